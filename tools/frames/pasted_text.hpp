/// Parses bytes from pasted text: hex text, lists of numbers, dumps, string literals, logs with
/// times and senders, logs of programs; also without the start bytes of frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/frame.hpp>

#include "frames/hex_text.hpp"
#include "frames/program_logs.hpp"
#include "frames/text_lines.hpp"

namespace sbgc::tools {

/// The notation of bytes.
enum class Notation : std::uint8_t {
  hex,
  decimal,
  dump,
  literals,
  braced,
  // Logs of programs.
  debug_tab,
  strace,
  socat,
  candump,
  table,
};

/// A way to read a text.
struct Reading {
  Notation notation{};
  /// Times, senders and names precede the bytes of a line, or comments and prose are between lines.
  bool skips_fronts = false;
};

/// For example "hex text after times or names".
std::string to_text(const Reading& reading);
/// For example "hex text, line 3 column 7: 'g' is not a hex digit".
std::string to_text(const Reading& reading, const TextError& error);

/// Reads a text in blocks.
class PastedText {
 public:
  explicit PastedText(Reading reading = {}) : reading_(reading) {}

  /// Appends the bytes of `text` to `out`, up to the first error. Must not be called after an
  /// error.
  [[nodiscard]] std::optional<TextError> feed(std::span<const std::uint8_t> text,
                                              std::vector<std::uint8_t>& out);
  /// Must be called at the end.
  [[nodiscard]] std::optional<TextError> finish(std::vector<std::uint8_t>& out);

  const Reading& reading() const { return reading_; }
  /// True if anything was skipped.
  bool has_fronts() const { return has_fronts_; }
  /// Returns the sender of the byte at `offset`, if the text names it. Offsets must not decrease.
  std::optional<Direction> sender(std::uint64_t offset);

 private:
  std::optional<TextError> read_line(std::string_view line, std::vector<std::uint8_t>& out);
  /// Records the sender of the bytes that begin with this line.
  void note_sender(std::optional<Direction> sender);
  std::optional<LineProblem> read_bytes(std::string_view line, std::vector<std::uint8_t>& out,
                                        std::optional<Direction>& sender);

  Reading reading_;
  HexDecoder hex_{};
  DumpLines dump_{};
  SocatLines socat_{};
  ByteTable table_{};
  std::string line_{};  // as far as it is known
  std::size_t lines_ = 0;
  std::uint64_t size_ = 0;  // bytes of complete lines
  bool has_fronts_ = false;
  bool is_begin_ = true;
  std::optional<Direction> sender_{};
  std::deque<std::pair<std::uint64_t, Direction>> senders_{};  // starting at these offsets
};

/// The most likely reading of a text.
struct ReadingChoice {
  Reading reading{};
  std::optional<TextError> problem{};  ///< the text cannot be read
  std::optional<Reading> other{};      ///< equally likely, with different bytes
  bool is_likely = false;              ///< it finds frames, or begins with a start byte
  bool has_bytes = false;
};

/// Selects the reading that finds most in the first part of a text: at least 4096 bytes, if
/// available.
ReadingChoice choose_reading(std::span<const std::uint8_t> begin);

/// A frame as stored by programs that remove the start byte, and perhaps the checksum after the
/// body.
struct BareFrame {
  Frame frame{};  ///< its offset is that of the id
  bool has_checksum{};
};

/// Returns the frames of known commands in the bytes; none if they contain anything else.
std::vector<BareFrame> bare_frames(std::span<const std::uint8_t> bytes);

/// Returns, for example, "without its start byte and the checksum behind the body".
std::string what_is_missing(const BareFrame& bare);

}  // namespace sbgc::tools
