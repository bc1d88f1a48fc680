// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Enums, flag sets and packed values of the protocol. Unnamed values are preserved. The names are
/// in <sbgc/meta/enums.hpp>.
#pragma once

#include <compare>
#include <cstdint>

#include <sbgc/detail/part.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/number.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::operator|;

/// The commands of messages to the board.
/// Source: Command ID definitions L75-L154.
enum class CommandToBoard : std::uint8_t {
  board_info_3 = 20,  ///< CMD_BOARD_INFO_3: Serial numbers, memory and scripts of the board.
  read_params_3 = 21,  ///< CMD_READ_PARAMS_3: Parameters of one profile and general parameters.
  /// CMD_WRITE_PARAMS_3: Store the parameters of one profile and the general parameters.
  write_params_3 = 22,
  realtime_data_3 = 23,  ///< CMD_REALTIME_DATA_3: Live data.
  /// CMD_SELECT_IMU_3: Select the IMU to configure and calibrate; ignored if it is not connected.
  select_imu_3 = 24,
  /// CMD_REALTIME_DATA_4: Live data with joint angles, currents and temperatures.
  realtime_data_4 = 25,
  /// CMD_ENCODERS_CALIB_OFFSET_4: Calibrate the offsets of the encoders.
  encoders_calib_offset_4 = 26,
  /// CMD_ENCODERS_CALIB_FLD_OFFSET_4: Calibrate the offsets between encoders and the motors'
  /// magnetic fields.
  encoders_calib_fld_offset_4 = 27,
  read_profile_names = 28,  ///< CMD_READ_PROFILE_NAMES: Profile names.
  write_profile_names = 29,  ///< CMD_WRITE_PROFILE_NAMES: Store the profile names.
  /// CMD_QUEUE_PARAMS_INFO_3: Undocumented; possibly describes the adjustable variables, the
  /// purpose of CMD_GET_PARAMS_3.
  queue_params_info_3 = 30,
  set_adj_vars_val = 31,  ///< CMD_SET_ADJ_VARS_VAL: Values of adjustable variables.
  /// CMD_SAVE_PARAMS_3: Save the parameters in use, with all changes to adjustable variables, to
  /// the active profile.
  save_params_3 = 32,
  /// CMD_READ_PARAMS_EXT: More parameters of one profile: filters, encoders, magnetometer.
  read_params_ext = 33,
  write_params_ext = 34,  ///< CMD_WRITE_PARAMS_EXT: Store more parameters of one profile.
  auto_pid = 35,  ///< CMD_AUTO_PID: Tune the PID controllers automatically.
  servo_out = 36,  ///< CMD_SERVO_OUT: Send PWM signals to servos.
  bode_test_start_stop = 37,  ///< CMD_BODE_TEST_START_STOP: Record a frequency response.
  i2c_write_reg_buf = 39,  ///< CMD_I2C_WRITE_REG_BUF: Write to a device on an I2C bus.
  i2c_read_reg_buf = 40,  ///< CMD_I2C_READ_REG_BUF: Data from a device on an I2C bus.
  write_external_data = 41,  ///< CMD_WRITE_EXTERNAL_DATA: Store user data in the EEPROM.
  read_external_data = 42,  ///< CMD_READ_EXTERNAL_DATA: User data in the EEPROM.
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
  eeprom_write = 47,  ///< CMD_EEPROM_WRITE: Write a block to the EEPROM.
  eeprom_read = 48,  ///< CMD_EEPROM_READ: A block of the EEPROM.
  calib_info = 49,  ///< CMD_CALIB_INFO: Calibration status for display.
  sign_message = 50,  ///< CMD_SIGN_MESSAGE: Signature of a message.
  sign_message_3 [[deprecated("use sign_message")]] = sign_message,
  boot_mode_3 = 51,  ///< CMD_BOOT_MODE_3: Enter the bootloader to load new firmware.
  system_state = 52,  ///< CMD_SYSTEM_STATE: Undocumented; by its name, the state of the system.
  read_file = 53,  ///< CMD_READ_FILE: Part of a file.
  write_file = 54,  ///< CMD_WRITE_FILE: Write part of a file; without data, delete it.
  fs_clear_all = 55,  ///< CMD_FS_CLEAR_ALL: Delete all files.
  ahrs_helper = 56,  ///< CMD_AHRS_HELPER: Attitude of an IMU as two unit vectors.
  run_script = 57,  ///< CMD_RUN_SCRIPT: Start or stop a script.
  calib_mag = 59,  ///< CMD_CALIB_MAG: Calibrate the magnetometer.
  /// CMD_UART_BYPASS: Undocumented; by its name, connects two serial ports of the board.
  uart_bypass = 60,
  get_angles_ext = 61,  ///< CMD_GET_ANGLES_EXT: Camera angles, targets and joint angles.
  read_params_ext2 = 62,  ///< CMD_READ_PARAMS_EXT2: The third set of parameters of one profile.
  /// CMD_WRITE_PARAMS_EXT2: Store the third set of parameters of one profile.
  write_params_ext2 = 63,
  get_adj_vars_val = 64,  ///< CMD_GET_ADJ_VARS_VAL: Request the values of adjustable variables.
  calib_acc = 65,  ///< CMD_CALIB_ACC: Calibrate an accelerometer.
  calib_bat = 66,  ///< CMD_CALIB_BAT: Calibrate the battery voltage measurement.
  control = 67,  ///< CMD_CONTROL: Move the camera.
  realtime_data = 68,  ///< CMD_REALTIME_DATA: Live data.
  /// CMD_EXECUTE_MENU: Execute a menu action, as the menu button or the RC command channel does.
  execute_menu = 69,
  use_defaults = 70,  ///< CMD_USE_DEFAULTS: Restore the factory defaults.
  /// CMD_CALIB_EXT_GAIN: Calibrate the gains of a flight controller's signals.
  calib_ext_gain = 71,
  /// CMD_HELPER_DATA: Motion of the frame from an external system; improves stabilization.
  helper_data = 72,
  get_angles = 73,  ///< CMD_GET_ANGLES: Camera angles and targets.
  /// CMD_CALIB_MOTOR_MAG_LINK: Undocumented; by its name, calibrates the magnetic linkage of the
  /// motors.
  calib_motor_mag_link = 74,
  /// CMD_GYRO_CORRECTION: Correct the zero of a gyroscope manually; the camera drifts if the
  /// correction is wrong.
  gyro_correction = 75,
  module_list = 76,  ///< CMD_MODULE_LIST: Modules connected to the board.
  motors_on = 77,  ///< CMD_MOTORS_ON: Turn the motors on.
  module_flash_start = 78,  ///< CMD_MODULE_FLASH_START: Begin to load new firmware into a module.
  calib_offset = 79,  ///< CMD_CALIB_OFFSET: Calibrate the follow mode offset.
  calib_poles = 80,  ///< CMD_CALIB_POLES: Detect the poles and the direction of the motors.
  module_flash_write = 81,  ///< CMD_MODULE_FLASH_WRITE: Load a part of new firmware into a module.
  read_params = 82,  ///< CMD_READ_PARAMS: Older id of CMD_READ_PARAMS_3.
  /// CMD_MODULE_FLASH_FINISH: End the loading of firmware into a module.
  module_flash_finish = 83,
  trigger_pin = 84,  ///< CMD_TRIGGER_PIN: Switch an output pin.
  /// CMD_DATA_STREAM_INTERVAL: Start, change or end a data stream: messages that the board sends at
  /// a fixed rate.
  data_stream_interval = 85,
  board_info = 86,  ///< CMD_BOARD_INFO: Board version and features.
  write_params = 87,  ///< CMD_WRITE_PARAMS: Older id of CMD_WRITE_PARAMS_3.
  realtime_data_custom = 88,  ///< CMD_REALTIME_DATA_CUSTOM: Live data of the requested blocks.
  beep_sound = 89,  ///< CMD_BEEP_SOUND: Play a melody through the motors, or a standard sound.
  control_config = 90,  ///< CMD_CONTROL_CONFIG: Configure serial control until the next start.
  calib_orient_corr = 91,  ///< CMD_CALIB_ORIENT_CORR: Calibrate the orientation of the IMU.
  /// CMD_COGGING_CALIB_INFO: Undocumented; by its name, the state of the calibration of the
  /// cogging.
  cogging_calib_info = 92,
  /// CMD_CALIB_COGGING: Calibrate the cogging of the motors, or delete this calibration.
  calib_cogging = 93,
  /// CMD_CALIB_ACC_EXT_REF: Calibrate the accelerometer with an external reference.
  calib_acc_ext_ref = 94,
  profile_set = 95,  ///< CMD_PROFILE_SET: Save, clear or load a profile set.
  can_device_scan = 96,  ///< CMD_CAN_DEVICE_SCAN: Devices on the CAN bus.
  /// CMD_CAN_DRV_HARD_PARAMS: Undocumented; by its name, hardware parameters of a CAN motor driver.
  can_drv_hard_params = 97,
  /// CMD_CAN_DRV_STATE: Undocumented; by its name, the state of a CAN motor driver.
  can_drv_state = 98,
  /// CMD_CAN_DRV_CALIBRATE: Undocumented; by its name, calibrates a CAN motor driver.
  can_drv_calibrate = 99,
  read_rc_inputs = 100,  ///< CMD_READ_RC_INPUTS: RC signals of selected inputs.
  /// CMD_REALTIME_DATA_CAN_DRV: Undocumented; by its name, live data of a CAN motor driver.
  realtime_data_can_drv = 101,
  calib_gyro = 103,  ///< CMD_CALIB_GYRO: Calibrate a gyroscope.
  read_params_ext3 = 104,  ///< CMD_READ_PARAMS_EXT3: The fourth set of parameters of one profile.
  /// CMD_WRITE_PARAMS_EXT3: Store the fourth set of parameters of one profile.
  write_params_ext3 = 105,
  /// CMD_EXT_IMU_DEBUG_INFO: State of the attitude estimation and of the external IMU.
  ext_imu_debug_info = 106,
  /// CMD_SET_DEVICE_ADDR: Undocumented; by its name, sets the address of a device.
  set_device_addr = 107,
  auto_pid2 = 108,  ///< CMD_AUTO_PID2: Tune the PID controllers automatically, in later firmware.
  motors_off = 109,  ///< CMD_MOTORS_OFF: Turn the motors off.
  ext_imu_cmd = 110,  ///< CMD_EXT_IMU_CMD: A command of the external IMU's own protocol.
  read_state_vars = 111,  ///< CMD_READ_STATE_VARS: Statistics of the board's whole life.
  /// CMD_WRITE_STATE_VARS: Store the statistics of the board's whole life.
  write_state_vars = 112,
  /// CMD_SERIAL_PROXY: Undocumented; by its name, passes data on to a serial port.
  serial_proxy = 113,
  reset = 114,  ///< CMD_RESET: The board restarts.
  /// CMD_IMU_ADVANCED_CALIB: Undocumented; by its name, calibrates an IMU in an advanced way.
  imu_advanced_calib = 115,
  /// CMD_API_VIRT_CH_HIGH_RES: Set the host's virtual RC channels in high resolution; they can
  /// control the camera and more.
  api_virt_ch_high_res = 116,
  /// CMD_CALIB_ENCODER_LUT: Undocumented; by its name, calibrates the correction table of an
  /// encoder.
  calib_encoder_lut = 117,
  /// CMD_CALIB_ENCODER_LUT_RES: Undocumented; by its name, the result of the calibration of an
  /// encoder's correction table.
  calib_encoder_lut_res = 118,
  /// CMD_WRITE_PARAMS_SET: Begin or end a series of commands that store parameters.
  write_params_set = 119,
  /// CMD_CALIB_CUR_SENS: Undocumented; by its name, calibrates the current sensors.
  calib_cur_sens = 120,
  control_ext = 121,  ///< CMD_CONTROL_EXT: Move the camera, with the data that each axis needs.
  /// CMD_ENC_INT_CALIB: Undocumented; by its name, calibrates an encoder internally.
  enc_int_calib = 122,
  /// CMD_SYNC_MOTORS: Power one motor as a synchronous motor for some time, then turn the motors
  /// off.
  sync_motors = 123,
  /// CMD_EXT_LICENSE_INFO: Undocumented; by its name, information about extended licenses.
  ext_license_info = 124,
  /// CMD_VIBRATION_TEST_START_STOP: Undocumented; by its name, starts or stops a vibration test.
  vibration_test_start_stop = 125,
  /// CMD_VIBRATION_TEST_DATA: Undocumented; by its name, data of a vibration test.
  vibration_test_data = 126,
  /// CMD_EXT_MOTORS_ACTION: Turn external motors on or off, or move them to their home position.
  ext_motors_action = 128,
  ext_motors_control = 129,  ///< CMD_EXT_MOTORS_CONTROL: Set targets of external motors.
  ext_motors_control_config = 130,  ///< CMD_EXT_MOTORS_CONTROL_CONFIG: Configure external motors.
  ext_motors_state = 131,  ///< CMD_EXT_MOTORS_STATE: State of an external motor.
  adj_vars_info = 132,  ///< CMD_ADJ_VARS_INFO: Names, ranges and values of adjustable variables.
  /// CMD_SERVO_OUT_EXT: Send PWM signals to servos of the board and of its CAN motor drivers.
  servo_out_ext = 133,
  /// CMD_SET_ADJ_VARS_VAL_F: Values of adjustable variables in floating point.
  set_adj_vars_val_f = 134,
  /// CMD_GET_ADJ_VARS_VAL_F: Request the values of adjustable variables in floating point.
  get_adj_vars_val_f = 135,
  pass_protect_read = 136,  ///< CMD_PASS_PROTECT_READ: What a password protects.
  pass_protect_write = 137,  ///< CMD_PASS_PROTECT_WRITE: Choose what a password protects.
  /// CMD_REALTIME_DATA_CUSTOM2: More live data of the requested blocks.
  realtime_data_custom2 = 139,
  control_quat = 140,  ///< CMD_CONTROL_QUAT: Move the camera, with attitude and speed in space.
  control_quat_status = 141,  ///< CMD_CONTROL_QUAT_STATUS: State of the control with quaternions.
  control_quat_config = 142,  ///< CMD_CONTROL_QUAT_CONFIG: Configure the control with quaternions.
  set_transp_proxy = 143,  ///< CMD_SET_TRANSP_PROXY: Connect two serial ports of the board.
  udrv_device_scan = 144,  ///< CMD_UDRV_DEVICE_SCAN: Devices on the bus of uDrv modules.
  ext_sens_cmd = 150,  ///< CMD_EXT_SENS_CMD: A message of an external sensor's own protocol.
  /// CMD_TRANSPARENT_SAPI: Data from a serial port of a device on the CAN bus.
  transparent_sapi = 151,
  set_debug_port = 249,  ///< CMD_SET_DEBUG_PORT: Copy of a message on another port of the board.
  /// CMD_MAVLINK_INFO: Undocumented; by its name, information about a MAVLink connection.
  mavlink_info = 250,
  /// CMD_MAVLINK_DEBUG: Undocumented; by its name, debugging of a MAVLink connection.
  mavlink_debug = 251,
  /// CMD_DEBUG_VARS_INFO_3: Names and types of the debug variables, in the order of
  /// CMD_DEBUG_VARS_3.
  debug_vars_info_3 = 253,
  debug_vars_3 = 254,  ///< CMD_DEBUG_VARS_3: Values of the debug variables.
};

/// The commands of messages from the board.
/// Source: Command ID definitions L75-L154.
enum class CommandFromBoard : std::uint8_t {
  board_info_3 = 20,  ///< CMD_BOARD_INFO_3: Serial numbers, memory and scripts of the board.
  read_params_3 = 21,  ///< CMD_READ_PARAMS_3: Parameters of one profile and general parameters.
  realtime_data_3 = 23,  ///< CMD_REALTIME_DATA_3: Live data.
  /// CMD_REALTIME_DATA_4: Live data with joint angles, currents and temperatures.
  realtime_data_4 = 25,
  read_profile_names = 28,  ///< CMD_READ_PROFILE_NAMES: Profile names.
  /// CMD_QUEUE_PARAMS_INFO_3: Undocumented; possibly describes the adjustable variables, the
  /// purpose of CMD_GET_PARAMS_3.
  queue_params_info_3 = 30,
  set_adj_vars_val = 31,  ///< CMD_SET_ADJ_VARS_VAL: Values of adjustable variables.
  /// CMD_READ_PARAMS_EXT: More parameters of one profile: filters, encoders, magnetometer.
  read_params_ext = 33,
  auto_pid = 35,  ///< CMD_AUTO_PID: Tune the PID controllers automatically.
  bode_test_start_stop = 37,  ///< CMD_BODE_TEST_START_STOP: Record a frequency response.
  bode_test_data = 38,  ///< CMD_BODE_TEST_DATA: Samples of a frequency response.
  i2c_read_reg_buf = 40,  ///< CMD_I2C_READ_REG_BUF: Data from a device on an I2C bus.
  read_external_data = 42,  ///< CMD_READ_EXTERNAL_DATA: User data in the EEPROM.
  /// CMD_READ_ADJ_VARS_CFG: RC signals that trigger actions or change adjustable variables.
  read_adj_vars_cfg = 43,
  /// CMD_ADJ_VARS_STATE: Current state of one trigger slot and one analog slot.
  adj_vars_state = 46,
  eeprom_read = 48,  ///< CMD_EEPROM_READ: A block of the EEPROM.
  calib_info = 49,  ///< CMD_CALIB_INFO: Calibration status for display.
  sign_message = 50,  ///< CMD_SIGN_MESSAGE: Signature of a message.
  sign_message_3 [[deprecated("use sign_message")]] = sign_message,
  system_state = 52,  ///< CMD_SYSTEM_STATE: Undocumented; by its name, the state of the system.
  read_file = 53,  ///< CMD_READ_FILE: Part of a file.
  ahrs_helper = 56,  ///< CMD_AHRS_HELPER: Attitude of an IMU as two unit vectors.
  script_debug = 58,  ///< CMD_SCRIPT_DEBUG: Progress of a script started with debugging.
  /// CMD_UART_BYPASS: Undocumented; by its name, connects two serial ports of the board.
  uart_bypass = 60,
  get_angles_ext = 61,  ///< CMD_GET_ANGLES_EXT: Camera angles, targets and joint angles.
  read_params_ext2 = 62,  ///< CMD_READ_PARAMS_EXT2: The third set of parameters of one profile.
  confirm = 67,  ///< CMD_CONFIRM: The board executed a command.
  get_angles = 73,  ///< CMD_GET_ANGLES: Camera angles and targets.
  /// CMD_CALIB_MOTOR_MAG_LINK: Undocumented; by its name, calibrates the magnetic linkage of the
  /// motors.
  calib_motor_mag_link = 74,
  module_list = 76,  ///< CMD_MODULE_LIST: Modules connected to the board.
  read_params = 82,  ///< CMD_READ_PARAMS: Older id of CMD_READ_PARAMS_3.
  board_info = 86,  ///< CMD_BOARD_INFO: Board version and features.
  realtime_data_custom = 88,  ///< CMD_REALTIME_DATA_CUSTOM: Live data of the requested blocks.
  /// CMD_COGGING_CALIB_INFO: Undocumented; by its name, the state of the calibration of the
  /// cogging.
  cogging_calib_info = 92,
  can_device_scan = 96,  ///< CMD_CAN_DEVICE_SCAN: Devices on the CAN bus.
  /// CMD_CAN_DRV_HARD_PARAMS: Undocumented; by its name, hardware parameters of a CAN motor driver.
  can_drv_hard_params = 97,
  /// CMD_CAN_DRV_STATE: Undocumented; by its name, the state of a CAN motor driver.
  can_drv_state = 98,
  /// CMD_CAN_DRV_CALIBRATE: Undocumented; by its name, calibrates a CAN motor driver.
  can_drv_calibrate = 99,
  read_rc_inputs = 100,  ///< CMD_READ_RC_INPUTS: RC signals of selected inputs.
  /// CMD_REALTIME_DATA_CAN_DRV: Undocumented; by its name, live data of a CAN motor driver.
  realtime_data_can_drv = 101,
  /// CMD_EVENT: An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL.
  event = 102,
  read_params_ext3 = 104,  ///< CMD_READ_PARAMS_EXT3: The fourth set of parameters of one profile.
  /// CMD_EXT_IMU_DEBUG_INFO: State of the attitude estimation and of the external IMU.
  ext_imu_debug_info = 106,
  /// CMD_SET_DEVICE_ADDR: Undocumented; by its name, sets the address of a device.
  set_device_addr = 107,
  ext_imu_cmd = 110,  ///< CMD_EXT_IMU_CMD: A command of the external IMU's own protocol.
  read_state_vars = 111,  ///< CMD_READ_STATE_VARS: Statistics of the board's whole life.
  /// CMD_SERIAL_PROXY: Undocumented; by its name, passes data on to a serial port.
  serial_proxy = 113,
  reset = 114,  ///< CMD_RESET: The board restarts.
  /// CMD_IMU_ADVANCED_CALIB: Undocumented; by its name, calibrates an IMU in an advanced way.
  imu_advanced_calib = 115,
  /// CMD_CALIB_ENCODER_LUT: Undocumented; by its name, calibrates the correction table of an
  /// encoder.
  calib_encoder_lut = 117,
  /// CMD_CALIB_ENCODER_LUT_RES: Undocumented; by its name, the result of the calibration of an
  /// encoder's correction table.
  calib_encoder_lut_res = 118,
  /// CMD_CALIB_CUR_SENS: Undocumented; by its name, calibrates the current sensors.
  calib_cur_sens = 120,
  /// CMD_ENC_INT_CALIB: Undocumented; by its name, calibrates an encoder internally.
  enc_int_calib = 122,
  /// CMD_EXT_LICENSE_INFO: Undocumented; by its name, information about extended licenses.
  ext_license_info = 124,
  /// CMD_VIBRATION_TEST_START_STOP: Undocumented; by its name, starts or stops a vibration test.
  vibration_test_start_stop = 125,
  /// CMD_VIBRATION_TEST_DATA: Undocumented; by its name, data of a vibration test.
  vibration_test_data = 126,
  can_drv_telemetry = 127,  ///< CMD_CAN_DRV_TELEMETRY: Live data of a CAN motor driver.
  ext_motors_state = 131,  ///< CMD_EXT_MOTORS_STATE: State of an external motor.
  adj_vars_info = 132,  ///< CMD_ADJ_VARS_INFO: Names, ranges and values of adjustable variables.
  /// CMD_SET_ADJ_VARS_VAL_F: Values of adjustable variables in floating point.
  set_adj_vars_val_f = 134,
  pass_protect_read = 136,  ///< CMD_PASS_PROTECT_READ: What a password protects.
  /// CMD_REALTIME_DATA_CUSTOM2: More live data of the requested blocks.
  realtime_data_custom2 = 139,
  control_quat_status = 141,  ///< CMD_CONTROL_QUAT_STATUS: State of the control with quaternions.
  ext_sens_cmd = 150,  ///< CMD_EXT_SENS_CMD: A message of an external sensor's own protocol.
  /// CMD_TRANSPARENT_SAPI: Data from a serial port of a device on the CAN bus.
  transparent_sapi = 151,
  set_debug_port = 249,  ///< CMD_SET_DEBUG_PORT: Copy of a message on another port of the board.
  /// CMD_MAVLINK_INFO: Undocumented; by its name, information about a MAVLink connection.
  mavlink_info = 250,
  /// CMD_MAVLINK_DEBUG: Undocumented; by its name, debugging of a MAVLink connection.
  mavlink_debug = 251,
  /// CMD_DEBUG_VARS_INFO_3: Names and types of the debug variables, in the order of
  /// CMD_DEBUG_VARS_3.
  debug_vars_info_3 = 253,
  debug_vars_3 = 254,  ///< CMD_DEBUG_VARS_3: Values of the debug variables.
  error = 255,  ///< CMD_ERROR: The board could not execute a command.
};

