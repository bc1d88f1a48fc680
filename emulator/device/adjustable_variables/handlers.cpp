// spec/adjustable_variables.yaml: variable values and slot states. parameters/access.hpp handles
// CMD_READ_ADJ_VARS_CFG and CMD_WRITE_ADJ_VARS_CFG.

#include "device/handlers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/meta/variables.hpp>
#include <sbgc/validate.hpp>

#include "device/adjustable_variables/slots.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// Reports all variables or none.
template <class Value, class Ids, class Answer>
Reaction report(RequestContext& context, const Parameters& parameters, const Ids& ids,
                Answer answer) {
  for (const msg::VariableId id : ids) {
    const auto value = parameters.variable(id);
    if (!value)
      return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(id));
    answer.params.push_back({id, static_cast<Value>(*value)});
  }
  return context.answer(answer);
}

/// Sets all variables or none.
Reaction set(RequestContext& context, Parameters& parameters,
             std::span<const msg::AdjVarValue> values) {
  if (const auto refused = parameters.set_variables(values)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(*refused));
  }
  return context.confirm();
}

/// The signal of an input in the widest range. Assumption: a missing one is reported as centered.
msg::FineRcSignal centred_signal(std::optional<double> signal) {
  return saturated<msg::FineRcSignal>(std::clamp(signal.value_or(0), -1.0, 1.0));
}

std::optional<double> signal_of(const RemoteControl& remote, std::uint16_t source) {
  using Raw = msg::RcMap::raw_type;
  if (source > std::numeric_limits<Raw>::max()) return {};
  return remote.signal(msg::RcMap(static_cast<Raw>(source)));
}

}  // namespace

Reaction handle(RequestContext& context, const msg::GetAdjVarsVal& request,
                const Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  return report<std::int32_t>(context, parameters, request.param_id, msg::SetAdjVarsVal{});
}
Reaction handle(RequestContext& context, const msg::GetAdjVarsValF& request,
                const Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  return report<float>(context, parameters, request.id, msg::SetAdjVarsValF{});
}

Reaction handle(RequestContext& context, const msg::SetAdjVarsVal& request,
                Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  return set(context, parameters, std::span(request.params.data(), request.params.size()));
}
Reaction handle(RequestContext& context, const msg::SetAdjVarsValF& request,
                Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  std::vector<msg::AdjVarValue> values;
  for (const msg::AdjVarFloat& one : request.params) {
    const auto value = static_cast<double>(one.value);
    // Larger than the range of any variable.
    constexpr double largest = 1e9;
    if (!(std::abs(value) <= largest)) {
      return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint8_t>(one.id));
    }
    // Assumption: the variables remain integers.
    values.push_back({one.id, static_cast<std::int32_t>(std::lround(value))});
  }
  return set(context, parameters, values);
}

Reaction handle(RequestContext& context, const msg::AdjVarsStateRequest& request,
                const Slots& slots, const RemoteControl& remote, const Parameters& parameters) {
  if (request.trigger_slot >= Slots::triggers || request.analog_slot >= Slots::analogs) {
    return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.answer(slots.state(remote, parameters, request.trigger_slot, request.analog_slot));
}
Reaction handle(RequestContext& context, const msg::AdjVarsStateRequestExt& request,
                const Slots& slots, const RemoteControl& remote, const Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  const auto analog = parameters.variable(request.analog_var_id);
  const auto table = parameters.variable(request.lut_var_id);
  if (!analog || !table) return context.refuse(msg::BoardErrorCode::wrong_params);
  const msg::AdjVarsState slot = slots.state(remote, parameters, request.trigger_slot, 0);
  return context.answer(msg::AdjVarsStateExt{
      .trigger_rc_data = centred_signal(slots.signal(remote, request.trigger_slot)),
      .trigger_action = slot.trigger_action,
      .analog_src_value = centred_signal(signal_of(remote, request.analog_src_id)),
      .analog_var_value = static_cast<float>(*analog),
      .lut_src_value = centred_signal(signal_of(remote, request.lut_src_id)),
      .lut_var_value = static_cast<float>(*table)});
}

/// Describes as many variables as fit into one body, from this one on.
Reaction handle(RequestContext& context, const msg::AdjVarsInfoRequest& request,
                const Parameters& parameters) {
  msg::AdjVarsInfo answer;
  answer.total_number = parameters.variable_count();
  std::array<std::uint8_t, max_body_size> body{};
  for (const VariableInfo& variable : variables) {
    const auto value = parameters.variable(variable.id);
    if (variable.id < request.start_id || !value) continue;
    msg::AdjVarInfo one;
    one.var_id = variable.id;
    constexpr std::size_t longest_name = 16;
    one.name.assign(std::string_view(variable.name).substr(0, longest_name));
    one.range_min = saturated_raw<std::int16_t>(variable.range.lowest);
    one.range_max = saturated_raw<std::int16_t>(variable.range.highest);
    one.value = *value;
    msg::AdjVarsInfo more = answer;
    if (!more.vars.push_back(one) || !encode(more, body)) break;
    answer = more;
  }
  return context.answer(answer);
}
}  // namespace sbgc::emulator
