// The actions of the menu: a button, an RC signal or a request starts them.

#include <cmath>
#include <optional>

#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/parts/gimbal_tuning.hpp"
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
  if (action < msg::MenuCommand::run_script1 || action > msg::MenuCommand::run_script5) return {};
  return static_cast<std::uint8_t>(static_cast<unsigned>(action) -
                                   static_cast<unsigned>(msg::MenuCommand::run_script1));
}

/// The present angles of the camera, as the ones to start with.
Axes<msg::Angle14> present_angles(Device& device, Instant now) {
  const Sample sample = device.gimbal.sample(now);
  return {wire_angle(sample.angles.roll), wire_angle(sample.angles.pitch),
          wire_angle(sample.angles.yaw)};
}

void set_angle(Device& device, bool is_saved, Instant now) {
  Parameters& parameters = device.parameters;
  const Axes<msg::Angle14> angles = present_angles(device, now);
  const auto edit = [&](msg::ReadParams3& changed) { changed.rc_memory = angles; };
  if (is_saved) {
    // As long as before, so there is room for it.
    static_cast<void>(parameters.change<msg::ReadParams3>(parameters.profile(), edit));
  } else {
    parameters.change_in_use<msg::ReadParams3>(edit);
  }
  device.apply_parameters(now);
}

void go_to(Device& device, std::size_t axis, double angle, Instant now) {
  device.gimbal.command(axis, {.mode = AxisMode::angle, .angle = angle}, now);
}

void go_home(Device& device, Instant now) {
  const Axes<double> angles = home_angles(device.parameters);
  for (std::size_t axis = 0; axis < angles.size(); ++axis) go_to(device, axis, angles[axis], now);
}

/// Towards the frame's heading, without turning back full turns.
void center_yaw(Device& device, Instant now) {
  const double joint = device.gimbal.sample(now).joints[yaw];
  constexpr double turn = 360;
  device.gimbal.command(
      yaw, {.mode = AxisMode::relative_angle, .angle = turn * std::round(joint / turn)}, now);
}

void calibrate(Device& device, Calibrations::Kind kind, Instant now) {
  const std::size_t imu = device.cur_imu == msg::SelectedImu::frame ? 1 : 0;
  static_cast<void>(device.calibrations.start(device, kind, imu, {}, now));
}

}  // namespace

bool Device::execute(msg::MenuCommand action, Instant now) {
  using Kind = Calibrations::Kind;
  if (const auto profile = profile_of(action)) {
    select_profile(*profile, now);
    return true;
  }
  if (const auto script = script_of(action)) {
    // An empty slot starts nothing.
    static_cast<void>(scripts.start(*this, *script, {}, now));
    return true;
  }
  switch (action) {
    case msg::MenuCommand::none: break;
    case msg::MenuCommand::swap_pitch_roll:
      remote.swap(pitch, roll);
      remote.apply(*this, now);
      break;
    case msg::MenuCommand::swap_yaw_roll:
      remote.swap(yaw, roll);
      remote.apply(*this, now);
      break;
    case msg::MenuCommand::calib_acc: calibrate(*this, Kind::acc, now); break;
    case msg::MenuCommand::calib_gyro: calibrate(*this, Kind::gyro, now); break;
    case msg::MenuCommand::calib_acc_temp: calibrate(*this, Kind::acc_temperature, now); break;
    case msg::MenuCommand::calib_gyro_temp: calibrate(*this, Kind::gyro_temperature, now); break;
    case msg::MenuCommand::calib_mag: calibrate(*this, Kind::mag, now); break;
    case msg::MenuCommand::reset: restarts.announce(*this, now); break;
    case msg::MenuCommand::set_angle: set_angle(*this, true, now); break;
    case msg::MenuCommand::set_angle_no_save: set_angle(*this, false, now); break;
    case msg::MenuCommand::motor_toggle: set_motors(!gimbal.motors_on(), now); break;
    case msg::MenuCommand::motor_on: set_motors(true, now); break;
    case msg::MenuCommand::motor_off: set_motors(false, now); break;
    case msg::MenuCommand::auto_pid: static_cast<void>(auto_tuning.start(*this, now)); break;
    case msg::MenuCommand::look_down: go_to(*this, pitch, -90, now); break;
    case msg::MenuCommand::home_position: go_home(*this, now); break;
    case msg::MenuCommand::level_roll_pitch:
      go_to(*this, roll, 0, now);
      go_to(*this, pitch, 0, now);
      break;
    case msg::MenuCommand::center_yaw: center_yaw(*this, now); break;
    case msg::MenuCommand::untwist_cables:
      gimbal.command(yaw, {.mode = AxisMode::relative_angle}, now);
      break;
    // The camera stays level whichever way the frame is, and there is no receiver to bind.
    case msg::MenuCommand::frame_upside_down:
    case msg::MenuCommand::rc_bind: break;
    case msg::MenuCommand::button_press: {
      // One press. A button that presses itself does nothing.
      const msg::MenuCommand pressed = parameters.of<msg::ReadParams3>().menu_cmd[0];
      return pressed == msg::MenuCommand::button_press || execute(pressed, now);
    }
    default: return false;
  }
  return true;
}

}  // namespace sbgc::emulator
