// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The fourth set of parameters, of later firmware.
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

struct ReadParamsExt3;

/// Settings of the shake generator.
struct ShakeGenerator {
  /// Amplitude of roll, tilt and pan, on a logarithmic scale.
  Axes<std::uint8_t> amplitude{};
  /// Lowest frequency. Unit: Hz.
  ShakeFrequency base_freq{};
  /// Ratio of the highest frequency to the lowest. Range: 1.5 to 11.5.
  ShakeFactor freq_range{};
  /// Period of the pauses. Unit: ms.
  ShakePause pause_period{};
  /// Share of the pauses in their period. Range: 0 to 100.
  std::uint8_t pause_balance{};
  /// Attenuation in the pauses. Range: 0 to 100.
  std::uint8_t pause_attenuation{};
  /// Randomness of the pauses. Range: 0 to 100.
  std::uint8_t pause_randomness{};
  /// Variation of the phase of the pauses between the axes. Range: 0 to 100.
  std::uint8_t pause_phase_var{};
  /// Gain at the resonance of roll, tilt and pan. Unit: dB.
  Axes<FifthDecibels> resonance_gain{};
  /// Frequency of the resonance. Unit: Hz.
  ShakeResonance resonance_freq{};
  /// Shift of the frequencies of roll, tilt and pan, on a logarithmic scale from 1/3 to 3. Range:
  /// -127 to 127.
  Axes<std::int8_t> freq_shift{};
  /// Reserved; kept as it is.
  Bytes<5> reserved{};

  bool operator==(const ShakeGenerator&) const = default;
  using FixedMembers = Members<&ShakeGenerator::amplitude, &ShakeGenerator::base_freq,
      &ShakeGenerator::freq_range, &ShakeGenerator::pause_period, &ShakeGenerator::pause_balance,
      &ShakeGenerator::pause_attenuation, &ShakeGenerator::pause_randomness,
      &ShakeGenerator::pause_phase_var, &ShakeGenerator::resonance_gain,
      &ShakeGenerator::resonance_freq, &ShakeGenerator::freq_shift, &ShakeGenerator::reserved>;
};

