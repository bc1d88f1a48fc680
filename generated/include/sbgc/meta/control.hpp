// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/control.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
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
      {.name = "speed", .spec_name = "SPEED_{AXIS}",
       .summary = "Speed of the motion; the acceleration limit in the parameters may restrict it.",
       .unit = &UnitMeta<msg::ControlSpeed>::info, .directed = Directed::by_axis,
       .alternative = &speed_alternative},
      {.name = "angle", .spec_name = "ANGLE_{AXIS}",
       .summary = "Target angle; in MODE_RC the RC signal, -500 to 500, in MODE_RC_HIGH_RES -16384 to 16384.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &angle_range, .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, speed), &detail::value_type<decltype(T::speed)>},
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.speed);
    visitor(fields[1], value.angle);
  }
};

template <>
struct Meta<msg::ControlExtAxis> {
  static constexpr AlternativeUnit speed_alternative{"mode", 0x80, &UnitMeta<msg::FineSpeed>::info};
  static constexpr Range angle_range{-32768, 32767};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "{AXIS}_MODE", .summary = "Mode."},
      {.name = "flags", .spec_name = "{AXIS}_FLAGS", .summary = "Further options."},
      {.name = "speed", .spec_name = "{AXIS}_SPEED", .summary = "Speed.",
       .unit = &UnitMeta<msg::ControlSpeed>::info, .directed = Directed::by_axis,
       .alternative = &speed_alternative},
      {.name = "speed_32", .spec_name = "{AXIS}_SPEED_32", .summary = "Speed, with 32 bits.",
       .unit = &UnitMeta<msg::LongFineSpeed>::info, .directed = Directed::by_axis,
       .unconfirmed = true},
      {.name = "angle", .spec_name = "{AXIS}_ANGLE",
       .summary = "Target angle, or an RC signal as in CMD_CONTROL.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &angle_range, .directed = Directed::by_axis},
      {.name = "angle_32", .spec_name = "{AXIS}_ANGLE_32", .summary = "Target angle, with 32 bits.",
       .unit = &UnitMeta<msg::Angle20>::info, .directed = Directed::by_axis, .unconfirmed = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, speed), &detail::value_type<decltype(T::speed)>},
      {offsetof(T, speed_32), &detail::value_type<decltype(T::speed_32)>},
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
      {offsetof(T, angle_32), &detail::value_type<decltype(T::angle_32)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.speed);
    visitor(fields[3], value.speed_32);
    visitor(fields[4], value.angle);
    visitor(fields[5], value.angle_32);
  }
};

template <>
struct Meta<msg::ControlConfigAxis> {
  static constexpr Range rc_lpf_range{1, 255};
  static constexpr Special rc_lpf_special[] = {
      {0, "the filter does not change"},
  };
  static constexpr Range acc_limit_range{1, 65535};
  static constexpr Special acc_limit_special[] = {
      {0, "the limit does not change"},
  };
  static constexpr Range jerk_slope_range{2, 255};
  static constexpr Special jerk_slope_special[] = {
      {0, "the time does not change"},
      {1, "the acceleration changes at once"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "angle_lpf", .spec_name = "ANGLE_LPF",
       .summary = "Low-pass filter of the angle, 0 (off) to 15."},
      {.name = "speed_lpf", .spec_name = "SPEED_LPF",
       .summary = "Low-pass filter of the speed, 0 (off) to 15."},
      {.name = "rc_lpf", .spec_name = "RC_LPF", .summary = "Low-pass filter of an RC signal.",
       .range = &rc_lpf_range, .special = rc_lpf_special},
      {.name = "acc_limit", .spec_name = "ACC_LIMIT", .summary = "Acceleration limit in all modes.",
       .unit = &UnitMeta<msg::LongAngularAcceleration>::info, .range = &acc_limit_range,
       .special = acc_limit_special, .since = {.firmware = 2701}},
      {.name = "jerk_slope", .spec_name = "JERK_SLOPE",
       .summary = "Time in which the acceleration rises to its limit.",
       .unit = &UnitMeta<msg::JerkTime>::info, .range = &jerk_slope_range,
       .special = jerk_slope_special, .since = {.firmware = 2708}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, angle_lpf), &detail::value_type<decltype(T::angle_lpf)>},
      {offsetof(T, speed_lpf), &detail::value_type<decltype(T::speed_lpf)>},
      {offsetof(T, rc_lpf), &detail::value_type<decltype(T::rc_lpf)>},
      {offsetof(T, acc_limit), &detail::value_type<decltype(T::acc_limit)>},
      {offsetof(T, jerk_slope), &detail::value_type<decltype(T::jerk_slope)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.angle_lpf);
    visitor(fields[1], value.speed_lpf);
    visitor(fields[2], value.rc_lpf);
    visitor(fields[3], value.acc_limit);
    visitor(fields[4], value.jerk_slope);
    visitor(fields[5], value.reserved);
  }
};

