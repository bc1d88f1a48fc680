/// The rates of data streams on the command line.
#pragma once

#include <chrono>
#include <cmath>

#include <CLI/CLI.hpp>

#include "command/number_range.hpp"

namespace sbgc::tools {

/// Adds --rate, in messages per second.
inline CLI::Option* add_rate(CLI::App& command, double& rate) {
  return command
      .add_option("--rate", rate,
                  "Messages per second; the board rounds the interval to milliseconds")
      ->type_name("HZ")
      ->check(number_range(0.02, 1000.0))
      ->capture_default_str();
}

inline std::chrono::milliseconds interval_of(double rate) {
  return std::chrono::milliseconds(std::lround(1000 / rate));
}

}  // namespace sbgc::tools
