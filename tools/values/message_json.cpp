#include "values/message_json.hpp"

#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include <sbgc/message.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "values/assignments.hpp"
#include "values/complete_message.hpp"

namespace sbgc::tools {

namespace {

/// Returns the JSON of one or several names; integers of 64 bits are text.
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

/// Joins a list of flag names: "A|B".
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

/// Marks a value that a line omits; no text has it.
const Json missing(Json::value_t::discarded);

void complete(const FieldType& type, Json& value);

void complete_members(const std::vector<FieldType>& members, Json& fields) {
  if (!fields.is_object()) return;
  for (const FieldType& member : members) {
    const bool is_demanded = !member.is_optional && !member.is_counter && !member.is_tail();
    if (is_demanded && !fields.contains(member.name)) fields[member.name] = missing;
    if (fields.contains(member.name)) complete(member, fields[member.name]);
  }
}

/// Fills in missing values, as in a new message. The reader objects to other shapes.
void complete(const FieldType& type, Json& value) {
  const bool is_new = value.is_discarded();
  switch (type.shape) {
    case FieldShape::group:
      if (is_new) value = Json::object();
      return complete_members(type.members, value);
    case FieldShape::axes:
      if (is_new) value = Json::object();
      if (!value.is_object()) return;
      for (const char* const axis : type.axes) {
        if (!value.contains(axis)) value[axis] = missing;
        complete(type.members.front(), value[axis]);
      }
      return;
    case FieldShape::list: {
      const std::size_t least = type.info == nullptr ? 0 : type.info->min_count;
      if (is_new) value = Json(type.has_count ? type.count : least, missing);
      if (!value.is_array()) return;
      for (Json& one : value) complete(type.members.front(), one);
      return;
    }
    default: break;
  }
  if (!is_new) return;
  switch (type.shape) {
    case FieldShape::bytes: value = std::string(type.has_count ? 2 * type.count : 0, '0'); return;
    case FieldShape::text: value = ""; return;
    case FieldShape::announced: value = {{name(NumberType::u8), 0}}; return;
    case FieldShape::real: value = 0.0; return;
    default:
      // 64-bit integers are text.
      value = type.size == sizeof(std::uint64_t) ? Json(std::to_string(type.initial))
                                                 : Json(type.initial);
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
  complete_members(type.fields(), fields);
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