template <>
struct Meta<msg::AxisState> {
  static constexpr Range imu_angle_range{-32768, 32767};
  static constexpr Range rc_target_angle_range{-32768, 32767};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_angle", .spec_name = "IMU_ANGLE",
       .summary = "Measured angle; wraps after two full turns.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &imu_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_target_angle", .spec_name = "RC_TARGET_ANGLE",
       .summary = "Target angle, set by RC or by control commands.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &rc_target_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_speed", .spec_name = "RC_SPEED",
       .summary = "Target speed; 0 once the target is reached.",
       .unit = &UnitMeta<msg::ControlSpeed>::info, .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_angle), &detail::value_type<decltype(T::imu_angle)>},
      {offsetof(T, rc_target_angle), &detail::value_type<decltype(T::rc_target_angle)>},
      {offsetof(T, rc_speed), &detail::value_type<decltype(T::rc_speed)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
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
      {.name = "imu_angle", .spec_name = "IMU_ANGLE",
       .summary = "Measured angle; wraps after two full turns.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &imu_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_target_angle", .spec_name = "RC_TARGET_ANGLE", .summary = "Target angle.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &rc_target_angle_range,
       .directed = Directed::by_axis},
      {.name = "stator_rotor_angle", .spec_name = "STATOR_ROTOR_ANGLE",
       .summary = "Angle of the joint, from an encoder or the second IMU; 0 in the normal position, accumulated over full turns.",
       .unit = &UnitMeta<msg::LongAngle14>::info, .directed = Directed::by_axis},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_angle), &detail::value_type<decltype(T::imu_angle)>},
      {offsetof(T, rc_target_angle), &detail::value_type<decltype(T::rc_target_angle)>},
      {offsetof(T, stator_rotor_angle), &detail::value_type<decltype(T::stator_rotor_angle)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_angle);
    visitor(fields[1], value.rc_target_angle);
    visitor(fields[2], value.stator_rotor_angle);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::Control> {
  static constexpr MessageInfo info{
      .name = "Control", .command = "CMD_CONTROL",
      .summary = "Move the camera, with one mode for all axes.", .id = 67,
      .direction = Direction::to_board, .min_size = 13, .max_size = 13,
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "control_mode", .spec_name = "CONTROL_MODE", .summary = "Mode of all three axes."},
      {.name = "axes", .spec_name = "axes", .summary = "Target of each axis."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, control_mode), &detail::value_type<decltype(T::control_mode)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.control_mode);
    visitor(fields[1], value.axes);
  }
};

template <>
struct Meta<msg::ControlExt> {
  static constexpr MessageInfo info{
      .name = "ControlExt", .command = "CMD_CONTROL",
      .summary = "Move the camera, with a mode for each axis.", .id = 67,
      .direction = Direction::to_board, .min_size = 15, .max_size = 15, .since = {.firmware = 2555},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "control_mode", .spec_name = "CONTROL_MODE_{AXIS}", .summary = "Mode of each axis."},
      {.name = "axes", .spec_name = "axes", .summary = "Target of each axis."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, control_mode), &detail::value_type<decltype(T::control_mode)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.control_mode);
    visitor(fields[1], value.axes);
  }
};

template <>
struct Meta<msg::ControlExtCommand> {
  static constexpr MessageInfo info{
      .name = "ControlExtCommand", .command = "CMD_CONTROL_EXT",
      .summary = "Move the camera, with the data that each axis needs.", .id = 121,
      .direction = Direction::to_board, .min_size = 2, .max_size = 32, .since = {.firmware = 2680},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Which of the following fields are present."},
      {.name = "axes", .spec_name = "axes", .summary = "Motion of each axis."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data_set);
    visitor(fields[1], value.axes);
  }
};

