// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Live data from the sensors and the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct RealtimeData3;
struct RealtimeData4;
struct RealtimeDataCustom;
struct RealtimeDataCustom2;

/// Sensors of each axis.
struct AxisSensors {
  /// Accelerometer. Unit: g.
  Acceleration acc_data{};
  /// Gyroscope. Unit: deg/s.
  GyroRate gyro_data{};

  bool operator==(const AxisSensors&) const = default;
  using FixedMembers = Members<&AxisSensors::acc_data, &AxisSensors::gyro_data>;
};

/// Control of a fourth motor.
struct Motor4Control {
  /// Feed-forward speed. Unit: deg/s.
  GyroRate ff_speed{};
  /// Error of the angle. Unit: deg.
  Angle14 angle_error{};
  /// Output of the PID controller.
  float pid_out{};

  bool operator==(const Motor4Control&) const = default;
  using FixedMembers = Members<&Motor4Control::ff_speed, &Motor4Control::angle_error,
      &Motor4Control::pid_out>;
};

/// State of each motor.
struct MotorPowerState {
  /// Output of the motor; 10000 is full power. Range: -10000 to 10000.
  std::int16_t mot_power{};
  /// Current of the motor. Unit: mA.
  Current mot_current{};
  /// Temperature of the motor. Unit: degC.
  Temperature mot_temp{};
  /// State of the motor.
  MotorPowerFlags mot_flags{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const MotorPowerState&) const = default;
  using FixedMembers = Members<&MotorPowerState::mot_power, &MotorPowerState::mot_current,
      &MotorPowerState::mot_temp, &MotorPowerState::mot_flags, &MotorPowerState::reserved>;
};

/// State of the motors and of the supply.
struct SystemPowerState {
  /// State of each motor.
  Axes<MotorPowerState> motors{};
  /// State of the motor power.
  PowerState state{};
  /// Battery voltage. Unit: V.
  Voltage battery_voltage{};
  /// Current of the whole system. Unit: mA.
  Current total_current{};
  /// Problems with the motors or their drivers.
  SystemPowerFlags system_flags{};

  bool operator==(const SystemPowerState&) const = default;
  using FixedMembers = Members<&SystemPowerState::motors, &SystemPowerState::state,
      &SystemPowerState::battery_voltage, &SystemPowerState::total_current,
      &SystemPowerState::system_flags>;
};

/// Counters of communication errors.
struct CommErrors {
  /// Number of errors on the I2C bus.
  std::uint16_t i2c_errors{};
  /// Number of errors on the serial line.
  std::uint16_t serial_errors{};
  /// Number of errors on the CAN bus.
  std::uint16_t can_errors{};
  /// State of the CAN bus.
  CanErrorFlags can_err_flags{};

  bool operator==(const CommErrors&) const = default;
  using FixedMembers = Members<&CommErrors::i2c_errors, &CommErrors::serial_errors,
      &CommErrors::can_errors, &CommErrors::can_err_flags>;
};

/// State of the system.
struct SystemStatus {
  /// State of the system.
  StateFlags flags{};
  /// Calibration or other task that is running.
  CalibMode calib_mode{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const SystemStatus&) const = default;
  using FixedMembers = Members<&SystemStatus::flags, &SystemStatus::calib_mode,
      &SystemStatus::reserved>;
};

/// Distances to the software limits, in Euler axes or, in servo mode, in those of the motors;
/// imprecise for large angles.
struct SoftLimitDistances {
  /// For dist: not set or unknown.
  static constexpr std::int16_t unknown_distance{32767};

  /// Distances to the lower and the upper limit: positive inside, negative outside of it. Unit:
  /// deg.
  std::array<Angle14, 2> dist{};

  bool operator==(const SoftLimitDistances&) const = default;
  using FixedMembers = Members<&SoftLimitDistances::dist>;
};

/// State of the main IMU.
struct MainImuState {
  /// Angle between the estimated and the reference gravity vector. Unit: deg. Unconfirmed.
  AngleError g_ref_error{};
  /// Angle between the estimated and the reference heading vector. Unit: deg. Unconfirmed.
  AngleError h_ref_error{};
  /// Flags that no source explains.
  std::uint8_t flags{};
  /// Errors of an external sensor.
  std::uint8_t ext_sensor_error{};
  /// Reserved; kept as it is.
  Bytes<7> reserved{};

