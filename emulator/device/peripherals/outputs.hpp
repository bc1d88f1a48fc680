/// Outputs other than the motors: pins, servo pulses, sounds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <sbgc/enums.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/time.hpp>

#include "device/parameters/parameters.hpp"

namespace sbgc::emulator {

/// Outputs that are not connected; hosts can query their state.
class Outputs {
 public:
  static constexpr std::size_t servos = std::tuple_size_v<decltype(msg::ServoOut::servo_time)>;
  /// The number of servo outputs with a pin; the others are reserved.
  static constexpr std::size_t servo_pins = 4;

  /// The number of servo outputs of CAN motor drivers.
  static constexpr std::size_t driver_servos = 14;

  /// The current sound.
  struct Sound {
    msg::BeepModes mode{};
    Instant end{};
  };

  /// Returns false, without effect, if there is no such pin or it is in use for another purpose.
  bool set_pin(const Parameters& parameters, Availability versions, msg::OutputPin pin,
               msg::PinState state);
  /// The state set by a host; empty if none was set.
  std::optional<msg::PinState> pin(msg::OutputPin pin) const;
  /// Returns the high pins, one bit per pin in the order of OutputPin.
  std::uint16_t high_pins() const;

  /// Returns false, without effect, if a pulse does not fit into the period of SERVO_RATE.
  /// Assumption: a servo takes over its pin from any other use.
  bool set_servos(const Parameters& parameters, const msg::ServoOut& request);
  /// Sets only the selected servos; those of drivers do not use a pin of the board.
  bool set_servos(const Parameters& parameters, const msg::ServoOutExt& request);
  /// The pulse as in CMD_SERVO_OUT. Precondition: index < servos.
  msg::ServoPulse servo(std::size_t index) const { return servos_[index]; }

  /// The same for the outputs of drivers. Precondition: index < driver_servos.
  msg::ServoPulse driver_servo(std::size_t index) const { return driver_servos_[index]; }

  /// Plays a melody or a standard sound in place of the current one. Returns false, without effect,
  /// if the message describes neither.
  bool play(const msg::BeepSound& sound, Instant now);
  /// Plays the standard sound of an event if it has one and the parameters enable it.
  void signal(const Parameters& parameters, msg::BeeperMode event, Instant now);
  std::optional<Sound> sound() const { return sound_; }

  Instant next() const { return sound_ ? sound_->end : Instant::never; }
  void advance(Instant /*now*/) { sound_.reset(); }

 private:
  /// The first values of OutputPin are the pins of the board.
  static constexpr std::size_t pin_count = 10;

  std::array<std::optional<msg::PinState>, pin_count> pins_{};
  std::array<msg::ServoPulse, servos> servos_ = free_servos();
  std::optional<Sound> sound_{};

  std::array<msg::ServoPulse, driver_servos> driver_servos_{};

  static std::array<msg::ServoPulse, servos> free_servos();
};

}  // namespace sbgc::emulator