/// The adjustable variables.
/// Source: Appendix B L1274-L1329.
enum class VariableId : std::uint8_t {
  p_roll = 0,  ///< P_ROLL: Proportional gain of roll.
  p_pitch = 1,  ///< P_PITCH: Proportional gain of pitch.
  p_yaw = 2,  ///< P_YAW: Proportional gain of yaw.
  i_roll = 3,  ///< I_ROLL: Integral gain of roll.
  i_pitch = 4,  ///< I_PITCH: Integral gain of pitch.
  i_yaw = 5,  ///< I_YAW: Integral gain of yaw.
  d_roll = 6,  ///< D_ROLL: Derivative gain of roll.
  d_pitch = 7,  ///< D_PITCH: Derivative gain of pitch.
  d_yaw = 8,  ///< D_YAW: Derivative gain of yaw.
  power_roll = 9,  ///< POWER_ROLL: Power of the roll motor.
  power_pitch = 10,  ///< POWER_PITCH: Power of the pitch motor.
  power_yaw = 11,  ///< POWER_YAW: Power of the yaw motor.
  acc_limiter = 12,  ///< ACC_LIMITER: Acceleration limit of all axes.
  follow_speed_roll = 13,  ///< FOLLOW_SPEED_ROLL: Follow mode speed of roll.
  follow_speed_pitch = 14,  ///< FOLLOW_SPEED_PITCH: Follow mode speed of pitch.
  follow_speed_yaw = 15,  ///< FOLLOW_SPEED_YAW: Follow mode speed of yaw.
  follow_lpf_roll = 16,  ///< FOLLOW_LPF_ROLL: Follow mode low-pass filter of roll.
  follow_lpf_pitch = 17,  ///< FOLLOW_LPF_PITCH: Follow mode low-pass filter of pitch.
  follow_lpf_yaw = 18,  ///< FOLLOW_LPF_YAW: Follow mode low-pass filter of yaw.
  rc_speed_roll = 19,  ///< RC_SPEED_ROLL: RC control speed of roll.
  rc_speed_pitch = 20,  ///< RC_SPEED_PITCH: RC control speed of pitch.
  rc_speed_yaw = 21,  ///< RC_SPEED_YAW: RC control speed of yaw.
  rc_lpf_roll = 22,  ///< RC_LPF_ROLL: RC low-pass filter of roll.
  rc_lpf_pitch = 23,  ///< RC_LPF_PITCH: RC low-pass filter of pitch.
  rc_lpf_yaw = 24,  ///< RC_LPF_YAW: RC low-pass filter of yaw.
  rc_trim_roll = 25,  ///< RC_TRIM_ROLL: RC trim of roll.
  rc_trim_pitch = 26,  ///< RC_TRIM_PITCH: RC trim of pitch.
  rc_trim_yaw = 27,  ///< RC_TRIM_YAW: RC trim of yaw.
  rc_deadband = 28,  ///< RC_DEADBAND: Dead band around the center of the RC signals.
  rc_expo_rate = 29,  ///< RC_EXPO_RATE: Expo rate of the RC signals.
  /// FOLLOW_MODE: What the camera follows: 0 nothing, 1 the flight controller, 2 pitch and roll of
  /// the frame. Later firmware calls it FOLLOW_PITCH, from 0 to 1.
  follow_mode = 30,
  /// RC_FOLLOW_YAW: 1 if yaw follows the frame, otherwise 0. Later firmware calls it
  /// RC_FOLLOW_YAW_PITCH, from 0 to 2.
  rc_follow_yaw = 31,
  follow_deadband = 32,  ///< FOLLOW_DEADBAND: Dead band of the follow mode.
  follow_expo_rate = 33,  ///< FOLLOW_EXPO_RATE: Expo rate of the follow mode.
  /// FOLLOW_ROLL_MIX_START: Angle at which pitch starts to follow roll.
  follow_roll_mix_start = 34,
  /// FOLLOW_ROLL_MIX_RANGE: Angle over which pitch continues to follow roll.
  follow_roll_mix_range = 35,
  gyro_trust = 36,  ///< GYRO_TRUST: Trust in the gyroscope relative to the accelerometer.
  /// FRAME_HEADING_ANGLE: Heading of the frame; in later firmware 32767 has a special meaning.
  frame_heading_angle = 37,
  /// GYRO_HEADING_CORRECTION: Gyroscope correction about the vertical.
  gyro_heading_correction = 38,
  acc_limiter_roll = 39,  ///< ACC_LIMITER_ROLL: Acceleration limit of roll.
  acc_limiter_pitch = 40,  ///< ACC_LIMITER_PITCH: Acceleration limit of pitch.
  acc_limiter_yaw = 41,  ///< ACC_LIMITER_YAW: Acceleration limit of yaw.
  pid_gain_roll = 42,  ///< PID_GAIN_ROLL: Factor for P, I and D of roll.
  pid_gain_pitch = 43,  ///< PID_GAIN_PITCH: Factor for P, I and D of pitch.
  pid_gain_yaw = 44,  ///< PID_GAIN_YAW: Factor for P, I and D of yaw.
  lpf_freq_roll = 45,  ///< LPF_FREQ_ROLL: Low-pass filter of roll.
  lpf_freq_pitch = 46,  ///< LPF_FREQ_PITCH: Low-pass filter of pitch.
  lpf_freq_yaw = 47,  ///< LPF_FREQ_YAW: Low-pass filter of yaw.
  timelapse_time = 48,  ///< TIMELAPSE_TIME: Duration of a time lapse. Since firmware 2.60.
  /// MAV_CTRL_MODE: What MAVLink controls: 0 nothing, 1 roll and pitch, 2 all axes. Since firmware
  /// 2.66.
  mav_ctrl_mode = 49,
  /// H_CORR_FACTOR: Strength of the heading correction. Since firmware 2.68b7.
  h_corr_factor = 50,
  /// SW_LIM_MIN_ROLL: Lowest angle of the roll joint. Since firmware 2.68b8.
  sw_lim_min_roll = 51,
  /// SW_LIM_MAX_ROLL: Highest angle of the roll joint. Since firmware 2.68b8.
  sw_lim_max_roll = 52,
  /// SW_LIM_MIN_PITCH: Lowest angle of the pitch joint. Since firmware 2.68b8.
  sw_lim_min_pitch = 53,
  /// SW_LIM_MAX_PITCH: Highest angle of the pitch joint. Since firmware 2.68b8.
  sw_lim_max_pitch = 54,
  sw_lim_min_yaw = 55,  ///< SW_LIM_MIN_YAW: Lowest angle of the yaw joint. Since firmware 2.68b8.
  sw_lim_max_yaw = 56,  ///< SW_LIM_MAX_YAW: Highest angle of the yaw joint. Since firmware 2.68b8.
  /// FOLLOW_RANGE_ROLL: Range of the follow mode of roll. Since firmware 2.68b9.
  follow_range_roll = 57,
  /// FOLLOW_RANGE_PITCH: Range of the follow mode of pitch. Since firmware 2.68b9.
  follow_range_pitch = 58,
  /// FOLLOW_RANGE_YAW: Range of the follow mode of yaw. Since firmware 2.68b9.
  follow_range_yaw = 59,
  /// AUTO_PID_TARGET: Target of the automatic PID tuning. Since firmware 2.68b9.
  auto_pid_target = 60,
  /// RC_MODE_ROLL: What the RC signal of roll controls, as in RC_MODE. Since firmware 2.69b3.
  rc_mode_roll = 61,
  /// RC_MODE_PITCH: What the RC signal of pitch controls, as in RC_MODE. Since firmware 2.69b3.
  rc_mode_pitch = 62,
  /// RC_MODE_YAW: What the RC signal of yaw controls, as in RC_MODE. Since firmware 2.69b3.
  rc_mode_yaw = 63,
  euler_order = 64,  ///< EULER_ORDER: Order of the Euler angles. Since firmware 2.69b3.
  /// FOLLOW_IN_DBAND: How much to follow inside the follow mode's dead band. Since firmware 2.70b4.
  follow_in_dband = 65,
  /// RC_LIMIT_MIN_ROLL: Angle of roll at the lowest RC signal. Since firmware 2.72.
  rc_limit_min_roll = 66,
  /// RC_LIMIT_MAX_ROLL: Angle of roll at the highest RC signal. Since firmware 2.72.
  rc_limit_max_roll = 67,
  /// RC_LIMIT_MIN_PITCH: Angle of pitch at the lowest RC signal. Since firmware 2.72.
  rc_limit_min_pitch = 68,
  /// RC_LIMIT_MAX_PITCH: Angle of pitch at the highest RC signal. Since firmware 2.72.
  rc_limit_max_pitch = 69,
  /// RC_LIMIT_MIN_YAW: Angle of yaw at the lowest RC signal. Since firmware 2.72.
  rc_limit_min_yaw = 70,
  /// RC_LIMIT_MAX_YAW: Angle of yaw at the highest RC signal. Since firmware 2.72.
  rc_limit_max_yaw = 71,
  /// RC_DEADBAND_PITCH: Dead band around the center of the RC signal of pitch. Since firmware 2.72.
  rc_deadband_pitch = 72,
  /// RC_DEADBAND_YAW: Dead band around the center of the RC signal of yaw. Since firmware 2.72.
  rc_deadband_yaw = 73,
  /// RC_EXPO_RATE_PITCH: Expo rate of the RC signal of pitch. Since firmware 2.72.
  rc_expo_rate_pitch = 74,
  /// RC_EXPO_RATE_YAW: Expo rate of the RC signal of yaw. Since firmware 2.72.
  rc_expo_rate_yaw = 75,
  /// SHAKE_AMP_ROLL: Amplitude of the shake generator in roll. Since firmware 2.73.
  shake_amp_roll = 76,
  /// SHAKE_AMP_TILT: Amplitude of the shake generator in tilt. Since firmware 2.73.
  shake_amp_tilt = 77,
  /// SHAKE_AMP_PAN: Amplitude of the shake generator in pan. Since firmware 2.73.
  shake_amp_pan = 78,
  shake_freq = 79,  ///< SHAKE_FREQ: Base frequency of the shake generator. Since firmware 2.73.
  /// SHAKE_FREQ_RANGE: Frequency range of the shake generator. Since firmware 2.73.
  shake_freq_range = 80,
  /// SHAKE_PAUSE_PERIOD: Period of the pauses of the shake generator. Since firmware 2.73.
  shake_pause_period = 81,
  /// SHAKE_PAUSE_BALANCE: Share of the pauses of the shake generator. Since firmware 2.73.
  shake_pause_balance = 82,
  /// SHAKE_PAUSE_RANDOMNESS: Randomness of the pauses of the shake generator. Since firmware 2.73.
  shake_pause_randomness = 83,
  /// SHAKE_RESONANCE_GAIN_ROLL: Gain of the shake generator's resonance in roll. Since firmware
  /// 2.73.
  shake_resonance_gain_roll = 84,
  /// SHAKE_RESONANCE_GAIN_TILT: Gain of the shake generator's resonance in tilt. Since firmware
  /// 2.73.
  shake_resonance_gain_tilt = 85,
  /// SHAKE_RESONANCE_GAIN_PAN: Gain of the shake generator's resonance in pan. Since firmware 2.73.
  shake_resonance_gain_pan = 86,
  /// SHAKE_FREQ_SHIFT_ROLL: Shift of the shake generator's frequency in roll. Since firmware 2.73.
  shake_freq_shift_roll = 87,
  /// SHAKE_FREQ_SHIFT_TILT: Shift of the shake generator's frequency in tilt. Since firmware 2.73.
  shake_freq_shift_tilt = 88,
  /// SHAKE_FREQ_SHIFT_PAN: Shift of the shake generator's frequency in pan. Since firmware 2.73.
  shake_freq_shift_pan = 89,
  /// SHAKE_MASTER_GAIN: Gain of the shake generator in all directions. Since firmware 2.73.
  shake_master_gain = 90,
  /// OUTER_P_ROLL: Proportional gain of the outer loop of roll. Since firmware 2.73.7.
  outer_p_roll = 91,
  /// OUTER_P_PITCH: Proportional gain of the outer loop of pitch. Since firmware 2.73.7.
  outer_p_pitch = 92,
  /// OUTER_P_YAW: Proportional gain of the outer loop of yaw. Since firmware 2.73.7.
  outer_p_yaw = 93,
  /// D_LPF_FREQ_ROLL: Low-pass filter of the derivative term of roll. Since firmware 2.73.7.
  d_lpf_freq_roll = 94,
  /// D_LPF_FREQ_PITCH: Low-pass filter of the derivative term of pitch. Since firmware 2.73.7.
  d_lpf_freq_pitch = 95,
  /// D_LPF_FREQ_YAW: Low-pass filter of the derivative term of yaw. Since firmware 2.73.7.
  d_lpf_freq_yaw = 96,
  /// IMU_ANGLE_CORR_ROLL: Correction of the roll angle of the IMU. Since firmware 2.73.8.
  imu_angle_corr_roll = 97,
  /// IMU_ANGLE_CORR_PITCH: Correction of the pitch angle of the IMU. Since firmware 2.73.8.
  imu_angle_corr_pitch = 98,
  /// SW_LIM_WIDTH_ROLL: Width of the soft limits of the roll joint. Since firmware 2.73.8.
  sw_lim_width_roll = 99,
  /// SW_LIM_WIDTH_PITCH: Width of the soft limits of the pitch joint. Since firmware 2.73.8.
  sw_lim_width_pitch = 100,
  /// SW_LIM_WIDTH_YAW: Width of the soft limits of the yaw joint. Since firmware 2.73.8.
  sw_lim_width_yaw = 101,
};

/// Reason that the board did not execute a command.
/// Source: Incoming commands L421-L426.
enum class BoardErrorCode : std::uint8_t {
  cmd_size = 1,  ///< The command has no body of this size.
  wrong_params = 2,  ///< A value is invalid.
  get_device_id = 3,  ///< GET_DEVICE_ID: The board cannot read its device id. Unconfirmed.
  crypto = 4,  ///< A key or signature check failed.
  /// CALIBRATE_BAT: The calibration of the battery voltage failed. Unconfirmed.
  calibrate_bat = 5,
  unknown_command = 6,  ///< The board does not know the command.
  wrong_state = 8,  ///< Not possible in the current state.
  not_supported = 9,  ///< The board lacks a feature that the command requires.
  operation_failed = 10,  ///< The board tried and failed.
  temporary = 11,  ///< Temporarily not possible; retry later.
};

/// What an RC signal controls.
/// Source: Variables L1022.
enum class RcModeKind : std::uint8_t {
  angle = 0,  ///< RC_MODE_ANGLE: The angle of the camera.
  speed = 1,  ///< RC_MODE_SPEED: The speed of the camera.
};

/// PWM frequency of the motor drivers.
/// Source: Variables L1030.
enum class PwmFrequency : std::uint8_t {
  low = 0,  ///< PWM_FREQ_LOW: Low.
  high = 1,  ///< PWM_FREQ_HIGH: High.
  ultra_high = 2,  ///< PWM_FREQ_ULTRA_HIGH: Ultra high. Since board 3.0.
};

/// Baud rate of the serial port.
/// Source: Variables L1031.
enum class SerialSpeed : std::uint8_t {
  baud_115200 = 0,  ///< 115200 baud.
  baud_57600 = 1,  ///< 57600 baud.
  baud_38400 = 2,  ///< 38400 baud.
  baud_19200 = 3,  ///< 19200 baud.
  baud_9600 = 4,  ///< 9600 baud.
  baud_256000 = 5,  ///< 256000 baud.
};

/// Returns the number that a value denotes; 0 for unknown values.
constexpr std::uint32_t number_of(SerialSpeed value) noexcept {
  switch (value) {
    case SerialSpeed::baud_115200: return 115200;
    case SerialSpeed::baud_57600: return 57600;
    case SerialSpeed::baud_38400: return 38400;
    case SerialSpeed::baud_19200: return 19200;
    case SerialSpeed::baud_9600: return 9600;
    case SerialSpeed::baud_256000: return 256000;
  }
  return 0;
}

/// Signal at the RC_ROLL input pin.
/// Source: Variables L1035.
enum class RcVirtualMode : std::uint8_t {
  normal = 0,  ///< RC_VIRT_MODE_NORMAL: One PWM signal.
  cppm = 1,  ///< RC_VIRT_MODE_CPPM: Sum-PPM.
  sbus = 2,  ///< RC_VIRT_MODE_SBUS: S.BUS. Since board 3.0.
  spektrum = 3,  ///< RC_VIRT_MODE_SPEKTRUM: Spektrum satellite. Since board 3.0.
  api = 10,  ///< RC_VIRT_MODE_API: A serial port on the pins RC_ROLL and RC_YAW. Since board 3.0.
};

/// Named inputs of RC_MAP: pins for PWM or an analog voltage.
/// Source: Variables L1036.
enum class RcInput : std::uint8_t {
  input_no = 0,  ///< INPUT_NO: No input.
  rc_input_roll = 1,  ///< RC_INPUT_ROLL: PWM at the RC_ROLL pin.
  rc_input_pitch = 2,  ///< RC_INPUT_PITCH: PWM at the RC_PITCH pin.
  ext_fc_input_roll = 3,  ///< EXT_FC_INPUT_ROLL: PWM at the FC_ROLL pin.
  ext_fc_input_pitch = 4,  ///< EXT_FC_INPUT_PITCH: PWM at the FC_PITCH pin.
  rc_input_yaw = 5,  ///< RC_INPUT_YAW: PWM at the RC_YAW pin. Since board 3.0.
  adc1 = 33,  ///< ADC1: Analog input 1; RC_INPUT_ROLL on older boards. Since board 3.0.
  adc2 = 34,  ///< ADC2: Analog input 2; RC_INPUT_PITCH on older boards. Since board 3.0.
  adc3 = 35,  ///< ADC3: Analog input 3; EXT_FC_INPUT_ROLL on older boards. Since board 3.0.
  adc4 = 36,  ///< ADC4: Analog input 4; EXT_FC_INPUT_PITCH on older boards.
  ext_fc_input_pitch_analog [[deprecated("use adc4")]] = adc4,
};

/// Kind of signal selected by RC_MAP.
/// Source: Variables L1036-L1038.
enum class RcSource : std::uint8_t {
  pwm = 0,  ///< A PWM signal.
  analog = 32,  ///< An analog voltage.
  serial = 64,  ///< A virtual channel of Sum-PPM, S.BUS or Spektrum.
  api = 128,  ///< A virtual channel that CMD_API_VIRT_CH_CONTROL sets.
  step_signal = 160,  ///< STEP_SIGNAL: A step signal, 1 to 6.
};

/// RC channel into which a flight controller's signal is mixed.
/// Source: Variables L1039.
enum class MixTarget : std::uint8_t {
  no_mix = 0,  ///< None.
  roll = 1,  ///< ROLL: Roll.
  pitch = 2,  ///< PITCH: Pitch.
  yaw = 3,  ///< YAW: Yaw.
};

/// What the camera follows.
/// Source: Variables L1040.
enum class FollowMode : std::uint8_t {
  disabled = 0,  ///< FOLLOW_MODE_DISABLED: Nothing.
  fc = 1,  ///< FOLLOW_MODE_FC: The flight controller.
  pitch = 2,  ///< FOLLOW_MODE_PITCH: Pitch and roll of the frame.
};

/// Direction of a sensor's axis.
/// Source: Variables L1046, L1104.
enum class SensorAxis : std::int8_t {
  x = 1,  ///< X: X axis.
  y = 2,  ///< Y: Y axis.
  z = 3,  ///< Z: Z axis.
  minus_x = -1,  ///< -X: Against the X axis.
  minus_y = -2,  ///< -Y: Against the Y axis.
  minus_z = -3,  ///< -Z: Against the Z axis.
};

/// Location of the frame IMU.
/// Source: Variables L1047.
enum class FrameImuPosition : std::uint8_t {
  disabled = 0,  ///< FRAME_IMU_DISABLED: There is none.
  below_yaw = 1,  ///< FRAME_IMU_BELOW_YAW: Below the yaw motor.
  above_yaw = 2,  ///< FRAME_IMU_ABOVE_YAW: Above the yaw motor.
  /// FRAME_IMU_BELOW_YAW_PID_SOURCE: Below the yaw motor, and the input of the PID controller.
  below_yaw_pid_source = 3,
};

/// Gyroscope calibration at start-up.
/// Source: Variables L1050.
enum class SkipGyroCalibration : std::uint8_t {
  do_not_skip = 0,  ///< Calibrate.
  skip_always = 1,  ///< Never calibrate.
  skip_if_moving = 2,  ///< Calibrate unless the board moves.
};

/// Actions of the menu button, an RC signal or CMD_EXECUTE_MENU.
/// Source: Variables L1051-L1053.
enum class MenuCommand : std::uint8_t {
  none = 0,  ///< MENU_CMD_NO: Nothing.
  profile1 = 1,  ///< MENU_CMD_PROFILE1: Switch to profile 1.
  profile2 = 2,  ///< MENU_CMD_PROFILE2: Switch to profile 2.
  profile3 = 3,  ///< MENU_CMD_PROFILE3: Switch to profile 3.
  swap_pitch_roll = 4,  ///< MENU_CMD_SWAP_PITCH_ROLL: Swap the RC signals of pitch and roll.
  swap_yaw_roll = 5,  ///< MENU_CMD_SWAP_YAW_ROLL: Swap the RC signals of yaw and roll.
  calib_acc = 6,  ///< MENU_CMD_CALIB_ACC: Calibrate the accelerometer.
  reset = 7,  ///< MENU_CMD_RESET: Restart the board.
  set_angle = 8,  ///< MENU_CMD_SET_ANGLE: Make the current angle the initial angle.
  calib_gyro = 9,  ///< MENU_CMD_CALIB_GYRO: Calibrate the gyroscope.
  motor_toggle = 10,  ///< MENU_CMD_MOTOR_TOGGLE: Turn the motors on or off.
  motor_on = 11,  ///< MENU_CMD_MOTOR_ON: Turn the motors on.
  motor_off = 12,  ///< MENU_CMD_MOTOR_OFF: Turn the motors off.
  frame_upside_down = 13,  ///< MENU_CMD_FRAME_UPSIDE_DOWN: Treat the frame as upside down.
  profile4 = 14,  ///< MENU_CMD_PROFILE4: Switch to profile 4.
  profile5 = 15,  ///< MENU_CMD_PROFILE5: Switch to profile 5.
  auto_pid = 16,  ///< MENU_CMD_AUTO_PID: Tune the PID controllers.
  look_down = 17,  ///< MENU_CMD_LOOK_DOWN: Point the camera downwards.
  home_position = 18,  ///< MENU_CMD_HOME_POSITION: Return the camera to its home position.
  rc_bind = 19,  ///< MENU_CMD_RC_BIND: Bind an RC receiver.
  calib_gyro_temp = 20,  ///< MENU_CMD_CALIB_GYRO_TEMP: Calibrate the gyroscope over temperature.
  calib_acc_temp = 21,  ///< MENU_CMD_CALIB_ACC_TEMP: Calibrate the accelerometer over temperature.
  button_press = 22,  ///< MENU_CMD_BUTTON_PRESS: Press the menu button.
  run_script1 = 23,  ///< MENU_CMD_RUN_SCRIPT1: Run script 1.
  run_script2 = 24,  ///< MENU_CMD_RUN_SCRIPT2: Run script 2.
  run_script3 = 25,  ///< MENU_CMD_RUN_SCRIPT3: Run script 3.
  run_script4 = 26,  ///< MENU_CMD_RUN_SCRIPT4: Run script 4.
  run_script5 = 27,  ///< MENU_CMD_RUN_SCRIPT5: Run script 5.
  run_script6 = 28,  ///< MENU_CMD_RUN_SCRIPT6: Run script 6. Unconfirmed.
  run_script7 = 29,  ///< MENU_CMD_RUN_SCRIPT7: Run script 7. Unconfirmed.
  run_script8 = 30,  ///< MENU_CMD_RUN_SCRIPT8: Run script 8. Unconfirmed.
  run_script9 = 31,  ///< MENU_CMD_RUN_SCRIPT9: Run script 9. Unconfirmed.
  run_script10 = 32,  ///< MENU_CMD_RUN_SCRIPT10: Run script 10. Unconfirmed.
  calib_mag = 33,  ///< MENU_CMD_CALIB_MAG: Calibrate the magnetometer.
  level_roll_pitch = 34,  ///< MENU_CMD_LEVEL_ROLL_PITCH: Level roll and pitch.
  center_yaw = 35,  ///< MENU_CMD_CENTER_YAW: Center yaw.
  untwist_cables = 36,  ///< MENU_CMD_UNTWIST_CABLES: Turn back to untwist the cables.
  /// MENU_CMD_SET_ANGLE_NO_SAVE: Make the current angle the initial angle, without saving it.
  set_angle_no_save = 37,
  /// MENU_CMD_HOME_POSITION_SHORTEST: Return the camera to its home position by the shortest way.
  home_position_shortest = 38,
  center_yaw_shortest = 39,  ///< MENU_CMD_CENTER_YAW_SHORTEST: Center yaw by the shortest way.
  rotate_yaw_180 = 40,  ///< MENU_CMD_ROTATE_YAW_180: Turn yaw by half a turn.
  /// MENU_CMD_ROTATE_YAW_180_FRAME_REL: Turn yaw by half a turn relative to the frame.
  rotate_yaw_180_frame_rel = 41,
  /// MENU_CMD_SWITCH_YAW_180_FRAME_REL: Switch yaw between forwards and backwards relative to the
  /// frame.
  switch_yaw_180_frame_rel = 42,
  /// MENU_CMD_SWITCH_POS_ROLL_90: Switch roll between two positions 90 degrees apart.
  switch_pos_roll_90 = 43,
  start_timelapse = 44,  ///< MENU_CMD_START_TIMELAPSE: Start a time-lapse motion.
  calib_momentum = 45,  ///< MENU_CMD_CALIB_MOMENTUM: Calibrate the momentum of the axes.
  level_roll = 46,  ///< MENU_CMD_LEVEL_ROLL: Level roll.
  repeat_timelapse = 47,  ///< MENU_CMD_REPEAT_TIMELAPSE: Repeat the time-lapse motion.
  load_profile_set1 = 48,  ///< MENU_CMD_LOAD_PROFILE_SET1: Load profile set 1.
  load_profile_set2 = 49,  ///< MENU_CMD_LOAD_PROFILE_SET2: Load profile set 2.
  load_profile_set3 = 50,  ///< MENU_CMD_LOAD_PROFILE_SET3: Load profile set 3.
  load_profile_set4 = 51,  ///< MENU_CMD_LOAD_PROFILE_SET4: Load profile set 4.
  load_profile_set5 = 52,  ///< MENU_CMD_LOAD_PROFILE_SET5: Load profile set 5.
  load_profile_set_backup = 53,  ///< MENU_CMD_LOAD_PROFILE_SET_BACKUP: Load the backup profile set.
  invert_rc_roll = 54,  ///< MENU_CMD_INVERT_RC_ROLL: Invert the RC signal of roll.
  invert_rc_pitch = 55,  ///< MENU_CMD_INVERT_RC_PITCH: Invert the RC signal of pitch.
  invert_rc_yaw = 56,  ///< MENU_CMD_INVERT_RC_YAW: Invert the RC signal of yaw.
  /// MENU_CMD_SNAP_TO_FIXED_POSITION: Move to the nearest fixed position.
  snap_to_fixed_position = 57,
  /// MENU_CMD_CAMERA_REC_PHOTO_EVENT: Send a CMD_EVENT for the camera, to record a video or take a
  /// photo.
  camera_rec_photo_event = 58,
  /// MENU_CMD_CAMERA_PHOTO_EVENT: Send a CMD_EVENT for the camera, to take a photo.
  camera_photo_event = 59,
  /// MENU_CMD_MOTORS_SAFE_STOP: Stop the motors safely, then turn them off.
  motors_safe_stop = 60,
  calib_acc_auto = 61,  ///< MENU_CMD_CALIB_ACC_AUTO: Calibrate the accelerometer automatically.
  reset_imu = 62,  ///< MENU_CMD_RESET_IMU: Reset the IMU.
  /// MENU_CMD_FORCED_FOLLOW_TOGGLE: Turn the forced follow mode on or off.
  forced_follow_toggle = 63,
  /// MENU_CMD_AUTO_PID_GAIN_ONLY: Tune the PID controllers, but only their gain.
  auto_pid_gain_only = 64,
  level_pitch = 65,  ///< MENU_CMD_LEVEL_PITCH: Level pitch.
  /// MENU_CMD_MOTORS_SAFE_TOGGLE: Turn the motors on, or stop them safely and turn them off.
  motors_safe_toggle = 66,
  timelapse_step1 = 67,  ///< MENU_CMD_TIMELAPSE_STEP1: Do the first step of a time-lapse motion.
  /// MENU_CMD_EXT_GYRO_ONLINE_CALIB: Calibrate the external gyroscope during operation.
  ext_gyro_online_calib = 68,
  /// MENU_CMD_DISABLE_FOLLOW_TOGGLE: Turn the follow mode off or on again.
  disable_follow_toggle = 69,
  /// MENU_CMD_SET_CUR_POS_AS_HOME: Make the current position the home position.
  set_cur_pos_as_home = 70,
  stop_script = 71,  ///< MENU_CMD_STOP_SCRIPT: Stop the running script.
  tripod_mode_off = 72,  ///< MENU_CMD_TRIPOD_MODE_OFF: Turn the tripod mode off.
  tripod_mode_on = 73,  ///< MENU_CMD_TRIPOD_MODE_ON: Turn the tripod mode on.
  set_rc_trim = 74,  ///< MENU_CMD_SET_RC_TRIM: Set the RC trim to the current signals.
  /// MENU_CMD_HOME_POSITION_MOTORS: Return the motors to their home positions.
  home_position_motors = 75,
  retracted_position = 76,  ///< MENU_CMD_RETRACTED_POSITION: Move to the retracted position.
  shake_generator_off = 77,  ///< MENU_CMD_SHAKE_GENERATOR_OFF: Turn the shake generator off.
  shake_generator_on = 78,  ///< MENU_CMD_SHAKE_GENERATOR_ON: Turn the shake generator on.
  servo_mode_on = 79,  ///< MENU_CMD_SERVO_MODE_ON: Turn the servo mode on.
  servo_mode_off = 80,  ///< MENU_CMD_SERVO_MODE_OFF: Turn the servo mode off.
  servo_mode_toggle = 81,  ///< MENU_CMD_SERVO_MODE_TOGGLE: Turn the servo mode on or off.
};

