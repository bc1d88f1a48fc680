// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Moving the camera and querying its orientation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/flag_unit.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct ControlQuatStatus;
struct GetAngles;
struct GetAnglesExt;

/// Target of each axis.
struct ControlAxis {
  /// Speed of the motion; the acceleration limit in the parameters may restrict it. Unit: deg/s.
  /// Interpreted as FineSpeed if CONTROL_FLAG_HIGH_RES_SPEED is set.
  ControlSpeed speed{};
  /// Target angle; in MODE_RC the RC signal, -500 to 500, in MODE_RC_HIGH_RES -16384 to 16384.
  /// Unit: deg.
  Angle14 angle{};

  bool operator==(const ControlAxis&) const = default;
  using FixedMembers = Members<&ControlAxis::speed, &ControlAxis::angle>;
};

/// Motion of each axis.
struct ControlExtAxis {
  /// Mode. Present if data_set has {AXIS}_SPEED or {AXIS}_ANGLE.
  Optional<ControlMode> mode{};
  /// Further options. Present if data_set has {AXIS}_SPEED or {AXIS}_ANGLE.
  Optional<ControlExtFlags> flags{};
  /// Speed. Unit: deg/s. Interpreted as FineSpeed if CONTROL_FLAG_HIGH_RES_SPEED is set. Present if
  /// data_set has {AXIS}_SPEED, and lacks {AXIS}_SPEED_32BIT.
  Optional<ControlSpeed> speed{};
  /// Speed, with 32 bits. Unit: deg/s. Present if data_set has {AXIS}_SPEED and {AXIS}_SPEED_32BIT.
  /// Unconfirmed.
  Optional<LongFineSpeed> speed_32{};
  /// Target angle, or an RC signal as in CMD_CONTROL. Unit: deg. Present if data_set has
  /// {AXIS}_ANGLE, and lacks {AXIS}_ANGLE_32BIT.
  Optional<Angle14> angle{};
  /// Target angle, with 32 bits. Unit: deg. Present if data_set has {AXIS}_ANGLE and
  /// {AXIS}_ANGLE_32BIT. Unconfirmed.
  Optional<Angle20> angle_32{};

  bool operator==(const ControlExtAxis&) const = default;
};

/// Options of each axis.
struct ControlConfigAxis {
  /// For rc_lpf: the filter does not change.
  static constexpr std::uint8_t keep_rc_lpf{0};
  /// For acc_limit: the limit does not change.
  static constexpr std::uint16_t keep_acc_limit{0};
  /// For jerk_slope: the time does not change.
  static constexpr std::uint8_t keep_jerk_slope{0};
  /// For jerk_slope: the acceleration changes at once.
  static constexpr std::uint8_t no_jerk_slope{1};

  /// Low-pass filter of the angle, 0 (off) to 15.
  std::uint8_t angle_lpf{};
  /// Low-pass filter of the speed, 0 (off) to 15.
  std::uint8_t speed_lpf{};
  /// Low-pass filter of an RC signal. Range: 1 to 255.
  std::uint8_t rc_lpf{};
  /// Acceleration limit in all modes. Range: 1 to 65535 deg/s^2. Since firmware 2.70b1.
  LongAngularAcceleration acc_limit{};
  /// Time in which the acceleration rises to its limit. Range: 40 to 5100 ms. Since firmware
  /// 2.70b8.
  JerkTime jerk_slope{};
  /// Reserved; kept as it is.
  Bytes<1> reserved{};

  bool operator==(const ControlConfigAxis&) const = default;
  using FixedMembers = Members<&ControlConfigAxis::angle_lpf, &ControlConfigAxis::speed_lpf,
      &ControlConfigAxis::rc_lpf, &ControlConfigAxis::acc_limit, &ControlConfigAxis::jerk_slope,
      &ControlConfigAxis::reserved>;
};

/// State of each axis.
struct AxisState {
  /// Measured angle; wraps after two full turns. Unit: deg.
  Angle14 imu_angle{};
  /// Target angle, set by RC or by control commands. Unit: deg.
  Angle14 rc_target_angle{};
  /// Target speed; 0 once the target is reached. Unit: deg/s.
  ControlSpeed rc_speed{};

  bool operator==(const AxisState&) const = default;
  using FixedMembers = Members<&AxisState::imu_angle, &AxisState::rc_target_angle,
      &AxisState::rc_speed>;
};

