#include "tasks/bounded_turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "tasks/motion_tools.hpp"
#include "tasks/tools.hpp"

namespace sbgc::detail {

namespace {

/// A stop must not wait long behind a queued command.
CallOptions short_options() {
  CallOptions options;
  options.timeout = std::chrono::seconds(1);
  return options;
}

/// The rate in a request is the board's own and must not be validated.
CallOptions own_values() {
  CallOptions options;
  options.validate = false;
  return options;
}

/// The maximum time that the camera may turn without a bound after an unnoticed restart.
constexpr Duration renewal_interval = seconds(1);

bool is_still(const Axes<msg::ControlSpeed>& speed) noexcept {
  return speed == Axes<msg::ControlSpeed>{};
}

/// Removes the sign; the lowest value has no positive counterpart.
msg::ControlSpeed magnitude(msg::ControlSpeed speed) noexcept {
  constexpr int highest = std::numeric_limits<std::int16_t>::max();
  return msg::ControlSpeed(
      static_cast<std::int16_t>(std::min(std::abs(int{speed.raw()}), highest)));
}

}  // namespace

ShortTargets::Command ShortTargets::next(const Speed& speed, const Angles& measured, Duration age) {
  Command command;
  msg::ControlSpeed fastest{};
  for (std::size_t i = 0; i < Speed::size(); ++i) fastest = std::max(fastest, magnitude(speed[i]));
  const double seconds =
      std::chrono::duration<double>(lookahead_ + std::chrono::microseconds(age.us)).count();
  for (std::size_t i = 0; i < Speed::size(); ++i) {
    if (speed[i].raw() == 0) {
      if (!held_[i]) held_[i] = measured[i];
      command.angle[i] = *held_[i];
      command.speed[i] = fastest;
      continue;
    }
    held_[i].reset();
    // Angles wrap around, like their raw values.
    const double way = speed[i].degrees_per_second() * seconds / msg::Angle14(1).degrees();
    const auto counts = static_cast<std::int32_t>(way < 0 ? std::floor(way) : std::ceil(way));
    command.angle[i] = msg::Angle14(static_cast<std::int16_t>(
        static_cast<std::uint16_t>(std::int32_t{measured[i].raw()} + counts)));
    command.speed[i] = magnitude(speed[i]);
  }
  return command;
}

Result<void> BoundedTurn::check() const {
  constexpr std::chrono::minutes longest{1};
  const bool is_possible = lookahead_.count() > 0 && lookahead_ <= longest;
  if (bound_ == MotionBound::none || is_possible) return {};
  return ClientError{ErrorCode::invalid, "the lookahead of a motion must be 1 ms to a minute"};
}

Task<Result<void>> BoundedTurn::begin() {
  if (bound_ == MotionBound::none) co_return Result<void>();
  if (Result<void> possible = check(); !possible) co_return possible;
  const bool is_choice = bound_ == MotionBound::automatic;
  if (is_choice) {
    const TaskMachine& task = co_await tasks::this_task();
    const bool has_timeouts = is_supported<msg::ControlConfig>(task.identity().versions());
    bound_ = has_timeouts ? MotionBound::timeout : MotionBound::target;
  }
  if (bound_ != MotionBound::timeout) co_return Result<void>();
  if (timeout_) co_return co_await renew_timeout();
  co_return co_await begin_timeout(is_choice);
}

Task<Result<void>> BoundedTurn::begin_timeout(bool is_choice) {
  const TaskMachine& task = co_await tasks::this_task();
  const Result<msg::ControlConfig> request = co_await control_timeout_request(lookahead_);
  if (!request) co_return during("limiting the motion", request.error());
  // Even if the call fails, the board may have set it.
  timeout_ = *request;
  renewal_ = task.now() + renewal_interval;
  const Result<void> set = co_await tasks::call(*request, own_values());
  if (set) co_return set;
  if (is_choice && set.error().code == ErrorCode::board_error) {
    bound_ = MotionBound::target;
    timeout_.reset();
    co_return Result<void>();
  }
  co_return during("limiting the motion", set.error());
}

/// Renews the timeout, which a board loses when it restarts without a notice.
Task<Result<void>> BoundedTurn::renew_timeout() {
  const TaskMachine& task = co_await tasks::this_task();
  if (task.now() < renewal_) co_return Result<void>();
  renewal_ = task.now() + renewal_interval;
  CallOptions options = own_values();
  options.timeout = lookahead_;
  const Result<void> set = co_await tasks::call(*timeout_, options);
  if (set) co_return set;
  // The board was silent for so long that it has ended the motion; it may be restarting. The camera
  // must not turn again without a command.
  co_return during("limiting the motion", set.error());
}

Task<Result<void>> BoundedTurn::turn(Axes<msg::ControlSpeed> speed, Instant not_after) {
  const TaskMachine& task = co_await tasks::this_task();
  const auto is_late = [&task, not_after] { return task.now() > not_after; };
  const ClientError late{ErrorCode::timeout, "the board answers too late to turn the camera"};
  if (Result<void> begun = co_await begin(); !begun) co_return begun;
  msg::Control command;
  if (bound_ != MotionBound::target || is_still(speed)) {
    command.control_mode.set_mode(msg::ControlModeKind::speed);
    for (std::size_t i = 0; i < speed.size(); ++i) command.axes[i].speed = speed[i];
  } else {
    const bool has_new = polls_.last() && polls_.time() > sent_;
    if (!has_new) {
      const Result<bool> read = co_await polls_.update(next_command(task.now()));
      if (!read) co_return read.error();
    }
    ShortTargets::Angles measured;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      measured[i] = polls_.last()->axes[i].imu_angle;
    }
    const auto next = targets_.next(speed, measured, task.now() - polls_.time());
    command.control_mode.set_mode(msg::ControlModeKind::angle);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      command.axes[i] = {next.speed[i], next.angle[i]};
    }
  }
  if (is_late()) co_return late;
  sent_ = task.now();
  co_return co_await tasks::call(command, short_options());
}

Instant BoundedTurn::next_command(Instant now) const noexcept {
  if (!polls_.last() || now >= polls_.time() + patience) return Instant::never;
  const Instant soon = polls_.time() + milliseconds(patience.us / 1000 * 7 / 8);
  if (bound_ == MotionBound::none) return soon;
  return earlier(soon, sent_ + milliseconds(lookahead_.count() * 4 / 5));
}

bool BoundedTurn::has_lapsed(Instant now) const noexcept {
  return bound_ != MotionBound::none && now - sent_ > duration_of(lookahead_);
}

Task<Result<void>> BoundedTurn::stop(std::function<bool()> turns_again) {
  polls_.forget(co_await tasks::this_task());
  targets_ = ShortTargets(lookahead_);
  StopOptions options;
  options.goes_on = [&turns_again] { return !turns_again(); };
  options.rest = {};
  Result<void> stopped = co_await tasks::stop(options);
  if (turns_again() || !stopped) co_return stopped;
  // Before the timeout has expired, which is not longer than the rest.
  Result<void> removed = co_await let_go();
  options.rest = StopOptions{}.rest;
  stopped = co_await tasks::stop(options);
  co_return stopped ? removed : stopped;
}

Task<Result<void>> BoundedTurn::let_go() {
  if (!timeout_) co_return Result<void>();
  const Result<void> removed = co_await tasks::set_control_timeout({});
  if (!removed) {
    co_return during("keeping RC from taking over half a second after the motion", removed.error());
  }
  timeout_.reset();
  co_return Result<void>();
}

}  // namespace sbgc::detail
