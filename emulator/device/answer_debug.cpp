/// Requests about debug variables.
#include "handlers.hpp"
#include "machine.hpp"

namespace sbgc::board {

Outcome handle(Turn& turn, const msg::DebugVarsInfo3Request&) {
  return turn.answer(DebugVariables::info());
}

Outcome handle(Turn& turn, const msg::DebugVars3Request&) {
  return turn.answer(DebugVariables::values(turn.machine, turn.now));
}

}  // namespace sbgc::board
