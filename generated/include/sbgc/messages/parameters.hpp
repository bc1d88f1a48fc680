// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Parameters of the board and of its five profiles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/later_unit.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct ReadParams3;
struct ReadParamsAnswer;
struct ReadParamsExt;
struct ReadParamsExt2;
struct ReadProfileNames;

/// Controller and motor of each axis.
struct AxisPid {
  /// Proportional gain. From firmware 2.73.1 on, it is a LogarithmicGain.
  std::uint8_t p{};
  /// Integral gain. From firmware 2.73.1 on, it is a LogarithmicGain.
  Hundredths i{};
  /// Derivative gain. From firmware 2.73.1 on, it is a LogarithmicGain.
  std::uint8_t d{};
  /// Power of the motor.
  std::uint8_t power{};
  /// 1 inverts the motor's direction. Range: 0 to 1.
  std::uint8_t invert{};
  /// Number of motor poles.
  std::uint8_t poles{};

  /// Returns the physical value of p on a board with these versions; without them, that before
  /// firmware 2.73.1.
  constexpr double real_p(const Availability& versions = {}) const noexcept {
    return detail::real_in_firmware<detail::LaterType<2731, LogarithmicGain>>(p, versions);
  }
  /// Sets it to the raw value nearest to a physical one. Returns false if it does not fit.
  [[nodiscard]] constexpr bool set_p(double value, const Availability& versions = {}) noexcept {
    return detail::set_in_firmware<detail::LaterType<2731, LogarithmicGain>>(p, value, versions);
  }

  /// Returns the physical value of i on a board with these versions; without them, that before
  /// firmware 2.73.1.
  constexpr double real_i(const Availability& versions = {}) const noexcept {
    return detail::real_in_firmware<detail::LaterType<2731, LogarithmicGain>>(i, versions);
  }
  /// Sets it to the raw value nearest to a physical one. Returns false if it does not fit.
  [[nodiscard]] constexpr bool set_i(double value, const Availability& versions = {}) noexcept {
    return detail::set_in_firmware<detail::LaterType<2731, LogarithmicGain>>(i, value, versions);
  }

  /// Returns the physical value of d on a board with these versions; without them, that before
  /// firmware 2.73.1.
  constexpr double real_d(const Availability& versions = {}) const noexcept {
    return detail::real_in_firmware<detail::LaterType<2731, LogarithmicGain>>(d, versions);
  }
  /// Sets it to the raw value nearest to a physical one. Returns false if it does not fit.
  [[nodiscard]] constexpr bool set_d(double value, const Availability& versions = {}) noexcept {
    return detail::set_in_firmware<detail::LaterType<2731, LogarithmicGain>>(d, value, versions);
  }

  bool operator==(const AxisPid&) const = default;
  using FixedMembers = Members<&AxisPid::p, &AxisPid::i, &AxisPid::d, &AxisPid::power,
      &AxisPid::invert, &AxisPid::poles>;
};

/// Remote control of an axis.
struct AxisRc {
  /// Angle at the lowest signal. Range: -720 to 720 deg.
  Degrees rc_min_angle{};
  /// Angle at the highest signal. Range: -720 to 720 deg.
  Degrees rc_max_angle{};
  /// What the signal controls.
  RcMode rc_mode{};
  /// Low-pass filter of the signal; up to 255 only with LPF_EXTENDED_RANGE.
  std::uint8_t rc_lpf{};
  /// Control speed.
  std::uint8_t rc_speed{};
  /// Roll and pitch: how much to follow the flight controller. Yaw: any value but 0 follows the
  /// motor. Range: -127 to 127.
  std::int8_t rc_follow{};

  bool operator==(const AxisRc&) const = default;
  using FixedMembers = Members<&AxisRc::rc_min_angle, &AxisRc::rc_max_angle, &AxisRc::rc_mode,
      &AxisRc::rc_lpf, &AxisRc::rc_speed, &AxisRc::rc_follow>;
};

/// Notch filters of each axis.
struct AxisNotches {
  /// Center frequency of each of the three filters. Unit: Hz.
  std::array<EvenFrequency, 3> notch_freq{};
  /// Width of each filter, between its -3 dB points. Unit: Hz.
  std::array<SmallFrequency, 3> notch_width{};

  bool operator==(const AxisNotches&) const = default;
  using FixedMembers = Members<&AxisNotches::notch_freq, &AxisNotches::notch_width>;
};

/// MAVLink channels.
struct MavChannel {
  /// Serial port of the channel.
  BoardPort mav_src{};
  /// MAVLink system id of the channel.
  std::uint8_t mav_sys_id{};
  /// MAVLink component id of the channel.
  std::uint8_t mav_comp_id{};
  /// Settings of the channel.
  MavConfig mav_cfg_flags{};
  /// Reserved; kept as it is.
  Bytes<4> reserved{};

