// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Live data from the sensors and the controller.
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

struct RealtimeData3;
struct RealtimeData4;
struct RealtimeDataCustom;

/// Sensors of each axis.
struct AxisSensors {
  /// Accelerometer. Unit: g.
  Acceleration acc_data{};
  /// Gyroscope. Unit: deg/s.
  GyroRate gyro_data{};

  bool operator==(const AxisSensors&) const = default;
  using FixedMembers = Members<&AxisSensors::acc_data, &AxisSensors::gyro_data>;
};

/// Options of the message; unused bytes are 0.
struct StreamConfig {
  static constexpr std::size_t wire_size = 8;

  /// Blocks to send. Present if cmd_id is CMD_REALTIME_DATA_CUSTOM.
  Optional<RealtimeDataCustomFlags> flags{};
  /// IMU whose attitude to send. Present if cmd_id is CMD_AHRS_HELPER.
  Optional<ImuIndex> imu_type{};
  /// What is not used of the 8 bytes; filled up with zeros.
  BoundedBytes<8> rest{};

  bool operator==(const StreamConfig&) const = default;
};

/// Request live data, with the older id.
///
/// CMD_REALTIME_DATA (68), to the board; 0 bytes. Effect: reads. Source: Outgoing commands
/// L615-L617.
struct RealtimeData {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = RealtimeData3;

  bool operator==(const RealtimeData&) const = default;
};

/// Live data.
///
/// CMD_REALTIME_DATA_3 (23), from the board; 63 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L361-L396; Variables L1117-L1135.
struct RealtimeData3 {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 63;
  static constexpr std::size_t max_size = 63;
  static constexpr Availability since{.board = 30};

  /// For ext_fc_roll and ext_fc_pitch: the input serves RC control or commands.
  static constexpr std::int16_t ext_fc_unused{0};

  /// Sensors of each axis.
  Axes<AxisSensors> axes{};
  /// Number of errors on the serial line.
  std::uint16_t serial_error_cnt{};
  /// Current errors; 0 if there are none.
  SystemErrors system_error{};
  /// Reason for an emergency stop.
  SystemSubError system_sub_error{};
  /// Reserved; kept as it is.
  Bytes<3> reserved{};
  /// RC channels of the axes. Range: 1000 to 2000 us.
  Axes<RcSignal> rc{};
  /// RC command channel. Range: 1000 to 2000 us.
  RcSignal rc_cmd{};
  /// Roll signal of an external flight controller. Range: 1000 to 2000 us.
  RcSignal ext_fc_roll{};
  /// Pitch signal of an external flight controller. Range: 1000 to 2000 us.
  RcSignal ext_fc_pitch{};
  /// Camera angles. Unit: deg.
  Axes<Angle14> angle{};
  /// Frame angles, from the second IMU if present. Unit: deg.
  Axes<Angle14> frame_imu_angle{};
  /// Target angles from RC. Unit: deg.
  Axes<Angle14> rc_angle{};
  /// Duration of one control cycle. Unit: us.
  Microseconds cycle_time{};
  /// Number of errors on the I2C bus.
  std::uint16_t i2c_error_count{};
  /// Predecessor of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR.
  std::uint8_t error_code{};
  /// Battery voltage. Unit: V.
  Voltage bat_level{};
  /// State of the motors.
  OtherFlags other_flags{};
  /// Selected IMU. Since board 3.0.
  SelectedImu cur_imu{};
  /// Active profile. Range: 0 to 4.
  std::uint8_t cur_profile{};
  /// Power of each motor.
  Axes<std::uint8_t> motor_power{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<192> tail{};

  bool operator==(const RealtimeData3&) const = default;
  using FixedMembers = Members<&RealtimeData3::axes, &RealtimeData3::serial_error_cnt,
      &RealtimeData3::system_error, &RealtimeData3::system_sub_error, &RealtimeData3::reserved,
      &RealtimeData3::rc, &RealtimeData3::rc_cmd, &RealtimeData3::ext_fc_roll,
      &RealtimeData3::ext_fc_pitch, &RealtimeData3::angle, &RealtimeData3::frame_imu_angle,
      &RealtimeData3::rc_angle, &RealtimeData3::cycle_time, &RealtimeData3::i2c_error_count,
      &RealtimeData3::error_code, &RealtimeData3::bat_level, &RealtimeData3::other_flags,
      &RealtimeData3::cur_imu, &RealtimeData3::cur_profile, &RealtimeData3::motor_power>;
};

/// Request live data.
///
/// CMD_REALTIME_DATA_3 (23), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L615-L617.
struct RealtimeData3Request {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = RealtimeData3;

