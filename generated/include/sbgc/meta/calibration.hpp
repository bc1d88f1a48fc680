// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/calibration.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::AxisTuning> {
  static constexpr FieldInfo fields[] = {
      {.name = "tracking_error", .spec_name = "TRACKING_ERROR",
       .summary = "Tracking error of the axis."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, tracking_error), &detail::value_type<decltype(T::tracking_error)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.tracking_error);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::AxisTuningConfig> {
  static constexpr FieldInfo fields[] = {
      {.name = "axis_flags", .spec_name = "AXIS_FLAGS", .summary = "What to tune."},
      {.name = "gain", .spec_name = "GAIN", .summary = "Gain to aim for."},
      {.name = "stimulus_gain", .spec_name = "STIMULUS_GAIN",
       .summary = "Strength of the test signal."},
      {.name = "effective_freq", .spec_name = "EFFECTIVE_FREQ", .summary = "Effective frequency.",
       .unit = &UnitMeta<msg::SmallFrequency>::info},
      {.name = "problem_freq", .spec_name = "PROBLEM_FREQ",
       .summary = "Frequency of a known problem.", .unit = &UnitMeta<msg::SmallFrequency>::info},
      {.name = "problem_margin", .spec_name = "PROBLEM_MARGIN",
       .summary = "Margin at that frequency.", .unit = &UnitMeta<msg::TenthDecibels>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axis_flags), &detail::value_type<decltype(T::axis_flags)>},
      {offsetof(T, gain), &detail::value_type<decltype(T::gain)>},
      {offsetof(T, stimulus_gain), &detail::value_type<decltype(T::stimulus_gain)>},
      {offsetof(T, effective_freq), &detail::value_type<decltype(T::effective_freq)>},
      {offsetof(T, problem_freq), &detail::value_type<decltype(T::problem_freq)>},
      {offsetof(T, problem_margin), &detail::value_type<decltype(T::problem_margin)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axis_flags);
    visitor(fields[1], value.gain);
    visitor(fields[2], value.stimulus_gain);
    visitor(fields[3], value.effective_freq);
    visitor(fields[4], value.problem_freq);
    visitor(fields[5], value.problem_margin);
    visitor(fields[6], value.reserved);
  }
};

template <>
struct Meta<msg::AutoPid2Config> {
  static constexpr Range cfg_version_range{1, 1};
  static constexpr FieldInfo fields[] = {
      {.name = "cfg_version", .spec_name = "CFG_VERSION", .summary = "Version of the configuration.",
       .range = &cfg_version_range},
      {.name = "axes", .spec_name = "axes", .summary = "How to tune each axis."},
      {.name = "general_flags", .spec_name = "GENERAL_FLAGS", .summary = "Options."},
      {.name = "reserved_1", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "test_freq_from", .spec_name = "TEST_FREQ_FROM",
       .summary = "Lowest frequency of the test signal.", .unit = &UnitMeta<msg::TenthHertz>::info},
      {.name = "test_freq_to", .spec_name = "TEST_FREQ_TO",
       .summary = "Highest frequency of the test signal.", .unit = &UnitMeta<msg::TwoHertz>::info},
      {.name = "multi_pos_flag", .spec_name = "MULTI_POS_FLAG",
       .summary = "Positions in which to tune."},
      {.name = "multi_pos_angle", .spec_name = "MULTI_POS_ANGLE",
       .summary = "Angle of each position.", .unit = &UnitMeta<msg::EncoderLimit>::info,
       .directed = Directed::by_axis},
      {.name = "reserved_2", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cfg_version), &detail::value_type<decltype(T::cfg_version)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, general_flags), &detail::value_type<decltype(T::general_flags)>},
      {offsetof(T, reserved_1), &detail::value_type<decltype(T::reserved_1)>},
      {offsetof(T, test_freq_from), &detail::value_type<decltype(T::test_freq_from)>},
      {offsetof(T, test_freq_to), &detail::value_type<decltype(T::test_freq_to)>},
      {offsetof(T, multi_pos_flag), &detail::value_type<decltype(T::multi_pos_flag)>},
      {offsetof(T, multi_pos_angle), &detail::value_type<decltype(T::multi_pos_angle)>},
      {offsetof(T, reserved_2), &detail::value_type<decltype(T::reserved_2)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cfg_version);
    visitor(fields[1], value.axes);
    visitor(fields[2], value.general_flags);
    visitor(fields[3], value.reserved_1);
    visitor(fields[4], value.test_freq_from);
    visitor(fields[5], value.test_freq_to);
    visitor(fields[6], value.multi_pos_flag);
    visitor(fields[7], value.multi_pos_angle);
    visitor(fields[8], value.reserved_2);
  }
};

