#include "device/control/menu.hpp"

#include <cmath>
#include <optional>

#include "device/calibration/auto_tuning.hpp"
#include "device/control/events.hpp"
#include "device/control/later_menu.hpp"
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

constexpr std::size_t roll = 0, pitch = 1, yaw = 2;

std::optional<std::uint8_t> profile_of(msg::MenuCommand action) {
  switch (action) {
    case msg::MenuCommand::profile1: return 0;
    case msg::MenuCommand::profile2: return 1;
    case msg::MenuCommand::profile3: return 2;
    case msg::MenuCommand::profile4: return 3;
    case msg::MenuCommand::profile5: return 4;
    default: return {};
  }
}

std::optional<std::uint8_t> script_of(msg::MenuCommand action) {
  if (action < msg::MenuCommand::run_script1 || action > msg::MenuCommand::run_script10) return {};
  return static_cast<std::uint8_t>(static_cast<unsigned>(action) -
                                   static_cast<unsigned>(msg::MenuCommand::run_script1));
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
  constexpr double turn = 360;
  parts.gimbal.command(
      yaw, {.mode = AxisMode::relative_angle, .angle = turn * std::round(joint / turn)}, now);
}

}  // namespace

void move_to(MenuParts& parts, std::size_t axis, double angle, Instant now) {
  parts.gimbal.command(axis, {.mode = AxisMode::angle, .angle = angle}, now);
}

void begin_calibration(MenuParts& parts, Calibrations::Kind kind, Instant now) {
  static_cast<void>(
      parts.calibrations.start(parts.calibration, kind, parts.imus.selected_index(), {}, now));
}

bool execute_menu(MenuParts& parts, msg::MenuCommand action, Instant now) {
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
    case msg::MenuCommand::none: break;
    case msg::MenuCommand::swap_pitch_roll:
      parts.remote.swap(pitch, roll);
      parts.remote.apply(parts.parameters, parts.gimbal, now);
      break;
    case msg::MenuCommand::swap_yaw_roll:
      parts.remote.swap(yaw, roll);
      parts.remote.apply(parts.parameters, parts.gimbal, now);
      break;
    case msg::MenuCommand::calib_acc: begin_calibration(parts, Kind::acc, now); break;
    case msg::MenuCommand::calib_gyro: begin_calibration(parts, Kind::gyro, now); break;
    case msg::MenuCommand::calib_acc_temp:
      begin_calibration(parts, Kind::acc_temperature, now);
      break;
    case msg::MenuCommand::calib_gyro_temp:
      begin_calibration(parts, Kind::gyro_temperature, now);
      break;
    case msg::MenuCommand::calib_mag: begin_calibration(parts, Kind::mag, now); break;
    case msg::MenuCommand::reset: parts.restarts.announce(parts.ports, now); break;
    case msg::MenuCommand::set_angle: set_angle(parts, true, now); break;
    case msg::MenuCommand::set_angle_no_save: set_angle(parts, false, now); break;
    case msg::MenuCommand::motor_toggle:
      parts.tasks.set_motors(parts.gimbal, !parts.gimbal.motors_on(), now);
      break;
    case msg::MenuCommand::motor_on: parts.tasks.set_motors(parts.gimbal, true, now); break;
    case msg::MenuCommand::motor_off: parts.tasks.set_motors(parts.gimbal, false, now); break;
    case msg::MenuCommand::auto_pid:
      static_cast<void>(parts.auto_tuning.start(parts.calibration, now));
      break;
    case msg::MenuCommand::look_down: move_to(parts, pitch, 90, now); break;
    case msg::MenuCommand::home_position: go_home(parts, now); break;
    case msg::MenuCommand::level_roll_pitch:
      move_to(parts, roll, 0, now);
      move_to(parts, pitch, 0, now);
      break;
    case msg::MenuCommand::center_yaw: center_yaw(parts, now); break;
    case msg::MenuCommand::untwist_cables:
      parts.gimbal.command(yaw, {.mode = AxisMode::relative_angle}, now);
      break;
    // The camera stays level in any position of the frame, and there is no receiver to bind.
    case msg::MenuCommand::frame_upside_down:
    case msg::MenuCommand::rc_bind: break;
    case msg::MenuCommand::button_press: {
      // A single press. An action that presses the button again does nothing.
      const msg::MenuCommand pressed = parts.parameters.of<msg::ReadParams3>().menu_cmd[0];
      Events::emit(parts, msg::EventId::menu_button, msg::EventType::on);
      Events::emit(parts, msg::EventId::menu_button, msg::EventType::off);
      return pressed == msg::MenuCommand::button_press || execute_menu(parts, pressed, now);
    }
    default: return execute_later_action(parts, action, now);
  }
  return true;
}

}  // namespace sbgc::emulator
