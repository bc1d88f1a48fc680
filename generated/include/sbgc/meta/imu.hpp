// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/imu.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::AhrsDebugInfo> {
  static constexpr FieldInfo fields[] = {
      {.name = "main_imu_ref_src", .spec_name = "MAIN_IMU_REF_SRC",
       .summary = "What corrects the attitude of the main IMU."},
      {.name = "frame_imu_ref_src", .spec_name = "FRAME_IMU_REF_SRC",
       .summary = "What corrects the attitude of the frame IMU."},
      {.name = "main_z_err", .spec_name = "MAIN_Z_ERR",
       .summary = "Error of the main IMU's gravity vector.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "main_h_err", .spec_name = "MAIN_H_ERR",
       .summary = "Error of the main IMU's heading vector.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "frame_z_err", .spec_name = "FRAME_Z_ERR",
       .summary = "Error of the frame IMU's gravity vector.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "frame_h_err", .spec_name = "FRAME_H_ERR",
       .summary = "Error of the frame IMU's heading vector.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "ext_imu_status", .spec_name = "EXT_IMU_STATUS",
       .summary = "State of the external IMU."},
      {.name = "ext_imu_packets", .spec_name = "EXT_IMU_PACKETS",
       .summary = "Number of packets from the external IMU."},
      {.name = "ext_imu_parse_err", .spec_name = "EXT_IMU_PARSE_ERR",
       .summary = "Number of damaged packets from the external IMU."},
      {.name = "ext_corr_h_err", .spec_name = "EXT_CORR_H_ERR",
       .summary = "Error of the external heading correction.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "ext_corr_z_err", .spec_name = "EXT_CORR_Z_ERR",
       .summary = "Error of the external gravity correction.",
       .unit = &UnitMeta<msg::AngleError>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, main_imu_ref_src), &detail::value_type<decltype(T::main_imu_ref_src)>},
      {offsetof(T, frame_imu_ref_src), &detail::value_type<decltype(T::frame_imu_ref_src)>},
      {offsetof(T, main_z_err), &detail::value_type<decltype(T::main_z_err)>},
      {offsetof(T, main_h_err), &detail::value_type<decltype(T::main_h_err)>},
      {offsetof(T, frame_z_err), &detail::value_type<decltype(T::frame_z_err)>},
      {offsetof(T, frame_h_err), &detail::value_type<decltype(T::frame_h_err)>},
      {offsetof(T, ext_imu_status), &detail::value_type<decltype(T::ext_imu_status)>},
      {offsetof(T, ext_imu_packets), &detail::value_type<decltype(T::ext_imu_packets)>},
      {offsetof(T, ext_imu_parse_err), &detail::value_type<decltype(T::ext_imu_parse_err)>},
      {offsetof(T, ext_corr_h_err), &detail::value_type<decltype(T::ext_corr_h_err)>},
      {offsetof(T, ext_corr_z_err), &detail::value_type<decltype(T::ext_corr_z_err)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.main_imu_ref_src);
    visitor(fields[1], value.frame_imu_ref_src);
    visitor(fields[2], value.main_z_err);
    visitor(fields[3], value.main_h_err);
    visitor(fields[4], value.frame_z_err);
    visitor(fields[5], value.frame_h_err);
    visitor(fields[6], value.ext_imu_status);
    visitor(fields[7], value.ext_imu_packets);
    visitor(fields[8], value.ext_imu_parse_err);
    visitor(fields[9], value.ext_corr_h_err);
    visitor(fields[10], value.ext_corr_z_err);
    visitor(fields[11], value.reserved);
  }
};

template <>
struct Meta<msg::SelectImu3> {
  static constexpr MessageInfo info{
      .name = "SelectImu3", .command = "CMD_SELECT_IMU_3",
      .summary = "Select the IMU to configure and calibrate.", .id = 24,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.board = 30},
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
  }
};

template <>
struct Meta<msg::SelectImu3Ext> {
  static constexpr MessageInfo info{
      .name = "SelectImu3Ext", .command = "CMD_SELECT_IMU_3",
      .summary = "Select an IMU, with parameters that no source describes.", .id = 24,
      .direction = Direction::to_board, .min_size = 2, .max_size = 10, .since = {.firmware = 2600},
      .unconfirmed = true, .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "param", .spec_name = "PARAM", .summary = "Undocumented."},
      {.name = "params", .spec_name = "PARAMS", .summary = "Further undocumented parameters.",
       .max_count = 8},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, param), &detail::value_type<decltype(T::param)>},
      {offsetof(T, params), &detail::value_type<decltype(T::params)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.param);
    visitor(fields[2], value.params);
  }
};