template <>
struct Meta<msg::CoggingMotor> {
  static constexpr Range angle_range{20, 360};
  static constexpr Range smooth_range{0, 100};
  static constexpr Special period_special[] = {
      {0, "automatic"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "angle", .spec_name = "ANGLE", .summary = "Angle by which the motor turns.",
       .unit = &UnitMeta<msg::WideDegrees>::info, .range = &angle_range},
      {.name = "smooth", .spec_name = "SMOOTH", .summary = "Smoothing of the result.",
       .unit = &UnitMeta<msg::Percent>::info, .range = &smooth_range},
      {.name = "speed", .spec_name = "SPEED", .summary = "Speed of the motion; relative."},
      {.name = "period", .spec_name = "PERIOD", .summary = "Angle after which the cogging repeats.",
       .unit = &UnitMeta<msg::WideDegrees>::info, .special = period_special},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, angle), &detail::value_type<decltype(T::angle)>},
      {offsetof(T, smooth), &detail::value_type<decltype(T::smooth)>},
      {offsetof(T, speed), &detail::value_type<decltype(T::speed)>},
      {offsetof(T, period), &detail::value_type<decltype(T::period)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.angle);
    visitor(fields[1], value.smooth);
    visitor(fields[2], value.speed);
    visitor(fields[3], value.period);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::BodeSample> {
  static constexpr Range input_range{0, 65534};
  static constexpr Range output_range{0, 65534};
  static constexpr FieldInfo fields[] = {
      {.name = "input", .spec_name = "INPUT", .summary = "Input.", .range = &input_range},
      {.name = "output", .spec_name = "OUTPUT", .summary = "Output.", .range = &output_range},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, input), &detail::value_type<decltype(T::input)>},
      {offsetof(T, output), &detail::value_type<decltype(T::output)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.input);
    visitor(fields[1], value.output);
  }
};

