/// Random numbers that depend only on a seed and a counter.
#pragma once

#include <cstdint>

namespace sbgc::emulator {

/// Returns 64 random bits for each pair of numbers (the finalizer of SplitMix64).
constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter) noexcept {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL + (counter + 1) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

/// Returns a number with 0 <= x < 1.
constexpr double random_share(std::uint64_t seed, std::uint64_t counter) noexcept {
  return static_cast<double>(random_bits(seed, counter) >> 11U) * 0x1.0p-53;
}

/// Returns a number with mean 0, standard deviation 1 and magnitude at most 3.5: the sum of four
/// uniform distributions, which approximates a normal one.
constexpr double random_normal(std::uint64_t seed, std::uint64_t counter) noexcept {
  const std::uint64_t bits = random_bits(seed, counter);
  const std::uint64_t sum =
      (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
  // Four times 16 bits: the mean is 2 * 65535, the deviation sqrt((65536^2 - 1) / 3).
  return (static_cast<double>(sum) - 131070.0) / 37837.2;
}

}  // namespace sbgc::emulator
