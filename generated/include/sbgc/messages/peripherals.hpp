// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Pins, servos, sound, I2C and virtual RC channels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::get;
using sbgc::put;

static_assert(codec_version == 1, "generated code and runtime do not belong together");

struct I2cReadRegBuf;

/// Play a melody through the motors, or one of the standard sounds.
///
/// CMD_BEEP_SOUND (89), to the board; 12 to 72 bytes.
/// Effect: sets.
/// Since firmware 2.59, board 3.0.
/// Source: Outgoing commands L985-L991; Variables L1222-L1227.
struct BeepSound {
  static constexpr CommandToBoard command = CommandToBoard::beep_sound;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 72;
  static constexpr Availability since{2590, 30};
  using Response = void;

  /// For decay_factor: no envelope.
  static constexpr std::uint8_t no_envelope = 0;
  /// For note_freq_hz: pause, then the envelope starts again.
  static constexpr std::uint16_t pause = 21000;

  /// Which sound to make. Errata: E111.
  BeepModes mode{};
  /// Length of each note of a custom melody. Unit: ms, one count is 8. Range: 1 to 255. 0: without
  /// meaning unless a custom melody is played. Errata: E063.
  NoteLength note_length{};
  /// How slowly a note fades after each pause; 0 turns the envelope off. Heard only with encoder
  /// firmware or while the motors are off. Range: 0 to 15. no_envelope (0): no envelope.
  std::uint8_t decay_factor{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// The notes of a custom melody. Unit: Hz. Range: 554 to 20999. pause (21000): pause, then the
  /// envelope starts again. At most 30. Errata: E010, E064.
  BoundedArray<NoteFrequency, 121> note_freq_hz{};

  constexpr bool operator==(const BeepSound&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BeepSound& SBGC_RESTRICT out) noexcept {
  using M = BeepSound;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, mode), offsetof(M, reserved), 4)) {
    detail::get_block(from, out, offsetof(M, mode), 12);
    return;
  }
  get(from, out.mode);
  get(from + 2, out.note_length);
  get(from + 3, out.decay_factor);
  get(from + 4, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BeepSound& SBGC_RESTRICT in) noexcept {
  using M = BeepSound;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, mode), offsetof(M, reserved), 4)) {
    detail::put_block(to, in, offsetof(M, mode), 12);
    return;
  }
  put(to, in.mode);
  put(to + 2, in.note_length);
  put(to + 3, in.decay_factor);
  put(to + 4, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BeepSound& out) noexcept {
  if (body.size() < 12) return detail::wrong_size(body.size(), 12);
  get(body.data(), out);
  detail::Reader reader(body, 12);
  reader.rest(out.note_freq_hz, "note_freq_hz");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const BeepSound& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 12) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 12);
  writer.array(in.note_freq_hz, "note_freq_hz");
  return writer.end();
}

/// Switch an output pin. Confirmed only if the pin was switched, which it is not while it serves as
/// an input.
///
/// CMD_TRIGGER_PIN (84), to the board; 2 bytes.
/// Effect: sets.
/// Source: Outgoing commands L717-L722; Variables L1153-L1155.
struct TriggerPin {
  static constexpr CommandToBoard command = CommandToBoard::trigger_pin;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// Which pin.
  OutputPin pin_id{};
  /// What to switch it to.
  PinState state{};

