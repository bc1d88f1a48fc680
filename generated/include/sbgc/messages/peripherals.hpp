// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Pins, servos, sound, I2C and virtual RC channels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct I2cReadRegBuf;
struct ReadRcInputs;

/// Play a melody through the motors, or a standard sound.
///
/// CMD_BEEP_SOUND (89), to the board; 12 to 112 bytes. Effect: sets. Since firmware 2.59, board
/// 3.0. Source: Outgoing commands L985-L991; Variables L1222-L1227.
struct BeepSound {
  static constexpr CommandToBoard command = CommandToBoard::beep_sound;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 112;
  static constexpr Availability since{.firmware = 2590, .board = 30};
  using Response = void;

  /// For decay_factor: no envelope.
  static constexpr std::uint8_t no_envelope{0};
  /// For note_freq_hz: pause, then the envelope starts again.
  static constexpr std::uint16_t pause{21000};

  /// Sound to play.
  BeepModes mode{};
  /// Length of each note of a custom melody. Range: 8 to 2040 ms. 0: without meaning unless a
  /// custom melody is played.
  NoteLength note_length{};
  /// How slowly a note fades after each pause; 0 disables the envelope. Audible only with encoder
  /// firmware or while the motors are off. Range: 0 to 15.
  std::uint8_t decay_factor{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// The notes of a custom melody; at most 30 in firmware of the specification's time. Range: 554
  /// to 20999 Hz. At most 50.
  BoundedArray<NoteFrequency, 121> note_freq_hz{};

  bool operator==(const BeepSound&) const = default;
  using FixedMembers = Members<&BeepSound::mode, &BeepSound::note_length, &BeepSound::decay_factor,
      &BeepSound::reserved>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.note_freq_hz, "note_freq_hz");
  }
};

/// Switch an output pin. Confirmed only if the pin was switched. A pin in use as an input is not
/// switched. The request for an input is always confirmed, with its level, or -1 if the pin is
/// unavailable.
///
/// CMD_TRIGGER_PIN (84), to the board; 2 bytes. Effect: sets. Source: Outgoing commands L717-L722;
/// Variables L1153-L1155.
struct TriggerPin {
  static constexpr CommandToBoard command = CommandToBoard::trigger_pin;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// The pin.
  OutputPin pin_id{};
  /// New state of the pin.
  PinState state{};

  bool operator==(const TriggerPin&) const = default;
  using FixedMembers = Members<&TriggerPin::pin_id, &TriggerPin::state>;
};

/// Send PWM signals to eight servos. Outputs 1 to 4 share their pins with FC_ROLL, FC_PITCH,
/// RC_PITCH and AUX1; 5 to 8 are reserved. A board may have fewer. Most servos take 500 to 2500 us,
/// with 1500 us as their center. A pulse must be shorter than the period that SERVO_RATE sets. From
/// firmware 2.70b8 on, if an output is a PWM duty cycle, 1000 is 0 % and 2000 is 100 %.
///
/// CMD_SERVO_OUT (36), to the board, simple form; 16 bytes. Effect: moves. Since board 3.0. Source:
/// Outgoing commands L813-L824; Variables L1183-L1184.
struct ServoOut {
  static constexpr CommandToBoard command = CommandToBoard::servo_out;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 16;
  static constexpr std::size_t max_size = 16;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// For servo_time: the pin is set free and floats.
  static constexpr std::int16_t floating{-1};
  /// For servo_time: the pin is low all the time.
  static constexpr std::int16_t low{0};

  /// Pulse of each output. Range: -1 to 20000 us.
  std::array<ServoPulse, 8> servo_time{};

  bool operator==(const ServoOut&) const = default;
  using FixedMembers = Members<&ServoOut::servo_time>;
};

/// Send PWM signals to the servos 1 to 4. Outputs 1 to 4 share their pins with FC_ROLL, FC_PITCH,
/// RC_PITCH and AUX1; 5 to 8 are reserved. A board may have fewer. Most servos take 500 to 2500 us,
/// with 1500 us as their center. A pulse must be shorter than the period that SERVO_RATE sets. From
/// firmware 2.70b8 on, if an output is a PWM duty cycle, 1000 is 0 % and 2000 is 100 %.
///
/// CMD_SERVO_OUT (36), to the board, four form; 8 bytes. Effect: moves. Since board 3.0. Source:
/// Vendor's code of 2026.
struct ServoOutFour {
  static constexpr CommandToBoard command = CommandToBoard::servo_out;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::four;
  static constexpr std::size_t min_size = 8;
  static constexpr std::size_t max_size = 8;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// For servo_time: the pin is set free and floats.
  static constexpr std::int16_t floating{-1};
  /// For servo_time: the pin is low all the time.
  static constexpr std::int16_t low{0};

