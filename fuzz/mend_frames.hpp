// Repairs the checksums of apparent frames in a fuzzer's input, so that mutations reach the code
// after the checks. Inputs contain frames among other bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/frame.hpp>

namespace sbgc::fuzz {

/// Gives each start byte that is followed by a complete frame valid checksums. Returns the number
/// of frames.
inline std::size_t mend_frames(std::span<std::uint8_t> input) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < input.size(); ++at) {
    const auto rest = input.subspan(at);
    for (const Framing framing : framings) {
      const auto start = with_framing(framing, [](auto f) { return FramingFacts<f()>::start; });
      if (rest[0] != start || rest.size() < frame_header_size || rest[1] == 0) continue;
      const std::size_t size = rest[2];
      if (rest.size() < frame_size(framing, size)) continue;
      // The body is in place.
      at += write_frame(framing, rest[1], rest.subspan(frame_header_size, size), rest).size - 1;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace sbgc::fuzz
