// sbgc reset: restarts the board.

#include <chrono>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <poll.h>

#include <sbgc/messages/system.hpp>

#include "board/arming.hpp"
#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/commands.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

using Clock = std::chrono::steady_clock;

/// A port of the board itself disappears while it restarts.
constexpr std::chrono::seconds longest_restart{30};
/// Between attempts to connect: a port that is missing is reported at once.
constexpr std::chrono::milliseconds attempt_interval{100};

int reset(const Arming& arming, const CommandContext& context) {
  arm(arming,
      "The board restarts. The motors have no power until it is up again: the camera drops to its "
      "heavy side, then jumps to its target angle.");
  const LineChoice line = choose_line(context.gimbal);
  {
    Client client = value_of(Client::connect(line.address, line.options));
    value_of(Result<void>(client.call(msg::ResetRequest{}, call_options(context.gimbal))));
  }
  const Interruption interruption;
  ProgressBar bar;
  bar.show("the board restarts");
  const auto start = Clock::now();
  while (true) {
    const Result<Client> client = Client::connect(line.address, line.options);
    if (client) break;
    pollfd signal{interruption_descriptor(), POLLIN, 0};
    ::poll(&signal, 1, static_cast<int>(attempt_interval.count()));
    if (was_interrupted()) throw CommandError("interrupted; the board restarts", interrupted);
    if (Clock::now() - start > longest_restart) {
      throw CommandError(fmt::format("the board has not come back within {} s: {}",
                                     longest_restart.count(), client.error().message));
    }
  }
  bar.clear();
  remark("The board is back after {:.1f} s.\n",
         std::chrono::duration<double>(Clock::now() - start).count());
  return success;
}

}  // namespace

void add_reset(CLI::App& app, CommandContext& context) {
  auto* const command = app.add_subcommand("reset", "Restart the board")->group(heading::care);
  auto arming = std::make_shared<Arming>();
  add_arming(*command, *arming);
  add_gimbal_options(*command, context.gimbal);
  command->footer(
      "Waits until the board answers again. Settings that are not stored are lost.\n"
      "\n"
      "The exit status is 0 if the board is back, 1 if not, 2 for wrong usage, 130 after Ctrl-C.");
  command->callback([arming, &context] { context.status = reset(*arming, context); });
}

}  // namespace sbgc::tools
