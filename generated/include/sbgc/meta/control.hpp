// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/control.hpp>.
#pragma once

#include <sbgc/messages/control.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::ControlAxis> {
  static constexpr AlternativeUnit speed_alternative{"control_mode", 0x80, &UnitMeta<msg::FineSpeed>::info};
  static constexpr Range angle_range{-32768, 32767};
  static constexpr FieldInfo fields[] = {
      {.name = "speed",
       .spec_name = "SPEED_{AXIS}",
       .summary = "Speed of the motion; the acceleration limit in the parameters may restrict it.",
       .unit = &UnitMeta<msg::ControlSpeed>::info,
       .alternative = &speed_alternative},
      {.name = "angle",
       .spec_name = "ANGLE_{AXIS}",
       .summary = "Target angle; in MODE_RC the RC signal, -500 to 500.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &angle_range},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.speed);
    visitor(fields[1], value.angle);
  }
};

template <>
struct Meta<msg::AxisState> {
  static constexpr Range imu_angle_range{-32768, 32767};
  static constexpr Range rc_target_angle_range{-32768, 32767};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_angle",
       .spec_name = "IMU_ANGLE",
       .summary = "Measured angle; wraps after two full turns.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &imu_angle_range},
      {.name = "rc_target_angle",
       .spec_name = "RC_TARGET_ANGLE",
       .summary = "Target angle, set by RC or by control commands.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &rc_target_angle_range},
      {.name = "rc_speed",
       .spec_name = "RC_SPEED",
       .summary = "Target speed; 0 once the target is reached.",
       .unit = &UnitMeta<msg::ControlSpeed>::info},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_angle);
    visitor(fields[1], value.rc_target_angle);
    visitor(fields[2], value.rc_speed);
  }
};

template <>
struct Meta<msg::AxisStateExt> {
  static constexpr Range imu_angle_range{-32768, 32767};
  static constexpr Range rc_target_angle_range{-32768, 32767};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_angle",
       .spec_name = "IMU_ANGLE",
       .summary = "Measured angle; wraps after two full turns.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &imu_angle_range},
      {.name = "rc_target_angle",
       .spec_name = "RC_TARGET_ANGLE",
       .summary = "Target angle.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &rc_target_angle_range},
      {.name = "stator_rotor_angle",
       .spec_name = "STATOR_ROTOR_ANGLE",
       .summary = "Angle of the joint, from an encoder or the second IMU; 0 in the normal position, accumulated over full turns.",
       .unit = &UnitMeta<msg::LongAngle14>::info},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.imu_angle);
    visitor(fields[1], value.rc_target_angle);
    visitor(fields[2], value.stator_rotor_angle);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::Control> {
  static constexpr MessageInfo info{
      .name = "Control",
      .command = "CMD_CONTROL",
      .summary = "Move the camera, with one mode for all axes.",
      .id = 67,
      .direction = Direction::to_board,
      .min_size = 13,
      .max_size = 13,
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "control_mode",
       .spec_name = "CONTROL_MODE",
       .summary = "Mode of all three axes."},
      {.name = "axes",
       .spec_name = "axes",
       .summary = "Target of each axis."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.control_mode);
    visitor(fields[1], value.axes);
  }
};

template <>
struct Meta<msg::ControlExt> {
  static constexpr MessageInfo info{
      .name = "ControlExt",
      .command = "CMD_CONTROL",
      .summary = "Move the camera, with a mode for each axis.",
      .id = 67,
      .direction = Direction::to_board,
      .min_size = 15,
      .max_size = 15,
      .since = {.firmware = 2555},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "control_mode",
       .spec_name = "CONTROL_MODE_{AXIS}",
       .summary = "Mode of each axis."},
      {.name = "axes",
       .spec_name = "axes",
       .summary = "Target of each axis."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.control_mode);
    visitor(fields[1], value.axes);
  }
};

