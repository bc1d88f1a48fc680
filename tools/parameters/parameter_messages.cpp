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

}  // namespace sbgc::tools
