// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The positive directions of angles and speeds about each axis, as the person behind the camera
/// sees it.
#pragma once

#include <sbgc/types.hpp>

namespace sbgc {

/// The directions of positive and negative values, such as "down" and "up"; "" if it is not
/// known.
struct AxisDirection {
  const char* positive = "";
  const char* negative = "";
};

inline constexpr Axes<AxisDirection> axis_directions{
    .roll = {"", ""},
    .pitch = {"down", "up"},
    .yaw = {"right", "left"},
};

}  // namespace sbgc