template <>
struct Meta<msg::ControlConfig> {
  static constexpr MessageInfo info{
      .name = "ControlConfig", .command = "CMD_CONTROL_CONFIG",
      .summary = "Configure serial control until the next start.", .id = 90,
      .direction = Direction::to_board, .min_size = 41, .max_size = 41, .since = {.firmware = 2610},
      .effects = Effects(Effect::sets) | Effect::moves};
  static constexpr Special timeout_ms_special[] = {
      {0, "no timeout"},
  };
  static constexpr Range ch_priority_range{1, 255};
  static constexpr Special ch_priority_special[] = {
      {0, "the priority does not change"},
  };
  static constexpr Range this_ch_priority_range{1, 255};
  static constexpr Special this_ch_priority_special[] = {
      {0, "the priority does not change"},
  };
  static constexpr Range rc_expo_rate_range{0, 100};
  static constexpr FieldInfo fields[] = {
      {.name = "timeout_ms", .spec_name = "TIMEOUT_MS",
       .summary = "Time without a control command after which serial control ends and RC takes over, which is not a stop.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .special = timeout_ms_special},
      {.name = "ch_priority", .spec_name = "CH{1..4}_PRIORITY",
       .summary = "Priority of UART1, RC_SERIAL, UART2 and USB_VCP or UART3.",
       .range = &ch_priority_range, .special = ch_priority_special},
      {.name = "this_ch_priority", .spec_name = "THIS_CH_PRIORITY",
       .summary = "Priority of this port.", .range = &this_ch_priority_range,
       .special = this_ch_priority_special},
      {.name = "axes", .spec_name = "axes", .summary = "Options of each axis."},
      {.name = "rc_expo_rate", .spec_name = "RC_EXPO_RATE", .summary = "Expo rate of RC signals.",
       .range = &rc_expo_rate_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "euler_order", .spec_name = "EULER_ORDER", .summary = "Order of the Euler angles.",
       .since = {.firmware = 2720}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, timeout_ms), &detail::value_type<decltype(T::timeout_ms)>},
      {offsetof(T, ch_priority), &detail::value_type<decltype(T::ch_priority)>},
      {offsetof(T, this_ch_priority), &detail::value_type<decltype(T::this_ch_priority)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, rc_expo_rate), &detail::value_type<decltype(T::rc_expo_rate)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, euler_order), &detail::value_type<decltype(T::euler_order)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.timeout_ms);
    visitor(fields[1], value.ch_priority);
    visitor(fields[2], value.this_ch_priority);
    visitor(fields[3], value.axes);
    visitor(fields[4], value.rc_expo_rate);
    visitor(fields[5], value.flags);
    visitor(fields[6], value.euler_order);
    visitor(fields[7], value.reserved);
  }
};

template <>
struct Meta<msg::ControlQuatDisabled> {
  static constexpr MessageInfo info{
      .name = "ControlQuatDisabled", .command = "CMD_CONTROL_QUAT",
      .summary = "End control with quaternions.", .id = 140, .direction = Direction::to_board,
      .min_size = 2, .max_size = 2, .since = {.firmware = 2730, .features = 0x800000000},
      .effects = Effects(Effect::moves)};
  static constexpr Range mode_range{0, 0};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Always DISABLED.", .range = &mode_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
  }
};

template <>
struct Meta<msg::ControlQuatSpeed> {
  static constexpr MessageInfo info{
      .name = "ControlQuatSpeed", .command = "CMD_CONTROL_QUAT",
      .summary = "Turn the camera at a speed.", .id = 140, .direction = Direction::to_board,
      .min_size = 14, .max_size = 14, .since = {.firmware = 2730, .features = 0x800000000},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "SPEED or SPEED_LIMITED."},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "target_speed", .spec_name = "TARGET_SPEED",
       .summary = "Rotation vector of the motion.", .unit = &UnitMeta<msg::RadianRate>::info,
       .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_speed), &detail::value_type<decltype(T::target_speed)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.target_speed);
  }
};

