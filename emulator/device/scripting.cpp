/// Requests about scripts.
#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {

Outcome handle(Turn& turn, const msg::RunScript& request) {
  Machine& machine = turn.machine;
  if (!Scripts::are_known(machine)) return turn.refuse(msg::BoardErrorCode::not_supported);
  std::optional<std::size_t> debug_port;
  switch (request.mode) {
    case msg::ScriptMode::stop:
      if (request.slot >= Scripts::slots) return turn.refuse(msg::BoardErrorCode::wrong_params);
      if (machine.scripts.running() == request.slot) machine.scripts.stop();
      return turn.confirm();
    case msg::ScriptMode::start: break;
    case msg::ScriptMode::start_debug: debug_port = turn.port; break;
    default: return turn.refuse(msg::BoardErrorCode::wrong_params);
  }
  const auto refusal = machine.scripts.start(machine, request.slot, debug_port, turn.now);
  return refusal ? turn.refuse(*refusal) : turn.confirm();
}

}  // namespace sbgc::board
