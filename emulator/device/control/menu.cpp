#include "device/control/menu.hpp"

#include <cmath>
#include <optional>

#include "device/control/later_menu.hpp"
#include "device/device.hpp"
#include "device/parameters/gimbal_tuning.hpp"
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
void set_angle(Device& device, bool is_saved, Instant now) {
  Parameters& parameters = device.parameters;
  const Axes<msg::Angle14> angles = wire_angles(device.gimbal.sample(now).angles);
  const auto edit = [&](msg::ReadParams3& changed) { changed.rc_memory = angles; };
  if (is_saved) {
    // The length does not change, so the body fits.
    static_cast<void>(parameters.change<msg::ReadParams3>(parameters.profile(), edit));
  } else {
    parameters.change_in_use<msg::ReadParams3>(edit);
  }
}

void go_home(Device& device, Instant now) {
  const Axes<double> angles = home_angles(device.parameters);
  for (std::size_t axis = 0; axis < angles.size(); ++axis) move_to(device, axis, angles[axis], now);
}

/// Turns to the heading of the frame without undoing full turns.
void center_yaw(Device& device, Instant now) {
  const double joint = device.gimbal.sample(now).joints[yaw];
  constexpr double turn = 360;
  device.gimbal.command(
      yaw, {.mode = AxisMode::relative_angle, .angle = turn * std::round(joint / turn)}, now);
}

}  // namespace

void move_to(Device& device, std::size_t axis, double angle, Instant now) {
  device.gimbal.command(axis, {.mode = AxisMode::angle, .angle = angle}, now);
}

void begin_calibration(Device& device, Calibrations::Kind kind, Instant now) {
  static_cast<void>(
      device.calibrations.start(device.calibration, kind, device.imus.selected_index(), {}, now));
}

bool execute_menu(Device& device, msg::MenuCommand action, Instant now) {
  using Kind = Calibrations::Kind;
  if (const auto profile = profile_of(action)) {
    device.parameters.select_profile(*profile);
    return true;
  }
  if (const auto script = script_of(action)) {
    // An empty slot starts nothing.
    if (Scripts::are_supported(device.options)) {
      static_cast<void>(device.scripts.start(device.files, *script, {}, now));
    }
    return true;
  }
  switch (action) {
    case msg::MenuCommand::none: break;
    case msg::MenuCommand::swap_pitch_roll:
      device.remote.swap(pitch, roll);
      device.remote.apply(device.parameters, device.gimbal, now);
      break;
    case msg::MenuCommand::swap_yaw_roll:
      device.remote.swap(yaw, roll);
      device.remote.apply(device.parameters, device.gimbal, now);
      break;
    case msg::MenuCommand::calib_acc: begin_calibration(device, Kind::acc, now); break;
    case msg::MenuCommand::calib_gyro: begin_calibration(device, Kind::gyro, now); break;
    case msg::MenuCommand::calib_acc_temp:
      begin_calibration(device, Kind::acc_temperature, now);
      break;
    case msg::MenuCommand::calib_gyro_temp:
      begin_calibration(device, Kind::gyro_temperature, now);
      break;
    case msg::MenuCommand::calib_mag: begin_calibration(device, Kind::mag, now); break;
    case msg::MenuCommand::reset: device.restarts.announce(device.ports, now); break;
    case msg::MenuCommand::set_angle: set_angle(device, true, now); break;
    case msg::MenuCommand::set_angle_no_save: set_angle(device, false, now); break;
    case msg::MenuCommand::motor_toggle:
      device.tasks.set_motors(device.gimbal, !device.gimbal.motors_on(), now);
      break;
    case msg::MenuCommand::motor_on: device.tasks.set_motors(device.gimbal, true, now); break;
    case msg::MenuCommand::motor_off: device.tasks.set_motors(device.gimbal, false, now); break;
    case msg::MenuCommand::auto_pid:
      static_cast<void>(device.auto_tuning.start(device.calibration, now));
      break;
    case msg::MenuCommand::look_down: move_to(device, pitch, 90, now); break;
    case msg::MenuCommand::home_position: go_home(device, now); break;
    case msg::MenuCommand::level_roll_pitch:
      move_to(device, roll, 0, now);
      move_to(device, pitch, 0, now);
      break;
    case msg::MenuCommand::center_yaw: center_yaw(device, now); break;
    case msg::MenuCommand::untwist_cables:
      device.gimbal.command(yaw, {.mode = AxisMode::relative_angle}, now);
      break;
    // The camera stays level in any position of the frame, and there is no receiver to bind.
    case msg::MenuCommand::frame_upside_down:
    case msg::MenuCommand::rc_bind: break;
    case msg::MenuCommand::button_press: {
      // A single press. An action that presses the button again does nothing.
      const msg::MenuCommand pressed = device.parameters.of<msg::ReadParams3>().menu_cmd[0];
      Events::emit(device, msg::EventId::menu_button, msg::EventType::on);
      Events::emit(device, msg::EventId::menu_button, msg::EventType::off);
      return pressed == msg::MenuCommand::button_press || execute_menu(device, pressed, now);
    }
    default: return execute_later_action(device, action, now);
  }
  return true;
}

}  // namespace sbgc::emulator
