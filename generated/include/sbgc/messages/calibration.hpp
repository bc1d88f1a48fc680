// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Calibration of sensors, motors and encoders, and tuning of the controller.
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

struct BodeTestStartStop;
struct CalibInfo;

/// Current result of each axis.
struct AxisTuning {
  /// Tracking error of the axis.
  float tracking_error{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const AxisTuning&) const = default;
  using FixedMembers = Members<&AxisTuning::tracking_error, &AxisTuning::reserved>;
};

/// How to tune each axis.
struct AxisTuningConfig {
  /// What to tune.
  AxisTuningOptions axis_flags{};
  /// Gain to aim for.
  std::uint8_t gain{};
  /// Strength of the test signal.
  std::uint16_t stimulus_gain{};
  /// Effective frequency. Unit: Hz.
  SmallFrequency effective_freq{};
  /// Frequency of a known problem. Unit: Hz.
  SmallFrequency problem_freq{};
  /// Margin at that frequency. Unit: dB.
  TenthDecibels problem_margin{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};

  bool operator==(const AxisTuningConfig&) const = default;
  using FixedMembers = Members<&AxisTuningConfig::axis_flags, &AxisTuningConfig::gain,
      &AxisTuningConfig::stimulus_gain, &AxisTuningConfig::effective_freq,
      &AxisTuningConfig::problem_freq, &AxisTuningConfig::problem_margin,
      &AxisTuningConfig::reserved>;
};

/// How to tune.
struct AutoPid2Config {
  /// Version of the configuration. Always 1.
  std::uint8_t cfg_version{1};
  /// How to tune each axis.
  Axes<AxisTuningConfig> axes{};
  /// Options.
  AutoPid2Flags general_flags{};
  /// Reserved; kept as it is.
  Bytes<1> reserved_1{};
  /// Lowest frequency of the test signal. Unit: Hz.
  TenthHertz test_freq_from{};
  /// Highest frequency of the test signal. Unit: Hz.
  TwoHertz test_freq_to{};
  /// Positions in which to tune.
  TuningPositions multi_pos_flag{};
  /// Angle of each position. Unit: deg.
  std::array<EncoderLimit, 4> multi_pos_angle{};
  /// Reserved; kept as it is.
  Bytes<12> reserved_2{};

  bool operator==(const AutoPid2Config&) const = default;
  using FixedMembers = Members<&AutoPid2Config::cfg_version, &AutoPid2Config::axes,
      &AutoPid2Config::general_flags, &AutoPid2Config::reserved_1, &AutoPid2Config::test_freq_from,
      &AutoPid2Config::test_freq_to, &AutoPid2Config::multi_pos_flag,
      &AutoPid2Config::multi_pos_angle, &AutoPid2Config::reserved_2>;
};

/// How to calibrate each motor.
struct CoggingMotor {
  /// For period: automatic.
  static constexpr std::uint16_t automatic_period{0};

  /// Angle by which the motor turns. Range: 20 to 360 deg.
  WideDegrees angle{};
  /// Smoothing of the result. Range: 0 to 100 %.
  Percent smooth{};
  /// Speed of the motion; relative.
  std::uint8_t speed{};
  /// Angle after which the cogging repeats. Unit: deg.
  WideDegrees period{};
  /// Reserved; kept as it is.
  Bytes<9> reserved{};

  bool operator==(const CoggingMotor&) const = default;
  using FixedMembers = Members<&CoggingMotor::angle, &CoggingMotor::smooth, &CoggingMotor::speed,
      &CoggingMotor::period, &CoggingMotor::reserved>;
};

/// The samples.
struct BodeSample {
  /// Input. Range: 0 to 65534.
  std::uint16_t input{};
  /// Output. Range: 0 to 65534.
  std::uint16_t output{};

  bool operator==(const BodeSample&) const = default;
  using FixedMembers = Members<&BodeSample::input, &BodeSample::output>;
};

