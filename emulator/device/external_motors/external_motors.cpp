#include "device/external_motors/external_motors.hpp"

#include <algorithm>
#include <cmath>

#include "device/features.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

using Mode = msg::ExtMotorMode;
using Power = msg::ExtMotorPower;

/// Assumption: time constants of a motor with power, with brake and without both, in seconds.
constexpr double with_power = 0.05;
constexpr double with_brake = 0.02;
constexpr double without_both = 1;
/// A motor settles within this time, in seconds; longer times are not simulated completely.
constexpr double settling = 20;
constexpr double full_torque = 32767;

double control_speed(std::int32_t counts) {
  return counts * msg::ControlSpeed(1).degrees_per_second();
}

}  // namespace

bool ExternalMotors::are_supported(const BoardOptions& options) {
  return features_ext2_of(options).has(msg::BoardFeaturesExt2Bit::ext_motors);
}

void ExternalMotors::Motor::step(double seconds) {
  const double share = max_torque / 65535.0;
  if (power != Power::on) {
    torque = 0;
    const double time = power == Power::off_floating ? without_both : with_brake;
    speed *= std::exp(-seconds / time);
    angle += speed * seconds;
    return;
  }
  const double limit = top > 0 ? std::min(top, max_speed) : max_speed;
  double wish = 0;
  switch (mode) {
    case Mode::torque: wish = std::clamp(goal, -share, share) * max_speed; break;
    case Mode::speed: wish = goal; break;
    case Mode::position: {
      const double off = goal - angle;
      // Slow enough to stop at the goal.
      wish =
          std::copysign(std::min(8 * std::abs(off), std::sqrt(acceleration * std::abs(off))), off);
      break;
    }
    default: break;
  }
  wish = std::clamp(wish, -limit, limit);
  double change = (wish - speed) * (1 - std::exp(-seconds / with_power));
  const double most = acceleration * seconds;
  if (mode != Mode::torque) change = std::clamp(change, -most, most);
  speed += change;
  angle += speed * seconds;
  const double used = mode == Mode::torque ? goal : change / std::max(most, 1e-9) / 2;
  torque = std::clamp(used, -share, share);
}

void ExternalMotors::Motor::run(Instant now) {
  constexpr double longest_step = 0.005;
  double rest = std::max(0.0, static_cast<double>((now - at).us) * 1e-6);
  at = now;
  const double skipped = rest - settling;
  for (double left = std::min(rest, settling); left > 0; left -= longest_step) {
    step(std::min(left, longest_step));
  }
  if (skipped > 0) angle += speed * skipped;
}

ExternalMotors::Motor& ExternalMotors::moved(std::size_t motor, Instant now) {
  motors_[motor].run(now);
  return motors_[motor];
}

bool ExternalMotors::act(std::size_t motor, msg::ExtMotorActionKind action, Instant now) {
  Motor& one = moved(motor, now);
  switch (action) {
    case msg::ExtMotorActionKind::off_floating: one.power = Power::off_floating; return true;
    case msg::ExtMotorActionKind::off_brake: one.power = Power::off_brake; return true;
    case msg::ExtMotorActionKind::off_safe: one.power = Power::off_safe_stop; return true;
    case msg::ExtMotorActionKind::on:
      if (one.power != Power::on) one.goal = one.mode == Mode::position ? one.angle : 0;
      one.power = Power::on;
      return true;
    case msg::ExtMotorActionKind::home_position:
    case msg::ExtMotorActionKind::search_home:
      one.power = Power::on;
      one.mode = Mode::position;
      one.goal = one.top = 0;
      return true;
    default: return false;
  }
}

bool ExternalMotors::configure(std::size_t motor, const msg::ExtMotorsControlConfig& config,
                               Instant now) {
  if (config.mode && *config.mode > Mode::torque) return false;
  Motor& one = moved(motor, now);
  if (config.mode && *config.mode != one.mode) {
    one.mode = *config.mode;
    one.goal = one.mode == Mode::position ? one.angle : 0;
    one.top = 0;
  }
  if (config.max_speed) one.max_speed = (*config.max_speed).degrees_per_second();
  if (config.max_acceleration) {
    one.acceleration = std::max(1.0, (*config.max_acceleration).degrees_per_second_squared());
  }
  if (config.jerk_slope) one.jerk_slope = (*config.jerk_slope).raw();
  if (config.max_torque) one.max_torque = *config.max_torque;
  return true;
}

