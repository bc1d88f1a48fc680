// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Calibration of sensors, motors and encoders, and tuning of the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 2, "generated code and runtime do not match");

struct CalibInfo;

/// Current result of each axis.
struct AxisTuning {
  /// Tracking error of the axis.
  float tracking_error{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const AxisTuning&) const = default;
  using FixedMembers = Members<&AxisTuning::tracking_error, &AxisTuning::reserved>;
};

/// Calibrate the accelerometer of the active IMU. Confirmed on reception and again at the end; not
/// at all if a parameter is wrong.
///
/// CMD_CALIB_ACC (65), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
/// commands L621-L640.
struct CalibAcc {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibAcc&) const = default;
};

/// Calibrate the accelerometer of an IMU, or manage its calibrations. Confirmed on reception and
/// again at the end; not at all if a parameter is wrong.
///
/// CMD_CALIB_ACC (65), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640.
struct CalibAccExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// The IMU.
  CalibImu imu_idx{};
  /// Operation.
  CalibAction action{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  bool operator==(const CalibAccExt&) const = default;
  using FixedMembers = Members<&CalibAccExt::imu_idx, &CalibAccExt::action, &CalibAccExt::reserved>;
};

/// Calibrate the gyroscope of the active IMU. Confirmed on reception and again at the end; not at
/// all if a parameter is wrong.
///
/// CMD_CALIB_GYRO (103), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
/// commands L621-L640.
struct CalibGyro {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibGyro&) const = default;
};

/// Calibrate the gyroscope of an IMU, or manage its calibrations. Confirmed on reception and again
/// at the end; not at all if a parameter is wrong.
///
/// CMD_CALIB_GYRO (103), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640.
struct CalibGyroExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// The IMU.
  CalibImu imu_idx{};
  /// Operation.
  CalibAction action{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  bool operator==(const CalibGyroExt&) const = default;
  using FixedMembers = Members<&CalibGyroExt::imu_idx, &CalibGyroExt::action,
      &CalibGyroExt::reserved>;
};

/// Calibrate the magnetometer.
///
/// CMD_CALIB_MAG (59), to the board; 0 bytes. Effect: stores. Since board 3.0. Source: Outgoing
/// commands L940-L944.
struct CalibMag {
  static constexpr CommandToBoard command = CommandToBoard::calib_mag;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const CalibMag&) const = default;
};

/// Calibrate the gains of a flight controller's signals.
///
/// CMD_CALIB_EXT_GAIN (71), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L642.
struct CalibExtGain {
  static constexpr CommandToBoard command = CommandToBoard::calib_ext_gain;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibExtGain&) const = default;
};

/// Detect the poles and the direction of the motors.
///
/// CMD_CALIB_POLES (80), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L650.
struct CalibPoles {
  static constexpr CommandToBoard command = CommandToBoard::calib_poles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibPoles&) const = default;
};

/// Calibrate the follow mode offset.
///
/// CMD_CALIB_OFFSET (79), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L688.
struct CalibOffset {
  static constexpr CommandToBoard command = CommandToBoard::calib_offset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibOffset&) const = default;
};

/// Calibrate the battery voltage measurement.
///
/// CMD_CALIB_BAT (66), to the board; 2 bytes. Effect: stores. Source: Outgoing commands L690-L692.
struct CalibBat {
  static constexpr CommandToBoard command = CommandToBoard::calib_bat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// Actual voltage, measured externally. Unit: V.
  Voltage actual_voltage{};

  bool operator==(const CalibBat&) const = default;
  using FixedMembers = Members<&CalibBat::actual_voltage>;
};

/// Calibration status for display.
///
/// CMD_CALIB_INFO (49), from the board; 33 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L546-L563; Variables L1233-L1246.
struct CalibInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 33;
  static constexpr std::size_t max_size = 33;
  static constexpr Availability since{.board = 30};

  /// Progress of the calibration. Range: 0 to 100 %.
  Percent progress{};
  /// The IMU.
  SelectedImu imu_type{};
  /// Accelerometer, as in CMD_REALTIME_DATA_3. Unit: g.
  Xyz<Acceleration> acc_data{};
  /// Magnitude of the gyroscope signal.
  std::uint16_t gyro_abs_val{};
  /// Accelerometer axis to calibrate next. Range: 0 to 2.
  std::uint8_t acc_cur_axis{};
  /// Calibrated directions of the accelerometer.
  CalibratedLimits acc_limits_info{};
  /// Temperature of the IMU. Range: -127 to 127 degC.
  Temperature imu_temp_cels{};
  /// 1 if the gyroscope's calibration over temperature is enabled. Range: 0 to 1.
  std::uint8_t temp_calib_gyro_enabled{};
  /// Lowest temperature of the gyroscope's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_gyro_t_min_cels{};
  /// Highest temperature of the gyroscope's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_gyro_t_max_cels{};
  /// 1 if the accelerometer's calibration over temperature is enabled. Range: 0 to 1.
  std::uint8_t temp_calib_acc_enabled{};
  /// Number of calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y,
  /// -Z. Range: 0 to 3.
  std::array<std::uint8_t, 6> temp_calib_acc_slot_num{};
  /// Lowest temperature of the accelerometer's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_acc_t_min_cels{};
  /// Highest temperature of the accelerometer's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_acc_t_max_cels{};
  /// Length of the difference between the estimated and the reference heading vector, both of
  /// length 1.
  Hundredths h1_err_length{};
  /// Reserved; kept as it is.
  Bytes<7> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<222> tail{};

  bool operator==(const CalibInfo&) const = default;
  using FixedMembers = Members<&CalibInfo::progress, &CalibInfo::imu_type, &CalibInfo::acc_data,
      &CalibInfo::gyro_abs_val, &CalibInfo::acc_cur_axis, &CalibInfo::acc_limits_info,
      &CalibInfo::imu_temp_cels, &CalibInfo::temp_calib_gyro_enabled,
      &CalibInfo::temp_calib_gyro_t_min_cels, &CalibInfo::temp_calib_gyro_t_max_cels,
      &CalibInfo::temp_calib_acc_enabled, &CalibInfo::temp_calib_acc_slot_num,
      &CalibInfo::temp_calib_acc_t_min_cels, &CalibInfo::temp_calib_acc_t_max_cels,
      &CalibInfo::h1_err_length, &CalibInfo::reserved>;
};

