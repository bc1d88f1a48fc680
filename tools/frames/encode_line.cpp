#include "frames/encode_line.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/validate.hpp>

#include "command/input_output.hpp"
#include "values/message_json.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

/// Returns a value of the line that must be a string.
std::string text_of(const Json& line, const char* key) {
  const auto found = line.find(key);
  if (found == line.end()) throw InputError(fmt::format("'{}' is missing", key));
  if (!found->is_string()) throw InputError(fmt::format("'{}' must be a string", key));
  return found->get<std::string>();
}

/// Returns the message that the line names: an own name, or the form of a command that has its
/// fields. Such a command goes to the board, unless the line says otherwise or only the board sends
/// it.
const MessageType& type_named_in(const Json& line) {
  const std::string name = text_of(line, "message");
  const auto direction = line.find("direction");
  const bool is_from_board = direction != line.end() && *direction == "from_board";
  std::vector<const MessageType*> forms =
      messages_named(name, is_from_board ? Direction::from_board : Direction::to_board);
  if (forms.empty() && direction == line.end()) {
    forms = messages_named(name, Direction::from_board);
  }
  if (forms.empty()) {
    throw InputError(fmt::format("unknown message '{}'{}", name, similar_messages(name)));
  }
  std::vector<std::string> fields;
  const auto given = line.find("fields");
  if (given != line.end() && given->is_object()) {
    for (const auto& item : given->items()) fields.push_back(item.key());
  }
  return form_with(forms, fields);
}

/// Checks the optional keys of a line, which must agree with its message.
void check_rest(const Json& line, const MessageInfo& info) {
  const auto check = [&](const char* key, bool agrees) {
    if (agrees) return;
    throw InputError(
        fmt::format("'{}' is {}, which does not match {}", key, line[key].dump(), info.name));
  };
  if (line.contains("command")) check("command", line["command"] == info.command);
  if (line.contains("id")) check("id", line["id"] == info.id);
  if (line.contains("direction")) {
    const bool from_board = line["direction"] == "from_board";
    const bool to_board = line["direction"] == "to_board";
    check("direction", info.direction == Direction::both
                           ? from_board || to_board
                           : (info.direction == Direction::from_board ? from_board : to_board));
  }
}

/// Returns the framing that the line names, or the one that every board understands.
Framing framing_named_in(const Json& line) {
  if (!line.contains("framing")) return basic_framing;
  const std::string name = text_of(line, "framing");
  std::string known;
  for (const Framing framing : framings) {
    if (name == to_string(framing)) return framing;
    known += (known.empty() ? "" : ", ") + std::string(to_string(framing));
  }
  throw InputError(fmt::format("unknown framing '{}'; known: {}", name, known));
}

/// Returns a frame. Throws InputError and JsonError.
std::vector<std::uint8_t> encode_fields(const MessageType& type, const Json& fields,
                                        Framing framing, const EncodeRules& rules) {
  const AnyMessage message =
      rules.defaults ? message_with_defaults(type, fields) : message_of(type, fields);
  if (!rules.no_validate) {
    const std::string problems = violations_of(message, newest);
    if (!problems.empty()) throw InputError(problems);
  }
  return encoded(message, framing);
}

bool works_with_defaults(const MessageType& message, const Json& fields, EncodeRules rules) {
  rules.defaults = true;
  try {
    static_cast<void>(encode_fields(message, fields, basic_framing, rules));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

std::vector<std::uint8_t> encode_line(const std::string& text, const EncodeRules& rules) {
  const ParsedJson parsed = parse_json(text);
  if (!parsed) {
    const std::string_view kind = detail::foreign_kind(text);
    if (!kind.empty()) throw InputError(fmt::format("this is {}, not JSON lines", kind));
    throw InputError(
        fmt::format("{}, at column {}", parsed.problem->reason, parsed.problem->column));
  }
  const Json& line = parsed.value;
  if (!line.is_object()) throw InputError("a line must be a JSON object");
  const MessageType& message = type_named_in(line);
  check_rest(line, *message.info);
  Json fields = line.value("fields", Json::object());
  if (!line.contains("fields") && !rules.defaults) throw InputError("'fields' is missing");
  replace_names(message, fields);
  const Framing framing = framing_named_in(line);
  try {
    return encode_fields(message, fields, framing, rules);
  } catch (const JsonError& error) {
    if (rules.defaults || !works_with_defaults(message, fields, rules)) throw;
    throw InputError(fmt::format("{}; --defaults adds what is missing", error.what()));
  }
}

}  // namespace sbgc::tools
