/// The values of live data in readable form.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/types.hpp>

namespace sbgc::tools {

/// One value of each axis: roll, pitch, yaw.
using PerAxis = Axes<double>;

/// The values of one message of live data, in their units. NaN means that the message lacks it.
struct LiveValues {
  PerAxis angle{};        ///< of the camera, in degrees
  PerAxis target{};       ///< in degrees
  PerAxis frame_angle{};  ///< in degrees
  PerAxis joint{};        ///< in degrees
  PerAxis balance{};      ///< motor power lost to imbalance, in percent
  PerAxis power{};        ///< of the motors, 0 to 1
  PerAxis rate{};         ///< of the gyroscope, in deg/s
  PerAxis vibration{};    ///< in the last seconds, see vibration_of(), in deg/s
  double slowest_vibration{}, fastest_vibration{};  ///< its frequencies, in hertz
  double battery{};                                 ///< in volts
  double current{};                                 ///< in milliamperes
  double temperature{};                             ///< of the main IMU, in degrees Celsius
  double cycle_us{};
  unsigned profile{};  ///< from 1
  unsigned i2c_errors{};
  unsigned serial_errors{};
  bool motors_on{};
  std::vector<const ValueInfo*> errors{};
  std::string sub_error{};  ///< the reason of an emergency stop, or ""
  std::string task{};       ///< a calibration that is running, or ""
};

/// The message that the values come from.
using LiveMessage = std::variant<msg::RealtimeData3, msg::RealtimeData4>;

LiveValues values_of(const msg::RealtimeData3& message);
LiveValues values_of(const msg::RealtimeData4& message);

}  // namespace sbgc::tools