/// Calibrate the accelerometer of the active IMU. Confirmed on reception and again at the end; not
/// at all if a parameter is wrong. Before: Place the camera so that the sensor is exactly level, on
/// something that does not move, and turn the motors off. To calibrate the other directions as
/// well, repeat it with each side of the sensor upwards; CMD_CALIB_INFO shows which ones are done.
///
/// CMD_CALIB_ACC (65), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
/// commands L621-L640.
struct CalibAcc {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibAcc&) const = default;
};

/// Calibrate the accelerometer of an IMU, or manage its calibrations. Confirmed on reception and
/// again at the end; not at all if a parameter is wrong. Before: Place the camera so that the
/// sensor is exactly level, on something that does not move, and turn the motors off. To calibrate
/// the other directions as well, repeat it with each side of the sensor upwards; CMD_CALIB_INFO
/// shows which ones are done. For TEMPERATURE, cool the sensor down first; it is calibrated while
/// it warms up by itself.
///
/// CMD_CALIB_ACC (65), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640.
struct CalibAccExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// The IMU.
  CalibImu imu_idx{};
  /// Operation.
  CalibAction action{};
  /// Without meaning here; the duration of the calibration of a gyroscope. Unit: ms. Since firmware
  /// 2.60.
  Milliseconds time_ms{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const CalibAccExt&) const = default;
  using FixedMembers = Members<&CalibAccExt::imu_idx, &CalibAccExt::action, &CalibAccExt::time_ms,
      &CalibAccExt::reserved>;
};

/// Calibrate the gyroscope of the active IMU. Confirmed on reception and again at the end; not at
/// all if a parameter is wrong. Before: Leave the camera completely still, in any position, and
/// turn the motors off; do not touch it until the end.
///
/// CMD_CALIB_GYRO (103), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
/// commands L621-L640.
struct CalibGyro {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibGyro&) const = default;
};

/// Calibrate the gyroscope of an IMU, or manage its calibrations. Confirmed on reception and again
/// at the end; not at all if a parameter is wrong. Before: Leave the camera completely still, in
/// any position, and turn the motors off; do not touch it until the end. For TEMPERATURE, cool the
/// sensor down first; it is calibrated while it warms up by itself.
///
/// CMD_CALIB_GYRO (103), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
/// Source: Outgoing commands L621-L640.
struct CalibGyroExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_gyro;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{};
  using Response = void;

  /// For time_ms: about 4 s.
  static constexpr std::uint16_t default_time{0};

  /// The IMU.
  CalibImu imu_idx{};
  /// Operation.
  CalibAction action{};
  /// Duration of the calibration of a gyroscope. Unit: ms. Since firmware 2.60.
  Milliseconds time_ms{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const CalibGyroExt&) const = default;
  using FixedMembers = Members<&CalibGyroExt::imu_idx, &CalibGyroExt::action,
      &CalibGyroExt::time_ms, &CalibGyroExt::reserved>;
};

/// Calibrate the magnetometer. Before: Take the gimbal away from steel and from other motors, and
/// turn the motors off. While the calibration runs, turn the sensor slowly about all its axes,
/// until every side has pointed in every direction.
///
/// CMD_CALIB_MAG (59), to the board, simple form; 0 bytes. Effect: stores. Since board 3.0. Source:
/// Outgoing commands L940-L944.
struct CalibMag {
  static constexpr CommandToBoard command = CommandToBoard::calib_mag;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const CalibMag&) const = default;
};

/// Calibrate the magnetometer of an IMU, or manage its calibrations. Before: Take the gimbal away
/// from steel and from other motors, and turn the motors off. While the calibration runs, turn the
/// sensor slowly about all its axes, until every side has pointed in every direction.
///
/// CMD_CALIB_MAG (59), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
/// Since board 3.0. Source: Later firmware.
struct CalibMagExt {
  static constexpr CommandToBoard command = CommandToBoard::calib_mag;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The IMU.
  CalibImu imu_idx{};
  /// Operation.
  CalibAction action{};
  /// Without meaning here; the duration of the calibration of a gyroscope. Unit: ms.
  Milliseconds time_ms{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const CalibMagExt&) const = default;
  using FixedMembers = Members<&CalibMagExt::imu_idx, &CalibMagExt::action, &CalibMagExt::time_ms,
      &CalibMagExt::reserved>;
};

