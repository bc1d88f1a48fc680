// sbgc speed: turns the camera at a speed for a time.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/speed_control.hpp>

#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "move/moving_gimbal.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

using Clock = std::chrono::steady_clock;

struct SpeedCommand {
  AxisNumbers speeds{};
  std::optional<std::chrono::milliseconds> time{};  // --for
  Arming arming{};
};

/// Turns until the time is over or the motion must stop.
Result<void> turn(const MovingGimbal& gimbal, SpeedControl& control,
                  const Axes<msg::ControlSpeed>& speed,
                  const std::optional<std::chrono::milliseconds>& time) {
  constexpr std::chrono::milliseconds interval{100};
  ProgressBar bar;
  const auto start = Clock::now();
  const auto end = time ? start + *time : Clock::time_point::max();
  for (auto now = start; now < end && !gimbal.must_stop(); now = Clock::now()) {
    if (Result<void> set = control.set(speed); !set) return set;
    bar.show(
        fmt::format("turning for {:.1f} s", std::chrono::duration<double>(now - start).count()));
    static_cast<void>(
        gimbal.wait(std::min(interval, std::chrono::ceil<std::chrono::milliseconds>(end - now))));
  }
  if (Result<void> stopping = control.stop(); !stopping) return stopping;
  return control.wait();
}

/// True if an axis that should turn, or its target, has moved.
bool has_turned(const AxisNumbers& speeds, const msg::GetAngles& before,
                const msg::GetAngles& after) {
  constexpr double noise = 0.05;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (speeds[i].value_or(0) == 0) continue;
    const auto& from = before.axes[i];
    const auto& to = after.axes[i];
    if (std::abs(to.imu_angle.degrees() - from.imu_angle.degrees()) > noise ||
        std::abs(to.rc_target_angle.degrees() - from.rc_target_angle.degrees()) > noise) {
      return true;
    }
  }
  return false;
}

/// After this time, a SpeedControl has checked that the camera turns.
constexpr std::chrono::seconds long_enough{1};

/// Returns a warning about turns that twist cables.
std::string cables_text(const SpeedCommand& command) {
  constexpr double half_turn = 180;
  std::string result;
  for (std::size_t i = 0; command.time && i < axis_names.size(); ++i) {
    const double seconds = std::chrono::duration<double>(*command.time).count();
    const double way = std::abs(command.speeds[i].value_or(0)) * seconds;
    if (way <= half_turn) continue;
    result += fmt::format(" Watch the cables: {} turns by {:.0f} deg.", axis_names[i], way);
  }
  return result;
}

int turn_at_speed(const SpeedCommand& command, const CommandContext& context) {
  require_an_axis(command.speeds);
  Axes<msg::ControlSpeed> speed;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (command.speeds[i])
      speed[i] = to_speed(*command.speeds[i], std::string("--") + axis_names[i]);
  }
  if (!command.time && !is_terminal(stdin)) {
    throw CommandError("without a terminal, say how long to turn: --for TIME", wrong_usage);
  }
  MovingGimbal gimbal(context.gimbal);
  arm(command.arming,
      fmt::format("The camera turns at {}, {}.{}", axes_text(command.speeds, "deg/s"),
                  command.time ? "for " + duration_text(*command.time) : "until Ctrl-C is pressed",
                  cables_text(command)));
  const auto before = value_of(Result<msg::GetAngles>(gimbal.client().get_angles()));
  gimbal.begins_to_move(AfterStop::remove_timeout);
  const auto start = Clock::now();
  Result<void> turned;
  {
    SpeedControl control(gimbal.client(), {.ends_when_stopped = true});
    turned = turn(gimbal, control, speed, command.time);
  }
  if (!turned) gimbal.give_up(turned.error());
  gimbal.has_stopped();
  // Ctrl-C is the usual end of a motion without a duration.
  if (gimbal.must_stop() && (command.time || !was_interrupted_by_key())) gimbal.give_up({});
  const bool turns = !(speed == Axes<msg::ControlSpeed>{});
  if (turns && Clock::now() - start < long_enough + StopOptions{}.rest) {
    const auto after = value_of(Result<msg::GetAngles>(gimbal.client().get_angles()));
    if (!has_turned(command.speeds, before, after)) {
      throw CommandError("nothing shows that the camera has turned; it stands still", cannot_tell);
    }
  }
  remark("The camera has stopped.\n");
  return success;
}

}  // namespace

void add_speed(CLI::App& app, CommandContext& context) {
  const Subcommand<SpeedCommand> command(app, context, "speed",
                                         "Turn the camera at a speed for a time");
  auto& options = command.options();
  add_axis_options(*command, options.speeds, "Speed", "deg/s");
  add_duration(*command, "--for", options.time,
               "How long to turn: 500ms, 2s, 1m. In a terminal, the default is until Ctrl-C");
  command->footer(
      "Other axes hold still. The camera stops when the time is over and after Ctrl-C; if the "
      "command or its terminal dies, a guard process stops it. If the line is lost, firmware "
      "from 2.61 on ends serial control after half a second, and RC takes over; with older "
      "firmware the camera stops at an angle half a second ahead. After a signal, the stop may "
      "take 8 s; then, or after a second Ctrl-C at least half a second later, the guard takes "
      "over.\n"
      "\n"
      "Example:\n"
      "  sbgc speed --yaw 5 --for 2s\n"
      "\n"
      "The exit status is 0 if the camera turned and has stopped, 1 if not, 2 for wrong usage, 3 "
      "if it is unknown whether it turned, 130 if Ctrl-C or another signal ended it early.");
  command.runs(turn_at_speed);
}

}  // namespace sbgc::tools
