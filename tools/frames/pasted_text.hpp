/// Bytes as people post them: hex text, lists of numbers, dumps, strings of programs, logs with
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
  /// Times, senders and names come before the bytes of a line, or comments and prose are between
  /// them.
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
  /// True if there was such a front, a comment or prose.
  bool has_fronts() const { return has_fronts_; }
  /// Returns who sent the byte at `offset`, if the text says so. Offsets must not decrease.
  std::optional<Direction> sender(std::uint64_t offset);

 private:
  std::optional<TextError> read_line(std::string_view line, std::vector<std::uint8_t>& out);
  /// From the bytes of the line on.
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
  std::deque<std::pair<std::uint64_t, Direction>> senders_{};  // from these offsets on
};

/// The most likely reading of a text.
struct ReadingChoice {
  Reading reading{};
  std::optional<TextError> problem{};  ///< the text cannot be read
  std::optional<Reading> other{};      ///< as likely, with other bytes
  bool is_likely = false;              ///< it finds frames, or begins with a start byte
  bool has_bytes = false;
};

/// Chooses the reading that finds most in the first part of a text: 4096 bytes at least, if it has
/// them.
ReadingChoice choose_reading(std::span<const std::uint8_t> begin);

/// A frame as programs keep it that take off the start byte, and perhaps the checksum behind the
/// body.
struct BareFrame {
  Frame frame{};  ///< its offset is that of the id
  bool has_checksum{};
};

/// Returns the frames of known commands that the bytes are; none if they are anything else as well.
std::vector<BareFrame> bare_frames(std::span<const std::uint8_t> bytes);

/// "without its start byte and the checksum behind the body".
std::string what_is_missing(const BareFrame& bare);

}  // namespace sbgc::tools
