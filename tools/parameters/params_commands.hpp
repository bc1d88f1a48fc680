/// The subcommands of `sbgc params`.
#pragma once

#include <CLI/CLI.hpp>

namespace sbgc::tools {

struct CommandContext;

void add_params_show(CLI::App& params, CommandContext& context);
void add_params_get(CLI::App& params, CommandContext& context);
void add_params_set(CLI::App& params, CommandContext& context);
void add_params_profiles(CLI::App& params, CommandContext& context);
void add_params_rename(CLI::App& params, CommandContext& context);
void add_params_backup(CLI::App& params, CommandContext& context);
void add_params_restore(CLI::App& params, CommandContext& context);
void add_params_diff(CLI::App& params, CommandContext& context);
void add_params_reset(CLI::App& params, CommandContext& context);

}  // namespace sbgc::tools
