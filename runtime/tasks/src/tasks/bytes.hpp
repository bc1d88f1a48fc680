/// Comparison of written data with data read back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sbgc::detail {

/// Returns the index of the first different byte; nothing if the blocks are equal.
inline std::optional<std::size_t> difference(std::span<const std::uint8_t> a,
                                             std::span<const std::uint8_t> b) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (at == a.end() && other == b.end()) return std::nullopt;
  return static_cast<std::size_t>(at - a.begin());
}

}  // namespace sbgc::detail
