// sbgc decode: prints a capture as JSON lines or as text.

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/text/values.hpp>

#include "command/input_output.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "frames/capture_frames.hpp"
#include "frames/capture_packets.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/frame_output.hpp"
#include "frames/input_guess.hpp"
#include "frames/pasted_text.hpp"
#include "frames/rejected_candidates.hpp"
#include "values/field_lookup.hpp"
#include "values/field_text.hpp"

namespace sbgc::tools {

namespace {

struct DecodeOptions {
  std::vector<std::string> input{};  ///< a file, or bytes as text; none: the standard input
  std::vector<std::string> from{};   // a side, a time, or both
  std::optional<std::chrono::microseconds> to{};
  std::string format = "text";
  std::string firmware{};
  std::vector<std::string> messages{};
  std::vector<std::string> conditions{};
  bool real = false;
  bool shows_passwords = false;
  bool hex = false;
  bool raw = false;
};

/// The part of a capture to show, in time since its start.
struct TimeRange {
  std::chrono::microseconds from = std::chrono::microseconds::min();
  std::chrono::microseconds to = std::chrono::microseconds::max();

  bool has(std::chrono::microseconds time) const { return time >= from && time <= to; }
};

/// The evaluated options.
struct DecodePlan {
  std::optional<Direction> direction{};
  TimeRange times{};
  bool has_times = false;
  FrameOutputOptions output{};
};

/// Parses seconds, such as "12.5", or a duration with a unit.
std::optional<std::chrono::microseconds> parse_time(const std::string& text) {
  if (const auto duration = parse_duration(text)) return *duration;
  const auto seconds = detail::parse_number<double>(text);
  constexpr double longest = 1e9;
  if (!seconds || !(*seconds >= 0 && *seconds <= longest)) return std::nullopt;
  return std::chrono::microseconds(std::llround(*seconds * 1e6));
}

std::optional<Direction> parse_side(const std::string& text) {
  if (detail::is_same_word(text, "board")) return Direction::from_board;
  if (detail::is_same_word(text, "host")) return Direction::to_board;
  return std::nullopt;
}

/// Evaluates the options. Throws CommandError.
DecodePlan plan_of(const DecodeOptions& options) {
  DecodePlan plan;
  bool has_side = false;
  for (const std::string& from : options.from) {
    const auto time = parse_time(from);
    if (time ? plan.has_times : has_side) {
      throw CommandError("--from takes one sender and one time", wrong_usage);
    }
    if (time) {
      plan.times.from = *time;
      plan.has_times = true;
    } else {
      plan.direction = parse_side(from);
      has_side = true;
    }
  }
  if (options.to) plan.times.to = *options.to;
  plan.has_times = plan.has_times || options.to;
  if (plan.times.from > plan.times.to) {
    throw CommandError("the time of --from is after that of --to", wrong_usage);
  }
  plan.output.format = format_named(options.format);
  plan.output.real = options.real;
  if (options.shows_passwords) plan.output.secrets = Secrets::shown;
  if (options.real && plan.output.format != OutputFormat::jsonl) {
    throw CommandError("--real is for --format jsonl: the other formats always show these values",
                       wrong_usage);
  }
  if (!options.firmware.empty()) {
    // Any board: its features are not known.
    plan.output.versions = Availability{parse_firmware(options.firmware)->raw(), 0xFF};
  }
  try {
    for (const std::string& name : options.messages) plan.output.filter.add_message(name);
    for (const std::string& text : options.conditions) plan.output.filter.add_condition(text);
  } catch (const ValueError& error) {
    throw CommandError(error.what(), wrong_usage);
  }
  return plan;
}

/// Throws CommandError for times, which plain bytes do not have.
void reject_times(const DecodePlan& plan) {
  if (plan.has_times) {
    throw CommandError("only a capture has times: omit --to and the time of --from", wrong_usage);
  }
}

std::string to_text(const RejectedCandidate& candidate) {
  return fmt::format("    @{}: {}\n", candidate.offset, candidate.text);
}

/// Reports input without a frame, with a guess at its format. `reading` describes how text was
/// read, whose bytes no baud rate has changed. `is_meant`: it probably contains frames, whose
/// damage is explained unless `shows_gaps` has already done so.
[[nodiscard]] int no_frame(std::uint64_t size, const std::string& reading, std::string guess,
                           bool is_meant, bool shows_gaps,
                           std::span<const RejectedCandidate> rejected) {
  if (guess.empty() && !is_meant) {
    guess =
        reading.empty()
            ? "if they come from a serial line, its baud rate or parity may be wrong"
            : "a frame is a start byte, its id, its size, the sum of both, the body and a checksum";
  }
  remark_failure(fmt::format("found no frame in {}{}{}{}", counted(size, "byte"), reading,
                             guess.empty() ? "" : "; ", guess));
  for (const RejectedCandidate& candidate : rejected) {
    if (is_meant && !shows_gaps && candidate.has_header) remark("{}", to_text(candidate));
  }
  return failure;
}

/// Reports that none of the frames can be decoded. JSON lines already show it.
[[nodiscard]] int unreadable(std::uint64_t frames) {
  remark_failure(fmt::format("{} with sound checksums, but {} its command",
                             counted(frames, "frame"),
                             frames == 1 ? "the body does not fit" : "no body fits"));
  return failure;
}

std::string to_text(const ParserCounters& counters) {
  return fmt::format("{}, {} skipped (bad headers: {}, bad bodies: {})\n",
                     counted(counters.frames, "frame"), counted(counters.skipped_bytes, "byte"),
                     counters.header_errors, counters.body_errors);
}

/// True if bytes without a frame were probably frames before a driver changed them.
bool looks_changed(std::span<const RejectedCandidate> rejected) {
  return !rejected.empty() && std::ranges::all_of(rejected, &RejectedCandidate::is_changed);
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
  /// `text` is the source of the bytes, if they come from text.
  RawDecoder(const DecodePlan& plan, PastedText* text, StandardOutput& out)
      : out_(out),
        text_(text),
        direction_(plan.direction),
        // Gaps belong to no frame that a filter could select.
        shows_gaps_(plan.output.format == OutputFormat::text && plan.output.filter.is_empty()),
        is_for_people_(plan.output.format != OutputFormat::jsonl),
        output_(plan.output, out),
        explainer_(direction_) {
    reject_times(plan);
  }

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
    if (shows_gaps_) print_gap(size_, rejected);
    print_bare_frames();
    output_.put_remark(to_text(parser_.counters()));
    output_.end();
    out_.flush();
    return rejected;
  }