  bool operator==(const MavChannel&) const = default;
  using FixedMembers = Members<&MavChannel::mav_src, &MavChannel::mav_sys_id,
      &MavChannel::mav_comp_id, &MavChannel::mav_cfg_flags, &MavChannel::reserved>;
};

/// Step signals: each counts how often an RC signal reaches a level.
struct StepSignal {
  /// RC signal that triggers the steps.
  RcMap step_signal_src{};
  /// Number of steps and how to trigger them.
  StepSignalConfig step_signal_cfg{};

  bool operator==(const StepSignal&) const = default;
  using FixedMembers = Members<&StepSignal::step_signal_src, &StepSignal::step_signal_cfg>;
};

/// Calibrations of RC signals: an offset is added, then a factor is applied.
struct RcCalibration {
  /// Calibrated signal.
  RcMap rc_calib_src{};
  /// Offset of the signal.
  SignalOffset rc_calib_offset{};
  /// Factor below the center. Unit: %.
  SignalScale rc_calib_neg_scale{};
  /// Factor above the center. Unit: %.
  SignalScale rc_calib_pos_scale{};

  bool operator==(const RcCalibration&) const = default;
  using FixedMembers = Members<&RcCalibration::rc_calib_src, &RcCalibration::rc_calib_offset,
      &RcCalibration::rc_calib_neg_scale, &RcCalibration::rc_calib_pos_scale>;
};