/// Motor output that drives an axis.
/// Source: Variables L1054.
enum class MotorOutput : std::uint8_t {
  disabled = 0,  ///< DISABLED: None.
  roll = 1,  ///< ROLL: The ROLL output.
  pitch = 2,  ///< PITCH: The PITCH output.
  yaw = 3,  ///< YAW: The YAW output.
  i2c_drv1 = 4,  ///< I2C_DRV1: The first motor driver on the I2C bus.
  i2c_drv2 = 5,  ///< I2C_DRV2: The second motor driver on the I2C bus.
  i2c_drv3 = 6,  ///< I2C_DRV3: The third motor driver on the I2C bus.
  i2c_drv4 = 7,  ///< I2C_DRV4: The fourth motor driver on the I2C bus.
};

/// Which IMU is selected.
/// Source: Variables L1062, L1135, L1169, L1235; Outgoing commands L893.
enum class SelectedImu : std::uint8_t {
  main = 1,  ///< IMU_TYPE_MAIN: The main IMU on the camera.
  frame = 2,  ///< IMU_TYPE_FRAME: The IMU on the frame.
};

/// Protocol of a Spektrum satellite.
/// Source: Variables L1075-L1077.
enum class SpektrumMode : std::uint8_t {
  auto_detect = 0,  ///< Detected.
  dsm2_11ms_10bit = 1,  ///< DSM2, 11 ms, 10 bits.
  dsm2_11ms_11bit = 2,  ///< DSM2, 11 ms, 11 bits.
  dsm2_22ms_10bit = 3,  ///< DSM2, 22 ms, 10 bits.
  dsm2_22ms_11bit = 4,  ///< DSM2, 22 ms, 11 bits.
  dsmx_11ms_10bit = 5,  ///< DSMX, 11 ms, 10 bits.
  dsmx_11ms_11bit = 6,  ///< DSMX, 11 ms, 11 bits.
  dsmx_22ms_10bit = 7,  ///< DSMX, 22 ms, 10 bits.
  dsmx_22ms_11bit = 8,  ///< DSMX, 22 ms, 11 bits.
};

/// Order of the motor axes, counted from the camera.
/// Source: Variables L1078.
enum class AxisOrder : std::uint8_t {
  pitch_roll_yaw = 0,  ///< PITCH_ROLL_YAW: Pitch, roll, yaw.
  yaw_roll_pitch = 1,  ///< YAW_ROLL_PITCH: Yaw, roll, pitch.
  roll_yaw_pitch = 2,  ///< ROLL_YAW_PITCH: Roll, yaw, pitch; not implemented.
  roll_pitch_yaw = 3,  ///< ROLL_PITCH_YAW: Roll, pitch, yaw.
};

/// Order of the Euler angles of camera and target.
/// Source: Variables L1079.
enum class EulerOrder : std::uint8_t {
  pitch_roll_yaw = 0,  ///< PITCH_ROLL_YAW: Pitch, roll, yaw.
  roll_pitch_yaw = 1,  ///< ROLL_PITCH_YAW: Roll, pitch, yaw.
  /// LOCAL_ROLL: Local, roll; for two-axis systems. Later: pitch of the motor, roll, yaw of the
  /// motor.
  local_roll = 2,
  /// ROLL_LOCAL: Roll, local; for two-axis systems. Later: roll, pitch of the motor, yaw of the
  /// motor.
  roll_local = 3,
  yaw_roll_pitch = 4,  ///< YAW_ROLL_PITCH: Yaw, roll, pitch.
  yaw_pitch_roll = 5,  ///< YAW_PITCH_ROLL: Yaw, pitch, roll.
};

/// Operation on a profile set.
/// Source: Later firmware.
enum class ProfileSetAction : std::uint8_t {
  save = 1,  ///< SAVE: Save the parameters in use as a profile set.
  clear = 2,  ///< CLEAR: Clear the profile set.
  load = 3,  ///< LOAD: Load the profile set.
};

/// Kind of encoder.
/// Source: Variables L1100.
enum class EncoderModel : std::uint8_t {
  as5048a = 1,  ///< ENC_TYPE_AS5048A: AS5048A, over SPI.
  as5048b = 2,  ///< ENC_TYPE_AS5048B: AS5048B, over I2C.
  as5048_pwm = 3,  ///< ENC_TYPE_AS5048_PWM: AS5048, over PWM.
  amt203 = 4,  ///< ENC_TYPE_AMT203: AMT203.
  ma3_10bit = 5,  ///< ENC_TYPE_MA3_10BIT: MA3 with 10 bits.
  ma3_12bit = 6,  ///< ENC_TYPE_MA3_12BIT: MA3 with 12 bits.
  analog = 7,  ///< ENC_TYPE_ANALOG: Analog.
  i2c_drv1 = 8,  ///< ENC_TYPE_I2C_DRV1: I2C driver 1.
  i2c_drv2 = 9,  ///< ENC_TYPE_I2C_DRV2: I2C driver 2.
  i2c_drv3 = 10,  ///< ENC_TYPE_I2C_DRV3: I2C driver 3.
  i2c_drv4 = 11,  ///< ENC_TYPE_I2C_DRV4: I2C driver 4.
  as5600_pwm = 12,  ///< ENC_TYPE_AS5600_PWM: AS5600, over PWM.
  as5600_i2c = 13,  ///< ENC_TYPE_AS5600_I2C: AS5600, over I2C.
  rls_orbis = 14,  ///< ENC_TYPE_RLS_ORBIS: RLS Orbis.
  rls_orbis_pwm = 15,  ///< ENC_TYPE_RLS_ORBIS_PWM: RLS Orbis, over PWM.
};

/// Clock of an SPI encoder; for an I2C driver, the kind of encoder in it.
/// Source: Variables L1101.
enum class EncoderConfig : std::uint8_t {
  spi_1_mhz = 0,  ///< SPI_SPEED_1MHz: SPI clock of 1 MHz.
  spi_2_mhz = 1,  ///< SPI_SPEED_2MHz: SPI clock of 2 MHz.
  spi_4_mhz = 2,  ///< SPI_SPEED_4MHz: SPI clock of 4 MHz.
  spi_500_khz = 3,  ///< SPI_SPEED_500kHz: SPI clock of 500 kHz.
};

/// Serial port of the board.
/// Source: Later firmware.
enum class BoardPort : std::uint8_t {
  disabled = 0,  ///< DISABLED: None.
  uart1 = 1,  ///< UART1: UART 1.
  rc_serial = 2,  ///< RC_SERIAL: The serial RC input.
  uart2 = 3,  ///< UART2: UART 2.
  usb_vcp = 4,  ///< USB_VCP: The virtual port of the USB connection.
};

/// Axes that a MAVLink host controls.
/// Source: Later firmware.
enum class MavControlMode : std::uint8_t {
  disabled = 0,  ///< DISABLED: None.
  roll_pitch = 1,  ///< ROLL_PITCH: Roll and pitch.
  all_axes = 2,  ///< ALL_AXES: All.
};

/// Axis that a motor stabilizes.
/// Source: Later firmware.
enum class StabilizedAxis : std::uint8_t {
  default_axis = 0,  ///< STAB_AXIS_DEFAULT: The axis of the motor.
  roll = 1,  ///< STAB_AXIS_ROLL: Roll.
  pitch = 2,  ///< STAB_AXIS_PITCH: Pitch.
  yaw = 3,  ///< STAB_AXIS_YAW: Yaw.
};

/// Distance between the fixed positions of an axis.
/// Source: Later firmware.
enum class SnapAngle : std::uint8_t {
  snap_angle_0 = 0,  ///< SNAP_ANGLE_0: 0 degrees.
  snap_angle_45 = 1,  ///< SNAP_ANGLE_45: 45 degrees.
  snap_angle_90 = 2,  ///< SNAP_ANGLE_90: 90 degrees.
  snap_angle_180 = 3,  ///< SNAP_ANGLE_180: 180 degrees.
};

/// Number of steps of a step signal.
/// Source: Later firmware.
enum class StepCount : std::uint8_t {
  steps_2 = 0,  ///< 2 steps.
  steps_3 = 1,  ///< 3 steps.
  steps_5 = 2,  ///< 5 steps.
  steps_10 = 3,  ///< 10 steps.
  steps_15 = 4,  ///< 15 steps.
  steps_25 = 5,  ///< 25 steps.
  steps_50 = 6,  ///< 50 steps.
  steps_100 = 7,  ///< 100 steps.
};

/// Returns the number that a value denotes; 0 for unknown values.
constexpr std::uint32_t number_of(StepCount value) noexcept {
  switch (value) {
    case StepCount::steps_2: return 2;
    case StepCount::steps_3: return 3;
    case StepCount::steps_5: return 5;
    case StepCount::steps_10: return 10;
    case StepCount::steps_15: return 15;
    case StepCount::steps_25: return 25;
    case StepCount::steps_50: return 50;
    case StepCount::steps_100: return 100;
  }
  return 0;
}

/// Level of an RC signal that triggers a step.
/// Source: Later firmware.
enum class StepTrigger : std::uint8_t {
  level_low = 0,  ///< LEVEL_LOW: Low.
  level_high = 1,  ///< LEVEL_HIGH: High.
  level_low_high = 2,  ///< LEVEL_LOW_HIGH: Low and high.
};

/// Begin or end of a series of writes.
/// Source: Later firmware.
enum class WriteParamsAction : std::uint8_t {
  finish = 0,  ///< FINISH: The series ends.
  start = 1,  ///< START: The series begins.
};

/// Model of the external IMU.
/// Source: Later firmware.
enum class ExtImuModel : std::uint8_t {
  mavlink1 = 1,  ///< MAVLINK1: Any, over MAVLink 1.
  mavlink2 = 2,  ///< MAVLINK2: Any, over MAVLink 2.
  vectornav_vn200 = 3,  ///< VECTORNAV_VN200: VectorNav VN-200.
  inertialsense_uahrs = 4,  ///< INERTIALSENSE_UAHRS: Inertial Sense uAHRS.
};

/// Location of the external IMU.
/// Source: Later firmware.
enum class ExtImuPosition : std::uint8_t {
  below_outer = 1,  ///< BELOW_OUTER: Below the outer motor.
  above_outer = 2,  ///< ABOVE_OUTER: Above the outer motor.
  below_middle = 8,  ///< BELOW_MIDDLE: Below the middle motor.
  main_imu = 9,  ///< MAIN_IMU: At the main IMU.
};

/// Direction of an axis of the external IMU.
/// Source: Later firmware.
enum class ExtImuAxis : std::uint8_t {
  x = 0,  ///< X: X axis.
  y = 1,  ///< Y: Y axis.
  z = 2,  ///< Z: Z axis.
  minus_x = 3,  ///< -X: Against the X axis.
  minus_y = 4,  ///< -Y: Against the Y axis.
  minus_z = 5,  ///< -Z: Against the Z axis.
};

/// Number of bits in which an encoder counts its turns.
/// Source: Later firmware.
enum class MultiTurn : std::uint8_t {
  multi_turn_no = 0,  ///< It does not count turns.
  multi_turn_12 = 1,  ///< 12 bits.
  multi_turn_16 = 2,  ///< 16 bits.
  multi_turn_20 = 3,  ///< 20 bits.
  multi_turn_24 = 4,  ///< 24 bits.
};

/// External sensor of the CAN IMU.
/// Source: Later firmware.
enum class CanImuSensor : std::uint8_t {
  disabled = 0,  ///< DISABLED: None.
  kvh_1725 = 1,  ///< KVH_1725: KVH 1725.
  kvh_1750_acc_2g = 2,  ///< KVH_1750_ACC_2G: KVH 1750, accelerometer up to 2 g.
  kvh_1750_acc_10g = 3,  ///< KVH_1750_ACC_10G: KVH 1750, accelerometer up to 10 g.
  kvh_1750_acc_30g = 4,  ///< KVH_1750_ACC_30G: KVH 1750, accelerometer up to 30 g.
  kvh_1775_acc_10g = 5,  ///< KVH_1775_ACC_10G: KVH 1775, accelerometer up to 10 g.
  kvh_1775_acc_25g = 6,  ///< KVH_1775_ACC_25G: KVH 1775, accelerometer up to 25 g.
  kvh_1760 = 7,  ///< KVH_1760: KVH 1760.
  adxrs453 = 8,  ///< ADXRS453: ADXRS453.
  adis16460 = 9,  ///< ADIS16460: ADIS16460.
  stim210 = 10,  ///< STIM210: STIM210.
  stim300 = 11,  ///< STIM300: STIM300.
  scha63x = 12,  ///< SCHA63X: SCHA63x.
  /// VECTORNAV_VN100_200_UART: VectorNav VN-100 or VN-200, over a UART.
  vectornav_vn100_200_uart = 64,
  vectornav_vn100_200_spi = 65,  ///< VECTORNAV_VN100_200_SPI: VectorNav VN-100 or VN-200, over SPI.
};

/// State of an input.
/// Source: Vendor's code of 2026.
enum class InputState : std::uint8_t {
  low = 0,  ///< LOW: Low.
  high = 1,  ///< HIGH: High.
  unavailable = 2,  ///< UNAVAILABLE: Unavailable or not assigned.
};

/// Reason for an emergency stop.
/// Source: Variables L1131; Later firmware.
enum class SystemSubError : std::uint8_t {
  none = 0,  ///< No emergency stop.
  i2c_errors = 1,  ///< SUB_ERR_I2C_ERRORS: Too many errors on the I2C bus.
  drv_otw = 2,  ///< SUB_ERR_DRV_OTW: A motor driver reports an overtemperature warning.
  drv_fault = 3,  ///< SUB_ERR_DRV_FAULT: A motor driver failed.
  encoder_imu_angle = 4,  ///< SUB_ERR_ENCODER_IMU_ANGLE: Encoder and IMU disagree.
  calibration_failed = 5,  ///< SUB_ERR_CALIBRATION_FAILED: A calibration failed.
  internal_system_error = 6,  ///< SUB_ERR_INTERNAL_SYSTEM_ERROR: Internal error.
  /// SUB_ERR_ENCODER_CALIB_BAD_SCALE: The scale of an encoder is wrong.
  encoder_calib_bad_scale = 7,
  over_temperature = 8,  ///< SUB_ERR_OVER_TEMPERATURE: Overtemperature.
  /// SUB_ERR_BAD_MOTOR_POLES_INVERT: Wrong poles or direction of a motor.
  bad_motor_poles_invert = 9,
  not_enough_memory = 10,  ///< SUB_ERR_NOT_ENOUGH_MEMORY: Out of memory.
  /// SUB_ERR_IMU_SENSOR_NOT_RESPONDING: The IMU sensor does not respond.
  imu_sensor_not_responding = 11,
  can_hard = 12,  ///< SUB_ERR_CAN_HARD: The hardware of the CAN bus failed.
  motor_overheat_protection = 13,  ///< SUB_ERR_MOTOR_OVERHEAT_PROTECTION: A motor overheated.
  motor_is_locked = 14,  ///< SUB_ERR_MOTOR_IS_LOCKED: A motor cannot turn.
  bad_imu_health = 15,  ///< SUB_ERR_BAD_IMU_HEALTH: The IMU sensor is unreliable.
  infinite_reset = 16,  ///< SUB_ERR_INFINITE_RESET: The board restarts again and again.
  /// SUB_ERR_WRONG_INITIAL_POSITION: The position at start-up is wrong.
  wrong_initial_position = 17,
  /// SUB_ERR_MOTOR_LOAD_TIME_EXCEEDED: A motor was overloaded for too long.
  motor_load_time_exceeded = 18,
  can_drv_overcurrent = 19,  ///< SUB_ERR_CAN_DRV_OVERCURRENT: Overcurrent in a CAN motor driver.
  can_drv_undervoltage = 20,  ///< SUB_ERR_CAN_DRV_UNDERVOLTAGE: Undervoltage in a CAN motor driver.
  /// SUB_ERR_CAN_DRV_EMERGENCY_PIN: The emergency pin of a CAN motor driver is active.
  can_drv_emergency_pin = 21,
  /// SUB_ERR_CAN_DRV_FOC_DURATION: The motor control of a CAN motor driver takes too long.
  can_drv_foc_duration = 22,
  /// SUB_ERR_CAN_DRV_MCU_OVERHEAT: The microcontroller of a CAN motor driver overheated.
  can_drv_mcu_overheat = 23,
  /// SUB_ERR_CAN_DRV_MOTOR_OVERHEAT: A motor of a CAN motor driver overheated.
  can_drv_motor_overheat = 24,
  /// SUB_ERR_CAN_DRV_OVERCURRENT_SOFT: The software of a CAN motor driver detected an overcurrent.
  can_drv_overcurrent_soft = 25,
  can_drv_several = 26,  ///< SUB_ERR_CAN_DRV_SEVERAL: Several CAN motor drivers failed.
  can_ext_bus_off = 27,  ///< SUB_ERR_CAN_EXT_BUS_OFF: The external CAN bus is off.
  can_int_bus_off = 28,  ///< SUB_ERR_CAN_INT_BUS_OFF: The internal CAN bus is off.
  encoder_not_found = 29,  ///< SUB_ERR_ENCODER_NOT_FOUND: An encoder is missing.
  /// SUB_ERR_CAN_DRV_NOT_RESPONDING: A CAN motor driver does not respond.
  can_drv_not_responding = 30,
  /// SUB_ERR_CAN_DRV_WRONG_PARAMS: Parameters of a CAN motor driver are wrong.
  can_drv_wrong_params = 31,
  overcurrent = 32,  ///< SUB_ERR_OVERCURRENT: Overcurrent.
  unsafe_voltage = 33,  ///< SUB_ERR_UNSAFE_VOLTAGE: The supply voltage is unsafe.
  /// SUB_ERR_WRONG_FULL_BAT_VOLTAGE_PARAM: The parameter for the voltage of a full battery is
  /// wrong.
  wrong_full_bat_voltage_param = 34,
  /// SUB_ERR_EEPROM_PARAMS_CORRUPTED: The parameters in the EEPROM are damaged.
  eeprom_params_corrupted = 35,
  /// SUB_ERR_ENCODER_UNSUPPORTED_TYPE: The kind of encoder is not supported.
  encoder_unsupported_type = 36,
  /// SUB_ERR_EXT_IMU_UNSUPPORTED_TYPE: The kind of external IMU is not supported.
  ext_imu_unsupported_type = 37,
  /// SUB_ERR_EXT_IMU_SENSOR_NOT_RESPONDING: The external IMU does not respond.
  ext_imu_sensor_not_responding = 38,
  /// SUB_ERR_EXT_IMU_WRONG_PARAMS: Parameters of the external IMU are wrong.
  ext_imu_wrong_params = 39,
  driver_init = 40,  ///< SUB_ERR_DRIVER_INIT: A motor driver cannot be initialized.
  /// SUB_ERR_EEPROM_VARS_OUT_OF_BORDERS: Variables in the EEPROM are out of range.
  eeprom_vars_out_of_borders = 41,
  iwdg_reset = 42,  ///< SUB_ERR_IWDG_RESET: The watchdog restarted the board.
  adc_wait = 43,  ///< SUB_ERR_ADC_WAIT: The analog-to-digital converter does not respond.
  calib_motor_off = 44,  ///< SUB_ERR_CALIB_MOTOR_OFF: The motors were off during a calibration.
  timeout = 45,  ///< SUB_ERR_TIMEOUT: Timeout.
  /// SUB_ERR_CAN_DRV_CALIB_UNEXPECTED_RES: The calibration of a CAN motor driver had an unexpected
  /// result.
  can_drv_calib_unexpected_res = 46,
  /// SUB_ERR_MAG_SENSOR_NOT_RESPONDING: The magnetometer does not respond.
  mag_sensor_not_responding = 47,
  /// SUB_ERR_CAN_DRV_OVERSPEED: A motor of a CAN motor driver is too fast.
  can_drv_overspeed = 48,
  /// SUB_ERR_ENC_SELF_CALIB_FAILED: The self-calibration of an encoder failed.
  enc_self_calib_failed = 49,
  /// SUB_ERR_CAN_VERSION_MISMATCH: The firmware of a CAN device does not match.
  can_version_mismatch = 50,
  /// SUB_ERR_CAN_SERIAL_INIT: The serial port over CAN cannot be initialized.
  can_serial_init = 51,
  can_serial_conflict = 52,  ///< SUB_ERR_CAN_SERIAL_CONFLICT: Serial ports over CAN conflict.
  /// SUB_ERR_CAN_DRV_INIT_STAGE: The start-up of a CAN motor driver failed.
  can_drv_init_stage = 53,
  encoder_data_timeout = 54,  ///< SUB_ERR_ENCODER_DATA_TIMEOUT: An encoder sends no data.
  /// SUB_ERR_CAN_CONNECTION_LOST: The connection to a CAN device is lost.
  can_connection_lost = 55,
  hse_start_fail = 56,  ///< SUB_ERR_HSE_START_FAIL: The external oscillator does not start.
  /// SUB_ERR_FRAME_IMU_SENSOR_NOT_RESPONDING: The sensor of the frame IMU does not respond.
  frame_imu_sensor_not_responding = 57,
  parameters_modified = 58,  ///< SUB_ERR_PARAMETERS_MODIFIED: The parameters were modified.
  /// SUB_ERR_NOT_NORMAL_POSITION: The camera is not in its normal position.
  not_normal_position = 59,
  /// SUB_ERR_CAN_DRV_LIMIT_EXCEED: There are more CAN motor drivers than allowed.
  can_drv_limit_exceed = 60,
};