/// State of each axis.
struct AxisStateExt {
  /// Measured angle; wraps after two full turns. Unit: deg.
  Angle14 imu_angle{};
  /// Target angle. Unit: deg.
  Angle14 rc_target_angle{};
  /// Angle of the joint, from an encoder or the second IMU; 0 in the normal position, accumulated
  /// over full turns. Unit: deg.
  LongAngle14 stator_rotor_angle{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  bool operator==(const AxisStateExt&) const = default;
  using FixedMembers = Members<&AxisStateExt::imu_angle, &AxisStateExt::rc_target_angle,
      &AxisStateExt::stator_rotor_angle, &AxisStateExt::reserved>;
};

/// Move the camera, with one mode for all axes. Overrides RC until a command with MODE_NO_CONTROL
/// and zeros. Send at most 50 per second. A board keeps the last speed when the link is lost;
/// CMD_CONTROL_CONFIG can set a timeout, and turn confirmations off. The command sets a target or a
/// speed, never a step, so it may be repeated; the last one counts.
///
/// CMD_CONTROL (67), to the board, simple form; 13 bytes. Effect: moves. Source: Outgoing commands
/// L694-L715; Variables L1147-L1152.
struct Control {
  static constexpr CommandToBoard command = CommandToBoard::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 13;
  static constexpr std::size_t max_size = 13;
  static constexpr Availability since{};
  using Response = void;

  /// Mode of all three axes.
  ControlMode control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// Returns the physical value of speed of an element in deg/s; CONTROL_FLAG_HIGH_RES_SPEED
  /// selects its unit on the wire.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode, 0x80);
  }
  /// Sets speed of an element and the flag that selects its unit. Returns false and changes nothing
  /// if another element has a value in the other unit.
  [[nodiscard]] constexpr bool set_speed(std::size_t index, ControlSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, false);
  }
  [[nodiscard]] constexpr bool set_speed(std::size_t index, FineSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, true);
  }
  /// As above, in the usual unit.
  template <std::int64_t numerator, std::int64_t denominator>
  [[nodiscard]] constexpr bool set_speed(
      std::size_t index, Physical<ControlSpeed::unit_type, numerator, denominator> value) noexcept {
    return set_speed(index, ControlSpeed(value));
  }

  bool operator==(const Control&) const = default;
  using FixedMembers = Members<&Control::control_mode, &Control::axes>;
};

/// Move the camera, with a mode for each axis. Overrides RC until a command with MODE_NO_CONTROL
/// and zeros. Send at most 50 per second. A board keeps the last speed when the link is lost;
/// CMD_CONTROL_CONFIG can set a timeout, and turn confirmations off. The command sets a target or a
/// speed, never a step, so it may be repeated; the last one counts.
///
/// CMD_CONTROL (67), to the board, extended form; 15 bytes. Effect: moves. Since firmware 2.55b5.
/// Source: Outgoing commands L694-L715; Variables L1147-L1152.
struct ControlExt {
  static constexpr CommandToBoard command = CommandToBoard::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{.firmware = 2555};
  using Response = void;

  /// Mode of each axis.
  Axes<ControlMode> control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// Returns the physical value of speed of an element in deg/s; CONTROL_FLAG_HIGH_RES_SPEED
  /// selects its unit on the wire.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode[index], 0x80);
  }
  /// Sets speed of an element and the flag that selects its unit.
  constexpr void set_speed(std::size_t index, ControlSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, false);
  }
  constexpr void set_speed(std::size_t index, FineSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, true);
  }
  /// As above, in the usual unit.
  template <std::int64_t numerator, std::int64_t denominator>
  constexpr void set_speed(
      std::size_t index, Physical<ControlSpeed::unit_type, numerator, denominator> value) noexcept {
    set_speed(index, ControlSpeed(value));
  }

  bool operator==(const ControlExt&) const = default;
  using FixedMembers = Members<&ControlExt::control_mode, &ControlExt::axes>;
};

/// Move the camera, with the data that each axis needs. Like CMD_CONTROL, but an axis without data
/// keeps its state, and speeds and angles may have 32 bits.
///
/// CMD_CONTROL_EXT (121), to the board; 2 to 32 bytes. Effect: moves. Since firmware 2.68. Source:
/// Later firmware.
struct ControlExtCommand {
  static constexpr CommandToBoard command = CommandToBoard::control_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 32;
  static constexpr Availability since{.firmware = 2680};
  using Response = void;

  /// Which of the following fields are present.
  ControlExtFields data_set{};
  /// Motion of each axis.
  Axes<ControlExtAxis> axes{};