/// Parameters of one profile and general parameters.
///
/// CMD_READ_PARAMS_3 (21), from the board; 134 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L180-L310; Variables L1010-L1079.
struct ReadParams3 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{.board = 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};
  /// For acc_limiter_all: disabled.
  static constexpr std::uint8_t acc_limiter_disabled{0};
  /// For servo_out: disabled.
  static constexpr std::uint8_t servo_disabled{0};

  /// Profile of the parameters. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// Controller and motor of each axis.
  Axes<AxisPid> axes{};
  /// Acceleration limit of all axes. Unit: deg/s^2. Deprecated since firmware 2.59: use
  /// ACC_LIMITER3 of CMD_READ_PARAMS_EXT2.
  AngularAcceleration acc_limiter_all{};
  /// Gain of the flight controller's roll signal. Range: -127 to 127.
  std::int8_t ext_fc_gain_roll{};
  /// Gain of the flight controller's pitch signal. Range: -127 to 127.
  std::int8_t ext_fc_gain_pitch{};
  /// Remote control of each axis.
  Axes<AxisRc> rc{};
  /// Trust in the gyroscope relative to the accelerometer.
  std::uint8_t gyro_trust{};
  /// 1 enables the motor model. Range: 0 to 1.
  std::uint8_t use_model{};
  /// PWM frequency of the motors.
  PwmFrequency pwm_freq{};
  /// Baud rate of the serial port. The same in all copies.
  SerialSpeed serial_speed{};
  /// Trim of the RC signals. Range: -127 to 127.
  Axes<std::int8_t> rc_trim{};
  /// Dead band around the center of the RC signals.
  std::uint8_t rc_deadband{};
  /// Expo rate of the RC signals. Range: 0 to 100.
  std::uint8_t rc_expo_rate{};
  /// Signal at the RC_ROLL pin.
  RcVirtualMode rc_virt_mode{};
  /// Control source of each axis.
  Axes<RcMap> rc_map{};
  /// Source of the command channel.
  RcMap rc_map_cmd{};
  /// Source of the flight controller's roll signal.
  RcMap rc_map_fc_roll{};
  /// Source of the flight controller's pitch signal.
  RcMap rc_map_fc_pitch{};
  /// Mix of the flight controller's roll signal.
  RcMix rc_mix_fc_roll{};
  /// Mix of the flight controller's pitch signal.
  RcMix rc_mix_fc_pitch{};
  /// What the camera follows.
  FollowMode follow_mode{};
  /// Dead band of the follow mode.
  std::uint8_t follow_deadband{};
  /// Expo rate of the follow mode. Range: 0 to 100.
  std::uint8_t follow_expo_rate{};
  /// Offset of the follow mode. Range: -127 to 127. Deprecated since firmware 2.70: use
  /// FOLLOW_OFFSET_EXT of CMD_READ_PARAMS_EXT3.
  Axes<std::int8_t> follow_offset{};
  /// Axis of the main IMU that points up. The same in all copies.
  SensorAxis axis_top{};
  /// Axis of the main IMU that points right. The same in all copies.
  SensorAxis axis_right{};
  /// Axis of the frame IMU that points up. The same in all copies.
  SensorAxis frame_axis_top{};
  /// Axis of the frame IMU that points right. The same in all copies.
  SensorAxis frame_axis_right{};
  /// Location of the frame IMU. The same in all copies.
  FrameImuPosition frame_imu_pos{};
  /// Dead band of the gyroscope. Unit: gyro unit.
  GyroDeadband gyro_deadband{};
  /// Sensitivity of the gyroscope. Deprecated.
  std::uint8_t gyro_sens{};
  /// 1 enables the controller's I2C pull-ups; in later firmware, an I2C clock of 800 kHz instead of
  /// 400 kHz. Range: 0 to 1.
  std::uint8_t i2c_internal_pullups{};
  /// Gyroscope calibration at start-up.
  SkipGyroCalibration skip_gyro_calib{};
  /// Action for a low signal on the command channel.
  MenuCommand rc_cmd_low{};
  /// Action for a middle signal on the command channel.
  MenuCommand rc_cmd_mid{};
  /// Action for a high signal on the command channel.
  MenuCommand rc_cmd_high{};
  /// Actions for 1 to 5 presses of the menu button.
  std::array<MenuCommand, 5> menu_cmd{};
  /// Action for a long press of the menu button.
  MenuCommand menu_cmd_long{};
  /// Motor output of each axis.
  Axes<MotorOutput> output{};
  /// Battery voltage that triggers the alarm; negative disables it. Range: -30 to 30 V.
  VoltageThreshold bat_threshold_alarm{};
  /// Battery voltage that stops the motors; negative disables it. Range: -30 to 30 V.
  VoltageThreshold bat_threshold_motors{};
  /// Reference voltage of the motor power compensation; negative disables it. Range: -30 to 30 V.
  VoltageThreshold bat_comp_ref{};
  /// When the board makes a sound.
  BeeperModes beeper_modes{};
  /// Angle at which pitch starts to follow roll. Range: 0 to 90 deg.
  SmallDegrees follow_roll_mix_start{};
  /// Angle over which pitch continues to follow roll. Range: 0 to 90 deg.
  SmallDegrees follow_roll_mix_range{};
  /// Additional power to recover lost synchronization.
  Axes<std::uint8_t> booster_power{};
  /// Speed of the follow mode.
  Axes<std::uint8_t> follow_speed{};
  /// 1 estimates the frame angle from the motors. Range: 0 to 1.
  std::uint8_t frame_angle_from_motors{};
  /// Angle at start-up. Unit: deg.
  Axes<Angle14> rc_memory{};
  /// Virtual channel on each servo pin. Range: 1 to 32.
  std::array<std::uint8_t, 4> servo_out{};
  /// PWM frequency of the servo outputs. Range: 50 to 400 Hz.
  ServoRate servo_rate{};
  /// Axes with adaptive control.
  AdaptivePidAxes adaptive_pid_enabled{};
  /// Vibration level that starts the adaptation.
  std::uint8_t adaptive_pid_threshold{};
  /// Speed of the adaptation. Range: 1 to 255.
  std::uint8_t adaptive_pid_rate{};
  /// How slowly the gains recover. Range: 0 to 10.
  std::uint8_t adaptive_pid_recovery_factor{};
  /// Low-pass filter of the follow mode. Range: 0 to 16.
  Axes<std::uint8_t> follow_lpf{};
  /// Options of the whole board. The same in all copies.
  GeneralFlags general_flags1{};
  /// Options of the profile.
  ProfileFlags profile_flags1{};
  /// Protocol of a Spektrum satellite.
  SpektrumMode spektrum_mode{};
  /// Order of the motors. The same in all copies.
  AxisOrder order_of_axes{};
  /// Order of the Euler angles.
  EulerOrderSetting euler_order{};
  /// Selected IMU; write it back unchanged.
  SelectedImu cur_imu{};
  /// Active profile; write it back unchanged. Range: 0 to 4.
  std::uint8_t cur_profile_id{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<121> tail{};

  bool operator==(const ReadParams3&) const = default;
  using FixedMembers = Members<&ReadParams3::profile_id, &ReadParams3::axes,
      &ReadParams3::acc_limiter_all, &ReadParams3::ext_fc_gain_roll,
      &ReadParams3::ext_fc_gain_pitch, &ReadParams3::rc, &ReadParams3::gyro_trust,
      &ReadParams3::use_model, &ReadParams3::pwm_freq, &ReadParams3::serial_speed,
      &ReadParams3::rc_trim, &ReadParams3::rc_deadband, &ReadParams3::rc_expo_rate,
      &ReadParams3::rc_virt_mode, &ReadParams3::rc_map, &ReadParams3::rc_map_cmd,
      &ReadParams3::rc_map_fc_roll, &ReadParams3::rc_map_fc_pitch, &ReadParams3::rc_mix_fc_roll,
      &ReadParams3::rc_mix_fc_pitch, &ReadParams3::follow_mode, &ReadParams3::follow_deadband,
      &ReadParams3::follow_expo_rate, &ReadParams3::follow_offset, &ReadParams3::axis_top,
      &ReadParams3::axis_right, &ReadParams3::frame_axis_top, &ReadParams3::frame_axis_right,
      &ReadParams3::frame_imu_pos, &ReadParams3::gyro_deadband, &ReadParams3::gyro_sens,
      &ReadParams3::i2c_internal_pullups, &ReadParams3::skip_gyro_calib, &ReadParams3::rc_cmd_low,
      &ReadParams3::rc_cmd_mid, &ReadParams3::rc_cmd_high, &ReadParams3::menu_cmd,
      &ReadParams3::menu_cmd_long, &ReadParams3::output, &ReadParams3::bat_threshold_alarm,
      &ReadParams3::bat_threshold_motors, &ReadParams3::bat_comp_ref, &ReadParams3::beeper_modes,
      &ReadParams3::follow_roll_mix_start, &ReadParams3::follow_roll_mix_range,
      &ReadParams3::booster_power, &ReadParams3::follow_speed,
      &ReadParams3::frame_angle_from_motors, &ReadParams3::rc_memory, &ReadParams3::servo_out,
      &ReadParams3::servo_rate, &ReadParams3::adaptive_pid_enabled,
      &ReadParams3::adaptive_pid_threshold, &ReadParams3::adaptive_pid_rate,
      &ReadParams3::adaptive_pid_recovery_factor, &ReadParams3::follow_lpf,
      &ReadParams3::general_flags1, &ReadParams3::profile_flags1, &ReadParams3::spektrum_mode,
      &ReadParams3::order_of_axes, &ReadParams3::euler_order, &ReadParams3::cur_imu,
      &ReadParams3::cur_profile_id>;
};

