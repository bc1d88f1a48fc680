/// Powers without <cmath>, in constant expressions as well.
#pragma once

#include <cstdint>

namespace sbgc::detail {

/// Returns base^exponent.
constexpr double power(double base, std::int64_t exponent) noexcept {
  double result = 1;
  double square = exponent < 0 ? 1 / base : base;
  for (std::int64_t rest = exponent < 0 ? -exponent : exponent; rest != 0; rest /= 2) {
    if (rest % 2 != 0) result *= square;
    if (rest > 1) square *= square;
  }
  return result;
}

/// Returns the exponent of 16 bits or less whose power of `base` (above 1) is nearest to a value,
/// or one out of this range if there is none. No quantity grows beyond 1e9.
constexpr std::int64_t nearest_exponent(double base, double value) noexcept {
  constexpr std::int64_t beyond = 0x10000;
  if (!(value > 1e-100)) return -beyond;
  if (value > 1e100) return beyond;
  // Doubling finds limits without powers that overflow.
  std::int64_t low = -1;
  std::int64_t high = 1;
  while (low > -beyond && power(base, low) > value) low *= 2;
  while (high < beyond && power(base, high) <= value) high *= 2;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (power(base, middle) <= value ? low : high) = middle;
  }
  return value - power(base, low) < power(base, high) - value ? low : high;
}

}  // namespace sbgc::detail
