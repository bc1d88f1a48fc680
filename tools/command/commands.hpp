/// The subcommands of sbgc. Each adds itself to the command line and stores its exit status.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "command/command_error.hpp"
#include "command/gimbal_options.hpp"

namespace sbgc::tools {

/// Shared state of the subcommands.
struct CommandContext {
  int status = success;
  GimbalOptions gimbal{};
};

/// Returns what `sbgc` alone prints; it fits on a small terminal.
std::string front_page(const CLI::App& app);

/// Adds the subcommands that this program has: those of all_commands.cpp or offline_commands.cpp.
void add_commands(CLI::App& app, CommandContext& context);

/// If this process is a helper that a subcommand started, does its work and returns the exit
/// status.
std::optional<int> run_helper(int argc, char** argv);

/// The type of the functions that add a subcommand.
using AddCommand = void(CLI::App& app, CommandContext& context);
AddCommand add_ports, add_info, add_monitor, add_stream, add_plot, add_describe;
AddCommand add_params, add_vars;
AddCommand add_move, add_speed, add_jog, add_stop, add_motors, add_menu, add_bode;
AddCommand add_doctor, add_tune, add_calibrate, add_eeprom, add_files, add_script, add_module;
AddCommand add_reset;
AddCommand add_send, add_record, add_replay, add_decode, add_encode, add_emulate;
AddCommand add_bridge, add_gateway;
AddCommand add_shell, add_help, add_completion, add_manual;

}  // namespace sbgc::tools