/// Request the parameters of one profile.
///
/// CMD_READ_PARAMS_3 (21), to the board; 1 byte. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L652-L660.
struct ReadParams3Request {
  static constexpr CommandToBoard command = CommandToBoard::read_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = ReadParams3;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile to read. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const ReadParams3Request&) const = default;
  using FixedMembers = Members<&ReadParams3Request::profile_id>;
};

/// Request the parameters of one profile, with the older id.
///
/// CMD_READ_PARAMS (82), to the board; 1 byte. Effect: reads. Deprecated: use CMD_READ_PARAMS_3.
/// Source: Outgoing commands L652-L660.
struct [[deprecated("use CMD_READ_PARAMS_3")]] ReadParams {
  static constexpr CommandToBoard command = CommandToBoard::read_params;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = ReadParamsAnswer;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile to read. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const ReadParams&) const = default;
  using FixedMembers = Members<&ReadParams::profile_id>;
};

/// More parameters of one profile: filters, encoders, magnetometer.
///
/// CMD_READ_PARAMS_EXT (33), from the board; 104 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L312-L348; Variables L1080-L1108.
struct ReadParamsExt {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_ext;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 104;
  static constexpr std::size_t max_size = 104;
  static constexpr Availability since{.board = 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile of the parameters. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// Notch filters of each axis.
  Axes<AxisNotches> notches{};
  /// Low-pass cut-off of each axis, at its -3 dB point. Range: 0 to 1000 Hz.
  Axes<Frequency> lpf_freq{};
  /// Enabled filters.
  Axes<FilterSwitches> filters_en{};
  /// Encoder angle in the zero position. Unit: deg.
  Axes<Angle14> encoder_offset{};
  /// Angle between the encoder and the motor's magnetic field. Unit: deg.
  Axes<Angle14> encoder_fld_offset{};
  /// Time to set the encoder by hand. Unit: ms.
  Axes<TensOfMilliseconds> encoder_manual_set_time{};
  /// Heating factor of the motor temperature model.
  Axes<std::uint8_t> motor_heating_factor{};
  /// Cooling factor of the motor temperature model.
  Axes<std::uint8_t> motor_cooling_factor{};
  /// Reserved; kept as it is.
  Bytes<2> reserved{};
  /// How much to follow inside the follow mode's dead band.
  std::uint8_t follow_inside_deadband{};
  /// Magnetic linkage of the motor. Deprecated: use MOTOR_MAG_LINK_FINE of CMD_READ_PARAMS_EXT2.
  Axes<std::uint8_t> motor_mag_link{};
  /// Ratio of the gear after the motor.
  Axes<FixedPoint8> motor_gearing{};
  /// Lowest angle of the joint. Range: -381 to 381 deg. Deprecated since firmware 2.61: use
  /// FRAME_CAM_ANGLE_MIN of CMD_READ_PARAMS_EXT2.
  Axes<EncoderLimit> encoder_limit_min{};
  /// Highest angle of the joint. Range: -381 to 381 deg. Deprecated since firmware 2.61: use
  /// FRAME_CAM_ANGLE_MAX of CMD_READ_PARAMS_EXT2.
  Axes<EncoderLimit> encoder_limit_max{};
  /// Depth of the first notch filter; a negative value makes a peak filter. Range: -100 to 100 dB.
  Axes<Decibels> notch1_gain{};
  /// Depth of the second notch filter; a negative value makes a peak filter. Range: -100 to 100 dB.
  Axes<Decibels> notch2_gain{};
  /// Depth of the third notch filter; a negative value makes a peak filter. Range: -100 to 100 dB.
  Axes<Decibels> notch3_gain{};
  /// Sound volume.
  std::uint8_t beeper_volume{};
  /// Ratio of the gear between motor and encoder.
  Axes<Thousandths> encoder_gear_ratio{};
  /// Kind and options of the encoder.
  Axes<EncoderType> encoder_type{};
  /// SPI clock, or the kind of encoder in an I2C driver.
  Axes<EncoderConfig> encoder_cfg{};
  /// Proportional gain of the outer loop.
  Axes<std::uint8_t> outer_p{};
  /// Integral gain of the outer loop.
  Axes<std::uint8_t> outer_i{};
  /// Axis of the magnetometer that points up.
  SensorAxis mag_axis_top{};
  /// Axis of the magnetometer that points right.
  SensorAxis mag_axis_right{};
  /// Trust in the magnetometer.
  std::uint8_t mag_trust{};
  /// Magnetic declination. Range: -127 to 127 deg.
  SignedDegrees mag_declination{};
  /// Low-pass filter of the accelerometer. Range: 0 to 10 Hz.
  FineFrequency acc_lpf_freq{};
  /// Low-pass filter of the derivative term. Range: 0 to 600 Hz.
  Axes<CoarseFrequency> d_term_lpf_freq{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<151> tail{};

  bool operator==(const ReadParamsExt&) const = default;
  using FixedMembers = Members<&ReadParamsExt::profile_id, &ReadParamsExt::notches,
      &ReadParamsExt::lpf_freq, &ReadParamsExt::filters_en, &ReadParamsExt::encoder_offset,
      &ReadParamsExt::encoder_fld_offset, &ReadParamsExt::encoder_manual_set_time,
      &ReadParamsExt::motor_heating_factor, &ReadParamsExt::motor_cooling_factor,
      &ReadParamsExt::reserved, &ReadParamsExt::follow_inside_deadband,
      &ReadParamsExt::motor_mag_link, &ReadParamsExt::motor_gearing,
      &ReadParamsExt::encoder_limit_min, &ReadParamsExt::encoder_limit_max,
      &ReadParamsExt::notch1_gain, &ReadParamsExt::notch2_gain, &ReadParamsExt::notch3_gain,
      &ReadParamsExt::beeper_volume, &ReadParamsExt::encoder_gear_ratio,
      &ReadParamsExt::encoder_type, &ReadParamsExt::encoder_cfg, &ReadParamsExt::outer_p,
      &ReadParamsExt::outer_i, &ReadParamsExt::mag_axis_top, &ReadParamsExt::mag_axis_right,
      &ReadParamsExt::mag_trust, &ReadParamsExt::mag_declination, &ReadParamsExt::acc_lpf_freq,
      &ReadParamsExt::d_term_lpf_freq>;
};

/// Request more parameters of one profile.
///
/// CMD_READ_PARAMS_EXT (33), to the board; 1 byte. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L652-L660.
struct ReadParamsExtRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_params_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = ReadParamsExt;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile to read. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const ReadParamsExtRequest&) const = default;
  using FixedMembers = Members<&ReadParamsExtRequest::profile_id>;
};