/// Calibrate the gains of a flight controller's signals. Before: Connect the flight controller and
/// level the camera. While the calibration runs, tilt the frame smoothly by 20 to 40 degrees to
/// both sides, in roll and in pitch.
///
/// CMD_CALIB_EXT_GAIN (71), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L642.
struct CalibExtGain {
  static constexpr CommandToBoard command = CommandToBoard::calib_ext_gain;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibExtGain&) const = default;
};

/// Detect the poles and the direction of the motors. Before: Balance the camera, fasten the frame,
/// and make sure that all axes turn freely: the motors turn the camera. Their power must be set
/// high enough to hold it.
///
/// CMD_CALIB_POLES (80), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L650.
struct CalibPoles {
  static constexpr CommandToBoard command = CommandToBoard::calib_poles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibPoles&) const = default;
};

/// Calibrate the follow mode offset. Before: Level the frame, and turn the camera to the position,
/// relative to the frame, that it should have in follow mode.
///
/// CMD_CALIB_OFFSET (79), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing commands
/// L688.
struct CalibOffset {
  static constexpr CommandToBoard command = CommandToBoard::calib_offset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const CalibOffset&) const = default;
};

/// Calibrate the battery voltage measurement. Before: Measure the voltage of the battery with a
/// voltmeter, at the connector of the board, while the board is on.
///
/// CMD_CALIB_BAT (66), to the board; 2 bytes. Effect: stores. Source: Outgoing commands L690-L692.
struct CalibBat {
  static constexpr CommandToBoard command = CommandToBoard::calib_bat;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// Actual voltage, measured externally. Unit: V.
  Voltage actual_voltage{};

  bool operator==(const CalibBat&) const = default;
  using FixedMembers = Members<&CalibBat::actual_voltage>;
};

/// Calibration status for display.
///
/// CMD_CALIB_INFO (49), from the board; 33 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L546-L563; Variables L1233-L1246.
struct CalibInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 33;
  static constexpr std::size_t max_size = 33;
  static constexpr Availability since{.board = 30};

  /// Progress of the calibration. Range: 0 to 100 %.
  Percent progress{};
  /// The IMU.
  SelectedImu imu_type{};
  /// Accelerometer, as in CMD_REALTIME_DATA_3. Unit: g.
  Xyz<Acceleration> acc_data{};
  /// Magnitude of the gyroscope signal.
  std::uint16_t gyro_abs_val{};
  /// Accelerometer axis to calibrate next. Range: 0 to 2.
  std::uint8_t acc_cur_axis{};
  /// Calibrated directions of the accelerometer.
  CalibratedLimits acc_limits_info{};
  /// Temperature of the IMU. Range: -127 to 127 degC.
  Temperature imu_temp_cels{};
  /// 1 if the gyroscope's calibration over temperature is enabled. Range: 0 to 1.
  std::uint8_t temp_calib_gyro_enabled{};
  /// Lowest temperature of the gyroscope's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_gyro_t_min_cels{};
  /// Highest temperature of the gyroscope's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_gyro_t_max_cels{};
  /// 1 if the accelerometer's calibration over temperature is enabled. Range: 0 to 1.
  std::uint8_t temp_calib_acc_enabled{};
  /// Number of calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y,
  /// -Z. Range: 0 to 3.
  std::array<std::uint8_t, 6> temp_calib_acc_slot_num{};
  /// Lowest temperature of the accelerometer's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_acc_t_min_cels{};
  /// Highest temperature of the accelerometer's calibration. Range: -127 to 127 degC.
  Temperature temp_calib_acc_t_max_cels{};
  /// Length of the difference between the estimated and the reference heading vector, both of
  /// length 1.
  Hundredths h1_err_length{};
  /// Reserved; kept as it is.
  Bytes<7> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<222> tail{};

  bool operator==(const CalibInfo&) const = default;
  using FixedMembers = Members<&CalibInfo::progress, &CalibInfo::imu_type, &CalibInfo::acc_data,
      &CalibInfo::gyro_abs_val, &CalibInfo::acc_cur_axis, &CalibInfo::acc_limits_info,
      &CalibInfo::imu_temp_cels, &CalibInfo::temp_calib_gyro_enabled,
      &CalibInfo::temp_calib_gyro_t_min_cels, &CalibInfo::temp_calib_gyro_t_max_cels,
      &CalibInfo::temp_calib_acc_enabled, &CalibInfo::temp_calib_acc_slot_num,
      &CalibInfo::temp_calib_acc_t_min_cels, &CalibInfo::temp_calib_acc_t_max_cels,
      &CalibInfo::h1_err_length, &CalibInfo::reserved>;
};

