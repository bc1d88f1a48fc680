// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Live data from the sensors and from the controller.
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

struct RealtimeData3;
struct RealtimeData4;
struct RealtimeDataCustom;

/// Sensors of each axis.
struct AxisSensors {
  static constexpr std::size_t wire_size = 4;

  /// Accelerometer. Unit: g, one count is 1/512.
  Acceleration acc_data{};
  /// Gyroscope. Unit: deg/s, one count is 2000/32767. Errata: E074.
  GyroRate gyro_data{};

  constexpr bool operator==(const AxisSensors&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisSensors& SBGC_RESTRICT out) noexcept {
  get(from, out.acc_data);
  get(from + 2, out.gyro_data);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisSensors& SBGC_RESTRICT in) noexcept {
  put(to, in.acc_data);
  put(to + 2, in.gyro_data);
}

/// What the message needs to know; unused bytes are 0.
struct StreamConfig {
  static constexpr std::size_t wire_size = 8;

  /// Which blocks to send. Present when cmd_id is CMD_REALTIME_DATA_CUSTOM.
  Optional<RealtimeDataCustomFlags> flags{};
  /// Which IMU's attitude to send. Present when cmd_id is CMD_AHRS_HELPER. Errata: E053.
  Optional<ImuIndex> imu_type{};
  /// What is not used of the 8 bytes; filled up with zeros.
  BoundedBytes<8> rest{};

  constexpr bool operator==(const StreamConfig&) const = default;
};


/// Ask for live data, with the older id.
///
/// CMD_REALTIME_DATA (68), to the board; 0 bytes.
/// Effect: reads.
/// Source: Outgoing commands L615-L617. Errata: E020.
struct RealtimeData {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = RealtimeData3;