template <>
struct Meta<msg::SelectImu3CalibrateShort> {
  static constexpr MessageInfo info{
      .name = "SelectImu3CalibrateShort", .command = "CMD_SELECT_IMU_3",
      .summary = "The same, with one byte less.", .id = 24, .direction = Direction::to_board,
      .min_size = 11, .max_size = 11, .since = {.firmware = 2600}, .unconfirmed = true,
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "time_ms", .spec_name = "TIME_MS", .summary = "Duration of the operation.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.action);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::SelectImu3Calibrate> {
  static constexpr MessageInfo info{
      .name = "SelectImu3Calibrate", .command = "CMD_SELECT_IMU_3",
      .summary = "Select an IMU and calibrate it, or manage its calibrations.", .id = 24,
      .direction = Direction::to_board, .min_size = 12, .max_size = 12, .since = {.firmware = 2600},
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "time_ms", .spec_name = "TIME_MS", .summary = "Duration of the operation.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.action);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::AhrsHelper> {
  static constexpr MessageInfo info{
      .name = "AhrsHelper", .command = "CMD_AHRS_HELPER",
      .summary = "Attitude of an IMU as two unit vectors.", .id = 56,
      .direction = Direction::from_board, .min_size = 24, .max_size = 24, .since = {.board = 30}};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "z1_vector", .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position); down according to later sources.",
       .range = &z1_vector_range, .unconfirmed = true},
      {.name = "h1_vector", .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position).",
       .range = &h1_vector_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, z1_vector), &detail::value_type<decltype(T::z1_vector)>},
      {offsetof(T, h1_vector), &detail::value_type<decltype(T::h1_vector)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.z1_vector);
    visitor(fields[1], value.h1_vector);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AhrsHelperRequest> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequest", .command = "CMD_AHRS_HELPER",
      .summary = "Query the attitude of an IMU.", .id = 56, .direction = Direction::to_board,
      .min_size = 1, .max_size = 1, .since = {.board = 30}, .until = {.firmware = 2695},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "The IMU to query; without SET."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestWide> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestWide", .command = "CMD_AHRS_HELPER",
      .summary = "Query the attitude of an IMU, with a two-byte mode.", .id = 56,
      .direction = Direction::to_board, .min_size = 2, .max_size = 2, .since = {.firmware = 2695},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "The IMU to query; without SET."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestExt> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestExt", .command = "CMD_AHRS_HELPER",
      .summary = "Query or set the attitude of an IMU.", .id = 56, .direction = Direction::to_board,
      .min_size = 25, .max_size = 25, .since = {.board = 30}, .until = {.firmware = 2695},
      .answers = answers, .effects = Effects(Effect::moves)};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Operation."},
      {.name = "z1_vector", .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position), or down according to later sources; unused in a query.",
       .range = &z1_vector_range},
      {.name = "h1_vector", .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position); unused in a query.",
       .range = &h1_vector_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, z1_vector), &detail::value_type<decltype(T::z1_vector)>},
      {offsetof(T, h1_vector), &detail::value_type<decltype(T::h1_vector)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.z1_vector);
    visitor(fields[2], value.h1_vector);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestExtWide> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestExtWide", .command = "CMD_AHRS_HELPER",
      .summary = "Query or set the attitude of an IMU, with a two-byte mode.", .id = 56,
      .direction = Direction::to_board, .min_size = 26, .max_size = 26, .since = {.firmware = 2695},
      .answers = answers, .effects = Effects(Effect::moves)};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Operation."},
      {.name = "z1_vector", .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position), or down according to later sources; unused in a query.",
       .range = &z1_vector_range},
      {.name = "h1_vector", .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position); unused in a query.",
       .range = &h1_vector_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, z1_vector), &detail::value_type<decltype(T::z1_vector)>},
      {offsetof(T, h1_vector), &detail::value_type<decltype(T::h1_vector)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.z1_vector);
    visitor(fields[2], value.h1_vector);
  }
};

