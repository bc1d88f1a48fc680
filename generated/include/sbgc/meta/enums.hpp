// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Names of enum values, flags and parts of packed values.
#pragma once

#include <sbgc/meta.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct EnumMeta<msg::CommandToBoard> {
  static constexpr ValueInfo values[] = {
      {"CMD_BOARD_INFO_3", 20, "Serial numbers, memory and scripts of the board."},
      {"CMD_READ_PARAMS_3", 21, "Parameters of one profile and general parameters."},
      {"CMD_WRITE_PARAMS_3", 22, "Store the parameters of one profile and the general parameters."},
      {"CMD_REALTIME_DATA_3", 23, "Live data."},
      {"CMD_SELECT_IMU_3", 24, "Select the IMU to configure and calibrate; ignored if it is not connected."},
      {"CMD_REALTIME_DATA_4", 25, "Live data with joint angles, currents and temperatures."},
      {"CMD_ENCODERS_CALIB_OFFSET_4", 26, "Calibrate the offsets of the encoders."},
      {"CMD_ENCODERS_CALIB_FLD_OFFSET_4", 27, "Calibrate the offsets between encoders and the motors' magnetic fields."},
      {"CMD_READ_PROFILE_NAMES", 28, "Profile names."},
      {"CMD_WRITE_PROFILE_NAMES", 29, "Store the profile names."},
      {"CMD_QUEUE_PARAMS_INFO_3", 30, "Undocumented; possibly describes the adjustable variables, the purpose of CMD_GET_PARAMS_3."},
      {"CMD_SET_ADJ_VARS_VAL", 31, "Values of adjustable variables."},
      {"CMD_SAVE_PARAMS_3", 32, "Save the parameters in use, with all changes to adjustable variables, to the active profile."},
      {"CMD_READ_PARAMS_EXT", 33, "More parameters of one profile: filters, encoders, magnetometer."},
      {"CMD_WRITE_PARAMS_EXT", 34, "Store more parameters of one profile."},
      {"CMD_AUTO_PID", 35, "Tune the PID controllers automatically."},
      {"CMD_SERVO_OUT", 36, "Send PWM signals to servos."},
      {"CMD_BODE_TEST_START_STOP", 37, "Record a frequency response."},
      {"CMD_I2C_WRITE_REG_BUF", 39, "Write to a device on an I2C bus."},
      {"CMD_I2C_READ_REG_BUF", 40, "Data from a device on an I2C bus."},
      {"CMD_WRITE_EXTERNAL_DATA", 41, "Store user data in the EEPROM."},
      {"CMD_READ_EXTERNAL_DATA", 42, "User data in the EEPROM."},
      {"CMD_READ_ADJ_VARS_CFG", 43, "RC signals that trigger actions or change adjustable variables."},
      {"CMD_WRITE_ADJ_VARS_CFG", 44, "Store the RC signals that trigger actions or change adjustable variables."},
      {"CMD_API_VIRT_CH_CONTROL", 45, "Set the host's virtual RC channels, which can control the camera and more."},
      {"CMD_ADJ_VARS_STATE", 46, "Current state of one trigger slot and one analog slot."},
      {"CMD_EEPROM_WRITE", 47, "Write a block to the EEPROM."},
      {"CMD_EEPROM_READ", 48, "A block of the EEPROM."},
      {"CMD_CALIB_INFO", 49, "Calibration status for display."},
      {"CMD_SIGN_MESSAGE", 50, "Signature of a message."},
      {"CMD_BOOT_MODE_3", 51, "Enter the bootloader to load new firmware."},
      {"CMD_SYSTEM_STATE", 52, "Undocumented; by its name, the state of the system."},
      {"CMD_READ_FILE", 53, "Part of a file."},
      {"CMD_WRITE_FILE", 54, "Write part of a file; without data, delete it."},
      {"CMD_FS_CLEAR_ALL", 55, "Delete all files."},
      {"CMD_AHRS_HELPER", 56, "Attitude of an IMU as two unit vectors."},
      {"CMD_RUN_SCRIPT", 57, "Start or stop a script."},
      {"CMD_CALIB_MAG", 59, "Calibrate the magnetometer."},
      {"CMD_UART_BYPASS", 60, "Undocumented; by its name, connects two serial ports of the board."},
      {"CMD_GET_ANGLES_EXT", 61, "Camera angles, targets and joint angles."},
      {"CMD_READ_PARAMS_EXT2", 62, "The third set of parameters of one profile."},
      {"CMD_WRITE_PARAMS_EXT2", 63, "Store the third set of parameters of one profile."},
      {"CMD_GET_ADJ_VARS_VAL", 64, "Request the values of adjustable variables."},
      {"CMD_CALIB_ACC", 65, "Calibrate an accelerometer."},
      {"CMD_CALIB_BAT", 66, "Calibrate the battery voltage measurement."},
      {"CMD_CONTROL", 67, "Move the camera."},
      {"CMD_REALTIME_DATA", 68, "Live data."},
      {"CMD_EXECUTE_MENU", 69, "Execute a menu action, as the menu button or the RC command channel does."},
      {"CMD_USE_DEFAULTS", 70, "Restore the factory defaults."},
      {"CMD_CALIB_EXT_GAIN", 71, "Calibrate the gains of a flight controller's signals."},
      {"CMD_HELPER_DATA", 72, "Motion of the frame from an external system; improves stabilization."},
      {"CMD_GET_ANGLES", 73, "Camera angles and targets."},
      {"CMD_CALIB_MOTOR_MAG_LINK", 74, "Undocumented; by its name, calibrates the magnetic linkage of the motors."},
      {"CMD_GYRO_CORRECTION", 75, "Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong."},
      {"CMD_MODULE_LIST", 76, "Modules connected to the board."},
      {"CMD_MOTORS_ON", 77, "Turn the motors on."},
      {"CMD_MODULE_FLASH_START", 78, "Begin to load new firmware into a module."},
      {"CMD_CALIB_OFFSET", 79, "Calibrate the follow mode offset."},
      {"CMD_CALIB_POLES", 80, "Detect the poles and the direction of the motors."},
      {"CMD_MODULE_FLASH_WRITE", 81, "Load a part of new firmware into a module."},
      {"CMD_READ_PARAMS", 82, "Older id of CMD_READ_PARAMS_3."},
      {"CMD_MODULE_FLASH_FINISH", 83, "End the loading of firmware into a module."},
      {"CMD_TRIGGER_PIN", 84, "Switch an output pin."},
      {"CMD_DATA_STREAM_INTERVAL", 85, "Start, change or end a data stream: messages that the board sends at a fixed rate."},
      {"CMD_BOARD_INFO", 86, "Board version and features."},
      {"CMD_WRITE_PARAMS", 87, "Older id of CMD_WRITE_PARAMS_3."},
      {"CMD_REALTIME_DATA_CUSTOM", 88, "Live data of the requested blocks."},
      {"CMD_BEEP_SOUND", 89, "Play a melody through the motors, or a standard sound."},
      {"CMD_CONTROL_CONFIG", 90, "Configure serial control until the next start."},
      {"CMD_CALIB_ORIENT_CORR", 91, "Calibrate the orientation of the IMU."},
      {"CMD_COGGING_CALIB_INFO", 92, "Undocumented; by its name, the state of the calibration of the cogging."},
      {"CMD_CALIB_COGGING", 93, "Calibrate the cogging of the motors, or delete this calibration."},
      {"CMD_CALIB_ACC_EXT_REF", 94, "Calibrate the accelerometer with an external reference."},
      {"CMD_PROFILE_SET", 95, "Save, clear or load a profile set."},
      {"CMD_CAN_DEVICE_SCAN", 96, "Devices on the CAN bus."},
      {"CMD_CAN_DRV_HARD_PARAMS", 97, "Undocumented; by its name, hardware parameters of a CAN motor driver."},
      {"CMD_CAN_DRV_STATE", 98, "Undocumented; by its name, the state of a CAN motor driver."},
      {"CMD_CAN_DRV_CALIBRATE", 99, "Undocumented; by its name, calibrates a CAN motor driver."},
      {"CMD_READ_RC_INPUTS", 100, "RC signals of selected inputs."},
      {"CMD_REALTIME_DATA_CAN_DRV", 101, "Undocumented; by its name, live data of a CAN motor driver."},
      {"CMD_CALIB_GYRO", 103, "Calibrate a gyroscope."},
      {"CMD_READ_PARAMS_EXT3", 104, "The fourth set of parameters of one profile."},
      {"CMD_WRITE_PARAMS_EXT3", 105, "Store the fourth set of parameters of one profile."},
      {"CMD_EXT_IMU_DEBUG_INFO", 106, "State of the attitude estimation and of the external IMU."},
      {"CMD_SET_DEVICE_ADDR", 107, "Undocumented; by its name, sets the address of a device."},
      {"CMD_AUTO_PID2", 108, "Tune the PID controllers automatically, in later firmware."},
      {"CMD_MOTORS_OFF", 109, "Turn the motors off."},
      {"CMD_EXT_IMU_CMD", 110, "A command of the external IMU's own protocol."},
      {"CMD_READ_STATE_VARS", 111, "Statistics of the board's whole life."},
      {"CMD_WRITE_STATE_VARS", 112, "Store the statistics of the board's whole life."},
      {"CMD_SERIAL_PROXY", 113, "Undocumented; by its name, passes data on to a serial port."},
      {"CMD_RESET", 114, "The board restarts."},
      {"CMD_IMU_ADVANCED_CALIB", 115, "Undocumented; by its name, calibrates an IMU in an advanced way."},
      {"CMD_API_VIRT_CH_HIGH_RES", 116, "Set the host's virtual RC channels in high resolution; they can control the camera and more."},
      {"CMD_CALIB_ENCODER_LUT", 117, "Undocumented; by its name, calibrates the correction table of an encoder."},
      {"CMD_CALIB_ENCODER_LUT_RES", 118, "Undocumented; by its name, the result of the calibration of an encoder's correction table."},
      {"CMD_WRITE_PARAMS_SET", 119, "Begin or end a series of commands that store parameters."},
      {"CMD_CALIB_CUR_SENS", 120, "Undocumented; by its name, calibrates the current sensors."},
      {"CMD_CONTROL_EXT", 121, "Move the camera, with the data that each axis needs."},
      {"CMD_ENC_INT_CALIB", 122, "Undocumented; by its name, calibrates an encoder internally."},
      {"CMD_SYNC_MOTORS", 123, "Power one motor as a synchronous motor for some time, then turn the motors off."},
      {"CMD_EXT_LICENSE_INFO", 124, "Undocumented; by its name, information about extended licenses."},
      {"CMD_VIBRATION_TEST_START_STOP", 125, "Undocumented; by its name, starts or stops a vibration test."},
      {"CMD_VIBRATION_TEST_DATA", 126, "Undocumented; by its name, data of a vibration test."},
      {"CMD_EXT_MOTORS_ACTION", 128, "Turn external motors on or off, or move them to their home position."},
      {"CMD_EXT_MOTORS_CONTROL", 129, "Set targets of external motors."},
      {"CMD_EXT_MOTORS_CONTROL_CONFIG", 130, "Configure external motors."},
      {"CMD_EXT_MOTORS_STATE", 131, "State of an external motor."},
      {"CMD_ADJ_VARS_INFO", 132, "Names, ranges and values of adjustable variables."},
      {"CMD_SERVO_OUT_EXT", 133, "Send PWM signals to servos of the board and of its CAN motor drivers."},
      {"CMD_SET_ADJ_VARS_VAL_F", 134, "Values of adjustable variables in floating point."},
      {"CMD_GET_ADJ_VARS_VAL_F", 135, "Request the values of adjustable variables in floating point."},
      {"CMD_PASS_PROTECT_READ", 136, "What a password protects."},
      {"CMD_PASS_PROTECT_WRITE", 137, "Choose what a password protects."},
      {"CMD_REALTIME_DATA_CUSTOM2", 139, "More live data of the requested blocks."},
      {"CMD_CONTROL_QUAT", 140, "Move the camera, with attitude and speed in space."},
      {"CMD_CONTROL_QUAT_STATUS", 141, "State of the control with quaternions."},
      {"CMD_CONTROL_QUAT_CONFIG", 142, "Configure the control with quaternions."},
      {"CMD_SET_TRANSP_PROXY", 143, "Connect two serial ports of the board."},
      {"CMD_UDRV_DEVICE_SCAN", 144, "Devices on the bus of uDrv modules."},
      {"CMD_EXT_SENS_CMD", 150, "A message of an external sensor's own protocol."},
      {"CMD_TRANSPARENT_SAPI", 151, "Data from a serial port of a device on the CAN bus."},
      {"CMD_SET_DEBUG_PORT", 249, "Copy of a message on another port of the board."},
      {"CMD_MAVLINK_INFO", 250, "Undocumented; by its name, information about a MAVLink connection."},
      {"CMD_MAVLINK_DEBUG", 251, "Undocumented; by its name, debugging of a MAVLink connection."},
      {"CMD_DEBUG_VARS_INFO_3", 253, "Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3."},
      {"CMD_DEBUG_VARS_3", 254, "Values of the debug variables."},
  };
  static constexpr EnumInfo info{"CommandToBoard", values, false};
};

template <>
struct EnumMeta<msg::CommandFromBoard> {
  static constexpr ValueInfo values[] = {
      {"CMD_BOARD_INFO_3", 20, "Serial numbers, memory and scripts of the board."},
      {"CMD_READ_PARAMS_3", 21, "Parameters of one profile and general parameters."},
      {"CMD_REALTIME_DATA_3", 23, "Live data."},
      {"CMD_REALTIME_DATA_4", 25, "Live data with joint angles, currents and temperatures."},
      {"CMD_READ_PROFILE_NAMES", 28, "Profile names."},
      {"CMD_QUEUE_PARAMS_INFO_3", 30, "Undocumented; possibly describes the adjustable variables, the purpose of CMD_GET_PARAMS_3."},
      {"CMD_SET_ADJ_VARS_VAL", 31, "Values of adjustable variables."},
      {"CMD_READ_PARAMS_EXT", 33, "More parameters of one profile: filters, encoders, magnetometer."},
      {"CMD_AUTO_PID", 35, "Tune the PID controllers automatically."},
      {"CMD_BODE_TEST_START_STOP", 37, "Record a frequency response."},
      {"CMD_BODE_TEST_DATA", 38, "Samples of a frequency response."},
      {"CMD_I2C_READ_REG_BUF", 40, "Data from a device on an I2C bus."},
      {"CMD_READ_EXTERNAL_DATA", 42, "User data in the EEPROM."},
      {"CMD_READ_ADJ_VARS_CFG", 43, "RC signals that trigger actions or change adjustable variables."},
      {"CMD_ADJ_VARS_STATE", 46, "Current state of one trigger slot and one analog slot."},
      {"CMD_EEPROM_READ", 48, "A block of the EEPROM."},
      {"CMD_CALIB_INFO", 49, "Calibration status for display."},
      {"CMD_SIGN_MESSAGE", 50, "Signature of a message."},
      {"CMD_SYSTEM_STATE", 52, "Undocumented; by its name, the state of the system."},
      {"CMD_READ_FILE", 53, "Part of a file."},
      {"CMD_AHRS_HELPER", 56, "Attitude of an IMU as two unit vectors."},
      {"CMD_SCRIPT_DEBUG", 58, "Progress of a script started with debugging."},
      {"CMD_UART_BYPASS", 60, "Undocumented; by its name, connects two serial ports of the board."},
      {"CMD_GET_ANGLES_EXT", 61, "Camera angles, targets and joint angles."},
      {"CMD_READ_PARAMS_EXT2", 62, "The third set of parameters of one profile."},
      {"CMD_CONFIRM", 67, "The board executed a command."},
      {"CMD_GET_ANGLES", 73, "Camera angles and targets."},
      {"CMD_CALIB_MOTOR_MAG_LINK", 74, "Undocumented; by its name, calibrates the magnetic linkage of the motors."},
      {"CMD_MODULE_LIST", 76, "Modules connected to the board."},
      {"CMD_READ_PARAMS", 82, "Older id of CMD_READ_PARAMS_3."},
      {"CMD_BOARD_INFO", 86, "Board version and features."},
      {"CMD_REALTIME_DATA_CUSTOM", 88, "Live data of the requested blocks."},
      {"CMD_COGGING_CALIB_INFO", 92, "Undocumented; by its name, the state of the calibration of the cogging."},
      {"CMD_CAN_DEVICE_SCAN", 96, "Devices on the CAN bus."},
      {"CMD_CAN_DRV_HARD_PARAMS", 97, "Undocumented; by its name, hardware parameters of a CAN motor driver."},
      {"CMD_CAN_DRV_STATE", 98, "Undocumented; by its name, the state of a CAN motor driver."},
      {"CMD_CAN_DRV_CALIBRATE", 99, "Undocumented; by its name, calibrates a CAN motor driver."},
      {"CMD_READ_RC_INPUTS", 100, "RC signals of selected inputs."},
      {"CMD_REALTIME_DATA_CAN_DRV", 101, "Undocumented; by its name, live data of a CAN motor driver."},
      {"CMD_EVENT", 102, "An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL."},
      {"CMD_READ_PARAMS_EXT3", 104, "The fourth set of parameters of one profile."},
      {"CMD_EXT_IMU_DEBUG_INFO", 106, "State of the attitude estimation and of the external IMU."},
      {"CMD_SET_DEVICE_ADDR", 107, "Undocumented; by its name, sets the address of a device."},
      {"CMD_EXT_IMU_CMD", 110, "A command of the external IMU's own protocol."},
      {"CMD_READ_STATE_VARS", 111, "Statistics of the board's whole life."},
      {"CMD_SERIAL_PROXY", 113, "Undocumented; by its name, passes data on to a serial port."},
      {"CMD_RESET", 114, "The board restarts."},
      {"CMD_IMU_ADVANCED_CALIB", 115, "Undocumented; by its name, calibrates an IMU in an advanced way."},
      {"CMD_CALIB_ENCODER_LUT", 117, "Undocumented; by its name, calibrates the correction table of an encoder."},
      {"CMD_CALIB_ENCODER_LUT_RES", 118, "Undocumented; by its name, the result of the calibration of an encoder's correction table."},
      {"CMD_CALIB_CUR_SENS", 120, "Undocumented; by its name, calibrates the current sensors."},
      {"CMD_ENC_INT_CALIB", 122, "Undocumented; by its name, calibrates an encoder internally."},
      {"CMD_EXT_LICENSE_INFO", 124, "Undocumented; by its name, information about extended licenses."},
      {"CMD_VIBRATION_TEST_START_STOP", 125, "Undocumented; by its name, starts or stops a vibration test."},
      {"CMD_VIBRATION_TEST_DATA", 126, "Undocumented; by its name, data of a vibration test."},
      {"CMD_CAN_DRV_TELEMETRY", 127, "Live data of a CAN motor driver."},
      {"CMD_EXT_MOTORS_STATE", 131, "State of an external motor."},
      {"CMD_ADJ_VARS_INFO", 132, "Names, ranges and values of adjustable variables."},
      {"CMD_SET_ADJ_VARS_VAL_F", 134, "Values of adjustable variables in floating point."},
      {"CMD_PASS_PROTECT_READ", 136, "What a password protects."},
      {"CMD_REALTIME_DATA_CUSTOM2", 139, "More live data of the requested blocks."},
      {"CMD_CONTROL_QUAT_STATUS", 141, "State of the control with quaternions."},
      {"CMD_EXT_SENS_CMD", 150, "A message of an external sensor's own protocol."},
      {"CMD_TRANSPARENT_SAPI", 151, "Data from a serial port of a device on the CAN bus."},
      {"CMD_SET_DEBUG_PORT", 249, "Copy of a message on another port of the board."},
      {"CMD_MAVLINK_INFO", 250, "Undocumented; by its name, information about a MAVLink connection."},
      {"CMD_MAVLINK_DEBUG", 251, "Undocumented; by its name, debugging of a MAVLink connection."},
      {"CMD_DEBUG_VARS_INFO_3", 253, "Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3."},
      {"CMD_DEBUG_VARS_3", 254, "Values of the debug variables."},
      {"CMD_ERROR", 255, "The board could not execute a command."},
  };
  static constexpr EnumInfo info{"CommandFromBoard", values, false};
};

