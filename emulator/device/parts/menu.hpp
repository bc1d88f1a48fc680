/// The menu actions, started by a button, an RC signal or a request.
#pragma once

#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Executes an action. Returns false if there is no such action.
bool execute_menu(Device& device, msg::MenuCommand action, Instant now);

}  // namespace sbgc::emulator
