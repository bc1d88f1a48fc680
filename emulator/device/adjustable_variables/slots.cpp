#include "device/adjustable_variables/slots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <sbgc/meta/variables.hpp>

#include "device/control/menu.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the interval at which the board reads the signals.
constexpr Duration period = milliseconds(20);

constexpr unsigned levels = std::tuple_size_v<decltype(msg::TriggerSlot::action)>;

/// Returns the number of the signal's level; there are five equally wide ones.
unsigned level_of(double signal) {
  const double share = (signal + 1) / 2;
  return static_cast<unsigned>(std::clamp(std::floor(share * levels), 0.0, levels - 1.0));
}

/// True if a trigger or an analog slot has a source.
bool is_used(const auto& slot) { return slot.src_ch != msg::RcMap(msg::RcInput::input_no); }

/// Assumption, because the formula is undocumented (E073): MIN_VAL and MAX_VAL divide the range of
/// the variable into 255 parts, and the signal maps linearly between them. MIN_VAL above MAX_VAL
/// reverses the direction.
std::int32_t value_of(const msg::AnalogSlot& slot, const VariableInfo& variable, double signal) {
  constexpr double whole = std::numeric_limits<decltype(slot.max_val)>::max();
  const double share = (std::clamp(signal, -1.0, 1.0) + 1) / 2;
  const double part = slot.min_val + (slot.max_val - slot.min_val) * share;
  const Range& range = variable.range;
  return static_cast<std::int32_t>(
      std::lround(range.lowest + (range.highest - range.lowest) * part / whole));
}

msg::CentredRcSignal rc_data(std::optional<double> signal) {
  // Assumption: a missing signal is reported as centered.
  return msg::CentredRcSignal::from_fraction(std::clamp(signal.value_or(0), -1.0, 1.0))
      .value_or({});
}

}  // namespace

void Slots::apply_parameters(const Parameters& parameters, Instant now) {
  const auto& configs = parameters.of<msg::ReadAdjVarsCfg>();
  if (std::exchange(profile_, parameters.profile()) != parameters.profile()) {
    for (Analog& slot : analogs_) slot.value.reset();
  }
  bool is_any_used = false;
  for (std::size_t i = 0; i < triggers; ++i) {
    const msg::TriggerSlot& config = configs.trigger_slots[i];
    if (!(triggers_[i].config == config)) triggers_[i] = {.config = config};
    is_any_used = is_any_used || is_used(config);
  }
  for (std::size_t i = 0; i < analogs; ++i) {
    const msg::AnalogSlot& config = configs.analog_slots[i];
    if (!(analogs_[i].config == config)) analogs_[i] = {.config = config};
    is_any_used = is_any_used || is_used(config);
  }
  if (!is_any_used) {
    next_ = Instant::never;
    next_trigger_ = 0;
  } else if (next_ == Instant::never) {
    next_ = now + period;
  }
}

void Slots::advance(Instant now, MenuParts& menu) {
  // Actions first, because they may switch the profile.
  while (next_trigger_ < triggers) {
    Trigger& slot = triggers_[next_trigger_++];
    const auto signal =
        is_used(slot.config) ? menu.remote.signal(slot.config.src_ch) : std::nullopt;
    const auto level = signal ? std::optional(level_of(*signal)) : std::nullopt;
    if (level == slot.level) continue;
    slot.level = level;
    if (!level) continue;
    const msg::MenuCommand action = slot.config.action[*level];
    slot.action = action;
    if (action == msg::MenuCommand::none) continue;
    execute_menu(menu, action, now);
    return;  // then continue at once, with the parameters that the action has changed
  }
  next_trigger_ = 0;
  next_ = next_ + period;
  if (next_ <= now) next_ = now + period;  // past values of a signal are unknown
  for (Analog& slot : analogs_) {
    const auto signal = menu.remote.signal(slot.config.src_ch);
    const VariableInfo* variable = find_variable(slot.config.param_id);
    if (!is_used(slot.config) || !signal || variable == nullptr) continue;
    const std::int32_t value = value_of(slot.config, *variable, *signal);
    // A host may also set the variable: the signal wins when it or the profile changes.
    if (slot.value == value) continue;
    slot.value = value;
    menu.parameters.set_variable(slot.config.param_id, value);
  }
}

msg::AdjVarsState Slots::state(const RemoteControl& remote, const Parameters& parameters,
                               std::size_t trigger, std::size_t analog) const {
  const Trigger& one = triggers_[trigger];
  const Analog& other = analogs_[analog];
  msg::AdjVarsState state;
  state.trigger_rc_data = rc_data(remote.signal(one.config.src_ch));
  state.trigger_action = one.action;
  state.analog_rc_data = rc_data(remote.signal(other.config.src_ch));
  if (is_used(other.config)) {
    state.analog_value = parameters.variable(other.config.param_id).value_or(0);
  }
  return state;
}

std::optional<double> Slots::signal(const RemoteControl& remote, std::size_t trigger) const {
  return remote.signal(triggers_[trigger].config.src_ch);
}

}  // namespace sbgc::emulator