  /// Like stop(), but also reports input without a frame. Returns the exit status.
  int finish() {
    const std::vector<RejectedCandidate> rejected = stop();
    const std::uint64_t frames = parser_.counters().frames;
    if (frames != 0 && is_for_people_ && output_.is_unreadable()) return unreadable(frames);
    if (frames != 0 || size_ == 0) return success;
    const bool is_meant = looks_intended(parser_.counters()) || looks_changed(rejected);
    const std::string reading =
        text_ == nullptr ? "" : fmt::format(", read as {}", to_text(text_->reading()));
    std::string guess = guess_input(begin_, text_ != nullptr);
    if (bare_ != 0) {
      guess = fmt::format("they are {} without start bytes{}", counted(bare_, "frame"),
                          output_.is_text() ? "" : ", which --format text shows");
    }
    return no_frame(size_, reading, guess, is_meant, shows_gaps_, rejected);
  }

 private:
  /// Without gaps in the output, they matter only until the first frame.
  bool explains_gaps() const { return shows_gaps_ || parser_.counters().frames == 0; }

  /// Shows truncated frames: without a start byte, and perhaps without a checksum.
  void print_bare_frames() {
    if (parser_.counters().frames != 0 || size_ != begin_.size()) return;
    const std::vector<BareFrame> found = bare_frames(begin_);
    bare_ = found.size();
    if (!output_.is_text()) return;
    for (const BareFrame& bare : found) {
      print_frame(bare.frame, fmt::format("@{}, {}:", bare.frame.offset, what_is_missing(bare)));
    }
  }

