// The decoder of the reference site: provides `sbgc decode` to a page.
//
// feed() and rejected_candidates() read the input of exchange.hpp. The output of feed() is JSON,
// one object per line:
//
//   {"frame": object printed by `sbgc decode --format jsonl`, "size": size of the frame in bytes,
//    "body": offset of the body in the frame,
//    "rows": [[path, raw, meaning, objection, offset, size], ...], "is_guess": of the direction,
//    "note": "...", "reason": of an error}
//   {"text_error": {"reading": "hex text", "line": 1, "column": 2, "reason": "..."}}
//   {"end": {"reading": "hex text", "bytes": 7, "frames": 1, "skipped_bytes": 0, "header_errors":
//   0, ...}}
//
// Offsets of rows count from the start of the frame, offsets of frames from the start of the input.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/parser.hpp>
#include <sbgc/text_output.hpp>

#include "frames/decoded_frame.hpp"
#include "frames/json_string.hpp"
#include "frames/pasted_text.hpp"
#include "frames/rejected_candidates.hpp"
#include "modules/exchange.hpp"

namespace sbgc::tools {

namespace {

/// Writes ["axes.roll.angle", ...] for each row.
void put_rows(TextOutput& out, const Rows& rows) {
  char separator = '[';
  for (const Row& row : rows) {
    out.put(separator);
    separator = ',';
    char start = '[';
    for (const std::string_view text :
         {row.path.text(), rows.raw(row), rows.meaning(row), std::string_view(row.objection)}) {
      out.put(start);
      start = ',';
      put_json_string(out, text);
    }
    out.put(',');
    out.put(frame_header_size + row.offset);
    out.put(',');
    out.put(row.size);
    out.put(']');
  }
  out.put(rows.empty() ? "[]" : "]");
}

/// Writes the message of a frame whose checksum is wrong, and its rows: any of them may be.
void put_damaged(TextOutput& out, std::span<const std::uint8_t> input,
                 const RejectedCandidate& candidate, std::optional<Direction> direction) {
  const auto from = input.subspan(static_cast<std::size_t>(candidate.offset));
  FrameDecoder decoder({.rows = true});
  DecodedFrame decoded;
  if (candidate.verdict == Verdict::bad_body && candidate.size <= from.size()) {
    const auto body = from.subspan(frame_header_size, candidate.wrong - frame_header_size);
    decoded = decoder.decode({from[frame_id_offset], body, 0, framing_of(from.data())}, direction);
  }
  const bool is_known = decoded.message != nullptr && decoded.status;
  put_json_string(out, is_known ? decoded.message->name : "");
  out.put(',');
  put_rows(out, is_known ? decoded.rows : Rows());
}

/// Writes what sbgc_rejected_candidates() says of a frame without its start byte.
void put_bare(TextOutput& out, const BareFrame& bare, std::optional<Direction> direction) {
  FrameDecoder decoder({.rows = true});
  const DecodedFrame decoded = decoder.decode(bare.frame, direction);
  const bool is_known = decoded.message != nullptr && decoded.status;
  out.put(bare.frame.offset);
  out.put(',');
  put_json_string(out, std::string(decoded.command) + ' ' + what_is_missing(bare));
  out.put(",[0,0],");
  put_json_string(out, is_known ? decoded.message->name : "");
  out.put(',');
  put_rows(out, is_known ? decoded.rows : Rows());
}

/// Decodes one input, from its first byte to its end.
class Decoding {
 public:
  Decoding(std::optional<Direction> direction, bool is_text)
      : direction_(direction), is_text_(is_text) {}

  void feed(std::span<const std::uint8_t> block, std::string& out) {
    bytes_.clear();
    if (failed_) return;
    std::optional<TextError> error;
    if (is_text_ && !text_) error = choose(block);
    if (text_ && !error) {
      error = text_->feed(block, bytes_);
    } else if (!is_text_) {
      bytes_.assign(block.begin(), block.end());
    }
    size_ += bytes_.size();
    parser_.feed(bytes_, Sink{*this, out});
    if (error) fail(*error, out);
  }

  void finish(std::string& out) {
    bytes_.clear();
    if (text_ && !failed_) {
      const auto error = text_->finish(bytes_);
      size_ += bytes_.size();
      parser_.feed(bytes_, Sink{*this, out});
      if (error) fail(*error, out);
    }
    parser_.flush(Sink{*this, out});
    const ParserCounters counters = parser_.counters();
    StringOutput line(out);
    const auto put = [&](const char* name, std::uint64_t value) {
      line.put(name);
      line.put(value);
    };
    line.put(R"({"end":{"reading":)");
    put_json_string(line, reading());
    put(",\"bytes\":", size_);
    put(",\"frames\":", counters.frames);
    put(",\"skipped_bytes\":", counters.skipped_bytes);
    put(",\"header_errors\":", counters.header_errors);
    put(",\"body_errors\":", counters.body_errors);
    put(",\"incomplete\":", counters.incomplete);
    line.put("}}\n");
    line.finish();
  }

  std::optional<Direction> direction() const { return direction_; }

  /// The bytes of the last block.
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  struct Sink {
    Decoding& decoding;
    std::string& out;
    void operator()(const Frame& frame) const { decoding.take(frame, out); }
  };

