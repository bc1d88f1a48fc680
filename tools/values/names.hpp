/// The names that a user can type, for the completion of the shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// Returns the names of all messages to the board and of their commands, sorted.
std::vector<std::string> message_names();

/// Returns the paths of the fields of a message to the board; none if there is no such message.
std::vector<std::string> field_names(std::string_view message);

/// Returns the paths of all parameters.
std::vector<std::string> parameter_names();

/// Returns the names of all adjustable variables.
std::vector<std::string> variable_names();

/// Returns the words that `sbgc describe` explains.
std::vector<std::string> described_words();

}  // namespace sbgc::tools
