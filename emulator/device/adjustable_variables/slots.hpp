/// RC signals that trigger actions and change adjustable variables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Parameters;
class RemoteControl;
struct MenuParts;

/// Implements the configuration of CMD_WRITE_ADJ_VARS_CFG.
class Slots {
 public:
  static constexpr std::size_t triggers =
      std::tuple_size_v<decltype(msg::ReadAdjVarsCfg::trigger_slots)>;
  static constexpr std::size_t analogs =
      std::tuple_size_v<decltype(msg::ReadAdjVarsCfg::analog_slots)>;

  /// Takes the configuration from the parameters; called by Device::apply_parameters().
  void apply_parameters(const Parameters& parameters, Instant now);
  /// The current state of two slots. Precondition: trigger < triggers, analog < analogs.
  msg::AdjVarsState state(const RemoteControl& remote, const Parameters& parameters,
                          std::size_t trigger, std::size_t analog) const;

  /// The signal of a trigger slot. Same precondition.
  std::optional<double> signal(const RemoteControl& remote, std::size_t trigger) const;

  Instant next() const { return next_; }
  void advance(Instant now, MenuParts& menu);

 private:
  struct Trigger {
    msg::TriggerSlot config{};
    std::optional<unsigned> level{};  ///< of the signal, if any
    msg::MenuCommand action{};        ///< last started
  };
  struct Analog {
    msg::AnalogSlot config{};
    std::optional<std::int32_t> value{};  ///< last set
  };

  std::array<Trigger, triggers> triggers_{};
  std::array<Analog, analogs> analogs_{};
  std::uint8_t profile_{};      ///< the profile in which the values were set
  std::size_t next_trigger_{};  ///< not 0 after an action: advance() continues here
  Instant next_ = Instant::never;
};

}  // namespace sbgc::emulator
