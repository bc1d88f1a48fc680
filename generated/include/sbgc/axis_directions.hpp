// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Which way angles and speeds about each axis of the gimbal count, as the person behind the camera
/// sees it.
#pragma once

#include <string_view>

#include <sbgc/types.hpp>

namespace sbgc {

/// Where positive and negative values turn the camera, such as "down" and "up"; "" if it is not
/// known.
struct AxisDirection {
  std::string_view positive{};
  std::string_view negative{};

  friend constexpr bool operator==(const AxisDirection&, const AxisDirection&) = default;
};

inline constexpr Axes<AxisDirection> axis_directions{
    .roll = {"", ""},
    .pitch = {"down", "up"},
    .yaw = {"right", "left"},
};

}  // namespace sbgc
