#include "frames/pasted_text.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include <sbgc/framing.hpp>
#include <sbgc/parser.hpp>

#include "frames/command_lookup.hpp"

namespace sbgc::tools {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<const char*, 10> notation_names{
    "hex text",
    "decimal numbers",
    "a hex dump",
    "strings",
    "characters and bytes in braces",
    "lines of the Debug tab of the vendor's program",
    "the output of strace",
    "the output of socat",
    "the output of candump",
    "a table of bytes"};

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The score of an interpretation of a text; higher is better.
struct Score {
  std::uint64_t in_frames = 0;
  bool is_all_frames = false;
  bool is_bare = false;  ///< frames without start bytes, and nothing else
  bool begins_frame = false;

  // NOLINTNEXTLINE(modernize-use-nullptr, readability-implicit-bool-conversion): of the compiler
  auto operator<=>(const Score&) const = default;
  bool is_none() const { return in_frames == 0 && !is_bare && !begins_frame; }
};

Score score_of(std::span<const std::uint8_t> bytes) {
  ParserOfAll parser;
  std::uint64_t in_frames = 0;
  parser.feed(bytes, [&](const Frame& frame) {
    in_frames += frame_size(frame.framing, frame.body.size());
  });
  return {in_frames, in_frames != 0 && in_frames + parser.waiting_bytes() == bytes.size(),
          in_frames == 0 && !bare_frames(bytes).empty(),
          !bytes.empty() && AllFrameFormats::is_start(bytes.front())};
}

/// The result of an interpretation of a text.
struct Attempt {
  Reading reading{};
  Bytes bytes{};
  Score score{};
  std::optional<TextError> error{};

  Attempt(const Reading& how, std::span<const std::uint8_t> text) : reading(how) {
    PastedText reader(reading);
    error = reader.feed(text, bytes);
    if (!error) error = reader.finish(bytes);
    score = score_of(bytes);
    // Otherwise it equals another reading; and any text could be characters, or a log without
    // bytes.
    const bool says_it = !reading.skips_fronts || reader.has_fronts();
    const bool is_any_text = reading.notation >= Notation::literals;
    if (says_it && !(is_any_text && score.is_none())) return;
    error = TextError{};
    score = {};
  }
};

}  // namespace

std::string to_text(const Reading& reading) {
  return fmt::format("{}{}", notation_names.at(static_cast<std::size_t>(reading.notation)),
                     reading.skips_fronts ? " after times or names" : "");
}

std::string to_text(const Reading& reading, const TextError& error) {
  return fmt::format("{}, line {} column {}: {}", to_text(reading), error.line, error.column,
                     error.reason);
}

std::optional<TextError> PastedText::feed(std::span<const std::uint8_t> text, Bytes& out) {
  // Windows editors mark UTF-8.
  const bool is_begin = std::exchange(is_begin_, false);
  if (is_begin && text_of(text).starts_with("\xEF\xBB\xBF")) text = text.subspan(3);
  if (reading_.notation == Notation::hex && !reading_.skips_fronts) return hex_.feed(text, out);
  std::string_view rest = text_of(text);
  while (true) {
    const std::size_t end = rest.find('\n');
    line_ += rest.substr(0, end);
    constexpr std::size_t longest = 16U << 20U;
    if (line_.size() > longest) return TextError{lines_ + 1, longest, "the line is too long"};
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 1);
    if (auto error = read_line(std::exchange(line_, {}), out)) return error;
  }
}

std::optional<TextError> PastedText::finish(Bytes& out) {
  if (!line_.empty()) return read_line(std::exchange(line_, {}), out);
  return reading_.skips_fronts ? std::nullopt : hex_.finish(out);
}

std::optional<TextError> PastedText::read_line(std::string_view line, Bytes& out) {
  ++lines_;
  const bool is_of_numbers = reading_.notation == Notation::hex ||
                             reading_.notation == Notation::decimal ||
                             reading_.notation == Notation::dump;
  std::string plain;
  if (reading_.skips_fronts && is_of_numbers) {
    plain = without_comments(line);
    has_fronts_ = has_fronts_ || plain != line;
    line = plain;
  }
  const LineFront front = reading_.skips_fronts ? front_of(line) : LineFront{};
  has_fronts_ = has_fronts_ || front.size > line.find_first_not_of(" \t");
  note_sender(front.sender);
  if (reading_.skips_fronts && is_of_numbers && is_prose(line.substr(front.size))) {
    has_fronts_ = true;
    return {};
  }
  const std::size_t before = out.size();
  std::optional<Direction> sender;
  const auto problem = read_bytes(line.substr(front.size), out, sender);
  note_sender(sender);
  size_ += out.size() - before;
  if (!problem) return {};
  return TextError{lines_, front.size + problem->column + 1, problem->reason};
}

