// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/external_motors.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/external_motors.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::ExtMotorTarget16> {
  static constexpr FieldInfo fields[] = {
      {.name = "setpoint", .spec_name = "SETPOINT", .summary = "Target."},
      {.name = "param1", .spec_name = "PARAM1", .summary = "Angle or speed limit."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, setpoint), &detail::value_type<decltype(T::setpoint)>},
      {offsetof(T, param1), &detail::value_type<decltype(T::param1)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.setpoint);
    visitor(fields[1], value.param1);
  }
};

template <>
struct Meta<msg::ExtMotorTarget16Param32> {
  static constexpr FieldInfo fields[] = {
      {.name = "setpoint", .spec_name = "SETPOINT", .summary = "Target."},
      {.name = "param1", .spec_name = "PARAM1", .summary = "Angle or speed limit."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, setpoint), &detail::value_type<decltype(T::setpoint)>},
      {offsetof(T, param1), &detail::value_type<decltype(T::param1)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.setpoint);
    visitor(fields[1], value.param1);
  }
};

template <>
struct Meta<msg::ExtMotorTarget32Param16> {
  static constexpr FieldInfo fields[] = {
      {.name = "setpoint", .spec_name = "SETPOINT", .summary = "Target."},
      {.name = "param1", .spec_name = "PARAM1", .summary = "Angle or speed limit."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, setpoint), &detail::value_type<decltype(T::setpoint)>},
      {offsetof(T, param1), &detail::value_type<decltype(T::param1)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.setpoint);
    visitor(fields[1], value.param1);
  }
};

template <>
struct Meta<msg::ExtMotorTarget32> {
  static constexpr FieldInfo fields[] = {
      {.name = "setpoint", .spec_name = "SETPOINT", .summary = "Target."},
      {.name = "param1", .spec_name = "PARAM1", .summary = "Angle or speed limit."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, setpoint), &detail::value_type<decltype(T::setpoint)>},
      {offsetof(T, param1), &detail::value_type<decltype(T::param1)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.setpoint);
    visitor(fields[1], value.param1);
  }
};

template <>
struct Meta<msg::ExtMotorsAction> {
  static constexpr MessageInfo info{
      .name = "ExtMotorsAction", .command = "CMD_EXT_MOTORS_ACTION",
      .summary = "Turn external motors on or off, or move them to their home position.", .id = 128,
      .direction = Direction::to_board, .min_size = 2, .max_size = 255,
      .since = {.firmware = 2730, .features = 0x400000000}, .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "for_motors", .spec_name = "FOR_MOTORS",
       .summary = "The motors, and whether to confirm."},
      {.name = "action", .spec_name = "ACTION", .summary = "What they do."},
      {.name = "args", .spec_name = "ARGS", .summary = "Arguments of later actions; send it empty.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, for_motors), &detail::value_type<decltype(T::for_motors)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, args), &detail::value_type<decltype(T::args)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.for_motors);
    visitor(fields[1], value.action);
    visitor(fields[2], value.args);
  }
};

template <>
struct Meta<msg::ExtMotorsControl> {
  static constexpr MessageInfo info{
      .name = "ExtMotorsControl", .command = "CMD_EXT_MOTORS_CONTROL",
      .summary = "Set targets of external motors.", .id = 129, .direction = Direction::to_board,
      .min_size = 2, .max_size = 58, .since = {.firmware = 2730, .features = 0x400000000},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "for_motors", .spec_name = "FOR_MOTORS", .summary = "The motors."},
      {.name = "data_set", .spec_name = "DATA_SET", .summary = "Format of the targets."},
      {.name = "setpoint16", .spec_name = "SETPOINT16", .summary = "Targets, 16 bits."},
      {.name = "setpoint32", .spec_name = "SETPOINT32", .summary = "Targets, 32 bits."},
      {.name = "setpoint16_param16", .spec_name = "setpoint16_param16",
       .summary = "Targets of 16 bits, parameters of 16 bits."},
      {.name = "setpoint16_param32", .spec_name = "setpoint16_param32",
       .summary = "Targets of 16 bits, parameters of 32 bits."},
      {.name = "setpoint32_param16", .spec_name = "setpoint32_param16",
       .summary = "Targets of 32 bits, parameters of 16 bits."},
      {.name = "setpoint32_param32", .spec_name = "setpoint32_param32",
       .summary = "Targets of 32 bits, parameters of 32 bits."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, for_motors), &detail::value_type<decltype(T::for_motors)>},
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, setpoint16), &detail::value_type<decltype(T::setpoint16)>},
      {offsetof(T, setpoint32), &detail::value_type<decltype(T::setpoint32)>},
      {offsetof(T, setpoint16_param16), &detail::value_type<decltype(T::setpoint16_param16)>},
      {offsetof(T, setpoint16_param32), &detail::value_type<decltype(T::setpoint16_param32)>},
      {offsetof(T, setpoint32_param16), &detail::value_type<decltype(T::setpoint32_param16)>},
      {offsetof(T, setpoint32_param32), &detail::value_type<decltype(T::setpoint32_param32)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.for_motors);
    visitor(fields[1], value.data_set);
    visitor(fields[2], value.setpoint16);
    visitor(fields[3], value.setpoint32);
    visitor(fields[4], value.setpoint16_param16);
    visitor(fields[5], value.setpoint16_param32);
    visitor(fields[6], value.setpoint32_param16);
    visitor(fields[7], value.setpoint32_param32);
  }
};

