// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/imu.hpp>.
#pragma once

#include <sbgc/messages/imu.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::SelectImu3> {
  static constexpr MessageInfo info{
      .name = "SelectImu3",
      .command = "CMD_SELECT_IMU_3",
      .summary = "Select the IMU to configure and calibrate.",
      .id = 24,
      .direction = Direction::to_board,
      .min_size = 1,
      .max_size = 1,
      .since = {.board = 30},
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type",
       .spec_name = "IMU_TYPE",
       .summary = "The IMU."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_type);
  }
};

template <>
struct Meta<msg::SelectImu3Ext> {
  static constexpr MessageInfo info{
      .name = "SelectImu3Ext",
      .command = "CMD_SELECT_IMU_3",
      .summary = "Select an IMU, with parameters of later firmware.",
      .id = 24,
      .direction = Direction::to_board,
      .min_size = 2,
      .max_size = 12,
      .since = {.board = 30},
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type",
       .spec_name = "IMU_TYPE",
       .summary = "The IMU."},
      {.name = "param",
       .spec_name = "PARAM",
       .summary = "Undocumented."},
      {.name = "params",
       .spec_name = "PARAMS",
       .summary = "Further undocumented parameters.",
       .max_count = 10},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.param);
    visitor(fields[2], value.params);
  }
};

template <>
struct Meta<msg::AhrsHelper> {
  static constexpr MessageInfo info{
      .name = "AhrsHelper",
      .command = "CMD_AHRS_HELPER",
      .summary = "Attitude of an IMU as two unit vectors.",
      .id = 56,
      .direction = Direction::from_board,
      .min_size = 24,
      .max_size = 24,
      .since = {.board = 30}};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "z1_vector",
       .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position); down according to later sources.",
       .range = &z1_vector_range},
      {.name = "h1_vector",
       .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position).",
       .range = &h1_vector_range},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.z1_vector);
    visitor(fields[1], value.h1_vector);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AhrsHelperRequest> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequest",
      .command = "CMD_AHRS_HELPER",
      .summary = "Query the attitude of an IMU.",
      .id = 56,
      .direction = Direction::to_board,
      .min_size = 1,
      .max_size = 1,
      .since = {.board = 30},
      .until = {.firmware = 2695},
      .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode",
       .spec_name = "MODE",
       .summary = "The IMU to query; without SET."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestWide> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestWide",
      .command = "CMD_AHRS_HELPER",
      .summary = "Query the attitude of an IMU, with a two-byte mode.",
      .id = 56,
      .direction = Direction::to_board,
      .min_size = 2,
      .max_size = 2,
      .since = {.firmware = 2695},
      .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode",
       .spec_name = "MODE",
       .summary = "The IMU to query; without SET."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestExt> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestExt",
      .command = "CMD_AHRS_HELPER",
      .summary = "Query or set the attitude of an IMU.",
      .id = 56,
      .direction = Direction::to_board,
      .min_size = 25,
      .max_size = 25,
      .since = {.board = 30},
      .until = {.firmware = 2695},
      .answers = answers,
      .effects = Effects(Effect::moves)};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode",
       .spec_name = "MODE",
       .summary = "Operation."},
      {.name = "z1_vector",
       .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position), or down according to later sources; unused in a query.",
       .range = &z1_vector_range},
      {.name = "h1_vector",
       .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position); unused in a query.",
       .range = &h1_vector_range},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.z1_vector);
    visitor(fields[2], value.h1_vector);
  }
};

template <>
struct Meta<msg::AhrsHelperRequestExtWide> {
  static constexpr const char* answers[] = {"AhrsHelper"};
  static constexpr MessageInfo info{
      .name = "AhrsHelperRequestExtWide",
      .command = "CMD_AHRS_HELPER",
      .summary = "Query or set the attitude of an IMU, with a two-byte mode.",
      .id = 56,
      .direction = Direction::to_board,
      .min_size = 26,
      .max_size = 26,
      .since = {.firmware = 2695},
      .answers = answers,
      .effects = Effects(Effect::moves)};
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode",
       .spec_name = "MODE",
       .summary = "Operation."},
      {.name = "z1_vector",
       .spec_name = "Z1_VECTOR",
       .summary = "Unit vector that points up (the Z axis in the normal position), or down according to later sources; unused in a query.",
       .range = &z1_vector_range},
      {.name = "h1_vector",
       .spec_name = "H1_VECTOR",
       .summary = "Unit vector that points north (the Y axis in the normal position); unused in a query.",
       .range = &h1_vector_range},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.z1_vector);
    visitor(fields[2], value.h1_vector);
  }
};

template <>
struct Meta<msg::GyroCorrection> {
  static constexpr MessageInfo info{
      .name = "GyroCorrection",
      .command = "CMD_GYRO_CORRECTION",
      .summary = "Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong.",
      .id = 75,
      .direction = Direction::to_board,
      .min_size = 9,
      .max_size = 9,
      .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type",
       .spec_name = "IMU_TYPE",
       .summary = "The IMU."},
      {.name = "gyro_zero_corr",
       .spec_name = "GYRO_ZERO_CORR",
       .summary = "Zero offset of each axis.",
       .unit = &UnitMeta<msg::GyroOffset>::info},
      {.name = "gyro_zero_heading_corr",
       .spec_name = "GYRO_ZERO_HEADING_CORR",
       .summary = "Offset of the rotation about the vertical, to correct the heading; the board distributes it over the axes.",
       .unit = &UnitMeta<msg::GyroOffset>::info},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.gyro_zero_corr);
    visitor(fields[2], value.gyro_zero_heading_corr);
  }
};

}  // namespace sbgc