  bool operator==(const ControlExtCommand&) const = default;
  using FixedMembers = Members<&ControlExtCommand::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when((self.data_set.has(ControlExtField::roll_speed) ||
        self.data_set.has(ControlExtField::roll_angle)), self.axes.roll.mode, "axes.roll.mode");
    cursor.when((self.data_set.has(ControlExtField::roll_speed) ||
        self.data_set.has(ControlExtField::roll_angle)), self.axes.roll.flags, "axes.roll.flags");
    cursor.when(self.data_set.has(ControlExtField::roll_speed) &&
        !self.data_set.has(ControlExtField::roll_speed_32bit), self.axes.roll.speed,
        "axes.roll.speed");
    cursor.when(self.data_set.has(ControlExtField::roll_speed) &&
        self.data_set.has(ControlExtField::roll_speed_32bit), self.axes.roll.speed_32,
        "axes.roll.speed_32");
    cursor.when(self.data_set.has(ControlExtField::roll_angle) &&
        !self.data_set.has(ControlExtField::roll_angle_32bit), self.axes.roll.angle,
        "axes.roll.angle");
    cursor.when(self.data_set.has(ControlExtField::roll_angle) &&
        self.data_set.has(ControlExtField::roll_angle_32bit), self.axes.roll.angle_32,
        "axes.roll.angle_32");
    cursor.when((self.data_set.has(ControlExtField::pitch_speed) ||
        self.data_set.has(ControlExtField::pitch_angle)), self.axes.pitch.mode, "axes.pitch.mode");
    cursor.when((self.data_set.has(ControlExtField::pitch_speed) ||
        self.data_set.has(ControlExtField::pitch_angle)), self.axes.pitch.flags,
        "axes.pitch.flags");
    cursor.when(self.data_set.has(ControlExtField::pitch_speed) &&
        !self.data_set.has(ControlExtField::pitch_speed_32bit), self.axes.pitch.speed,
        "axes.pitch.speed");
    cursor.when(self.data_set.has(ControlExtField::pitch_speed) &&
        self.data_set.has(ControlExtField::pitch_speed_32bit), self.axes.pitch.speed_32,
        "axes.pitch.speed_32");
    cursor.when(self.data_set.has(ControlExtField::pitch_angle) &&
        !self.data_set.has(ControlExtField::pitch_angle_32bit), self.axes.pitch.angle,
        "axes.pitch.angle");
    cursor.when(self.data_set.has(ControlExtField::pitch_angle) &&
        self.data_set.has(ControlExtField::pitch_angle_32bit), self.axes.pitch.angle_32,
        "axes.pitch.angle_32");
    cursor.when((self.data_set.has(ControlExtField::yaw_speed) ||
        self.data_set.has(ControlExtField::yaw_angle)), self.axes.yaw.mode, "axes.yaw.mode");
    cursor.when((self.data_set.has(ControlExtField::yaw_speed) ||
        self.data_set.has(ControlExtField::yaw_angle)), self.axes.yaw.flags, "axes.yaw.flags");
    cursor.when(self.data_set.has(ControlExtField::yaw_speed) &&
        !self.data_set.has(ControlExtField::yaw_speed_32bit), self.axes.yaw.speed,
        "axes.yaw.speed");
    cursor.when(self.data_set.has(ControlExtField::yaw_speed) &&
        self.data_set.has(ControlExtField::yaw_speed_32bit), self.axes.yaw.speed_32,
        "axes.yaw.speed_32");
    cursor.when(self.data_set.has(ControlExtField::yaw_angle) &&
        !self.data_set.has(ControlExtField::yaw_angle_32bit), self.axes.yaw.angle,
        "axes.yaw.angle");
    cursor.when(self.data_set.has(ControlExtField::yaw_angle) &&
        self.data_set.has(ControlExtField::yaw_angle_32bit), self.axes.yaw.angle_32,
        "axes.yaw.angle_32");
  }
};

/// Configure serial control until the next start. A control command counts only if no other port
/// has a higher priority. All ports start with priority 0.
///
/// CMD_CONTROL_CONFIG (90), to the board; 41 bytes. Effect: sets, moves. Since firmware 2.61.
/// Source: Later firmware.
struct ControlConfig {
  static constexpr CommandToBoard command = CommandToBoard::control_config;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 41;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{.firmware = 2610};
  using Response = void;

  /// For timeout_ms: no timeout.
  static constexpr std::uint16_t no_timeout{0};
  /// For ch_priority and this_ch_priority: the priority does not change.
  static constexpr std::uint8_t keep_priority{0};

