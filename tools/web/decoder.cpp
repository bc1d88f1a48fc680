// The decoder of the reference site: provides `sbgc decode` to a page.
//
// Text is exchanged through memory: the page calls input() for a buffer, fills it, calls feed() or
// rejected_candidates(), and reads output(), which is JSON, one object per line:
//
//   {"frame": object printed by `sbgc decode --format jsonl`, "size": size of the frame in bytes,
//    "body": offset of the body in the frame,
//    "rows": [[path, raw, meaning, objection, offset, size], ...], "reason": of an error}
//   {"hex_error": {"line": 1, "column": 2, "reason": "..."}}
//   {"end": {"bytes": 7, "frames": 1, "skipped_bytes": 0, "header_errors": 0, ...}}
//
// Offsets of rows count from the start of the frame, offsets of frames from the start of the input.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/parser.hpp>
#include <sbgc/to_json.hpp>

#include "../decoded_frame.hpp"
#include "../hex_text.hpp"
#include "../rejected_candidates.hpp"

namespace sbgc::tools {

namespace {

void add_line(std::string& out, const Json& json) {
  out += json.dump(-1, ' ', false, Json::error_handler_t::replace);
  out += '\n';
}

Json rows_of(const DecodedFrame& decoded) {
  Json result = Json::array();
  for (const Row& row : decoded.rows) {
    result.push_back(
        {row.path, row.raw, row.meaning, row.objection, frame_header_size + row.offset, row.size});
  }
  return result;
}

/// Decodes one input, from its first byte to its end.
class Decoding {
 public:
  Decoding(std::optional<Direction> direction, bool hex) : direction_(direction), is_hex_(hex) {}

  void feed(std::span<const std::uint8_t> block, std::string& out) {
    bytes_.clear();
    if (failed_) return;
    std::optional<HexError> error;
    if (is_hex_) {
      error = hex_.feed(block, bytes_);
    } else {
      bytes_.assign(block.begin(), block.end());
    }
    size_ += bytes_.size();
    parser_.feed(bytes_, Sink{*this, out});
    if (error) fail(*error, out);
  }

  void finish(std::string& out) {
    bytes_.clear();
    if (is_hex_ && !failed_) {
      if (const auto error = hex_.finish()) fail(*error, out);
    }
    parser_.flush(Sink{*this, out});
    const ParserCounters counters = parser_.counters();
    Json line;
    line["end"] = {{"bytes", size_},
                   {"frames", counters.frames},
                   {"skipped_bytes", counters.skipped_bytes},
                   {"header_errors", counters.header_errors},
                   {"body_errors", counters.body_errors},
                   {"incomplete", counters.incomplete}};
    add_line(out, line);
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

  void take(const Frame& frame, std::string& out) {
    const DecodedFrame decoded = decoder_.decode(frame, direction_);
    Json line;
    line["frame"] = decoded.to_json();
    line["size"] = frame_size(frame.framing, frame.body.size());
    line["body"] = frame_header_size;
    line["checksum"] = frame_header_size + frame.body.size();
    line["rows"] = rows_of(decoded);
    if (!decoded.status) line["reason"] = text(decoded.status.code);
    add_line(out, line);
  }

  void fail(const HexError& error, std::string& out) {
    failed_ = true;
    Json line;
    line["hex_error"] = {{"line", error.line}, {"column", error.column}, {"reason", error.reason}};
    add_line(out, line);
  }

  std::optional<Direction> direction_;
  FrameDecoder decoder_;
  ParserOfAll parser_;
  HexDecoder hex_;
  std::vector<std::uint8_t> bytes_;
  std::uint64_t size_ = 0;
  bool is_hex_;
  bool failed_ = false;
};

/// The state of the functions below, which a page calls one at a time.
struct State {
  std::vector<std::uint8_t> input;
  std::string output;
  Decoding decoding{std::nullopt, false};
};

State& state() {
  static State result;
  return result;
}

}  // namespace
}  // namespace sbgc::tools

#if defined(__wasm__)
#define SBGC_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else  // for tools that only parse this file
#define SBGC_EXPORT(name) extern "C"
#endif

using sbgc::tools::state;

/// Returns a buffer for the next `size` bytes of input.
SBGC_EXPORT(input) std::uint8_t* sbgc_input(std::size_t size) {
  state().input.resize(size);
  return state().input.data();
}

/// Starts a new input. `from` is the sender: 0 unknown, 1 host, 2 board.
SBGC_EXPORT(start) void sbgc_start(int from, bool is_hex) {
  std::optional<sbgc::Direction> direction;
  if (from == 1) direction = sbgc::Direction::to_board;
  if (from == 2) direction = sbgc::Direction::from_board;
  state().decoding = {direction, is_hex};
}

/// Decodes the input as the next part of the capture. Outputs the frames that it completes.
SBGC_EXPORT(feed) void sbgc_feed() {
  state().output.clear();
  state().decoding.feed(state().input, state().output);
}

/// Ends the capture. Outputs the remaining lines.
SBGC_EXPORT(finish) void sbgc_finish() {
  state().output.clear();
  state().decoding.finish(state().output);
}

/// Treats the input as bytes outside of frames and the bytes after them. Outputs a JSON list of
/// [offset, reason] for at most `limit` start bytes among the first `gap` bytes.
SBGC_EXPORT(rejected_candidates) void sbgc_rejected_candidates(std::size_t gap, std::size_t limit) {
  const std::span<const std::uint8_t> input(state().input);
  sbgc::Json list = sbgc::Json::array();
  for (const auto& candidate :
       sbgc::tools::rejected_candidates(input, gap, limit, state().decoding.direction())) {
    list.push_back({candidate.offset, candidate.text});
  }
  state().output = list.dump();
}

/// The largest size of a frame in bytes.
SBGC_EXPORT(frame_limit) std::size_t sbgc_frame_limit() { return sbgc::max_frame_size; }

SBGC_EXPORT(output) const char* sbgc_output() { return state().output.data(); }
SBGC_EXPORT(output_size) std::size_t sbgc_output_size() { return state().output.size(); }

/// The bytes of the last feed(); those decoded from hex text, if it was hex text.
SBGC_EXPORT(bytes) const std::uint8_t* sbgc_bytes() { return state().decoding.bytes().data(); }
SBGC_EXPORT(bytes_size) std::size_t sbgc_bytes_size() { return state().decoding.bytes().size(); }
