/// Errors of the command line, with suggestions.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Returns the subcommand that the command line chose, at the deepest level; `app` if none.
const CLI::App& chosen_command(const CLI::App& app);

/// For example "sbgc params get".
std::string full_name(const CLI::App& command);

/// Reports an error of the command line on standard error. Returns the exit status.
int report_usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The same for an error with this message.
int report_usage_error(const CLI::App& command, const std::string& problem);

}  // namespace sbgc::tools
