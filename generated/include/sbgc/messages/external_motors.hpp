// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Additional motors, up to seven, on drivers of their own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct ExtMotorsState;

/// Targets of 16 bits, parameters of 16 bits.
struct ExtMotorTarget16 {
  /// Target.
  std::int16_t setpoint{};
  /// Angle or speed limit.
  std::int16_t param1{};

  bool operator==(const ExtMotorTarget16&) const = default;
  using FixedMembers = Members<&ExtMotorTarget16::setpoint, &ExtMotorTarget16::param1>;
};

/// Targets of 16 bits, parameters of 32 bits.
struct ExtMotorTarget16Param32 {
  /// Target.
  std::int16_t setpoint{};
  /// Angle or speed limit.
  std::int32_t param1{};

  bool operator==(const ExtMotorTarget16Param32&) const = default;
  using FixedMembers = Members<&ExtMotorTarget16Param32::setpoint,
      &ExtMotorTarget16Param32::param1>;
};

/// Targets of 32 bits, parameters of 16 bits.
struct ExtMotorTarget32Param16 {
  /// Target.
  std::int32_t setpoint{};
  /// Angle or speed limit.
  std::int16_t param1{};

  bool operator==(const ExtMotorTarget32Param16&) const = default;
  using FixedMembers = Members<&ExtMotorTarget32Param16::setpoint,
      &ExtMotorTarget32Param16::param1>;
};

/// Targets of 32 bits, parameters of 32 bits.
struct ExtMotorTarget32 {
  /// Target.
  std::int32_t setpoint{};
  /// Angle or speed limit.
  std::int32_t param1{};

  bool operator==(const ExtMotorTarget32&) const = default;
  using FixedMembers = Members<&ExtMotorTarget32::setpoint, &ExtMotorTarget32::param1>;
};

/// Turn external motors on or off, or move them to their home position.
///
/// CMD_EXT_MOTORS_ACTION (128), to the board; 2 to 255 bytes. Effect: moves. Since firmware 2.73.
/// Source: Later firmware.
struct ExtMotorsAction {
  static constexpr CommandToBoard command = CommandToBoard::ext_motors_action;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2730, .features = 0x400000000};
  using Response = void;

  /// The motors, and whether to confirm.
  ExtMotorTargets for_motors{};
  /// What they do.
  ExtMotorActionKind action{};
  /// Arguments of later actions; send it empty.
  BoundedBytes<253> args{};

  bool operator==(const ExtMotorsAction&) const = default;
  using FixedMembers = Members<&ExtMotorsAction::for_motors, &ExtMotorsAction::action>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.args, "args");
  }
};

/// Set targets of external motors. One of the lists is present, with one element for each motor in
/// FOR_MOTORS. The mode of a motor determines the meaning of its setpoint. Torque: 32767 is all
/// that the driver can provide; 16 bits only. Speed: 4000/32767 deg/s, with an optional angle as
/// PARAM1. Position: 16384 counts per turn, with an optional speed limit as PARAM1; 16 bits may
/// wrap.
///
/// CMD_EXT_MOTORS_CONTROL (129), to the board; 2 to 58 bytes. Effect: moves. Since firmware 2.73.
/// Source: Later firmware.
struct ExtMotorsControl {
  static constexpr CommandToBoard command = CommandToBoard::ext_motors_control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 58;
  static constexpr Availability since{.firmware = 2730, .features = 0x400000000};
  using Response = void;