  bool operator==(const MainImuState&) const = default;
  using FixedMembers = Members<&MainImuState::g_ref_error, &MainImuState::h_ref_error,
      &MainImuState::flags, &MainImuState::ext_sensor_error, &MainImuState::reserved>;
};

/// State of the inputs.
struct PinStates {
  /// State of additional buttons.
  InputStates extra_buttons_state{};
  /// State of the pins.
  InputStates pin_state{};
  /// Reserved; kept as it is.
  Bytes<4> reserved{};

  bool operator==(const PinStates&) const = default;
  using FixedMembers = Members<&PinStates::extra_buttons_state, &PinStates::pin_state,
      &PinStates::reserved>;
};

/// Options of the message; unused bytes are 0.
struct StreamConfig {
  static constexpr std::size_t wire_size = 8;

  /// Blocks to send. Present if cmd_id is CMD_REALTIME_DATA_CUSTOM.
  Optional<RealtimeDataCustomFlags> flags{};
  /// IMU whose attitude to send. Present if cmd_id is CMD_AHRS_HELPER. Unconfirmed.
  Optional<ImuIndex> imu_type{};
  /// Event to report. Present if cmd_id is CMD_EVENT.
  Optional<EventId> event_id{};
  /// Kinds of the event to report. Present if cmd_id is CMD_EVENT.
  Optional<EventTypes> event_type{};
  /// Data to send. Present if cmd_id is CMD_CAN_DRV_TELEMETRY.
  Optional<CanDrvTelemetryFlags> telemetry_flags{};
  /// CAN motor driver whose data to send. Range: 0 to 6. Present if cmd_id is
  /// CMD_CAN_DRV_TELEMETRY.
  Optional<std::uint8_t> drv_id{};
  /// External motor whose state to send. Present if cmd_id is CMD_EXT_MOTORS_STATE.
  Optional<std::uint8_t> motor{};
  /// Data to send. Present if cmd_id is CMD_EXT_MOTORS_STATE.
  Optional<ExtMotorsStateFields> data_set{};
  /// Blocks to send. Present if cmd_id is CMD_REALTIME_DATA_CUSTOM2.
  Optional<RealtimeDataCustom2Flags> custom2_flags{};
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

  /// For rc and rc_cmd and ext_fc_roll and ext_fc_pitch: no signal.
  static constexpr std::int16_t no_signal{-10000};
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

  /// For rc and rc_cmd and ext_fc_roll and ext_fc_pitch: no signal.
  static constexpr std::int16_t no_signal{-10000};
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
  /// Output of each motor; 10000 is full power. Range: -10000 to 10000. Since firmware 2.61.
  Axes<std::int16_t> motor_out{};
  /// Calibration or other task that is running. Since firmware 2.61.
  CalibMode calib_mode{};
  /// Errors of the external sensor of a CAN IMU. Since firmware 2.61.
  std::uint8_t can_imu_ext_sens_err{};
  /// Actual angles of the camera. Unit: deg. Since firmware 2.72.
  Axes<Angle14> actual_angle{};
  /// State of the system. Since firmware 2.73.
  StateFlags system_state_flags{};
  /// Reserved; kept as it is.
  Bytes<18> reserved_3{};
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
      &RealtimeData4::motor_out, &RealtimeData4::calib_mode, &RealtimeData4::can_imu_ext_sens_err,
      &RealtimeData4::actual_angle, &RealtimeData4::system_state_flags, &RealtimeData4::reserved_3>;
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
/// CMD_REALTIME_DATA_CUSTOM (88), from the board; 2 to 255 bytes, and later firmware may append
/// more. Since firmware 2.59, board 3.0. Source: Incoming commands L587-L590; Variables
/// L1210-L1220.
struct RealtimeDataCustom {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_custom;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2590, .board = 30};

  /// For rc_data and rc_channels: undefined.
  static constexpr std::int16_t undefined{-32768};

  /// Facts from earlier messages that the body needs for decoding.
  struct Context {
    /// FLAGS of the request, which determine the blocks. Only with INCLUDE_FLAGS does the response
    /// repeat them.
    RealtimeDataCustomFlags flags{};

    /// Calls `visitor(fact)` for each of them.
    static constexpr void visit(auto& context, auto&& visitor) {
      visitor(context.flags);
    }

    /// The fact that a body may repeat, and the flag for it.
    static constexpr auto repeated = &Context::flags;
    static constexpr auto repeats = RealtimeDataCustomFlag::include_flags;
  };