void PastedText::note_sender(std::optional<Direction> sender) {
  if (!sender || sender == sender_) return;
  sender_ = sender;
  senders_.emplace_back(size_, *sender);
}

std::optional<LineProblem> PastedText::read_bytes(std::string_view line, Bytes& out,
                                                  std::optional<Direction>& sender) {
  switch (reading_.notation) {
    case Notation::hex: break;
    case Notation::decimal: return read_decimal(line, out);
    case Notation::dump: return dump_.read(line, out);
    case Notation::literals: return read_literals(line, out);
    case Notation::braced: return read_braced(line, out);
    case Notation::debug_tab: return read_debug_tab(line, out);
    case Notation::strace: return read_strace(line, out, sender);
    case Notation::socat: return socat_.read(line, out);
    case Notation::candump: return read_candump(line, out, sender);
    case Notation::table: return table_.read(line, out, sender);
  }
  HexDecoder hex;
  auto error = hex.feed({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, out);
  if (!error) error = hex.finish(out);
  if (!error) return {};
  return LineProblem{error->column - 1, error->reason};
}

std::optional<Direction> PastedText::sender(std::uint64_t offset) {
  while (senders_.size() > 1 && senders_[1].first <= offset) senders_.pop_front();
  if (senders_.empty() || senders_.front().first > offset) return {};
  return senders_.front().second;
}

ReadingChoice choose_reading(std::span<const std::uint8_t> begin) {
  // A line at the end of a block may continue in the next one.
  constexpr std::size_t block = 4096;
  const std::size_t end = text_of(begin).rfind('\n');
  if (begin.size() >= block && end != std::string_view::npos) begin = begin.first(end + 1);
  std::vector<Attempt> attempts;
  for (const bool skips_fronts : {false, true}) {
    for (std::size_t i = 0; i < notation_names.size(); ++i) {
      attempts.emplace_back(Reading{static_cast<Notation>(i), skips_fronts}, begin);
    }
  }
  // The first of equally good ones: hex, without anything else in a line.
  const auto rank = [](const Attempt& a) {
    const TextError error = a.error.value_or(TextError{});
    return std::tuple(a.score, !a.error, error.line, error.column);
  };
  const auto best =
      std::max_element(attempts.begin(), attempts.end(),
                       [&](const Attempt& a, const Attempt& b) { return rank(a) < rank(b); });
  ReadingChoice choice{
      best->reading, best->error, {}, !best->score.is_none(), !best->bytes.empty()};
  if (best->error) return choice;
  const auto other = std::find_if(attempts.begin(), attempts.end(), [&](const Attempt& a) {
    return !a.error && a.score == best->score && a.bytes != best->bytes;
  });
  if (other != attempts.end()) choice.other = other->reading;
  return choice;
}

namespace {

/// Appends the frame at the beginning of `bytes` and returns its size; 0 if there is none.
std::size_t take_frame(std::span<const std::uint8_t> bytes, std::uint64_t offset,
                       std::vector<BareFrame>& out) {
  std::size_t taken = 0;
  for (const Framing framing : framings) {
    std::array<std::uint8_t, max_frame_size> whole{};
    const std::size_t rest = std::min(bytes.size(), whole.size() - 1);
    whole[0] = with_framing(framing, [](auto f) { return FramingFacts<f()>::start; });
    std::copy_n(bytes.begin(), rest, whole.begin() + 1);
    const Candidate found = AllFrameFormats::inspect(whole.data(), rest + 1);
    if (rest + 1 < frame_header_size || found.verdict == Verdict::bad_header) return 0;
    const std::size_t size = whole[frame_size_offset];
    const std::size_t end = frame_header_size - 1 + size;
    const bool is_whole = found.verdict == Verdict::frame;
    const std::uint8_t id = whole[frame_id_offset];
    const bool is_known =
        has_command(Direction::to_board, id) || has_command(Direction::from_board, id);
    if (end > bytes.size() || !is_known) return 0;
    if (taken != 0 && !is_whole) continue;
    if (taken != 0) out.pop_back();
    out.push_back({{id, bytes.subspan(frame_header_size - 1, size), offset, framing}, is_whole});
    taken = is_whole ? found.size - 1 : end;
    if (is_whole) break;
  }
  return taken;
}

}  // namespace

std::vector<BareFrame> bare_frames(std::span<const std::uint8_t> bytes) {
  std::vector<BareFrame> result;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = take_frame(bytes.subspan(at), at, result);
    if (size == 0) return {};
    at += size;
  }
  return result;
}

std::string what_is_missing(const BareFrame& bare) {
  return bare.has_checksum ? "without its start byte"
                           : "without its start byte and the checksum behind its body";
}

}  // namespace sbgc::tools
