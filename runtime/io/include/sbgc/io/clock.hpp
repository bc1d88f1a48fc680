/// The clock of this machine, converted to the time types of the library.
#pragma once

#include <chrono>

#include <sbgc/time.hpp>

namespace sbgc::io {

/// The clock of all deadlines.
using Clock = std::chrono::steady_clock;

/// Returns the duration in the type of a session, rounded down.
constexpr Duration from_chrono(Clock::duration duration) noexcept {
  return {std::chrono::floor<std::chrono::microseconds>(duration).count()};
}

constexpr Instant from_chrono(Clock::time_point time) noexcept {
  return {from_chrono(time.time_since_epoch()).us};
}

/// Saturates to the range of the clock.
constexpr Clock::duration to_chrono(Duration duration) noexcept {
  using std::chrono::microseconds;
  constexpr Duration least = {std::chrono::ceil<microseconds>(Clock::duration::min()).count()};
  constexpr Duration most = {std::chrono::floor<microseconds>(Clock::duration::max()).count()};
  if (duration < least) return Clock::duration::min();
  if (duration > most) return Clock::duration::max();
  return std::chrono::duration_cast<Clock::duration>(microseconds(duration.us));
}

/// Instant::never becomes Clock::time_point::max().
constexpr Clock::time_point to_chrono(Instant time) noexcept {
  return Clock::time_point(to_chrono(Duration{time.us}));
}

/// Returns the time of the clock.
inline Instant now() noexcept { return from_chrono(Clock::now()); }

}  // namespace sbgc::io
