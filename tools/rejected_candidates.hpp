/// Why bytes outside of frames are not frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/framing.hpp>
#include <sbgc/message.hpp>

namespace sbgc::tools {

/// A start byte that does not begin a frame.
struct RejectedCandidate {
  std::uint64_t offset{};  ///< in the bytes that were looked at
  Verdict verdict{};       ///< incomplete, bad_header or bad_body
  bool has_header{};       ///< a good header is there: this was probably meant to be a frame
  std::string text{};      ///< the reason, such as "a start byte, but no command has the id 0"
};

/// The number of bytes after a start byte that can be part of the reason.
inline constexpr std::size_t rejection_reach = max_frame_size + frame_header_size;

/// The start bytes among the first `gap` bytes of `bytes`, at most `limit` of them, and why they do
/// not begin a frame. The remaining bytes are those after the gap, which a cut-off frame may have
/// claimed. Without `direction`, either side may have sent them.
std::vector<RejectedCandidate> rejected_candidates(std::span<const std::uint8_t> bytes,
                                                   std::size_t gap, std::size_t limit,
                                                   std::optional<Direction> direction);

/// Finds the rejected candidates of a stream that arrives in pieces, gap by gap. Keeps the bytes
/// that are not judged yet and a few candidates.
class GapExplainer {
 public:
  explicit GapExplainer(std::optional<Direction> direction = std::nullopt)
      : direction_(direction) {}

  /// Takes the next bytes of the stream.
  void add(std::span<const std::uint8_t> bytes);
  /// Says that the next frame does not begin before `offset`.
  void advance(std::uint64_t offset);
  /// Ends the gap at `end`; the next one begins at `next`. Returns the candidates worth reporting.
  std::vector<RejectedCandidate> end_gap(std::uint64_t end, std::uint64_t next);

 private:
  void scan(std::uint64_t end);

  std::optional<Direction> direction_;
  std::vector<std::uint8_t> bytes_{};  // of the stream, from scanned_ on
  std::size_t used_ = 0;               // of them, that are before scanned_
  std::uint64_t scanned_ = 0;          // everything before is in a frame, or looked at
  std::vector<RejectedCandidate> found_{};
};

}  // namespace sbgc::tools
