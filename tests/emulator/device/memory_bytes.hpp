/// Contents of the emulated board's memory, for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sbgc::test {

/// The page size of the specification.
inline constexpr std::size_t page = 64;

/// Returns `size` bytes, each different from its neighbors.
inline std::vector<std::uint8_t> numbered(std::size_t size, unsigned start = 1) {
  std::vector<std::uint8_t> result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<std::uint8_t>(start + i * 7);
  return result;
}

}  // namespace sbgc::test
