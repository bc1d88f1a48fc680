/// How long a motion to angles may take.
#pragma once

#include <chrono>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>

namespace sbgc::tools {

/// Returns enough time for the axis that has the farthest way from where it is.
std::chrono::milliseconds time_for_move(const MoveTarget& target, const msg::GetAngles& state,
                                        msg::ControlSpeed speed);

}  // namespace sbgc::tools
