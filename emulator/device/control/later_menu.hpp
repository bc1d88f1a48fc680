/// The menu actions of firmware after the specification.
#pragma once

#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct MenuParts;

/// Executes such an action. Returns false if there is no such action.
bool execute_later_action(MenuParts& parts, msg::MenuCommand action, Instant now);

}  // namespace sbgc::emulator
