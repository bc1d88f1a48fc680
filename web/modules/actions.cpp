#include "modules/actions.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include <sbgc/client/motion.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>

#include "modules/bounded_move.hpp"
#include "modules/client.hpp"
#include "modules/lines.hpp"
#include "move/menu_action.hpp"

namespace sbgc::web {

namespace {

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
