#include "device/control/later_menu.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "device/calibration/auto_tuning.hpp"
#include "device/control/events.hpp"
#include "device/control/menu.hpp"
#include "device/control/modes.hpp"
#include "device/control/tasks.hpp"
#include "device/parameters/gimbal_tuning.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"
#include "device/scripting/scripts.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

using Command = msg::MenuCommand;

constexpr std::size_t roll_motor = 0, pitch_motor = 1, yaw_motor = 2;
constexpr double whole_turn = 360;

/// Moves to the nearest of the equal angles.
void move_shortest(MenuParts& parts, std::size_t axis, double angle, Instant now) {
  const double from = parts.gimbal.sample(now).targets[axis];
  move_to(parts, axis, from + std::remainder(angle - from, whole_turn), now);
}

/// Moves the motor to this angle, without undoing full turns.
void move_joint(MenuParts& parts, std::size_t axis, double angle, Instant now) {
  const double joint = parts.gimbal.sample(now).joints[axis];
  const double to = joint + std::remainder(angle - joint, whole_turn);
  parts.gimbal.command(axis, {.mode = AxisMode::relative_angle, .angle = to}, now);
}

void go_home_shortest(MenuParts& parts, Instant now) {
  const Axes<double> angles = home_angles(parts.parameters);
  for (std::size_t axis = 0; axis < angles.size(); ++axis) {
    move_shortest(parts, axis, angles[axis], now);
  }
}

/// Moves each axis to the nearest multiple of 90 degrees.
void snap(MenuParts& parts, Instant now) {
  constexpr double quarter = 90;
  const Axes<double> angles = parts.gimbal.sample(now).angles;
  for (std::size_t axis = 0; axis < angles.size(); ++axis) {
    move_to(parts, axis, quarter * std::round(angles[axis] / quarter), now);
  }
}

/// Assumption: RETRACTED_ANGLE is in degrees, of the motors.
void retract(MenuParts& parts, Instant now) {
  const auto& angles = parts.parameters.of<msg::ReadParamsExt3>().retracted_angle;
  for (std::size_t axis = 0; axis < angles.size(); ++axis) {
    move_joint(parts, axis, angles[axis], now);
  }
  parts.modes.retracted = true;
}

void invert_rc(Parameters& active, std::size_t axis) {
  active.change_in_use<msg::ReadParams3>([axis](msg::ReadParams3& parameters) {
    auto& mode = parameters.rc[axis].rc_mode;
    mode.set_inverted(!mode.inverted());
  });
}

/// Assumption: the trim makes the current signals the center.
void trim_rc(MenuParts& parts) {
  Axes<std::int8_t> trims;
  for (std::size_t axis = 0; axis < trims.size(); ++axis) {
    const double signal = parts.remote.own(parts.parameters, axis).value_or(0);
    constexpr double lowest = -127, highest = 127;
    const double counts = -saturated<msg::CentredRcSignal>(signal).raw();
    trims[axis] = static_cast<std::int8_t>(std::clamp(counts, lowest, highest));
  }
  static_cast<void>(parts.parameters.change<msg::ReadParams3>(
      parts.parameters.profile(), [&](msg::ReadParams3& parameters) {
        for (std::size_t axis = 0; axis < trims.size(); ++axis) {
          parameters.rc_trim[axis] = trims[axis];
        }
      }));
}

std::optional<std::size_t> profile_set_of(Command action) {
  if (action < Command::load_profile_set1 || action > Command::load_profile_set_backup) return {};
  return static_cast<std::size_t>(action) - static_cast<std::size_t>(Command::load_profile_set1);
}

