/// Numbers packed into some bits of an integer, with or without a sign.
#pragma once

#include <cstdint>

namespace sbgc::detail {

/// The position of the number. `sign` is a bit that makes it negative, or 0.
struct PartBits {
  std::uint64_t mask{};
  unsigned shift{};
  std::uint64_t sign{};
  bool is_signed{};  ///< two's complement
};

constexpr std::int64_t part_number(std::uint64_t raw, const PartBits& part) noexcept {
  const std::uint64_t most = part.mask >> part.shift;
  const std::uint64_t bits = (raw & part.mask) >> part.shift;
  if (part.is_signed && bits > most / 2) {
    return static_cast<std::int64_t>(bits) - static_cast<std::int64_t>(most) - 1;
  }
  const auto number = static_cast<std::int64_t>(bits);
  return (raw & part.sign) != 0 ? -number : number;
}

/// Returns false and changes nothing if the number does not fit.
template <class Raw>
constexpr bool set_part_number(Raw& raw, std::int64_t number, const PartBits& part) noexcept {
  const auto most = static_cast<std::int64_t>(part.mask >> part.shift);
  const std::int64_t highest = part.is_signed ? most / 2 : most;
  const std::int64_t lowest = part.is_signed ? -highest - 1 : part.sign != 0 ? -most : 0;
  if (number < lowest || number > highest) return false;
  const bool is_below = part.sign != 0 && number < 0;
  const auto bits = static_cast<std::uint64_t>(is_below ? -number : number);
  const std::uint64_t others = raw & ~(part.mask | part.sign);
  raw = static_cast<Raw>(others | ((bits << part.shift) & part.mask) | (is_below ? part.sign : 0));
  return true;
}

}  // namespace sbgc::detail