/// The third set of parameters of one profile.
///
/// CMD_READ_PARAMS_EXT2 (62), from the board; 151 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L350-L359; Variables L1110-L1116.
struct ReadParamsExt2 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_ext2;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 151;
  static constexpr std::size_t max_size = 151;
  static constexpr Availability since{.board = 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};
  /// For acc_limiter3: disabled.
  static constexpr std::uint8_t acc_limiter3_disabled{0};

  /// Profile of the parameters. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// MAVLink channels. Since firmware 2.60.
  std::array<MavChannel, 2> mav_channels{};
  /// Magnetic linkage of the motor.
  Axes<LongHundredths> motor_mag_link_fine{};
  /// Acceleration limit of each axis. Range: 0 to 1000 deg/s^2. Since firmware 2.59.
  Axes<AngularAcceleration> acc_limiter3{};
  /// Factor for P, I and D of each axis. From firmware 2.73.1 on, it is a LogarithmicGain.
  Axes<PidGain> pid_gain{};
  /// Low-pass filter of the frame IMU. Unit: Hz.
  SmallFrequency frame_imu_lpf_freq{};
  /// CFG_FLAGS for CMD_AUTO_PID.
  AutoPidFlags auto_pid_cfg{};
  /// GAIN_VS_STABILITY for CMD_AUTO_PID.
  std::uint8_t auto_pid_gain{};
  /// Lowest angle of the joint. Unit: deg. Since firmware 2.61.
  Axes<Degrees> frame_cam_angle_min{};
  /// Highest angle of the joint. Unit: deg. Since firmware 2.61.
  Axes<Degrees> frame_cam_angle_max{};
  /// More options of the whole board. The same in all copies. Since firmware 2.61.
  GeneralFlags2 general_flags2{};
  /// Speed of automatic motions. Range: 1 to 255. 0: not set. Since firmware 2.61.
  std::uint8_t auto_speed{};
  /// Acceleration limit of automatic motions. Unit: deg/s^2. Since firmware 2.61.
  AngularAcceleration auto_acc_limiter{};
  /// Correction of the orientation of the main IMU. Unit: deg. Since firmware 2.61.
  Axes<HundredthDegrees> imu_orientation_corr{};
  /// Duration of a time lapse. Unit: ms. Since firmware 2.60.
  Seconds timelapse_time{};
  /// Delay between an emergency stop and the restart. Unit: ms. Since firmware 2.61.
  Milliseconds emergency_stop_restart_delay{};
  /// Share of a time lapse in which the speed changes. Range: 0 to 50 %. Since firmware 2.61.
  FifthPercent timelapse_acc_part{};
  /// Moment of inertia of the axis. Since firmware 2.62b7.
  Axes<std::uint16_t> momentum{};
  /// Stimulus for the calibration of the momentum. Range: 1 to 255. 0: not set. Since firmware
  /// 2.62b7.
  Axes<std::uint8_t> momentum_calib_stimulus{};
  /// How much the momentum depends on the angle. Since firmware 2.62b7.
  Axes<Twentieths> momentum_ellipticity{};
  /// Range of the follow mode. Range: 1 to 180. 0: not set. Since firmware 2.62b7.
  Axes<std::uint8_t> follow_range{};
  /// Axis that the motor stabilizes. Since firmware 2.62b7.
  Axes<StabAxis> stab_axis{};
  /// Tilt of the outer motor. Range: -90 to 90 deg. The same in all copies. Since firmware 2.62b7.
  SignedDegrees outer_mot_tilt_angle{};
  /// Actions at start-up. Since firmware 2.66.
  std::array<StartupAction, 4> startup_action{};
  /// RC signals that are conditions of the actions: a first one for each, then a second one. Since
  /// firmware 2.66.
  std::array<RcMap, 8> startup_action_src{};
  /// Thresholds of these signals, in steps of 10. Since firmware 2.66.
  std::array<std::int8_t, 8> startup_action_threshold{};
  /// When and how the axis snaps to a fixed position. Since firmware 2.66.
  Axes<ForcePositionConfig> force_position_cfg{};
  /// Step signals: each counts how often an RC signal reaches a level. Since firmware 2.66.
  std::array<StepSignal, 6> step_signals{};
  /// Calibrations of RC signals: an offset is added, then a factor is applied. Since firmware 2.66.
  std::array<RcCalibration, 5> rc_calibrations{};
  /// Limits at which the axes park. Since firmware 2.66.
  ParkingBorders parking_pos_cfg{};
  /// Pin that repeats the signals of the LED. The same in all copies. Since firmware 2.66.
  OutputPin ext_led_pin_id{};
  /// Pin that signals an event to other devices. The same in all copies. Since firmware 2.66.
  InterruptConfig interrupt_cfg{};
  /// How long the motors may be overloaded. Unit: ms. Since firmware 2.66.
  HundredsOfMilliseconds overload_time{};
  /// MOMENTUM for CMD_AUTO_PID. 0: automatic. Since firmware 2.66.
  std::uint8_t auto_pid_momentum{};
  /// How slowly the acceleration changes. Since firmware 2.66.
  Axes<std::uint8_t> jerk_slope{};
  /// Axes that a MAVLink host controls. Since firmware 2.66.
  MavControlMode mav_ctrl_mode{};
  /// Baud rate of the serial RC input. The same in all copies. Since firmware 2.66.
  SerialSpeed rc_serial_speed{};
  /// Baud rate of UART 2. The same in all copies. Since firmware 2.66.
  SerialSpeed uart2_speed{};
  /// Resistance of one phase of the motor. Unit: ohm. Since firmware 2.66.
  Axes<TenthOhms> motor_res{};
  /// Limit of the total current. Unit: mA. Since firmware 2.66.
  TensOfMilliamperes current_limit{};
  /// Tilt of the middle motor. Range: -90 to 90 deg. The same in all copies. Since firmware 2.67.
  SignedDegrees middle_mot_tilt_angle{};

  /// Returns the physical value of pid_gain of an element on a board with these versions; without
  /// them, that before firmware 2.73.1.
  constexpr double real_pid_gain(std::size_t index, const Availability& versions = {}) const
      noexcept {
    return detail::real_in_firmware<detail::LaterType<2731, LogarithmicGain>>(pid_gain[index],
        versions);
  }
  /// Sets it to the raw value nearest to a physical one. Returns false if it does not fit.
  [[nodiscard]] constexpr bool set_pid_gain(std::size_t index, double value, const Availability&
      versions = {}) noexcept {
    return detail::set_in_firmware<detail::LaterType<2731, LogarithmicGain>>(pid_gain[index], value,
        versions);
  }
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<104> tail{};

  bool operator==(const ReadParamsExt2&) const = default;
  using FixedMembers = Members<&ReadParamsExt2::profile_id, &ReadParamsExt2::mav_channels,
      &ReadParamsExt2::motor_mag_link_fine, &ReadParamsExt2::acc_limiter3,
      &ReadParamsExt2::pid_gain, &ReadParamsExt2::frame_imu_lpf_freq, &ReadParamsExt2::auto_pid_cfg,
      &ReadParamsExt2::auto_pid_gain, &ReadParamsExt2::frame_cam_angle_min,
      &ReadParamsExt2::frame_cam_angle_max, &ReadParamsExt2::general_flags2,
      &ReadParamsExt2::auto_speed, &ReadParamsExt2::auto_acc_limiter,
      &ReadParamsExt2::imu_orientation_corr, &ReadParamsExt2::timelapse_time,
      &ReadParamsExt2::emergency_stop_restart_delay, &ReadParamsExt2::timelapse_acc_part,
      &ReadParamsExt2::momentum, &ReadParamsExt2::momentum_calib_stimulus,
      &ReadParamsExt2::momentum_ellipticity, &ReadParamsExt2::follow_range,
      &ReadParamsExt2::stab_axis, &ReadParamsExt2::outer_mot_tilt_angle,
      &ReadParamsExt2::startup_action, &ReadParamsExt2::startup_action_src,
      &ReadParamsExt2::startup_action_threshold, &ReadParamsExt2::force_position_cfg,
      &ReadParamsExt2::step_signals, &ReadParamsExt2::rc_calibrations,
      &ReadParamsExt2::parking_pos_cfg, &ReadParamsExt2::ext_led_pin_id,
      &ReadParamsExt2::interrupt_cfg, &ReadParamsExt2::overload_time,
      &ReadParamsExt2::auto_pid_momentum, &ReadParamsExt2::jerk_slope,
      &ReadParamsExt2::mav_ctrl_mode, &ReadParamsExt2::rc_serial_speed,
      &ReadParamsExt2::uart2_speed, &ReadParamsExt2::motor_res, &ReadParamsExt2::current_limit,
      &ReadParamsExt2::middle_mot_tilt_angle>;
};

