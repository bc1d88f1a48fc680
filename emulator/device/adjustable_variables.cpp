// spec/adjustable_variables.yaml: variable values and slot states. parameter_access.hpp handles
// CMD_READ_ADJ_VARS_CFG and CMD_WRITE_ADJ_VARS_CFG.

#include <cstdint>
#include <span>

#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/validate.hpp>

#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {
namespace {

Outcome report(RequestContext& context, std::uint8_t trigger, std::uint8_t analog) {
  if (trigger >= Slots::triggers || analog >= Slots::analogs) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.answer(context.device.slots.state(context.device, trigger, analog));
}

}  // namespace

Outcome handle(RequestContext& context, const msg::GetAdjVarsVal& request) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  msg::SetAdjVarsVal answer;
  for (const msg::VariableId id : request.param_id) {
    const auto value = context.device.parameters.variable(id);
    if (!value)
      return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(id));
    answer.params.push_back({id, *value});
  }
  return context.answer(answer);
}

/// Sets all variables or none.
Outcome handle(RequestContext& context, const msg::SetAdjVarsVal& request) {
  Device& device = context.device;
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  const auto refused =
      device.parameters.set_variables(std::span(request.params.data(), request.params.size()));
  if (refused)
    return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(*refused));
  device.apply_parameters(context.now);
  return context.confirm();
}

Outcome handle(RequestContext& context, const msg::AdjVarsStateRequest& request) {
  return report(context, request.trigger_slot, request.analog_slot);
}
Outcome handle(RequestContext& context, const msg::AdjVarsStateRequestExt& request) {
  return report(context, request.trigger_slot, 0);
}

}  // namespace sbgc::emulator