/// Calibration or other task that is running.
/// Source: Later firmware.
enum class CalibMode : std::uint8_t {
  none = 0,  ///< NONE: None.
  ext_gain = 1,  ///< EXT_GAIN: The gains of a flight controller's signals.
  /// SET_ANGLE_AND_SAVE: Make the current angle the initial angle and save it.
  set_angle_and_save = 2,
  poles = 3,  ///< POLES: The poles and directions of the motors.
  acc = 4,  ///< ACC: The accelerometer.
  gyro = 5,  ///< GYRO: The gyroscope.
  encoder_offset = 6,  ///< ENCODER_OFFSET: The offsets of the encoders.
  /// ENCODER_FLD_OFFSET: The offsets between encoders and magnetic fields.
  encoder_fld_offset = 7,
  auto_pid = 8,  ///< AUTO_PID: Automatic tuning of the PID controllers.
  bode_test = 9,  ///< BODE_TEST: Recording a frequency response.
  gyro_temp = 10,  ///< GYRO_TEMP: The gyroscope over temperature.
  acc_temp = 11,  ///< ACC_TEMP: The accelerometer over temperature.
  mag = 12,  ///< MAG: The magnetometer.
  set_angle = 13,  ///< SET_ANGLE: Make the current angle the initial angle.
  system_ident = 14,  ///< SYSTEM_IDENT: Identification of the system.
  motor_mag_link = 15,  ///< MOTOR_MAG_LINK: The magnetic linkage of the motors.
  search_limits = 16,  ///< SEARCH_LIMITS: Searching the mechanical limits.
  set_operation_pos = 17,  ///< SET_OPERATION_POS: Moving to the operating position.
  imu_orientation_corr = 18,  ///< IMU_ORIENTATION_CORR: The orientation of the IMU.
  timelapse = 19,  ///< TIMELAPSE: A time-lapse motion.
  momentum = 20,  ///< MOMENTUM: The moment of inertia.
  momentum_auto = 21,  ///< MOMENTUM_AUTO: The moment of inertia, automatically.
  cogging = 22,  ///< COGGING: The cogging of the motors.
  acc_ext_ref = 23,  ///< ACC_EXT_REF: The accelerometer, by an external reference.
  safe_stop = 24,  ///< SAFE_STOP: A safe stop.
  acc_sphere = 25,  ///< ACC_SPHERE: The accelerometer on a sphere.
  gyro_axes_alignment = 26,  ///< GYRO_AXES_ALIGNMENT: The alignment of the gyroscope's axes.
  ext_imu_gyro = 27,  ///< EXT_IMU_GYRO: The gyroscope of the external IMU.
  ext_imu_align = 28,  ///< EXT_IMU_ALIGN: The alignment of the external IMU.
  /// ACC_GYRO_MULTIPOINT: Accelerometer and gyroscope in several positions.
  acc_gyro_multipoint = 34,
  encoder_lut = 35,  ///< ENCODER_LUT: The correction tables of the encoders.
  write_params = 36,  ///< WRITE_PARAMS: Writing parameters.
  cur_sens = 37,  ///< CUR_SENS: The current sensors.
  move_home_motors = 38,  ///< MOVE_HOME_MOTORS: Moving the motors to their home positions.
  encoder_int = 39,  ///< ENCODER_INT: The internal calibration of the encoders.
  vibration_test = 40,  ///< VIBRATION_TEST: A vibration test.
  retracted_position = 41,  ///< RETRACTED_POSITION: Moving to the retracted position.
  /// RETRACTED_POSITION_RC_CONTROL: Moving to or from the retracted position by RC.
  retracted_position_rc_control = 42,
};

/// State of the motor power.
/// Source: Later firmware.
enum class PowerState : std::int8_t {
  on_from_backup = -2,  ///< ON_FROM_BACKUP: On, after a restart.
  startup = -1,  ///< STARTUP: The board is starting.
  off = 0,  ///< OFF: Off.
  on = 1,  ///< ON: On.
  off_temporary = 2,  ///< OFF_TEMPORARY: Temporarily off.
  off_parking = 3,  ///< OFF_PARKING: Off, in the parking position.
  on_safe_stop = 4,  ///< ON_SAFE_STOP: On, until a safe stop is complete.
};

/// Event that triggers the samples of a data stream.
/// Source: Later firmware.
enum class StreamSync : std::uint8_t {
  off = 0,  ///< OFF: None; the samples follow the clock.
  imu_attitude = 1,  ///< A new attitude of the IMU.
};

/// Meaning of SPEED and ANGLE in a control command.
/// Source: Variables L1148.
enum class ControlModeKind : std::uint8_t {
  no_control = 0,  ///< MODE_NO_CONTROL: Serial control ends and RC takes over.
  /// MODE_SPEED: Turn at the given speed, in Euler coordinates, until the next command; the angle
  /// is ignored.
  speed = 1,
  /// MODE_ANGLE: Go to the given angle, in Euler coordinates, at the given speed; speed 0 selects
  /// the speed from the parameters.
  angle = 2,
  /// MODE_SPEED_ANGLE: Follow the given speed while the controller holds the given angle; the most
  /// precise mode.
  speed_angle = 3,
  /// MODE_RC: The angle replaces the RC signal, -500 to 500, or -10000 for a lost signal; firmware
  /// before 2.61 ignores the speed.
  rc = 4,
  /// MODE_ANGLE_REL_FRAME: Go to the given angle relative to the frame's neutral point; undoes full
  /// turns, so it untwists cables. Speed 0 selects the speed from the parameters.
  angle_rel_frame = 5,
  /// MODE_RC_HIGH_RES: Like MODE_RC, with a finer signal: -16384 to 16384, or -32768 for a lost
  /// signal. Since firmware 2.66b2.
  rc_high_res = 6,
  /// MODE_IGNORE: The axis keeps its state; its speed and angle are ignored. Since firmware 2.70b4.
  ignore = 7,
  /// MODE_ANGLE_SHORTEST: Like MODE_ANGLE, but by the shortest way that the software limits leave
  /// open. Since firmware 2.70b7.
  angle_shortest = 8,
};

/// How to turn the motors off.
/// Source: Later firmware.
enum class MotorsOffMode : std::uint8_t {
  normal = 0,  ///< NORMAL: They turn freely, without current.
  brake = 1,  ///< BRAKE: They brake.
  safe_stop = 2,  ///< SAFE_STOP: Their power falls until they stand still, then they are off.
};

/// Coordinate system of data from an external system.
/// Source: Variables L1250.
enum class CoordinateSystem : std::uint8_t {
  /// COORD_SYS_GROUND_YAW_ROTATED: Ground coordinates rotated with the camera about Z: Z points up,
  /// X right, Y forward. The default.
  ground_yaw_rotated = 1,
  ground_end = 2,  ///< COORD_SYS_GROUND_END: Ground coordinates: X points east, Y north, Z down.
  frame = 3,  ///< COORD_SYS_FRAME: Coordinates of the frame.
};

/// Order of the Euler angles to change to.
/// Source: Later firmware.
enum class EulerOrderChange : std::uint8_t {
  keep = 0,  ///< The order does not change.
  pitch_roll_yaw = 1,  ///< PITCH_ROLL_YAW: Pitch, roll, yaw.
  roll_pitch_yaw = 2,  ///< ROLL_PITCH_YAW: Roll, pitch, yaw.
  local_roll = 3,  ///< LOCAL_ROLL: Pitch of the motor, roll, yaw of the motor.
  roll_local = 4,  ///< ROLL_LOCAL: Roll, pitch of the motor, yaw of the motor.
  yaw_roll_pitch = 5,  ///< YAW_ROLL_PITCH: Yaw, roll, pitch.
  yaw_pitch_roll = 6,  ///< YAW_PITCH_ROLL: Yaw, pitch, roll. Unconfirmed.
};

/// Meaning of attitude and speed in CMD_CONTROL_QUAT.
/// Source: Later firmware.
enum class ControlQuatMode : std::uint8_t {
  disabled = 0,  ///< DISABLED: Control with quaternions ends.
  speed = 1,  ///< SPEED: Turn at the given speed, without a motion profile.
  attitude = 2,  ///< ATTITUDE: Go to the given attitude with the configured motion profile.
  /// SPEED_ATTITUDE: Turn at the given speed and correct deviations from the given attitude.
  speed_attitude = 5,
  /// SPEED_LIMITED: Turn at the given speed, reached with the configured motion profile.
  speed_limited = 9,
};

/// Component of a quaternion.
/// Source: Later firmware.
enum class QuaternionComponent : std::uint8_t {
  w = 0,  ///< W: The scalar component.
  x = 1,  ///< X: The X component.
  y = 2,  ///< Y: The Y component.
  z = 3,  ///< Z: The Z component.
};

/// Motor of CMD_SYNC_MOTORS.
/// Source: Later firmware.
enum class SyncMotorAxis : std::uint8_t {
  roll = 0,  ///< ROLL: Roll.
  pitch = 1,  ///< PITCH: Pitch.
  yaw = 2,  ///< YAW: Yaw.
};

/// What has happened.
/// Source: Later firmware.
enum class EventId : std::uint8_t {
  menu_button = 1,  ///< MENU_BUTTON: The menu button was pressed or released.
  motor_state = 2,  ///< MOTOR_STATE: The motors were turned on or off.
  emergency_stop = 3,  ///< EMERGENCY_STOP: An emergency stop began or ended.
  camera = 4,  ///< CAMERA: The camera is to record or to take a photo.
  script = 5,  ///< SCRIPT: A script started or ended. Since firmware 2.68b8.
  /// RETRACTED_POSITION: The retracted position was reached or left. Since firmware 2.73.1.
  retracted_position = 6,
};

/// What external motors do.
/// Source: Later firmware.
enum class ExtMotorActionKind : std::uint8_t {
  off_floating = 1,  ///< OFF_FLOATING: Turn off and rotate freely.
  off_brake = 2,  ///< OFF_BRAKE: Turn off and brake.
  off_safe = 3,  ///< OFF_SAFE: Slow down against external forces, then turn off and brake.
  on = 4,  ///< ON: Turn on.
  home_position = 5,  ///< HOME_POSITION: Move to the home position.
  /// SEARCH_HOME: Search the home position of a geared motor, or of one that makes several turns.
  search_home = 6,
};

/// What the setpoint of an external motor controls.
/// Source: Later firmware.
enum class ExtMotorMode : std::uint8_t {
  position = 0,  ///< POSITION: Its angle.
  speed = 1,  ///< SPEED: Its speed.
  torque = 2,  ///< TORQUE: Its torque.
};

/// Whether an external motor has power.
/// Source: Later firmware.
enum class ExtMotorPower : std::uint8_t {
  off_brake = 0,  ///< OFF_BRAKE: It is off and brakes.
  on = 1,  ///< ON: It is on.
  off_floating = 2,  ///< OFF_FLOATING: It is off and rotates freely.
  off_safe_stop = 3,  ///< OFF_SAFE_STOP: It is off after a safe stop.
};

/// Axis of a frequency response.
/// Source: Vendor's code of 2026.
enum class BodeAxis : std::uint8_t {
  roll = 0,  ///< ROLL: Roll.
  pitch = 1,  ///< PITCH: Pitch.
  yaw = 2,  ///< YAW: Yaw.
};

/// Stimulus of a frequency response.
/// Source: Vendor's code of 2026.
enum class BodeStimulus : std::uint8_t {
  white_noise = 1,  ///< WHITE_NOISE: White noise.
  sine_sweep = 2,  ///< SINE_SWEEP: A sine with rising frequency.
  exponential_sweep = 3,  ///< EXPONENTIAL_SWEEP: A sine with exponentially rising frequency.
};

/// What a frequency response describes.
/// Source: Vendor's code of 2026.
enum class BodeSystem : std::uint8_t {
  controller = 3,  ///< CONTROLLER: The controller.
  /// OPEN_LOOP_PLANT_WITH_FILTERS: The plant with notch filters, open loop.
  open_loop_plant_with_filters = 6,
  /// OPEN_LOOP_CONTROLLER_AND_PLANT: Controller and plant, open loop.
  open_loop_controller_and_plant = 7,
  overall = 11,  ///< OVERALL: The overall response of the system.
  open_loop_plant = 70,  ///< OPEN_LOOP_PLANT: The plant alone, open loop.
  /// CLOSED_LOOP_PLANT_WITH_FILTERS: The plant with notch filters, closed loop.
  closed_loop_plant_with_filters = 134,
  /// CLOSED_LOOP_CONTROLLER_AND_PLANT: Controller and plant, closed loop.
  closed_loop_controller_and_plant = 135,
  closed_loop_plant = 198,  ///< CLOSED_LOOP_PLANT: The plant alone, closed loop.
};

/// IMU to calibrate.
/// Source: Outgoing commands L629.
enum class CalibImu : std::uint8_t {
  active = 0,  ///< The active IMU.
  main = 1,  ///< The main IMU on the camera.
  frame = 2,  ///< The IMU on the frame.
};

/// Kind of calibration.
/// Source: Outgoing commands L630-L637.
enum class CalibAction : std::uint8_t {
  regular = 1,  ///< Calibrate at the current temperature.
  reset = 2,  ///< Erase all calibrations and restart.
  temperature = 3,  ///< Calibrate over temperature.
  /// Enable the calibration over temperature, if there is one, and restart.
  enable_temperature = 4,
  /// Disable the calibration over temperature, but keep it in memory, and restart.
  disable_temperature = 5,
  restore_factory = 6,  ///< Copy the calibration from the sensor's EEPROM to the main EEPROM.
  store_in_sensor = 7,  ///< Copy the calibration from the main EEPROM to the sensor's EEPROM.
};

/// Motor whose encoder to calibrate.
/// Source: Later firmware.
enum class CalibMotor : std::uint8_t {
  roll = 0,  ///< The roll motor.
  pitch = 1,  ///< The pitch motor.
  yaw = 2,  ///< The yaw motor.
  all = 255,  ///< All motors.
};

/// Operation of CMD_AUTO_PID2.
/// Source: Later firmware.
enum class AutoPid2Action : std::uint8_t {
  start = 1,  ///< START: Start the tuning with this configuration.
  start_save = 2,  ///< START_SAVE: Save this configuration and start the tuning.
  save = 3,  ///< SAVE: Save this configuration.
  stop = 5,  ///< STOP: Stop the tuning.
  read = 6,  ///< READ: Read the saved configuration.
};

/// Operation of CMD_CALIB_COGGING.
/// Source: Later firmware.
enum class CoggingAction : std::uint8_t {
  calibrate = 1,  ///< Calibrate the motors.
  erase = 2,  ///< Delete the calibration of the motors.
};

/// IMU, counted from 0.
/// Source: Variables L1199, L1207.
enum class ImuIndex : std::uint8_t {
  main = 0,  ///< The main IMU on the camera.
  frame = 1,  ///< The IMU on the frame.
};

/// Reference that corrects an estimate of the attitude.
/// Source: Later firmware.
enum class AhrsReference : std::uint8_t {
  none = 0,  ///< None.
  internal = 1,  ///< The board's own sensor.
  external = 2,  ///< An external sensor.
  translate = 3,  ///< The other IMU, translated by the motor angles.
};

/// State of the external IMU.
/// Source: Later firmware.
enum class ExtImuState : std::uint8_t {
  disabled = 0,  ///< Disabled.
  not_connected = 1,  ///< Not connected.
  unknown = 2,  ///< Unknown.
  error = 3,  ///< It reports an error.
  bad = 4,  ///< Its data are bad.
  coarse = 5,  ///< Its data are coarse.
  good = 6,  ///< Its data are good.
  fine = 7,  ///< Its data are precise.
};

/// Commands of the GPS_IMU sensor's own protocol.
/// Source: Later firmware.
enum class ExtSensCommand : std::uint8_t {
  confirm = 1,  ///< CONFIRM: Confirmation.
  reset = 2,  ///< RESET: Restart the sensor.
  reset_notify = 3,  ///< RESET_NOTIFY: The sensor restarts.
  get_device_info = 4,  ///< GET_DEVICE_INFO: Request information about the sensor.
  device_info = 5,  ///< DEVICE_INFO: Information about the sensor.
  get_data = 6,  ///< GET_DATA: Request data.
  get_data_stream = 7,  ///< GET_DATA_STREAM: Request a stream of data.
  data = 8,  ///< DATA: Data.
  calib = 9,  ///< CALIB: Calibrate the sensor.
  boot_mode = 10,  ///< BOOT_MODE: Enter the bootloader of the sensor.
  user_data_log = 11,  ///< USER_DATA_LOG: Log the user's data.
  get_user_conf_log = 12,  ///< GET_USER_CONF_LOG: Request the configuration of the log.
  user_conf_log = 13,  ///< USER_CONF_LOG: Configuration of the log.
};

/// Pins of the board that a host can switch.
/// Source: Variables L1154.
enum class BoardPin : std::uint8_t {
  rc_input_roll = 1,  ///< RC_INPUT_ROLL: The RC_ROLL pin.
  rc_input_pitch = 2,  ///< RC_INPUT_PITCH: The RC_PITCH pin.
  ext_fc_input_roll = 3,  ///< EXT_FC_INPUT_ROLL: The FC_ROLL pin.
  ext_fc_input_pitch = 4,  ///< EXT_FC_INPUT_PITCH: The FC_PITCH pin.
  rc_input_yaw = 5,  ///< RC_INPUT_YAW: The RC_YAW pin. Since board 3.0.
  pin_aux1 = 16,  ///< PIN_AUX1: The AUX1 pin; on 1.x boards, pin 2 of the microcontroller.
  pin_aux2 = 17,  ///< PIN_AUX2: The AUX2 pin; on 1.x boards, pin 11 of the microcontroller.
  pin_aux3 = 18,  ///< PIN_AUX3: The AUX3 pin; on 1.x boards, pin 12 of the microcontroller.
  pin_buzzer = 32,  ///< PIN_BUZZER: The buzzer; on 1.x boards, pin 32 of the microcontroller.
  /// PIN_SSAT_POWER: The 3.3 V supply of the Spektrum connector; LOW turns it on.
  pin_ssat_power = 33,
};

/// Pins that a host can switch.
/// Source: Variables L1154; Vendor's code of 2026.
enum class OutputPin : std::uint8_t {
  rc_input_roll = 1,  ///< RC_INPUT_ROLL: The RC_ROLL pin.
  rc_input_pitch = 2,  ///< RC_INPUT_PITCH: The RC_PITCH pin.
  ext_fc_input_roll = 3,  ///< EXT_FC_INPUT_ROLL: The FC_ROLL pin.
  ext_fc_input_pitch = 4,  ///< EXT_FC_INPUT_PITCH: The FC_PITCH pin.
  rc_input_yaw = 5,  ///< RC_INPUT_YAW: The RC_YAW pin. Since board 3.0.
  pin_aux1 = 16,  ///< PIN_AUX1: The AUX1 pin; on 1.x boards, pin 2 of the microcontroller.
  pin_aux2 = 17,  ///< PIN_AUX2: The AUX2 pin; on 1.x boards, pin 11 of the microcontroller.
  pin_aux3 = 18,  ///< PIN_AUX3: The AUX3 pin; on 1.x boards, pin 12 of the microcontroller.
  pin_buzzer = 32,  ///< PIN_BUZZER: The buzzer; on 1.x boards, pin 32 of the microcontroller.
  /// PIN_SSAT_POWER: The 3.3 V supply of the Spektrum connector; LOW turns it on.
  pin_ssat_power = 33,
  can_drv1_aux1 = 64,  ///< CAN_DRV1_AUX1: The AUX1 pin of CAN motor driver 1.
  can_drv1_aux2 = 65,  ///< CAN_DRV1_AUX2: The AUX2 pin of CAN motor driver 1.
  can_drv1_aux3 = 66,  ///< CAN_DRV1_AUX3: The AUX3 pin of CAN motor driver 1.
  can_drv2_aux1 = 67,  ///< CAN_DRV2_AUX1: The AUX1 pin of CAN motor driver 2.
  can_drv2_aux2 = 68,  ///< CAN_DRV2_AUX2: The AUX2 pin of CAN motor driver 2.
  can_drv2_aux3 = 69,  ///< CAN_DRV2_AUX3: The AUX3 pin of CAN motor driver 2.
  can_drv3_aux1 = 70,  ///< CAN_DRV3_AUX1: The AUX1 pin of CAN motor driver 3.
  can_drv3_aux2 = 71,  ///< CAN_DRV3_AUX2: The AUX2 pin of CAN motor driver 3.
  can_drv3_aux3 = 72,  ///< CAN_DRV3_AUX3: The AUX3 pin of CAN motor driver 3.
  can_drv4_aux1 = 73,  ///< CAN_DRV4_AUX1: The AUX1 pin of CAN motor driver 4.
  can_drv4_aux2 = 74,  ///< CAN_DRV4_AUX2: The AUX2 pin of CAN motor driver 4.
  can_drv4_aux3 = 75,  ///< CAN_DRV4_AUX3: The AUX3 pin of CAN motor driver 4.
  can_drv5_aux1 = 76,  ///< CAN_DRV5_AUX1: The AUX1 pin of CAN motor driver 5.
  can_drv5_aux2 = 77,  ///< CAN_DRV5_AUX2: The AUX2 pin of CAN motor driver 5.
  can_drv5_aux3 = 78,  ///< CAN_DRV5_AUX3: The AUX3 pin of CAN motor driver 5.
  can_drv6_aux1 = 79,  ///< CAN_DRV6_AUX1: The AUX1 pin of CAN motor driver 6.
  can_drv6_aux2 = 80,  ///< CAN_DRV6_AUX2: The AUX2 pin of CAN motor driver 6.
  can_drv6_aux3 = 81,  ///< CAN_DRV6_AUX3: The AUX3 pin of CAN motor driver 6.
  can_drv7_aux1 = 82,  ///< CAN_DRV7_AUX1: The AUX1 pin of CAN motor driver 7.
  can_drv7_aux2 = 83,  ///< CAN_DRV7_AUX2: The AUX2 pin of CAN motor driver 7.
  can_drv7_aux3 = 84,  ///< CAN_DRV7_AUX3: The AUX3 pin of CAN motor driver 7.
  can_imu_aux1 = 85,  ///< CAN_IMU_AUX1: The AUX1 pin of the main CAN IMU.
  can_imu_aux2 = 86,  ///< CAN_IMU_AUX2: The AUX2 pin of the main CAN IMU.
  can_imu_frame_aux1 = 88,  ///< CAN_IMU_FRAME_AUX1: The AUX1 pin of the CAN IMU of the frame.
  can_imu_frame_aux2 = 89,  ///< CAN_IMU_FRAME_AUX2: The AUX2 pin of the CAN IMU of the frame.
};

/// State of a pin.
/// Source: Variables L1155.
enum class PinState : std::uint8_t {
  low = 0,  ///< LOW: Low; sinks up to 40 mA.
  high = 1,  ///< HIGH: High; supplies up to 40 mA.
  floating = 2,  ///< FLOATING: Floating. Since firmware 2.66.
  input_pull_up = 3,  ///< INPUT_PULL_UP: An input that is pulled up. Since firmware 2.74.3.
  input_pull_down = 4,  ///< INPUT_PULL_DOWN: An input that is pulled down. Since firmware 2.74.3.
};

/// I2C bus of the board.
/// Source: Outgoing commands L829.
enum class I2cPort : std::uint8_t {
  main = 0,  ///< The bus of the sensors.
  second = 1,  ///< The bus of the EEPROM.
};

/// Module of CMD_MODULE_LIST.
/// Source: Later firmware.
enum class ModuleId : std::uint8_t {
  imu_main = 1,  ///< IMU_MAIN: Main IMU.
  imu_frame = 2,  ///< IMU_FRAME: Frame IMU.
  can_drv1 = 3,  ///< CAN_DRV1: CAN motor driver 1.
  can_drv2 = 4,  ///< CAN_DRV2: CAN motor driver 2.
  can_drv3 = 5,  ///< CAN_DRV3: CAN motor driver 3.
  can_drv4 = 6,  ///< CAN_DRV4: CAN motor driver 4.
  can_drv5 = 7,  ///< CAN_DRV5: CAN motor driver 5.
  can_drv6 = 8,  ///< CAN_DRV6: CAN motor driver 6.
  can_drv7 = 9,  ///< CAN_DRV7: CAN motor driver 7.
  gps_imu = 10,  ///< GPS_IMU: GPS_IMU.
  can_hub_gnss = 11,  ///< CAN_HUB_GNSS: CAN hub with a GNSS receiver.
  can_hub1 = 12,  ///< CAN_HUB1: CAN hub 1.
  can_hub2 = 13,  ///< CAN_HUB2: CAN hub 2.
  udrv1 = 14,  ///< UDRV1: uDrv module 1.
  udrv2 = 15,  ///< UDRV2: uDrv module 2.
  udrv3 = 16,  ///< UDRV3: uDrv module 3.
  udrv4 = 17,  ///< UDRV4: uDrv module 4.
};

/// Id of a device on the CAN bus.
/// Source: Later firmware.
enum class CanDeviceId : std::uint8_t {
  not_assigned = 0,  ///< NOT_ASSIGNED: None assigned.
  can_imu_main = 5,  ///< CAN_IMU_MAIN: Main IMU.
  can_imu_frame = 6,  ///< CAN_IMU_FRAME: Frame IMU.
  gps_imu_main = 7,  ///< GPS_IMU_MAIN: GPS_IMU as the main IMU.
  can_drv1 = 17,  ///< CAN_DRV1: CAN motor driver 1.
  can_drv2 = 18,  ///< CAN_DRV2: CAN motor driver 2.
  can_drv3 = 19,  ///< CAN_DRV3: CAN motor driver 3.
  can_drv4 = 20,  ///< CAN_DRV4: CAN motor driver 4.
  can_drv5 = 21,  ///< CAN_DRV5: CAN motor driver 5.
  can_drv6 = 22,  ///< CAN_DRV6: CAN motor driver 6.
  can_drv7 = 23,  ///< CAN_DRV7: CAN motor driver 7.
  can_imu_main_old = 28,  ///< CAN_IMU_MAIN_OLD: Main IMU of an older kind.
  can_imu_frame_old = 29,  ///< CAN_IMU_FRAME_OLD: Frame IMU of an older kind.
};

