/// Points in time and durations, passed in by the caller: the library has no clock. (<chrono> is
/// not freestanding.)
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include <sbgc/internal/compiler.hpp>

namespace sbgc {

namespace detail {

/// Returns a + b, saturated to the range of the type.
constexpr std::int64_t add_saturating(std::int64_t a, std::int64_t b) noexcept {
  std::int64_t sum = 0;
  if (!add_overflows(a, b, sum)) return sum;
  return b < 0 ? std::numeric_limits<std::int64_t>::min()
               : std::numeric_limits<std::int64_t>::max();
}

/// Returns a - b, saturated to the range of the type.
constexpr std::int64_t subtract_saturating(std::int64_t a, std::int64_t b) noexcept {
  std::int64_t difference = 0;
  if (!subtract_overflows(a, b, difference)) return difference;
  return b < 0 ? std::numeric_limits<std::int64_t>::max()
               : std::numeric_limits<std::int64_t>::min();
}

}  // namespace detail

/// A duration in microseconds. Arithmetic saturates; it never wraps.
struct Duration {
  std::int64_t us{};  ///< microseconds

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  constexpr auto operator<=>(const Duration&) const = default;

  friend constexpr Duration operator+(Duration a, Duration b) noexcept {
    return {detail::add_saturating(a.us, b.us)};
  }
  friend constexpr Duration operator-(Duration a, Duration b) noexcept {
    return {detail::subtract_saturating(a.us, b.us)};
  }
  friend constexpr Duration operator*(Duration a, std::int32_t n) noexcept {
    std::int64_t product = 0;
    if (!detail::multiply_overflows(a.us, std::int64_t{n}, product)) return {product};
    return {(a.us < 0) == (n < 0) ? std::numeric_limits<std::int64_t>::max()
                                  : std::numeric_limits<std::int64_t>::min()};
  }
};

/// Returns `n` microseconds.
constexpr Duration microseconds(std::int64_t n) noexcept { return {n}; }
/// Returns `n` milliseconds.
constexpr Duration milliseconds(std::int64_t n) noexcept { return {n * 1000}; }
/// Returns `n` seconds.
constexpr Duration seconds(std::int64_t n) noexcept { return {n * 1'000'000}; }

/// A point in time: microseconds since an arbitrary epoch, the same for all calls of one object.
struct Instant {
  std::int64_t us{};  ///< since an epoch that the owner chooses, in microseconds

  /// Later than any reachable point in time.
  static const Instant never;

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  constexpr auto operator<=>(const Instant&) const = default;

  friend constexpr Instant operator+(Instant at, Duration by) noexcept {
    return {detail::add_saturating(at.us, by.us)};
  }
  friend constexpr Instant operator-(Instant at, Duration by) noexcept {
    return {detail::subtract_saturating(at.us, by.us)};
  }
  friend constexpr Duration operator-(Instant a, Instant b) noexcept {
    return {detail::subtract_saturating(a.us, b.us)};
  }
};

inline constexpr Instant Instant::never{std::numeric_limits<std::int64_t>::max()};

/// Returns the earlier of two instants.
constexpr Instant earlier(Instant a, Instant b) noexcept { return b < a ? b : a; }
/// Returns the later of two instants.
constexpr Instant later(Instant a, Instant b) noexcept { return a < b ? b : a; }

}  // namespace sbgc
