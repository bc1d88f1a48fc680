#include "device/peripherals/outputs.hpp"

#include <algorithm>
#include <bit>

#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/peripherals.hpp>
#include <sbgc/validate.hpp>

#include "device/features.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the duration of the standard sounds.
constexpr Duration standard_sound = milliseconds(300);
constexpr Duration click_sound = milliseconds(20);

/// Returns the index of a value in its enum.
template <class E>
std::optional<std::size_t> index_of(E value) {
  const auto values = EnumMeta<E>::info.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].value == static_cast<std::int64_t>(value)) return i;
  }
  return {};
}

/// True if an RC source is this pin: RC_MAP_* values use the numbers of OutputPin.
bool is_at(Availability versions, msg::RcMap source, msg::OutputPin pin) {
  // Boards without separate analog inputs read analog signals at the PWM pins.
  const bool reads_pin =
      source.source() == msg::RcSource::pwm ||
      (source.source() == msg::RcSource::analog && !knows(versions, msg::RcInput::adc1));
  return reads_pin && source.channel() == static_cast<std::uint8_t>(pin);
}

/// True if the pin is an input or carries a serial port.
bool is_taken(const Parameters& in_use, Availability versions, msg::OutputPin pin) {
  const auto& parameters = in_use.of<msg::ReadParams3>();
  const msg::RcVirtualMode mode = parameters.rc_virt_mode;
  if (mode == msg::RcVirtualMode::api &&
      (pin == msg::OutputPin::rc_input_roll || pin == msg::OutputPin::rc_input_yaw)) {
    return true;
  }
  const bool has_receiver = mode == msg::RcVirtualMode::cppm || mode == msg::RcVirtualMode::sbus ||
                            mode == msg::RcVirtualMode::spektrum;
  if (has_receiver && pin == msg::OutputPin::rc_input_roll) return true;
  const auto is_pin = [&](msg::RcMap source) { return is_at(versions, source, pin); };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_pin(parameters.rc_map[axis])) return true;
  }
  if (is_pin(parameters.rc_map_cmd) || is_pin(parameters.rc_map_fc_roll) ||
      is_pin(parameters.rc_map_fc_pitch)) {
    return true;
  }
  const auto& slots = in_use.of<msg::ReadAdjVarsCfg>();
  const auto reads_pin = [&](const auto& slot) { return is_pin(slot.src_ch); };
  return std::any_of(slots.trigger_slots.begin(), slots.trigger_slots.end(), reads_pin) ||
         std::any_of(slots.analog_slots.begin(), slots.analog_slots.end(), reads_pin);
}

/// The pins of the servo outputs, as documented for CMD_SERVO_OUT.
constexpr std::array<msg::OutputPin, Outputs::servo_pins> servo_pin{
    msg::OutputPin::ext_fc_input_roll, msg::OutputPin::ext_fc_input_pitch,
    msg::OutputPin::rc_input_pitch, msg::OutputPin::pin_aux1};

constexpr msg::ServoPulse floating{msg::ServoOut::floating};

/// Returns the sound of an event in the parameters, whose values differ from those of sounds
/// (E111).
std::optional<msg::BeepMode> sound_of(msg::BeeperMode event) {
  switch (event) {
    case msg::BeeperMode::calibrate: return msg::BeepMode::calibrate;
    case msg::BeeperMode::confirm: return msg::BeepMode::confirm;
    case msg::BeeperMode::error: return msg::BeepMode::error;
    default: return {};  // alarm, by_motors
  }
}

}  // namespace

std::array<msg::ServoPulse, Outputs::servos> Outputs::free_servos() {
  std::array<msg::ServoPulse, servos> result;
  result.fill(floating);
  return result;
}

bool Outputs::set_pin(const Parameters& parameters, Availability versions, msg::OutputPin pin,
                      msg::PinState state) {
  const bool exist = knows(versions, pin) && knows(versions, state);
  // The emulated modules have no pins.
  if (!exist || *index_of(pin) >= pin_count || is_taken(parameters, versions, pin)) return false;
  const auto& servo_out = parameters.of<msg::ReadParams3>().servo_out;
  for (std::size_t i = 0; i < servo_pin.size(); ++i) {
    const bool is_servo =
        servos_[i] != floating || servo_out[i] != msg::ReadParams3::servo_disabled;
    if (servo_pin[i] == pin && is_servo) return false;
  }
  pins_[*index_of(pin)] = state;
  return true;
}

std::optional<msg::PinState> Outputs::pin(msg::OutputPin pin) const {
  const auto index = index_of(pin);
  return index && *index < pin_count ? pins_[*index] : std::nullopt;
}

std::uint16_t Outputs::high_pins() const {
  unsigned bits = 0;
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    if (pins_[i] == msg::PinState::high) bits |= 1U << i;
  }
  return static_cast<std::uint16_t>(bits);
}

bool Outputs::set_servos(const Parameters& parameters, const msg::ServoOut& request) {
  msg::ServoOut wanted = request;
  // All negative values mean floating.
  for (msg::ServoPulse& pulse : wanted.servo_time) {
    if (pulse < msg::ServoPulse(msg::ServoOut::low)) pulse = floating;
  }
  if (!is_valid(wanted)) return false;
  const double rate = parameters.of<msg::ReadParams3>().servo_rate.hertz();
  constexpr auto second = static_cast<double>(seconds(1).us);
  for (const msg::ServoPulse pulse : wanted.servo_time) {
    if (pulse.microseconds() * rate >= second) return false;
  }
  servos_ = wanted.servo_time;
  for (std::size_t i = 0; i < servo_pin.size(); ++i) {
    if (servos_[i] != floating) pins_[*index_of(servo_pin[i])].reset();
  }
  return true;
}

bool Outputs::set_servos(const Parameters& parameters, const msg::ServoOutExt& request) {
  msg::ServoOut wanted;
  wanted.servo_time = servos_;
  auto drivers = driver_servos_;
  std::size_t index = 0;
  for (std::size_t bit = 0; bit < servo_pins + driver_servos; ++bit) {
    if (((request.servo_bits.raw() >> bit) & 1U) == 0) continue;
    const msg::ServoPulse pulse = request.servo_time[index++];
    if (bit < servo_pins) {
      wanted.servo_time[bit] = pulse;
    } else {
      drivers[bit - servo_pins] = pulse;
    }
  }
  if (index != request.servo_time.size() || !set_servos(parameters, wanted)) return false;
  driver_servos_ = drivers;
  return true;
}

bool Outputs::play(const msg::BeepSound& sound, Instant now) {
  // Assumption: one sound at a time, although the mode is a flag set.
  const auto mode = static_cast<msg::BeepMode>(sound.mode.raw());
  if (!std::has_single_bit(sound.mode.raw()) || !index_of(mode) || !is_valid(sound)) return false;
  Duration length = mode == msg::BeepMode::click ? click_sound : standard_sound;
  if (mode == msg::BeepMode::custom_melody) {
    const auto note = static_cast<std::int64_t>(sound.note_length.milliseconds());
    if (note == 0 || sound.note_freq_hz.empty()) return false;
    length = milliseconds(note) * static_cast<std::int32_t>(sound.note_freq_hz.size());
  }
  sound_ = Sound{sound.mode, now + length};
  return true;
}

void Outputs::signal(const Parameters& parameters, msg::BeeperMode event, Instant now) {
  if (!parameters.of<msg::ReadParams3>().beeper_modes.has(event)) return;
  if (const auto sound = sound_of(event)) sound_ = Sound{*sound, now + standard_sound};
}

}  // namespace sbgc::emulator