/// Request the third set of parameters of one profile.
///
/// CMD_READ_PARAMS_EXT2 (62), to the board; 1 byte. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L658-L660.
struct ReadParamsExt2Request {
  static constexpr CommandToBoard command = CommandToBoard::read_params_ext2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = ReadParamsExt2;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile{255};

  /// Profile to read. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const ReadParamsExt2Request&) const = default;
  using FixedMembers = Members<&ReadParamsExt2Request::profile_id>;
};

/// Begin or end a series of commands that store parameters. Between the two, the board is in a
/// state for configuration. At the end it may restart to apply the parameters.
///
/// CMD_WRITE_PARAMS_SET (119), to the board; 1 byte. Effect: sets, moves, restarts. Since firmware
/// 2.70b4. Source: Later firmware.
struct WriteParamsSet {
  static constexpr CommandToBoard command = CommandToBoard::write_params_set;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.firmware = 2704};
  using Response = void;

  /// Whether the series begins or ends.
  WriteParamsAction action{};

  bool operator==(const WriteParamsSet&) const = default;
  using FixedMembers = Members<&WriteParamsSet::action>;
};

/// Profile names.
///
/// CMD_READ_PROFILE_NAMES (28), from the board; 240 bytes, and later firmware may append more.
/// Since board 3.0. Source: Incoming commands L445-L453.
struct ReadProfileNames {
  static constexpr CommandFromBoard command = CommandFromBoard::read_profile_names;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 240;
  static constexpr std::size_t max_size = 240;
  static constexpr Availability since{.board = 30};

