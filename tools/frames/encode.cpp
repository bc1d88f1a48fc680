// sbgc encode: encodes JSON lines, as printed by sbgc decode, to frames.

#include <cstdio>
#include <string>

#include <fmt/format.h>

#include <sbgc/json/hex.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/validate.hpp>

#include "command/commands.hpp"
#include "command/input.hpp"
#include "command/remark.hpp"
#include "command/standard_output.hpp"
#include "command/wording.hpp"
#include "values/assignments.hpp"
#include "values/message_names.hpp"
#include "values/message_type.hpp"

namespace sbgc::tools {

namespace {

struct EncodeOptions {
  std::string file = "-";
  bool hex = false;
  bool no_validate = false;
  bool defaults = false;
};

/// Returns a value of the line that must be a string.
std::string text_of(const Json& line, const char* key) {
  const auto found = line.find(key);
  if (found == line.end()) throw InputError(fmt::format("'{}' is missing", key));
  if (!found->is_string()) throw InputError(fmt::format("'{}' must be a string", key));
  return found->get<std::string>();
}

/// Returns the message that the line names: one of ours, or the form of a command that has its
/// fields. Such a command goes to the board, unless the line says otherwise or only the board sends
/// it.
const MessageType& message_of(const Json& line) {
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
std::vector<std::uint8_t> encode_fields(const MessageType& message, const Json& fields,
                                        Framing framing, const EncodeOptions& options) {
  if (!options.no_validate) {
    const std::string problems = violations_of(message, fields, newest);
    if (!problems.empty()) throw InputError(problems);
  }
  return encoded(message, fields, framing);
}

bool works_with_defaults(const MessageType& message, Json fields, const EncodeOptions& options) {
  try {
    add_defaults(message, fields);
    static_cast<void>(encode_fields(message, fields, basic_framing, options));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::vector<std::uint8_t> encode_line(const std::string& text, const EncodeOptions& options) {
  const ParsedJson parsed = parse_json(text);
  if (!parsed) {
    throw InputError(
        fmt::format("{}, at column {}", parsed.problem->reason, parsed.problem->column));
  }
  const Json& line = parsed.value;
  if (!line.is_object()) throw InputError("a line must be a JSON object");
  const MessageType& message = message_of(line);
  check_rest(line, *message.info);
  Json fields = line.value("fields", Json::object());
  if (!line.contains("fields") && !options.defaults) throw InputError("'fields' is missing");
  replace_names(message, fields);
  if (options.defaults) add_defaults(message, fields);
  const Framing framing = framing_named_in(line);
  try {
    return encode_fields(message, fields, framing, options);
  } catch (const JsonError& error) {
    if (options.defaults || !works_with_defaults(message, fields, options)) throw;
    throw InputError(fmt::format("{}; --defaults adds what is missing", error.what()));
  }
}

void write(const std::vector<std::uint8_t>& frame, bool hex) {
  if (hex) {
    fmt::print("{}\n", detail::to_hex(frame));
  } else {
    std::fwrite(frame.data(), 1, frame.size(), stdout);
  }
}

int encode_file(const EncodeOptions& options) {
  if (!options.hex) require_no_terminal("--hex");
  Input input(options.file);
  int status = success;
  std::string line;
  constexpr std::size_t longest = JsonLimits{}.size;
  for (std::size_t number = 1; input.read_line(line, longest); ++number) {
    if (line.size() <= longest && line.find_first_not_of(" \t") == std::string::npos) continue;
    try {
      write(encode_line(line, options), options.hex);
    } catch (const std::runtime_error& error) {
      remark("sbgc: line {}: {}\n", number, clipped(error.what()));
      status = failure;
    }
  }
  return status;
}

}  // namespace

void add_encode(CLI::App& app, CommandContext& context) {
  auto* const command =
      app.add_subcommand("encode", "Encode JSON lines to frames")->group(heading::bytes);
  auto options = std::make_shared<EncodeOptions>();
  command
      ->add_option("file", options->file,
                   "JSON lines as printed by `sbgc decode --format jsonl`; - means standard "
                   "input. 'message' and 'fields' are required; 'message' may be the name of a "
                   "command, such as CMD_MOTORS_ON")
      ->capture_default_str();
  command->add_flag("--hex", options->hex,
                    "Print each frame as a line of hex instead of raw bytes");
  command->add_flag("--no-validate", options->no_validate,
                    "Also encode values that the specification does not allow");
  command->add_flag(
      "--defaults", options->defaults,
      "Fill in fields that a line leaves out: 0, empty, or the default of the specification");
  command->footer(
      "Numbers are those on the wire. Enums, flags and packed values may be names instead: "
      "\"MODE_ANGLE\", \"FLAG_A|FLAG_B\", [\"FLAG_A\", \"FLAG_B\"].\n"
      "A line may have up to 16 MiB and 64 nested levels, and no duplicate keys. A line that "
      "cannot be encoded or is invalid is reported and skipped; the exit status is then 1. It is "
      "2 for wrong usage.");
  command->callback([options, &context] { context.status = encode_file(*options); });
}

}  // namespace sbgc::tools
