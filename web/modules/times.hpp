/// Times of pages: microseconds as numbers of JavaScript.
#pragma once

#include <cstdint>
#include <limits>

#include <sbgc/time.hpp>

namespace sbgc::web {

inline Instant at(double us) { return {static_cast<std::int64_t>(us)}; }

/// Infinity for Instant::never.
inline double in_us(Instant time) {
  if (time == Instant::never) return std::numeric_limits<double>::infinity();
  return static_cast<double>(time.us);
}

}  // namespace sbgc::web