/// Request the calibration status.
///
/// CMD_CALIB_INFO (49), to the board; 12 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L891-L896.
struct CalibInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.board = 30};
  using Response = CalibInfo;

  /// The IMU.
  SelectedImu imu_type{};
  /// Reserved; kept as it is.
  Bytes<11> reserved{};

  bool operator==(const CalibInfoRequest&) const = default;
  using FixedMembers = Members<&CalibInfoRequest::imu_type, &CalibInfoRequest::reserved>;
};

/// Undocumented body from the board.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), from the board; 0 to 255 bytes. Since board 3.0. Source: Command
/// ID definitions L142.
struct CalibMotorMagLink {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibMotorMagLink&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CALIB_MOTOR_MAG_LINK (74), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
/// Source: Command ID definitions L142.
struct CalibMotorMagLinkRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_motor_mag_link;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibMotorMagLinkRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Calibrate the offsets of the encoders. Before: Turn the motors off, and turn the camera by hand
/// to the position in which all motor angles are zero: level, and straight to the frame.
///
/// CMD_ENCODERS_CALIB_OFFSET_4 (26), to the board; 0 or 1 byte. Effect: stores. Since board 3.0.
/// Source: Outgoing commands L993.
struct EncodersCalibOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Motor whose encoder to calibrate. Since firmware 2.68b7; before, the body ends here.
  Optional<CalibMotor> for_motor{};

  bool operator==(const EncodersCalibOffset4&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.appended(self.for_motor, "for_motor");
  }
};

/// Calibrate the offsets between encoders and the motors' magnetic fields. Before: Balance the
/// camera, fasten the frame, and make sure that all axes turn freely: the motors turn the camera
/// back and forth.
///
/// CMD_ENCODERS_CALIB_FLD_OFFSET_4 (27), to the board; 0 to 14 bytes. Effect: stores, moves. Since
/// board 3.0. Source: Outgoing commands L995.
struct EncodersCalibFldOffset4 {
  static constexpr CommandToBoard command = CommandToBoard::encoders_calib_fld_offset_4;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 14;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Angle by which each motor turns; 40 degrees if omitted. Unit: deg. Since firmware 2.62b6;
  /// before, the body ends here.
  Optional<Axes<Angle14>> calib_angle{};
  /// Speed at which each motor turns. Unit: deg/s. Since firmware 2.71b1; before, the body ends
  /// here.
  Optional<Axes<GyroRate>> calib_speed{};
  /// Checks to omit. Since firmware 2.70b8; before, the body ends here.
  Optional<FieldOffsetFlags> calib_flags{};

  bool operator==(const EncodersCalibFldOffset4&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.appended(self.calib_angle, "calib_angle");
    cursor.appended(self.calib_speed, "calib_speed");
    cursor.appended(self.calib_flags, "calib_flags");
  }
};