  constexpr bool operator==(const RealtimeData&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeData& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeData& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Live data.
///
/// CMD_REALTIME_DATA_3 (23), from the board; 63 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L361-L396; Variables L1117-L1135. Errata: E020, E043, E099.
struct RealtimeData3 {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 63;
  static constexpr std::size_t max_size = 63;
  static constexpr Availability since{0, 30};

  /// For ext_fc_roll and ext_fc_pitch: the input serves RC control or commands.
  static constexpr std::int16_t ext_fc_unused = 0;

  /// Sensors of each axis.
  Axes<AxisSensors> axes{};
  /// Errors counted on the serial line.
  std::uint16_t serial_error_cnt{};
  /// Errors that are present; 0 is none. Errata: E048.
  SystemErrors system_error{};
  /// Reason of an emergency stop. Errata: E033.
  SystemSubError system_sub_error{};
  /// Reserved; kept as it is.
  Bytes<3> reserved{};
  /// RC channels of the axes. Unit: us. Range: 1000 to 2000. Errata: E070.
  Axes<RcSignal> rc{};
  /// RC command channel. Unit: us. Range: 1000 to 2000. Errata: E070.
  RcSignal rc_cmd{};
  /// Signal of an external flight controller for roll. Unit: us. Range: 1000 to 2000. ext_fc_unused
  /// (0): the input serves RC control or commands. Errata: E060.
  RcSignal ext_fc_roll{};
  /// Signal of an external flight controller for pitch. Unit: us. Range: 1000 to 2000.
  /// ext_fc_unused (0): the input serves RC control or commands. Errata: E060.
  RcSignal ext_fc_pitch{};
  /// Angles of the camera. Unit: deg, one count is 360/16384. Range: -32768 to 32767.
  Axes<Angle14> angle{};
  /// Angles of the frame, from the second IMU if there is one. Unit: deg, one count is 360/16384.
  /// Range: -32768 to 32767. Errata: E040.
  Axes<Angle14> frame_imu_angle{};
  /// Angles that RC asks for. Unit: deg, one count is 360/16384. Range: -32768 to 32767. Errata:
  /// E041.
  Axes<Angle14> rc_angle{};
  /// Duration of one cycle of the controller. Unit: us. Errata: E078.
  Microseconds cycle_time{};
  /// Errors counted on the I2C bus.
  std::uint16_t i2c_error_count{};
  /// Older form of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR. Errata: E075.
  std::uint8_t error_code{};
  /// Battery voltage. Unit: V, one count is 1/100.
  Voltage bat_level{};
  /// State of the motors.
  OtherFlags other_flags{};
  /// Currently selected IMU. Since board 3.0.
  SelectedImu cur_imu{};
  /// Active profile. Range: 0 to 4. Errata: E061.
  std::uint8_t cur_profile{};
  /// Power of each motor.
  Axes<std::uint8_t> motor_power{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<192> tail{};

  constexpr bool operator==(const RealtimeData3&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   RealtimeData3& SBGC_RESTRICT out) noexcept {
  using M = RealtimeData3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, motor_power), 5)) {
    detail::get_block(from, out, offsetof(M, axes), 55);
    detail::get_block(from + 55, out, offsetof(M, bat_level), 8);
    return;
  }
  get(from, out.axes);
  get(from + 12, out.serial_error_cnt);
  get(from + 14, out.system_error);
  get(from + 16, out.system_sub_error);
  get(from + 17, out.reserved);
  get(from + 20, out.rc);
  get(from + 26, out.rc_cmd);
  get(from + 28, out.ext_fc_roll);
  get(from + 30, out.ext_fc_pitch);
  get(from + 32, out.angle);
  get(from + 38, out.frame_imu_angle);
  get(from + 44, out.rc_angle);
  get(from + 50, out.cycle_time);
  get(from + 52, out.i2c_error_count);
  get(from + 54, out.error_code);
  get(from + 55, out.bat_level);
  get(from + 57, out.other_flags);
  get(from + 58, out.cur_imu);
  get(from + 59, out.cur_profile);
  get(from + 60, out.motor_power);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const RealtimeData3& SBGC_RESTRICT in) noexcept {
  using M = RealtimeData3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, motor_power), 5)) {
    detail::put_block(to, in, offsetof(M, axes), 55);
    detail::put_block(to + 55, in, offsetof(M, bat_level), 8);
    return;
  }
  put(to, in.axes);
  put(to + 12, in.serial_error_cnt);
  put(to + 14, in.system_error);
  put(to + 16, in.system_sub_error);
  put(to + 17, in.reserved);
  put(to + 20, in.rc);
  put(to + 26, in.rc_cmd);
  put(to + 28, in.ext_fc_roll);
  put(to + 30, in.ext_fc_pitch);
  put(to + 32, in.angle);
  put(to + 38, in.frame_imu_angle);
  put(to + 44, in.rc_angle);
  put(to + 50, in.cycle_time);
  put(to + 52, in.i2c_error_count);
  put(to + 54, in.error_code);
  put(to + 55, in.bat_level);
  put(to + 57, in.other_flags);
  put(to + 58, in.cur_imu);
  put(to + 59, in.cur_profile);
  put(to + 60, in.motor_power);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeData3& out) noexcept {
  if (body.size() < 63) return detail::wrong_size(body.size(), 63);
  get(body.data(), out);
  return detail::get_tail(body, 63, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeData3& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 63 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 63, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const RealtimeData3& in) noexcept {
  using M = RealtimeData3;
  if (!(detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, motor_power), 5))) return false;
  detail::add_block(sum, in, offsetof(M, axes), 55);
  detail::add_block(sum, in, offsetof(M, bat_level), 8);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for live data.
///
/// CMD_REALTIME_DATA_3 (23), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L615-L617.
struct RealtimeData3Request {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = RealtimeData3;

