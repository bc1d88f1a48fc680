/// Requests about debug variables.
#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {

Outcome handle(Turn& turn, const msg::DebugVarsInfo3Request&) {
  return turn.answer(DebugVariables::info());
}

Outcome handle(Turn& turn, const msg::DebugVars3Request&) {
  return turn.answer(DebugVariables::values(turn.machine, turn.now));
}

}  // namespace sbgc::board