/// Progress of the automatic tuning.
///
/// CMD_AUTO_PID (35), from the board; 57 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L462-L474.
struct AutoPid {
  static constexpr CommandFromBoard command = CommandFromBoard::auto_pid;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 57;
  static constexpr std::size_t max_size = 57;
  static constexpr Availability since{.board = 30};

  /// Proportional gain of each axis.
  Axes<std::uint8_t> p{};
  /// Integral gain of each axis, as stored.
  Axes<std::uint8_t> i{};
  /// Derivative gain of each axis.
  Axes<std::uint8_t> d{};
  /// Low-pass filter of each axis, as stored.
  Axes<std::uint16_t> lpf_freq{};
  /// Number of completed iterations.
  std::uint16_t iter_num{};
  /// Current result of each axis.
  Axes<AxisTuning> axes{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<198> tail{};

  bool operator==(const AutoPid&) const = default;
  using FixedMembers = Members<&AutoPid::p, &AutoPid::i, &AutoPid::d, &AutoPid::lpf_freq,
      &AutoPid::iter_num, &AutoPid::axes, &AutoPid::reserved>;
};

/// Start or stop the automatic tuning. With AUTO_PID_CFG_SEND_GUI the board sends CMD_AUTO_PID
/// repeatedly while it tunes. Later firmware has CMD_AUTO_PID2.
///
/// CMD_AUTO_PID (35), to the board; 19 bytes. Effect: stores, moves. Since board 3.0. Firmware 2.73
/// and later no longer accepts it. Source: Outgoing commands L806-L811; Variables L1177-L1182.
struct AutoPidRequest {
  static constexpr CommandToBoard command = CommandToBoard::auto_pid;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 19;
  static constexpr std::size_t max_size = 19;
  static constexpr Availability since{.board = 30};
  static constexpr Availability until{.firmware = 2730}
;
  using Response = void;

  /// For cfg_flags: stops the tuning.
  static constexpr std::uint8_t stop_tuning{0};
  /// For momentum: automatic.
  static constexpr std::uint8_t automatic_momentum{0};
  /// For action: starts the tuning.
  static constexpr std::uint8_t start_tuning{0};

  /// Profile to switch to first. Range: 0 to 4.
  std::uint8_t profile_id{};
  /// What to tune, and options.
  AutoPidFlags cfg_flags{};
  /// Preference for high gains at the cost of stability.
  std::uint8_t gain_vs_stability{};
  /// Moment of inertia. Since firmware 2.60.
  std::uint8_t momentum{};
  /// Operation; only one is documented. Since firmware 2.60.
  std::uint8_t action{};
  /// Reserved; kept as it is.
  Bytes<14> reserved{};

  bool operator==(const AutoPidRequest&) const = default;
  using FixedMembers = Members<&AutoPidRequest::profile_id, &AutoPidRequest::cfg_flags,
      &AutoPidRequest::gain_vs_stability, &AutoPidRequest::momentum, &AutoPidRequest::action,
      &AutoPidRequest::reserved>;
};

/// Tune the PID controllers automatically, in later firmware. The configuration is part of the
/// requests that start the tuning or save it. After the end, the board sends the tuned parameters.
///
/// CMD_AUTO_PID2 (108), to the board; 11 to 73 bytes. Effect: stores, moves. Since firmware 2.73.
/// Source: Later firmware.
struct AutoPid2 {
  static constexpr CommandToBoard command = CommandToBoard::auto_pid2;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 11;
  static constexpr std::size_t max_size = 73;
  static constexpr Availability since{.firmware = 2730};
  using Response = void;