  /// The motors.
  ExtMotors for_motors{};
  /// Format of the targets.
  ExtMotorsControlFields data_set{};
  /// Targets, 16 bits. Present if data_set lacks SETPOINT_32BIT and PARAM1_16BIT and PARAM1_32BIT.
  Optional<BoundedArray<std::int16_t, 8>> setpoint16{};
  /// Targets, 32 bits. Present if data_set has SETPOINT_32BIT, and lacks PARAM1_16BIT and
  /// PARAM1_32BIT.
  Optional<BoundedArray<std::int32_t, 8>> setpoint32{};
  /// Targets of 16 bits, parameters of 16 bits. Present if data_set has PARAM1_16BIT, and lacks
  /// SETPOINT_32BIT.
  Optional<BoundedArray<ExtMotorTarget16, 8>> setpoint16_param16{};
  /// Targets of 16 bits, parameters of 32 bits. Present if data_set has PARAM1_32BIT, and lacks
  /// SETPOINT_32BIT and PARAM1_16BIT.
  Optional<BoundedArray<ExtMotorTarget16Param32, 8>> setpoint16_param32{};
  /// Targets of 32 bits, parameters of 16 bits. Present if data_set has SETPOINT_32BIT and
  /// PARAM1_16BIT.
  Optional<BoundedArray<ExtMotorTarget32Param16, 8>> setpoint32_param16{};
  /// Targets of 32 bits, parameters of 32 bits. Present if data_set has SETPOINT_32BIT and
  /// PARAM1_32BIT, and lacks PARAM1_16BIT.
  Optional<BoundedArray<ExtMotorTarget32, 8>> setpoint32_param32{};

  bool operator==(const ExtMotorsControl&) const = default;
  using FixedMembers = Members<&ExtMotorsControl::for_motors, &ExtMotorsControl::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    if (cursor.present(!self.data_set.has(ExtMotorsControlField::setpoint_32bit) && !self.data_set.has(ExtMotorsControlField::param1_16bit) && !self.data_set.has(ExtMotorsControlField::param1_32bit), self.setpoint16, "setpoint16")) {
      cursor.counted_by(*self.setpoint16, detail::count_bits(self.for_motors.raw()), "setpoint16");
    }
    if (cursor.present(self.data_set.has(ExtMotorsControlField::setpoint_32bit) && !self.data_set.has(ExtMotorsControlField::param1_16bit) && !self.data_set.has(ExtMotorsControlField::param1_32bit), self.setpoint32, "setpoint32")) {
      cursor.counted_by(*self.setpoint32, detail::count_bits(self.for_motors.raw()), "setpoint32");
    }
    if (cursor.present(self.data_set.has(ExtMotorsControlField::param1_16bit) && !self.data_set.has(ExtMotorsControlField::setpoint_32bit), self.setpoint16_param16, "setpoint16_param16")) {
      cursor.counted_by(*self.setpoint16_param16, detail::count_bits(self.for_motors.raw()), "setpoint16_param16");
    }
    if (cursor.present(self.data_set.has(ExtMotorsControlField::param1_32bit) && !self.data_set.has(ExtMotorsControlField::setpoint_32bit) && !self.data_set.has(ExtMotorsControlField::param1_16bit), self.setpoint16_param32, "setpoint16_param32")) {
      cursor.counted_by(*self.setpoint16_param32, detail::count_bits(self.for_motors.raw()), "setpoint16_param32");
    }
    if (cursor.present(self.data_set.has(ExtMotorsControlField::setpoint_32bit) && self.data_set.has(ExtMotorsControlField::param1_16bit), self.setpoint32_param16, "setpoint32_param16")) {
      cursor.counted_by(*self.setpoint32_param16, detail::count_bits(self.for_motors.raw()), "setpoint32_param16");
    }
    if (cursor.present(self.data_set.has(ExtMotorsControlField::setpoint_32bit) && self.data_set.has(ExtMotorsControlField::param1_32bit) && !self.data_set.has(ExtMotorsControlField::param1_16bit), self.setpoint32_param32, "setpoint32_param32")) {
      cursor.counted_by(*self.setpoint32_param32, detail::count_bits(self.for_motors.raw()), "setpoint32_param32");
    }
  }
};

