// spec/debug.yaml: debug variables.

#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {

Outcome handle(RequestContext& context, const msg::DebugVarsInfo3Request&) {
  return context.answer(DebugVariables::info());
}

Outcome handle(RequestContext& context, const msg::DebugVars3Request&) {
  return context.answer(DebugVariables::values(context.device, context.now));
}

}  // namespace sbgc::emulator
