#include "device/realtime/custom_data.hpp"

#include "device/control/quaternion_control.hpp"
#include "device/control/reported_state.hpp"
#include "device/control/targets.hpp"
#include "device/features.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/realtime/live_data.hpp"
#include "device/realtime/measured_parts.hpp"
#include "physics/attitude.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

constexpr double pi = 3.14159265358979323846;
/// The range of motor outputs.
constexpr double full_output = 10000;
/// Assumption: the current of a motor at full power, in milliamperes.
constexpr double full_current = 800;
/// 24 bits of an encoder are a full turn.
constexpr double counts_per_degree = (1U << 24U) / 360.0;

msg::AhrsReferences references(bool is_used) {
  msg::AhrsReferences out;
  if (!is_used) return out;
  static_cast<void>(out.set_attitude(msg::AhrsReference::internal));
  static_cast<void>(out.set_heading(msg::AhrsReference::internal));
  out.set_internal_used(true);
  out.set_enabled(true);
  return out;
}

msg::SystemPowerState power(MeasuredParts& parts, const Sample& sample) {
  msg::SystemPowerState out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    msg::MotorPowerState& motor = out.motors[axis];
    motor.mot_power = saturated_raw<std::int16_t>(full_output * sample.power[axis]);
    motor.mot_current = saturated<msg::Current>(full_current * sample.power[axis]);
    motor.mot_temp = saturated<msg::Temperature>(sample.temperature);
    motor.mot_flags.set(msg::MotorPowerFlag::driver_enabled, sample.power[axis] > 0);
  }
  out.state = power_state(parts.control);
  out.battery_voltage = saturated<msg::Voltage>(parts.measured_battery(sample));
  out.total_current = saturated<msg::Current>(1000 * sample.current);
  return out;
}

/// The distances of an axis to its limits; unknown if it has none.
msg::SoftLimitDistances distances(const AxisTuning& tuning, double joint) {
  msg::SoftLimitDistances out;
  const msg::Angle14 unknown(msg::SoftLimitDistances::unknown_distance);
  out.dist = {unknown, unknown};
  if (tuning.joint_min < tuning.joint_max) {
    out.dist = {saturated<msg::Angle14>(joint - tuning.joint_min),
                saturated<msg::Angle14>(tuning.joint_max - joint)};
  }
  return out;
}

}  // namespace

msg::AhrsDebugInfo attitude_debug(const Sample& sample, const Imus& imus,
                                  const Parameters& parameters) {
  msg::AhrsDebugInfo out;
  out.main_imu_ref_src = references(true);
  out.frame_imu_ref_src = references(imus.has_frame);
  out.main_z_err = saturated<msg::AngleError>(sample.gravity_error);
  out.main_h_err = saturated<msg::AngleError>(sample.heading_error);
  if (imus.has_frame) {
    out.frame_z_err = saturated<msg::AngleError>(sample.frame_gravity_error);
    out.frame_h_err = saturated<msg::AngleError>(sample.frame_heading_error);
  }
  const bool is_set_up = parameters.of<msg::ReadParamsExt3>().ext_imu_type != msg::ExtImuModel{};
  static_cast<void>(out.ext_imu_status.set_state(is_set_up ? msg::ExtImuState::not_connected
                                                           : msg::ExtImuState::disabled));
  return out;
}

