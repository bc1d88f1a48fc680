// sbgc decode: prints a capture as JSON lines or as text.

#include <algorithm>
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
#include <sbgc/text/values.hpp>

#include "capture_frames.hpp"
#include "commands.hpp"
#include "decoded_frame.hpp"
#include "frame_text.hpp"
#include "hex_text.hpp"
#include "input.hpp"
#include "input_guess.hpp"
#include "rejected_candidates.hpp"
#include "serving/arguments.hpp"
#include "standard_output.hpp"
#include "wording.hpp"

namespace sbgc::tools {

namespace {

struct DecodeOptions {
  std::string file = "-";
  std::string from = "auto";
  std::string format = "text";
  bool hex = false;
  std::string firmware{};
};

/// Returns a decoder for the firmware of the options.
FrameDecoder decoder_of(const DecodeOptions& options) {
  const bool is_text = options.format == "text";
  const FrameDecoder::Wanted wanted{.json = !is_text, .rows = is_text};
  if (options.firmware.empty()) return FrameDecoder(wanted);
  // Any board: which features it has is not known.
  return FrameDecoder(wanted, Availability{serving::read_firmware(options.firmware).raw(), 0xFF});
}

std::optional<Direction> direction(const std::string& from) {
  if (from == "board") return Direction::from_board;
  if (from == "host") return Direction::to_board;
  return std::nullopt;
}

std::string to_text(const RejectedCandidate& candidate) {
  return fmt::format("    @{}: {}\n", candidate.offset, candidate.text);
}

/// Reports input without a frame, and guesses what it is.
[[nodiscard]] int no_frame(std::uint64_t size, const std::string& guess,
                           std::span<const RejectedCandidate> rejected) {
  fmt::print(stderr, "sbgc: found no frame in {}{}{}\n", counted(size, "byte"),
             guess.empty() ? "" : "; ", guess);
  for (const RejectedCandidate& candidate : rejected) {
    if (candidate.has_header) fmt::print(stderr, "{}", to_text(candidate));
  }
  return failure;
}

constexpr const char* line_may_be_wrong =
    "if they come from a serial line, its baud rate or parity may be wrong";

std::string to_text(const ParserCounters& counters) {
  return fmt::format("{}, {} skipped (bad headers: {}, bad bodies: {})\n",
                     counted(counters.frames, "frame"), counted(counters.skipped_bytes, "byte"),
                     counters.header_errors, counters.body_errors);
}

/// True if bytes without a frame were probably intended as frames: in noise, most start bytes are
/// not followed by a valid header.
bool looks_intended(const ParserCounters& counters) {
  const std::uint64_t with_header = counters.body_errors + counters.incomplete;
  return with_header != 0 && with_header >= counters.header_errors;
}

std::uint64_t end_of(const Frame& frame) {
  return frame.offset + frame_size(frame.framing, frame.body.size());
}

/// Decodes a raw byte stream.
class RawDecoder {
 public:
  RawDecoder(const DecodeOptions& options, StandardOutput& out)
      : out_(out),
        jsonl_(options.format == "jsonl"),
        is_hex_(options.hex),
        direction_(direction(options.from)),
        decoder_(decoder_of(options)),
        explainer_(direction_) {}

