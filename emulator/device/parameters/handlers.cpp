// spec/parameters.yaml: saving parameters and restoring defaults. parameters/access.hpp handles the
// requests that read and write them.

#include "device/handlers.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

#include "device/control/reported_state.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"

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

Reaction handle(RequestContext& context, const msg::UseDefaults& request, Parameters& parameters,
                Memory& memory, Imus& imus) {
  if (request.profile_id == msg::UseDefaults::erase_eeprom) {
    parameters.erase();
    memory.imus = {};
    memory.battery_factor = Memory{}.battery_factor;
    ++memory.revision;
    imus.headings = {};
  } else if (request.profile_id < ParametersOf<msg::ReadParams3>::copies) {
    parameters.use_defaults(request.profile_id);
  } else {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.profile_id);
  }
  return context.confirm();
}

/// Between the two requests, written parameters are stored but not yet in use.
Reaction handle(RequestContext& context, const msg::WriteParamsSet& request, Modes& modes,
                Parameters& parameters) {
  switch (request.action) {
    case msg::WriteParamsAction::start: modes.is_writing_parameters = true; break;
    case msg::WriteParamsAction::finish:
      modes.is_writing_parameters = false;
      parameters.apply_later();
      break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ProfileSet& request, Parameters& parameters) {
  const std::size_t index = request.slot - std::size_t{1};
  if (request.slot == 0 || index >= Memory::profile_set_slots) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.slot);
  }
  switch (request.action) {
    case msg::ProfileSetAction::save: parameters.save_profile_set(index); break;
    case msg::ProfileSetAction::clear: parameters.clear_profile_set(index); break;
    case msg::ProfileSetAction::load:
      if (!parameters.load_profile_set(index)) {
        return context.refuse(msg::BoardErrorCode::operation_failed, request.slot);
      }
      break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.confirm();
}

}  // namespace sbgc::emulator
