// sbgc encode: encodes JSON lines, as printed by sbgc decode, to frames.

#include <cstdio>
#include <string>

#include <fmt/format.h>

#include <sbgc/dispatch.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/text.hpp>

#include "commands.hpp"
#include "input.hpp"
#include "wording.hpp"

namespace sbgc::tools {

namespace {

struct EncodeOptions {
  std::string file = "-";
  bool hex = false;
  bool no_validate = false;
};

/// Collects violations. A lambda would have a different type for each message and instantiate the
/// validator again each time.
struct Problems {
  std::string& text;

  void operator()(const Violation& violation) const {
    text += (text.empty() ? "" : "; ") + to_string(violation);
  }
};

/// Returns the frame of the message with these `fields`. Throws InputError or JsonError.
template <class M>
std::vector<std::uint8_t> encode_fields(const Json& fields, Framing framing, bool check) {
  M message{};
  from_dom(fields, message);
  if (check) {
    std::string problems;
    validate(message, Problems{problems});
    if (!problems.empty()) throw InputError(problems);
  }
  std::vector<std::uint8_t> frame(max_frame_size);
  const WriteResult written = encode_frame(framing, message, frame);
  if (!written) {
    throw InputError(to_string(written.status) + " (" + to_string(written.status.code) + ')');
  }
  frame.resize(written.size);
  return frame;
}

/// Returns a value of the line that must be a string.
std::string text_of(const Json& line, const char* key) {
  const auto found = line.find(key);
  if (found == line.end()) throw InputError(fmt::format("'{}' is missing", key));
  if (!found->is_string()) throw InputError(fmt::format("'{}' must be a string", key));
  return found->get<std::string>();
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

std::vector<std::uint8_t> encode_line(const std::string& text, const EncodeOptions& options) {
  const ParsedJson parsed = parse_json(text);
  if (!parsed) {
    throw InputError(
        fmt::format("{}, at column {}", parsed.problem->reason, parsed.problem->column));
  }
  const Json& line = parsed.value;
  if (!line.is_object()) throw InputError("a line must be a JSON object");
  const std::string name = text_of(line, "message");
  const auto fields = line.find("fields");
  if (fields == line.end()) throw InputError("'fields' is missing");
  std::vector<std::uint8_t> frame;
  bool known = false;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (name != Meta<M>::info.name) return;
    known = true;
    check_rest(line, Meta<M>::info);
    frame = encode_fields<M>(*fields, framing_named_in(line), !options.no_validate);
  });
  if (!known) throw InputError(fmt::format("unknown message '{}'", name));
  return frame;
}

void write(const std::vector<std::uint8_t>& frame, bool hex) {
  if (hex) {
    fmt::print("{}\n", detail::to_hex(frame));
  } else {
    std::fwrite(frame.data(), 1, frame.size(), stdout);
  }
}

int encode_file(const EncodeOptions& options) {
  Input input(options.file);
  int status = success;
  std::string line;
  constexpr std::size_t longest = JsonLimits{}.size;
  for (std::size_t number = 1; input.read_line(line, longest); ++number) {
    if (line.size() <= longest && line.find_first_not_of(" \t") == std::string::npos) continue;
    try {
      write(encode_line(line, options), options.hex);
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "sbgc: line {}: {}\n", number, clipped(error.what()));
      status = failure;
    }
  }
  return status;
}

}  // namespace

void add_encode(CLI::App& app, int& status) {
  auto* const command = app.add_subcommand("encode", "Encode JSON lines to frames");
  auto options = std::make_shared<EncodeOptions>();
  command
      ->add_option("file", options->file,
                   "JSON lines as printed by `sbgc decode --format jsonl`; - means standard "
                   "input. 'message' and 'fields' are required")
      ->capture_default_str();
  command->add_flag("--hex", options->hex,
                    "Print each frame as a line of hex instead of raw bytes");
  command->add_flag("--no-validate", options->no_validate,
                    "Also encode values that the specification does not allow");
  command->footer(
      "A line may have up to 16 MiB and 64 nested levels, and no duplicate keys. A line that "
      "cannot be encoded or is invalid is reported and skipped; the exit status is then 1. It is "
      "2 for wrong usage.");
  command->callback([options, &status] { status = encode_file(*options); });
}

}  // namespace sbgc::tools
