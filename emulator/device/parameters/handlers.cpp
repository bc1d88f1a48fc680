// spec/parameters.yaml: saving parameters and restoring defaults. parameters/access.hpp handles the
// requests that read and write them.

#include "device/handlers.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace sbgc::emulator {

Reaction handle(RequestContext& context, const msg::SaveParams3& request, Parameters& parameters) {
  if (request.param_id.empty()) {
    parameters.save();
    return context.confirm();
  }
  for (const msg::VariableId id : request.param_id) {
    if (!parameters.variable(id)) {
      return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(id));
    }
  }
  parameters.save(std::span(request.param_id.data(), request.param_id.size()));
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::UseDefaults& request, Device& device) {
  if (request.profile_id == msg::UseDefaults::erase_eeprom) {
    device.parameters.erase();
    device.memory.imus = {};
    device.memory.battery_factor = Memory{}.battery_factor;
    ++device.memory.revision;
    device.imus.headings = {};
  } else if (request.profile_id < ParametersOf<msg::ReadParams3>::copies) {
    device.parameters.use_defaults(request.profile_id);
  } else {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.profile_id);
  }
  return context.confirm();
}

/// Between the two requests, written parameters are stored but not yet in use.
Reaction handle(RequestContext& context, const msg::WriteParamsSet& request, Device& device) {
  switch (request.action) {
    case msg::WriteParamsAction::start: device.modes.is_writing_parameters = true; break;
    case msg::WriteParamsAction::finish:
      device.modes.is_writing_parameters = false;
      device.parameters.apply_later();
      break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ProfileSet& request, Device& device) {
  const std::size_t index = request.slot - std::size_t{1};
  if (request.slot == 0 || index >= device.memory.profile_sets.size()) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.slot);
  }
  switch (request.action) {
    case msg::ProfileSetAction::save: device.parameters.save_profile_set(index); break;
    case msg::ProfileSetAction::clear: device.parameters.clear_profile_set(index); break;
    case msg::ProfileSetAction::load:
      if (!device.parameters.load_profile_set(index)) {
        return context.refuse(msg::BoardErrorCode::operation_failed, request.slot);
      }
      break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.confirm();
}

}  // namespace sbgc::emulator
