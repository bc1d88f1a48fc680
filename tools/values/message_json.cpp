#include "values/message_json.hpp"

#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include <sbgc/message.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "values/assignments.hpp"

namespace sbgc::tools {

namespace {

Json initial_fields(const std::vector<FieldType>& members);

/// Returns the value of a field in a new message.
Json initial_value(const FieldType& type) {
  switch (type.shape) {
    case FieldShape::group: return initial_fields(type.members);
    case FieldShape::axes: {
      Json result = Json::object();
      for (const char* const axis : type.axes) result[axis] = initial_value(type.members.front());
      return result;
    }
    case FieldShape::list: {
      Json result = Json::array();
      const std::size_t least = type.info == nullptr ? 0 : type.info->min_count;
      const std::size_t size = type.has_count ? type.count : least;
      for (std::size_t i = 0; i < size; ++i) {
        result.push_back(initial_value(type.members.front()));
      }
      return result;
    }
    case FieldShape::integer:
      // 64 bits are text.
      return type.size == sizeof(std::uint64_t) ? Json(std::to_string(type.initial))
                                                : Json(type.initial);
    case FieldShape::real: return 0.0;
    case FieldShape::bytes: return std::string(type.has_count ? 2 * type.count : 0, '0');
    case FieldShape::text: return "";
    case FieldShape::announced: return Json{{name(NumberType::u8), 0}};
  }
  return {};
}

Json initial_fields(const std::vector<FieldType>& members) {
  Json result = Json::object();
  for (const FieldType& member : members) {
    if (member.is_optional || member.is_counter || member.is_tail()) continue;
    result[member.name] = initial_value(member);
  }
  return result;
}

/// Returns the JSON of a name or several; an integer of 64 bits is text.
Json number_of(const FieldType& type, const std::string& text) {
  const ParsedValue parsed = parse_value(type, nullptr, text);
  if (!parsed) throw ValueError(parsed.problem);
  const auto raw = std::get<std::int64_t>(parsed.value);
  if (type.size != sizeof(raw)) return raw;
  return type.is_wide ? std::to_string(static_cast<std::uint64_t>(raw)) : std::to_string(raw);
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
    value = number_of(type, text);
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

AnyMessage message_of(const MessageType& type, const Json& fields) {
  AnyMessage message = type.make();
  const JsonResult read =
      message.from_json(fields.dump(-1, ' ', false, Json::error_handler_t::replace));
  if (!read) throw JsonError(read.problem->field, read.problem->reason);
  return message;
}

AnyMessage message_with_defaults(const MessageType& type, Json fields) {
  complete(type.fields(), fields);
  AnyMessage message = message_of(type, fields);
  add_demanded(message);
  return message;
}

void replace_names(const MessageType& type, Json& fields) {
  replace_in_members(type.fields(), fields, "");
}

std::vector<std::uint8_t> encoded(const AnyMessage& message, Framing framing) {
  std::vector<std::uint8_t> frame(max_frame_size);
  const WriteResult written = message.encode_frame(framing, frame);
  if (!written) {
    throw std::runtime_error(
        fmt::format("{} ({})", to_string(written.status), to_string(written.status.code)));
  }
  frame.resize(written.size);
  return frame;
}

std::string violations_of(const AnyMessage& message, const Availability& versions) {
  std::string problems;
  message.validate(versions, [&](const Violation& violation) {
    problems += (problems.empty() ? "" : "; ") + to_string(violation);
  });
  return problems;
}

}  // namespace sbgc::tools
