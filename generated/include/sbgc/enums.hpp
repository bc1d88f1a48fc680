// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Enums, flag sets and packed values of the protocol. Unnamed values are preserved. The names are
/// in <sbgc/meta/enums.hpp>.
#pragma once

#include <compare>
#include <cstdint>

#include <sbgc/flags.hpp>
#include <sbgc/number.hpp>

namespace sbgc::msg {

using sbgc::operator|;

/// The commands of messages to the board.
/// Source: Command ID definitions L75-L154.
enum class CommandToBoard : std::uint8_t {
  /// CMD_BOARD_INFO_3: Serial numbers, memory and scripts of the board.
  board_info_3 = 20,
  /// CMD_READ_PARAMS_3: Parameters of one profile and general parameters.
  read_params_3 = 21,
  /// CMD_WRITE_PARAMS_3: Store the parameters of one profile and the general parameters.
  write_params_3 = 22,
  /// CMD_REALTIME_DATA_3: Live data.
  realtime_data_3 = 23,
  /// CMD_SELECT_IMU_3: Select the IMU to configure and calibrate; ignored if it is not connected.
  select_imu_3 = 24,
  /// CMD_REALTIME_DATA_4: Live data with joint angles, currents and temperatures.
  realtime_data_4 = 25,
  /// CMD_ENCODERS_CALIB_OFFSET_4: Calibrate the offsets of the encoders.
  encoders_calib_offset_4 = 26,
  /// CMD_ENCODERS_CALIB_FLD_OFFSET_4: Calibrate the offsets between encoders and the motors'
  /// magnetic fields.
  encoders_calib_fld_offset_4 = 27,
  /// CMD_READ_PROFILE_NAMES: Profile names.
  read_profile_names = 28,
  /// CMD_WRITE_PROFILE_NAMES: Store the profile names.
  write_profile_names = 29,
  /// CMD_QUEUE_PARAMS_INFO_3: Undocumented; possibly describes the adjustable variables, the
  /// purpose of CMD_GET_PARAMS_3.
  queue_params_info_3 = 30,
  /// CMD_SET_ADJ_VARS_VAL: Values of adjustable variables.
  set_adj_vars_val = 31,
  /// CMD_SAVE_PARAMS_3: Save the parameters in use, with all changes to adjustable variables, to
  /// the active profile.
  save_params_3 = 32,
  /// CMD_READ_PARAMS_EXT: More parameters of one profile: filters, encoders, magnetometer.
  read_params_ext = 33,
  /// CMD_WRITE_PARAMS_EXT: Store more parameters of one profile.
  write_params_ext = 34,
  /// CMD_AUTO_PID: Tune the PID controllers automatically.
  auto_pid = 35,
  /// CMD_SERVO_OUT: Send PWM signals to servos.
  servo_out = 36,
  /// CMD_I2C_WRITE_REG_BUF: Write to a device on an I2C bus.
  i2c_write_reg_buf = 39,
  /// CMD_I2C_READ_REG_BUF: Data from a device on an I2C bus.
  i2c_read_reg_buf = 40,
  /// CMD_WRITE_EXTERNAL_DATA: Store user data in the EEPROM.
  write_external_data = 41,
  /// CMD_READ_EXTERNAL_DATA: User data in the EEPROM.
  read_external_data = 42,
  /// CMD_READ_ADJ_VARS_CFG: RC signals that trigger actions or change adjustable variables.
  read_adj_vars_cfg = 43,
  /// CMD_WRITE_ADJ_VARS_CFG: Store the RC signals that trigger actions or change adjustable
  /// variables.
  write_adj_vars_cfg = 44,
  /// CMD_API_VIRT_CH_CONTROL: Set the host's virtual RC channels, which can control the camera and
  /// more.
  api_virt_ch_control = 45,
  /// CMD_ADJ_VARS_STATE: Current state of one trigger slot and one analog slot.
  adj_vars_state = 46,
  /// CMD_EEPROM_WRITE: Write a block to the EEPROM.
  eeprom_write = 47,
  /// CMD_EEPROM_READ: A block of the EEPROM.
  eeprom_read = 48,
  /// CMD_CALIB_INFO: Calibration status for display.
  calib_info = 49,
  /// CMD_BOOT_MODE_3: Enter the bootloader to load new firmware.
  boot_mode_3 = 51,
  /// CMD_SYSTEM_STATE: Undocumented; by its name, the state of the system.
  system_state = 52,
  /// CMD_READ_FILE: Part of a file.
  read_file = 53,
  /// CMD_WRITE_FILE: Write part of a file; without data, delete it.
  write_file = 54,
  /// CMD_FS_CLEAR_ALL: Delete all files.
  fs_clear_all = 55,
  /// CMD_AHRS_HELPER: Attitude of an IMU as two unit vectors.
  ahrs_helper = 56,
  /// CMD_RUN_SCRIPT: Start or stop a script.
  run_script = 57,
  /// CMD_CALIB_MAG: Calibrate the magnetometer.
  calib_mag = 59,
  /// CMD_GET_ANGLES_EXT: Camera angles, targets and joint angles.
  get_angles_ext = 61,
  /// CMD_READ_PARAMS_EXT2: The third set of parameters of one profile.
  read_params_ext2 = 62,
  /// CMD_WRITE_PARAMS_EXT2: Store the third set of parameters of one profile.
  write_params_ext2 = 63,
  /// CMD_GET_ADJ_VARS_VAL: Request the values of adjustable variables.
  get_adj_vars_val = 64,
  /// CMD_CALIB_ACC: Calibrate an accelerometer.
  calib_acc = 65,
  /// CMD_CALIB_BAT: Calibrate the battery voltage measurement.
  calib_bat = 66,
  /// CMD_CONTROL: Move the camera.
  control = 67,
  /// CMD_REALTIME_DATA: Live data.
  realtime_data = 68,
  /// CMD_EXECUTE_MENU: Execute a menu action, as the menu button or the RC command channel does.
  execute_menu = 69,
  /// CMD_USE_DEFAULTS: Restore the factory defaults.
  use_defaults = 70,
  /// CMD_CALIB_EXT_GAIN: Calibrate the gains of a flight controller's signals.
  calib_ext_gain = 71,
  /// CMD_HELPER_DATA: Motion of the frame from an external system; improves stabilization.
  helper_data = 72,
  /// CMD_GET_ANGLES: Camera angles and targets.
  get_angles = 73,
  /// CMD_CALIB_MOTOR_MAG_LINK: Undocumented; by its name, calibrates the magnetic linkage of the
  /// motors.
  calib_motor_mag_link = 74,
  /// CMD_GYRO_CORRECTION: Correct the zero of a gyroscope manually; the camera drifts if the
  /// correction is wrong.
  gyro_correction = 75,
  /// CMD_MOTORS_ON: Turn the motors on.
  motors_on = 77,
  /// CMD_CALIB_OFFSET: Calibrate the follow mode offset.
  calib_offset = 79,
  /// CMD_CALIB_POLES: Detect the poles and the direction of the motors.
  calib_poles = 80,
  /// CMD_READ_PARAMS: Older id of CMD_READ_PARAMS_3.
  read_params = 82,
  /// CMD_TRIGGER_PIN: Switch an output pin.
  trigger_pin = 84,
  /// CMD_DATA_STREAM_INTERVAL: Start, change or end a data stream: messages that the board sends at
  /// a fixed rate.
  data_stream_interval = 85,
  /// CMD_BOARD_INFO: Board version and features.
  board_info = 86,
  /// CMD_WRITE_PARAMS: Older id of CMD_WRITE_PARAMS_3.
  write_params = 87,
  /// CMD_REALTIME_DATA_CUSTOM: Live data of the requested blocks.
  realtime_data_custom = 88,
  /// CMD_BEEP_SOUND: Play a melody through the motors, or a standard sound.
  beep_sound = 89,
  /// CMD_CALIB_GYRO: Calibrate a gyroscope.
  calib_gyro = 103,
  /// CMD_MOTORS_OFF: Turn the motors off.
  motors_off = 109,
  /// CMD_RESET: The board restarts.
  reset = 114,
  /// CMD_MAVLINK_INFO: Undocumented; by its name, information about a MAVLink connection.
  mavlink_info = 250,
  /// CMD_MAVLINK_DEBUG: Undocumented; by its name, debugging of a MAVLink connection.
  mavlink_debug = 251,
  /// CMD_DEBUG_VARS_INFO_3: Names and types of the debug variables, in the order of
  /// CMD_DEBUG_VARS_3.
  debug_vars_info_3 = 253,
  /// CMD_DEBUG_VARS_3: Values of the debug variables.
  debug_vars_3 = 254,
};

/// The commands of messages from the board.
/// Source: Command ID definitions L75-L154.
enum class CommandFromBoard : std::uint8_t {
  /// CMD_BOARD_INFO_3: Serial numbers, memory and scripts of the board.
  board_info_3 = 20,
  /// CMD_READ_PARAMS_3: Parameters of one profile and general parameters.
  read_params_3 = 21,
  /// CMD_REALTIME_DATA_3: Live data.
  realtime_data_3 = 23,
  /// CMD_REALTIME_DATA_4: Live data with joint angles, currents and temperatures.
  realtime_data_4 = 25,
  /// CMD_READ_PROFILE_NAMES: Profile names.
  read_profile_names = 28,
  /// CMD_QUEUE_PARAMS_INFO_3: Undocumented; possibly describes the adjustable variables, the
  /// purpose of CMD_GET_PARAMS_3.
  queue_params_info_3 = 30,
  /// CMD_SET_ADJ_VARS_VAL: Values of adjustable variables.
  set_adj_vars_val = 31,
  /// CMD_READ_PARAMS_EXT: More parameters of one profile: filters, encoders, magnetometer.
  read_params_ext = 33,
  /// CMD_AUTO_PID: Tune the PID controllers automatically.
  auto_pid = 35,
  /// CMD_I2C_READ_REG_BUF: Data from a device on an I2C bus.
  i2c_read_reg_buf = 40,
  /// CMD_READ_EXTERNAL_DATA: User data in the EEPROM.
  read_external_data = 42,
  /// CMD_READ_ADJ_VARS_CFG: RC signals that trigger actions or change adjustable variables.
  read_adj_vars_cfg = 43,
  /// CMD_ADJ_VARS_STATE: Current state of one trigger slot and one analog slot.
  adj_vars_state = 46,
  /// CMD_EEPROM_READ: A block of the EEPROM.
  eeprom_read = 48,
  /// CMD_CALIB_INFO: Calibration status for display.
  calib_info = 49,
  /// CMD_SYSTEM_STATE: Undocumented; by its name, the state of the system.
  system_state = 52,
  /// CMD_READ_FILE: Part of a file.
  read_file = 53,
  /// CMD_AHRS_HELPER: Attitude of an IMU as two unit vectors.
  ahrs_helper = 56,
  /// CMD_SCRIPT_DEBUG: Progress of a script started with debugging.
  script_debug = 58,
  /// CMD_GET_ANGLES_EXT: Camera angles, targets and joint angles.
  get_angles_ext = 61,
  /// CMD_READ_PARAMS_EXT2: The third set of parameters of one profile.
  read_params_ext2 = 62,
  /// CMD_CONFIRM: The board executed a command.
  confirm = 67,
  /// CMD_GET_ANGLES: Camera angles and targets.
  get_angles = 73,
  /// CMD_CALIB_MOTOR_MAG_LINK: Undocumented; by its name, calibrates the magnetic linkage of the
  /// motors.
  calib_motor_mag_link = 74,
  /// CMD_BOARD_INFO: Board version and features.
  board_info = 86,
  /// CMD_REALTIME_DATA_CUSTOM: Live data of the requested blocks.
  realtime_data_custom = 88,
  /// CMD_RESET: The board restarts.
  reset = 114,
  /// CMD_MAVLINK_INFO: Undocumented; by its name, information about a MAVLink connection.
  mavlink_info = 250,
  /// CMD_MAVLINK_DEBUG: Undocumented; by its name, debugging of a MAVLink connection.
  mavlink_debug = 251,
  /// CMD_DEBUG_VARS_INFO_3: Names and types of the debug variables, in the order of
  /// CMD_DEBUG_VARS_3.
  debug_vars_info_3 = 253,
  /// CMD_DEBUG_VARS_3: Values of the debug variables.
  debug_vars_3 = 254,
  /// CMD_ERROR: The board could not execute a command.
  error = 255,
};

/// The adjustable variables.
/// Source: Appendix B L1274-L1329.
enum class VariableId : std::uint8_t {
  /// P_ROLL: Proportional gain of roll.
  p_roll = 0,
  /// P_PITCH: Proportional gain of pitch.
  p_pitch = 1,
  /// P_YAW: Proportional gain of yaw.
  p_yaw = 2,
  /// I_ROLL: Integral gain of roll.
  i_roll = 3,
  /// I_PITCH: Integral gain of pitch.
  i_pitch = 4,
  /// I_YAW: Integral gain of yaw.
  i_yaw = 5,
  /// D_ROLL: Derivative gain of roll.
  d_roll = 6,
  /// D_PITCH: Derivative gain of pitch.
  d_pitch = 7,
  /// D_YAW: Derivative gain of yaw.
  d_yaw = 8,
  /// POWER_ROLL: Power of the roll motor.
  power_roll = 9,
  /// POWER_PITCH: Power of the pitch motor.
  power_pitch = 10,
  /// POWER_YAW: Power of the yaw motor.
  power_yaw = 11,
  /// ACC_LIMITER: Acceleration limit of all axes.
  acc_limiter = 12,
  /// FOLLOW_SPEED_ROLL: Follow mode speed of roll.
  follow_speed_roll = 13,
  /// FOLLOW_SPEED_PITCH: Follow mode speed of pitch.
  follow_speed_pitch = 14,
  /// FOLLOW_SPEED_YAW: Follow mode speed of yaw.
  follow_speed_yaw = 15,
  /// FOLLOW_LPF_ROLL: Follow mode low-pass filter of roll.
  follow_lpf_roll = 16,
  /// FOLLOW_LPF_PITCH: Follow mode low-pass filter of pitch.
  follow_lpf_pitch = 17,
  /// FOLLOW_LPF_YAW: Follow mode low-pass filter of yaw.
  follow_lpf_yaw = 18,
  /// RC_SPEED_ROLL: RC control speed of roll.
  rc_speed_roll = 19,
  /// RC_SPEED_PITCH: RC control speed of pitch.
  rc_speed_pitch = 20,
  /// RC_SPEED_YAW: RC control speed of yaw.
  rc_speed_yaw = 21,
  /// RC_LPF_ROLL: RC low-pass filter of roll.
  rc_lpf_roll = 22,
  /// RC_LPF_PITCH: RC low-pass filter of pitch.
  rc_lpf_pitch = 23,
  /// RC_LPF_YAW: RC low-pass filter of yaw.
  rc_lpf_yaw = 24,
  /// RC_TRIM_ROLL: RC trim of roll.
  rc_trim_roll = 25,
  /// RC_TRIM_PITCH: RC trim of pitch.
  rc_trim_pitch = 26,
  /// RC_TRIM_YAW: RC trim of yaw.
  rc_trim_yaw = 27,
  /// RC_DEADBAND: Dead band around the center of the RC signals.
  rc_deadband = 28,
  /// RC_EXPO_RATE: Expo rate of the RC signals.
  rc_expo_rate = 29,
  /// FOLLOW_MODE: What the camera follows: 0 nothing, 1 the flight controller, 2 pitch and roll of
  /// the frame.
  follow_mode = 30,
  /// RC_FOLLOW_YAW: 1 if yaw follows the frame, otherwise 0.
  rc_follow_yaw = 31,
  /// FOLLOW_DEADBAND: Dead band of the follow mode.
  follow_deadband = 32,
  /// FOLLOW_EXPO_RATE: Expo rate of the follow mode.
  follow_expo_rate = 33,
  /// FOLLOW_ROLL_MIX_START: Angle at which pitch starts to follow roll.
  follow_roll_mix_start = 34,
  /// FOLLOW_ROLL_MIX_RANGE: Angle over which pitch continues to follow roll.
  follow_roll_mix_range = 35,
  /// GYRO_TRUST: Trust in the gyroscope relative to the accelerometer.
  gyro_trust = 36,
  /// FRAME_HEADING_ANGLE: Heading of the frame.
  frame_heading_angle = 37,
  /// GYRO_HEADING_CORRECTION: Gyroscope correction about the vertical.
  gyro_heading_correction = 38,
  /// ACC_LIMITER_ROLL: Acceleration limit of roll.
  acc_limiter_roll = 39,
  /// ACC_LIMITER_PITCH: Acceleration limit of pitch.
  acc_limiter_pitch = 40,
  /// ACC_LIMITER_YAW: Acceleration limit of yaw.
  acc_limiter_yaw = 41,
  /// PID_GAIN_ROLL: Factor for P, I and D of roll.
  pid_gain_roll = 42,
  /// PID_GAIN_PITCH: Factor for P, I and D of pitch.
  pid_gain_pitch = 43,
  /// PID_GAIN_YAW: Factor for P, I and D of yaw.
  pid_gain_yaw = 44,
  /// LPF_FREQ_ROLL: Low-pass filter of roll.
  lpf_freq_roll = 45,
  /// LPF_FREQ_PITCH: Low-pass filter of pitch.
  lpf_freq_pitch = 46,
  /// LPF_FREQ_YAW: Low-pass filter of yaw.
  lpf_freq_yaw = 47,
};

/// Reason that the board did not execute a command.
/// Source: Incoming commands L421-L426.
enum class BoardErrorCode : std::uint8_t {
  /// The command has no body of this size.
  cmd_size = 1,
  /// A value is invalid.
  wrong_params = 2,
  /// A key or signature check failed.
  crypto = 4,
  /// The board does not know the command.
  unknown_command = 6,
  /// Not possible in the current state.
  wrong_state = 8,
  /// The board lacks a feature that the command requires.
  not_supported = 9,
  /// The board tried and failed.
  operation_failed = 10,
  /// Temporarily not possible; retry later.
  temporary = 11,
};

/// What an RC signal controls.
/// Source: Variables L1022.
enum class RcModeKind : std::uint8_t {
  /// RC_MODE_ANGLE: The angle of the camera.
  angle = 0,
  /// RC_MODE_SPEED: The speed of the camera.
  speed = 1,
};

/// PWM frequency of the motor drivers.
/// Source: Variables L1030.
enum class PwmFrequency : std::uint8_t {
  /// PWM_FREQ_LOW: Low.
  low = 0,
  /// PWM_FREQ_HIGH: High.
  high = 1,
  /// PWM_FREQ_ULTRA_HIGH: Ultra high. Since board 3.0.
  ultra_high = 2,
};

/// Baud rate of the serial port.
/// Source: Variables L1031.
enum class SerialSpeed : std::uint8_t {
  /// 115200 baud.
  baud_115200 = 0,
  /// 57600 baud.
  baud_57600 = 1,
  /// 38400 baud.
  baud_38400 = 2,
  /// 19200 baud.
  baud_19200 = 3,
  /// 9600 baud.
  baud_9600 = 4,
};

/// Returns the number that a value denotes; 0 for unknown values.
constexpr std::uint32_t number_of(SerialSpeed value) noexcept {
  switch (value) {
    case SerialSpeed::baud_115200: return 115200;
    case SerialSpeed::baud_57600: return 57600;
    case SerialSpeed::baud_38400: return 38400;
    case SerialSpeed::baud_19200: return 19200;
    case SerialSpeed::baud_9600: return 9600;
  }
  return 0;
}

/// Signal at the RC_ROLL input pin.
/// Source: Variables L1035.
enum class RcVirtualMode : std::uint8_t {
  /// RC_VIRT_MODE_NORMAL: One PWM signal.
  normal = 0,
  /// RC_VIRT_MODE_CPPM: Sum-PPM.
  cppm = 1,
  /// RC_VIRT_MODE_SBUS: S.BUS. Since board 3.0.
  sbus = 2,
  /// RC_VIRT_MODE_SPEKTRUM: Spektrum satellite. Since board 3.0.
  spektrum = 3,
  /// RC_VIRT_MODE_API: Virtual channels of the Serial API. Since board 3.0.
  api = 10,
};

/// Named inputs of RC_MAP: pins for PWM or an analog voltage.
/// Source: Variables L1036.
enum class RcInput : std::uint8_t {
  /// INPUT_NO: No input.
  input_no = 0,
  /// RC_INPUT_ROLL: PWM at the RC_ROLL pin.
  rc_input_roll = 1,
  /// RC_INPUT_PITCH: PWM at the RC_PITCH pin.
  rc_input_pitch = 2,
  /// EXT_FC_INPUT_ROLL: PWM at the FC_ROLL pin.
  ext_fc_input_roll = 3,
  /// EXT_FC_INPUT_PITCH: PWM at the FC_PITCH pin.
  ext_fc_input_pitch = 4,
  /// RC_INPUT_YAW: PWM at the RC_YAW pin. Since board 3.0.
  rc_input_yaw = 5,
  /// ADC1: Analog input 1; RC_INPUT_ROLL on older boards. Since board 3.0.
  adc1 = 33,
  /// ADC2: Analog input 2; RC_INPUT_PITCH on older boards. Since board 3.0.
  adc2 = 34,
  /// ADC3: Analog input 3; EXT_FC_INPUT_ROLL on older boards. Since board 3.0.
  adc3 = 35,
  /// Analog signal at the FC_PITCH pin of boards before 3.0.
  ext_fc_input_pitch_analog = 36,
};

/// Kind of signal selected by RC_MAP.
/// Source: Variables L1036-L1038.
enum class RcSource : std::uint8_t {
  /// A PWM signal.
  pwm = 0,
  /// An analog voltage.
  analog = 32,
  /// A virtual channel of Sum-PPM, S.BUS or Spektrum.
  serial = 64,
  /// A virtual channel that CMD_API_VIRT_CH_CONTROL sets.
  api = 128,
};

/// RC channel into which a flight controller's signal is mixed.
/// Source: Variables L1039.
enum class MixTarget : std::uint8_t {
  /// None.
  no_mix = 0,
  /// ROLL: Roll.
  roll = 1,
  /// PITCH: Pitch.
  pitch = 2,
  /// YAW: Yaw.
  yaw = 3,
};

/// What the camera follows.
/// Source: Variables L1040.
enum class FollowMode : std::uint8_t {
  /// FOLLOW_MODE_DISABLED: Nothing.
  disabled = 0,
  /// FOLLOW_MODE_FC: The flight controller.
  fc = 1,
  /// FOLLOW_MODE_PITCH: Pitch and roll of the frame.
  pitch = 2,
};

/// Direction of a sensor's axis.
/// Source: Variables L1046, L1104.
enum class SensorAxis : std::int8_t {
  /// X: X axis.
  x = 1,
  /// Y: Y axis.
  y = 2,
  /// Z: Z axis.
  z = 3,
  /// -X: Against the X axis.
  minus_x = -1,
  /// -Y: Against the Y axis.
  minus_y = -2,
  /// -Z: Against the Z axis.
  minus_z = -3,
};

/// Location of the frame IMU.
/// Source: Variables L1047.
enum class FrameImuPosition : std::uint8_t {
  /// FRAME_IMU_DISABLED: There is none.
  disabled = 0,
  /// FRAME_IMU_BELOW_YAW: Below the yaw motor.
  below_yaw = 1,
  /// FRAME_IMU_ABOVE_YAW: Above the yaw motor.
  above_yaw = 2,
  /// FRAME_IMU_BELOW_YAW_PID_SOURCE: Below the yaw motor, and the input of the PID controller.
  below_yaw_pid_source = 3,
};

/// Gyroscope calibration at start-up.
/// Source: Variables L1050.
enum class SkipGyroCalibration : std::uint8_t {
  /// Calibrate.
  do_not_skip = 0,
  /// Never calibrate.
  skip_always = 1,
  /// Calibrate unless the board moves.
  skip_if_moving = 2,
};

/// Actions of the menu button, an RC signal or CMD_EXECUTE_MENU.
/// Source: Variables L1051-L1053.
enum class MenuCommand : std::uint8_t {
  /// MENU_CMD_NO: Nothing.
  none = 0,
  /// MENU_CMD_PROFILE1: Switch to profile 1.
  profile1 = 1,
  /// MENU_CMD_PROFILE2: Switch to profile 2.
  profile2 = 2,
  /// MENU_CMD_PROFILE3: Switch to profile 3.
  profile3 = 3,
  /// MENU_CMD_SWAP_PITCH_ROLL: Swap the RC signals of pitch and roll.
  swap_pitch_roll = 4,
  /// MENU_CMD_SWAP_YAW_ROLL: Swap the RC signals of yaw and roll.
  swap_yaw_roll = 5,
  /// MENU_CMD_CALIB_ACC: Calibrate the accelerometer.
  calib_acc = 6,
  /// MENU_CMD_RESET: Restart the board.
  reset = 7,
  /// MENU_CMD_SET_ANGLE: Make the current angle the initial angle.
  set_angle = 8,
  /// MENU_CMD_CALIB_GYRO: Calibrate the gyroscope.
  calib_gyro = 9,
  /// MENU_CMD_MOTOR_TOGGLE: Turn the motors on or off.
  motor_toggle = 10,
  /// MENU_CMD_MOTOR_ON: Turn the motors on.
  motor_on = 11,
  /// MENU_CMD_MOTOR_OFF: Turn the motors off.
  motor_off = 12,
  /// MENU_CMD_FRAME_UPSIDE_DOWN: Treat the frame as upside down.
  frame_upside_down = 13,
  /// MENU_CMD_PROFILE4: Switch to profile 4.
  profile4 = 14,
  /// MENU_CMD_PROFILE5: Switch to profile 5.
  profile5 = 15,
  /// MENU_CMD_AUTO_PID: Tune the PID controllers.
  auto_pid = 16,
  /// MENU_CMD_LOOK_DOWN: Point the camera downwards.
  look_down = 17,
  /// MENU_CMD_HOME_POSITION: Return the camera to its home position.
  home_position = 18,
  /// MENU_CMD_RC_BIND: Bind an RC receiver.
  rc_bind = 19,
  /// MENU_CMD_CALIB_GYRO_TEMP: Calibrate the gyroscope over temperature.
  calib_gyro_temp = 20,
  /// MENU_CMD_CALIB_ACC_TEMP: Calibrate the accelerometer over temperature.
  calib_acc_temp = 21,
  /// MENU_CMD_BUTTON_PRESS: Press the menu button.
  button_press = 22,
  /// MENU_CMD_RUN_SCRIPT1: Run script 1.
  run_script1 = 23,
  /// MENU_CMD_RUN_SCRIPT2: Run script 2.
  run_script2 = 24,
  /// MENU_CMD_RUN_SCRIPT3: Run script 3.
  run_script3 = 25,
  /// MENU_CMD_RUN_SCRIPT4: Run script 4.
  run_script4 = 26,
  /// MENU_CMD_RUN_SCRIPT5: Run script 5.
  run_script5 = 27,
  /// MENU_CMD_CALIB_MAG: Calibrate the magnetometer.
  calib_mag = 33,
  /// MENU_CMD_LEVEL_ROLL_PITCH: Level roll and pitch.
  level_roll_pitch = 34,
  /// MENU_CMD_CENTER_YAW: Center yaw.
  center_yaw = 35,
  /// MENU_CMD_UNTWIST_CABLES: Turn back to untwist the cables.
  untwist_cables = 36,
  /// MENU_CMD_SET_ANGLE_NO_SAVE: Make the current angle the initial angle, without saving it.
  set_angle_no_save = 37,
};

/// Motor output that drives an axis.
/// Source: Variables L1054.
enum class MotorOutput : std::uint8_t {
  /// DISABLED: None.
  disabled = 0,
  /// ROLL: The ROLL output.
  roll = 1,
  /// PITCH: The PITCH output.
  pitch = 2,
  /// YAW: The YAW output.
  yaw = 3,
};

/// Which IMU is selected.
/// Source: Variables L1062, L1135, L1169, L1235; Outgoing commands L893.
enum class SelectedImu : std::uint8_t {
  /// IMU_TYPE_MAIN: The main IMU on the camera.
  main = 1,
  /// IMU_TYPE_FRAME: The IMU on the frame.
  frame = 2,
};

/// Protocol of a Spektrum satellite.
/// Source: Variables L1075-L1077.
enum class SpektrumMode : std::uint8_t {
  /// Detected.
  auto_detect = 0,
  /// DSM2, 11 ms, 10 bits.
  dsm2_11ms_10bit = 1,
  /// DSM2, 11 ms, 11 bits.
  dsm2_11ms_11bit = 2,
  /// DSM2, 22 ms, 10 bits.
  dsm2_22ms_10bit = 3,
  /// DSM2, 22 ms, 11 bits.
  dsm2_22ms_11bit = 4,
  /// DSMX, 11 ms, 10 bits.
  dsmx_11ms_10bit = 5,
  /// DSMX, 11 ms, 11 bits.
  dsmx_11ms_11bit = 6,
  /// DSMX, 22 ms, 10 bits.
  dsmx_22ms_10bit = 7,
  /// DSMX, 22 ms, 11 bits.
  dsmx_22ms_11bit = 8,
};

/// Order of the motor axes, counted from the camera.
/// Source: Variables L1078.
enum class AxisOrder : std::uint8_t {
  /// PITCH_ROLL_YAW: Pitch, roll, yaw.
  pitch_roll_yaw = 0,
  /// YAW_ROLL_PITCH: Yaw, roll, pitch.
  yaw_roll_pitch = 1,
  /// ROLL_YAW_PITCH: Roll, yaw, pitch; not implemented.
  roll_yaw_pitch = 2,
  /// ROLL_PITCH_YAW: Roll, pitch, yaw.
  roll_pitch_yaw = 3,
};

/// Order of the Euler angles of camera and target.
/// Source: Variables L1079.
enum class EulerOrder : std::uint8_t {
  /// PITCH_ROLL_YAW: Pitch, roll, yaw.
  pitch_roll_yaw = 0,
  /// ROLL_PITCH_YAW: Roll, pitch, yaw.
  roll_pitch_yaw = 1,
  /// LOCAL_ROLL: Local, roll; for two-axis systems.
  local_roll = 2,
  /// ROLL_LOCAL: Roll, local; for two-axis systems.
  roll_local = 3,
  /// YAW_ROLL_PITCH: Yaw, roll, pitch.
  yaw_roll_pitch = 4,
  /// YAW_PITCH_ROLL: Yaw, pitch, roll.
  yaw_pitch_roll = 5,
};

/// Kind of encoder.
/// Source: Variables L1100.
enum class EncoderModel : std::uint8_t {
  /// ENC_TYPE_AS5048A: AS5048A, over SPI.
  as5048a = 1,
  /// ENC_TYPE_AS5048B: AS5048B, over I2C.
  as5048b = 2,
  /// ENC_TYPE_AS5048_PWM: AS5048, over PWM.
  as5048_pwm = 3,
  /// ENC_TYPE_AMT203: AMT203.
  amt203 = 4,
  /// ENC_TYPE_MA3_10BIT: MA3 with 10 bits.
  ma3_10bit = 5,
  /// ENC_TYPE_MA3_12BIT: MA3 with 12 bits.
  ma3_12bit = 6,
  /// ENC_TYPE_ANALOG: Analog.
  analog = 7,
  /// ENC_TYPE_I2C_DRV1: I2C driver 1.
  i2c_drv1 = 8,
  /// ENC_TYPE_I2C_DRV2: I2C driver 2.
  i2c_drv2 = 9,
  /// ENC_TYPE_I2C_DRV3: I2C driver 3.
  i2c_drv3 = 10,
  /// ENC_TYPE_I2C_DRV4: I2C driver 4.
  i2c_drv4 = 11,
  /// ENC_TYPE_AS5600_PWM: AS5600, over PWM.
  as5600_pwm = 12,
  /// ENC_TYPE_AS5600_I2C: AS5600, over I2C.
  as5600_i2c = 13,
};

/// Clock of an SPI encoder; for an I2C driver, the kind of encoder in it.
/// Source: Variables L1101.
enum class EncoderConfig : std::uint8_t {
  /// SPI_SPEED_1MHz: SPI clock of 1 MHz.
  spi_1_mhz = 0,
  /// SPI_SPEED_2MHz: SPI clock of 2 MHz.
  spi_2_mhz = 1,
  /// SPI_SPEED_4MHz: SPI clock of 4 MHz.
  spi_4_mhz = 2,
  /// SPI_SPEED_500kHz: SPI clock of 500 kHz.
  spi_500_khz = 3,
};

/// Reason for an emergency stop.
/// Source: Variables L1131.
enum class SystemSubError : std::uint8_t {
  /// No emergency stop.
  none = 0,
  /// SUB_ERR_I2C_ERRORS: Too many errors on the I2C bus.
  i2c_errors = 1,
  /// SUB_ERR_DRV_OTW: A motor driver reports an overtemperature warning.
  drv_otw = 2,
  /// SUB_ERR_DRV_FAULT: A motor driver failed.
  drv_fault = 3,
  /// SUB_ERR_ENCODER_IMU_ANGLE: Encoder and IMU disagree.
  encoder_imu_angle = 4,
  /// SUB_ERR_CALIBRATION_FAILED: A calibration failed.
  calibration_failed = 5,
  /// SUB_ERR_INTERNAL_SYSTEM_ERROR: Internal error.
  internal_system_error = 6,
  /// SUB_ERR_ENCODER_CALIB_BAD_SCALE: The scale of an encoder is wrong.
  encoder_calib_bad_scale = 7,
  /// SUB_ERR_OVER_TEMPERATURE: Overtemperature.
  over_temperature = 8,
  /// SUB_ERR_BAD_MOTOR_POLES_INVERT: Wrong poles or direction of a motor.
  bad_motor_poles_invert = 9,
  /// SUB_ERR_NOT_ENOUGH_MEMORY: Out of memory.
  not_enough_memory = 10,
  /// SUB_ERR_IMU_SENSOR_NOT_RESPONDING: The IMU sensor does not respond.
  imu_sensor_not_responding = 11,
  /// SUB_ERR_MOTOR_OVERHEAT_PROTECTION: A motor overheated.
  motor_overheat_protection = 13,
};

/// Meaning of SPEED and ANGLE in a control command.
/// Source: Variables L1148.
enum class ControlModeKind : std::uint8_t {
  /// MODE_NO_CONTROL: Serial control ends and RC takes over.
  no_control = 0,
  /// MODE_SPEED: Turn at the given speed, in Euler coordinates, until the next command; the angle
  /// is ignored.
  speed = 1,
  /// MODE_ANGLE: Go to the given angle, in Euler coordinates, at the given speed; speed 0 selects
  /// the speed from the parameters.
  angle = 2,
  /// MODE_SPEED_ANGLE: Follow the given speed while the controller holds the given angle; the most
  /// precise mode.
  speed_angle = 3,
  /// MODE_RC: The angle replaces the RC signal, -500 to 500; the speed is ignored.
  rc = 4,
  /// MODE_ANGLE_REL_FRAME: Go to the given angle relative to the frame's neutral point; undoes full
  /// turns, so it untwists cables. Speed 0 selects the speed from the parameters.
  angle_rel_frame = 5,
};

/// How to turn the motors off.
/// Source: Later firmware.
enum class MotorsOffMode : std::uint8_t {
  /// They turn freely, without current.
  normal = 0,
  /// They brake.
  brake = 1,
  /// They stop safely.
  safe_stop = 2,
};

/// Coordinate system of data from an external system.
/// Source: Variables L1250.
enum class CoordinateSystem : std::uint8_t {
  /// COORD_SYS_GROUND_YAW_ROTATED: Ground coordinates rotated with the camera about Z: Z points up,
  /// X right, Y forward. The default.
  ground_yaw_rotated = 1,
};

/// IMU to calibrate.
/// Source: Outgoing commands L629.
enum class CalibImu : std::uint8_t {
  /// The active IMU.
  active = 0,
  /// The main IMU on the camera.
  main = 1,
  /// The IMU on the frame.
  frame = 2,
};

/// Kind of calibration.
/// Source: Outgoing commands L630-L637.
enum class CalibAction : std::uint8_t {
  /// Calibrate at the current temperature.
  regular = 1,
  /// Erase all calibrations and restart.
  reset = 2,
  /// Calibrate over temperature.
  temperature = 3,
  /// Enable the calibration over temperature, if there is one, and restart.
  enable_temperature = 4,
  /// Disable the calibration over temperature, but keep it in memory, and restart.
  disable_temperature = 5,
  /// Copy the calibration from the sensor's EEPROM to the main EEPROM.
  restore_factory = 6,
  /// Copy the calibration from the main EEPROM to the sensor's EEPROM.
  store_in_sensor = 7,
};

/// IMU, counted from 0.
/// Source: Variables L1199, L1207.
enum class ImuIndex : std::uint8_t {
  /// The main IMU on the camera.
  main = 0,
  /// The IMU on the frame.
  frame = 1,
};

/// Pins that a host can switch.
/// Source: Variables L1154.
enum class OutputPin : std::uint8_t {
  /// RC_INPUT_ROLL: The RC_ROLL pin.
  rc_input_roll = 1,
  /// RC_INPUT_PITCH: The RC_PITCH pin.
  rc_input_pitch = 2,
  /// EXT_FC_INPUT_ROLL: The FC_ROLL pin.
  ext_fc_input_roll = 3,
  /// EXT_FC_INPUT_PITCH: The FC_PITCH pin.
  ext_fc_input_pitch = 4,
  /// RC_INPUT_YAW: The RC_YAW pin. Since board 3.0.
  rc_input_yaw = 5,
  /// PIN_AUX1: The AUX1 pin; on 1.x boards, pin 2 of the microcontroller.
  pin_aux1 = 16,
  /// PIN_AUX2: The AUX2 pin; on 1.x boards, pin 11 of the microcontroller.
  pin_aux2 = 17,
  /// PIN_AUX3: The AUX3 pin; on 1.x boards, pin 12 of the microcontroller.
  pin_aux3 = 18,
  /// PIN_BUZZER: The buzzer; on 1.x boards, pin 32 of the microcontroller.
  pin_buzzer = 32,
  /// PIN_SSAT_POWER: The 3.3 V supply of the Spektrum connector; LOW turns it on.
  pin_ssat_power = 33,
};

/// State of an output pin.
/// Source: Variables L1155.
enum class PinState : std::uint8_t {
  /// LOW: Low; sinks up to 40 mA.
  low = 0,
  /// HIGH: High; supplies up to 40 mA.
  high = 1,
};

/// I2C bus of the board.
/// Source: Outgoing commands L829.
enum class I2cPort : std::uint8_t {
  /// The bus of the sensors.
  main = 0,
  /// The bus of the EEPROM.
  second = 1,
};

/// Result of an operation on the board's file system.
/// Source: Outgoing commands L916-L928.
enum class FileError : std::uint8_t {
  /// NO_ERROR: Success.
  no_error = 0,
  /// ERR_EEPROM_FAULT: The memory chip does not respond.
  eeprom_fault = 1,
  /// ERR_FILE_NOT_FOUND: No file has this id.
  file_not_found = 2,
  /// ERR_FAT: The file table is damaged.
  fat = 3,
  /// ERR_NO_FREE_SPACE: The memory is full.
  no_free_space = 4,
  /// ERR_FAT_IS_FULL: The file table is full.
  fat_is_full = 5,
  /// ERR_FILE_SIZE: The size is invalid.
  file_size = 6,
  /// ERR_CRC: Checksum mismatch.
  crc = 7,
  /// ERR_LIMIT_REACHED: The file system reached a limit.
  limit_reached = 8,
  /// The file is damaged.
  file_corrupted = 9,
  /// A value of the request is invalid.
  wrong_params = 10,
};

/// Operation on a script.
/// Source: Outgoing commands L936.
enum class ScriptMode : std::uint8_t {
  /// Stop it.
  stop = 0,
  /// Start it.
  start = 1,
  /// Start it and report progress with CMD_SCRIPT_DEBUG.
  start_debug = 2,
};

/// Type of a debug variable.
/// Source: Variables L1188.
enum class DebugVarKind : std::uint8_t {
  /// VAR_TYPE_UINT8: Unsigned, 8 bits.
  uint8 = 1,
  /// VAR_TYPE_INT8: Signed, 8 bits.
  int8 = 2,
  /// VAR_TYPE_UINT16: Unsigned, 16 bits.
  uint16 = 3,
  /// VAR_TYPE_INT16: Signed, 16 bits.
  int16 = 4,
  /// VAR_TYPE_UINT32: Unsigned, 32 bits.
  uint32 = 5,
  /// VAR_TYPE_INT32: Signed, 32 bits.
  int32 = 6,
  /// VAR_TYPE_FLOAT: Floating point, IEEE-754, 32 bits.
  float32 = 7,
};

/// Returns the number type that a value denotes; none for unknown values.
constexpr NumberType number_type(DebugVarKind value) noexcept {
  switch (value) {
    case DebugVarKind::uint8: return NumberType::u8;
    case DebugVarKind::int8: return NumberType::i8;
    case DebugVarKind::uint16: return NumberType::u16;
    case DebugVarKind::int16: return NumberType::i16;
    case DebugVarKind::uint32: return NumberType::u32;
    case DebugVarKind::int32: return NumberType::i32;
    case DebugVarKind::float32: return NumberType::f32;
  }
  return NumberType::none;
}

/// Axis of a debug variable.
/// Source: Variables L1188.
enum class DebugVarAxis : std::uint8_t {
  /// None.
  no_axis = 0,
  /// VAR_FLAG_ROLL: Roll.
  roll = 16,
  /// VAR_FLAG_PITCH: Pitch.
  pitch = 32,
  /// VAR_FLAG_YAW: Yaw.
  yaw = 48,
};

/// Features of the board's hardware and firmware.
/// Source: Variables L1008.
enum class BoardFeature : std::uint16_t {
  /// BOARD_FEATURE_3AXIS: Drives three motors.
  three_axis = 0x0001,
  /// BOARD_FEATURE_BAT_MONITORING: Measures the battery voltage.
  bat_monitoring = 0x0002,
  /// BOARD_FEATURE_ENCODERS: Supports motor encoders.
  encoders = 0x0004,
  /// BOARD_FEATURE_BODE_TEST: Can record a frequency response.
  bode_test = 0x0008,
  /// BOARD_FEATURE_SCRIPTING: Runs user scripts.
  scripting = 0x0010,
  /// BOARD_FEATURE_CURRENT_SENSOR: Measures the supply current.
  current_sensor = 0x0020,
};
using BoardFeatures = Flags<BoardFeature>;

/// How the host is connected to the board.
/// Source: Variables L1009.
enum class ConnectionFlag : std::uint8_t {
  /// CONNECTION_USB: The host is connected over USB, not over a UART.
  usb = 0x01,
};
using ConnectionFlags = Flags<ConnectionFlag>;

/// What the board does before a restart.
/// Source: Outgoing commands L676, L685.
enum class ResetOption : std::uint8_t {
  /// Send CMD_RESET back first.
  notify = 0x01,
};
using ResetOptions = Flags<ResetOption>;

/// Enabled filters of an axis; 0 disables all.
/// Source: Variables L1084.
enum class FilterSwitch : std::uint8_t {
  /// EN_NOTCH1: First notch filter.
  notch1 = 0x01,
  /// EN_NOTCH2: Second notch filter.
  notch2 = 0x02,
  /// EN_NOTCH3: Third notch filter.
  notch3 = 0x04,
  /// EN_LPF: Low-pass filter.
  lpf = 0x08,
};
using FilterSwitches = Flags<FilterSwitch>;

/// Options in the upper half of the encoder type byte.
/// Source: Variables L1100.
enum class EncoderFlag : std::uint8_t {
  /// SKIP_DETECTION: Do not detect whether the encoder is present.
  skip_detection = 0x10,
  /// ENCODER_IS_GEARED: There is a gear between motor and encoder.
  encoder_is_geared = 0x80,
};
using EncoderFlags = Flags<EncoderFlag>;

/// When the board makes a sound.
/// Source: Variables L1058.
enum class BeeperMode : std::uint8_t {
  /// BEEPER_MODE_CALIBRATE: During calibrations.
  calibrate = 0x01,
  /// BEEPER_MODE_CONFIRM: To confirm commands.
  confirm = 0x02,
  /// BEEPER_MODE_ERROR: On errors.
  error = 0x04,
  /// BEEPER_MODE_ALARM: On alarms.
  alarm = 0x08,
  /// BEEP_BY_MOTORS: The motors make the sound instead of the buzzer.
  by_motors = 0x80,
};
using BeeperModes = Flags<BeeperMode>;

/// Axes with adaptive PID control; 0 disables it.
/// Source: Variables L1067.
enum class AdaptivePidAxis : std::uint8_t {
  /// EN_ROLL: Roll.
  roll = 0x01,
  /// EN_PITCH: Pitch.
  pitch = 0x02,
  /// EN_YAW: Yaw.
  yaw = 0x04,
};
using AdaptivePidAxes = Flags<AdaptivePidAxis>;

/// Options of the whole board.
/// Source: Variables L1073.
enum class GeneralFlag : std::uint16_t {
  /// REMEMBER_LAST_USED_PROFILE: Start with the last used profile.
  remember_last_used_profile = 0x0001,
  /// UPSIDE_DOWN_AUTO: Detect an upside-down frame.
  upside_down_auto = 0x0002,
  /// SWAP_FRAME_MAIN_IMU: Swap frame IMU and main IMU.
  swap_frame_main_imu = 0x0004,
  /// BLINK_PROFILE: Blink the profile number.
  blink_profile = 0x0008,
  /// EMERGENCY_STOP: Stop in an emergency.
  emergency_stop = 0x0010,
  /// MAGNETOMETER_POS_FRAME: The magnetometer is on the frame.
  magnetometer_pos_frame = 0x0020,
  /// FRAME_IMU_FF: Feed forward from the frame IMU.
  frame_imu_ff = 0x0040,
  /// OVERHEAT_STOP_MOTORS: Stop the motors when they overheat.
  overheat_stop_motors = 0x0080,
  /// CENTER_YAW_AT_STARTUP: Center yaw at start-up.
  center_yaw_at_startup = 0x0100,
};
using GeneralFlags = Flags<GeneralFlag>;

/// Options of one profile.
/// Source: Variables L1074.
enum class ProfileFlag : std::uint16_t {
  /// ADC1_AUTO_DETECTION: Detect whether analog input 1 is connected.
  adc1_auto_detection = 0x0001,
  /// ADC2_AUTO_DETECTION: Detect whether analog input 2 is connected.
  adc2_auto_detection = 0x0002,
  /// ADC3_AUTO_DETECTION: Detect whether analog input 3 is connected.
  adc3_auto_detection = 0x0004,
  /// FOLLOW_USE_FRAME_IMU: Follow mode uses the frame IMU.
  follow_use_frame_imu = 0x0010,
  /// BRIEFCASE_AUTO_DETECTION: Detect when the gimbal is carried like a briefcase.
  briefcase_auto_detection = 0x0020,
  /// UPSIDE_DOWN_AUTO_ROTATE: Turn the camera when the frame is upside down.
  upside_down_auto_rotate = 0x0040,
  /// FOLLOW_LOCK_OFFSET_CORRECTION: Do not correct the offset in follow mode.
  follow_lock_offset_correction = 0x0080,
  /// START_NEUTRAL_POSITION: Start in the neutral position.
  start_neutral_position = 0x0100,
};
using ProfileFlags = Flags<ProfileFlag>;

/// Errors detected by the board.
/// Source: Variables L1128-L1130.
enum class SystemError : std::uint16_t {
  /// ERR_NO_SENSOR: The IMU sensor does not respond.
  no_sensor = 0x0001,
  /// ERR_CALIB_ACC: The accelerometer is not calibrated.
  calib_acc = 0x0002,
  /// ERR_SET_POWER: The motor power is not set.
  set_power = 0x0004,
  /// ERR_CALIB_POLES: The motor poles are not calibrated.
  calib_poles = 0x0008,
  /// ERR_PROTECTION: The driver protection tripped.
  protection = 0x0010,
  /// ERR_SERIAL: Errors on the serial line.
  serial = 0x0020,
  /// ERR_LOW_BAT1: The battery is below the alarm threshold.
  low_bat1 = 0x0040,
  /// ERR_LOW_BAT2: The battery is below the motor stop threshold.
  low_bat2 = 0x0080,
  /// ERR_GUI_VERSION: The host software does not match the firmware.
  gui_version = 0x0100,
  /// ERR_MISS_STEPS: A motor lost steps.
  miss_steps = 0x0200,
  /// ERR_SYSTEM: System error.
  system = 0x0400,
  /// ERR_EMERGENCY_STOP: Emergency stop; SYSTEM_SUB_ERROR gives the reason.
  emergency_stop = 0x0800,
};
using SystemErrors = Flags<SystemError>;

/// State of the motors.
/// Source: Variables L1133.
enum class OtherFlag : std::uint8_t {
  /// The motors are on.
  motors_on = 0x01,
};
using OtherFlags = Flags<OtherFlag>;

/// Data blocks of CMD_REALTIME_DATA_CUSTOM.
/// Source: Variables L1209.
enum class RealtimeDataCustomFlag : std::uint32_t {
  /// Angles of the main IMU.
  imu_angles = 0x00000001,
  /// RC target angles.
  target_angles = 0x00000002,
  /// RC target speed.
  target_speed = 0x00000004,
  /// Joint angles.
  stator_rotor_angle = 0x00000008,
  /// Gyroscope of the IMU.
  gyro_data = 0x00000010,
  /// RC signals of the standard inputs.
  rc_data = 0x00000020,
  /// Attitude of the IMU as a rotation matrix.
  z1_h1_vectors = 0x00000040,
  /// All RC channels of S.BUS, Sum-PPM or Spektrum.
  rc_channels = 0x00000080,
  /// Accelerometer of the IMU.
  acc_data = 0x00000100,
};
using RealtimeDataCustomFlags = Flags<RealtimeDataCustomFlag>;

/// Options in the upper half of a control mode byte.
/// Source: Variables L1148.
enum class ControlFlag : std::uint8_t {
  /// CONTROL_FLAG_HIGH_RES_SPEED: Speeds are in 0.001 deg/s. Since firmware 2.59.
  high_res_speed = 0x80,
};
using ControlFlags = Flags<ControlFlag>;

/// Options of automatic PID tuning.
/// Source: Variables L1179-L1181.
enum class AutoPidFlag : std::uint8_t {
  /// AUTO_PID_STOP: Not a bit: the whole value 0 stops the tuning.
  stop = 0x00,
  /// AUTO_PID_CFG_ROLL: Tune roll.
  roll = 0x01,
  /// AUTO_PID_CFG_PITCH: Tune pitch.
  pitch = 0x02,
  /// AUTO_PID_CFG_YAW: Tune yaw.
  yaw = 0x04,
  /// AUTO_PID_CFG_SEND_GUI: Report progress with CMD_AUTO_PID.
  send_gui = 0x08,
  /// AUTO_PID_CFG_KEEP_CURRENT: Start from the current gains.
  keep_current = 0x10,
  /// AUTO_PID_CFG_TUNE_LPF_FREQ: Tune the low-pass filter as well.
  tune_lpf_freq = 0x20,
  /// AUTO_PID_CFG_ALL_PROFILES: Store the result in all profiles.
  all_profiles = 0x40,
};
using AutoPidFlags = Flags<AutoPidFlag>;

/// Calibrated directions of the accelerometer.
/// Source: Variables L1239.
enum class CalibratedLimit : std::uint8_t {
  /// Limit +X.
  plus_x = 0x01,
  /// Limit -X.
  minus_x = 0x02,
  /// Limit +Y.
  plus_y = 0x04,
  /// Limit -Y.
  minus_y = 0x08,
  /// Limit +Z.
  plus_z = 0x10,
  /// Limit -Z.
  minus_z = 0x20,
};
using CalibratedLimits = Flags<CalibratedLimit>;

/// Operation of CMD_AHRS_HELPER. Without SET it is a query, in which only FRAME_IMU matters.
/// Source: Variables L1193-L1195.
enum class AhrsHelperModeBit : std::uint8_t {
  /// Set the attitude instead of querying it.
  set = 0x01,
  /// The frame IMU instead of the main one.
  frame_imu = 0x02,
  /// Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it.
  reference_only = 0x04,
  /// Translate between camera and frame and use the result as a reference; requires known motor
  /// angles.
  translate = 0x08,
  /// Use Z1_VECTOR only.
  z1_only = 0x10,
  /// Use H1_VECTOR only.
  h1_only = 0x20,
};
using AhrsHelperMode = Flags<AhrsHelperModeBit>;

/// Operation of the forms of CMD_AHRS_HELPER with a two-byte mode. Without SET they are queries.
/// Source: Later firmware.
enum class AhrsHelperWideModeBit : std::uint16_t {
  /// Set the attitude instead of querying it.
  set = 0x0001,
  /// The frame IMU instead of the main one.
  frame_imu = 0x0002,
  /// Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it.
  reference_only = 0x0004,
  /// Translate between camera and frame and use the result as a reference; requires known motor
  /// angles.
  translate = 0x0008,
  /// Use Z1_VECTOR only.
  z1_only = 0x0010,
  /// Use H1_VECTOR only.
  h1_only = 0x0020,
  /// Translate Z1_VECTOR only.
  translate_z1_only = 0x0040,
  /// Translate H1_VECTOR only.
  translate_h1_only = 0x0080,
  /// Turn the correction off. Since firmware 2.70b1.
  disable_correction = 0x0400,
};
using AhrsHelperWideMode = Flags<AhrsHelperWideModeBit>;

/// Sounds of CMD_BEEP_SOUND.
/// Source: Variables L1223.
enum class BeepMode : std::uint16_t {
  /// BEEPER_MODE_CALIBRATE: The calibration sound.
  calibrate = 0x0001,
  /// BEEPER_MODE_CONFIRM: The confirmation sound.
  confirm = 0x0002,
  /// BEEPER_MODE_ERROR: The error sound.
  error = 0x0004,
  /// BEEPER_MODE_CLICK: A click.
  click = 0x0010,
  /// BEEPER_MODE_COMPLETE: The completion sound.
  complete = 0x0020,
  /// BEEPER_MODE_INTRO: The start-up sound.
  intro = 0x0040,
  /// BEEPER_MODE_CUSTOM_MELODY: The notes of this message.
  custom_melody = 0x8000,
};
using BeepModes = Flags<BeepMode>;

/// Properties of a debug variable.
/// Source: Variables L1188.
enum class DebugVarFlag : std::uint8_t {
  /// VAR_FLAG_ANGLE14: An angle, 16384 counts per turn.
  angle14 = 0x40,
};
using DebugVarFlags = Flags<DebugVarFlag>;

/// Hardware version as a two-digit decimal number: 31 is 3.1.
/// Source: Variables L1006.
class BoardVersion {
 public:
  using raw_type = std::uint8_t;

