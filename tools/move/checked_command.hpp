/// Menu actions that a command of ours does with checks.
#pragma once

#include <string>
#include <vector>

#include <sbgc/messages/control.hpp>

namespace sbgc::tools {

/// Returns the words of the command that does the same as a menu action; none if there is none.
std::vector<std::string> checked_command(msg::MenuCommand action);

}  // namespace sbgc::tools
