/// Internal variables of the board.
#pragma once

#include <sbgc/messages/debug.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct MeasuredParts;

/// The names and types, which never change.
msg::DebugVarsInfo3 debug_variables_info(std::size_t first = 0);
/// The values, in the same order.
msg::DebugVars3 debug_variable_values(MeasuredParts& parts, Instant now);

}  // namespace sbgc::emulator
