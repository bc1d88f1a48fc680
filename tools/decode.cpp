// sbgc decode: a capture as JSON lines or as text for people.

#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sbgc/io/capture.hpp>
#include <sbgc/parser.hpp>

#include "capture_frames.hpp"
#include "commands.hpp"
#include "decoded_frame.hpp"
#include "hex_text.hpp"
#include "input.hpp"
#include "rows.hpp"
#include "text.hpp"

namespace sbgc::tools {

namespace {

struct DecodeOptions {
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

void check(const std::optional<HexError>& error) {
  if (error) throw InputError(to_text(*error));
}

/// What has been printed goes out now: a reader may be waiting for it.
void flush_output() {
  if (std::fflush(stdout) != 0) throw std::runtime_error("can not write to the standard output");
}

void print_line(const Json& line) {
  fmt::print("{}\n", line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// "no frame: 5 bytes", if there are bytes between two places of a stream.
void print_gap(const std::string& place, std::uint64_t begin, std::uint64_t end) {
  if (end > begin) fmt::print("{}  no frame: {}\n", place, counted(end - begin, "byte"));
}

void print_counters(const char* whose, const ParserCounters& counters) {
  fmt::print("{}{}, {} skipped (bad headers: {}, bad bodies: {})\n", whose,
             counted(counters.frames, "frame"), counted(counters.skipped_bytes, "byte"),
             counters.header_errors, counters.body_errors);
}

std::uint64_t end_of(const Frame& frame) {
  return frame.offset + Framing::frame_size(frame.body.size());
}

/// A stream of bytes of which nothing else is known.
class RawDecoder {
 public:
  explicit RawDecoder(const DecodeOptions& options)
      : jsonl_(options.format == "jsonl"), direction_(direction(options.from)) {}

  void feed(std::span<const std::uint8_t> bytes) {
    size_ += bytes.size();
    parser_.feed(bytes, [this](const Frame& frame) { print(frame); });
  }

  void finish() {
    parser_.flush([this](const Frame& frame) { print(frame); });
    if (jsonl_) return;
    print_gap(place(end_), end_, size_);
    print_counters("", parser_.counters());
  }

 private:
  static std::string place(std::uint64_t offset) { return fmt::format("@{}", offset); }

  void print(const Frame& frame) {
    const DecodedFrame decoded = decoder_.decode(frame, direction_);
    if (jsonl_) return print_line(decoded.to_json());
    print_gap(place(end_), end_, frame.offset);
    fmt::print("{}", to_text(decoded, place(frame.offset)));
    end_ = end_of(frame);
  }

  bool jsonl_;
  std::optional<Direction> direction_;
  Parser parser_;
  FrameDecoder decoder_;
  std::uint64_t size_ = 0;
  std::uint64_t end_ = 0;  // of what has been printed
};

/// A capture file, which knows who sent what and when.
class CaptureDecoder final : private CaptureListener {
 public:
  explicit CaptureDecoder(const DecodeOptions& options)
      : jsonl_(options.format == "jsonl"), only_(direction(options.from)), frames_(*this) {}

  void feed(std::span<const std::uint8_t> bytes) { frames_.feed(bytes); }

  /// Throws InputError if parts of the capture could not be read.
  void finish() {
    frames_.finish();
    if (!jsonl_) {
      for (const Direction side : {Direction::to_board, Direction::from_board}) {
        const bool board = side == Direction::from_board;
        if (wanted(side)) {
          print_counters(board ? "from the board: " : "to the board: ", frames_.counters(side));
        }
      }
    }
    flush_output();
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  bool wanted(Direction side) const { return !only_ || *only_ == side; }

  static std::string place(io::CaptureTime time) {
    return fmt::format("{}.{:06} s", time.count() / 1'000'000, time.count() % 1'000'000);
  }

  void on_session(const io::CaptureSession& session) override {
    decoder_ = FrameDecoder();
    ++session_;
    if (jsonl_) return;
    // As seconds: a time point would be converted to nanoseconds, which overflow in a far future.
    const auto start = std::chrono::floor<std::chrono::seconds>(session.start).time_since_epoch();
    fmt::print("session {}, begun {:%Y-%m-%d %H:%M:%S} UTC\n", session_,
               fmt::gmtime(static_cast<std::time_t>(start.count())));
  }

  void on_frame(Direction side, io::CaptureTime time, const Frame& frame) override {
    if (!wanted(side)) return;
    const DecodedFrame decoded = decoder_.decode(frame, side);
    if (!jsonl_) {
      fmt::print("{}", to_text(decoded, place(time)));
      return;
    }
    Json line = decoded.to_json();
    line["time"] = std::chrono::duration<double>(time).count();
    line["session"] = session_;
    print_line(line);
  }

  void on_skipped(Direction side, io::CaptureTime time, std::uint64_t size) override {
    if (!jsonl_ && wanted(side)) {
      fmt::print("{}  no frame: {} {} the board\n", place(time), counted(size, "byte"),
                 side == Direction::from_board ? "from" : "to");
    }
  }

  void on_note(io::CaptureTime time, std::string_view text) override {
    if (!jsonl_) fmt::print("{}  note: {}\n", place(time), rows_detail::quoted(text));
  }

  void on_damage(const io::CaptureDamage& damage) override {
    problems_ += (problems_.empty() ? "" : " ") + to_string(damage);
  }

  bool jsonl_;
  std::optional<Direction> only_;
  CaptureFrames frames_;
  FrameDecoder decoder_;
  int session_ = -1;
  std::string problems_;
};

/// The first bytes of the input, as many as are needed to tell whether it is a capture file.
std::vector<std::uint8_t> read_begin(Input& input) {
  std::vector<std::uint8_t> begin;
  do {
    const auto block = input.read();
    if (block.empty()) break;
    begin.insert(begin.end(), block.begin(), block.end());
  } while (io::may_become_capture(begin));
  return begin;
}

template <class Decoder>
void decode_bytes(Input& input, std::span<const std::uint8_t> begin, Decoder decoder) {
  for (auto block = begin; !block.empty(); block = input.read()) {
    decoder.feed(block);
    flush_output();
  }
  decoder.finish();
  flush_output();
}

void decode_hex(Input& input, RawDecoder decoder) {
  HexDecoder hex;
  std::vector<std::uint8_t> bytes;
  const auto feed = [&] {
    decoder.feed(bytes);
    bytes.clear();
    flush_output();
  };
  try {
    for (auto block = input.read(); !block.empty(); block = input.read()) {
      check(hex.feed(block, bytes));
      feed();
    }
    check(hex.finish());
  } catch (const InputError&) {
    feed();  // what stands before the mistake is good
    decoder.finish();
    flush_output();
    throw;
  }
  decoder.finish();
  flush_output();
}

int decode_file(const DecodeOptions& options) {
  Input input(options.file);
  if (options.hex) {
    decode_hex(input, RawDecoder(options));
    return success;
  }
  const std::vector<std::uint8_t> begin = read_begin(input);
  if (io::is_capture(begin)) {
    decode_bytes(input, begin, CaptureDecoder(options));
  } else {
    decode_bytes(input, begin, RawDecoder(options));
  }
  return success;
}

}  // namespace

void add_decode(CLI::App& app, int& status) {
  auto* const command = app.add_subcommand("decode", "Show the frames of a capture");
  auto options = std::make_shared<DecodeOptions>();
  command->add_option("file", options->file, "Capture to read; - is the standard input")
      ->capture_default_str();
  command
      ->add_option("--from", options->from,
                   "Who sent the bytes; auto takes each frame for what its size fits, the board's "
                   "meaning first. Of a capture file, which knows: whose frames to show")
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
      "The input may be raw bytes or a capture file as `sbgc record` writes it. Of the latter, "
      "JSON "
      "lines have more keys: 'time' in seconds since the session began, and 'session', a number "
      "from 0; offsets count the bytes of one direction and session.\n"
      "The exit status is 0 when all input was read, 1 when it could not be read, 2 for wrong "
      "usage.");
  command->callback([options, &status] { status = decode_file(*options); });
}

}  // namespace sbgc::tools
