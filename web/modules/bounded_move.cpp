#include "modules/bounded_move.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/messages/realtime.hpp>

#include "tasks/bounded_turn.hpp"
#include "tasks/tools.hpp"

namespace sbgc::web {

namespace {

using detail::degrees_between;

/// How long the camera turns after the last command.
constexpr std::chrono::milliseconds bound{500};
constexpr Duration interval = milliseconds(50);
/// The rest of the way, in degrees, which a single command moves.
constexpr double short_way = 1;
/// Speed for each degree that is left, so that the camera slows down before its target.
constexpr double speed_per_degree = 2;
constexpr double least_speed = 1;  // deg/s
/// A camera that has not moved by more than this, in degrees, does not turn.
constexpr double noise = 0.2;
constexpr Duration patience = seconds(1);

/// True if the board turns an axis that has a speed.
bool is_turning(const msg::GetAngles& state, const Axes<msg::ControlSpeed>& speeds) {
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (speeds[i].raw() != 0 && state.axes[i].rc_speed.raw() != 0) return true;
  }
  return false;
}

/// Turns until each axis is near its target.
Task<Result<void>> approach(MoveTarget target, MoveOptions options, detail::BoundedTurn& motion) {
  TaskMachine& task = co_await tasks::this_task();
  const Instant start = task.now();
  const Instant end = start + detail::duration_of(options.timeout);
  std::optional<msg::GetAngles> before;
  Axes<msg::ControlSpeed> speeds{};
  bool has_begun = false;
  int still_polls = 0;
  Instant sent = start;
  const double fastest = options.speed.degrees_per_second();
  while (true) {
    const Result<msg::GetAngles> state = co_await tasks::call(msg::GetAnglesRequest{});
    if (!state) co_return state.error();
    Axes<msg::ControlSpeed> next{};
    bool is_near = true;
    bool has_turned = false;
    if (!before) before = *state;
    for (std::size_t i = 0; i < target.size(); ++i) {
      if (!target[i]) continue;
      const msg::Angle14 angle = state->axes[i].imu_angle;
      has_turned =
          has_turned || std::abs(degrees_between(before->axes[i].imu_angle, angle)) > noise;
      const double way = degrees_between(angle, *target[i]);
      if (std::abs(way) <= short_way) continue;
      is_near = false;
      const double speed = std::clamp(std::abs(way) * speed_per_degree, least_speed, fastest);
      next[i] = msg::ControlSpeed::from_degrees_per_second(std::copysign(speed, way)).value_or({});
    }
    if (is_near) co_return Result<void>();
    const bool turns = is_turning(*state, speeds);
    has_begun = has_begun || turns;
    // The bound of a late command ends the motion, too.
    const bool is_stopped = has_begun && !turns && task.now() - sent < detail::duration_of(bound);
    still_polls = is_stopped ? still_polls + 1 : 0;
    if (still_polls == 2) {
      co_return ClientError{ErrorCode::interrupted,
                            "another program, RC, a limit or the control timeout has stopped the "
                            "camera"};
    }
    if (!has_turned && task.now() - start >= patience) {
      co_return ClientError{ErrorCode::timeout,
                            "the camera did not begin to turn; are the motors on?"};
    }
    if (task.now() >= end) {
      co_return ClientError{ErrorCode::timeout, "the camera has not arrived in time"};
    }
    if (is_stopped) {  // a command could undo the stop of another program
      const Result<void> waited = co_await tasks::wait_until(task.now() + interval);
      if (!waited) co_return waited;
      continue;
    }
    speeds = next;
    sent = task.now();
    if (Result<void> turned = co_await motion.turn(speeds); !turned) co_return turned;
    const Result<void> waited = co_await tasks::wait_until(task.now() + interval);
    if (!waited) co_return waited;
  }
}

}  // namespace

Task<Result<MoveProgress>> bounded_move(MoveTarget target, MoveOptions options) {
  if (options.speed.raw() <= 0) {
    co_return ClientError{ErrorCode::invalid, "a move needs a speed"};
  }
  detail::BoundedTurn motion(MotionBound::automatic, bound);
  const Result<void> arrived = co_await approach(target, options, motion);
  if (!arrived && is_in_other_hands(arrived.error().code)) {
    static_cast<void>(co_await motion.let_go());
    co_return arrived.error();
  }
  const Result<void> stopped = co_await motion.stop([] { return false; });
  if (!arrived) co_return arrived.error();
  if (!stopped) co_return stopped.error();
  co_return co_await tasks::move_to(target, options);
}

}  // namespace sbgc::web