template <>
struct Meta<msg::CalibAcc> {
  static constexpr MessageInfo info{
      .name = "CalibAcc", .command = "CMD_CALIB_ACC",
      .summary = "Calibrate the accelerometer of the active IMU.", .id = 65,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::stores),
      .preparation = "Place the camera so that the sensor is exactly level, on something that does not move, and turn the motors off. To calibrate the other directions as well, repeat it with each side of the sensor upwards; CMD_CALIB_INFO shows which ones are done."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibAccExt> {
  static constexpr MessageInfo info{
      .name = "CalibAccExt", .command = "CMD_CALIB_ACC",
      .summary = "Calibrate the accelerometer of an IMU, or manage its calibrations.", .id = 65,
      .direction = Direction::to_board, .min_size = 12, .max_size = 12,
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases,
      .preparation = "Place the camera so that the sensor is exactly level, on something that does not move, and turn the motors off. To calibrate the other directions as well, repeat it with each side of the sensor upwards; CMD_CALIB_INFO shows which ones are done. For TEMPERATURE, cool the sensor down first; it is calibrated while it warms up by itself."};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_idx", .spec_name = "IMU_IDX", .summary = "The IMU."},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "time_ms", .spec_name = "TIME_MS",
       .summary = "Without meaning here; the duration of the calibration of a gyroscope.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .since = {.firmware = 2600}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_idx), &detail::value_type<decltype(T::imu_idx)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_idx);
    visitor(fields[1], value.action);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::CalibGyro> {
  static constexpr MessageInfo info{
      .name = "CalibGyro", .command = "CMD_CALIB_GYRO",
      .summary = "Calibrate the gyroscope of the active IMU.", .id = 103,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::stores),
      .preparation = "Leave the camera completely still, in any position, and turn the motors off; do not touch it until the end."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibGyroExt> {
  static constexpr MessageInfo info{
      .name = "CalibGyroExt", .command = "CMD_CALIB_GYRO",
      .summary = "Calibrate the gyroscope of an IMU, or manage its calibrations.", .id = 103,
      .direction = Direction::to_board, .min_size = 12, .max_size = 12,
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases,
      .preparation = "Leave the camera completely still, in any position, and turn the motors off; do not touch it until the end. For TEMPERATURE, cool the sensor down first; it is calibrated while it warms up by itself."};
  static constexpr Special time_ms_special[] = {
      {0, "about 4 s"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "imu_idx", .spec_name = "IMU_IDX", .summary = "The IMU."},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "time_ms", .spec_name = "TIME_MS",
       .summary = "Duration of the calibration of a gyroscope.",
       .unit = &UnitMeta<msg::Milliseconds>::info, .special = time_ms_special,
       .since = {.firmware = 2600}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_idx), &detail::value_type<decltype(T::imu_idx)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_idx);
    visitor(fields[1], value.action);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::CalibMag> {
  static constexpr MessageInfo info{
      .name = "CalibMag", .command = "CMD_CALIB_MAG", .summary = "Calibrate the magnetometer.",
      .id = 59, .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .since = {.board = 30}, .effects = Effects(Effect::stores),
      .preparation = "Take the gimbal away from steel and from other motors, and turn the motors off. While the calibration runs, turn the sensor slowly about all its axes, until every side has pointed in every direction."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibMagExt> {
  static constexpr MessageInfo info{
      .name = "CalibMagExt", .command = "CMD_CALIB_MAG",
      .summary = "Calibrate the magnetometer of an IMU, or manage its calibrations.", .id = 59,
      .direction = Direction::to_board, .min_size = 12, .max_size = 12, .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::restarts | Effect::erases,
      .preparation = "Take the gimbal away from steel and from other motors, and turn the motors off. While the calibration runs, turn the sensor slowly about all its axes, until every side has pointed in every direction."};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_idx", .spec_name = "IMU_IDX", .summary = "The IMU."},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "time_ms", .spec_name = "TIME_MS",
       .summary = "Without meaning here; the duration of the calibration of a gyroscope.",
       .unit = &UnitMeta<msg::Milliseconds>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_idx), &detail::value_type<decltype(T::imu_idx)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_idx);
    visitor(fields[1], value.action);
    visitor(fields[2], value.time_ms);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::CalibExtGain> {
  static constexpr MessageInfo info{
      .name = "CalibExtGain", .command = "CMD_CALIB_EXT_GAIN",
      .summary = "Calibrate the gains of a flight controller's signals.", .id = 71,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::stores) | Effect::moves,
      .preparation = "Connect the flight controller and level the camera. While the calibration runs, tilt the frame smoothly by 20 to 40 degrees to both sides, in roll and in pitch."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibPoles> {
  static constexpr MessageInfo info{
      .name = "CalibPoles", .command = "CMD_CALIB_POLES",
      .summary = "Detect the poles and the direction of the motors.", .id = 80,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .effects = Effects(Effect::stores) | Effect::moves,
      .preparation = "Balance the camera, fasten the frame, and make sure that all axes turn freely: the motors turn the camera. Their power must be set high enough to hold it."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibOffset> {
  static constexpr MessageInfo info{
      .name = "CalibOffset", .command = "CMD_CALIB_OFFSET",
      .summary = "Calibrate the follow mode offset.", .id = 79, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .effects = Effects(Effect::stores) | Effect::moves,
      .preparation = "Level the frame, and turn the camera to the position, relative to the frame, that it should have in follow mode."};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::CalibBat> {
  static constexpr MessageInfo info{
      .name = "CalibBat", .command = "CMD_CALIB_BAT",
      .summary = "Calibrate the battery voltage measurement.", .id = 66,
      .direction = Direction::to_board, .min_size = 2, .max_size = 2,
      .effects = Effects(Effect::stores),
      .preparation = "Measure the voltage of the battery with a voltmeter, at the connector of the board, while the board is on."};
  static constexpr FieldInfo fields[] = {
      {.name = "actual_voltage", .spec_name = "ACTUAL_VOLTAGE",
       .summary = "Actual voltage, measured externally.", .unit = &UnitMeta<msg::Voltage>::info},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, actual_voltage), &detail::value_type<decltype(T::actual_voltage)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.actual_voltage);
  }
};

template <>
struct Meta<msg::CalibInfo> {
  static constexpr MessageInfo info{
      .name = "CalibInfo", .command = "CMD_CALIB_INFO", .summary = "Calibration status for display.",
      .id = 49, .direction = Direction::from_board, .min_size = 33, .max_size = 33,
      .since = {.board = 30}};
  static constexpr Range progress_range{0, 100};
  static constexpr Range acc_cur_axis_range{0, 2};
  static constexpr Range imu_temp_cels_range{-127, 127};
  static constexpr Range temp_calib_gyro_enabled_range{0, 1};
  static constexpr Range temp_calib_gyro_t_min_cels_range{-127, 127};
  static constexpr Range temp_calib_gyro_t_max_cels_range{-127, 127};
  static constexpr Range temp_calib_acc_enabled_range{0, 1};
  static constexpr Range temp_calib_acc_slot_num_range{0, 3};
  static constexpr Range temp_calib_acc_t_min_cels_range{-127, 127};
  static constexpr Range temp_calib_acc_t_max_cels_range{-127, 127};
  static constexpr Range h1_err_length_range{0, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "progress", .spec_name = "PROGRESS", .summary = "Progress of the calibration.",
       .unit = &UnitMeta<msg::Percent>::info, .range = &progress_range},
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "acc_data", .spec_name = "ACC_DATA",
       .summary = "Accelerometer, as in CMD_REALTIME_DATA_3.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::by_axis},
      {.name = "gyro_abs_val", .spec_name = "GYRO_ABS_VAL",
       .summary = "Magnitude of the gyroscope signal."},
      {.name = "acc_cur_axis", .spec_name = "ACC_CUR_AXIS",
       .summary = "Accelerometer axis to calibrate next.", .range = &acc_cur_axis_range},
      {.name = "acc_limits_info", .spec_name = "ACC_LIMITS_INFO",
       .summary = "Calibrated directions of the accelerometer."},
      {.name = "imu_temp_cels", .spec_name = "IMU_TEMP_CELS", .summary = "Temperature of the IMU.",
       .unit = &UnitMeta<msg::Temperature>::info, .range = &imu_temp_cels_range},
      {.name = "temp_calib_gyro_enabled", .spec_name = "TEMP_CALIB_GYRO_ENABLED",
       .summary = "1 if the gyroscope's calibration over temperature is enabled.",
       .range = &temp_calib_gyro_enabled_range},
      {.name = "temp_calib_gyro_t_min_cels", .spec_name = "TEMP_CALIB_GYRO_T_MIN_CELS",
       .summary = "Lowest temperature of the gyroscope's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info, .range = &temp_calib_gyro_t_min_cels_range},
      {.name = "temp_calib_gyro_t_max_cels", .spec_name = "TEMP_CALIB_GYRO_T_MAX_CELS",
       .summary = "Highest temperature of the gyroscope's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info, .range = &temp_calib_gyro_t_max_cels_range},
      {.name = "temp_calib_acc_enabled", .spec_name = "TEMP_CALIB_ACC_ENABLED",
       .summary = "1 if the accelerometer's calibration over temperature is enabled.",
       .range = &temp_calib_acc_enabled_range},
      {.name = "temp_calib_acc_slot_num", .spec_name = "TEMP_CALIB_ACC_SLOT_NUM",
       .summary = "Number of calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y, -Z.",
       .range = &temp_calib_acc_slot_num_range},
      {.name = "temp_calib_acc_t_min_cels", .spec_name = "TEMP_CALIB_ACC_T_MIN_CELS",
       .summary = "Lowest temperature of the accelerometer's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info, .range = &temp_calib_acc_t_min_cels_range},
      {.name = "temp_calib_acc_t_max_cels", .spec_name = "TEMP_CALIB_ACC_T_MAX_CELS",
       .summary = "Highest temperature of the accelerometer's calibration.",
       .unit = &UnitMeta<msg::Temperature>::info, .range = &temp_calib_acc_t_max_cels_range},
      {.name = "h1_err_length", .spec_name = "H1_ERR_LENGTH",
       .summary = "Length of the difference between the estimated and the reference heading vector, both of length 1.",
       .unit = &UnitMeta<msg::Hundredths>::info, .range = &h1_err_length_range},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, progress), &detail::value_type<decltype(T::progress)>},
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, acc_data), &detail::value_type<decltype(T::acc_data)>},
      {offsetof(T, gyro_abs_val), &detail::value_type<decltype(T::gyro_abs_val)>},
      {offsetof(T, acc_cur_axis), &detail::value_type<decltype(T::acc_cur_axis)>},
      {offsetof(T, acc_limits_info), &detail::value_type<decltype(T::acc_limits_info)>},
      {offsetof(T, imu_temp_cels), &detail::value_type<decltype(T::imu_temp_cels)>},
      {offsetof(T, temp_calib_gyro_enabled), &detail::value_type<decltype(T::temp_calib_gyro_enabled)>},
      {offsetof(T, temp_calib_gyro_t_min_cels), &detail::value_type<decltype(T::temp_calib_gyro_t_min_cels)>},
      {offsetof(T, temp_calib_gyro_t_max_cels), &detail::value_type<decltype(T::temp_calib_gyro_t_max_cels)>},
      {offsetof(T, temp_calib_acc_enabled), &detail::value_type<decltype(T::temp_calib_acc_enabled)>},
      {offsetof(T, temp_calib_acc_slot_num), &detail::value_type<decltype(T::temp_calib_acc_slot_num)>},
      {offsetof(T, temp_calib_acc_t_min_cels), &detail::value_type<decltype(T::temp_calib_acc_t_min_cels)>},
      {offsetof(T, temp_calib_acc_t_max_cels), &detail::value_type<decltype(T::temp_calib_acc_t_max_cels)>},
      {offsetof(T, h1_err_length), &detail::value_type<decltype(T::h1_err_length)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.progress);
    visitor(fields[1], value.imu_type);
    visitor(fields[2], value.acc_data);
    visitor(fields[3], value.gyro_abs_val);
    visitor(fields[4], value.acc_cur_axis);
    visitor(fields[5], value.acc_limits_info);
    visitor(fields[6], value.imu_temp_cels);
    visitor(fields[7], value.temp_calib_gyro_enabled);
    visitor(fields[8], value.temp_calib_gyro_t_min_cels);
    visitor(fields[9], value.temp_calib_gyro_t_max_cels);
    visitor(fields[10], value.temp_calib_acc_enabled);
    visitor(fields[11], value.temp_calib_acc_slot_num);
    visitor(fields[12], value.temp_calib_acc_t_min_cels);
    visitor(fields[13], value.temp_calib_acc_t_max_cels);
    visitor(fields[14], value.h1_err_length);
    visitor(fields[15], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::CalibInfoRequest> {
  static constexpr const char* answers[] = {"CalibInfo"};
  static constexpr MessageInfo info{
      .name = "CalibInfoRequest", .command = "CMD_CALIB_INFO",
      .summary = "Request the calibration status.", .id = 49, .direction = Direction::to_board,
      .min_size = 12, .max_size = 12, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "imu_type", .spec_name = "IMU_TYPE", .summary = "The IMU."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, imu_type), &detail::value_type<decltype(T::imu_type)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.imu_type);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::CalibMotorMagLink> {
  static constexpr MessageInfo info{
      .name = "CalibMotorMagLink", .command = "CMD_CALIB_MOTOR_MAG_LINK",
      .summary = "Undocumented body from the board.", .id = 74, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
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
struct Meta<msg::CalibMotorMagLinkRequest> {
  static constexpr MessageInfo info{
      .name = "CalibMotorMagLinkRequest", .command = "CMD_CALIB_MOTOR_MAG_LINK",
      .summary = "Undocumented body to the board.", .id = 74, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}, .effects = Effects(Effect::unknown)};
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
struct Meta<msg::EncodersCalibOffset4> {
  static constexpr MessageInfo info{
      .name = "EncodersCalibOffset4", .command = "CMD_ENCODERS_CALIB_OFFSET_4",
      .summary = "Calibrate the offsets of the encoders.", .id = 26,
      .direction = Direction::to_board, .min_size = 0, .max_size = 1, .since = {.board = 30},
      .effects = Effects(Effect::stores),
      .preparation = "Turn the motors off, and turn the camera by hand to the position in which all motor angles are zero: level, and straight to the frame."};
  static constexpr FieldInfo fields[] = {
      {.name = "for_motor", .spec_name = "FOR_MOTOR", .summary = "Motor whose encoder to calibrate.",
       .since = {.firmware = 2687}},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, for_motor), &detail::value_type<decltype(T::for_motor)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.for_motor);
  }
};

template <>
struct Meta<msg::EncodersCalibFldOffset4> {
  static constexpr MessageInfo info{
      .name = "EncodersCalibFldOffset4", .command = "CMD_ENCODERS_CALIB_FLD_OFFSET_4",
      .summary = "Calibrate the offsets between encoders and the motors' magnetic fields.", .id = 27,
      .direction = Direction::to_board, .min_size = 0, .max_size = 14, .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::moves,
      .preparation = "Balance the camera, fasten the frame, and make sure that all axes turn freely: the motors turn the camera back and forth."};
  static constexpr FieldInfo fields[] = {
      {.name = "calib_angle", .spec_name = "CALIB_ANGLE",
       .summary = "Angle by which each motor turns; 40 degrees if omitted.",
       .unit = &UnitMeta<msg::Angle14>::info, .directed = Directed::unknown,
       .since = {.firmware = 2626}},
      {.name = "calib_speed", .spec_name = "CALIB_SPEED",
       .summary = "Speed at which each motor turns.", .unit = &UnitMeta<msg::GyroRate>::info,
       .directed = Directed::unknown, .since = {.firmware = 2711}},
      {.name = "calib_flags", .spec_name = "CALIB_FLAGS", .summary = "Checks to omit.",
       .since = {.firmware = 2708}},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, calib_angle), &detail::value_type<decltype(T::calib_angle)>},
      {offsetof(T, calib_speed), &detail::value_type<decltype(T::calib_speed)>},
      {offsetof(T, calib_flags), &detail::value_type<decltype(T::calib_flags)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.calib_angle);
    visitor(fields[1], value.calib_speed);
    visitor(fields[2], value.calib_flags);
  }
};

template <>
struct Meta<msg::AutoPid> {
  static constexpr MessageInfo info{
      .name = "AutoPid", .command = "CMD_AUTO_PID", .summary = "Progress of the automatic tuning.",
      .id = 35, .direction = Direction::from_board, .min_size = 57, .max_size = 57,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "p", .spec_name = "P", .summary = "Proportional gain of each axis."},
      {.name = "i", .spec_name = "I", .summary = "Integral gain of each axis, as stored."},
      {.name = "d", .spec_name = "D", .summary = "Derivative gain of each axis."},
      {.name = "lpf_freq", .spec_name = "LPF_FREQ",
       .summary = "Low-pass filter of each axis, as stored."},
      {.name = "iter_num", .spec_name = "ITER_NUM", .summary = "Number of completed iterations."},
      {.name = "axes", .spec_name = "axes", .summary = "Current result of each axis."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, p), &detail::value_type<decltype(T::p)>},
      {offsetof(T, i), &detail::value_type<decltype(T::i)>},
      {offsetof(T, d), &detail::value_type<decltype(T::d)>},
      {offsetof(T, lpf_freq), &detail::value_type<decltype(T::lpf_freq)>},
      {offsetof(T, iter_num), &detail::value_type<decltype(T::iter_num)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.p);
    visitor(fields[1], value.i);
    visitor(fields[2], value.d);
    visitor(fields[3], value.lpf_freq);
    visitor(fields[4], value.iter_num);
    visitor(fields[5], value.axes);
    visitor(fields[6], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AutoPidRequest> {
  static constexpr MessageInfo info{
      .name = "AutoPidRequest", .command = "CMD_AUTO_PID",
      .summary = "Start or stop the automatic tuning.", .id = 35, .direction = Direction::to_board,
      .min_size = 19, .max_size = 19, .since = {.board = 30}, .until = {.firmware = 2730},
      .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special cfg_flags_special[] = {
      {0, "stops the tuning"},
  };
  static constexpr Range gain_vs_stability_range{0, 255};
  static constexpr Special momentum_special[] = {
      {0, "automatic"},
  };
  static constexpr Special action_special[] = {
      {0, "starts the tuning"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile to switch to first.",
       .range = &profile_id_range},
      {.name = "cfg_flags", .spec_name = "CFG_FLAGS", .summary = "What to tune, and options.",
       .special = cfg_flags_special},
      {.name = "gain_vs_stability", .spec_name = "GAIN_VS_STABILITY",
       .summary = "Preference for high gains at the cost of stability.",
       .range = &gain_vs_stability_range},
      {.name = "momentum", .spec_name = "MOMENTUM", .summary = "Moment of inertia.",
       .special = momentum_special, .since = {.firmware = 2600}},
      {.name = "action", .spec_name = "ACTION", .summary = "Operation; only one is documented.",
       .special = action_special, .since = {.firmware = 2600}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
      {offsetof(T, cfg_flags), &detail::value_type<decltype(T::cfg_flags)>},
      {offsetof(T, gain_vs_stability), &detail::value_type<decltype(T::gain_vs_stability)>},
      {offsetof(T, momentum), &detail::value_type<decltype(T::momentum)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.cfg_flags);
    visitor(fields[2], value.gain_vs_stability);
    visitor(fields[3], value.momentum);
    visitor(fields[4], value.action);
    visitor(fields[5], value.reserved);
  }
};

template <>
struct Meta<msg::AutoPid2> {
  static constexpr MessageInfo info{
      .name = "AutoPid2", .command = "CMD_AUTO_PID2",
      .summary = "Tune the PID controllers automatically, in later firmware.", .id = 108,
      .direction = Direction::to_board, .min_size = 11, .max_size = 73, .since = {.firmware = 2730},
      .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "cmd_flags", .spec_name = "CMD_FLAGS", .summary = "Options of this request."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "config", .spec_name = "config", .summary = "How to tune."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, cmd_flags), &detail::value_type<decltype(T::cmd_flags)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
      {offsetof(T, config), &detail::value_type<decltype(T::config)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.action);
    visitor(fields[1], value.cmd_flags);
    visitor(fields[2], value.reserved);
    visitor(fields[3], value.config);
  }
};

template <>
struct Meta<msg::CalibOrientCorr> {
  static constexpr MessageInfo info{
      .name = "CalibOrientCorr", .command = "CMD_CALIB_ORIENT_CORR",
      .summary = "Calibrate the orientation of the IMU.", .id = 91, .direction = Direction::to_board,
      .min_size = 16, .max_size = 16, .since = {.firmware = 2610},
      .effects = Effects(Effect::stores) | Effect::moves,
      .preparation = "Balance the camera, fasten the frame, and make sure that all axes turn freely: the motors turn the camera. Calibrate the gyroscope and the accelerometer first."};
  static constexpr FieldInfo fields[] = {
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.reserved);
  }
};

template <>
struct Meta<msg::CalibCogging> {
  static constexpr MessageInfo info{
      .name = "CalibCogging", .command = "CMD_CALIB_COGGING",
      .summary = "Calibrate the cogging of the motors, or delete this calibration.", .id = 93,
      .direction = Direction::to_board, .min_size = 57, .max_size = 57, .since = {.firmware = 2600},
      .effects = Effects(Effect::stores) | Effect::moves | Effect::erases,
      .preparation = "Balance the camera, fasten the frame, and make sure that the chosen axes turn freely: the motors turn the camera slowly, several times."};
  static constexpr Range iterations_num_range{2, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "axes", .spec_name = "AXES", .summary = "The motors."},
      {.name = "motors", .spec_name = "motors", .summary = "How to calibrate each motor."},
      {.name = "iterations_num", .spec_name = "ITERATIONS_NUM", .summary = "Number of repetitions.",
       .range = &iterations_num_range},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, axes), &detail::value_type<decltype(T::axes)>},
      {offsetof(T, motors), &detail::value_type<decltype(T::motors)>},
      {offsetof(T, iterations_num), &detail::value_type<decltype(T::iterations_num)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.action);
    visitor(fields[1], value.axes);
    visitor(fields[2], value.motors);
    visitor(fields[3], value.iterations_num);
    visitor(fields[4], value.reserved);
  }

  /// The same, without what the board does not use; single elements go to `visitor.element()`.
  template <class T, class Visitor>
  static constexpr void visit_used(T& value, Visitor&& visitor) {
    visitor(fields[0], value.action);
    visitor(fields[1], value.axes);
    if ((value.action != msg::CoggingAction::erase) && (value.axes.has(msg::CoggingAxis::roll)))
        visitor.element(fields[2], value.motors, 0);
    if ((value.action != msg::CoggingAction::erase) && (value.axes.has(msg::CoggingAxis::pitch)))
        visitor.element(fields[2], value.motors, 1);
    if ((value.action != msg::CoggingAction::erase) && (value.axes.has(msg::CoggingAxis::yaw)))
        visitor.element(fields[2], value.motors, 2);
    if (value.action != msg::CoggingAction::erase) visitor(fields[3], value.iterations_num);
    visitor(fields[4], value.reserved);
  }
};

template <>
struct Meta<msg::CalibAccExtRef> {
  static constexpr MessageInfo info{
      .name = "CalibAccExtRef", .command = "CMD_CALIB_ACC_EXT_REF",
      .summary = "Calibrate the accelerometer with an external reference.", .id = 94,
      .direction = Direction::to_board, .min_size = 20, .max_size = 20, .since = {.firmware = 2627},
      .effects = Effects(Effect::stores),
      .preparation = "Leave the camera completely still, and determine the direction of gravity in the coordinates of the sensor with another instrument."};
  static constexpr FieldInfo fields[] = {
      {.name = "acc_ref", .spec_name = "ACC_REF", .summary = "Actual acceleration.",
       .unit = &UnitMeta<msg::Acceleration>::info, .directed = Directed::by_axis},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, acc_ref), &detail::value_type<decltype(T::acc_ref)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.acc_ref);
    visitor(fields[1], value.reserved);
  }
};

template <>
struct Meta<msg::BodeTestStartStop> {
  static constexpr MessageInfo info{
      .name = "BodeTestStartStop", .command = "CMD_BODE_TEST_START_STOP",
      .summary = "End of the recording.", .id = 37, .direction = Direction::from_board,
      .min_size = 22, .max_size = 22, .since = {.firmware = 2500, .board = 30, .features = 0x08}};
  static constexpr Special error_code_special[] = {
      {0, "success"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "samples_count", .spec_name = "SAMPLES_COUNT",
       .summary = "Number of samples; some firmware sends the index of the last one."},
      {.name = "error_code", .spec_name = "ERROR_CODE", .summary = "Reason of the end.",
       .special = error_code_special},
      {.name = "mode", .spec_name = "MODE", .summary = "MODE of the request."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, samples_count), &detail::value_type<decltype(T::samples_count)>},
      {offsetof(T, error_code), &detail::value_type<decltype(T::error_code)>},
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.samples_count);
    visitor(fields[1], value.error_code);
    visitor(fields[2], value.mode);
    visitor(fields[3], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::BodeTestStartStopRequest> {
  static constexpr const char* answers[] = {"BodeTestStartStop"};
  static constexpr MessageInfo info{
      .name = "BodeTestStartStopRequest", .command = "CMD_BODE_TEST_START_STOP",
      .summary = "Start the recording of a frequency response.", .id = 37,
      .direction = Direction::to_board, .min_size = 30, .max_size = 30,
      .since = {.firmware = 2500, .board = 30, .features = 0x08}, .answers = answers,
      .effects = Effects(Effect::moves)};
  static constexpr Range stimulus_gain_range{1, 65535};
  static constexpr Range mode_range{0, 0};
  static constexpr FieldInfo fields[] = {
      {.name = "axis", .spec_name = "AXIS", .summary = "The axis."},
      {.name = "stimulus_type", .spec_name = "STIMULUS_TYPE", .summary = "Kind of stimulus."},
      {.name = "stimulus_gain", .spec_name = "STIMULUS_GAIN", .summary = "Strength of the stimulus.",
       .range = &stimulus_gain_range},
      {.name = "end_freq", .spec_name = "END_FREQ", .summary = "Highest frequency.",
       .unit = &UnitMeta<msg::Frequency>::info},
      {.name = "system", .spec_name = "SYSTEM", .summary = "What is measured."},
      {.name = "samples_num", .spec_name = "SAMPLES_NUM",
       .summary = "Number of samples, each of 0.8 ms."},
      {.name = "mode", .spec_name = "MODE", .summary = "Reserved.", .range = &mode_range},
      {.name = "start_freq", .spec_name = "START_FREQ", .summary = "Lowest frequency.",
       .unit = &UnitMeta<msg::Frequency>::info},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, axis), &detail::value_type<decltype(T::axis)>},
      {offsetof(T, stimulus_type), &detail::value_type<decltype(T::stimulus_type)>},
      {offsetof(T, stimulus_gain), &detail::value_type<decltype(T::stimulus_gain)>},
      {offsetof(T, end_freq), &detail::value_type<decltype(T::end_freq)>},
      {offsetof(T, system), &detail::value_type<decltype(T::system)>},
      {offsetof(T, samples_num), &detail::value_type<decltype(T::samples_num)>},
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, start_freq), &detail::value_type<decltype(T::start_freq)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.axis);
    visitor(fields[1], value.stimulus_type);
    visitor(fields[2], value.stimulus_gain);
    visitor(fields[3], value.end_freq);
    visitor(fields[4], value.system);
    visitor(fields[5], value.samples_num);
    visitor(fields[6], value.mode);
    visitor(fields[7], value.start_freq);
    visitor(fields[8], value.reserved);
  }
  /// Calls `check(field, low, field, high, is_strict)` for each rule that low is not above high.
  template <class T, class Check>
  static constexpr void rules(const T& value, Check&& check) {
    check(fields[7], value.start_freq, fields[3], value.end_freq, false);
  }
};

