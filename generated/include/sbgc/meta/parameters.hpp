// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/parameters.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc {

template <>
struct Meta<msg::AxisPid> {
  static constexpr Range p_range{0, 255};
  static constexpr LaterMeaning p_later[] = {
      {.since = {.firmware = 2731}
  ,
       .unit = &UnitMeta<msg::LogarithmicGain>::info,
       .summary = "Proportional gain."},
  };
  static constexpr Range i_range{0, 255};
  static constexpr LaterMeaning i_later[] = {
      {.since = {.firmware = 2731}
  ,
       .unit = &UnitMeta<msg::LogarithmicGain>::info,
       .summary = "Integral gain."},
  };
  static constexpr Range d_range{0, 255};
  static constexpr LaterMeaning d_later[] = {
      {.since = {.firmware = 2731}
  ,
       .unit = &UnitMeta<msg::LogarithmicGain>::info,
       .summary = "Derivative gain."},
  };
  static constexpr Range power_range{0, 255};
  static constexpr Range invert_range{0, 1};
  static constexpr Range poles_range{0, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "p", .spec_name = "P", .summary = "Proportional gain.", .range = &p_range,
       .later = p_later},
      {.name = "i", .spec_name = "I", .summary = "Integral gain.",
       .unit = &UnitMeta<msg::Hundredths>::info, .range = &i_range, .later = i_later},
      {.name = "d", .spec_name = "D", .summary = "Derivative gain.", .range = &d_range,
       .later = d_later},
      {.name = "power", .spec_name = "POWER", .summary = "Power of the motor.",
       .range = &power_range},
      {.name = "invert", .spec_name = "INVERT", .summary = "1 inverts the motor's direction.",
       .range = &invert_range},
      {.name = "poles", .spec_name = "POLES", .summary = "Number of motor poles.",
       .range = &poles_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, p), &detail::value_type<decltype(T::p)>},
      {offsetof(T, i), &detail::value_type<decltype(T::i)>},
      {offsetof(T, d), &detail::value_type<decltype(T::d)>},
      {offsetof(T, power), &detail::value_type<decltype(T::power)>},
      {offsetof(T, invert), &detail::value_type<decltype(T::invert)>},
      {offsetof(T, poles), &detail::value_type<decltype(T::poles)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.p);
    visitor(fields[1], value.i);
    visitor(fields[2], value.d);
    visitor(fields[3], value.power);
    visitor(fields[4], value.invert);
    visitor(fields[5], value.poles);
  }
};

template <>
struct Meta<msg::AxisRc> {
  static constexpr Range rc_min_angle_range{-720, 720};
  static constexpr Range rc_max_angle_range{-720, 720};
  static constexpr Range rc_lpf_range{0, 255};
  static constexpr Range rc_speed_range{0, 255};
  static constexpr Range rc_follow_range{-127, 127};
  static constexpr FieldInfo fields[] = {
      {.name = "rc_min_angle", .spec_name = "RC_MIN_ANGLE", .summary = "Angle at the lowest signal.",
       .unit = &UnitMeta<msg::Degrees>::info, .range = &rc_min_angle_range,
       .directed = Directed::by_axis},
      {.name = "rc_max_angle", .spec_name = "RC_MAX_ANGLE",
       .summary = "Angle at the highest signal.", .unit = &UnitMeta<msg::Degrees>::info,
       .range = &rc_max_angle_range, .directed = Directed::by_axis},
      {.name = "rc_mode", .spec_name = "RC_MODE", .summary = "What the signal controls."},
      {.name = "rc_lpf", .spec_name = "RC_LPF",
       .summary = "Low-pass filter of the signal; up to 255 only with LPF_EXTENDED_RANGE.",
       .range = &rc_lpf_range},
      {.name = "rc_speed", .spec_name = "RC_SPEED", .summary = "Control speed.",
       .range = &rc_speed_range},
      {.name = "rc_follow", .spec_name = "RC_FOLLOW",
       .summary = "Roll and pitch: how much to follow the flight controller. Yaw: any value but 0 follows the motor.",
       .range = &rc_follow_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, rc_min_angle), &detail::value_type<decltype(T::rc_min_angle)>},
      {offsetof(T, rc_max_angle), &detail::value_type<decltype(T::rc_max_angle)>},
      {offsetof(T, rc_mode), &detail::value_type<decltype(T::rc_mode)>},
      {offsetof(T, rc_lpf), &detail::value_type<decltype(T::rc_lpf)>},
      {offsetof(T, rc_speed), &detail::value_type<decltype(T::rc_speed)>},
      {offsetof(T, rc_follow), &detail::value_type<decltype(T::rc_follow)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.rc_min_angle);
    visitor(fields[1], value.rc_max_angle);
    visitor(fields[2], value.rc_mode);
    visitor(fields[3], value.rc_lpf);
    visitor(fields[4], value.rc_speed);
    visitor(fields[5], value.rc_follow);
  }
  /// Calls `check(field, low, field, high, is_strict)` for each rule that low is not above high.
  template <class T, class Check>
  static constexpr void rules(const T& value, Check&& check) {
    check(fields[0], value.rc_min_angle, fields[1], value.rc_max_angle, false);
  }
};

template <>
struct Meta<msg::AxisNotches> {
  static constexpr Range notch_freq_range{0, 255};
  static constexpr Range notch_width_range{0, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "notch_freq", .spec_name = "NOTCH_FREQ",
       .summary = "Center frequency of each of the three filters.",
       .unit = &UnitMeta<msg::EvenFrequency>::info, .range = &notch_freq_range,
       .saved_as = "notchFreq{n}"},
      {.name = "notch_width", .spec_name = "NOTCH_WIDTH",
       .summary = "Width of each filter, between its -3 dB points.",
       .unit = &UnitMeta<msg::SmallFrequency>::info, .range = &notch_width_range,
       .saved_as = "notchWidth{n}"},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, notch_freq), &detail::value_type<decltype(T::notch_freq)>},
      {offsetof(T, notch_width), &detail::value_type<decltype(T::notch_width)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.notch_freq);
    visitor(fields[1], value.notch_width);
  }
};

template <>
struct Meta<msg::MavChannel> {
  static constexpr FieldInfo fields[] = {
      {.name = "mav_src", .spec_name = "MAV_SRC", .summary = "Serial port of the channel.",
       .saved_as = "mavlink__src"},
      {.name = "mav_sys_id", .spec_name = "MAV_SYS_ID",
       .summary = "MAVLink system id of the channel.", .saved_as = "mavlink__sys__id"},
      {.name = "mav_comp_id", .spec_name = "MAV_COMP_ID",
       .summary = "MAVLink component id of the channel.", .saved_as = "mavlink__comp__id"},
      {.name = "mav_cfg_flags", .spec_name = "MAV_CFG_FLAGS", .summary = "Settings of the channel.",
       .saved_as = "mavlink__flags"},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mav_src), &detail::value_type<decltype(T::mav_src)>},
      {offsetof(T, mav_sys_id), &detail::value_type<decltype(T::mav_sys_id)>},
      {offsetof(T, mav_comp_id), &detail::value_type<decltype(T::mav_comp_id)>},
      {offsetof(T, mav_cfg_flags), &detail::value_type<decltype(T::mav_cfg_flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mav_src);
    visitor(fields[1], value.mav_sys_id);
    visitor(fields[2], value.mav_comp_id);
    visitor(fields[3], value.mav_cfg_flags);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::StepSignal> {
  static constexpr FieldInfo fields[] = {
      {.name = "step_signal_src", .spec_name = "STEP_SIGNAL_SRC",
       .summary = "RC signal that triggers the steps."},
      {.name = "step_signal_cfg", .spec_name = "STEP_SIGNAL_CFG",
       .summary = "Number of steps and how to trigger them."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, step_signal_src), &detail::value_type<decltype(T::step_signal_src)>},
      {offsetof(T, step_signal_cfg), &detail::value_type<decltype(T::step_signal_cfg)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.step_signal_src);
    visitor(fields[1], value.step_signal_cfg);
  }
};

template <>
struct Meta<msg::RcCalibration> {
  static constexpr FieldInfo fields[] = {
      {.name = "rc_calib_src", .spec_name = "RC_CALIB_SRC", .summary = "Calibrated signal."},
      {.name = "rc_calib_offset", .spec_name = "RC_CALIB_OFFSET", .summary = "Offset of the signal.",
       .unit = &UnitMeta<msg::SignalOffset>::info},
      {.name = "rc_calib_neg_scale", .spec_name = "RC_CALIB_NEG_SCALE",
       .summary = "Factor below the center.", .unit = &UnitMeta<msg::SignalScale>::info},
      {.name = "rc_calib_pos_scale", .spec_name = "RC_CALIB_POS_SCALE",
       .summary = "Factor above the center.", .unit = &UnitMeta<msg::SignalScale>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, rc_calib_src), &detail::value_type<decltype(T::rc_calib_src)>},
      {offsetof(T, rc_calib_offset), &detail::value_type<decltype(T::rc_calib_offset)>},
      {offsetof(T, rc_calib_neg_scale), &detail::value_type<decltype(T::rc_calib_neg_scale)>},
      {offsetof(T, rc_calib_pos_scale), &detail::value_type<decltype(T::rc_calib_pos_scale)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.rc_calib_src);
    visitor(fields[1], value.rc_calib_offset);
    visitor(fields[2], value.rc_calib_neg_scale);
    visitor(fields[3], value.rc_calib_pos_scale);
  }
};