  /// Time without a control command after which serial control ends and RC takes over, which is not
  /// a stop. Unit: ms.
  Milliseconds timeout_ms{};
  /// Priority of UART1, RC_SERIAL, UART2 and USB_VCP or UART3. Range: 1 to 255.
  std::array<std::uint8_t, 4> ch_priority{};
  /// Priority of this port. Range: 1 to 255.
  std::uint8_t this_ch_priority{};
  /// Options of each axis.
  Axes<ControlConfigAxis> axes{};
  /// Expo rate of RC signals. Range: 0 to 100.
  std::uint8_t rc_expo_rate{};
  /// Options.
  ControlConfigFlags flags{};
  /// Order of the Euler angles. Since firmware 2.72.
  EulerOrderChoice euler_order{};
  /// Reserved; kept as it is.
  Bytes<9> reserved{};

  bool operator==(const ControlConfig&) const = default;
  using FixedMembers = Members<&ControlConfig::timeout_ms, &ControlConfig::ch_priority,
      &ControlConfig::this_ch_priority, &ControlConfig::axes, &ControlConfig::rc_expo_rate,
      &ControlConfig::flags, &ControlConfig::euler_order, &ControlConfig::reserved>;
};

/// End control with quaternions. Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and
/// Z of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, disabled form; 2 bytes. Effect: moves. Since firmware
/// 2.73. Source: Later firmware.
struct ControlQuatDisabled {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::disabled;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// Always DISABLED. Always 0.
  ControlQuatMode mode{};
  /// Options.
  ControlQuatFlags flags{};

  bool operator==(const ControlQuatDisabled&) const = default;
  using FixedMembers = Members<&ControlQuatDisabled::mode, &ControlQuatDisabled::flags>;
};

/// Turn the camera at a speed. Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z
/// of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, speed form; 14 bytes. Effect: moves. Since firmware 2.73.
/// Source: Later firmware.
struct ControlQuatSpeed {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::speed;
  static constexpr std::size_t min_size = 14;
  static constexpr std::size_t max_size = 14;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// SPEED or SPEED_LIMITED.
  ControlQuatMode mode{static_cast<ControlQuatMode>(1)};
  /// Options.
  ControlQuatFlags flags{};
  /// Rotation vector of the motion. Unit: rad/s.
  Xyz<RadianRate> target_speed{};

  bool operator==(const ControlQuatSpeed&) const = default;
  using FixedMembers = Members<&ControlQuatSpeed::mode, &ControlQuatSpeed::flags,
      &ControlQuatSpeed::target_speed>;
};

/// Turn the camera to an attitude. Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll
/// and Z of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, attitude form; 18 bytes. Effect: moves. Since firmware
/// 2.73. Source: Later firmware.
struct ControlQuatAttitude {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::attitude;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// Always ATTITUDE. Always 2.
  ControlQuatMode mode{static_cast<ControlQuatMode>(2)};
  /// Options.
  ControlQuatFlags flags{};
  /// Quaternion of length 1: W, X, Y, Z. Range: -1 to 1.
  std::array<float, 4> target_attitude{};

  bool operator==(const ControlQuatAttitude&) const = default;
  using FixedMembers = Members<&ControlQuatAttitude::mode, &ControlQuatAttitude::flags,
      &ControlQuatAttitude::target_attitude>;
};

/// Turn the camera to an attitude, packed. Quaternions are W, X, Y, Z; X is the axis of pitch, Y of
/// roll and Z of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, attitude_packed form; 10 bytes. Effect: moves. Since
/// firmware 2.73. Source: Later firmware.
struct ControlQuatAttitudePacked {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::attitude_packed;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// Always ATTITUDE. Always 2.
  ControlQuatMode mode{static_cast<ControlQuatMode>(2)};
  /// Options, with ATTITUDE_PACKED.
  ControlQuatFlags flags{ControlQuatFlags(2)};
  /// The attitude.
  PackedQuaternion target_attitude{};

  bool operator==(const ControlQuatAttitudePacked&) const = default;
  using FixedMembers = Members<&ControlQuatAttitudePacked::mode, &ControlQuatAttitudePacked::flags,
      &ControlQuatAttitudePacked::target_attitude>;
};