template <>
struct Meta<msg::BodeTestData> {
  static constexpr MessageInfo info{
      .name = "BodeTestData", .command = "CMD_BODE_TEST_DATA",
      .summary = "Samples of a recording that runs.", .id = 38, .direction = Direction::from_board,
      .min_size = 17, .max_size = 97, .since = {.firmware = 2500, .board = 30, .features = 0x08}};
  static constexpr FieldInfo fields[] = {
      {.name = "sample_counter", .spec_name = "SAMPLE_COUNTER",
       .summary = "Index of the first sample, modulo 256; the next message begins where this one ends, unless samples are lost."},
      {.name = "input_min", .spec_name = "INPUT_MIN", .summary = "Input of raw value 0."},
      {.name = "output_min", .spec_name = "OUTPUT_MIN", .summary = "Output of raw value 0."},
      {.name = "input_max", .spec_name = "INPUT_MAX", .summary = "Input of raw value 65534."},
      {.name = "output_max", .spec_name = "OUTPUT_MAX", .summary = "Output of raw value 65534."},
      {.name = "samples", .spec_name = "samples", .summary = "The samples.", .max_count = 20},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, sample_counter), &detail::value_type<decltype(T::sample_counter)>},
      {offsetof(T, input_min), &detail::value_type<decltype(T::input_min)>},
      {offsetof(T, output_min), &detail::value_type<decltype(T::output_min)>},
      {offsetof(T, input_max), &detail::value_type<decltype(T::input_max)>},
      {offsetof(T, output_max), &detail::value_type<decltype(T::output_max)>},
      {offsetof(T, samples), &detail::value_type<decltype(T::samples)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.sample_counter);
    visitor(fields[1], value.input_min);
    visitor(fields[2], value.output_min);
    visitor(fields[3], value.input_max);
    visitor(fields[4], value.output_max);
    visitor(fields[5], value.samples);
  }
};

