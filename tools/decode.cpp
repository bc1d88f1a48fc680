// sbgc decode: a capture as JSON lines or as text for people.

#include <cstdio>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/parser.hpp>

#include "commands.hpp"
#include "decoded_frame.hpp"
#include "hex_text.hpp"
#include "input.hpp"
#include "text.hpp"

namespace sbgc::tools {

namespace {

struct Options {
  std::string file = "-";
  std::string from = "auto";
  std::string format = "text";
  bool hex = false;
};

std::optional<Direction> direction(const std::string& from) {
  if (from == "board") return Direction::from_board;
  if (from == "host") return Direction::to_board;
  return std::nullopt;
}

/// Prints frames as they come.
class Printer {
 public:
  explicit Printer(const Options& options)
      : jsonl_(options.format == "jsonl"), decoder_(direction(options.from)) {}

  void operator()(const Frame& frame) {
    const DecodedFrame decoded = decoder_.decode(frame);
    if (jsonl_) {
      const std::string line =
          decoded.to_json().dump(-1, ' ', false, Json::error_handler_t::replace);
      fmt::print("{}\n", line);
      return;
    }
    print_gap(frame.offset);
    fmt::print("{}", to_text(decoded));
    end_ = frame.offset + Framing::frame_size(frame.body.size());
  }

  /// What can be said at the end of a capture of `size` bytes.
  void finish(std::uint64_t size, const Parser& parser) {
    if (jsonl_) return;
    print_gap(size);
    const auto counters = parser.counters();
    fmt::print("{}, {} skipped", counted(counters.frames, "frame"),
               counted(counters.skipped_bytes, "byte"));
    fmt::print(" (bad headers: {}, bad bodies: {})\n", counters.header_errors,
               counters.body_errors);
  }

 private:
  void print_gap(std::uint64_t until) const {
    if (until > end_) fmt::print("@{}  no frame: {}\n", end_, counted(until - end_, "byte"));
  }

  bool jsonl_;
  FrameDecoder decoder_;
  std::uint64_t end_ = 0;
};

void check(const std::optional<HexError>& error) {
  if (error) throw InputError(to_text(*error));
}

/// What has been printed goes out now: a reader may be waiting for it.
void flush_output() {
  if (std::fflush(stdout) != 0) throw std::runtime_error("can not write to the standard output");
}

int decode_file(const Options& options) {
  Input input(options.file);
  Printer print(options);
  Parser parser;
  HexDecoder hex;
  std::vector<std::uint8_t> bytes;
  std::uint64_t size = 0;
  const auto feed = [&](std::span<const std::uint8_t> block) {
    size += block.size();
    parser.feed(block, print);
    flush_output();
  };
  const auto finish = [&] {
    parser.flush(print);
    print.finish(size, parser);
    flush_output();
  };
  try {
    for (auto block = input.read(); !block.empty(); block = input.read()) {
      bytes.clear();
      if (options.hex) check(hex.feed(block, bytes));
      feed(options.hex ? bytes : block);
    }
    bytes.clear();
    check(hex.finish());
  } catch (const InputError&) {
    feed(bytes);  // what stands before the mistake is good
    finish();
    throw;
  }
  finish();
  return success;
}

}  // namespace

void add_decode(CLI::App& app, int& status) {
  auto* const command = app.add_subcommand("decode", "Show the frames of a capture");
  auto options = std::make_shared<Options>();
  command->add_option("file", options->file, "Capture to read; - is the standard input")
      ->capture_default_str();
  command
      ->add_option("--from", options->from,
                   "Who sent the bytes; auto takes each frame for what its size fits, the board's "
                   "meaning first")
      ->check(CLI::IsMember({"auto", "board", "host"}))
      ->capture_default_str();
  command->add_option("--format", options->format, "How to print")
      ->check(CLI::IsMember({"text", "jsonl"}))
      ->capture_default_str();
  command->add_flag("--hex", options->hex, "The input is hex text, not raw bytes");
  command->footer(
      "In JSON, integers are raw wire values, bytes hex strings, and infinite or not-a-number "
      "floats "
      "the strings \"inf\", \"-inf\" and \"nan:<bits>\". A field 'tail' has what later firmware "
      "appends, or what can not be read because the request that says how was not seen.\n"
      "The exit status is 0 when all input was read, 1 when it could not be read, 2 for wrong "
      "usage.");
  command->callback([options, &status] { status = decode_file(*options); });
}

}  // namespace sbgc::tools