  /// Name of each profile.
  std::array<Text<48>, 5> profile_name{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<15> tail{};

  bool operator==(const ReadProfileNames&) const = default;
  using FixedMembers = Members<&ReadProfileNames::profile_name>;
};

/// Request the profile names.
///
/// CMD_READ_PROFILE_NAMES (28), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L761.
struct ReadProfileNamesRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_profile_names;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = ReadProfileNames;

  bool operator==(const ReadProfileNamesRequest&) const = default;
};

/// Save, clear or load a profile set.
///
/// CMD_PROFILE_SET (95), to the board; 10 bytes. Effect: stores, moves, erases. Since firmware
/// 2.65. Source: Later firmware.
struct ProfileSet {
  static constexpr CommandToBoard command = CommandToBoard::profile_set;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{.firmware = 2650};
  using Response = void;

  /// For slot: the backup.
  static constexpr std::uint8_t backup_slot{6};

  /// Place of the profile set. Range: 1 to 5.
  std::uint8_t slot{};
  /// Operation.
  ProfileSetAction action{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const ProfileSet&) const = default;
  using FixedMembers = Members<&ProfileSet::slot, &ProfileSet::action, &ProfileSet::reserved>;
};

/// Save the parameters in use, with all changes to adjustable variables, to the active profile.
///
/// CMD_SAVE_PARAMS_3 (32), to the board; 0 to 255 bytes. Effect: stores. Since board 3.0. Source:
/// Outgoing commands L804.
struct SaveParams3 {
  static constexpr CommandToBoard command = CommandToBoard::save_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Variables to save; none stands for all. Since firmware 2.68b9.
  BoundedArray<VariableId, 255> param_id{};

