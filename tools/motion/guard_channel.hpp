/// The channel from a command to its guard.
#pragma once

#include "motion/guard.hpp"

namespace sbgc::tools {

/// The name of the guard process.
inline constexpr const char* guard_name = "sbgc-guard";

struct GuardedLine {
  int descriptor = -1;
  AfterStop after{};
};

/// Sends a line; the sender keeps its descriptor. Returns false on an error, which is in errno.
bool send_line(int channel, const GuardedLine& line);

/// Waits for lines until the other side has closed the channel or ended. Returns the last line; its
/// descriptor is the receiver's, or -1 if none came.
GuardedLine receive_line(int channel);

}  // namespace sbgc::tools
