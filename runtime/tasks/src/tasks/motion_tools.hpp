/// What tasks of motion share: how long they wait for a camera, and the timeout of serial control.
#pragma once

#include <chrono>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/result.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// How long a command of motion is repeated while nothing shows that the board has it. Shorter than
/// the rest that a stop waits for: a repeated command cannot follow a stop that has succeeded.
inline constexpr Duration patience = milliseconds(400);
/// How long a camera must stand still to have stopped.
inline constexpr Duration rest = milliseconds(500);

/// Returns the request that sets the timeout and changes as little else as possible; its values
/// come from the board, so do not validate them.
Task<Result<msg::ControlConfig>> control_timeout_request(std::chrono::milliseconds timeout);

}  // namespace sbgc::detail
