/// The actions of the menu: a button, an RC signal or a request starts them.
#pragma once

#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Carries out an action. False if there is no such action.
bool execute_menu(Device& device, msg::MenuCommand action, Instant now);

}  // namespace sbgc::emulator
