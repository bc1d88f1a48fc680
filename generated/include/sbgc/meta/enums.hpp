// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Names of enum values, flags and parts of packed values.
#pragma once

#include <sbgc/meta.hpp>

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
      {"CMD_BOOT_MODE_3", 51, "Enter the bootloader to load new firmware."},
      {"CMD_SYSTEM_STATE", 52, "Undocumented; by its name, the state of the system."},
      {"CMD_READ_FILE", 53, "Part of a file."},
      {"CMD_WRITE_FILE", 54, "Write part of a file; without data, delete it."},
      {"CMD_FS_CLEAR_ALL", 55, "Delete all files."},
      {"CMD_AHRS_HELPER", 56, "Attitude of an IMU as two unit vectors."},
      {"CMD_RUN_SCRIPT", 57, "Start or stop a script."},
      {"CMD_CALIB_MAG", 59, "Calibrate the magnetometer."},
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
      {"CMD_MOTORS_ON", 77, "Turn the motors on."},
      {"CMD_CALIB_OFFSET", 79, "Calibrate the follow mode offset."},
      {"CMD_CALIB_POLES", 80, "Detect the poles and the direction of the motors."},
      {"CMD_READ_PARAMS", 82, "Older id of CMD_READ_PARAMS_3."},
      {"CMD_TRIGGER_PIN", 84, "Switch an output pin."},
      {"CMD_DATA_STREAM_INTERVAL", 85, "Start, change or end a data stream: messages that the board sends at a fixed rate."},
      {"CMD_BOARD_INFO", 86, "Board version and features."},
      {"CMD_WRITE_PARAMS", 87, "Older id of CMD_WRITE_PARAMS_3."},
      {"CMD_REALTIME_DATA_CUSTOM", 88, "Live data of the requested blocks."},
      {"CMD_BEEP_SOUND", 89, "Play a melody through the motors, or a standard sound."},
      {"CMD_CALIB_GYRO", 103, "Calibrate a gyroscope."},
      {"CMD_MOTORS_OFF", 109, "Turn the motors off."},
      {"CMD_RESET", 114, "The board restarts."},
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
      {"CMD_I2C_READ_REG_BUF", 40, "Data from a device on an I2C bus."},
      {"CMD_READ_EXTERNAL_DATA", 42, "User data in the EEPROM."},
      {"CMD_READ_ADJ_VARS_CFG", 43, "RC signals that trigger actions or change adjustable variables."},
      {"CMD_ADJ_VARS_STATE", 46, "Current state of one trigger slot and one analog slot."},
      {"CMD_EEPROM_READ", 48, "A block of the EEPROM."},
      {"CMD_CALIB_INFO", 49, "Calibration status for display."},
      {"CMD_SYSTEM_STATE", 52, "Undocumented; by its name, the state of the system."},
      {"CMD_READ_FILE", 53, "Part of a file."},
      {"CMD_AHRS_HELPER", 56, "Attitude of an IMU as two unit vectors."},
      {"CMD_SCRIPT_DEBUG", 58, "Progress of a script started with debugging."},
      {"CMD_GET_ANGLES_EXT", 61, "Camera angles, targets and joint angles."},
      {"CMD_READ_PARAMS_EXT2", 62, "The third set of parameters of one profile."},
      {"CMD_CONFIRM", 67, "The board executed a command."},
      {"CMD_GET_ANGLES", 73, "Camera angles and targets."},
      {"CMD_CALIB_MOTOR_MAG_LINK", 74, "Undocumented; by its name, calibrates the magnetic linkage of the motors."},
      {"CMD_BOARD_INFO", 86, "Board version and features."},
      {"CMD_REALTIME_DATA_CUSTOM", 88, "Live data of the requested blocks."},
      {"CMD_RESET", 114, "The board restarts."},
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
      {"FOLLOW_MODE", 30, "What the camera follows: 0 nothing, 1 the flight controller, 2 pitch and roll of the frame."},
      {"RC_FOLLOW_YAW", 31, "1 if yaw follows the frame, otherwise 0."},
      {"FOLLOW_DEADBAND", 32, "Dead band of the follow mode."},
      {"FOLLOW_EXPO_RATE", 33, "Expo rate of the follow mode."},
      {"FOLLOW_ROLL_MIX_START", 34, "Angle at which pitch starts to follow roll."},
      {"FOLLOW_ROLL_MIX_RANGE", 35, "Angle over which pitch continues to follow roll."},
      {"GYRO_TRUST", 36, "Trust in the gyroscope relative to the accelerometer."},
      {"FRAME_HEADING_ANGLE", 37, "Heading of the frame."},
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
  };
  static constexpr EnumInfo info{"VariableId", values, false};
};