  void feed(std::span<const std::uint8_t> bytes) {
    size_ += bytes.size();
    begin_.insert(begin_.end(), bytes.begin(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(
                                      std::min(bytes.size(), guess_size - begin_.size())));
    const bool explains = explains_gaps();
    if (explains) explainer_.add(bytes);
    parser_.feed(bytes, [this](const Frame& frame) { print(frame); });
    if (explains) explainer_.advance(size_ - parser_.waiting_bytes());
  }

  /// Prints the remaining bytes. Returns the rejected candidates after the last frame.
  std::vector<RejectedCandidate> stop() {
    parser_.flush([this](const Frame& frame) { print(frame); });
    std::vector<RejectedCandidate> rejected;
    if (explains_gaps()) rejected = explainer_.end_gap(size_, size_);
    if (!jsonl_) {
      print_gap(size_, rejected);
      out_.put(to_text(parser_.counters()));
    }
    out_.flush();
    return rejected;
  }

  /// Like stop(), but also reports input without a frame. Returns the exit status.
  int finish() {
    const std::vector<RejectedCandidate> rejected = stop();
    if (parser_.counters().frames != 0 || size_ == 0) return success;
    std::string guess = guess_input(begin_, is_hex_);
    const bool is_meant = looks_intended(parser_.counters());
    if (guess.empty() && !is_meant) guess = line_may_be_wrong;
    const bool explains = jsonl_ && is_meant;
    return no_frame(size_, guess,
                    explains ? std::span(rejected) : std::span<const RejectedCandidate>());
  }

 private:
  void put_place(std::uint64_t offset) {
    out_.put('@');
    out_.put(offset);
  }

  /// JSON lines contain only frames, so gaps matter only until the first frame.
  bool explains_gaps() const { return !jsonl_ || parser_.counters().frames == 0; }

  void print(const Frame& frame) {
    const DecodedFrame decoded = decoder_.decode(frame, direction_);
    if (jsonl_) {
      put_json(out_, decoded);
      return out_.put('\n');
    }
    const std::uint64_t end = end_of(frame);
    print_gap(frame.offset, explainer_.end_gap(frame.offset, end));
    put_place(frame.offset);
    put_text(out_, decoded);
    end_ = end;
  }

  /// Prints "no frame: 5 bytes" and the reasons, if there are bytes since the last frame.
  void print_gap(std::uint64_t end, std::span<const RejectedCandidate> rejected) {
    if (end == end_) return;
    put_place(end_);
    out_.put(fmt::format("  no frame: {}\n", counted(end - end_, "byte")));
    for (const RejectedCandidate& candidate : rejected) out_.put(to_text(candidate));
  }

  StandardOutput& out_;
  bool jsonl_;
  bool is_hex_;
  std::optional<Direction> direction_;
  ParserOfAll parser_;
  FrameDecoder decoder_;
  GapExplainer explainer_;
  std::vector<std::uint8_t> begin_;
  std::uint64_t size_ = 0;
  std::uint64_t end_ = 0;  // end of the printed bytes
};

/// Decodes a capture file, which records direction and time.
class CaptureDecoder final : private CaptureListener {
 public:
  CaptureDecoder(const DecodeOptions& options, StandardOutput& out)
      : out_(out),
        jsonl_(options.format == "jsonl"),
        only_(direction(options.from)),
        frames_(*this),
        new_decoder_(decoder_of(options)) {}

  void feed(std::span<const std::uint8_t> bytes) { frames_.feed(bytes); }

  /// Returns the exit status. Throws InputError if parts of the capture are damaged.
  int finish() {
    frames_.finish();
    if (!jsonl_) {
      for (const Direction side : {Direction::to_board, Direction::from_board}) {
        const bool board = side == Direction::from_board;
        if (!wanted(side)) continue;
        out_.put(board ? "from the board: " : "to the board: ");
        out_.put(to_text(frames_.counters(side)));
      }
    }
    out_.flush();
    if (!problems_.empty()) throw InputError(problems_);
    if (found_ != 0 || skipped_ == 0) return success;
    const bool is_meant = looks_intended(frames_.counters(Direction::to_board)) ||
                          looks_intended(frames_.counters(Direction::from_board));
    const bool explains = jsonl_ && is_meant;
    return no_frame(skipped_, is_meant ? "" : line_may_be_wrong,
                    explains ? std::span<const RejectedCandidate>(rejected_)
                             : std::span<const RejectedCandidate>());
  }

 private:
  bool wanted(Direction side) const { return !only_ || *only_ == side; }

  static std::string place(io::CaptureTime time) {
    return fmt::format("{}.{:06} s", time.count() / 1'000'000, time.count() % 1'000'000);
  }

  void on_session(const io::CaptureSession& session) override {
    decoder_ = new_decoder_;
    ++session_;
    if (jsonl_) return;
    // Use seconds, because a conversion to nanoseconds overflows for dates far in the future.
    const auto start = std::chrono::floor<std::chrono::seconds>(session.start).time_since_epoch();
    out_.put(fmt::format("session {}, started {:%Y-%m-%d %H:%M:%S} UTC\n", session_,
                         fmt::gmtime(static_cast<std::time_t>(start.count()))));
  }

  void on_frame(Direction side, io::CaptureTime time, const Frame& frame) override {
    ++found_;
    if (!wanted(side)) return;
    const DecodedFrame decoded = decoder_.decode(frame, side);
    if (!jsonl_) {
      out_.put(place(time));
      return put_text(out_, decoded);
    }
    const CapturePlace place{std::chrono::duration<double>(time).count(), session_};
    put_json(out_, decoded, &place);
    out_.put('\n');
  }

  void on_skipped(Direction side, io::CaptureTime time, std::uint64_t size,
                  std::span<const RejectedCandidate> rejected) override {
    skipped_ += size;
    if (rejected_.empty()) rejected_.assign(rejected.begin(), rejected.end());
    if (!jsonl_ && wanted(side)) {
      out_.put(fmt::format("{}  no frame: {} {} the board\n", place(time), counted(size, "byte"),
                           side == Direction::from_board ? "from" : "to"));
      for (const RejectedCandidate& candidate : rejected) out_.put(to_text(candidate));
    }
  }