template <>
struct Meta<msg::CoggingCalibInfo> {
  static constexpr MessageInfo info{
      .name = "CoggingCalibInfo", .command = "CMD_COGGING_CALIB_INFO",
      .summary = "Undocumented body from the board.", .id = 92, .direction = Direction::from_board,
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
struct Meta<msg::CoggingCalibInfoRequest> {
  static constexpr MessageInfo info{
      .name = "CoggingCalibInfoRequest", .command = "CMD_COGGING_CALIB_INFO",
      .summary = "Undocumented body to the board.", .id = 92, .direction = Direction::to_board,
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
struct Meta<msg::CanDrvHardParams> {
  static constexpr MessageInfo info{
      .name = "CanDrvHardParams", .command = "CMD_CAN_DRV_HARD_PARAMS",
      .summary = "Undocumented body from the board.", .id = 97, .direction = Direction::from_board,
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
struct Meta<msg::CanDrvHardParamsRequest> {
  static constexpr MessageInfo info{
      .name = "CanDrvHardParamsRequest", .command = "CMD_CAN_DRV_HARD_PARAMS",
      .summary = "Undocumented body to the board.", .id = 97, .direction = Direction::to_board,
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
struct Meta<msg::CanDrvCalibrate> {
  static constexpr MessageInfo info{
      .name = "CanDrvCalibrate", .command = "CMD_CAN_DRV_CALIBRATE",
      .summary = "Undocumented body from the board.", .id = 99, .direction = Direction::from_board,
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
struct Meta<msg::CanDrvCalibrateRequest> {
  static constexpr MessageInfo info{
      .name = "CanDrvCalibrateRequest", .command = "CMD_CAN_DRV_CALIBRATE",
      .summary = "Undocumented body to the board.", .id = 99, .direction = Direction::to_board,
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
struct Meta<msg::CalibEncoderLut> {
  static constexpr MessageInfo info{
      .name = "CalibEncoderLut", .command = "CMD_CALIB_ENCODER_LUT",
      .summary = "Undocumented body from the board.", .id = 117, .direction = Direction::from_board,
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
struct Meta<msg::CalibEncoderLutRequest> {
  static constexpr MessageInfo info{
      .name = "CalibEncoderLutRequest", .command = "CMD_CALIB_ENCODER_LUT",
      .summary = "Undocumented body to the board.", .id = 117, .direction = Direction::to_board,
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
struct Meta<msg::CalibEncoderLutRes> {
  static constexpr MessageInfo info{
      .name = "CalibEncoderLutRes", .command = "CMD_CALIB_ENCODER_LUT_RES",
      .summary = "Undocumented body from the board.", .id = 118, .direction = Direction::from_board,
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
struct Meta<msg::CalibEncoderLutResRequest> {
  static constexpr MessageInfo info{
      .name = "CalibEncoderLutResRequest", .command = "CMD_CALIB_ENCODER_LUT_RES",
      .summary = "Undocumented body to the board.", .id = 118, .direction = Direction::to_board,
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
struct Meta<msg::CalibCurSens> {
  static constexpr MessageInfo info{
      .name = "CalibCurSens", .command = "CMD_CALIB_CUR_SENS",
      .summary = "Undocumented body from the board.", .id = 120, .direction = Direction::from_board,
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
struct Meta<msg::CalibCurSensRequest> {
  static constexpr MessageInfo info{
      .name = "CalibCurSensRequest", .command = "CMD_CALIB_CUR_SENS",
      .summary = "Undocumented body to the board.", .id = 120, .direction = Direction::to_board,
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
struct Meta<msg::EncIntCalib> {
  static constexpr MessageInfo info{
      .name = "EncIntCalib", .command = "CMD_ENC_INT_CALIB",
      .summary = "Undocumented body from the board.", .id = 122, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true};
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
struct Meta<msg::EncIntCalibRequest> {
  static constexpr MessageInfo info{
      .name = "EncIntCalibRequest", .command = "CMD_ENC_INT_CALIB",
      .summary = "Undocumented body to the board.", .id = 122, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true,
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
struct Meta<msg::VibrationTestStartStop> {
  static constexpr MessageInfo info{
      .name = "VibrationTestStartStop", .command = "CMD_VIBRATION_TEST_START_STOP",
      .summary = "Undocumented body from the board.", .id = 125, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true};
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
struct Meta<msg::VibrationTestStartStopRequest> {
  static constexpr MessageInfo info{
      .name = "VibrationTestStartStopRequest", .command = "CMD_VIBRATION_TEST_START_STOP",
      .summary = "Undocumented body to the board.", .id = 125, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true,
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
struct Meta<msg::VibrationTestData> {
  static constexpr MessageInfo info{
      .name = "VibrationTestData", .command = "CMD_VIBRATION_TEST_DATA",
      .summary = "Undocumented body from the board.", .id = 126, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true};
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
struct Meta<msg::VibrationTestDataRequest> {
  static constexpr MessageInfo info{
      .name = "VibrationTestDataRequest", .command = "CMD_VIBRATION_TEST_DATA",
      .summary = "Undocumented body to the board.", .id = 126, .direction = Direction::to_board,
      .min_size = 0, .max_size = 255, .since = {.firmware = 2600}, .unconfirmed = true,
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
