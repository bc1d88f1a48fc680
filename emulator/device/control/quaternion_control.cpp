#include "device/control/quaternion_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "device/features.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// The interval for converting a speed in space to speeds of the axes.
constexpr Duration turn_period = milliseconds(20);

Pose pose(const Tuning& tuning, const Axes<double>& angles) {
  return {angles, tuning.rotation_order};
}

std::array<float, 4> wire(const Quaternion& quaternion) {
  std::array<float, 4> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<float>(std::clamp(quaternion[i], -1.0, 1.0));
  }
  return out;
}

/// Returns the rotation in space for these derivatives of the Euler angles.
Vector speed_of(const Pose& pose, const Axes<double>& speeds) {
  return to_world(pose.rotation(), pose.rates(speeds));
}

bool has_speed(msg::ControlQuatMode mode) {
  return mode == msg::ControlQuatMode::speed || mode == msg::ControlQuatMode::speed_limited;
}

}  // namespace

bool QuaternionControl::are_supported(const BoardOptions& options) {
  return features_ext2_of(options).has(msg::BoardFeaturesExt2Bit::quat_control);
}

double QuaternionControl::limited(double speed, std::size_t direction) const {
  const double limit = max_speed_[direction];
  return limit == 0 ? speed : std::clamp(speed, -limit, limit);
}

void QuaternionControl::command(Gimbal& gimbal, const Tuning& tuning, const Target& target,
                                Instant now) {
  target_ = target;
  next_ = Instant::never;
  if (target.mode == msg::ControlQuatMode::disabled) {
    for (std::size_t axis = 0; axis < 3; ++axis) gimbal.command(axis, {}, now);
  } else if (has_speed(target.mode)) {
    turn(gimbal, tuning, now);
    next_ = now + turn_period;
  } else if (target.attitude) {
    const Axes<double> present = gimbal.sample(now).targets;
    const Axes<double> angles = angles_of(*target.attitude, tuning.rotation_order, present);
    const auto speeds =
        euler_speeds(pose(tuning, present), to_body(*target.attitude, target.speed));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t direction = turning_axes[axis].direction;
      AxisCommand command{.mode = AxisMode::angle, .angle = angles[axis]};
      if (target.mode == msg::ControlQuatMode::speed_attitude) {
        command.mode = AxisMode::speed_angle;
        command.speed = speeds ? (*speeds)[axis] : 0;
      }
      command.speed = limited(command.speed, direction);
      if (command.mode == AxisMode::angle) command.speed = max_speed_[direction];
      gimbal.command(axis, command, now);
    }
  }
}

void QuaternionControl::turn(Gimbal& gimbal, const Tuning& tuning, Instant now) const {
  const Pose now_pose = pose(tuning, gimbal.sample(now).targets);
  Vector speed = target_.speed;
  for (std::size_t i = 0; i < 3; ++i) speed[i] = limited(speed[i], i);
  const auto speeds = euler_speeds(now_pose, to_body(now_pose.rotation(), speed));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gimbal.command(axis, {.mode = AxisMode::speed, .speed = speeds ? (*speeds)[axis] : 0}, now);
  }
}

void QuaternionControl::end() {
  target_ = {};
  next_ = Instant::never;
}

void QuaternionControl::configure(const msg::ControlQuatConfig& config) {
  if (!config.max_speed) return;
  for (std::size_t i = 0; i < 3; ++i) {
    max_speed_[i] = (*config.max_speed)[i].degrees_per_second();
  }
}

bool QuaternionControl::has_arrived(Gimbal& gimbal, const Tuning& tuning, Instant now) const {
  if (!target_.attitude) return true;
  const Quaternion actual = quaternion_of(pose(tuning, gimbal.sample(now).angles).rotation());
  return angle_between(actual, quaternion_of(*target_.attitude)) <= 1;
}

msg::ControlQuatStatus QuaternionControl::status(Gimbal& gimbal, const Tuning& tuning,
                                                 msg::ControlQuatStatusFields fields,
                                                 Instant now) const {
  using enum msg::ControlQuatStatusField;
  const Sample sample = gimbal.sample(now);
  const Pose setpoint_pose = pose(tuning, sample.targets);
  const Pose actual_pose = pose(tuning, sample.angles);
  const Quaternion setpoint = quaternion_of(setpoint_pose.rotation());
  const Quaternion actual = quaternion_of(actual_pose.rotation());
  const Quaternion target = target_.attitude ? quaternion_of(*target_.attitude) : setpoint;
  msg::ControlQuatStatus status;
  status.data_set = fields;
  if (fields.has(mode)) {
    status.mode = target_.mode;
    status.flags = msg::ControlQuatStatusFlags(target_.flags.raw());
  }
  if (fields.has(target_attitude)) status.target_attitude = wire(target);
  if (fields.has(setpoint_attitude)) status.setpoint_attitude = wire(setpoint);
  if (fields.has(actual_attitude)) status.actual_attitude = wire(actual);
  if (fields.has(target_speed)) status.target_speed = saturated<msg::GyroRate>(target_.speed);
  if (fields.has(setpoint_speed)) {
    status.setpoint_speed = saturated<msg::GyroRate>(speed_of(setpoint_pose, sample.target_speeds));
  }
  if (fields.has(actual_speed))
    status.actual_speed = saturated<msg::GyroRate>(speed_of(actual_pose, sample.speeds));
  if (fields.has(target_attitude_packed)) status.target_attitude_packed = packed(target);
  if (fields.has(setpoint_attitude_packed)) status.setpoint_attitude_packed = packed(setpoint);
  if (fields.has(actual_attitude_packed)) status.actual_attitude_packed = packed(actual);
  return status;
}

void QuaternionControl::advance(Instant now, Gimbal& gimbal, const Tuning& tuning) {
  turn(gimbal, tuning, now);
  next_ = now + turn_period;
}

msg::PackedQuaternion packed(const Quaternion& quaternion) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < quaternion.size(); ++i) {
    if (std::abs(quaternion[i]) > std::abs(quaternion[largest])) largest = i;
  }
  std::array<double, 3> others{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < quaternion.size(); ++i) {
    if (i != largest) others[count++] = quaternion[i];
  }
  const auto part = [](double value) {
    constexpr std::int32_t most = 0x7FFFF;
    const auto raw = saturated<msg::QuaternionPart>(value).raw();
    return msg::QuaternionPart(std::clamp(raw, -most, most));
  };
  msg::PackedQuaternion out;
  static_cast<void>(out.set_a(part(others[0])));
  static_cast<void>(out.set_b(part(others[1])));
  static_cast<void>(out.set_c(part(others[2])));
  static_cast<void>(out.set_largest(static_cast<msg::QuaternionComponent>(largest)));
  out.set_largest_sign(quaternion[largest] < 0);
  return out;
}

Quaternion unpacked(msg::PackedQuaternion packed) {
  const std::array<double, 3> others{packed.a().value(), packed.b().value(), packed.c().value()};
  double rest = 1;
  for (const double other : others) rest -= other * other;
  const double omitted = std::sqrt(std::max(rest, 0.0));
  const auto largest = static_cast<std::size_t>(packed.largest());
  Quaternion out{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = i == largest ? (packed.largest_sign() ? -omitted : omitted) : others[count++];
  }
  return out;
}

}  // namespace sbgc::emulator