/// The fourth set of parameters of one profile.
///
/// CMD_READ_PARAMS_EXT3 (104), from the board; 221 bytes, and later firmware may append more. Since
/// firmware 2.66. Source: Later firmware.
struct ReadParamsExt3 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_ext3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 221;
  static constexpr std::size_t max_size = 221;
  static constexpr Availability since{.firmware = 2660};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};
  /// For can_imu_servo_out: disabled.
  static constexpr std::uint8_t can_imu_servo_disabled{0};

  /// Profile of the parameters. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// Reserved; kept as it is.
  Bytes<21> reserved_1{};
  /// Model of the external IMU. The same in all copies.
  ExtImuModel ext_imu_type{};
  /// Serial port of the external IMU. The same in all copies.
  BoardPort ext_imu_port{};
  /// Location of the external IMU. The same in all copies.
  ExtImuPosition ext_imu_position{};
  /// Orientation of the external IMU. The same in all copies.
  ExtImuOrientation ext_imu_orientation{};
  /// Use of the external IMU. The same in all copies.
  ExtImuFlags ext_imu_flags{};
  /// Correction of the orientation of the external IMU, in unknown units. Unconfirmed.
  Axes<std::int16_t> ext_imu_align_correction{};
  /// Delay until the external IMU is used, in unknown units. Unconfirmed.
  std::uint8_t ext_imu_startup_delay{};
  /// Rate at which the external IMU corrects the gyroscope. Unconfirmed.
  std::uint8_t ext_imu_gyro_corr_rate{};
  /// Reserved; kept as it is.
  Bytes<4> reserved_2{};
  /// Width of the software limits FRAME_CAM_ANGLE_MIN and FRAME_CAM_ANGLE_MAX. Unit: deg.
  Axes<TenthDegreesWidth> soft_limit_width{};
  /// Signals that replace ADC1, ADC2 and ADC3.
  std::array<RcMap, 3> adc_replace_src{};
  /// Rate at which the position of the middle motor is corrected near gimbal lock.
  std::uint8_t glock_mid_mot_pos_corr_rate{};
  /// Pins of additional buttons.
  std::array<ExtraButton, 5> extra_btn_cfg{};
  /// Current at which the power switch turns off. Unit: mA.
  CoarseCurrent overcurrent_protection{};
  /// Delay before the power switch turns on. Unit: ms.
  HundredsOfMilliseconds power_on_delay{};
  /// Delay before the power switch turns off. Unit: ms.
  HundredsOfMilliseconds power_off_delay{};
  /// Limit of the current while the power switch turns on.
  std::uint8_t power_on_limiter{};
  /// Reserved; kept as it is.
  Bytes<4> reserved_3{};
  /// Inverse quality factor of the low-pass filter.
  Axes<InverseQuality> lpf_q_inv{};
  /// External sensor of the CAN IMU. The same in all copies.
  CanImuSensor can_imu_ext_sens_type{};
  /// More options of the profile.
  ProfileFlags2 profile_flags2{};
  /// Reserved; kept as it is.
  Bytes<3> reserved_4{};
  /// Still more options of the whole board. The same in all copies.
  GeneralFlags3 general_flags3{};
  /// Offset of the follow mode. Range: -360 to 360 deg. Since firmware 2.70.
  Axes<Angle14> follow_offset_ext{};
  /// Delay before the motors start. Unit: ms.
  Milliseconds motor_startup_delay{};
  /// Model of the main IMU. The same in all copies.
  std::uint8_t imu_model_main{};
  /// Model of the frame IMU. The same in all copies.
  std::uint8_t imu_model_frame{};
  /// Angle between motor and axis up to which the motor stabilizes. Range: 15 to 80 deg. 0: not
  /// set.
  Axes<SmallDegrees> stab_threshold_angle{};
  /// Pin of an additional buzzer. The same in all copies.
  OutputPin ext_buzzer_pin{};
  /// Speed of the return from beyond a limit.
  Axes<std::uint8_t> enc_limit_return_speed{};
  /// Threshold at which the tripod mode starts automatically.
  std::uint8_t tripod_mode_auto_threshold{};
  /// Dead band of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT.
  std::uint8_t rc_deadband_pitch{};
  /// Dead band of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT.
  std::uint8_t rc_deadband_yaw{};
  /// Expo rate of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT.
  std::uint8_t rc_expo_rate_pitch{};
  /// Expo rate of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT.
  std::uint8_t rc_expo_rate_yaw{};
  /// Still more options of the profile.
  ProfileFlags3 profile_flags3{};
  /// Profile after a restart. Range: 0 to 4. The same in all copies.
  std::uint8_t default_profile{};
  /// Angle of the retracted position, in unknown units.
  Axes<std::int16_t> retracted_angle{};
  /// Settings of the shake generator.
  ShakeGenerator shake_generator{};
  /// CAN drivers of the external motors 1 to 7.
  std::array<std::uint8_t, 7> ext_motor_drv_ids{};
  /// Resolution and turns of the encoder.
  Axes<EncoderConfigExt> encoder_cfg_ext{};
  /// Settings of the CAN IMU's external sensor; they depend on its model.
  Bytes<16> ext_sens_params{};
  /// Correction of the roll angle. Unit: deg.
  HundredthDegrees imu_angle_corr_r{};
  /// Correction of the pitch angle. Unit: deg.
  HundredthDegrees imu_angle_corr_p{};
  /// Virtual channel on each servo pin of the CAN IMU. Range: 1 to 32.
  std::array<std::uint8_t, 2> can_imu_servo_out{};
  /// PWM frequency of these servo outputs. Unit: Hz.
  ServoRate can_imu_servo_rate{};
  /// Factor on OUTER_P in servo mode: 0.1 * exp(raw * ln(500) / 255).
  std::uint8_t servo_outer_p_mult{};
  /// Integral gain of the outer loop in servo mode: 5 * exp(raw * ln(52) / 255) - 5.
  std::uint8_t servo_outer_i{};
  /// Shunt resistance of an external power switch. Unit: ohm. The same in all copies.
  HundredthOhms ext_pwr_sw_shunt_r{};
  /// The last options of the whole board. The same in all copies.
  GeneralFlags4 general_flags4{};
  /// Time limit of automatic motions, in unknown units. Unconfirmed.
  std::uint8_t auto_motion_timeout{};
  /// Reserved; kept as it is.
  Bytes<48> reserved_5{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<34> tail{};

  bool operator==(const ReadParamsExt3&) const = default;
  using FixedMembers = Members<&ReadParamsExt3::profile_id, &ReadParamsExt3::reserved_1,
      &ReadParamsExt3::ext_imu_type, &ReadParamsExt3::ext_imu_port,
      &ReadParamsExt3::ext_imu_position, &ReadParamsExt3::ext_imu_orientation,
      &ReadParamsExt3::ext_imu_flags, &ReadParamsExt3::ext_imu_align_correction,
      &ReadParamsExt3::ext_imu_startup_delay, &ReadParamsExt3::ext_imu_gyro_corr_rate,
      &ReadParamsExt3::reserved_2, &ReadParamsExt3::soft_limit_width,
      &ReadParamsExt3::adc_replace_src, &ReadParamsExt3::glock_mid_mot_pos_corr_rate,
      &ReadParamsExt3::extra_btn_cfg, &ReadParamsExt3::overcurrent_protection,
      &ReadParamsExt3::power_on_delay, &ReadParamsExt3::power_off_delay,
      &ReadParamsExt3::power_on_limiter, &ReadParamsExt3::reserved_3, &ReadParamsExt3::lpf_q_inv,
      &ReadParamsExt3::can_imu_ext_sens_type, &ReadParamsExt3::profile_flags2,
      &ReadParamsExt3::reserved_4, &ReadParamsExt3::general_flags3,
      &ReadParamsExt3::follow_offset_ext, &ReadParamsExt3::motor_startup_delay,
      &ReadParamsExt3::imu_model_main, &ReadParamsExt3::imu_model_frame,
      &ReadParamsExt3::stab_threshold_angle, &ReadParamsExt3::ext_buzzer_pin,
      &ReadParamsExt3::enc_limit_return_speed, &ReadParamsExt3::tripod_mode_auto_threshold,
      &ReadParamsExt3::rc_deadband_pitch, &ReadParamsExt3::rc_deadband_yaw,
      &ReadParamsExt3::rc_expo_rate_pitch, &ReadParamsExt3::rc_expo_rate_yaw,
      &ReadParamsExt3::profile_flags3, &ReadParamsExt3::default_profile,
      &ReadParamsExt3::retracted_angle, &ReadParamsExt3::shake_generator,
      &ReadParamsExt3::ext_motor_drv_ids, &ReadParamsExt3::encoder_cfg_ext,
      &ReadParamsExt3::ext_sens_params, &ReadParamsExt3::imu_angle_corr_r,
      &ReadParamsExt3::imu_angle_corr_p, &ReadParamsExt3::can_imu_servo_out,
      &ReadParamsExt3::can_imu_servo_rate, &ReadParamsExt3::servo_outer_p_mult,
      &ReadParamsExt3::servo_outer_i, &ReadParamsExt3::ext_pwr_sw_shunt_r,
      &ReadParamsExt3::general_flags4, &ReadParamsExt3::auto_motion_timeout,
      &ReadParamsExt3::reserved_5>;
};

/// Request the fourth set of parameters of one profile.
///
/// CMD_READ_PARAMS_EXT3 (104), to the board; 1 byte. Effect: reads. Since firmware 2.66. Source:
/// Later firmware.
struct ReadParamsExt3Request {
  static constexpr CommandToBoard command = CommandToBoard::read_params_ext3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.firmware = 2660};
  using Response = ReadParamsExt3;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile to read. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const ReadParamsExt3Request&) const = default;
  using FixedMembers = Members<&ReadParamsExt3Request::profile_id>;
};

/// Store the fourth set of parameters of one profile.
///
/// CMD_WRITE_PARAMS_EXT3 (105), to the board; 221 bytes, and later firmware may append more.
/// Effect: stores, moves. Since firmware 2.66. Source: Later firmware.
struct WriteParamsExt3 : ReadParamsExt3 {
  static constexpr CommandToBoard command = CommandToBoard::write_params_ext3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 221;
  static constexpr std::size_t max_size = 221;
  static constexpr Availability since{.firmware = 2660};
  using Response = void;
  using Body = ReadParamsExt3;

  bool operator==(const WriteParamsExt3&) const = default;
};

}  // namespace sbgc::msg
