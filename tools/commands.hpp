/// The subcommands of sbgc. Each adds itself to the command line and stores its exit status.
#pragma once

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Exit statuses of every subcommand.
enum ExitStatus : int {
  success = 0,
  failure = 1,      ///< the input cannot be read, or its content is invalid
  wrong_usage = 2,  ///< the command line is invalid
};

void add_decode(CLI::App& app, int& status);
void add_emulate(CLI::App& app, int& status);
void add_encode(CLI::App& app, int& status);
void add_ports(CLI::App& app, int& status);
void add_record(CLI::App& app, int& status);

}  // namespace sbgc::tools
