/// Why bytes that lie in no frame are none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sbgc/framing.hpp>

namespace sbgc::tools {

/// A start byte that begins no frame.
struct NearMiss {
  std::size_t offset{};  ///< in the bytes that were looked at
  Verdict verdict{};     ///< incomplete, bad_header or bad_body
  std::string text{};    ///< the reason, such as "a start byte, but no command has the id 0"
};

/// The first start bytes in `bytes`, at most `limit`, and why they begin no frame. `rest` is what
/// follows, as far as it is known: a frame that was cut off may have claimed it.
std::vector<NearMiss> near_misses(std::span<const std::uint8_t> bytes,
                                  std::span<const std::uint8_t> rest, std::size_t limit);

}  // namespace sbgc::tools