/// Configure external motors.
///
/// CMD_EXT_MOTORS_CONTROL_CONFIG (130), to the board; 3 to 12 bytes. Effect: sets. Since firmware
/// 2.73. Source: Later firmware.
struct ExtMotorsControlConfig {
  static constexpr CommandToBoard command = CommandToBoard::ext_motors_control_config;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.firmware = 2730, .features = 0x400000000};
  using Response = void;

  /// The motors, and whether to confirm.
  ExtMotorTargets for_motors{};
  /// Which of the following fields are present.
  ExtMotorsControlConfigFields data_set{};
  /// What their setpoints control. Present if data_set has MODE.
  Optional<ExtMotorMode> mode{};
  /// Speed limit in all modes. Unit: deg/s. Present if data_set has MAX_SPEED.
  Optional<ExtMotorSpeedLimit> max_speed{};
  /// Acceleration limit in the modes SPEED and POSITION. Unit: deg/s^2. Present if data_set has
  /// MAX_ACCELERATION.
  Optional<ExtMotorAccelerationLimit> max_acceleration{};
  /// Time in which the acceleration rises to its limit in the modes SPEED and POSITION. Unit: ms.
  /// Present if data_set has JERK_SLOPE.
  Optional<Milliseconds> jerk_slope{};
  /// Torque limit in all modes; 65535 is all that the driver can provide. Present if data_set has
  /// MAX_TORQUE.
  Optional<std::uint16_t> max_torque{};

  bool operator==(const ExtMotorsControlConfig&) const = default;
  using FixedMembers = Members<&ExtMotorsControlConfig::for_motors,
      &ExtMotorsControlConfig::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when(self.data_set.has(ExtMotorsControlConfigField::mode), self.mode, "mode");
    cursor.when(self.data_set.has(ExtMotorsControlConfigField::max_speed), self.max_speed,
        "max_speed");
    cursor.when(self.data_set.has(ExtMotorsControlConfigField::max_acceleration),
        self.max_acceleration, "max_acceleration");
    cursor.when(self.data_set.has(ExtMotorsControlConfigField::jerk_slope), self.jerk_slope,
        "jerk_slope");
    cursor.when(self.data_set.has(ExtMotorsControlConfigField::max_torque), self.max_torque,
        "max_torque");
  }
};

/// State of an external motor.
///
/// CMD_EXT_MOTORS_STATE (131), from the board; 5 to 50 bytes, and later firmware may append more.
/// Since firmware 2.73. Source: Later firmware.
struct ExtMotorsState {
  static constexpr CommandFromBoard command = CommandFromBoard::ext_motors_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 50;
  static constexpr Availability since{.firmware = 2730, .features = 0x400000000};

