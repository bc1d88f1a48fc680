
#include "physics/axis_motion.hpp"

#include <algorithm>
#include <cmath>

#include "physics/limits.hpp"

namespace sbgc::emulator {

namespace {

/// The friction of a joint without motor power, deg/s^2.
constexpr double friction = 1000;
/// The strength of a motor at power 100, deg/s^2.
constexpr double motor_strength = 3000;

}  // namespace

AxisGains gains_of(const AxisTuning& tuning) {
  const double power = within(tuning.power, 0, 255) / 100;
  AxisGains gains;
  gains.strength = motor_strength * power;
  // Default parameters (10, 0.1, 10, power 100) result in 4 Hz with a damping ratio of 0.8.
  gains.stiffness = 60 * within(tuning.p, 0, 1e4) * power;
  gains.damping = 4 * within(tuning.d, 0, 1e4) * power;
  // Assumption: bad tuning makes an axis weak or lets it oscillate for a while, but never makes it
  // unstable.
  gains.integral =
      std::min(6000 * within(tuning.i, 0, 1e4) * power, 0.3 * gains.stiffness * gains.damping);
  // Half of the motor strength is for the acceleration of the target, the rest for disturbances.
  gains.acceleration = std::clamp(gains.strength / 2, 1.0, motor_strength / 3);
  const double limit = within(tuning.acceleration, 0, 1e9);
  if (limit > 0) gains.acceleration = std::min(gains.acceleration, limit);
  return gains;
}

void AxisMotion::hold(const AxisGains& gains, const Path& path, double acceleration,
                      const AxisSurroundings& around, double seconds) {
  // Implicit in the new speed, so that the integration is stable for all parameters.
  const double drag = around.coupling;
  const double outside = drag * (around.frame_speed + around.error_speed) + around.imbalance;
  const double halfway = path.position - angle - speed * seconds / 2;
  const double wish = gains.stiffness * halfway + gains.damping * path.speed +
                      gains.integral * integral + acceleration + outside;
  double next = (speed + seconds * wish) /
                (1 + seconds * (gains.damping + drag + gains.stiffness * seconds / 2));
  const double inverse = 1 / seconds;
  double torque = (next - speed) * inverse - outside + drag * next;
  if (std::abs(torque) > gains.strength) {
    torque = std::copysign(gains.strength, torque);
    next = (speed + seconds * (torque + outside)) / (1 + seconds * drag);
  }
  load = torque / gains.strength;
  balance += (load - balance) * seconds;

  if (is_jammed) {
    stick(around);
    return;
  }
  const double before = speed;
  const double fastest = 2 * top_speed;  // the physical limit of the motor
  speed = std::clamp(next, -fastest, fastest);
  angle += (before + speed) / 2 * seconds;
  if (std::abs(load) < 1) {
    integral += (path.position - angle) * seconds;
    // Limit it to the strength of the motor.
    const double most = gains.integral > 0 ? gains.strength / gains.integral : 0;
    integral = std::clamp(integral, -most, most);
  }
  joint = angle - around.frame - around.error;
  joint_speed = speed - around.frame_speed - around.error_speed;
}

void AxisMotion::coast(const AxisSurroundings& around, double seconds) {
  load = 0;
  balance -= balance * seconds;
  integral = 0;
  if (joint_speed != 0 && !is_jammed) {
    const double before = joint_speed;
    const double change = friction * seconds;
    joint_speed = std::abs(before) <= change ? 0 : before - std::copysign(change, before);
    joint += (before + joint_speed) / 2 * seconds;
    angle = around.frame + joint + around.error;
    speed = around.frame_speed + joint_speed + around.error_speed;
    return;
  }
  stick(around);
}

void AxisMotion::stick(const AxisSurroundings& around) {
  joint_speed = 0;
  angle = around.frame + joint + around.error;
  speed = around.frame_speed + around.error_speed;
}

namespace {

/// A smaller distance counts as arrived, degrees.
constexpr double arrived = 1e-9;

/// Changes the speed with constant acceleration.
void move(Path& path, double speed, double seconds) {
  path.position += (path.speed + speed) / 2 * seconds;
  path.speed = speed;
}

}  // namespace

void turn(Path& path, double speed, double acceleration, double seconds) {
  const double change = acceleration * seconds;
  move(path, std::clamp(speed, path.speed - change, path.speed + change), seconds);
}

void go(Path& path, double goal, double fastest, double acceleration, double seconds) {
  const double change = acceleration * seconds;
  // Computed as if the goal were in the positive direction.
  const double sign = goal < path.position ? -1 : 1;
  const double distance = (goal - path.position) * sign;
  const double speed = path.speed * sign;
  const double stopping_distance = speed * seconds / 2;
  const bool can_stop = std::abs(speed) <= change * (1 + 1e-6);
  if (can_stop && (distance <= arrived || (speed > 0 && distance <= stopping_distance))) {
    path = {goal, 0};
    return;
  }
  // The speed after this step at which braking ends exactly at the goal:
  // distance - (speed + next) / 2 * seconds = next^2 / (2 * acceleration).
  double next = 0;
  if (distance > stopping_distance) {
    next = acceleration *
           (std::sqrt(seconds * seconds / 4 + 2 * (distance - stopping_distance) / acceleration) -
            seconds / 2);
  }
  next = std::clamp(std::min(next, fastest), speed - change, speed + change);
  move(path, next * sign, seconds);
}

void pull(Path& path, double angle, double speed, double top_pull, double acceleration,
          double seconds) {
  constexpr double strength = 10;  // 1/s
  if (speed == 0) {
    go(path, angle, top_pull, acceleration, seconds);
    return;
  }
  const double end = angle + speed / strength;
  const double distance = std::abs(end - path.position);
  const double sign = end < path.position ? -1 : 1;
  // Brake with half of the acceleration; the rest is for following a moving end.
  double wanted = std::min(
      {strength * distance, std::sqrt(acceleration * distance), top_pull + std::abs(speed)});
  if (distance < 1e-4 && std::abs(path.speed) <= acceleration * seconds) {
    path = {end, 0};
    return;
  }
  wanted *= sign;
  turn(path, wanted, acceleration, seconds);
}

}  // namespace sbgc::emulator