template <>
struct EnumMeta<msg::VariableId> {
  static constexpr ValueInfo values[] = {
      {"P_ROLL", 0, "Proportional gain of roll."},
      {"P_PITCH", 1, "Proportional gain of pitch."},
      {"P_YAW", 2, "Proportional gain of yaw."},
      {"I_ROLL", 3, "Integral gain of roll."},
      {"I_PITCH", 4, "Integral gain of pitch."},
      {"I_YAW", 5, "Integral gain of yaw."},
      {"D_ROLL", 6, "Derivative gain of roll."},
      {"D_PITCH", 7, "Derivative gain of pitch."},
      {"D_YAW", 8, "Derivative gain of yaw."},
      {"POWER_ROLL", 9, "Power of the roll motor."},
      {"POWER_PITCH", 10, "Power of the pitch motor."},
      {"POWER_YAW", 11, "Power of the yaw motor."},
      {"ACC_LIMITER", 12, "Acceleration limit of all axes."},
      {"FOLLOW_SPEED_ROLL", 13, "Follow mode speed of roll."},
      {"FOLLOW_SPEED_PITCH", 14, "Follow mode speed of pitch."},
      {"FOLLOW_SPEED_YAW", 15, "Follow mode speed of yaw."},
      {"FOLLOW_LPF_ROLL", 16, "Follow mode low-pass filter of roll."},
      {"FOLLOW_LPF_PITCH", 17, "Follow mode low-pass filter of pitch."},
      {"FOLLOW_LPF_YAW", 18, "Follow mode low-pass filter of yaw."},
      {"RC_SPEED_ROLL", 19, "RC control speed of roll."},
      {"RC_SPEED_PITCH", 20, "RC control speed of pitch."},
      {"RC_SPEED_YAW", 21, "RC control speed of yaw."},
      {"RC_LPF_ROLL", 22, "RC low-pass filter of roll."},
      {"RC_LPF_PITCH", 23, "RC low-pass filter of pitch."},
      {"RC_LPF_YAW", 24, "RC low-pass filter of yaw."},
      {"RC_TRIM_ROLL", 25, "RC trim of roll."},
      {"RC_TRIM_PITCH", 26, "RC trim of pitch."},
      {"RC_TRIM_YAW", 27, "RC trim of yaw."},
      {"RC_DEADBAND", 28, "Dead band around the center of the RC signals."},
      {"RC_EXPO_RATE", 29, "Expo rate of the RC signals."},
      {"FOLLOW_MODE", 30, "What the camera follows: 0 nothing, 1 the flight controller, 2 pitch and roll of the frame. Later firmware calls it FOLLOW_PITCH, from 0 to 1."},
      {"RC_FOLLOW_YAW", 31, "1 if yaw follows the frame, otherwise 0. Later firmware calls it RC_FOLLOW_YAW_PITCH, from 0 to 2."},
      {"FOLLOW_DEADBAND", 32, "Dead band of the follow mode."},
      {"FOLLOW_EXPO_RATE", 33, "Expo rate of the follow mode."},
      {"FOLLOW_ROLL_MIX_START", 34, "Angle at which pitch starts to follow roll."},
      {"FOLLOW_ROLL_MIX_RANGE", 35, "Angle over which pitch continues to follow roll."},
      {"GYRO_TRUST", 36, "Trust in the gyroscope relative to the accelerometer."},
      {"FRAME_HEADING_ANGLE", 37, "Heading of the frame; in later firmware 32767 has a special meaning."},
      {"GYRO_HEADING_CORRECTION", 38, "Gyroscope correction about the vertical."},
      {"ACC_LIMITER_ROLL", 39, "Acceleration limit of roll."},
      {"ACC_LIMITER_PITCH", 40, "Acceleration limit of pitch."},
      {"ACC_LIMITER_YAW", 41, "Acceleration limit of yaw."},
      {"PID_GAIN_ROLL", 42, "Factor for P, I and D of roll."},
      {"PID_GAIN_PITCH", 43, "Factor for P, I and D of pitch."},
      {"PID_GAIN_YAW", 44, "Factor for P, I and D of yaw."},
      {"LPF_FREQ_ROLL", 45, "Low-pass filter of roll."},
      {"LPF_FREQ_PITCH", 46, "Low-pass filter of pitch."},
      {"LPF_FREQ_YAW", 47, "Low-pass filter of yaw."},
      {"TIMELAPSE_TIME", 48, "Duration of a time lapse.", {.firmware = 2600}},
      {"MAV_CTRL_MODE", 49, "What MAVLink controls: 0 nothing, 1 roll and pitch, 2 all axes.", {.firmware = 2660}},
      {"H_CORR_FACTOR", 50, "Strength of the heading correction.", {.firmware = 2687}},
      {"SW_LIM_MIN_ROLL", 51, "Lowest angle of the roll joint.", {.firmware = 2688}},
      {"SW_LIM_MAX_ROLL", 52, "Highest angle of the roll joint.", {.firmware = 2688}},
      {"SW_LIM_MIN_PITCH", 53, "Lowest angle of the pitch joint.", {.firmware = 2688}},
      {"SW_LIM_MAX_PITCH", 54, "Highest angle of the pitch joint.", {.firmware = 2688}},
      {"SW_LIM_MIN_YAW", 55, "Lowest angle of the yaw joint.", {.firmware = 2688}},
      {"SW_LIM_MAX_YAW", 56, "Highest angle of the yaw joint.", {.firmware = 2688}},
      {"FOLLOW_RANGE_ROLL", 57, "Range of the follow mode of roll.", {.firmware = 2689}},
      {"FOLLOW_RANGE_PITCH", 58, "Range of the follow mode of pitch.", {.firmware = 2689}},
      {"FOLLOW_RANGE_YAW", 59, "Range of the follow mode of yaw.", {.firmware = 2689}},
      {"AUTO_PID_TARGET", 60, "Target of the automatic PID tuning.", {.firmware = 2689}},
      {"RC_MODE_ROLL", 61, "What the RC signal of roll controls, as in RC_MODE.", {.firmware = 2693}},
      {"RC_MODE_PITCH", 62, "What the RC signal of pitch controls, as in RC_MODE.", {.firmware = 2693}},
      {"RC_MODE_YAW", 63, "What the RC signal of yaw controls, as in RC_MODE.", {.firmware = 2693}},
      {"EULER_ORDER", 64, "Order of the Euler angles.", {.firmware = 2693}},
      {"FOLLOW_IN_DBAND", 65, "How much to follow inside the follow mode's dead band.", {.firmware = 2704}},
      {"RC_LIMIT_MIN_ROLL", 66, "Angle of roll at the lowest RC signal.", {.firmware = 2720}},
      {"RC_LIMIT_MAX_ROLL", 67, "Angle of roll at the highest RC signal.", {.firmware = 2720}},
      {"RC_LIMIT_MIN_PITCH", 68, "Angle of pitch at the lowest RC signal.", {.firmware = 2720}},
      {"RC_LIMIT_MAX_PITCH", 69, "Angle of pitch at the highest RC signal.", {.firmware = 2720}},
      {"RC_LIMIT_MIN_YAW", 70, "Angle of yaw at the lowest RC signal.", {.firmware = 2720}},
      {"RC_LIMIT_MAX_YAW", 71, "Angle of yaw at the highest RC signal.", {.firmware = 2720}},
      {"RC_DEADBAND_PITCH", 72, "Dead band around the center of the RC signal of pitch.", {.firmware = 2720}},
      {"RC_DEADBAND_YAW", 73, "Dead band around the center of the RC signal of yaw.", {.firmware = 2720}},
      {"RC_EXPO_RATE_PITCH", 74, "Expo rate of the RC signal of pitch.", {.firmware = 2720}},
      {"RC_EXPO_RATE_YAW", 75, "Expo rate of the RC signal of yaw.", {.firmware = 2720}},
      {"SHAKE_AMP_ROLL", 76, "Amplitude of the shake generator in roll.", {.firmware = 2730}},
      {"SHAKE_AMP_TILT", 77, "Amplitude of the shake generator in tilt.", {.firmware = 2730}},
      {"SHAKE_AMP_PAN", 78, "Amplitude of the shake generator in pan.", {.firmware = 2730}},
      {"SHAKE_FREQ", 79, "Base frequency of the shake generator.", {.firmware = 2730}},
      {"SHAKE_FREQ_RANGE", 80, "Frequency range of the shake generator.", {.firmware = 2730}},
      {"SHAKE_PAUSE_PERIOD", 81, "Period of the pauses of the shake generator.", {.firmware = 2730}},
      {"SHAKE_PAUSE_BALANCE", 82, "Share of the pauses of the shake generator.", {.firmware = 2730}},
      {"SHAKE_PAUSE_RANDOMNESS", 83, "Randomness of the pauses of the shake generator.", {.firmware = 2730}},
      {"SHAKE_RESONANCE_GAIN_ROLL", 84, "Gain of the shake generator's resonance in roll.", {.firmware = 2730}},
      {"SHAKE_RESONANCE_GAIN_TILT", 85, "Gain of the shake generator's resonance in tilt.", {.firmware = 2730}},
      {"SHAKE_RESONANCE_GAIN_PAN", 86, "Gain of the shake generator's resonance in pan.", {.firmware = 2730}},
      {"SHAKE_FREQ_SHIFT_ROLL", 87, "Shift of the shake generator's frequency in roll.", {.firmware = 2730}},
      {"SHAKE_FREQ_SHIFT_TILT", 88, "Shift of the shake generator's frequency in tilt.", {.firmware = 2730}},
      {"SHAKE_FREQ_SHIFT_PAN", 89, "Shift of the shake generator's frequency in pan.", {.firmware = 2730}},
      {"SHAKE_MASTER_GAIN", 90, "Gain of the shake generator in all directions.", {.firmware = 2730}},
      {"OUTER_P_ROLL", 91, "Proportional gain of the outer loop of roll.", {.firmware = 2737}},
      {"OUTER_P_PITCH", 92, "Proportional gain of the outer loop of pitch.", {.firmware = 2737}},
      {"OUTER_P_YAW", 93, "Proportional gain of the outer loop of yaw.", {.firmware = 2737}},
      {"D_LPF_FREQ_ROLL", 94, "Low-pass filter of the derivative term of roll.", {.firmware = 2737}},
      {"D_LPF_FREQ_PITCH", 95, "Low-pass filter of the derivative term of pitch.", {.firmware = 2737}},
      {"D_LPF_FREQ_YAW", 96, "Low-pass filter of the derivative term of yaw.", {.firmware = 2737}},
      {"IMU_ANGLE_CORR_ROLL", 97, "Correction of the roll angle of the IMU.", {.firmware = 2738}},
      {"IMU_ANGLE_CORR_PITCH", 98, "Correction of the pitch angle of the IMU.", {.firmware = 2738}},
      {"SW_LIM_WIDTH_ROLL", 99, "Width of the soft limits of the roll joint.", {.firmware = 2738}},
      {"SW_LIM_WIDTH_PITCH", 100, "Width of the soft limits of the pitch joint.", {.firmware = 2738}},
      {"SW_LIM_WIDTH_YAW", 101, "Width of the soft limits of the yaw joint.", {.firmware = 2738}},
  };
  static constexpr EnumInfo info{"VariableId", values, false};
};

template <>
struct EnumMeta<msg::BoardErrorCode> {
  static constexpr ValueInfo values[] = {
      {"CMD_SIZE", 1, "The command has no body of this size."},
      {"WRONG_PARAMS", 2, "A value is invalid."},
      {"GET_DEVICE_ID", 3, "The board cannot read its device id.", {}, true},
      {"CRYPTO", 4, "A key or signature check failed."},
      {"CALIBRATE_BAT", 5, "The calibration of the battery voltage failed.", {}, true},
      {"UNKNOWN_COMMAND", 6, "The board does not know the command."},
      {"WRONG_STATE", 8, "Not possible in the current state."},
      {"NOT_SUPPORTED", 9, "The board lacks a feature that the command requires."},
      {"OPERATION_FAILED", 10, "The board tried and failed."},
      {"TEMPORARY", 11, "Temporarily not possible; retry later."},
  };
  static constexpr EnumInfo info{"BoardErrorCode", values, false};
};

template <>
struct EnumMeta<msg::RcModeKind> {
  static constexpr ValueInfo values[] = {
      {"RC_MODE_ANGLE", 0, "The angle of the camera."},
      {"RC_MODE_SPEED", 1, "The speed of the camera."},
  };
  static constexpr EnumInfo info{"RcModeKind", values, false};
};

template <>
struct EnumMeta<msg::PwmFrequency> {
  static constexpr ValueInfo values[] = {
      {"PWM_FREQ_LOW", 0, "Low."},
      {"PWM_FREQ_HIGH", 1, "High."},
      {"PWM_FREQ_ULTRA_HIGH", 2, "Ultra high.", {.board = 30}},
  };
  static constexpr EnumInfo info{"PwmFrequency", values, false};
};

template <>
struct EnumMeta<msg::SerialSpeed> {
  static constexpr ValueInfo values[] = {
      {"BAUD_115200", 0, "115200 baud."},
      {"BAUD_57600", 1, "57600 baud."},
      {"BAUD_38400", 2, "38400 baud."},
      {"BAUD_19200", 3, "19200 baud."},
      {"BAUD_9600", 4, "9600 baud."},
      {"BAUD_256000", 5, "256000 baud."},
  };
  static constexpr EnumInfo info{"SerialSpeed", values, false};
};

template <>
struct EnumMeta<msg::RcVirtualMode> {
  static constexpr ValueInfo values[] = {
      {"RC_VIRT_MODE_NORMAL", 0, "One PWM signal."},
      {"RC_VIRT_MODE_CPPM", 1, "Sum-PPM."},
      {"RC_VIRT_MODE_SBUS", 2, "S.BUS.", {.board = 30}},
      {"RC_VIRT_MODE_SPEKTRUM", 3, "Spektrum satellite.", {.board = 30}},
      {"RC_VIRT_MODE_API", 10, "A serial port on the pins RC_ROLL and RC_YAW.", {.board = 30}},
  };
  static constexpr EnumInfo info{"RcVirtualMode", values, false};
};

template <>
struct EnumMeta<msg::RcInput> {
  static constexpr ValueInfo values[] = {
      {"INPUT_NO", 0, "No input."},
      {"RC_INPUT_ROLL", 1, "PWM at the RC_ROLL pin."},
      {"RC_INPUT_PITCH", 2, "PWM at the RC_PITCH pin."},
      {"EXT_FC_INPUT_ROLL", 3, "PWM at the FC_ROLL pin."},
      {"EXT_FC_INPUT_PITCH", 4, "PWM at the FC_PITCH pin."},
      {"RC_INPUT_YAW", 5, "PWM at the RC_YAW pin.", {.board = 30}},
      {"ADC1", 33, "Analog input 1; RC_INPUT_ROLL on older boards.", {.board = 30}},
      {"ADC2", 34, "Analog input 2; RC_INPUT_PITCH on older boards.", {.board = 30}},
      {"ADC3", 35, "Analog input 3; EXT_FC_INPUT_ROLL on older boards.", {.board = 30}},
      {"ADC4", 36, "Analog input 4; EXT_FC_INPUT_PITCH on older boards."},
  };
  static constexpr EnumInfo info{"RcInput", values, false};
};

template <>
struct EnumMeta<msg::RcSource> {
  static constexpr ValueInfo values[] = {
      {"PWM", 0, "A PWM signal."},
      {"ANALOG", 32, "An analog voltage."},
      {"SERIAL", 64, "A virtual channel of Sum-PPM, S.BUS or Spektrum."},
      {"API", 128, "A virtual channel that CMD_API_VIRT_CH_CONTROL sets."},
      {"STEP_SIGNAL", 160, "A step signal, 1 to 6."},
  };
  static constexpr EnumInfo info{"RcSource", values, false};
};

template <>
struct EnumMeta<msg::MixTarget> {
  static constexpr ValueInfo values[] = {
      {"NO_MIX", 0, "None."},
      {"ROLL", 1, "Roll."},
      {"PITCH", 2, "Pitch."},
      {"YAW", 3, "Yaw."},
  };
  static constexpr EnumInfo info{"MixTarget", values, false};
};

template <>
struct EnumMeta<msg::FollowMode> {
  static constexpr ValueInfo values[] = {
      {"FOLLOW_MODE_DISABLED", 0, "Nothing."},
      {"FOLLOW_MODE_FC", 1, "The flight controller."},
      {"FOLLOW_MODE_PITCH", 2, "Pitch and roll of the frame."},
  };
  static constexpr EnumInfo info{"FollowMode", values, false};
};

template <>
struct EnumMeta<msg::SensorAxis> {
  static constexpr ValueInfo values[] = {
      {"X", 1, "X axis."},
      {"Y", 2, "Y axis."},
      {"Z", 3, "Z axis."},
      {"-X", -1, "Against the X axis."},
      {"-Y", -2, "Against the Y axis."},
      {"-Z", -3, "Against the Z axis."},
  };
  static constexpr EnumInfo info{"SensorAxis", values, false};
};

template <>
struct EnumMeta<msg::FrameImuPosition> {
  static constexpr ValueInfo values[] = {
      {"FRAME_IMU_DISABLED", 0, "There is none."},
      {"FRAME_IMU_BELOW_YAW", 1, "Below the yaw motor."},
      {"FRAME_IMU_ABOVE_YAW", 2, "Above the yaw motor."},
      {"FRAME_IMU_BELOW_YAW_PID_SOURCE", 3, "Below the yaw motor, and the input of the PID controller."},
  };
  static constexpr EnumInfo info{"FrameImuPosition", values, false};
};

template <>
struct EnumMeta<msg::SkipGyroCalibration> {
  static constexpr ValueInfo values[] = {
      {"DO_NOT_SKIP", 0, "Calibrate."},
      {"SKIP_ALWAYS", 1, "Never calibrate."},
      {"SKIP_IF_MOVING", 2, "Calibrate unless the board moves."},
  };
  static constexpr EnumInfo info{"SkipGyroCalibration", values, false};
};