template <>
struct Meta<msg::ExtMotorsControlConfig> {
  static constexpr MessageInfo info{
      .name = "ExtMotorsControlConfig", .command = "CMD_EXT_MOTORS_CONTROL_CONFIG",
      .summary = "Configure external motors.", .id = 130, .direction = Direction::to_board,
      .min_size = 3, .max_size = 12, .since = {.firmware = 2730, .features = 0x400000000},
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "for_motors", .spec_name = "FOR_MOTORS",
       .summary = "The motors, and whether to confirm."},
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Which of the following fields are present."},
      {.name = "mode", .spec_name = "MODE", .summary = "What their setpoints control."},
      {.name = "max_speed", .spec_name = "MAX_SPEED", .summary = "Speed limit in all modes.",
       .unit = &UnitMeta<msg::ExtMotorSpeedLimit>::info},
      {.name = "max_acceleration", .spec_name = "MAX_ACCELERATION",
       .summary = "Acceleration limit in the modes SPEED and POSITION.",
       .unit = &UnitMeta<msg::ExtMotorAccelerationLimit>::info},
      {.name = "jerk_slope", .spec_name = "JERK_SLOPE",
       .summary = "Time in which the acceleration rises to its limit in the modes SPEED and POSITION.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "max_torque", .spec_name = "MAX_TORQUE",
       .summary = "Torque limit in all modes; 65535 is all that the driver can provide."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, for_motors), &detail::value_type<decltype(T::for_motors)>},
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, max_speed), &detail::value_type<decltype(T::max_speed)>},
      {offsetof(T, max_acceleration), &detail::value_type<decltype(T::max_acceleration)>},
      {offsetof(T, jerk_slope), &detail::value_type<decltype(T::jerk_slope)>},
      {offsetof(T, max_torque), &detail::value_type<decltype(T::max_torque)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.for_motors);
    visitor(fields[1], value.data_set);
    visitor(fields[2], value.mode);
    visitor(fields[3], value.max_speed);
    visitor(fields[4], value.max_acceleration);
    visitor(fields[5], value.jerk_slope);
    visitor(fields[6], value.max_torque);
  }
};

