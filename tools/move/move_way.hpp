/// The path of a move: its end, the directions of the turns, and its duration.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>

namespace sbgc::tools {

/// Returns the target that is `way` from an angle. Angles wrap after two turns in each direction,
/// as on boards: 2 degrees after 719 is -719.
msg::Angle14 angle_after(msg::Angle14 from, msg::Angle14 way);

/// Describes the target and the directions of the turns: "10 deg down (now 40 down: up by 30), yaw
/// 0 deg (now 30 right: left by 30)". `when` is the time of `angles`.
std::string target_text(const MoveTarget& target, const Axes<msg::Angle14>& angles,
                        std::string_view when = "now");

/// Returns sentences that begin with a space about axes that turn by more than half a turn, or to
/// angles beyond it; "" if there are none.
std::string cable_warning(const MoveTarget& target, const Axes<msg::Angle14>& angles);

/// Returns enough time for the axis with the longest way.
std::chrono::milliseconds time_for_move(const MoveTarget& target, const Axes<msg::Angle14>& angles,
                                        msg::ControlSpeed speed);

/// Returns the measured angles of an answer.
Axes<msg::Angle14> angles_of(const msg::GetAngles& state);

}  // namespace sbgc::tools
