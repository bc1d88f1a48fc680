/// The subcommands of sbgc. Each adds itself to the command line and stores its exit status.
#pragma once

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Exit statuses of every subcommand.
enum ExitStatus : int {
  success = 0,
  failure = 1,      ///< the input could not be read, or does not describe what it should
  wrong_usage = 2,  ///< the command line is wrong
};

void add_decode(CLI::App& app, int& status);
void add_emulate(CLI::App& app, int& status);
void add_encode(CLI::App& app, int& status);
void add_ports(CLI::App& app, int& status);
void add_record(CLI::App& app, int& status);

}  // namespace sbgc::tools
