/// The request that sets the timeout of serial control.
#pragma once

#include <chrono>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/result.hpp>

namespace sbgc::detail {

/// Returns the request that sets the timeout and changes as little else as possible; its values
/// come from the board, so do not validate them.
Task<Result<msg::ControlConfig>> control_timeout_request(std::chrono::milliseconds timeout);

}  // namespace sbgc::detail
