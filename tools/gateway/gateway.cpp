// sbgc gateway: many gimbals, on a message broker and for Prometheus.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"

namespace sbgc::tools {

namespace {

struct GatewayOptions {
  std::string config;
};

int run_gateway(const GatewayOptions& options) {
  const Fleet fleet = read_fleet(options.config);
  Io io(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
  std::vector<std::unique_ptr<Gimbal>> gimbals;
  for (const FleetGimbal& one : fleet.gimbals) {
    gimbals.push_back(std::make_unique<Gimbal>(io, one));
  }
  // Metrics and the broker register their handlers here, before the gimbals start.
  const Interruption interruption;
  for (const auto& gimbal : gimbals) gimbal->start();
  // Waits for a signal.
  for (const auto& gimbal : gimbals) gimbal->close();
  return success;
}

}  // namespace

void add_gateway(CLI::App& app, CommandContext& context) {
  const Subcommand<GatewayOptions> command(app, context, "gateway",
                                           "Put many gimbals on a message broker and Prometheus");
  auto& options = command.options();
  command->add_option("--config", options.config, "The fleet, in TOML")
      ->type_name("FILE")
      ->required();
  command.runs(run_gateway);
}

}  // namespace sbgc::tools