  constexpr bool operator==(const TriggerPin&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   TriggerPin& SBGC_RESTRICT out) noexcept {
  get(from, out.pin_id);
  get(from + 1, out.state);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const TriggerPin& SBGC_RESTRICT in) noexcept {
  put(to, in.pin_id);
  put(to + 1, in.state);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      TriggerPin& out) noexcept {
  if (body.size() != 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const TriggerPin& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {2, {}};
}

/// Send PWM signals to servos. Outputs 1 to 4 share their pins with FC_ROLL, FC_PITCH, RC_PITCH and
/// AUX1; 5 to 8 are reserved. A board may have fewer. Servos mostly take 500 to 2500 us, 1500 us is
/// their middle; a pulse must be shorter than the period that SERVO_RATE sets.
///
/// CMD_SERVO_OUT (36), to the board; 16 bytes.
/// Effect: moves.
/// Since board 3.0.
/// Source: Outgoing commands L813-L824; Variables L1183-L1184.
struct ServoOut {
  static constexpr CommandToBoard command = CommandToBoard::servo_out;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 16;
  static constexpr std::size_t max_size = 16;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// For servo_time: the pin is set free and floats.
  static constexpr std::int16_t floating = -1;
  /// For servo_time: the pin is low all the time.
  static constexpr std::int16_t low = 0;

  /// Pulse of each output. Unit: us. Range: -1 to 20000. floating (-1): the pin is set free and
  /// floats. low (0): the pin is low all the time. Errata: E076.
  std::array<ServoPulse, 8> servo_time{};

  constexpr bool operator==(const ServoOut&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ServoOut& SBGC_RESTRICT out) noexcept {
  get(from, out.servo_time);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ServoOut& SBGC_RESTRICT in) noexcept {
  put(to, in.servo_time);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ServoOut& out) noexcept {
  if (body.size() != 16) return detail::wrong_size(body.size(), 16);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ServoOut& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 16) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {16, {}};
}

/// Write to a device on an I2C bus. The sensors and the EEPROM are on these buses, too. Write only
/// to a device of your own, as the example does: what is written to a sensor can make the camera
/// move.
///
/// CMD_I2C_WRITE_REG_BUF (39), to the board; 2 to 255 bytes.
/// Effect: sets, stores.
/// Since board 3.0.
/// Source: Outgoing commands L826-L835.
struct I2cWriteRegBuf {
  static constexpr CommandToBoard command = CommandToBoard::i2c_write_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Which device.
  I2cDevice device_addr{};
  /// Register to begin with.
  std::uint8_t reg_addr{};
  /// What to write.
  BoundedBytes<253> data{};

  constexpr bool operator==(const I2cWriteRegBuf&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   I2cWriteRegBuf& SBGC_RESTRICT out) noexcept {
  get(from, out.device_addr);
  get(from + 1, out.reg_addr);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const I2cWriteRegBuf& SBGC_RESTRICT in) noexcept {
  put(to, in.device_addr);
  put(to + 1, in.reg_addr);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      I2cWriteRegBuf& out) noexcept {
  if (body.size() < 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  detail::Reader reader(body, 2);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const I2cWriteRegBuf& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 2);
  writer.array(in.data, "data");
  return writer.end();
}

/// Data of a device on an I2C bus.
///
/// CMD_I2C_READ_REG_BUF (40), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Incoming commands L458-L460.
struct I2cReadRegBuf {
  static constexpr CommandFromBoard command = CommandFromBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// What was read, 1 to 255 bytes: as many as were asked for. At most 255.
  BoundedBytes<255> data{};

  constexpr bool operator==(const I2cReadRegBuf&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      I2cReadRegBuf& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const I2cReadRegBuf& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Read from a device on an I2C bus.
///
/// CMD_I2C_READ_REG_BUF (40), to the board; 3 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L837-L845.
struct I2cReadRegBufRequest {
  static constexpr CommandToBoard command = CommandToBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{0, 30};
  using Response = I2cReadRegBuf;

  /// Which device.
  I2cDevice device_addr{};
  /// Register to begin with.
  std::uint8_t reg_addr{};
  /// How much to read. Unit: byte. Range: 1 to 255. Errata: E116.
  SmallByteCount data_len{};

  constexpr bool operator==(const I2cReadRegBufRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   I2cReadRegBufRequest& SBGC_RESTRICT out) noexcept {
  using M = I2cReadRegBufRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, device_addr), offsetof(M, data_len), 2)) {
    detail::get_block(from, out, offsetof(M, device_addr), 3);
    return;
  }
  get(from, out.device_addr);
  get(from + 1, out.reg_addr);
  get(from + 2, out.data_len);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const I2cReadRegBufRequest& SBGC_RESTRICT in) noexcept {
  using M = I2cReadRegBufRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, device_addr), offsetof(M, data_len), 2)) {
    detail::put_block(to, in, offsetof(M, device_addr), 3);
    return;
  }
  put(to, in.device_addr);
  put(to + 1, in.reg_addr);
  put(to + 2, in.data_len);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      I2cReadRegBufRequest& out) noexcept {
  if (body.size() != 3) return detail::wrong_size(body.size(), 3);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const I2cReadRegBufRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 3) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {3, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const I2cReadRegBufRequest& in) noexcept {
  using M = I2cReadRegBufRequest;
  if (!(detail::in_parallel(offsetof(M, device_addr), offsetof(M, data_len), 2))) return false;
  detail::add_block(sum, in, offsetof(M, device_addr), 3);
  return true;
}

/// Set the virtual RC channels that the host provides; they can control the camera and more. Send
/// all 32 channels to firmware before 2.70b5.
///
/// CMD_API_VIRT_CH_CONTROL (45), to the board; 2 to 64 bytes.
/// Effect: sets, stores, moves, restarts.
/// Since board 3.0.
/// Source: Outgoing commands L859-L865; Variables L1190-L1191.
struct ApiVirtChControl {
  static constexpr CommandToBoard command = CommandToBoard::api_virt_ch_control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 64;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// For val_ch: undefined, as if the signal were lost.
  static constexpr std::int16_t undefined = -10000;

  /// Signal of each channel from the first on; the board clips what goes beyond. Unit: no unit, one
  /// count is 1/500. Range: -500 to 500. undefined (-10000): undefined, as if the signal were lost.
  /// At least 1. At most 32. Errata: E042, E069, E070, E217.
  BoundedArray<CentredRcSignal, 32> val_ch{};

  constexpr bool operator==(const ApiVirtChControl&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ApiVirtChControl& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.val_ch, "val_ch", 1);
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const ApiVirtChControl& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.val_ch, "val_ch", 1);
  return writer.end();
}

}  // namespace sbgc::msg
