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

#include "frames/decoded_frame.hpp"
#include "frames/pasted_text.hpp"
#include "frames/rejected_candidates.hpp"
#include "modules/exchange.hpp"
#include "modules/json_writer.hpp"

namespace sbgc::tools {

namespace {

using web::JsonWriter;

/// Writes ["axes.roll.angle", ...] for each row.
void put_rows(JsonWriter& out, const Rows& rows) {
  out.list([&] {
    for (const Row& row : rows) {
      out.values(row.path.text(), rows.raw(row), rows.meaning(row), row.objection,
                 frame_header_size + row.offset, row.size);
    }
  });
}

/// Writes the name of the message and its rows, if there are any.
void put_message(JsonWriter& out, const DecodedFrame& decoded) {
  const bool is_known = decoded.message != nullptr && decoded.status;
  out.put(is_known ? decoded.message->name : "");
  put_rows(out, is_known ? decoded.rows : Rows());
}

/// Writes the rejected candidate of a frame with a wrong checksum: any row may be wrong.
void put_damaged(JsonWriter& out, std::span<const std::uint8_t> input,
                 const RejectedCandidate& candidate, std::optional<Direction> direction) {
  const auto from = input.subspan(static_cast<std::size_t>(candidate.offset));
  FrameDecoder decoder({.rows = true});
  DecodedFrame decoded;
  if (candidate.verdict == Verdict::bad_body && candidate.size <= from.size()) {
    const auto body = from.subspan(frame_header_size, candidate.wrong - frame_header_size);
    decoded = decoder.decode({from[frame_id_offset], body, 0, framing_of(from.data())}, direction);
  }
  out.list([&] {
    out.put(candidate.offset);
    out.put(candidate.text);
    out.values(candidate.wrong, candidate.wrong_size);
    put_message(out, decoded);
  });
}

/// Does the same for a frame without its start byte.
void put_bare(JsonWriter& out, const BareFrame& bare, std::optional<Direction> direction) {
  FrameDecoder decoder({.rows = true});
  const DecodedFrame decoded = decoder.decode(bare.frame, direction);
  out.list([&] {
    out.put(bare.frame.offset);
    out.put(std::string(decoded.command) + ' ' + what_is_missing(bare));
    out.values(0, 0);
    put_message(out, decoded);
  });
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
    JsonWriter line(out);
    line.object([&] {
      line.key("end").object([&] {
        line.member("reading", reading());
        line.member("bytes", size_);
        line.member("frames", counters.frames);
        line.member("skipped_bytes", counters.skipped_bytes);
        line.member("header_errors", counters.header_errors);
        line.member("body_errors", counters.body_errors);
        line.member("incomplete", counters.incomplete);
      });
    });
    line.end_line();
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
    JsonWriter line(out);
    line.object([&] {
      put_json(line.key("frame").value(), decoded);
      line.member("size", frame_size(frame.framing, frame.body.size()));
      line.member("body", frame_header_size);
      line.member("checksum", frame_header_size + frame.body.size());
      put_rows(line.key("rows"), decoded.rows);
      line.member("is_guess", decoded.is_guess);
      line.member("note", decoded.note);
      if (!decoded.status) line.member("reason", decoded.explanation);
    });
    line.end_line();
  }

  void fail(const TextError& error, std::string& out) {
    failed_ = true;
    JsonWriter line(out);
    line.object([&] {
      line.key("text_error").object([&] {
        line.member("reading", reading());
        line.member("line", error.line);
        line.member("column", error.column);
        line.member("reason", error.reason);
      });
    });
    line.end_line();
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
  const std::optional<sbgc::Direction> direction = decoding().direction();
  const auto bare = sbgc::tools::bare_frames(input.first(std::min(gap, input.size())));
  sbgc::web::JsonWriter out(exchange().output);
  out.list([&] {
    for (const auto& one : std::span(bare).first(std::min(limit, bare.size()))) {
      sbgc::tools::put_bare(out, one, direction);
    }
    if (!bare.empty()) limit = 0;
    for (const auto& one : sbgc::tools::rejected_candidates(input, gap, limit, direction)) {
      sbgc::tools::put_damaged(out, input, one, direction);
    }
  });
}

/// The largest size of a frame in bytes.
SBGC_EXPORT(frame_limit) std::size_t sbgc_frame_limit() { return sbgc::max_frame_size; }

/// The bytes of the last feed(); those that it stands for, if it was text.
SBGC_EXPORT(bytes) const std::uint8_t* sbgc_bytes() { return decoding().bytes().data(); }
SBGC_EXPORT(bytes_size) std::size_t sbgc_bytes_size() { return decoding().bytes().size(); }