  bool operator==(const RealtimeData3Request&) const = default;
};

/// Live data with joint angles, currents and temperatures.
///
/// CMD_REALTIME_DATA_4 (25), from the board; 124 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L398-L410; Variables L1136-L1146.
struct RealtimeData4 {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_4;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 124;
  static constexpr std::size_t max_size = 124;
  static constexpr Availability since{.board = 30};

  /// For ext_fc_roll and ext_fc_pitch: the input serves RC control or commands.
  static constexpr std::int16_t ext_fc_unused{0};

  /// Sensors of each axis.
  Axes<AxisSensors> axes{};
  /// Number of errors on the serial line.
  std::uint16_t serial_error_cnt{};
  /// Current errors; 0 if there are none.
  SystemErrors system_error{};
  /// Reason for an emergency stop.
  SystemSubError system_sub_error{};
  /// Reserved; kept as it is.
  Bytes<3> reserved_1{};
  /// RC channels of the axes. Range: 1000 to 2000 us.
  Axes<RcSignal> rc{};
  /// RC command channel. Range: 1000 to 2000 us.
  RcSignal rc_cmd{};
  /// Roll signal of an external flight controller. Range: 1000 to 2000 us.
  RcSignal ext_fc_roll{};
  /// Pitch signal of an external flight controller. Range: 1000 to 2000 us.
  RcSignal ext_fc_pitch{};
  /// Camera angles. Unit: deg.
  Axes<Angle14> angle{};
  /// Frame angles, from the second IMU if present. Unit: deg.
  Axes<Angle14> frame_imu_angle{};
  /// Target angles from RC. Unit: deg.
  Axes<Angle14> rc_angle{};
  /// Duration of one control cycle. Unit: us.
  Microseconds cycle_time{};
  /// Number of errors on the I2C bus.
  std::uint16_t i2c_error_count{};
  /// Predecessor of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR.
  std::uint8_t error_code{};
  /// Battery voltage. Unit: V.
  Voltage bat_level{};
  /// State of the motors.
  OtherFlags other_flags{};
  /// Selected IMU. Since board 3.0.
  SelectedImu cur_imu{};
  /// Active profile. Range: 0 to 4.
  std::uint8_t cur_profile{};
  /// Power of each motor.
  Axes<std::uint8_t> motor_power{};
  /// Angle of each joint, from an encoder, the second IMU or an estimate; 0 in the normal position.
  /// Unit: deg.
  Axes<Angle14> rotor_angle{};
  /// Reserved; kept as it is.
  Bytes<1> reserved_2{};
  /// Motor power lost to imbalance. Range: -100 to 100 %.
  Axes<BalanceError> balance_error{};
  /// Current drawn by the board. Unit: mA.
  Current current{};
  /// Raw magnetometer data.
  Axes<std::int16_t> mag_data{};
  /// Temperature of the main IMU. Range: -127 to 127 degC.
  Temperature imu_temperature{};
  /// Temperature of the frame IMU. Range: -127 to 127 degC.
  Temperature frame_imu_temperature{};
  /// Angle between the estimated and the reference gravity vector. Unit: deg.
  AngleError imu_g_err{};
  /// Angle between the estimated and the reference heading vector. Unit: deg.
  AngleError imu_h_err{};
  /// Reserved; kept as it is.
  Bytes<36> reserved_3{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<131> tail{};

  bool operator==(const RealtimeData4&) const = default;
  using FixedMembers = Members<&RealtimeData4::axes, &RealtimeData4::serial_error_cnt,
      &RealtimeData4::system_error, &RealtimeData4::system_sub_error, &RealtimeData4::reserved_1,
      &RealtimeData4::rc, &RealtimeData4::rc_cmd, &RealtimeData4::ext_fc_roll,
      &RealtimeData4::ext_fc_pitch, &RealtimeData4::angle, &RealtimeData4::frame_imu_angle,
      &RealtimeData4::rc_angle, &RealtimeData4::cycle_time, &RealtimeData4::i2c_error_count,
      &RealtimeData4::error_code, &RealtimeData4::bat_level, &RealtimeData4::other_flags,
      &RealtimeData4::cur_imu, &RealtimeData4::cur_profile, &RealtimeData4::motor_power,
      &RealtimeData4::rotor_angle, &RealtimeData4::reserved_2, &RealtimeData4::balance_error,
      &RealtimeData4::current, &RealtimeData4::mag_data, &RealtimeData4::imu_temperature,
      &RealtimeData4::frame_imu_temperature, &RealtimeData4::imu_g_err, &RealtimeData4::imu_h_err,
      &RealtimeData4::reserved_3>;
};

/// Request the longer live data.
///
/// CMD_REALTIME_DATA_4 (25), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L619.
struct RealtimeData4Request {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = RealtimeData4;

