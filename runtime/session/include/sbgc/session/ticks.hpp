/// The timers of a session.
#pragma once

#include <cstdint>
#include <limits>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// A time span in microseconds, up to 71 minutes. A timer is the remaining span: it ends at 0. So a
/// small microcontroller adds and compares 32 bits, and a timer never wraps however late it is
/// read.
using Ticks = std::uint32_t;

/// A timer that is not running.
inline constexpr Ticks never = std::numeric_limits<Ticks>::max();

/// The longest timeout of a response, and the longest of any other duration. The sum of one of each
/// fits with the time of two frames on the line.
inline constexpr Ticks longest_response = 3'600'000'000;
inline constexpr Ticks longest_other = 600'000'000;

/// Returns the span of a duration: 0 if it is negative, `longest` if it is longer.
SBGC_ALWAYS_INLINE constexpr Ticks ticks_of(Duration duration,
                                            Ticks longest = longest_other) noexcept {
  if (duration.us <= 0) return 0;
  return duration.us < std::int64_t{longest} ? static_cast<Ticks>(duration.us) : longest;
}

/// Returns the span of a number of milliseconds, at most longest_response.
SBGC_NOINLINE constexpr Ticks ticks_of_ms(std::uint32_t ms) noexcept {
  return ms < longest_response / 1000 ? ms * 1000 : longest_response;
}

constexpr Ticks shorter(Ticks a, Ticks b) noexcept { return b < a ? b : a; }
constexpr Ticks longer(Ticks a, Ticks b) noexcept { return a < b ? b : a; }

/// Lets time pass on a timer.
constexpr void pass(Ticks& left, Ticks elapsed) noexcept {
  if (left != never) left -= shorter(left, elapsed);
}

/// Returns the time from `from` to `to`: 0 if that is earlier, the longest span if it is too long.
SBGC_NOINLINE constexpr Ticks between(Instant from, Instant to) noexcept {
  if (to == Instant::never) return never;
  if (to.us <= from.us) return 0;
  const std::uint64_t span =
      static_cast<std::uint64_t>(to.us) - static_cast<std::uint64_t>(from.us);
  return span < never ? static_cast<Ticks>(span) : never - 1;
}

}  // namespace sbgc::detail