void measure_later(MeasuredParts& parts, std::size_t port, msg::RealtimeDataCustomFlags blocks,
                   Instant now, msg::RealtimeDataCustom& data) {
  using Flag = msg::RealtimeDataCustomFlag;
  const Sample sample = parts.gimbal.sample(now);
  const Tuning& tuning = parts.tuning;
  const bool has_joints = knows_joints(parts.options, parts.imus);
  // There is no fourth motor.
  if (blocks.has(Flag::motor4_control)) data.motor4_control = msg::Motor4Control{};
  if (blocks.has(Flag::ahrs_debug_info))
    data.ahrs_debug_info = attitude_debug(sample, parts.imus, parts.parameters);
  if (blocks.has(Flag::encoder_raw24)) {
    Axes<U24>& encoders = data.encoder_raw24.emplace();
    encoders = Axes<U24>{};
    for (std::size_t axis = 0; has_encoders(parts.options) && axis < 3; ++axis) {
      const auto counts = static_cast<std::int64_t>(sample.joints[axis] * counts_per_degree);
      encoders[axis] = U24(static_cast<std::uint32_t>(counts & 0xFFFFFF));
    }
  }
  if (blocks.has(Flag::imu_angles_rad)) {
    data.imu_angles_rad = saturated<msg::Radians>(sample.angles, pi / 180);
  }
  // The emulated scripts have no variables.
  if (blocks.has(Flag::script_vars_float)) data.script_vars_float = std::array<float, 10>{};
  if (blocks.has(Flag::script_vars_int16)) data.script_vars_int16 = std::array<std::int16_t, 10>{};
  if (blocks.has(Flag::system_power_state)) data.system_power_state = power(parts, sample);
  if (blocks.has(Flag::frame_cam_rate)) {
    const Axes<double> frame = turning(sample.frame_speed);
    data.frame_cam_rate = saturated<msg::GyroRate>(Axes<double>{sample.speeds.roll - frame.roll,
                                                                sample.speeds.pitch - frame.pitch,
                                                                sample.speeds.yaw - frame.yaw});
  }
  if (blocks.has(Flag::imu_angles_20)) data.imu_angles_20 = saturated<msg::Angle20>(sample.angles);
  if (blocks.has(Flag::target_angles_20)) {
    data.target_angles_20 = saturated<msg::Angle20>(sample.targets);
  }
  if (blocks.has(Flag::comm_errors)) {
    msg::CommErrors& errors = data.comm_errors.emplace();
    errors = {};
    errors.i2c_errors = parts.i2c_errors(now);
    errors.serial_errors = parts.serial_errors(port, now);
  }
  if (blocks.has(Flag::system_state)) {
    msg::SystemStatus& state = data.system_state.emplace();
    state = {};
    state.flags = state_flags(parts.gimbal, parts.modes, parts.tuning, now);
    state.calib_mode = calibration_mode(parts.control, parts.calibration);
  }
  const auto attitude = [&](const Axes<double>& angles) {
    return quaternion_of(Pose(angles, tuning.rotation_order).rotation());
  };
  if (blocks.has(Flag::imu_quat)) data.imu_quat = packed(attitude(sample.angles));
  if (blocks.has(Flag::target_quat)) data.target_quat = packed(attitude(sample.targets));
  if (blocks.has(Flag::imu_to_frame_quat)) {
    data.imu_to_frame_quat = packed(relative(attitude(sample.angles), attitude(sample.frame)));
  }
  // Nothing is connected to the analog inputs.
  if (blocks.has(Flag::adc_ch_raw)) data.adc_ch_raw = std::array<std::uint16_t, 4>{};
  if (blocks.has(Flag::sw_limits_dist)) {
    auto& limits = data.sw_limits_dist.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      limits[axis] = distances(has_joints ? tuning.axes[axis] : AxisTuning{}, sample.joints[axis]);
    }
  }
  if (blocks.has(Flag::follow_dist)) {
    auto& distance = data.follow_dist.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool follows = tuning.axes[axis].follows;
      distance[axis] = follows ? wire_angle(sample.joints[axis]) : msg::Angle14{};
    }
  }
  if (blocks.has(Flag::ext_target_limit)) {
    auto& lowest = data.ext_target_limit_min.emplace();
    auto& highest = data.ext_target_limit_max.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lowest[axis] = saturated<msg::LongAngle14>(tuning.axes[axis].remote_min);
      highest[axis] = saturated<msg::LongAngle14>(tuning.axes[axis].remote_max);
    }
  }
  if (blocks.has(Flag::frame_cam_angle_20)) {
    data.frame_cam_angle_20 =
        has_joints ? saturated<msg::Angle20>(sample.joints) : Axes<msg::Angle20>{};
  }
  if (blocks.has(Flag::main_imu_state)) {
    msg::MainImuState& state = data.main_imu_state.emplace();
    state = {};
    state.g_ref_error = saturated<msg::AngleError>(sample.gravity_error);
    state.h_ref_error = saturated<msg::AngleError>(sample.heading_error);
  }
}

}  // namespace sbgc::emulator
