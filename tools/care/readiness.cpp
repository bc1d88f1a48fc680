#include "care/readiness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"
#include "care/sensor_motion.hpp"
#include "command/arming.hpp"
#include "command/remark.hpp"
#include "move/motor_state.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

// All limits are assumptions.

/// More than the noise of a gyroscope, less than the motion of a hand, in deg/s.
constexpr double rest = 1;
/// More than the error of an accelerometer that was never calibrated, in degrees.
constexpr double most_tilt = 10;
/// Of the motor's power that holds the camera, in percent; as for `sbgc doctor`.
constexpr double most_imbalance = 10;
/// Share of the measured voltage by which a sensor that was never calibrated may be wrong.
constexpr double most_wrong = 0.25;

/// With one of these, the motors do not turn.
constexpr std::array stopping_errors{
    msg::SystemError::no_sensor, msg::SystemError::low_bat2,       msg::SystemError::protection,
    msg::SystemError::set_power, msg::SystemError::emergency_stop, msg::SystemError::system,
};

[[noreturn]] void not_ready(const std::string& problem) {
  throw CommandError(problem + ", or add --no-check");
}

msg::RealtimeData3 live_data_of(Client& client) {
  return value_of(Result<msg::RealtimeData3>(client.call(msg::RealtimeData3Request{})));
}

}  // namespace

void Readiness::require() {
  const CalibrationConditions& conditions = options_.conditions;
  if (conditions.motors_off) require_motors_off();
  if (!options_.checks) return;
  if (conditions.motors_can_turn) require_motors_that_turn();
  if (conditions.near_voltage) require_voltage();
  if (conditions.level) require_level();
  if (conditions.still || conditions.one_side_up) require_sensor();
}

void Readiness::require_motors_off() {
  if (!options_.motors_off && !options_.checks) return;
  if (!value_of(are_motors_on(client_))) return;
  if (!options_.motors_off && !options_.can_ask) {
    throw CommandError(
        "the motors are on: turn them off with --motors-off, by which the camera drops to its "
        "heavy side, or add --no-check");
  }
  arm({.yes = options_.motors_off},
      "The motors are on. They lose power now, and the camera drops to its heavy side.");
  value_of(Result<void>(client_.call(msg::MotorsOff{}, confirming())));
}

void Readiness::require_sensor() {
  // A camera that was just turned on, or let go, comes to rest.
  constexpr int attempts = 5;
  SensorMotion motion = motion_of(client_, options_.of_frame);
  for (int i = 1; i < attempts && std::max(motion.shaking, motion.turning) > rest; ++i) {
    motion = motion_of(client_, options_.of_frame);
  }
  const char* const what = options_.of_frame ? "frame" : "camera";
  if (!motion.is_known) {
    remark("The board does not say how the frame moves: see to it that it is still.\n");
    return;
  }
  if (options_.conditions.still && motion.shaking > rest) {
    not_ready(fmt::format("the {} is not still: it turns by {:.1f} deg/s; leave it alone", what,
                          motion.shaking + motion.turning));
  }
  if (options_.conditions.still && motion.turning > rest) {
    // Only eyes tell one from the other.
    const std::string problem =
        fmt::format("the {} turns evenly by {:.1f} deg/s, or its gyroscope has this offset", what,
                    motion.turning);
    if (!options_.can_ask) not_ready(problem + ": leave it alone");
    if (!agrees(fmt::format("Either {}. Is it still? [y/N] ", problem))) {
      throw CommandError("the " + std::string(what) + " is not still");
    }
  }
  if (!options_.conditions.one_side_up || !motion.up) return;
  const double angle = angle_to_side(*motion.up);
  if (!(angle <= most_tilt)) {
    not_ready(
        fmt::format("no side of the sensor points up: the nearest one is {:.0f} deg off; "
                    "level it",
                    angle));
  }
  const std::size_t side = side_of(*motion.up);
  if (std::ranges::find(sides_, side) != sides_.end()) {
    not_ready("this side of the sensor was up before; turn another one upwards");
  }
  sides_.push_back(side);
}

void Readiness::require_level() {
  const msg::RealtimeData3 data = live_data_of(client_);
  for (const std::size_t axis : {0U, 1U}) {
    const double angle = std::remainder(data.angle[axis].degrees(), 360);
    if (std::abs(angle) <= most_tilt) continue;
    not_ready(fmt::format("the camera is not level: its {} angle is {:.0f} deg; level it",
                          axis_names[axis], angle));
  }
}

void Readiness::require_motors_that_turn() {
  const msg::RealtimeData3 data = live_data_of(client_);
  for (const msg::SystemError error : stopping_errors) {
    if (!data.system_error.has(error)) continue;
    for (const ValueInfo& one : EnumMeta<msg::SystemError>::info.values) {
      if (one.value != static_cast<std::int64_t>(error)) continue;
      not_ready(
          fmt::format("the board reports {}, with which the motors do not turn; `sbgc "
                      "doctor` says what helps",
                      one.name));
    }
  }
  msg::ReadParams3Request request;
  request.profile_id = msg::ReadParams3Request::active_profile;
  const auto parameters = value_of(Result<msg::ReadParams3>(client_.call(request)));
  const Axes<bool> has_power{parameters.axes.roll.power != 0, parameters.axes.pitch.power != 0,
                             parameters.axes.yaw.power != 0};
  if (!has_power.roll && !has_power.pitch && !has_power.yaw) {
    not_ready("the power of all motors is 0; set it with `sbgc params set power=...`");
  }
  // Only motors that hold the camera measure its balance.
  const bool measures_balance =
      data.other_flags.has(msg::OtherFlag::motors_on) &&
      is_supported<msg::RealtimeData4Request>(client_.identity().versions());
  if (!measures_balance) return;
  const auto more = value_of(Result<msg::RealtimeData4>(client_.call(msg::RealtimeData4Request{})));
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    const double share = std::abs(more.balance_error[axis].percent());
    if (share <= most_imbalance) continue;
    not_ready(
        fmt::format("the {} axis is out of balance: {:.0f} % of the motor's power holds it; "
                    "balance the camera",
                    axis_names[axis], share));
  }
}

void Readiness::require_voltage() {
  const double measured = live_data_of(client_).bat_level.volts();
  if (!options_.voltage || measured <= 0) return;
  if (std::abs(*options_.voltage - measured) <= most_wrong * measured) return;
  not_ready(fmt::format("the board measures {:.2f} V, which is far from {:.2f} V; measure again",
                        measured, *options_.voltage));
}

}  // namespace sbgc::tools