  /// Chooses how to read the text from its first part.
  std::optional<TextError> choose(std::span<const std::uint8_t> begin) {
    const ReadingChoice choice = choose_reading(begin);
    text_.emplace(choice.reading);
    if (!choice.other) return {};
    return TextError{1, 1, "it can also be " + to_text(*choice.other) + ", with other bytes"};
  }

  std::string reading() const { return text_ ? to_text(text_->reading()) : "raw bytes"; }

  void take(const Frame& frame, std::string& out) {
    const bool is_told = direction_.has_value() || !text_;
    const DecodedFrame decoded =
        decoder_.decode(frame, is_told ? direction_ : text_->sender(frame.offset));
    StringOutput line(out);
    line.put("{\"frame\":");
    put_json(line, decoded);
    line.put(",\"size\":");
    line.put(frame_size(frame.framing, frame.body.size()));
    line.put(",\"body\":");
    line.put(frame_header_size);
    line.put(",\"checksum\":");
    line.put(frame_header_size + frame.body.size());
    line.put(",\"rows\":");
    put_rows(line, decoded.rows);
    line.put(decoded.is_guess ? R"(,"is_guess":true,"note":)" : R"(,"is_guess":false,"note":)");
    put_json_string(line, decoded.note);
    if (!decoded.status) {
      line.put(",\"reason\":");
      put_json_string(line, decoded.explanation);
    }
    line.put("}\n");
    line.finish();
  }

  void fail(const TextError& error, std::string& out) {
    failed_ = true;
    StringOutput line(out);
    line.put(R"({"text_error":{"reading":)");
    put_json_string(line, reading());
    line.put(",\"line\":");
    line.put(error.line);
    line.put(",\"column\":");
    line.put(error.column);
    line.put(",\"reason\":");
    put_json_string(line, error.reason);
    line.put("}}\n");
    line.finish();
  }

  std::optional<Direction> direction_;
  FrameDecoder decoder_{{.json = true, .rows = true}};
  ParserOfAll parser_;
  std::optional<PastedText> text_{};
  std::vector<std::uint8_t> bytes_;
  std::uint64_t size_ = 0;
  bool is_text_;
  bool failed_ = false;
};

/// The capture that the functions below decode.
Decoding& decoding() {
  static Decoding result(std::nullopt, false);
  return result;
}

}  // namespace
}  // namespace sbgc::tools

using sbgc::tools::decoding;
using sbgc::tools::exchange;

/// Starts a new input. `from` is the sender: 0 unknown, 1 host, 2 board.
SBGC_EXPORT(start) void sbgc_start(int from, bool is_text) {
  std::optional<sbgc::Direction> direction;
  if (from == 1) direction = sbgc::Direction::to_board;
  if (from == 2) direction = sbgc::Direction::from_board;
  decoding() = {direction, is_text};
}

/// Decodes the input as the next part of the capture. Outputs the frames that it completes.
SBGC_EXPORT(feed) void sbgc_feed() {
  exchange().output.clear();
  decoding().feed(exchange().input, exchange().output);
}

/// Ends the capture. Outputs the remaining lines.
SBGC_EXPORT(finish) void sbgc_finish() {
  exchange().output.clear();
  decoding().finish(exchange().output);
}

/// Treats the input as bytes outside of frames and the bytes after them. Outputs a JSON list of
/// [offset, reason, [wrong, wrong size], message, rows] for at most `limit` start bytes among the
/// first `gap` bytes, or for the frames without start bytes that these are. The rows are those of a
/// damaged frame as it came; its message is "" if there are none.
SBGC_EXPORT(rejected_candidates) void sbgc_rejected_candidates(std::size_t gap, std::size_t limit) {
  const std::span<const std::uint8_t> input(exchange().input);
  exchange().output.clear();
  sbgc::StringOutput list(exchange().output);
  char separator = '[';
  const auto bare = sbgc::tools::bare_frames(input.first(std::min(gap, input.size())));
  for (const auto& one : std::span(bare).first(std::min(limit, bare.size()))) {
    list.put(separator);
    separator = ',';
    list.put('[');
    sbgc::tools::put_bare(list, one, decoding().direction());
    list.put(']');
  }
  if (!bare.empty()) limit = 0;
  for (const auto& candidate :
       sbgc::tools::rejected_candidates(input, gap, limit, decoding().direction())) {
    list.put(separator);
    separator = ',';
    list.put('[');
    list.put(candidate.offset);
    list.put(',');
    sbgc::tools::put_json_string(list, candidate.text);
    list.put(",[");
    list.put(candidate.wrong);
    list.put(',');
    list.put(candidate.wrong_size);
    list.put("],");
    sbgc::tools::put_damaged(list, input, candidate, decoding().direction());
    list.put(']');
  }
  list.put(separator == '[' ? "[]" : "]");
  list.finish();
}

/// The largest size of a frame in bytes.
SBGC_EXPORT(frame_limit) std::size_t sbgc_frame_limit() { return sbgc::max_frame_size; }

/// The bytes of the last feed(); those that it stands for, if it was text.
SBGC_EXPORT(bytes) const std::uint8_t* sbgc_bytes() { return decoding().bytes().data(); }
SBGC_EXPORT(bytes_size) std::size_t sbgc_bytes_size() { return decoding().bytes().size(); }
