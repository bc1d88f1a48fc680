/// Prints the frames of a line, decoded, on standard error.
#pragma once

#include "board/connection.hpp"

namespace sbgc::tools {

/// Returns `inner`, or nothing, followed by an observer that prints each frame.
Wrap with_frame_printer(Wrap inner);

}  // namespace sbgc::tools