  /// Operation.
  AutoPid2Action action{};
  /// Options of this request.
  AutoPid2CommandFlags cmd_flags{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// How to tune. Present if action is START or START_SAVE or SAVE.
  Optional<AutoPid2Config> config{};

  bool operator==(const AutoPid2&) const = default;
  using FixedMembers = Members<&AutoPid2::action, &AutoPid2::cmd_flags, &AutoPid2::reserved>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when(self.action == AutoPid2Action::start || self.action == AutoPid2Action::start_save ||
        self.action == AutoPid2Action::save, self.config, "config");
  }
};

/// Calibrate the orientation of the IMU. According to one source, the board later also sends
/// CMD_READ_PARAMS_EXT2, which holds the result. Before: Balance the camera, fasten the frame, and
/// make sure that all axes turn freely: the motors turn the camera. Calibrate the gyroscope and the
/// accelerometer first.
///
/// CMD_CALIB_ORIENT_CORR (91), to the board; 16 bytes. Effect: stores, moves. Since firmware 2.61.
/// Source: Later firmware.
struct CalibOrientCorr {
  static constexpr CommandToBoard command = CommandToBoard::calib_orient_corr;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 16;
  static constexpr std::size_t max_size = 16;
  static constexpr Availability since{.firmware = 2610};
  using Response = void;

  /// Reserved; kept as it is.
  Bytes<16> reserved{};

  bool operator==(const CalibOrientCorr&) const = default;
  using FixedMembers = Members<&CalibOrientCorr::reserved>;
};

/// Calibrate the cogging of the motors, or delete this calibration. Before: Balance the camera,
/// fasten the frame, and make sure that the chosen axes turn freely: the motors turn the camera
/// slowly, several times.
///
/// CMD_CALIB_COGGING (93), to the board; 57 bytes. Effect: stores, moves, erases. Since firmware
/// 2.60. Source: Later firmware.
struct CalibCogging {
  static constexpr CommandToBoard command = CommandToBoard::calib_cogging;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 57;
  static constexpr std::size_t max_size = 57;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Operation.
  CoggingAction action{};
  /// The motors.
  CoggingAxes axes{};
  /// How to calibrate each motor. Used if action is not DELETE and axes has {AXIS}.
  Axes<CoggingMotor> motors{};
  /// Number of repetitions. Range: 2 to 255. Used if action is not DELETE.
  std::uint8_t iterations_num{};
  /// Reserved; kept as it is.
  Bytes<9> reserved{};

  bool operator==(const CalibCogging&) const = default;
  using FixedMembers = Members<&CalibCogging::action, &CalibCogging::axes, &CalibCogging::motors,
      &CalibCogging::iterations_num, &CalibCogging::reserved>;
};

/// Calibrate the accelerometer with an external reference. Before: Leave the camera completely
/// still, and determine the direction of gravity in the coordinates of the sensor with another
/// instrument.
///
/// CMD_CALIB_ACC_EXT_REF (94), to the board; 20 bytes. Effect: stores. Since firmware 2.62b7.
/// Source: Later firmware.
struct CalibAccExtRef {
  static constexpr CommandToBoard command = CommandToBoard::calib_acc_ext_ref;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{.firmware = 2627};
  using Response = void;

  /// Actual acceleration. Unit: g.
  Xyz<Acceleration> acc_ref{};
  /// Reserved; kept as it is.
  Bytes<14> reserved{};

  bool operator==(const CalibAccExtRef&) const = default;
  using FixedMembers = Members<&CalibAccExtRef::acc_ref, &CalibAccExtRef::reserved>;
};

/// End of the recording.
///
/// CMD_BODE_TEST_START_STOP (37), from the board; 22 bytes, and later firmware may append more.
/// Since firmware 2.50, board 3.0. Source: Vendor's code of 2026.
struct BodeTestStartStop {
  static constexpr CommandFromBoard command = CommandFromBoard::bode_test_start_stop;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 22;
  static constexpr std::size_t max_size = 22;
  static constexpr Availability since{.firmware = 2500, .board = 30, .features = 0x08};

  /// For error_code: success.
  static constexpr std::uint16_t bode_success{0};

