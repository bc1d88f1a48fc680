// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/system.hpp>.
#pragma once

#include <sbgc/messages/system.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::BoardInfo> {
  static constexpr MessageInfo info{
      .name = "BoardInfo",
      .command = "CMD_BOARD_INFO",
      .summary = "Board version and features.",
      .id = 86,
      .direction = Direction::from_board,
      .min_size = 18,
      .max_size = 18};
  static constexpr Special debug_mode_special[] = {
      {0, "a host should hide its debug output"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "board_ver",
       .spec_name = "BOARD_VER",
       .summary = "Hardware version."},
      {.name = "firmware_ver",
       .spec_name = "FIRMWARE_VER",
       .summary = "Firmware version."},
      {.name = "debug_mode",
       .spec_name = "DEBUG_MODE",
       .summary = "Whether debug output is enabled.",
       .special = debug_mode_special},
      {.name = "board_features",
       .spec_name = "BOARD_FEATURES",
       .summary = "Features of the board."},
      {.name = "connection_flags",
       .spec_name = "CONNECTION_FLAGS",
       .summary = "How this host is connected."},
      {.name = "frw_extra_id",
       .spec_name = "FRW_EXTRA_ID",
       .summary = "Identifies special firmware builds."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Later firmware holds more feature bits, IMU models and a base firmware version here.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.board_ver);
    visitor(fields[1], value.firmware_ver);
    visitor(fields[2], value.debug_mode);
    visitor(fields[3], value.board_features);
    visitor(fields[4], value.connection_flags);
    visitor(fields[5], value.frw_extra_id);
    visitor(fields[6], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfoRequest> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequest",
      .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version.",
      .id = 86,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::BoardInfoRequestOneByte> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequestOneByte",
      .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version, with a byte that has no meaning.",
      .id = 86,
      .direction = Direction::to_board,
      .min_size = 1,
      .max_size = 1,
      .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.reserved);
  }
};

template <>
struct Meta<msg::BoardInfoRequestExt> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequestExt",
      .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version, and configure this serial port.",
      .id = 86,
      .direction = Direction::to_board,
      .min_size = 2,
      .max_size = 255,
      .answers = answers,
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "cfg",
       .spec_name = "CFG",
       .summary = "On a UART, the pause between the 20-byte packets of a Bluetooth LE link; no meaning on USB.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Of undefined size; send it empty.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.cfg);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::Confirm> {
  static constexpr MessageInfo info{
      .name = "Confirm",
      .command = "CMD_CONFIRM",
      .summary = "The board executed a command.",
      .id = 67,
      .direction = Direction::from_board,
      .min_size = 1,
      .max_size = 6};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd",
       .spec_name = "CMD",
       .summary = "The confirmed command."},
      {.name = "addr",
       .spec_name = "ADDR",
       .summary = "Address of the written block."},
      {.name = "err_code",
       .spec_name = "ERR_CODE",
       .summary = "Result of the file operation."},
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Data of other commands; usually empty.",
       .max_count = 5},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.cmd);
    visitor(fields[1], value.addr);
    visitor(fields[2], value.err_code);
    visitor(fields[3], value.data);
  }
};

template <>
struct Meta<msg::Error> {
  static constexpr MessageInfo info{
      .name = "Error",
      .command = "CMD_ERROR",
      .summary = "An error as the specification describes it.",
      .id = 255,
      .direction = Direction::from_board,
      .min_size = 5,
      .max_size = 5,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "error_code",
       .spec_name = "ERROR_CODE",
       .summary = "Error code."},
      {.name = "error_data",
       .spec_name = "ERROR_DATA",
       .summary = "Details that depend on the code."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.error_code);
    visitor(fields[1], value.error_data);
  }
};

