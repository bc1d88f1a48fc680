/// Conversion of simulated values to quantities on the wire.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/quantity.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc::emulator {

/// Converts a value that may exceed the range of its type, such as the speed of a pushed camera.
/// Saturates like a sensor; NaN becomes 0.
template <class Q>
Q saturated(double value) {
  if (const auto quantity = Q::from_real(value)) return *quantity;
  using Raw = typename Q::raw_type;
  if (std::isnan(value)) return Q(Raw{});
  return Q(value < 0 ? std::numeric_limits<Raw>::lowest() : std::numeric_limits<Raw>::max());
}

/// The same for each of several values, times a factor.
template <class Q, template <class> class Each>
Each<Q> saturated(const Each<double>& values, double factor = 1) {
  Each<Q> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = saturated<Q>(factor * values[i]);
  return result;
}

/// The same for plain integers.
template <std::integral Raw>
Raw saturated_raw(double value) {
  constexpr auto lowest = static_cast<double>(std::numeric_limits<Raw>::lowest());
  constexpr auto highest = static_cast<double>(std::numeric_limits<Raw>::max());
  if (std::isnan(value)) return 0;
  if (value <= lowest) return std::numeric_limits<Raw>::lowest();
  if (value >= highest) return std::numeric_limits<Raw>::max();
  return static_cast<Raw>(std::lround(value));
}

/// The angle difference at which angles are equal on the wire, in degrees: four turns.
inline constexpr double angle_period = [] {
  using Counts = std::numeric_limits<msg::Angle14::raw_type>;
  return msg::Angle14(Counts::max()).degrees() - msg::Angle14(Counts::lowest()).degrees() +
         msg::Angle14(1).degrees();
}();

/// Converts an angle, which wraps on overflow of the raw value, after two turns in each direction.
inline msg::Angle14 wire_angle(double degrees) {
  const auto angle = msg::LongAngle14::from_degrees(std::remainder(degrees, angle_period));
  const msg::Angle14 result(static_cast<std::int16_t>(angle.value_or(msg::LongAngle14{}).raw()));
  return result;
}
inline Axes<msg::Angle14> wire_angles(const Axes<double>& degrees) {
  return {wire_angle(degrees.roll), wire_angle(degrees.pitch), wire_angle(degrees.yaw)};
}

}  // namespace sbgc::emulator
