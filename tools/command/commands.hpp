/// The subcommands of sbgc. Each adds itself to the command line and stores its exit status.
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "board/gimbal_options.hpp"
#include "command/command_error.hpp"

namespace sbgc::tools {

/// What the subcommands share.
struct CommandContext {
  int status = success;
  GimbalOptions gimbal{};
};

/// The headings of the subcommands in the help.
namespace heading {
inline constexpr const char* look = "Look";
inline constexpr const char* parameters = "Parameters";
inline constexpr const char* move = "Move";
inline constexpr const char* care = "Care";
inline constexpr const char* bytes = "Bytes";
inline constexpr const char* share = "Share";
inline constexpr const char* shell = "Shell";
}  // namespace heading

/// Adds the subcommands that this program has: those of all_commands.cpp or offline_commands.cpp.
void add_commands(CLI::App& app, CommandContext& context);

/// If this process is a helper that a subcommand started, does its work and returns the exit
/// status.
std::optional<int> run_helper(int argc, char** argv);

void add_ports(CLI::App& app, CommandContext& context);
void add_info(CLI::App& app, CommandContext& context);
void add_monitor(CLI::App& app, CommandContext& context);
void add_stream(CLI::App& app, CommandContext& context);
void add_describe(CLI::App& app, CommandContext& context);
void add_params(CLI::App& app, CommandContext& context);
void add_vars(CLI::App& app, CommandContext& context);
void add_move(CLI::App& app, CommandContext& context);
void add_speed(CLI::App& app, CommandContext& context);
void add_jog(CLI::App& app, CommandContext& context);
void add_stop(CLI::App& app, CommandContext& context);
void add_motors(CLI::App& app, CommandContext& context);
void add_menu(CLI::App& app, CommandContext& context);
void add_calibrate(CLI::App& app, CommandContext& context);
void add_eeprom(CLI::App& app, CommandContext& context);
void add_files(CLI::App& app, CommandContext& context);
void add_script(CLI::App& app, CommandContext& context);
void add_reset(CLI::App& app, CommandContext& context);
void add_send(CLI::App& app, CommandContext& context);
void add_record(CLI::App& app, CommandContext& context);
void add_replay(CLI::App& app, CommandContext& context);
void add_decode(CLI::App& app, CommandContext& context);
void add_encode(CLI::App& app, CommandContext& context);
void add_emulate(CLI::App& app, CommandContext& context);
void add_bridge(CLI::App& app, CommandContext& context);
void add_completion(CLI::App& app, CommandContext& context);
void add_manual(CLI::App& app, CommandContext& context);

}  // namespace sbgc::tools
