// sbgc stop: stops the camera. Never asks.

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "move/insistence.hpp"
#include "move/motor_state.hpp"

namespace sbgc::tools {

namespace {

struct StopCommand {
  std::optional<std::chrono::milliseconds> time{};
};

int stop_camera(const StopCommand& command, const CommandContext& context) {
  remark_in_background();
  Client client = insist(choose_line(context.gimbal), OwedStop(), command.time);
  const Result<bool> has_power = are_motors_on(client);
  remark("The camera has stopped{}.\n", !has_power   ? ""
                                        : *has_power ? "; its motors hold it"
                                                     : "; its motors are off");
  return success;
}

}  // namespace

void add_stop(CLI::App& app, CommandContext& context) {
  const Subcommand<StopCommand> command(app, context, "stop", "Stop the camera, without asking");
  add_insistence(*command, command.options().time);
  command->footer(
      "Commands speed 0 on all axes until the board has reported for half a second that no axis "
      "turns. While the board does not answer, the command retries. The motors keep their power. "
      "If the camera shakes or does not stop, use `sbgc motors off` or the battery switch: the "
      "camera then drops to its heavy side.\n"
      "\n"
      "The exit status is 0 if the camera has stopped, 1 if not or if something else turns it, 2 "
      "for wrong usage, 130 after Ctrl-C.");
  command.examples({"sbgc stop", "sbgc stop --for 1m"});
  command.runs(stop_camera);
}

}  // namespace sbgc::tools