  /// Number of samples; some firmware sends the index of the last one.
  std::uint32_t samples_count{};
  /// Reason of the end.
  std::uint16_t error_code{};
  /// MODE of the request.
  std::uint8_t mode{};
  /// Reserved; kept as it is.
  Bytes<15> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<233> tail{};

  bool operator==(const BodeTestStartStop&) const = default;
  using FixedMembers = Members<&BodeTestStartStop::samples_count, &BodeTestStartStop::error_code,
      &BodeTestStartStop::mode, &BodeTestStartStop::reserved>;
};

/// Start the recording of a frequency response. The board moves the axis with a stimulus and sends
/// CMD_BODE_TEST_DATA until the end, which this command from the board reports. Data may come
/// before the confirmation, which some firmware omits. No source says how to stop a recording:
/// CMD_MOTORS_OFF ends the motion. The messages do not say to which recording they belong, so there
/// is one at a time.
///
/// CMD_BODE_TEST_START_STOP (37), to the board; 30 bytes. Effect: moves. Since firmware 2.50, board
/// 3.0. Source: Vendor's code of 2026.
struct BodeTestStartStopRequest {
  static constexpr CommandToBoard command = CommandToBoard::bode_test_start_stop;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 30;
  static constexpr std::size_t max_size = 30;
  static constexpr Availability since{.firmware = 2500, .board = 30, .features = 0x08};
  using Response = BodeTestStartStop;

  /// The axis.
  BodeAxis axis{};
  /// Kind of stimulus.
  BodeStimulus stimulus_type{};
  /// Strength of the stimulus. Range: 1 to 65535.
  std::uint16_t stimulus_gain{};
  /// Highest frequency. Unit: Hz.
  Frequency end_freq{};
  /// What is measured.
  BodeSystem system{};
  /// Number of samples, each of 0.8 ms.
  std::uint32_t samples_num{};
  /// Reserved. Always 0.
  std::uint8_t mode{};
  /// Lowest frequency. Unit: Hz.
  Frequency start_freq{};
  /// Reserved; kept as it is.
  Bytes<16> reserved{};

  bool operator==(const BodeTestStartStopRequest&) const = default;
  using FixedMembers = Members<&BodeTestStartStopRequest::axis,
      &BodeTestStartStopRequest::stimulus_type, &BodeTestStartStopRequest::stimulus_gain,
      &BodeTestStartStopRequest::end_freq, &BodeTestStartStopRequest::system,
      &BodeTestStartStopRequest::samples_num, &BodeTestStartStopRequest::mode,
      &BodeTestStartStopRequest::start_freq, &BodeTestStartStopRequest::reserved>;
};

/// Samples of a recording that runs. A value is MIN + raw * (MAX - MIN) / 65534, with the limits of
/// its signal in the same message.
///
/// CMD_BODE_TEST_DATA (38), from the board; 17 to 97 bytes. Since firmware 2.50, board 3.0. Source:
/// Vendor's code of 2026.
struct BodeTestData {
  static constexpr CommandFromBoard command = CommandFromBoard::bode_test_data;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 17;
  static constexpr std::size_t max_size = 97;
  static constexpr Availability since{.firmware = 2500, .board = 30, .features = 0x08};

  /// Index of the first sample, modulo 256; the next message begins where this one ends, unless
  /// samples are lost.
  std::uint8_t sample_counter{};
  /// Input of raw value 0.
  float input_min{};
  /// Output of raw value 0.
  float output_min{};
  /// Input of raw value 65534.
  float input_max{};
  /// Output of raw value 65534.
  float output_max{};
  /// The samples. At most 20.
  BoundedArray<BodeSample, 59> samples{};

  bool operator==(const BodeTestData&) const = default;
  using FixedMembers = Members<&BodeTestData::sample_counter, &BodeTestData::input_min,
      &BodeTestData::output_min, &BodeTestData::input_max, &BodeTestData::output_max>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.samples, "samples");
  }
};

