// sbgc gateway: many gimbals, on a message broker and for Prometheus.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poll.h>

#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "gateway/broker.hpp"
#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"
#include "gateway/metrics.hpp"
#include "gateway/reports.hpp"

namespace sbgc::tools {

namespace {

constexpr unsigned most_io_threads = 8;
/// With the prefix of the command, 500 bytes. File content can be longer.
constexpr std::size_t longest_error = 480;
/// The time for the stops, and for reporting them.
constexpr std::chrono::seconds gateway_bound = stop_bound + std::chrono::seconds(4);

struct GatewayOptions {
  std::string config{};
  bool only_checks = false;
  bool shows_schema = false;
};

void report_on(Gimbal& gimbal) {
  gimbal.on_status([&gimbal, last = std::string()](const GimbalStatus& status) mutable {
    const std::string details =
        status.link == GimbalLink::online
            ? fmt::format("board {}, firmware {}", status.board, status.firmware)
            : abridged(status.reason, longest_error);
    const std::string text = fmt::format("{}: {}", name(status.link), details);
    if (std::exchange(last, text) != text) remark("sbgc: {} is {}\n", gimbal.name(), text);
  });
  gimbal.on_event([&gimbal](const GimbalEvent& event, Gimbal::Time) {
    remark("sbgc: {}: {}: {}\n", gimbal.name(), event.kind, event.message);
  });
}

void wait_for_signal() {
  pollfd signal{.fd = interruption_descriptor(), .events = POLLIN, .revents = 0};
  while (!was_interrupted()) ::poll(&signal, 1, -1);
}

/// Serves the fleet until a signal arrives, or both halves have failed.
int serve_fleet(Io& io, const Fleet& fleet, const std::vector<std::unique_ptr<Gimbal>>& gimbals) {
  remark_in_background();
  std::signal(SIGPIPE, SIG_IGN);
  const MustFinish stopping(gateway_bound, "gimbals may still turn");
  // Both halves register their handlers before the gimbals start.
  std::optional<Broker> broker;
  if (fleet.broker) broker.emplace(fleet, gimbals);
  std::optional<Metrics> metrics;
  if (fleet.metrics) metrics.emplace(*fleet.metrics, gimbals, broker ? &*broker : nullptr);
  if (metrics) {
    metrics->start();
    remark("sbgc: metrics at {}\n", metrics->address());
    if (metrics->is_open()) remark("sbgc: warning: metrics are open to any other machine\n");
  }
  for (const auto& gimbal : gimbals) gimbal->start();
  if (broker) broker->start();
  wait_for_signal();
  metrics.reset();
  if (broker) broker->close();
  for (const auto& gimbal : gimbals) gimbal->close();
  io.finish();  // what still completes uses the broker and the gimbals
  // People must choose a gateway; a service manager must not restart this one.
  if (broker && broker->has_duplicate()) return wrong_usage;
  return broker && (!broker->failure().empty() || broker->has_left_moving()) ? failure : success;
}

int run_fleet(const GatewayOptions& options) {
  const Fleet fleet = read_fleet(options.config);
  if (options.only_checks) {
    remark("{}: {}\n", fleet.name, counted(fleet.gimbals.size(), "gimbal"));
    return success;
  }
  Io io(std::clamp(std::thread::hardware_concurrency(), 2U, most_io_threads));
  std::vector<std::unique_ptr<Gimbal>> gimbals;
  for (const FleetGimbal& one : fleet.gimbals) {
    gimbals.push_back(std::make_unique<Gimbal>(io, one));
    report_on(*gimbals.back());
  }
  return serve_fleet(io, fleet, gimbals);
}

int run_gateway(const GatewayOptions& options) {
  if (options.shows_schema) {
    fmt::print("{}\n", detail::json_text(gateway_schema(), 1));
    return success;
  }
  if (options.config.empty()) throw CommandError("--config is missing", wrong_usage);
  try {
    return run_fleet(options);
  } catch (const CommandError& error) {
    throw CommandError(abridged(error.what(), longest_error), error.status());
  } catch (const std::runtime_error& error) {
    throw CommandError(abridged(error.what(), longest_error));
  }
}

}  // namespace

void add_gateway(CLI::App& app, CommandContext& context) {
  const Subcommand<GatewayOptions> command(
      app, context, "gateway", "Connect many gimbals to a message broker and Prometheus");
  auto& options = command.options();
  command->add_option("--config", options.config, "The fleet, in TOML")->type_name("FILE");
  command->add_flag("--check", options.only_checks,
                    "Only check the file and the files that it names");
  command->add_flag("--schema", options.shows_schema, "Print the JSON Schema of all payloads");
  command->footer(
      "It connects to the gimbals that the file names, and reconnects lost lines. [broker] and "
      "[metrics] are both optional. Ctrl-C or another signal ends it, but it first stops gimbals "
      "that commands have set in motion, for at most 8 seconds; a second Ctrl-C, at least half a "
      "second later, ends it at once. docs/21-many-gimbals.md has the details.\n"
      "\n"
      "The exit status is 0 if a signal ended it, 1 if the file is wrong, it could not start, "
      "the connection to the broker has failed or a gimbal may still turn, 2 for wrong usage or "
      "if another gateway serves the fleet.");
  command.examples({"sbgc gateway --config fleet.toml --check", "sbgc gateway --schema"});
  command.runs(run_gateway);
}

}  // namespace sbgc::tools
