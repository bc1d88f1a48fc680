// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Settings of the board and of its five profiles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::get;
using sbgc::put;

static_assert(codec_version == 1, "generated code and runtime do not belong together");

struct ReadParams3;
struct ReadParamsExt;
struct ReadParamsExt2;
struct ReadProfileNames;

/// Controller and motor of each axis.
struct AxisPid {
  static constexpr std::size_t wire_size = 6;

  /// Proportional gain. Range: 0 to 255.
  std::uint8_t p{};
  /// Integral gain. Unit: no unit, one count is 1/100. Range: 0 to 255.
  Hundredths i{};
  /// Derivative gain. Range: 0 to 255.
  std::uint8_t d{};
  /// Power of the motor. Range: 0 to 255.
  std::uint8_t power{};
  /// 1 if the motor's direction is inverted. Range: 0 to 1.
  std::uint8_t invert{};
  /// Number of the motor's poles. Range: 0 to 255.
  std::uint8_t poles{};

  constexpr bool operator==(const AxisPid&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisPid& SBGC_RESTRICT out) noexcept {
  using M = AxisPid;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, p), offsetof(M, poles), 5)) {
    detail::get_block(from, out, offsetof(M, p), 6);
    return;
  }
  get(from, out.p);
  get(from + 1, out.i);
  get(from + 2, out.d);
  get(from + 3, out.power);
  get(from + 4, out.invert);
  get(from + 5, out.poles);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisPid& SBGC_RESTRICT in) noexcept {
  using M = AxisPid;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, p), offsetof(M, poles), 5)) {
    detail::put_block(to, in, offsetof(M, p), 6);
    return;
  }
  put(to, in.p);
  put(to + 1, in.i);
  put(to + 2, in.d);
  put(to + 3, in.power);
  put(to + 4, in.invert);
  put(to + 5, in.poles);
}

/// Remote control of each axis.
struct AxisRc {
  static constexpr std::size_t wire_size = 8;

  /// Angle at the lowest signal. Unit: deg. Range: -720 to 720.
  Degrees rc_min_angle{};
  /// Angle at the highest signal. Unit: deg. Range: -720 to 720.
  Degrees rc_max_angle{};
  /// What the signal controls.
  RcMode rc_mode{};
  /// Low-pass filter of the signal. Range: 0 to 16.
  std::uint8_t rc_lpf{};
  /// Speed of the control. Range: 0 to 255.
  std::uint8_t rc_speed{};
  /// Roll and pitch: how much to follow the flight controller. Yaw: not 0 follows the motor. Range:
  /// -127 to 127. Errata: E003, E067.
  std::int8_t rc_follow{};

  constexpr bool operator==(const AxisRc&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisRc& SBGC_RESTRICT out) noexcept {
  using M = AxisRc;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, rc_min_angle), offsetof(M, rc_follow), 7)) {
    detail::get_block(from, out, offsetof(M, rc_min_angle), 8);
    return;
  }
  get(from, out.rc_min_angle);
  get(from + 2, out.rc_max_angle);
  get(from + 4, out.rc_mode);
  get(from + 5, out.rc_lpf);
  get(from + 6, out.rc_speed);
  get(from + 7, out.rc_follow);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisRc& SBGC_RESTRICT in) noexcept {
  using M = AxisRc;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, rc_min_angle), offsetof(M, rc_follow), 7)) {
    detail::put_block(to, in, offsetof(M, rc_min_angle), 8);
    return;
  }
  put(to, in.rc_min_angle);
  put(to + 2, in.rc_max_angle);
  put(to + 4, in.rc_mode);
  put(to + 5, in.rc_lpf);
  put(to + 6, in.rc_speed);
  put(to + 7, in.rc_follow);
}

/// Notch filters of each axis.
struct AxisNotches {
  static constexpr std::size_t wire_size = 6;

  /// Middle frequency of each of the three filters. Unit: Hz, one count is 2. Range: 0 to 255.
  /// Errata: E011.
  std::array<EvenFrequency, 3> notch_freq{};
  /// Width of each filter, between its -3 dB points. Unit: Hz. Range: 0 to 255. Errata: E011.
  std::array<SmallFrequency, 3> notch_width{};

  constexpr bool operator==(const AxisNotches&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisNotches& SBGC_RESTRICT out) noexcept {
  get(from, out.notch_freq);
  get(from + 3, out.notch_width);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisNotches& SBGC_RESTRICT in) noexcept {
  put(to, in.notch_freq);
  put(to + 3, in.notch_width);
}

/// Settings of one profile together with the general settings.
///
/// CMD_READ_PARAMS_3 (21), from the board; 134 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L180-L310; Variables L1010-L1079. Errata: E087, E096, E099, E105.
struct ReadParams3 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{0, 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;
  /// For acc_limiter_all: disabled.
  static constexpr std::uint8_t acc_limiter_disabled = 0;
  /// For servo_out: disabled.
  static constexpr std::uint8_t servo_disabled = 0;

