/// Reasons why bytes outside of frames are not frames.
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
  std::uint64_t offset{};    ///< in the examined bytes
  Verdict verdict{};         ///< incomplete, bad_header or bad_body
  bool has_header{};         ///< probably intended as a frame: its header is, or was, valid
  bool is_changed{};         ///< a driver has probably changed its header
  std::size_t size{};        ///< the size of the frame, if it has a header
  std::size_t wrong{};       ///< offset from its start byte: the contradictory bytes
  std::size_t wrong_size{};  ///< 0 if bytes are missing
  std::string text{};        ///< the reason, such as "a start byte, but no command has the id 0"
};

/// The number of bytes after a start byte that the reason can depend on.
inline constexpr std::size_t rejection_reach = max_frame_size + frame_header_size;

/// Returns at most `limit` start bytes among the first `gap` bytes of `bytes`, and the reasons why
/// they do not begin a frame. The bytes after the gap may belong to a truncated frame that begins
/// in it. Without `direction`, either side may have sent them.
std::vector<RejectedCandidate> rejected_candidates(std::span<const std::uint8_t> bytes,
                                                   std::size_t gap, std::size_t limit,
                                                   std::optional<Direction> direction);

/// Finds the rejected candidates of a stream that arrives in pieces, gap by gap. Stores the
/// unexamined bytes and a few candidates.
class GapExplainer {
 public:
  explicit GapExplainer(std::optional<Direction> direction = std::nullopt)
      : direction_(direction) {}

  /// Adds the next bytes of the stream.
  void add(std::span<const std::uint8_t> bytes);
  /// Reports that the next frame does not begin before `offset`.
  void advance(std::uint64_t offset);
  /// Ends the gap at `end`; the next one begins at `next`. Returns the candidates worth reporting.
  std::vector<RejectedCandidate> end_gap(std::uint64_t end, std::uint64_t next);

 private:
  void scan(std::uint64_t end);

  std::optional<Direction> direction_;
  std::vector<std::uint8_t> bytes_{};  // from the stream; begins used_ bytes before scanned_
  std::size_t used_ = 0;               // bytes of bytes_ before scanned_
  std::uint64_t scanned_ = 0;          // all bytes before it are examined, or in a frame
  std::vector<RejectedCandidate> found_{};
};

}  // namespace sbgc::tools