/// Turn the camera at a speed and hold it to an attitude. Quaternions are W, X, Y, Z; X is the axis
/// of pitch, Y of roll and Z of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, speed_attitude form; 30 bytes. Effect: moves. Since
/// firmware 2.73. Source: Later firmware.
struct ControlQuatSpeedAttitude {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::speed_attitude;
  static constexpr std::size_t min_size = 30;
  static constexpr std::size_t max_size = 30;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// Always SPEED_ATTITUDE. Always 5.
  ControlQuatMode mode{static_cast<ControlQuatMode>(5)};
  /// Options.
  ControlQuatFlags flags{};
  /// Quaternion of length 1: W, X, Y, Z. Range: -1 to 1.
  std::array<float, 4> target_attitude{};
  /// Rotation vector of the motion. Unit: rad/s.
  Xyz<RadianRate> target_speed{};

  bool operator==(const ControlQuatSpeedAttitude&) const = default;
  using FixedMembers = Members<&ControlQuatSpeedAttitude::mode, &ControlQuatSpeedAttitude::flags,
      &ControlQuatSpeedAttitude::target_attitude, &ControlQuatSpeedAttitude::target_speed>;
};

/// Turn the camera at a speed and hold it to an attitude, packed. Quaternions are W, X, Y, Z; X is
/// the axis of pitch, Y of roll and Z of yaw.
///
/// CMD_CONTROL_QUAT (140), to the board, speed_attitude_packed form; 22 bytes. Effect: moves. Since
/// firmware 2.73. Source: Later firmware.
struct ControlQuatSpeedAttitudePacked {
  static constexpr CommandToBoard command = CommandToBoard::control_quat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::speed_attitude_packed;
  static constexpr std::size_t min_size = 22;
  static constexpr std::size_t max_size = 22;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// Always SPEED_ATTITUDE. Always 5.
  ControlQuatMode mode{static_cast<ControlQuatMode>(5)};
  /// Options, with ATTITUDE_PACKED.
  ControlQuatFlags flags{ControlQuatFlags(2)};
  /// The attitude.
  PackedQuaternion target_attitude{};
  /// Rotation vector of the motion. Unit: rad/s.
  Xyz<RadianRate> target_speed{};

  bool operator==(const ControlQuatSpeedAttitudePacked&) const = default;
  using FixedMembers = Members<&ControlQuatSpeedAttitudePacked::mode,
      &ControlQuatSpeedAttitudePacked::flags, &ControlQuatSpeedAttitudePacked::target_attitude,
      &ControlQuatSpeedAttitudePacked::target_speed>;
};

/// State of the control with quaternions.
///
/// CMD_CONTROL_QUAT_STATUS (141), from the board; 2 to 97 bytes, and later firmware may append
/// more. Since firmware 2.73. Source: Later firmware.
struct ControlQuatStatus {
  static constexpr CommandFromBoard command = CommandFromBoard::control_quat_status;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 97;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};

  /// Which of the following fields are present.
  ControlQuatStatusFields data_set{};
  /// The upper half of DATA_SET, if that has 32 bits. Present if only then the body ends with its
  /// last member. Unconfirmed.
  Optional<std::uint16_t> data_set_high{};
  /// Mode of the last command. Present if data_set has MODE.
  Optional<ControlQuatMode> mode{};
  /// Options of the last command. Present if data_set has MODE.
  Optional<ControlQuatStatusFlags> flags{};
  /// Attitude of the last command: W, X, Y, Z. Range: -1 to 1. Present if data_set has
  /// TARGET_ATTITUDE.
  Optional<std::array<float, 4>> target_attitude{};
  /// Attitude that the board stabilizes: W, X, Y, Z. Range: -1 to 1. Present if data_set has
  /// SETPOINT_ATTITUDE.
  Optional<std::array<float, 4>> setpoint_attitude{};
  /// Measured attitude: W, X, Y, Z. Range: -1 to 1. Present if data_set has ACTUAL_ATTITUDE.
  Optional<std::array<float, 4>> actual_attitude{};
  /// Speed of the last command. Unit: deg/s. Present if data_set has TARGET_SPEED.
  Optional<Xyz<GyroRate>> target_speed{};
  /// Speed that the board stabilizes. Unit: deg/s. Present if data_set has SETPOINT_SPEED.
  Optional<Xyz<GyroRate>> setpoint_speed{};
  /// Measured speed. Unit: deg/s. Present if data_set has ACTUAL_SPEED.
  Optional<Xyz<GyroRate>> actual_speed{};
  /// Attitude of the last command. Present if data_set has TARGET_ATTITUDE_PACKED.
  Optional<PackedQuaternion> target_attitude_packed{};
  /// Attitude that the board stabilizes. Present if data_set has SETPOINT_ATTITUDE_PACKED.
  Optional<PackedQuaternion> setpoint_attitude_packed{};
  /// Measured attitude. Present if data_set has ACTUAL_ATTITUDE_PACKED.
  Optional<PackedQuaternion> actual_attitude_packed{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<253> tail{};

  bool operator==(const ControlQuatStatus&) const = default;
  using FixedMembers = Members<&ControlQuatStatus::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.if_fits(self.data_set_high, "data_set_high");
    cursor.when(self.data_set.has(ControlQuatStatusField::mode), self.mode, "mode");
    cursor.when(self.data_set.has(ControlQuatStatusField::mode), self.flags, "flags");
    cursor.when(self.data_set.has(ControlQuatStatusField::target_attitude), self.target_attitude,
        "target_attitude");
    cursor.when(self.data_set.has(ControlQuatStatusField::setpoint_attitude),
        self.setpoint_attitude, "setpoint_attitude");
    cursor.when(self.data_set.has(ControlQuatStatusField::actual_attitude), self.actual_attitude,
        "actual_attitude");
    cursor.when(self.data_set.has(ControlQuatStatusField::target_speed), self.target_speed,
        "target_speed");
    cursor.when(self.data_set.has(ControlQuatStatusField::setpoint_speed), self.setpoint_speed,
        "setpoint_speed");
    cursor.when(self.data_set.has(ControlQuatStatusField::actual_speed), self.actual_speed,
        "actual_speed");
    cursor.when(self.data_set.has(ControlQuatStatusField::target_attitude_packed),
        self.target_attitude_packed, "target_attitude_packed");
    cursor.when(self.data_set.has(ControlQuatStatusField::setpoint_attitude_packed),
        self.setpoint_attitude_packed, "setpoint_attitude_packed");
    cursor.when(self.data_set.has(ControlQuatStatusField::actual_attitude_packed),
        self.actual_attitude_packed, "actual_attitude_packed");
  }
  static constexpr bool has_fitting_member = true;
};