template <>
struct Meta<msg::GetAngles> {
  static constexpr MessageInfo info{
      .name = "GetAngles",
      .command = "CMD_GET_ANGLES",
      .summary = "Camera angles and targets.",
      .id = 73,
      .direction = Direction::from_board,
      .min_size = 18,
      .max_size = 18};
  static constexpr FieldInfo fields[] = {
      {.name = "axes",
       .spec_name = "axes",
       .summary = "State of each axis."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.axes);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAnglesRequest> {
  static constexpr const char* answers[] = {"GetAngles"};
  static constexpr MessageInfo info{
      .name = "GetAnglesRequest",
      .command = "CMD_GET_ANGLES",
      .summary = "Request camera angles and targets.",
      .id = 73,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::GetAnglesExt> {
  static constexpr MessageInfo info{
      .name = "GetAnglesExt",
      .command = "CMD_GET_ANGLES_EXT",
      .summary = "Camera angles, targets and joint angles.",
      .id = 61,
      .direction = Direction::from_board,
      .min_size = 54,
      .max_size = 54,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "axes",
       .spec_name = "axes",
       .summary = "State of each axis."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.axes);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAnglesExtRequest> {
  static constexpr const char* answers[] = {"GetAnglesExt"};
  static constexpr MessageInfo info{
      .name = "GetAnglesExtRequest",
      .command = "CMD_GET_ANGLES_EXT",
      .summary = "Request angles, targets and joint angles.",
      .id = 61,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::MotorsOn> {
  static constexpr MessageInfo info{
      .name = "MotorsOn",
      .command = "CMD_MOTORS_ON",
      .summary = "Turn the motors on.",
      .id = 77,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .effects = Effects(Effect::moves)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::MotorsOff> {
  static constexpr MessageInfo info{
      .name = "MotorsOff",
      .command = "CMD_MOTORS_OFF",
      .summary = "Turn the motors off.",
      .id = 109,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .until = {.firmware = 2687},
      .effects = Effects(Effect::moves)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::MotorsOffExt> {
  static constexpr MessageInfo info{
      .name = "MotorsOffExt",
      .command = "CMD_MOTORS_OFF",
      .summary = "Turn the motors off, in one of several ways.",
      .id = 109,
      .direction = Direction::to_board,
      .min_size = 1,
      .max_size = 1,
      .since = {.firmware = 2687},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode",
       .spec_name = "MODE",
       .summary = "How to turn them off."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::ExecuteMenu> {
  static constexpr MessageInfo info{
      .name = "ExecuteMenu",
      .command = "CMD_EXECUTE_MENU",
      .summary = "Execute a menu action.",
      .id = 69,
      .direction = Direction::to_board,
      .min_size = 1,
      .max_size = 1,
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id",
       .spec_name = "CMD_ID",
       .summary = "Which action."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.cmd_id);
  }
};

template <>
struct Meta<msg::ExecuteMenuExt> {
  static constexpr MessageInfo info{
      .name = "ExecuteMenuExt",
      .command = "CMD_EXECUTE_MENU",
      .summary = "Execute a menu action, with a parameter of later firmware.",
      .id = 69,
      .direction = Direction::to_board,
      .min_size = 2,
      .max_size = 2,
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id",
       .spec_name = "CMD_ID",
       .summary = "Which action."},
      {.name = "param",
       .spec_name = "PARAM",
       .summary = "Its meaning is not documented."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.param);
  }
};

template <>
struct Meta<msg::HelperData> {
  static constexpr MessageInfo info{
      .name = "HelperData",
      .command = "CMD_HELPER_DATA",
      .summary = "Report acceleration and tilt of the frame to the board.",
      .id = 72,
      .direction = Direction::to_board,
      .min_size = 10,
      .max_size = 10,
      .effects = Effects(Effect::moves)};
  static constexpr Range frame_angle_roll_range{-32768, 32767};
  static constexpr Special frame_angle_roll_special[] = {
      {0, "with FRAME_ANGLE_PITCH 0 too, not used"},
  };
  static constexpr Range frame_angle_pitch_range{-32768, 32767};
  static constexpr Special frame_angle_pitch_special[] = {
      {0, "with FRAME_ANGLE_ROLL 0 too, not used"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "frame_acc",
       .spec_name = "FRAME_ACC_{XYZ}",
       .summary = "Linear acceleration of the frame; keeps the horizon level during acceleration.",
       .unit = &UnitMeta<msg::Acceleration>::info},
      {.name = "frame_angle_roll",
       .spec_name = "FRAME_ANGLE_ROLL",
       .summary = "Sideways tilt of the frame.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_roll_range,
       .special = frame_angle_roll_special},
      {.name = "frame_angle_pitch",
       .spec_name = "FRAME_ANGLE_PITCH",
       .summary = "Forward tilt of the frame.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_pitch_range,
       .special = frame_angle_pitch_special},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.frame_acc);
    visitor(fields[1], value.frame_angle_roll);
    visitor(fields[2], value.frame_angle_pitch);
  }
};

template <>
struct Meta<msg::HelperDataExt> {
  static constexpr MessageInfo info{
      .name = "HelperDataExt",
      .command = "CMD_HELPER_DATA",
      .summary = "Report acceleration, tilt and rotation of the frame to the board.",
      .id = 72,
      .direction = Direction::to_board,
      .min_size = 20,
      .max_size = 20,
      .since = {.firmware = 2590},
      .effects = Effects(Effect::moves)};
  static constexpr Range frame_angle_roll_range{-32768, 32767};
  static constexpr Special frame_angle_roll_special[] = {
      {0, "with FRAME_ANGLE_PITCH 0 too, not used"},
  };
  static constexpr Range frame_angle_pitch_range{-32768, 32767};
  static constexpr Special frame_angle_pitch_special[] = {
      {0, "with FRAME_ANGLE_ROLL 0 too, not used"},
  };
  static constexpr Special frame_speed_special[] = {
      {0, "with all three 0, not used"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "frame_acc",
       .spec_name = "FRAME_ACC",
       .summary = "Linear acceleration of the frame; keeps the horizon level during acceleration.",
       .unit = &UnitMeta<msg::Acceleration>::info},
      {.name = "frame_angle_roll",
       .spec_name = "FRAME_ANGLE_ROLL",
       .summary = "Sideways tilt of the frame.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_roll_range,
       .special = frame_angle_roll_special},
      {.name = "frame_angle_pitch",
       .spec_name = "FRAME_ANGLE_PITCH",
       .summary = "Forward tilt of the frame.",
       .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_pitch_range,
       .special = frame_angle_pitch_special},
      {.name = "coord_sys",
       .spec_name = "COORD_SYS",
       .summary = "Coordinate system of all the vectors."},
      {.name = "frame_speed",
       .spec_name = "FRAME_SPEED",
       .summary = "Angular speed of the frame; useful without encoders and a second IMU.",
       .unit = &UnitMeta<msg::GyroRate>::info,
       .special = frame_speed_special},
      {.name = "reserved",
       .spec_name = "RESERVED",
       .summary = "Reserved; kept as it is.",
       .reserved = true},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.frame_acc);
    visitor(fields[1], value.frame_angle_roll);
    visitor(fields[2], value.frame_angle_pitch);
    visitor(fields[3], value.coord_sys);
    visitor(fields[4], value.frame_speed);
    visitor(fields[5], value.reserved);
  }
};

}  // namespace sbgc
