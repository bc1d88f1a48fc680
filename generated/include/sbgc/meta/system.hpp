// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/system.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::BoardInfo> {
  static constexpr MessageInfo info{
      .name = "BoardInfo", .command = "CMD_BOARD_INFO", .summary = "Board version and features.",
      .id = 86, .direction = Direction::from_board, .min_size = 18, .max_size = 18};
  static constexpr Special firmware_ver_special[] = {
      {0, "unknown; the sensors are often unplugged"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "board_ver", .spec_name = "BOARD_VER", .summary = "Hardware version."},
      {.name = "firmware_ver", .spec_name = "FIRMWARE_VER", .summary = "Firmware version.",
       .special = firmware_ver_special},
      {.name = "debug_mode", .spec_name = "DEBUG_MODE",
       .summary = "State of the board; before later firmware, only whether debug output is enabled."},
      {.name = "board_features", .spec_name = "BOARD_FEATURES", .summary = "Features of the board."},
      {.name = "connection_flags", .spec_name = "CONNECTION_FLAGS",
       .summary = "How this host is connected."},
      {.name = "frw_extra_id", .spec_name = "FRW_EXTRA_ID",
       .summary = "Identifies special firmware builds."},
      {.name = "board_features_ext", .spec_name = "BOARD_FEATURES_EXT",
       .summary = "More features of the board."},
      {.name = "main_imu_sens_model", .spec_name = "MAIN_IMU_SENS_MODEL",
       .summary = "Model of the main IMU's sensor."},
      {.name = "frame_imu_sens_model", .spec_name = "FRAME_IMU_SENS_MODEL",
       .summary = "Model of the frame IMU's sensor."},
      {.name = "build_number", .spec_name = "BUILD_NUMBER",
       .summary = "Build of the firmware version."},
      {.name = "base_frw_ver", .spec_name = "BASE_FRW_VER",
       .summary = "Main version on which an experimental version is based."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, board_ver), &detail::value_type<decltype(T::board_ver)>},
      {offsetof(T, firmware_ver), &detail::value_type<decltype(T::firmware_ver)>},
      {offsetof(T, debug_mode), &detail::value_type<decltype(T::debug_mode)>},
      {offsetof(T, board_features), &detail::value_type<decltype(T::board_features)>},
      {offsetof(T, connection_flags), &detail::value_type<decltype(T::connection_flags)>},
      {offsetof(T, frw_extra_id), &detail::value_type<decltype(T::frw_extra_id)>},
      {offsetof(T, board_features_ext), &detail::value_type<decltype(T::board_features_ext)>},
      {offsetof(T, main_imu_sens_model), &detail::value_type<decltype(T::main_imu_sens_model)>},
      {offsetof(T, frame_imu_sens_model), &detail::value_type<decltype(T::frame_imu_sens_model)>},
      {offsetof(T, build_number), &detail::value_type<decltype(T::build_number)>},
      {offsetof(T, base_frw_ver), &detail::value_type<decltype(T::base_frw_ver)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.board_ver);
    visitor(fields[1], value.firmware_ver);
    visitor(fields[2], value.debug_mode);
    visitor(fields[3], value.board_features);
    visitor(fields[4], value.connection_flags);
    visitor(fields[5], value.frw_extra_id);
    visitor(fields[6], value.board_features_ext);
    visitor(fields[7], value.main_imu_sens_model);
    visitor(fields[8], value.frame_imu_sens_model);
    visitor(fields[9], value.build_number);
    visitor(fields[10], value.base_frw_ver);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfoRequest> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequest", .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version.", .id = 86,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::BoardInfoRequestOneByte> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequestOneByte", .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version, with a byte that has no meaning.",
      .id = 86, .direction = Direction::to_board, .min_size = 1, .max_size = 1, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.reserved);
  }
};