/// Request the state of the control with quaternions.
///
/// CMD_CONTROL_QUAT_STATUS (141), to the board; 4 bytes. Effect: reads. Since firmware 2.73.
/// Source: Later firmware.
struct ControlQuatStatusRequest {
  static constexpr CommandToBoard command = CommandToBoard::control_quat_status;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 4;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = ControlQuatStatus;

  /// Data to send, in 32 bits with the reserved bytes.
  ControlQuatStatusFields data_set{};
  /// Reserved; kept as it is.
  Bytes<2> reserved{};

  bool operator==(const ControlQuatStatusRequest&) const = default;
  using FixedMembers = Members<&ControlQuatStatusRequest::data_set,
      &ControlQuatStatusRequest::reserved>;
};

/// Configure the control with quaternions.
///
/// CMD_CONTROL_QUAT_CONFIG (142), to the board; 2 to 24 bytes. Effect: sets. Since firmware 2.73.
/// Source: Later firmware.
struct ControlQuatConfig {
  static constexpr CommandToBoard command = CommandToBoard::control_quat_config;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 24;
  static constexpr Availability since{.firmware = 2730, .features = 0x800000000};
  using Response = void;

  /// For acc_limit: no limit.
  static constexpr std::uint16_t acc_unlimited{0};
  /// For jerk_slope: the acceleration changes at once.
  static constexpr std::uint16_t jerk_unlimited{0};
  /// For attitude_lpf_freq and speed_lpf_freq: no filter.
  static constexpr std::uint8_t no_filter{0};

  /// Which of the following fields are present.
  ControlQuatConfigFields data_set{};
  /// Speed limit of each axis. Unit: deg/s. Present if data_set has MAX_SPEED.
  Optional<Xyz<ControlSpeedLimit>> max_speed{};
  /// Acceleration limit of each axis. Range: 1 to 65535 deg/s^2. Present if data_set has ACC_LIMIT.
  Optional<Xyz<LongAngularAcceleration>> acc_limit{};
  /// Time in which the acceleration of each axis rises to its limit. Range: 1 to 65535 ms. Present
  /// if data_set has JERK_SLOPE.
  Optional<Xyz<Milliseconds>> jerk_slope{};
  /// Options. Present if data_set has FLAGS.
  Optional<ControlQuatConfigFlags> flags{};
  /// Low-pass filter of the attitude. Range: 1 to 255 Hz. Present if data_set has
  /// ATTITUDE_LPF_FREQ.
  Optional<SmallFrequency> attitude_lpf_freq{};
  /// Low-pass filter of the speed. Range: 1 to 255 Hz. Present if data_set has SPEED_LPF_FREQ.
  Optional<SmallFrequency> speed_lpf_freq{};

