/// The calibrations that users can start, by name.
#pragma once

#include <vector>

#include <sbgc/meta.hpp>

namespace sbgc {

/// A request that starts a calibration.
struct CalibrationForm {
  const MessageInfo* info{};  ///< of the request
  bool has_action{};          ///< it has an action and an IMU
};

/// The conditions of a calibration, as far as live data show them. MessageInfo::preparation
/// describes all of them in words.
struct CalibrationConditions {
  bool motors_off{};       ///< the motors must be off
  bool still{};            ///< the sensor must not move
  bool one_side_up{};      ///< a side of the sensor points straight up
  bool level{};            ///< the camera is level
  bool motors_can_turn{};  ///< they have power, the camera is balanced, and no error stops them
  bool near_voltage{};     ///< the voltage of the request is near the measured one
};

/// The name of a calibration for users, and its requests, the simplest first.
struct Calibration {
  const char* name = "";                 ///< for people
  std::vector<CalibrationForm> forms{};  ///< the requests that start it
  bool needs_values = false;             ///< without them, the request is meaningless
  CalibrationConditions conditions{};    ///< the conditions of the gimbal

  /// Returns its simplest request.
  const MessageInfo& info() const { return *forms.front().info; }
};

/// All calibrations, by name.
const std::vector<Calibration>& calibrations();

}  // namespace sbgc