template <>
struct Meta<msg::BoardInfoRequestExt> {
  static constexpr const char* answers[] = {"BoardInfo"};
  static constexpr MessageInfo info{
      .name = "BoardInfoRequestExt", .command = "CMD_BOARD_INFO",
      .summary = "Request the board and firmware version, and configure this serial port.", .id = 86,
      .direction = Direction::to_board, .min_size = 2, .max_size = 255, .secret_from = 2,
      .answers = answers, .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "cfg", .spec_name = "CFG",
       .summary = "On a UART, the pause between the 20-byte packets of a Bluetooth LE link; no meaning on USB.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "password", .spec_name = "PASSWORD",
       .summary = "Opens a port with a password, from firmware 2.73.6 on.", .secret = true},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cfg), &detail::value_type<decltype(T::cfg)>},
      {offsetof(T, password), &detail::value_type<decltype(T::password)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cfg);
    visitor(fields[1], value.password);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::Confirm> {
  static constexpr MessageInfo info{
      .name = "Confirm", .command = "CMD_CONFIRM", .summary = "The board executed a command.",
      .id = 67, .direction = Direction::from_board, .min_size = 1, .max_size = 6};
  static constexpr Range pin_state_range{0, 1};
  static constexpr Special pin_state_special[] = {
      {-1, "the pin is unavailable"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "cmd", .spec_name = "CMD", .summary = "The confirmed command."},
      {.name = "addr", .spec_name = "ADDR", .summary = "Address of the written block."},
      {.name = "err_code", .spec_name = "ERR_CODE", .summary = "Result of the file operation."},
      {.name = "pin_id", .spec_name = "PIN_ID", .summary = "The pin that became an input."},
      {.name = "pin_state", .spec_name = "PIN_STATE", .summary = "Its level.",
       .range = &pin_state_range, .special = pin_state_special},
      {.name = "data", .spec_name = "DATA",
       .summary = "Data of other commands; usually empty, or 0 for success.", .max_count = 5},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd), &detail::value_type<decltype(T::cmd)>},
      {offsetof(T, addr), &detail::value_type<decltype(T::addr)>},
      {offsetof(T, err_code), &detail::value_type<decltype(T::err_code)>},
      {offsetof(T, pin_id), &detail::value_type<decltype(T::pin_id)>},
      {offsetof(T, pin_state), &detail::value_type<decltype(T::pin_state)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd);
    visitor(fields[1], value.addr);
    visitor(fields[2], value.err_code);
    visitor(fields[3], value.pin_id);
    visitor(fields[4], value.pin_state);
    visitor(fields[5], value.data);
  }
};

template <>
struct Meta<msg::Error> {
  static constexpr MessageInfo info{
      .name = "Error", .command = "CMD_ERROR",
      .summary = "An error as the specification describes it.", .id = 255,
      .direction = Direction::from_board, .min_size = 5, .max_size = 5, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "error_code", .spec_name = "ERROR_CODE", .summary = "Error code."},
      {.name = "error_data", .spec_name = "ERROR_DATA",
       .summary = "Details that depend on the code."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, error_code), &detail::value_type<decltype(T::error_code)>},
      {offsetof(T, error_data), &detail::value_type<decltype(T::error_data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.error_code);
    visitor(fields[1], value.error_data);
  }
};

