#include "device/control/menu.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "device/calibration/auto_tuning.hpp"
#include "device/control/reported_state.hpp"
#include "device/control/tasks.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/gimbal_tuning.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"
#include "device/scripting/scripts.hpp"
#include "device/system/restarts.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

using Command = msg::MenuCommand;

constexpr std::size_t roll = 0, pitch = 1, yaw = 2;
constexpr double whole_turn = 360;

void move_to(MenuParts& parts, std::size_t axis, double angle, Instant now) {
  parts.gimbal.command(axis, {.mode = AxisMode::angle, .angle = angle}, now);
}

/// Starts a calibration of the selected IMU.
void begin_calibration(MenuParts& parts, Calibrations::Kind kind, Instant now) {
  static_cast<void>(
      parts.calibrations.start(parts.calibration, kind, parts.imus.selected_index(), {}, now));
}

std::optional<std::uint8_t> profile_of(Command action) {
  switch (action) {
    case Command::profile1: return 0;
    case Command::profile2: return 1;
    case Command::profile3: return 2;
    case Command::profile4: return 3;
    case Command::profile5: return 4;
    default: return {};
  }
}

std::optional<std::uint8_t> script_of(Command action) {
  if (action < Command::run_script1 || action > Command::run_script10) return {};
  return static_cast<std::uint8_t>(static_cast<unsigned>(action) -
                                   static_cast<unsigned>(Command::run_script1));
}

/// Makes the current camera angles the start angles.
void set_angle(MenuParts& parts, bool is_saved, Instant now) {
  Parameters& parameters = parts.parameters;
  const Axes<msg::Angle14> angles = wire_angles(parts.gimbal.sample(now).angles);
  const auto edit = [&](msg::ReadParams3& changed) { changed.rc_memory = angles; };
  if (is_saved) {
    // The length does not change, so the body fits.
    static_cast<void>(parameters.change<msg::ReadParams3>(parameters.profile(), edit));
  } else {
    parameters.change_in_use<msg::ReadParams3>(edit);
  }
}

void go_home(MenuParts& parts, Instant now) {
  const Axes<double> angles = home_angles(parts.parameters);
  for (std::size_t axis = 0; axis < angles.size(); ++axis) move_to(parts, axis, angles[axis], now);
}

/// Turns to the heading of the frame without undoing full turns.
void center_yaw(MenuParts& parts, Instant now) {
  const double joint = parts.gimbal.sample(now).joints[yaw];
  parts.gimbal.command(
      yaw, {.mode = AxisMode::relative_angle, .angle = whole_turn * std::round(joint / whole_turn)},
      now);
}

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
    case Command::center_yaw_shortest: move_joint(parts, yaw, 0, now); return true;
    case Command::rotate_yaw_180: {
      const double target = parts.gimbal.sample(now).targets.yaw;
      move_to(parts, yaw, target + whole_turn / 2, now);
      return true;
    }
    case Command::rotate_yaw_180_frame_rel:
      parts.gimbal.command(yaw,
                           {.mode = AxisMode::relative_angle,
                            .angle = parts.gimbal.sample(now).joints.yaw + whole_turn / 2},
                           now);
      return true;
    case Command::switch_yaw_180_frame_rel: {
      const double joint = std::remainder(parts.gimbal.sample(now).joints.yaw, whole_turn);
      const bool is_forward = std::abs(joint) < whole_turn / 4;
      move_joint(parts, yaw, is_forward ? whole_turn / 2 : 0, now);
      return true;
    }
    case Command::switch_pos_roll_90: {
      const bool is_level = std::abs(parts.gimbal.sample(now).targets.roll) < whole_turn / 8;
      move_to(parts, roll, is_level ? whole_turn / 4 : 0, now);
      return true;
    }
    case Command::level_roll: move_to(parts, roll, 0, now); return true;
    case Command::level_pitch: move_to(parts, pitch, 0, now); return true;
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
    case Command::invert_rc_roll: invert_rc(parts.parameters, roll); return true;
    case Command::invert_rc_pitch: invert_rc(parts.parameters, pitch); return true;
    case Command::invert_rc_yaw: invert_rc(parts.parameters, yaw); return true;
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

/// Executes an action of firmware after the specification. Returns false if there is no such
/// action.
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

}  // namespace

bool execute_menu(MenuParts& parts, Command action, Instant now) {
  using Kind = Calibrations::Kind;
  if (const auto profile = profile_of(action)) {
    parts.parameters.select_profile(*profile);
    return true;
  }
  if (const auto script = script_of(action)) {
    // An empty slot starts nothing.
    if (Scripts::are_supported(parts.options)) {
      static_cast<void>(parts.scripts.start(parts.files, *script, {}, now));
    }
    return true;
  }
  switch (action) {
    case Command::none: break;
    case Command::swap_pitch_roll:
      parts.remote.swap(pitch, roll);
      parts.remote.apply(parts.parameters, parts.gimbal, now);
      break;
    case Command::swap_yaw_roll:
      parts.remote.swap(yaw, roll);
      parts.remote.apply(parts.parameters, parts.gimbal, now);
      break;
    case Command::calib_acc: begin_calibration(parts, Kind::acc, now); break;
    case Command::calib_gyro: begin_calibration(parts, Kind::gyro, now); break;
    case Command::calib_acc_temp: begin_calibration(parts, Kind::acc_temperature, now); break;
    case Command::calib_gyro_temp: begin_calibration(parts, Kind::gyro_temperature, now); break;
    case Command::calib_mag: begin_calibration(parts, Kind::mag, now); break;
    case Command::reset: parts.restarts.announce(parts.ports, now); break;
    case Command::set_angle: set_angle(parts, true, now); break;
    case Command::set_angle_no_save: set_angle(parts, false, now); break;
    case Command::motor_toggle:
      parts.tasks.set_motors(parts.gimbal, !parts.gimbal.motors_on(), now);
      break;
    case Command::motor_on: parts.tasks.set_motors(parts.gimbal, true, now); break;
    case Command::motor_off: parts.tasks.set_motors(parts.gimbal, false, now); break;
    case Command::auto_pid:
      static_cast<void>(parts.auto_tuning.start(parts.calibration, now));
      break;
    case Command::look_down: move_to(parts, pitch, 90, now); break;
    case Command::home_position: go_home(parts, now); break;
    case Command::level_roll_pitch:
      move_to(parts, roll, 0, now);
      move_to(parts, pitch, 0, now);
      break;
    case Command::center_yaw: center_yaw(parts, now); break;
    case Command::untwist_cables:
      parts.gimbal.command(yaw, {.mode = AxisMode::relative_angle}, now);
      break;
    // The camera stays level in any position of the frame, and there is no receiver to bind.
    case Command::frame_upside_down:
    case Command::rc_bind: break;
    case Command::button_press: {
      // A single press. An action that presses the button again does nothing.
      const Command pressed = parts.parameters.of<msg::ReadParams3>().menu_cmd[0];
      Events::emit(parts, msg::EventId::menu_button, msg::EventType::on);
      Events::emit(parts, msg::EventId::menu_button, msg::EventType::off);
      return pressed == Command::button_press || execute_menu(parts, pressed, now);
    }
    default: return execute_later_action(parts, action, now);
  }
  return true;
}

}  // namespace sbgc::emulator