template <>
struct EnumMeta<msg::BoardErrorCode> {
  static constexpr ValueInfo values[] = {
      {"CMD_SIZE", 1, "The command has no body of this size."},
      {"WRONG_PARAMS", 2, "A value is invalid."},
      {"CRYPTO", 4, "A key or signature check failed."},
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
      {"RC_VIRT_MODE_API", 10, "Virtual channels of the Serial API.", {.board = 30}},
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
      {"EXT_FC_INPUT_PITCH_ANALOG", 36, "Analog signal at the FC_PITCH pin of boards before 3.0."},
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
      {"MENU_CMD_CALIB_MAG", 33, "Calibrate the magnetometer."},
      {"MENU_CMD_LEVEL_ROLL_PITCH", 34, "Level roll and pitch."},
      {"MENU_CMD_CENTER_YAW", 35, "Center yaw."},
      {"MENU_CMD_UNTWIST_CABLES", 36, "Turn back to untwist the cables."},
      {"MENU_CMD_SET_ANGLE_NO_SAVE", 37, "Make the current angle the initial angle, without saving it."},
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
      {"LOCAL_ROLL", 2, "Local, roll; for two-axis systems."},
      {"ROLL_LOCAL", 3, "Roll, local; for two-axis systems."},
      {"YAW_ROLL_PITCH", 4, "Yaw, roll, pitch."},
      {"YAW_PITCH_ROLL", 5, "Yaw, pitch, roll."},
  };
  static constexpr EnumInfo info{"EulerOrder", values, false};
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
      {"SUB_ERR_MOTOR_OVERHEAT_PROTECTION", 13, "A motor overheated."},
  };
  static constexpr EnumInfo info{"SystemSubError", values, false};
};

template <>
struct EnumMeta<msg::ControlModeKind> {
  static constexpr ValueInfo values[] = {
      {"MODE_NO_CONTROL", 0, "Serial control ends and RC takes over."},
      {"MODE_SPEED", 1, "Turn at the given speed, in Euler coordinates, until the next command; the angle is ignored."},
      {"MODE_ANGLE", 2, "Go to the given angle, in Euler coordinates, at the given speed; speed 0 selects the speed from the parameters."},
      {"MODE_SPEED_ANGLE", 3, "Follow the given speed while the controller holds the given angle; the most precise mode."},
      {"MODE_RC", 4, "The angle replaces the RC signal, -500 to 500; the speed is ignored."},
      {"MODE_ANGLE_REL_FRAME", 5, "Go to the given angle relative to the frame's neutral point; undoes full turns, so it untwists cables. Speed 0 selects the speed from the parameters."},
  };
  static constexpr EnumInfo info{"ControlModeKind", values, false};
};

template <>
struct EnumMeta<msg::MotorsOffMode> {
  static constexpr ValueInfo values[] = {
      {"NORMAL", 0, "They turn freely, without current."},
      {"BRAKE", 1, "They brake."},
      {"SAFE_STOP", 2, "They stop safely."},
  };
  static constexpr EnumInfo info{"MotorsOffMode", values, false};
};

