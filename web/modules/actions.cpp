#include "modules/actions.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <sbgc/client/motion.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "modules/client.hpp"
#include "modules/exchange.hpp"
#include "move/menu_action.hpp"
#include "tasks/bounded_turn.hpp"
#include "tasks/tools.hpp"

namespace sbgc::web {

namespace {

using detail::degrees_between;

/// The camera turns this long after the last command.
constexpr std::chrono::milliseconds bound{500};
constexpr Duration interval = milliseconds(50);
/// The last part of the way, in degrees, which a single command moves.
constexpr double short_way = 1;
/// Speed per remaining degree, so that the camera slows down before its target.
constexpr double speed_per_degree = 2;
constexpr double least_speed = 1;  // deg/s
/// A camera that has moved by at most this, in degrees, is not turning.
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
    // The motion also ends if the next command is late.
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
    if (is_stopped) {  // a command could cancel the stop of another program
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

/// Like tasks::move_to(), but turns at speeds that last for half a second, so that the camera
/// brakes if the page is gone. The last degree is a move to the target. Errors: those of move_to(),
/// and `invalid` without a speed.
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

std::string no_action(std::string_view name) {
  return "there is no action '" + std::string(name) + "'";
}

/// Values for axes, and a further one.
struct Motion {
  Axes<std::optional<double>> axes{};
  std::optional<double> other{};
};

/// Reads "pitch=-30 yaw=20 speed=40". Returns what is wrong.
std::string read_motion(std::string_view text, std::string_view other, Motion& motion) {
  std::string problem;
  for_each_setting(
      text,
      [&](std::string_view name, std::string_view value) {
        const auto* const axis =
            std::find(detail::axis_names.begin(), detail::axis_names.end(), name);
        const bool is_axis = axis != detail::axis_names.end();
        const auto number = detail::parse_number<double>(value);
        if (!number || (!is_axis && name != other)) {
          problem = "not a value: '" + std::string(name) + "=" + std::string(value) + "'";
          return;
        }
        (is_axis ? motion.axes[static_cast<std::size_t>(axis - detail::axis_names.begin())]
                 : motion.other) = *number;
      },
      ' ');
  return problem;
}

constexpr const char* out_of_range = "a number is out of the range of the protocol";

std::string move(Client& client, double id, std::string_view text) {
  Motion motion;
  if (std::string problem = read_motion(text, "speed", motion); !problem.empty()) return problem;
  MoveTarget target;
  MoveOptions options;
  bool has_target = false;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!motion.axes[i]) continue;
    const auto angle = msg::Angle14::from_degrees(*motion.axes[i]);
    if (!angle) return out_of_range;
    target[i] = *angle;
    has_target = true;
  }
  if (!has_target) return "a move needs an angle, such as pitch=-30";
  if (motion.other) {
    const auto speed = msg::ControlSpeed::from_degrees_per_second(*motion.other);
    if (!speed || *motion.other < 0) return out_of_range;
    options.speed = *speed;
  }
  if (client.bounds_moves()) {
    client.start(id, bounded_move(target, options));
  } else {
    client.start(id, tasks::move_to(target, options));
  }
  return "";
}

std::string turn(Client& client, double id, std::string_view text, Instant now) {
  Motion motion;
  if (std::string problem = read_motion(text, "seconds", motion); !problem.empty()) return problem;
  Axes<msg::ControlSpeed> speeds;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const auto speed = msg::ControlSpeed::from_degrees_per_second(motion.axes[i].value_or(0));
    if (!speed) return out_of_range;
    speeds[i] = *speed;
  }
  const double seconds = motion.other.value_or(0.5);
  if (!(seconds > 0 && seconds <= 60)) return "seconds is more than 0 and at most 60";
  client.turn(id, speeds, now, microseconds(static_cast<std::int64_t>(seconds * 1e6)));
  return "";
}

/// Confirmed, because the state of the motors matters.
template <Message M>
Task<Result<void>> switch_motors() {
  co_return co_await tasks::call(M{}, {.expect_confirmation = true, .repeat_unconfirmed = true});
}

std::string menu(Client& client, double id, std::string_view name) {
  const ValueInfo* const action = tools::menu_action(name);
  if (action == nullptr) return no_action(name);
  client.start(id, tools::perform(static_cast<msg::MenuCommand>(action->value), {}));
  return "";
}

}  // namespace

std::string begin_action(Client& client, double id, std::string_view action, Instant now) {
  std::string_view rest = action;
  const std::string_view name = take_until(' ', rest);
  if (name == "move") return move(client, id, rest);
  if (name == "turn") return turn(client, id, rest, now);
  if (name == "menu") return menu(client, id, rest);
  if (action == "stop") return client.start(id, tasks::stop()), "";
  if (action == "release") return client.start(id, tasks::release()), "";
  if (action == "motors on") return client.start(id, switch_motors<msg::MotorsOn>()), "";
  if (action == "motors off") return client.start(id, switch_motors<msg::MotorsOff>()), "";
  return no_action(action);
}

}  // namespace sbgc::web