template <>
struct EnumMeta<msg::MenuCommand> {
  static constexpr ValueInfo values[] = {
      {"MENU_CMD_NO", 0, "Nothing."},
      {"MENU_CMD_PROFILE1", 1, "Switch to profile 1."},
      {"MENU_CMD_PROFILE2", 2, "Switch to profile 2."},
      {"MENU_CMD_PROFILE3", 3, "Switch to profile 3."},
      {"MENU_CMD_SWAP_PITCH_ROLL", 4, "Swap the RC signals of pitch and roll."},
      {"MENU_CMD_SWAP_YAW_ROLL", 5, "Swap the RC signals of yaw and roll."},
      {"MENU_CMD_CALIB_ACC", 6, "Calibrate the accelerometer."},
      {"MENU_CMD_RESET", 7, "Restart the board."},
      {"MENU_CMD_SET_ANGLE", 8, "Make the current angle the initial angle."},
      {"MENU_CMD_CALIB_GYRO", 9, "Calibrate the gyroscope."},
      {"MENU_CMD_MOTOR_TOGGLE", 10, "Turn the motors on or off."},
      {"MENU_CMD_MOTOR_ON", 11, "Turn the motors on."},
      {"MENU_CMD_MOTOR_OFF", 12, "Turn the motors off."},
      {"MENU_CMD_FRAME_UPSIDE_DOWN", 13, "Treat the frame as upside down."},
      {"MENU_CMD_PROFILE4", 14, "Switch to profile 4."},
      {"MENU_CMD_PROFILE5", 15, "Switch to profile 5."},
      {"MENU_CMD_AUTO_PID", 16, "Tune the PID controllers."},
      {"MENU_CMD_LOOK_DOWN", 17, "Point the camera downwards."},
      {"MENU_CMD_HOME_POSITION", 18, "Return the camera to its home position."},
      {"MENU_CMD_RC_BIND", 19, "Bind an RC receiver."},
      {"MENU_CMD_CALIB_GYRO_TEMP", 20, "Calibrate the gyroscope over temperature."},
      {"MENU_CMD_CALIB_ACC_TEMP", 21, "Calibrate the accelerometer over temperature."},
      {"MENU_CMD_BUTTON_PRESS", 22, "Press the menu button."},
      {"MENU_CMD_RUN_SCRIPT1", 23, "Run script 1."},
      {"MENU_CMD_RUN_SCRIPT2", 24, "Run script 2."},
      {"MENU_CMD_RUN_SCRIPT3", 25, "Run script 3."},
      {"MENU_CMD_RUN_SCRIPT4", 26, "Run script 4."},
      {"MENU_CMD_RUN_SCRIPT5", 27, "Run script 5."},
      {"MENU_CMD_RUN_SCRIPT6", 28, "Run script 6.", {}, true},
      {"MENU_CMD_RUN_SCRIPT7", 29, "Run script 7.", {}, true},
      {"MENU_CMD_RUN_SCRIPT8", 30, "Run script 8.", {}, true},
      {"MENU_CMD_RUN_SCRIPT9", 31, "Run script 9.", {}, true},
      {"MENU_CMD_RUN_SCRIPT10", 32, "Run script 10.", {}, true},
      {"MENU_CMD_CALIB_MAG", 33, "Calibrate the magnetometer."},
      {"MENU_CMD_LEVEL_ROLL_PITCH", 34, "Level roll and pitch."},
      {"MENU_CMD_CENTER_YAW", 35, "Center yaw."},
      {"MENU_CMD_UNTWIST_CABLES", 36, "Turn back to untwist the cables."},
      {"MENU_CMD_SET_ANGLE_NO_SAVE", 37, "Make the current angle the initial angle, without saving it."},
      {"MENU_CMD_HOME_POSITION_SHORTEST", 38, "Return the camera to its home position by the shortest way."},
      {"MENU_CMD_CENTER_YAW_SHORTEST", 39, "Center yaw by the shortest way."},
      {"MENU_CMD_ROTATE_YAW_180", 40, "Turn yaw by half a turn."},
      {"MENU_CMD_ROTATE_YAW_180_FRAME_REL", 41, "Turn yaw by half a turn relative to the frame."},
      {"MENU_CMD_SWITCH_YAW_180_FRAME_REL", 42, "Switch yaw between forwards and backwards relative to the frame."},
      {"MENU_CMD_SWITCH_POS_ROLL_90", 43, "Switch roll between two positions 90 degrees apart."},
      {"MENU_CMD_START_TIMELAPSE", 44, "Start a time-lapse motion."},
      {"MENU_CMD_CALIB_MOMENTUM", 45, "Calibrate the momentum of the axes."},
      {"MENU_CMD_LEVEL_ROLL", 46, "Level roll."},
      {"MENU_CMD_REPEAT_TIMELAPSE", 47, "Repeat the time-lapse motion."},
      {"MENU_CMD_LOAD_PROFILE_SET1", 48, "Load profile set 1."},
      {"MENU_CMD_LOAD_PROFILE_SET2", 49, "Load profile set 2."},
      {"MENU_CMD_LOAD_PROFILE_SET3", 50, "Load profile set 3."},
      {"MENU_CMD_LOAD_PROFILE_SET4", 51, "Load profile set 4."},
      {"MENU_CMD_LOAD_PROFILE_SET5", 52, "Load profile set 5."},
      {"MENU_CMD_LOAD_PROFILE_SET_BACKUP", 53, "Load the backup profile set."},
      {"MENU_CMD_INVERT_RC_ROLL", 54, "Invert the RC signal of roll."},
      {"MENU_CMD_INVERT_RC_PITCH", 55, "Invert the RC signal of pitch."},
      {"MENU_CMD_INVERT_RC_YAW", 56, "Invert the RC signal of yaw."},
      {"MENU_CMD_SNAP_TO_FIXED_POSITION", 57, "Move to the nearest fixed position."},
      {"MENU_CMD_CAMERA_REC_PHOTO_EVENT", 58, "Send a CMD_EVENT for the camera, to record a video or take a photo."},
      {"MENU_CMD_CAMERA_PHOTO_EVENT", 59, "Send a CMD_EVENT for the camera, to take a photo."},
      {"MENU_CMD_MOTORS_SAFE_STOP", 60, "Stop the motors safely, then turn them off."},
      {"MENU_CMD_CALIB_ACC_AUTO", 61, "Calibrate the accelerometer automatically."},
      {"MENU_CMD_RESET_IMU", 62, "Reset the IMU."},
      {"MENU_CMD_FORCED_FOLLOW_TOGGLE", 63, "Turn the forced follow mode on or off."},
      {"MENU_CMD_AUTO_PID_GAIN_ONLY", 64, "Tune the PID controllers, but only their gain."},
      {"MENU_CMD_LEVEL_PITCH", 65, "Level pitch."},
      {"MENU_CMD_MOTORS_SAFE_TOGGLE", 66, "Turn the motors on, or stop them safely and turn them off."},
      {"MENU_CMD_TIMELAPSE_STEP1", 67, "Do the first step of a time-lapse motion."},
      {"MENU_CMD_EXT_GYRO_ONLINE_CALIB", 68, "Calibrate the external gyroscope during operation."},
      {"MENU_CMD_DISABLE_FOLLOW_TOGGLE", 69, "Turn the follow mode off or on again."},
      {"MENU_CMD_SET_CUR_POS_AS_HOME", 70, "Make the current position the home position."},
      {"MENU_CMD_STOP_SCRIPT", 71, "Stop the running script."},
      {"MENU_CMD_TRIPOD_MODE_OFF", 72, "Turn the tripod mode off."},
      {"MENU_CMD_TRIPOD_MODE_ON", 73, "Turn the tripod mode on."},
      {"MENU_CMD_SET_RC_TRIM", 74, "Set the RC trim to the current signals."},
      {"MENU_CMD_HOME_POSITION_MOTORS", 75, "Return the motors to their home positions."},
      {"MENU_CMD_RETRACTED_POSITION", 76, "Move to the retracted position."},
      {"MENU_CMD_SHAKE_GENERATOR_OFF", 77, "Turn the shake generator off."},
      {"MENU_CMD_SHAKE_GENERATOR_ON", 78, "Turn the shake generator on."},
      {"MENU_CMD_SERVO_MODE_ON", 79, "Turn the servo mode on."},
      {"MENU_CMD_SERVO_MODE_OFF", 80, "Turn the servo mode off."},
      {"MENU_CMD_SERVO_MODE_TOGGLE", 81, "Turn the servo mode on or off."},
  };
  static constexpr EnumInfo info{"MenuCommand", values, false};
};

template <>
struct EnumMeta<msg::MotorOutput> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "None."},
      {"ROLL", 1, "The ROLL output."},
      {"PITCH", 2, "The PITCH output."},
      {"YAW", 3, "The YAW output."},
      {"I2C_DRV1", 4, "The first motor driver on the I2C bus."},
      {"I2C_DRV2", 5, "The second motor driver on the I2C bus."},
      {"I2C_DRV3", 6, "The third motor driver on the I2C bus."},
      {"I2C_DRV4", 7, "The fourth motor driver on the I2C bus."},
  };
  static constexpr EnumInfo info{"MotorOutput", values, false};
};

template <>
struct EnumMeta<msg::SelectedImu> {
  static constexpr ValueInfo values[] = {
      {"IMU_TYPE_MAIN", 1, "The main IMU on the camera."},
      {"IMU_TYPE_FRAME", 2, "The IMU on the frame."},
  };
  static constexpr EnumInfo info{"SelectedImu", values, false};
};

template <>
struct EnumMeta<msg::SpektrumMode> {
  static constexpr ValueInfo values[] = {
      {"AUTO", 0, "Detected."},
      {"DSM2_11MS_10BIT", 1, "DSM2, 11 ms, 10 bits."},
      {"DSM2_11MS_11BIT", 2, "DSM2, 11 ms, 11 bits."},
      {"DSM2_22MS_10BIT", 3, "DSM2, 22 ms, 10 bits."},
      {"DSM2_22MS_11BIT", 4, "DSM2, 22 ms, 11 bits."},
      {"DSMX_11MS_10BIT", 5, "DSMX, 11 ms, 10 bits."},
      {"DSMX_11MS_11BIT", 6, "DSMX, 11 ms, 11 bits."},
      {"DSMX_22MS_10BIT", 7, "DSMX, 22 ms, 10 bits."},
      {"DSMX_22MS_11BIT", 8, "DSMX, 22 ms, 11 bits."},
  };
  static constexpr EnumInfo info{"SpektrumMode", values, false};
};

template <>
struct EnumMeta<msg::AxisOrder> {
  static constexpr ValueInfo values[] = {
      {"PITCH_ROLL_YAW", 0, "Pitch, roll, yaw."},
      {"YAW_ROLL_PITCH", 1, "Yaw, roll, pitch."},
      {"ROLL_YAW_PITCH", 2, "Roll, yaw, pitch; not implemented."},
      {"ROLL_PITCH_YAW", 3, "Roll, pitch, yaw."},
  };
  static constexpr EnumInfo info{"AxisOrder", values, false};
};

template <>
struct EnumMeta<msg::EulerOrder> {
  static constexpr ValueInfo values[] = {
      {"PITCH_ROLL_YAW", 0, "Pitch, roll, yaw."},
      {"ROLL_PITCH_YAW", 1, "Roll, pitch, yaw."},
      {"LOCAL_ROLL", 2, "Local, roll; for two-axis systems. Later: pitch of the motor, roll, yaw of the motor."},
      {"ROLL_LOCAL", 3, "Roll, local; for two-axis systems. Later: roll, pitch of the motor, yaw of the motor."},
      {"YAW_ROLL_PITCH", 4, "Yaw, roll, pitch."},
      {"YAW_PITCH_ROLL", 5, "Yaw, pitch, roll."},
  };
  static constexpr EnumInfo info{"EulerOrder", values, false};
};

template <>
struct EnumMeta<msg::ProfileSetAction> {
  static constexpr ValueInfo values[] = {
      {"SAVE", 1, "Save the parameters in use as a profile set."},
      {"CLEAR", 2, "Clear the profile set."},
      {"LOAD", 3, "Load the profile set."},
  };
  static constexpr EnumInfo info{"ProfileSetAction", values, false};
};

template <>
struct EnumMeta<msg::EncoderModel> {
  static constexpr ValueInfo values[] = {
      {"ENC_TYPE_AS5048A", 1, "AS5048A, over SPI."},
      {"ENC_TYPE_AS5048B", 2, "AS5048B, over I2C."},
      {"ENC_TYPE_AS5048_PWM", 3, "AS5048, over PWM."},
      {"ENC_TYPE_AMT203", 4, "AMT203."},
      {"ENC_TYPE_MA3_10BIT", 5, "MA3 with 10 bits."},
      {"ENC_TYPE_MA3_12BIT", 6, "MA3 with 12 bits."},
      {"ENC_TYPE_ANALOG", 7, "Analog."},
      {"ENC_TYPE_I2C_DRV1", 8, "I2C driver 1."},
      {"ENC_TYPE_I2C_DRV2", 9, "I2C driver 2."},
      {"ENC_TYPE_I2C_DRV3", 10, "I2C driver 3."},
      {"ENC_TYPE_I2C_DRV4", 11, "I2C driver 4."},
      {"ENC_TYPE_AS5600_PWM", 12, "AS5600, over PWM."},
      {"ENC_TYPE_AS5600_I2C", 13, "AS5600, over I2C."},
      {"ENC_TYPE_RLS_ORBIS", 14, "RLS Orbis."},
      {"ENC_TYPE_RLS_ORBIS_PWM", 15, "RLS Orbis, over PWM."},
  };
  static constexpr EnumInfo info{"EncoderModel", values, false};
};

template <>
struct EnumMeta<msg::EncoderConfig> {
  static constexpr ValueInfo values[] = {
      {"SPI_SPEED_1MHz", 0, "SPI clock of 1 MHz."},
      {"SPI_SPEED_2MHz", 1, "SPI clock of 2 MHz."},
      {"SPI_SPEED_4MHz", 2, "SPI clock of 4 MHz."},
      {"SPI_SPEED_500kHz", 3, "SPI clock of 500 kHz."},
  };
  static constexpr EnumInfo info{"EncoderConfig", values, false};
};

template <>
struct EnumMeta<msg::BoardPort> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "None."},
      {"UART1", 1, "UART 1."},
      {"RC_SERIAL", 2, "The serial RC input."},
      {"UART2", 3, "UART 2."},
      {"USB_VCP", 4, "The virtual port of the USB connection."},
  };
  static constexpr EnumInfo info{"BoardPort", values, false};
};

template <>
struct EnumMeta<msg::MavControlMode> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "None."},
      {"ROLL_PITCH", 1, "Roll and pitch."},
      {"ALL_AXES", 2, "All."},
  };
  static constexpr EnumInfo info{"MavControlMode", values, false};
};

template <>
struct EnumMeta<msg::StabilizedAxis> {
  static constexpr ValueInfo values[] = {
      {"STAB_AXIS_DEFAULT", 0, "The axis of the motor."},
      {"STAB_AXIS_ROLL", 1, "Roll."},
      {"STAB_AXIS_PITCH", 2, "Pitch."},
      {"STAB_AXIS_YAW", 3, "Yaw."},
  };
  static constexpr EnumInfo info{"StabilizedAxis", values, false};
};

template <>
struct EnumMeta<msg::SnapAngle> {
  static constexpr ValueInfo values[] = {
      {"SNAP_ANGLE_0", 0, "0 degrees."},
      {"SNAP_ANGLE_45", 1, "45 degrees."},
      {"SNAP_ANGLE_90", 2, "90 degrees."},
      {"SNAP_ANGLE_180", 3, "180 degrees."},
  };
  static constexpr EnumInfo info{"SnapAngle", values, false};
};

template <>
struct EnumMeta<msg::StepCount> {
  static constexpr ValueInfo values[] = {
      {"STEPS_2", 0, "2 steps."},
      {"STEPS_3", 1, "3 steps."},
      {"STEPS_5", 2, "5 steps."},
      {"STEPS_10", 3, "10 steps."},
      {"STEPS_15", 4, "15 steps."},
      {"STEPS_25", 5, "25 steps."},
      {"STEPS_50", 6, "50 steps."},
      {"STEPS_100", 7, "100 steps."},
  };
  static constexpr EnumInfo info{"StepCount", values, false};
};

template <>
struct EnumMeta<msg::StepTrigger> {
  static constexpr ValueInfo values[] = {
      {"LEVEL_LOW", 0, "Low."},
      {"LEVEL_HIGH", 1, "High."},
      {"LEVEL_LOW_HIGH", 2, "Low and high."},
  };
  static constexpr EnumInfo info{"StepTrigger", values, false};
};

template <>
struct EnumMeta<msg::WriteParamsAction> {
  static constexpr ValueInfo values[] = {
      {"FINISH", 0, "The series ends."},
      {"START", 1, "The series begins."},
  };
  static constexpr EnumInfo info{"WriteParamsAction", values, false};
};

template <>
struct EnumMeta<msg::ExtImuModel> {
  static constexpr ValueInfo values[] = {
      {"MAVLINK1", 1, "Any, over MAVLink 1."},
      {"MAVLINK2", 2, "Any, over MAVLink 2."},
      {"VECTORNAV_VN200", 3, "VectorNav VN-200."},
      {"INERTIALSENSE_UAHRS", 4, "Inertial Sense uAHRS."},
  };
  static constexpr EnumInfo info{"ExtImuModel", values, false};
};

template <>
struct EnumMeta<msg::ExtImuPosition> {
  static constexpr ValueInfo values[] = {
      {"BELOW_OUTER", 1, "Below the outer motor."},
      {"ABOVE_OUTER", 2, "Above the outer motor."},
      {"BELOW_MIDDLE", 8, "Below the middle motor."},
      {"MAIN_IMU", 9, "At the main IMU."},
  };
  static constexpr EnumInfo info{"ExtImuPosition", values, false};
};

template <>
struct EnumMeta<msg::ExtImuAxis> {
  static constexpr ValueInfo values[] = {
      {"X", 0, "X axis."},
      {"Y", 1, "Y axis."},
      {"Z", 2, "Z axis."},
      {"-X", 3, "Against the X axis."},
      {"-Y", 4, "Against the Y axis."},
      {"-Z", 5, "Against the Z axis."},
  };
  static constexpr EnumInfo info{"ExtImuAxis", values, false};
};

template <>
struct EnumMeta<msg::MultiTurn> {
  static constexpr ValueInfo values[] = {
      {"MULTI_TURN_NO", 0, "It does not count turns."},
      {"MULTI_TURN_12", 1, "12 bits."},
      {"MULTI_TURN_16", 2, "16 bits."},
      {"MULTI_TURN_20", 3, "20 bits."},
      {"MULTI_TURN_24", 4, "24 bits."},
  };
  static constexpr EnumInfo info{"MultiTurn", values, false};
};

template <>
struct EnumMeta<msg::CanImuSensor> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "None."},
      {"KVH_1725", 1, "KVH 1725."},
      {"KVH_1750_ACC_2G", 2, "KVH 1750, accelerometer up to 2 g."},
      {"KVH_1750_ACC_10G", 3, "KVH 1750, accelerometer up to 10 g."},
      {"KVH_1750_ACC_30G", 4, "KVH 1750, accelerometer up to 30 g."},
      {"KVH_1775_ACC_10G", 5, "KVH 1775, accelerometer up to 10 g."},
      {"KVH_1775_ACC_25G", 6, "KVH 1775, accelerometer up to 25 g."},
      {"KVH_1760", 7, "KVH 1760."},
      {"ADXRS453", 8, "ADXRS453."},
      {"ADIS16460", 9, "ADIS16460."},
      {"STIM210", 10, "STIM210."},
      {"STIM300", 11, "STIM300."},
      {"SCHA63X", 12, "SCHA63x."},
      {"VECTORNAV_VN100_200_UART", 64, "VectorNav VN-100 or VN-200, over a UART."},
      {"VECTORNAV_VN100_200_SPI", 65, "VectorNav VN-100 or VN-200, over SPI."},
  };
  static constexpr EnumInfo info{"CanImuSensor", values, false};
};

template <>
struct EnumMeta<msg::InputState> {
  static constexpr ValueInfo values[] = {
      {"LOW", 0, "Low."},
      {"HIGH", 1, "High."},
      {"UNAVAILABLE", 2, "Unavailable or not assigned."},
  };
  static constexpr EnumInfo info{"InputState", values, false};
};