  void on_note(io::CaptureTime time, std::string_view text) override {
    if (!jsonl_) out_.put(fmt::format("{}  note: {}\n", place(time), detail::quoted(text)));
  }

  void on_damage(const io::CaptureDamage& damage) override {
    problems_ += (problems_.empty() ? "" : " ") + to_string(damage);
  }

  StandardOutput& out_;
  bool jsonl_;
  std::optional<Direction> only_;
  CaptureFrames frames_;
  FrameDecoder new_decoder_;
  FrameDecoder decoder_ = new_decoder_;
  int session_ = -1;
  std::uint64_t found_ = 0;  // number of frames
  std::uint64_t skipped_ = 0;
  std::vector<RejectedCandidate> rejected_;  // of the first gap that has any
  std::string problems_;
};

/// Reads enough bytes to decide whether the input is a capture file.
std::vector<std::uint8_t> read_begin(Input& input) {
  std::vector<std::uint8_t> begin;
  do {
    const auto block = input.read();
    if (block.empty()) break;
    begin.insert(begin.end(), block.begin(), block.end());
  } while (io::may_become_capture(begin));
  return begin;
}

/// Prints the frames before an error in hex text, then reports the error.
[[noreturn]] void fail_at(const HexError& error, RawDecoder& decoder, bool is_text) {
  decoder.stop();
  throw InputError(to_text(error) + (is_text ? "" : "; omit --hex for raw bytes"));
}

template <class Decoder>
int decode_bytes(Input& input, std::span<const std::uint8_t> begin, Decoder decoder,
                 StandardOutput& out) {
  for (auto block = begin; !block.empty(); block = input.read()) {
    decoder.feed(block);
    out.flush();
  }
  return decoder.finish();
}

int decode_hex(Input& input, RawDecoder decoder, StandardOutput& out) {
  HexDecoder hex;
  std::vector<std::uint8_t> bytes;
  bool is_text = true;
  for (auto block = input.read(); !block.empty(); block = input.read()) {
    is_text = is_text && !is_binary(block);
    std::optional<HexError> error = hex.feed(block, bytes);
    decoder.feed(bytes);
    bytes.clear();
    out.flush();
    if (error) fail_at(*error, decoder, is_text);
  }
  if (const auto error = hex.finish()) fail_at(*error, decoder, is_text);
  return decoder.finish();
}

int decode_file(const DecodeOptions& options) {
  Input input(options.file);
  StandardOutput out;
  if (options.hex) return decode_hex(input, RawDecoder(options, out), out);
  const std::vector<std::uint8_t> begin = read_begin(input);
  if (io::is_capture(begin)) return decode_bytes(input, begin, CaptureDecoder(options, out), out);
  return decode_bytes(input, begin, RawDecoder(options, out), out);
}

}  // namespace

void add_decode(CLI::App& app, int& status) {
  auto* const command = app.add_subcommand("decode", "Show the frames of a capture");
  auto options = std::make_shared<DecodeOptions>();
  command->add_option("file", options->file, "Capture to read; - means standard input")
      ->capture_default_str();
  command
      ->add_option("--from", options->from,
                   "Sender of the bytes. auto decides by the size of each frame, and prefers the "
                   "board. A capture file records the sender; then this selects the frames to show")
      ->check(CLI::IsMember({"auto", "board", "host"}))
      ->capture_default_str();
  command->add_option("--format", options->format, "Output format")
      ->check(CLI::IsMember({"text", "jsonl"}))
      ->capture_default_str();
  command
      ->add_option("--firmware", options->firmware,
                   "Firmware of the board, such as 2.59: name what it does not know")
      ->check([](const std::string& text) -> std::string {
        try {
          serving::read_firmware(text);
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
        return {};
      });
  command->add_flag("--hex", options->hex, "Read hex text instead of raw bytes");
  command->footer(
      "In JSON, integers are raw values, bytes are hex strings, and infinite or NaN floats are "
      "the strings \"inf\", \"-inf\" and \"nan:<bits>\". A field 'tail' holds bytes that later "
      "firmware appends, or that cannot be decoded because the request was not captured.\n"
      "The input is raw bytes or a capture file written by `sbgc record`. For the latter, JSON "
      "lines have two more keys: 'time' in seconds since the start of the session, and "
      "'session', counted from 0. Offsets count the bytes of one direction and session.\n"
      "Text output explains gaps between frames that look like damaged frames.\n"
      "The exit status is 0 if all input was read and contained a frame, or was empty; 1 if it "
      "could not be read or contained none; 2 for wrong usage.");
  command->callback([options, &status] { status = decode_file(*options); });
}

}  // namespace sbgc::tools
