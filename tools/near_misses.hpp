/// Why bytes that lie in no frame are none.
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

/// A start byte that begins no frame.
struct NearMiss {
  std::uint64_t offset{};  ///< in the bytes that were looked at
  Verdict verdict{};       ///< incomplete, bad_header or bad_body
  bool has_header{};       ///< a good header is there: this was probably meant to be a frame
  std::string text{};      ///< the reason, such as "a start byte, but no command has the id 0"
};

/// So many bytes behind a start byte have a part in its reason.
inline constexpr std::size_t near_miss_reach = max_frame_size + frame_header_size;

/// The first start bytes among the first `gap` bytes of `bytes`, at most `limit`, and why they
/// begin no frame. The rest is what follows, as far as it is known: a frame that was cut off may
/// have claimed it. Without `direction`, anybody may have sent them.
std::vector<NearMiss> near_misses(std::span<const std::uint8_t> bytes, std::size_t gap,
                                  std::size_t limit, std::optional<Direction> direction);

/// Finds the near misses of a stream that arrives in pieces, gap by gap. Keeps what is not judged
/// yet, and no more than a few of the misses.
class GapExplainer {
 public:
  explicit GapExplainer(std::optional<Direction> direction = std::nullopt)
      : direction_(direction) {}

  /// Takes the next bytes of the stream.
  void add(std::span<const std::uint8_t> bytes);
  /// Says that the next frame does not begin before `offset`.
  void advance(std::uint64_t offset);
  /// Ends the gap at `end`; the next one begins at `next`. Returns what is worth telling about it.
  std::vector<NearMiss> end_gap(std::uint64_t end, std::uint64_t next);

 private:
  void scan(std::uint64_t end);

  std::optional<Direction> direction_;
  std::vector<std::uint8_t> bytes_{};  // of the stream, from scanned_ on
  std::size_t used_ = 0;               // of them, that are before scanned_
  std::uint64_t scanned_ = 0;          // everything before is in a frame, or looked at
  std::vector<NearMiss> found_{};
};

}  // namespace sbgc::tools
