// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/peripherals.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::BeepSound> {
  static constexpr MessageInfo info{
      .name = "BeepSound", .command = "CMD_BEEP_SOUND",
      .summary = "Play a melody through the motors, or a standard sound.", .id = 89,
      .direction = Direction::to_board, .min_size = 12, .max_size = 112,
      .since = {.firmware = 2590, .board = 30}, .effects = Effects(Effect::sets)};
  static constexpr Range note_length_range{1, 255};
  static constexpr Special note_length_special[] = {
      {0, "without meaning unless a custom melody is played"},
  };
  static constexpr Range decay_factor_range{0, 15};
  static constexpr Special decay_factor_special[] = {
      {0, "no envelope"},
  };
  static constexpr Range note_freq_hz_range{554, 20999};
  static constexpr Special note_freq_hz_special[] = {
      {21000, "pause, then the envelope starts again"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Sound to play."},
      {.name = "note_length", .spec_name = "NOTE_LENGTH",
       .summary = "Length of each note of a custom melody.",
       .unit = &UnitMeta<msg::NoteLength>::info, .range = &note_length_range,
       .special = note_length_special},
      {.name = "decay_factor", .spec_name = "DECAY_FACTOR",
       .summary = "How slowly a note fades after each pause; 0 disables the envelope. Audible only with encoder firmware or while the motors are off.",
       .range = &decay_factor_range, .special = decay_factor_special},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "note_freq_hz", .spec_name = "NOTE_FREQ_HZ",
       .summary = "The notes of a custom melody; at most 30 in firmware of the specification's time.",
       .unit = &UnitMeta<msg::NoteFrequency>::info, .range = &note_freq_hz_range,
       .special = note_freq_hz_special, .max_count = 50},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, note_length), &detail::value_type<decltype(T::note_length)>},
      {offsetof(T, decay_factor), &detail::value_type<decltype(T::decay_factor)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
      {offsetof(T, note_freq_hz), &detail::value_type<decltype(T::note_freq_hz)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.note_length);
    visitor(fields[2], value.decay_factor);
    visitor(fields[3], value.reserved);
    visitor(fields[4], value.note_freq_hz);
  }
};

template <>
struct Meta<msg::TriggerPin> {
  static constexpr MessageInfo info{
      .name = "TriggerPin", .command = "CMD_TRIGGER_PIN", .summary = "Switch an output pin.",
      .id = 84, .direction = Direction::to_board, .min_size = 2, .max_size = 2,
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "pin_id", .spec_name = "PIN_ID", .summary = "The pin."},
      {.name = "state", .spec_name = "STATE", .summary = "New state of the pin."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, pin_id), &detail::value_type<decltype(T::pin_id)>},
      {offsetof(T, state), &detail::value_type<decltype(T::state)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.pin_id);
    visitor(fields[1], value.state);
  }
};

template <>
struct Meta<msg::ServoOut> {
  static constexpr MessageInfo info{
      .name = "ServoOut", .command = "CMD_SERVO_OUT", .summary = "Send PWM signals to eight servos.",
      .id = 36, .direction = Direction::to_board, .min_size = 16, .max_size = 16,
      .since = {.board = 30}, .effects = Effects(Effect::moves)};
  static constexpr Range servo_time_range{-1, 20000};
  static constexpr Special servo_time_special[] = {
      {-1, "the pin is set free and floats"},
      {0, "the pin is low all the time"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "servo_time", .spec_name = "SERVO{1..8}_TIME", .summary = "Pulse of each output.",
       .unit = &UnitMeta<msg::ServoPulse>::info, .range = &servo_time_range,
       .special = servo_time_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, servo_time), &detail::value_type<decltype(T::servo_time)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.servo_time);
  }
};

template <>
struct Meta<msg::ServoOutFour> {
  static constexpr MessageInfo info{
      .name = "ServoOutFour", .command = "CMD_SERVO_OUT",
      .summary = "Send PWM signals to the servos 1 to 4.", .id = 36,
      .direction = Direction::to_board, .min_size = 8, .max_size = 8, .since = {.board = 30},
      .effects = Effects(Effect::moves)};
  static constexpr Range servo_time_range{-1, 20000};
  static constexpr Special servo_time_special[] = {
      {-1, "the pin is set free and floats"},
      {0, "the pin is low all the time"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "servo_time", .spec_name = "SERVO{1..4}_TIME", .summary = "Pulse of each output.",
       .unit = &UnitMeta<msg::ServoPulse>::info, .range = &servo_time_range,
       .special = servo_time_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, servo_time), &detail::value_type<decltype(T::servo_time)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.servo_time);
  }
};

