#include "values/assignments.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include <sbgc/detail/suggestions.hpp>
#include <sbgc/text.hpp>

#include "command/wording.hpp"
#include "values/value_text.hpp"

namespace sbgc::tools {

namespace {

/// True if other values of the message can select the unit of this one.
bool is_in_unit(const FieldType& type) {
  const FieldType& element = type.innermost();
  const bool is_variable = element.info != nullptr && element.info->is_variable_value;
  return is_variable || element.unit != nullptr;
}

const FieldType* member_named(const std::vector<FieldType>& members, std::string_view name) {
  const auto found = std::ranges::find(
      members, name, [](const FieldType& type) { return std::string_view(type.name); });
  return found != members.end() ? &*found : nullptr;
}

/// Returns the place of a value. Adds what is missing on the way.
Json& place_of(const std::vector<FieldType>& members, const FieldSteps& steps, Json& fields) {
  Json* at = &fields;
  const std::vector<FieldType>* inside = &members;
  const FieldType* type = nullptr;
  for (const PathStep& step : steps) {
    if (const auto* const index = std::get_if<std::size_t>(&step)) {
      type = &type->members.front();
      while (at->size() <= *index) at->push_back(initial_value(*type));
      at = &(*at)[*index];
    } else {
      const auto& name = std::get<std::string>(step);
      type = type != nullptr && type->shape == FieldShape::axes ? &type->members.front()
                                                                : member_named(*inside, name);
      if (!at->contains(name)) (*at)[name] = initial_value(*type);
      at = &(*at)[name];
    }
    inside = &type->members;
  }
  return *at;
}

/// Throws ValueError if a value is of an element of a list beyond its end, and an element before
/// that is neither there nor has a value: it would be sent with zeros that nobody asked for.
void reject_gaps(const MessageType& message, const std::vector<FieldValue>& values,
                 const Json& fields) {
  Json grown = fields;
  for (const FieldValue& value : values) {
    FieldSteps steps;
    for (const PathStep& step : value.field.steps) {
      const auto* const index = std::get_if<std::size_t>(&step);
      const std::size_t size =
          index != nullptr ? place_of(message.fields(), steps, grown).size() : 0;
      for (std::size_t i = size; index != nullptr && i < *index; ++i) {
        FieldSteps element = steps;
        element.emplace_back(i);
        const bool has_value = std::ranges::any_of(values, [&](const FieldValue& other) {
          const FieldSteps& others = other.field.steps;
          return others.size() >= element.size() &&
                 std::equal(element.begin(), element.end(), others.begin());
        });
        if (has_value) continue;
        throw ValueError(fmt::format("{} has no value, but {} has one; elements count from 0",
                                     steps_text(element), steps_text(value.field.steps)));
      }
      steps.push_back(step);
    }
  }
}

/// The units in effect, by path.
using Units = std::map<std::string, const UnitInfo*>;

const UnitInfo* unit_of(const FoundField& field, const Units& units) {
  FieldSteps steps = field.steps;
  for (const FieldType* type = field.type;;) {
    const auto found = units.find(steps_text(steps));
    if (found != units.end()) return found->second;
    if (type->shape == FieldShape::axes) {
      steps.emplace_back(std::string(type->axes.front()));
    } else if (type->shape == FieldShape::list) {
      steps.emplace_back(std::size_t{0});
    } else {
      return type->unit;
    }
    type = &type->members.front();
  }
}

[[noreturn]] void fail_value(const std::string& path, const std::exception& error) {
  throw ValueError(fmt::format("{}: {}", path, error.what()));
}

void replace_in(const FieldType& type, Json& value, const std::string& path);

void replace_in_members(const std::vector<FieldType>& members, Json& fields,
                        const std::string& path) {
  if (!fields.is_object()) return;
  for (const FieldType& member : members) {
    if (!fields.contains(member.name)) continue;
    replace_in(member, fields[member.name], path.empty() ? member.name : path + '.' + member.name);
  }
}

/// Returns the flags of a list of names: "A|B".
std::string joined_names(const Json& list) {
  std::string text;
  for (const Json& one : list) {
    if (!one.is_string()) return "";
    text += (text.empty() ? "" : "|") + one.get<std::string>();
  }
  return list.empty() ? "0" : text;
}

void replace_in(const FieldType& type, Json& value, const std::string& path) {
  switch (type.shape) {
    case FieldShape::group: return replace_in_members(type.members, value, path);
    case FieldShape::axes:
      if (!value.is_object()) return;
      for (const char* const axis : type.axes) {
        if (value.contains(axis)) {
          replace_in(type.members.front(), value[axis], path + '.' + axis);
        }
      }
      return;
    case FieldShape::list:
      if (!value.is_array()) return;
      for (std::size_t i = 0; i < value.size(); ++i) {
        replace_in(type.members.front(), value[i], fmt::format("{}[{}]", path, i));
      }
      return;
    case FieldShape::integer: break;
    default: return;
  }
  if (type.names == nullptr && type.packed == nullptr) return;
  // Integers of 64 bits are text as well.
  const bool is_digits = value.is_string() && value.get_ref<const std::string&>().find_first_not_of(
                                                  "-0123456789") == std::string::npos;
  if (is_digits || !(value.is_string() || value.is_array())) return;
  const std::string text = value.is_array() ? joined_names(value) : value.get<std::string>();
  if (value.is_array() && text.empty()) return;
  try {
    value = parse_value(type, nullptr, text, Json());
  } catch (const ValueError& error) {
    fail_value(path, error);
  }
}

void complete(const std::vector<FieldType>& members, Json& fields) {
  if (!fields.is_object()) return;
  for (const FieldType& member : members) {
    if (!fields.contains(member.name)) {
      if (member.is_optional || member.is_counter || member.is_tail()) continue;
      fields[member.name] = initial_value(member);
      continue;
    }
    Json& value = fields[member.name];
    if (member.shape == FieldShape::group) complete(member.members, value);
    if (!member.has_elements()) continue;
    const FieldType& element = member.members.front();
    if (member.shape == FieldShape::axes && value.is_object()) {
      for (const char* const axis : member.axes) {
        if (!value.contains(axis)) value[axis] = initial_value(element);
      }
    }
    const bool has_elements = value.is_object() || value.is_array();
    if (element.shape != FieldShape::group || !has_elements) continue;
    for (Json& one : value) complete(element.members, one);
  }
}

}  // namespace

Assignment parse_assignment(std::string_view text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string_view::npos || sign == 0) {
    throw ValueError(fmt::format("'{}' is not NAME=VALUE", clipped(text)));
  }
  return {std::string(text.substr(0, sign)), std::string(text.substr(sign + 1))};
}