  bool operator==(const SaveParams3&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.param_id, "param_id");
  }
};

/// Restore the factory defaults. The parameters of the profile are lost; 253 erases the whole
/// EEPROM. Back up the parameters first.
///
/// CMD_USE_DEFAULTS (70), to the board; 1 byte. Effect: stores, moves, erases. Source: Outgoing
/// commands L644-L648.
struct UseDefaults {
  static constexpr CommandToBoard command = CommandToBoard::use_defaults;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = void;

  /// For profile_id: erases the EEPROM.
  static constexpr std::uint8_t erase_eeprom{253};
  /// For profile_id: resets the active profile.
  static constexpr std::uint8_t reset_active{254};

  /// Profile to reset. Range: 0 to 4.
  std::uint8_t profile_id{};

  bool operator==(const UseDefaults&) const = default;
  using FixedMembers = Members<&UseDefaults::profile_id>;
};

/// Store the parameters of one profile and the general parameters. Also saves to the EEPROM. Write
/// back what you read and change only what you need: unknown bytes are parameters too.
///
/// CMD_WRITE_PARAMS_3 (22), to the board; 134 bytes, and later firmware may append more. Effect:
/// stores, moves. Since board 3.0. Source: Outgoing commands L662-L668; Variables L1010-L1079.
struct WriteParams3 : ReadParams3 {
  static constexpr CommandToBoard command = CommandToBoard::write_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadParams3;

  bool operator==(const WriteParams3&) const = default;
};

/// Parameters of one profile and general parameters, with the older id.
///
/// CMD_READ_PARAMS (82), from the board; 134 bytes, and later firmware may append more. Deprecated:
/// use CMD_READ_PARAMS_3. Source: Outgoing commands L652-L660.
struct [[deprecated("use CMD_READ_PARAMS_3")]] ReadParamsAnswer : ReadParams3 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{};
  using Body = ReadParams3;

  bool operator==(const ReadParamsAnswer&) const = default;
};

/// Store the parameters of one profile and the general parameters, with the older id.
///
/// CMD_WRITE_PARAMS (87), to the board; 134 bytes, and later firmware may append more. Effect:
/// stores, moves. Deprecated: use CMD_WRITE_PARAMS_3. Source: Outgoing commands L662-L668.
struct [[deprecated("use CMD_WRITE_PARAMS_3")]] WriteParams : ReadParams3 {
  static constexpr CommandToBoard command = CommandToBoard::write_params;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{};
  using Response = void;
  using Body = ReadParams3;

  bool operator==(const WriteParams&) const = default;
};

/// Store more parameters of one profile.
///
/// CMD_WRITE_PARAMS_EXT (34), to the board; 104 bytes, and later firmware may append more. Effect:
/// stores, moves. Since board 3.0. Source: Outgoing commands L662-L668; Variables L1080-L1108.
struct WriteParamsExt : ReadParamsExt {
  static constexpr CommandToBoard command = CommandToBoard::write_params_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 104;
  static constexpr std::size_t max_size = 104;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadParamsExt;

  bool operator==(const WriteParamsExt&) const = default;
};

/// Store the third set of parameters of one profile.
///
/// CMD_WRITE_PARAMS_EXT2 (63), to the board; 151 bytes, and later firmware may append more. Effect:
/// stores, moves. Since board 3.0. Source: Outgoing commands L668; Variables L1110-L1116.
struct WriteParamsExt2 : ReadParamsExt2 {
  static constexpr CommandToBoard command = CommandToBoard::write_params_ext2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 151;
  static constexpr std::size_t max_size = 151;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadParamsExt2;

  bool operator==(const WriteParamsExt2&) const = default;
};

/// Store the profile names.
///
/// CMD_WRITE_PROFILE_NAMES (29), to the board; 240 bytes, and later firmware may append more.
/// Effect: stores. Since board 3.0. Source: Outgoing commands L763-L772.
struct WriteProfileNames : ReadProfileNames {
  static constexpr CommandToBoard command = CommandToBoard::write_profile_names;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 240;
  static constexpr std::size_t max_size = 240;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadProfileNames;

  bool operator==(const WriteProfileNames&) const = default;
};

}  // namespace sbgc::msg

#pragma GCC diagnostic pop