template <>
struct Meta<msg::ReadParams3> {
  static constexpr MessageInfo info{
      .name = "ReadParams3", .command = "CMD_READ_PARAMS_3",
      .summary = "Parameters of one profile and general parameters.", .id = 21,
      .direction = Direction::from_board, .min_size = 134, .max_size = 134, .since = {.board = 30}};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr Range acc_limiter_all_range{0, 255};
  static constexpr Special acc_limiter_all_special[] = {
      {0, "disabled"},
  };
  static constexpr Range ext_fc_gain_roll_range{-127, 127};
  static constexpr Range ext_fc_gain_pitch_range{-127, 127};
  static constexpr Range gyro_trust_range{0, 255};
  static constexpr Range use_model_range{0, 1};
  static constexpr Range rc_trim_range{-127, 127};
  static constexpr Range rc_deadband_range{0, 255};
  static constexpr Range rc_expo_rate_range{0, 100};
  static constexpr Range follow_deadband_range{0, 255};
  static constexpr Range follow_expo_rate_range{0, 100};
  static constexpr Range follow_offset_range{-127, 127};
  static constexpr Range gyro_deadband_range{0, 255};
  static constexpr Range i2c_internal_pullups_range{0, 1};
  static constexpr Range bat_threshold_alarm_range{-3000, 3000};
  static constexpr Range bat_threshold_motors_range{-3000, 3000};
  static constexpr Range bat_comp_ref_range{-3000, 3000};
  static constexpr Range follow_roll_mix_start_range{0, 90};
  static constexpr Range follow_roll_mix_range_range{0, 90};
  static constexpr Range booster_power_range{0, 255};
  static constexpr Range follow_speed_range{0, 255};
  static constexpr Range frame_angle_from_motors_range{0, 1};
  static constexpr Range rc_memory_range{-32768, 32767};
  static constexpr Range servo_out_range{1, 32};
  static constexpr Special servo_out_special[] = {
      {0, "disabled"},
  };
  static constexpr Range servo_rate_range{5, 40};
  static constexpr Range adaptive_pid_threshold_range{0, 255};
  static constexpr Range adaptive_pid_rate_range{1, 255};
  static constexpr Range adaptive_pid_recovery_factor_range{0, 10};
  static constexpr Range follow_lpf_range{0, 16};
  static constexpr Range cur_profile_id_range{0, 4};
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile of the parameters.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
      {.name = "axes", .spec_name = "axes", .summary = "Controller and motor of each axis."},
      {.name = "acc_limiter_all", .spec_name = "ACC_LIMITER_ALL",
       .summary = "Acceleration limit of all axes.",
       .unit = &UnitMeta<msg::AngularAcceleration>::info, .range = &acc_limiter_all_range,
       .special = acc_limiter_all_special, .saved_as = "angleAccLimit"},
      {.name = "ext_fc_gain_roll", .spec_name = "EXT_FC_GAIN_ROLL",
       .summary = "Gain of the flight controller's roll signal.", .range = &ext_fc_gain_roll_range,
       .saved_as = "extFCGain"},
      {.name = "ext_fc_gain_pitch", .spec_name = "EXT_FC_GAIN_PITCH",
       .summary = "Gain of the flight controller's pitch signal.", .range = &ext_fc_gain_pitch_range,
       .saved_as = "extFCGain"},
      {.name = "rc", .spec_name = "rc", .summary = "Remote control of each axis."},
      {.name = "gyro_trust", .spec_name = "GYRO_TRUST",
       .summary = "Trust in the gyroscope relative to the accelerometer.",
       .range = &gyro_trust_range},
      {.name = "use_model", .spec_name = "USE_MODEL", .summary = "1 enables the motor model.",
       .range = &use_model_range},
      {.name = "pwm_freq", .spec_name = "PWM_FREQ", .summary = "PWM frequency of the motors."},
      {.name = "serial_speed", .spec_name = "SERIAL_SPEED",
       .summary = "Baud rate of the serial port.", .role = FieldRole::general},
      {.name = "rc_trim", .spec_name = "RC_TRIM_{AXIS}", .summary = "Trim of the RC signals.",
       .range = &rc_trim_range},
      {.name = "rc_deadband", .spec_name = "RC_DEADBAND",
       .summary = "Dead band around the center of the RC signals.", .range = &rc_deadband_range},
      {.name = "rc_expo_rate", .spec_name = "RC_EXPO_RATE",
       .summary = "Expo rate of the RC signals.", .range = &rc_expo_rate_range},
      {.name = "rc_virt_mode", .spec_name = "RC_VIRT_MODE", .summary = "Signal at the RC_ROLL pin."},
      {.name = "rc_map", .spec_name = "RC_MAP_{AXIS}", .summary = "Control source of each axis."},
      {.name = "rc_map_cmd", .spec_name = "RC_MAP_CMD", .summary = "Source of the command channel.",
       .saved_as = "rcMap"},
      {.name = "rc_map_fc_roll", .spec_name = "RC_MAP_FC_ROLL",
       .summary = "Source of the flight controller's roll signal.", .saved_as = "rcMap"},
      {.name = "rc_map_fc_pitch", .spec_name = "RC_MAP_FC_PITCH",
       .summary = "Source of the flight controller's pitch signal.", .saved_as = "rcMap"},
      {.name = "rc_mix_fc_roll", .spec_name = "RC_MIX_FC_ROLL",
       .summary = "Mix of the flight controller's roll signal.", .saved_as = "rcMix"},
      {.name = "rc_mix_fc_pitch", .spec_name = "RC_MIX_FC_PITCH",
       .summary = "Mix of the flight controller's pitch signal.", .saved_as = "rcMix"},
      {.name = "follow_mode", .spec_name = "FOLLOW_MODE", .summary = "What the camera follows."},
      {.name = "follow_deadband", .spec_name = "FOLLOW_DEADBAND",
       .summary = "Dead band of the follow mode.", .range = &follow_deadband_range},
      {.name = "follow_expo_rate", .spec_name = "FOLLOW_EXPO_RATE",
       .summary = "Expo rate of the follow mode.", .range = &follow_expo_rate_range},
      {.name = "follow_offset", .spec_name = "FOLLOW_OFFSET_{AXIS}",
       .summary = "Offset of the follow mode.", .range = &follow_offset_range},
      {.name = "axis_top", .spec_name = "AXIS_TOP",
       .summary = "Axis of the main IMU that points up.", .role = FieldRole::general},
      {.name = "axis_right", .spec_name = "AXIS_RIGHT",
       .summary = "Axis of the main IMU that points right.", .role = FieldRole::general},
      {.name = "frame_axis_top", .spec_name = "FRAME_AXIS_TOP",
       .summary = "Axis of the frame IMU that points up.", .role = FieldRole::general},
      {.name = "frame_axis_right", .spec_name = "FRAME_AXIS_RIGHT",
       .summary = "Axis of the frame IMU that points right.", .role = FieldRole::general},
      {.name = "frame_imu_pos", .spec_name = "FRAME_IMU_POS",
       .summary = "Location of the frame IMU.", .role = FieldRole::general},
      {.name = "gyro_deadband", .spec_name = "GYRO_DEADBAND",
       .summary = "Dead band of the gyroscope.", .unit = &UnitMeta<msg::GyroDeadband>::info,
       .range = &gyro_deadband_range},
      {.name = "gyro_sens", .spec_name = "GYRO_SENS", .summary = "Sensitivity of the gyroscope."},
      {.name = "i2c_internal_pullups", .spec_name = "I2C_INTERNAL_PULLUPS",
       .summary = "1 enables the controller's I2C pull-ups; in later firmware, an I2C clock of 800 kHz instead of 400 kHz.",
       .range = &i2c_internal_pullups_range, .saved_as = "i2c__fast"},
      {.name = "skip_gyro_calib", .spec_name = "SKIP_GYRO_CALIB",
       .summary = "Gyroscope calibration at start-up."},
      {.name = "rc_cmd_low", .spec_name = "RC_CMD_LOW",
       .summary = "Action for a low signal on the command channel.", .saved_as = "rcCmd"},
      {.name = "rc_cmd_mid", .spec_name = "RC_CMD_MID",
       .summary = "Action for a middle signal on the command channel.", .saved_as = "rcCmd"},
      {.name = "rc_cmd_high", .spec_name = "RC_CMD_HIGH",
       .summary = "Action for a high signal on the command channel.", .saved_as = "rcCmd"},
      {.name = "menu_cmd", .spec_name = "MENU_CMD_{1..5}",
       .summary = "Actions for 1 to 5 presses of the menu button."},
      {.name = "menu_cmd_long", .spec_name = "MENU_CMD_LONG",
       .summary = "Action for a long press of the menu button.", .saved_as = "menuCmd"},
      {.name = "output", .spec_name = "OUTPUT_{AXIS}", .summary = "Motor output of each axis.",
       .saved_as = "outputMap"},
      {.name = "bat_threshold_alarm", .spec_name = "BAT_THRESHOLD_ALARM",
       .summary = "Battery voltage that triggers the alarm; negative disables it.",
       .unit = &UnitMeta<msg::VoltageThreshold>::info, .range = &bat_threshold_alarm_range},
      {.name = "bat_threshold_motors", .spec_name = "BAT_THRESHOLD_MOTORS",
       .summary = "Battery voltage that stops the motors; negative disables it.",
       .unit = &UnitMeta<msg::VoltageThreshold>::info, .range = &bat_threshold_motors_range},
      {.name = "bat_comp_ref", .spec_name = "BAT_COMP_REF",
       .summary = "Reference voltage of the motor power compensation; negative disables it.",
       .unit = &UnitMeta<msg::VoltageThreshold>::info, .range = &bat_comp_ref_range},
      {.name = "beeper_modes", .spec_name = "BEEPER_MODES",
       .summary = "When the board makes a sound."},
      {.name = "follow_roll_mix_start", .spec_name = "FOLLOW_ROLL_MIX_START",
       .summary = "Angle at which pitch starts to follow roll.",
       .unit = &UnitMeta<msg::SmallDegrees>::info, .range = &follow_roll_mix_start_range},
      {.name = "follow_roll_mix_range", .spec_name = "FOLLOW_ROLL_MIX_RANGE",
       .summary = "Angle over which pitch continues to follow roll.",
       .unit = &UnitMeta<msg::SmallDegrees>::info, .range = &follow_roll_mix_range_range},
      {.name = "booster_power", .spec_name = "BOOSTER_POWER_{AXIS}",
       .summary = "Additional power to recover lost synchronization.", .range = &booster_power_range},
      {.name = "follow_speed", .spec_name = "FOLLOW_SPEED_{AXIS}",
       .summary = "Speed of the follow mode.", .range = &follow_speed_range},
      {.name = "frame_angle_from_motors", .spec_name = "FRAME_ANGLE_FROM_MOTORS",
       .summary = "1 estimates the frame angle from the motors.",
       .range = &frame_angle_from_motors_range},
      {.name = "rc_memory", .spec_name = "RC_MEMORY_{AXIS}", .summary = "Angle at start-up.",
       .unit = &UnitMeta<msg::Angle14>::info, .range = &rc_memory_range,
       .directed = Directed::by_axis},
      {.name = "servo_out", .spec_name = "SERVO{1..4}_OUT",
       .summary = "Virtual channel on each servo pin.", .range = &servo_out_range,
       .special = servo_out_special},
      {.name = "servo_rate", .spec_name = "SERVO_RATE",
       .summary = "PWM frequency of the servo outputs.", .unit = &UnitMeta<msg::ServoRate>::info,
       .range = &servo_rate_range, .saved_in = SavedIn::unit},
      {.name = "adaptive_pid_enabled", .spec_name = "ADAPTIVE_PID_ENABLED",
       .summary = "Axes with adaptive control."},
      {.name = "adaptive_pid_threshold", .spec_name = "ADAPTIVE_PID_THRESHOLD",
       .summary = "Vibration level that starts the adaptation.",
       .range = &adaptive_pid_threshold_range},
      {.name = "adaptive_pid_rate", .spec_name = "ADAPTIVE_PID_RATE",
       .summary = "Speed of the adaptation.", .range = &adaptive_pid_rate_range},
      {.name = "adaptive_pid_recovery_factor", .spec_name = "ADAPTIVE_PID_RECOVERY_FACTOR",
       .summary = "How slowly the gains recover.", .range = &adaptive_pid_recovery_factor_range},
      {.name = "follow_lpf", .spec_name = "FOLLOW_LPF_{AXIS}",
       .summary = "Low-pass filter of the follow mode.", .range = &follow_lpf_range},
      {.name = "general_flags1", .spec_name = "GENERAL_FLAGS1",
       .summary = "Options of the whole board.", .role = FieldRole::general},
      {.name = "profile_flags1", .spec_name = "PROFILE_FLAGS1", .summary = "Options of the profile."},
      {.name = "spektrum_mode", .spec_name = "SPEKTRUM_MODE",
       .summary = "Protocol of a Spektrum satellite."},
      {.name = "order_of_axes", .spec_name = "ORDER_OF_AXES", .summary = "Order of the motors.",
       .role = FieldRole::general},
      {.name = "euler_order", .spec_name = "EULER_ORDER", .summary = "Order of the Euler angles."},
      {.name = "cur_imu", .spec_name = "CUR_IMU",
       .summary = "Selected IMU; write it back unchanged.", .role = FieldRole::state},
      {.name = "cur_profile_id", .spec_name = "CUR_PROFILE_ID",
       .summary = "Active profile; write it back unchanged.", .range = &cur_profile_id_range,
       .role = FieldRole::state},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, acc_limiter_all), &detail::value_type<decltype(T::acc_limiter_all)>},
      {offsetof(T, ext_fc_gain_roll), &detail::value_type<decltype(T::ext_fc_gain_roll)>},
      {offsetof(T, ext_fc_gain_pitch), &detail::value_type<decltype(T::ext_fc_gain_pitch)>},
      {offsetof(T, rc), &detail::value_type<decltype(T::rc)>},
      {offsetof(T, gyro_trust), &detail::value_type<decltype(T::gyro_trust)>},
      {offsetof(T, use_model), &detail::value_type<decltype(T::use_model)>},
      {offsetof(T, pwm_freq), &detail::value_type<decltype(T::pwm_freq)>},
      {offsetof(T, serial_speed), &detail::value_type<decltype(T::serial_speed)>},
      {offsetof(T, rc_trim), &detail::value_type<decltype(T::rc_trim)>},
      {offsetof(T, rc_deadband), &detail::value_type<decltype(T::rc_deadband)>},
      {offsetof(T, rc_expo_rate), &detail::value_type<decltype(T::rc_expo_rate)>},
      {offsetof(T, rc_virt_mode), &detail::value_type<decltype(T::rc_virt_mode)>},
      {offsetof(T, rc_map), &detail::value_type<decltype(T::rc_map)>},
      {offsetof(T, rc_map_cmd), &detail::value_type<decltype(T::rc_map_cmd)>},
      {offsetof(T, rc_map_fc_roll), &detail::value_type<decltype(T::rc_map_fc_roll)>},
      {offsetof(T, rc_map_fc_pitch), &detail::value_type<decltype(T::rc_map_fc_pitch)>},
      {offsetof(T, rc_mix_fc_roll), &detail::value_type<decltype(T::rc_mix_fc_roll)>},
      {offsetof(T, rc_mix_fc_pitch), &detail::value_type<decltype(T::rc_mix_fc_pitch)>},
      {offsetof(T, follow_mode), &detail::value_type<decltype(T::follow_mode)>},
      {offsetof(T, follow_deadband), &detail::value_type<decltype(T::follow_deadband)>},
      {offsetof(T, follow_expo_rate), &detail::value_type<decltype(T::follow_expo_rate)>},
      {offsetof(T, follow_offset), &detail::value_type<decltype(T::follow_offset)>},
      {offsetof(T, axis_top), &detail::value_type<decltype(T::axis_top)>},
      {offsetof(T, axis_right), &detail::value_type<decltype(T::axis_right)>},
      {offsetof(T, frame_axis_top), &detail::value_type<decltype(T::frame_axis_top)>},
      {offsetof(T, frame_axis_right), &detail::value_type<decltype(T::frame_axis_right)>},
      {offsetof(T, frame_imu_pos), &detail::value_type<decltype(T::frame_imu_pos)>},
      {offsetof(T, gyro_deadband), &detail::value_type<decltype(T::gyro_deadband)>},
      {offsetof(T, gyro_sens), &detail::value_type<decltype(T::gyro_sens)>},
      {offsetof(T, i2c_internal_pullups), &detail::value_type<decltype(T::i2c_internal_pullups)>},
      {offsetof(T, skip_gyro_calib), &detail::value_type<decltype(T::skip_gyro_calib)>},
      {offsetof(T, rc_cmd_low), &detail::value_type<decltype(T::rc_cmd_low)>},
      {offsetof(T, rc_cmd_mid), &detail::value_type<decltype(T::rc_cmd_mid)>},
      {offsetof(T, rc_cmd_high), &detail::value_type<decltype(T::rc_cmd_high)>},
      {offsetof(T, menu_cmd), &detail::value_type<decltype(T::menu_cmd)>},
      {offsetof(T, menu_cmd_long), &detail::value_type<decltype(T::menu_cmd_long)>},
      {offsetof(T, output), &detail::value_type<decltype(T::output)>},
      {offsetof(T, bat_threshold_alarm), &detail::value_type<decltype(T::bat_threshold_alarm)>},
      {offsetof(T, bat_threshold_motors), &detail::value_type<decltype(T::bat_threshold_motors)>},
      {offsetof(T, bat_comp_ref), &detail::value_type<decltype(T::bat_comp_ref)>},
      {offsetof(T, beeper_modes), &detail::value_type<decltype(T::beeper_modes)>},
      {offsetof(T, follow_roll_mix_start), &detail::value_type<decltype(T::follow_roll_mix_start)>},
      {offsetof(T, follow_roll_mix_range), &detail::value_type<decltype(T::follow_roll_mix_range)>},
      {offsetof(T, booster_power), &detail::value_type<decltype(T::booster_power)>},
      {offsetof(T, follow_speed), &detail::value_type<decltype(T::follow_speed)>},
      {offsetof(T, frame_angle_from_motors), &detail::value_type<decltype(T::frame_angle_from_motors)>},
      {offsetof(T, rc_memory), &detail::value_type<decltype(T::rc_memory)>},
      {offsetof(T, servo_out), &detail::value_type<decltype(T::servo_out)>},
      {offsetof(T, servo_rate), &detail::value_type<decltype(T::servo_rate)>},
      {offsetof(T, adaptive_pid_enabled), &detail::value_type<decltype(T::adaptive_pid_enabled)>},
      {offsetof(T, adaptive_pid_threshold), &detail::value_type<decltype(T::adaptive_pid_threshold)>},
      {offsetof(T, adaptive_pid_rate), &detail::value_type<decltype(T::adaptive_pid_rate)>},
      {offsetof(T, adaptive_pid_recovery_factor), &detail::value_type<decltype(T::adaptive_pid_recovery_factor)>},
      {offsetof(T, follow_lpf), &detail::value_type<decltype(T::follow_lpf)>},
      {offsetof(T, general_flags1), &detail::value_type<decltype(T::general_flags1)>},
      {offsetof(T, profile_flags1), &detail::value_type<decltype(T::profile_flags1)>},
      {offsetof(T, spektrum_mode), &detail::value_type<decltype(T::spektrum_mode)>},
      {offsetof(T, order_of_axes), &detail::value_type<decltype(T::order_of_axes)>},
      {offsetof(T, euler_order), &detail::value_type<decltype(T::euler_order)>},
      {offsetof(T, cur_imu), &detail::value_type<decltype(T::cur_imu)>},
      {offsetof(T, cur_profile_id), &detail::value_type<decltype(T::cur_profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.axes);
    visitor(fields[2], value.acc_limiter_all);
    visitor(fields[3], value.ext_fc_gain_roll);
    visitor(fields[4], value.ext_fc_gain_pitch);
    visitor(fields[5], value.rc);
    visitor(fields[6], value.gyro_trust);
    visitor(fields[7], value.use_model);
    visitor(fields[8], value.pwm_freq);
    visitor(fields[9], value.serial_speed);
    visitor(fields[10], value.rc_trim);
    visitor(fields[11], value.rc_deadband);
    visitor(fields[12], value.rc_expo_rate);
    visitor(fields[13], value.rc_virt_mode);
    visitor(fields[14], value.rc_map);
    visitor(fields[15], value.rc_map_cmd);
    visitor(fields[16], value.rc_map_fc_roll);
    visitor(fields[17], value.rc_map_fc_pitch);
    visitor(fields[18], value.rc_mix_fc_roll);
    visitor(fields[19], value.rc_mix_fc_pitch);
    visitor(fields[20], value.follow_mode);
    visitor(fields[21], value.follow_deadband);
    visitor(fields[22], value.follow_expo_rate);
    visitor(fields[23], value.follow_offset);
    visitor(fields[24], value.axis_top);
    visitor(fields[25], value.axis_right);
    visitor(fields[26], value.frame_axis_top);
    visitor(fields[27], value.frame_axis_right);
    visitor(fields[28], value.frame_imu_pos);
    visitor(fields[29], value.gyro_deadband);
    visitor(fields[30], value.gyro_sens);
    visitor(fields[31], value.i2c_internal_pullups);
    visitor(fields[32], value.skip_gyro_calib);
    visitor(fields[33], value.rc_cmd_low);
    visitor(fields[34], value.rc_cmd_mid);
    visitor(fields[35], value.rc_cmd_high);
    visitor(fields[36], value.menu_cmd);
    visitor(fields[37], value.menu_cmd_long);
    visitor(fields[38], value.output);
    visitor(fields[39], value.bat_threshold_alarm);
    visitor(fields[40], value.bat_threshold_motors);
    visitor(fields[41], value.bat_comp_ref);
    visitor(fields[42], value.beeper_modes);
    visitor(fields[43], value.follow_roll_mix_start);
    visitor(fields[44], value.follow_roll_mix_range);
    visitor(fields[45], value.booster_power);
    visitor(fields[46], value.follow_speed);
    visitor(fields[47], value.frame_angle_from_motors);
    visitor(fields[48], value.rc_memory);
    visitor(fields[49], value.servo_out);
    visitor(fields[50], value.servo_rate);
    visitor(fields[51], value.adaptive_pid_enabled);
    visitor(fields[52], value.adaptive_pid_threshold);
    visitor(fields[53], value.adaptive_pid_rate);
    visitor(fields[54], value.adaptive_pid_recovery_factor);
    visitor(fields[55], value.follow_lpf);
    visitor(fields[56], value.general_flags1);
    visitor(fields[57], value.profile_flags1);
    visitor(fields[58], value.spektrum_mode);
    visitor(fields[59], value.order_of_axes);
    visitor(fields[60], value.euler_order);
    visitor(fields[61], value.cur_imu);
    visitor(fields[62], value.cur_profile_id);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadParams3Request> {
  static constexpr const char* answers[] = {"ReadParams3"};
  static constexpr MessageInfo info{
      .name = "ReadParams3Request", .command = "CMD_READ_PARAMS_3",
      .summary = "Request the parameters of one profile.", .id = 21,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to read.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
  }
};

template <>
struct Meta<msg::ReadParams> {
  static constexpr const char* answers[] = {"ReadParamsAnswer"};
  static constexpr MessageInfo info{
      .name = "ReadParams", .command = "CMD_READ_PARAMS",
      .summary = "Request the parameters of one profile, with the older id.", .id = 82,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to read.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
  }
};

template <>
struct Meta<msg::ReadParamsExt> {
  static constexpr MessageInfo info{
      .name = "ReadParamsExt", .command = "CMD_READ_PARAMS_EXT",
      .summary = "More parameters of one profile: filters, encoders, magnetometer.", .id = 33,
      .direction = Direction::from_board, .min_size = 104, .max_size = 104, .since = {.board = 30}};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr Range lpf_freq_range{0, 1000};
  static constexpr Range encoder_manual_set_time_range{0, 255};
  static constexpr Range motor_heating_factor_range{0, 255};
  static constexpr Range motor_cooling_factor_range{0, 255};
  static constexpr Range follow_inside_deadband_range{0, 255};
  static constexpr Range motor_mag_link_range{0, 255};
  static constexpr Range encoder_limit_min_range{-127, 127};
  static constexpr Range encoder_limit_max_range{-127, 127};
  static constexpr Range notch1_gain_range{-100, 100};
  static constexpr Range notch2_gain_range{-100, 100};
  static constexpr Range notch3_gain_range{-100, 100};
  static constexpr Range beeper_volume_range{0, 255};
  static constexpr Range outer_p_range{0, 255};
  static constexpr Range outer_i_range{0, 255};
  static constexpr Range mag_trust_range{0, 255};
  static constexpr Range mag_declination_range{-127, 127};
  static constexpr Range acc_lpf_freq_range{0, 1000};
  static constexpr Range d_term_lpf_freq_range{0, 60};
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile of the parameters.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
      {.name = "notches", .spec_name = "notches", .summary = "Notch filters of each axis."},
      {.name = "lpf_freq", .spec_name = "LPF_FREQ",
       .summary = "Low-pass cut-off of each axis, at its -3 dB point.",
       .unit = &UnitMeta<msg::Frequency>::info, .range = &lpf_freq_range},
      {.name = "filters_en", .spec_name = "FILTERS_EN", .summary = "Enabled filters."},
      {.name = "encoder_offset", .spec_name = "ENCODER_OFFSET",
       .summary = "Encoder angle in the zero position.", .unit = &UnitMeta<msg::Angle14>::info,
       .directed = Directed::unknown},
      {.name = "encoder_fld_offset", .spec_name = "ENCODER_FLD_OFFSET",
       .summary = "Angle between the encoder and the motor's magnetic field.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::unknown},
      {.name = "encoder_manual_set_time", .spec_name = "ENCODER_MANUAL_SET_TIME",
       .summary = "Time to set the encoder by hand.",
       .unit = &UnitMeta<msg::TensOfMilliseconds>::info, .range = &encoder_manual_set_time_range,
       .saved_as = "manual__set__time"},
      {.name = "motor_heating_factor", .spec_name = "MOTOR_HEATING_FACTOR",
       .summary = "Heating factor of the motor temperature model.",
       .range = &motor_heating_factor_range},
      {.name = "motor_cooling_factor", .spec_name = "MOTOR_COOLING_FACTOR",
       .summary = "Cooling factor of the motor temperature model.",
       .range = &motor_cooling_factor_range},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "follow_inside_deadband", .spec_name = "FOLLOW_INSIDE_DEADBAND",
       .summary = "How much to follow inside the follow mode's dead band.",
       .range = &follow_inside_deadband_range},
      {.name = "motor_mag_link", .spec_name = "MOTOR_MAG_LINK",
       .summary = "Magnetic linkage of the motor.", .range = &motor_mag_link_range,
       .saved_as = nullptr},
      {.name = "motor_gearing", .spec_name = "MOTOR_GEARING",
       .summary = "Ratio of the gear after the motor.", .unit = &UnitMeta<msg::FixedPoint8>::info,
       .saved_as = "motor__gear"},
      {.name = "encoder_limit_min", .spec_name = "ENCODER_LIMIT_MIN",
       .summary = "Lowest angle of the joint.", .unit = &UnitMeta<msg::EncoderLimit>::info,
       .range = &encoder_limit_min_range, .directed = Directed::by_axis},
      {.name = "encoder_limit_max", .spec_name = "ENCODER_LIMIT_MAX",
       .summary = "Highest angle of the joint.", .unit = &UnitMeta<msg::EncoderLimit>::info,
       .range = &encoder_limit_max_range, .directed = Directed::by_axis},
      {.name = "notch1_gain", .spec_name = "NOTCH1_GAIN",
       .summary = "Depth of the first notch filter; a negative value makes a peak filter.",
       .unit = &UnitMeta<msg::Decibels>::info, .range = &notch1_gain_range, .saved_as = "notchGain1"},
      {.name = "notch2_gain", .spec_name = "NOTCH2_GAIN",
       .summary = "Depth of the second notch filter; a negative value makes a peak filter.",
       .unit = &UnitMeta<msg::Decibels>::info, .range = &notch2_gain_range, .saved_as = "notchGain2"},
      {.name = "notch3_gain", .spec_name = "NOTCH3_GAIN",
       .summary = "Depth of the third notch filter; a negative value makes a peak filter.",
       .unit = &UnitMeta<msg::Decibels>::info, .range = &notch3_gain_range, .saved_as = "notchGain3"},
      {.name = "beeper_volume", .spec_name = "BEEPER_VOLUME", .summary = "Sound volume.",
       .range = &beeper_volume_range},
      {.name = "encoder_gear_ratio", .spec_name = "ENCODER_GEAR_RATIO",
       .summary = "Ratio of the gear between motor and encoder.",
       .unit = &UnitMeta<msg::Thousandths>::info},
      {.name = "encoder_type", .spec_name = "ENCODER_TYPE",
       .summary = "Kind and options of the encoder.", .saved_as = "encoder__types"},
      {.name = "encoder_cfg", .spec_name = "ENCODER_CFG",
       .summary = "SPI clock, or the kind of encoder in an I2C driver.", .saved_as = "encoder__cfgs"},
      {.name = "outer_p", .spec_name = "OUTER_P", .summary = "Proportional gain of the outer loop.",
       .range = &outer_p_range},
      {.name = "outer_i", .spec_name = "OUTER_I", .summary = "Integral gain of the outer loop.",
       .range = &outer_i_range},
      {.name = "mag_axis_top", .spec_name = "MAG_AXIS_TOP",
       .summary = "Axis of the magnetometer that points up."},
      {.name = "mag_axis_right", .spec_name = "MAG_AXIS_RIGHT",
       .summary = "Axis of the magnetometer that points right."},
      {.name = "mag_trust", .spec_name = "MAG_TRUST", .summary = "Trust in the magnetometer.",
       .range = &mag_trust_range},
      {.name = "mag_declination", .spec_name = "MAG_DECLINATION", .summary = "Magnetic declination.",
       .unit = &UnitMeta<msg::SignedDegrees>::info, .range = &mag_declination_range,
       .directed = Directed::by_axis},
      {.name = "acc_lpf_freq", .spec_name = "ACC_LPF_FREQ",
       .summary = "Low-pass filter of the accelerometer.",
       .unit = &UnitMeta<msg::FineFrequency>::info, .range = &acc_lpf_freq_range},
      {.name = "d_term_lpf_freq", .spec_name = "D_TERM_LPF_FREQ",
       .summary = "Low-pass filter of the derivative term.",
       .unit = &UnitMeta<msg::CoarseFrequency>::info, .range = &d_term_lpf_freq_range,
       .saved_as = "d__lpfFreq", .saved_in = SavedIn::unit},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
      {offsetof(T, notches), &detail::value_type<decltype(T::notches)>},
      {offsetof(T, lpf_freq), &detail::value_type<decltype(T::lpf_freq)>},
      {offsetof(T, filters_en), &detail::value_type<decltype(T::filters_en)>},
      {offsetof(T, encoder_offset), &detail::value_type<decltype(T::encoder_offset)>},
      {offsetof(T, encoder_fld_offset), &detail::value_type<decltype(T::encoder_fld_offset)>},
      {offsetof(T, encoder_manual_set_time), &detail::value_type<decltype(T::encoder_manual_set_time)>},
      {offsetof(T, motor_heating_factor), &detail::value_type<decltype(T::motor_heating_factor)>},
      {offsetof(T, motor_cooling_factor), &detail::value_type<decltype(T::motor_cooling_factor)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
      {offsetof(T, follow_inside_deadband), &detail::value_type<decltype(T::follow_inside_deadband)>},
      {offsetof(T, motor_mag_link), &detail::value_type<decltype(T::motor_mag_link)>},
      {offsetof(T, motor_gearing), &detail::value_type<decltype(T::motor_gearing)>},
      {offsetof(T, encoder_limit_min), &detail::value_type<decltype(T::encoder_limit_min)>},
      {offsetof(T, encoder_limit_max), &detail::value_type<decltype(T::encoder_limit_max)>},
      {offsetof(T, notch1_gain), &detail::value_type<decltype(T::notch1_gain)>},
      {offsetof(T, notch2_gain), &detail::value_type<decltype(T::notch2_gain)>},
      {offsetof(T, notch3_gain), &detail::value_type<decltype(T::notch3_gain)>},
      {offsetof(T, beeper_volume), &detail::value_type<decltype(T::beeper_volume)>},
      {offsetof(T, encoder_gear_ratio), &detail::value_type<decltype(T::encoder_gear_ratio)>},
      {offsetof(T, encoder_type), &detail::value_type<decltype(T::encoder_type)>},
      {offsetof(T, encoder_cfg), &detail::value_type<decltype(T::encoder_cfg)>},
      {offsetof(T, outer_p), &detail::value_type<decltype(T::outer_p)>},
      {offsetof(T, outer_i), &detail::value_type<decltype(T::outer_i)>},
      {offsetof(T, mag_axis_top), &detail::value_type<decltype(T::mag_axis_top)>},
      {offsetof(T, mag_axis_right), &detail::value_type<decltype(T::mag_axis_right)>},
      {offsetof(T, mag_trust), &detail::value_type<decltype(T::mag_trust)>},
      {offsetof(T, mag_declination), &detail::value_type<decltype(T::mag_declination)>},
      {offsetof(T, acc_lpf_freq), &detail::value_type<decltype(T::acc_lpf_freq)>},
      {offsetof(T, d_term_lpf_freq), &detail::value_type<decltype(T::d_term_lpf_freq)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.notches);
    visitor(fields[2], value.lpf_freq);
    visitor(fields[3], value.filters_en);
    visitor(fields[4], value.encoder_offset);
    visitor(fields[5], value.encoder_fld_offset);
    visitor(fields[6], value.encoder_manual_set_time);
    visitor(fields[7], value.motor_heating_factor);
    visitor(fields[8], value.motor_cooling_factor);
    visitor(fields[9], value.reserved);
    visitor(fields[10], value.follow_inside_deadband);
    visitor(fields[11], value.motor_mag_link);
    visitor(fields[12], value.motor_gearing);
    visitor(fields[13], value.encoder_limit_min);
    visitor(fields[14], value.encoder_limit_max);
    visitor(fields[15], value.notch1_gain);
    visitor(fields[16], value.notch2_gain);
    visitor(fields[17], value.notch3_gain);
    visitor(fields[18], value.beeper_volume);
    visitor(fields[19], value.encoder_gear_ratio);
    visitor(fields[20], value.encoder_type);
    visitor(fields[21], value.encoder_cfg);
    visitor(fields[22], value.outer_p);
    visitor(fields[23], value.outer_i);
    visitor(fields[24], value.mag_axis_top);
    visitor(fields[25], value.mag_axis_right);
    visitor(fields[26], value.mag_trust);
    visitor(fields[27], value.mag_declination);
    visitor(fields[28], value.acc_lpf_freq);
    visitor(fields[29], value.d_term_lpf_freq);
    visitor(tail_field, value.tail);
  }
  /// Calls `check(field, low, field, high, is_strict)` for each rule that low is not above high.
  template <class T, class Check>
  static constexpr void rules(const T& value, Check&& check) {
    check(fields[13], value.encoder_limit_min, fields[14], value.encoder_limit_max, false);
  }
};

template <>
struct Meta<msg::ReadParamsExtRequest> {
  static constexpr const char* answers[] = {"ReadParamsExt"};
  static constexpr MessageInfo info{
      .name = "ReadParamsExtRequest", .command = "CMD_READ_PARAMS_EXT",
      .summary = "Request more parameters of one profile.", .id = 33,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to read.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
  }
};

template <>
struct Meta<msg::ReadParamsExt2> {
  static constexpr MessageInfo info{
      .name = "ReadParamsExt2", .command = "CMD_READ_PARAMS_EXT2",
      .summary = "The third set of parameters of one profile.", .id = 62,
      .direction = Direction::from_board, .min_size = 151, .max_size = 151, .since = {.board = 30}};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr Range motor_mag_link_fine_range{0, 65535};
  static constexpr Range acc_limiter3_range{0, 200};
  static constexpr Special acc_limiter3_special[] = {
      {0, "disabled"},
  };
  static constexpr Range pid_gain_range{0, 255};
  static constexpr LaterMeaning pid_gain_later[] = {
      {.since = {.firmware = 2731}
  ,
       .unit = &UnitMeta<msg::LogarithmicGain>::info,
       .summary = "Factor for P, I and D of each axis."},
  };
  static constexpr Range frame_imu_lpf_freq_range{0, 255};
  static constexpr Range auto_pid_gain_range{0, 255};
  static constexpr Range auto_speed_range{1, 255};
  static constexpr Special auto_speed_special[] = {
      {0, "not set"},
  };
  static constexpr Range timelapse_acc_part_range{0, 250};
  static constexpr Range momentum_calib_stimulus_range{1, 255};
  static constexpr Special momentum_calib_stimulus_special[] = {
      {0, "not set"},
  };
  static constexpr Range follow_range_range{1, 180};
  static constexpr Special follow_range_special[] = {
      {0, "not set"},
  };
  static constexpr Range outer_mot_tilt_angle_range{-90, 90};
  static constexpr Range auto_pid_momentum_range{0, 255};
  static constexpr Special auto_pid_momentum_special[] = {
      {0, "automatic"},
  };
  static constexpr Range middle_mot_tilt_angle_range{-90, 90};
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile of the parameters.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
      {.name = "mav_channels", .spec_name = "mav_channels", .summary = "MAVLink channels.",
       .since = {.firmware = 2600}},
      {.name = "motor_mag_link_fine", .spec_name = "MOTOR_MAG_LINK_FINE",
       .summary = "Magnetic linkage of the motor.", .unit = &UnitMeta<msg::LongHundredths>::info,
       .range = &motor_mag_link_fine_range},
      {.name = "acc_limiter3", .spec_name = "ACC_LIMITER3",
       .summary = "Acceleration limit of each axis.",
       .unit = &UnitMeta<msg::AngularAcceleration>::info, .range = &acc_limiter3_range,
       .special = acc_limiter3_special, .saved_as = "angleAccLimit3", .since = {.firmware = 2590}},
      {.name = "pid_gain", .spec_name = "PID_GAIN", .summary = "Factor for P, I and D of each axis.",
       .unit = &UnitMeta<msg::PidGain>::info, .range = &pid_gain_range, .later = pid_gain_later},
      {.name = "frame_imu_lpf_freq", .spec_name = "FRAME_IMU_LPF_FREQ",
       .summary = "Low-pass filter of the frame IMU.", .unit = &UnitMeta<msg::SmallFrequency>::info,
       .range = &frame_imu_lpf_freq_range},
      {.name = "auto_pid_cfg", .spec_name = "AUTO_PID_CFG", .summary = "CFG_FLAGS for CMD_AUTO_PID."},
      {.name = "auto_pid_gain", .spec_name = "AUTO_PID_GAIN",
       .summary = "GAIN_VS_STABILITY for CMD_AUTO_PID.", .range = &auto_pid_gain_range},
      {.name = "frame_cam_angle_min", .spec_name = "FRAME_CAM_ANGLE_MIN",
       .summary = "Lowest angle of the joint.", .unit = &UnitMeta<msg::Degrees>::info,
       .directed = Directed::by_axis, .since = {.firmware = 2610}},
      {.name = "frame_cam_angle_max", .spec_name = "FRAME_CAM_ANGLE_MAX",
       .summary = "Highest angle of the joint.", .unit = &UnitMeta<msg::Degrees>::info,
       .directed = Directed::by_axis, .since = {.firmware = 2610}},
      {.name = "general_flags2", .spec_name = "GENERAL_FLAGS2",
       .summary = "More options of the whole board.", .role = FieldRole::general,
       .since = {.firmware = 2610}},
      {.name = "auto_speed", .spec_name = "AUTO_SPEED", .summary = "Speed of automatic motions.",
       .range = &auto_speed_range, .special = auto_speed_special, .since = {.firmware = 2610}},
      {.name = "auto_acc_limiter", .spec_name = "AUTO_ACC_LIMITER",
       .summary = "Acceleration limit of automatic motions.",
       .unit = &UnitMeta<msg::AngularAcceleration>::info, .saved_as = "auto__acc__limit",
       .since = {.firmware = 2610}},
      {.name = "imu_orientation_corr", .spec_name = "IMU_ORIENTATION_CORR",
       .summary = "Correction of the orientation of the main IMU.",
       .unit = &UnitMeta<msg::HundredthDegrees>::info, .directed = Directed::unknown,
       .saved_as = "orientation__corr", .since = {.firmware = 2610}},
      {.name = "timelapse_time", .spec_name = "TIMELAPSE_TIME",
       .summary = "Duration of a time lapse.", .unit = &UnitMeta<msg::Seconds>::info,
       .saved_in = SavedIn::raw, .since = {.firmware = 2600}},
      {.name = "emergency_stop_restart_delay", .spec_name = "EMERGENCY_STOP_RESTART_DELAY",
       .summary = "Delay between an emergency stop and the restart.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .since = {.firmware = 2610}},
      {.name = "timelapse_acc_part", .spec_name = "TIMELAPSE_ACC_PART",
       .summary = "Share of a time lapse in which the speed changes.",
       .unit = &UnitMeta<msg::FifthPercent>::info, .range = &timelapse_acc_part_range,
       .since = {.firmware = 2610}},
      {.name = "momentum", .spec_name = "MOMENTUM", .summary = "Moment of inertia of the axis.",
       .since = {.firmware = 2627}},
      {.name = "momentum_calib_stimulus", .spec_name = "MOMENTUM_CALIB_STIMULUS",
       .summary = "Stimulus for the calibration of the momentum.",
       .range = &momentum_calib_stimulus_range, .special = momentum_calib_stimulus_special,
       .saved_as = "momentum__stimulus", .since = {.firmware = 2627}},
      {.name = "momentum_ellipticity", .spec_name = "MOMENTUM_ELLIPTICITY",
       .summary = "How much the momentum depends on the angle.",
       .unit = &UnitMeta<msg::Twentieths>::info, .since = {.firmware = 2627}},
      {.name = "follow_range", .spec_name = "FOLLOW_RANGE", .summary = "Range of the follow mode.",
       .range = &follow_range_range, .special = follow_range_special, .since = {.firmware = 2627}},
      {.name = "stab_axis", .spec_name = "STAB_AXIS", .summary = "Axis that the motor stabilizes.",
       .since = {.firmware = 2627}},
      {.name = "outer_mot_tilt_angle", .spec_name = "OUTER_MOT_TILT_ANGLE",
       .summary = "Tilt of the outer motor.", .unit = &UnitMeta<msg::SignedDegrees>::info,
       .range = &outer_mot_tilt_angle_range, .role = FieldRole::general,
       .directed = Directed::by_axis, .saved_as = "outer__motor__tilt", .since = {.firmware = 2627}},
      {.name = "startup_action", .spec_name = "STARTUP_ACTION", .summary = "Actions at start-up.",
       .since = {.firmware = 2660}},
      {.name = "startup_action_src", .spec_name = "STARTUP_ACTION_SRC",
       .summary = "RC signals that are conditions of the actions: a first one for each, then a second one.",
       .since = {.firmware = 2660}},
      {.name = "startup_action_threshold", .spec_name = "STARTUP_ACTION_THRESHOLD",
       .summary = "Thresholds of these signals, in steps of 10.", .saved_as = "startup__action__thr",
       .since = {.firmware = 2660}},
      {.name = "force_position_cfg", .spec_name = "FORCE_POSITION_CFG",
       .summary = "When and how the axis snaps to a fixed position.", .saved_as = "force__position",
       .since = {.firmware = 2660}},
      {.name = "step_signals", .spec_name = "step_signals",
       .summary = "Step signals: each counts how often an RC signal reaches a level.",
       .since = {.firmware = 2660}},
      {.name = "rc_calibrations", .spec_name = "rc_calibrations",
       .summary = "Calibrations of RC signals: an offset is added, then a factor is applied.",
       .since = {.firmware = 2660}},
      {.name = "parking_pos_cfg", .spec_name = "PARKING_POS_CFG",
       .summary = "Limits at which the axes park.", .saved_as = "parking__cfg",
       .since = {.firmware = 2660}},
      {.name = "ext_led_pin_id", .spec_name = "EXT_LED_PIN_ID",
       .summary = "Pin that repeats the signals of the LED.", .role = FieldRole::general,
       .saved_as = "ext__led__pin", .since = {.firmware = 2660}},
      {.name = "interrupt_cfg", .spec_name = "INTERRUPT_CFG",
       .summary = "Pin that signals an event to other devices.", .role = FieldRole::general,
       .since = {.firmware = 2660}},
      {.name = "overload_time", .spec_name = "OVERLOAD_TIME",
       .summary = "How long the motors may be overloaded.",
       .unit = &UnitMeta<msg::HundredsOfMilliseconds>::info, .since = {.firmware = 2660}},
      {.name = "auto_pid_momentum", .spec_name = "AUTO_PID_MOMENTUM",
       .summary = "MOMENTUM for CMD_AUTO_PID.", .range = &auto_pid_momentum_range,
       .special = auto_pid_momentum_special, .since = {.firmware = 2660}},
      {.name = "jerk_slope", .spec_name = "JERK_SLOPE",
       .summary = "How slowly the acceleration changes.", .since = {.firmware = 2660}},
      {.name = "mav_ctrl_mode", .spec_name = "MAV_CTRL_MODE",
       .summary = "Axes that a MAVLink host controls.", .since = {.firmware = 2660}},
      {.name = "rc_serial_speed", .spec_name = "RC_SERIAL_SPEED",
       .summary = "Baud rate of the serial RC input.", .role = FieldRole::general,
       .since = {.firmware = 2660}},
      {.name = "uart2_speed", .spec_name = "UART2_SPEED", .summary = "Baud rate of UART 2.",
       .role = FieldRole::general, .since = {.firmware = 2660}},
      {.name = "motor_res", .spec_name = "MOTOR_RES",
       .summary = "Resistance of one phase of the motor.", .unit = &UnitMeta<msg::TenthOhms>::info,
       .since = {.firmware = 2660}},
      {.name = "current_limit", .spec_name = "CURRENT_LIMIT",
       .summary = "Limit of the total current.", .unit = &UnitMeta<msg::TensOfMilliamperes>::info,
       .since = {.firmware = 2660}},
      {.name = "middle_mot_tilt_angle", .spec_name = "MIDDLE_MOT_TILT_ANGLE",
       .summary = "Tilt of the middle motor.", .unit = &UnitMeta<msg::SignedDegrees>::info,
       .range = &middle_mot_tilt_angle_range, .role = FieldRole::general,
       .directed = Directed::by_axis, .saved_as = "middle__motor__tilt", .since = {.firmware = 2670}},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
      {offsetof(T, mav_channels), &detail::value_type<decltype(T::mav_channels)>},
      {offsetof(T, motor_mag_link_fine), &detail::value_type<decltype(T::motor_mag_link_fine)>},
      {offsetof(T, acc_limiter3), &detail::value_type<decltype(T::acc_limiter3)>},
      {offsetof(T, pid_gain), &detail::value_type<decltype(T::pid_gain)>},
      {offsetof(T, frame_imu_lpf_freq), &detail::value_type<decltype(T::frame_imu_lpf_freq)>},
      {offsetof(T, auto_pid_cfg), &detail::value_type<decltype(T::auto_pid_cfg)>},
      {offsetof(T, auto_pid_gain), &detail::value_type<decltype(T::auto_pid_gain)>},
      {offsetof(T, frame_cam_angle_min), &detail::value_type<decltype(T::frame_cam_angle_min)>},
      {offsetof(T, frame_cam_angle_max), &detail::value_type<decltype(T::frame_cam_angle_max)>},
      {offsetof(T, general_flags2), &detail::value_type<decltype(T::general_flags2)>},
      {offsetof(T, auto_speed), &detail::value_type<decltype(T::auto_speed)>},
      {offsetof(T, auto_acc_limiter), &detail::value_type<decltype(T::auto_acc_limiter)>},
      {offsetof(T, imu_orientation_corr), &detail::value_type<decltype(T::imu_orientation_corr)>},
      {offsetof(T, timelapse_time), &detail::value_type<decltype(T::timelapse_time)>},
      {offsetof(T, emergency_stop_restart_delay), &detail::value_type<decltype(T::emergency_stop_restart_delay)>},
      {offsetof(T, timelapse_acc_part), &detail::value_type<decltype(T::timelapse_acc_part)>},
      {offsetof(T, momentum), &detail::value_type<decltype(T::momentum)>},
      {offsetof(T, momentum_calib_stimulus), &detail::value_type<decltype(T::momentum_calib_stimulus)>},
      {offsetof(T, momentum_ellipticity), &detail::value_type<decltype(T::momentum_ellipticity)>},
      {offsetof(T, follow_range), &detail::value_type<decltype(T::follow_range)>},
      {offsetof(T, stab_axis), &detail::value_type<decltype(T::stab_axis)>},
      {offsetof(T, outer_mot_tilt_angle), &detail::value_type<decltype(T::outer_mot_tilt_angle)>},
      {offsetof(T, startup_action), &detail::value_type<decltype(T::startup_action)>},
      {offsetof(T, startup_action_src), &detail::value_type<decltype(T::startup_action_src)>},
      {offsetof(T, startup_action_threshold), &detail::value_type<decltype(T::startup_action_threshold)>},
      {offsetof(T, force_position_cfg), &detail::value_type<decltype(T::force_position_cfg)>},
      {offsetof(T, step_signals), &detail::value_type<decltype(T::step_signals)>},
      {offsetof(T, rc_calibrations), &detail::value_type<decltype(T::rc_calibrations)>},
      {offsetof(T, parking_pos_cfg), &detail::value_type<decltype(T::parking_pos_cfg)>},
      {offsetof(T, ext_led_pin_id), &detail::value_type<decltype(T::ext_led_pin_id)>},
      {offsetof(T, interrupt_cfg), &detail::value_type<decltype(T::interrupt_cfg)>},
      {offsetof(T, overload_time), &detail::value_type<decltype(T::overload_time)>},
      {offsetof(T, auto_pid_momentum), &detail::value_type<decltype(T::auto_pid_momentum)>},
      {offsetof(T, jerk_slope), &detail::value_type<decltype(T::jerk_slope)>},
      {offsetof(T, mav_ctrl_mode), &detail::value_type<decltype(T::mav_ctrl_mode)>},
      {offsetof(T, rc_serial_speed), &detail::value_type<decltype(T::rc_serial_speed)>},
      {offsetof(T, uart2_speed), &detail::value_type<decltype(T::uart2_speed)>},
      {offsetof(T, motor_res), &detail::value_type<decltype(T::motor_res)>},
      {offsetof(T, current_limit), &detail::value_type<decltype(T::current_limit)>},
      {offsetof(T, middle_mot_tilt_angle), &detail::value_type<decltype(T::middle_mot_tilt_angle)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.mav_channels);
    visitor(fields[2], value.motor_mag_link_fine);
    visitor(fields[3], value.acc_limiter3);
    visitor(fields[4], value.pid_gain);
    visitor(fields[5], value.frame_imu_lpf_freq);
    visitor(fields[6], value.auto_pid_cfg);
    visitor(fields[7], value.auto_pid_gain);
    visitor(fields[8], value.frame_cam_angle_min);
    visitor(fields[9], value.frame_cam_angle_max);
    visitor(fields[10], value.general_flags2);
    visitor(fields[11], value.auto_speed);
    visitor(fields[12], value.auto_acc_limiter);
    visitor(fields[13], value.imu_orientation_corr);
    visitor(fields[14], value.timelapse_time);
    visitor(fields[15], value.emergency_stop_restart_delay);
    visitor(fields[16], value.timelapse_acc_part);
    visitor(fields[17], value.momentum);
    visitor(fields[18], value.momentum_calib_stimulus);
    visitor(fields[19], value.momentum_ellipticity);
    visitor(fields[20], value.follow_range);
    visitor(fields[21], value.stab_axis);
    visitor(fields[22], value.outer_mot_tilt_angle);
    visitor(fields[23], value.startup_action);
    visitor(fields[24], value.startup_action_src);
    visitor(fields[25], value.startup_action_threshold);
    visitor(fields[26], value.force_position_cfg);
    visitor(fields[27], value.step_signals);
    visitor(fields[28], value.rc_calibrations);
    visitor(fields[29], value.parking_pos_cfg);
    visitor(fields[30], value.ext_led_pin_id);
    visitor(fields[31], value.interrupt_cfg);
    visitor(fields[32], value.overload_time);
    visitor(fields[33], value.auto_pid_momentum);
    visitor(fields[34], value.jerk_slope);
    visitor(fields[35], value.mav_ctrl_mode);
    visitor(fields[36], value.rc_serial_speed);
    visitor(fields[37], value.uart2_speed);
    visitor(fields[38], value.motor_res);
    visitor(fields[39], value.current_limit);
    visitor(fields[40], value.middle_mot_tilt_angle);
    visitor(tail_field, value.tail);
  }
  /// Calls `check(field, low, field, high, is_strict)` for each rule that low is not above high.
  template <class T, class Check>
  static constexpr void rules(const T& value, Check&& check) {
    check(fields[8], value.frame_cam_angle_min, fields[9], value.frame_cam_angle_max, false);
  }
};

template <>
struct Meta<msg::ReadParamsExt2Request> {
  static constexpr const char* answers[] = {"ReadParamsExt2"};
  static constexpr MessageInfo info{
      .name = "ReadParamsExt2Request", .command = "CMD_READ_PARAMS_EXT2",
      .summary = "Request the third set of parameters of one profile.", .id = 62,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to read.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
  }
};

template <>
struct Meta<msg::WriteParamsSet> {
  static constexpr MessageInfo info{
      .name = "WriteParamsSet", .command = "CMD_WRITE_PARAMS_SET",
      .summary = "Begin or end a series of commands that store parameters.", .id = 119,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.firmware = 2704},
      .effects = Effects(Effect::sets) | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "action", .spec_name = "ACTION", .summary = "Whether the series begins or ends."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.action);
  }
};

