// spec/scripting.yaml: running scripts.

#include "device/handlers.hpp"

#include "device/device.hpp"

namespace sbgc::emulator {

Verdict handle(RequestContext& context, const msg::RunScript& request) {
  Device& device = context.device;
  if (!Scripts::are_supported(device)) return context.refuse(msg::BoardErrorCode::not_supported);
  std::optional<std::size_t> debug_port;
  switch (request.mode) {
    case msg::ScriptMode::stop:
      if (request.slot >= Scripts::slots) return context.refuse(msg::BoardErrorCode::wrong_params);
      if (device.scripts.running() == request.slot) device.scripts.stop();
      return context.confirm();
    case msg::ScriptMode::start: break;
    case msg::ScriptMode::start_debug: debug_port = context.port; break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  const auto refusal = device.scripts.start(device, request.slot, debug_port, context.now);
  return refusal ? context.refuse(*refusal) : context.confirm();
}

}  // namespace sbgc::emulator
