// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/parameters_ext3.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/parameters_ext3.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::ShakeGenerator> {
  static constexpr Range freq_range_range{0, 100};
  static constexpr Range pause_balance_range{0, 100};
  static constexpr Range pause_attenuation_range{0, 100};
  static constexpr Range pause_randomness_range{0, 100};
  static constexpr Range pause_phase_var_range{0, 100};
  static constexpr Range freq_shift_range{-127, 127};
  static constexpr FieldInfo fields[] = {
      {.name = "amplitude", .spec_name = "AMPLITUDE",
       .summary = "Amplitude of roll, tilt and pan, on a logarithmic scale."},
      {.name = "base_freq", .spec_name = "BASE_FREQ", .summary = "Lowest frequency.",
       .unit = &UnitMeta<msg::ShakeFrequency>::info},
      {.name = "freq_range", .spec_name = "FREQ_RANGE",
       .summary = "Ratio of the highest frequency to the lowest.",
       .unit = &UnitMeta<msg::ShakeFactor>::info, .range = &freq_range_range},
      {.name = "pause_period", .spec_name = "PAUSE_PERIOD", .summary = "Period of the pauses.",
       .unit = &UnitMeta<msg::ShakePause>::info},
      {.name = "pause_balance", .spec_name = "PAUSE_BALANCE",
       .summary = "Share of the pauses in their period.", .range = &pause_balance_range},
      {.name = "pause_attenuation", .spec_name = "PAUSE_ATTENUATION",
       .summary = "Attenuation in the pauses.", .range = &pause_attenuation_range},
      {.name = "pause_randomness", .spec_name = "PAUSE_RANDOMNESS",
       .summary = "Randomness of the pauses.", .range = &pause_randomness_range},
      {.name = "pause_phase_var", .spec_name = "PAUSE_PHASE_VAR",
       .summary = "Variation of the phase of the pauses between the axes.",
       .range = &pause_phase_var_range},
      {.name = "resonance_gain", .spec_name = "RESONANCE_GAIN",
       .summary = "Gain at the resonance of roll, tilt and pan.",
       .unit = &UnitMeta<msg::FifthDecibels>::info},
      {.name = "resonance_freq", .spec_name = "RESONANCE_FREQ",
       .summary = "Frequency of the resonance.", .unit = &UnitMeta<msg::ShakeResonance>::info},
      {.name = "freq_shift", .spec_name = "FREQ_SHIFT",
       .summary = "Shift of the frequencies of roll, tilt and pan, on a logarithmic scale from 1/3 to 3.",
       .range = &freq_shift_range},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, amplitude), &detail::value_type<decltype(T::amplitude)>},
      {offsetof(T, base_freq), &detail::value_type<decltype(T::base_freq)>},
      {offsetof(T, freq_range), &detail::value_type<decltype(T::freq_range)>},
      {offsetof(T, pause_period), &detail::value_type<decltype(T::pause_period)>},
      {offsetof(T, pause_balance), &detail::value_type<decltype(T::pause_balance)>},
      {offsetof(T, pause_attenuation), &detail::value_type<decltype(T::pause_attenuation)>},
      {offsetof(T, pause_randomness), &detail::value_type<decltype(T::pause_randomness)>},
      {offsetof(T, pause_phase_var), &detail::value_type<decltype(T::pause_phase_var)>},
      {offsetof(T, resonance_gain), &detail::value_type<decltype(T::resonance_gain)>},
      {offsetof(T, resonance_freq), &detail::value_type<decltype(T::resonance_freq)>},
      {offsetof(T, freq_shift), &detail::value_type<decltype(T::freq_shift)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.amplitude);
    visitor(fields[1], value.base_freq);
    visitor(fields[2], value.freq_range);
    visitor(fields[3], value.pause_period);
    visitor(fields[4], value.pause_balance);
    visitor(fields[5], value.pause_attenuation);
    visitor(fields[6], value.pause_randomness);
    visitor(fields[7], value.pause_phase_var);
    visitor(fields[8], value.resonance_gain);
    visitor(fields[9], value.resonance_freq);
    visitor(fields[10], value.freq_shift);
    visitor(fields[11], value.reserved);
  }
};