  void print(const Frame& frame) {
    const std::uint64_t end = end_of(frame);
    if (shows_gaps_) print_gap(frame.offset, explainer_.end_gap(frame.offset, end));
    std::string_view heading;
    if (output_.is_text()) heading = place(frame.offset);
    print_frame(frame, heading);
    end_ = end;
  }

  void print_frame(const Frame& frame, std::string_view heading) {
    const bool is_told = direction_.has_value() || text_ == nullptr;
    output_.print(frame, is_told ? direction_ : text_->sender(frame.offset), heading);
  }

  /// Prints "no frame: 5 bytes" and the reasons, if there are bytes since the last frame.
  void print_gap(std::uint64_t end, std::span<const RejectedCandidate> rejected) {
    if (end == end_) return;
    out_.put(place(end_));
    out_.put(fmt::format("  no frame: {}\n", counted(end - end_, "byte")));
    for (const RejectedCandidate& candidate : rejected) out_.put(to_text(candidate));
  }

  /// Returns "@123", valid until the next call.
  std::string_view place(std::uint64_t offset) {
    place_.resize(1 + TextOutput::longest_number);
    char* const end = std::to_chars(place_.data() + 1, place_.data() + place_.size(), offset).ptr;
    place_.resize(static_cast<std::size_t>(end - place_.data()));
    return place_;
  }

