#include "parameters/parameter_messages.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/text.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "parameters/parameter_blocks.hpp"
#include "values/field_text.hpp"
#include "values/message_names.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

namespace {

std::vector<FieldSource> parameter_sources() {
  std::vector<FieldSource> sources;
  for (const ParameterMessage& message : parameter_messages()) {
    sources.push_back({message.type->info->name, &message.type->fields()});
  }
  return sources;
}

[[noreturn]] void fail_lacking(const std::string& what, const Availability& since) {
  const std::string versions = versions_text(since);
  throw CommandError(fmt::format("this board does not have {}{}", what,
                                 versions.empty() ? "" : "; it needs " + versions));
}

}  // namespace

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

namespace {

/// True if the meaning of the written value depends on the firmware.
bool depends_on_firmware(const FieldValue& value) {
  const FieldInfo* const info = value.field.type->innermost().info;
  return info != nullptr && !info->later.empty();
}

/// True if the written value depends on the present one.
bool changes_present(const FieldValue& value) { return value.change != Change::set; }

/// Returns the values for the block with this id: general ones for every profile.
std::vector<FieldValue> values_in(const MessageValues& one, const ParametersId& id,
                                  std::uint8_t profile) {
  if (one.message->copies == 1 || id.copy == profile) return one.values;
  std::vector<FieldValue> general;
  for (const FieldValue& value : one.values) {
    if (is_general(value.field)) general.push_back(value);
  }
  return general;
}

}  // namespace

std::vector<MessageValues> values_of(const std::vector<Assignment>& assignments, bool no_validate) {
  std::vector<MessageValues> result;
  for (const Assignment& assignment : assignments) {
    const FoundParameters found = find_parameters(assignment.name);
    auto at = std::ranges::find(result, found.message, &MessageValues::message);
    if (at == result.end()) at = result.insert(at, {found.message, {}});
    for (FieldValue& value : values_for(found.fields, assignment)) {
      add_value(at->values, std::move(value));
    }
  }
  for (const MessageValues& one : result) {
    AnyMessage message = one.message->type->make();
    std::vector<FieldValue> certain = one.values;
    std::erase_if(certain, depends_on_firmware);
    std::erase_if(certain, changes_present);
    set_values(message, certain);
    if (!no_validate) check_ranges(message, certain);
  }
  return result;
}

bool concerns(const MessageValues& one, const ParametersId& id, std::uint8_t profile) {
  if (id.message != one.message->type->info->name) return false;
  return one.message->copies == 1 || id.copy == profile || one.has_general();
}

ParameterSet with_values(const ParameterSet& present, const std::vector<MessageValues>& values,
                         std::uint8_t profile, const Availability& versions) {
  ParameterSet wanted;
  for (const MessageValues& one : values) {
    const char* const name = one.message->type->info->name;
    bool is_present = false;
    for (const Parameters& block : present.all()) {
      if (block.id.message != name) continue;
      is_present = true;
      AnyMessage message = message_in(block);
      std::vector<FieldValue> here = values_in(one, block.id, profile);
      for (const FieldValue& value : here) {
        if (!message.has(std::get<std::string>(value.field.steps.front()))) {
          fail_lacking(value.field);
        }
      }
      try {
        for (FieldValue& value : here) {
          if (changes_present(value)) value = changed_value(message, value, versions);
        }
        set_values(message, here, versions);
        if (Result<void> put = put_message(wanted, block.id, message); !put) {
          throw CommandError(put.error().message);
        }
      } catch (const CommandError&) {
        throw;
      } catch (const std::runtime_error& error) {
        throw CommandError(clipped(error.what()), wrong_usage);
      }
    }
    if (!is_present) throw CommandError(fmt::format("this board does not have {}", name));
  }
  return wanted;
}

}  // namespace sbgc::tools