template <>
struct Meta<msg::ReadProfileNames> {
  static constexpr MessageInfo info{
      .name = "ReadProfileNames", .command = "CMD_READ_PROFILE_NAMES", .summary = "Profile names.",
      .id = 28, .direction = Direction::from_board, .min_size = 240, .max_size = 240,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "profile_name", .spec_name = "PROFILE{1..5}_NAME", .summary = "Name of each profile."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_name), &detail::value_type<decltype(T::profile_name)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_name);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadProfileNamesRequest> {
  static constexpr const char* answers[] = {"ReadProfileNames"};
  static constexpr MessageInfo info{
      .name = "ReadProfileNamesRequest", .command = "CMD_READ_PROFILE_NAMES",
      .summary = "Request the profile names.", .id = 28, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::ProfileSet> {
  static constexpr MessageInfo info{
      .name = "ProfileSet", .command = "CMD_PROFILE_SET",
      .summary = "Save, clear or load a profile set.", .id = 95, .direction = Direction::to_board,
      .min_size = 10, .max_size = 10, .since = {.firmware = 2650},
      .effects = Effects(Effect::stores) | Effect::moves | Effect::erases};
  static constexpr Range slot_range{1, 5};
  static constexpr Special slot_special[] = {
      {6, "the backup"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "slot", .spec_name = "SLOT", .summary = "Place of the profile set.",
       .range = &slot_range, .special = slot_special},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, slot), &detail::value_type<decltype(T::slot)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.slot);
    visitor(fields[1], value.action);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::SaveParams3> {
  static constexpr MessageInfo info{
      .name = "SaveParams3", .command = "CMD_SAVE_PARAMS_3",
      .summary = "Save the parameters in use, with all changes to adjustable variables, to the active profile.",
      .id = 32, .direction = Direction::to_board, .min_size = 0, .max_size = 255,
      .since = {.board = 30}, .effects = Effects(Effect::stores)};
  static constexpr FieldInfo fields[] = {
      {.name = "param_id", .spec_name = "PARAM_ID",
       .summary = "Variables to save; none stands for all.", .since = {.firmware = 2689}},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, param_id), &detail::value_type<decltype(T::param_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.param_id);
  }
};

template <>
struct Meta<msg::UseDefaults> {
  static constexpr MessageInfo info{
      .name = "UseDefaults", .command = "CMD_USE_DEFAULTS",
      .summary = "Restore the factory defaults.", .id = 70, .direction = Direction::to_board,
      .min_size = 1, .max_size = 1,
      .effects = Effects(Effect::stores) | Effect::moves | Effect::erases};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {253, "erases the EEPROM"},
      {254, "resets the active profile"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to reset.",
       .range = &profile_id_range, .special = profile_id_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
  }
};

template <>
struct Meta<msg::WriteParams3> : Meta<msg::ReadParams3> {
  static constexpr MessageInfo info{
      .name = "WriteParams3", .command = "CMD_WRITE_PARAMS_3",
      .summary = "Store the parameters of one profile and the general parameters.", .id = 22,
      .direction = Direction::to_board, .min_size = 134, .max_size = 134, .since = {.board = 30},
      .stores = "ReadParams3", .effects = Effects(Effect::stores) | Effect::moves};
};

template <>
struct Meta<msg::ReadParamsAnswer> : Meta<msg::ReadParams3> {
  static constexpr MessageInfo info{
      .name = "ReadParamsAnswer", .command = "CMD_READ_PARAMS",
      .summary = "Parameters of one profile and general parameters, with the older id.", .id = 82,
      .direction = Direction::from_board, .min_size = 134, .max_size = 134};
};

template <>
struct Meta<msg::WriteParams> : Meta<msg::ReadParams3> {
  static constexpr MessageInfo info{
      .name = "WriteParams", .command = "CMD_WRITE_PARAMS",
      .summary = "Store the parameters of one profile and the general parameters, with the older id.",
      .id = 87, .direction = Direction::to_board, .min_size = 134, .max_size = 134,
      .stores = "ReadParams3", .effects = Effects(Effect::stores) | Effect::moves};
};

template <>
struct Meta<msg::WriteParamsExt> : Meta<msg::ReadParamsExt> {
  static constexpr MessageInfo info{
      .name = "WriteParamsExt", .command = "CMD_WRITE_PARAMS_EXT",
      .summary = "Store more parameters of one profile.", .id = 34, .direction = Direction::to_board,
      .min_size = 104, .max_size = 104, .since = {.board = 30}, .stores = "ReadParamsExt",
      .effects = Effects(Effect::stores) | Effect::moves};
};

template <>
struct Meta<msg::WriteParamsExt2> : Meta<msg::ReadParamsExt2> {
  static constexpr MessageInfo info{
      .name = "WriteParamsExt2", .command = "CMD_WRITE_PARAMS_EXT2",
      .summary = "Store the third set of parameters of one profile.", .id = 63,
      .direction = Direction::to_board, .min_size = 151, .max_size = 151, .since = {.board = 30},
      .stores = "ReadParamsExt2", .effects = Effects(Effect::stores) | Effect::moves};
};

template <>
struct Meta<msg::WriteProfileNames> : Meta<msg::ReadProfileNames> {
  static constexpr MessageInfo info{
      .name = "WriteProfileNames", .command = "CMD_WRITE_PROFILE_NAMES",
      .summary = "Store the profile names.", .id = 29, .direction = Direction::to_board,
      .min_size = 240, .max_size = 240, .since = {.board = 30}, .stores = "ReadProfileNames",
      .effects = Effects(Effect::stores)};
};

}  // namespace sbgc

#pragma GCC diagnostic pop