  bool operator==(const RealtimeData4Request&) const = default;
};

/// Live data of the requested blocks.
///
/// CMD_REALTIME_DATA_CUSTOM (88), from the board; 2 to 110 bytes, and later firmware may append
/// more. Since firmware 2.59, board 3.0. Source: Incoming commands L587-L590; Variables
/// L1210-L1220.
struct RealtimeDataCustom {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_custom;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 110;
  static constexpr Availability since{.firmware = 2590, .board = 30};

  /// For rc_data and rc_channels: undefined.
  static constexpr std::int16_t undefined{-32768};

  /// Facts from earlier messages that the body needs for decoding.
  struct Context {
    /// FLAGS of the request. The response does not repeat them, but they determine its blocks.
    RealtimeDataCustomFlags flags{};
  };

  /// Time of the sample. Unit: ms.
  MillisecondClock timestamp_ms{};
  /// Angles of the main IMU (Euler). Unit: deg. Present if flags has IMU_ANGLES.
  Optional<Axes<Angle14>> imu_angles{};
  /// Target angles (Euler). Unit: deg. Present if flags has TARGET_ANGLES.
  Optional<Axes<Angle14>> target_angles{};
  /// Target speeds over the Euler axes. Unit: deg/s. Present if flags has TARGET_SPEED.
  Optional<Axes<GyroRate>> target_speed{};
  /// Joint angles. Unit: deg. Present if flags has STATOR_ROTOR_ANGLE.
  Optional<Axes<Angle14>> stator_rotor_angle{};
  /// Gyroscope after calibration. Unit: deg/s. Present if flags has GYRO_DATA.
  Optional<Axes<GyroRate>> gyro_data{};
  /// RC signals of the inputs ROLL, PITCH, YAW, CMD, FC_ROLL, FC_PITCH. Range: -1 to 1. Present if
  /// flags has RC_DATA.
  Optional<std::array<FineRcSignal, 6>> rc_data{};
  /// Gravity row of the rotation matrix. Range: -1 to 1. Present if flags has Z1_H1_VECTORS.
  Optional<Xyz<float>> z1_vector{};
  /// Heading row of the rotation matrix; the cross product of both rows is the third. Range: -1 to
  /// 1. Present if flags has Z1_H1_VECTORS.
  Optional<Xyz<float>> h1_vector{};
  /// All captured RC channels. Range: -1 to 1. Present if flags has RC_CHANNELS.
  Optional<std::array<FineRcSignal, 18>> rc_channels{};
  /// Accelerometer after calibration. Unit: g. Present if flags has ACC_DATA.
  Optional<Axes<Acceleration>> acc_data{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<253> tail{};

  bool operator==(const RealtimeDataCustom&) const = default;
  using FixedMembers = Members<&RealtimeDataCustom::timestamp_ms>;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor, const Context& context) noexcept {
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::imu_angles), self.imu_angles,
        "imu_angles");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::target_angles),
        self.target_angles, "target_angles");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::target_speed), self.target_speed,
        "target_speed");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::stator_rotor_angle),
        self.stator_rotor_angle, "stator_rotor_angle");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::gyro_data), self.gyro_data,
        "gyro_data");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::rc_data), self.rc_data,
        "rc_data");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::z1_h1_vectors), self.z1_vector,
        "z1_vector");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::z1_h1_vectors), self.h1_vector,
        "h1_vector");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::rc_channels), self.rc_channels,
        "rc_channels");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::acc_data), self.acc_data,
        "acc_data");
  }
};