/// Kind of a device on the CAN bus.
/// Source: Later firmware.
enum class CanDeviceKind : std::uint8_t {
  motor_driver = 1,  ///< MOTOR_DRIVER: Motor driver.
  imu = 2,  ///< IMU: IMU.
};

/// Device at the far end of a transparent connection.
/// Source: Later firmware.
enum class TransparentDevice : std::uint8_t {
  sbgc32 = 1,  ///< SBGC32: The board itself.
  gps_imu = 2,  ///< GPS_IMU: GPS_IMU.
  can_imu_main = 3,  ///< CAN_IMU_MAIN: Main IMU.
  can_imu_frame = 4,  ///< CAN_IMU_FRAME: Frame IMU.
  gps_split_rcvr = 5,  ///< GPS_SPLIT_RCVR: Split GPS receiver.
  can_serial_hub1 = 6,  ///< CAN_SERIAL_HUB1: CAN hub 1.
  can_serial_hub2 = 7,  ///< CAN_SERIAL_HUB2: CAN hub 2.
  can_drv1 = 8,  ///< CAN_DRV1: CAN motor driver 1.
  can_drv2 = 9,  ///< CAN_DRV2: CAN motor driver 2.
  can_drv3 = 10,  ///< CAN_DRV3: CAN motor driver 3.
  can_drv4 = 11,  ///< CAN_DRV4: CAN motor driver 4.
};

/// Result of an operation on the board's file system.
/// Source: Outgoing commands L916-L928.
enum class FileError : std::uint8_t {
  no_error = 0,  ///< NO_ERROR: Success.
  eeprom_fault = 1,  ///< ERR_EEPROM_FAULT: The memory chip does not respond.
  file_not_found = 2,  ///< ERR_FILE_NOT_FOUND: No file has this id.
  fat = 3,  ///< ERR_FAT: The file table is damaged.
  no_free_space = 4,  ///< ERR_NO_FREE_SPACE: The memory is full.
  fat_is_full = 5,  ///< ERR_FAT_IS_FULL: The file table is full.
  file_size = 6,  ///< ERR_FILE_SIZE: The size is invalid.
  crc = 7,  ///< ERR_CRC: Checksum mismatch.
  limit_reached = 8,  ///< ERR_LIMIT_REACHED: The file system reached a limit.
  file_corrupted = 9,  ///< The file is damaged.
  wrong_params = 10,  ///< A value of the request is invalid.
};

/// Operation on a script.
/// Source: Outgoing commands L936.
enum class ScriptMode : std::uint8_t {
  stop = 0,  ///< Stop it.
  start = 1,  ///< Start it.
  start_debug = 2,  ///< Start it and report progress with CMD_SCRIPT_DEBUG.
};

/// Type of a debug variable.
/// Source: Variables L1188.
enum class DebugVarKind : std::uint8_t {
  uint8 = 1,  ///< VAR_TYPE_UINT8: Unsigned, 8 bits.
  int8 = 2,  ///< VAR_TYPE_INT8: Signed, 8 bits.
  uint16 = 3,  ///< VAR_TYPE_UINT16: Unsigned, 16 bits.
  int16 = 4,  ///< VAR_TYPE_INT16: Signed, 16 bits.
  uint32 = 5,  ///< VAR_TYPE_UINT32: Unsigned, 32 bits.
  int32 = 6,  ///< VAR_TYPE_INT32: Signed, 32 bits.
  float32 = 7,  ///< VAR_TYPE_FLOAT: Floating point, IEEE-754, 32 bits.
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
  no_axis = 0,  ///< None.
  roll = 16,  ///< VAR_FLAG_ROLL: Roll.
  pitch = 32,  ///< VAR_FLAG_PITCH: Pitch.
  yaw = 48,  ///< VAR_FLAG_YAW: Yaw.
};

/// Operation on the debug port.
/// Source: Later firmware.
enum class DebugPortAction : std::uint8_t {
  stop = 0,  ///< STOP: Stop copying messages.
  start = 1,  ///< START: Copy messages to this port.
};

/// Features of the board's hardware and firmware.
/// Source: Variables L1008.
enum class BoardFeature : std::uint16_t {
  three_axis = 0x0001,  ///< BOARD_FEATURE_3AXIS: Drives three motors.
  bat_monitoring = 0x0002,  ///< BOARD_FEATURE_BAT_MONITORING: Measures the battery voltage.
  encoders = 0x0004,  ///< BOARD_FEATURE_ENCODERS: Supports motor encoders.
  bode_test = 0x0008,  ///< BOARD_FEATURE_BODE_TEST: Can record a frequency response.
  scripting = 0x0010,  ///< BOARD_FEATURE_SCRIPTING: Runs user scripts.
  current_sensor = 0x0020,  ///< BOARD_FEATURE_CURRENT_SENSOR: Measures the supply current.
  mag_sensor = 0x0040,  ///< BOARD_FEATURE_MAG_SENSOR: Supports a magnetometer.
  /// BOARD_FEATURE_ORDER_OF_AXES_LETUS: Supports the order of axes of a Letus gimbal.
  order_of_axes_letus = 0x0080,
  imu_eeprom = 0x0100,  ///< BOARD_FEATURE_IMU_EEPROM: The main IMU has an EEPROM.
  frame_imu_eeprom = 0x0200,  ///< BOARD_FEATURE_FRAME_IMU_EEPROM: The frame IMU has an EEPROM.
  can_port = 0x0400,  ///< BOARD_FEATURE_CAN_PORT: Has a CAN bus.
  momentum = 0x0800,  ///< BOARD_FEATURE_MOMENTUM: Compensates the moment of inertia.
  /// BOARD_FEATURE_COGGING_CORRECTION: Corrects the cogging of motors.
  cogging_correction = 0x1000,
  motor4_control = 0x2000,  ///< BOARD_FEATURE_MOTOR4_CONTROL: Drives a fourth motor.
  /// BOARD_FEATURE_ACC_AUTO_CALIB: Calibrates the accelerometer automatically.
  acc_auto_calib = 0x4000,
  big_flash = 0x8000,  ///< BOARD_FEATURE_BIG_FLASH: Has a large flash memory.
};
using BoardFeatures = Flags<BoardFeature>;

/// More features of the board's hardware and firmware.
/// Source: Later firmware.
enum class BoardFeaturesExtBit : std::uint16_t {
  ext_imu = 0x0001,  ///< EXT_IMU: Supports an external IMU.
  state_vars = 0x0004,  ///< STATE_VARS: Keeps statistics; see CMD_READ_STATE_VARS.
  power_management = 0x0008,  ///< POWER_MANAGEMENT: Manages its power supply.
  /// GYRO_ADVANCED_CALIB: Has an advanced calibration of the gyroscope.
  gyro_advanced_calib = 0x0010,
  limited_version = 0x0020,  ///< LIMITED_VERSION: Has a limited set of functions.
  reaction = 0x0040,  ///< REACTION: Has a feature of this name, which no source explains.
  encoder_lut = 0x0080,  ///< ENCODER_LUT: Corrects encoders with a lookup table.
};
using BoardFeaturesExt = Flags<BoardFeaturesExtBit>;

/// Features of the board from firmware 2.73 on.
/// Source: Later firmware.
enum class BoardFeaturesExt2Bit : std::uint32_t {
  plus_ver = 0x00000001,  ///< PLUS_VER: The firmware is a "plus" version.
  shake_generator = 0x00000002,  ///< SHAKE_GENERATOR: Can shake the camera on purpose.
  ext_motors = 0x00000004,  ///< EXT_MOTORS: Drives auxiliary motors.
  quat_control = 0x00000008,  ///< QUAT_CONTROL: Can be controlled with quaternions.
  adc4 = 0x00000010,  ///< ADC4: Has a fourth analog input.
};
using BoardFeaturesExt2 = Flags<BoardFeaturesExt2Bit>;

/// State of the board.
/// Source: Later firmware.
enum class BoardStateFlag : std::uint8_t {
  debug_mode = 0x01,  ///< DEBUG_MODE: A host should show its debug output.
  is_frame_inverted = 0x02,  ///< IS_FRAME_INVERTED: The frame is upside down.
  init_step1_done = 0x04,  ///< INIT_STEP1_DONE: The first step of the start-up is done.
  init_step2_done = 0x08,  ///< INIT_STEP2_DONE: The second step of the start-up is done.
  /// STARTUP_AUTO_ROUTINE_DONE: The automatic actions at start-up are done.
  startup_auto_routine_done = 0x10,
  power_manager_enabled = 0x20,  ///< POWER_MANAGER_ENABLED: Power management is on.
};
using BoardStateFlags = Flags<BoardStateFlag>;

/// Hardware on the board.
/// Source: Later firmware.
enum class HardwareFlag : std::uint16_t {
  one_wire_crypto_ic = 0x0001,  ///< ONE_WIRE_CRYPTO_IC: A one-wire crypto chip is installed.
};
using HardwareFlags = Flags<HardwareFlag>;

/// Profile sets in the board's memory.
/// Source: Later firmware.
enum class StoredProfileSet : std::uint8_t {
  set1 = 0x01,  ///< PROFILE_SET1: Profile set 1.
  set2 = 0x02,  ///< PROFILE_SET2: Profile set 2.
  set3 = 0x04,  ///< PROFILE_SET3: Profile set 3.
  set4 = 0x08,  ///< PROFILE_SET4: Profile set 4.
  set5 = 0x10,  ///< PROFILE_SET5: Profile set 5.
  set_backup = 0x20,  ///< PROFILE_SET_BACKUP: The backup.
};
using StoredProfileSets = Flags<StoredProfileSet>;

/// How the host is connected to the board.
/// Source: Variables L1009.
enum class ConnectionFlag : std::uint8_t {
  usb = 0x01,  ///< CONNECTION_USB: The host is connected over USB, not over a UART.
};
using ConnectionFlags = Flags<ConnectionFlag>;

/// What the board does before a restart.
/// Source: Outgoing commands L676, L685.
enum class ResetOption : std::uint8_t {
  notify = 0x01,  ///< Send CMD_RESET back first.
  /// RESTORE_STATE: Keep the state and restore it after the restart; not for CMD_BOOT_MODE_3.
  restore_state = 0x02,
};
using ResetOptions = Flags<ResetOption>;

/// What a password protects.
/// Source: Vendor's code of 2026.
enum class PassProtectFlag : std::uint32_t {
  encrypt_params = 0x00000002,  ///< ENCRYPT_PARAMS: Parameters are encrypted.
  /// SILENT: By its name, protected ports do not respond without the password.
  silent = 0x00000004,
  channel_1_enabled = 0x00000010,  ///< CHANNEL_1_ENABLED: Port 1 is protected, by the name.
  channel_2_enabled = 0x00000020,  ///< CHANNEL_2_ENABLED: Port 2 is protected, by the name.
  channel_3_enabled = 0x00000040,  ///< CHANNEL_3_ENABLED: Port 3 is protected, by the name.
  channel_4_enabled = 0x00000080,  ///< CHANNEL_4_ENABLED: Port 4 is protected, by the name.
  channel_5_enabled = 0x00000100,  ///< CHANNEL_5_ENABLED: Port 5 is protected, by the name.
  channel_6_enabled = 0x00000200,  ///< CHANNEL_6_ENABLED: Port 6 is protected, by the name.
  /// CHANNEL_1_ALLOW_CONTROL: Port 1 accepts control without the password, by the name.
  channel_1_allow_control = 0x00000400,
  /// CHANNEL_2_ALLOW_CONTROL: Port 2 accepts control without the password, by the name.
  channel_2_allow_control = 0x00000800,
  /// CHANNEL_3_ALLOW_CONTROL: Port 3 accepts control without the password, by the name.
  channel_3_allow_control = 0x00001000,
  /// CHANNEL_4_ALLOW_CONTROL: Port 4 accepts control without the password, by the name.
  channel_4_allow_control = 0x00002000,
  /// CHANNEL_5_ALLOW_CONTROL: Port 5 accepts control without the password, by the name.
  channel_5_allow_control = 0x00004000,
  /// CHANNEL_6_ALLOW_CONTROL: Port 6 accepts control without the password, by the name.
  channel_6_allow_control = 0x00008000,
};
using PassProtectFlags = Flags<PassProtectFlag>;

/// Enabled filters of an axis; 0 disables all.
/// Source: Variables L1084.
enum class FilterSwitch : std::uint8_t {
  notch1 = 0x01,  ///< EN_NOTCH1: First notch filter.
  notch2 = 0x02,  ///< EN_NOTCH2: Second notch filter.
  notch3 = 0x04,  ///< EN_NOTCH3: Third notch filter.
  lpf = 0x08,  ///< EN_LPF: Low-pass filter.
};
using FilterSwitches = Flags<FilterSwitch>;

/// Options in the upper half of the encoder type byte.
/// Source: Variables L1100.
enum class EncoderFlag : std::uint8_t {
  skip_detection = 0x10,  ///< SKIP_DETECTION: Do not detect whether the encoder is present.
  encoder_is_geared = 0x80,  ///< ENCODER_IS_GEARED: There is a gear between motor and encoder.
};
using EncoderFlags = Flags<EncoderFlag>;

/// When the board makes a sound.
/// Source: Variables L1058.
enum class BeeperMode : std::uint8_t {
  calibrate = 0x01,  ///< BEEPER_MODE_CALIBRATE: During calibrations.
  confirm = 0x02,  ///< BEEPER_MODE_CONFIRM: To confirm commands.
  error = 0x04,  ///< BEEPER_MODE_ERROR: On errors.
  alarm = 0x08,  ///< BEEPER_MODE_ALARM: On alarms.
  by_motors = 0x80,  ///< BEEP_BY_MOTORS: The motors make the sound instead of the buzzer.
};
using BeeperModes = Flags<BeeperMode>;

/// Axes with adaptive PID control; 0 disables it.
/// Source: Variables L1067.
enum class AdaptivePidAxis : std::uint8_t {
  roll = 0x01,  ///< EN_ROLL: Roll.
  pitch = 0x02,  ///< EN_PITCH: Pitch.
  yaw = 0x04,  ///< EN_YAW: Yaw.
};
using AdaptivePidAxes = Flags<AdaptivePidAxis>;

/// Options of the whole board.
/// Source: Variables L1073.
enum class GeneralFlag : std::uint16_t {
  /// REMEMBER_LAST_USED_PROFILE: Start with the last used profile.
  remember_last_used_profile = 0x0001,
  upside_down_auto = 0x0002,  ///< UPSIDE_DOWN_AUTO: Detect an upside-down frame.
  swap_frame_main_imu = 0x0004,  ///< SWAP_FRAME_MAIN_IMU: Swap frame IMU and main IMU.
  blink_profile = 0x0008,  ///< BLINK_PROFILE: Blink the profile number.
  emergency_stop = 0x0010,  ///< EMERGENCY_STOP: Stop in an emergency.
  magnetometer_pos_frame = 0x0020,  ///< MAGNETOMETER_POS_FRAME: The magnetometer is on the frame.
  frame_imu_ff = 0x0040,  ///< FRAME_IMU_FF: Feed forward from the frame IMU.
  overheat_stop_motors = 0x0080,  ///< OVERHEAT_STOP_MOTORS: Stop the motors when they overheat.
  center_yaw_at_startup = 0x0100,  ///< CENTER_YAW_AT_STARTUP: Center yaw at start-up.
  swap_rc_serial_uart_b = 0x0200,  ///< SWAP_RC_SERIAL_UART_B: Swap the serial RC input and UART B.
  uart_b_serial_api = 0x0400,  ///< UART_B_SERIAL_API: UART B speaks this protocol.
  blink_bat_level = 0x0800,  ///< BLINK_BAT_LEVEL: Blink the battery level.
  adaptive_gyro_trust = 0x1000,  ///< ADAPTIVE_GYRO_TRUST: Adapt the trust in the gyroscope.
  is_upside_down = 0x2000,  ///< IS_UPSIDE_DOWN: The frame is upside down. Since firmware 2.66.
  /// UART_3_SERIAL_API: UART 3 speaks this protocol. Since firmware 2.66.
  uart_3_serial_api = 0x4000,
  /// FRAME_INV_RC_INV: Invert the RC signals while the frame is upside down. Since firmware 2.66.
  frame_inv_rc_inv = 0x8000,
};
using GeneralFlags = Flags<GeneralFlag>;

/// More options of the whole board.
/// Source: Later firmware.
enum class GeneralFlags2Bit : std::uint16_t {
  /// SEARCH_LIMIT_ROLL: Search the mechanical limits of roll at start-up. Since firmware 2.61.
  search_limit_roll = 0x0001,
  /// SEARCH_LIMIT_PITCH: Search the mechanical limits of pitch at start-up. Since firmware 2.61.
  search_limit_pitch = 0x0002,
  /// SEARCH_LIMIT_YAW: Search the mechanical limits of yaw at start-up. Since firmware 2.61.
  search_limit_yaw = 0x0004,
  /// AUTO_CALIBRATE_MOMENTUM: Calibrate the momentum automatically. Since firmware 2.62b7.
  auto_calibrate_momentum = 0x0008,
  /// USE_MOMENTUM_FEED_FORWARD: Feed forward from the momentum. Since firmware 2.62b7.
  use_momentum_feed_forward = 0x0010,
  /// MOTORS_OFF_AT_STARTUP: Leave the motors off at start-up. Since firmware 2.62b7.
  motors_off_at_startup = 0x0020,
  /// FC_BELOW_OUTER: The flight controller is below the outer motor. Since firmware 2.62b7.
  fc_below_outer = 0x0040,
  /// DO_NOT_CHECK_ENCODER_LIMITS: Do not check the limits of the encoders. Since firmware 2.66.
  do_not_check_encoder_limits = 0x0080,
  /// AUTO_SAVE_BACKUP_SLOT: Save the profiles to the backup slot automatically. Since firmware
  /// 2.66.
  auto_save_backup_slot = 0x0100,
  /// FC_BELOW_MIDDLE: The flight controller is below the middle motor. Since firmware 2.66.
  fc_below_middle = 0x0200,
  /// ENVIRONMENT_TEMP_UNKNOWN: The temperature of the environment is unknown. Since firmware
  /// 2.67b2.
  environment_temp_unknown = 0x0400,
  /// LPF_EXTENDED_RANGE: The low-pass filters of RC signals range to 255, not 15. Since firmware
  /// 2.67b2.
  lpf_extended_range = 0x0800,
  /// SAVE_SYSTEM_STAT: Save statistics of the system. Since firmware 2.67b2.
  save_system_stat = 0x1000,
  disable_acc = 0x2000,  ///< DISABLE_ACC: Do not use the accelerometer. Since firmware 2.67b2.
  /// DISABLE_POWER_MANAGER: Do not use the power manager. Since firmware 2.67b2.
  disable_power_manager = 0x4000,
  /// ALLOW_ONBOARD_IMU_AS_MAIN: The IMU on the board may be the main IMU. Since firmware 2.67b2.
  allow_onboard_imu_as_main = 0x8000,
};
using GeneralFlags2 = Flags<GeneralFlags2Bit>;

/// Options of one profile.
/// Source: Variables L1074.
enum class ProfileFlag : std::uint16_t {
  /// ADC1_AUTO_DETECTION: Detect whether analog input 1 is connected.
  adc1_auto_detection = 0x0001,
  /// ADC2_AUTO_DETECTION: Detect whether analog input 2 is connected.
  adc2_auto_detection = 0x0002,
  /// ADC3_AUTO_DETECTION: Detect whether analog input 3 is connected.
  adc3_auto_detection = 0x0004,
  follow_use_frame_imu = 0x0010,  ///< FOLLOW_USE_FRAME_IMU: Follow mode uses the frame IMU.
  /// BRIEFCASE_AUTO_DETECTION: Detect when the gimbal is carried like a briefcase.
  briefcase_auto_detection = 0x0020,
  /// UPSIDE_DOWN_AUTO_ROTATE: Turn the camera when the frame is upside down.
  upside_down_auto_rotate = 0x0040,
  /// FOLLOW_LOCK_OFFSET_CORRECTION: Do not correct the offset in follow mode.
  follow_lock_offset_correction = 0x0080,
  start_neutral_position = 0x0100,  ///< START_NEUTRAL_POSITION: Start in the neutral position.
  /// MENU_BUTTON_DISABLE_FOLLOW: The menu button suspends the follow mode.
  menu_button_disable_follow = 0x0200,
  /// TIMELAPSE_FRAME_FIXED: The frame does not move during a time lapse.
  timelapse_frame_fixed = 0x0400,
  rc_keep_mix_rate = 0x0800,  ///< RC_KEEP_MIX_RATE: Keep the mix rate of the RC channels.
  /// RC_KEEP_CUR_POS_ON_INIT: Keep the current position when RC control starts.
  rc_keep_cur_pos_on_init = 0x1000,
  /// OUTER_MOTOR_LIMIT_FREE_ROTATION: Limit the free rotation of the outer motor. Since firmware
  /// 2.66.
  outer_motor_limit_free_rotation = 0x2000,
  /// EULER_ORDER_AUTO: Select the order of the Euler angles automatically. Since firmware 2.67b1.
  /// Unconfirmed.
  euler_order_auto = 0x4000,
  /// CAM_UPSIDE_DOWN_WORKING: The camera may work upside down. Unconfirmed.
  cam_upside_down_working = 0x8000,
};
using ProfileFlags = Flags<ProfileFlag>;

/// Limits at which an axis parks.
/// Source: Later firmware.
enum class ParkingBorder : std::uint8_t {
  roll_neg = 0x01,  ///< ROLL_NEG: The lower limit of roll.
  roll_pos = 0x02,  ///< ROLL_POS: The upper limit of roll.
  pitch_neg = 0x04,  ///< PITCH_NEG: The lower limit of pitch.
  pitch_pos = 0x08,  ///< PITCH_POS: The upper limit of pitch.
  yaw_neg = 0x10,  ///< YAW_NEG: The lower limit of yaw.
  yaw_pos = 0x20,  ///< YAW_POS: The upper limit of yaw.
};
using ParkingBorders = Flags<ParkingBorder>;

/// Options of the order of the Euler angles.
/// Source: Later firmware.
enum class EulerOrderFlag : std::uint8_t {
  /// CONTROL_LOCAL_XYZ: Control commands turn the camera about its own axes; not for LOCAL_ROLL and
  /// ROLL_LOCAL.
  control_local_xyz = 0x10,
  /// STAB_CONTROL_LOCAL_XYZ: Stabilization and control use the camera's own axes; not for
  /// LOCAL_ROLL and ROLL_LOCAL. Since firmware 2.74.
  stab_control_local_xyz = 0x20,
};
using EulerOrderFlags = Flags<EulerOrderFlag>;

/// Use of the external IMU.
/// Source: Later firmware.
enum class ExtImuFlag : std::uint16_t {
  acc_comp_only = 0x0002,  ///< ACC_COMP_ONLY: Only compensate linear accelerations.
  replace = 0x0004,  ///< REPLACE: Replace the attitude of the internal IMU.
  z = 0x0008,  ///< Z: Correct the vertical.
  h = 0x0010,  ///< H: Correct the heading.
  /// FRAME_UPSIDE_DOWN_UPDATE: Take into account that the frame is upside down.
  frame_upside_down_update = 0x0020,
  as_frame_imu = 0x0040,  ///< AS_FRAME_IMU: Use it as the frame IMU.
  gyro_corr = 0x0080,  ///< GYRO_CORR: Correct the gyroscope. Since firmware 2.68b7.
};
using ExtImuFlags = Flags<ExtImuFlag>;