template <>
struct EnumMeta<msg::CoordinateSystem> {
  static constexpr ValueInfo values[] = {
      {"COORD_SYS_GROUND_YAW_ROTATED", 1, "Ground coordinates rotated with the camera about Z: Z points up, X right, Y forward. The default."},
  };
  static constexpr EnumInfo info{"CoordinateSystem", values, false};
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
struct EnumMeta<msg::ImuIndex> {
  static constexpr ValueInfo values[] = {
      {"MAIN", 0, "The main IMU on the camera."},
      {"FRAME", 1, "The IMU on the frame."},
  };
  static constexpr EnumInfo info{"ImuIndex", values, false};
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
  };
  static constexpr EnumInfo info{"OutputPin", values, false};
};

template <>
struct EnumMeta<msg::PinState> {
  static constexpr ValueInfo values[] = {
      {"LOW", 0, "Low; sinks up to 40 mA."},
      {"HIGH", 1, "High; supplies up to 40 mA."},
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
struct EnumMeta<msg::FileError> {
  static constexpr ValueInfo values[] = {
      {"NO_ERROR", 0, "Success."},
      {"ERR_EEPROM_FAULT", 1, "The memory chip does not respond."},
      {"ERR_FILE_NOT_FOUND", 2, "No file has this id."},
      {"ERR_FAT", 3, "The file table is damaged."},
      {"ERR_NO_FREE_SPACE", 4, "The memory is full."},
      {"ERR_FAT_IS_FULL", 5, "The file table is full."},
      {"ERR_FILE_SIZE", 6, "The size is invalid."},
      {"ERR_CRC", 7, "Checksum mismatch."},
      {"ERR_LIMIT_REACHED", 8, "The file system reached a limit."},
      {"ERR_FILE_CORRUPTED", 9, "The file is damaged."},
      {"ERR_WRONG_PARAMS", 10, "A value of the request is invalid."},
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
struct EnumMeta<msg::BoardFeature> {
  static constexpr ValueInfo values[] = {
      {"BOARD_FEATURE_3AXIS", 1, "Drives three motors."},
      {"BOARD_FEATURE_BAT_MONITORING", 2, "Measures the battery voltage."},
      {"BOARD_FEATURE_ENCODERS", 4, "Supports motor encoders."},
      {"BOARD_FEATURE_BODE_TEST", 8, "Can record a frequency response."},
      {"BOARD_FEATURE_SCRIPTING", 16, "Runs user scripts."},
      {"BOARD_FEATURE_CURRENT_SENSOR", 32, "Measures the supply current."},
  };
  static constexpr EnumInfo info{"BoardFeatures", values, true};
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
  };
  static constexpr EnumInfo info{"ResetOptions", values, true};
};

template <>
struct EnumMeta<msg::FilterSwitch> {
  static constexpr ValueInfo values[] = {
      {"EN_NOTCH1", 1, "First notch filter."},
      {"EN_NOTCH2", 2, "Second notch filter."},
      {"EN_NOTCH3", 4, "Third notch filter."},
      {"EN_LPF", 8, "Low-pass filter."},
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
  };
  static constexpr EnumInfo info{"GeneralFlags", values, true};
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
  };
  static constexpr EnumInfo info{"ProfileFlags", values, true};
};

template <>
struct EnumMeta<msg::SystemError> {
  static constexpr ValueInfo values[] = {
      {"ERR_NO_SENSOR", 1, "The IMU sensor does not respond."},
      {"ERR_CALIB_ACC", 2, "The accelerometer is not calibrated."},
      {"ERR_SET_POWER", 4, "The motor power is not set."},
      {"ERR_CALIB_POLES", 8, "The motor poles are not calibrated."},
      {"ERR_PROTECTION", 16, "The driver protection tripped."},
      {"ERR_SERIAL", 32, "Errors on the serial line."},
      {"ERR_LOW_BAT1", 64, "The battery is below the alarm threshold."},
      {"ERR_LOW_BAT2", 128, "The battery is below the motor stop threshold."},
      {"ERR_GUI_VERSION", 256, "The host software does not match the firmware."},
      {"ERR_MISS_STEPS", 512, "A motor lost steps."},
      {"ERR_SYSTEM", 1024, "System error."},
      {"ERR_EMERGENCY_STOP", 2048, "Emergency stop; SYSTEM_SUB_ERROR gives the reason."},
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
  };
  static constexpr EnumInfo info{"RealtimeDataCustomFlags", values, true};
};

template <>
struct EnumMeta<msg::ControlFlag> {
  static constexpr ValueInfo values[] = {
      {"CONTROL_FLAG_HIGH_RES_SPEED", 128, "Speeds are in 0.001 deg/s.", {.firmware = 2590}},
  };
  static constexpr EnumInfo info{"ControlFlags", values, true};
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
struct EnumMeta<msg::DebugVarFlag> {
  static constexpr ValueInfo values[] = {
      {"VAR_FLAG_ANGLE14", 64, "An angle, 16384 counts per turn."},
  };
  static constexpr EnumInfo info{"DebugVarFlags", values, true};
};

template <>
struct PackedMeta<msg::BoardVersion> {
  static constexpr PartInfo parts[] = {
      {"major", 0xFF, 0, 10, 0},
      {"minor", 0xFF, 0, 1, 10},
  };
  static constexpr PackedInfo info{"BoardVersion", "{major}.{minor}", nullptr, parts};
};

template <>
struct PackedMeta<msg::FirmwareVersion> {
  static constexpr PartInfo parts[] = {
      {"major", 0xFFFF, 0, 1000, 0},
      {"minor", 0xFFFF, 0, 10, 100},
      {"beta", 0xFFFF, 0, 1, 10},
  };
  static constexpr PackedInfo info{"FirmwareVersion", "{major}.{minor:02}[b{beta}]", nullptr, parts};
};

template <>
struct PackedMeta<msg::RcMode> {
  static constexpr PartInfo parts[] = {
      {"mode", 0x07, 0, 1, 0, &EnumMeta<msg::RcModeKind>::info},
      {"inverted", 0x08, 3, 1, 0},
  };
  static constexpr PackedInfo info{"RcMode", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::RcMap> {
  static constexpr PartInfo parts[] = {
      {"channel", 0x1F, 0, 1, 0},
      {"source", 0xE0, 0, 1, 0, &EnumMeta<msg::RcSource>::info},
  };
  static constexpr PackedInfo info{"RcMap", "", &EnumMeta<msg::RcInput>::info, parts};
};

template <>
struct PackedMeta<msg::RcMix> {
  static constexpr PartInfo parts[] = {
      {"rate", 0x3F, 0, 1, 0},
      {"target", 0xC0, 6, 1, 0, &EnumMeta<msg::MixTarget>::info},
  };
  static constexpr PackedInfo info{"RcMix", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::EncoderType> {
  static constexpr PartInfo parts[] = {
      {"model", 0x0F, 0, 1, 0, &EnumMeta<msg::EncoderModel>::info},
      {"flags", 0xF0, 0, 1, 0, &EnumMeta<msg::EncoderFlag>::info},
  };
  static constexpr PackedInfo info{"EncoderType", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::ControlMode> {
  static constexpr PartInfo parts[] = {
      {"mode", 0x0F, 0, 1, 0, &EnumMeta<msg::ControlModeKind>::info},
      {"flags", 0xF0, 0, 1, 0, &EnumMeta<msg::ControlFlag>::info},
  };
  static constexpr PackedInfo info{"ControlMode", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::I2cDevice> {
  static constexpr PartInfo parts[] = {
      {"port", 0x01, 0, 1, 0, &EnumMeta<msg::I2cPort>::info},
      {"address", 0xFE, 1, 1, 0},
  };
  static constexpr PackedInfo info{"I2cDevice", "", nullptr, parts};
};

template <>
struct PackedMeta<msg::DebugVarType> {
  static constexpr PartInfo parts[] = {
      {"kind", 0x0F, 0, 1, 0, &EnumMeta<msg::DebugVarKind>::info},
      {"axis", 0x30, 0, 1, 0, &EnumMeta<msg::DebugVarAxis>::info},
      {"flags", 0xC0, 0, 1, 0, &EnumMeta<msg::DebugVarFlag>::info},
  };
  static constexpr PackedInfo info{"DebugVarType", "", nullptr, parts};
};

}  // namespace sbgc