  bool operator==(const ControlQuatConfig&) const = default;
  using FixedMembers = Members<&ControlQuatConfig::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when(self.data_set.has(ControlQuatConfigField::max_speed), self.max_speed, "max_speed");
    cursor.when(self.data_set.has(ControlQuatConfigField::acc_limit), self.acc_limit, "acc_limit");
    cursor.when(self.data_set.has(ControlQuatConfigField::jerk_slope), self.jerk_slope,
        "jerk_slope");
    cursor.when(self.data_set.has(ControlQuatConfigField::flags), self.flags, "flags");
    cursor.when(self.data_set.has(ControlQuatConfigField::attitude_lpf_freq),
        self.attitude_lpf_freq, "attitude_lpf_freq");
    cursor.when(self.data_set.has(ControlQuatConfigField::speed_lpf_freq), self.speed_lpf_freq,
        "speed_lpf_freq");
  }
};

/// Camera angles and targets.
///
/// CMD_GET_ANGLES (73), from the board; 18 bytes, and later firmware may append more. Source:
/// Incoming commands L428-L434; Variables L1156-L1161.
struct GetAngles {
  static constexpr CommandFromBoard command = CommandFromBoard::get_angles;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{};

  /// State of each axis.
  Axes<AxisState> axes{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<237> tail{};

  bool operator==(const GetAngles&) const = default;
  using FixedMembers = Members<&GetAngles::axes>;
};

/// Request camera angles and targets.
///
/// CMD_GET_ANGLES (73), to the board; 0 bytes. Effect: reads. Source: Outgoing commands L753-L755.
struct GetAnglesRequest {
  static constexpr CommandToBoard command = CommandToBoard::get_angles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = GetAngles;

  bool operator==(const GetAnglesRequest&) const = default;
};

/// Camera angles, targets and joint angles.
///
/// CMD_GET_ANGLES_EXT (61), from the board; 54 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L436-L443; Variables L1162-L1165.
struct GetAnglesExt {
  static constexpr CommandFromBoard command = CommandFromBoard::get_angles_ext;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 54;
  static constexpr std::size_t max_size = 54;
  static constexpr Availability since{.board = 30};

  /// State of each axis.
  Axes<AxisStateExt> axes{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<201> tail{};

  bool operator==(const GetAnglesExt&) const = default;
  using FixedMembers = Members<&GetAnglesExt::axes>;
};

/// Request angles, targets and joint angles.
///
/// CMD_GET_ANGLES_EXT (61), to the board; 0 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L753-L755.
struct GetAnglesExtRequest {
  static constexpr CommandToBoard command = CommandToBoard::get_angles_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = GetAnglesExt;

  bool operator==(const GetAnglesExtRequest&) const = default;
};

/// Turn the motors on.
///
/// CMD_MOTORS_ON (77), to the board; 0 bytes. Effect: moves. Source: Outgoing commands L724-L726.
struct MotorsOn {
  static constexpr CommandToBoard command = CommandToBoard::motors_on;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const MotorsOn&) const = default;
};

/// Turn the motors off.
///
/// CMD_MOTORS_OFF (109), to the board, simple form; 0 bytes. Effect: moves. Source: Outgoing
/// commands L728-L730.
struct MotorsOff {
  static constexpr CommandToBoard command = CommandToBoard::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const MotorsOff&) const = default;
};

/// Turn the motors off, in one of several ways.
///
/// CMD_MOTORS_OFF (109), to the board, extended form; 1 byte. Effect: moves. Since firmware 2.68b7.
/// Source: Outgoing commands L728-L730.
struct MotorsOffExt {
  static constexpr CommandToBoard command = CommandToBoard::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.firmware = 2687};
  using Response = void;

  /// How to turn them off.
  MotorsOffMode mode{};

  bool operator==(const MotorsOffExt&) const = default;
  using FixedMembers = Members<&MotorsOffExt::mode>;
};

/// Power one motor as a synchronous motor for some time, then turn the motors off.
///
/// CMD_SYNC_MOTORS (123), to the board; 6 bytes. Effect: moves. Since firmware 2.70b9. Source:
/// Later firmware.
struct SyncMotors {
  static constexpr CommandToBoard command = CommandToBoard::sync_motors;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{.firmware = 2709};
  using Response = void;

  /// For angle: the motor holds its position.
  static constexpr std::uint16_t hold{0};