  /// Time of the sample. Unit: ms.
  MillisecondClock timestamp_ms{};
  /// FLAGS of the request. Present if flags has INCLUDE_FLAGS.
  Optional<RealtimeDataCustomFlags> flags{};
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
  /// Control of a fourth motor. Present if flags has MOTOR4_CONTROL.
  Optional<Motor4Control> motor4_control{};
  /// State of the attitude estimation. Present if flags has AHRS_DEBUG_INFO.
  Optional<AhrsDebugInfo> ahrs_debug_info{};
  /// Raw values of the encoders. Present if flags has ENCODER_RAW24. Unconfirmed.
  Optional<Axes<U24>> encoder_raw24{};
  /// Angles of the main IMU (Euler), in radians. Unit: rad. Present if flags has IMU_ANGLES_RAD.
  Optional<Axes<Radians>> imu_angles_rad{};
  /// Floating-point variables of the script. Present if flags has SCRIPT_VARS_FLOAT.
  Optional<std::array<float, 10>> script_vars_float{};
  /// Integer variables of the script. Present if flags has SCRIPT_VARS_INT16.
  Optional<std::array<std::int16_t, 10>> script_vars_int16{};
  /// State of the motors and of the supply. Present if flags has SYSTEM_POWER_STATE.
  Optional<SystemPowerState> system_power_state{};
  /// Speed of the camera relative to the frame. Unit: deg/s. Present if flags has FRAME_CAM_RATE.
  Optional<Axes<GyroRate>> frame_cam_rate{};
  /// Angles of the main IMU (Euler), in high resolution. Unit: deg. Present if flags has
  /// IMU_ANGLES_20.
  Optional<Axes<Angle20>> imu_angles_20{};
  /// Target angles (Euler), in high resolution. Unit: deg. Present if flags has TARGET_ANGLES_20.
  Optional<Axes<Angle20>> target_angles_20{};
  /// Counters of communication errors. Present if flags has COMM_ERRORS.
  Optional<CommErrors> comm_errors{};
  /// State of the system. Present if flags has SYSTEM_STATE.
  Optional<SystemStatus> system_state{};
  /// Attitude of the main IMU. Present if flags has IMU_QUAT.
  Optional<PackedQuaternion> imu_quat{};
  /// Target attitude; only of Extended boards that CMD_CONTROL_QUAT controls. Present if flags has
  /// TARGET_QUAT.
  Optional<PackedQuaternion> target_quat{};
  /// Rotation from the main IMU to the frame. Present if flags has IMU_TO_FRAME_QUAT.
  Optional<PackedQuaternion> imu_to_frame_quat{};
  /// Raw values of the analog inputs, averaged over 8 ms. Range: 0 to 4096. Present if flags has
  /// ADC_CH_RAW.
  Optional<std::array<std::uint16_t, 4>> adc_ch_raw{};
  /// Distances to the software limits, in Euler axes or, in servo mode, in those of the motors;
  /// imprecise for large angles. Present if flags has SW_LIMITS_DIST.
  Optional<Axes<SoftLimitDistances>> sw_limits_dist{};
  /// Distance to the neutral point of the follow mode, or 0 without it. Unit: deg. Present if flags
  /// has FOLLOW_DIST.
  Optional<Axes<Angle14>> follow_dist{};
  /// Lower limits of an external target, such as an angle of CMD_CONTROL, in follow mode as well;
  /// if both are 0, there are none. Unit: deg. Present if flags has EXT_TARGET_LIMIT. Unconfirmed.
  Optional<Axes<LongAngle14>> ext_target_limit_min{};
  /// Upper limits of an external target. Unit: deg. Present if flags has EXT_TARGET_LIMIT.
  /// Unconfirmed.
  Optional<Axes<LongAngle14>> ext_target_limit_max{};
  /// Joint angles, in high resolution. Unit: deg. Present if flags has FRAME_CAM_ANGLE_20.
  Optional<Axes<Angle20>> frame_cam_angle_20{};
  /// State of the main IMU. Present if flags has MAIN_IMU_STATE.
  Optional<MainImuState> main_imu_state{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<253> tail{};

  bool operator==(const RealtimeDataCustom&) const = default;
  using FixedMembers = Members<&RealtimeDataCustom::timestamp_ms>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor, const Context& context) noexcept {
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::include_flags), self.flags,
        "flags");
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
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::motor4_control),
        self.motor4_control, "motor4_control");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::ahrs_debug_info),
        self.ahrs_debug_info, "ahrs_debug_info");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::encoder_raw24),
        self.encoder_raw24, "encoder_raw24");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::imu_angles_rad),
        self.imu_angles_rad, "imu_angles_rad");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::script_vars_float),
        self.script_vars_float, "script_vars_float");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::script_vars_int16),
        self.script_vars_int16, "script_vars_int16");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::system_power_state),
        self.system_power_state, "system_power_state");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::frame_cam_rate),
        self.frame_cam_rate, "frame_cam_rate");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::imu_angles_20),
        self.imu_angles_20, "imu_angles_20");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::target_angles_20),
        self.target_angles_20, "target_angles_20");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::comm_errors), self.comm_errors,
        "comm_errors");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::system_state), self.system_state,
        "system_state");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::imu_quat), self.imu_quat,
        "imu_quat");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::target_quat), self.target_quat,
        "target_quat");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::imu_to_frame_quat),
        self.imu_to_frame_quat, "imu_to_frame_quat");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::adc_ch_raw), self.adc_ch_raw,
        "adc_ch_raw");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::sw_limits_dist),
        self.sw_limits_dist, "sw_limits_dist");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::follow_dist), self.follow_dist,
        "follow_dist");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::ext_target_limit),
        self.ext_target_limit_min, "ext_target_limit_min");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::ext_target_limit),
        self.ext_target_limit_max, "ext_target_limit_max");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::frame_cam_angle_20),
        self.frame_cam_angle_20, "frame_cam_angle_20");
    cursor.when_context(context.flags.has(RealtimeDataCustomFlag::main_imu_state),
        self.main_imu_state, "main_imu_state");
  }
};

