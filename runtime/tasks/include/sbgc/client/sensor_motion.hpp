/// The motion of a sensor, as far as its own data show it.
#pragma once

#include <cstddef>
#include <optional>

#include <sbgc/client/task.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

/// The motion of a sensor, and the direction that points up.
struct SensorMotion {
  bool is_known = true;  ///< false for a frame whose sensor reports nothing
  double shaking{};      ///< largest deviation of the rate from its mean within a second, in deg/s
  double turning{};  ///< size of the mean rate, in deg/s: an even turn, or the gyroscope's offset
  /// The direction that points up, in the coordinates of the sensor and in g; empty if the firmware
  /// does not send it for this sensor.
  std::optional<Axes<double>> up{};
};

/// The angle between the upward direction and the nearest axis of the sensor, in degrees.
double angle_to_side(const Axes<double>& up);
/// The side of the sensor that points up: 0 to 5.
std::size_t side_of(const Axes<double>& up);

namespace tasks {

/// Observes the active sensor, or the frame's, for a second. Errors: those of Client::call().
Task<Result<SensorMotion>> watch_sensor(bool of_frame);

}  // namespace tasks
}  // namespace sbgc
