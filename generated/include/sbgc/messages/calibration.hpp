// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Calibrating sensors, motors and encoders, and tuning the controller.
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

struct CalibInfo;

/// Result of each axis so far.
struct AxisTuning {
  static constexpr std::size_t wire_size = 10;

  /// How badly the axis holds its target. Errata: E013, E015.
  float tracking_error{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  constexpr bool operator==(const AxisTuning&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisTuning& SBGC_RESTRICT out) noexcept {
  get(from, out.tracking_error);
  get(from + 4, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisTuning& SBGC_RESTRICT in) noexcept {
  put(to, in.tracking_error);
  put(to + 4, in.reserved);
}

/// Calibrate the accelerometer of the active IMU. Confirmed on reception and once more at the end;
/// not at all if a parameter is wrong.
///
/// CMD_CALIB_ACC (65), to the board, simple form; 0 bytes.
/// Effect: stores.
/// Source: Outgoing commands L621-L640. Errata: E091, E102, E121.
struct CalibAcc {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const CalibAcc&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibAcc& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibAcc& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the accelerometer of an IMU, or manage its calibrations. Confirmed on reception and
/// once more at the end; not at all if a parameter is wrong.
///
/// CMD_CALIB_ACC (65), to the board, extended form; 12 bytes.
/// Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640. Errata: E091, E102, E121.
struct CalibAccExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// Which IMU. Errata: E051, E053.
  CalibImu imu_idx{};
  /// What to do.
  CalibAction action{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  constexpr bool operator==(const CalibAccExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   CalibAccExt& SBGC_RESTRICT out) noexcept {
  using M = CalibAccExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2)) {
    detail::get_block(from, out, offsetof(M, imu_idx), 12);
    return;
  }
  get(from, out.imu_idx);
  get(from + 1, out.action);
  get(from + 2, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const CalibAccExt& SBGC_RESTRICT in) noexcept {
  using M = CalibAccExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2)) {
    detail::put_block(to, in, offsetof(M, imu_idx), 12);
    return;
  }
  put(to, in.imu_idx);
  put(to + 1, in.action);
  put(to + 2, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibAccExt& out) noexcept {
  if (body.size() != 12) return detail::wrong_size(body.size(), 12);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibAccExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 12) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {12, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const CalibAccExt& in) noexcept {
  using M = CalibAccExt;
  if (!(detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2))) return false;
  detail::add_block(sum, in, offsetof(M, imu_idx), 12);
  return true;
}

/// Calibrate the gyroscope of the active IMU. Confirmed on reception and once more at the end; not
/// at all if a parameter is wrong.
///
/// CMD_CALIB_GYRO (103), to the board, simple form; 0 bytes.
/// Effect: stores.
/// Source: Outgoing commands L621-L640. Errata: E091, E102, E121.
struct CalibGyro {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const CalibGyro&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibGyro& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibGyro& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the gyroscope of an IMU, or manage its calibrations. Confirmed on reception and once
/// more at the end; not at all if a parameter is wrong.
///
/// CMD_CALIB_GYRO (103), to the board, extended form; 12 bytes.
/// Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640. Errata: E091, E102, E121.
struct CalibGyroExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// Which IMU. Errata: E051, E053.
  CalibImu imu_idx{};
  /// What to do.
  CalibAction action{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  constexpr bool operator==(const CalibGyroExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   CalibGyroExt& SBGC_RESTRICT out) noexcept {
  using M = CalibGyroExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2)) {
    detail::get_block(from, out, offsetof(M, imu_idx), 12);
    return;
  }
  get(from, out.imu_idx);
  get(from + 1, out.action);
  get(from + 2, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const CalibGyroExt& SBGC_RESTRICT in) noexcept {
  using M = CalibGyroExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2)) {
    detail::put_block(to, in, offsetof(M, imu_idx), 12);
    return;
  }
  put(to, in.imu_idx);
  put(to + 1, in.action);
  put(to + 2, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibGyroExt& out) noexcept {
  if (body.size() != 12) return detail::wrong_size(body.size(), 12);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibGyroExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 12) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {12, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const CalibGyroExt& in) noexcept {
  using M = CalibGyroExt;
  if (!(detail::in_parallel(offsetof(M, imu_idx), offsetof(M, reserved), 2))) return false;
  detail::add_block(sum, in, offsetof(M, imu_idx), 12);
  return true;
}

/// Calibrate the magnetometer.
///
/// CMD_CALIB_MAG (59), to the board; 0 bytes.
/// Effect: stores.
/// Since board 3.0.
/// Source: Outgoing commands L940-L944. Errata: E094.
struct CalibMag {
  static constexpr CommandToBoard command = CommandToBoard::calib_mag;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const CalibMag&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibMag& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibMag& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the gains of the signals from a flight controller.
///
/// CMD_CALIB_EXT_GAIN (71), to the board; 0 bytes.
/// Effect: stores, moves.
/// Source: Outgoing commands L642. Errata: E141.
struct CalibExtGain {
  static constexpr CommandToBoard command = CommandToBoard::calib_ext_gain;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const CalibExtGain&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibExtGain& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibExtGain& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Find out poles and direction of the motors.
///
/// CMD_CALIB_POLES (80), to the board; 0 bytes.
/// Effect: stores, moves.
/// Source: Outgoing commands L650. Errata: E141.
struct CalibPoles {
  static constexpr CommandToBoard command = CommandToBoard::calib_poles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const CalibPoles&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibPoles& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibPoles& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the offset of the follow mode.
///
/// CMD_CALIB_OFFSET (79), to the board; 0 bytes.
/// Effect: stores, moves.
/// Source: Outgoing commands L688.
struct CalibOffset {
  static constexpr CommandToBoard command = CommandToBoard::calib_offset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const CalibOffset&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibOffset& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibOffset& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the measurement of the battery voltage.
///
/// CMD_CALIB_BAT (66), to the board; 2 bytes.
/// Effect: stores.
/// Source: Outgoing commands L690-L692.
struct CalibBat {
  static constexpr CommandToBoard command = CommandToBoard::calib_bat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// The true voltage, measured by other means. Unit: V, one count is 1/100. Errata: E077.
  Voltage actual_voltage{};

  constexpr bool operator==(const CalibBat&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   CalibBat& SBGC_RESTRICT out) noexcept {
  get(from, out.actual_voltage);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const CalibBat& SBGC_RESTRICT in) noexcept {
  put(to, in.actual_voltage);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibBat& out) noexcept {
  if (body.size() != 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibBat& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {2, {}};
}

/// What a host shows while sensors are calibrated.
///
/// CMD_CALIB_INFO (49), from the board; 33 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L546-L563; Variables L1233-L1246.
struct CalibInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 33;
  static constexpr std::size_t max_size = 33;
  static constexpr Availability since{0, 30};

  /// How much of the calibration is done. Unit: %. Range: 0 to 100.
  Percent progress{};
  /// IMU that this is about. Errata: E053.
  SelectedImu imu_type{};
  /// Accelerometer, as in CMD_REALTIME_DATA_3. Unit: g, one count is 1/512. Errata: E105, E108.
  Xyz<Acceleration> acc_data{};
  /// Strength of the gyroscope's signal.
  std::uint16_t gyro_abs_val{};
  /// Axis of the accelerometer that is calibrated next. Range: 0 to 2.
  std::uint8_t acc_cur_axis{};
  /// Directions of the accelerometer that are calibrated. Errata: E054.
  CalibratedLimits acc_limits_info{};
  /// Temperature of the IMU. Unit: degC. Range: -127 to 127.
  Temperature imu_temp_cels{};
  /// 1 if the gyroscope's calibration over temperature is used. Range: 0 to 1. Errata: E047.
  std::uint8_t temp_calib_gyro_enabled{};
  /// Lowest temperature of the gyroscope's calibration. Unit: degC. Range: -127 to 127. Errata:
  /// E047.
  Temperature temp_calib_gyro_t_min_cels{};
  /// Highest temperature of the gyroscope's calibration. Unit: degC. Range: -127 to 127. Errata:
  /// E047.
  Temperature temp_calib_gyro_t_max_cels{};
  /// 1 if the accelerometer's calibration over temperature is used. Range: 0 to 1. Errata: E047.
  std::uint8_t temp_calib_acc_enabled{};
  /// Calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y, -Z. Range:
  /// 0 to 3. Errata: E047, E054, E108.
  std::array<std::uint8_t, 6> temp_calib_acc_slot_num{};
  /// Lowest temperature of the accelerometer's calibration. Unit: degC. Range: -127 to 127. Errata:
  /// E047.
  Temperature temp_calib_acc_t_min_cels{};
  /// Highest temperature of the accelerometer's calibration. Unit: degC. Range: -127 to 127.
  /// Errata: E047.
  Temperature temp_calib_acc_t_max_cels{};
  /// Length of the difference between the estimated and the reference heading vector; the vectors
  /// have length 1. Unit: no unit, one count is 1/100. Range: 0 to 255.
  Hundredths h1_err_length{};
  /// Reserved; kept as it is.
  Bytes<7> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<222> tail{};

  constexpr bool operator==(const CalibInfo&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   CalibInfo& SBGC_RESTRICT out) noexcept {
  using M = CalibInfo;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, progress), offsetof(M, reserved), 26)) {
    detail::get_block(from, out, offsetof(M, progress), 33);
    return;
  }
  get(from, out.progress);
  get(from + 1, out.imu_type);
  get(from + 2, out.acc_data);
  get(from + 8, out.gyro_abs_val);
  get(from + 10, out.acc_cur_axis);
  get(from + 11, out.acc_limits_info);
  get(from + 12, out.imu_temp_cels);
  get(from + 13, out.temp_calib_gyro_enabled);
  get(from + 14, out.temp_calib_gyro_t_min_cels);
  get(from + 15, out.temp_calib_gyro_t_max_cels);
  get(from + 16, out.temp_calib_acc_enabled);
  get(from + 17, out.temp_calib_acc_slot_num);
  get(from + 23, out.temp_calib_acc_t_min_cels);
  get(from + 24, out.temp_calib_acc_t_max_cels);
  get(from + 25, out.h1_err_length);
  get(from + 26, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const CalibInfo& SBGC_RESTRICT in) noexcept {
  using M = CalibInfo;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, progress), offsetof(M, reserved), 26)) {
    detail::put_block(to, in, offsetof(M, progress), 33);
    return;
  }
  put(to, in.progress);
  put(to + 1, in.imu_type);
  put(to + 2, in.acc_data);
  put(to + 8, in.gyro_abs_val);
  put(to + 10, in.acc_cur_axis);
  put(to + 11, in.acc_limits_info);
  put(to + 12, in.imu_temp_cels);
  put(to + 13, in.temp_calib_gyro_enabled);
  put(to + 14, in.temp_calib_gyro_t_min_cels);
  put(to + 15, in.temp_calib_gyro_t_max_cels);
  put(to + 16, in.temp_calib_acc_enabled);
  put(to + 17, in.temp_calib_acc_slot_num);
  put(to + 23, in.temp_calib_acc_t_min_cels);
  put(to + 24, in.temp_calib_acc_t_max_cels);
  put(to + 25, in.h1_err_length);
  put(to + 26, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibInfo& out) noexcept {
  if (body.size() < 33) return detail::wrong_size(body.size(), 33);
  get(body.data(), out);
  return detail::get_tail(body, 33, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const CalibInfo& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 33 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 33, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const CalibInfo& in) noexcept {
  using M = CalibInfo;
  if (!(detail::in_parallel(offsetof(M, progress), offsetof(M, reserved), 26))) return false;
  detail::add_block(sum, in, offsetof(M, progress), 33);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for what to show while sensors are calibrated.
///
/// CMD_CALIB_INFO (49), to the board; 12 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L891-L896.
struct CalibInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{0, 30};
  using Response = CalibInfo;

  /// Which IMU. Errata: E051, E053.
  SelectedImu imu_type{};
  /// Reserved; kept as it is.
  Bytes<11> reserved{};

  constexpr bool operator==(const CalibInfoRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   CalibInfoRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.imu_type);
  get(from + 1, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const CalibInfoRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.imu_type);
  put(to + 1, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibInfoRequest& out) noexcept {
  if (body.size() != 12) return detail::wrong_size(body.size(), 12);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const CalibInfoRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 12) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {12, {}};
}

/// Body from the board, not documented.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Command ID definitions L142.
struct CalibMotorMagLink {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const CalibMotorMagLink&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibMotorMagLink& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const CalibMotorMagLink& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body to the board, not documented.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), to the board; 0 to 255 bytes.
/// Effect: unknown.
/// Since board 3.0.
/// Source: Command ID definitions L142.
struct CalibMotorMagLinkRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const CalibMotorMagLinkRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      CalibMotorMagLinkRequest& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const CalibMotorMagLinkRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Calibrate the offsets of the encoders.
///
/// CMD_ENCODERS_CALIB_OFFSET_4 (26), to the board; 0 bytes.
/// Effect: stores.
/// Since board 3.0.
/// Source: Outgoing commands L993.
struct EncodersCalibOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const EncodersCalibOffset4&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      EncodersCalibOffset4& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const EncodersCalibOffset4& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Calibrate the offsets between encoders and the motors' magnetic fields.
///
/// CMD_ENCODERS_CALIB_FLD_OFFSET_4 (27), to the board; 0 bytes.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L995.
struct EncodersCalibFldOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_fld_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const EncodersCalibFldOffset4&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      EncodersCalibFldOffset4& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const EncodersCalibFldOffset4& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Progress of the automatic tuning.
///
/// CMD_AUTO_PID (35), from the board; 57 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L462-L474. Errata: E012, E105, E114.
struct AutoPid {
  static constexpr CommandFromBoard command = CommandFromBoard::auto_pid;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 57;
  static constexpr std::size_t max_size = 57;
  static constexpr Availability since{0, 30};

  /// Proportional gain of each axis.
  Axes<std::uint8_t> p{};
  /// Integral gain of each axis, as stored.
  Axes<std::uint8_t> i{};
  /// Derivative gain of each axis.
  Axes<std::uint8_t> d{};
  /// Low-pass filter of each axis, as stored. Errata: E105.
  Axes<std::uint16_t> lpf_freq{};
  /// How many rounds are done.
  std::uint16_t iter_num{};
  /// Result of each axis so far. Errata: E012.
  Axes<AxisTuning> axes{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<198> tail{};

  constexpr bool operator==(const AutoPid&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AutoPid& SBGC_RESTRICT out) noexcept {
  get(from, out.p);
  get(from + 3, out.i);
  get(from + 6, out.d);
  get(from + 9, out.lpf_freq);
  get(from + 15, out.iter_num);
  get(from + 17, out.axes);
  get(from + 47, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AutoPid& SBGC_RESTRICT in) noexcept {
  put(to, in.p);
  put(to + 3, in.i);
  put(to + 6, in.d);
  put(to + 9, in.lpf_freq);
  put(to + 15, in.iter_num);
  put(to + 17, in.axes);
  put(to + 47, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AutoPid& out) noexcept {
  if (body.size() < 57) return detail::wrong_size(body.size(), 57);
  get(body.data(), out);
  return detail::get_tail(body, 57, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const AutoPid& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 57 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 57, in.tail);
  return {size, {}};
}

/// Start or stop the automatic tuning. With AUTO_PID_CFG_SEND_GUI the board sends CMD_AUTO_PID
/// again and again while it tunes.
///
/// CMD_AUTO_PID (35), to the board; 19 bytes.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L806-L811; Variables L1177-L1182.
struct AutoPidRequest {
  static constexpr CommandToBoard command = CommandToBoard::auto_pid;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 19;
  static constexpr std::size_t max_size = 19;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// For cfg_flags: stops the tuning.
  static constexpr std::uint8_t stop_tuning = 0;

  /// Profile to switch to first. Range: 0 to 4. Errata: E062.
  std::uint8_t profile_id{};
  /// What to tune and how. stop_tuning (0): stops the tuning. Errata: E056.
  AutoPidFlags cfg_flags{};
  /// How far to go for high gains, at the cost of stability. Range: 0 to 255.
  std::uint8_t gain_vs_stability{};
  /// Reserved; kept as it is.
  Bytes<16> reserved{};

  constexpr bool operator==(const AutoPidRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AutoPidRequest& SBGC_RESTRICT out) noexcept {
  using M = AutoPidRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved), 3)) {
    detail::get_block(from, out, offsetof(M, profile_id), 19);
    return;
  }
  get(from, out.profile_id);
  get(from + 1, out.cfg_flags);
  get(from + 2, out.gain_vs_stability);
  get(from + 3, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AutoPidRequest& SBGC_RESTRICT in) noexcept {
  using M = AutoPidRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved), 3)) {
    detail::put_block(to, in, offsetof(M, profile_id), 19);
    return;
  }
  put(to, in.profile_id);
  put(to + 1, in.cfg_flags);
  put(to + 2, in.gain_vs_stability);
  put(to + 3, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AutoPidRequest& out) noexcept {
  if (body.size() != 19) return detail::wrong_size(body.size(), 19);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AutoPidRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 19) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {19, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const AutoPidRequest& in) noexcept {
  using M = AutoPidRequest;
  if (!(detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved), 3))) return false;
  detail::add_block(sum, in, offsetof(M, profile_id), 19);
  return true;
}

}  // namespace sbgc::msg
