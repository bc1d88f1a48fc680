/// Shared code of motion tasks: timeouts for the camera, and the timeout of serial control.
#pragma once

#include <chrono>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/result.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// A motion command is repeated for this long while nothing shows that the board has received it.
/// Shorter than the rest after a stop: a repetition cannot follow a successful stop.
inline constexpr Duration patience = milliseconds(400);
/// A camera that stands still for this long has stopped.
inline constexpr Duration rest = milliseconds(500);

/// Returns the request that sets the timeout and changes as little else as possible; its values
/// come from the board, so do not validate them.
Task<Result<msg::ControlConfig>> control_timeout_request(std::chrono::milliseconds timeout);

}  // namespace sbgc::detail