template <>
struct EnumMeta<msg::SystemSubError> {
  static constexpr ValueInfo values[] = {
      {"NONE", 0, "No emergency stop."},
      {"SUB_ERR_I2C_ERRORS", 1, "Too many errors on the I2C bus."},
      {"SUB_ERR_DRV_OTW", 2, "A motor driver reports an overtemperature warning."},
      {"SUB_ERR_DRV_FAULT", 3, "A motor driver failed."},
      {"SUB_ERR_ENCODER_IMU_ANGLE", 4, "Encoder and IMU disagree."},
      {"SUB_ERR_CALIBRATION_FAILED", 5, "A calibration failed."},
      {"SUB_ERR_INTERNAL_SYSTEM_ERROR", 6, "Internal error."},
      {"SUB_ERR_ENCODER_CALIB_BAD_SCALE", 7, "The scale of an encoder is wrong."},
      {"SUB_ERR_OVER_TEMPERATURE", 8, "Overtemperature."},
      {"SUB_ERR_BAD_MOTOR_POLES_INVERT", 9, "Wrong poles or direction of a motor."},
      {"SUB_ERR_NOT_ENOUGH_MEMORY", 10, "Out of memory."},
      {"SUB_ERR_IMU_SENSOR_NOT_RESPONDING", 11, "The IMU sensor does not respond."},
      {"SUB_ERR_CAN_HARD", 12, "The hardware of the CAN bus failed."},
      {"SUB_ERR_MOTOR_OVERHEAT_PROTECTION", 13, "A motor overheated."},
      {"SUB_ERR_MOTOR_IS_LOCKED", 14, "A motor cannot turn."},
      {"SUB_ERR_BAD_IMU_HEALTH", 15, "The IMU sensor is unreliable."},
      {"SUB_ERR_INFINITE_RESET", 16, "The board restarts again and again."},
      {"SUB_ERR_WRONG_INITIAL_POSITION", 17, "The position at start-up is wrong."},
      {"SUB_ERR_MOTOR_LOAD_TIME_EXCEEDED", 18, "A motor was overloaded for too long."},
      {"SUB_ERR_CAN_DRV_OVERCURRENT", 19, "Overcurrent in a CAN motor driver."},
      {"SUB_ERR_CAN_DRV_UNDERVOLTAGE", 20, "Undervoltage in a CAN motor driver."},
      {"SUB_ERR_CAN_DRV_EMERGENCY_PIN", 21, "The emergency pin of a CAN motor driver is active."},
      {"SUB_ERR_CAN_DRV_FOC_DURATION", 22, "The motor control of a CAN motor driver takes too long."},
      {"SUB_ERR_CAN_DRV_MCU_OVERHEAT", 23, "The microcontroller of a CAN motor driver overheated."},
      {"SUB_ERR_CAN_DRV_MOTOR_OVERHEAT", 24, "A motor of a CAN motor driver overheated."},
      {"SUB_ERR_CAN_DRV_OVERCURRENT_SOFT", 25, "The software of a CAN motor driver detected an overcurrent."},
      {"SUB_ERR_CAN_DRV_SEVERAL", 26, "Several CAN motor drivers failed."},
      {"SUB_ERR_CAN_EXT_BUS_OFF", 27, "The external CAN bus is off."},
      {"SUB_ERR_CAN_INT_BUS_OFF", 28, "The internal CAN bus is off."},
      {"SUB_ERR_ENCODER_NOT_FOUND", 29, "An encoder is missing."},
      {"SUB_ERR_CAN_DRV_NOT_RESPONDING", 30, "A CAN motor driver does not respond."},
      {"SUB_ERR_CAN_DRV_WRONG_PARAMS", 31, "Parameters of a CAN motor driver are wrong."},
      {"SUB_ERR_OVERCURRENT", 32, "Overcurrent."},
      {"SUB_ERR_UNSAFE_VOLTAGE", 33, "The supply voltage is unsafe."},
      {"SUB_ERR_WRONG_FULL_BAT_VOLTAGE_PARAM", 34, "The parameter for the voltage of a full battery is wrong."},
      {"SUB_ERR_EEPROM_PARAMS_CORRUPTED", 35, "The parameters in the EEPROM are damaged."},
      {"SUB_ERR_ENCODER_UNSUPPORTED_TYPE", 36, "The kind of encoder is not supported."},
      {"SUB_ERR_EXT_IMU_UNSUPPORTED_TYPE", 37, "The kind of external IMU is not supported."},
      {"SUB_ERR_EXT_IMU_SENSOR_NOT_RESPONDING", 38, "The external IMU does not respond."},
      {"SUB_ERR_EXT_IMU_WRONG_PARAMS", 39, "Parameters of the external IMU are wrong."},
      {"SUB_ERR_DRIVER_INIT", 40, "A motor driver cannot be initialized."},
      {"SUB_ERR_EEPROM_VARS_OUT_OF_BORDERS", 41, "Variables in the EEPROM are out of range."},
      {"SUB_ERR_IWDG_RESET", 42, "The watchdog restarted the board."},
      {"SUB_ERR_ADC_WAIT", 43, "The analog-to-digital converter does not respond."},
      {"SUB_ERR_CALIB_MOTOR_OFF", 44, "The motors were off during a calibration."},
      {"SUB_ERR_TIMEOUT", 45, "Timeout."},
      {"SUB_ERR_CAN_DRV_CALIB_UNEXPECTED_RES", 46, "The calibration of a CAN motor driver had an unexpected result."},
      {"SUB_ERR_MAG_SENSOR_NOT_RESPONDING", 47, "The magnetometer does not respond."},
      {"SUB_ERR_CAN_DRV_OVERSPEED", 48, "A motor of a CAN motor driver is too fast."},
      {"SUB_ERR_ENC_SELF_CALIB_FAILED", 49, "The self-calibration of an encoder failed."},
      {"SUB_ERR_CAN_VERSION_MISMATCH", 50, "The firmware of a CAN device does not match."},
      {"SUB_ERR_CAN_SERIAL_INIT", 51, "The serial port over CAN cannot be initialized."},
      {"SUB_ERR_CAN_SERIAL_CONFLICT", 52, "Serial ports over CAN conflict."},
      {"SUB_ERR_CAN_DRV_INIT_STAGE", 53, "The start-up of a CAN motor driver failed."},
      {"SUB_ERR_ENCODER_DATA_TIMEOUT", 54, "An encoder sends no data."},
      {"SUB_ERR_CAN_CONNECTION_LOST", 55, "The connection to a CAN device is lost."},
      {"SUB_ERR_HSE_START_FAIL", 56, "The external oscillator does not start."},
      {"SUB_ERR_FRAME_IMU_SENSOR_NOT_RESPONDING", 57, "The sensor of the frame IMU does not respond."},
      {"SUB_ERR_PARAMETERS_MODIFIED", 58, "The parameters were modified."},
      {"SUB_ERR_NOT_NORMAL_POSITION", 59, "The camera is not in its normal position."},
      {"SUB_ERR_CAN_DRV_LIMIT_EXCEED", 60, "There are more CAN motor drivers than allowed."},
  };
  static constexpr EnumInfo info{"SystemSubError", values, false};
};

template <>
struct EnumMeta<msg::CalibMode> {
  static constexpr ValueInfo values[] = {
      {"NONE", 0, "None."},
      {"EXT_GAIN", 1, "The gains of a flight controller's signals."},
      {"SET_ANGLE_AND_SAVE", 2, "Make the current angle the initial angle and save it."},
      {"POLES", 3, "The poles and directions of the motors."},
      {"ACC", 4, "The accelerometer."},
      {"GYRO", 5, "The gyroscope."},
      {"ENCODER_OFFSET", 6, "The offsets of the encoders."},
      {"ENCODER_FLD_OFFSET", 7, "The offsets between encoders and magnetic fields."},
      {"AUTO_PID", 8, "Automatic tuning of the PID controllers."},
      {"BODE_TEST", 9, "Recording a frequency response."},
      {"GYRO_TEMP", 10, "The gyroscope over temperature."},
      {"ACC_TEMP", 11, "The accelerometer over temperature."},
      {"MAG", 12, "The magnetometer."},
      {"SET_ANGLE", 13, "Make the current angle the initial angle."},
      {"SYSTEM_IDENT", 14, "Identification of the system."},
      {"MOTOR_MAG_LINK", 15, "The magnetic linkage of the motors."},
      {"SEARCH_LIMITS", 16, "Searching the mechanical limits."},
      {"SET_OPERATION_POS", 17, "Moving to the operating position."},
      {"IMU_ORIENTATION_CORR", 18, "The orientation of the IMU."},
      {"TIMELAPSE", 19, "A time-lapse motion."},
      {"MOMENTUM", 20, "The moment of inertia."},
      {"MOMENTUM_AUTO", 21, "The moment of inertia, automatically."},
      {"COGGING", 22, "The cogging of the motors."},
      {"ACC_EXT_REF", 23, "The accelerometer, by an external reference."},
      {"SAFE_STOP", 24, "A safe stop."},
      {"ACC_SPHERE", 25, "The accelerometer on a sphere."},
      {"GYRO_AXES_ALIGNMENT", 26, "The alignment of the gyroscope's axes."},
      {"EXT_IMU_GYRO", 27, "The gyroscope of the external IMU."},
      {"EXT_IMU_ALIGN", 28, "The alignment of the external IMU."},
      {"ACC_GYRO_MULTIPOINT", 34, "Accelerometer and gyroscope in several positions."},
      {"ENCODER_LUT", 35, "The correction tables of the encoders."},
      {"WRITE_PARAMS", 36, "Writing parameters."},
      {"CUR_SENS", 37, "The current sensors."},
      {"MOVE_HOME_MOTORS", 38, "Moving the motors to their home positions."},
      {"ENCODER_INT", 39, "The internal calibration of the encoders."},
      {"VIBRATION_TEST", 40, "A vibration test."},
      {"RETRACTED_POSITION", 41, "Moving to the retracted position."},
      {"RETRACTED_POSITION_RC_CONTROL", 42, "Moving to or from the retracted position by RC."},
  };
  static constexpr EnumInfo info{"CalibMode", values, false};
};

template <>
struct EnumMeta<msg::PowerState> {
  static constexpr ValueInfo values[] = {
      {"ON_FROM_BACKUP", -2, "On, after a restart."},
      {"STARTUP", -1, "The board is starting."},
      {"OFF", 0, "Off."},
      {"ON", 1, "On."},
      {"OFF_TEMPORARY", 2, "Temporarily off."},
      {"OFF_PARKING", 3, "Off, in the parking position."},
      {"ON_SAFE_STOP", 4, "On, until a safe stop is complete."},
  };
  static constexpr EnumInfo info{"PowerState", values, false};
};

template <>
struct EnumMeta<msg::StreamSync> {
  static constexpr ValueInfo values[] = {
      {"OFF", 0, "None; the samples follow the clock."},
      {"IMU_ATTITUDE", 1, "A new attitude of the IMU."},
  };
  static constexpr EnumInfo info{"StreamSync", values, false};
};

template <>
struct EnumMeta<msg::ControlModeKind> {
  static constexpr ValueInfo values[] = {
      {"MODE_NO_CONTROL", 0, "Serial control ends and RC takes over."},
      {"MODE_SPEED", 1, "Turn at the given speed, in Euler coordinates, until the next command; the angle is ignored."},
      {"MODE_ANGLE", 2, "Go to the given angle, in Euler coordinates, at the given speed; speed 0 selects the speed from the parameters."},
      {"MODE_SPEED_ANGLE", 3, "Follow the given speed while the controller holds the given angle; the most precise mode."},
      {"MODE_RC", 4, "The angle replaces the RC signal, -500 to 500, or -10000 for a lost signal; firmware before 2.61 ignores the speed."},
      {"MODE_ANGLE_REL_FRAME", 5, "Go to the given angle relative to the frame's neutral point; undoes full turns, so it untwists cables. Speed 0 selects the speed from the parameters."},
      {"MODE_RC_HIGH_RES", 6, "Like MODE_RC, with a finer signal: -16384 to 16384, or -32768 for a lost signal.", {.firmware = 2662}},
      {"MODE_IGNORE", 7, "The axis keeps its state; its speed and angle are ignored.", {.firmware = 2704}},
      {"MODE_ANGLE_SHORTEST", 8, "Like MODE_ANGLE, but by the shortest way that the software limits leave open.", {.firmware = 2707}},
  };
  static constexpr EnumInfo info{"ControlModeKind", values, false};
};

template <>
struct EnumMeta<msg::MotorsOffMode> {
  static constexpr ValueInfo values[] = {
      {"NORMAL", 0, "They turn freely, without current."},
      {"BRAKE", 1, "They brake."},
      {"SAFE_STOP", 2, "Their power falls until they stand still, then they are off."},
  };
  static constexpr EnumInfo info{"MotorsOffMode", values, false};
};

template <>
struct EnumMeta<msg::CoordinateSystem> {
  static constexpr ValueInfo values[] = {
      {"COORD_SYS_GROUND_YAW_ROTATED", 1, "Ground coordinates rotated with the camera about Z: Z points up, X right, Y forward. The default."},
      {"COORD_SYS_GROUND_END", 2, "Ground coordinates: X points east, Y north, Z down."},
      {"COORD_SYS_FRAME", 3, "Coordinates of the frame."},
  };
  static constexpr EnumInfo info{"CoordinateSystem", values, false};
};

template <>
struct EnumMeta<msg::EulerOrderChange> {
  static constexpr ValueInfo values[] = {
      {"KEEP", 0, "The order does not change."},
      {"PITCH_ROLL_YAW", 1, "Pitch, roll, yaw."},
      {"ROLL_PITCH_YAW", 2, "Roll, pitch, yaw."},
      {"LOCAL_ROLL", 3, "Pitch of the motor, roll, yaw of the motor."},
      {"ROLL_LOCAL", 4, "Roll, pitch of the motor, yaw of the motor."},
      {"YAW_ROLL_PITCH", 5, "Yaw, roll, pitch."},
      {"YAW_PITCH_ROLL", 6, "Yaw, pitch, roll.", {}, true},
  };
  static constexpr EnumInfo info{"EulerOrderChange", values, false};
};

template <>
struct EnumMeta<msg::ControlQuatMode> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "Control with quaternions ends."},
      {"SPEED", 1, "Turn at the given speed, without a motion profile."},
      {"ATTITUDE", 2, "Go to the given attitude with the configured motion profile."},
      {"SPEED_ATTITUDE", 5, "Turn at the given speed and correct deviations from the given attitude."},
      {"SPEED_LIMITED", 9, "Turn at the given speed, reached with the configured motion profile."},
  };
  static constexpr EnumInfo info{"ControlQuatMode", values, false};
};

template <>
struct EnumMeta<msg::QuaternionComponent> {
  static constexpr ValueInfo values[] = {
      {"W", 0, "The scalar component."},
      {"X", 1, "The X component."},
      {"Y", 2, "The Y component."},
      {"Z", 3, "The Z component."},
  };
  static constexpr EnumInfo info{"QuaternionComponent", values, false};
};

template <>
struct EnumMeta<msg::SyncMotorAxis> {
  static constexpr ValueInfo values[] = {
      {"ROLL", 0, "Roll."},
      {"PITCH", 1, "Pitch."},
      {"YAW", 2, "Yaw."},
  };
  static constexpr EnumInfo info{"SyncMotorAxis", values, false};
};

template <>
struct EnumMeta<msg::EventId> {
  static constexpr ValueInfo values[] = {
      {"MENU_BUTTON", 1, "The menu button was pressed or released."},
      {"MOTOR_STATE", 2, "The motors were turned on or off."},
      {"EMERGENCY_STOP", 3, "An emergency stop began or ended."},
      {"CAMERA", 4, "The camera is to record or to take a photo."},
      {"SCRIPT", 5, "A script started or ended.", {.firmware = 2688}},
      {"RETRACTED_POSITION", 6, "The retracted position was reached or left.", {.firmware = 2731}},
  };
  static constexpr EnumInfo info{"EventId", values, false};
};

template <>
struct EnumMeta<msg::ExtMotorActionKind> {
  static constexpr ValueInfo values[] = {
      {"OFF_FLOATING", 1, "Turn off and rotate freely."},
      {"OFF_BRAKE", 2, "Turn off and brake."},
      {"OFF_SAFE", 3, "Slow down against external forces, then turn off and brake."},
      {"ON", 4, "Turn on."},
      {"HOME_POSITION", 5, "Move to the home position."},
      {"SEARCH_HOME", 6, "Search the home position of a geared motor, or of one that makes several turns."},
  };
  static constexpr EnumInfo info{"ExtMotorActionKind", values, false};
};

template <>
struct EnumMeta<msg::ExtMotorMode> {
  static constexpr ValueInfo values[] = {
      {"POSITION", 0, "Its angle."},
      {"SPEED", 1, "Its speed."},
      {"TORQUE", 2, "Its torque."},
  };
  static constexpr EnumInfo info{"ExtMotorMode", values, false};
};

template <>
struct EnumMeta<msg::ExtMotorPower> {
  static constexpr ValueInfo values[] = {
      {"OFF_BRAKE", 0, "It is off and brakes."},
      {"ON", 1, "It is on."},
      {"OFF_FLOATING", 2, "It is off and rotates freely."},
      {"OFF_SAFE_STOP", 3, "It is off after a safe stop."},
  };
  static constexpr EnumInfo info{"ExtMotorPower", values, false};
};

template <>
struct EnumMeta<msg::BodeAxis> {
  static constexpr ValueInfo values[] = {
      {"ROLL", 0, "Roll."},
      {"PITCH", 1, "Pitch."},
      {"YAW", 2, "Yaw."},
  };
  static constexpr EnumInfo info{"BodeAxis", values, false};
};

template <>
struct EnumMeta<msg::BodeStimulus> {
  static constexpr ValueInfo values[] = {
      {"WHITE_NOISE", 1, "White noise."},
      {"SINE_SWEEP", 2, "A sine with rising frequency."},
      {"EXPONENTIAL_SWEEP", 3, "A sine with exponentially rising frequency."},
  };
  static constexpr EnumInfo info{"BodeStimulus", values, false};
};

template <>
struct EnumMeta<msg::BodeSystem> {
  static constexpr ValueInfo values[] = {
      {"CONTROLLER", 3, "The controller."},
      {"OPEN_LOOP_PLANT_WITH_FILTERS", 6, "The plant with notch filters, open loop."},
      {"OPEN_LOOP_CONTROLLER_AND_PLANT", 7, "Controller and plant, open loop."},
      {"OVERALL", 11, "The overall response of the system."},
      {"OPEN_LOOP_PLANT", 70, "The plant alone, open loop."},
      {"CLOSED_LOOP_PLANT_WITH_FILTERS", 134, "The plant with notch filters, closed loop."},
      {"CLOSED_LOOP_CONTROLLER_AND_PLANT", 135, "Controller and plant, closed loop."},
      {"CLOSED_LOOP_PLANT", 198, "The plant alone, closed loop."},
  };
  static constexpr EnumInfo info{"BodeSystem", values, false};
};

template <>
struct EnumMeta<msg::CalibImu> {
  static constexpr ValueInfo values[] = {
      {"ACTIVE", 0, "The active IMU."},
      {"MAIN", 1, "The main IMU on the camera."},
      {"FRAME", 2, "The IMU on the frame."},
  };
  static constexpr EnumInfo info{"CalibImu", values, false};
};

template <>
struct EnumMeta<msg::CalibAction> {
  static constexpr ValueInfo values[] = {
      {"REGULAR", 1, "Calibrate at the current temperature."},
      {"RESET", 2, "Erase all calibrations and restart."},
      {"TEMPERATURE", 3, "Calibrate over temperature."},
      {"ENABLE_TEMPERATURE", 4, "Enable the calibration over temperature, if there is one, and restart."},
      {"DISABLE_TEMPERATURE", 5, "Disable the calibration over temperature, but keep it in memory, and restart."},
      {"RESTORE_FACTORY", 6, "Copy the calibration from the sensor's EEPROM to the main EEPROM."},
      {"STORE_IN_SENSOR", 7, "Copy the calibration from the main EEPROM to the sensor's EEPROM."},
  };
  static constexpr EnumInfo info{"CalibAction", values, false};
};

template <>
struct EnumMeta<msg::CalibMotor> {
  static constexpr ValueInfo values[] = {
      {"ROLL", 0, "The roll motor."},
      {"PITCH", 1, "The pitch motor."},
      {"YAW", 2, "The yaw motor."},
      {"ALL", 255, "All motors."},
  };
  static constexpr EnumInfo info{"CalibMotor", values, false};
};

template <>
struct EnumMeta<msg::AutoPid2Action> {
  static constexpr ValueInfo values[] = {
      {"START", 1, "Start the tuning with this configuration."},
      {"START_SAVE", 2, "Save this configuration and start the tuning."},
      {"SAVE", 3, "Save this configuration."},
      {"STOP", 5, "Stop the tuning."},
      {"READ", 6, "Read the saved configuration."},
  };
  static constexpr EnumInfo info{"AutoPid2Action", values, false};
};

template <>
struct EnumMeta<msg::CoggingAction> {
  static constexpr ValueInfo values[] = {
      {"CALIBRATE", 1, "Calibrate the motors."},
      {"DELETE", 2, "Delete the calibration of the motors."},
  };
  static constexpr EnumInfo info{"CoggingAction", values, false};
};

template <>
struct EnumMeta<msg::ImuIndex> {
  static constexpr ValueInfo values[] = {
      {"MAIN", 0, "The main IMU on the camera."},
      {"FRAME", 1, "The IMU on the frame."},
  };
  static constexpr EnumInfo info{"ImuIndex", values, false};
};

template <>
struct EnumMeta<msg::AhrsReference> {
  static constexpr ValueInfo values[] = {
      {"NONE", 0, "None."},
      {"INTERNAL", 1, "The board's own sensor."},
      {"EXTERNAL", 2, "An external sensor."},
      {"TRANSLATE", 3, "The other IMU, translated by the motor angles."},
  };
  static constexpr EnumInfo info{"AhrsReference", values, false};
};

template <>
struct EnumMeta<msg::ExtImuState> {
  static constexpr ValueInfo values[] = {
      {"DISABLED", 0, "Disabled."},
      {"NOT_CONNECTED", 1, "Not connected."},
      {"UNKNOWN", 2, "Unknown."},
      {"ERROR", 3, "It reports an error."},
      {"BAD", 4, "Its data are bad."},
      {"COARSE", 5, "Its data are coarse."},
      {"GOOD", 6, "Its data are good."},
      {"FINE", 7, "Its data are precise."},
  };
  static constexpr EnumInfo info{"ExtImuState", values, false};
};

template <>
struct EnumMeta<msg::ExtSensCommand> {
  static constexpr ValueInfo values[] = {
      {"CONFIRM", 1, "Confirmation."},
      {"RESET", 2, "Restart the sensor."},
      {"RESET_NOTIFY", 3, "The sensor restarts."},
      {"GET_DEVICE_INFO", 4, "Request information about the sensor."},
      {"DEVICE_INFO", 5, "Information about the sensor."},
      {"GET_DATA", 6, "Request data."},
      {"GET_DATA_STREAM", 7, "Request a stream of data."},
      {"DATA", 8, "Data."},
      {"CALIB", 9, "Calibrate the sensor."},
      {"BOOT_MODE", 10, "Enter the bootloader of the sensor."},
      {"USER_DATA_LOG", 11, "Log the user's data."},
      {"GET_USER_CONF_LOG", 12, "Request the configuration of the log."},
      {"USER_CONF_LOG", 13, "Configuration of the log."},
  };
  static constexpr EnumInfo info{"ExtSensCommand", values, false};
};

