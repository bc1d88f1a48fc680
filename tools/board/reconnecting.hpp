/// Connecting to the gimbal that the options name, again and again.
#pragma once

#include <sbgc/client/client.hpp>

#include "board/connection.hpp"

namespace sbgc::tools {

/// Connects to the gimbal like connect(), but to a client that connects again by itself. `adjust`
/// changes the options of the library. Throws CommandError.
Client connect_for_long(const GimbalOptions& options,
                        const std::function<void(ConnectOptions&)>& adjust = {});

/// True if the address is that of a capture, which ends but is never lost.
bool is_replay(const GimbalOptions& options);

/// Writes a line on standard error for each change of the connection, as long as the result lives.
Subscription report_changes(Client& client);

}  // namespace sbgc::tools
