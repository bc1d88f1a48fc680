/// The cycle of the controller.
#pragma once

#include <sbgc/roles.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

inline constexpr Duration cycle = microseconds(roles::stream_cycle_us);

}  // namespace sbgc::emulator