/// Still more options of the whole board.
/// Source: Later firmware.
enum class GeneralFlags3Bit : std::uint32_t {
  enc_lut_en_roll = 0x00000001,  ///< ENC_LUT_EN_ROLL: Use the look-up table of the roll encoder.
  enc_lut_en_pitch = 0x00000002,  ///< ENC_LUT_EN_PITCH: Use the look-up table of the pitch encoder.
  enc_lut_en_yaw = 0x00000004,  ///< ENC_LUT_EN_YAW: Use the look-up table of the yaw encoder.
  /// MAVLINK_YAW_ABSOLUTE: The yaw of MAVLink commands is absolute.
  mavlink_yaw_absolute = 0x00000008,
  /// EXT_SENS_AS_REFERENCE: Use the external sensor as a reference.
  ext_sens_as_reference = 0x00000010,
  disable_bt = 0x00000020,  ///< DISABLE_BT: Turn Bluetooth off.
  /// ALLOW_SENSOR_RECOVERY: Try to recover a sensor that fails.
  allow_sensor_recovery = 0x00000040,
  uart2_alt = 0x00000080,  ///< UART2_ALT: Use the alternative pins of UART 2.
  pass_limit_roll = 0x00000100,  ///< PASS_LIMIT_ROLL: Roll may pass its limits.
  pass_limit_pitch = 0x00000200,  ///< PASS_LIMIT_PITCH: Pitch may pass its limits.
  pass_limit_yaw = 0x00000400,  ///< PASS_LIMIT_YAW: Yaw may pass its limits.
  /// DONT_PUSH_SOFT_LIMITS_ROLL: Do not push roll away from its software limits.
  dont_push_soft_limits_roll = 0x00000800,
  /// DONT_PUSH_SOFT_LIMITS_PITCH: Do not push pitch away from its software limits.
  dont_push_soft_limits_pitch = 0x00001000,
  /// DONT_PUSH_SOFT_LIMITS_YAW: Do not push yaw away from its software limits.
  dont_push_soft_limits_yaw = 0x00002000,
  tripod_mode_auto = 0x00004000,  ///< TRIPOD_MODE_AUTO: Start the tripod mode automatically.
  /// TRIPOD_MODE_GYRO_ONLINE_CALIB: Calibrate the gyroscope in tripod mode.
  tripod_mode_gyro_online_calib = 0x00008000,
  /// RETRACTED_POSITION_MOTORS_OFF: Turn the motors off in the retracted position.
  retracted_position_motors_off = 0x00010000,
  /// CAN_IMU_THERMOSTAT_ENABLE: The CAN IMU keeps its temperature constant.
  can_imu_thermostat_enable = 0x00020000,
  /// RETRACTED_POSITION_SHORTEST: Take the shortest path to the retracted position.
  retracted_position_shortest = 0x00040000,
  /// RETRACTED_POSITION_RC_CONTROL: RC controls the retracted position.
  retracted_position_rc_control = 0x00080000,
  /// ACC_LIMIT_EXT_RANGE: The acceleration limits have a wider range.
  acc_limit_ext_range = 0x00100000,
  move_short_path_roll = 0x00200000,  ///< MOVE_SHORT_PATH_ROLL: Roll moves on the shortest path.
  move_short_path_pitch = 0x00400000,  ///< MOVE_SHORT_PATH_PITCH: Pitch moves on the shortest path.
  move_short_path_yaw = 0x00800000,  ///< MOVE_SHORT_PATH_YAW: Yaw moves on the shortest path.
  /// FRAME_INV_SOFT_LIMIT_MIDDLE: An upside-down frame changes the software limits of the middle
  /// motor.
  frame_inv_soft_limit_middle = 0x01000000,
  /// FRAME_INV_SOFT_LIMIT_OUTER: An upside-down frame changes the software limits of the outer
  /// motor.
  frame_inv_soft_limit_outer = 0x02000000,
  /// CAN_IMU_SERVO1_DUTY_MODE: Servo output 1 of the CAN IMU sets the duty cycle.
  can_imu_servo1_duty_mode = 0x04000000,
  /// CAN_IMU_SERVO2_DUTY_MODE: Servo output 2 of the CAN IMU sets the duty cycle.
  can_imu_servo2_duty_mode = 0x08000000,
};
using GeneralFlags3 = Flags<GeneralFlags3Bit>;

/// The last options of the whole board.
/// Source: Later firmware.
enum class GeneralFlags4Bit : std::uint32_t {
  /// ACC_LIMIT_BY_MOMENTUM: The momentum determines the acceleration limits.
  acc_limit_by_momentum = 0x00000001,
  /// CALIB_MOMENTUM_IN_NORMAL_POS: Calibrate the momentum in the normal position.
  calib_momentum_in_normal_pos = 0x00000002,
  /// EULER_MIDDLE_AXIS: The middle axis determines the initial Euler angles. Unconfirmed.
  euler_middle_axis = 0x00000004,
  /// EULER_MATCH_MOTOR_ROTATION: The rotation of the motors determines the initial Euler angles.
  /// Unconfirmed.
  euler_match_motor_rotation = 0x00000008,
};
using GeneralFlags4 = Flags<GeneralFlags4Bit>;

/// More options of one profile.
/// Source: Later firmware.
enum class ProfileFlags2Bit : std::uint16_t {
  follow_pitch_disabled = 0x0001,  ///< FOLLOW_PITCH_DISABLED: Pitch does not follow the frame.
  low_angle_prior_roll = 0x0002,  ///< LOW_ANGLE_PRIOR_ROLL: Roll prefers small angles.
  low_angle_prior_pitch = 0x0004,  ///< LOW_ANGLE_PRIOR_PITCH: Pitch prefers small angles.
  low_angle_prior_yaw = 0x0008,  ///< LOW_ANGLE_PRIOR_YAW: Yaw prefers small angles.
  heading_tripod_mode = 0x0010,  ///< HEADING_TRIPOD_MODE: The tripod mode applies to the heading.
  mot_roll_disabled = 0x0020,  ///< MOT_ROLL_DISABLED: The roll motor is off.
  mot_pitch_disabled = 0x0040,  ///< MOT_PITCH_DISABLED: The pitch motor is off.
  mot_yaw_disabled = 0x0080,  ///< MOT_YAW_DISABLED: The yaw motor is off.
  rc_out_duty1 = 0x0100,  ///< RC_OUT_DUTY1: Servo output 1 sets the duty cycle.
  rc_out_duty2 = 0x0200,  ///< RC_OUT_DUTY2: Servo output 2 sets the duty cycle.
  rc_out_duty3 = 0x0400,  ///< RC_OUT_DUTY3: Servo output 3 sets the duty cycle.
  rc_out_duty4 = 0x0800,  ///< RC_OUT_DUTY4: Servo output 4 sets the duty cycle.
  disable_follow_startup = 0x1000,  ///< DISABLE_FOLLOW_STARTUP: Do not follow at start-up.
  servo_mode = 0x2000,  ///< SERVO_MODE: Servo mode.
  /// RC_EXPO_DEADBAND_SPLIT: Pitch and yaw have their own RC dead band and expo rate.
  rc_expo_deadband_split = 0x4000,
};
using ProfileFlags2 = Flags<ProfileFlags2Bit>;

/// Still more options of one profile.
/// Source: Later firmware.
enum class ProfileFlags3Bit : std::uint32_t {
  /// ACC_LIMIT_AUTO_R: The board determines the acceleration limit of roll.
  acc_limit_auto_r = 0x00000001,
  /// ACC_LIMIT_AUTO_P: The board determines the acceleration limit of pitch.
  acc_limit_auto_p = 0x00000002,
  /// ACC_LIMIT_AUTO_Y: The board determines the acceleration limit of yaw.
  acc_limit_auto_y = 0x00000004,
  shake_generator_enabled = 0x00000008,  ///< SHAKE_GENERATOR_ENABLED: The shake generator runs.
  err_corr_long_r = 0x00000010,  ///< ERR_CORR_LONG_R: Correct long errors of roll.
  err_corr_long_p = 0x00000020,  ///< ERR_CORR_LONG_P: Correct long errors of pitch.
  err_corr_long_y = 0x00000040,  ///< ERR_CORR_LONG_Y: Correct long errors of yaw.
};
using ProfileFlags3 = Flags<ProfileFlags3Bit>;

/// Errors detected by the board.
/// Source: Variables L1128-L1130.
enum class SystemError : std::uint16_t {
  no_sensor = 0x0001,  ///< ERR_NO_SENSOR: The IMU sensor does not respond.
  calib_acc = 0x0002,  ///< ERR_CALIB_ACC: The accelerometer is not calibrated.
  set_power = 0x0004,  ///< ERR_SET_POWER: The motor power is not set.
  calib_poles = 0x0008,  ///< ERR_CALIB_POLES: The motor poles are not calibrated.
  protection = 0x0010,  ///< ERR_PROTECTION: The driver protection tripped.
  serial = 0x0020,  ///< ERR_SERIAL: Errors on the serial line.
  low_bat1 = 0x0040,  ///< ERR_LOW_BAT1: The battery is below the alarm threshold.
  low_bat2 = 0x0080,  ///< ERR_LOW_BAT2: The battery is below the motor stop threshold.
  gui_version = 0x0100,  ///< ERR_GUI_VERSION: The host software does not match the firmware.
  miss_steps = 0x0200,  ///< ERR_MISS_STEPS: A motor lost steps.
  system = 0x0400,  ///< ERR_SYSTEM: System error.
  /// ERR_EMERGENCY_STOP: Emergency stop; SYSTEM_SUB_ERROR gives the reason.
  emergency_stop = 0x0800,
};
using SystemErrors = Flags<SystemError>;

/// State of the motors.
/// Source: Variables L1133.
enum class OtherFlag : std::uint8_t {
  motors_on = 0x01,  ///< The motors are on.
};
using OtherFlags = Flags<OtherFlag>;

/// Data blocks of CMD_REALTIME_DATA_CUSTOM.
/// Source: Variables L1209; Later firmware.
enum class RealtimeDataCustomFlag : std::uint32_t {
  imu_angles = 0x00000001,  ///< Angles of the main IMU.
  target_angles = 0x00000002,  ///< RC target angles.
  target_speed = 0x00000004,  ///< RC target speed.
  stator_rotor_angle = 0x00000008,  ///< Joint angles.
  gyro_data = 0x00000010,  ///< Gyroscope of the IMU.
  rc_data = 0x00000020,  ///< RC signals of the standard inputs.
  z1_h1_vectors = 0x00000040,  ///< Attitude of the IMU as a rotation matrix.
  rc_channels = 0x00000080,  ///< All RC channels of S.BUS, Sum-PPM or Spektrum.
  acc_data = 0x00000100,  ///< Accelerometer of the IMU.
  motor4_control = 0x00000200,  ///< MOTOR4_CONTROL: Control of a fourth motor.
  ahrs_debug_info = 0x00000400,  ///< AHRS_DEBUG_INFO: State of the attitude estimation.
  encoder_raw24 = 0x00000800,  ///< ENCODER_RAW24: Raw values of the encoders. Since firmware 2.68.
  /// IMU_ANGLES_RAD: Angles of the main IMU in radians. Since firmware 2.68b7.
  imu_angles_rad = 0x00001000,
  script_vars_float = 0x00002000,  ///< SCRIPT_VARS_FLOAT: Floating-point variables of the script.
  script_vars_int16 = 0x00004000,  ///< SCRIPT_VARS_INT16: Integer variables of the script.
  /// SYSTEM_POWER_STATE: State of the motors and of the supply. Since firmware 2.70b6.
  system_power_state = 0x00008000,
  /// FRAME_CAM_RATE: Speed of the camera relative to the frame. Since firmware 2.70b6.
  frame_cam_rate = 0x00010000,
  /// IMU_ANGLES_20: Angles of the main IMU in high resolution. Since firmware 2.70b8.
  imu_angles_20 = 0x00020000,
  /// TARGET_ANGLES_20: Target angles in high resolution. Since firmware 2.70b8.
  target_angles_20 = 0x00040000,
  /// COMM_ERRORS: Counters of communication errors. Since firmware 2.72.
  comm_errors = 0x00080000,
  system_state = 0x00100000,  ///< SYSTEM_STATE: State of the system. Since firmware 2.73.
  /// IMU_QUAT: Attitude of the main IMU as a quaternion. Since firmware 2.73.
  imu_quat = 0x00200000,
  target_quat = 0x00400000,  ///< TARGET_QUAT: Target attitude as a quaternion. Since firmware 2.73.
  /// IMU_TO_FRAME_QUAT: Rotation from the main IMU to the frame as a quaternion. Since firmware
  /// 2.73.
  imu_to_frame_quat = 0x00800000,
  adc_ch_raw = 0x01000000,  ///< ADC_CH_RAW: Raw values of the analog inputs. Since firmware 2.73.
  /// SW_LIMITS_DIST: Distances to the software limits. Since firmware 2.73.8.
  sw_limits_dist = 0x02000000,
  follow_dist = 0x04000000,  ///< FOLLOW_DIST: Distance in follow mode. Since firmware 2.73.8.
  ext_target_limit = 0x08000000,  ///< Limits of an external target. Since firmware 2.73.8.
  frame_cam_angle_20 = 0x10000000,  ///< FRAME_CAM_ANGLE_20: Joint angles in high resolution.
  main_imu_state = 0x20000000,  ///< MAIN_IMU_STATE: State of the main IMU.
  include_flags = 0x80000000,  ///< INCLUDE_FLAGS: FLAGS in each sample.
};
using RealtimeDataCustomFlags = Flags<RealtimeDataCustomFlag>;

/// Data blocks of CMD_REALTIME_DATA_CUSTOM2.
/// Source: Vendor's code of 2026.
enum class RealtimeDataCustom2Flag : std::uint32_t {
  frame_imu_angles = 0x00000001,  ///< FRAME_IMU_ANGLES: Angles of the frame IMU.
  frame_gyro = 0x00000002,  ///< FRAME_GYRO: Gyroscope of the frame IMU.
  frame_acc = 0x00000004,  ///< FRAME_ACC: Accelerometer of the frame IMU.
  debug = 0x00000008,  ///< DEBUG: Values for debugging.
  mag_sens_data = 0x00000010,  ///< MAG_SENS_DATA: Magnetometer.
  pin_state = 0x00000020,  ///< PIN_STATE: State of the inputs.
  /// STAB_ERR_AMPL: Amplitude of the stabilization error. Since firmware 2.74.4.
  stab_err_ampl = 0x00000040,
  include_flags = 0x80000000,  ///< INCLUDE_FLAGS: FLAGS in each sample.
};
using RealtimeDataCustom2Flags = Flags<RealtimeDataCustom2Flag>;

/// State of the system.
/// Source: Later firmware.
enum class StateFlag : std::uint32_t {
  debug_mode = 0x00000001,  ///< DEBUG_MODE: A host should show its debug output.
  is_frame_inverted = 0x00000002,  ///< IS_FRAME_INVERTED: The frame is upside down.
  init_step1_done = 0x00000004,  ///< INIT_STEP1_DONE: The first step of the start-up is done.
  init_step2_done = 0x00000008,  ///< INIT_STEP2_DONE: The second step of the start-up is done.
  /// STARTUP_AUTO_ROUTINE_DONE: The automatic actions at start-up are done.
  startup_auto_routine_done = 0x00000010,
  power_manager_enabled = 0x00000020,  ///< POWER_MANAGER_ENABLED: Power management is on.
  shake_gen_enabled = 0x00000100,  ///< SHAKE_GEN_ENABLED: The shake generator is enabled.
  servo_mode_enabled = 0x00000200,  ///< SERVO_MODE_ENABLED: The servo mode is enabled.
  follow_mode_roll = 0x00000400,  ///< FOLLOW_MODE_ROLL: Roll is in follow mode.
  follow_mode_pitch = 0x00000800,  ///< FOLLOW_MODE_PITCH: Pitch is in follow mode.
  follow_mode_yaw = 0x00001000,  ///< FOLLOW_MODE_YAW: Yaw is in follow mode.
  /// TRIPOD_MODE_ENABLED: The tripod mode is enabled. Since firmware 2.73.9.
  tripod_mode_enabled = 0x00002000,
  /// RETRACTED_POSITION: The camera is in its retracted position. Since firmware 2.74.
  retracted_position = 0x00004000,
};
using StateFlags = Flags<StateFlag>;

/// State of a motor.
/// Source: Later firmware.
enum class MotorPowerFlag : std::uint16_t {
  sw_limit_violated = 0x0001,  ///< SW_LIMIT_VIOLATED: The motor is beyond a software limit.
  current_exceeds_limit = 0x0002,  ///< CURRENT_EXCEEDS_LIMIT: The current exceeds its limit.
  driver_enabled = 0x0004,  ///< DRIVER_ENABLED: The driver is enabled.
};
using MotorPowerFlags = Flags<MotorPowerFlag>;

/// Problems with the motors or their drivers.
/// Source: Later firmware.
enum class SystemPowerFlag : std::uint16_t {
  sw_limit_violated = 0x0001,  ///< SW_LIMIT_VIOLATED: A motor is beyond a software limit.
  overheat_warning = 0x0002,  ///< OVERHEAT_WARNING: A motor or a driver is too warm.
  /// DRIVER_OTW: A motor driver reports an overtemperature warning. Unconfirmed.
  driver_otw = 0x0004,
  driver_fault = 0x0008,  ///< DRIVER_FAULT: A motor driver failed. Unconfirmed.
};
using SystemPowerFlags = Flags<SystemPowerFlag>;

/// State of the CAN bus.
/// Source: Later firmware.
enum class CanErrorFlag : std::uint8_t {
  warn = 0x01,  ///< WARN: The number of errors exceeds the warning level.
  passive = 0x02,  ///< PASSIVE: The controller is error-passive.
  bus_off = 0x04,  ///< BUS_OFF: The controller has left the bus.
};
using CanErrorFlags = Flags<CanErrorFlag>;

/// Data of CMD_CAN_DRV_TELEMETRY.
/// Source: Later firmware.
enum class CanDrvTelemetryFlag : std::uint32_t {
  can_bus_flags = 0x00000001,  ///< CAN_BUS_FLAGS: State of the CAN bus.
  can_bus_err_cnt = 0x00000002,  ///< CAN_BUS_ERR_CNT: Errors of the CAN bus.
  temp_board = 0x00000004,  ///< TEMP_BOARD: Temperature of the driver.
  temp_motor = 0x00000008,  ///< TEMP_MOTOR: Temperature of the motor.
  avg_current = 0x00000010,  ///< AVG_CURRENT: Average current.
  bus_voltage = 0x00000020,  ///< BUS_VOLTAGE: Supply voltage.
  pin_state = 0x00000040,  ///< PIN_STATE: State of the pins.
  phase_current = 0x00000080,  ///< PHASE_CURRENT: Current of each phase.
  encoder_error_cnt = 0x00000100,  ///< ENCODER_ERROR_CNT: Errors of the encoder.
  iq_id_current = 0x00000200,  ///< Currents that make torque and field.
  motor_speed = 0x00000400,  ///< MOTOR_SPEED: Speed of the motor.
  pid_pos_err = 0x00000800,  ///< PID_POS_ERR: Error of the position controller.
  pid_speed_err = 0x00001000,  ///< PID_SPEED_ERR: Error of the speed controller.
  iq_ref = 0x00002000,  ///< IQ_REF: Target of the torque current.
  pid_current_err = 0x00004000,  ///< PID_CURRENT_ERR: Error of the current controller.
};
using CanDrvTelemetryFlags = Flags<CanDrvTelemetryFlag>;

/// Pins of a CAN motor driver.
/// Source: Later firmware.
enum class CanDrvPin : std::uint8_t {
  limit = 0x01,  ///< LIMIT: Limit switch.
  index = 0x02,  ///< INDEX: Index of the encoder.
  emergency = 0x04,  ///< EMERGENCY: Emergency stop.
  aux1 = 0x08,  ///< AUX1: The AUX1 pin.
  aux2 = 0x10,  ///< AUX2: The AUX2 pin.
  aux3 = 0x20,  ///< AUX3: The AUX3 pin.
  half_bridge_enable = 0x40,  ///< HALF_BRIDGE_ENABLE: Enables the half bridges.
  encoder_spi_cs = 0x80,  ///< ENCODER_SPI_CS: Selects the encoder on the SPI bus.
};
using CanDrvPins = Flags<CanDrvPin>;

/// Options in the upper half of a control mode byte.
/// Source: Variables L1148.
enum class ControlFlag : std::uint8_t {
  /// CONTROL_FLAG_MIX_FOLLOW: The motion is added to that of the follow mode instead of replacing
  /// it; for MODE_SPEED, MODE_ANGLE, MODE_ANGLE_SHORTEST and MODE_RC. Since firmware 2.70b5.
  mix_follow = 0x10,
  /// CONTROL_FLAG_TARGET_PRECISE: The motion does not slow down near its target; for MODE_ANGLE,
  /// MODE_ANGLE_SHORTEST and MODE_ANGLE_REL_FRAME. Since firmware 2.70b1.
  target_precise = 0x20,
  /// CONTROL_FLAG_AUTO_TASK: In MODE_ANGLE and MODE_ANGLE_REL_FRAME, move as fast as automatic
  /// tasks do, and confirm when the target is reached. In MODE_RC the bit is
  /// CONTROL_FLAG_FORCE_RC_SPEED: the signal controls the speed, whatever the parameters say. Since
  /// firmware 2.62b7.
  auto_task = 0x40,
  /// CONTROL_FLAG_HIGH_RES_SPEED: Speeds are in 0.001 deg/s. Since firmware 2.59. Before firmware
  /// 2.59: A flag UNTWIST, which is not described.
  high_res_speed = 0x80,
};
using ControlFlags = Flags<ControlFlag>;

/// Data of CMD_CONTROL_EXT: five bits for each axis, the last of which is not used.
/// Source: Later firmware.
enum class ControlExtField : std::uint16_t {
  roll_speed = 0x0001,  ///< ROLL_SPEED: The speed of roll is given.
  roll_angle = 0x0002,  ///< ROLL_ANGLE: The angle of roll is given.
  roll_angle_32bit = 0x0004,  ///< The angle of roll has 32 bits.
  roll_speed_32bit = 0x0008,  ///< The speed of roll has 32 bits. Since firmware 2.72.
  pitch_speed = 0x0020,  ///< PITCH_SPEED: The speed of pitch is given.
  pitch_angle = 0x0040,  ///< PITCH_ANGLE: The angle of pitch is given.
  pitch_angle_32bit = 0x0080,  ///< The angle of pitch has 32 bits.
  pitch_speed_32bit = 0x0100,  ///< The speed of pitch has 32 bits. Since firmware 2.72.
  yaw_speed = 0x0400,  ///< YAW_SPEED: The speed of yaw is given.
  yaw_angle = 0x0800,  ///< YAW_ANGLE: The angle of yaw is given.
  yaw_angle_32bit = 0x1000,  ///< The angle of yaw has 32 bits.
  yaw_speed_32bit = 0x2000,  ///< The speed of yaw has 32 bits. Since firmware 2.72.
};
using ControlExtFields = Flags<ControlExtField>;

/// Further options of the motion of an axis.
/// Source: Later firmware.
enum class ControlExtFlag : std::uint8_t {
  /// DISABLE_ANGLE_ERR_CORR: Do not correct deviations from the target angle, as with an OUTER_P of
  /// 0.
  disable_angle_err_corr = 0x01,
};
using ControlExtFlags = Flags<ControlExtFlag>;

/// Options of serial control.
/// Source: Later firmware.
enum class ControlConfigFlag : std::uint16_t {
  no_confirm = 0x0001,  ///< CONTROL_CONFIG_FLAG_NO_CONFIRM: Do not confirm control commands.
  /// CONTROL_CONFIG_FLAG_SERVO_MODE_ENABLE: Turn the servo mode on, in which angles are those of
  /// the motors. Since firmware 2.72.
  servo_mode_enable = 0x0002,
  /// CONTROL_CONFIG_FLAG_SERVO_MODE_DISABLE: Turn the servo mode off. Since firmware 2.72.
  servo_mode_disable = 0x0004,
  /// CONTROL_CONFIG_FLAG_LPF_EXT_RANGE: The filters have an extended range. Since firmware 2.72b3.
  lpf_ext_range = 0x0008,
  /// CONTROL_CONFIG_FLAG_LPF_FREQUENCY_HZ: The filters are frequencies in Hz, by the name. Since
  /// firmware 2.74.1.
  lpf_frequency_hz = 0x0010,
};
using ControlConfigFlags = Flags<ControlConfigFlag>;

/// Options of CMD_CONTROL_QUAT.
/// Source: Later firmware.
enum class ControlQuatFlag : std::uint8_t {
  confirm = 0x01,  ///< CONFIRM: Confirm the command.
  attitude_packed = 0x02,  ///< ATTITUDE_PACKED: The attitude is packed into 8 bytes.
  /// ATTITUDE_LIMITED_180: Attitudes are within half a turn, and each is reached from the last one
  /// by the shortest way.
  attitude_limited_180 = 0x04,
  /// ATTITUDE_REMOVE_ABSENT_AXES: By its name, axes without a motor are taken out of the attitude.
  /// Since firmware 2.74.1.
  attitude_remove_absent_axes = 0x08,
  att_remove_absent_axes [[deprecated("use attitude_remove_absent_axes")]] = attitude_remove_absent_axes,
  /// AUTO_TASK: For ATTITUDE: move as fast as automatic tasks do, and confirm when the attitude is
  /// reached within 1 degree. The motion ends after 10 s in any case.
  auto_task = 0x40,
};
using ControlQuatFlags = Flags<ControlQuatFlag>;

/// Options of the current control with quaternions.
/// Source: Later firmware.
enum class ControlQuatStatusFlag : std::uint16_t {
  confirm = 0x0001,  ///< CONFIRM: Commands are confirmed.
  attitude_packed = 0x0002,  ///< ATTITUDE_PACKED: Attitudes are packed into 8 bytes.
  attitude_limited_180 = 0x0004,  ///< ATTITUDE_LIMITED_180: Attitudes are within half a turn.
  /// ATTITUDE_REMOVE_ABSENT_AXES: Axes without a motor are taken out of the attitude.
  attitude_remove_absent_axes = 0x0008,
  att_remove_absent_axes [[deprecated("use attitude_remove_absent_axes")]] = attitude_remove_absent_axes,
  auto_task = 0x0040,  ///< AUTO_TASK: The motion is an automatic task.
};
using ControlQuatStatusFlags = Flags<ControlQuatStatusFlag>;