template <>
struct Meta<msg::ServoOutExt> {
  static constexpr MessageInfo info{
      .name = "ServoOutExt", .command = "CMD_SERVO_OUT_EXT",
      .summary = "Send PWM signals to servos of the board and of its CAN motor drivers.", .id = 133,
      .direction = Direction::to_board, .min_size = 4, .max_size = 68, .since = {.firmware = 2732},
      .effects = Effects(Effect::moves)};
  static constexpr Range servo_time_range{-1, 20000};
  static constexpr Special servo_time_special[] = {
      {-1, "the pin is set free and floats"},
      {0, "the pin is low all the time"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "servo_bits", .spec_name = "SERVO_BITS", .summary = "Outputs to set."},
      {.name = "servo_time", .spec_name = "SERVO_TIME",
       .summary = "Pulse of each selected output, from the lowest bit to the highest.",
       .unit = &UnitMeta<msg::ServoPulse>::info, .range = &servo_time_range,
       .special = servo_time_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, servo_bits), &detail::value_type<decltype(T::servo_bits)>},
      {offsetof(T, servo_time), &detail::value_type<decltype(T::servo_time)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.servo_bits);
    visitor(fields[1], value.servo_time);
  }
};

template <>
struct Meta<msg::I2cWriteRegBuf> {
  static constexpr MessageInfo info{
      .name = "I2cWriteRegBuf", .command = "CMD_I2C_WRITE_REG_BUF",
      .summary = "Write to a device on an I2C bus.", .id = 39, .direction = Direction::to_board,
      .min_size = 2, .max_size = 255, .since = {.board = 30},
      .effects = Effects(Effect::sets) | Effect::stores};
  static constexpr FieldInfo fields[] = {
      {.name = "device_addr", .spec_name = "DEVICE_ADDR", .summary = "The device."},
      {.name = "reg_addr", .spec_name = "REG_ADDR", .summary = "First register."},
      {.name = "data", .spec_name = "DATA", .summary = "Data to write."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_addr), &detail::value_type<decltype(T::device_addr)>},
      {offsetof(T, reg_addr), &detail::value_type<decltype(T::reg_addr)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_addr);
    visitor(fields[1], value.reg_addr);
    visitor(fields[2], value.data);
  }
};

template <>
struct Meta<msg::I2cReadRegBuf> {
  static constexpr MessageInfo info{
      .name = "I2cReadRegBuf", .command = "CMD_I2C_READ_REG_BUF",
      .summary = "Data from a device on an I2C bus.", .id = 40, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA",
       .summary = "The data, 1 to 255 bytes: as many as requested.", .max_count = 255},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::I2cReadRegBufRequest> {
  static constexpr const char* answers[] = {"I2cReadRegBuf"};
  static constexpr MessageInfo info{
      .name = "I2cReadRegBufRequest", .command = "CMD_I2C_READ_REG_BUF",
      .summary = "Read from a device on an I2C bus.", .id = 40, .direction = Direction::to_board,
      .min_size = 3, .max_size = 3, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr Range data_len_range{1, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "device_addr", .spec_name = "DEVICE_ADDR", .summary = "The device."},
      {.name = "reg_addr", .spec_name = "REG_ADDR", .summary = "First register."},
      {.name = "data_len", .spec_name = "DATA_LEN", .summary = "Number of bytes to read.",
       .unit = &UnitMeta<msg::SmallByteCount>::info, .range = &data_len_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_addr), &detail::value_type<decltype(T::device_addr)>},
      {offsetof(T, reg_addr), &detail::value_type<decltype(T::reg_addr)>},
      {offsetof(T, data_len), &detail::value_type<decltype(T::data_len)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_addr);
    visitor(fields[1], value.reg_addr);
    visitor(fields[2], value.data_len);
  }
};

template <>
struct Meta<msg::I2cReadRegBufRequestNoRegister> {
  static constexpr const char* answers[] = {"I2cReadRegBuf"};
  static constexpr MessageInfo info{
      .name = "I2cReadRegBufRequestNoRegister", .command = "CMD_I2C_READ_REG_BUF",
      .summary = "Read from a device without registers.", .id = 40, .direction = Direction::to_board,
      .min_size = 2, .max_size = 2, .since = {.board = 30}, .unconfirmed = true, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr Range data_len_range{1, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "device_addr", .spec_name = "DEVICE_ADDR", .summary = "The device."},
      {.name = "data_len", .spec_name = "DATA_LEN", .summary = "Number of bytes to read.",
       .unit = &UnitMeta<msg::SmallByteCount>::info, .range = &data_len_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_addr), &detail::value_type<decltype(T::device_addr)>},
      {offsetof(T, data_len), &detail::value_type<decltype(T::data_len)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_addr);
    visitor(fields[1], value.data_len);
  }
};