template <>
struct EnumMeta<msg::BoardPin> {
  static constexpr ValueInfo values[] = {
      {"RC_INPUT_ROLL", 1, "The RC_ROLL pin."},
      {"RC_INPUT_PITCH", 2, "The RC_PITCH pin."},
      {"EXT_FC_INPUT_ROLL", 3, "The FC_ROLL pin."},
      {"EXT_FC_INPUT_PITCH", 4, "The FC_PITCH pin."},
      {"RC_INPUT_YAW", 5, "The RC_YAW pin.", {.board = 30}},
      {"PIN_AUX1", 16, "The AUX1 pin; on 1.x boards, pin 2 of the microcontroller."},
      {"PIN_AUX2", 17, "The AUX2 pin; on 1.x boards, pin 11 of the microcontroller."},
      {"PIN_AUX3", 18, "The AUX3 pin; on 1.x boards, pin 12 of the microcontroller."},
      {"PIN_BUZZER", 32, "The buzzer; on 1.x boards, pin 32 of the microcontroller."},
      {"PIN_SSAT_POWER", 33, "The 3.3 V supply of the Spektrum connector; LOW turns it on."},
  };
  static constexpr EnumInfo info{"BoardPin", values, false};
};

template <>
struct EnumMeta<msg::OutputPin> {
  static constexpr ValueInfo values[] = {
      {"RC_INPUT_ROLL", 1, "The RC_ROLL pin."},
      {"RC_INPUT_PITCH", 2, "The RC_PITCH pin."},
      {"EXT_FC_INPUT_ROLL", 3, "The FC_ROLL pin."},
      {"EXT_FC_INPUT_PITCH", 4, "The FC_PITCH pin."},
      {"RC_INPUT_YAW", 5, "The RC_YAW pin.", {.board = 30}},
      {"PIN_AUX1", 16, "The AUX1 pin; on 1.x boards, pin 2 of the microcontroller."},
      {"PIN_AUX2", 17, "The AUX2 pin; on 1.x boards, pin 11 of the microcontroller."},
      {"PIN_AUX3", 18, "The AUX3 pin; on 1.x boards, pin 12 of the microcontroller."},
      {"PIN_BUZZER", 32, "The buzzer; on 1.x boards, pin 32 of the microcontroller."},
      {"PIN_SSAT_POWER", 33, "The 3.3 V supply of the Spektrum connector; LOW turns it on."},
      {"CAN_DRV1_AUX1", 64, "The AUX1 pin of CAN motor driver 1."},
      {"CAN_DRV1_AUX2", 65, "The AUX2 pin of CAN motor driver 1."},
      {"CAN_DRV1_AUX3", 66, "The AUX3 pin of CAN motor driver 1."},
      {"CAN_DRV2_AUX1", 67, "The AUX1 pin of CAN motor driver 2."},
      {"CAN_DRV2_AUX2", 68, "The AUX2 pin of CAN motor driver 2."},
      {"CAN_DRV2_AUX3", 69, "The AUX3 pin of CAN motor driver 2."},
      {"CAN_DRV3_AUX1", 70, "The AUX1 pin of CAN motor driver 3."},
      {"CAN_DRV3_AUX2", 71, "The AUX2 pin of CAN motor driver 3."},
      {"CAN_DRV3_AUX3", 72, "The AUX3 pin of CAN motor driver 3."},
      {"CAN_DRV4_AUX1", 73, "The AUX1 pin of CAN motor driver 4."},
      {"CAN_DRV4_AUX2", 74, "The AUX2 pin of CAN motor driver 4."},
      {"CAN_DRV4_AUX3", 75, "The AUX3 pin of CAN motor driver 4."},
      {"CAN_DRV5_AUX1", 76, "The AUX1 pin of CAN motor driver 5."},
      {"CAN_DRV5_AUX2", 77, "The AUX2 pin of CAN motor driver 5."},
      {"CAN_DRV5_AUX3", 78, "The AUX3 pin of CAN motor driver 5."},
      {"CAN_DRV6_AUX1", 79, "The AUX1 pin of CAN motor driver 6."},
      {"CAN_DRV6_AUX2", 80, "The AUX2 pin of CAN motor driver 6."},
      {"CAN_DRV6_AUX3", 81, "The AUX3 pin of CAN motor driver 6."},
      {"CAN_DRV7_AUX1", 82, "The AUX1 pin of CAN motor driver 7."},
      {"CAN_DRV7_AUX2", 83, "The AUX2 pin of CAN motor driver 7."},
      {"CAN_DRV7_AUX3", 84, "The AUX3 pin of CAN motor driver 7."},
      {"CAN_IMU_AUX1", 85, "The AUX1 pin of the main CAN IMU."},
      {"CAN_IMU_AUX2", 86, "The AUX2 pin of the main CAN IMU."},
      {"CAN_IMU_FRAME_AUX1", 88, "The AUX1 pin of the CAN IMU of the frame."},
      {"CAN_IMU_FRAME_AUX2", 89, "The AUX2 pin of the CAN IMU of the frame."},
  };
  static constexpr EnumInfo info{"OutputPin", values, false};
};

template <>
struct EnumMeta<msg::PinState> {
  static constexpr ValueInfo values[] = {
      {"LOW", 0, "Low; sinks up to 40 mA."},
      {"HIGH", 1, "High; supplies up to 40 mA."},
      {"FLOATING", 2, "Floating.", {.firmware = 2660}},
      {"INPUT_PULL_UP", 3, "An input that is pulled up.", {.firmware = 2743}},
      {"INPUT_PULL_DOWN", 4, "An input that is pulled down.", {.firmware = 2743}},
  };
  static constexpr EnumInfo info{"PinState", values, false};
};

template <>
struct EnumMeta<msg::I2cPort> {
  static constexpr ValueInfo values[] = {
      {"MAIN", 0, "The bus of the sensors."},
      {"SECOND", 1, "The bus of the EEPROM."},
  };
  static constexpr EnumInfo info{"I2cPort", values, false};
};

template <>
struct EnumMeta<msg::ModuleId> {
  static constexpr ValueInfo values[] = {
      {"IMU_MAIN", 1, "Main IMU."},
      {"IMU_FRAME", 2, "Frame IMU."},
      {"CAN_DRV1", 3, "CAN motor driver 1."},
      {"CAN_DRV2", 4, "CAN motor driver 2."},
      {"CAN_DRV3", 5, "CAN motor driver 3."},
      {"CAN_DRV4", 6, "CAN motor driver 4."},
      {"CAN_DRV5", 7, "CAN motor driver 5."},
      {"CAN_DRV6", 8, "CAN motor driver 6."},
      {"CAN_DRV7", 9, "CAN motor driver 7."},
      {"GPS_IMU", 10, "GPS_IMU."},
      {"CAN_HUB_GNSS", 11, "CAN hub with a GNSS receiver."},
      {"CAN_HUB1", 12, "CAN hub 1."},
      {"CAN_HUB2", 13, "CAN hub 2."},
      {"UDRV1", 14, "uDrv module 1."},
      {"UDRV2", 15, "uDrv module 2."},
      {"UDRV3", 16, "uDrv module 3."},
      {"UDRV4", 17, "uDrv module 4."},
  };
  static constexpr EnumInfo info{"ModuleId", values, false};
};

template <>
struct EnumMeta<msg::CanDeviceId> {
  static constexpr ValueInfo values[] = {
      {"NOT_ASSIGNED", 0, "None assigned."},
      {"CAN_IMU_MAIN", 5, "Main IMU."},
      {"CAN_IMU_FRAME", 6, "Frame IMU."},
      {"GPS_IMU_MAIN", 7, "GPS_IMU as the main IMU."},
      {"CAN_DRV1", 17, "CAN motor driver 1."},
      {"CAN_DRV2", 18, "CAN motor driver 2."},
      {"CAN_DRV3", 19, "CAN motor driver 3."},
      {"CAN_DRV4", 20, "CAN motor driver 4."},
      {"CAN_DRV5", 21, "CAN motor driver 5."},
      {"CAN_DRV6", 22, "CAN motor driver 6."},
      {"CAN_DRV7", 23, "CAN motor driver 7."},
      {"CAN_IMU_MAIN_OLD", 28, "Main IMU of an older kind."},
      {"CAN_IMU_FRAME_OLD", 29, "Frame IMU of an older kind."},
  };
  static constexpr EnumInfo info{"CanDeviceId", values, false};
};

template <>
struct EnumMeta<msg::CanDeviceKind> {
  static constexpr ValueInfo values[] = {
      {"MOTOR_DRIVER", 1, "Motor driver."},
      {"IMU", 2, "IMU."},
  };
  static constexpr EnumInfo info{"CanDeviceKind", values, false};
};

template <>
struct EnumMeta<msg::TransparentDevice> {
  static constexpr ValueInfo values[] = {
      {"SBGC32", 1, "The board itself."},
      {"GPS_IMU", 2, "GPS_IMU."},
      {"CAN_IMU_MAIN", 3, "Main IMU."},
      {"CAN_IMU_FRAME", 4, "Frame IMU."},
      {"GPS_SPLIT_RCVR", 5, "Split GPS receiver."},
      {"CAN_SERIAL_HUB1", 6, "CAN hub 1."},
      {"CAN_SERIAL_HUB2", 7, "CAN hub 2."},
      {"CAN_DRV1", 8, "CAN motor driver 1."},
      {"CAN_DRV2", 9, "CAN motor driver 2."},
      {"CAN_DRV3", 10, "CAN motor driver 3."},
      {"CAN_DRV4", 11, "CAN motor driver 4."},
  };
  static constexpr EnumInfo info{"TransparentDevice", values, false};
};

template <>
struct EnumMeta<msg::FileError> {
  static constexpr ValueInfo values[] = {
      {"NO_ERROR", 0, Explanation{"Success."}},
      {"ERR_EEPROM_FAULT", 1, Explanation{"The memory chip does not respond."}},
      {"ERR_FILE_NOT_FOUND", 2, Explanation{"No file has this id."}},
      {"ERR_FAT", 3, Explanation{"The file table is damaged."}},
      {"ERR_NO_FREE_SPACE", 4, Explanation{"The memory is full."}},
      {"ERR_FAT_IS_FULL", 5, Explanation{"The file table is full."}},
      {"ERR_FILE_SIZE", 6, Explanation{"The size is invalid."}},
      {"ERR_CRC", 7, Explanation{"Checksum mismatch."}},
      {"ERR_LIMIT_REACHED", 8, Explanation{"The file system reached a limit."}},
      {"ERR_FILE_CORRUPTED", 9, Explanation{"The file is damaged."}},
      {"ERR_WRONG_PARAMS", 10, Explanation{"A value of the request is invalid."}},
  };
  static constexpr EnumInfo info{"FileError", values, false};
};

template <>
struct EnumMeta<msg::ScriptMode> {
  static constexpr ValueInfo values[] = {
      {"STOP", 0, "Stop it."},
      {"START", 1, "Start it."},
      {"START_DEBUG", 2, "Start it and report progress with CMD_SCRIPT_DEBUG."},
  };
  static constexpr EnumInfo info{"ScriptMode", values, false};
};

template <>
struct EnumMeta<msg::DebugVarKind> {
  static constexpr ValueInfo values[] = {
      {"VAR_TYPE_UINT8", 1, "Unsigned, 8 bits."},
      {"VAR_TYPE_INT8", 2, "Signed, 8 bits."},
      {"VAR_TYPE_UINT16", 3, "Unsigned, 16 bits."},
      {"VAR_TYPE_INT16", 4, "Signed, 16 bits."},
      {"VAR_TYPE_UINT32", 5, "Unsigned, 32 bits."},
      {"VAR_TYPE_INT32", 6, "Signed, 32 bits."},
      {"VAR_TYPE_FLOAT", 7, "Floating point, IEEE-754, 32 bits."},
  };
  static constexpr EnumInfo info{"DebugVarKind", values, false};
};

template <>
struct EnumMeta<msg::DebugVarAxis> {
  static constexpr ValueInfo values[] = {
      {"NO_AXIS", 0, "None."},
      {"VAR_FLAG_ROLL", 16, "Roll."},
      {"VAR_FLAG_PITCH", 32, "Pitch."},
      {"VAR_FLAG_YAW", 48, "Yaw."},
  };
  static constexpr EnumInfo info{"DebugVarAxis", values, false};
};

template <>
struct EnumMeta<msg::DebugPortAction> {
  static constexpr ValueInfo values[] = {
      {"STOP", 0, "Stop copying messages."},
      {"START", 1, "Copy messages to this port."},
  };
  static constexpr EnumInfo info{"DebugPortAction", values, false};
};

template <>
struct EnumMeta<msg::BoardFeature> {
  static constexpr ValueInfo values[] = {
      {"BOARD_FEATURE_3AXIS", 1, "Drives three motors."},
      {"BOARD_FEATURE_BAT_MONITORING", 2, "Measures the battery voltage."},
      {"BOARD_FEATURE_ENCODERS", 4, "Supports motor encoders."},
      {"BOARD_FEATURE_BODE_TEST", 8, "Can record a frequency response."},
      {"BOARD_FEATURE_SCRIPTING", 16, "Runs user scripts."},
      {"BOARD_FEATURE_CURRENT_SENSOR", 32, "Measures the supply current."},
      {"BOARD_FEATURE_MAG_SENSOR", 64, "Supports a magnetometer."},
      {"BOARD_FEATURE_ORDER_OF_AXES_LETUS", 128, "Supports the order of axes of a Letus gimbal."},
      {"BOARD_FEATURE_IMU_EEPROM", 256, "The main IMU has an EEPROM."},
      {"BOARD_FEATURE_FRAME_IMU_EEPROM", 512, "The frame IMU has an EEPROM."},
      {"BOARD_FEATURE_CAN_PORT", 1024, "Has a CAN bus."},
      {"BOARD_FEATURE_MOMENTUM", 2048, "Compensates the moment of inertia."},
      {"BOARD_FEATURE_COGGING_CORRECTION", 4096, "Corrects the cogging of motors."},
      {"BOARD_FEATURE_MOTOR4_CONTROL", 8192, "Drives a fourth motor."},
      {"BOARD_FEATURE_ACC_AUTO_CALIB", 16384, "Calibrates the accelerometer automatically."},
      {"BOARD_FEATURE_BIG_FLASH", 32768, "Has a large flash memory."},
  };
  static constexpr EnumInfo info{"BoardFeatures", values, true};
};

template <>
struct EnumMeta<msg::BoardFeaturesExtBit> {
  static constexpr ValueInfo values[] = {
      {"EXT_IMU", 1, "Supports an external IMU."},
      {"STATE_VARS", 4, "Keeps statistics; see CMD_READ_STATE_VARS."},
      {"POWER_MANAGEMENT", 8, "Manages its power supply."},
      {"GYRO_ADVANCED_CALIB", 16, "Has an advanced calibration of the gyroscope."},
      {"LIMITED_VERSION", 32, "Has a limited set of functions."},
      {"REACTION", 64, "Has a feature of this name, which no source explains."},
      {"ENCODER_LUT", 128, "Corrects encoders with a lookup table."},
  };
  static constexpr EnumInfo info{"BoardFeaturesExt", values, true};
};

template <>
struct EnumMeta<msg::BoardFeaturesExt2Bit> {
  static constexpr ValueInfo values[] = {
      {"PLUS_VER", 1, "The firmware is a \"plus\" version."},
      {"SHAKE_GENERATOR", 2, "Can shake the camera on purpose."},
      {"EXT_MOTORS", 4, "Drives auxiliary motors."},
      {"QUAT_CONTROL", 8, "Can be controlled with quaternions."},
      {"ADC4", 16, "Has a fourth analog input."},
  };
  static constexpr EnumInfo info{"BoardFeaturesExt2", values, true};
};

template <>
struct EnumMeta<msg::BoardStateFlag> {
  static constexpr ValueInfo values[] = {
      {"DEBUG_MODE", 1, "A host should show its debug output."},
      {"IS_FRAME_INVERTED", 2, "The frame is upside down."},
      {"INIT_STEP1_DONE", 4, "The first step of the start-up is done."},
      {"INIT_STEP2_DONE", 8, "The second step of the start-up is done."},
      {"STARTUP_AUTO_ROUTINE_DONE", 16, "The automatic actions at start-up are done."},
      {"POWER_MANAGER_ENABLED", 32, "Power management is on."},
  };
  static constexpr EnumInfo info{"BoardStateFlags", values, true};
};

template <>
struct EnumMeta<msg::HardwareFlag> {
  static constexpr ValueInfo values[] = {
      {"ONE_WIRE_CRYPTO_IC", 1, "A one-wire crypto chip is installed."},
  };
  static constexpr EnumInfo info{"HardwareFlags", values, true};
};

template <>
struct EnumMeta<msg::StoredProfileSet> {
  static constexpr ValueInfo values[] = {
      {"PROFILE_SET1", 1, "Profile set 1."},
      {"PROFILE_SET2", 2, "Profile set 2."},
      {"PROFILE_SET3", 4, "Profile set 3."},
      {"PROFILE_SET4", 8, "Profile set 4."},
      {"PROFILE_SET5", 16, "Profile set 5."},
      {"PROFILE_SET_BACKUP", 32, "The backup."},
  };
  static constexpr EnumInfo info{"StoredProfileSets", values, true};
};

template <>
struct EnumMeta<msg::ConnectionFlag> {
  static constexpr ValueInfo values[] = {
      {"CONNECTION_USB", 1, "The host is connected over USB, not over a UART."},
  };
  static constexpr EnumInfo info{"ConnectionFlags", values, true};
};

template <>
struct EnumMeta<msg::ResetOption> {
  static constexpr ValueInfo values[] = {
      {"NOTIFY", 1, "Send CMD_RESET back first."},
      {"RESTORE_STATE", 2, "Keep the state and restore it after the restart; not for CMD_BOOT_MODE_3."},
  };
  static constexpr EnumInfo info{"ResetOptions", values, true};
};

template <>
struct EnumMeta<msg::PassProtectFlag> {
  static constexpr ValueInfo values[] = {
      {"ENCRYPT_PARAMS", 2, "Parameters are encrypted."},
      {"SILENT", 4, "By its name, protected ports do not respond without the password."},
      {"CHANNEL_1_ENABLED", 16, "Port 1 is protected, by the name."},
      {"CHANNEL_2_ENABLED", 32, "Port 2 is protected, by the name."},
      {"CHANNEL_3_ENABLED", 64, "Port 3 is protected, by the name."},
      {"CHANNEL_4_ENABLED", 128, "Port 4 is protected, by the name."},
      {"CHANNEL_5_ENABLED", 256, "Port 5 is protected, by the name."},
      {"CHANNEL_6_ENABLED", 512, "Port 6 is protected, by the name."},
      {"CHANNEL_1_ALLOW_CONTROL", 1024, "Port 1 accepts control without the password, by the name."},
      {"CHANNEL_2_ALLOW_CONTROL", 2048, "Port 2 accepts control without the password, by the name."},
      {"CHANNEL_3_ALLOW_CONTROL", 4096, "Port 3 accepts control without the password, by the name."},
      {"CHANNEL_4_ALLOW_CONTROL", 8192, "Port 4 accepts control without the password, by the name."},
      {"CHANNEL_5_ALLOW_CONTROL", 16384, "Port 5 accepts control without the password, by the name."},
      {"CHANNEL_6_ALLOW_CONTROL", 32768, "Port 6 accepts control without the password, by the name."},
  };
  static constexpr EnumInfo info{"PassProtectFlags", values, true};
};

template <>
struct EnumMeta<msg::FilterSwitch> {
  static constexpr ValueInfo values[] = {
      {"EN_NOTCH1", 1, "First notch filter.", {}, false, "notchEnabled1"},
      {"EN_NOTCH2", 2, "Second notch filter.", {}, false, "notchEnabled2"},
      {"EN_NOTCH3", 4, "Third notch filter.", {}, false, "notchEnabled3"},
      {"EN_LPF", 8, "Low-pass filter.", {}, false, "lpfEnabled"},
  };
  static constexpr EnumInfo info{"FilterSwitches", values, true};
};

template <>
struct EnumMeta<msg::EncoderFlag> {
  static constexpr ValueInfo values[] = {
      {"SKIP_DETECTION", 16, "Do not detect whether the encoder is present."},
      {"ENCODER_IS_GEARED", 128, "There is a gear between motor and encoder."},
  };
  static constexpr EnumInfo info{"EncoderFlags", values, true};
};