/// Actions that move the camera.
bool move_camera(MenuParts& parts, Command action, Instant now) {
  switch (action) {
    case Command::home_position_shortest: go_home_shortest(parts, now); return true;
    case Command::center_yaw_shortest: move_joint(parts, yaw_motor, 0, now); return true;
    case Command::rotate_yaw_180: {
      const double yaw = parts.gimbal.sample(now).targets.yaw;
      move_to(parts, yaw_motor, yaw + whole_turn / 2, now);
      return true;
    }
    case Command::rotate_yaw_180_frame_rel:
      parts.gimbal.command(yaw_motor,
                           {.mode = AxisMode::relative_angle,
                            .angle = parts.gimbal.sample(now).joints.yaw + whole_turn / 2},
                           now);
      return true;
    case Command::switch_yaw_180_frame_rel: {
      const double joint = std::remainder(parts.gimbal.sample(now).joints.yaw, whole_turn);
      const bool is_forward = std::abs(joint) < whole_turn / 4;
      move_joint(parts, yaw_motor, is_forward ? whole_turn / 2 : 0, now);
      return true;
    }
    case Command::switch_pos_roll_90: {
      const bool is_level = std::abs(parts.gimbal.sample(now).targets.roll) < whole_turn / 8;
      move_to(parts, roll_motor, is_level ? whole_turn / 4 : 0, now);
      return true;
    }
    case Command::level_roll: move_to(parts, roll_motor, 0, now); return true;
    case Command::level_pitch: move_to(parts, pitch_motor, 0, now); return true;
    case Command::snap_to_fixed_position: snap(parts, now); return true;
    case Command::home_position_motors:
      for (std::size_t axis = 0; axis < 3; ++axis) move_joint(parts, axis, 0, now);
      return true;
    case Command::retracted_position: retract(parts, now); return true;
    // The two positions of a time lapse are set elsewhere; the emulated camera has none.
    case Command::start_timelapse:
    case Command::repeat_timelapse:
    case Command::timelapse_step1: return true;
    default: return false;
  }
}

/// Actions that switch something until the board restarts.
bool switch_mode(MenuParts& parts, Command action) {
  Modes& modes = parts.modes;
  switch (action) {
    case Command::invert_rc_roll: invert_rc(parts.parameters, roll_motor); return true;
    case Command::invert_rc_pitch: invert_rc(parts.parameters, pitch_motor); return true;
    case Command::invert_rc_yaw: invert_rc(parts.parameters, yaw_motor); return true;
    case Command::forced_follow_toggle: modes.follows = !modes.follows; break;
    case Command::disable_follow_toggle: modes.follow_off = !modes.follow_off; break;
    case Command::tripod_mode_off: modes.tripod = false; break;
    case Command::tripod_mode_on: modes.tripod = true; break;
    case Command::shake_generator_off: modes.shakes = false; break;
    case Command::shake_generator_on: modes.shakes = true; break;
    case Command::servo_mode_on: modes.servo = true; break;
    case Command::servo_mode_off: modes.servo = false; break;
    case Command::servo_mode_toggle: modes.servo = !modes.servo; break;
    default: return false;
  }
  parts.parameters.apply_later();
  return true;
}

}  // namespace

bool execute_later_action(MenuParts& parts, Command action, Instant now) {
  using Kind = Calibrations::Kind;
  if (const auto slot = profile_set_of(action)) {
    // An empty slot changes nothing.
    static_cast<void>(parts.parameters.load_profile_set(*slot));
    return true;
  }
  if (move_camera(parts, action, now) || switch_mode(parts, action)) return true;
  switch (action) {
    case Command::calib_momentum: begin_calibration(parts, Kind::momentum, now); break;
    case Command::calib_acc_auto: begin_calibration(parts, Kind::acc, now); break;
    case Command::ext_gyro_online_calib: begin_calibration(parts, Kind::gyro, now); break;
    case Command::camera_rec_photo_event:
      Events::emit(parts, msg::EventId::camera, msg::EventType::off);
      break;
    case Command::camera_photo_event:
      Events::emit(parts, msg::EventId::camera, msg::EventType::on);
      break;
    case Command::motors_safe_stop: parts.tasks.stop_safely(parts.gimbal, now); break;
    case Command::motors_safe_toggle:
      if (parts.gimbal.motors_on()) {
        parts.tasks.stop_safely(parts.gimbal, now);
      } else {
        parts.tasks.set_motors(parts.gimbal, true, now);
      }
      break;
    case Command::reset_imu: parts.gimbal.gyro_calibrated(false, now); break;
    case Command::auto_pid_gain_only:
      static_cast<void>(parts.auto_tuning.start(parts.calibration, now));
      break;
    case Command::set_cur_pos_as_home: return execute_menu(parts, Command::set_angle, now);
    case Command::stop_script: parts.scripts.stop(); break;
    case Command::set_rc_trim: trim_rc(parts); break;
    default: return false;
  }
  return true;
}

}  // namespace sbgc::emulator
