// sbgc replay: serves a capture in place of a board.

#include <string>

#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/signal_set.hpp>

#include <sbgc/io/replay.hpp>

#include "bytes/replay_ports.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/number_range.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "share/places.hpp"

namespace sbgc::tools {

namespace {

/// TCP and UDP each have as many places.
constexpr std::size_t places_of_each = 16;

struct ReplayOptions {
  std::string file;
  double speed = 1;
  Places places{};
};

int run_replay(const ReplayOptions& options) {
  asio::io_context loop(1);
  io::OpenResult capture =
      io::open_replay(loop.get_executor(), options.file, io::ReplayTiming::original, options.speed);
  if (!capture) throw CommandError(without_period(capture.error.message));
  remark_in_background();
  const auto log = [](const std::string& text) { remark("sbgc: {}\n", text); };
  asio::signal_set signals(loop);
  for (const int signal : asking_signals()) signals.add(signal);
  signals.async_wait([&](std::error_code error, int) {
    if (!error) loop.stop();
  });
  ReplayPorts ports(
      std::move(capture.transport),
      [&] {
        // The hosts get their last bytes first.
        asio::post(loop, [&] { loop.stop(); });
      },
      log);
  const auto endpoints =
      open_places(loop.get_executor(), ports, options.places, places_of_each, "replay", {log, log});
  loop.run();
  finish_stdout();
  return success;
}

}  // namespace

void add_replay(CLI::App& app, CommandContext& context) {
  const Subcommand<ReplayOptions> command(app, context, "replay",
                                          "Serve a capture in place of a board");
  auto& options = command.options();
  command->add_option("file", options.file, "A capture, or the raw bytes of a board")
      ->type_name("FILE")
      ->required();
  command->add_option("--speed", options.speed, "Speed relative to the recording")
      ->check(number_range(0.001, 1000.0))
      ->capture_default_str();
  add_places(*command, options.places);
  command->footer(
      "Programs that connect get the bytes of the board at the recorded times, counted from the "
      "first connection; their own bytes are ignored. By default it opens a pseudo-terminal. For "
      "sbgc itself, the address capture:FILE does the same. The exit status is 0 after the end "
      "of the capture or Ctrl-C, 1 if the file or a place cannot be opened, 2 for wrong usage.");
  command.examples({"sbgc replay capture --tcp 5000"});
  command.runs([](ReplayOptions& chosen) {
    if (chosen.places.empty()) chosen.places.terminal = true;
    return run_replay(chosen);
  });
}

}  // namespace sbgc::tools
