// sbgc reset: restarts the board.

#include <chrono>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <poll.h>

#include <sbgc/messages/system.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"

namespace sbgc::tools {

namespace {

struct ResetOptions {
  Arming arming{};
};

using Clock = std::chrono::steady_clock;

/// The delay between the board's confirmation and its restart, so that the confirmation arrives.
constexpr std::chrono::milliseconds restart_delay{200};
/// After this time the board answers only if it has restarted: the delay, and a margin.
constexpr std::chrono::milliseconds until_restart{500};
/// A USB port of the board itself disappears while it restarts.
constexpr std::chrono::seconds longest_restart{30};
/// The interval between attempts to connect: a missing port is reported at once.
constexpr std::chrono::milliseconds attempt_interval{100};

/// Asks the user, and restarts the board.
void begin_restart(const LineChoice& line, const Arming& arming, const CommandContext& context) {
  Client client = value_of(Client::connect(line.address, line.options));
  msg::ResetRequestExt request;
  request.confirm = msg::ResetOption::notify;
  request.delay_ms = msg::Milliseconds(static_cast<std::uint16_t>(restart_delay.count()));
  require_possible(client, request);
  arm(arming,
      "The board restarts. The motors have no power until it is up again: the camera drops to its "
      "heavy side, then jumps to its target angle.");
  const auto confirmed = client.call(request, call_options(context.gimbal));
  if (!confirmed && confirmed.error().code == ErrorCode::timeout) {
    throw CommandError("the board has not confirmed that it restarts: " +
                       confirmed.error().message);
  }
  value_of(confirmed);
}

/// Returns false if a signal interrupts the pause.
bool wait_for(std::chrono::milliseconds time) {
  pollfd signal{interruption_descriptor(), POLLIN, 0};
  ::poll(&signal, 1, static_cast<int>(time.count()));
  return !was_interrupted();
}

int reset_board(const ResetOptions& options, const CommandContext& context) {
  const LineChoice line = choose_line(context.gimbal);
  begin_restart(line, options.arming, context);
  const Interruption interruption;
  ProgressBar bar;
  bar.show("the board restarts");
  const auto start = Clock::now();
  for (auto wait = until_restart;; wait = attempt_interval) {
    if (!wait_for(wait)) throw CommandError("interrupted; the board restarts", interrupted);
    const Result<Client> client = Client::connect(line.address, line.options);
    if (client) break;
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
  const Subcommand<ResetOptions> command(app, context, "reset", "Restart the board");
  command->footer(
      "It waits until the board has restarted and answers again. Settings that are not stored "
      "are lost.\n"
      "\n"
      "The exit status is 0 if the board is back, 1 if not, 2 for wrong usage, 130 after Ctrl-C.");
  command.examples({"sbgc reset"});
  command.runs(reset_board);
}

}  // namespace sbgc::tools