  StandardOutput& out_;
  PastedText* text_;
  std::optional<Direction> direction_;
  bool shows_gaps_;
  bool is_for_people_;
  FrameOutput output_;
  ParserOfAll parser_;
  GapExplainer explainer_;
  std::string place_ = "@";
  std::vector<std::uint8_t> begin_;
  std::uint64_t size_ = 0;
  std::uint64_t end_ = 0;  // end of the printed bytes
  std::size_t bare_ = 0;   // frames without start bytes
};

/// Formats a time after 1970 for any year: those of a time_t can end in 2038, and those of
/// std::chrono in 32767. The calendar repeats after 400 years.
std::string utc_text(std::chrono::sys_seconds time) {
  constexpr std::chrono::days cycle{146'097};
  const auto cycles = time.time_since_epoch() / cycle;
  const std::chrono::sys_seconds in_cycle(time.time_since_epoch() % cycle);
  const auto day = std::chrono::floor<std::chrono::days>(in_cycle);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(in_cycle - day);
  return fmt::format("{}-{:02}-{:02} {:02}:{:02}:{:02} UTC",
                     static_cast<int>(date.year()) + 400 * cycles,
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

/// Decodes a capture file, which records direction and time.
class CaptureDecoder final : private CaptureListener {
 public:
  CaptureDecoder(const DecodePlan& plan, StandardOutput& out)
      : out_(out),
        only_(plan.direction),
        times_(plan.times),
        shows_gaps_(plan.output.format == OutputFormat::text && plan.output.filter.is_empty()),
        is_for_people_(plan.output.format != OutputFormat::jsonl),
        output_(plan.output, out),
        frames_(*this) {}

  void feed(std::span<const std::uint8_t> bytes) { frames_.feed(bytes); }

  /// Returns the exit status. Throws InputError if parts of the capture are damaged.
  int finish() {
    frames_.finish();
    for (const Direction side : {Direction::to_board, Direction::from_board}) {
      if (only_ && *only_ != side) continue;
      output_.put_remark(side == Direction::from_board ? "from the board: " : "to the board: ");
      output_.put_remark(to_text(frames_.counters(side)));
    }
    output_.end();
    out_.flush();
    if (!problems_.empty()) throw InputError(problems_);
    if (found_ != 0 && is_for_people_ && output_.is_unreadable()) return unreadable(found_);
    if (found_ != 0 || skipped_ == 0) return success;
    const bool is_meant = looks_intended(frames_.counters(Direction::to_board)) ||
                          looks_intended(frames_.counters(Direction::from_board)) ||
                          looks_changed(rejected_);
    return no_frame(skipped_, "", "", is_meant, shows_gaps_, rejected_);
  }

 private:
  bool wanted(Direction side, io::CaptureTime time) const {
    return (!only_ || *only_ == side) && times_.has(since_start(time));
  }

  /// Returns the time since the start of the first session.
  std::chrono::microseconds since_start(io::CaptureTime time) const {
    return start_ - first_start_ + time;
  }

  static std::string place(io::CaptureTime time) {
    return fmt::format("{}.{:06} s", time.count() / 1'000'000, time.count() % 1'000'000);
  }

  void on_session(const io::CaptureSession& session) override {
    output_.begin_session();
    ++session_;
    if (session_ == 0) first_start_ = session.start;
    start_ = session.start;
    output_.put_remark(fmt::format("session {}, started {}\n", session_,
                                   utc_text(std::chrono::floor<std::chrono::seconds>(start_))));
  }

  void on_frame(Direction side, io::CaptureTime time, const Frame& frame) override {
    ++found_;
    if (!wanted(side, time)) return output_.learn(frame, side);
    using Seconds = std::chrono::duration<double>;
    const CapturePlace place_of_frame{Seconds(time).count(), session_,
                                      Seconds(since_start(time)).count()};
    output_.print(frame, side, output_.is_text() ? place(time) : "", &place_of_frame);
  }

  void on_skipped(Direction side, io::CaptureTime time, std::uint64_t size,
                  std::span<const RejectedCandidate> rejected) override {
    skipped_ += size;
    if (rejected_.empty()) rejected_.assign(rejected.begin(), rejected.end());
    if (!shows_gaps_ || !wanted(side, time)) return;
    out_.put(fmt::format("{}  no frame: {} {} the board\n", place(time), counted(size, "byte"),
                         side == Direction::from_board ? "from" : "to"));
    for (const RejectedCandidate& candidate : rejected) out_.put(to_text(candidate));
  }

  void on_note(io::CaptureTime time, std::string_view text) override {
    if (!shows_gaps_ || !times_.has(since_start(time))) return;
    out_.put(fmt::format("{}  note: {}\n", place(time), detail::quoted(text)));
  }

  void on_damage(const io::CaptureDamage& damage) override {
    problems_ += (problems_.empty() ? "" : " ") + to_string(damage);
  }

  StandardOutput& out_;
  std::optional<Direction> only_;
  TimeRange times_;
  bool shows_gaps_;
  bool is_for_people_;
  FrameOutput output_;
  CaptureFrames frames_;
  int session_ = -1;
  std::chrono::sys_time<std::chrono::microseconds> first_start_{};
  std::chrono::sys_time<std::chrono::microseconds> start_{};  // of the session
  std::uint64_t found_ = 0;                                   // number of frames
  std::uint64_t skipped_ = 0;
  std::vector<RejectedCandidate> rejected_;  // of the first gap that has any
  std::string problems_;
};

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

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

constexpr const char* awaited = "bytes, such as a log or hex text";

/// Opens the file, or interprets the arguments as the bytes themselves. Throws InputError or
/// CommandError.
Input input_of(const DecodeOptions& options) {
  if (options.input.empty()) return {"-", awaited};
  const std::string& first = options.input.front();
  std::error_code ignored;
  const bool is_one = options.input.size() == 1;
  if (is_one && (first == "-" || std::filesystem::exists(first, ignored))) return {first, awaited};
  const std::string text = fmt::format("{}", fmt::join(options.input, " "));
  const ReadingChoice choice = choose_reading(bytes_of(text));
  if (options.hex || (choice.is_likely && !options.raw)) return Input(text);
  if (is_one) return {first, awaited};
  throw CommandError("the arguments are neither one file nor bytes that begin a frame",
                     wrong_usage);
}

/// Prints the frames before an error in text, then reports the error.
template <class Decoder>
[[noreturn]] void fail_at(const TextError& error, const PastedText& text, Decoder& decoder,
                          bool is_text) {
  decoder.stop();
  throw InputError(to_text(text.reading(), error) +
                   (is_text ? "" : "; for raw bytes, use --raw and not --hex"));
}

/// Returns how to read the text. Throws InputError if that is ambiguous, unless `is_said` states
/// that it is hex.
Reading reading_of(std::span<const std::uint8_t> begin, bool is_said) {
  const ReadingChoice choice = choose_reading(begin);
  if (choice.other && !is_said) {
    throw InputError(
        fmt::format("this can be {} or {}, with different bytes; --hex means the former",
                    to_text(choice.reading), to_text(*choice.other)));
  }
  return choice.reading;
}

template <class Decoder>
int decode_bytes(Input& input, std::span<const std::uint8_t> begin, Decoder&& decoder,
                 StandardOutput& out) {
  for (auto block = begin; !block.empty(); block = input.read()) {
    decoder.feed(block);
    out.flush();
  }
  return decoder.finish();
}

/// Decodes the bytes that `text` represents.
template <class Decoder>
int decode_text(Input& input, std::span<const std::uint8_t> begin, PastedText& text,
                Decoder&& decoder, StandardOutput& out) {
  std::vector<std::uint8_t> bytes;
  bool is_text = true;
  bool has_bytes = false;
  const auto deliver = [&](const std::optional<TextError>& error) {
    has_bytes = has_bytes || !bytes.empty();
    decoder.feed(bytes);
    bytes.clear();
    out.flush();
    if (error) fail_at(*error, text, decoder, is_text);
  };
  for (auto block = begin; !block.empty(); block = input.read()) {
    is_text = is_text && !is_binary(block);
    deliver(text.feed(block, bytes));
  }
  deliver(text.finish(bytes));
  // Comments alone are an empty text, which is valid.
  if (has_bytes || !text.has_fronts()) return decoder.finish();
  decoder.stop();
  throw InputError(
      fmt::format("there are no bytes in the text, read as {}", to_text(text.reading())));
}

/// Throws CommandError for options that select or describe frames: a file for Wireshark has all
/// bytes.
void reject_options_of_frames(const DecodeOptions& options) {
  const std::pair<bool, const char*> given[] = {
      {!options.messages.empty(), "--message"},
      {!options.conditions.empty(), "--where"},
      {options.real, "--real"},
      {options.shows_passwords, "--show-passwords"},
      {!options.firmware.empty(), "--firmware"},
  };
  for (const auto& [is_given, name] : given) {
    if (!is_given) continue;
    throw CommandError(
        fmt::format("{} has no effect on --format pcapng, which keeps all bytes", name),
        wrong_usage);
  }
}

int write_packets(const DecodeOptions& options) {
  reject_options_of_frames(options);
  require_no_terminal("another --format");
  DecodeOptions of_plan = options;
  of_plan.format = "text";
  const DecodePlan plan = plan_of(of_plan);
  Input input = input_of(options);
  StandardOutput out;
  const std::vector<std::uint8_t> begin = read_begin(input);
  const bool is_text = options.hex || (!options.raw && is_text_of_bytes(begin));
  if (is_text || options.raw || !io::is_capture(begin)) {
    if (!plan.direction) {
      throw CommandError(
          "only a capture has senders: --format pcapng needs --from board or --from host",
          wrong_usage);
    }
    reject_times(plan);
    BytePackets packets(out, *plan.direction);
    if (!is_text) return decode_bytes(input, begin, packets, out);
    PastedText text(reading_of(begin, options.hex));
    return decode_text(input, begin, text, packets, out);
  }
  const auto wants = [&plan](Direction direction, std::chrono::microseconds time) {
    return (!plan.direction || *plan.direction == direction) && plan.times.has(time);
  };
  return decode_bytes(input, begin, CapturePackets(out, wants), out);
}

int decode_file(const DecodeOptions& options) {
  if (options.format == "pcapng") return write_packets(options);
  const DecodePlan plan = plan_of(options);
  Input input = input_of(options);
  StandardOutput out;
  const std::vector<std::uint8_t> begin = read_begin(input);
  if (options.hex || (!options.raw && is_text_of_bytes(begin))) {
    PastedText text(reading_of(begin, options.hex));
    return decode_text(input, begin, text, RawDecoder(plan, &text, out), out);
  }
  if (!options.raw && io::is_capture(begin)) {
    return decode_bytes(input, begin, CaptureDecoder(plan, out), out);
  }
  return decode_bytes(input, begin, RawDecoder(plan, nullptr, out), out);
}

}  // namespace

void add_decode(CLI::App& app, CommandContext& context) {
  const Subcommand<DecodeOptions> command(app, context, "decode", "Show the frames of a capture");
  auto& options = command.options();
  command
      ->add_option("file", options.input,
                   "Capture to read, or the bytes themselves as text; - or nothing is standard "
                   "input")
      ->type_name("FILE");
  command
      ->add_option("--from", options.from,
                   "Sender of the bytes: board, host, or auto, which decides by the size of each "
                   "frame and marks a guess. In a capture, which records the sender, this "
                   "selects frames. Or a time in seconds since the start of the capture: show "
                   "frames from then on. You may give both")
      ->type_name("auto|board|host|TIME")
      ->allow_extra_args(false)
      ->check([](const std::string& text) -> std::string {
        if (detail::is_same_word(text, "auto") || parse_side(text) || parse_time(text)) return {};
        return fmt::format("'{}' is neither auto, board or host, nor a time", text);
      });
  command
      ->add_option_function<std::string>(
          "--to",
          [&options](const std::string& text) {
            options.to = parse_time(text);
            if (!options.to) throw CLI::ValidationError("--to", "'" + text + "' is not a time");
          },
          "Show frames up to this time, in seconds since the start of the capture")
      ->type_name("TIME");
  command
      ->add_option("-m,--message", options.messages,
                   "Show only this message or command, by name or id; may be repeated")
      ->type_name("MESSAGE")
      ->allow_extra_args(false);
  command
      ->add_option("-w,--where", options.conditions,
                   "Show only frames that satisfy this condition, as in the examples; may be "
                   "repeated")
      ->type_name("CONDITION")
      ->allow_extra_args(false);
  add_format(
      *command, options.format, {"text", "jsonl", "csv", "pcapng"},
      "Output format: csv for one kind of message, pcapng for Wireshark, which needs --from for "
      "raw bytes");
  command->add_flag("--real", options.real, "Add values in their units, and names, to JSON lines");
  command->add_flag("--show-passwords", options.shows_passwords,
                    "Show passwords instead of (hidden)");
  command
      ->add_option("--firmware", options.firmware,
                   "Firmware of the board, such as 2.59: report what it does not have")
      ->type_name("VERSION")
      ->check(firmware_problem);
  auto* const hex = command->add_flag(
      "--hex", options.hex,
      "Read text, such as hex, a hex dump or a list of numbers; usually detected");
  command->add_flag("--raw", options.raw, "Read raw bytes, whatever they look like")->excludes(hex);
  command->footer(
      "In JSON, integers are raw values, bytes are hex strings, and infinite or NaN floats are "
      "the strings \"inf\", \"-inf\" and \"nan:<bits>\". A field 'tail' holds bytes that later "
      "firmware appends, that the board ignores in a request, or that cannot be decoded because "
      "the request was not captured.\n"
      "The input is raw bytes or a capture file of `sbgc record`. For a capture, JSON lines have "
      "two more keys: 'time' in seconds since the start of the session, and 'session', counted "
      "from 0. Offsets count the bytes of one direction and session.\n"
      "Text output also explains damaged frames, unless options select frames. With --real, JSON "
      "lines have 'values' by path: 'raw', 'real' with 'unit', and 'text' of a value with a "
      "name. CSV has a line per frame and a column per value in its unit; the first column is "
      "the time since the start of the capture, or the offset in raw bytes.\n"
      "\n"
      "Examples:\n"
      "  sbgc decode 3e49004900\n"
      "  sbgc decode --where \"cmd=CMD_CONTROL\" capture\n"
      "  sbgc decode --where \"system_error & ERR_LOW_BAT1\" --from 0 --to 60 capture\n"
      "  sbgc decode --where \"angle.pitch > 10deg\" --format csv capture\n"
      "\n"
      "The exit status is 0 if all input was read and contained a frame, or was empty; 1 if it "
      "could not be read, contained none, or, except in JSON lines, none that can be decoded; 2 "
      "for wrong usage.");
  command.runs(decode_file);
}

}  // namespace sbgc::tools