template <>
struct Meta<msg::ExtMotorsState> {
  static constexpr MessageInfo info{
      .name = "ExtMotorsState", .command = "CMD_EXT_MOTORS_STATE",
      .summary = "State of an external motor.", .id = 131, .direction = Direction::from_board,
      .min_size = 5, .max_size = 50, .since = {.firmware = 2730, .features = 0x400000000}};
  static constexpr Range motor_id_range{0, 6};
  static constexpr FieldInfo fields[] = {
      {.name = "motor_id", .spec_name = "MOTOR_ID", .summary = "The motor, counted from 0.",
       .range = &motor_id_range},
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Which of the following fields are present."},
      {.name = "control_mode", .spec_name = "CONTROL_MODE", .summary = "What its setpoint controls."},
      {.name = "torque", .spec_name = "TORQUE",
       .summary = "Torque; 32767 is all that the driver can provide."},
      {.name = "torque_setpoint", .spec_name = "TORQUE_SETPOINT", .summary = "Target torque."},
      {.name = "speed16", .spec_name = "SPEED16", .summary = "Speed.",
       .unit = &UnitMeta<msg::ControlSpeed>::info, .directed = Directed::by_axis},
      {.name = "speed16_setpoint", .spec_name = "SPEED16_SETPOINT", .summary = "Target speed.",
       .unit = &UnitMeta<msg::ControlSpeed>::info, .directed = Directed::by_axis},
      {.name = "speed32", .spec_name = "SPEED32", .summary = "Speed.",
       .unit = &UnitMeta<msg::MicroradianRate>::info, .directed = Directed::by_axis},
      {.name = "speed32_setpoint", .spec_name = "SPEED32_SETPOINT", .summary = "Target speed.",
       .unit = &UnitMeta<msg::MicroradianRate>::info, .directed = Directed::by_axis},
      {.name = "angle16", .spec_name = "ANGLE16", .summary = "Angle.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "angle16_setpoint", .spec_name = "ANGLE16_SETPOINT", .summary = "Target angle.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "angle32", .spec_name = "ANGLE32", .summary = "Angle.",
       .unit = &UnitMeta<msg::Angle20>::info, .directed = Directed::by_axis},
      {.name = "angle32_setpoint", .spec_name = "ANGLE32_SETPOINT", .summary = "Target angle.",
       .unit = &UnitMeta<msg::Angle20>::info, .directed = Directed::by_axis},
      {.name = "state_flags", .spec_name = "STATE_FLAGS", .summary = "State of the motor."},
      {.name = "max_speed", .spec_name = "MAX_SPEED", .summary = "Speed limit.",
       .unit = &UnitMeta<msg::ExtMotorSpeedLimit>::info},
      {.name = "max_acceleration", .spec_name = "MAX_ACCELERATION", .summary = "Acceleration limit.",
       .unit = &UnitMeta<msg::ExtMotorAccelerationLimit>::info},
      {.name = "jerk_slope", .spec_name = "JERK_SLOPE",
       .summary = "Time in which the acceleration rises to its limit.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "max_torque", .spec_name = "MAX_TORQUE", .summary = "Torque limit."},
      {.name = "current", .spec_name = "CURRENT", .summary = "Current.",
       .unit = &UnitMeta<msg::Current>::info},
      {.name = "battery_voltage", .spec_name = "BATTERY_VOLTAGE", .summary = "Supply voltage.",
       .unit = &UnitMeta<msg::Millivolts>::info},
      {.name = "motor_temperature", .spec_name = "MOTOR_TEMPERATURE",
       .summary = "Temperature of the motor.", .unit = &UnitMeta<msg::Temperature>::info},
      {.name = "driver_temperature", .spec_name = "DRIVER_TEMPERATURE",
       .summary = "Temperature of the driver.", .unit = &UnitMeta<msg::Temperature>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, motor_id), &detail::value_type<decltype(T::motor_id)>},
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, control_mode), &detail::value_type<decltype(T::control_mode)>},
      {offsetof(T, torque), &detail::value_type<decltype(T::torque)>},
      {offsetof(T, torque_setpoint), &detail::value_type<decltype(T::torque_setpoint)>},
      {offsetof(T, speed16), &detail::value_type<decltype(T::speed16)>},
      {offsetof(T, speed16_setpoint), &detail::value_type<decltype(T::speed16_setpoint)>},
      {offsetof(T, speed32), &detail::value_type<decltype(T::speed32)>},
      {offsetof(T, speed32_setpoint), &detail::value_type<decltype(T::speed32_setpoint)>},
      {offsetof(T, angle16), &detail::value_type<decltype(T::angle16)>},
      {offsetof(T, angle16_setpoint), &detail::value_type<decltype(T::angle16_setpoint)>},
      {offsetof(T, angle32), &detail::value_type<decltype(T::angle32)>},
      {offsetof(T, angle32_setpoint), &detail::value_type<decltype(T::angle32_setpoint)>},
      {offsetof(T, state_flags), &detail::value_type<decltype(T::state_flags)>},
      {offsetof(T, max_speed), &detail::value_type<decltype(T::max_speed)>},
      {offsetof(T, max_acceleration), &detail::value_type<decltype(T::max_acceleration)>},
      {offsetof(T, jerk_slope), &detail::value_type<decltype(T::jerk_slope)>},
      {offsetof(T, max_torque), &detail::value_type<decltype(T::max_torque)>},
      {offsetof(T, current), &detail::value_type<decltype(T::current)>},
      {offsetof(T, battery_voltage), &detail::value_type<decltype(T::battery_voltage)>},
      {offsetof(T, motor_temperature), &detail::value_type<decltype(T::motor_temperature)>},
      {offsetof(T, driver_temperature), &detail::value_type<decltype(T::driver_temperature)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.motor_id);
    visitor(fields[1], value.data_set);
    visitor(fields[2], value.control_mode);
    visitor(fields[3], value.torque);
    visitor(fields[4], value.torque_setpoint);
    visitor(fields[5], value.speed16);
    visitor(fields[6], value.speed16_setpoint);
    visitor(fields[7], value.speed32);
    visitor(fields[8], value.speed32_setpoint);
    visitor(fields[9], value.angle16);
    visitor(fields[10], value.angle16_setpoint);
    visitor(fields[11], value.angle32);
    visitor(fields[12], value.angle32_setpoint);
    visitor(fields[13], value.state_flags);
    visitor(fields[14], value.max_speed);
    visitor(fields[15], value.max_acceleration);
    visitor(fields[16], value.jerk_slope);
    visitor(fields[17], value.max_torque);
    visitor(fields[18], value.current);
    visitor(fields[19], value.battery_voltage);
    visitor(fields[20], value.motor_temperature);
    visitor(fields[21], value.driver_temperature);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ExtMotorsStateRequest> {
  static constexpr const char* answers[] = {"ExtMotorsState"};
  static constexpr MessageInfo info{
      .name = "ExtMotorsStateRequest", .command = "CMD_EXT_MOTORS_STATE",
      .summary = "Request the state of external motors.", .id = 131,
      .direction = Direction::to_board, .min_size = 5, .max_size = 5,
      .since = {.firmware = 2730, .features = 0x400000000}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "for_motors", .spec_name = "FOR_MOTORS", .summary = "The motors."},
      {.name = "data_set", .spec_name = "DATA_SET", .summary = "Data to send."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, for_motors), &detail::value_type<decltype(T::for_motors)>},
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.for_motors);
    visitor(fields[1], value.data_set);
  }
};

}  // namespace sbgc
