/// Requests about adjustable variables.
#include <cstdint>
#include <span>

#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/validate.hpp>

#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

Outcome report(Turn& turn, std::uint8_t trigger, std::uint8_t analog) {
  if (trigger >= Slots::triggers || analog >= Slots::analogs) {
    return turn.refuse(msg::BoardErrorCode::wrong_params);
  }
  return turn.answer(turn.machine.slots.state(turn.machine, trigger, analog));
}

}  // namespace

Outcome handle(Turn& turn, const msg::GetAdjVarsVal& request) {
  if (!is_valid(request)) return turn.refuse(msg::BoardErrorCode::wrong_params);
  msg::SetAdjVarsVal answer;
  for (const msg::VariableId id : request.param_id) {
    const auto value = turn.machine.settings.variable(id);
    if (!value)
      return turn.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(id));
    answer.params.push_back({id, *value});
  }
  return turn.answer(answer);
}

/// All of them or none.
Outcome handle(Turn& turn, const msg::SetAdjVarsVal& request) {
  Machine& machine = turn.machine;
  if (!is_valid(request)) return turn.refuse(msg::BoardErrorCode::wrong_params);
  const auto refused =
      machine.settings.set_variables(std::span(request.params.data(), request.params.size()));
  if (refused)
    return turn.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(*refused));
  machine.apply_settings(turn.now);
  return turn.confirm();
}

Outcome handle(Turn& turn, const msg::SaveParams3&) {
  turn.machine.settings.save();
  return turn.confirm();
}

Outcome handle(Turn& turn, const msg::AdjVarsStateRequest& request) {
  return report(turn, request.trigger_slot, request.analog_slot);
}
/// Ours, because these parameters are not documented: the first two are those of the simple form.
Outcome handle(Turn& turn, const msg::AdjVarsStateRequestExt& request) {
  return report(turn, request.params[0], request.params[1]);
}

}  // namespace sbgc::board