void ExternalMotors::control(std::size_t motor, const Setpoint& setpoint, Instant now) {
  Motor& one = moved(motor, now);
  switch (one.mode) {
    case Mode::torque: one.goal = std::clamp(setpoint.value / full_torque, -1.0, 1.0); break;
    case Mode::speed: one.goal = control_speed(setpoint.value); break;
    case Mode::position: {
      const double angle = msg::LongAngle14(setpoint.value).degrees();
      one.goal =
          setpoint.wraps ? one.angle + std::remainder(angle - one.angle, angle_period) : angle;
      one.top = setpoint.has_param ? std::abs(control_speed(setpoint.param)) : 0;
      break;
    }
    default: break;
  }
}

ExternalMotors::Motion ExternalMotors::motion(std::size_t motor, Instant now) {
  const Motor& one = moved(motor, now);
  return {one.speed, one.torque};
}

msg::ExtMotorsState ExternalMotors::state(Gimbal& gimbal, std::size_t motor,
                                          msg::ExtMotorsStateFields fields, Instant now) {
  using enum msg::ExtMotorsStateField;
  const Motor& one = moved(motor, now);
  const bool has_goal = one.power == Power::on;
  const double speed_goal = has_goal && one.mode == Mode::speed ? one.goal : 0;
  const double angle_goal = has_goal && one.mode == Mode::position ? one.goal : one.angle;
  const double torque_goal = has_goal && one.mode == Mode::torque ? one.goal : 0;
  const Sample sample = gimbal.sample(now);
  constexpr double radians_per_degree = 3.14159265358979323846 / 180;
  msg::ExtMotorsState state;
  state.motor_id = static_cast<std::uint8_t>(motor);
  state.data_set = fields;
  if (fields.has(control_mode)) state.control_mode = one.mode;
  if (fields.has(torque)) state.torque = saturated_raw<std::int16_t>(one.torque * full_torque);
  if (fields.has(torque_setpoint)) {
    state.torque_setpoint = saturated_raw<std::int16_t>(torque_goal * full_torque);
  }
  if (fields.has(speed16)) state.speed16 = saturated<msg::ControlSpeed>(one.speed);
  if (fields.has(speed16_setpoint))
    state.speed16_setpoint = saturated<msg::ControlSpeed>(speed_goal);
  if (fields.has(speed32)) {
    state.speed32 = saturated<msg::MicroradianRate>(one.speed * radians_per_degree);
  }
  if (fields.has(speed32_setpoint)) {
    state.speed32_setpoint = saturated<msg::MicroradianRate>(speed_goal * radians_per_degree);
  }
  if (fields.has(angle16)) state.angle16 = wire_angle(one.angle);
  if (fields.has(angle16_setpoint)) state.angle16_setpoint = wire_angle(angle_goal);
  if (fields.has(angle32)) state.angle32 = saturated<msg::Angle20>(one.angle);
  if (fields.has(angle32_setpoint)) {
    state.angle32_setpoint = saturated<msg::Angle20>(angle_goal);
  }
  if (fields.has(state_flags)) state.state_flags = msg::ExtMotorStatus(one.power);
  if (fields.has(max_speed)) state.max_speed = saturated<msg::ExtMotorSpeedLimit>(one.max_speed);
  if (fields.has(max_acceleration)) {
    state.max_acceleration = saturated<msg::ExtMotorAccelerationLimit>(one.acceleration);
  }
  if (fields.has(jerk_slope)) state.jerk_slope = msg::Milliseconds(one.jerk_slope);
  if (fields.has(max_torque)) state.max_torque = one.max_torque;
  if (fields.has(current)) {
    // Assumption: 2 A at full torque.
    const double milliamperes = one.power == Power::on ? 50 + 2000 * std::abs(one.torque) : 0;
    state.current = saturated<msg::Current>(milliamperes);
  }
  if (fields.has(battery_voltage)) {
    state.battery_voltage = saturated<msg::Millivolts>(sample.battery);
  }
  if (fields.has(motor_temperature)) {
    state.motor_temperature = saturated<msg::Temperature>(sample.temperature);
  }
  if (fields.has(driver_temperature)) {
    state.driver_temperature = saturated<msg::Temperature>(sample.temperature + 2);
  }
  return state;
}

void ExternalMotors::restart(Instant now) {
  motors_ = {};
  for (Motor& motor : motors_) motor.at = now;
}

}  // namespace sbgc::emulator