template <>
struct Meta<msg::GyroCorrection> {
  static constexpr MessageInfo info{
      .name = "GyroCorrection", .command = "CMD_GYRO_CORRECTION",
      .summary = "Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong.",
      .id = 75, .direction = Direction::to_board, .min_size = 9, .max_size = 9,
      .since = {.board = 30}, .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "gyro_zero_corr", .spec_name = "GYRO_ZERO_CORR",
       .summary = "Zero offset of each axis.", .unit = &UnitMeta<msg::GyroOffset>::info,
       .directed = Directed::by_axis},
      {.name = "gyro_zero_heading_corr", .spec_name = "GYRO_ZERO_HEADING_CORR",
       .summary = "Offset of the rotation about the vertical, to correct the heading; the board distributes it over the axes.",
       .unit = &UnitMeta<msg::GyroOffset>::info, .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, gyro_zero_corr), &detail::value_type<decltype(T::gyro_zero_corr)>},
      {offsetof(T, gyro_zero_heading_corr), &detail::value_type<decltype(T::gyro_zero_heading_corr)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.gyro_zero_corr);
    visitor(fields[2], value.gyro_zero_heading_corr);
  }
};

template <>
struct Meta<msg::ExtImuDebugInfo> {
  static constexpr MessageInfo info{
      .name = "ExtImuDebugInfo", .command = "CMD_EXT_IMU_DEBUG_INFO",
      .summary = "State of the attitude estimation and of the external IMU.", .id = 106,
      .direction = Direction::from_board, .min_size = 74, .max_size = 74,
      .since = {.firmware = 2660, .features = 0x10000}};
  static constexpr FieldInfo fields[] = {
      {.name = "ahrs_debug_info", .spec_name = "AHRS_DEBUG_INFO",
       .summary = "State of the attitude estimation."},
      {.name = "dcm", .spec_name = "DCM", .summary = "Attitude as a rotation matrix, row by row."},
      {.name = "acc_body", .spec_name = "ACC_BODY", .summary = "Acceleration of the sensor."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, ahrs_debug_info), &detail::value_type<decltype(T::ahrs_debug_info)>},
      {offsetof(T, dcm), &detail::value_type<decltype(T::dcm)>},
      {offsetof(T, acc_body), &detail::value_type<decltype(T::acc_body)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.ahrs_debug_info);
    visitor(fields[1], value.dcm);
    visitor(fields[2], value.acc_body);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ExtImuDebugInfoRequest> {
  static constexpr const char* answers[] = {"ExtImuDebugInfo"};
  static constexpr MessageInfo info{
      .name = "ExtImuDebugInfoRequest", .command = "CMD_EXT_IMU_DEBUG_INFO",
      .summary = "Request the state of the attitude estimation and of the external IMU.", .id = 106,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .since = {.firmware = 2660, .features = 0x10000}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::ExtImuCmd> {
  static constexpr MessageInfo info{
      .name = "ExtImuCmd", .command = "CMD_EXT_IMU_CMD", .summary = "A message of the external IMU.",
      .id = 110, .direction = Direction::both, .min_size = 1, .max_size = 255,
      .since = {.firmware = 2600, .features = 0x10000},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Command of the external IMU."},
      {.name = "data", .spec_name = "DATA", .summary = "Body of the command."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.data);
  }
};

template <>
struct Meta<msg::ExtSensCmd> {
  static constexpr MessageInfo info{
      .name = "ExtSensCmd", .command = "CMD_EXT_SENS_CMD",
      .summary = "A message of the external sensor.", .id = 150, .direction = Direction::from_board,
      .min_size = 1, .max_size = 255, .since = {.firmware = 2687, .board = 36, .features = 0x10000},
      .unconfirmed = true};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Command of the sensor."},
      {.name = "data", .spec_name = "DATA", .summary = "Body of the command."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.data);
  }
};

template <>
struct Meta<msg::ExtSensCmdRequest> {
  static constexpr MessageInfo info{
      .name = "ExtSensCmdRequest", .command = "CMD_EXT_SENS_CMD",
      .summary = "Forward a command to an external sensor.", .id = 150,
      .direction = Direction::to_board, .min_size = 2, .max_size = 255,
      .since = {.firmware = 2687, .board = 36, .features = 0x10000},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Command of the sensor."},
      {.name = "data", .spec_name = "DATA", .summary = "Body of the command."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.cmd_id);
    visitor(fields[2], value.data);
  }
};

template <>
struct Meta<msg::ImuAdvancedCalib> {
  static constexpr MessageInfo info{
      .name = "ImuAdvancedCalib", .command = "CMD_IMU_ADVANCED_CALIB",
      .summary = "Undocumented body from the board.", .id = 115, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}};
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
struct Meta<msg::ImuAdvancedCalibRequest> {
  static constexpr MessageInfo info{
      .name = "ImuAdvancedCalibRequest", .command = "CMD_IMU_ADVANCED_CALIB",
      .summary = "Undocumented body to the board.", .id = 115, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600},
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

}  // namespace sbgc