template <>
struct EnumMeta<msg::BeeperMode> {
  static constexpr ValueInfo values[] = {
      {"BEEPER_MODE_CALIBRATE", 1, "During calibrations."},
      {"BEEPER_MODE_CONFIRM", 2, "To confirm commands."},
      {"BEEPER_MODE_ERROR", 4, "On errors."},
      {"BEEPER_MODE_ALARM", 8, "On alarms."},
      {"BEEP_BY_MOTORS", 128, "The motors make the sound instead of the buzzer."},
  };
  static constexpr EnumInfo info{"BeeperModes", values, true};
};

template <>
struct EnumMeta<msg::AdaptivePidAxis> {
  static constexpr ValueInfo values[] = {
      {"EN_ROLL", 1, "Roll."},
      {"EN_PITCH", 2, "Pitch."},
      {"EN_YAW", 4, "Yaw."},
  };
  static constexpr EnumInfo info{"AdaptivePidAxes", values, true};
};

template <>
struct EnumMeta<msg::GeneralFlag> {
  static constexpr ValueInfo values[] = {
      {"REMEMBER_LAST_USED_PROFILE", 1, "Start with the last used profile."},
      {"UPSIDE_DOWN_AUTO", 2, "Detect an upside-down frame."},
      {"SWAP_FRAME_MAIN_IMU", 4, "Swap frame IMU and main IMU."},
      {"BLINK_PROFILE", 8, "Blink the profile number."},
      {"EMERGENCY_STOP", 16, "Stop in an emergency."},
      {"MAGNETOMETER_POS_FRAME", 32, "The magnetometer is on the frame."},
      {"FRAME_IMU_FF", 64, "Feed forward from the frame IMU."},
      {"OVERHEAT_STOP_MOTORS", 128, "Stop the motors when they overheat."},
      {"CENTER_YAW_AT_STARTUP", 256, "Center yaw at start-up."},
      {"SWAP_RC_SERIAL_UART_B", 512, "Swap the serial RC input and UART B."},
      {"UART_B_SERIAL_API", 1024, "UART B speaks this protocol."},
      {"BLINK_BAT_LEVEL", 2048, "Blink the battery level."},
      {"ADAPTIVE_GYRO_TRUST", 4096, "Adapt the trust in the gyroscope."},
      {"IS_UPSIDE_DOWN", 8192, "The frame is upside down.", {.firmware = 2660}},
      {"UART_3_SERIAL_API", 16384, "UART 3 speaks this protocol.", {.firmware = 2660}},
      {"FRAME_INV_RC_INV", 32768, "Invert the RC signals while the frame is upside down.", {.firmware = 2660}},
  };
  static constexpr EnumInfo info{"GeneralFlags", values, true};
};

template <>
struct EnumMeta<msg::GeneralFlags2Bit> {
  static constexpr ValueInfo values[] = {
      {"SEARCH_LIMIT_ROLL", 1, "Search the mechanical limits of roll at start-up.", {.firmware = 2610}},
      {"SEARCH_LIMIT_PITCH", 2, "Search the mechanical limits of pitch at start-up.", {.firmware = 2610}},
      {"SEARCH_LIMIT_YAW", 4, "Search the mechanical limits of yaw at start-up.", {.firmware = 2610}},
      {"AUTO_CALIBRATE_MOMENTUM", 8, "Calibrate the momentum automatically.", {.firmware = 2627}},
      {"USE_MOMENTUM_FEED_FORWARD", 16, "Feed forward from the momentum.", {.firmware = 2627}},
      {"MOTORS_OFF_AT_STARTUP", 32, "Leave the motors off at start-up.", {.firmware = 2627}},
      {"FC_BELOW_OUTER", 64, "The flight controller is below the outer motor.", {.firmware = 2627}},
      {"DO_NOT_CHECK_ENCODER_LIMITS", 128, "Do not check the limits of the encoders.", {.firmware = 2660}},
      {"AUTO_SAVE_BACKUP_SLOT", 256, "Save the profiles to the backup slot automatically.", {.firmware = 2660}},
      {"FC_BELOW_MIDDLE", 512, "The flight controller is below the middle motor.", {.firmware = 2660}},
      {"ENVIRONMENT_TEMP_UNKNOWN", 1024, "The temperature of the environment is unknown.", {.firmware = 2672}},
      {"LPF_EXTENDED_RANGE", 2048, "The low-pass filters of RC signals range to 255, not 15.", {.firmware = 2672}},
      {"SAVE_SYSTEM_STAT", 4096, "Save statistics of the system.", {.firmware = 2672}},
      {"DISABLE_ACC", 8192, "Do not use the accelerometer.", {.firmware = 2672}},
      {"DISABLE_POWER_MANAGER", 16384, "Do not use the power manager.", {.firmware = 2672}},
      {"ALLOW_ONBOARD_IMU_AS_MAIN", 32768, "The IMU on the board may be the main IMU.", {.firmware = 2672}},
  };
  static constexpr EnumInfo info{"GeneralFlags2", values, true};
};

template <>
struct EnumMeta<msg::ProfileFlag> {
  static constexpr ValueInfo values[] = {
      {"ADC1_AUTO_DETECTION", 1, "Detect whether analog input 1 is connected."},
      {"ADC2_AUTO_DETECTION", 2, "Detect whether analog input 2 is connected."},
      {"ADC3_AUTO_DETECTION", 4, "Detect whether analog input 3 is connected."},
      {"FOLLOW_USE_FRAME_IMU", 16, "Follow mode uses the frame IMU."},
      {"BRIEFCASE_AUTO_DETECTION", 32, "Detect when the gimbal is carried like a briefcase."},
      {"UPSIDE_DOWN_AUTO_ROTATE", 64, "Turn the camera when the frame is upside down."},
      {"FOLLOW_LOCK_OFFSET_CORRECTION", 128, "Do not correct the offset in follow mode."},
      {"START_NEUTRAL_POSITION", 256, "Start in the neutral position."},
      {"MENU_BUTTON_DISABLE_FOLLOW", 512, "The menu button suspends the follow mode."},
      {"TIMELAPSE_FRAME_FIXED", 1024, "The frame does not move during a time lapse."},
      {"RC_KEEP_MIX_RATE", 2048, "Keep the mix rate of the RC channels."},
      {"RC_KEEP_CUR_POS_ON_INIT", 4096, "Keep the current position when RC control starts."},
      {"OUTER_MOTOR_LIMIT_FREE_ROTATION", 8192, "Limit the free rotation of the outer motor.", {.firmware = 2660}},
      {"EULER_ORDER_AUTO", 16384, "Select the order of the Euler angles automatically.", {.firmware = 2671}, true},
      {"CAM_UPSIDE_DOWN_WORKING", 32768, "The camera may work upside down.", {}, true},
  };
  static constexpr EnumInfo info{"ProfileFlags", values, true};
};

template <>
struct EnumMeta<msg::ParkingBorder> {
  static constexpr ValueInfo values[] = {
      {"ROLL_NEG", 1, "The lower limit of roll."},
      {"ROLL_POS", 2, "The upper limit of roll."},
      {"PITCH_NEG", 4, "The lower limit of pitch."},
      {"PITCH_POS", 8, "The upper limit of pitch."},
      {"YAW_NEG", 16, "The lower limit of yaw."},
      {"YAW_POS", 32, "The upper limit of yaw."},
  };
  static constexpr EnumInfo info{"ParkingBorders", values, true};
};

template <>
struct EnumMeta<msg::EulerOrderFlag> {
  static constexpr ValueInfo values[] = {
      {"CONTROL_LOCAL_XYZ", 16, "Control commands turn the camera about its own axes; not for LOCAL_ROLL and ROLL_LOCAL."},
      {"STAB_CONTROL_LOCAL_XYZ", 32, "Stabilization and control use the camera's own axes; not for LOCAL_ROLL and ROLL_LOCAL.", {.firmware = 2740}},
  };
  static constexpr EnumInfo info{"EulerOrderFlags", values, true};
};

template <>
struct EnumMeta<msg::ExtImuFlag> {
  static constexpr ValueInfo values[] = {
      {"ACC_COMP_ONLY", 2, "Only compensate linear accelerations."},
      {"REPLACE", 4, "Replace the attitude of the internal IMU."},
      {"Z", 8, "Correct the vertical."},
      {"H", 16, "Correct the heading."},
      {"FRAME_UPSIDE_DOWN_UPDATE", 32, "Take into account that the frame is upside down."},
      {"AS_FRAME_IMU", 64, "Use it as the frame IMU."},
      {"GYRO_CORR", 128, "Correct the gyroscope.", {.firmware = 2687}},
  };
  static constexpr EnumInfo info{"ExtImuFlags", values, true};
};

template <>
struct EnumMeta<msg::GeneralFlags3Bit> {
  static constexpr ValueInfo values[] = {
      {"ENC_LUT_EN_ROLL", 1, "Use the look-up table of the roll encoder."},
      {"ENC_LUT_EN_PITCH", 2, "Use the look-up table of the pitch encoder."},
      {"ENC_LUT_EN_YAW", 4, "Use the look-up table of the yaw encoder."},
      {"MAVLINK_YAW_ABSOLUTE", 8, "The yaw of MAVLink commands is absolute."},
      {"EXT_SENS_AS_REFERENCE", 16, "Use the external sensor as a reference."},
      {"DISABLE_BT", 32, "Turn Bluetooth off."},
      {"ALLOW_SENSOR_RECOVERY", 64, "Try to recover a sensor that fails."},
      {"UART2_ALT", 128, "Use the alternative pins of UART 2."},
      {"PASS_LIMIT_ROLL", 256, "Roll may pass its limits."},
      {"PASS_LIMIT_PITCH", 512, "Pitch may pass its limits."},
      {"PASS_LIMIT_YAW", 1024, "Yaw may pass its limits."},
      {"DONT_PUSH_SOFT_LIMITS_ROLL", 2048, "Do not push roll away from its software limits."},
      {"DONT_PUSH_SOFT_LIMITS_PITCH", 4096, "Do not push pitch away from its software limits."},
      {"DONT_PUSH_SOFT_LIMITS_YAW", 8192, "Do not push yaw away from its software limits."},
      {"TRIPOD_MODE_AUTO", 16384, "Start the tripod mode automatically."},
      {"TRIPOD_MODE_GYRO_ONLINE_CALIB", 32768, "Calibrate the gyroscope in tripod mode."},
      {"RETRACTED_POSITION_MOTORS_OFF", 65536, "Turn the motors off in the retracted position."},
      {"CAN_IMU_THERMOSTAT_ENABLE", 131072, "The CAN IMU keeps its temperature constant."},
      {"RETRACTED_POSITION_SHORTEST", 262144, "Take the shortest path to the retracted position."},
      {"RETRACTED_POSITION_RC_CONTROL", 524288, "RC controls the retracted position."},
      {"ACC_LIMIT_EXT_RANGE", 1048576, "The acceleration limits have a wider range."},
      {"MOVE_SHORT_PATH_ROLL", 2097152, "Roll moves on the shortest path."},
      {"MOVE_SHORT_PATH_PITCH", 4194304, "Pitch moves on the shortest path."},
      {"MOVE_SHORT_PATH_YAW", 8388608, "Yaw moves on the shortest path."},
      {"FRAME_INV_SOFT_LIMIT_MIDDLE", 16777216, "An upside-down frame changes the software limits of the middle motor."},
      {"FRAME_INV_SOFT_LIMIT_OUTER", 33554432, "An upside-down frame changes the software limits of the outer motor."},
      {"CAN_IMU_SERVO1_DUTY_MODE", 67108864, "Servo output 1 of the CAN IMU sets the duty cycle."},
      {"CAN_IMU_SERVO2_DUTY_MODE", 134217728, "Servo output 2 of the CAN IMU sets the duty cycle."},
  };
  static constexpr EnumInfo info{"GeneralFlags3", values, true};
};

template <>
struct EnumMeta<msg::GeneralFlags4Bit> {
  static constexpr ValueInfo values[] = {
      {"ACC_LIMIT_BY_MOMENTUM", 1, "The momentum determines the acceleration limits."},
      {"CALIB_MOMENTUM_IN_NORMAL_POS", 2, "Calibrate the momentum in the normal position."},
      {"EULER_MIDDLE_AXIS", 4, "The middle axis determines the initial Euler angles.", {}, true},
      {"EULER_MATCH_MOTOR_ROTATION", 8, "The rotation of the motors determines the initial Euler angles.", {}, true},
  };
  static constexpr EnumInfo info{"GeneralFlags4", values, true};
};

template <>
struct EnumMeta<msg::ProfileFlags2Bit> {
  static constexpr ValueInfo values[] = {
      {"FOLLOW_PITCH_DISABLED", 1, "Pitch does not follow the frame."},
      {"LOW_ANGLE_PRIOR_ROLL", 2, "Roll prefers small angles."},
      {"LOW_ANGLE_PRIOR_PITCH", 4, "Pitch prefers small angles."},
      {"LOW_ANGLE_PRIOR_YAW", 8, "Yaw prefers small angles."},
      {"HEADING_TRIPOD_MODE", 16, "The tripod mode applies to the heading."},
      {"MOT_ROLL_DISABLED", 32, "The roll motor is off."},
      {"MOT_PITCH_DISABLED", 64, "The pitch motor is off."},
      {"MOT_YAW_DISABLED", 128, "The yaw motor is off."},
      {"RC_OUT_DUTY1", 256, "Servo output 1 sets the duty cycle."},
      {"RC_OUT_DUTY2", 512, "Servo output 2 sets the duty cycle."},
      {"RC_OUT_DUTY3", 1024, "Servo output 3 sets the duty cycle."},
      {"RC_OUT_DUTY4", 2048, "Servo output 4 sets the duty cycle."},
      {"DISABLE_FOLLOW_STARTUP", 4096, "Do not follow at start-up."},
      {"SERVO_MODE", 8192, "Servo mode."},
      {"RC_EXPO_DEADBAND_SPLIT", 16384, "Pitch and yaw have their own RC dead band and expo rate."},
  };
  static constexpr EnumInfo info{"ProfileFlags2", values, true};
};

template <>
struct EnumMeta<msg::ProfileFlags3Bit> {
  static constexpr ValueInfo values[] = {
      {"ACC_LIMIT_AUTO_R", 1, "The board determines the acceleration limit of roll."},
      {"ACC_LIMIT_AUTO_P", 2, "The board determines the acceleration limit of pitch."},
      {"ACC_LIMIT_AUTO_Y", 4, "The board determines the acceleration limit of yaw."},
      {"SHAKE_GENERATOR_ENABLED", 8, "The shake generator runs."},
      {"ERR_CORR_LONG_R", 16, "Correct long errors of roll."},
      {"ERR_CORR_LONG_P", 32, "Correct long errors of pitch."},
      {"ERR_CORR_LONG_Y", 64, "Correct long errors of yaw."},
  };
  static constexpr EnumInfo info{"ProfileFlags3", values, true};
};

template <>
struct EnumMeta<msg::SystemError> {
  static constexpr ValueInfo values[] = {
      {"ERR_NO_SENSOR", 1, Explanation{"The IMU sensor does not respond."}},
      {"ERR_CALIB_ACC", 2, Explanation{"The accelerometer is not calibrated."}},
      {"ERR_SET_POWER", 4, Explanation{"The motor power is not set."}},
      {"ERR_CALIB_POLES", 8, Explanation{"The motor poles are not calibrated."}},
      {"ERR_PROTECTION", 16, Explanation{"The driver protection tripped."}},
      {"ERR_SERIAL", 32, Explanation{"Errors on the serial line."}},
      {"ERR_LOW_BAT1", 64, Explanation{"The battery is below the alarm threshold."}},
      {"ERR_LOW_BAT2", 128, Explanation{"The battery is below the motor stop threshold."}},
      {"ERR_GUI_VERSION", 256, Explanation{"The host software does not match the firmware."}},
      {"ERR_MISS_STEPS", 512, Explanation{"A motor lost steps."}},
      {"ERR_SYSTEM", 1024, Explanation{"System error."}},
      {"ERR_EMERGENCY_STOP", 2048, Explanation{"Emergency stop; SYSTEM_SUB_ERROR gives the reason."}},
  };
  static constexpr EnumInfo info{"SystemErrors", values, true};
};

template <>
struct EnumMeta<msg::OtherFlag> {
  static constexpr ValueInfo values[] = {
      {"MOTORS_ON", 1, "The motors are on."},
  };
  static constexpr EnumInfo info{"OtherFlags", values, true};
};

template <>
struct EnumMeta<msg::RealtimeDataCustomFlag> {
  static constexpr ValueInfo values[] = {
      {"IMU_ANGLES", 1, "Angles of the main IMU."},
      {"TARGET_ANGLES", 2, "RC target angles."},
      {"TARGET_SPEED", 4, "RC target speed."},
      {"STATOR_ROTOR_ANGLE", 8, "Joint angles."},
      {"GYRO_DATA", 16, "Gyroscope of the IMU."},
      {"RC_DATA", 32, "RC signals of the standard inputs."},
      {"Z1_H1_VECTORS", 64, "Attitude of the IMU as a rotation matrix."},
      {"RC_CHANNELS", 128, "All RC channels of S.BUS, Sum-PPM or Spektrum."},
      {"ACC_DATA", 256, "Accelerometer of the IMU."},
      {"MOTOR4_CONTROL", 512, "Control of a fourth motor."},
      {"AHRS_DEBUG_INFO", 1024, "State of the attitude estimation."},
      {"ENCODER_RAW24", 2048, "Raw values of the encoders.", {.firmware = 2680}},
      {"IMU_ANGLES_RAD", 4096, "Angles of the main IMU in radians.", {.firmware = 2687}},
      {"SCRIPT_VARS_FLOAT", 8192, "Floating-point variables of the script."},
      {"SCRIPT_VARS_INT16", 16384, "Integer variables of the script."},
      {"SYSTEM_POWER_STATE", 32768, "State of the motors and of the supply.", {.firmware = 2706}},
      {"FRAME_CAM_RATE", 65536, "Speed of the camera relative to the frame.", {.firmware = 2706}},
      {"IMU_ANGLES_20", 131072, "Angles of the main IMU in high resolution.", {.firmware = 2708}},
      {"TARGET_ANGLES_20", 262144, "Target angles in high resolution.", {.firmware = 2708}},
      {"COMM_ERRORS", 524288, "Counters of communication errors.", {.firmware = 2720}},
      {"SYSTEM_STATE", 1048576, "State of the system.", {.firmware = 2730}},
      {"IMU_QUAT", 2097152, "Attitude of the main IMU as a quaternion.", {.firmware = 2730}},
      {"TARGET_QUAT", 4194304, "Target attitude as a quaternion.", {.firmware = 2730}},
      {"IMU_TO_FRAME_QUAT", 8388608, "Rotation from the main IMU to the frame as a quaternion.", {.firmware = 2730}},
      {"ADC_CH_RAW", 16777216, "Raw values of the analog inputs.", {.firmware = 2730}},
      {"SW_LIMITS_DIST", 33554432, "Distances to the software limits.", {.firmware = 2738}},
      {"FOLLOW_DIST", 67108864, "Distance in follow mode.", {.firmware = 2738}},
      {"EXT_TARGET_LIMIT", 134217728, "Limits of an external target.", {.firmware = 2738}},
      {"FRAME_CAM_ANGLE_20", 268435456, "Joint angles in high resolution."},
      {"MAIN_IMU_STATE", 536870912, "State of the main IMU."},
      {"INCLUDE_FLAGS", 2147483648, "FLAGS in each sample."},
  };
  static constexpr EnumInfo info{"RealtimeDataCustomFlags", values, true};
};

template <>
struct EnumMeta<msg::RealtimeDataCustom2Flag> {
  static constexpr ValueInfo values[] = {
      {"FRAME_IMU_ANGLES", 1, "Angles of the frame IMU."},
      {"FRAME_GYRO", 2, "Gyroscope of the frame IMU."},
      {"FRAME_ACC", 4, "Accelerometer of the frame IMU."},
      {"DEBUG", 8, "Values for debugging."},
      {"MAG_SENS_DATA", 16, "Magnetometer."},
      {"PIN_STATE", 32, "State of the inputs."},
      {"STAB_ERR_AMPL", 64, "Amplitude of the stabilization error.", {.firmware = 2744}},
      {"INCLUDE_FLAGS", 2147483648, "FLAGS in each sample."},
  };
  static constexpr EnumInfo info{"RealtimeDataCustom2Flags", values, true};
};

