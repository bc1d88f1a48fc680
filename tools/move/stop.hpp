/// Stopping the camera whatever the state of the line.
#pragma once

#include <chrono>
#include <optional>

#include <CLI/CLI.hpp>

#include <sbgc/client/client.hpp>

#include "board/connection.hpp"
#include "move/owed_stop.hpp"

namespace sbgc::tools {

/// Adds --for.
void add_insistence(CLI::App& command, std::optional<std::chrono::milliseconds>& time);

/// Connects, and attempts the stop `owed` until it is done or `time` is over, which is 10 s by
/// default; 0 means one attempt. Reports its actions each second. Ctrl-C and SIGTERM end the
/// process. Returns the client. Throws CommandError if the camera may still be turning; at once if
/// there is no such device at the start, or no permission for it.
Client insist(const LineChoice& line, OwedStop owed, std::optional<std::chrono::milliseconds> time);

}  // namespace sbgc::tools