  /// The motor, counted from 0. Range: 0 to 6.
  std::uint8_t motor_id{};
  /// Which of the following fields are present.
  ExtMotorsStateFields data_set{};
  /// What its setpoint controls. Present if data_set has CONTROL_MODE.
  Optional<ExtMotorMode> control_mode{};
  /// Torque; 32767 is all that the driver can provide. Present if data_set has TORQUE.
  Optional<std::int16_t> torque{};
  /// Target torque. Present if data_set has TORQUE_SETPOINT.
  Optional<std::int16_t> torque_setpoint{};
  /// Speed. Unit: deg/s. Present if data_set has SPEED16.
  Optional<ControlSpeed> speed16{};
  /// Target speed. Unit: deg/s. Present if data_set has SPEED16_SETPOINT.
  Optional<ControlSpeed> speed16_setpoint{};
  /// Speed. Unit: rad/s. Present if data_set has SPEED32.
  Optional<MicroradianRate> speed32{};
  /// Target speed. Unit: rad/s. Present if data_set has SPEED32_SETPOINT.
  Optional<MicroradianRate> speed32_setpoint{};
  /// Angle. Unit: deg. Present if data_set has ANGLE16.
  Optional<Angle14> angle16{};
  /// Target angle. Unit: deg. Present if data_set has ANGLE16_SETPOINT.
  Optional<Angle14> angle16_setpoint{};
  /// Angle. Unit: deg. Present if data_set has ANGLE32.
  Optional<Angle20> angle32{};
  /// Target angle. Unit: deg. Present if data_set has ANGLE32_SETPOINT.
  Optional<Angle20> angle32_setpoint{};
  /// State of the motor. Present if data_set has STATE_FLAGS.
  Optional<ExtMotorStatus> state_flags{};
  /// Speed limit. Unit: deg/s. Present if data_set has MAX_SPEED.
  Optional<ExtMotorSpeedLimit> max_speed{};
  /// Acceleration limit. Unit: deg/s^2. Present if data_set has MAX_ACCELERATION.
  Optional<ExtMotorAccelerationLimit> max_acceleration{};
  /// Time in which the acceleration rises to its limit. Unit: ms. Present if data_set has
  /// JERK_SLOPE.
  Optional<Milliseconds> jerk_slope{};
  /// Torque limit. Present if data_set has MAX_TORQUE.
  Optional<std::uint16_t> max_torque{};
  /// Current. Unit: mA. Present if data_set has CURRENT.
  Optional<Current> current{};
  /// Supply voltage. Unit: V. Present if data_set has BATTERY_VOLTAGE.
  Optional<Millivolts> battery_voltage{};
  /// Temperature of the motor. Unit: degC. Present if data_set has MOTOR_TEMPERATURE.
  Optional<Temperature> motor_temperature{};
  /// Temperature of the driver. Unit: degC. Present if data_set has DRIVER_TEMPERATURE.
  Optional<Temperature> driver_temperature{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<250> tail{};

  bool operator==(const ExtMotorsState&) const = default;
  using FixedMembers = Members<&ExtMotorsState::motor_id, &ExtMotorsState::data_set>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when(self.data_set.has(ExtMotorsStateField::control_mode), self.control_mode,
        "control_mode");
    cursor.when(self.data_set.has(ExtMotorsStateField::torque), self.torque, "torque");
    cursor.when(self.data_set.has(ExtMotorsStateField::torque_setpoint), self.torque_setpoint,
        "torque_setpoint");
    cursor.when(self.data_set.has(ExtMotorsStateField::speed16), self.speed16, "speed16");
    cursor.when(self.data_set.has(ExtMotorsStateField::speed16_setpoint), self.speed16_setpoint,
        "speed16_setpoint");
    cursor.when(self.data_set.has(ExtMotorsStateField::speed32), self.speed32, "speed32");
    cursor.when(self.data_set.has(ExtMotorsStateField::speed32_setpoint), self.speed32_setpoint,
        "speed32_setpoint");
    cursor.when(self.data_set.has(ExtMotorsStateField::angle16), self.angle16, "angle16");
    cursor.when(self.data_set.has(ExtMotorsStateField::angle16_setpoint), self.angle16_setpoint,
        "angle16_setpoint");
    cursor.when(self.data_set.has(ExtMotorsStateField::angle32), self.angle32, "angle32");
    cursor.when(self.data_set.has(ExtMotorsStateField::angle32_setpoint), self.angle32_setpoint,
        "angle32_setpoint");
    cursor.when(self.data_set.has(ExtMotorsStateField::state_flags), self.state_flags,
        "state_flags");
    cursor.when(self.data_set.has(ExtMotorsStateField::max_speed), self.max_speed, "max_speed");
    cursor.when(self.data_set.has(ExtMotorsStateField::max_acceleration), self.max_acceleration,
        "max_acceleration");
    cursor.when(self.data_set.has(ExtMotorsStateField::jerk_slope), self.jerk_slope, "jerk_slope");
    cursor.when(self.data_set.has(ExtMotorsStateField::max_torque), self.max_torque, "max_torque");
    cursor.when(self.data_set.has(ExtMotorsStateField::current), self.current, "current");
    cursor.when(self.data_set.has(ExtMotorsStateField::battery_voltage), self.battery_voltage,
        "battery_voltage");
    cursor.when(self.data_set.has(ExtMotorsStateField::motor_temperature), self.motor_temperature,
        "motor_temperature");
    cursor.when(self.data_set.has(ExtMotorsStateField::driver_temperature), self.driver_temperature,
        "driver_temperature");
  }
};

/// Request the state of external motors. The board answers once for each motor.
///
/// CMD_EXT_MOTORS_STATE (131), to the board; 5 bytes. Effect: reads. Since firmware 2.73. Source:
/// Later firmware.
struct ExtMotorsStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::ext_motors_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 5;
  static constexpr Availability since{.firmware = 2730, .features = 0x400000000};
  using Response = ExtMotorsState;

  /// The motors.
  ExtMotors for_motors{};
  /// Data to send.
  ExtMotorsStateFields data_set{};

  bool operator==(const ExtMotorsStateRequest&) const = default;
  using FixedMembers = Members<&ExtMotorsStateRequest::for_motors,
      &ExtMotorsStateRequest::data_set>;
};

}  // namespace sbgc::msg
