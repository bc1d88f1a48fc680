// spec/debug.yaml: debug variables.

#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/parts/debug_variables.hpp"

namespace sbgc::emulator {

Outcome handle(RequestContext& context, const msg::DebugVarsInfo3Request&) {
  return context.answer(debug_variables_info());
}

Outcome handle(RequestContext& context, const msg::DebugVars3Request&) {
  return context.answer(debug_variable_values(context.device, context.now));
}

}  // namespace sbgc::emulator
