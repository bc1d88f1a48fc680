/// How long tasks wait for a camera.
#pragma once

#include <sbgc/time.hpp>

namespace sbgc::detail {

/// How long a command of motion is repeated while nothing shows that the board has it. Shorter than
/// the rest that a stop waits for: a repeated command cannot follow a stop that has succeeded.
inline constexpr Duration patience = milliseconds(400);
/// How long a camera must stand still to have stopped.
inline constexpr Duration rest = milliseconds(500);

}  // namespace sbgc::detail
