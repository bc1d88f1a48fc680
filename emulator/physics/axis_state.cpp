#include "physics/axis_state.hpp"

#include <algorithm>
#include <cmath>

#include "physics/attitude.hpp"
#include "physics/limits.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {

namespace {

/// Assumption: the time for which the speed of a command dominates in `speed_angle`.
constexpr double lead_time = 0.5;

bool is_remote(AxisMode mode) { return mode == AxisMode::remote || mode == AxisMode::signal; }

/// Returns the signal that controls the axis, if any.
std::optional<double> signal_of(const AxisOrders& orders) {
  if (orders.command.mode == AxisMode::signal) {
    return orders.command.is_lost ? std::nullopt : std::optional(orders.command.signal);
  }
  return orders.remote;
}

/// Assumption: an axis does not follow anything while its command is an angle.
Followed followed_by(const AxisOrders& orders) {
  const AxisMode mode = orders.command.mode;
  if (!is_remote(mode) && mode != AxisMode::speed) return Followed::nothing;
  if (orders.followed) return Followed::reported;
  return orders.tuning.follows ? Followed::frame : Followed::nothing;
}

/// Returns the nearest of the angles that are equal in the protocol.
double nearest(double angle, double to) { return to + std::remainder(angle - to, angle_period); }

double estimated_frame(const AxisSurroundings& around) { return around.frame + around.error; }

/// Returns the angle of the followed object; 0 if there is none.
double angle_of(Followed followed, const AxisOrders& orders, const AxisSurroundings& around) {
  switch (followed) {
    case Followed::nothing: break;
    case Followed::frame: return estimated_frame(around);
    case Followed::reported: return orders.followed.value_or(0);
  }
  return 0;
}

}  // namespace

void AxisState::hold_position() {
  own = {motion.angle, 0};
  follow = {};
  follows = Followed::nothing;
}

void AxisState::apply_orders(const AxisOrders& orders, bool has_power, bool is_new,
                             const AxisSurroundings& around) {
  const AxisMode mode = orders.command.mode;
  const bool was_held = is_held;
  is_held = has_power && orders.gains.strength >= 1;
  if (!is_held) {
    hold_position();
    return;
  }
  if (!was_held) {
    hold_position();
    motion.integral = 0;
    is_new = true;
  }
  if (const Followed follows_now = followed_by(orders); follows_now != follows) {
    const double from = angle_of(follows_now, orders, around);
    own = {target() - from, target_speed()};
    follow = {from, 0};
    follows = follows_now;
  }

  if (is_new) lead = lead_time;

  const AxisTuning& tuning = orders.tuning;
  if (is_remote(mode)) {
    const std::optional<double> signal = signal_of(orders);
    const bool decides = signal && (!tuning.remote_is_speed || *signal != 0);
    if (mode == AxisMode::signal || decides) is_starting = false;
    const bool is_free = follows == Followed::nothing;
    const double neutral = is_free ? 0 : within(tuning.follow_offset, -top_angle, top_angle);
    if (is_starting) {
      goal = neutral + within(tuning.start_angle, -top_angle, top_angle);
    } else if (signal && !tuning.remote_is_speed) {
      const double low = within(tuning.remote_min, -top_angle, top_angle);
      const double high = within(tuning.remote_max, -top_angle, top_angle);
      goal = neutral + low + (high - low) * (*signal + 1) / 2;
      if (is_free) goal = nearest(goal, own.position);
    }
    return;
  }
  is_starting = false;
  if (mode == AxisMode::relative_angle) {
    // The neutral point is determined once, on arrival of the command.
    if (is_new) goal = motion.angle - motion.joint + orders.command.angle;
  } else {
    goal = nearest(orders.command.angle, own.position);
  }
}

void AxisState::move_own(const AxisOrders& orders, double acceleration, double seconds) {
  const AxisCommand& command = orders.command;
  const AxisTuning& tuning = orders.tuning;
  const double usual_speed = within(std::abs(tuning.speed), 0, top_speed);
  const double speed = command.speed == 0 ? usual_speed : std::abs(command.speed);
  switch (command.mode) {
    case AxisMode::remote:
    case AxisMode::signal: {
      const std::optional<double> signal = signal_of(orders);
      if (is_starting) {
        go(own, goal, usual_speed, acceleration, seconds);
        is_starting = own.speed != 0 || own.position != goal;
      } else if (!signal) {
        turn(own, 0, acceleration, seconds);
      } else if (tuning.remote_is_speed) {
        const double full = within(tuning.remote_speed, -top_speed, top_speed);
        turn(own, *signal * full, acceleration, seconds);
      } else {
        go(own, goal, usual_speed, acceleration, seconds);
      }
      return;
    }
    case AxisMode::speed: turn(own, command.speed, acceleration, seconds); return;
    case AxisMode::angle:
    case AxisMode::relative_angle: go(own, goal, speed, acceleration, seconds); return;
    case AxisMode::speed_angle:
      if (lead > 0) {
        pull(own, goal, command.speed, usual_speed, acceleration, seconds);
      } else {
        go(own, goal, usual_speed + std::abs(command.speed), acceleration, seconds);
      }
      lead -= seconds;
      return;
  }
}