template <>
struct Meta<msg::ControlQuatAttitude> {
  static constexpr MessageInfo info{
      .name = "ControlQuatAttitude", .command = "CMD_CONTROL_QUAT",
      .summary = "Turn the camera to an attitude.", .id = 140, .direction = Direction::to_board,
      .min_size = 18, .max_size = 18, .since = {.firmware = 2730, .features = 0x800000000},
      .effects = Effects(Effect::moves)};
  static constexpr Range mode_range{2, 2};
  static constexpr Range target_attitude_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Always ATTITUDE.", .range = &mode_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "target_attitude", .spec_name = "TARGET_ATTITUDE",
       .summary = "Quaternion of length 1: W, X, Y, Z.", .range = &target_attitude_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_attitude), &detail::value_type<decltype(T::target_attitude)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.target_attitude);
  }
};

template <>
struct Meta<msg::ControlQuatAttitudePacked> {
  static constexpr MessageInfo info{
      .name = "ControlQuatAttitudePacked", .command = "CMD_CONTROL_QUAT",
      .summary = "Turn the camera to an attitude, packed.", .id = 140,
      .direction = Direction::to_board, .min_size = 10, .max_size = 10,
      .since = {.firmware = 2730, .features = 0x800000000}, .effects = Effects(Effect::moves)};
  static constexpr Range mode_range{2, 2};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Always ATTITUDE.", .range = &mode_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options, with ATTITUDE_PACKED."},
      {.name = "target_attitude", .spec_name = "TARGET_ATTITUDE", .summary = "The attitude."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_attitude), &detail::value_type<decltype(T::target_attitude)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.target_attitude);
  }
};

template <>
struct Meta<msg::ControlQuatSpeedAttitude> {
  static constexpr MessageInfo info{
      .name = "ControlQuatSpeedAttitude", .command = "CMD_CONTROL_QUAT",
      .summary = "Turn the camera at a speed and hold it to an attitude.", .id = 140,
      .direction = Direction::to_board, .min_size = 30, .max_size = 30,
      .since = {.firmware = 2730, .features = 0x800000000}, .effects = Effects(Effect::moves)};
  static constexpr Range mode_range{5, 5};
  static constexpr Range target_attitude_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Always SPEED_ATTITUDE.",
       .range = &mode_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "target_attitude", .spec_name = "TARGET_ATTITUDE",
       .summary = "Quaternion of length 1: W, X, Y, Z.", .range = &target_attitude_range},
      {.name = "target_speed", .spec_name = "TARGET_SPEED",
       .summary = "Rotation vector of the motion.", .unit = &UnitMeta<msg::RadianRate>::info,
       .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_attitude), &detail::value_type<decltype(T::target_attitude)>},
      {offsetof(T, target_speed), &detail::value_type<decltype(T::target_speed)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.target_attitude);
    visitor(fields[3], value.target_speed);
  }
};

template <>
struct Meta<msg::ControlQuatSpeedAttitudePacked> {
  static constexpr MessageInfo info{
      .name = "ControlQuatSpeedAttitudePacked", .command = "CMD_CONTROL_QUAT",
      .summary = "Turn the camera at a speed and hold it to an attitude, packed.", .id = 140,
      .direction = Direction::to_board, .min_size = 22, .max_size = 22,
      .since = {.firmware = 2730, .features = 0x800000000}, .effects = Effects(Effect::moves)};
  static constexpr Range mode_range{5, 5};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Always SPEED_ATTITUDE.",
       .range = &mode_range},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options, with ATTITUDE_PACKED."},
      {.name = "target_attitude", .spec_name = "TARGET_ATTITUDE", .summary = "The attitude."},
      {.name = "target_speed", .spec_name = "TARGET_SPEED",
       .summary = "Rotation vector of the motion.", .unit = &UnitMeta<msg::RadianRate>::info,
       .directed = Directed::by_axis},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_attitude), &detail::value_type<decltype(T::target_attitude)>},
      {offsetof(T, target_speed), &detail::value_type<decltype(T::target_speed)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.target_attitude);
    visitor(fields[3], value.target_speed);
  }
};

