// sbgc move: turns the camera to angles.

#include <cstddef>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/realtime.hpp>

#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "move/move_way.hpp"
#include "move/moving_gimbal.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

struct MoveCommand {
  AxisNumbers angles{};
  double speed = 10;  // deg/s
  bool relative = false;
  bool wait = false;
  Arming arming{};
};

/// Returns the targets; relative angles are added to the measured ones.
MoveTarget target_of(const MoveCommand& command, const Axes<msg::Angle14>& angles) {
  MoveTarget target;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (!command.angles[i]) continue;
    const std::string option = std::string("--") + axis_names[i];
    const msg::Angle14 angle = to_angle(*command.angles[i], option);
    // It would equal two turns in the other direction.
    if (command.relative && angle.raw() == std::numeric_limits<msg::Angle14::raw_type>::min()) {
      throw CommandError(option + ": a relative angle is less than two turns", wrong_usage);
    }
    target[i] = command.relative ? angle_after(angles[i], angle) : angle;
  }
  return target;
}

std::string angles_text(const MoveTarget& target, const MoveProgress& progress) {
  std::string text;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (!target[i]) continue;
    if (!text.empty()) text += ", ";
    text += axis_text(i, fmt::format("{:.1f}", progress.angles[i].degrees()), "deg");
  }
  return text;
}

/// Determines the target, and asks. Returns the target that the question names.
MoveTarget ask(const MoveCommand& command, Client& client) {
  const Axes<msg::Angle14> now = angles_of(value_of(Result<msg::GetAngles>(client.get_angles())));
  const MoveTarget target = target_of(command, now);
  arm(command.arming,
      fmt::format("The camera turns to {}, at up to {} deg/s.{}", target_text(target, now),
                  command.speed, cable_warning(target, now)));
  return target;
}

void move_and_wait(const MoveCommand& command, const CommandContext& context, MoveOptions options) {
  MovingGimbal gimbal(context.gimbal);
  const MoveTarget target = ask(command, gimbal.client());
  const auto state = value_of(Result<msg::GetAngles>(gimbal.client().get_angles()));
  options.timeout = time_for_move(target, angles_of(state), options.speed);
  ProgressBar bar;
  options.progress = [&](const MoveProgress& progress) {
    bar.show(angles_text(target, progress));
    return !gimbal.must_stop();
  };
  gimbal.begins_to_move(AfterStop::nothing);
  options.stop_on_failure = false;  // give_up() stops it
  const Result<MoveProgress> moved = gimbal.client().move_to(target, options);
  if (!moved) gimbal.give_up(moved.error());
  gimbal.has_stopped();
  bar.clear();
  remark("The camera is at {}.\n", angles_text(target, *moved));
}

/// Without a guard: the camera stops at its target by itself.
void begin_to_move(const MoveCommand& command, const CommandContext& context, MoveOptions options) {
  Client client = connect(context.gimbal);
  require_motors(client);
  const MoveTarget target = ask(command, client);
  options.timeout = std::chrono::seconds(3);
  const MoveProgress begun = value_of(client.begin_move(target, options));
  remark("{}\n", begun.is_close ? "The camera is there." : "The camera turns to its target.");
}

int move(const MoveCommand& command, const CommandContext& context) {
  require_an_axis(command.angles);
  MoveOptions options;
  options.speed = to_speed(command.speed, "--speed");
  if (options.speed.raw() <= 0) {
    throw CommandError("--speed must be positive; 0 would select the speed in the parameters",
                       wrong_usage);
  }
  static_cast<void>(target_of(command, {}));  // detects angles out of range before asking
  if (command.wait) {
    move_and_wait(command, context, options);
  } else {
    begin_to_move(command, context, options);
  }
  return success;
}

}  // namespace

void add_move(CLI::App& app, CommandContext& context) {
  const Subcommand<MoveCommand> command(app, context, "move", "Turn the camera to angles");
  auto& options = command.options();
  add_axis_options(*command, options.angles, "Angle", "deg");
  command->add_option("--speed", options.speed, "The highest speed, in degrees per second")
      ->transform(number_with_unit("deg/s"))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_flag("--relative", options.relative,
                    "Count the angles from the current ones; less than two turns");
  command->add_flag("--wait", options.wait,
                    "Wait until the camera is there. Ctrl-C stops the camera, as in `sbgc "
                    "speed`; if the command dies, a guard process stops it");
  command->footer(
      "The question names the target and the direction, and warns of cables before more than "
      "half a turn. Other axes stay under, or return to, RC control. Without --wait, the command "
      "ends as soon as the camera turns; the camera stops at its target, and `sbgc stop` stops "
      "it earlier.\n"
      "\n"
      "Examples:\n"
      "  sbgc move --pitch 30 --wait\n"
      "  sbgc move --tilt 30down --pan 45left\n"
      "  sbgc move --yaw 5 --relative --speed 2 --yes\n"
      "\n"
      "The exit status is 0 if the camera is at its target, or without --wait, if it turns to "
      "the target; 1 if not; 2 for wrong usage; 130 if Ctrl-C stopped it.");
  command.runs(move);
}

}  // namespace sbgc::tools