void AxisState::move_follow(const AxisOrders& orders, double to, double acceleration,
                            double seconds) {
  constexpr double follow_gain = 4;  // 1/s
  const double off = to - follow.position;
  const double excess = std::abs(off) - within(orders.tuning.follow_deadband, 0, top_angle);
  double speed = 0;
  if (excess > 0) {
    speed = std::min({within(orders.tuning.follow_speed, 0, top_speed), follow_gain * excess,
                      std::sqrt(acceleration * excess)});
  }
  if (speed < 1e-3) speed = 0;  // so that it comes to rest
  turn(follow, std::copysign(speed, off), acceleration, seconds);
}

std::optional<AxisState::Room> AxisState::room(const AxisTuning& tuning,
                                               const AxisSurroundings& around) const {
  if (!(tuning.joint_min < tuning.joint_max)) return {};
  const double middle = estimated_frame(around) - follow.position;
  return Room{middle + within(tuning.joint_min, -top_angle, top_angle),
              middle + within(tuning.joint_max, -top_angle, top_angle)};
}

void AxisState::move(const AxisOrders& orders, const AxisSurroundings& around, double seconds) {
  const Path before = own;
  double acceleration = orders.gains.acceleration;
  // Both paths together must not exceed the limit.
  if (follows != Followed::nothing) acceleration /= 2;
  move_own(orders, acceleration, seconds);
  if (follows != Followed::nothing) {
    move_follow(orders, angle_of(follows, orders, around), acceleration, seconds);
  }
  if (const auto room = this->room(orders.tuning, around)) {
    // Limit the path so that it can stop at the joint limits.
    Path lowest = before;
    Path highest = before;
    go(lowest, room->lowest, top_speed, acceleration, seconds);
    go(highest, room->highest, top_speed, acceleration, seconds);
    if (own.position < lowest.position) own = lowest;
    if (own.position > highest.position) own = highest;
  }
}

void AxisState::step(const AxisOrders& orders, const AxisSurroundings& around, double seconds) {
  if (!is_held) {
    motion.coast(around, seconds);
    own = {motion.angle, 0};
    return;
  }
  const double before = target_speed();
  move(orders, around, seconds);
  const Path path{target(), target_speed()};
  motion.hold(orders.gains, path, (path.speed - before) / seconds, around, seconds);
}

void AxisState::skip(const AxisOrders& orders, const AxisSurroundings& around, double seconds) {
  if (is_held) {
    const AxisMode mode = orders.command.mode;
    const bool has_goal = mode == AxisMode::angle || mode == AxisMode::relative_angle ||
                          mode == AxisMode::speed_angle ||
                          (is_remote(mode) && (is_starting || !orders.tuning.remote_is_speed));
    const double way = own.speed * seconds;
    if (has_goal && std::abs(goal - own.position) <= std::abs(way)) {
      own = {goal, 0};
    } else {
      own.position += way;
    }
    if (follows != Followed::nothing) {
      const double deadband = within(orders.tuning.follow_deadband, 0, top_angle);
      const double to = angle_of(follows, orders, around);
      follow = {std::clamp(follow.position, to - deadband, to + deadband), 0};
    }
    if (const auto room = this->room(orders.tuning, around)) {
      const double limited = std::clamp(own.position, room->lowest, room->highest);
      if (limited != own.position) own = {limited, 0};
    }
    if (!motion.is_jammed) {
      motion.angle = target();
      motion.speed = target_speed();
      motion.joint = motion.angle - around.frame - around.error;
      motion.joint_speed = motion.speed - around.frame_speed - around.error_speed;
      return;
    }
  }
  motion.stick(around);
  if (!is_held) hold_position();
}

void AxisState::place(double angle, const AxisSurroundings& around) {
  motion.angle = angle;
  motion.joint = angle - around.frame - around.error;
  motion.speed = 0;
  motion.joint_speed = -around.frame_speed - around.error_speed;
  if (!is_held || motion.is_jammed) motion.stick(around);
  is_starting = false;
  hold_position();
}

void AxisState::push(double degrees) {
  if (motion.is_jammed) return;
  motion.angle += degrees;
  motion.joint += degrees;
  if (!is_held) hold_position();
}

void AxisState::restart(const AxisSurroundings& around) {
  motion.joint = wrapped(motion.joint);
  motion.angle = around.frame + motion.joint + around.error;
  motion.integral = 0;
  is_held = false;
  is_starting = true;
  hold_position();
}

}  // namespace sbgc::emulator