  /// Profile that the settings belong to. Range: 0 to 4. active_profile (255): the active profile.
  /// Errata: E062.
  std::uint8_t profile_id{};
  /// Controller and motor of each axis.
  Axes<AxisPid> axes{};
  /// Limit of the acceleration of all axes. Unit: deg/s^2, one count is 5. Range: 0 to 255.
  /// acc_limiter_disabled (0): disabled. Deprecated since firmware 2.59: use ACC_LIMITER3 of
  /// CMD_READ_PARAMS_EXT2. Errata: E066.
  AngularAcceleration acc_limiter_all{};
  /// Gain of the flight controller's roll signal. Range: -127 to 127. Errata: E036.
  std::int8_t ext_fc_gain_roll{};
  /// Gain of the flight controller's pitch signal. Range: -127 to 127. Errata: E036.
  std::int8_t ext_fc_gain_pitch{};
  /// Remote control of each axis.
  Axes<AxisRc> rc{};
  /// Trust in the gyroscope against the accelerometer. Range: 0 to 255.
  std::uint8_t gyro_trust{};
  /// 1 if the model of the motors is used. Range: 0 to 1.
  std::uint8_t use_model{};
  /// PWM frequency of the motors.
  PwmFrequency pwm_freq{};
  /// Baud rate of the serial port. General: the same in all copies. Errata: E087.
  SerialSpeed serial_speed{};
  /// Trim of the RC signals. Range: -127 to 127.
  Axes<std::int8_t> rc_trim{};
  /// Dead band around the middle of the RC signals. Range: 0 to 255.
  std::uint8_t rc_deadband{};
  /// Curvature of the RC signals. Range: 0 to 100.
  std::uint8_t rc_expo_rate{};
  /// What the RC_ROLL pin receives.
  RcVirtualMode rc_virt_mode{};
  /// Source of control of each axis. Errata: E058, E069.
  Axes<RcMap> rc_map{};
  /// Source of the command channel. Errata: E058, E069.
  RcMap rc_map_cmd{};
  /// Source of the flight controller's roll signal. Errata: E058, E069.
  RcMap rc_map_fc_roll{};
  /// Source of the flight controller's pitch signal. Errata: E058, E069.
  RcMap rc_map_fc_pitch{};
  /// Where the flight controller's roll signal is mixed in.
  RcMix rc_mix_fc_roll{};
  /// Where the flight controller's pitch signal is mixed in.
  RcMix rc_mix_fc_pitch{};
  /// What the camera follows.
  FollowMode follow_mode{};
  /// Dead band of the follow mode. Range: 0 to 255.
  std::uint8_t follow_deadband{};
  /// Curvature of the follow mode. Range: 0 to 100.
  std::uint8_t follow_expo_rate{};
  /// Offset of the follow mode. Range: -127 to 127.
  Axes<std::int8_t> follow_offset{};
  /// Axis of the main IMU that points up. General: the same in all copies. Errata: E087.
  SensorAxis axis_top{};
  /// Axis of the main IMU that points right. General: the same in all copies. Errata: E087.
  SensorAxis axis_right{};
  /// Axis of the frame IMU that points up. General: the same in all copies. Errata: E087.
  SensorAxis frame_axis_top{};
  /// Axis of the frame IMU that points right. General: the same in all copies. Errata: E087.
  SensorAxis frame_axis_right{};
  /// Where the frame IMU is mounted. General: the same in all copies. Errata: E087.
  FrameImuPosition frame_imu_pos{};
  /// Dead band of the gyroscope. Unit: gyro unit, one count is 1/10. Range: 0 to 255.
  GyroDeadband gyro_deadband{};
  /// Sensitivity of the gyroscope. Errata: E114.
  std::uint8_t gyro_sens{};
  /// 1 if the I2C bus uses the controller's pull-ups. Range: 0 to 1.
  std::uint8_t i2c_internal_pullups{};
  /// Calibration of the gyroscope at start-up.
  SkipGyroCalibration skip_gyro_calib{};
  /// Action at a low signal of the command channel.
  MenuCommand rc_cmd_low{};
  /// Action at a middle signal of the command channel.
  MenuCommand rc_cmd_mid{};
  /// Action at a high signal of the command channel.
  MenuCommand rc_cmd_high{};
  /// Actions for 1 to 5 presses of the menu button.
  std::array<MenuCommand, 5> menu_cmd{};
  /// Action for a long press of the menu button.
  MenuCommand menu_cmd_long{};
  /// Motor output of each axis.
  Axes<MotorOutput> output{};
  /// Battery voltage that sounds the alarm; negative turns it off. Unit: V, one count is 1/100.
  /// Range: -3000 to 3000.
  VoltageThreshold bat_threshold_alarm{};
  /// Battery voltage that stops the motors; negative turns it off. Unit: V, one count is 1/100.
  /// Range: -3000 to 3000.
  VoltageThreshold bat_threshold_motors{};
  /// Battery voltage that the motor power is compensated to; negative turns it off. Unit: V, one
  /// count is 1/100. Range: -3000 to 3000.
  VoltageThreshold bat_comp_ref{};
  /// When the board makes a sound. Errata: E049, E111.
  BeeperModes beeper_modes{};
  /// Angle at which pitch begins to follow roll. Unit: deg. Range: 0 to 90. Errata: E047, E115.
  SmallDegrees follow_roll_mix_start{};
  /// Angle over which pitch goes on to follow roll. Unit: deg. Range: 0 to 90. Errata: E047, E115.
  SmallDegrees follow_roll_mix_range{};
  /// Additional power that corrects a lost synchronisation. Range: 0 to 255.
  Axes<std::uint8_t> booster_power{};
  /// Speed of the follow mode. Range: 0 to 255.
  Axes<std::uint8_t> follow_speed{};
  /// 1 if the frame's angle is estimated from the motors. Range: 0 to 1.
  std::uint8_t frame_angle_from_motors{};
  /// Angle at start-up. Unit: deg, one count is 360/16384. Range: -32768 to 32767. Errata: E052.
  Axes<Angle14> rc_memory{};
  /// Virtual channel that is output at each servo pin. Range: 1 to 32. servo_disabled (0):
  /// disabled. Errata: E069.
  std::array<std::uint8_t, 4> servo_out{};
  /// PWM frequency of the servo outputs. Unit: Hz, one count is 10. Range: 5 to 40.
  ServoRate servo_rate{};
  /// Axes with adaptive control.
  AdaptivePidAxes adaptive_pid_enabled{};
  /// Vibration that starts the adaptation. Range: 0 to 255.
  std::uint8_t adaptive_pid_threshold{};
  /// Speed of the adaptation. Range: 1 to 255.
  std::uint8_t adaptive_pid_rate{};
  /// How slowly the gains come back. Range: 0 to 10.
  std::uint8_t adaptive_pid_recovery_factor{};
  /// Low-pass filter of the follow mode. Range: 0 to 16.
  Axes<std::uint8_t> follow_lpf{};
  /// Settings of the whole board. General: the same in all copies. Errata: E087.
  GeneralFlags general_flags1{};
  /// Settings of the profile.
  ProfileFlags profile_flags1{};
  /// Protocol of a Spektrum satellite.
  SpektrumMode spektrum_mode{};
  /// Order of the motors. General: the same in all copies. Errata: E005, E087.
  AxisOrder order_of_axes{};
  /// Order of the Euler angles. Errata: E005.
  EulerOrder euler_order{};
  /// Currently selected IMU; written back as it was read. Errata: E088.
  SelectedImu cur_imu{};
  /// Active profile; written back as it was read. Range: 0 to 4. Errata: E034, E061, E088.
  std::uint8_t cur_profile_id{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<121> tail{};

  constexpr bool operator==(const ReadParams3&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParams3& SBGC_RESTRICT out) noexcept {
  using M = ReadParams3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, output), 88) &&
      detail::in_parallel(offsetof(M, bat_threshold_alarm), offsetof(M, cur_profile_id), 42)) {
    detail::get_block(from, out, offsetof(M, profile_id), 91);
    detail::get_block(from + 91, out, offsetof(M, bat_threshold_alarm), 43);
    return;
  }
  get(from, out.profile_id);
  get(from + 1, out.axes);
  get(from + 19, out.acc_limiter_all);
  get(from + 20, out.ext_fc_gain_roll);
  get(from + 21, out.ext_fc_gain_pitch);
  get(from + 22, out.rc);
  get(from + 46, out.gyro_trust);
  get(from + 47, out.use_model);
  get(from + 48, out.pwm_freq);
  get(from + 49, out.serial_speed);
  get(from + 50, out.rc_trim);
  get(from + 53, out.rc_deadband);
  get(from + 54, out.rc_expo_rate);
  get(from + 55, out.rc_virt_mode);
  get(from + 56, out.rc_map);
  get(from + 59, out.rc_map_cmd);
  get(from + 60, out.rc_map_fc_roll);
  get(from + 61, out.rc_map_fc_pitch);
  get(from + 62, out.rc_mix_fc_roll);
  get(from + 63, out.rc_mix_fc_pitch);
  get(from + 64, out.follow_mode);
  get(from + 65, out.follow_deadband);
  get(from + 66, out.follow_expo_rate);
  get(from + 67, out.follow_offset);
  get(from + 70, out.axis_top);
  get(from + 71, out.axis_right);
  get(from + 72, out.frame_axis_top);
  get(from + 73, out.frame_axis_right);
  get(from + 74, out.frame_imu_pos);
  get(from + 75, out.gyro_deadband);
  get(from + 76, out.gyro_sens);
  get(from + 77, out.i2c_internal_pullups);
  get(from + 78, out.skip_gyro_calib);
  get(from + 79, out.rc_cmd_low);
  get(from + 80, out.rc_cmd_mid);
  get(from + 81, out.rc_cmd_high);
  get(from + 82, out.menu_cmd);
  get(from + 87, out.menu_cmd_long);
  get(from + 88, out.output);
  get(from + 91, out.bat_threshold_alarm);
  get(from + 93, out.bat_threshold_motors);
  get(from + 95, out.bat_comp_ref);
  get(from + 97, out.beeper_modes);
  get(from + 98, out.follow_roll_mix_start);
  get(from + 99, out.follow_roll_mix_range);
  get(from + 100, out.booster_power);
  get(from + 103, out.follow_speed);
  get(from + 106, out.frame_angle_from_motors);
  get(from + 107, out.rc_memory);
  get(from + 113, out.servo_out);
  get(from + 117, out.servo_rate);
  get(from + 118, out.adaptive_pid_enabled);
  get(from + 119, out.adaptive_pid_threshold);
  get(from + 120, out.adaptive_pid_rate);
  get(from + 121, out.adaptive_pid_recovery_factor);
  get(from + 122, out.follow_lpf);
  get(from + 125, out.general_flags1);
  get(from + 127, out.profile_flags1);
  get(from + 129, out.spektrum_mode);
  get(from + 130, out.order_of_axes);
  get(from + 131, out.euler_order);
  get(from + 132, out.cur_imu);
  get(from + 133, out.cur_profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParams3& SBGC_RESTRICT in) noexcept {
  using M = ReadParams3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, output), 88) &&
      detail::in_parallel(offsetof(M, bat_threshold_alarm), offsetof(M, cur_profile_id), 42)) {
    detail::put_block(to, in, offsetof(M, profile_id), 91);
    detail::put_block(to + 91, in, offsetof(M, bat_threshold_alarm), 43);
    return;
  }
  put(to, in.profile_id);
  put(to + 1, in.axes);
  put(to + 19, in.acc_limiter_all);
  put(to + 20, in.ext_fc_gain_roll);
  put(to + 21, in.ext_fc_gain_pitch);
  put(to + 22, in.rc);
  put(to + 46, in.gyro_trust);
  put(to + 47, in.use_model);
  put(to + 48, in.pwm_freq);
  put(to + 49, in.serial_speed);
  put(to + 50, in.rc_trim);
  put(to + 53, in.rc_deadband);
  put(to + 54, in.rc_expo_rate);
  put(to + 55, in.rc_virt_mode);
  put(to + 56, in.rc_map);
  put(to + 59, in.rc_map_cmd);
  put(to + 60, in.rc_map_fc_roll);
  put(to + 61, in.rc_map_fc_pitch);
  put(to + 62, in.rc_mix_fc_roll);
  put(to + 63, in.rc_mix_fc_pitch);
  put(to + 64, in.follow_mode);
  put(to + 65, in.follow_deadband);
  put(to + 66, in.follow_expo_rate);
  put(to + 67, in.follow_offset);
  put(to + 70, in.axis_top);
  put(to + 71, in.axis_right);
  put(to + 72, in.frame_axis_top);
  put(to + 73, in.frame_axis_right);
  put(to + 74, in.frame_imu_pos);
  put(to + 75, in.gyro_deadband);
  put(to + 76, in.gyro_sens);
  put(to + 77, in.i2c_internal_pullups);
  put(to + 78, in.skip_gyro_calib);
  put(to + 79, in.rc_cmd_low);
  put(to + 80, in.rc_cmd_mid);
  put(to + 81, in.rc_cmd_high);
  put(to + 82, in.menu_cmd);
  put(to + 87, in.menu_cmd_long);
  put(to + 88, in.output);
  put(to + 91, in.bat_threshold_alarm);
  put(to + 93, in.bat_threshold_motors);
  put(to + 95, in.bat_comp_ref);
  put(to + 97, in.beeper_modes);
  put(to + 98, in.follow_roll_mix_start);
  put(to + 99, in.follow_roll_mix_range);
  put(to + 100, in.booster_power);
  put(to + 103, in.follow_speed);
  put(to + 106, in.frame_angle_from_motors);
  put(to + 107, in.rc_memory);
  put(to + 113, in.servo_out);
  put(to + 117, in.servo_rate);
  put(to + 118, in.adaptive_pid_enabled);
  put(to + 119, in.adaptive_pid_threshold);
  put(to + 120, in.adaptive_pid_rate);
  put(to + 121, in.adaptive_pid_recovery_factor);
  put(to + 122, in.follow_lpf);
  put(to + 125, in.general_flags1);
  put(to + 127, in.profile_flags1);
  put(to + 129, in.spektrum_mode);
  put(to + 130, in.order_of_axes);
  put(to + 131, in.euler_order);
  put(to + 132, in.cur_imu);
  put(to + 133, in.cur_profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParams3& out) noexcept {
  if (body.size() < 134) return detail::wrong_size(body.size(), 134);
  get(body.data(), out);
  return detail::get_tail(body, 134, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadParams3& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 134 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 134, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ReadParams3& in) noexcept {
  using M = ReadParams3;
  if (!(detail::in_parallel(offsetof(M, profile_id), offsetof(M, output), 88) &&
      detail::in_parallel(offsetof(M, bat_threshold_alarm), offsetof(M, cur_profile_id), 42))) return false;
  detail::add_block(sum, in, offsetof(M, profile_id), 91);
  detail::add_block(sum, in, offsetof(M, bat_threshold_alarm), 43);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for the settings of one profile.
///
/// CMD_READ_PARAMS_3 (21), to the board; 1 byte.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L652-L660. Errata: E101.
struct ReadParams3Request {
  static constexpr CommandToBoard command = CommandToBoard::read_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};
  using Response = ReadParams3;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;

  /// Profile to read. Range: 0 to 4. active_profile (255): the active profile. Errata: E062.
  std::uint8_t profile_id{};

  constexpr bool operator==(const ReadParams3Request&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParams3Request& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParams3Request& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParams3Request& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadParams3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Ask for the settings of one profile, with the older id.
///
/// CMD_READ_PARAMS (82), to the board; 1 byte.
/// Effect: reads.
/// Deprecated: use CMD_READ_PARAMS_3.
/// Source: Outgoing commands L652-L660. Errata: E019, E101, E120.
struct ReadParams {
  static constexpr CommandToBoard command = CommandToBoard::read_params;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = ReadParams3;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;

  /// Profile to read. Range: 0 to 4. active_profile (255): the active profile. Errata: E062.
  std::uint8_t profile_id{};

  constexpr bool operator==(const ReadParams&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParams& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParams& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParams& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadParams& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Further settings of one profile: filters, encoders, magnetometer.
///
/// CMD_READ_PARAMS_EXT (33), from the board; 104 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L312-L348; Variables L1080-L1108. Errata: E087, E105.
struct ReadParamsExt {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_ext;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 104;
  static constexpr std::size_t max_size = 104;
  static constexpr Availability since{0, 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;

  /// Profile that the settings belong to. Range: 0 to 4. active_profile (255): the active profile.
  /// Errata: E062.
  std::uint8_t profile_id{};
  /// Notch filters of each axis. Errata: E011.
  Axes<AxisNotches> notches{};
  /// Low-pass filter of each axis, at its -3 dB point. Unit: Hz. Range: 0 to 1000. Errata: E065,
  /// E105.
  Axes<Frequency> lpf_freq{};
  /// Filters that are on.
  Axes<FilterSwitches> filters_en{};
  /// Angle of the encoder in zero position. Unit: deg, one count is 360/16384. Errata: E074.
  Axes<Angle14> encoder_offset{};
  /// Angle between the encoder and the motor's magnetic field. Unit: deg, one count is 360/16384.
  /// Errata: E074.
  Axes<Angle14> encoder_fld_offset{};
  /// Time for setting the encoder by hand. Unit: ms, one count is 10. Range: 0 to 255. Errata:
  /// E047.
  Axes<TensOfMilliseconds> encoder_manual_set_time{};
  /// Warming in the model of the motor's temperature. Range: 0 to 255. Errata: E047.
  Axes<std::uint8_t> motor_heating_factor{};
  /// Cooling in the model of the motor's temperature. Range: 0 to 255. Errata: E047.
  Axes<std::uint8_t> motor_cooling_factor{};
  /// Reserved; kept as it is.
  Bytes<2> reserved{};
  /// How much to follow inside the dead band of the follow mode. Range: 0 to 255. Errata: E047.
  std::uint8_t follow_inside_deadband{};
  /// Magnetic linkage of the motor. Range: 0 to 255. Deprecated: use MOTOR_MAG_LINK_FINE of
  /// CMD_READ_PARAMS_EXT2.
  Axes<std::uint8_t> motor_mag_link{};
  /// Ratio of the gear behind the motor. Unit: no unit, one count is 1/256.
  Axes<FixedPoint8> motor_gearing{};
  /// Lowest angle of the joint. Unit: deg, one count is 3. Range: -127 to 127.
  Axes<EncoderLimit> encoder_limit_min{};
  /// Highest angle of the joint. Unit: deg, one count is 3. Range: -127 to 127.
  Axes<EncoderLimit> encoder_limit_max{};
  /// Depth of the first notch filter; below 0 it makes a peak. Unit: dB. Range: -100 to 100.
  /// Errata: E004.
  Axes<Decibels> notch1_gain{};
  /// Depth of the second notch filter; below 0 it makes a peak. Unit: dB. Range: -100 to 100.
  /// Errata: E004.
  Axes<Decibels> notch2_gain{};
  /// Depth of the third notch filter; below 0 it makes a peak. Unit: dB. Range: -100 to 100.
  /// Errata: E004.
  Axes<Decibels> notch3_gain{};
  /// Volume of the sounds. Range: 0 to 255.
  std::uint8_t beeper_volume{};
  /// Ratio of the gear between motor and encoder. Unit: no unit, one count is 1/1000.
  Axes<Thousandths> encoder_gear_ratio{};
  /// Kind of the encoder. Errata: E057.
  Axes<EncoderType> encoder_type{};
  /// SPI clock, or the kind of encoder inside an I2C driver. Errata: E118.
  Axes<EncoderConfig> encoder_cfg{};
  /// Proportional gain of the outer loop. Range: 0 to 255.
  Axes<std::uint8_t> outer_p{};
  /// Integral gain of the outer loop. Range: 0 to 255.
  Axes<std::uint8_t> outer_i{};
  /// Axis of the magnetometer that points up.
  SensorAxis mag_axis_top{};
  /// Axis of the magnetometer that points right.
  SensorAxis mag_axis_right{};
  /// Trust in the magnetometer. Range: 0 to 255.
  std::uint8_t mag_trust{};
  /// Magnetic declination. Unit: deg. Range: -127 to 127.
  SignedDegrees mag_declination{};
  /// Low-pass filter of the accelerometer. Unit: Hz, one count is 1/100. Range: 0 to 1000.
  FineFrequency acc_lpf_freq{};
  /// Low-pass filter of the derivative term. Unit: Hz, one count is 10. Range: 0 to 60. Errata:
  /// E108.
  Axes<CoarseFrequency> d_term_lpf_freq{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<151> tail{};

  constexpr bool operator==(const ReadParamsExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParamsExt& SBGC_RESTRICT out) noexcept {
  using M = ReadParamsExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, notches), 1) &&
      detail::in_parallel(offsetof(M, lpf_freq), offsetof(M, filters_en), 6) &&
      detail::in_parallel(offsetof(M, encoder_offset), offsetof(M, motor_mag_link), 24) &&
      detail::in_parallel(offsetof(M, motor_gearing), offsetof(M, d_term_lpf_freq), 46)) {
    detail::get_block(from, out, offsetof(M, profile_id), 19);
    detail::get_block(from + 19, out, offsetof(M, lpf_freq), 9);
    detail::get_block(from + 28, out, offsetof(M, encoder_offset), 27);
    detail::get_block(from + 55, out, offsetof(M, motor_gearing), 49);
    return;
  }
  get(from, out.profile_id);
  get(from + 1, out.notches);
  get(from + 19, out.lpf_freq);
  get(from + 25, out.filters_en);
  get(from + 28, out.encoder_offset);
  get(from + 34, out.encoder_fld_offset);
  get(from + 40, out.encoder_manual_set_time);
  get(from + 43, out.motor_heating_factor);
  get(from + 46, out.motor_cooling_factor);
  get(from + 49, out.reserved);
  get(from + 51, out.follow_inside_deadband);
  get(from + 52, out.motor_mag_link);
  get(from + 55, out.motor_gearing);
  get(from + 61, out.encoder_limit_min);
  get(from + 64, out.encoder_limit_max);
  get(from + 67, out.notch1_gain);
  get(from + 70, out.notch2_gain);
  get(from + 73, out.notch3_gain);
  get(from + 76, out.beeper_volume);
  get(from + 77, out.encoder_gear_ratio);
  get(from + 83, out.encoder_type);
  get(from + 86, out.encoder_cfg);
  get(from + 89, out.outer_p);
  get(from + 92, out.outer_i);
  get(from + 95, out.mag_axis_top);
  get(from + 96, out.mag_axis_right);
  get(from + 97, out.mag_trust);
  get(from + 98, out.mag_declination);
  get(from + 99, out.acc_lpf_freq);
  get(from + 101, out.d_term_lpf_freq);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParamsExt& SBGC_RESTRICT in) noexcept {
  using M = ReadParamsExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, notches), 1) &&
      detail::in_parallel(offsetof(M, lpf_freq), offsetof(M, filters_en), 6) &&
      detail::in_parallel(offsetof(M, encoder_offset), offsetof(M, motor_mag_link), 24) &&
      detail::in_parallel(offsetof(M, motor_gearing), offsetof(M, d_term_lpf_freq), 46)) {
    detail::put_block(to, in, offsetof(M, profile_id), 19);
    detail::put_block(to + 19, in, offsetof(M, lpf_freq), 9);
    detail::put_block(to + 28, in, offsetof(M, encoder_offset), 27);
    detail::put_block(to + 55, in, offsetof(M, motor_gearing), 49);
    return;
  }
  put(to, in.profile_id);
  put(to + 1, in.notches);
  put(to + 19, in.lpf_freq);
  put(to + 25, in.filters_en);
  put(to + 28, in.encoder_offset);
  put(to + 34, in.encoder_fld_offset);
  put(to + 40, in.encoder_manual_set_time);
  put(to + 43, in.motor_heating_factor);
  put(to + 46, in.motor_cooling_factor);
  put(to + 49, in.reserved);
  put(to + 51, in.follow_inside_deadband);
  put(to + 52, in.motor_mag_link);
  put(to + 55, in.motor_gearing);
  put(to + 61, in.encoder_limit_min);
  put(to + 64, in.encoder_limit_max);
  put(to + 67, in.notch1_gain);
  put(to + 70, in.notch2_gain);
  put(to + 73, in.notch3_gain);
  put(to + 76, in.beeper_volume);
  put(to + 77, in.encoder_gear_ratio);
  put(to + 83, in.encoder_type);
  put(to + 86, in.encoder_cfg);
  put(to + 89, in.outer_p);
  put(to + 92, in.outer_i);
  put(to + 95, in.mag_axis_top);
  put(to + 96, in.mag_axis_right);
  put(to + 97, in.mag_trust);
  put(to + 98, in.mag_declination);
  put(to + 99, in.acc_lpf_freq);
  put(to + 101, in.d_term_lpf_freq);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParamsExt& out) noexcept {
  if (body.size() < 104) return detail::wrong_size(body.size(), 104);
  get(body.data(), out);
  return detail::get_tail(body, 104, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadParamsExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 104 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 104, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ReadParamsExt& in) noexcept {
  using M = ReadParamsExt;
  if (!(detail::in_parallel(offsetof(M, profile_id), offsetof(M, notches), 1) &&
      detail::in_parallel(offsetof(M, lpf_freq), offsetof(M, filters_en), 6) &&
      detail::in_parallel(offsetof(M, encoder_offset), offsetof(M, motor_mag_link), 24) &&
      detail::in_parallel(offsetof(M, motor_gearing), offsetof(M, d_term_lpf_freq), 46))) return false;
  detail::add_block(sum, in, offsetof(M, profile_id), 19);
  detail::add_block(sum, in, offsetof(M, lpf_freq), 9);
  detail::add_block(sum, in, offsetof(M, encoder_offset), 27);
  detail::add_block(sum, in, offsetof(M, motor_gearing), 49);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for further settings of one profile.
///
/// CMD_READ_PARAMS_EXT (33), to the board; 1 byte.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L652-L660. Errata: E101.
struct ReadParamsExtRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_params_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};
  using Response = ReadParamsExt;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;

  /// Profile to read. Range: 0 to 4. active_profile (255): the active profile. Errata: E062.
  std::uint8_t profile_id{};

  constexpr bool operator==(const ReadParamsExtRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParamsExtRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParamsExtRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParamsExtRequest& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadParamsExtRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Still further settings of one profile.
///
/// CMD_READ_PARAMS_EXT2 (62), from the board; 151 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L350-L359; Variables L1110-L1116. Errata: E001, E201.
struct ReadParamsExt2 {
  static constexpr CommandFromBoard command = CommandFromBoard::read_params_ext2;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 151;
  static constexpr std::size_t max_size = 151;
  static constexpr Availability since{0, 30};

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;
  /// For acc_limiter3: disabled.
  static constexpr std::uint8_t acc_limiter3_disabled = 0;

  /// Profile that the settings belong to. Range: 0 to 4. active_profile (255): the active profile.
  /// Errata: E001, E062.
  std::uint8_t profile_id{};
  /// Reserved; kept as it is.
  Bytes<16> reserved_1{};
  /// Magnetic linkage of the motor. Unit: no unit, one count is 1/100. Range: 0 to 65535. Errata:
  /// E047.
  Axes<LongHundredths> motor_mag_link_fine{};
  /// Limit of the acceleration of each axis. Unit: deg/s^2, one count is 5. Range: 0 to 200.
  /// acc_limiter3_disabled (0): disabled. Since firmware 2.59. Errata: E035, E066, E108.
  Axes<AngularAcceleration> acc_limiter3{};
  /// Factor on P, I and D of each axis. Unit: no unit, one count is 1/50, counted from 1/10. Range:
  /// 0 to 255. Errata: E108.
  Axes<PidGain> pid_gain{};
  /// Low-pass filter of the frame IMU. Unit: Hz. Range: 0 to 255.
  SmallFrequency frame_imu_lpf_freq{};
  /// CFG_FLAGS that CMD_AUTO_PID is started with. Errata: E056.
  AutoPidFlags auto_pid_cfg{};
  /// GAIN_VS_STABILITY that CMD_AUTO_PID is started with. Range: 0 to 255.
  std::uint8_t auto_pid_gain{};
  /// Later firmware keeps settings in all of these.
  Bytes<119> reserved_2{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<104> tail{};

  constexpr bool operator==(const ReadParamsExt2&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParamsExt2& SBGC_RESTRICT out) noexcept {
  using M = ReadParamsExt2;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved_1), 1) &&
      detail::in_parallel(offsetof(M, motor_mag_link_fine), offsetof(M, reserved_2), 15)) {
    detail::get_block(from, out, offsetof(M, profile_id), 17);
    detail::get_block(from + 17, out, offsetof(M, motor_mag_link_fine), 134);
    return;
  }
  get(from, out.profile_id);
  get(from + 1, out.reserved_1);
  get(from + 17, out.motor_mag_link_fine);
  get(from + 23, out.acc_limiter3);
  get(from + 26, out.pid_gain);
  get(from + 29, out.frame_imu_lpf_freq);
  get(from + 30, out.auto_pid_cfg);
  get(from + 31, out.auto_pid_gain);
  get(from + 32, out.reserved_2);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParamsExt2& SBGC_RESTRICT in) noexcept {
  using M = ReadParamsExt2;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved_1), 1) &&
      detail::in_parallel(offsetof(M, motor_mag_link_fine), offsetof(M, reserved_2), 15)) {
    detail::put_block(to, in, offsetof(M, profile_id), 17);
    detail::put_block(to + 17, in, offsetof(M, motor_mag_link_fine), 134);
    return;
  }
  put(to, in.profile_id);
  put(to + 1, in.reserved_1);
  put(to + 17, in.motor_mag_link_fine);
  put(to + 23, in.acc_limiter3);
  put(to + 26, in.pid_gain);
  put(to + 29, in.frame_imu_lpf_freq);
  put(to + 30, in.auto_pid_cfg);
  put(to + 31, in.auto_pid_gain);
  put(to + 32, in.reserved_2);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParamsExt2& out) noexcept {
  if (body.size() < 151) return detail::wrong_size(body.size(), 151);
  get(body.data(), out);
  return detail::get_tail(body, 151, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadParamsExt2& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 151 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 151, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ReadParamsExt2& in) noexcept {
  using M = ReadParamsExt2;
  if (!(detail::in_parallel(offsetof(M, profile_id), offsetof(M, reserved_1), 1) &&
      detail::in_parallel(offsetof(M, motor_mag_link_fine), offsetof(M, reserved_2), 15))) return false;
  detail::add_block(sum, in, offsetof(M, profile_id), 17);
  detail::add_block(sum, in, offsetof(M, motor_mag_link_fine), 134);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for still further settings of one profile.
///
/// CMD_READ_PARAMS_EXT2 (62), to the board; 1 byte.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L658-L660. Errata: E101.
struct ReadParamsExt2Request {
  static constexpr CommandToBoard command = CommandToBoard::read_params_ext2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};
  using Response = ReadParamsExt2;

  /// For profile_id: the active profile.
  static constexpr std::uint8_t active_profile = 255;

  /// Profile to read. Range: 0 to 4. active_profile (255): the active profile. Errata: E062.
  std::uint8_t profile_id{};

  constexpr bool operator==(const ReadParamsExt2Request&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadParamsExt2Request& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadParamsExt2Request& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadParamsExt2Request& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadParamsExt2Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Names of the profiles.
///
/// CMD_READ_PROFILE_NAMES (28), from the board; 240 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L445-L453.
struct ReadProfileNames {
  static constexpr CommandFromBoard command = CommandFromBoard::read_profile_names;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 240;
  static constexpr std::size_t max_size = 240;
  static constexpr Availability since{0, 30};

  /// Name of each profile.
  std::array<Text<48>, 5> profile_name{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<15> tail{};

  constexpr bool operator==(const ReadProfileNames&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadProfileNames& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_name);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadProfileNames& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_name);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadProfileNames& out) noexcept {
  if (body.size() < 240) return detail::wrong_size(body.size(), 240);
  get(body.data(), out);
  return detail::get_tail(body, 240, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadProfileNames& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 240 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 240, in.tail);
  return {size, {}};
}

/// Ask for the names of the profiles.
///
/// CMD_READ_PROFILE_NAMES (28), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L761.
struct ReadProfileNamesRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_profile_names;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = ReadProfileNames;

  constexpr bool operator==(const ReadProfileNamesRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadProfileNamesRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadProfileNamesRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Save the settings that are in use, with all changes to adjustable variables, to the active
/// profile.
///
/// CMD_SAVE_PARAMS_3 (32), to the board; 0 bytes.
/// Effect: stores.
/// Since board 3.0.
/// Source: Outgoing commands L804.
struct SaveParams3 {
  static constexpr CommandToBoard command = CommandToBoard::save_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const SaveParams3&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SaveParams3& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const SaveParams3& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Return to the factory settings. The settings of the profile are gone; 253 erases the EEPROM with
/// all that it holds. Save the settings first.
///
/// CMD_USE_DEFAULTS (70), to the board; 1 byte.
/// Effect: stores, moves, erases.
/// Source: Outgoing commands L644-L648.
struct UseDefaults {
  static constexpr CommandToBoard command = CommandToBoard::use_defaults;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = void;

  /// For profile_id: erases the EEPROM.
  static constexpr std::uint8_t erase_eeprom = 253;

  /// Profile to reset. Range: 0 to 4. erase_eeprom (253): erases the EEPROM. Errata: E062.
  std::uint8_t profile_id{};

  constexpr bool operator==(const UseDefaults&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   UseDefaults& SBGC_RESTRICT out) noexcept {
  get(from, out.profile_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const UseDefaults& SBGC_RESTRICT in) noexcept {
  put(to, in.profile_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      UseDefaults& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const UseDefaults& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Store the settings of one profile and the general ones. Also saved to the EEPROM. Write back
/// what was read, changed where it must be: bytes that are not understood are settings too.
///
/// CMD_WRITE_PARAMS_3 (22), to the board; 134 bytes, and later firmware may append more.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L662-L668; Variables L1010-L1079. Errata: E088, E103, E201.
struct WriteParams3 : ReadParams3 {
  static constexpr CommandToBoard command = CommandToBoard::write_params_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteParams3&) const = default;
};

/// Store the settings of one profile and the general ones, with the older id.
///
/// CMD_WRITE_PARAMS (87), to the board; 134 bytes, and later firmware may append more.
/// Effect: stores, moves.
/// Deprecated: use CMD_WRITE_PARAMS_3.
/// Source: Outgoing commands L662-L668. Errata: E019, E088, E103, E201.
struct WriteParams : ReadParams3 {
  static constexpr CommandToBoard command = CommandToBoard::write_params;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 134;
  static constexpr std::size_t max_size = 134;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const WriteParams&) const = default;
};

/// Store further settings of one profile.
///
/// CMD_WRITE_PARAMS_EXT (34), to the board; 104 bytes, and later firmware may append more.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L662-L668; Variables L1080-L1108. Errata: E103, E201.
struct WriteParamsExt : ReadParamsExt {
  static constexpr CommandToBoard command = CommandToBoard::write_params_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 104;
  static constexpr std::size_t max_size = 104;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteParamsExt&) const = default;
};

/// Store still further settings of one profile.
///
/// CMD_WRITE_PARAMS_EXT2 (63), to the board; 151 bytes, and later firmware may append more.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L668; Variables L1110-L1116. Errata: E018, E201.
struct WriteParamsExt2 : ReadParamsExt2 {
  static constexpr CommandToBoard command = CommandToBoard::write_params_ext2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 151;
  static constexpr std::size_t max_size = 151;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteParamsExt2&) const = default;
};

/// Store the names of the profiles.
///
/// CMD_WRITE_PROFILE_NAMES (29), to the board; 240 bytes, and later firmware may append more.
/// Effect: stores.
/// Since board 3.0.
/// Source: Outgoing commands L763-L772.
struct WriteProfileNames : ReadProfileNames {
  static constexpr CommandToBoard command = CommandToBoard::write_profile_names;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 240;
  static constexpr std::size_t max_size = 240;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteProfileNames&) const = default;
};

}  // namespace sbgc::msg
