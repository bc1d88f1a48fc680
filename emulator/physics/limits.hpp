/// Numbers that the parts of the simulation share.
#pragma once

#include <cstdint>

namespace sbgc::emulator {

/// The simulation's step.
inline constexpr std::int64_t step_us = 4000;
inline constexpr double step_seconds = 0.004;
inline constexpr std::int64_t steps_per_second = 250;

/// No axis turns faster, deg/s. Assumption: the range of the gyroscope, 16 bits of its unit.
inline constexpr double top_speed = 2000;
/// Limit of angles in arguments, degrees.
inline constexpr double top_angle = 1e6;

/// `value` within [low, high]; 0, or the nearest limit to it, for NaN.
constexpr double within(double value, double low, double high) noexcept {
  if (!(value == value)) value = 0;  // NOLINT(misc-redundant-expression): NaN
  return value < low ? low : value > high ? high : value;
}

}  // namespace sbgc::emulator
