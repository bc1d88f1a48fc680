// spec/parameters.yaml: saving parameters and restoring defaults. parameter_access.hpp handles the
// requests that read and write them.

#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {

Outcome handle(RequestContext& context, const msg::SaveParams3&) {
  context.device.parameters.save();
  return context.confirm();
}

Outcome handle(RequestContext& context, const msg::UseDefaults& request) {
  if (request.profile_id == msg::UseDefaults::erase_eeprom) {
    context.device.parameters.erase();
    context.device.forget_calibrations();
  } else if (request.profile_id < ParametersOf<msg::ReadParams3>::copies) {
    context.device.parameters.use_defaults(request.profile_id);
  } else {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.profile_id);
  }
  context.device.apply_parameters(context.now);
  return context.confirm();
}

}  // namespace sbgc::emulator