/// Request live data of the blocks in FLAGS. The requested blocks must fit into one body of 255
/// bytes; all of them do not.
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

/// More live data of the requested blocks.
///
/// CMD_REALTIME_DATA_CUSTOM2 (139), from the board; 2 to 52 bytes, and later firmware may append
/// more. Since firmware 2.74.2. Source: Vendor's code of 2026.
struct RealtimeDataCustom2 {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_custom2;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 52;
  static constexpr Availability since{.firmware = 2742};

  /// Facts from earlier messages that the body needs for decoding.
  struct Context {
    /// FLAGS of the request, which determine the blocks. Only with INCLUDE_FLAGS does the response
    /// repeat them.
    RealtimeDataCustom2Flags flags{};

    /// Calls `visitor(fact)` for each of them.
    static constexpr void visit(auto& context, auto&& visitor) {
      visitor(context.flags);
    }

    /// The fact that a body may repeat, and the flag for it.
    static constexpr auto repeated = &Context::flags;
    static constexpr auto repeats = RealtimeDataCustom2Flag::include_flags;
  };

  /// Time of the sample. Unit: ms.
  MillisecondClock timestamp_ms{};
  /// FLAGS of the request. Present if flags has INCLUDE_FLAGS.
  Optional<RealtimeDataCustom2Flags> flags{};
  /// Angles of the frame IMU (Euler). Unit: deg. Present if flags has FRAME_IMU_ANGLES.
  Optional<Axes<Angle14>> frame_imu_angles{};
  /// Gyroscope of the frame IMU. Unit: deg/s. Present if flags has FRAME_GYRO.
  Optional<Axes<GyroRate>> frame_gyro{};
  /// Accelerometer of the frame IMU. Unit: g. Present if flags has FRAME_ACC.
  Optional<Axes<Acceleration>> frame_acc{};
  /// Values for debugging. Present if flags has DEBUG.
  Optional<std::array<std::int16_t, 4>> debug{};
  /// Raw magnetometer data. Present if flags has MAG_SENS_DATA.
  Optional<Axes<std::int16_t>> mag_sens_data{};
  /// State of the inputs. Present if flags has PIN_STATE.
  Optional<PinStates> pin_state{};
  /// Amplitude of the stabilization error. Unit: deg. Present if flags has STAB_ERR_AMPL.
  Optional<Axes<Millidegrees>> stab_err_ampl{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<253> tail{};

  bool operator==(const RealtimeDataCustom2&) const = default;
  using FixedMembers = Members<&RealtimeDataCustom2::timestamp_ms>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor, const Context& context) noexcept {
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::include_flags), self.flags,
        "flags");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::frame_imu_angles),
        self.frame_imu_angles, "frame_imu_angles");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::frame_gyro), self.frame_gyro,
        "frame_gyro");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::frame_acc), self.frame_acc,
        "frame_acc");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::debug), self.debug, "debug");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::mag_sens_data),
        self.mag_sens_data, "mag_sens_data");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::pin_state), self.pin_state,
        "pin_state");
    cursor.when_context(context.flags.has(RealtimeDataCustom2Flag::stab_err_ampl),
        self.stab_err_ampl, "stab_err_ampl");
  }
};

