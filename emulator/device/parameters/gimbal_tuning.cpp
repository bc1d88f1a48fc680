#include "device/parameters/gimbal_tuning.hpp"

#include <sbgc/internal/meta_limits.hpp>

namespace sbgc::emulator {

/// The first rotation comes first, as in the name of the order. In the orders for two axes, yaw is
/// the outermost one; unknown orders count as the first.
std::array<std::uint8_t, 3> rotation_order_of(msg::EulerOrder order) {
  constexpr std::uint8_t roll = 0, pitch = 1, yaw = 2;
  switch (order) {
    case msg::EulerOrder::roll_pitch_yaw:
    case msg::EulerOrder::roll_local: return {roll, pitch, yaw};
    case msg::EulerOrder::yaw_roll_pitch: return {yaw, roll, pitch};
    case msg::EulerOrder::yaw_pitch_roll: return {yaw, pitch, roll};
    default: return {pitch, roll, yaw};  // pitch_roll_yaw, local_roll
  }
}

namespace {

bool follows(const msg::ReadParams3& parameters, std::size_t axis) {
  constexpr std::size_t yaw = 2;
  if (axis == yaw) return parameters.rc.yaw.rc_follow != 0;
  return parameters.follow_mode == msg::FollowMode::pitch;
}

msg::AngularAcceleration acceleration_limit(const Parameters& parameters,
                                            const Availability& versions, std::size_t axis) {
  constexpr Availability since =
      sbgc::detail::field_info<msg::ReadParamsExt2>("acc_limiter3").since;
  return is_available(since, versions) ? parameters.of<msg::ReadParamsExt2>().acc_limiter3[axis]
                                       : parameters.of<msg::ReadParams3>().acc_limiter_all;
}

/// Assumption: the specification gives no unit for these speeds, the dead band and FOLLOW_OFFSET;
/// deg/s, tenths of a degree and degrees fit their ranges.
double speed_of(std::uint8_t setting) { return setting; }
double deadband_of(std::uint8_t setting) {
  return msg::TenthDegrees(static_cast<std::int16_t>(setting)).degrees();
}

}  // namespace

Axes<double> home_angles(const Parameters& parameters) {
  const auto& main = parameters.of<msg::ReadParams3>();
  if (main.profile_flags1.has(msg::ProfileFlag::start_neutral_position)) return {};
  const auto& angles = main.rc_memory;
  return {angles.roll.degrees(), angles.pitch.degrees(), angles.yaw.degrees()};
}

Tuning tuning_of(const Parameters& parameters, const Availability& versions, bool has_encoders,
                 double battery_factor) {
  const auto& main = parameters.of<msg::ReadParams3>();
  const auto& joints = parameters.of<msg::ReadParamsExt>();
  const auto& more = parameters.of<msg::ReadParamsExt2>();
  const Axes<double> start = home_angles(parameters);
  Tuning tuning;
  for (std::size_t axis = 0; axis < tuning.axes.size(); ++axis) {
    AxisTuning& out = tuning.axes[axis];
    const msg::AxisPid& pid = main.axes[axis];
    const msg::AxisRc& rc = main.rc[axis];
    const double gain = more.pid_gain[axis].real();
    out.p = pid.p * gain;
    out.i = pid.i.real() * gain;
    out.d = pid.d * gain;
    out.power = main.output[axis] == msg::MotorOutput::disabled ? 0 : pid.power;
    out.acceleration = acceleration_limit(parameters, versions, axis).real();
    out.speed = out.remote_speed = speed_of(rc.rc_speed);
    out.follow_speed = speed_of(main.follow_speed[axis]);
    out.follow_deadband = deadband_of(main.follow_deadband);
    out.follow_offset = msg::SignedDegrees(main.follow_offset[axis]).degrees();
    out.follows = follows(main, axis);
    out.remote_is_speed = rc.rc_mode.mode() == msg::RcModeKind::speed;
    out.remote_min = rc.rc_min_angle.degrees();
    out.remote_max = rc.rc_max_angle.degrees();
    out.start_angle = start[axis];
    if (has_encoders) {
      // Assumption: if both limits are equal, as in factory parameters, there are none.
      out.joint_min = joints.encoder_limit_min[axis].degrees();
      out.joint_max = joints.encoder_limit_max[axis].degrees();
    }
  }
  tuning.rotation_order = rotation_order_of(main.euler_order.order());
  tuning.gyro_trust = main.gyro_trust;
  const double stop = main.bat_threshold_motors.volts();
  // The threshold applies to the reading of the sensor.
  tuning.battery_stop = stop < 0 || !(battery_factor > 0) ? -1 : stop / battery_factor;
  return tuning;
}

}  // namespace sbgc::emulator