/// Undocumented body from the board.
///
/// CMD_COGGING_CALIB_INFO (92), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CoggingCalibInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::cogging_calib_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CoggingCalibInfo&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_COGGING_CALIB_INFO (92), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct CoggingCalibInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::cogging_calib_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CoggingCalibInfoRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_CAN_DRV_HARD_PARAMS (97), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CanDrvHardParams {
  static constexpr CommandFromBoard command = CommandFromBoard::can_drv_hard_params;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvHardParams&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CAN_DRV_HARD_PARAMS (97), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
/// 2.60. Source: Later firmware.
struct CanDrvHardParamsRequest {
  static constexpr CommandToBoard command = CommandToBoard::can_drv_hard_params;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvHardParamsRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_CAN_DRV_CALIBRATE (99), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CanDrvCalibrate {
  static constexpr CommandFromBoard command = CommandFromBoard::can_drv_calibrate;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvCalibrate&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CAN_DRV_CALIBRATE (99), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct CanDrvCalibrateRequest {
  static constexpr CommandToBoard command = CommandToBoard::can_drv_calibrate;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CanDrvCalibrateRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_CALIB_ENCODER_LUT (117), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CalibEncoderLut {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_encoder_lut;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibEncoderLut&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CALIB_ENCODER_LUT (117), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct CalibEncoderLutRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_encoder_lut;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibEncoderLutRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_CALIB_ENCODER_LUT_RES (118), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
/// Later firmware.
struct CalibEncoderLutRes {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_encoder_lut_res;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibEncoderLutRes&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CALIB_ENCODER_LUT_RES (118), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
/// 2.60. Source: Later firmware.
struct CalibEncoderLutResRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_encoder_lut_res;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibEncoderLutResRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_CALIB_CUR_SENS (120), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct CalibCurSens {
  static constexpr CommandFromBoard command = CommandFromBoard::calib_cur_sens;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibCurSens&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_CALIB_CUR_SENS (120), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Source: Later firmware.
struct CalibCurSensRequest {
  static constexpr CommandToBoard command = CommandToBoard::calib_cur_sens;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const CalibCurSensRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_ENC_INT_CALIB (122), from the board; 0 to 255 bytes. Since firmware 2.60. Unconfirmed.
/// Source: Later firmware.
struct EncIntCalib {
  static constexpr CommandFromBoard command = CommandFromBoard::enc_int_calib;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const EncIntCalib&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_ENC_INT_CALIB (122), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Unconfirmed. Source: Later firmware.
struct EncIntCalibRequest {
  static constexpr CommandToBoard command = CommandToBoard::enc_int_calib;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const EncIntCalibRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_VIBRATION_TEST_START_STOP (125), from the board; 0 to 255 bytes. Since firmware 2.60.
/// Unconfirmed. Source: Later firmware.
struct VibrationTestStartStop {
  static constexpr CommandFromBoard command = CommandFromBoard::vibration_test_start_stop;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const VibrationTestStartStop&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_VIBRATION_TEST_START_STOP (125), to the board; 0 to 255 bytes. Effect: unknown. Since
/// firmware 2.60. Unconfirmed. Source: Later firmware.
struct VibrationTestStartStopRequest {
  static constexpr CommandToBoard command = CommandToBoard::vibration_test_start_stop;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const VibrationTestStartStopRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_VIBRATION_TEST_DATA (126), from the board; 0 to 255 bytes. Since firmware 2.60. Unconfirmed.
/// Source: Later firmware.
struct VibrationTestData {
  static constexpr CommandFromBoard command = CommandFromBoard::vibration_test_data;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const VibrationTestData&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_VIBRATION_TEST_DATA (126), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
/// 2.60. Unconfirmed. Source: Later firmware.
struct VibrationTestDataRequest {
  static constexpr CommandToBoard command = CommandToBoard::vibration_test_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const VibrationTestDataRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

}  // namespace sbgc::msg
