// sbgc motors: turns the motors on or off.

#include <chrono>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/meta/control.hpp>

#include "board/connection.hpp"
#include "command/common_options.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "move/moving_gimbal.hpp"
#include "move/stop.hpp"

namespace sbgc::tools {

namespace {

struct MotorsCommand {
  std::string state{};  // "on", "off" or "toggle"
  Arming arming{};
  std::optional<std::chrono::milliseconds> time{};
};

void turn_on(const MotorsCommand& command, Client& client, const GimbalOptions& gimbal) {
  arm(command.arming, "The motors turn on, and the camera jumps to its target angle.");
  const Result<void> done = client.call(msg::MotorsOn{}, confirming(call_options(gimbal)));
  if (!done && done.error().code == ErrorCode::board_error) {
    ClientError error = done.error();
    const std::string errors = current_errors(client);
    if (!errors.empty()) error.message += "; current errors of the board: " + errors;
    fail(error);
  }
  value_of(done);
  remark("The motors are on.\n");
}

void turn_off(const MotorsCommand& command, const LineChoice& line) {
  arm(command.arming, "The motors lose power, and the camera drops to its heavy side.");
  const msg::MotorsOff request;
  const MessageType& type = *find_message(Meta<msg::MotorsOff>::info.name);
  insist(line, OwedStop(AnyMessage(type, &request)), command.time);
  remark("The motors are off.\n");
}

int turn_motors(const MotorsCommand& command, const CommandContext& context) {
  const LineChoice line = choose_line(context.gimbal);
  if (command.state != "off") {
    Client client = value_of(Client::connect(line.address, line.options));
    if (command.state == "on" || !value_of(are_motors_on(client))) {
      turn_on(command, client, context.gimbal);
      return success;
    }
  }
  turn_off(command, line);
  return success;
}

}  // namespace

void add_motors(CLI::App& app, CommandContext& context) {
  const Subcommand<MotorsCommand> command(app, context, "motors", "Turn the motors on or off");
  auto& options = command.options();
  command->add_option("state", options.state, "The new state of the motors")
      ->required()
      ->transform(one_of({"on", "off", "toggle"}));
  add_insistence(*command, options.time);
  command->footer(
      "Hold the camera when you turn the motors off. While the board does not answer, the "
      "command retries to turn them off, for the time of --for.\n"
      "\n"
      "The exit status is 0 if the board accepted it, 1 if not, 2 for wrong usage, 130 after "
      "Ctrl-C.");
  command.examples({"sbgc motors on"});
  command.runs(turn_motors);
}

}  // namespace sbgc::tools