template <>
struct Meta<msg::I2cReadRegBufRequestWideRegister> {
  static constexpr const char* answers[] = {"I2cReadRegBuf"};
  static constexpr MessageInfo info{
      .name = "I2cReadRegBufRequestWideRegister", .command = "CMD_I2C_READ_REG_BUF",
      .summary = "Read from a device with 16-bit register addresses.", .id = 40,
      .direction = Direction::to_board, .min_size = 4, .max_size = 4, .since = {.board = 30},
      .unconfirmed = true, .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range data_len_range{1, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "device_addr", .spec_name = "DEVICE_ADDR", .summary = "The device."},
      {.name = "reg_addr", .spec_name = "REG_ADDR", .summary = "First register."},
      {.name = "data_len", .spec_name = "DATA_LEN", .summary = "Number of bytes to read.",
       .unit = &UnitMeta<msg::SmallByteCount>::info, .range = &data_len_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_addr), &detail::value_type<decltype(T::device_addr)>},
      {offsetof(T, reg_addr), &detail::value_type<decltype(T::reg_addr)>},
      {offsetof(T, data_len), &detail::value_type<decltype(T::data_len)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_addr);
    visitor(fields[1], value.reg_addr);
    visitor(fields[2], value.data_len);
  }
};

template <>
struct Meta<msg::ApiVirtChControl> {
  static constexpr MessageInfo info{
      .name = "ApiVirtChControl", .command = "CMD_API_VIRT_CH_CONTROL",
      .summary = "Set the host's virtual RC channels, which can control the camera and more.",
      .id = 45, .direction = Direction::to_board, .min_size = 2, .max_size = 64,
      .since = {.board = 30},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr Range val_ch_range{-500, 500};
  static constexpr Special val_ch_special[] = {
      {-10000, "undefined, as if the signal were lost"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "val_ch", .spec_name = "VAL_CH{1..32}",
       .summary = "Signal of each channel, starting with the first; the board clips values beyond the range.",
       .unit = &UnitMeta<msg::CentredRcSignal>::info, .range = &val_ch_range,
       .special = val_ch_special, .min_count = 1, .max_count = 32},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, val_ch), &detail::value_type<decltype(T::val_ch)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.val_ch);
  }
};

template <>
struct Meta<msg::ApiVirtChHighRes> {
  static constexpr MessageInfo info{
      .name = "ApiVirtChHighRes", .command = "CMD_API_VIRT_CH_HIGH_RES",
      .summary = "Set the host's virtual RC channels in high resolution; they can control the camera and more.",
      .id = 116, .direction = Direction::to_board, .min_size = 2, .max_size = 64,
      .since = {.firmware = 2687},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr Range val_ch_range{-16384, 16384};
  static constexpr Special val_ch_special[] = {
      {-32768, "undefined, as if the signal were lost"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "val_ch", .spec_name = "VAL_CH{1..32}",
       .summary = "Signal of each channel, starting with the first.",
       .unit = &UnitMeta<msg::FineRcSignal>::info, .range = &val_ch_range, .special = val_ch_special,
       .min_count = 1, .max_count = 32},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, val_ch), &detail::value_type<decltype(T::val_ch)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.val_ch);
  }
};

template <>
struct Meta<msg::ReadRcInputs> {
  static constexpr MessageInfo info{
      .name = "ReadRcInputs", .command = "CMD_READ_RC_INPUTS",
      .summary = "RC signals of selected inputs.", .id = 100, .direction = Direction::from_board,
      .min_size = 0, .max_size = 254, .since = {.firmware = 2600}};
  static constexpr Range rc_val_range{-16384, 16384};
  static constexpr Special rc_val_special[] = {
      {-32768, "undefined"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "rc_val", .spec_name = "RC_VAL",
       .summary = "Signal of each requested input, in the order of the request.",
       .unit = &UnitMeta<msg::FineRcSignal>::info, .range = &rc_val_range, .special = rc_val_special,
       .max_count = 127},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, rc_val), &detail::value_type<decltype(T::rc_val)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.rc_val);
  }
};

template <>
struct Meta<msg::ReadRcInputsRequest> {
  static constexpr const char* answers[] = {"ReadRcInputs"};
  static constexpr MessageInfo info{
      .name = "ReadRcInputsRequest", .command = "CMD_READ_RC_INPUTS",
      .summary = "Request the RC signals of selected inputs.", .id = 100,
      .direction = Direction::to_board, .min_size = 2, .max_size = 129, .since = {.firmware = 2600},
      .answers = answers, .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "cfg_flags", .spec_name = "CFG_FLAGS", .summary = "Options."},
      {.name = "rc_src", .spec_name = "RC_SRC",
       .summary = "The inputs; more than 127 signals do not fit into the response.",
       .max_count = 127},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cfg_flags), &detail::value_type<decltype(T::cfg_flags)>},
      {offsetof(T, rc_src), &detail::value_type<decltype(T::rc_src)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cfg_flags);
    visitor(fields[1], value.rc_src);
  }
};

}  // namespace sbgc