template <>
struct Meta<msg::ControlQuatStatus> {
  static constexpr MessageInfo info{
      .name = "ControlQuatStatus", .command = "CMD_CONTROL_QUAT_STATUS",
      .summary = "State of the control with quaternions.", .id = 141,
      .direction = Direction::from_board, .min_size = 2, .max_size = 97,
      .since = {.firmware = 2730, .features = 0x800000000}};
  static constexpr Range target_attitude_range{-1, 1};
  static constexpr Range setpoint_attitude_range{-1, 1};
  static constexpr Range actual_attitude_range{-1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Which of the following fields are present."},
      {.name = "data_set_high", .spec_name = "DATA_SET_HIGH",
       .summary = "The upper half of DATA_SET, if that has 32 bits.", .unconfirmed = true},
      {.name = "mode", .spec_name = "MODE", .summary = "Mode of the last command."},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options of the last command."},
      {.name = "target_attitude", .spec_name = "TARGET_ATTITUDE",
       .summary = "Attitude of the last command: W, X, Y, Z.", .range = &target_attitude_range},
      {.name = "setpoint_attitude", .spec_name = "SETPOINT_ATTITUDE",
       .summary = "Attitude that the board stabilizes: W, X, Y, Z.",
       .range = &setpoint_attitude_range},
      {.name = "actual_attitude", .spec_name = "ACTUAL_ATTITUDE",
       .summary = "Measured attitude: W, X, Y, Z.", .range = &actual_attitude_range},
      {.name = "target_speed", .spec_name = "TARGET_SPEED", .summary = "Speed of the last command.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::by_axis},
      {.name = "setpoint_speed", .spec_name = "SETPOINT_SPEED",
       .summary = "Speed that the board stabilizes.", .unit = &UnitMeta<msg::GyroRate>::info,
       .directed = Directed::by_axis},
      {.name = "actual_speed", .spec_name = "ACTUAL_SPEED", .summary = "Measured speed.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::by_axis},
      {.name = "target_attitude_packed", .spec_name = "TARGET_ATTITUDE_PACKED",
       .summary = "Attitude of the last command."},
      {.name = "setpoint_attitude_packed", .spec_name = "SETPOINT_ATTITUDE_PACKED",
       .summary = "Attitude that the board stabilizes."},
      {.name = "actual_attitude_packed", .spec_name = "ACTUAL_ATTITUDE_PACKED",
       .summary = "Measured attitude."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, data_set_high), &detail::value_type<decltype(T::data_set_high)>},
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, target_attitude), &detail::value_type<decltype(T::target_attitude)>},
      {offsetof(T, setpoint_attitude), &detail::value_type<decltype(T::setpoint_attitude)>},
      {offsetof(T, actual_attitude), &detail::value_type<decltype(T::actual_attitude)>},
      {offsetof(T, target_speed), &detail::value_type<decltype(T::target_speed)>},
      {offsetof(T, setpoint_speed), &detail::value_type<decltype(T::setpoint_speed)>},
      {offsetof(T, actual_speed), &detail::value_type<decltype(T::actual_speed)>},
      {offsetof(T, target_attitude_packed), &detail::value_type<decltype(T::target_attitude_packed)>},
      {offsetof(T, setpoint_attitude_packed), &detail::value_type<decltype(T::setpoint_attitude_packed)>},
      {offsetof(T, actual_attitude_packed), &detail::value_type<decltype(T::actual_attitude_packed)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data_set);
    visitor(fields[1], value.data_set_high);
    visitor(fields[2], value.mode);
    visitor(fields[3], value.flags);
    visitor(fields[4], value.target_attitude);
    visitor(fields[5], value.setpoint_attitude);
    visitor(fields[6], value.actual_attitude);
    visitor(fields[7], value.target_speed);
    visitor(fields[8], value.setpoint_speed);
    visitor(fields[9], value.actual_speed);
    visitor(fields[10], value.target_attitude_packed);
    visitor(fields[11], value.setpoint_attitude_packed);
    visitor(fields[12], value.actual_attitude_packed);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ControlQuatStatusRequest> {
  static constexpr const char* answers[] = {"ControlQuatStatus"};
  static constexpr MessageInfo info{
      .name = "ControlQuatStatusRequest", .command = "CMD_CONTROL_QUAT_STATUS",
      .summary = "Request the state of the control with quaternions.", .id = 141,
      .direction = Direction::to_board, .min_size = 4, .max_size = 4,
      .since = {.firmware = 2730, .features = 0x800000000}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Data to send, in 32 bits with the reserved bytes."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data_set);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::ControlQuatConfig> {
  static constexpr MessageInfo info{
      .name = "ControlQuatConfig", .command = "CMD_CONTROL_QUAT_CONFIG",
      .summary = "Configure the control with quaternions.", .id = 142,
      .direction = Direction::to_board, .min_size = 2, .max_size = 24,
      .since = {.firmware = 2730, .features = 0x800000000}, .effects = Effects(Effect::sets)};
  static constexpr Range acc_limit_range{1, 65535};
  static constexpr Special acc_limit_special[] = {
      {0, "no limit"},
  };
  static constexpr Range jerk_slope_range{1, 65535};
  static constexpr Special jerk_slope_special[] = {
      {0, "the acceleration changes at once"},
  };
  static constexpr Range attitude_lpf_freq_range{1, 255};
  static constexpr Special attitude_lpf_freq_special[] = {
      {0, "no filter"},
  };
  static constexpr Range speed_lpf_freq_range{1, 255};
  static constexpr Special speed_lpf_freq_special[] = {
      {0, "no filter"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "data_set", .spec_name = "DATA_SET",
       .summary = "Which of the following fields are present."},
      {.name = "max_speed", .spec_name = "MAX_SPEED", .summary = "Speed limit of each axis.",
       .unit = &UnitMeta<msg::ControlSpeedLimit>::info},
      {.name = "acc_limit", .spec_name = "ACC_LIMIT", .summary = "Acceleration limit of each axis.",
       .unit = &UnitMeta<msg::LongAngularAcceleration>::info, .range = &acc_limit_range,
       .special = acc_limit_special},
      {.name = "jerk_slope", .spec_name = "JERK_SLOPE",
       .summary = "Time in which the acceleration of each axis rises to its limit.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .range = &jerk_slope_range,
       .special = jerk_slope_special},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Options."},
      {.name = "attitude_lpf_freq", .spec_name = "ATTITUDE_LPF_FREQ",
       .summary = "Low-pass filter of the attitude.", .unit = &UnitMeta<msg::SmallFrequency>::info,
       .range = &attitude_lpf_freq_range, .special = attitude_lpf_freq_special},
      {.name = "speed_lpf_freq", .spec_name = "SPEED_LPF_FREQ",
       .summary = "Low-pass filter of the speed.", .unit = &UnitMeta<msg::SmallFrequency>::info,
       .range = &speed_lpf_freq_range, .special = speed_lpf_freq_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, max_speed), &detail::value_type<decltype(T::max_speed)>},
      {offsetof(T, acc_limit), &detail::value_type<decltype(T::acc_limit)>},
      {offsetof(T, jerk_slope), &detail::value_type<decltype(T::jerk_slope)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, attitude_lpf_freq), &detail::value_type<decltype(T::attitude_lpf_freq)>},
      {offsetof(T, speed_lpf_freq), &detail::value_type<decltype(T::speed_lpf_freq)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data_set);
    visitor(fields[1], value.max_speed);
    visitor(fields[2], value.acc_limit);
    visitor(fields[3], value.jerk_slope);
    visitor(fields[4], value.flags);
    visitor(fields[5], value.attitude_lpf_freq);
    visitor(fields[6], value.speed_lpf_freq);
  }
};

