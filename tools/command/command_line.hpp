/// The parts of a command line, for the help, the manual and the completion; and its errors, with
/// suggestions.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Returns the subcommands that the help lists.
std::vector<const CLI::App*> subcommands_of(const CLI::App& command);

/// Returns the options without the positional arguments, in the order of their definition.
std::vector<const CLI::Option*> options_of(const CLI::App& command);

/// Returns the positional arguments in order.
std::vector<const CLI::Option*> arguments_of(const CLI::App& command);

/// Returns the subcommand with this name; null if there is none.
const CLI::App* find_subcommand(const CLI::App& command, const std::string& name);

/// True if the option takes a value.
bool takes_value(const CLI::Option& option);

/// Returns the values that an option of a choice accepts; empty for others.
std::vector<std::string> choices_of(const CLI::Option& option);

/// Returns what the value of an option or argument is called in the help: "FILE", "ADDRESS". It
/// tells the completion what to offer.
std::string value_name(const CLI::Option& option);

/// Returns what a positional argument is called in the help: what its value is called, or its own
/// name in capital letters.
std::string argument_name(const CLI::Option& argument);

/// Returns the subcommand that the command line chose, at the deepest level; `app` if none.
const CLI::App& chosen_command(const CLI::App& app);

/// For example "sbgc params get".
std::string full_name(const CLI::App& command);

/// Reports an error of the command line on standard error. Returns the exit status.
int report_usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The same for an error with this message.
int report_usage_error(const CLI::App& command, const std::string& problem);

}  // namespace sbgc::tools