template <>
struct Meta<msg::ErrorExt> {
  static constexpr MessageInfo info{
      .name = "ErrorExt", .command = "CMD_ERROR",
      .summary = "An error as real boards send it, with the failed command.", .id = 255,
      .direction = Direction::from_board, .min_size = 6, .max_size = 6, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "The failed command."},
      {.name = "error_code", .spec_name = "ERROR_CODE", .summary = "Error code."},
      {.name = "error_data", .spec_name = "ERROR_DATA",
       .summary = "Details that depend on the code."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, error_code), &detail::value_type<decltype(T::error_code)>},
      {offsetof(T, error_data), &detail::value_type<decltype(T::error_data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.error_code);
    visitor(fields[2], value.error_data);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfo3> {
  static constexpr MessageInfo info{
      .name = "BoardInfo3", .command = "CMD_BOARD_INFO_3",
      .summary = "Serial numbers, memory and scripts of the board.", .id = 20,
      .direction = Direction::from_board, .min_size = 69, .max_size = 69, .since = {.board = 30}};
  static constexpr Special script_slot_size_special[] = {
      {0, "the slot is empty"},
  };
  static constexpr Range profile_set_cur_range{1, 6};
  static constexpr Special profile_set_cur_special[] = {
      {0, "earlier firmware has no profile sets"},
  };
  static constexpr Special script_slot_6_to_10_size_special[] = {
      {0, "the slot is empty"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "device_id", .spec_name = "deviceID", .summary = "Identifies the board."},
      {.name = "mcu_id", .spec_name = "mcuID", .summary = "Identifies the microcontroller."},
      {.name = "eeprom_size", .spec_name = "EEPROM_SIZE", .summary = "Size of the EEPROM.",
       .unit = &UnitMeta<msg::LongByteCount>::info},
      {.name = "script_slot_size", .spec_name = "SCRIPT_SLOT{1..5}_SIZE",
       .summary = "Size of the user script in each slot.", .unit = &UnitMeta<msg::ByteCount>::info,
       .special = script_slot_size_special},
      {.name = "profile_set_slots", .spec_name = "PROFILE_SET_SLOTS",
       .summary = "Profile sets in memory."},
      {.name = "profile_set_cur", .spec_name = "PROFILE_SET_CUR",
       .summary = "Selected profile set; 6 is the backup.", .range = &profile_set_cur_range,
       .special = profile_set_cur_special},
      {.name = "flash_size", .spec_name = "FLASH_SIZE", .summary = "Size of the flash memory.",
       .unit = &UnitMeta<msg::FlashSize>::info},
      {.name = "imu_calib_info", .spec_name = "IMU_CALIB_INFO",
       .summary = "Information about the calibrations of the IMUs."},
      {.name = "script_slot_6_to_10_size", .spec_name = "SCRIPT_SLOT{6..10}_SIZE",
       .summary = "Size of the user script in each of slots 6 to 10.",
       .unit = &UnitMeta<msg::ByteCount>::info, .special = script_slot_6_to_10_size_special},
      {.name = "hw_flags", .spec_name = "HW_FLAGS", .summary = "Hardware on the board."},
      {.name = "board_features_ext2", .spec_name = "BOARD_FEATURES_EXT2",
       .summary = "More features of the board.", .since = {.firmware = 2730}},
      {.name = "can_drv_main_limit", .spec_name = "CAN_DRV_MAIN_LIMIT",
       .summary = "Number of licensed CAN motor drivers for the main axes.",
       .since = {.firmware = 2723}},
      {.name = "can_drv_aux_limit", .spec_name = "CAN_DRV_AUX_LIMIT",
       .summary = "Number of licensed CAN motor drivers for auxiliary motors.",
       .since = {.firmware = 2723}},
      {.name = "adj_vars_total_num", .spec_name = "ADJ_VARS_TOTAL_NUM",
       .summary = "Number of adjustable variables.", .since = {.firmware = 2730}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, device_id), &detail::value_type<decltype(T::device_id)>},
      {offsetof(T, mcu_id), &detail::value_type<decltype(T::mcu_id)>},
      {offsetof(T, eeprom_size), &detail::value_type<decltype(T::eeprom_size)>},
      {offsetof(T, script_slot_size), &detail::value_type<decltype(T::script_slot_size)>},
      {offsetof(T, profile_set_slots), &detail::value_type<decltype(T::profile_set_slots)>},
      {offsetof(T, profile_set_cur), &detail::value_type<decltype(T::profile_set_cur)>},
      {offsetof(T, flash_size), &detail::value_type<decltype(T::flash_size)>},
      {offsetof(T, imu_calib_info), &detail::value_type<decltype(T::imu_calib_info)>},
      {offsetof(T, script_slot_6_to_10_size), &detail::value_type<decltype(T::script_slot_6_to_10_size)>},
      {offsetof(T, hw_flags), &detail::value_type<decltype(T::hw_flags)>},
      {offsetof(T, board_features_ext2), &detail::value_type<decltype(T::board_features_ext2)>},
      {offsetof(T, can_drv_main_limit), &detail::value_type<decltype(T::can_drv_main_limit)>},
      {offsetof(T, can_drv_aux_limit), &detail::value_type<decltype(T::can_drv_aux_limit)>},
      {offsetof(T, adj_vars_total_num), &detail::value_type<decltype(T::adj_vars_total_num)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.device_id);
    visitor(fields[1], value.mcu_id);
    visitor(fields[2], value.eeprom_size);
    visitor(fields[3], value.script_slot_size);
    visitor(fields[4], value.profile_set_slots);
    visitor(fields[5], value.profile_set_cur);
    visitor(fields[6], value.flash_size);
    visitor(fields[7], value.imu_calib_info);
    visitor(fields[8], value.script_slot_6_to_10_size);
    visitor(fields[9], value.hw_flags);
    visitor(fields[10], value.board_features_ext2);
    visitor(fields[11], value.can_drv_main_limit);
    visitor(fields[12], value.can_drv_aux_limit);
    visitor(fields[13], value.adj_vars_total_num);
    visitor(fields[14], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BoardInfo3Request> {
  static constexpr const char* answers[] = {"BoardInfo3"};
  static constexpr MessageInfo info{
      .name = "BoardInfo3Request", .command = "CMD_BOARD_INFO_3",
      .summary = "Request serial numbers, memory and scripts of the board.", .id = 20,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::Reset> {
  static constexpr MessageInfo info{
      .name = "Reset", .command = "CMD_RESET", .summary = "The board is about to restart.",
      .id = 114, .direction = Direction::from_board, .min_size = 0, .max_size = 0};

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ResetRequest> {
  static constexpr MessageInfo info{
      .name = "ResetRequest", .command = "CMD_RESET",
      .summary = "Restart immediately, without notification.", .id = 114,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::restarts)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::ResetRequestExt> {
  static constexpr const char* answers[] = {"Reset"};
  static constexpr MessageInfo info{
      .name = "ResetRequestExt", .command = "CMD_RESET",
      .summary = "Restart after a delay, with an optional notification.", .id = 114,
      .direction = Direction::to_board, .min_size = 3, .max_size = 3, .answers = answers,
      .effects = Effects(Effect::restarts)};
  static constexpr FieldInfo fields[] = {
      {.name = "confirm", .spec_name = "CONFIRM", .summary = "Whether CMD_RESET is sent back first."},
      {.name = "delay_ms", .spec_name = "DELAY_MS", .summary = "Delay before the restart.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, confirm), &detail::value_type<decltype(T::confirm)>},
      {offsetof(T, delay_ms), &detail::value_type<decltype(T::delay_ms)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.confirm);
    visitor(fields[1], value.delay_ms);
  }
};

template <>
struct Meta<msg::BootMode3> {
  static constexpr MessageInfo info{
      .name = "BootMode3", .command = "CMD_BOOT_MODE_3",
      .summary = "Enter the bootloader immediately, without notification.", .id = 51,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.board = 30},
      .effects = Effects(Effect::restarts) | Effect::disconnects};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::BootMode3Ext> {
  static constexpr const char* answers[] = {"Reset"};
  static constexpr MessageInfo info{
      .name = "BootMode3Ext", .command = "CMD_BOOT_MODE_3",
      .summary = "Enter the bootloader after a delay, with an optional notification.", .id = 51,
      .direction = Direction::to_board, .min_size = 3, .max_size = 3, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::restarts) | Effect::disconnects};
  static constexpr FieldInfo fields[] = {
      {.name = "confirm", .spec_name = "CONFIRM", .summary = "Whether CMD_RESET is sent back first."},
      {.name = "delay_ms", .spec_name = "DELAY_MS", .summary = "Delay before the bootloader starts.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, confirm), &detail::value_type<decltype(T::confirm)>},
      {offsetof(T, delay_ms), &detail::value_type<decltype(T::delay_ms)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.confirm);
    visitor(fields[1], value.delay_ms);
  }
};

template <>
struct Meta<msg::ReadStateVars> {
  static constexpr MessageInfo info{
      .name = "ReadStateVars", .command = "CMD_READ_STATE_VARS",
      .summary = "Statistics of the board's whole life.", .id = 111,
      .direction = Direction::from_board, .min_size = 192, .max_size = 192,
      .since = {.firmware = 2687, .board = 36, .features = 0x40000}};
  static constexpr FieldInfo fields[] = {
      {.name = "step_signal_val", .spec_name = "STEP_SIGNAL_VAL",
       .summary = "Current value of each step signal."},
      {.name = "sub_error", .spec_name = "SUB_ERROR",
       .summary = "Reason for the last emergency stop."},
      {.name = "max_acc", .spec_name = "MAX_ACC", .summary = "Highest acceleration.",
       .unit = &UnitMeta<msg::AccelerationPeak>::info},
      {.name = "work_time", .spec_name = "WORK_TIME", .summary = "Time in operation.",
       .unit = &UnitMeta<msg::LongSeconds>::info},
      {.name = "startup_cnt", .spec_name = "STARTUP_CNT", .summary = "Number of starts."},
      {.name = "max_current", .spec_name = "MAX_CURRENT", .summary = "Highest current.",
       .unit = &UnitMeta<msg::Current>::info},
      {.name = "imu_temp_min", .spec_name = "IMU_TEMP_MIN",
       .summary = "Lowest temperature of the IMU.",
       .unit = &UnitMeta<msg::PositiveTemperature>::info},
      {.name = "imu_temp_max", .spec_name = "IMU_TEMP_MAX",
       .summary = "Highest temperature of the IMU.",
       .unit = &UnitMeta<msg::PositiveTemperature>::info},
      {.name = "mcu_temp_min", .spec_name = "MCU_TEMP_MIN",
       .summary = "Lowest temperature of the microcontroller.",
       .unit = &UnitMeta<msg::PositiveTemperature>::info},
      {.name = "mcu_temp_max", .spec_name = "MCU_TEMP_MAX",
       .summary = "Highest temperature of the microcontroller.",
       .unit = &UnitMeta<msg::PositiveTemperature>::info},
      {.name = "shock_cnt", .spec_name = "SHOCK_CNT", .summary = "Numbers of shocks."},
      {.name = "energy_time", .spec_name = "ENERGY_TIME",
       .summary = "Time over which ENERGY is counted.", .unit = &UnitMeta<msg::LongSeconds>::info},
      {.name = "energy", .spec_name = "ENERGY", .summary = "Energy used.",
       .unit = &UnitMeta<msg::WattHours>::info},
      {.name = "avg_current_time", .spec_name = "AVG_CURRENT_TIME",
       .summary = "Time over which AVG_CURRENT is averaged.",
       .unit = &UnitMeta<msg::LongSeconds>::info},
      {.name = "avg_current", .spec_name = "AVG_CURRENT", .summary = "Average current.",
       .unit = &UnitMeta<msg::AverageCurrent>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, step_signal_val), &detail::value_type<decltype(T::step_signal_val)>},
      {offsetof(T, sub_error), &detail::value_type<decltype(T::sub_error)>},
      {offsetof(T, max_acc), &detail::value_type<decltype(T::max_acc)>},
      {offsetof(T, work_time), &detail::value_type<decltype(T::work_time)>},
      {offsetof(T, startup_cnt), &detail::value_type<decltype(T::startup_cnt)>},
      {offsetof(T, max_current), &detail::value_type<decltype(T::max_current)>},
      {offsetof(T, imu_temp_min), &detail::value_type<decltype(T::imu_temp_min)>},
      {offsetof(T, imu_temp_max), &detail::value_type<decltype(T::imu_temp_max)>},
      {offsetof(T, mcu_temp_min), &detail::value_type<decltype(T::mcu_temp_min)>},
      {offsetof(T, mcu_temp_max), &detail::value_type<decltype(T::mcu_temp_max)>},
      {offsetof(T, shock_cnt), &detail::value_type<decltype(T::shock_cnt)>},
      {offsetof(T, energy_time), &detail::value_type<decltype(T::energy_time)>},
      {offsetof(T, energy), &detail::value_type<decltype(T::energy)>},
      {offsetof(T, avg_current_time), &detail::value_type<decltype(T::avg_current_time)>},
      {offsetof(T, avg_current), &detail::value_type<decltype(T::avg_current)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.step_signal_val);
    visitor(fields[1], value.sub_error);
    visitor(fields[2], value.max_acc);
    visitor(fields[3], value.work_time);
    visitor(fields[4], value.startup_cnt);
    visitor(fields[5], value.max_current);
    visitor(fields[6], value.imu_temp_min);
    visitor(fields[7], value.imu_temp_max);
    visitor(fields[8], value.mcu_temp_min);
    visitor(fields[9], value.mcu_temp_max);
    visitor(fields[10], value.shock_cnt);
    visitor(fields[11], value.energy_time);
    visitor(fields[12], value.energy);
    visitor(fields[13], value.avg_current_time);
    visitor(fields[14], value.avg_current);
    visitor(fields[15], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadStateVarsRequest> {
  static constexpr const char* answers[] = {"ReadStateVars"};
  static constexpr MessageInfo info{
      .name = "ReadStateVarsRequest", .command = "CMD_READ_STATE_VARS",
      .summary = "Request the statistics of the board's whole life.", .id = 111,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .since = {.firmware = 2687, .board = 36, .features = 0x40000}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::SignMessage> {
  static constexpr MessageInfo info{
      .name = "SignMessage", .command = "CMD_SIGN_MESSAGE", .summary = "Signature of a message.",
      .id = 50, .direction = Direction::from_board, .min_size = 32, .max_size = 32,
      .since = {.firmware = 2500, .board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "signature", .spec_name = "SIGNATURE", .summary = "The signature."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, signature), &detail::value_type<decltype(T::signature)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.signature);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::SignMessageRequest> {
  static constexpr const char* answers[] = {"SignMessage"};
  static constexpr MessageInfo info{
      .name = "SignMessageRequest", .command = "CMD_SIGN_MESSAGE",
      .summary = "Sign a message with the keys of the board.", .id = 50,
      .direction = Direction::to_board, .min_size = 33, .max_size = 33,
      .since = {.firmware = 2500, .board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "sign_type", .spec_name = "SIGN_TYPE", .summary = "Set of keys."},
      {.name = "message", .spec_name = "MESSAGE", .summary = "The message."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, sign_type), &detail::value_type<decltype(T::sign_type)>},
      {offsetof(T, message), &detail::value_type<decltype(T::message)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.sign_type);
    visitor(fields[1], value.message);
  }
};

template <>
struct Meta<msg::PassProtectRead> {
  static constexpr MessageInfo info{
      .name = "PassProtectRead", .command = "CMD_PASS_PROTECT_READ",
      .summary = "What a password protects.", .id = 136, .direction = Direction::from_board,
      .min_size = 8, .max_size = 8, .since = {.firmware = 2736}};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "What is protected."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::PassProtectReadRequest> {
  static constexpr const char* answers[] = {"PassProtectRead"};
  static constexpr MessageInfo info{
      .name = "PassProtectReadRequest", .command = "CMD_PASS_PROTECT_READ",
      .summary = "Request what a password protects.", .id = 136, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .since = {.firmware = 2736}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::PassProtectWrite> {
  static constexpr MessageInfo info{
      .name = "PassProtectWrite", .command = "CMD_PASS_PROTECT_WRITE",
      .summary = "Choose what a password protects.", .id = 137, .direction = Direction::to_board,
      .min_size = 9, .max_size = 41, .since = {.firmware = 2736}, .secret_from = 8,
      .effects = Effects(Effect::stores)};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "What is protected."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "new_password", .spec_name = "NEW_PASSWORD",
       .summary = "The new password; empty keeps the present one.", .secret = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
      {offsetof(T, new_password), &detail::value_type<decltype(T::new_password)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.reserved);
    visitor(fields[2], value.new_password);
  }
};

template <>
struct Meta<msg::QueueParamsInfo3> {
  static constexpr MessageInfo info{
      .name = "QueueParamsInfo3", .command = "CMD_QUEUE_PARAMS_INFO_3",
      .summary = "Undocumented body from the board.", .id = 30, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::QueueParamsInfo3Request> {
  static constexpr MessageInfo info{
      .name = "QueueParamsInfo3Request", .command = "CMD_QUEUE_PARAMS_INFO_3",
      .summary = "Undocumented body to the board.", .id = 30, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}, .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SystemState> {
  static constexpr MessageInfo info{
      .name = "SystemState", .command = "CMD_SYSTEM_STATE",
      .summary = "Undocumented body from the board.", .id = 52, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::SystemStateRequest> {
  static constexpr MessageInfo info{
      .name = "SystemStateRequest", .command = "CMD_SYSTEM_STATE",
      .summary = "Undocumented body to the board.", .id = 52, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}, .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkInfo> {
  static constexpr MessageInfo info{
      .name = "MavlinkInfo", .command = "CMD_MAVLINK_INFO",
      .summary = "Undocumented body from the board.", .id = 250, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkInfoRequest> {
  static constexpr MessageInfo info{
      .name = "MavlinkInfoRequest", .command = "CMD_MAVLINK_INFO",
      .summary = "Undocumented body to the board.", .id = 250, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}, .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkDebug> {
  static constexpr MessageInfo info{
      .name = "MavlinkDebug", .command = "CMD_MAVLINK_DEBUG",
      .summary = "Undocumented body from the board.", .id = 251, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::MavlinkDebugRequest> {
  static constexpr MessageInfo info{
      .name = "MavlinkDebugRequest", .command = "CMD_MAVLINK_DEBUG",
      .summary = "Undocumented body to the board.", .id = 251, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}, .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::ExtLicenseInfo> {
  static constexpr MessageInfo info{
      .name = "ExtLicenseInfo", .command = "CMD_EXT_LICENSE_INFO",
      .summary = "Undocumented body from the board.", .id = 124, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::ExtLicenseInfoRequest> {
  static constexpr MessageInfo info{
      .name = "ExtLicenseInfoRequest", .command = "CMD_EXT_LICENSE_INFO",
      .summary = "Undocumented body to the board.", .id = 124, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true,
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::WriteStateVars> : Meta<msg::ReadStateVars> {
  static constexpr MessageInfo info{
      .name = "WriteStateVars", .command = "CMD_WRITE_STATE_VARS",
      .summary = "Store the statistics of the board's whole life.", .id = 112,
      .direction = Direction::to_board, .min_size = 192, .max_size = 192,
      .since = {.firmware = 2687, .board = 36, .features = 0x40000},
      .effects = Effects(Effect::stores)};
};

}  // namespace sbgc
