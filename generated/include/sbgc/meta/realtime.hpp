// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/realtime.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>
#include <sbgc/meta/imu.hpp>

namespace sbgc {

template <>
struct Meta<msg::AxisSensors> {
  static constexpr FieldInfo fields[] = {
      {.name = "acc_data", .spec_name = "ACC_DATA", .summary = "Accelerometer.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::unknown},
      {.name = "gyro_data", .spec_name = "GYRO_DATA", .summary = "Gyroscope.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::unknown},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, acc_data), &detail::value_type<decltype(T::acc_data)>},
      {offsetof(T, gyro_data), &detail::value_type<decltype(T::gyro_data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.acc_data);
    visitor(fields[1], value.gyro_data);
  }
};

template <>
struct Meta<msg::Motor4Control> {
  static constexpr FieldInfo fields[] = {
      {.name = "ff_speed", .spec_name = "FF_SPEED", .summary = "Feed-forward speed.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::by_axis},
      {.name = "angle_error", .spec_name = "ANGLE_ERROR", .summary = "Error of the angle.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "pid_out", .spec_name = "PID_OUT", .summary = "Output of the PID controller."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, ff_speed), &detail::value_type<decltype(T::ff_speed)>},
      {offsetof(T, angle_error), &detail::value_type<decltype(T::angle_error)>},
      {offsetof(T, pid_out), &detail::value_type<decltype(T::pid_out)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.ff_speed);
    visitor(fields[1], value.angle_error);
    visitor(fields[2], value.pid_out);
  }
};

template <>
struct Meta<msg::MotorPowerState> {
  static constexpr Range mot_power_range{-10000, 10000};
  static constexpr FieldInfo fields[] = {
      {.name = "mot_power", .spec_name = "MOT_POWER",
       .summary = "Output of the motor; 10000 is full power.", .range = &mot_power_range},
      {.name = "mot_current", .spec_name = "MOT_CURRENT", .summary = "Current of the motor.",
       .unit = &UnitMeta<msg::Current>::info},
      {.name = "mot_temp", .spec_name = "MOT_TEMP", .summary = "Temperature of the motor.",
       .unit = &UnitMeta<msg::Temperature>::info},
      {.name = "mot_flags", .spec_name = "MOT_FLAGS", .summary = "State of the motor."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mot_power), &detail::value_type<decltype(T::mot_power)>},
      {offsetof(T, mot_current), &detail::value_type<decltype(T::mot_current)>},
      {offsetof(T, mot_temp), &detail::value_type<decltype(T::mot_temp)>},
      {offsetof(T, mot_flags), &detail::value_type<decltype(T::mot_flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mot_power);
    visitor(fields[1], value.mot_current);
    visitor(fields[2], value.mot_temp);
    visitor(fields[3], value.mot_flags);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::SystemPowerState> {
  static constexpr FieldInfo fields[] = {
      {.name = "motors", .spec_name = "motors", .summary = "State of each motor."},
      {.name = "state", .spec_name = "STATE", .summary = "State of the motor power."},
      {.name = "battery_voltage", .spec_name = "BATTERY_VOLTAGE", .summary = "Battery voltage.",
       .unit = &UnitMeta<msg::Voltage>::info},
      {.name = "total_current", .spec_name = "TOTAL_CURRENT",
       .summary = "Current of the whole system.", .unit = &UnitMeta<msg::Current>::info},
      {.name = "system_flags", .spec_name = "SYSTEM_FLAGS",
       .summary = "Problems with the motors or their drivers."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, motors), &detail::value_type<decltype(T::motors)>},
      {offsetof(T, state), &detail::value_type<decltype(T::state)>},
      {offsetof(T, battery_voltage), &detail::value_type<decltype(T::battery_voltage)>},
      {offsetof(T, total_current), &detail::value_type<decltype(T::total_current)>},
      {offsetof(T, system_flags), &detail::value_type<decltype(T::system_flags)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.motors);
    visitor(fields[1], value.state);
    visitor(fields[2], value.battery_voltage);
    visitor(fields[3], value.total_current);
    visitor(fields[4], value.system_flags);
  }
};

template <>
struct Meta<msg::CommErrors> {
  static constexpr FieldInfo fields[] = {
      {.name = "i2c_errors", .spec_name = "I2C_ERRORS",
       .summary = "Number of errors on the I2C bus."},
      {.name = "serial_errors", .spec_name = "SERIAL_ERRORS",
       .summary = "Number of errors on the serial line."},
      {.name = "can_errors", .spec_name = "CAN_ERRORS",
       .summary = "Number of errors on the CAN bus."},
      {.name = "can_err_flags", .spec_name = "CAN_ERR_FLAGS", .summary = "State of the CAN bus."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, i2c_errors), &detail::value_type<decltype(T::i2c_errors)>},
      {offsetof(T, serial_errors), &detail::value_type<decltype(T::serial_errors)>},
      {offsetof(T, can_errors), &detail::value_type<decltype(T::can_errors)>},
      {offsetof(T, can_err_flags), &detail::value_type<decltype(T::can_err_flags)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.i2c_errors);
    visitor(fields[1], value.serial_errors);
    visitor(fields[2], value.can_errors);
    visitor(fields[3], value.can_err_flags);
  }
};

template <>
struct Meta<msg::SystemStatus> {
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "State of the system."},
      {.name = "calib_mode", .spec_name = "CALIB_MODE",
       .summary = "Calibration or other task that is running."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, calib_mode), &detail::value_type<decltype(T::calib_mode)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.calib_mode);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::SoftLimitDistances> {
  static constexpr Special dist_special[] = {
      {32767, "not set or unknown"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "dist", .spec_name = "DIST",
       .summary = "Distances to the lower and the upper limit: positive inside, negative outside of it.",
       .unit = &UnitMeta<msg::Angle14>::info, .special = dist_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, dist), &detail::value_type<decltype(T::dist)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.dist);
  }
};

template <>
struct Meta<msg::MainImuState> {
  static constexpr FieldInfo fields[] = {
      {.name = "g_ref_error", .spec_name = "G_REF_ERROR",
       .summary = "Angle between the estimated and the reference gravity vector.",
       .unit = &UnitMeta<msg::AngleError>::info, .unconfirmed = true},
      {.name = "h_ref_error", .spec_name = "H_REF_ERROR",
       .summary = "Angle between the estimated and the reference heading vector.",
       .unit = &UnitMeta<msg::AngleError>::info, .unconfirmed = true},
      {.name = "flags", .spec_name = "FLAGS", .summary = "Flags that no source explains."},
      {.name = "ext_sensor_error", .spec_name = "EXT_SENSOR_ERROR",
       .summary = "Errors of an external sensor."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, g_ref_error), &detail::value_type<decltype(T::g_ref_error)>},
      {offsetof(T, h_ref_error), &detail::value_type<decltype(T::h_ref_error)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, ext_sensor_error), &detail::value_type<decltype(T::ext_sensor_error)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.g_ref_error);
    visitor(fields[1], value.h_ref_error);
    visitor(fields[2], value.flags);
    visitor(fields[3], value.ext_sensor_error);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::PinStates> {
  static constexpr FieldInfo fields[] = {
      {.name = "extra_buttons_state", .spec_name = "EXTRA_BUTTONS_STATE",
       .summary = "State of additional buttons."},
      {.name = "pin_state", .spec_name = "PIN_STATE", .summary = "State of the pins."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, extra_buttons_state), &detail::value_type<decltype(T::extra_buttons_state)>},
      {offsetof(T, pin_state), &detail::value_type<decltype(T::pin_state)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.extra_buttons_state);
    visitor(fields[1], value.pin_state);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::StreamConfig> {
  static constexpr Range drv_id_range{0, 6};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "Blocks to send."},
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "IMU whose attitude to send.",
       .unconfirmed = true},
      {.name = "event_id", .spec_name = "EVENT_ID", .summary = "Event to report."},
      {.name = "event_type", .spec_name = "EVENT_TYPE", .summary = "Kinds of the event to report."},
      {.name = "telemetry_flags", .spec_name = "FLAGS", .summary = "Data to send."},
      {.name = "drv_id", .spec_name = "DRV_ID", .summary = "CAN motor driver whose data to send.",
       .range = &drv_id_range},
      {.name = "motor", .spec_name = "MOTOR", .summary = "External motor whose state to send."},
      {.name = "data_set", .spec_name = "DATA_SET", .summary = "Data to send."},
      {.name = "custom2_flags", .spec_name = "FLAGS", .summary = "Blocks to send."},
      {.name = "rest", .spec_name = "",
       .summary = "What is not used of the 8 bytes; filled up with zeros.", .reserved = true,
       .optional = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, event_id), &detail::value_type<decltype(T::event_id)>},
      {offsetof(T, event_type), &detail::value_type<decltype(T::event_type)>},
      {offsetof(T, telemetry_flags), &detail::value_type<decltype(T::telemetry_flags)>},
      {offsetof(T, drv_id), &detail::value_type<decltype(T::drv_id)>},
      {offsetof(T, motor), &detail::value_type<decltype(T::motor)>},
      {offsetof(T, data_set), &detail::value_type<decltype(T::data_set)>},
      {offsetof(T, custom2_flags), &detail::value_type<decltype(T::custom2_flags)>},
      {offsetof(T, rest), &detail::value_type<decltype(T::rest)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.imu_type);
    visitor(fields[2], value.event_id);
    visitor(fields[3], value.event_type);
    visitor(fields[4], value.telemetry_flags);
    visitor(fields[5], value.drv_id);
    visitor(fields[6], value.motor);
    visitor(fields[7], value.data_set);
    visitor(fields[8], value.custom2_flags);
    visitor(fields[9], value.rest);
  }
};

template <>
struct Meta<msg::RealtimeData> {
  static constexpr const char* answers[] = {"RealtimeData3"};
  static constexpr MessageInfo info{
      .name = "RealtimeData", .command = "CMD_REALTIME_DATA",
      .summary = "Request live data, with the older id.", .id = 68, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::RealtimeData3> {
  static constexpr MessageInfo info{
      .name = "RealtimeData3", .command = "CMD_REALTIME_DATA_3", .summary = "Live data.", .id = 23,
      .direction = Direction::from_board, .min_size = 63, .max_size = 63, .since = {.board = 30}};
  static constexpr Range rc_range{1000, 2000};
  static constexpr Special rc_special[] = {
      {-10000, "no signal"},
  };
  static constexpr Range rc_cmd_range{1000, 2000};
  static constexpr Special rc_cmd_special[] = {
      {-10000, "no signal"},
  };
  static constexpr Range ext_fc_roll_range{1000, 2000};
  static constexpr Special ext_fc_roll_special[] = {
      {0, "the input serves RC control or commands"},
      {-10000, "no signal"},
  };
  static constexpr Range ext_fc_pitch_range{1000, 2000};
  static constexpr Special ext_fc_pitch_special[] = {
      {0, "the input serves RC control or commands"},
      {-10000, "no signal"},
  };
  static constexpr Range angle_range{-32768, 32767};
  static constexpr Range frame_imu_angle_range{-32768, 32767};
  static constexpr Range rc_angle_range{-32768, 32767};
  static constexpr Range cur_profile_range{0, 4};
  static constexpr FieldInfo fields[] = {
      {.name = "axes", .spec_name = "axes", .summary = "Sensors of each axis."},
      {.name = "serial_error_cnt", .spec_name = "SERIAL_ERROR_CNT",
       .summary = "Number of errors on the serial line."},
      {.name = "system_error", .spec_name = "SYSTEM_ERROR",
       .summary = "Current errors; 0 if there are none."},
      {.name = "system_sub_error", .spec_name = "SYSTEM_SUB_ERROR",
       .summary = "Reason for an emergency stop."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "rc", .spec_name = "RC_{AXIS}", .summary = "RC channels of the axes.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &rc_range, .special = rc_special},
      {.name = "rc_cmd", .spec_name = "RC_CMD", .summary = "RC command channel.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &rc_cmd_range, .special = rc_cmd_special},
      {.name = "ext_fc_roll", .spec_name = "EXT_FC_ROLL",
       .summary = "Roll signal of an external flight controller.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &ext_fc_roll_range,
       .special = ext_fc_roll_special},
      {.name = "ext_fc_pitch", .spec_name = "EXT_FC_PITCH",
       .summary = "Pitch signal of an external flight controller.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &ext_fc_pitch_range,
       .special = ext_fc_pitch_special},
      {.name = "angle", .spec_name = "ANGLE_{AXIS}", .summary = "Camera angles.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &angle_range, .directed = Directed::by_axis},
      {.name = "frame_imu_angle", .spec_name = "FRAME_IMU_ANGLE_{AXIS}",
       .summary = "Frame angles, from the second IMU if present.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &frame_imu_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_angle", .spec_name = "RC_ANGLE_{AXIS}", .summary = "Target angles from RC.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &rc_angle_range,
       .directed = Directed::by_axis},
      {.name = "cycle_time", .spec_name = "CYCLE_TIME", .summary = "Duration of one control cycle.",
       .unit = &UnitMeta<msg::Microseconds>::info},
      {.name = "i2c_error_count", .spec_name = "I2C_ERROR_COUNT",
       .summary = "Number of errors on the I2C bus."},
      {.name = "error_code", .spec_name = "ERROR_CODE", .summary = "Predecessor of SYSTEM_ERROR."},
      {.name = "bat_level", .spec_name = "BAT_LEVEL", .summary = "Battery voltage.",
       .unit = &UnitMeta<msg::Voltage>::info},
      {.name = "other_flags", .spec_name = "OTHER_FLAGS", .summary = "State of the motors."},
      {.name = "cur_imu", .spec_name = "CUR_IMU", .summary = "Selected IMU.", .since = {.board = 30}},
      {.name = "cur_profile", .spec_name = "CUR_PROFILE", .summary = "Active profile.",
       .range = &cur_profile_range},
      {.name = "motor_power", .spec_name = "MOTOR_POWER_{AXIS}", .summary = "Power of each motor."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, serial_error_cnt), &detail::value_type<decltype(T::serial_error_cnt)>},
      {offsetof(T, system_error), &detail::value_type<decltype(T::system_error)>},
      {offsetof(T, system_sub_error), &detail::value_type<decltype(T::system_sub_error)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
      {offsetof(T, rc), &detail::value_type<decltype(T::rc)>},
      {offsetof(T, rc_cmd), &detail::value_type<decltype(T::rc_cmd)>},
      {offsetof(T, ext_fc_roll), &detail::value_type<decltype(T::ext_fc_roll)>},
      {offsetof(T, ext_fc_pitch), &detail::value_type<decltype(T::ext_fc_pitch)>},
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
      {offsetof(T, frame_imu_angle), &detail::value_type<decltype(T::frame_imu_angle)>},
      {offsetof(T, rc_angle), &detail::value_type<decltype(T::rc_angle)>},
      {offsetof(T, cycle_time), &detail::value_type<decltype(T::cycle_time)>},
      {offsetof(T, i2c_error_count), &detail::value_type<decltype(T::i2c_error_count)>},
      {offsetof(T, error_code), &detail::value_type<decltype(T::error_code)>},
      {offsetof(T, bat_level), &detail::value_type<decltype(T::bat_level)>},
      {offsetof(T, other_flags), &detail::value_type<decltype(T::other_flags)>},
      {offsetof(T, cur_imu), &detail::value_type<decltype(T::cur_imu)>},
      {offsetof(T, cur_profile), &detail::value_type<decltype(T::cur_profile)>},
      {offsetof(T, motor_power), &detail::value_type<decltype(T::motor_power)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axes);
    visitor(fields[1], value.serial_error_cnt);
    visitor(fields[2], value.system_error);
    visitor(fields[3], value.system_sub_error);
    visitor(fields[4], value.reserved);
    visitor(fields[5], value.rc);
    visitor(fields[6], value.rc_cmd);
    visitor(fields[7], value.ext_fc_roll);
    visitor(fields[8], value.ext_fc_pitch);
    visitor(fields[9], value.angle);
    visitor(fields[10], value.frame_imu_angle);
    visitor(fields[11], value.rc_angle);
    visitor(fields[12], value.cycle_time);
    visitor(fields[13], value.i2c_error_count);
    visitor(fields[14], value.error_code);
    visitor(fields[15], value.bat_level);
    visitor(fields[16], value.other_flags);
    visitor(fields[17], value.cur_imu);
    visitor(fields[18], value.cur_profile);
    visitor(fields[19], value.motor_power);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::RealtimeData3Request> {
  static constexpr const char* answers[] = {"RealtimeData3"};
  static constexpr MessageInfo info{
      .name = "RealtimeData3Request", .command = "CMD_REALTIME_DATA_3",
      .summary = "Request live data.", .id = 23, .direction = Direction::to_board, .min_size = 0,
      .max_size = 0, .since = {.board = 30}, .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::RealtimeData4> {
  static constexpr MessageInfo info{
      .name = "RealtimeData4", .command = "CMD_REALTIME_DATA_4",
      .summary = "Live data with joint angles, currents and temperatures.", .id = 25,
      .direction = Direction::from_board, .min_size = 124, .max_size = 124, .since = {.board = 30}};
  static constexpr Range rc_range{1000, 2000};
  static constexpr Special rc_special[] = {
      {-10000, "no signal"},
  };
  static constexpr Range rc_cmd_range{1000, 2000};
  static constexpr Special rc_cmd_special[] = {
      {-10000, "no signal"},
  };
  static constexpr Range ext_fc_roll_range{1000, 2000};
  static constexpr Special ext_fc_roll_special[] = {
      {0, "the input serves RC control or commands"},
      {-10000, "no signal"},
  };
  static constexpr Range ext_fc_pitch_range{1000, 2000};
  static constexpr Special ext_fc_pitch_special[] = {
      {0, "the input serves RC control or commands"},
      {-10000, "no signal"},
  };
  static constexpr Range angle_range{-32768, 32767};
  static constexpr Range frame_imu_angle_range{-32768, 32767};
  static constexpr Range rc_angle_range{-32768, 32767};
  static constexpr Range cur_profile_range{0, 4};
  static constexpr Range balance_error_range{-512, 512};
  static constexpr Range imu_temperature_range{-127, 127};
  static constexpr Range frame_imu_temperature_range{-127, 127};
  static constexpr Range imu_g_err_range{0, 255};
  static constexpr Range imu_h_err_range{0, 255};
  static constexpr Range motor_out_range{-10000, 10000};
  static constexpr FieldInfo fields[] = {
      {.name = "axes", .spec_name = "axes", .summary = "Sensors of each axis."},
      {.name = "serial_error_cnt", .spec_name = "SERIAL_ERROR_CNT",
       .summary = "Number of errors on the serial line."},
      {.name = "system_error", .spec_name = "SYSTEM_ERROR",
       .summary = "Current errors; 0 if there are none."},
      {.name = "system_sub_error", .spec_name = "SYSTEM_SUB_ERROR",
       .summary = "Reason for an emergency stop."},
      {.name = "reserved_1", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "rc", .spec_name = "RC_{AXIS}", .summary = "RC channels of the axes.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &rc_range, .special = rc_special},
      {.name = "rc_cmd", .spec_name = "RC_CMD", .summary = "RC command channel.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &rc_cmd_range, .special = rc_cmd_special},
      {.name = "ext_fc_roll", .spec_name = "EXT_FC_ROLL",
       .summary = "Roll signal of an external flight controller.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &ext_fc_roll_range,
       .special = ext_fc_roll_special},
      {.name = "ext_fc_pitch", .spec_name = "EXT_FC_PITCH",
       .summary = "Pitch signal of an external flight controller.",
       .unit = &UnitMeta<msg::RcSignal>::info, .range = &ext_fc_pitch_range,
       .special = ext_fc_pitch_special},
      {.name = "angle", .spec_name = "ANGLE_{AXIS}", .summary = "Camera angles.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &angle_range, .directed = Directed::by_axis},
      {.name = "frame_imu_angle", .spec_name = "FRAME_IMU_ANGLE_{AXIS}",
       .summary = "Frame angles, from the second IMU if present.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &frame_imu_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_angle", .spec_name = "RC_ANGLE_{AXIS}", .summary = "Target angles from RC.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &rc_angle_range,
       .directed = Directed::by_axis},
      {.name = "cycle_time", .spec_name = "CYCLE_TIME", .summary = "Duration of one control cycle.",
       .unit = &UnitMeta<msg::Microseconds>::info},
      {.name = "i2c_error_count", .spec_name = "I2C_ERROR_COUNT",
       .summary = "Number of errors on the I2C bus."},
      {.name = "error_code", .spec_name = "ERROR_CODE", .summary = "Predecessor of SYSTEM_ERROR."},
      {.name = "bat_level", .spec_name = "BAT_LEVEL", .summary = "Battery voltage.",
       .unit = &UnitMeta<msg::Voltage>::info},
      {.name = "other_flags", .spec_name = "OTHER_FLAGS", .summary = "State of the motors."},
      {.name = "cur_imu", .spec_name = "CUR_IMU", .summary = "Selected IMU.", .since = {.board = 30}},
      {.name = "cur_profile", .spec_name = "CUR_PROFILE", .summary = "Active profile.",
       .range = &cur_profile_range},
      {.name = "motor_power", .spec_name = "MOTOR_POWER_{AXIS}", .summary = "Power of each motor."},
      {.name = "rotor_angle", .spec_name = "ROTOR_ANGLE",
       .summary = "Angle of each joint, from an encoder, the second IMU or an estimate; 0 in the normal position.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "reserved_2", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "balance_error", .spec_name = "BALANCE_ERROR",
       .summary = "Motor power lost to imbalance.", .unit = &UnitMeta<msg::BalanceError>::info,
       .range = &balance_error_range},
      {.name = "current", .spec_name = "CURRENT", .summary = "Current drawn by the board.",
       .unit = &UnitMeta<msg::Current>::info},
      {.name = "mag_data", .spec_name = "MAG_DATA", .summary = "Raw magnetometer data."},
      {.name = "imu_temperature", .spec_name = "IMU_TEMPERATURE",
       .summary = "Temperature of the main IMU.", .unit = &UnitMeta<msg::Temperature>::info,
       .range = &imu_temperature_range},
      {.name = "frame_imu_temperature", .spec_name = "FRAME_IMU_TEMPERATURE",
       .summary = "Temperature of the frame IMU.", .unit = &UnitMeta<msg::Temperature>::info,
       .range = &frame_imu_temperature_range},
      {.name = "imu_g_err", .spec_name = "IMU_G_ERR",
       .summary = "Angle between the estimated and the reference gravity vector.",
       .unit = &UnitMeta<msg::AngleError>::info, .range = &imu_g_err_range},
      {.name = "imu_h_err", .spec_name = "IMU_H_ERR",
       .summary = "Angle between the estimated and the reference heading vector.",
       .unit = &UnitMeta<msg::AngleError>::info, .range = &imu_h_err_range},
      {.name = "motor_out", .spec_name = "MOTOR_OUT",
       .summary = "Output of each motor; 10000 is full power.", .range = &motor_out_range,
       .since = {.firmware = 2610}},
      {.name = "calib_mode", .spec_name = "CALIB_MODE",
       .summary = "Calibration or other task that is running.", .since = {.firmware = 2610}},
      {.name = "can_imu_ext_sens_err", .spec_name = "CAN_IMU_EXT_SENS_ERR",
       .summary = "Errors of the external sensor of a CAN IMU.", .since = {.firmware = 2610}},
      {.name = "actual_angle", .spec_name = "ACTUAL_ANGLE",
       .summary = "Actual angles of the camera.", .unit = &UnitMeta<msg::Angle14>::info,
       .directed = Directed::by_axis, .since = {.firmware = 2720}},
      {.name = "system_state_flags", .spec_name = "SYSTEM_STATE_FLAGS",
       .summary = "State of the system.", .since = {.firmware = 2730}},
      {.name = "reserved_3", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, serial_error_cnt), &detail::value_type<decltype(T::serial_error_cnt)>},
      {offsetof(T, system_error), &detail::value_type<decltype(T::system_error)>},
      {offsetof(T, system_sub_error), &detail::value_type<decltype(T::system_sub_error)>},
      {offsetof(T, reserved_1), &detail::value_type<decltype(T::reserved_1)>},
      {offsetof(T, rc), &detail::value_type<decltype(T::rc)>},
      {offsetof(T, rc_cmd), &detail::value_type<decltype(T::rc_cmd)>},
      {offsetof(T, ext_fc_roll), &detail::value_type<decltype(T::ext_fc_roll)>},
      {offsetof(T, ext_fc_pitch), &detail::value_type<decltype(T::ext_fc_pitch)>},
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
      {offsetof(T, frame_imu_angle), &detail::value_type<decltype(T::frame_imu_angle)>},
      {offsetof(T, rc_angle), &detail::value_type<decltype(T::rc_angle)>},
      {offsetof(T, cycle_time), &detail::value_type<decltype(T::cycle_time)>},
      {offsetof(T, i2c_error_count), &detail::value_type<decltype(T::i2c_error_count)>},
      {offsetof(T, error_code), &detail::value_type<decltype(T::error_code)>},
      {offsetof(T, bat_level), &detail::value_type<decltype(T::bat_level)>},
      {offsetof(T, other_flags), &detail::value_type<decltype(T::other_flags)>},
      {offsetof(T, cur_imu), &detail::value_type<decltype(T::cur_imu)>},
      {offsetof(T, cur_profile), &detail::value_type<decltype(T::cur_profile)>},
      {offsetof(T, motor_power), &detail::value_type<decltype(T::motor_power)>},
      {offsetof(T, rotor_angle), &detail::value_type<decltype(T::rotor_angle)>},
      {offsetof(T, reserved_2), &detail::value_type<decltype(T::reserved_2)>},
      {offsetof(T, balance_error), &detail::value_type<decltype(T::balance_error)>},
      {offsetof(T, current), &detail::value_type<decltype(T::current)>},
      {offsetof(T, mag_data), &detail::value_type<decltype(T::mag_data)>},
      {offsetof(T, imu_temperature), &detail::value_type<decltype(T::imu_temperature)>},
      {offsetof(T, frame_imu_temperature), &detail::value_type<decltype(T::frame_imu_temperature)>},
      {offsetof(T, imu_g_err), &detail::value_type<decltype(T::imu_g_err)>},
      {offsetof(T, imu_h_err), &detail::value_type<decltype(T::imu_h_err)>},
      {offsetof(T, motor_out), &detail::value_type<decltype(T::motor_out)>},
      {offsetof(T, calib_mode), &detail::value_type<decltype(T::calib_mode)>},
      {offsetof(T, can_imu_ext_sens_err), &detail::value_type<decltype(T::can_imu_ext_sens_err)>},
      {offsetof(T, actual_angle), &detail::value_type<decltype(T::actual_angle)>},
      {offsetof(T, system_state_flags), &detail::value_type<decltype(T::system_state_flags)>},
      {offsetof(T, reserved_3), &detail::value_type<decltype(T::reserved_3)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axes);
    visitor(fields[1], value.serial_error_cnt);
    visitor(fields[2], value.system_error);
    visitor(fields[3], value.system_sub_error);
    visitor(fields[4], value.reserved_1);
    visitor(fields[5], value.rc);
    visitor(fields[6], value.rc_cmd);
    visitor(fields[7], value.ext_fc_roll);
    visitor(fields[8], value.ext_fc_pitch);
    visitor(fields[9], value.angle);
    visitor(fields[10], value.frame_imu_angle);
    visitor(fields[11], value.rc_angle);
    visitor(fields[12], value.cycle_time);
    visitor(fields[13], value.i2c_error_count);
    visitor(fields[14], value.error_code);
    visitor(fields[15], value.bat_level);
    visitor(fields[16], value.other_flags);
    visitor(fields[17], value.cur_imu);
    visitor(fields[18], value.cur_profile);
    visitor(fields[19], value.motor_power);
    visitor(fields[20], value.rotor_angle);
    visitor(fields[21], value.reserved_2);
    visitor(fields[22], value.balance_error);
    visitor(fields[23], value.current);
    visitor(fields[24], value.mag_data);
    visitor(fields[25], value.imu_temperature);
    visitor(fields[26], value.frame_imu_temperature);
    visitor(fields[27], value.imu_g_err);
    visitor(fields[28], value.imu_h_err);
    visitor(fields[29], value.motor_out);
    visitor(fields[30], value.calib_mode);
    visitor(fields[31], value.can_imu_ext_sens_err);
    visitor(fields[32], value.actual_angle);
    visitor(fields[33], value.system_state_flags);
    visitor(fields[34], value.reserved_3);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::RealtimeData4Request> {
  static constexpr const char* answers[] = {"RealtimeData4"};
  static constexpr MessageInfo info{
      .name = "RealtimeData4Request", .command = "CMD_REALTIME_DATA_4",
      .summary = "Request the longer live data.", .id = 25, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::RealtimeDataCustom> {
  static constexpr MessageInfo info{
      .name = "RealtimeDataCustom", .command = "CMD_REALTIME_DATA_CUSTOM",
      .summary = "Live data of the requested blocks.", .id = 88, .direction = Direction::from_board,
      .min_size = 2, .max_size = 255, .since = {.firmware = 2590, .board = 30}};
  static constexpr Range rc_data_range{-16384, 16384};
  static constexpr Special rc_data_special[] = {
      {-32768, "undefined"},
  };
  static constexpr Range z1_vector_range{-1, 1};
  static constexpr Range h1_vector_range{-1, 1};
  static constexpr Range rc_channels_range{-16384, 16384};
  static constexpr Special rc_channels_special[] = {
      {-32768, "undefined"},
  };
  static constexpr Range adc_ch_raw_range{0, 4096};
  static constexpr FieldInfo fields[] = {
      {.name = "timestamp_ms", .spec_name = "TIMESTAMP_MS", .summary = "Time of the sample.",
       .unit = &UnitMeta<msg::MillisecondClock>::info},
      {.name = "flags", .spec_name = "FLAGS", .summary = "FLAGS of the request."},
      {.name = "imu_angles", .spec_name = "IMU_ANGLES", .summary = "Angles of the main IMU (Euler).",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "target_angles", .spec_name = "TARGET_ANGLES", .summary = "Target angles (Euler).",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "target_speed", .spec_name = "TARGET_SPEED",
       .summary = "Target speeds over the Euler axes.", .unit = &UnitMeta<msg::GyroRate>::info,
       .directed = Directed::by_axis},
      {.name = "stator_rotor_angle", .spec_name = "STATOR_ROTOR_ANGLE", .summary = "Joint angles.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::by_axis},
      {.name = "gyro_data", .spec_name = "GYRO_DATA", .summary = "Gyroscope after calibration.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::unknown},
      {.name = "rc_data", .spec_name = "RC_DATA",
       .summary = "RC signals of the inputs ROLL, PITCH, YAW, CMD, FC_ROLL, FC_PITCH.",
       .unit = &UnitMeta<msg::FineRcSignal>::info, .range = &rc_data_range,
       .special = rc_data_special},
      {.name = "z1_vector", .spec_name = "Z1_VECTOR",
       .summary = "Gravity row of the rotation matrix.", .range = &z1_vector_range},
      {.name = "h1_vector", .spec_name = "H1_VECTOR",
       .summary = "Heading row of the rotation matrix; the cross product of both rows is the third.",
       .range = &h1_vector_range},
      {.name = "rc_channels", .spec_name = "RC_CHANNELS", .summary = "All captured RC channels.",
       .unit = &UnitMeta<msg::FineRcSignal>::info, .range = &rc_channels_range,
       .special = rc_channels_special},
      {.name = "acc_data", .spec_name = "ACC_DATA", .summary = "Accelerometer after calibration.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::unknown},
      {.name = "motor4_control", .spec_name = "MOTOR4_CONTROL",
       .summary = "Control of a fourth motor."},
      {.name = "ahrs_debug_info", .spec_name = "AHRS_DEBUG_INFO",
       .summary = "State of the attitude estimation."},
      {.name = "encoder_raw24", .spec_name = "ENCODER_RAW24",
       .summary = "Raw values of the encoders.", .unconfirmed = true},
      {.name = "imu_angles_rad", .spec_name = "IMU_ANGLES_RAD",
       .summary = "Angles of the main IMU (Euler), in radians.",
       .unit = &UnitMeta<msg::Radians>::info, .directed = Directed::by_axis},
      {.name = "script_vars_float", .spec_name = "SCRIPT_VARS_FLOAT",
       .summary = "Floating-point variables of the script."},
      {.name = "script_vars_int16", .spec_name = "SCRIPT_VARS_INT16",
       .summary = "Integer variables of the script."},
      {.name = "system_power_state", .spec_name = "SYSTEM_POWER_STATE",
       .summary = "State of the motors and of the supply."},
      {.name = "frame_cam_rate", .spec_name = "FRAME_CAM_RATE",
       .summary = "Speed of the camera relative to the frame.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::unknown},
      {.name = "imu_angles_20", .spec_name = "IMU_ANGLES_20",
       .summary = "Angles of the main IMU (Euler), in high resolution.",
       .unit = &UnitMeta<msg::Angle20>::info, .directed = Directed::by_axis},
      {.name = "target_angles_20", .spec_name = "TARGET_ANGLES_20",
       .summary = "Target angles (Euler), in high resolution.",
       .unit = &UnitMeta<msg::Angle20>::info, .directed = Directed::by_axis},
      {.name = "comm_errors", .spec_name = "COMM_ERRORS",
       .summary = "Counters of communication errors."},
      {.name = "system_state", .spec_name = "SYSTEM_STATE", .summary = "State of the system."},
      {.name = "imu_quat", .spec_name = "IMU_QUAT", .summary = "Attitude of the main IMU."},
      {.name = "target_quat", .spec_name = "TARGET_QUAT",
       .summary = "Target attitude; only of Extended boards that CMD_CONTROL_QUAT controls."},
      {.name = "imu_to_frame_quat", .spec_name = "IMU_TO_FRAME_QUAT",
       .summary = "Rotation from the main IMU to the frame."},
      {.name = "adc_ch_raw", .spec_name = "ADC_CH_RAW",
       .summary = "Raw values of the analog inputs, averaged over 8 ms.", .range = &adc_ch_raw_range},
      {.name = "sw_limits_dist", .spec_name = "SW_LIMITS_DIST",
       .summary = "Distances to the software limits, in Euler axes or, in servo mode, in those of the motors; imprecise for large angles."},
      {.name = "follow_dist", .spec_name = "FOLLOW_DIST",
       .summary = "Distance to the neutral point of the follow mode, or 0 without it.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::unknown},
      {.name = "ext_target_limit_min", .spec_name = "EXT_TARGET_LIMIT_MIN",
       .summary = "Lower limits of an external target, such as an angle of CMD_CONTROL, in follow mode as well; if both are 0, there are none.",
       .unit = &UnitMeta<msg::LongAngle14>::info, .directed = Directed::by_axis, .unconfirmed = true},
      {.name = "ext_target_limit_max", .spec_name = "EXT_TARGET_LIMIT_MAX",
       .summary = "Upper limits of an external target.", .unit = &UnitMeta<msg::LongAngle14>::info,
       .directed = Directed::by_axis, .unconfirmed = true},
      {.name = "frame_cam_angle_20", .spec_name = "FRAME_CAM_ANGLE_20",
       .summary = "Joint angles, in high resolution.", .unit = &UnitMeta<msg::Angle20>::info,
       .directed = Directed::by_axis},
      {.name = "main_imu_state", .spec_name = "MAIN_IMU_STATE", .summary = "State of the main IMU."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, timestamp_ms), &detail::value_type<decltype(T::timestamp_ms)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, imu_angles), &detail::value_type<decltype(T::imu_angles)>},
      {offsetof(T, target_angles), &detail::value_type<decltype(T::target_angles)>},
      {offsetof(T, target_speed), &detail::value_type<decltype(T::target_speed)>},
      {offsetof(T, stator_rotor_angle), &detail::value_type<decltype(T::stator_rotor_angle)>},
      {offsetof(T, gyro_data), &detail::value_type<decltype(T::gyro_data)>},
      {offsetof(T, rc_data), &detail::value_type<decltype(T::rc_data)>},
      {offsetof(T, z1_vector), &detail::value_type<decltype(T::z1_vector)>},
      {offsetof(T, h1_vector), &detail::value_type<decltype(T::h1_vector)>},
      {offsetof(T, rc_channels), &detail::value_type<decltype(T::rc_channels)>},
      {offsetof(T, acc_data), &detail::value_type<decltype(T::acc_data)>},
      {offsetof(T, motor4_control), &detail::value_type<decltype(T::motor4_control)>},
      {offsetof(T, ahrs_debug_info), &detail::value_type<decltype(T::ahrs_debug_info)>},
      {offsetof(T, encoder_raw24), &detail::value_type<decltype(T::encoder_raw24)>},
      {offsetof(T, imu_angles_rad), &detail::value_type<decltype(T::imu_angles_rad)>},
      {offsetof(T, script_vars_float), &detail::value_type<decltype(T::script_vars_float)>},
      {offsetof(T, script_vars_int16), &detail::value_type<decltype(T::script_vars_int16)>},
      {offsetof(T, system_power_state), &detail::value_type<decltype(T::system_power_state)>},
      {offsetof(T, frame_cam_rate), &detail::value_type<decltype(T::frame_cam_rate)>},
      {offsetof(T, imu_angles_20), &detail::value_type<decltype(T::imu_angles_20)>},
      {offsetof(T, target_angles_20), &detail::value_type<decltype(T::target_angles_20)>},
      {offsetof(T, comm_errors), &detail::value_type<decltype(T::comm_errors)>},
      {offsetof(T, system_state), &detail::value_type<decltype(T::system_state)>},
      {offsetof(T, imu_quat), &detail::value_type<decltype(T::imu_quat)>},
      {offsetof(T, target_quat), &detail::value_type<decltype(T::target_quat)>},
      {offsetof(T, imu_to_frame_quat), &detail::value_type<decltype(T::imu_to_frame_quat)>},
      {offsetof(T, adc_ch_raw), &detail::value_type<decltype(T::adc_ch_raw)>},
      {offsetof(T, sw_limits_dist), &detail::value_type<decltype(T::sw_limits_dist)>},
      {offsetof(T, follow_dist), &detail::value_type<decltype(T::follow_dist)>},
      {offsetof(T, ext_target_limit_min), &detail::value_type<decltype(T::ext_target_limit_min)>},
      {offsetof(T, ext_target_limit_max), &detail::value_type<decltype(T::ext_target_limit_max)>},
      {offsetof(T, frame_cam_angle_20), &detail::value_type<decltype(T::frame_cam_angle_20)>},
      {offsetof(T, main_imu_state), &detail::value_type<decltype(T::main_imu_state)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.timestamp_ms);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.imu_angles);
    visitor(fields[3], value.target_angles);
    visitor(fields[4], value.target_speed);
    visitor(fields[5], value.stator_rotor_angle);
    visitor(fields[6], value.gyro_data);
    visitor(fields[7], value.rc_data);
    visitor(fields[8], value.z1_vector);
    visitor(fields[9], value.h1_vector);
    visitor(fields[10], value.rc_channels);
    visitor(fields[11], value.acc_data);
    visitor(fields[12], value.motor4_control);
    visitor(fields[13], value.ahrs_debug_info);
    visitor(fields[14], value.encoder_raw24);
    visitor(fields[15], value.imu_angles_rad);
    visitor(fields[16], value.script_vars_float);
    visitor(fields[17], value.script_vars_int16);
    visitor(fields[18], value.system_power_state);
    visitor(fields[19], value.frame_cam_rate);
    visitor(fields[20], value.imu_angles_20);
    visitor(fields[21], value.target_angles_20);
    visitor(fields[22], value.comm_errors);
    visitor(fields[23], value.system_state);
    visitor(fields[24], value.imu_quat);
    visitor(fields[25], value.target_quat);
    visitor(fields[26], value.imu_to_frame_quat);
    visitor(fields[27], value.adc_ch_raw);
    visitor(fields[28], value.sw_limits_dist);
    visitor(fields[29], value.follow_dist);
    visitor(fields[30], value.ext_target_limit_min);
    visitor(fields[31], value.ext_target_limit_max);
    visitor(fields[32], value.frame_cam_angle_20);
    visitor(fields[33], value.main_imu_state);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::RealtimeDataCustomRequest> {
  static constexpr const char* answers[] = {"RealtimeDataCustom"};
  static constexpr MessageInfo info{
      .name = "RealtimeDataCustomRequest", .command = "CMD_REALTIME_DATA_CUSTOM",
      .summary = "Request live data of the blocks in FLAGS.", .id = 88,
      .direction = Direction::to_board, .min_size = 10, .max_size = 10,
      .since = {.firmware = 2590, .board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "Blocks to send."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::RealtimeDataCustom2> {
  static constexpr MessageInfo info{
      .name = "RealtimeDataCustom2", .command = "CMD_REALTIME_DATA_CUSTOM2",
      .summary = "More live data of the requested blocks.", .id = 139,
      .direction = Direction::from_board, .min_size = 2, .max_size = 52, .since = {.firmware = 2742}};
  static constexpr FieldInfo fields[] = {
      {.name = "timestamp_ms", .spec_name = "TIMESTAMP_MS", .summary = "Time of the sample.",
       .unit = &UnitMeta<msg::MillisecondClock>::info},
      {.name = "flags", .spec_name = "FLAGS", .summary = "FLAGS of the request."},
      {.name = "frame_imu_angles", .spec_name = "FRAME_IMU_ANGLES",
       .summary = "Angles of the frame IMU (Euler).", .unit = &UnitMeta<msg::Angle14>::info,
       .directed = Directed::by_axis},
      {.name = "frame_gyro", .spec_name = "FRAME_GYRO", .summary = "Gyroscope of the frame IMU.",
       .unit = &UnitMeta<msg::GyroRate>::info, .directed = Directed::unknown},
      {.name = "frame_acc", .spec_name = "FRAME_ACC", .summary = "Accelerometer of the frame IMU.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::unknown},
      {.name = "debug", .spec_name = "DEBUG", .summary = "Values for debugging."},
      {.name = "mag_sens_data", .spec_name = "MAG_SENS_DATA", .summary = "Raw magnetometer data."},
      {.name = "pin_state", .spec_name = "PIN_STATE", .summary = "State of the inputs."},
      {.name = "stab_err_ampl", .spec_name = "STAB_ERR_AMPL",
       .summary = "Amplitude of the stabilization error.",
       .unit = &UnitMeta<msg::Millidegrees>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, timestamp_ms), &detail::value_type<decltype(T::timestamp_ms)>},
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, frame_imu_angles), &detail::value_type<decltype(T::frame_imu_angles)>},
      {offsetof(T, frame_gyro), &detail::value_type<decltype(T::frame_gyro)>},
      {offsetof(T, frame_acc), &detail::value_type<decltype(T::frame_acc)>},
      {offsetof(T, debug), &detail::value_type<decltype(T::debug)>},
      {offsetof(T, mag_sens_data), &detail::value_type<decltype(T::mag_sens_data)>},
      {offsetof(T, pin_state), &detail::value_type<decltype(T::pin_state)>},
      {offsetof(T, stab_err_ampl), &detail::value_type<decltype(T::stab_err_ampl)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.timestamp_ms);
    visitor(fields[1], value.flags);
    visitor(fields[2], value.frame_imu_angles);
    visitor(fields[3], value.frame_gyro);
    visitor(fields[4], value.frame_acc);
    visitor(fields[5], value.debug);
    visitor(fields[6], value.mag_sens_data);
    visitor(fields[7], value.pin_state);
    visitor(fields[8], value.stab_err_ampl);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::RealtimeDataCustom2Request> {
  static constexpr const char* answers[] = {"RealtimeDataCustom2"};
  static constexpr MessageInfo info{
      .name = "RealtimeDataCustom2Request", .command = "CMD_REALTIME_DATA_CUSTOM2",
      .summary = "Request live data of the blocks in FLAGS.", .id = 139,
      .direction = Direction::to_board, .min_size = 10, .max_size = 10, .since = {.firmware = 2742},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "flags", .spec_name = "FLAGS", .summary = "Blocks to send."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, flags), &detail::value_type<decltype(T::flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.flags);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::DataStreamInterval> {
  static constexpr MessageInfo info{
      .name = "DataStreamInterval", .command = "CMD_DATA_STREAM_INTERVAL",
      .summary = "Start, change or end a data stream: messages that the board sends at a fixed rate.",
      .id = 85, .direction = Direction::to_board, .min_size = 21, .max_size = 21,
      .since = {.firmware = 2590, .board = 30}, .effects = Effects(Effect::sets)};
  static constexpr Special interval_ms_special[] = {
      {0, "ends the stream"},
      {1, "a sample in every cycle, 0.8 ms"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Message to send."},
      {.name = "interval_ms", .spec_name = "INTERVAL_MS",
       .summary = "Time between samples; a divider with SYNC_TO_DATA.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .special = interval_ms_special},
      {.name = "config", .spec_name = "CONFIG",
       .summary = "Options of the message; unused bytes are 0."},
      {.name = "sync_to_data", .spec_name = "SYNC_TO_DATA",
       .summary = "Event that triggers the samples.", .since = {.firmware = 2701}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, interval_ms), &detail::value_type<decltype(T::interval_ms)>},
      {offsetof(T, config), &detail::value_type<decltype(T::config)>},
      {offsetof(T, sync_to_data), &detail::value_type<decltype(T::sync_to_data)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_id);
    visitor(fields[1], value.interval_ms);
    visitor(fields[2], value.config);
    visitor(fields[3], value.sync_to_data);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::CanDrvTelemetry> {
  static constexpr MessageInfo info{
      .name = "CanDrvTelemetry", .command = "CMD_CAN_DRV_TELEMETRY",
      .summary = "Live data of a CAN motor driver.", .id = 127, .direction = Direction::from_board,
      .min_size = 3, .max_size = 35, .since = {.firmware = 2720, .board = 36}, .unconfirmed = true};
  static constexpr Range drv_id_range{0, 6};
  static constexpr FieldInfo fields[] = {
      {.name = "drv_id", .spec_name = "DRV_ID", .summary = "The driver.", .range = &drv_id_range},
      {.name = "timestamp_ms", .spec_name = "TIMESTAMP_MS", .summary = "Time of the sample.",
       .unit = &UnitMeta<msg::MillisecondClock>::info},
      {.name = "can_bus_flags", .spec_name = "CAN_BUS_FLAGS",
       .summary = "State of the CAN bus; its bits are not documented."},
      {.name = "can_bus_err_cnt", .spec_name = "CAN_BUS_ERR_CNT",
       .summary = "Number of errors on the CAN bus."},
      {.name = "temp_board", .spec_name = "TEMP_BOARD", .summary = "Temperature of the driver.",
       .unit = &UnitMeta<msg::Temperature>::info},
      {.name = "temp_motor", .spec_name = "TEMP_MOTOR", .summary = "Temperature of the motor.",
       .unit = &UnitMeta<msg::Temperature>::info},
      {.name = "avg_current", .spec_name = "AVG_CURRENT", .summary = "Average current.",
       .unit = &UnitMeta<msg::Current>::info},
      {.name = "bus_voltage", .spec_name = "BUS_VOLTAGE", .summary = "Supply voltage.",
       .unit = &UnitMeta<msg::Millivolts>::info},
      {.name = "pin_state", .spec_name = "PIN_STATE", .summary = "State of the pins."},
      {.name = "phase_current", .spec_name = "PHASE_CURRENT", .summary = "Current of each phase.",
       .unit = &UnitMeta<msg::SignedCurrent>::info},
      {.name = "encoder_error_cnt", .spec_name = "ENCODER_ERROR_CNT",
       .summary = "Number of errors of the encoder."},
      {.name = "iq_current", .spec_name = "IQ_CURRENT", .summary = "Current that makes torque.",
       .unit = &UnitMeta<msg::SignedCurrent>::info},
      {.name = "id_current", .spec_name = "ID_CURRENT", .summary = "Current that makes the field.",
       .unit = &UnitMeta<msg::SignedCurrent>::info},
      {.name = "motor_speed", .spec_name = "MOTOR_SPEED", .summary = "Speed of the motor.",
       .unit = &UnitMeta<msg::RevolutionsPerMinute>::info, .directed = Directed::by_axis},
      {.name = "pid_pos_err", .spec_name = "PID_POS_ERR",
       .summary = "Error of the position controller."},
      {.name = "pid_speed_err", .spec_name = "PID_SPEED_ERR",
       .summary = "Error of the speed controller."},
      {.name = "iq_ref", .spec_name = "IQ_REF", .summary = "Target of the torque current.",
       .unit = &UnitMeta<msg::CurrentShare>::info},
      {.name = "pid_current_err", .spec_name = "PID_CURRENT_ERR",
       .summary = "Error of the current controller."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, drv_id), &detail::value_type<decltype(T::drv_id)>},
      {offsetof(T, timestamp_ms), &detail::value_type<decltype(T::timestamp_ms)>},
      {offsetof(T, can_bus_flags), &detail::value_type<decltype(T::can_bus_flags)>},
      {offsetof(T, can_bus_err_cnt), &detail::value_type<decltype(T::can_bus_err_cnt)>},
      {offsetof(T, temp_board), &detail::value_type<decltype(T::temp_board)>},
      {offsetof(T, temp_motor), &detail::value_type<decltype(T::temp_motor)>},
      {offsetof(T, avg_current), &detail::value_type<decltype(T::avg_current)>},
      {offsetof(T, bus_voltage), &detail::value_type<decltype(T::bus_voltage)>},
      {offsetof(T, pin_state), &detail::value_type<decltype(T::pin_state)>},
      {offsetof(T, phase_current), &detail::value_type<decltype(T::phase_current)>},
      {offsetof(T, encoder_error_cnt), &detail::value_type<decltype(T::encoder_error_cnt)>},
      {offsetof(T, iq_current), &detail::value_type<decltype(T::iq_current)>},
      {offsetof(T, id_current), &detail::value_type<decltype(T::id_current)>},
      {offsetof(T, motor_speed), &detail::value_type<decltype(T::motor_speed)>},
      {offsetof(T, pid_pos_err), &detail::value_type<decltype(T::pid_pos_err)>},
      {offsetof(T, pid_speed_err), &detail::value_type<decltype(T::pid_speed_err)>},
      {offsetof(T, iq_ref), &detail::value_type<decltype(T::iq_ref)>},
      {offsetof(T, pid_current_err), &detail::value_type<decltype(T::pid_current_err)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.drv_id);
    visitor(fields[1], value.timestamp_ms);
    visitor(fields[2], value.can_bus_flags);
    visitor(fields[3], value.can_bus_err_cnt);
    visitor(fields[4], value.temp_board);
    visitor(fields[5], value.temp_motor);
    visitor(fields[6], value.avg_current);
    visitor(fields[7], value.bus_voltage);
    visitor(fields[8], value.pin_state);
    visitor(fields[9], value.phase_current);
    visitor(fields[10], value.encoder_error_cnt);
    visitor(fields[11], value.iq_current);
    visitor(fields[12], value.id_current);
    visitor(fields[13], value.motor_speed);
    visitor(fields[14], value.pid_pos_err);
    visitor(fields[15], value.pid_speed_err);
    visitor(fields[16], value.iq_ref);
    visitor(fields[17], value.pid_current_err);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::CanDrvState> {
  static constexpr MessageInfo info{
      .name = "CanDrvState", .command = "CMD_CAN_DRV_STATE",
      .summary = "Undocumented body from the board.", .id = 98, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::CanDrvStateRequest> {
  static constexpr MessageInfo info{
      .name = "CanDrvStateRequest", .command = "CMD_CAN_DRV_STATE",
      .summary = "Undocumented body to the board.", .id = 98, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::RealtimeDataCanDrv> {
  static constexpr MessageInfo info{
      .name = "RealtimeDataCanDrv", .command = "CMD_REALTIME_DATA_CAN_DRV",
      .summary = "Undocumented body from the board.", .id = 101, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

template <>
struct Meta<msg::RealtimeDataCanDrvRequest> {
  static constexpr MessageInfo info{
      .name = "RealtimeDataCanDrvRequest", .command = "CMD_REALTIME_DATA_CAN_DRV",
      .summary = "Undocumented body to the board.", .id = 101, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600},
      .effects = Effects(Effect::unknown)};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "DATA", .summary = "Undocumented content."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
  }
};

}  // namespace sbgc
