/// Comparing what was written with what is read back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sbgc::detail {

/// The first byte from which on two blocks differ; nothing if they are equal.
inline std::optional<std::size_t> difference(std::span<const std::uint8_t> a,
                                             std::span<const std::uint8_t> b) {
  const auto [at, other] = std::ranges::mismatch(a, b);
  if (at == a.end() && other == b.end()) return std::nullopt;
  return static_cast<std::size_t>(at - a.begin());
}

}  // namespace sbgc::detail