template <>
struct Meta<msg::GetAngles> {
  static constexpr MessageInfo info{
      .name = "GetAngles", .command = "CMD_GET_ANGLES", .summary = "Camera angles and targets.",
      .id = 73, .direction = Direction::from_board, .min_size = 18, .max_size = 18};
  static constexpr FieldInfo fields[] = {
      {.name = "axes", .spec_name = "axes", .summary = "State of each axis."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axes);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAnglesRequest> {
  static constexpr const char* answers[] = {"GetAngles"};
  static constexpr MessageInfo info{
      .name = "GetAnglesRequest", .command = "CMD_GET_ANGLES",
      .summary = "Request camera angles and targets.", .id = 73, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::GetAnglesExt> {
  static constexpr MessageInfo info{
      .name = "GetAnglesExt", .command = "CMD_GET_ANGLES_EXT",
      .summary = "Camera angles, targets and joint angles.", .id = 61,
      .direction = Direction::from_board, .min_size = 54, .max_size = 54, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "axes", .spec_name = "axes", .summary = "State of each axis."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axes);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAnglesExtRequest> {
  static constexpr const char* answers[] = {"GetAnglesExt"};
  static constexpr MessageInfo info{
      .name = "GetAnglesExtRequest", .command = "CMD_GET_ANGLES_EXT",
      .summary = "Request angles, targets and joint angles.", .id = 61,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::MotorsOn> {
  static constexpr MessageInfo info{
      .name = "MotorsOn", .command = "CMD_MOTORS_ON", .summary = "Turn the motors on.", .id = 77,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::moves)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::MotorsOff> {
  static constexpr MessageInfo info{
      .name = "MotorsOff", .command = "CMD_MOTORS_OFF", .summary = "Turn the motors off.", .id = 109,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::moves)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::MotorsOffExt> {
  static constexpr MessageInfo info{
      .name = "MotorsOffExt", .command = "CMD_MOTORS_OFF",
      .summary = "Turn the motors off, in one of several ways.", .id = 109,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.firmware = 2687},
      .effects = Effects(Effect::moves)};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "How to turn them off."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
  }
};

template <>
struct Meta<msg::SyncMotors> {
  static constexpr MessageInfo info{
      .name = "SyncMotors", .command = "CMD_SYNC_MOTORS",
      .summary = "Power one motor as a synchronous motor for some time, then turn the motors off.",
      .id = 123, .direction = Direction::to_board, .min_size = 6, .max_size = 6,
      .since = {.firmware = 2709}, .effects = Effects(Effect::moves)};
  static constexpr Range power_range{0, 255};
  static constexpr Special angle_special[] = {
      {0, "the motor holds its position"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "axis", .spec_name = "AXIS", .summary = "The motor."},
      {.name = "power", .spec_name = "POWER", .summary = "Power of the windings.",
       .range = &power_range},
      {.name = "time_ms", .spec_name = "TIME_MS", .summary = "How long the windings have power.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "angle", .spec_name = "ANGLE", .summary = "Angle to turn.", .special = angle_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axis), &detail::value_type<decltype(T::axis)>},
      {offsetof(T, power), &detail::value_type<decltype(T::power)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axis);
    visitor(fields[1], value.power);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.angle);
  }
};

template <>
struct Meta<msg::Event> {
  static constexpr MessageInfo info{
      .name = "Event", .command = "CMD_EVENT",
      .summary = "An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL.",
      .id = 102, .direction = Direction::from_board, .min_size = 4, .max_size = 4,
      .since = {.firmware = 2657}};
  static constexpr FieldInfo fields[] = {
      {.name = "event_id", .spec_name = "EVENT_ID", .summary = "What has happened."},
      {.name = "event_type", .spec_name = "EVENT_TYPE", .summary = "Kind of the event."},
      {.name = "param", .spec_name = "PARAM", .summary = "Data that depend on the event."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, event_id), &detail::value_type<decltype(T::event_id)>},
      {offsetof(T, event_type), &detail::value_type<decltype(T::event_type)>},
      {offsetof(T, param), &detail::value_type<decltype(T::param)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.event_id);
    visitor(fields[1], value.event_type);
    visitor(fields[2], value.param);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ExecuteMenu> {
  static constexpr MessageInfo info{
      .name = "ExecuteMenu", .command = "CMD_EXECUTE_MENU", .summary = "Execute a menu action.",
      .id = 69, .direction = Direction::to_board, .min_size = 1, .max_size = 1,
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Which action."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
  }
};

template <>
struct Meta<msg::ExecuteMenuExt> {
  static constexpr MessageInfo info{
      .name = "ExecuteMenuExt", .command = "CMD_EXECUTE_MENU",
      .summary = "Execute a menu action and say when to confirm it.", .id = 69,
      .direction = Direction::to_board, .min_size = 2, .max_size = 2, .since = {.firmware = 2738},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Which action."},
      {.name = "param", .spec_name = "FLAGS", .summary = "When the board confirms the action."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, param), &detail::value_type<decltype(T::param)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.param);
  }
};

template <>
struct Meta<msg::HelperData> {
  static constexpr MessageInfo info{
      .name = "HelperData", .command = "CMD_HELPER_DATA",
      .summary = "Report acceleration and tilt of the frame to the board.", .id = 72,
      .direction = Direction::to_board, .min_size = 10, .max_size = 10,
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
      {.name = "frame_acc", .spec_name = "FRAME_ACC_{XYZ}",
       .summary = "Linear acceleration of the frame; keeps the horizon level during acceleration.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::by_axis},
      {.name = "frame_angle_roll", .spec_name = "FRAME_ANGLE_ROLL",
       .summary = "Sideways tilt of the frame.", .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_roll_range, .special = frame_angle_roll_special,
       .directed = Directed::unknown},
      {.name = "frame_angle_pitch", .spec_name = "FRAME_ANGLE_PITCH",
       .summary = "Forward tilt of the frame.", .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_pitch_range, .special = frame_angle_pitch_special,
       .directed = Directed::unknown},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, frame_acc), &detail::value_type<decltype(T::frame_acc)>},
      {offsetof(T, frame_angle_roll), &detail::value_type<decltype(T::frame_angle_roll)>},
      {offsetof(T, frame_angle_pitch), &detail::value_type<decltype(T::frame_angle_pitch)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.frame_acc);
    visitor(fields[1], value.frame_angle_roll);
    visitor(fields[2], value.frame_angle_pitch);
  }
};

template <>
struct Meta<msg::HelperDataExt> {
  static constexpr MessageInfo info{
      .name = "HelperDataExt", .command = "CMD_HELPER_DATA",
      .summary = "Report acceleration, tilt and rotation of the frame to the board.", .id = 72,
      .direction = Direction::to_board, .min_size = 20, .max_size = 20, .since = {.firmware = 2590},
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
  static constexpr Range frame_heading_range{-16384, 16384};
  static constexpr Special frame_heading_special[] = {
      {32767, "stops the correction of the heading"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "frame_acc", .spec_name = "FRAME_ACC",
       .summary = "Linear acceleration of the frame; keeps the horizon level during acceleration.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::by_axis},
      {.name = "frame_angle_roll", .spec_name = "FRAME_ANGLE_ROLL",
       .summary = "Sideways tilt of the frame.", .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_roll_range, .special = frame_angle_roll_special,
       .directed = Directed::unknown},
      {.name = "frame_angle_pitch", .spec_name = "FRAME_ANGLE_PITCH",
       .summary = "Forward tilt of the frame.", .unit = &UnitMeta<msg::Angle14>::info,
       .range = &frame_angle_pitch_range, .special = frame_angle_pitch_special,
       .directed = Directed::unknown},
      {.name = "coord_sys", .spec_name = "COORD_SYS",
       .summary = "Coordinate system of all the vectors, and options."},
      {.name = "frame_speed", .spec_name = "FRAME_SPEED",
       .summary = "Angular speed of the frame; useful without encoders and a second IMU.",
       .unit = &UnitMeta<msg::GyroRate>::info, .special = frame_speed_special,
       .directed = Directed::by_axis},
      {.name = "frame_heading", .spec_name = "FRAME_HEADING",
       .summary = "Heading of the frame; used with USE_FRAME_HEADING.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &frame_heading_range,
       .special = frame_heading_special, .directed = Directed::by_axis, .since = {.firmware = 2627}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, frame_acc), &detail::value_type<decltype(T::frame_acc)>},
      {offsetof(T, frame_angle_roll), &detail::value_type<decltype(T::frame_angle_roll)>},
      {offsetof(T, frame_angle_pitch), &detail::value_type<decltype(T::frame_angle_pitch)>},
      {offsetof(T, coord_sys), &detail::value_type<decltype(T::coord_sys)>},
      {offsetof(T, frame_speed), &detail::value_type<decltype(T::frame_speed)>},
      {offsetof(T, frame_heading), &detail::value_type<decltype(T::frame_heading)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.frame_acc);
    visitor(fields[1], value.frame_angle_roll);
    visitor(fields[2], value.frame_angle_pitch);
    visitor(fields[3], value.coord_sys);
    visitor(fields[4], value.frame_speed);
    visitor(fields[5], value.frame_heading);
    visitor(fields[6], value.reserved);
  }
};

}  // namespace sbgc