template <>
struct Meta<msg::ReadParamsExt3> {
  static constexpr MessageInfo info{
      .name = "ReadParamsExt3", .command = "CMD_READ_PARAMS_EXT3",
      .summary = "The fourth set of parameters of one profile.", .id = 104,
      .direction = Direction::from_board, .min_size = 221, .max_size = 221,
      .since = {.firmware = 2660}};
  static constexpr Range profile_id_range{0, 4};
  static constexpr Special profile_id_special[] = {
      {255, "the active profile"},
  };
  static constexpr Range follow_offset_ext_range{-16384, 16384};
  static constexpr Range stab_threshold_angle_range{15, 80};
  static constexpr Special stab_threshold_angle_special[] = {
      {0, "not set"},
  };
  static constexpr Range rc_deadband_pitch_range{0, 255};
  static constexpr Range rc_deadband_yaw_range{0, 255};
  static constexpr Range rc_expo_rate_pitch_range{0, 255};
  static constexpr Range rc_expo_rate_yaw_range{0, 255};
  static constexpr Range default_profile_range{0, 4};
  static constexpr Range can_imu_servo_out_range{1, 32};
  static constexpr Special can_imu_servo_out_special[] = {
      {0, "disabled"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "profile_id", .spec_name = "PROFILE_ID", .summary = "Profile of the parameters.",
       .range = &profile_id_range, .special = profile_id_special, .role = FieldRole::copy},
      {.name = "reserved_1", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "ext_imu_type", .spec_name = "EXT_IMU_TYPE", .summary = "Model of the external IMU.",
       .role = FieldRole::general},
      {.name = "ext_imu_port", .spec_name = "EXT_IMU_PORT",
       .summary = "Serial port of the external IMU.", .role = FieldRole::general},
      {.name = "ext_imu_position", .spec_name = "EXT_IMU_POSITION",
       .summary = "Location of the external IMU.", .role = FieldRole::general},
      {.name = "ext_imu_orientation", .spec_name = "EXT_IMU_ORIENTATION",
       .summary = "Orientation of the external IMU.", .role = FieldRole::general},
      {.name = "ext_imu_flags", .spec_name = "EXT_IMU_FLAGS", .summary = "Use of the external IMU.",
       .role = FieldRole::general},
      {.name = "ext_imu_align_correction", .spec_name = "EXT_IMU_ALIGN_CORRECTION",
       .summary = "Correction of the orientation of the external IMU, in unknown units.",
       .unconfirmed = true},
      {.name = "ext_imu_startup_delay", .spec_name = "EXT_IMU_STARTUP_DELAY",
       .summary = "Delay until the external IMU is used, in unknown units.", .unconfirmed = true},
      {.name = "ext_imu_gyro_corr_rate", .spec_name = "EXT_IMU_GYRO_CORR_RATE",
       .summary = "Rate at which the external IMU corrects the gyroscope.", .unconfirmed = true},
      {.name = "reserved_2", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "soft_limit_width", .spec_name = "SOFT_LIMIT_WIDTH",
       .summary = "Width of the software limits FRAME_CAM_ANGLE_MIN and FRAME_CAM_ANGLE_MAX.",
       .unit = &UnitMeta<msg::TenthDegreesWidth>::info, .saved_as = "limit__width"},
      {.name = "adc_replace_src", .spec_name = "ADC_REPLACE_SRC",
       .summary = "Signals that replace ADC1, ADC2 and ADC3.", .saved_as = "adc__replace"},
      {.name = "glock_mid_mot_pos_corr_rate", .spec_name = "GLOCK_MID_MOT_POS_CORR_RATE",
       .summary = "Rate at which the position of the middle motor is corrected near gimbal lock.",
       .saved_as = "improve__mid__mot__pos"},
      {.name = "extra_btn_cfg", .spec_name = "EXTRA_BTN_CFG",
       .summary = "Pins of additional buttons."},
      {.name = "overcurrent_protection", .spec_name = "OVERCURRENT_PROTECTION",
       .summary = "Current at which the power switch turns off.",
       .unit = &UnitMeta<msg::CoarseCurrent>::info},
      {.name = "power_on_delay", .spec_name = "POWER_ON_DELAY",
       .summary = "Delay before the power switch turns on.",
       .unit = &UnitMeta<msg::HundredsOfMilliseconds>::info},
      {.name = "power_off_delay", .spec_name = "POWER_OFF_DELAY",
       .summary = "Delay before the power switch turns off.",
       .unit = &UnitMeta<msg::HundredsOfMilliseconds>::info},
      {.name = "power_on_limiter", .spec_name = "POWER_ON_LIMITER",
       .summary = "Limit of the current while the power switch turns on."},
      {.name = "reserved_3", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "lpf_q_inv", .spec_name = "LPF_Q_INV",
       .summary = "Inverse quality factor of the low-pass filter.",
       .unit = &UnitMeta<msg::InverseQuality>::info},
      {.name = "can_imu_ext_sens_type", .spec_name = "CAN_IMU_EXT_SENS_TYPE",
       .summary = "External sensor of the CAN IMU.", .role = FieldRole::general,
       .saved_as = "ext__sens__type"},
      {.name = "profile_flags2", .spec_name = "PROFILE_FLAGS2",
       .summary = "More options of the profile."},
      {.name = "reserved_4", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
      {.name = "general_flags3", .spec_name = "GENERAL_FLAGS3",
       .summary = "Still more options of the whole board.", .role = FieldRole::general},
      {.name = "follow_offset_ext", .spec_name = "FOLLOW_OFFSET_EXT",
       .summary = "Offset of the follow mode.", .unit = &UnitMeta<msg::Angle14>::info,
       .range = &follow_offset_ext_range, .directed = Directed::unknown, .since = {.firmware = 2700}},
      {.name = "motor_startup_delay", .spec_name = "MOTOR_STARTUP_DELAY",
       .summary = "Delay before the motors start.", .unit = &UnitMeta<msg::Milliseconds>::info,
       .saved_as = "motor__startup__delay__ms"},
      {.name = "imu_model_main", .spec_name = "IMU_MODEL_MAIN", .summary = "Model of the main IMU.",
       .role = FieldRole::general},
      {.name = "imu_model_frame", .spec_name = "IMU_MODEL_FRAME",
       .summary = "Model of the frame IMU.", .role = FieldRole::general},
      {.name = "stab_threshold_angle", .spec_name = "STAB_THRESHOLD_ANGLE",
       .summary = "Angle between motor and axis up to which the motor stabilizes.",
       .unit = &UnitMeta<msg::SmallDegrees>::info, .range = &stab_threshold_angle_range,
       .special = stab_threshold_angle_special},
      {.name = "ext_buzzer_pin", .spec_name = "EXT_BUZZER_PIN",
       .summary = "Pin of an additional buzzer.", .role = FieldRole::general},
      {.name = "enc_limit_return_speed", .spec_name = "ENC_LIMIT_RETURN_SPEED",
       .summary = "Speed of the return from beyond a limit."},
      {.name = "tripod_mode_auto_threshold", .spec_name = "TRIPOD_MODE_AUTO_THRESHOLD",
       .summary = "Threshold at which the tripod mode starts automatically."},
      {.name = "rc_deadband_pitch", .spec_name = "RC_DEADBAND_PITCH",
       .summary = "Dead band of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT.",
       .range = &rc_deadband_pitch_range},
      {.name = "rc_deadband_yaw", .spec_name = "RC_DEADBAND_YAW",
       .summary = "Dead band of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT.",
       .range = &rc_deadband_yaw_range},
      {.name = "rc_expo_rate_pitch", .spec_name = "RC_EXPO_RATE_PITCH",
       .summary = "Expo rate of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT.",
       .range = &rc_expo_rate_pitch_range},
      {.name = "rc_expo_rate_yaw", .spec_name = "RC_EXPO_RATE_YAW",
       .summary = "Expo rate of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT.",
       .range = &rc_expo_rate_yaw_range},
      {.name = "profile_flags3", .spec_name = "PROFILE_FLAGS3",
       .summary = "Still more options of the profile."},
      {.name = "default_profile", .spec_name = "DEFAULT_PROFILE",
       .summary = "Profile after a restart.", .range = &default_profile_range,
       .role = FieldRole::general},
      {.name = "retracted_angle", .spec_name = "RETRACTED_ANGLE",
       .summary = "Angle of the retracted position, in unknown units.",
       .directed = Directed::unknown},
      {.name = "shake_generator", .spec_name = "shake_generator",
       .summary = "Settings of the shake generator."},
      {.name = "ext_motor_drv_ids", .spec_name = "EXT_MOTOR_DRV_IDS",
       .summary = "CAN drivers of the external motors 1 to 7."},
      {.name = "encoder_cfg_ext", .spec_name = "ENCODER_CFG_EXT",
       .summary = "Resolution and turns of the encoder."},
      {.name = "ext_sens_params", .spec_name = "EXT_SENS_PARAMS",
       .summary = "Settings of the CAN IMU's external sensor; they depend on its model."},
      {.name = "imu_angle_corr_r", .spec_name = "IMU_ANGLE_CORR_R",
       .summary = "Correction of the roll angle.", .unit = &UnitMeta<msg::HundredthDegrees>::info,
       .directed = Directed::by_axis},
      {.name = "imu_angle_corr_p", .spec_name = "IMU_ANGLE_CORR_P",
       .summary = "Correction of the pitch angle.", .unit = &UnitMeta<msg::HundredthDegrees>::info,
       .directed = Directed::by_axis},
      {.name = "can_imu_servo_out", .spec_name = "CAN_IMU_SERVO_OUT",
       .summary = "Virtual channel on each servo pin of the CAN IMU.",
       .range = &can_imu_servo_out_range, .special = can_imu_servo_out_special},
      {.name = "can_imu_servo_rate", .spec_name = "CAN_IMU_SERVO_RATE",
       .summary = "PWM frequency of these servo outputs.", .unit = &UnitMeta<msg::ServoRate>::info},
      {.name = "servo_outer_p_mult", .spec_name = "SERVO_OUTER_P_MULT",
       .summary = "Factor on OUTER_P in servo mode: 0.1 * exp(raw * ln(500) / 255)."},
      {.name = "servo_outer_i", .spec_name = "SERVO_OUTER_I",
       .summary = "Integral gain of the outer loop in servo mode: 5 * exp(raw * ln(52) / 255) - 5."},
      {.name = "ext_pwr_sw_shunt_r", .spec_name = "EXT_PWR_SW_SHUNT_R",
       .summary = "Shunt resistance of an external power switch.",
       .unit = &UnitMeta<msg::HundredthOhms>::info, .role = FieldRole::general},
      {.name = "general_flags4", .spec_name = "GENERAL_FLAGS4",
       .summary = "The last options of the whole board.", .role = FieldRole::general},
      {.name = "auto_motion_timeout", .spec_name = "AUTO_MOTION_TIMEOUT",
       .summary = "Time limit of automatic motions, in unknown units.", .unconfirmed = true},
      {.name = "reserved_5", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, profile_id), &detail::value_type<decltype(T::profile_id)>},
      {offsetof(T, reserved_1), &detail::value_type<decltype(T::reserved_1)>},
      {offsetof(T, ext_imu_type), &detail::value_type<decltype(T::ext_imu_type)>},
      {offsetof(T, ext_imu_port), &detail::value_type<decltype(T::ext_imu_port)>},
      {offsetof(T, ext_imu_position), &detail::value_type<decltype(T::ext_imu_position)>},
      {offsetof(T, ext_imu_orientation), &detail::value_type<decltype(T::ext_imu_orientation)>},
      {offsetof(T, ext_imu_flags), &detail::value_type<decltype(T::ext_imu_flags)>},
      {offsetof(T, ext_imu_align_correction), &detail::value_type<decltype(T::ext_imu_align_correction)>},
      {offsetof(T, ext_imu_startup_delay), &detail::value_type<decltype(T::ext_imu_startup_delay)>},
      {offsetof(T, ext_imu_gyro_corr_rate), &detail::value_type<decltype(T::ext_imu_gyro_corr_rate)>},
      {offsetof(T, reserved_2), &detail::value_type<decltype(T::reserved_2)>},
      {offsetof(T, soft_limit_width), &detail::value_type<decltype(T::soft_limit_width)>},
      {offsetof(T, adc_replace_src), &detail::value_type<decltype(T::adc_replace_src)>},
      {offsetof(T, glock_mid_mot_pos_corr_rate), &detail::value_type<decltype(T::glock_mid_mot_pos_corr_rate)>},
      {offsetof(T, extra_btn_cfg), &detail::value_type<decltype(T::extra_btn_cfg)>},
      {offsetof(T, overcurrent_protection), &detail::value_type<decltype(T::overcurrent_protection)>},
      {offsetof(T, power_on_delay), &detail::value_type<decltype(T::power_on_delay)>},
      {offsetof(T, power_off_delay), &detail::value_type<decltype(T::power_off_delay)>},
      {offsetof(T, power_on_limiter), &detail::value_type<decltype(T::power_on_limiter)>},
      {offsetof(T, reserved_3), &detail::value_type<decltype(T::reserved_3)>},
      {offsetof(T, lpf_q_inv), &detail::value_type<decltype(T::lpf_q_inv)>},
      {offsetof(T, can_imu_ext_sens_type), &detail::value_type<decltype(T::can_imu_ext_sens_type)>},
      {offsetof(T, profile_flags2), &detail::value_type<decltype(T::profile_flags2)>},
      {offsetof(T, reserved_4), &detail::value_type<decltype(T::reserved_4)>},
      {offsetof(T, general_flags3), &detail::value_type<decltype(T::general_flags3)>},
      {offsetof(T, follow_offset_ext), &detail::value_type<decltype(T::follow_offset_ext)>},
      {offsetof(T, motor_startup_delay), &detail::value_type<decltype(T::motor_startup_delay)>},
      {offsetof(T, imu_model_main), &detail::value_type<decltype(T::imu_model_main)>},
      {offsetof(T, imu_model_frame), &detail::value_type<decltype(T::imu_model_frame)>},
      {offsetof(T, stab_threshold_angle), &detail::value_type<decltype(T::stab_threshold_angle)>},
      {offsetof(T, ext_buzzer_pin), &detail::value_type<decltype(T::ext_buzzer_pin)>},
      {offsetof(T, enc_limit_return_speed), &detail::value_type<decltype(T::enc_limit_return_speed)>},
      {offsetof(T, tripod_mode_auto_threshold), &detail::value_type<decltype(T::tripod_mode_auto_threshold)>},
      {offsetof(T, rc_deadband_pitch), &detail::value_type<decltype(T::rc_deadband_pitch)>},
      {offsetof(T, rc_deadband_yaw), &detail::value_type<decltype(T::rc_deadband_yaw)>},
      {offsetof(T, rc_expo_rate_pitch), &detail::value_type<decltype(T::rc_expo_rate_pitch)>},
      {offsetof(T, rc_expo_rate_yaw), &detail::value_type<decltype(T::rc_expo_rate_yaw)>},
      {offsetof(T, profile_flags3), &detail::value_type<decltype(T::profile_flags3)>},
      {offsetof(T, default_profile), &detail::value_type<decltype(T::default_profile)>},
      {offsetof(T, retracted_angle), &detail::value_type<decltype(T::retracted_angle)>},
      {offsetof(T, shake_generator), &detail::value_type<decltype(T::shake_generator)>},
      {offsetof(T, ext_motor_drv_ids), &detail::value_type<decltype(T::ext_motor_drv_ids)>},
      {offsetof(T, encoder_cfg_ext), &detail::value_type<decltype(T::encoder_cfg_ext)>},
      {offsetof(T, ext_sens_params), &detail::value_type<decltype(T::ext_sens_params)>},
      {offsetof(T, imu_angle_corr_r), &detail::value_type<decltype(T::imu_angle_corr_r)>},
      {offsetof(T, imu_angle_corr_p), &detail::value_type<decltype(T::imu_angle_corr_p)>},
      {offsetof(T, can_imu_servo_out), &detail::value_type<decltype(T::can_imu_servo_out)>},
      {offsetof(T, can_imu_servo_rate), &detail::value_type<decltype(T::can_imu_servo_rate)>},
      {offsetof(T, servo_outer_p_mult), &detail::value_type<decltype(T::servo_outer_p_mult)>},
      {offsetof(T, servo_outer_i), &detail::value_type<decltype(T::servo_outer_i)>},
      {offsetof(T, ext_pwr_sw_shunt_r), &detail::value_type<decltype(T::ext_pwr_sw_shunt_r)>},
      {offsetof(T, general_flags4), &detail::value_type<decltype(T::general_flags4)>},
      {offsetof(T, auto_motion_timeout), &detail::value_type<decltype(T::auto_motion_timeout)>},
      {offsetof(T, reserved_5), &detail::value_type<decltype(T::reserved_5)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.profile_id);
    visitor(fields[1], value.reserved_1);
    visitor(fields[2], value.ext_imu_type);
    visitor(fields[3], value.ext_imu_port);
    visitor(fields[4], value.ext_imu_position);
    visitor(fields[5], value.ext_imu_orientation);
    visitor(fields[6], value.ext_imu_flags);
    visitor(fields[7], value.ext_imu_align_correction);
    visitor(fields[8], value.ext_imu_startup_delay);
    visitor(fields[9], value.ext_imu_gyro_corr_rate);
    visitor(fields[10], value.reserved_2);
    visitor(fields[11], value.soft_limit_width);
    visitor(fields[12], value.adc_replace_src);
    visitor(fields[13], value.glock_mid_mot_pos_corr_rate);
    visitor(fields[14], value.extra_btn_cfg);
    visitor(fields[15], value.overcurrent_protection);
    visitor(fields[16], value.power_on_delay);
    visitor(fields[17], value.power_off_delay);
    visitor(fields[18], value.power_on_limiter);
    visitor(fields[19], value.reserved_3);
    visitor(fields[20], value.lpf_q_inv);
    visitor(fields[21], value.can_imu_ext_sens_type);
    visitor(fields[22], value.profile_flags2);
    visitor(fields[23], value.reserved_4);
    visitor(fields[24], value.general_flags3);
    visitor(fields[25], value.follow_offset_ext);
    visitor(fields[26], value.motor_startup_delay);
    visitor(fields[27], value.imu_model_main);
    visitor(fields[28], value.imu_model_frame);
    visitor(fields[29], value.stab_threshold_angle);
    visitor(fields[30], value.ext_buzzer_pin);
    visitor(fields[31], value.enc_limit_return_speed);
    visitor(fields[32], value.tripod_mode_auto_threshold);
    visitor(fields[33], value.rc_deadband_pitch);
    visitor(fields[34], value.rc_deadband_yaw);
    visitor(fields[35], value.rc_expo_rate_pitch);
    visitor(fields[36], value.rc_expo_rate_yaw);
    visitor(fields[37], value.profile_flags3);
    visitor(fields[38], value.default_profile);
    visitor(fields[39], value.retracted_angle);
    visitor(fields[40], value.shake_generator);
    visitor(fields[41], value.ext_motor_drv_ids);
    visitor(fields[42], value.encoder_cfg_ext);
    visitor(fields[43], value.ext_sens_params);
    visitor(fields[44], value.imu_angle_corr_r);
    visitor(fields[45], value.imu_angle_corr_p);
    visitor(fields[46], value.can_imu_servo_out);
    visitor(fields[47], value.can_imu_servo_rate);
    visitor(fields[48], value.servo_outer_p_mult);
    visitor(fields[49], value.servo_outer_i);
    visitor(fields[50], value.ext_pwr_sw_shunt_r);
    visitor(fields[51], value.general_flags4);
    visitor(fields[52], value.auto_motion_timeout);
    visitor(fields[53], value.reserved_5);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadParamsExt3Request> {
  static constexpr const char* answers[] = {"ReadParamsExt3"};
  static constexpr MessageInfo info{
      .name = "ReadParamsExt3Request", .command = "CMD_READ_PARAMS_EXT3",
      .summary = "Request the fourth set of parameters of one profile.", .id = 104,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.firmware = 2660},
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
struct Meta<msg::WriteParamsExt3> : Meta<msg::ReadParamsExt3> {
  static constexpr MessageInfo info{
      .name = "WriteParamsExt3", .command = "CMD_WRITE_PARAMS_EXT3",
      .summary = "Store the fourth set of parameters of one profile.", .id = 105,
      .direction = Direction::to_board, .min_size = 221, .max_size = 221,
      .since = {.firmware = 2660}, .stores = "ReadParamsExt3",
      .effects = Effects(Effect::stores) | Effect::moves};
};

}  // namespace sbgc