/// Request live data of the blocks in FLAGS.
///
/// CMD_REALTIME_DATA_CUSTOM2 (139), to the board; 10 bytes. Effect: reads. Since firmware 2.74.2.
/// Source: Vendor's code of 2026.
struct RealtimeDataCustom2Request {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_custom2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{.firmware = 2742};
  using Response = RealtimeDataCustom2;

  /// Blocks to send.
  RealtimeDataCustom2Flags flags{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const RealtimeDataCustom2Request&) const = default;
  using FixedMembers = Members<&RealtimeDataCustom2Request::flags,
      &RealtimeDataCustom2Request::reserved>;
};

/// Start, change or end a data stream: messages that the board sends at a fixed rate. CMD_ID and
/// CONFIG together identify the stream on this port; a second request with the same values changes
/// its interval. Each sample is within 1 ms of its time, and the average rate is exact. Samples
/// that exceed the capacity of the port are dropped. With SYNC_TO_DATA, INTERVAL_MS is a divider:
/// the number of events for each sample.
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
  /// Time between samples; a divider with SYNC_TO_DATA. Unit: ms.
  Milliseconds interval_ms{};
  /// Options of the message; unused bytes are 0.
  StreamConfig config{};
  /// Event that triggers the samples. Since firmware 2.70b1.
  StreamSync sync_to_data{};
  /// Reserved; kept as it is.
  Bytes<9> reserved{};

  bool operator==(const DataStreamInterval&) const = default;
  using FixedMembers = Members<&DataStreamInterval::cmd_id, &DataStreamInterval::interval_ms,
      &DataStreamInterval::config, &DataStreamInterval::sync_to_data,
      &DataStreamInterval::reserved>;
  SBGC_ALWAYS_INLINE
  static constexpr void tagged_unions(auto& self, auto& cursor) noexcept {
    cursor.enter(3, 8);
    cursor.when(self.cmd_id == CommandFromBoard::realtime_data_custom, self.config.flags,
        "config.flags");
    cursor.when(self.cmd_id == CommandFromBoard::ahrs_helper, self.config.imu_type,
        "config.imu_type");
    cursor.when(self.cmd_id == CommandFromBoard::event, self.config.event_id, "config.event_id");
    cursor.when(self.cmd_id == CommandFromBoard::event, self.config.event_type,
        "config.event_type");
    cursor.when(self.cmd_id == CommandFromBoard::can_drv_telemetry, self.config.telemetry_flags,
        "config.telemetry_flags");
    cursor.when(self.cmd_id == CommandFromBoard::can_drv_telemetry, self.config.drv_id,
        "config.drv_id");
    cursor.when(self.cmd_id == CommandFromBoard::ext_motors_state, self.config.motor,
        "config.motor");
    cursor.when(self.cmd_id == CommandFromBoard::ext_motors_state, self.config.data_set,
        "config.data_set");
    cursor.when(self.cmd_id == CommandFromBoard::realtime_data_custom2, self.config.custom2_flags,
        "config.custom2_flags");
    cursor.rest(self.config.rest, "config.rest");
    cursor.leave();
  }
};

/// Live data of a CAN motor driver. The board sends it only as a stream that
/// CMD_DATA_STREAM_INTERVAL starts.
///
/// CMD_CAN_DRV_TELEMETRY (127), from the board; 3 to 35 bytes, and later firmware may append more.
/// Since firmware 2.72, board 3.6. Unconfirmed. Source: Later firmware.
struct CanDrvTelemetry {
  static constexpr CommandFromBoard command = CommandFromBoard::can_drv_telemetry;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 35;
  static constexpr Availability since{.firmware = 2720, .board = 36};

  /// Facts from earlier messages that the body needs for decoding.
  struct Context {
    /// FLAGS in CONFIG of the stream request; they determine the data that follow.
    CanDrvTelemetryFlags flags{};

    /// Calls `visitor(fact)` for each of them.
    static constexpr void visit(auto& context, auto&& visitor) {
      visitor(context.flags);
    }
  };