  constexpr BoardVersion() = default;
  constexpr explicit BoardVersion(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Major version.
  constexpr raw_type major() const noexcept {
    return static_cast<raw_type>(raw_ / 10);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_major(unsigned value) noexcept {
    return set_digits(major(), value, 10, 0);
  }

  /// Minor version.
  constexpr raw_type minor() const noexcept {
    return static_cast<raw_type>(raw_ % 10);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_minor(unsigned value) noexcept {
    return set_digits(minor(), value, 1, 10);
  }

  friend constexpr bool operator==(const BoardVersion&, const BoardVersion&) = default;
  friend constexpr auto operator<=>(const BoardVersion&, const BoardVersion&) = default;

 private:
  constexpr bool set_digits(unsigned old, unsigned value, unsigned divide, unsigned modulo) noexcept {
    const std::uint64_t raw = raw_ + (std::uint64_t{value} - old) * divide;
    if ((modulo != 0 && value >= modulo) || raw > raw_type(-1)) return false;
    raw_ = static_cast<raw_type>(raw);
    return true;
  }

  raw_type raw_{};
};

/// Firmware version as a decimal number: 2439 is 2.43b9.
/// Source: Variables L1007.
class FirmwareVersion {
 public:
  using raw_type = std::uint16_t;

  constexpr FirmwareVersion() = default;
  constexpr explicit FirmwareVersion(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Major version.
  constexpr raw_type major() const noexcept {
    return static_cast<raw_type>(raw_ / 1000);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_major(unsigned value) noexcept {
    return set_digits(major(), value, 1000, 0);
  }

  /// Minor version.
  constexpr raw_type minor() const noexcept {
    return static_cast<raw_type>(raw_ / 10 % 100);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_minor(unsigned value) noexcept {
    return set_digits(minor(), value, 10, 100);
  }

  /// Beta version; 0 is a release.
  constexpr raw_type beta() const noexcept {
    return static_cast<raw_type>(raw_ % 10);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_beta(unsigned value) noexcept {
    return set_digits(beta(), value, 1, 10);
  }

  friend constexpr bool operator==(const FirmwareVersion&, const FirmwareVersion&) = default;
  friend constexpr auto operator<=>(const FirmwareVersion&, const FirmwareVersion&) = default;

 private:
  constexpr bool set_digits(unsigned old, unsigned value, unsigned divide, unsigned modulo) noexcept {
    const std::uint64_t raw = raw_ + (std::uint64_t{value} - old) * divide;
    if ((modulo != 0 && value >= modulo) || raw > raw_type(-1)) return false;
    raw_ = static_cast<raw_type>(raw);
    return true;
  }

  raw_type raw_{};
};

/// How an RC signal controls an axis.
/// Source: Variables L1022.
class RcMode {
 public:
  using raw_type = std::uint8_t;

  constexpr RcMode() = default;
  constexpr explicit RcMode(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `mode` converts to the whole, with 0 in the other parts.
  using enum RcModeKind;
  constexpr RcMode(RcModeKind value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x07U)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// What the signal controls.
  constexpr RcModeKind mode() const noexcept {
    return static_cast<RcModeKind>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_mode(RcModeKind value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// The signal is inverted.
  constexpr bool inverted() const noexcept { return (raw_ & 0x08) != 0; }
  constexpr RcMode& set_inverted(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x08U : raw_ & ~0x08U);
    return *this;
  }

  friend constexpr bool operator==(const RcMode&, const RcMode&) = default;
  friend constexpr auto operator<=>(const RcMode&, const RcMode&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Source of an RC signal.
/// Source: Variables L1036-L1038.
class RcMap {
 public:
  using raw_type = std::uint8_t;

  constexpr RcMap() = default;
  constexpr explicit RcMap(raw_type raw) noexcept : raw_(raw) {}
  /// Named values of the whole integer.
  using enum RcInput;
  constexpr RcMap(RcInput value) noexcept : raw_(static_cast<raw_type>(value)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }
  /// Returns the whole integer as an enum value, which may be unnamed.
  constexpr RcInput named() const noexcept { return static_cast<RcInput>(raw_); }

  /// Number of the input or virtual channel.
  constexpr raw_type channel() const noexcept {
    return static_cast<raw_type>(raw_ & 0x1F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_channel(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x1F, 0);
  }

  /// Kind of signal.
  constexpr RcSource source() const noexcept {
    return static_cast<RcSource>(raw_ & 0xE0);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_source(RcSource value) noexcept {
    return set(static_cast<raw_type>(value), 0xE0, 0);
  }

  friend constexpr bool operator==(const RcMap&, const RcMap&) = default;
  friend constexpr auto operator<=>(const RcMap&, const RcMap&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Share of the flight controller's signal in an RC channel.
/// Source: Variables L1039.
class RcMix {
 public:
  using raw_type = std::uint8_t;

  constexpr RcMix() = default;
  constexpr explicit RcMix(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// 0 is RC only, 32 half and half, 63 the flight controller only.
  constexpr raw_type rate() const noexcept {
    return static_cast<raw_type>(raw_ & 0x3F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_rate(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x3F, 0);
  }

  /// Target channel of the mix.
  constexpr MixTarget target() const noexcept {
    return static_cast<MixTarget>((raw_ & 0xC0) >> 6);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_target(MixTarget value) noexcept {
    return set(static_cast<raw_type>(value), 0xC0, 6);
  }

  friend constexpr bool operator==(const RcMix&, const RcMix&) = default;
  friend constexpr auto operator<=>(const RcMix&, const RcMix&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Kind and options of an encoder.
/// Source: Variables L1100.
class EncoderType {
 public:
  using raw_type = std::uint8_t;

  constexpr EncoderType() = default;
  constexpr explicit EncoderType(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `model` converts to the whole, with 0 in the other parts.
  using enum EncoderModel;
  constexpr EncoderType(EncoderModel value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x0FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Kind of encoder.
  constexpr EncoderModel model() const noexcept {
    return static_cast<EncoderModel>(raw_ & 0x0F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_model(EncoderModel value) noexcept {
    return set(static_cast<raw_type>(value), 0x0F, 0);
  }

  /// Options.
  constexpr EncoderFlags flags() const noexcept {
    return static_cast<EncoderFlags>(raw_ & 0xF0);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(EncoderFlags value) noexcept {
    return set(value.raw(), 0xF0, 0);
  }

  friend constexpr bool operator==(const EncoderType&, const EncoderType&) = default;
  friend constexpr auto operator<=>(const EncoderType&, const EncoderType&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Control mode and options, for one axis or for all.
/// Source: Variables L1148.
class ControlMode {
 public:
  using raw_type = std::uint8_t;

  constexpr ControlMode() = default;
  constexpr explicit ControlMode(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `mode` converts to the whole, with 0 in the other parts.
  using enum ControlModeKind;
  constexpr ControlMode(ControlModeKind value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x0FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Meaning of speed and angle.
  constexpr ControlModeKind mode() const noexcept {
    return static_cast<ControlModeKind>(raw_ & 0x0F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_mode(ControlModeKind value) noexcept {
    return set(static_cast<raw_type>(value), 0x0F, 0);
  }

  /// Options.
  constexpr ControlFlags flags() const noexcept {
    return static_cast<ControlFlags>(raw_ & 0xF0);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(ControlFlags value) noexcept {
    return set(value.raw(), 0xF0, 0);
  }

  friend constexpr bool operator==(const ControlMode&, const ControlMode&) = default;
  friend constexpr auto operator<=>(const ControlMode&, const ControlMode&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// A device on one of the I2C buses.
/// Source: Outgoing commands L828-L830.
class I2cDevice {
 public:
  using raw_type = std::uint8_t;

  constexpr I2cDevice() = default;
  constexpr explicit I2cDevice(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Bus of the device.
  constexpr I2cPort port() const noexcept {
    return static_cast<I2cPort>(raw_ & 0x01);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_port(I2cPort value) noexcept {
    return set(static_cast<raw_type>(value), 0x01, 0);
  }

  /// 7-bit address of the device.
  constexpr raw_type address() const noexcept {
    return static_cast<raw_type>((raw_ & 0xFE) >> 1);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_address(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0xFE, 1);
  }

  friend constexpr bool operator==(const I2cDevice&, const I2cDevice&) = default;
  friend constexpr auto operator<=>(const I2cDevice&, const I2cDevice&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Type, axis and properties of a debug variable.
/// Source: Variables L1188.
class DebugVarType {
 public:
  using raw_type = std::uint8_t;

  constexpr DebugVarType() = default;
  constexpr explicit DebugVarType(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `kind` converts to the whole, with 0 in the other parts.
  using enum DebugVarKind;
  constexpr DebugVarType(DebugVarKind value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x0FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Type of each value.
  constexpr DebugVarKind kind() const noexcept {
    return static_cast<DebugVarKind>(raw_ & 0x0F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_kind(DebugVarKind value) noexcept {
    return set(static_cast<raw_type>(value), 0x0F, 0);
  }

  /// Axis of the variable.
  constexpr DebugVarAxis axis() const noexcept {
    return static_cast<DebugVarAxis>(raw_ & 0x30);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_axis(DebugVarAxis value) noexcept {
    return set(static_cast<raw_type>(value), 0x30, 0);
  }

  /// Properties of the variable.
  constexpr DebugVarFlags flags() const noexcept {
    return static_cast<DebugVarFlags>(raw_ & 0xC0);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(DebugVarFlags value) noexcept {
    return set(value.raw(), 0xC0, 0);
  }

  friend constexpr bool operator==(const DebugVarType&, const DebugVarType&) = default;
  friend constexpr auto operator<=>(const DebugVarType&, const DebugVarType&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

}  // namespace sbgc::msg

namespace sbgc {

/// The types of the versions in an Availability, which define their text.
struct VersionTypes {
  using Firmware = msg::FirmwareVersion;
  using Board = msg::BoardVersion;
};

template <>
inline constexpr bool is_flag<msg::BoardFeature> = true;
template <>
inline constexpr bool is_flag<msg::ConnectionFlag> = true;
template <>
inline constexpr bool is_flag<msg::ResetOption> = true;
template <>
inline constexpr bool is_flag<msg::FilterSwitch> = true;
template <>
inline constexpr bool is_flag<msg::EncoderFlag> = true;
template <>
inline constexpr bool is_flag<msg::BeeperMode> = true;
template <>
inline constexpr bool is_flag<msg::AdaptivePidAxis> = true;
template <>
inline constexpr bool is_flag<msg::GeneralFlag> = true;
template <>
inline constexpr bool is_flag<msg::ProfileFlag> = true;
template <>
inline constexpr bool is_flag<msg::SystemError> = true;
template <>
inline constexpr bool is_flag<msg::OtherFlag> = true;
template <>
inline constexpr bool is_flag<msg::RealtimeDataCustomFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlFlag> = true;
template <>
inline constexpr bool is_flag<msg::AutoPidFlag> = true;
template <>
inline constexpr bool is_flag<msg::CalibratedLimit> = true;
template <>
inline constexpr bool is_flag<msg::AhrsHelperModeBit> = true;
template <>
inline constexpr bool is_flag<msg::AhrsHelperWideModeBit> = true;
template <>
inline constexpr bool is_flag<msg::BeepMode> = true;
template <>
inline constexpr bool is_flag<msg::DebugVarFlag> = true;

}  // namespace sbgc