template <>
struct Meta<msg::ErrorExt> {
  static constexpr MessageInfo info{
      .name = "ErrorExt",
      .command = "CMD_ERROR",
      .summary = "An error as real boards send it, with the failed command.",
      .id = 255,
      .direction = Direction::from_board,
      .min_size = 6,
      .max_size = 6,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id",
       .spec_name = "CMD_ID",
       .summary = "The failed command."},
      {.name = "error_code",
       .spec_name = "ERROR_CODE",
       .summary = "Error code."},
      {.name = "error_data",
       .spec_name = "ERROR_DATA",
       .summary = "Details that depend on the code."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.error_code);
    visitor(fields[2], value.error_data);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfo3> {
  static constexpr MessageInfo info{
      .name = "BoardInfo3",
      .command = "CMD_BOARD_INFO_3",
      .summary = "Serial numbers, memory and scripts of the board.",
      .id = 20,
      .direction = Direction::from_board,
      .min_size = 69,
      .max_size = 69,
      .since = {.board = 30}};
  static constexpr Special script_slot_size_special[] = {
      {0, "the slot is empty"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "device_id",
       .spec_name = "deviceID",
       .summary = "Identifies the board."},
      {.name = "mcu_id",
       .spec_name = "mcuID",
       .summary = "Identifies the microcontroller."},
      {.name = "eeprom_size",
       .spec_name = "EEPROM_SIZE",
       .summary = "Size of the EEPROM.",
       .unit = &UnitMeta<msg::LongByteCount>::info},
      {.name = "script_slot_size",
       .spec_name = "SCRIPT_SLOT{1..5}_SIZE",
       .summary = "Size of the user script in each slot.",
       .unit = &UnitMeta<msg::ByteCount>::info,
       .special = script_slot_size_special},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.device_id);
    visitor(fields[1], value.mcu_id);
    visitor(fields[2], value.eeprom_size);
    visitor(fields[3], value.script_slot_size);
    visitor(fields[4], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfo3Request> {
  static constexpr const char* answers[] = {"BoardInfo3"};
  static constexpr MessageInfo info{
      .name = "BoardInfo3Request",
      .command = "CMD_BOARD_INFO_3",
      .summary = "Request serial numbers, memory and scripts of the board.",
      .id = 20,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::Reset> {
  static constexpr MessageInfo info{
      .name = "Reset",
      .command = "CMD_RESET",
      .summary = "The board is about to restart.",
      .id = 114,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 0};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ResetRequest> {
  static constexpr MessageInfo info{
      .name = "ResetRequest",
      .command = "CMD_RESET",
      .summary = "Restart immediately, without notification.",
      .id = 114,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::restarts)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::ResetRequestExt> {
  static constexpr const char* answers[] = {"Reset"};
  static constexpr MessageInfo info{
      .name = "ResetRequestExt",
      .command = "CMD_RESET",
      .summary = "Restart after a delay, with an optional notification.",
      .id = 114,
      .direction = Direction::to_board,
      .min_size = 3,
      .max_size = 3,
      .answers = answers,
      .effects = Effects(Effect::restarts)};
  static constexpr FieldInfo fields[] = {
      {.name = "confirm",
       .spec_name = "CONFIRM",
       .summary = "Whether CMD_RESET is sent back first."},
      {.name = "delay_ms",
       .spec_name = "DELAY_MS",
       .summary = "Delay before the restart.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.confirm);
    visitor(fields[1], value.delay_ms);
  }
};

template <>
struct Meta<msg::BootMode3> {
  static constexpr MessageInfo info{
      .name = "BootMode3",
      .command = "CMD_BOOT_MODE_3",
      .summary = "Enter the bootloader immediately, without notification.",
      .id = 51,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .effects = Effects(Effect::restarts)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::BootMode3Ext> {
  static constexpr const char* answers[] = {"Reset"};
  static constexpr MessageInfo info{
      .name = "BootMode3Ext",
      .command = "CMD_BOOT_MODE_3",
      .summary = "Enter the bootloader after a delay, with an optional notification.",
      .id = 51,
      .direction = Direction::to_board,
      .min_size = 3,
      .max_size = 3,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::restarts)};
  static constexpr FieldInfo fields[] = {
      {.name = "confirm",
       .spec_name = "CONFIRM",
       .summary = "Whether CMD_RESET is sent back first."},
      {.name = "delay_ms",
       .spec_name = "DELAY_MS",
       .summary = "Delay before the bootloader starts.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.confirm);
    visitor(fields[1], value.delay_ms);
  }
};

template <>
struct Meta<msg::QueueParamsInfo3> {
  static constexpr MessageInfo info{
      .name = "QueueParamsInfo3",
      .command = "CMD_QUEUE_PARAMS_INFO_3",
      .summary = "Undocumented body from the board.",
      .id = 30,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::QueueParamsInfo3Request> {
  static constexpr MessageInfo info{
      .name = "QueueParamsInfo3Request",
      .command = "CMD_QUEUE_PARAMS_INFO_3",
      .summary = "Undocumented body to the board.",
      .id = 30,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SystemState> {
  static constexpr MessageInfo info{
      .name = "SystemState",
      .command = "CMD_SYSTEM_STATE",
      .summary = "Undocumented body from the board.",
      .id = 52,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SystemStateRequest> {
  static constexpr MessageInfo info{
      .name = "SystemStateRequest",
      .command = "CMD_SYSTEM_STATE",
      .summary = "Undocumented body to the board.",
      .id = 52,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkInfo> {
  static constexpr MessageInfo info{
      .name = "MavlinkInfo",
      .command = "CMD_MAVLINK_INFO",
      .summary = "Undocumented body from the board.",
      .id = 250,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkInfoRequest> {
  static constexpr MessageInfo info{
      .name = "MavlinkInfoRequest",
      .command = "CMD_MAVLINK_INFO",
      .summary = "Undocumented body to the board.",
      .id = 250,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkDebug> {
  static constexpr MessageInfo info{
      .name = "MavlinkDebug",
      .command = "CMD_MAVLINK_DEBUG",
      .summary = "Undocumented body from the board.",
      .id = 251,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkDebugRequest> {
  static constexpr MessageInfo info{
      .name = "MavlinkDebugRequest",
      .command = "CMD_MAVLINK_DEBUG",
      .summary = "Undocumented body to the board.",
      .id = 251,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data",
       .spec_name = "DATA",
       .summary = "Undocumented content."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.data);
  }
};

}  // namespace sbgc