  constexpr bool operator==(const RealtimeData3Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeData3Request& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeData3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Live data with joint angles, currents and temperatures.
///
/// CMD_REALTIME_DATA_4 (25), from the board; 124 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L398-L410; Variables L1136-L1146. Errata: E044.
struct RealtimeData4 {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_4;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 124;
  static constexpr std::size_t max_size = 124;
  static constexpr Availability since{0, 30};

  /// For ext_fc_roll and ext_fc_pitch: the input serves RC control or commands.
  static constexpr std::int16_t ext_fc_unused = 0;

  /// Sensors of each axis.
  Axes<AxisSensors> axes{};
  /// Errors counted on the serial line.
  std::uint16_t serial_error_cnt{};
  /// Errors that are present; 0 is none. Errata: E048.
  SystemErrors system_error{};
  /// Reason of an emergency stop. Errata: E033.
  SystemSubError system_sub_error{};
  /// Reserved; kept as it is.
  Bytes<3> reserved_1{};
  /// RC channels of the axes. Unit: us. Range: 1000 to 2000. Errata: E070.
  Axes<RcSignal> rc{};
  /// RC command channel. Unit: us. Range: 1000 to 2000. Errata: E070.
  RcSignal rc_cmd{};
  /// Signal of an external flight controller for roll. Unit: us. Range: 1000 to 2000. ext_fc_unused
  /// (0): the input serves RC control or commands. Errata: E060.
  RcSignal ext_fc_roll{};
  /// Signal of an external flight controller for pitch. Unit: us. Range: 1000 to 2000.
  /// ext_fc_unused (0): the input serves RC control or commands. Errata: E060.
  RcSignal ext_fc_pitch{};
  /// Angles of the camera. Unit: deg, one count is 360/16384. Range: -32768 to 32767.
  Axes<Angle14> angle{};
  /// Angles of the frame, from the second IMU if there is one. Unit: deg, one count is 360/16384.
  /// Range: -32768 to 32767. Errata: E040.
  Axes<Angle14> frame_imu_angle{};
  /// Angles that RC asks for. Unit: deg, one count is 360/16384. Range: -32768 to 32767. Errata:
  /// E041.
  Axes<Angle14> rc_angle{};
  /// Duration of one cycle of the controller. Unit: us. Errata: E078.
  Microseconds cycle_time{};
  /// Errors counted on the I2C bus.
  std::uint16_t i2c_error_count{};
  /// Older form of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR. Errata: E075.
  std::uint8_t error_code{};
  /// Battery voltage. Unit: V, one count is 1/100.
  Voltage bat_level{};
  /// State of the motors.
  OtherFlags other_flags{};
  /// Currently selected IMU. Since board 3.0.
  SelectedImu cur_imu{};
  /// Active profile. Range: 0 to 4. Errata: E061.
  std::uint8_t cur_profile{};
  /// Power of each motor.
  Axes<std::uint8_t> motor_power{};
  /// Angle of each joint, from an encoder, the second IMU or an estimate; 0 in normal position.
  /// Unit: deg, one count is 360/16384. Errata: E039, E044.
  Axes<Angle14> rotor_angle{};
  /// Reserved; kept as it is.
  Bytes<1> reserved_2{};
  /// Motor power that imbalance costs. Unit: %, one count is 100/512. Range: -512 to 512.
  Axes<BalanceError> balance_error{};
  /// Current that the board draws. Unit: mA.
  Current current{};
  /// Magnetometer, raw.
  Axes<std::int16_t> mag_data{};
  /// Temperature of the main IMU. Unit: degC. Range: -127 to 127.
  Temperature imu_temperature{};
  /// Temperature of the frame IMU. Unit: degC. Range: -127 to 127.
  Temperature frame_imu_temperature{};
  /// Angle between the estimated and the reference gravity vector. Unit: deg, one count is 1/10.
  /// Range: 0 to 255.
  AngleError imu_g_err{};
  /// Angle between the estimated and the reference heading vector. Unit: deg, one count is 1/10.
  /// Range: 0 to 255.
  AngleError imu_h_err{};
  /// Reserved; kept as it is.
  Bytes<36> reserved_3{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<131> tail{};

  constexpr bool operator==(const RealtimeData4&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   RealtimeData4& SBGC_RESTRICT out) noexcept {
  using M = RealtimeData4;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, reserved_2), 14) &&
      detail::in_parallel(offsetof(M, balance_error), offsetof(M, reserved_3), 18)) {
    detail::get_block(from, out, offsetof(M, axes), 55);
    detail::get_block(from + 55, out, offsetof(M, bat_level), 15);
    detail::get_block(from + 70, out, offsetof(M, balance_error), 54);
    return;
  }
  get(from, out.axes);
  get(from + 12, out.serial_error_cnt);
  get(from + 14, out.system_error);
  get(from + 16, out.system_sub_error);
  get(from + 17, out.reserved_1);
  get(from + 20, out.rc);
  get(from + 26, out.rc_cmd);
  get(from + 28, out.ext_fc_roll);
  get(from + 30, out.ext_fc_pitch);
  get(from + 32, out.angle);
  get(from + 38, out.frame_imu_angle);
  get(from + 44, out.rc_angle);
  get(from + 50, out.cycle_time);
  get(from + 52, out.i2c_error_count);
  get(from + 54, out.error_code);
  get(from + 55, out.bat_level);
  get(from + 57, out.other_flags);
  get(from + 58, out.cur_imu);
  get(from + 59, out.cur_profile);
  get(from + 60, out.motor_power);
  get(from + 63, out.rotor_angle);
  get(from + 69, out.reserved_2);
  get(from + 70, out.balance_error);
  get(from + 76, out.current);
  get(from + 78, out.mag_data);
  get(from + 84, out.imu_temperature);
  get(from + 85, out.frame_imu_temperature);
  get(from + 86, out.imu_g_err);
  get(from + 87, out.imu_h_err);
  get(from + 88, out.reserved_3);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const RealtimeData4& SBGC_RESTRICT in) noexcept {
  using M = RealtimeData4;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, reserved_2), 14) &&
      detail::in_parallel(offsetof(M, balance_error), offsetof(M, reserved_3), 18)) {
    detail::put_block(to, in, offsetof(M, axes), 55);
    detail::put_block(to + 55, in, offsetof(M, bat_level), 15);
    detail::put_block(to + 70, in, offsetof(M, balance_error), 54);
    return;
  }
  put(to, in.axes);
  put(to + 12, in.serial_error_cnt);
  put(to + 14, in.system_error);
  put(to + 16, in.system_sub_error);
  put(to + 17, in.reserved_1);
  put(to + 20, in.rc);
  put(to + 26, in.rc_cmd);
  put(to + 28, in.ext_fc_roll);
  put(to + 30, in.ext_fc_pitch);
  put(to + 32, in.angle);
  put(to + 38, in.frame_imu_angle);
  put(to + 44, in.rc_angle);
  put(to + 50, in.cycle_time);
  put(to + 52, in.i2c_error_count);
  put(to + 54, in.error_code);
  put(to + 55, in.bat_level);
  put(to + 57, in.other_flags);
  put(to + 58, in.cur_imu);
  put(to + 59, in.cur_profile);
  put(to + 60, in.motor_power);
  put(to + 63, in.rotor_angle);
  put(to + 69, in.reserved_2);
  put(to + 70, in.balance_error);
  put(to + 76, in.current);
  put(to + 78, in.mag_data);
  put(to + 84, in.imu_temperature);
  put(to + 85, in.frame_imu_temperature);
  put(to + 86, in.imu_g_err);
  put(to + 87, in.imu_h_err);
  put(to + 88, in.reserved_3);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeData4& out) noexcept {
  if (body.size() < 124) return detail::wrong_size(body.size(), 124);
  get(body.data(), out);
  return detail::get_tail(body, 124, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeData4& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 124 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 124, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const RealtimeData4& in) noexcept {
  using M = RealtimeData4;
  if (!(detail::in_parallel(offsetof(M, axes), offsetof(M, error_code), 54) &&
      detail::in_parallel(offsetof(M, bat_level), offsetof(M, reserved_2), 14) &&
      detail::in_parallel(offsetof(M, balance_error), offsetof(M, reserved_3), 18))) return false;
  detail::add_block(sum, in, offsetof(M, axes), 55);
  detail::add_block(sum, in, offsetof(M, bat_level), 15);
  detail::add_block(sum, in, offsetof(M, balance_error), 54);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for the longer live data.
///
/// CMD_REALTIME_DATA_4 (25), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L619.
struct RealtimeData4Request {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = RealtimeData4;

  constexpr bool operator==(const RealtimeData4Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeData4Request& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeData4Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Live data of the blocks that the request names.
///
/// CMD_REALTIME_DATA_CUSTOM (88), from the board; 2 to 110 bytes, and later firmware may append
/// more.
/// Since firmware 2.59, board 3.0.
/// Source: Incoming commands L587-L590; Variables L1210-L1220.
struct RealtimeDataCustom {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_custom;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 110;
  static constexpr Availability since{2590, 30};

  /// For rc_data and rc_channels: undefined.
  static constexpr std::int16_t undefined = -32768;

  /// What has to be known from earlier messages to read the body.
  struct Context {
    /// The FLAGS of the request: they are not in the answer, and decide which blocks it has.
    RealtimeDataCustomFlags flags{};
  };

  /// Time of the sample. Unit: ms.
  MillisecondClock timestamp_ms{};
  /// Angles of the main IMU (Euler). Unit: deg, one count is 360/16384. Present when flags has
  /// IMU_ANGLES.
  Optional<Axes<Angle14>> imu_angles{};
  /// Angles that the gimbal should hold (Euler). Unit: deg, one count is 360/16384. Present when
  /// flags has TARGET_ANGLES.
  Optional<Axes<Angle14>> target_angles{};
  /// Speeds that the gimbal should hold over the Euler axes. Unit: deg/s, one count is 2000/32767.
  /// Present when flags has TARGET_SPEED. Errata: E071.
  Optional<Axes<GyroRate>> target_speed{};
  /// Joint angles. Unit: deg, one count is 360/16384. Present when flags has STATOR_ROTOR_ANGLE.
  /// Errata: E039.
  Optional<Axes<Angle14>> stator_rotor_angle{};
  /// Gyroscope after calibration. Unit: deg/s, one count is 2000/32767. Present when flags has
  /// GYRO_DATA. Errata: E078.
  Optional<Axes<GyroRate>> gyro_data{};
  /// RC signals of the inputs ROLL, PITCH, YAW, CMD, FC_ROLL, FC_PITCH. Unit: no unit, one count is
  /// 1/16384. Range: -16384 to 16384. undefined (-32768): undefined. Present when flags has
  /// RC_DATA. Errata: E070.
  Optional<std::array<FineRcSignal, 6>> rc_data{};
  /// Gravity row of the rotation matrix. Range: -1 to 1. Present when flags has Z1_H1_VECTORS.
  /// Errata: E038, E216.
  Optional<Xyz<float>> z1_vector{};
  /// Heading row of the rotation matrix; the cross product of both is the third row. Range: -1 to
  /// 1. Present when flags has Z1_H1_VECTORS. Errata: E038.
  Optional<Xyz<float>> h1_vector{};
  /// All captured RC channels. Unit: no unit, one count is 1/16384. Range: -16384 to 16384.
  /// undefined (-32768): undefined. Present when flags has RC_CHANNELS. Errata: E070.
  Optional<std::array<FineRcSignal, 18>> rc_channels{};
  /// Accelerometer after calibration. Unit: g, one count is 1/512. Present when flags has ACC_DATA.
  /// Errata: E078.
  Optional<Axes<Acceleration>> acc_data{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<253> tail{};

  constexpr bool operator==(const RealtimeDataCustom&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   RealtimeDataCustom& SBGC_RESTRICT out) noexcept {
  get(from, out.timestamp_ms);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const RealtimeDataCustom& SBGC_RESTRICT in) noexcept {
  put(to, in.timestamp_ms);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeDataCustom& out,
                                      const RealtimeDataCustom::Context& context = {}) noexcept {
  if (body.size() < 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  detail::Reader reader(body, 2);
  reader.when(context.flags.has(RealtimeDataCustomFlag::imu_angles),
              detail::required, out.imu_angles, "imu_angles");
  reader.when(context.flags.has(RealtimeDataCustomFlag::target_angles),
              detail::required, out.target_angles, "target_angles");
  reader.when(context.flags.has(RealtimeDataCustomFlag::target_speed),
              detail::required, out.target_speed, "target_speed");
  reader.when(context.flags.has(RealtimeDataCustomFlag::stator_rotor_angle),
              detail::required, out.stator_rotor_angle, "stator_rotor_angle");
  reader.when(context.flags.has(RealtimeDataCustomFlag::gyro_data),
              detail::required, out.gyro_data, "gyro_data");
  reader.when(context.flags.has(RealtimeDataCustomFlag::rc_data),
              detail::required, out.rc_data, "rc_data");
  reader.when(context.flags.has(RealtimeDataCustomFlag::z1_h1_vectors),
              detail::required, out.z1_vector, "z1_vector");
  reader.when(context.flags.has(RealtimeDataCustomFlag::z1_h1_vectors),
              detail::required, out.h1_vector, "h1_vector");
  reader.when(context.flags.has(RealtimeDataCustomFlag::rc_channels),
              detail::required, out.rc_channels, "rc_channels");
  reader.when(context.flags.has(RealtimeDataCustomFlag::acc_data),
              detail::required, out.acc_data, "acc_data");
  return reader.end(out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeDataCustom& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 2);
  if (in.imu_angles) writer.value(*in.imu_angles, "imu_angles");
  if (in.target_angles) writer.value(*in.target_angles, "target_angles");
  if (in.target_speed) writer.value(*in.target_speed, "target_speed");
  if (in.stator_rotor_angle) writer.value(*in.stator_rotor_angle, "stator_rotor_angle");
  if (in.gyro_data) writer.value(*in.gyro_data, "gyro_data");
  if (in.rc_data) writer.value(*in.rc_data, "rc_data");
  if (in.z1_vector) writer.value(*in.z1_vector, "z1_vector");
  if (in.h1_vector) writer.value(*in.h1_vector, "h1_vector");
  if (in.rc_channels) writer.value(*in.rc_channels, "rc_channels");
  if (in.acc_data) writer.value(*in.acc_data, "acc_data");
  writer.array(in.tail, "tail");
  return writer.end();
}

/// Ask for live data of the blocks that FLAGS names.
///
/// CMD_REALTIME_DATA_CUSTOM (88), to the board; 10 bytes.
/// Effect: reads.
/// Since firmware 2.59, board 3.0.
/// Source: Outgoing commands L980-L983; Variables L1208-L1209.
struct RealtimeDataCustomRequest {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_custom;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{2590, 30};
  using Response = RealtimeDataCustom;

  /// Which blocks to send.
  RealtimeDataCustomFlags flags{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  constexpr bool operator==(const RealtimeDataCustomRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   RealtimeDataCustomRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.flags);
  get(from + 4, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const RealtimeDataCustomRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.flags);
  put(to + 4, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RealtimeDataCustomRequest& out) noexcept {
  if (body.size() != 10) return detail::wrong_size(body.size(), 10);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const RealtimeDataCustomRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 10) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {10, {}};
}

/// Start, change or end a data stream: messages that the board sends at a fixed rate, unasked.
/// CMD_ID and CONFIG together name the stream on this port: a second request with the same ones
/// changes its interval. Single samples come within 1 ms of their time, their average rate is
/// exact; what does not fit through the port is left out.
///
/// CMD_DATA_STREAM_INTERVAL (85), to the board; 21 bytes.
/// Effect: sets.
/// Since firmware 2.59, board 3.0.
/// Source: Outgoing commands L963-L978; Variables L1202-L1207. Errata: E050, E089, E100.
struct DataStreamInterval {
  static constexpr CommandToBoard command = CommandToBoard::data_stream_interval;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 21;
  static constexpr std::size_t max_size = 21;
  static constexpr Availability since{2590, 30};
  using Response = void;

  /// For interval_ms: ends the stream.
  static constexpr std::uint16_t end_stream = 0;
  /// For interval_ms: a sample in every cycle, 0.8 ms.
  static constexpr std::uint16_t every_cycle = 1;

  /// Message to send. Errata: E089.
  CommandFromBoard cmd_id{};
  /// Time between two samples. Unit: ms. end_stream (0): ends the stream. every_cycle (1): a sample
  /// in every cycle, 0.8 ms. Errata: E072.
  Milliseconds interval_ms{};
  /// What the message needs to know; unused bytes are 0. Errata: E100.
  StreamConfig config{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  constexpr bool operator==(const DataStreamInterval&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   DataStreamInterval& SBGC_RESTRICT out) noexcept {
  get(from, out.cmd_id);
  get(from + 1, out.interval_ms);
  get(from + 11, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const DataStreamInterval& SBGC_RESTRICT in) noexcept {
  put(to, in.cmd_id);
  put(to + 1, in.interval_ms);
  put(to + 11, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      DataStreamInterval& out) noexcept {
  if (body.size() != 21) return detail::wrong_size(body.size(), 21);
  get(body.data(), out);
  detail::Reader config_bytes(body.subspan(3, 8), 0);
  config_bytes.when(out.cmd_id == CommandFromBoard::realtime_data_custom,
              detail::required, out.config.flags, "config.flags");
  config_bytes.when(out.cmd_id == CommandFromBoard::ahrs_helper,
              detail::required, out.config.imu_type, "config.imu_type");
  config_bytes.rest(out.config.rest, "config.rest");
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const DataStreamInterval& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 21) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer config_bytes(out.subspan(3, 8), 0);
  config_bytes.when(in.cmd_id == CommandFromBoard::realtime_data_custom,
              detail::required, in.config.flags, "config.flags");
  config_bytes.when(in.cmd_id == CommandFromBoard::ahrs_helper,
              detail::required, in.config.imu_type, "config.imu_type");
  config_bytes.array(in.config.rest, "config.rest");
  if (const Status status = config_bytes.fill(3); !status) return {0, status};
  return {21, {}};
}

}  // namespace sbgc::msg