/// Request the calibration status.
///
/// CMD_CALIB_INFO (49), to the board; 12 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L891-L896.
struct CalibInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.board = 30};
  using Response = CalibInfo;

  /// The IMU.
  SelectedImu imu_type{};
  /// Reserved; kept as it is.
  Bytes<11> reserved{};

  bool operator==(const CalibInfoRequest&) const = default;
  using FixedMembers = Members<&CalibInfoRequest::imu_type, &CalibInfoRequest::reserved>;
};

/// Undocumented body from the board.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), from the board; 0 to 255 bytes. Since board 3.0. Source: Command
/// ID definitions L142.
struct CalibMotorMagLink {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibMotorMagLink&) const = default;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
/// Source: Command ID definitions L142.
struct CalibMotorMagLinkRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibMotorMagLinkRequest&) const = default;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Calibrate the offsets of the encoders.
///
/// CMD_ENCODERS_CALIB_OFFSET_4 (26), to the board; 0 bytes. Effect: stores. Since board 3.0.
/// Source: Outgoing commands L993.
struct EncodersCalibOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const EncodersCalibOffset4&) const = default;
};

/// Calibrate the offsets between encoders and the motors' magnetic fields.
///
/// CMD_ENCODERS_CALIB_FLD_OFFSET_4 (27), to the board; 0 bytes. Effect: stores, moves. Since board
/// 3.0. Source: Outgoing commands L995.
struct EncodersCalibFldOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_fld_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const EncodersCalibFldOffset4&) const = default;
};

/// Progress of the automatic tuning.
///
/// CMD_AUTO_PID (35), from the board; 57 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L462-L474.
struct AutoPid {
  static constexpr CommandFromBoard command = CommandFromBoard::auto_pid;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 57;
  static constexpr std::size_t max_size = 57;
  static constexpr Availability since{.board = 30};

  /// Proportional gain of each axis.
  Axes<std::uint8_t> p{};
  /// Integral gain of each axis, as stored.
  Axes<std::uint8_t> i{};
  /// Derivative gain of each axis.
  Axes<std::uint8_t> d{};
  /// Low-pass filter of each axis, as stored.
  Axes<std::uint16_t> lpf_freq{};
  /// Number of completed iterations.
  std::uint16_t iter_num{};
  /// Current result of each axis.
  Axes<AxisTuning> axes{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<198> tail{};

  bool operator==(const AutoPid&) const = default;
  using FixedMembers = Members<&AutoPid::p, &AutoPid::i, &AutoPid::d, &AutoPid::lpf_freq,
      &AutoPid::iter_num, &AutoPid::axes, &AutoPid::reserved>;
};

/// Start or stop the automatic tuning. With AUTO_PID_CFG_SEND_GUI the board sends CMD_AUTO_PID
/// repeatedly while it tunes.
///
/// CMD_AUTO_PID (35), to the board; 19 bytes. Effect: stores, moves. Since board 3.0. Source:
/// Outgoing commands L806-L811; Variables L1177-L1182.
struct AutoPidRequest {
  static constexpr CommandToBoard command = CommandToBoard::auto_pid;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 19;
  static constexpr std::size_t max_size = 19;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// For cfg_flags: stops the tuning.
  static constexpr std::uint8_t stop_tuning{0};

  /// Profile to switch to first. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// What to tune, and options.
  AutoPidFlags cfg_flags{};
  /// Preference for high gains at the cost of stability.
  std::uint8_t gain_vs_stability{};
  /// Reserved; kept as it is.
  Bytes<16> reserved{};

  bool operator==(const AutoPidRequest&) const = default;
  using FixedMembers = Members<&AutoPidRequest::profile_id, &AutoPidRequest::cfg_flags,
      &AutoPidRequest::gain_vs_stability, &AutoPidRequest::reserved>;
};

}  // namespace sbgc::msg
