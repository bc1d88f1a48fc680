/// Internal variables of the board.
#pragma once

#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Names and types, always the same.
msg::DebugVarsInfo3 debug_variables_info();
/// Values, in the same order.
msg::DebugVars3 debug_variable_values(Device& device, Instant now);

}  // namespace sbgc::emulator