/// Request live data of the blocks in FLAGS.
///
/// CMD_REALTIME_DATA_CUSTOM (88), to the board; 10 bytes. Effect: reads. Since firmware 2.59, board
/// 3.0. Source: Outgoing commands L980-L983; Variables L1208-L1209.
struct RealtimeDataCustomRequest {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_custom;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{.firmware = 2590, .board = 30};
  using Response = RealtimeDataCustom;

  /// Blocks to send.
  RealtimeDataCustomFlags flags{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const RealtimeDataCustomRequest&) const = default;
  using FixedMembers = Members<&RealtimeDataCustomRequest::flags,
      &RealtimeDataCustomRequest::reserved>;
};

/// Start, change or end a data stream: messages that the board sends at a fixed rate. CMD_ID and
/// CONFIG together identify the stream on this port; a second request with the same values changes
/// its interval. Each sample is within 1 ms of its time, and the average rate is exact. Samples
/// that exceed the capacity of the port are dropped.
///
/// CMD_DATA_STREAM_INTERVAL (85), to the board; 21 bytes. Effect: sets. Since firmware 2.59, board
/// 3.0. Source: Outgoing commands L963-L978; Variables L1202-L1207.
struct DataStreamInterval {
  static constexpr CommandToBoard command = CommandToBoard::data_stream_interval;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 21;
  static constexpr std::size_t max_size = 21;
  static constexpr Availability since{.firmware = 2590, .board = 30};
  using Response = void;

  /// For interval_ms: ends the stream.
  static constexpr std::uint16_t end_stream{0};
  /// For interval_ms: a sample in every cycle, 0.8 ms.
  static constexpr std::uint16_t every_cycle{1};

  /// Message to send.
  CommandFromBoard cmd_id{};
  /// Time between samples. Unit: ms.
  Milliseconds interval_ms{};
  /// Options of the message; unused bytes are 0.
  StreamConfig config{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  bool operator==(const DataStreamInterval&) const = default;
  using FixedMembers = Members<&DataStreamInterval::cmd_id, &DataStreamInterval::interval_ms,
      &DataStreamInterval::config, &DataStreamInterval::reserved>;
  [[gnu::always_inline]]
  static constexpr void tagged_unions(auto& self, auto& cursor) noexcept {
    cursor.enter(3, 8);
    cursor.when(self.cmd_id == CommandFromBoard::realtime_data_custom, self.config.flags,
        "config.flags");
    cursor.when(self.cmd_id == CommandFromBoard::ahrs_helper, self.config.imu_type,
        "config.imu_type");
    cursor.rest(self.config.rest, "config.rest");
    cursor.leave();
  }
};

}  // namespace sbgc::msg
