// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/calibration.hpp>.
#pragma once

#include <sbgc/messages/calibration.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::AxisTuning> {
  static constexpr FieldInfo fields[] = {
      {.name = "tracking_error",
       .spec_name = "TRACKING_ERROR",
       .summary = "Tracking error of the axis."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.tracking_error);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::CalibAcc> {
  static constexpr MessageInfo info{
      .name = "CalibAcc",
      .command = "CMD_CALIB_ACC",
      .summary = "Calibrate the accelerometer of the active IMU.",
      .id = 65,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::stores)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibAccExt> {
  static constexpr MessageInfo info{
      .name = "CalibAccExt",
      .command = "CMD_CALIB_ACC",
      .summary = "Calibrate the accelerometer of an IMU, or manage its calibrations.",
      .id = 65,
      .direction = Direction::to_board,
      .min_size = 12,
      .max_size = 12,
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_idx",
       .spec_name = "IMU_IDX",
       .summary = "The IMU."},
      {.name = "action",
       .spec_name = "ACTION",
       .summary = "Operation."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_idx);
    visitor(fields[1], value.action);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::CalibGyro> {
  static constexpr MessageInfo info{
      .name = "CalibGyro",
      .command = "CMD_CALIB_GYRO",
      .summary = "Calibrate the gyroscope of the active IMU.",
      .id = 103,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::stores)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibGyroExt> {
  static constexpr MessageInfo info{
      .name = "CalibGyroExt",
      .command = "CMD_CALIB_GYRO",
      .summary = "Calibrate the gyroscope of an IMU, or manage its calibrations.",
      .id = 103,
      .direction = Direction::to_board,
      .min_size = 12,
      .max_size = 12,
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_idx",
       .spec_name = "IMU_IDX",
       .summary = "The IMU."},
      {.name = "action",
       .spec_name = "ACTION",
       .summary = "Operation."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_idx);
    visitor(fields[1], value.action);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::CalibMag> {
  static constexpr MessageInfo info{
      .name = "CalibMag",
      .command = "CMD_CALIB_MAG",
      .summary = "Calibrate the magnetometer.",
      .id = 59,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .effects = Effects(Effect::stores)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibExtGain> {
  static constexpr MessageInfo info{
      .name = "CalibExtGain",
      .command = "CMD_CALIB_EXT_GAIN",
      .summary = "Calibrate the gains of a flight controller's signals.",
      .id = 71,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::stores) | Effect::moves};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibPoles> {
  static constexpr MessageInfo info{
      .name = "CalibPoles",
      .command = "CMD_CALIB_POLES",
      .summary = "Detect the poles and the direction of the motors.",
      .id = 80,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::stores) | Effect::moves};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibOffset> {
  static constexpr MessageInfo info{
      .name = "CalibOffset",
      .command = "CMD_CALIB_OFFSET",
      .summary = "Calibrate the follow mode offset.",
      .id = 79,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::stores) | Effect::moves};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::CalibBat> {
  static constexpr MessageInfo info{
      .name = "CalibBat",
      .command = "CMD_CALIB_BAT",
      .summary = "Calibrate the battery voltage measurement.",
      .id = 66,
      .direction = Direction::to_board,
      .min_size = 2,
      .max_size = 2,
      .effects = Effects(Effect::stores)};
  static constexpr FieldInfo fields[] = {
      {.name = "actual_voltage",
       .spec_name = "ACTUAL_VOLTAGE",
       .summary = "Actual voltage, measured externally.",
       .unit = &UnitMeta<msg::Voltage>::info},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.actual_voltage);
  }
};

template <>
struct Meta<msg::CalibInfo> {
  static constexpr MessageInfo info{
      .name = "CalibInfo",
      .command = "CMD_CALIB_INFO",
      .summary = "Calibration status for display.",
      .id = 49,
      .direction = Direction::from_board,
      .min_size = 33,
      .max_size = 33,
      .since = {.board = 30}};
  static constexpr Range progress_range{0, 100};
  static constexpr Range acc_cur_axis_range{0, 2};
  static constexpr Range imu_temp_cels_range{-127, 127};
  static constexpr Range temp_calib_gyro_enabled_range{0, 1};
  static constexpr Range temp_calib_gyro_t_min_cels_range{-127, 127};
  static constexpr Range temp_calib_gyro_t_max_cels_range{-127, 127};
  static constexpr Range temp_calib_acc_enabled_range{0, 1};
  static constexpr Range temp_calib_acc_slot_num_range{0, 3};
  static constexpr Range temp_calib_acc_t_min_cels_range{-127, 127};
  static constexpr Range temp_calib_acc_t_max_cels_range{-127, 127};
  static constexpr Range h1_err_length_range{0, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "progress",
       .spec_name = "PROGRESS",
       .summary = "Progress of the calibration.",
       .unit = &UnitMeta<msg::Percent>::info,
       .range = &progress_range},
      {.name = "imu_type",
       .spec_name = "IMU_TYPE",
       .summary = "The IMU."},
      {.name = "acc_data",
       .spec_name = "ACC_DATA",
       .summary = "Accelerometer, as in CMD_REALTIME_DATA_3.",
       .unit = &UnitMeta<msg::Acceleration>::info},
      {.name = "gyro_abs_val",
       .spec_name = "GYRO_ABS_VAL",
       .summary = "Magnitude of the gyroscope signal."},
      {.name = "acc_cur_axis",
       .spec_name = "ACC_CUR_AXIS",
       .summary = "Accelerometer axis to calibrate next.",
       .range = &acc_cur_axis_range},
      {.name = "acc_limits_info",
       .spec_name = "ACC_LIMITS_INFO",
       .summary = "Calibrated directions of the accelerometer."},
      {.name = "imu_temp_cels",
       .spec_name = "IMU_TEMP_CELS",
       .summary = "Temperature of the IMU.",
       .unit = &UnitMeta<msg::Temperature>::info,
       .range = &imu_temp_cels_range},
      {.name = "temp_calib_gyro_enabled",
       .spec_name = "TEMP_CALIB_GYRO_ENABLED",
       .summary = "1 if the gyroscope's calibration over temperature is enabled.",
       .range = &temp_calib_gyro_enabled_range},
      {.name = "temp_calib_gyro_t_min_cels",
       .spec_name = "TEMP_CALIB_GYRO_T_MIN_CELS",
       .summary = "Lowest temperature of the gyroscope's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info,
       .range = &temp_calib_gyro_t_min_cels_range},
      {.name = "temp_calib_gyro_t_max_cels",
       .spec_name = "TEMP_CALIB_GYRO_T_MAX_CELS",
       .summary = "Highest temperature of the gyroscope's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info,
       .range = &temp_calib_gyro_t_max_cels_range},
      {.name = "temp_calib_acc_enabled",
       .spec_name = "TEMP_CALIB_ACC_ENABLED",
       .summary = "1 if the accelerometer's calibration over temperature is enabled.",
       .range = &temp_calib_acc_enabled_range},
      {.name = "temp_calib_acc_slot_num",
       .spec_name = "TEMP_CALIB_ACC_SLOT_NUM",
       .summary = "Number of calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y, -Z.",
       .range = &temp_calib_acc_slot_num_range},
      {.name = "temp_calib_acc_t_min_cels",
       .spec_name = "TEMP_CALIB_ACC_T_MIN_CELS",
       .summary = "Lowest temperature of the accelerometer's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info,
       .range = &temp_calib_acc_t_min_cels_range},
      {.name = "temp_calib_acc_t_max_cels",
       .spec_name = "TEMP_CALIB_ACC_T_MAX_CELS",
       .summary = "Highest temperature of the accelerometer's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info,
       .range = &temp_calib_acc_t_max_cels_range},
      {.name = "h1_err_length",
       .spec_name = "H1_ERR_LENGTH",
       .summary = "Length of the difference between the estimated and the reference heading vector, both of length 1.",
       .unit = &UnitMeta<msg::Hundredths>::info,
       .range = &h1_err_length_range},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.progress);
    visitor(fields[1], value.imu_type);
    visitor(fields[2], value.acc_data);
    visitor(fields[3], value.gyro_abs_val);
    visitor(fields[4], value.acc_cur_axis);
    visitor(fields[5], value.acc_limits_info);
    visitor(fields[6], value.imu_temp_cels);
    visitor(fields[7], value.temp_calib_gyro_enabled);
    visitor(fields[8], value.temp_calib_gyro_t_min_cels);
    visitor(fields[9], value.temp_calib_gyro_t_max_cels);
    visitor(fields[10], value.temp_calib_acc_enabled);
    visitor(fields[11], value.temp_calib_acc_slot_num);
    visitor(fields[12], value.temp_calib_acc_t_min_cels);
    visitor(fields[13], value.temp_calib_acc_t_max_cels);
    visitor(fields[14], value.h1_err_length);
    visitor(fields[15], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::CalibInfoRequest> {
  static constexpr const char* answers[] = {"CalibInfo"};
  static constexpr MessageInfo info{
      .name = "CalibInfoRequest",
      .command = "CMD_CALIB_INFO",
      .summary = "Request the calibration status.",
      .id = 49,
      .direction = Direction::to_board,
      .min_size = 12,
      .max_size = 12,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type",
       .spec_name = "IMU_TYPE",
       .summary = "The IMU."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::CalibMotorMagLink> {
  static constexpr MessageInfo info{
      .name = "CalibMotorMagLink",
      .command = "CMD_CALIB_MOTOR_MAG_LINK",
      .summary = "Undocumented body from the board.",
      .id = 74,
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
struct Meta<msg::CalibMotorMagLinkRequest> {
  static constexpr MessageInfo info{
      .name = "CalibMotorMagLinkRequest",
      .command = "CMD_CALIB_MOTOR_MAG_LINK",
      .summary = "Undocumented body to the board.",
      .id = 74,
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
struct Meta<msg::EncodersCalibOffset4> {
  static constexpr MessageInfo info{
      .name = "EncodersCalibOffset4",
      .command = "CMD_ENCODERS_CALIB_OFFSET_4",
      .summary = "Calibrate the offsets of the encoders.",
      .id = 26,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .effects = Effects(Effect::stores)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::EncodersCalibFldOffset4> {
  static constexpr MessageInfo info{
      .name = "EncodersCalibFldOffset4",
      .command = "CMD_ENCODERS_CALIB_FLD_OFFSET_4",
      .summary = "Calibrate the offsets between encoders and the motors' magnetic fields.",
      .id = 27,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::moves};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::AutoPid> {
  static constexpr MessageInfo info{
      .name = "AutoPid",
      .command = "CMD_AUTO_PID",
      .summary = "Progress of the automatic tuning.",
      .id = 35,
      .direction = Direction::from_board,
      .min_size = 57,
      .max_size = 57,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "p",
       .spec_name = "P",
       .summary = "Proportional gain of each axis."},
      {.name = "i",
       .spec_name = "I",
       .summary = "Integral gain of each axis, as stored."},
      {.name = "d",
       .spec_name = "D",
       .summary = "Derivative gain of each axis."},
      {.name = "lpf_freq",
       .spec_name = "LPF_FREQ",
       .summary = "Low-pass filter of each axis, as stored."},
      {.name = "iter_num",
       .spec_name = "ITER_NUM",
       .summary = "Number of completed iterations."},
      {.name = "axes",
       .spec_name = "axes",
       .summary = "Current result of each axis."},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.p);
    visitor(fields[1], value.i);
    visitor(fields[2], value.d);
    visitor(fields[3], value.lpf_freq);
    visitor(fields[4], value.iter_num);
    visitor(fields[5], value.axes);
    visitor(fields[6], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AutoPidRequest> {
  static constexpr MessageInfo info{
      .name = "AutoPidRequest",
      .command = "CMD_AUTO_PID",
      .summary = "Start or stop the automatic tuning.",
      .id = 35,
      .direction = Direction::to_board,
      .min_size = 19,
      .max_size = 19,
      .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special cfg_flags_special[] = {
      {0, "stops the tuning"},
  };
  static constexpr Range gain_vs_stability_range{0, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id",
       .spec_name = "PROFILE_ID",
       .summary = "Profile to switch to first.",
       .range = &profile_id_range},
      {.name = "cfg_flags",
       .spec_name = "CFG_FLAGS",
       .summary = "What to tune, and options.",
       .special = cfg_flags_special},
      {.name = "gain_vs_stability",
       .spec_name = "GAIN_VS_STABILITY",
       .summary = "Preference for high gains at the cost of stability.",
       .range = &gain_vs_stability_range},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.cfg_flags);
    visitor(fields[2], value.gain_vs_stability);
    visitor(fields[3], value.reserved);
  }
};

}  // namespace sbgc
