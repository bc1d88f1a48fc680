/// Between the library's time and the steady clock's.
#pragma once

#include <chrono>

#include <sbgc/time.hpp>

namespace sbgc::detail {

inline Duration to_duration(std::chrono::microseconds duration) noexcept {
  return {duration.count()};
}

inline Instant now() noexcept {
  const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration_cast<std::chrono::microseconds>(since_start).count()};
}

/// Never is far away, but a moment that can be reckoned with.
inline std::chrono::steady_clock::time_point to_time_point(Instant at) noexcept {
  const Instant horizon = now() + seconds(1'000'000);
  return std::chrono::steady_clock::time_point(std::chrono::microseconds(earlier(at, horizon).us));
}

}  // namespace sbgc::detail
