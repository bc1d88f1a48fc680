/// Passwords, which come from a file or a terminal, and never from the command line.
#pragma once

#include <string>

namespace sbgc::tools {

/// Returns the password from a file that only its owner can access, or with "-", prompts for it on
/// the terminal, without an echo. `whose` completes the prompt "Password of ...". Throws
/// CommandError, which reveals nothing of the password.
std::string read_password(const std::string& file, const std::string& whose);

}  // namespace sbgc::tools