template <>
struct EnumMeta<msg::StateFlag> {
  static constexpr ValueInfo values[] = {
      {"DEBUG_MODE", 1, "A host should show its debug output."},
      {"IS_FRAME_INVERTED", 2, "The frame is upside down."},
      {"INIT_STEP1_DONE", 4, "The first step of the start-up is done."},
      {"INIT_STEP2_DONE", 8, "The second step of the start-up is done."},
      {"STARTUP_AUTO_ROUTINE_DONE", 16, "The automatic actions at start-up are done."},
      {"POWER_MANAGER_ENABLED", 32, "Power management is on."},
      {"SHAKE_GEN_ENABLED", 256, "The shake generator is enabled."},
      {"SERVO_MODE_ENABLED", 512, "The servo mode is enabled."},
      {"FOLLOW_MODE_ROLL", 1024, "Roll is in follow mode."},
      {"FOLLOW_MODE_PITCH", 2048, "Pitch is in follow mode."},
      {"FOLLOW_MODE_YAW", 4096, "Yaw is in follow mode."},
      {"TRIPOD_MODE_ENABLED", 8192, "The tripod mode is enabled.", {.firmware = 2739}},
      {"RETRACTED_POSITION", 16384, "The camera is in its retracted position.", {.firmware = 2740}},
  };
  static constexpr EnumInfo info{"StateFlags", values, true};
};

template <>
struct EnumMeta<msg::MotorPowerFlag> {
  static constexpr ValueInfo values[] = {
      {"SW_LIMIT_VIOLATED", 1, "The motor is beyond a software limit."},
      {"CURRENT_EXCEEDS_LIMIT", 2, "The current exceeds its limit."},
      {"DRIVER_ENABLED", 4, "The driver is enabled."},
  };
  static constexpr EnumInfo info{"MotorPowerFlags", values, true};
};

template <>
struct EnumMeta<msg::SystemPowerFlag> {
  static constexpr ValueInfo values[] = {
      {"SW_LIMIT_VIOLATED", 1, "A motor is beyond a software limit."},
      {"OVERHEAT_WARNING", 2, "A motor or a driver is too warm."},
      {"DRIVER_OTW", 4, "A motor driver reports an overtemperature warning.", {}, true},
      {"DRIVER_FAULT", 8, "A motor driver failed.", {}, true},
  };
  static constexpr EnumInfo info{"SystemPowerFlags", values, true};
};

template <>
struct EnumMeta<msg::CanErrorFlag> {
  static constexpr ValueInfo values[] = {
      {"WARN", 1, "The number of errors exceeds the warning level."},
      {"PASSIVE", 2, "The controller is error-passive."},
      {"BUS_OFF", 4, "The controller has left the bus."},
  };
  static constexpr EnumInfo info{"CanErrorFlags", values, true};
};

template <>
struct EnumMeta<msg::CanDrvTelemetryFlag> {
  static constexpr ValueInfo values[] = {
      {"CAN_BUS_FLAGS", 1, "State of the CAN bus."},
      {"CAN_BUS_ERR_CNT", 2, "Errors of the CAN bus."},
      {"TEMP_BOARD", 4, "Temperature of the driver."},
      {"TEMP_MOTOR", 8, "Temperature of the motor."},
      {"AVG_CURRENT", 16, "Average current."},
      {"BUS_VOLTAGE", 32, "Supply voltage."},
      {"PIN_STATE", 64, "State of the pins."},
      {"PHASE_CURRENT", 128, "Current of each phase."},
      {"ENCODER_ERROR_CNT", 256, "Errors of the encoder."},
      {"IQ_ID_CURRENT", 512, "Currents that make torque and field."},
      {"MOTOR_SPEED", 1024, "Speed of the motor."},
      {"PID_POS_ERR", 2048, "Error of the position controller."},
      {"PID_SPEED_ERR", 4096, "Error of the speed controller."},
      {"IQ_REF", 8192, "Target of the torque current."},
      {"PID_CURRENT_ERR", 16384, "Error of the current controller."},
  };
  static constexpr EnumInfo info{"CanDrvTelemetryFlags", values, true};
};

template <>
struct EnumMeta<msg::CanDrvPin> {
  static constexpr ValueInfo values[] = {
      {"LIMIT", 1, "Limit switch."},
      {"INDEX", 2, "Index of the encoder."},
      {"EMERGENCY", 4, "Emergency stop."},
      {"AUX1", 8, "The AUX1 pin."},
      {"AUX2", 16, "The AUX2 pin."},
      {"AUX3", 32, "The AUX3 pin."},
      {"HALF_BRIDGE_ENABLE", 64, "Enables the half bridges."},
      {"ENCODER_SPI_CS", 128, "Selects the encoder on the SPI bus."},
  };
  static constexpr EnumInfo info{"CanDrvPins", values, true};
};

