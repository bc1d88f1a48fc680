/// Completion scripts for shells.
#pragma once

#include <string>
#include <string_view>

namespace sbgc::tools {

/// The hidden subcommand that prints the candidates for the last of its arguments.
inline constexpr std::string_view complete_command = "__complete";
/// A candidate that stands for file names.
inline constexpr std::string_view files_directive = ":files";

/// Returns the script for "bash", "zsh" or "fish".
std::string_view completion_script(std::string_view shell);

}  // namespace sbgc::tools
