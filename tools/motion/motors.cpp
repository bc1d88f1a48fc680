// sbgc motors: turns the motors on or off.

#include <string>

#include <fmt/format.h>

#include <sbgc/messages/control.hpp>

#include "board/connection.hpp"
#include "command/arming.hpp"
#include "command/choices.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "motion/motor_state.hpp"

namespace sbgc::tools {

namespace {

struct MotorsCommand {
  std::string state{};  // "on", "off" or "toggle"
  Arming arming{};
};

int turn_motors(const MotorsCommand& command, const CommandContext& context) {
  Client client = connect(context.gimbal);
  const bool on =
      command.state == "toggle" ? !value_of(are_motors_on(client)) : command.state == "on";
  arm(command.arming, on ? "The motors turn on, and the camera jumps to its target angle."
                         : "The motors lose power, and the camera drops to its heavy side.");
  const CallOptions options = confirming(call_options(context.gimbal));
  Result<void> done = on ? Result<void>(client.call(msg::MotorsOn{}, options))
                         : Result<void>(client.call(msg::MotorsOff{}, options));
  if (!done && done.error().code == ErrorCode::board_error) {
    ClientError error = done.error();
    const std::string errors = current_errors(client);
    if (!errors.empty()) error.message += "; current errors of the board: " + errors;
    done = error;
  }
  value_of(done);
  remark("The motors are {}.\n", on ? "on" : "off");
  return success;
}

}  // namespace

void add_motors(CLI::App& app, CommandContext& context) {
  const Subcommand<MotorsCommand> command(app, context, "motors", "Turn the motors on or off");
  auto& options = command.options();
  command->add_option("state", options.state, "What the motors become")
      ->required()
      ->transform(one_of({"on", "off", "toggle"}));
  command->footer(
      "Hold the camera when you turn the motors off.\n"
      "\n"
      "The exit status is 0 if the board accepted it, 1 if not, 2 for wrong usage.");
  command.examples({"sbgc motors on"});
  command.runs(turn_motors);
}

}  // namespace sbgc::tools