std::vector<Assignment> parse_assignments(const std::vector<std::string>& texts) {
  std::vector<Assignment> result;
  result.reserve(texts.size());
  for (const std::string& text : texts) result.push_back(parse_assignment(text));
  return result;
}

std::vector<FieldValue> values_for(const std::vector<FoundField>& fields, const std::string& text) {
  const FieldType& type = *fields.front().type;
  const bool is_one_number = type.is_number() && type.names == nullptr && type.packed == nullptr;
  const auto commas = static_cast<std::size_t>(std::ranges::count(text, ','));
  const bool is_split = fields.size() > 1 && is_one_number && commas + 1 == fields.size();
  std::vector<FieldValue> result;
  std::size_t at = 0;
  for (const FoundField& field : fields) {
    const std::size_t end = is_split ? std::min(text.find(',', at), text.size()) : text.size();
    result.push_back({field, text.substr(at, end - at)});
    if (is_split) at = end + 1;
  }
  return result;
}

std::vector<FieldValue> find_values(const MessageType& message,
                                    const std::vector<Assignment>& assignments) {
  std::vector<FieldValue> result;
  for (const Assignment& assignment : assignments) {
    const std::vector<FoundField> found = find_fields(message.fields(), assignment.name);
    if (found.empty()) {
      const FieldSource source{message.info->name, &message.fields()};
      const std::string name(message.info->name);
      throw ValueError(
          fmt::format("{} has no field '{}'{}", name, clipped(assignment.name),
                      detail::did_you_mean(similar_fields({source}, assignment.name),
                                           "`sbgc describe " + name + "` lists them")));
    }
    for (FieldValue& value : values_for(found, assignment.value)) {
      const std::string path = steps_text(value.field.steps);
      const bool is_again = std::ranges::any_of(
          result, [&](const FieldValue& other) { return steps_text(other.field.steps) == path; });
      if (is_again) throw ValueError(fmt::format("{} is set twice", path));
      if (value.field.type->is_counter) {
        throw ValueError(fmt::format("{} follows from the number of elements", path));
      }
      result.push_back(std::move(value));
    }
  }
  return result;
}

void set_values(const MessageType& message, const std::vector<FieldValue>& values, Json& fields) {
  const auto set = [&](const FieldValue& value, const UnitInfo* unit) {
    Json& place = place_of(message.fields(), value.field.steps, fields);
    try {
      place = parse_value(*value.field.type, unit, value.text, place);
    } catch (const ValueError& error) {
      fail_value(steps_text(value.field.steps), error);
    }
  };
  reject_gaps(message, values, fields);
  bool has_units = false;
  for (const FieldValue& value : values) {
    if (is_in_unit(*value.field.type)) {
      has_units = true;
      place_of(message.fields(), value.field.steps, fields);
    } else {
      set(value, nullptr);
    }
  }
  if (!has_units) return;
  Units units;
  message_of(message, fields).for_each_leaf([&](const Leaf& leaf) {
    units.emplace(to_string(leaf.path), leaf.unit);
  });
  for (const FieldValue& value : values) {
    if (is_in_unit(*value.field.type)) set(value, unit_of(value.field, units));
  }
}

void check_ranges(const MessageType& message, const std::vector<FieldValue>& values,
                  const Json& fields) {
  std::string problem;
  message_of(message, fields).validate(newest, [&](const Violation& violation) {
    const bool is_range = violation.rule == Rule::minimum || violation.rule == Rule::maximum;
    if (!is_range || violation.other != nullptr || !problem.empty()) return;
    const std::string path = to_string(violation.path);
    const bool is_one = std::ranges::any_of(
        values, [&](const FieldValue& value) { return steps_text(value.field.steps) == path; });
    if (is_one) problem = to_string(violation);
  });
  if (!problem.empty()) throw ValueError(problem);
}

void assign(const MessageType& message, const std::vector<Assignment>& assignments, Json& fields) {
  set_values(message, find_values(message, assignments), fields);
}

void replace_names(const MessageType& message, Json& fields) {
  replace_in_members(message.fields(), fields, "");
}

void add_demanded(const MessageType& message, Json& fields) {
  std::vector<std::uint8_t> body(max_body_size);
  for (;;) {
    const WriteResult written = message_of(message, fields).encode(body);
    if (written.status.code != Code::presence_mismatch) return;
    const auto found = find_fields(message.fields(), written.status.field);
    if (found.size() != 1) return;
    const Json before = fields;
    place_of(message.fields(), found.front().steps, fields);
    if (fields == before) return;  // it is there, but should not be
  }
}

void add_defaults(const MessageType& message, Json& fields) {
  complete(message.fields(), fields);
  add_demanded(message, fields);
}

}  // namespace sbgc::tools