/// Data of CMD_CONTROL_QUAT_STATUS.
/// Source: Later firmware.
enum class ControlQuatStatusField : std::uint16_t {
  mode = 0x0001,  ///< MODE: Mode and flags.
  target_attitude = 0x0002,  ///< TARGET_ATTITUDE: Attitude of the last command.
  setpoint_attitude = 0x0004,  ///< SETPOINT_ATTITUDE: Attitude that the board stabilizes.
  actual_attitude = 0x0008,  ///< ACTUAL_ATTITUDE: Measured attitude.
  target_speed = 0x0010,  ///< TARGET_SPEED: Speed of the last command.
  setpoint_speed = 0x0020,  ///< SETPOINT_SPEED: Speed that the board stabilizes.
  actual_speed = 0x0040,  ///< ACTUAL_SPEED: Measured speed.
  /// TARGET_ATTITUDE_PACKED: Attitude of the last command, packed.
  target_attitude_packed = 0x0080,
  /// SETPOINT_ATTITUDE_PACKED: Attitude that the board stabilizes, packed.
  setpoint_attitude_packed = 0x0100,
  actual_attitude_packed = 0x0200,  ///< ACTUAL_ATTITUDE_PACKED: Measured attitude, packed.
};
using ControlQuatStatusFields = Flags<ControlQuatStatusField>;

/// Data of CMD_CONTROL_QUAT_CONFIG.
/// Source: Later firmware.
enum class ControlQuatConfigField : std::uint16_t {
  max_speed = 0x0001,  ///< MAX_SPEED: Speed limits.
  acc_limit = 0x0002,  ///< ACC_LIMIT: Acceleration limits.
  jerk_slope = 0x0004,  ///< JERK_SLOPE: Times in which the acceleration rises.
  flags = 0x0008,  ///< FLAGS: Options.
  attitude_lpf_freq = 0x0010,  ///< ATTITUDE_LPF_FREQ: Low-pass filter of the attitude.
  speed_lpf_freq = 0x0020,  ///< SPEED_LPF_FREQ: Low-pass filter of the speed.
};
using ControlQuatConfigFields = Flags<ControlQuatConfigField>;

/// Options of the motion profile of CMD_CONTROL_QUAT.
/// Source: Later firmware.
enum class ControlQuatConfigFlag : std::uint16_t {
  /// MOTION_PROFILE_SPLIT_XYZ: Each axis has its own profile. Otherwise the profile of X applies
  /// along the shortest way.
  motion_profile_split_xyz = 0x0001,
};
using ControlQuatConfigFlags = Flags<ControlQuatConfigFlag>;

/// Options of CMD_HELPER_DATA.
/// Source: Later firmware.
enum class HelperDataFlag : std::uint8_t {
  /// EULER_ORDER_ROLL_PITCH_YAW: The tilt is given in the Euler order roll, pitch, yaw. Since
  /// firmware 2.70b7.
  euler_order_roll_pitch_yaw = 0x40,
  /// USE_FRAME_HEADING: The heading of the frame is given. Since firmware 2.62b7.
  use_frame_heading = 0x80,
};
using HelperDataFlags = Flags<HelperDataFlag>;

/// Confirmations of CMD_EXECUTE_MENU.
/// Source: Later firmware.
enum class ExecuteMenuFlag : std::uint8_t {
  confirm = 0x01,  ///< CONFIRM: Confirm the start of the action.
  confirm_on_finish = 0x02,  ///< CONFIRM_ON_FINISH: Confirm the end of the action.
};
using ExecuteMenuFlags = Flags<ExecuteMenuFlag>;

/// Kind of an event.
/// Source: Later firmware.
enum class EventType : std::uint8_t {
  off = 0x01,  ///< OFF: It ended; for CAMERA, REC_PHOTO: record a video or take a photo.
  on = 0x02,  ///< ON: It began; for CAMERA, PHOTO: take a photo.
  hold = 0x04,  ///< HOLD: It continues.
};
using EventTypes = Flags<EventType>;

/// External motors.
/// Source: Later firmware.
enum class ExtMotor : std::uint8_t {
  motor1 = 0x01,  ///< MOTOR1: Motor 1.
  motor2 = 0x02,  ///< MOTOR2: Motor 2.
  motor3 = 0x04,  ///< MOTOR3: Motor 3.
  motor4 = 0x08,  ///< MOTOR4: Motor 4.
  motor5 = 0x10,  ///< MOTOR5: Motor 5.
  motor6 = 0x20,  ///< MOTOR6: Motor 6.
  motor7 = 0x40,  ///< MOTOR7: Motor 7.
};
using ExtMotors = Flags<ExtMotor>;

/// External motors of a command, and whether to confirm it.
/// Source: Later firmware.
enum class ExtMotorTarget : std::uint8_t {
  motor1 = 0x01,  ///< MOTOR1: Motor 1.
  motor2 = 0x02,  ///< MOTOR2: Motor 2.
  motor3 = 0x04,  ///< MOTOR3: Motor 3.
  motor4 = 0x08,  ///< MOTOR4: Motor 4.
  motor5 = 0x10,  ///< MOTOR5: Motor 5.
  motor6 = 0x20,  ///< MOTOR6: Motor 6.
  motor7 = 0x40,  ///< MOTOR7: Motor 7.
  confirm = 0x80,  ///< CONFIRM: Confirm the command.
};
using ExtMotorTargets = Flags<ExtMotorTarget>;

/// Format of CMD_EXT_MOTORS_CONTROL.
/// Source: Later firmware.
enum class ExtMotorsControlField : std::uint8_t {
  setpoint_32bit = 0x01,  ///< SETPOINT_32BIT: Setpoints have 32 bits, otherwise 16.
  param1_16bit = 0x02,  ///< PARAM1_16BIT: A parameter follows each setpoint, with 16 bits.
  param1_32bit = 0x04,  ///< PARAM1_32BIT: A parameter follows each setpoint, with 32 bits.
};
using ExtMotorsControlFields = Flags<ExtMotorsControlField>;

/// Data of CMD_EXT_MOTORS_CONTROL_CONFIG.
/// Source: Later firmware.
enum class ExtMotorsControlConfigField : std::uint16_t {
  mode = 0x0001,  ///< MODE: Mode.
  max_speed = 0x0002,  ///< MAX_SPEED: Speed limit.
  max_acceleration = 0x0004,  ///< MAX_ACCELERATION: Acceleration limit.
  jerk_slope = 0x0008,  ///< JERK_SLOPE: Time in which the acceleration rises.
  max_torque = 0x0010,  ///< MAX_TORQUE: Torque limit.
};
using ExtMotorsControlConfigFields = Flags<ExtMotorsControlConfigField>;

/// Data of CMD_EXT_MOTORS_STATE.
/// Source: Later firmware.
enum class ExtMotorsStateField : std::uint32_t {
  control_mode = 0x00000001,  ///< CONTROL_MODE: Mode.
  torque = 0x00000002,  ///< TORQUE: Torque.
  torque_setpoint = 0x00000004,  ///< TORQUE_SETPOINT: Target torque.
  speed16 = 0x00000008,  ///< SPEED16: Speed, 16 bits.
  speed16_setpoint = 0x00000010,  ///< SPEED16_SETPOINT: Target speed, 16 bits.
  speed32 = 0x00000020,  ///< SPEED32: Speed, 32 bits.
  speed32_setpoint = 0x00000040,  ///< SPEED32_SETPOINT: Target speed, 32 bits.
  angle16 = 0x00000080,  ///< ANGLE16: Angle, 16 bits.
  angle16_setpoint = 0x00000100,  ///< ANGLE16_SETPOINT: Target angle, 16 bits.
  angle32 = 0x00000200,  ///< ANGLE32: Angle, 32 bits.
  angle32_setpoint = 0x00000400,  ///< ANGLE32_SETPOINT: Target angle, 32 bits.
  state_flags = 0x00000800,  ///< STATE_FLAGS: State.
  max_speed = 0x00001000,  ///< MAX_SPEED: Speed limit.
  max_acceleration = 0x00002000,  ///< MAX_ACCELERATION: Acceleration limit.
  jerk_slope = 0x00004000,  ///< JERK_SLOPE: Time in which the acceleration rises.
  max_torque = 0x00008000,  ///< MAX_TORQUE: Torque limit.
  current = 0x00010000,  ///< CURRENT: Current.
  battery_voltage = 0x00020000,  ///< BATTERY_VOLTAGE: Supply voltage.
  motor_temperature = 0x00040000,  ///< MOTOR_TEMPERATURE: Temperature of the motor.
  driver_temperature = 0x00080000,  ///< DRIVER_TEMPERATURE: Temperature of the driver.
};
using ExtMotorsStateFields = Flags<ExtMotorsStateField>;

/// Pins of the driver of an external motor.
/// Source: Later firmware.
enum class ExtMotorPin : std::uint16_t {
  index_pin_state = 0x0004,  ///< INDEX_PIN_STATE: The index pin is active. Unconfirmed.
};
using ExtMotorPins = Flags<ExtMotorPin>;

/// Options of automatic PID tuning.
/// Source: Variables L1179-L1181.
enum class AutoPidFlag : std::uint8_t {
  stop = 0x00,  ///< AUTO_PID_STOP: Not a bit: the whole value 0 stops the tuning.
  roll = 0x01,  ///< AUTO_PID_CFG_ROLL: Tune roll.
  pitch = 0x02,  ///< AUTO_PID_CFG_PITCH: Tune pitch.
  yaw = 0x04,  ///< AUTO_PID_CFG_YAW: Tune yaw.
  send_gui = 0x08,  ///< AUTO_PID_CFG_SEND_GUI: Report progress with CMD_AUTO_PID.
  keep_current = 0x10,  ///< AUTO_PID_CFG_KEEP_CURRENT: Start from the current gains.
  tune_lpf_freq = 0x20,  ///< AUTO_PID_CFG_TUNE_LPF_FREQ: Tune the low-pass filter as well.
  all_profiles = 0x40,  ///< AUTO_PID_CFG_ALL_PROFILES: Store the result in all profiles.
};
using AutoPidFlags = Flags<AutoPidFlag>;

/// Calibrated directions of the accelerometer.
/// Source: Variables L1239.
enum class CalibratedLimit : std::uint8_t {
  plus_x = 0x01,  ///< Limit +X.
  minus_x = 0x02,  ///< Limit -X.
  plus_y = 0x04,  ///< Limit +Y.
  minus_y = 0x08,  ///< Limit -Y.
  plus_z = 0x10,  ///< Limit +Z.
  minus_z = 0x20,  ///< Limit -Z.
};
using CalibratedLimits = Flags<CalibratedLimit>;

/// Checks that the calibration of field offsets omits.
/// Source: Later firmware.
enum class FieldOffsetFlag : std::uint16_t {
  ignore_imu_check = 0x0001,  ///< IGNORE_IMU_CHECK: Do not compare with the IMU.
  ignore_encoder_check = 0x0002,  ///< IGNORE_ENCODER_CHECK: Do not check the encoder.
};
using FieldOffsetFlags = Flags<FieldOffsetFlag>;

/// Motors whose cogging to calibrate.
/// Source: Later firmware.
enum class CoggingAxis : std::uint8_t {
  roll = 0x01,  ///< ROLL: The roll motor.
  pitch = 0x02,  ///< PITCH: The pitch motor.
  yaw = 0x04,  ///< YAW: The yaw motor.
};
using CoggingAxes = Flags<CoggingAxis>;

/// Options of CMD_AUTO_PID2.
/// Source: Later firmware.
enum class AutoPid2CommandFlag : std::uint16_t {
  send_config = 0x0001,  ///< Send the configuration when the tuning ends.
};
using AutoPid2CommandFlags = Flags<AutoPid2CommandFlag>;

/// Options of the automatic tuning of later firmware.
/// Source: Later firmware.
enum class AutoPid2Flag : std::uint16_t {
  start_from_current = 0x0001,  ///< START_FROM_CURRENT: Start from the current parameters.
  all_profiles = 0x0002,  ///< ALL_PROFILES: Store the result in all profiles.
  tune_gain_only = 0x0004,  ///< TUNE_GAIN_ONLY: Tune the gains only.
  autosave = 0x0010,  ///< AUTOSAVE: Save the result.
  run_at_start_all = 0x4000,  ///< RUN_AT_START_ALL: Tune everything at each start-up.
  run_at_start_gain = 0x8000,  ///< RUN_AT_START_GAIN: Tune the gains at each start-up.
};
using AutoPid2Flags = Flags<AutoPid2Flag>;

/// Positions in which to tune.
/// Source: Later firmware.
enum class TuningPosition : std::uint8_t {
  position1 = 0x01,  ///< Position 1.
  position2 = 0x02,  ///< Position 2.
  position3 = 0x04,  ///< Position 3.
  position4 = 0x08,  ///< Position 4.
};
using TuningPositions = Flags<TuningPosition>;

/// Options of CMD_EXT_SENS_CMD.
/// Source: Later firmware.
enum class ExtSensOption : std::uint8_t {
  high_priority = 0x01,  ///< Forward the command before others.
};
using ExtSensOptions = Flags<ExtSensOption>;

/// Operation of CMD_AHRS_HELPER. Without SET it is a query, in which only FRAME_IMU matters.
/// Source: Variables L1193-L1195.
enum class AhrsHelperModeBit : std::uint8_t {
  set = 0x01,  ///< Set the attitude instead of querying it.
  frame_imu = 0x02,  ///< The frame IMU instead of the main one.
  /// Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it.
  reference_only = 0x04,
  /// Translate between camera and frame and use the result as a reference; requires known motor
  /// angles.
  translate = 0x08,
  z1_only = 0x10,  ///< Use Z1_VECTOR only.
  h1_only = 0x20,  ///< Use H1_VECTOR only.
};
using AhrsHelperMode = Flags<AhrsHelperModeBit>;

/// Operation of the forms of CMD_AHRS_HELPER with a two-byte mode. Without SET they are queries.
/// Source: Later firmware.
enum class AhrsHelperWideModeBit : std::uint16_t {
  set = 0x0001,  ///< Set the attitude instead of querying it.
  frame_imu = 0x0002,  ///< The frame IMU instead of the main one.
  /// Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it.
  reference_only = 0x0004,
  /// Translate between camera and frame and use the result as a reference; requires known motor
  /// angles.
  translate = 0x0008,
  z1_only = 0x0010,  ///< Use Z1_VECTOR only.
  h1_only = 0x0020,  ///< Use H1_VECTOR only.
  translate_z1_only = 0x0040,  ///< Translate Z1_VECTOR only.
  translate_h1_only = 0x0080,  ///< Translate H1_VECTOR only.
  on_frame = 0x0100,  ///< The sensor is on the frame, whatever the place of the frame IMU.
  below_outer = 0x0200,  ///< The sensor is below the outer motor.
  disable_correction = 0x0400,  ///< Turn the correction off. Since firmware 2.70b1.
};
using AhrsHelperWideMode = Flags<AhrsHelperWideModeBit>;

/// Sounds of CMD_BEEP_SOUND.
/// Source: Variables L1223.
enum class BeepMode : std::uint16_t {
  calibrate = 0x0001,  ///< BEEPER_MODE_CALIBRATE: The calibration sound.
  confirm = 0x0002,  ///< BEEPER_MODE_CONFIRM: The confirmation sound.
  error = 0x0004,  ///< BEEPER_MODE_ERROR: The error sound.
  click = 0x0010,  ///< BEEPER_MODE_CLICK: A click.
  complete = 0x0020,  ///< BEEPER_MODE_COMPLETE: The completion sound.
  intro = 0x0040,  ///< BEEPER_MODE_INTRO: The start-up sound.
  custom_melody = 0x8000,  ///< BEEPER_MODE_CUSTOM_MELODY: The notes of this message.
};
using BeepModes = Flags<BeepMode>;

/// Servo outputs of the board and of its CAN motor drivers.
/// Source: Later firmware.
enum class ServoOutput : std::uint32_t {
  servo1 = 0x00000001,  ///< SERVO1: The FC_ROLL pin.
  servo2 = 0x00000002,  ///< SERVO2: The FC_PITCH pin.
  servo3 = 0x00000004,  ///< SERVO3: The RC_PITCH pin.
  servo4 = 0x00000008,  ///< SERVO4: The AUX1 pin.
  can_drv1_servo1 = 0x00000010,  ///< CAN_DRV1_SERVO1: First pin of CAN motor driver 1.
  can_drv1_servo2 = 0x00000020,  ///< CAN_DRV1_SERVO2: Second pin of CAN motor driver 1.
  can_drv2_servo1 = 0x00000040,  ///< CAN_DRV2_SERVO1: First pin of CAN motor driver 2.
  can_drv2_servo2 = 0x00000080,  ///< CAN_DRV2_SERVO2: Second pin of CAN motor driver 2.
  can_drv3_servo1 = 0x00000100,  ///< CAN_DRV3_SERVO1: First pin of CAN motor driver 3.
  can_drv3_servo2 = 0x00000200,  ///< CAN_DRV3_SERVO2: Second pin of CAN motor driver 3.
  can_drv4_servo1 = 0x00000400,  ///< CAN_DRV4_SERVO1: First pin of CAN motor driver 4.
  can_drv4_servo2 = 0x00000800,  ///< CAN_DRV4_SERVO2: Second pin of CAN motor driver 4.
  can_drv5_servo1 = 0x00001000,  ///< CAN_DRV5_SERVO1: First pin of CAN motor driver 5.
  can_drv5_servo2 = 0x00002000,  ///< CAN_DRV5_SERVO2: Second pin of CAN motor driver 5.
  can_drv6_servo1 = 0x00004000,  ///< CAN_DRV6_SERVO1: First pin of CAN motor driver 6.
  can_drv6_servo2 = 0x00008000,  ///< CAN_DRV6_SERVO2: Second pin of CAN motor driver 6.
  can_drv7_servo1 = 0x00010000,  ///< CAN_DRV7_SERVO1: First pin of CAN motor driver 7.
  can_drv7_servo2 = 0x00020000,  ///< CAN_DRV7_SERVO2: Second pin of CAN motor driver 7.
};
using ServoOutputs = Flags<ServoOutput>;

/// Options of CMD_READ_RC_INPUTS.
/// Source: Later firmware.
enum class RcInputOption : std::uint16_t {
  init_if_needed = 0x0001,  ///< INIT_IF_NEEDED: Initialize each input that is not in use yet.
};
using RcInputOptions = Flags<RcInputOption>;

/// Properties of a debug variable.
/// Source: Variables L1188.
enum class DebugVarFlag : std::uint8_t {
  angle14 = 0x40,  ///< VAR_FLAG_ANGLE14: An angle, 16384 counts per turn.
};
using DebugVarFlags = Flags<DebugVarFlag>;

/// Frequent messages to filter on the debug port.
/// Source: Later firmware.
enum class DebugPortCommand : std::uint32_t {
  realtime_data_3 = 0x00000001,  ///< REALTIME_DATA_3: CMD_REALTIME_DATA_3.
  realtime_data_4 = 0x00000002,  ///< REALTIME_DATA_4: CMD_REALTIME_DATA_4.
  realtime_data_custom = 0x00000004,  ///< REALTIME_DATA_CUSTOM: CMD_REALTIME_DATA_CUSTOM.
  debug_vars_3 = 0x00000008,  ///< DEBUG_VARS_3: CMD_DEBUG_VARS_3.
  mavlink_debug = 0x00000010,  ///< MAVLINK_DEBUG: CMD_MAVLINK_DEBUG.
  get_angles = 0x00000020,  ///< GET_ANGLES: CMD_GET_ANGLES.
  get_angles_ext = 0x00000040,  ///< GET_ANGLES_EXT: CMD_GET_ANGLES_EXT.
  bode_test_data = 0x00000080,  ///< BODE_TEST_DATA: CMD_BODE_TEST_DATA.
  helper_data = 0x00000100,  ///< HELPER_DATA: CMD_HELPER_DATA.
  ahrs_helper = 0x00000200,  ///< AHRS_HELPER: CMD_AHRS_HELPER.
  gyro_correction = 0x00000400,  ///< GYRO_CORRECTION: CMD_GYRO_CORRECTION.
  control = 0x00000800,  ///< CONTROL: CMD_CONTROL.
  set_adj_vars_val = 0x00001000,  ///< SET_ADJ_VARS_VAL: CMD_SET_ADJ_VARS_VAL.
  api_virt_ch_control = 0x00002000,  ///< API_VIRT_CH_CONTROL: CMD_API_VIRT_CH_CONTROL.
  api_virt_ch_high_res = 0x00004000,  ///< API_VIRT_CH_HIGH_RES: CMD_API_VIRT_CH_HIGH_RES.
};
using DebugPortCommands = Flags<DebugPortCommand>;

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

/// Firmware version as a decimal number: 2439 is 2.43b9, 2745 is 2.74.5.
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

  /// Beta version, from 2.73 on a release; 0 is the first release.
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

/// Order of the Euler angles with its options.
/// Source: Variables L1079.
class EulerOrderSetting {
 public:
  using raw_type = std::uint8_t;

