#include "parameters/parameter_messages.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/text.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "values/field_text.hpp"
#include "values/names.hpp"

namespace sbgc::tools {

namespace {

std::vector<FieldSource> parameter_sources() {
  std::vector<FieldSource> sources;
  for (const ParameterMessage& message : parameter_messages()) {
    sources.push_back({message.type->info->name, &message.type->fields()});
  }
  return sources;
}

bool is_settable(const FieldInfo& field) {
  return field.role != FieldRole::copy && field.role != FieldRole::state && !field.reserved &&
         &field != &tail_field;
}

[[noreturn]] void fail_lacking(const std::string& what, const Availability& since) {
  const std::string versions = versions_text(since);
  throw CommandError(fmt::format("this board does not have {}{}", what,
                                 versions.empty() ? "" : "; it needs " + versions));
}

}  // namespace

const std::vector<ParameterMessage>& parameter_messages() {
  static const std::vector<ParameterMessage> messages = [] {
    std::vector<ParameterMessage> result;
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      result.push_back({find_message(ParametersOf<M>::name), ParametersOf<M>::copies});
    });
    return result;
  }();
  return messages;
}

std::uint8_t copy_count(const ParametersId& id) {
  const auto found = std::ranges::find_if(parameter_messages(), [&](const auto& message) {
    return id.message == message.type->info->name;
  });
  return found != parameter_messages().end() ? found->copies : std::uint8_t{1};
}

AnyMessage message_in(const Parameters& block) {
  AnyMessage message = find_message(block.id.message)->make();
  static_cast<void>(message.decode(block.body));  // ParameterSet has checked this
  return message;
}

Parameters block_of(const ParametersId& id, const AnyMessage& message) {
  Parameters block{id, std::vector<std::uint8_t>(max_body_size)};
  const WriteResult written = message.encode(block.body);
  if (!written) throw ValueError(to_string(written.status));
  block.body.resize(written.size);
  return block;
}

FoundParameters find_parameters(std::string_view name) {
  const std::vector<FieldSource> sources = parameter_sources();
  const SourcedFields found = find_fields(sources, name);
  if (found.fields.empty()) {
    throw ValueError(fmt::format(
        "there is no parameter '{}'{}", clipped(name),
        detail::did_you_mean(similar_fields(sources, name), "`sbgc params show` lists them")));
  }
  for (const FoundField& field : found.fields) {
    const FieldInfo* const info = field.type->info;
    if (info == nullptr || is_settable(*info)) continue;
    throw ValueError(fmt::format("{} is not a parameter: it {}", steps_text(field.steps),
                                 info->role == FieldRole::copy    ? "selects the profile"
                                 : info->role == FieldRole::state ? "reports a state of the board"
                                                                  : "is reserved"));
  }
  return {&parameter_messages()[found.source], found.fields};
}

const ParameterMessage* find_parameter_message(const Query& query) {
  for (const ParameterMessage& message : parameter_messages()) {
    bool fits = false;
    for_each_field(message.type->fields(), [&](const auto& way, const FieldType& type) {
      if (type.info == nullptr || !is_settable(*type.info)) return;
      fits = fits || query.fits(way_text(way), type.info->summary, topics_of(*type.info), true);
    });
    if (fits) return &message;
  }
  return nullptr;
}

void fail_lacking(const FoundField& field) {
  fail_lacking(steps_text(field.steps),
               field.type->info == nullptr ? Availability{} : field.type->info->since);
}

void fail_lacking(const ParameterMessage& message) {
  fail_lacking(message.type->info->name, message.type->info->since);
}

bool is_general(const FoundField& field) {
  return field.type->info != nullptr && field.type->info->role == FieldRole::general;
}

bool is_profile_index(const FieldInfo& field) {
  static const std::string name = [] {
    for (const ParameterMessage& message : parameter_messages()) {
      for (const FieldType& one : message.type->fields()) {
        if (one.info != nullptr && one.info->role == FieldRole::copy) return std::string(one.name);
      }
    }
    return std::string();
  }();
  return field.name == name;
}

std::string ShownParameter::text() const {
  if (meaning.empty()) return raw;
  return is_special ? fmt::format("{} ({})", raw, meaning) : meaning;
}

std::string ShownParameter::short_text() const {
  constexpr std::size_t longest = 32;
  constexpr std::size_t shown = 16;
  if (bytes <= longest) return text();
  return fmt::format("{}… ({} bytes)", raw.substr(0, 2 * shown), bytes);
}

std::vector<ShownParameter> shown_parameters(const Parameters& block,
                                             const Availability& versions) {
  std::vector<ShownParameter> result;
  auto add = [&](const Leaf& leaf) {
    if (!is_settable(leaf.field) || leaf.kind == LeafKind::counter) return;
    ShownParameter shown{.message = block.id.message,
                         .path = to_string(leaf.path),
                         .spec_name = leaf.field.spec_name,
                         .raw = raw_text(leaf),
                         .meaning = meaning_text(leaf),
                         .is_special = special_meaning(leaf) != nullptr,
                         .is_general = leaf.field.role == FieldRole::general,
                         .summary = leaf.field.summary,
                         .topics = topics_of(leaf.field)};
    const bool is_number = leaf.kind == LeafKind::integer || leaf.kind == LeafKind::real;
    if (is_number && leaf.names == nullptr && leaf.packed == nullptr && !shown.is_special) {
      const double raw =
          leaf.kind == LeafKind::real ? leaf.real : static_cast<double>(leaf.integer);
      shown.value = leaf.unit != nullptr ? leaf.unit->real(raw) : raw;
    }
    if (leaf.kind == LeafKind::bytes) shown.bytes = leaf.bytes.size();
    if (leaf.unit != nullptr) shown.unit = leaf.unit->name;
    result.push_back(std::move(shown));
  };
  message_in(block).for_each_leaf(add, versions);
  return result;
}

Json to_json(const ShownParameter& parameter) {
  Json result{{"message", parameter.message}, {"path", parameter.path}, {"raw", parameter.raw}};
  result["value"] = parameter.value ? Json(*parameter.value) : Json();
  result["unit"] = parameter.unit.empty() ? Json() : Json(parameter.unit);
  result["meaning"] = parameter.meaning.empty() ? Json() : Json(parameter.meaning);
  result["general"] = parameter.is_general;
  result["topics"] = Json::array();
  for (const TopicReference* const topic : parameter.topics) {
    result["topics"].push_back(topic->name);
  }
  if (!parameter.other_default.empty()) result["default"] = parameter.other_default;
  return result;
}

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const ParameterMessage& message : parameter_messages()) {
    for (const std::string& path : field_paths(message.type->fields())) {
      const auto found = find_fields(message.type->fields(), path);
      const FieldInfo* const info = found.empty() ? nullptr : found.front().type->info;
      if (info != nullptr && !is_settable(*info)) continue;
      if (std::ranges::find(names, path) == names.end()) names.push_back(path);
    }
  }
  return names;
}

}  // namespace sbgc::tools
