// sbgc encode: encodes JSON lines, as printed by sbgc decode, to frames.

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/json/hex.hpp>
#include <sbgc/parse_json.hpp>

#include "command/input_output.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "frames/encode_line.hpp"

namespace sbgc::tools {

namespace {

struct EncodeOptions {
  std::string file = "-";
  bool hex = false;
  EncodeRules rules{};
};

void write(const std::vector<std::uint8_t>& frame, bool hex) {
  if (hex) {
    fmt::print("{}\n", detail::to_hex(frame));
  } else {
    std::fwrite(frame.data(), 1, frame.size(), stdout);
  }
}

int encode_file(const EncodeOptions& options) {
  if (!options.hex) require_no_terminal("--hex");
  Input input(options.file, "JSON lines");
  int status = success;
  std::string line;
  constexpr std::size_t longest = JsonLimits{}.size;
  for (std::size_t number = 1; input.read_line(line, longest); ++number) {
    if (line.size() <= longest && line.find_first_not_of(" \t") == std::string::npos) continue;
    try {
      write(encode_line(line, options.rules), options.hex);
    } catch (const std::runtime_error& error) {
      remark_failure(fmt::format("line {}: {}", number, clipped(error.what())));
      status = failure;
    }
  }
  return status;
}

}  // namespace

void add_encode(CLI::App& app, CommandContext& context) {
  const Subcommand<EncodeOptions> command(app, context, "encode", "Encode JSON lines to frames");
  auto& options = command.options();
  command
      ->add_option("file", options.file,
                   "JSON lines as `sbgc decode --format jsonl` prints them; - is standard input. "
                   "'message' and 'fields' are required; 'message' may be the name of a command, "
                   "such as CMD_MOTORS_ON")
      ->capture_default_str();
  command->add_flag("--hex", options.hex, "Print each frame as a line of hex instead of raw bytes");
  command->add_flag("--no-validate", options.rules.no_validate,
                    "Also encode values that the specification does not allow");
  command->add_flag("--defaults", options.rules.defaults,
                    "Fill in omitted fields: 0, empty, or the default of the specification");
  command->footer(
      "Numbers are those on the wire. Enums, flags and packed values may be names instead: "
      "\"MODE_ANGLE\", \"FLAG_A|FLAG_B\", [\"FLAG_A\", \"FLAG_B\"].\n"
      "A line may have up to 16 MiB and 64 levels of nesting, and no duplicate keys. The command "
      "reports and skips a line that it cannot encode; the exit status is then 1. It is 2 for "
      "wrong usage.");
  command.examples(
      {"sbgc encode --hex frames.jsonl", "sbgc encode --defaults < frames.jsonl > frames.bin"});
  command.runs(encode_file);
}

}  // namespace sbgc::tools