  /// Pulse of each output. Range: -1 to 20000 us.
  std::array<ServoPulse, 4> servo_time{};

  bool operator==(const ServoOutFour&) const = default;
  using FixedMembers = Members<&ServoOutFour::servo_time>;
};

/// Send PWM signals to servos of the board and of its CAN motor drivers. Outputs that are not
/// selected keep their signals. Most servos take 500 to 2500 us, with 1500 us as their center.
///
/// CMD_SERVO_OUT_EXT (133), to the board; 4 to 68 bytes. Effect: moves. Since firmware 2.73.2.
/// Source: Later firmware.
struct ServoOutExt {
  static constexpr CommandToBoard command = CommandToBoard::servo_out_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 68;
  static constexpr Availability since{.firmware = 2732};
  using Response = void;

  /// For servo_time: the pin is set free and floats.
  static constexpr std::int16_t floating{-1};
  /// For servo_time: the pin is low all the time.
  static constexpr std::int16_t low{0};

  /// Outputs to set.
  ServoOutputs servo_bits{};
  /// Pulse of each selected output, from the lowest bit to the highest. Range: -1 to 20000 us.
  BoundedArray<ServoPulse, 32> servo_time{};

  bool operator==(const ServoOutExt&) const = default;
  using FixedMembers = Members<&ServoOutExt::servo_bits>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.counted_by(self.servo_time, detail::count_bits(self.servo_bits.raw()), "servo_time");
  }
};

/// Write to a device on an I2C bus. The sensors and the EEPROM are on these buses, too. Write only
/// to your own device, as the example does: a write to a sensor can make the camera move.
///
/// CMD_I2C_WRITE_REG_BUF (39), to the board; 2 to 255 bytes. Effect: sets, stores. Since board 3.0.
/// Source: Outgoing commands L826-L835.
struct I2cWriteRegBuf {
  static constexpr CommandToBoard command = CommandToBoard::i2c_write_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The device.
  I2cDevice device_addr{};
  /// First register.
  std::uint8_t reg_addr{};
  /// Data to write.
  BoundedBytes<253> data{};

  bool operator==(const I2cWriteRegBuf&) const = default;
  using FixedMembers = Members<&I2cWriteRegBuf::device_addr, &I2cWriteRegBuf::reg_addr>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Data from a device on an I2C bus.
///
/// CMD_I2C_READ_REG_BUF (40), from the board; 0 to 255 bytes. Since board 3.0. Source: Incoming
/// commands L458-L460.
struct I2cReadRegBuf {
  static constexpr CommandFromBoard command = CommandFromBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// The data, 1 to 255 bytes: as many as requested. At most 255.
  BoundedBytes<255> data{};

  bool operator==(const I2cReadRegBuf&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Read from a device on an I2C bus.
///
/// CMD_I2C_READ_REG_BUF (40), to the board, simple form; 3 bytes. Effect: reads. Since board 3.0.
/// Source: Outgoing commands L837-L845.
struct I2cReadRegBufRequest {
  static constexpr CommandToBoard command = CommandToBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{.board = 30};
  using Response = I2cReadRegBuf;

  /// The device.
  I2cDevice device_addr{};
  /// First register.
  std::uint8_t reg_addr{};
  /// Number of bytes to read. Range: 1 to 255 byte.
  SmallByteCount data_len{};

  bool operator==(const I2cReadRegBufRequest&) const = default;
  using FixedMembers = Members<&I2cReadRegBufRequest::device_addr, &I2cReadRegBufRequest::reg_addr,
      &I2cReadRegBufRequest::data_len>;
};

/// Read from a device without registers.
///
/// CMD_I2C_READ_REG_BUF (40), to the board, no_register form; 2 bytes. Effect: reads. Since board
/// 3.0. Unconfirmed. Source: Outgoing commands L837-L845.
struct I2cReadRegBufRequestNoRegister {
  static constexpr CommandToBoard command = CommandToBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::no_register;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.board = 30};
  using Response = I2cReadRegBuf;

  /// The device.
  I2cDevice device_addr{};
  /// Number of bytes to read. Range: 1 to 255 byte.
  SmallByteCount data_len{};

  bool operator==(const I2cReadRegBufRequestNoRegister&) const = default;
  using FixedMembers = Members<&I2cReadRegBufRequestNoRegister::device_addr,
      &I2cReadRegBufRequestNoRegister::data_len>;
};

/// Read from a device with 16-bit register addresses.
///
/// CMD_I2C_READ_REG_BUF (40), to the board, wide_register form; 4 bytes. Effect: reads. Since board
/// 3.0. Unconfirmed. Source: Outgoing commands L837-L845.
struct I2cReadRegBufRequestWideRegister {
  static constexpr CommandToBoard command = CommandToBoard::i2c_read_reg_buf;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::wide_register;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 4;
  static constexpr Availability since{.board = 30};
  using Response = I2cReadRegBuf;