template <>
struct EnumMeta<msg::ControlFlag> {
  static constexpr ValueInfo values[] = {
      {"CONTROL_FLAG_MIX_FOLLOW", 16, "The motion is added to that of the follow mode instead of replacing it; for MODE_SPEED, MODE_ANGLE, MODE_ANGLE_SHORTEST and MODE_RC.", {.firmware = 2705}},
      {"CONTROL_FLAG_TARGET_PRECISE", 32, "The motion does not slow down near its target; for MODE_ANGLE, MODE_ANGLE_SHORTEST and MODE_ANGLE_REL_FRAME.", {.firmware = 2701}},
      {"CONTROL_FLAG_AUTO_TASK", 64, "In MODE_ANGLE and MODE_ANGLE_REL_FRAME, move as fast as automatic tasks do, and confirm when the target is reached. In MODE_RC the bit is CONTROL_FLAG_FORCE_RC_SPEED: the signal controls the speed, whatever the parameters say.", {.firmware = 2627}},
      {"CONTROL_FLAG_HIGH_RES_SPEED", 128, "Speeds are in 0.001 deg/s.", {.firmware = 2590}},
  };
  static constexpr EnumInfo info{"ControlFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlExtField> {
  static constexpr ValueInfo values[] = {
      {"ROLL_SPEED", 1, "The speed of roll is given."},
      {"ROLL_ANGLE", 2, "The angle of roll is given."},
      {"ROLL_ANGLE_32BIT", 4, "The angle of roll has 32 bits."},
      {"ROLL_SPEED_32BIT", 8, "The speed of roll has 32 bits.", {.firmware = 2720}},
      {"PITCH_SPEED", 32, "The speed of pitch is given."},
      {"PITCH_ANGLE", 64, "The angle of pitch is given."},
      {"PITCH_ANGLE_32BIT", 128, "The angle of pitch has 32 bits."},
      {"PITCH_SPEED_32BIT", 256, "The speed of pitch has 32 bits.", {.firmware = 2720}},
      {"YAW_SPEED", 1024, "The speed of yaw is given."},
      {"YAW_ANGLE", 2048, "The angle of yaw is given."},
      {"YAW_ANGLE_32BIT", 4096, "The angle of yaw has 32 bits."},
      {"YAW_SPEED_32BIT", 8192, "The speed of yaw has 32 bits.", {.firmware = 2720}},
  };
  static constexpr EnumInfo info{"ControlExtFields", values, true};
};

template <>
struct EnumMeta<msg::ControlExtFlag> {
  static constexpr ValueInfo values[] = {
      {"DISABLE_ANGLE_ERR_CORR", 1, "Do not correct deviations from the target angle, as with an OUTER_P of 0."},
  };
  static constexpr EnumInfo info{"ControlExtFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlConfigFlag> {
  static constexpr ValueInfo values[] = {
      {"CONTROL_CONFIG_FLAG_NO_CONFIRM", 1, "Do not confirm control commands."},
      {"CONTROL_CONFIG_FLAG_SERVO_MODE_ENABLE", 2, "Turn the servo mode on, in which angles are those of the motors.", {.firmware = 2720}},
      {"CONTROL_CONFIG_FLAG_SERVO_MODE_DISABLE", 4, "Turn the servo mode off.", {.firmware = 2720}},
      {"CONTROL_CONFIG_FLAG_LPF_EXT_RANGE", 8, "The filters have an extended range.", {.firmware = 2723}},
      {"CONTROL_CONFIG_FLAG_LPF_FREQUENCY_HZ", 16, "The filters are frequencies in Hz, by the name.", {.firmware = 2741}},
  };
  static constexpr EnumInfo info{"ControlConfigFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlQuatFlag> {
  static constexpr ValueInfo values[] = {
      {"CONFIRM", 1, "Confirm the command."},
      {"ATTITUDE_PACKED", 2, "The attitude is packed into 8 bytes."},
      {"ATTITUDE_LIMITED_180", 4, "Attitudes are within half a turn, and each is reached from the last one by the shortest way."},
      {"ATTITUDE_REMOVE_ABSENT_AXES", 8, "By its name, axes without a motor are taken out of the attitude.", {.firmware = 2741}},
      {"AUTO_TASK", 64, "For ATTITUDE: move as fast as automatic tasks do, and confirm when the attitude is reached within 1 degree. The motion ends after 10 s in any case."},
  };
  static constexpr EnumInfo info{"ControlQuatFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlQuatStatusFlag> {
  static constexpr ValueInfo values[] = {
      {"CONFIRM", 1, "Commands are confirmed."},
      {"ATTITUDE_PACKED", 2, "Attitudes are packed into 8 bytes."},
      {"ATTITUDE_LIMITED_180", 4, "Attitudes are within half a turn."},
      {"ATTITUDE_REMOVE_ABSENT_AXES", 8, "Axes without a motor are taken out of the attitude."},
      {"AUTO_TASK", 64, "The motion is an automatic task."},
  };
  static constexpr EnumInfo info{"ControlQuatStatusFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlQuatStatusField> {
  static constexpr ValueInfo values[] = {
      {"MODE", 1, "Mode and flags."},
      {"TARGET_ATTITUDE", 2, "Attitude of the last command."},
      {"SETPOINT_ATTITUDE", 4, "Attitude that the board stabilizes."},
      {"ACTUAL_ATTITUDE", 8, "Measured attitude."},
      {"TARGET_SPEED", 16, "Speed of the last command."},
      {"SETPOINT_SPEED", 32, "Speed that the board stabilizes."},
      {"ACTUAL_SPEED", 64, "Measured speed."},
      {"TARGET_ATTITUDE_PACKED", 128, "Attitude of the last command, packed."},
      {"SETPOINT_ATTITUDE_PACKED", 256, "Attitude that the board stabilizes, packed."},
      {"ACTUAL_ATTITUDE_PACKED", 512, "Measured attitude, packed."},
  };
  static constexpr EnumInfo info{"ControlQuatStatusFields", values, true};
};

template <>
struct EnumMeta<msg::ControlQuatConfigField> {
  static constexpr ValueInfo values[] = {
      {"MAX_SPEED", 1, "Speed limits."},
      {"ACC_LIMIT", 2, "Acceleration limits."},
      {"JERK_SLOPE", 4, "Times in which the acceleration rises."},
      {"FLAGS", 8, "Options."},
      {"ATTITUDE_LPF_FREQ", 16, "Low-pass filter of the attitude."},
      {"SPEED_LPF_FREQ", 32, "Low-pass filter of the speed."},
  };
  static constexpr EnumInfo info{"ControlQuatConfigFields", values, true};
};

template <>
struct EnumMeta<msg::ControlQuatConfigFlag> {
  static constexpr ValueInfo values[] = {
      {"MOTION_PROFILE_SPLIT_XYZ", 1, "Each axis has its own profile. Otherwise the profile of X applies along the shortest way."},
  };
  static constexpr EnumInfo info{"ControlQuatConfigFlags", values, true};
};

template <>
struct EnumMeta<msg::HelperDataFlag> {
  static constexpr ValueInfo values[] = {
      {"EULER_ORDER_ROLL_PITCH_YAW", 64, "The tilt is given in the Euler order roll, pitch, yaw.", {.firmware = 2707}},
      {"USE_FRAME_HEADING", 128, "The heading of the frame is given.", {.firmware = 2627}},
  };
  static constexpr EnumInfo info{"HelperDataFlags", values, true};
};

template <>
struct EnumMeta<msg::ExecuteMenuFlag> {
  static constexpr ValueInfo values[] = {
      {"CONFIRM", 1, "Confirm the start of the action."},
      {"CONFIRM_ON_FINISH", 2, "Confirm the end of the action."},
  };
  static constexpr EnumInfo info{"ExecuteMenuFlags", values, true};
};

template <>
struct EnumMeta<msg::EventType> {
  static constexpr ValueInfo values[] = {
      {"OFF", 1, "It ended; for CAMERA, REC_PHOTO: record a video or take a photo."},
      {"ON", 2, "It began; for CAMERA, PHOTO: take a photo."},
      {"HOLD", 4, "It continues."},
  };
  static constexpr EnumInfo info{"EventTypes", values, true};
};

template <>
struct EnumMeta<msg::ExtMotor> {
  static constexpr ValueInfo values[] = {
      {"MOTOR1", 1, "Motor 1."},
      {"MOTOR2", 2, "Motor 2."},
      {"MOTOR3", 4, "Motor 3."},
      {"MOTOR4", 8, "Motor 4."},
      {"MOTOR5", 16, "Motor 5."},
      {"MOTOR6", 32, "Motor 6."},
      {"MOTOR7", 64, "Motor 7."},
  };
  static constexpr EnumInfo info{"ExtMotors", values, true};
};

template <>
struct EnumMeta<msg::ExtMotorTarget> {
  static constexpr ValueInfo values[] = {
      {"MOTOR1", 1, "Motor 1."},
      {"MOTOR2", 2, "Motor 2."},
      {"MOTOR3", 4, "Motor 3."},
      {"MOTOR4", 8, "Motor 4."},
      {"MOTOR5", 16, "Motor 5."},
      {"MOTOR6", 32, "Motor 6."},
      {"MOTOR7", 64, "Motor 7."},
      {"CONFIRM", 128, "Confirm the command."},
  };
  static constexpr EnumInfo info{"ExtMotorTargets", values, true};
};

template <>
struct EnumMeta<msg::ExtMotorsControlField> {
  static constexpr ValueInfo values[] = {
      {"SETPOINT_32BIT", 1, "Setpoints have 32 bits, otherwise 16."},
      {"PARAM1_16BIT", 2, "A parameter follows each setpoint, with 16 bits."},
      {"PARAM1_32BIT", 4, "A parameter follows each setpoint, with 32 bits."},
  };
  static constexpr EnumInfo info{"ExtMotorsControlFields", values, true};
};

template <>
struct EnumMeta<msg::ExtMotorsControlConfigField> {
  static constexpr ValueInfo values[] = {
      {"MODE", 1, "Mode."},
      {"MAX_SPEED", 2, "Speed limit."},
      {"MAX_ACCELERATION", 4, "Acceleration limit."},
      {"JERK_SLOPE", 8, "Time in which the acceleration rises."},
      {"MAX_TORQUE", 16, "Torque limit."},
  };
  static constexpr EnumInfo info{"ExtMotorsControlConfigFields", values, true};
};

template <>
struct EnumMeta<msg::ExtMotorsStateField> {
  static constexpr ValueInfo values[] = {
      {"CONTROL_MODE", 1, "Mode."},
      {"TORQUE", 2, "Torque."},
      {"TORQUE_SETPOINT", 4, "Target torque."},
      {"SPEED16", 8, "Speed, 16 bits."},
      {"SPEED16_SETPOINT", 16, "Target speed, 16 bits."},
      {"SPEED32", 32, "Speed, 32 bits."},
      {"SPEED32_SETPOINT", 64, "Target speed, 32 bits."},
      {"ANGLE16", 128, "Angle, 16 bits."},
      {"ANGLE16_SETPOINT", 256, "Target angle, 16 bits."},
      {"ANGLE32", 512, "Angle, 32 bits."},
      {"ANGLE32_SETPOINT", 1024, "Target angle, 32 bits."},
      {"STATE_FLAGS", 2048, "State."},
      {"MAX_SPEED", 4096, "Speed limit."},
      {"MAX_ACCELERATION", 8192, "Acceleration limit."},
      {"JERK_SLOPE", 16384, "Time in which the acceleration rises."},
      {"MAX_TORQUE", 32768, "Torque limit."},
      {"CURRENT", 65536, "Current."},
      {"BATTERY_VOLTAGE", 131072, "Supply voltage."},
      {"MOTOR_TEMPERATURE", 262144, "Temperature of the motor."},
      {"DRIVER_TEMPERATURE", 524288, "Temperature of the driver."},
  };
  static constexpr EnumInfo info{"ExtMotorsStateFields", values, true};
};

template <>
struct EnumMeta<msg::ExtMotorPin> {
  static constexpr ValueInfo values[] = {
      {"INDEX_PIN_STATE", 4, "The index pin is active.", {}, true},
  };
  static constexpr EnumInfo info{"ExtMotorPins", values, true};
};

template <>
struct EnumMeta<msg::AutoPidFlag> {
  static constexpr ValueInfo values[] = {
      {"AUTO_PID_STOP", 0, "Not a bit: the whole value 0 stops the tuning."},
      {"AUTO_PID_CFG_ROLL", 1, "Tune roll."},
      {"AUTO_PID_CFG_PITCH", 2, "Tune pitch."},
      {"AUTO_PID_CFG_YAW", 4, "Tune yaw."},
      {"AUTO_PID_CFG_SEND_GUI", 8, "Report progress with CMD_AUTO_PID."},
      {"AUTO_PID_CFG_KEEP_CURRENT", 16, "Start from the current gains."},
      {"AUTO_PID_CFG_TUNE_LPF_FREQ", 32, "Tune the low-pass filter as well."},
      {"AUTO_PID_CFG_ALL_PROFILES", 64, "Store the result in all profiles."},
  };
  static constexpr EnumInfo info{"AutoPidFlags", values, true};
};

template <>
struct EnumMeta<msg::CalibratedLimit> {
  static constexpr ValueInfo values[] = {
      {"PLUS_X", 1, "Limit +X."},
      {"MINUS_X", 2, "Limit -X."},
      {"PLUS_Y", 4, "Limit +Y."},
      {"MINUS_Y", 8, "Limit -Y."},
      {"PLUS_Z", 16, "Limit +Z."},
      {"MINUS_Z", 32, "Limit -Z."},
  };
  static constexpr EnumInfo info{"CalibratedLimits", values, true};
};

template <>
struct EnumMeta<msg::FieldOffsetFlag> {
  static constexpr ValueInfo values[] = {
      {"IGNORE_IMU_CHECK", 1, "Do not compare with the IMU."},
      {"IGNORE_ENCODER_CHECK", 2, "Do not check the encoder."},
  };
  static constexpr EnumInfo info{"FieldOffsetFlags", values, true};
};

template <>
struct EnumMeta<msg::CoggingAxis> {
  static constexpr ValueInfo values[] = {
      {"ROLL", 1, "The roll motor."},
      {"PITCH", 2, "The pitch motor."},
      {"YAW", 4, "The yaw motor."},
  };
  static constexpr EnumInfo info{"CoggingAxes", values, true};
};

template <>
struct EnumMeta<msg::AutoPid2CommandFlag> {
  static constexpr ValueInfo values[] = {
      {"SEND_CONFIG", 1, "Send the configuration when the tuning ends."},
  };
  static constexpr EnumInfo info{"AutoPid2CommandFlags", values, true};
};

template <>
struct EnumMeta<msg::AutoPid2Flag> {
  static constexpr ValueInfo values[] = {
      {"START_FROM_CURRENT", 1, "Start from the current parameters."},
      {"ALL_PROFILES", 2, "Store the result in all profiles."},
      {"TUNE_GAIN_ONLY", 4, "Tune the gains only."},
      {"AUTOSAVE", 16, "Save the result."},
      {"RUN_AT_START_ALL", 16384, "Tune everything at each start-up."},
      {"RUN_AT_START_GAIN", 32768, "Tune the gains at each start-up."},
  };
  static constexpr EnumInfo info{"AutoPid2Flags", values, true};
};

template <>
struct EnumMeta<msg::TuningPosition> {
  static constexpr ValueInfo values[] = {
      {"POSITION1", 1, "Position 1."},
      {"POSITION2", 2, "Position 2."},
      {"POSITION3", 4, "Position 3."},
      {"POSITION4", 8, "Position 4."},
  };
  static constexpr EnumInfo info{"TuningPositions", values, true};
};

template <>
struct EnumMeta<msg::ExtSensOption> {
  static constexpr ValueInfo values[] = {
      {"HIGH_PRIORITY", 1, "Forward the command before others."},
  };
  static constexpr EnumInfo info{"ExtSensOptions", values, true};
};

template <>
struct EnumMeta<msg::AhrsHelperModeBit> {
  static constexpr ValueInfo values[] = {
      {"SET", 1, "Set the attitude instead of querying it."},
      {"FRAME_IMU", 2, "The frame IMU instead of the main one."},
      {"REFERENCE_ONLY", 4, "Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it."},
      {"TRANSLATE", 8, "Translate between camera and frame and use the result as a reference; requires known motor angles."},
      {"Z1_ONLY", 16, "Use Z1_VECTOR only."},
      {"H1_ONLY", 32, "Use H1_VECTOR only."},
  };
  static constexpr EnumInfo info{"AhrsHelperMode", values, true};
};

template <>
struct EnumMeta<msg::AhrsHelperWideModeBit> {
  static constexpr ValueInfo values[] = {
      {"SET", 1, "Set the attitude instead of querying it."},
      {"FRAME_IMU", 2, "The frame IMU instead of the main one."},
      {"REFERENCE_ONLY", 4, "Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it."},
      {"TRANSLATE", 8, "Translate between camera and frame and use the result as a reference; requires known motor angles."},
      {"Z1_ONLY", 16, "Use Z1_VECTOR only."},
      {"H1_ONLY", 32, "Use H1_VECTOR only."},
      {"TRANSLATE_Z1_ONLY", 64, "Translate Z1_VECTOR only."},
      {"TRANSLATE_H1_ONLY", 128, "Translate H1_VECTOR only."},
      {"ON_FRAME", 256, "The sensor is on the frame, whatever the place of the frame IMU."},
      {"BELOW_OUTER", 512, "The sensor is below the outer motor."},
      {"DISABLE_CORRECTION", 1024, "Turn the correction off.", {.firmware = 2701}},
  };
  static constexpr EnumInfo info{"AhrsHelperWideMode", values, true};
};

template <>
struct EnumMeta<msg::BeepMode> {
  static constexpr ValueInfo values[] = {
      {"BEEPER_MODE_CALIBRATE", 1, "The calibration sound."},
      {"BEEPER_MODE_CONFIRM", 2, "The confirmation sound."},
      {"BEEPER_MODE_ERROR", 4, "The error sound."},
      {"BEEPER_MODE_CLICK", 16, "A click."},
      {"BEEPER_MODE_COMPLETE", 32, "The completion sound."},
      {"BEEPER_MODE_INTRO", 64, "The start-up sound."},
      {"BEEPER_MODE_CUSTOM_MELODY", 32768, "The notes of this message."},
  };
  static constexpr EnumInfo info{"BeepModes", values, true};
};

template <>
struct EnumMeta<msg::ServoOutput> {
  static constexpr ValueInfo values[] = {
      {"SERVO1", 1, "The FC_ROLL pin."},
      {"SERVO2", 2, "The FC_PITCH pin."},
      {"SERVO3", 4, "The RC_PITCH pin."},
      {"SERVO4", 8, "The AUX1 pin."},
      {"CAN_DRV1_SERVO1", 16, "First pin of CAN motor driver 1."},
      {"CAN_DRV1_SERVO2", 32, "Second pin of CAN motor driver 1."},
      {"CAN_DRV2_SERVO1", 64, "First pin of CAN motor driver 2."},
      {"CAN_DRV2_SERVO2", 128, "Second pin of CAN motor driver 2."},
      {"CAN_DRV3_SERVO1", 256, "First pin of CAN motor driver 3."},
      {"CAN_DRV3_SERVO2", 512, "Second pin of CAN motor driver 3."},
      {"CAN_DRV4_SERVO1", 1024, "First pin of CAN motor driver 4."},
      {"CAN_DRV4_SERVO2", 2048, "Second pin of CAN motor driver 4."},
      {"CAN_DRV5_SERVO1", 4096, "First pin of CAN motor driver 5."},
      {"CAN_DRV5_SERVO2", 8192, "Second pin of CAN motor driver 5."},
      {"CAN_DRV6_SERVO1", 16384, "First pin of CAN motor driver 6."},
      {"CAN_DRV6_SERVO2", 32768, "Second pin of CAN motor driver 6."},
      {"CAN_DRV7_SERVO1", 65536, "First pin of CAN motor driver 7."},
      {"CAN_DRV7_SERVO2", 131072, "Second pin of CAN motor driver 7."},
  };
  static constexpr EnumInfo info{"ServoOutputs", values, true};
};

template <>
struct EnumMeta<msg::RcInputOption> {
  static constexpr ValueInfo values[] = {
      {"INIT_IF_NEEDED", 1, "Initialize each input that is not in use yet."},
  };
  static constexpr EnumInfo info{"RcInputOptions", values, true};
};

template <>
struct EnumMeta<msg::DebugVarFlag> {
  static constexpr ValueInfo values[] = {
      {"VAR_FLAG_ANGLE14", 64, "An angle, 16384 counts per turn."},
  };
  static constexpr EnumInfo info{"DebugVarFlags", values, true};
};

template <>
struct EnumMeta<msg::DebugPortCommand> {
  static constexpr ValueInfo values[] = {
      {"REALTIME_DATA_3", 1, "CMD_REALTIME_DATA_3."},
      {"REALTIME_DATA_4", 2, "CMD_REALTIME_DATA_4."},
      {"REALTIME_DATA_CUSTOM", 4, "CMD_REALTIME_DATA_CUSTOM."},
      {"DEBUG_VARS_3", 8, "CMD_DEBUG_VARS_3."},
      {"MAVLINK_DEBUG", 16, "CMD_MAVLINK_DEBUG."},
      {"GET_ANGLES", 32, "CMD_GET_ANGLES."},
      {"GET_ANGLES_EXT", 64, "CMD_GET_ANGLES_EXT."},
      {"BODE_TEST_DATA", 128, "CMD_BODE_TEST_DATA."},
      {"HELPER_DATA", 256, "CMD_HELPER_DATA."},
      {"AHRS_HELPER", 512, "CMD_AHRS_HELPER."},
      {"GYRO_CORRECTION", 1024, "CMD_GYRO_CORRECTION."},
      {"CONTROL", 2048, "CMD_CONTROL."},
      {"SET_ADJ_VARS_VAL", 4096, "CMD_SET_ADJ_VARS_VAL."},
      {"API_VIRT_CH_CONTROL", 8192, "CMD_API_VIRT_CH_CONTROL."},
      {"API_VIRT_CH_HIGH_RES", 16384, "CMD_API_VIRT_CH_HIGH_RES."},
  };
  static constexpr EnumInfo info{"DebugPortCommands", values, true};
};

template <>
struct PackedMeta<msg::BoardVersion> {
  static constexpr PartInfo parts[] = {
      {.name = "major", .mask = 0xFF, .shift = 0, .divide = 10},
      {.name = "minor", .mask = 0xFF, .shift = 0, .modulo = 10},
  };
  static constexpr PackedInfo info{"BoardVersion", "{major}.{minor}", nullptr, parts};
};

template <>
struct PackedMeta<msg::FirmwareVersion> {
  static constexpr PartInfo parts[] = {
      {.name = "major", .mask = 0xFFFF, .shift = 0, .divide = 1000},
      {.name = "minor", .mask = 0xFFFF, .shift = 0, .divide = 10, .modulo = 100},
      {.name = "beta", .mask = 0xFFFF, .shift = 0, .modulo = 10},
  };
  static constexpr PackedInfo info{"FirmwareVersion", "{major}.{minor:02}[b{beta}]", nullptr, parts, 2730, "{major}.{minor:02}[.{beta}]"};
};

template <>
struct PackedMeta<msg::EulerOrderSetting> {
  static constexpr PartInfo parts[] = {
      {.name = "order", .mask = 0x0F, .shift = 0, .values = &EnumMeta<msg::EulerOrder>::info},
      {.name = "flags", .mask = 0x30, .shift = 0, .values = &EnumMeta<msg::EulerOrderFlag>::info},
  };
  static constexpr PackedInfo info{"EulerOrderSetting", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::RcMode> {
  static constexpr PartInfo parts[] = {
      {.name = "mode", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::RcModeKind>::info, .saved_as = "rcMode"},
      {.name = "inverted", .mask = 0x08, .shift = 3, .saved_as = "rcInverse"},
  };
  static constexpr PackedInfo info{"RcMode", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::RcMap> {
  static constexpr PartInfo parts[] = {
      {.name = "channel", .mask = 0x1F, .shift = 0},
      {.name = "source", .mask = 0xE0, .shift = 0, .values = &EnumMeta<msg::RcSource>::info},
  };
  static constexpr PackedInfo info{"RcMap", "", &EnumMeta<msg::RcInput>::info, parts};
};

template <>
struct PackedMeta<msg::RcMix> {
  static constexpr PartInfo parts[] = {
      {.name = "rate", .mask = 0x3F, .shift = 0},
      {.name = "target", .mask = 0xC0, .shift = 6, .values = &EnumMeta<msg::MixTarget>::info},
  };
  static constexpr PackedInfo info{"RcMix", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::EncoderType> {
  static constexpr PartInfo parts[] = {
      {.name = "model", .mask = 0x0F, .shift = 0, .values = &EnumMeta<msg::EncoderModel>::info},
      {.name = "flags", .mask = 0xF0, .shift = 0, .values = &EnumMeta<msg::EncoderFlag>::info},
  };
  static constexpr PackedInfo info{"EncoderType", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::MavConfig> {
  static constexpr PartInfo parts[] = {
      {.name = "baud", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::SerialSpeed>::info},
      {.name = "parity_even", .mask = 0x08, .shift = 3},
      {.name = "heartbeat", .mask = 0x10, .shift = 4},
      {.name = "debug", .mask = 0x20, .shift = 5},
      {.name = "rc", .mask = 0x40, .shift = 6},
  };
  static constexpr PackedInfo info{"MavConfig", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::StabAxis> {
  static constexpr PartInfo parts[] = {
      {.name = "axis", .mask = 0x03, .shift = 0, .values = &EnumMeta<msg::StabilizedAxis>::info},
      {.name = "automatic_roll", .mask = 0x04, .shift = 2},
      {.name = "automatic_pitch", .mask = 0x08, .shift = 3},
      {.name = "automatic_yaw", .mask = 0x10, .shift = 4},
  };
  static constexpr PackedInfo info{"StabAxis", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::StartupAction> {
  static constexpr PartInfo parts[] = {
      {.name = "action", .mask = 0x7F, .shift = 0, .values = &EnumMeta<msg::MenuCommand>::info},
      {.name = "button_pressed", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"StartupAction", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ForcePositionConfig> {
  static constexpr PartInfo parts[] = {
      {.name = "snap", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::SnapAngle>::info},
      {.name = "on_button", .mask = 0x10, .shift = 4},
      {.name = "at_startup", .mask = 0x20, .shift = 5},
      {.name = "ignore_limits", .mask = 0x40, .shift = 6},
      {.name = "fine_adjust", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"ForcePositionConfig", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::StepSignalConfig> {
  static constexpr PartInfo parts[] = {
      {.name = "steps", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::StepCount>::info},
      {.name = "button_pressed", .mask = 0x08, .shift = 3},
      {.name = "start_at_zero", .mask = 0x20, .shift = 5},
      {.name = "trigger", .mask = 0xC0, .shift = 6, .values = &EnumMeta<msg::StepTrigger>::info},
  };
  static constexpr PackedInfo info{"StepSignalConfig", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::InterruptConfig> {
  static constexpr PartInfo parts[] = {
      {.name = "pin", .mask = 0x1F, .shift = 0},
      {.name = "on_emergency_stop", .mask = 0x20, .shift = 5},
      {.name = "on_parking", .mask = 0x40, .shift = 6},
  };
  static constexpr PackedInfo info{"InterruptConfig", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ExtImuOrientation> {
  static constexpr PartInfo parts[] = {
      {.name = "top", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::ExtImuAxis>::info},
      {.name = "right", .mask = 0x38, .shift = 3, .values = &EnumMeta<msg::ExtImuAxis>::info},
  };
  static constexpr PackedInfo info{"ExtImuOrientation", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ExtraButton> {
  static constexpr PartInfo parts[] = {
      {.name = "pin", .mask = 0x3F, .shift = 0, .values = &EnumMeta<msg::BoardPin>::info},
      {.name = "latching", .mask = 0x40, .shift = 6},
      {.name = "inverted", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"ExtraButton", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::EncoderConfigExt> {
  static constexpr PartInfo parts[] = {
      {.name = "resolution", .mask = 0x1F, .shift = 0},
      {.name = "multi_turn", .mask = 0xE0, .shift = 5, .values = &EnumMeta<msg::MultiTurn>::info},
  };
  static constexpr PackedInfo info{"EncoderConfigExt", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::InputStates> {
  static constexpr PartInfo parts[] = {
      {.name = "input_1", .mask = 0x03, .shift = 0, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_2", .mask = 0x0C, .shift = 2, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_3", .mask = 0x30, .shift = 4, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_4", .mask = 0xC0, .shift = 6, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_5", .mask = 0x300, .shift = 8, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_6", .mask = 0xC00, .shift = 10, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_7", .mask = 0x3000, .shift = 12, .values = &EnumMeta<msg::InputState>::info},
      {.name = "input_8", .mask = 0xC000, .shift = 14, .values = &EnumMeta<msg::InputState>::info},
  };
  static constexpr PackedInfo info{"InputStates", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ControlMode> {
  static constexpr PartInfo parts[] = {
      {.name = "mode", .mask = 0x0F, .shift = 0, .values = &EnumMeta<msg::ControlModeKind>::info},
      {.name = "flags", .mask = 0xF0, .shift = 0, .values = &EnumMeta<msg::ControlFlag>::info},
  };
  static constexpr PackedInfo info{"ControlMode", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::EulerOrderChoice> {
  static constexpr PartInfo parts[] = {
      {.name = "order", .mask = 0x0F, .shift = 0, .values = &EnumMeta<msg::EulerOrderChange>::info},
      {.name = "flags", .mask = 0x30, .shift = 0, .values = &EnumMeta<msg::EulerOrderFlag>::info},
  };
  static constexpr PackedInfo info{"EulerOrderChoice", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::HelperCoordinates> {
  static constexpr PartInfo parts[] = {
      {.name = "system", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::CoordinateSystem>::info},
      {.name = "flags", .mask = 0xC0, .shift = 0, .values = &EnumMeta<msg::HelperDataFlag>::info},
  };
  static constexpr PackedInfo info{"HelperCoordinates", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::PackedQuaternion> {
  static constexpr PartInfo parts[] = {
      {.name = "a", .mask = 0x7FFFF, .shift = 0, .sign = 0x80000, .unit = &UnitMeta<msg::QuaternionPart>::info},
      {.name = "b", .mask = 0x7FFFF00000, .shift = 20, .sign = 0x8000000000, .unit = &UnitMeta<msg::QuaternionPart>::info},
      {.name = "c", .mask = 0x7FFFF0000000000, .shift = 40, .sign = 0x800000000000000, .unit = &UnitMeta<msg::QuaternionPart>::info},
      {.name = "largest", .mask = 0x3000000000000000, .shift = 60, .values = &EnumMeta<msg::QuaternionComponent>::info},
      {.name = "largest_sign", .mask = 0x4000000000000000, .shift = 62},
  };
  static constexpr PackedInfo info{"PackedQuaternion", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ExtMotorStatus> {
  static constexpr PartInfo parts[] = {
      {.name = "power", .mask = 0x03, .shift = 0, .values = &EnumMeta<msg::ExtMotorPower>::info},
      {.name = "pins", .mask = 0xFFFC, .shift = 0, .values = &EnumMeta<msg::ExtMotorPin>::info},
  };
  static constexpr PackedInfo info{"ExtMotorStatus", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::AxisTuningOptions> {
  static constexpr PartInfo parts[] = {
      {.name = "enabled", .mask = 0x01, .shift = 0},
      {.name = "tune_lpf", .mask = 0x02, .shift = 1},
      {.name = "notch_filters", .mask = 0x0C, .shift = 2},
  };
  static constexpr PackedInfo info{"AxisTuningOptions", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::AhrsReferences> {
  static constexpr PartInfo parts[] = {
      {.name = "attitude", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::AhrsReference>::info},
      {.name = "heading", .mask = 0x38, .shift = 3, .values = &EnumMeta<msg::AhrsReference>::info},
      {.name = "internal_used", .mask = 0x40, .shift = 6},
      {.name = "enabled", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"AhrsReferences", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ExtImuStatus> {
  static constexpr PartInfo parts[] = {
      {.name = "state", .mask = 0x07, .shift = 0, .values = &EnumMeta<msg::ExtImuState>::info},
      {.name = "bad_mag", .mask = 0x40, .shift = 6},
      {.name = "no_gps_signal", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"ExtImuStatus", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::I2cDevice> {
  static constexpr PartInfo parts[] = {
      {.name = "port", .mask = 0x01, .shift = 0, .values = &EnumMeta<msg::I2cPort>::info},
      {.name = "address", .mask = 0xFE, .shift = 1},
  };
  static constexpr PackedInfo info{"I2cDevice", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ModuleVersion> {
  static constexpr PartInfo parts[] = {
      {.name = "major", .mask = 0xFFFF, .shift = 0, .divide = 100},
      {.name = "minor", .mask = 0xFFFF, .shift = 0, .modulo = 100},
  };
  static constexpr PackedInfo info{"ModuleVersion", "{major}.{minor:02}", nullptr, parts};
};

template <>
struct PackedMeta<msg::CanDeviceType> {
  static constexpr PartInfo parts[] = {
      {.name = "kind", .mask = 0x7F, .shift = 0, .values = &EnumMeta<msg::CanDeviceKind>::info},
      {.name = "hardware_assigned", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"CanDeviceType", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::TransparentTarget> {
  static constexpr PartInfo parts[] = {
      {.name = "port", .mask = 0x03, .shift = 0},
      {.name = "device", .mask = 0x3C, .shift = 2, .values = &EnumMeta<msg::TransparentDevice>::info},
      {.name = "wait", .mask = 0x40, .shift = 6},
  };
  static constexpr PackedInfo info{"TransparentTarget", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::DebugPortLine> {
  static constexpr PartInfo parts[] = {
      {.name = "port", .mask = 0x7F, .shift = 0},
      {.name = "direction", .mask = 0x80, .shift = 7},
  };
  static constexpr PackedInfo info{"DebugPortLine", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::DebugVarType> {
  static constexpr PartInfo parts[] = {
      {.name = "kind", .mask = 0x0F, .shift = 0, .values = &EnumMeta<msg::DebugVarKind>::info},
      {.name = "axis", .mask = 0x30, .shift = 0, .values = &EnumMeta<msg::DebugVarAxis>::info},
      {.name = "flags", .mask = 0xC0, .shift = 0, .values = &EnumMeta<msg::DebugVarFlag>::info},
  };
  static constexpr PackedInfo info{"DebugVarType", "", nullptr, parts};
};

/// The features that boards may have.
inline constexpr FeatureInfo features[] = {
    {"BOARD_FEATURE_3AXIS", 0x01},
    {"BOARD_FEATURE_BAT_MONITORING", 0x02},
    {"BOARD_FEATURE_ENCODERS", 0x04},
    {"BOARD_FEATURE_BODE_TEST", 0x08},
    {"BOARD_FEATURE_SCRIPTING", 0x10},
    {"BOARD_FEATURE_CURRENT_SENSOR", 0x20},
    {"BOARD_FEATURE_MAG_SENSOR", 0x40},
    {"BOARD_FEATURE_ORDER_OF_AXES_LETUS", 0x80},
    {"BOARD_FEATURE_IMU_EEPROM", 0x100},
    {"BOARD_FEATURE_FRAME_IMU_EEPROM", 0x200},
    {"BOARD_FEATURE_CAN_PORT", 0x400},
    {"BOARD_FEATURE_MOMENTUM", 0x800},
    {"BOARD_FEATURE_COGGING_CORRECTION", 0x1000},
    {"BOARD_FEATURE_MOTOR4_CONTROL", 0x2000},
    {"BOARD_FEATURE_ACC_AUTO_CALIB", 0x4000},
    {"BOARD_FEATURE_BIG_FLASH", 0x8000},
    {"EXT_IMU", 0x10000},
    {"STATE_VARS", 0x40000},
    {"POWER_MANAGEMENT", 0x80000},
    {"GYRO_ADVANCED_CALIB", 0x100000},
    {"LIMITED_VERSION", 0x200000},
    {"REACTION", 0x400000},
    {"ENCODER_LUT", 0x800000},
    {"PLUS_VER", 0x100000000},
    {"SHAKE_GENERATOR", 0x200000000},
    {"EXT_MOTORS", 0x400000000},
    {"QUAT_CONTROL", 0x800000000},
    {"ADC4", 0x1000000000},
};

}  // namespace sbgc
