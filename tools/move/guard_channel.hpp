/// The channel from a command to its guard.
#pragma once

#include <sbgc/client/parameters.hpp>

#include "move/guard.hpp"

namespace sbgc::tools {

/// The name of the guard process.
inline constexpr const char* guard_name = "sbgc-guard";

struct GuardedLine {
  int descriptor = -1;
  AfterStop after{};
  ParameterSet restored{};  ///< what the board shall have after the stop
};

/// Sends a line; the sender keeps its descriptor. Returns false on an error, which is in errno.
bool send_line(int channel, const GuardedLine& line);

/// Sends parameters that the board shall have after the stop. Returns false on an error, which is
/// in errno.
bool send_parameters(int channel, const Parameters& parameters);

/// Waits for lines and parameters until the other side has closed the channel or ended. Returns the
/// last line, with all parameters; its descriptor is the receiver's, or -1 if none came.
GuardedLine receive_line(int channel);

}  // namespace sbgc::tools
