/// Stopping the camera however the line is.
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

/// Connects, and makes attempts at `owed` until it is done or for `time`, which is 10 s if it is
/// not given; 0 is one attempt. Says each second what it does. Ctrl-C and SIGTERM end the process.
/// Returns the client. Throws CommandError if the camera may still turn; at once if there is no
/// such device, or no permission for it.
Client insist(const LineChoice& line, OwedStop owed, std::optional<std::chrono::milliseconds> time);

}  // namespace sbgc::tools