  /// The driver. Range: 0 to 6.
  std::uint8_t drv_id{};
  /// Time of the sample. Unit: ms.
  MillisecondClock timestamp_ms{};
  /// State of the CAN bus; its bits are not documented. Present if flags has CAN_BUS_FLAGS.
  Optional<std::uint8_t> can_bus_flags{};
  /// Number of errors on the CAN bus. Present if flags has CAN_BUS_ERR_CNT.
  Optional<std::uint16_t> can_bus_err_cnt{};
  /// Temperature of the driver. Unit: degC. Present if flags has TEMP_BOARD.
  Optional<Temperature> temp_board{};
  /// Temperature of the motor. Unit: degC. Present if flags has TEMP_MOTOR.
  Optional<Temperature> temp_motor{};
  /// Average current. Unit: mA. Present if flags has AVG_CURRENT.
  Optional<Current> avg_current{};
  /// Supply voltage. Unit: V. Present if flags has BUS_VOLTAGE.
  Optional<Millivolts> bus_voltage{};
  /// State of the pins. Present if flags has PIN_STATE.
  Optional<CanDrvPins> pin_state{};
  /// Current of each phase. Unit: mA. Present if flags has PHASE_CURRENT.
  Optional<std::array<SignedCurrent, 3>> phase_current{};
  /// Number of errors of the encoder. Present if flags has ENCODER_ERROR_CNT.
  Optional<std::uint16_t> encoder_error_cnt{};
  /// Current that makes torque. Unit: mA. Present if flags has IQ_ID_CURRENT.
  Optional<SignedCurrent> iq_current{};
  /// Current that makes the field. Unit: mA. Present if flags has IQ_ID_CURRENT.
  Optional<SignedCurrent> id_current{};
  /// Speed of the motor. Unit: rpm. Present if flags has MOTOR_SPEED.
  Optional<RevolutionsPerMinute> motor_speed{};
  /// Error of the position controller. Present if flags has PID_POS_ERR.
  Optional<std::int16_t> pid_pos_err{};
  /// Error of the speed controller. Present if flags has PID_SPEED_ERR.
  Optional<std::int16_t> pid_speed_err{};
  /// Target of the torque current. Unit: %. Present if flags has IQ_REF.
  Optional<CurrentShare> iq_ref{};
  /// Error of the current controller. Present if flags has PID_CURRENT_ERR.
  Optional<std::int16_t> pid_current_err{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<252> tail{};

  bool operator==(const CanDrvTelemetry&) const = default;
  using FixedMembers = Members<&CanDrvTelemetry::drv_id, &CanDrvTelemetry::timestamp_ms>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor, const Context& context) noexcept {
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::can_bus_flags), self.can_bus_flags,
        "can_bus_flags");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::can_bus_err_cnt),
        self.can_bus_err_cnt, "can_bus_err_cnt");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::temp_board), self.temp_board,
        "temp_board");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::temp_motor), self.temp_motor,
        "temp_motor");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::avg_current), self.avg_current,
        "avg_current");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::bus_voltage), self.bus_voltage,
        "bus_voltage");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::pin_state), self.pin_state,
        "pin_state");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::phase_current), self.phase_current,
        "phase_current");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::encoder_error_cnt),
        self.encoder_error_cnt, "encoder_error_cnt");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::iq_id_current), self.iq_current,
        "iq_current");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::iq_id_current), self.id_current,
        "id_current");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::motor_speed), self.motor_speed,
        "motor_speed");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::pid_pos_err), self.pid_pos_err,
        "pid_pos_err");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::pid_speed_err), self.pid_speed_err,
        "pid_speed_err");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::iq_ref), self.iq_ref, "iq_ref");
    cursor.when_context(context.flags.has(CanDrvTelemetryFlag::pid_current_err),
        self.pid_current_err, "pid_current_err");
  }
};

/// Undocumented body from the board.
///
/// CMD_CAN_DRV_STATE (98), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CanDrvState {
  static constexpr CommandFromBoard command = CommandFromBoard::can_drv_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvState&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CAN_DRV_STATE (98), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct CanDrvStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::can_drv_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvStateRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_REALTIME_DATA_CAN_DRV (101), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
/// Later firmware.
struct RealtimeDataCanDrv {
  static constexpr CommandFromBoard command = CommandFromBoard::realtime_data_can_drv;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const RealtimeDataCanDrv&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_REALTIME_DATA_CAN_DRV (101), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
/// 2.60. Source: Later firmware.
struct RealtimeDataCanDrvRequest {
  static constexpr CommandToBoard command = CommandToBoard::realtime_data_can_drv;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const RealtimeDataCanDrvRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

}  // namespace sbgc::msg
