/// Constants shared by the parts of the simulation.
#pragma once

#include <cstdint>

namespace sbgc::emulator {

/// The step of the simulation.
inline constexpr std::int64_t step_us = 4000;
inline constexpr double step_seconds = 0.004;
inline constexpr std::int64_t steps_per_second = 250;

/// The maximum speed of an axis, deg/s. Assumption: the range of the gyroscope, 16 bits of its
/// unit.
inline constexpr double top_speed = 2000;
/// The limit of angle arguments, degrees.
inline constexpr double top_angle = 1e6;

/// Clamps `value` to [low, high]; NaN counts as 0.
constexpr double within(double value, double low, double high) noexcept {
  if (!(value == value)) value = 0;  // NOLINT(misc-redundant-expression): NaN
  return value < low ? low : value > high ? high : value;
}

}  // namespace sbgc::emulator