  /// The device.
  I2cDevice device_addr{};
  /// First register.
  std::uint16_t reg_addr{};
  /// Number of bytes to read. Range: 1 to 255 byte.
  SmallByteCount data_len{};

  bool operator==(const I2cReadRegBufRequestWideRegister&) const = default;
  using FixedMembers = Members<&I2cReadRegBufRequestWideRegister::device_addr,
      &I2cReadRegBufRequestWideRegister::reg_addr, &I2cReadRegBufRequestWideRegister::data_len>;
};

/// Set the host's virtual RC channels, which can control the camera and more. Send all 32 channels
/// to firmware before 2.70b5.
///
/// CMD_API_VIRT_CH_CONTROL (45), to the board; 2 to 64 bytes. Effect: sets, stores, moves,
/// restarts. Since board 3.0. Source: Outgoing commands L859-L865; Variables L1190-L1191.
struct ApiVirtChControl {
  static constexpr CommandToBoard command = CommandToBoard::api_virt_ch_control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 64;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// For val_ch: undefined, as if the signal were lost.
  static constexpr std::int16_t undefined{-10000};

  /// Signal of each channel, starting with the first; the board clips values beyond the range.
  /// Range: -1 to 1. At least 1. At most 32.
  BoundedArray<CentredRcSignal, 32> val_ch{};

  bool operator==(const ApiVirtChControl&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.val_ch, "val_ch", 1);
  }
};

/// Set the host's virtual RC channels in high resolution; they can control the camera and more.
/// These are the channels that CMD_API_VIRT_CH_CONTROL sets.
///
/// CMD_API_VIRT_CH_HIGH_RES (116), to the board; 2 to 64 bytes. Effect: sets, stores, moves,
/// restarts. Since firmware 2.68b7. Source: Later firmware.
struct ApiVirtChHighRes {
  static constexpr CommandToBoard command = CommandToBoard::api_virt_ch_high_res;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 64;
  static constexpr Availability since{.firmware = 2687};
  using Response = void;

  /// For val_ch: undefined, as if the signal were lost.
  static constexpr std::int16_t undefined{-32768};

  /// Signal of each channel, starting with the first. Range: -1 to 1. At least 1. At most 32.
  BoundedArray<FineRcSignal, 32> val_ch{};

  bool operator==(const ApiVirtChHighRes&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.val_ch, "val_ch", 1);
  }
};

/// RC signals of selected inputs.
///
/// CMD_READ_RC_INPUTS (100), from the board; 0 to 254 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct ReadRcInputs {
  static constexpr CommandFromBoard command = CommandFromBoard::read_rc_inputs;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 254;
  static constexpr Availability since{.firmware = 2600};

  /// For rc_val: undefined.
  static constexpr std::int16_t undefined{-32768};

  /// Signal of each requested input, in the order of the request. Range: -1 to 1. At most 127.
  BoundedArray<FineRcSignal, 127> rc_val{};

  bool operator==(const ReadRcInputs&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.rc_val, "rc_val");
  }
};

/// Request the RC signals of selected inputs.
///
/// CMD_READ_RC_INPUTS (100), to the board; 2 to 129 bytes. Effect: sets. Since firmware 2.60.
/// Source: Later firmware.
struct ReadRcInputsRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_rc_inputs;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 129;
  static constexpr Availability since{.firmware = 2600};
  using Response = ReadRcInputs;

  /// Options.
  RcInputOptions cfg_flags{};
  /// The inputs; more than 127 signals do not fit into the response. At most 127.
  BoundedArray<RcMap, 253> rc_src{};

  bool operator==(const ReadRcInputsRequest&) const = default;
  using FixedMembers = Members<&ReadRcInputsRequest::cfg_flags>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.rc_src, "rc_src");
  }
};

}  // namespace sbgc::msg
