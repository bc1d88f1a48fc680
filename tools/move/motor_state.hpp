/// Whether the motors have power, and what is wrong with the board.
#pragma once

#include <string>

#include <sbgc/client/client.hpp>

namespace sbgc::tools {

/// Asks the board whether its motors are on.
Result<bool> are_motors_on(Client& client);

/// Ends the command unless the motors are on: without them, the board accepts every motion and the
/// camera does not turn. Throws CommandError.
void require_motors(Client& client);

/// Returns the names of the current errors of the board, such as "ERR_LOW_BAT1"; "" if there
/// are none or it does not tell.
std::string current_errors(Client& client);

}  // namespace sbgc::tools