  constexpr EulerOrderSetting() = default;
  constexpr explicit EulerOrderSetting(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `order` converts to the whole, with 0 in the other parts.
  using enum EulerOrder;
  constexpr EulerOrderSetting(EulerOrder value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x0FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The order.
  constexpr EulerOrder order() const noexcept {
    return static_cast<EulerOrder>(raw_ & 0x0F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_order(EulerOrder value) noexcept {
    return set(static_cast<raw_type>(value), 0x0F, 0);
  }

  /// Options.
  constexpr EulerOrderFlags flags() const noexcept {
    return static_cast<EulerOrderFlags>(raw_ & 0x30);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(EulerOrderFlags value) noexcept {
    return set(value.raw(), 0x30, 0);
  }

  friend constexpr bool operator==(const EulerOrderSetting&, const EulerOrderSetting&) = default;
  friend constexpr auto operator<=>(const EulerOrderSetting&, const EulerOrderSetting&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
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

/// Settings of a MAVLink channel.
/// Source: Later firmware.
class MavConfig {
 public:
  using raw_type = std::uint8_t;

  constexpr MavConfig() = default;
  constexpr explicit MavConfig(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Baud rate.
  constexpr SerialSpeed baud() const noexcept {
    return static_cast<SerialSpeed>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_baud(SerialSpeed value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// The parity is even.
  constexpr bool parity_even() const noexcept { return (raw_ & 0x08) != 0; }
  constexpr MavConfig& set_parity_even(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x08U : raw_ & ~0x08U);
    return *this;
  }

  /// Send heartbeats.
  constexpr bool heartbeat() const noexcept { return (raw_ & 0x10) != 0; }
  constexpr MavConfig& set_heartbeat(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x10U : raw_ & ~0x10U);
    return *this;
  }

  /// Debug the channel.
  constexpr bool debug() const noexcept { return (raw_ & 0x20) != 0; }
  constexpr MavConfig& set_debug(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x20U : raw_ & ~0x20U);
    return *this;
  }

  /// Take RC signals from the channel.
  constexpr bool rc() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr MavConfig& set_rc(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  friend constexpr bool operator==(const MavConfig&, const MavConfig&) = default;
  friend constexpr auto operator<=>(const MavConfig&, const MavConfig&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Axis that a motor stabilizes.
/// Source: Later firmware.
class StabAxis {
 public:
  using raw_type = std::uint8_t;

  constexpr StabAxis() = default;
  constexpr explicit StabAxis(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `axis` converts to the whole, with 0 in the other parts.
  using enum StabilizedAxis;
  constexpr StabAxis(StabilizedAxis value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x03U)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The axis.
  constexpr StabilizedAxis axis() const noexcept {
    return static_cast<StabilizedAxis>(raw_ & 0x03);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_axis(StabilizedAxis value) noexcept {
    return set(static_cast<raw_type>(value), 0x03, 0);
  }

  /// The board may select roll.
  constexpr bool automatic_roll() const noexcept { return (raw_ & 0x04) != 0; }
  constexpr StabAxis& set_automatic_roll(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x04U : raw_ & ~0x04U);
    return *this;
  }

  /// The board may select pitch.
  constexpr bool automatic_pitch() const noexcept { return (raw_ & 0x08) != 0; }
  constexpr StabAxis& set_automatic_pitch(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x08U : raw_ & ~0x08U);
    return *this;
  }

  /// The board may select yaw.
  constexpr bool automatic_yaw() const noexcept { return (raw_ & 0x10) != 0; }
  constexpr StabAxis& set_automatic_yaw(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x10U : raw_ & ~0x10U);
    return *this;
  }

  friend constexpr bool operator==(const StabAxis&, const StabAxis&) = default;
  friend constexpr auto operator<=>(const StabAxis&, const StabAxis&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Action at start-up and its condition.
/// Source: Later firmware.
class StartupAction {
 public:
  using raw_type = std::uint8_t;

  constexpr StartupAction() = default;
  constexpr explicit StartupAction(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `action` converts to the whole, with 0 in the other parts.
  using enum MenuCommand;
  constexpr StartupAction(MenuCommand value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x7FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The action.
  constexpr MenuCommand action() const noexcept {
    return static_cast<MenuCommand>(raw_ & 0x7F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_action(MenuCommand value) noexcept {
    return set(static_cast<raw_type>(value), 0x7F, 0);
  }

  /// Only while the menu button is pressed.
  constexpr bool button_pressed() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr StartupAction& set_button_pressed(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const StartupAction&, const StartupAction&) = default;
  friend constexpr auto operator<=>(const StartupAction&, const StartupAction&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// When and how an axis snaps to a fixed position.
/// Source: Later firmware.
class ForcePositionConfig {
 public:
  using raw_type = std::uint8_t;

  constexpr ForcePositionConfig() = default;
  constexpr explicit ForcePositionConfig(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `snap` converts to the whole, with 0 in the other parts.
  using enum SnapAngle;
  constexpr ForcePositionConfig(SnapAngle value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x07U)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Distance between the positions.
  constexpr SnapAngle snap() const noexcept {
    return static_cast<SnapAngle>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_snap(SnapAngle value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// When the menu button is pressed.
  constexpr bool on_button() const noexcept { return (raw_ & 0x10) != 0; }
  constexpr ForcePositionConfig& set_on_button(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x10U : raw_ & ~0x10U);
    return *this;
  }

  /// At start-up.
  constexpr bool at_startup() const noexcept { return (raw_ & 0x20) != 0; }
  constexpr ForcePositionConfig& set_at_startup(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x20U : raw_ & ~0x20U);
    return *this;
  }

  /// Even beyond the limits of the axis.
  constexpr bool ignore_limits() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr ForcePositionConfig& set_ignore_limits(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  /// The position can be adjusted finely.
  constexpr bool fine_adjust() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr ForcePositionConfig& set_fine_adjust(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const ForcePositionConfig&, const ForcePositionConfig&) = default;
  friend constexpr auto operator<=>(const ForcePositionConfig&, const ForcePositionConfig&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Steps of a step signal, and what triggers them.
/// Source: Later firmware.
class StepSignalConfig {
 public:
  using raw_type = std::uint8_t;

  constexpr StepSignalConfig() = default;
  constexpr explicit StepSignalConfig(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Number of steps.
  constexpr StepCount steps() const noexcept {
    return static_cast<StepCount>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_steps(StepCount value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// Only while the menu button is pressed.
  constexpr bool button_pressed() const noexcept { return (raw_ & 0x08) != 0; }
  constexpr StepSignalConfig& set_button_pressed(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x08U : raw_ & ~0x08U);
    return *this;
  }

  /// The signal starts at 0.
  constexpr bool start_at_zero() const noexcept { return (raw_ & 0x20) != 0; }
  constexpr StepSignalConfig& set_start_at_zero(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x20U : raw_ & ~0x20U);
    return *this;
  }

  /// Level that triggers a step.
  constexpr StepTrigger trigger() const noexcept {
    return static_cast<StepTrigger>((raw_ & 0xC0) >> 6);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_trigger(StepTrigger value) noexcept {
    return set(static_cast<raw_type>(value), 0xC0, 6);
  }

  friend constexpr bool operator==(const StepSignalConfig&, const StepSignalConfig&) = default;
  friend constexpr auto operator<=>(const StepSignalConfig&, const StepSignalConfig&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Pin that signals an event to other devices.
/// Source: Later firmware.
class InterruptConfig {
 public:
  using raw_type = std::uint16_t;

  constexpr InterruptConfig() = default;
  constexpr explicit InterruptConfig(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Number of the pin, as in CMD_TRIGGER_PIN.
  constexpr raw_type pin() const noexcept {
    return static_cast<raw_type>(raw_ & 0x1F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_pin(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x1F, 0);
  }

  /// On an emergency stop.
  constexpr bool on_emergency_stop() const noexcept { return (raw_ & 0x20) != 0; }
  constexpr InterruptConfig& set_on_emergency_stop(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x20U : raw_ & ~0x20U);
    return *this;
  }

  /// On reaching the parking position.
  constexpr bool on_parking() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr InterruptConfig& set_on_parking(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  friend constexpr bool operator==(const InterruptConfig&, const InterruptConfig&) = default;
  friend constexpr auto operator<=>(const InterruptConfig&, const InterruptConfig&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Orientation of the external IMU.
/// Source: Later firmware.
class ExtImuOrientation {
 public:
  using raw_type = std::uint8_t;

  constexpr ExtImuOrientation() = default;
  constexpr explicit ExtImuOrientation(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Axis that points up.
  constexpr ExtImuAxis top() const noexcept {
    return static_cast<ExtImuAxis>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_top(ExtImuAxis value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// Axis that points right.
  constexpr ExtImuAxis right() const noexcept {
    return static_cast<ExtImuAxis>((raw_ & 0x38) >> 3);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_right(ExtImuAxis value) noexcept {
    return set(static_cast<raw_type>(value), 0x38, 3);
  }

  friend constexpr bool operator==(const ExtImuOrientation&, const ExtImuOrientation&) = default;
  friend constexpr auto operator<=>(const ExtImuOrientation&, const ExtImuOrientation&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Pin of an additional button.
/// Source: Later firmware.
class ExtraButton {
 public:
  using raw_type = std::uint8_t;

  constexpr ExtraButton() = default;
  constexpr explicit ExtraButton(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `pin` converts to the whole, with 0 in the other parts.
  using enum BoardPin;
  constexpr ExtraButton(BoardPin value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x3FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The pin.
  constexpr BoardPin pin() const noexcept {
    return static_cast<BoardPin>(raw_ & 0x3F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_pin(BoardPin value) noexcept {
    return set(static_cast<raw_type>(value), 0x3F, 0);
  }

  /// The button latches.
  constexpr bool latching() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr ExtraButton& set_latching(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  /// The signal is inverted.
  constexpr bool inverted() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr ExtraButton& set_inverted(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const ExtraButton&, const ExtraButton&) = default;
  friend constexpr auto operator<=>(const ExtraButton&, const ExtraButton&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Resolution and turns of an encoder.
/// Source: Later firmware.
class EncoderConfigExt {
 public:
  using raw_type = std::uint16_t;

  constexpr EncoderConfigExt() = default;
  constexpr explicit EncoderConfigExt(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Bits of resolution, less 12.
  constexpr raw_type resolution() const noexcept {
    return static_cast<raw_type>(raw_ & 0x1F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_resolution(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x1F, 0);
  }

  /// Bits that count turns.
  constexpr MultiTurn multi_turn() const noexcept {
    return static_cast<MultiTurn>((raw_ & 0xE0) >> 5);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_multi_turn(MultiTurn value) noexcept {
    return set(static_cast<raw_type>(value), 0xE0, 5);
  }

  friend constexpr bool operator==(const EncoderConfigExt&, const EncoderConfigExt&) = default;
  friend constexpr auto operator<=>(const EncoderConfigExt&, const EncoderConfigExt&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// State of eight inputs.
/// Source: Vendor's code of 2026.
class InputStates {
 public:
  using raw_type = std::uint16_t;

  constexpr InputStates() = default;
  constexpr explicit InputStates(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Input 1.
  constexpr InputState input_1() const noexcept {
    return static_cast<InputState>(raw_ & 0x03);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_1(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0x03, 0);
  }

  /// Input 2.
  constexpr InputState input_2() const noexcept {
    return static_cast<InputState>((raw_ & 0x0C) >> 2);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_2(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0x0C, 2);
  }

  /// Input 3.
  constexpr InputState input_3() const noexcept {
    return static_cast<InputState>((raw_ & 0x30) >> 4);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_3(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0x30, 4);
  }

  /// Input 4.
  constexpr InputState input_4() const noexcept {
    return static_cast<InputState>((raw_ & 0xC0) >> 6);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_4(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0xC0, 6);
  }

  /// Input 5.
  constexpr InputState input_5() const noexcept {
    return static_cast<InputState>((raw_ & 0x300) >> 8);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_5(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0x300, 8);
  }

  /// Input 6.
  constexpr InputState input_6() const noexcept {
    return static_cast<InputState>((raw_ & 0xC00) >> 10);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_6(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0xC00, 10);
  }

  /// Input 7.
  constexpr InputState input_7() const noexcept {
    return static_cast<InputState>((raw_ & 0x3000) >> 12);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_7(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0x3000, 12);
  }

  /// Input 8.
  constexpr InputState input_8() const noexcept {
    return static_cast<InputState>((raw_ & 0xC000) >> 14);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_input_8(InputState value) noexcept {
    return set(static_cast<raw_type>(value), 0xC000, 14);
  }

  friend constexpr bool operator==(const InputStates&, const InputStates&) = default;
  friend constexpr auto operator<=>(const InputStates&, const InputStates&) = default;

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

/// Order of the Euler angles of serial control.
/// Source: Later firmware.
class EulerOrderChoice {
 public:
  using raw_type = std::uint8_t;

  constexpr EulerOrderChoice() = default;
  constexpr explicit EulerOrderChoice(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `order` converts to the whole, with 0 in the other parts.
  using enum EulerOrderChange;
  constexpr EulerOrderChoice(EulerOrderChange value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x0FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The order.
  constexpr EulerOrderChange order() const noexcept {
    return static_cast<EulerOrderChange>(raw_ & 0x0F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_order(EulerOrderChange value) noexcept {
    return set(static_cast<raw_type>(value), 0x0F, 0);
  }

  /// Options.
  constexpr EulerOrderFlags flags() const noexcept {
    return static_cast<EulerOrderFlags>(raw_ & 0x30);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(EulerOrderFlags value) noexcept {
    return set(value.raw(), 0x30, 0);
  }

  friend constexpr bool operator==(const EulerOrderChoice&, const EulerOrderChoice&) = default;
  friend constexpr auto operator<=>(const EulerOrderChoice&, const EulerOrderChoice&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Coordinate system and options of CMD_HELPER_DATA.
/// Source: Variables L1250.
class HelperCoordinates {
 public:
  using raw_type = std::uint8_t;

  constexpr HelperCoordinates() = default;
  constexpr explicit HelperCoordinates(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `system` converts to the whole, with 0 in the other parts.
  using enum CoordinateSystem;
  constexpr HelperCoordinates(CoordinateSystem value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x07U)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Coordinate system of all the vectors.
  constexpr CoordinateSystem system() const noexcept {
    return static_cast<CoordinateSystem>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_system(CoordinateSystem value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// Options.
  constexpr HelperDataFlags flags() const noexcept {
    return static_cast<HelperDataFlags>(raw_ & 0xC0);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_flags(HelperDataFlags value) noexcept {
    return set(value.raw(), 0xC0, 0);
  }

  friend constexpr bool operator==(const HelperCoordinates&, const HelperCoordinates&) = default;
  friend constexpr auto operator<=>(const HelperCoordinates&, const HelperCoordinates&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Attitude as a quaternion of length 1 without its largest component, which follows from the
/// others.
/// Source: Later firmware.
class PackedQuaternion {
 public:
  using raw_type = std::uint64_t;

  constexpr PackedQuaternion() = default;
  constexpr explicit PackedQuaternion(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// The first of the other three components, in the order W, X, Y, Z.
  constexpr QuaternionPart a() const noexcept {
    return QuaternionPart(static_cast<QuaternionPart::raw_type>(detail::part_number(raw_, {0x7FFFF, 0, 0x80000, false})));
  }
  /// Returns false and changes nothing if the number does not fit into its bits.
  constexpr bool set_a(QuaternionPart value) noexcept {
    return detail::set_part_number(raw_, value.raw(), {0x7FFFF, 0, 0x80000, false});
  }

  /// The second one.
  constexpr QuaternionPart b() const noexcept {
    return QuaternionPart(static_cast<QuaternionPart::raw_type>(detail::part_number(raw_, {0x7FFFF00000, 20, 0x8000000000, false})));
  }
  /// Returns false and changes nothing if the number does not fit into its bits.
  constexpr bool set_b(QuaternionPart value) noexcept {
    return detail::set_part_number(raw_, value.raw(), {0x7FFFF00000, 20, 0x8000000000, false});
  }

  /// The third one.
  constexpr QuaternionPart c() const noexcept {
    return QuaternionPart(static_cast<QuaternionPart::raw_type>(detail::part_number(raw_, {0x7FFFF0000000000, 40, 0x800000000000000, false})));
  }
  /// Returns false and changes nothing if the number does not fit into its bits.
  constexpr bool set_c(QuaternionPart value) noexcept {
    return detail::set_part_number(raw_, value.raw(), {0x7FFFF0000000000, 40, 0x800000000000000, false});
  }

  /// The omitted component.
  constexpr QuaternionComponent largest() const noexcept {
    return static_cast<QuaternionComponent>((raw_ & 0x3000000000000000) >> 60);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_largest(QuaternionComponent value) noexcept {
    return set(static_cast<raw_type>(value), 0x3000000000000000, 60);
  }

  /// 1 if the omitted component is negative.
  constexpr bool largest_sign() const noexcept { return (raw_ & 0x4000000000000000) != 0; }
  constexpr PackedQuaternion& set_largest_sign(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x4000000000000000U : raw_ & ~0x4000000000000000U);
    return *this;
  }

  friend constexpr bool operator==(const PackedQuaternion&, const PackedQuaternion&) = default;
  friend constexpr auto operator<=>(const PackedQuaternion&, const PackedQuaternion&) = default;

 private:
  constexpr bool set(std::uint64_t value, std::uint64_t mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// State of an external motor.
/// Source: Later firmware.
class ExtMotorStatus {
 public:
  using raw_type = std::uint16_t;

  constexpr ExtMotorStatus() = default;
  constexpr explicit ExtMotorStatus(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `power` converts to the whole, with 0 in the other parts.
  using enum ExtMotorPower;
  constexpr ExtMotorStatus(ExtMotorPower value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x03U)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Whether it has power.
  constexpr ExtMotorPower power() const noexcept {
    return static_cast<ExtMotorPower>(raw_ & 0x03);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_power(ExtMotorPower value) noexcept {
    return set(static_cast<raw_type>(value), 0x03, 0);
  }

  /// Pins of its driver.
  constexpr ExtMotorPins pins() const noexcept {
    return static_cast<ExtMotorPins>(raw_ & 0xFFFC);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_pins(ExtMotorPins value) noexcept {
    return set(value.raw(), 0xFFFC, 0);
  }

  friend constexpr bool operator==(const ExtMotorStatus&, const ExtMotorStatus&) = default;
  friend constexpr auto operator<=>(const ExtMotorStatus&, const ExtMotorStatus&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// What to tune on an axis.
/// Source: Later firmware.
class AxisTuningOptions {
 public:
  using raw_type = std::uint8_t;

  constexpr AxisTuningOptions() = default;
  constexpr explicit AxisTuningOptions(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Tune the axis.
  constexpr bool enabled() const noexcept { return (raw_ & 0x01) != 0; }
  constexpr AxisTuningOptions& set_enabled(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x01U : raw_ & ~0x01U);
    return *this;
  }

  /// Tune its low-pass filter.
  constexpr bool tune_lpf() const noexcept { return (raw_ & 0x02) != 0; }
  constexpr AxisTuningOptions& set_tune_lpf(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x02U : raw_ & ~0x02U);
    return *this;
  }

  /// Number of notch filters to tune, 0 to 3.
  constexpr raw_type notch_filters() const noexcept {
    return static_cast<raw_type>((raw_ & 0x0C) >> 2);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_notch_filters(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x0C, 2);
  }

  friend constexpr bool operator==(const AxisTuningOptions&, const AxisTuningOptions&) = default;
  friend constexpr auto operator<=>(const AxisTuningOptions&, const AxisTuningOptions&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// What corrects the estimated attitude of an IMU.
/// Source: Later firmware.
class AhrsReferences {
 public:
  using raw_type = std::uint8_t;

  constexpr AhrsReferences() = default;
  constexpr explicit AhrsReferences(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Reference of the attitude.
  constexpr AhrsReference attitude() const noexcept {
    return static_cast<AhrsReference>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_attitude(AhrsReference value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// Reference of the heading.
  constexpr AhrsReference heading() const noexcept {
    return static_cast<AhrsReference>((raw_ & 0x38) >> 3);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_heading(AhrsReference value) noexcept {
    return set(static_cast<raw_type>(value), 0x38, 3);
  }

  /// The internal sensor is connected and used.
  constexpr bool internal_used() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr AhrsReferences& set_internal_used(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  /// The estimation is enabled.
  constexpr bool enabled() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr AhrsReferences& set_enabled(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const AhrsReferences&, const AhrsReferences&) = default;
  friend constexpr auto operator<=>(const AhrsReferences&, const AhrsReferences&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// State of the external IMU.
/// Source: Later firmware.
class ExtImuStatus {
 public:
  using raw_type = std::uint8_t;

  constexpr ExtImuStatus() = default;
  constexpr explicit ExtImuStatus(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// State of the external IMU.
  constexpr ExtImuState state() const noexcept {
    return static_cast<ExtImuState>(raw_ & 0x07);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_state(ExtImuState value) noexcept {
    return set(static_cast<raw_type>(value), 0x07, 0);
  }

  /// Its magnetometer is unreliable.
  constexpr bool bad_mag() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr ExtImuStatus& set_bad_mag(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  /// It receives no GPS signal.
  constexpr bool no_gps_signal() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr ExtImuStatus& set_no_gps_signal(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const ExtImuStatus&, const ExtImuStatus&) = default;
  friend constexpr auto operator<=>(const ExtImuStatus&, const ExtImuStatus&) = default;

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

/// Version as a decimal number: 120 is 1.20.
/// Source: Later firmware.
class ModuleVersion {
 public:
  using raw_type = std::uint16_t;

  constexpr ModuleVersion() = default;
  constexpr explicit ModuleVersion(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Major version.
  constexpr raw_type major() const noexcept {
    return static_cast<raw_type>(raw_ / 100);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_major(unsigned value) noexcept {
    return set_digits(major(), value, 100, 0);
  }

  /// Minor version.
  constexpr raw_type minor() const noexcept {
    return static_cast<raw_type>(raw_ % 100);
  }
  /// Returns false and changes nothing if the number does not fit.
  constexpr bool set_minor(unsigned value) noexcept {
    return set_digits(minor(), value, 1, 100);
  }

  friend constexpr bool operator==(const ModuleVersion&, const ModuleVersion&) = default;
  friend constexpr auto operator<=>(const ModuleVersion&, const ModuleVersion&) = default;

 private:
  constexpr bool set_digits(unsigned old, unsigned value, unsigned divide, unsigned modulo) noexcept {
    const std::uint64_t raw = raw_ + (std::uint64_t{value} - old) * divide;
    if ((modulo != 0 && value >= modulo) || raw > raw_type(-1)) return false;
    raw_ = static_cast<raw_type>(raw);
    return true;
  }

  raw_type raw_{};
};

/// Kind of a device on the CAN bus, and how it got its id.
/// Source: Later firmware.
class CanDeviceType {
 public:
  using raw_type = std::uint8_t;

  constexpr CanDeviceType() = default;
  constexpr explicit CanDeviceType(raw_type raw) noexcept : raw_(raw) {}
  /// A value of the part `kind` converts to the whole, with 0 in the other parts.
  using enum CanDeviceKind;
  constexpr CanDeviceType(CanDeviceKind value) noexcept
      : raw_(static_cast<raw_type>(static_cast<unsigned>(value) & 0x7FU)) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Kind of the device.
  constexpr CanDeviceKind kind() const noexcept {
    return static_cast<CanDeviceKind>(raw_ & 0x7F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_kind(CanDeviceKind value) noexcept {
    return set(static_cast<raw_type>(value), 0x7F, 0);
  }

  /// The hardware of the device determines its id.
  constexpr bool hardware_assigned() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr CanDeviceType& set_hardware_assigned(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const CanDeviceType&, const CanDeviceType&) = default;
  friend constexpr auto operator<=>(const CanDeviceType&, const CanDeviceType&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Far end of a transparent connection.
/// Source: Later firmware.
class TransparentTarget {
 public:
  using raw_type = std::uint8_t;

  constexpr TransparentTarget() = default;
  constexpr explicit TransparentTarget(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Serial port of the device.
  constexpr raw_type port() const noexcept {
    return static_cast<raw_type>(raw_ & 0x03);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_port(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x03, 0);
  }

  /// The device.
  constexpr TransparentDevice device() const noexcept {
    return static_cast<TransparentDevice>((raw_ & 0x3C) >> 2);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_device(TransparentDevice value) noexcept {
    return set(static_cast<raw_type>(value), 0x3C, 2);
  }

  /// 1 waits until the port is free, 0 drops the data if it is not.
  constexpr bool wait() const noexcept { return (raw_ & 0x40) != 0; }
  constexpr TransparentTarget& set_wait(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x40U : raw_ & ~0x40U);
    return *this;
  }

  friend constexpr bool operator==(const TransparentTarget&, const TransparentTarget&) = default;
  friend constexpr auto operator<=>(const TransparentTarget&, const TransparentTarget&) = default;

 private:
  constexpr bool set(unsigned value, unsigned mask, unsigned shift) noexcept {
    if (((value << shift) & ~mask) != 0) return false;
    raw_ = static_cast<raw_type>((raw_ & ~mask) | (value << shift));
    return true;
  }

  raw_type raw_{};
};

/// Where a copied message was seen.
/// Source: Later firmware.
class DebugPortLine {
 public:
  using raw_type = std::uint8_t;

  constexpr DebugPortLine() = default;
  constexpr explicit DebugPortLine(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }

  /// Index of the port.
  constexpr raw_type port() const noexcept {
    return static_cast<raw_type>(raw_ & 0x7F);
  }
  /// Returns false and changes nothing if the value does not fit into its bits.
  constexpr bool set_port(raw_type value) noexcept {
    return set(static_cast<raw_type>(value), 0x7F, 0);
  }

  /// Direction of the message.
  constexpr bool direction() const noexcept { return (raw_ & 0x80) != 0; }
  constexpr DebugPortLine& set_direction(bool on) noexcept {
    raw_ = static_cast<raw_type>(on ? raw_ | 0x80U : raw_ & ~0x80U);
    return *this;
  }

  friend constexpr bool operator==(const DebugPortLine&, const DebugPortLine&) = default;
  friend constexpr auto operator<=>(const DebugPortLine&, const DebugPortLine&) = default;

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
inline constexpr bool is_flag<msg::BoardFeaturesExtBit> = true;
template <>
inline constexpr bool is_flag<msg::BoardFeaturesExt2Bit> = true;
template <>
inline constexpr bool is_flag<msg::BoardStateFlag> = true;
template <>
inline constexpr bool is_flag<msg::HardwareFlag> = true;
template <>
inline constexpr bool is_flag<msg::StoredProfileSet> = true;
template <>
inline constexpr bool is_flag<msg::ConnectionFlag> = true;
template <>
inline constexpr bool is_flag<msg::ResetOption> = true;
template <>
inline constexpr bool is_flag<msg::PassProtectFlag> = true;
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
inline constexpr bool is_flag<msg::GeneralFlags2Bit> = true;
template <>
inline constexpr bool is_flag<msg::ProfileFlag> = true;
template <>
inline constexpr bool is_flag<msg::ParkingBorder> = true;
template <>
inline constexpr bool is_flag<msg::EulerOrderFlag> = true;
template <>
inline constexpr bool is_flag<msg::ExtImuFlag> = true;
template <>
inline constexpr bool is_flag<msg::GeneralFlags3Bit> = true;
template <>
inline constexpr bool is_flag<msg::GeneralFlags4Bit> = true;
template <>
inline constexpr bool is_flag<msg::ProfileFlags2Bit> = true;
template <>
inline constexpr bool is_flag<msg::ProfileFlags3Bit> = true;
template <>
inline constexpr bool is_flag<msg::SystemError> = true;
template <>
inline constexpr bool is_flag<msg::OtherFlag> = true;
template <>
inline constexpr bool is_flag<msg::RealtimeDataCustomFlag> = true;
template <>
inline constexpr bool is_flag<msg::RealtimeDataCustom2Flag> = true;
template <>
inline constexpr bool is_flag<msg::StateFlag> = true;
template <>
inline constexpr bool is_flag<msg::MotorPowerFlag> = true;
template <>
inline constexpr bool is_flag<msg::SystemPowerFlag> = true;
template <>
inline constexpr bool is_flag<msg::CanErrorFlag> = true;
template <>
inline constexpr bool is_flag<msg::CanDrvTelemetryFlag> = true;
template <>
inline constexpr bool is_flag<msg::CanDrvPin> = true;
template <>
inline constexpr bool is_flag<msg::ControlFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlExtField> = true;
template <>
inline constexpr bool is_flag<msg::ControlExtFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlConfigFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlQuatFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlQuatStatusFlag> = true;
template <>
inline constexpr bool is_flag<msg::ControlQuatStatusField> = true;
template <>
inline constexpr bool is_flag<msg::ControlQuatConfigField> = true;
template <>
inline constexpr bool is_flag<msg::ControlQuatConfigFlag> = true;
template <>
inline constexpr bool is_flag<msg::HelperDataFlag> = true;
template <>
inline constexpr bool is_flag<msg::ExecuteMenuFlag> = true;
template <>
inline constexpr bool is_flag<msg::EventType> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotor> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotorTarget> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotorsControlField> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotorsControlConfigField> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotorsStateField> = true;
template <>
inline constexpr bool is_flag<msg::ExtMotorPin> = true;
template <>
inline constexpr bool is_flag<msg::AutoPidFlag> = true;
template <>
inline constexpr bool is_flag<msg::CalibratedLimit> = true;
template <>
inline constexpr bool is_flag<msg::FieldOffsetFlag> = true;
template <>
inline constexpr bool is_flag<msg::CoggingAxis> = true;
template <>
inline constexpr bool is_flag<msg::AutoPid2CommandFlag> = true;
template <>
inline constexpr bool is_flag<msg::AutoPid2Flag> = true;
template <>
inline constexpr bool is_flag<msg::TuningPosition> = true;
template <>
inline constexpr bool is_flag<msg::ExtSensOption> = true;
template <>
inline constexpr bool is_flag<msg::AhrsHelperModeBit> = true;
template <>
inline constexpr bool is_flag<msg::AhrsHelperWideModeBit> = true;
template <>
inline constexpr bool is_flag<msg::BeepMode> = true;
template <>
inline constexpr bool is_flag<msg::ServoOutput> = true;
template <>
inline constexpr bool is_flag<msg::RcInputOption> = true;
template <>
inline constexpr bool is_flag<msg::DebugVarFlag> = true;
template <>
inline constexpr bool is_flag<msg::DebugPortCommand> = true;

}  // namespace sbgc
