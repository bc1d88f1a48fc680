// sbgc stop: stops the camera. Never asks.

#include <chrono>
#include <cstddef>
#include <thread>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/realtime.hpp>

#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "motion/motor_state.hpp"

namespace sbgc::tools {

namespace {

/// Throws CommandError if the camera turns again soon: something else controls it.
void require_rest(Client& client) {
  constexpr std::chrono::milliseconds interval{100};
  constexpr int looks = 5;
  for (int i = 0; i < looks; ++i) {
    std::this_thread::sleep_for(interval);
    const auto state = value_of(Result<msg::GetAngles>(client.get_angles()));
    for (std::size_t axis = 0; axis < state.axes.size(); ++axis) {
      if (state.axes[axis].rc_speed.raw() == 0) continue;
      throw CommandError(
          "the camera stopped and turns again: another program, RC or a script controls it");
    }
  }
}

int stop_camera(const NoOptions& /*none*/, const CommandContext& context) {
  remark_in_background();
  Client client = connect(context.gimbal);
  value_of(client.stop());
  require_rest(client);
  const Result<bool> has_power = are_motors_on(client);
  remark("The camera has stopped{}.\n", !has_power   ? ""
                                        : *has_power ? "; its motors hold it"
                                                     : "; its motors are off");
  return success;
}

}  // namespace

void add_stop(CLI::App& app, CommandContext& context) {
  const Subcommand<NoOptions> command(app, context, "stop", "Stop the camera, without asking");
  command->footer(
      "Commands speed 0 on all axes until the board reports that no axis turns, and watches it for "
      "half a second, in case something else turns the camera. The motors keep "
      "their power. If the camera shakes or does not stop, use `sbgc motors off` or the battery "
      "switch: the camera then drops to its heavy side.\n"
      "\n"
      "The exit status is 0 if the camera has stopped, 1 if not, 2 for wrong usage.");
  command.examples({"sbgc stop"});
  command.runs(stop_camera);
}

}  // namespace sbgc::tools