  /// The motor.
  SyncMotorAxis axis{};
  /// Power of the windings.
  std::uint8_t power{};
  /// How long the windings have power. Unit: ms.
  Milliseconds time_ms{};
  /// Angle to turn.
  std::uint16_t angle{};

  bool operator==(const SyncMotors&) const = default;
  using FixedMembers = Members<&SyncMotors::axis, &SyncMotors::power, &SyncMotors::time_ms,
      &SyncMotors::angle>;
};

/// An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL.
///
/// CMD_EVENT (102), from the board; 4 bytes, and later firmware may append more. Since firmware
/// 2.65b7. Source: Later firmware.
struct Event {
  static constexpr CommandFromBoard command = CommandFromBoard::event;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 4;
  static constexpr Availability since{.firmware = 2657};

  /// What has happened.
  EventId event_id{};
  /// Kind of the event.
  EventTypes event_type{};
  /// Data that depend on the event.
  Bytes<2> param{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<251> tail{};

  bool operator==(const Event&) const = default;
  using FixedMembers = Members<&Event::event_id, &Event::event_type, &Event::param>;
};

/// Execute a menu action.
///
/// CMD_EXECUTE_MENU (69), to the board, simple form; 1 byte. Effect: sets, stores, moves, restarts.
/// Source: Outgoing commands L732-L734; Variables L1166-L1167.
struct ExecuteMenu {
  static constexpr CommandToBoard command = CommandToBoard::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = void;

  /// Which action.
  MenuCommand cmd_id{};

  bool operator==(const ExecuteMenu&) const = default;
  using FixedMembers = Members<&ExecuteMenu::cmd_id>;
};

/// Execute a menu action and say when to confirm it.
///
/// CMD_EXECUTE_MENU (69), to the board, extended form; 2 bytes. Effect: sets, stores, moves,
/// restarts. Since firmware 2.73.8. Source: Outgoing commands L732-L734; Variables L1166-L1167.
struct ExecuteMenuExt {
  static constexpr CommandToBoard command = CommandToBoard::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.firmware = 2738};
  using Response = void;

  /// Which action.
  MenuCommand cmd_id{};
  /// When the board confirms the action.
  ExecuteMenuFlags param{};

  bool operator==(const ExecuteMenuExt&) const = default;
  using FixedMembers = Members<&ExecuteMenuExt::cmd_id, &ExecuteMenuExt::param>;
};

/// Report acceleration and tilt of the frame to the board.
///
/// CMD_HELPER_DATA (72), to the board, simple form; 10 bytes. Effect: moves. Source: Outgoing
/// commands L736-L751; Variables L1247-L1251.
struct HelperData {
  static constexpr CommandToBoard command = CommandToBoard::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{};
  using Response = void;

  /// Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
  Xyz<Acceleration> frame_acc{};
  /// Sideways tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Forward tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};

  bool operator==(const HelperData&) const = default;
  using FixedMembers = Members<&HelperData::frame_acc, &HelperData::frame_angle_roll,
      &HelperData::frame_angle_pitch>;
};

/// Report acceleration, tilt and rotation of the frame to the board.
///
/// CMD_HELPER_DATA (72), to the board, extended form; 20 bytes. Effect: moves. Since firmware 2.59.
/// Source: Outgoing commands L736-L751; Variables L1247-L1251.
struct HelperDataExt {
  static constexpr CommandToBoard command = CommandToBoard::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{.firmware = 2590};
  using Response = void;

  /// For frame_heading: stops the correction of the heading.
  static constexpr std::int16_t stop_heading_correction{32767};

  /// Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
  Xyz<Acceleration> frame_acc{};
  /// Sideways tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Forward tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};
  /// Coordinate system of all the vectors, and options.
  HelperCoordinates coord_sys{};
  /// Angular speed of the frame; useful without encoders and a second IMU. Unit: deg/s. 0: with all
  /// three 0, not used.
  Xyz<GyroRate> frame_speed{};
  /// Heading of the frame; used with USE_FRAME_HEADING. Range: -360 to 360 deg. Since firmware
  /// 2.62b7.
  Angle14 frame_heading{};
  /// Reserved; kept as it is.
  Bytes<1> reserved{};

  bool operator==(const HelperDataExt&) const = default;
  using FixedMembers = Members<&HelperDataExt::frame_acc, &HelperDataExt::frame_angle_roll,
      &HelperDataExt::frame_angle_pitch, &HelperDataExt::coord_sys, &HelperDataExt::frame_speed,
      &HelperDataExt::frame_heading, &HelperDataExt::reserved>;
};

}  // namespace sbgc::msg
