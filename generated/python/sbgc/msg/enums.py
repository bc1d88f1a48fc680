# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Enums and flag sets of the protocol."""

from __future__ import annotations

from sbgc.values import Flags8, Flags16, Flags32, OpenEnum

__all__ = [
    "AdaptivePidAxes",
    "AhrsHelperMode",
    "AhrsHelperWideMode",
    "AhrsReference",
    "AutoPid2Action",
    "AutoPid2CommandFlags",
    "AutoPid2Flags",
    "AutoPidFlags",
    "AxisOrder",
    "BeeperModes",
    "BeepModes",
    "BoardErrorCode",
    "BoardFeatures",
    "BoardFeaturesExt",
    "BoardFeaturesExt2",
    "BoardPin",
    "BoardPort",
    "BoardStateFlags",
    "BodeAxis",
    "BodeStimulus",
    "BodeSystem",
    "CalibAction",
    "CalibImu",
    "CalibMode",
    "CalibMotor",
    "CalibratedLimits",
    "CanDeviceId",
    "CanDeviceKind",
    "CanDrvPins",
    "CanDrvTelemetryFlags",
    "CanErrorFlags",
    "CanImuSensor",
    "CoggingAction",
    "CoggingAxes",
    "CommandFromBoard",
    "CommandToBoard",
    "ConnectionFlags",
    "ControlConfigFlags",
    "ControlExtFields",
    "ControlExtFlags",
    "ControlFlags",
    "ControlModeKind",
    "ControlQuatConfigFields",
    "ControlQuatConfigFlags",
    "ControlQuatFlags",
    "ControlQuatMode",
    "ControlQuatStatusFields",
    "ControlQuatStatusFlags",
    "CoordinateSystem",
    "DebugPortAction",
    "DebugPortCommands",
    "DebugVarAxis",
    "DebugVarFlags",
    "DebugVarKind",
    "EncoderConfig",
    "EncoderFlags",
    "EncoderModel",
    "EulerOrder",
    "EulerOrderChange",
    "EulerOrderFlags",
    "EventId",
    "EventTypes",
    "ExecuteMenuFlags",
    "ExtImuAxis",
    "ExtImuFlags",
    "ExtImuModel",
    "ExtImuPosition",
    "ExtImuState",
    "ExtMotorActionKind",
    "ExtMotorMode",
    "ExtMotorPins",
    "ExtMotorPower",
    "ExtMotors",
    "ExtMotorsControlConfigFields",
    "ExtMotorsControlFields",
    "ExtMotorsStateFields",
    "ExtMotorTargets",
    "ExtSensCommand",
    "ExtSensOptions",
    "FieldOffsetFlags",
    "FileError",
    "FilterSwitches",
    "FollowMode",
    "FrameImuPosition",
    "GeneralFlags",
    "GeneralFlags2",
    "GeneralFlags3",
    "GeneralFlags4",
    "HardwareFlags",
    "HelperDataFlags",
    "I2cPort",
    "ImuIndex",
    "InputState",
    "MavControlMode",
    "MenuCommand",
    "MixTarget",
    "ModuleId",
    "MotorOutput",
    "MotorPowerFlags",
    "MotorsOffMode",
    "MultiTurn",
    "OtherFlags",
    "OutputPin",
    "ParkingBorders",
    "PassProtectFlags",
    "PinState",
    "PowerState",
    "ProfileFlags",
    "ProfileFlags2",
    "ProfileFlags3",
    "ProfileSetAction",
    "PwmFrequency",
    "QuaternionComponent",
    "RcInput",
    "RcInputOptions",
    "RcModeKind",
    "RcSource",
    "RcVirtualMode",
    "RealtimeDataCustom2Flags",
    "RealtimeDataCustomFlags",
    "ResetOptions",
    "ScriptMode",
    "SelectedImu",
    "SensorAxis",
    "SerialSpeed",
    "ServoOutputs",
    "SkipGyroCalibration",
    "SnapAngle",
    "SpektrumMode",
    "StabilizedAxis",
    "StateFlags",
    "StepCount",
    "StepTrigger",
    "StoredProfileSets",
    "StreamSync",
    "SyncMotorAxis",
    "SystemErrors",
    "SystemPowerFlags",
    "SystemSubError",
    "TransparentDevice",
    "TuningPositions",
    "VariableId",
    "WriteParamsAction",
]


class CommandToBoard(OpenEnum):
    """The commands of messages to the board."""

    CMD_BOARD_INFO_3 = 20
    """Serial numbers, memory and scripts of the board."""
    CMD_READ_PARAMS_3 = 21
    """Parameters of one profile and general parameters."""
    CMD_WRITE_PARAMS_3 = 22
    """Store the parameters of one profile and the general parameters."""
    CMD_REALTIME_DATA_3 = 23
    """Live data."""
    CMD_SELECT_IMU_3 = 24
    """Select the IMU to configure and calibrate; ignored if it is not connected."""
    CMD_REALTIME_DATA_4 = 25
    """Live data with joint angles, currents and temperatures."""
    CMD_ENCODERS_CALIB_OFFSET_4 = 26
    """Calibrate the offsets of the encoders."""
    CMD_ENCODERS_CALIB_FLD_OFFSET_4 = 27
    """Calibrate the offsets between encoders and the motors' magnetic fields."""
    CMD_READ_PROFILE_NAMES = 28
    """Profile names."""
    CMD_WRITE_PROFILE_NAMES = 29
    """Store the profile names."""
    CMD_QUEUE_PARAMS_INFO_3 = 30
    """Undocumented; possibly describes the adjustable variables, the purpose of CMD_GET_PARAMS_3.
    """
    CMD_SET_ADJ_VARS_VAL = 31
    """Values of adjustable variables."""
    CMD_SAVE_PARAMS_3 = 32
    """Save the parameters in use, with all changes to adjustable variables, to the active profile.
    """
    CMD_READ_PARAMS_EXT = 33
    """More parameters of one profile: filters, encoders, magnetometer."""
    CMD_WRITE_PARAMS_EXT = 34
    """Store more parameters of one profile."""
    CMD_AUTO_PID = 35
    """Tune the PID controllers automatically."""
    CMD_SERVO_OUT = 36
    """Send PWM signals to servos."""
    CMD_BODE_TEST_START_STOP = 37
    """Record a frequency response."""
    CMD_I2C_WRITE_REG_BUF = 39
    """Write to a device on an I2C bus."""
    CMD_I2C_READ_REG_BUF = 40
    """Data from a device on an I2C bus."""
    CMD_WRITE_EXTERNAL_DATA = 41
    """Store user data in the EEPROM."""
    CMD_READ_EXTERNAL_DATA = 42
    """User data in the EEPROM."""
    CMD_READ_ADJ_VARS_CFG = 43
    """RC signals that trigger actions or change adjustable variables."""
    CMD_WRITE_ADJ_VARS_CFG = 44
    """Store the RC signals that trigger actions or change adjustable variables."""
    CMD_API_VIRT_CH_CONTROL = 45
    """Set the host's virtual RC channels, which can control the camera and more."""
    CMD_ADJ_VARS_STATE = 46
    """Current state of one trigger slot and one analog slot."""
    CMD_EEPROM_WRITE = 47
    """Write a block to the EEPROM."""
    CMD_EEPROM_READ = 48
    """A block of the EEPROM."""
    CMD_CALIB_INFO = 49
    """Calibration status for display."""
    CMD_SIGN_MESSAGE = 50
    """Signature of a message."""
    CMD_BOOT_MODE_3 = 51
    """Enter the bootloader to load new firmware."""
    CMD_SYSTEM_STATE = 52
    """Undocumented; by its name, the state of the system."""
    CMD_READ_FILE = 53
    """Part of a file."""
    CMD_WRITE_FILE = 54
    """Write part of a file; without data, delete it."""
    CMD_FS_CLEAR_ALL = 55
    """Delete all files."""
    CMD_AHRS_HELPER = 56
    """Attitude of an IMU as two unit vectors."""
    CMD_RUN_SCRIPT = 57
    """Start or stop a script."""
    CMD_CALIB_MAG = 59
    """Calibrate the magnetometer."""
    CMD_UART_BYPASS = 60
    """Undocumented; by its name, connects two serial ports of the board."""
    CMD_GET_ANGLES_EXT = 61
    """Camera angles, targets and joint angles."""
    CMD_READ_PARAMS_EXT2 = 62
    """The third set of parameters of one profile."""
    CMD_WRITE_PARAMS_EXT2 = 63
    """Store the third set of parameters of one profile."""
    CMD_GET_ADJ_VARS_VAL = 64
    """Request the values of adjustable variables."""
    CMD_CALIB_ACC = 65
    """Calibrate an accelerometer."""
    CMD_CALIB_BAT = 66
    """Calibrate the battery voltage measurement."""
    CMD_CONTROL = 67
    """Move the camera."""
    CMD_REALTIME_DATA = 68
    """Live data."""
    CMD_EXECUTE_MENU = 69
    """Execute a menu action, as the menu button or the RC command channel does."""
    CMD_USE_DEFAULTS = 70
    """Restore the factory defaults."""
    CMD_CALIB_EXT_GAIN = 71
    """Calibrate the gains of a flight controller's signals."""
    CMD_HELPER_DATA = 72
    """Motion of the frame from an external system; improves stabilization."""
    CMD_GET_ANGLES = 73
    """Camera angles and targets."""
    CMD_CALIB_MOTOR_MAG_LINK = 74
    """Undocumented; by its name, calibrates the magnetic linkage of the motors."""
    CMD_GYRO_CORRECTION = 75
    """Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong."""
    CMD_MODULE_LIST = 76
    """Modules connected to the board."""
    CMD_MOTORS_ON = 77
    """Turn the motors on."""
    CMD_MODULE_FLASH_START = 78
    """Begin to load new firmware into a module."""
    CMD_CALIB_OFFSET = 79
    """Calibrate the follow mode offset."""
    CMD_CALIB_POLES = 80
    """Detect the poles and the direction of the motors."""
    CMD_MODULE_FLASH_WRITE = 81
    """Load a part of new firmware into a module."""
    CMD_READ_PARAMS = 82
    """Older id of CMD_READ_PARAMS_3."""
    CMD_MODULE_FLASH_FINISH = 83
    """End the loading of firmware into a module."""
    CMD_TRIGGER_PIN = 84
    """Switch an output pin."""
    CMD_DATA_STREAM_INTERVAL = 85
    """Start, change or end a data stream: messages that the board sends at a fixed rate."""
    CMD_BOARD_INFO = 86
    """Board version and features."""
    CMD_WRITE_PARAMS = 87
    """Older id of CMD_WRITE_PARAMS_3."""
    CMD_REALTIME_DATA_CUSTOM = 88
    """Live data of the requested blocks."""
    CMD_BEEP_SOUND = 89
    """Play a melody through the motors, or a standard sound."""
    CMD_CONTROL_CONFIG = 90
    """Configure serial control until the next start."""
    CMD_CALIB_ORIENT_CORR = 91
    """Calibrate the orientation of the IMU."""
    CMD_COGGING_CALIB_INFO = 92
    """Undocumented; by its name, the state of the calibration of the cogging."""
    CMD_CALIB_COGGING = 93
    """Calibrate the cogging of the motors, or delete this calibration."""
    CMD_CALIB_ACC_EXT_REF = 94
    """Calibrate the accelerometer with an external reference."""
    CMD_PROFILE_SET = 95
    """Save, clear or load a profile set."""
    CMD_CAN_DEVICE_SCAN = 96
    """Devices on the CAN bus."""
    CMD_CAN_DRV_HARD_PARAMS = 97
    """Undocumented; by its name, hardware parameters of a CAN motor driver."""
    CMD_CAN_DRV_STATE = 98
    """Undocumented; by its name, the state of a CAN motor driver."""
    CMD_CAN_DRV_CALIBRATE = 99
    """Undocumented; by its name, calibrates a CAN motor driver."""
    CMD_READ_RC_INPUTS = 100
    """RC signals of selected inputs."""
    CMD_REALTIME_DATA_CAN_DRV = 101
    """Undocumented; by its name, live data of a CAN motor driver."""
    CMD_CALIB_GYRO = 103
    """Calibrate a gyroscope."""
    CMD_READ_PARAMS_EXT3 = 104
    """The fourth set of parameters of one profile."""
    CMD_WRITE_PARAMS_EXT3 = 105
    """Store the fourth set of parameters of one profile."""
    CMD_EXT_IMU_DEBUG_INFO = 106
    """State of the attitude estimation and of the external IMU."""
    CMD_SET_DEVICE_ADDR = 107
    """Undocumented; by its name, sets the address of a device."""
    CMD_AUTO_PID2 = 108
    """Tune the PID controllers automatically, in later firmware."""
    CMD_MOTORS_OFF = 109
    """Turn the motors off."""
    CMD_EXT_IMU_CMD = 110
    """A command of the external IMU's own protocol."""
    CMD_READ_STATE_VARS = 111
    """Statistics of the board's whole life."""
    CMD_WRITE_STATE_VARS = 112
    """Store the statistics of the board's whole life."""
    CMD_SERIAL_PROXY = 113
    """Undocumented; by its name, passes data on to a serial port."""
    CMD_RESET = 114
    """The board restarts."""
    CMD_IMU_ADVANCED_CALIB = 115
    """Undocumented; by its name, calibrates an IMU in an advanced way."""
    CMD_API_VIRT_CH_HIGH_RES = 116
    """Set the host's virtual RC channels in high resolution; they can control the camera and more.
    """
    CMD_CALIB_ENCODER_LUT = 117
    """Undocumented; by its name, calibrates the correction table of an encoder."""
    CMD_CALIB_ENCODER_LUT_RES = 118
    """Undocumented; by its name, the result of the calibration of an encoder's correction table."""
    CMD_WRITE_PARAMS_SET = 119
    """Begin or end a series of commands that store parameters."""
    CMD_CALIB_CUR_SENS = 120
    """Undocumented; by its name, calibrates the current sensors."""
    CMD_CONTROL_EXT = 121
    """Move the camera, with the data that each axis needs."""
    CMD_ENC_INT_CALIB = 122
    """Undocumented; by its name, calibrates an encoder internally."""
    CMD_SYNC_MOTORS = 123
    """Power one motor as a synchronous motor for some time, then turn the motors off."""
    CMD_EXT_LICENSE_INFO = 124
    """Undocumented; by its name, information about extended licenses."""
    CMD_VIBRATION_TEST_START_STOP = 125
    """Undocumented; by its name, starts or stops a vibration test."""
    CMD_VIBRATION_TEST_DATA = 126
    """Undocumented; by its name, data of a vibration test."""
    CMD_EXT_MOTORS_ACTION = 128
    """Turn external motors on or off, or move them to their home position."""
    CMD_EXT_MOTORS_CONTROL = 129
    """Set targets of external motors."""
    CMD_EXT_MOTORS_CONTROL_CONFIG = 130
    """Configure external motors."""
    CMD_EXT_MOTORS_STATE = 131
    """State of an external motor."""
    CMD_ADJ_VARS_INFO = 132
    """Names, ranges and values of adjustable variables."""
    CMD_SERVO_OUT_EXT = 133
    """Send PWM signals to servos of the board and of its CAN motor drivers."""
    CMD_SET_ADJ_VARS_VAL_F = 134
    """Values of adjustable variables in floating point."""
    CMD_GET_ADJ_VARS_VAL_F = 135
    """Request the values of adjustable variables in floating point."""
    CMD_PASS_PROTECT_READ = 136
    """What a password protects."""
    CMD_PASS_PROTECT_WRITE = 137
    """Choose what a password protects."""
    CMD_REALTIME_DATA_CUSTOM2 = 139
    """More live data of the requested blocks."""
    CMD_CONTROL_QUAT = 140
    """Move the camera, with attitude and speed in space."""
    CMD_CONTROL_QUAT_STATUS = 141
    """State of the control with quaternions."""
    CMD_CONTROL_QUAT_CONFIG = 142
    """Configure the control with quaternions."""
    CMD_SET_TRANSP_PROXY = 143
    """Connect two serial ports of the board."""
    CMD_UDRV_DEVICE_SCAN = 144
    """Devices on the bus of uDrv modules."""
    CMD_EXT_SENS_CMD = 150
    """A message of an external sensor's own protocol."""
    CMD_TRANSPARENT_SAPI = 151
    """Data from a serial port of a device on the CAN bus."""
    CMD_SET_DEBUG_PORT = 249
    """Copy of a message on another port of the board."""
    CMD_MAVLINK_INFO = 250
    """Undocumented; by its name, information about a MAVLink connection."""
    CMD_MAVLINK_DEBUG = 251
    """Undocumented; by its name, debugging of a MAVLink connection."""
    CMD_DEBUG_VARS_INFO_3 = 253
    """Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3."""
    CMD_DEBUG_VARS_3 = 254
    """Values of the debug variables."""


class CommandFromBoard(OpenEnum):
    """The commands of messages from the board."""

    CMD_BOARD_INFO_3 = 20
    """Serial numbers, memory and scripts of the board."""
    CMD_READ_PARAMS_3 = 21
    """Parameters of one profile and general parameters."""
    CMD_REALTIME_DATA_3 = 23
    """Live data."""
    CMD_REALTIME_DATA_4 = 25
    """Live data with joint angles, currents and temperatures."""
    CMD_READ_PROFILE_NAMES = 28
    """Profile names."""
    CMD_QUEUE_PARAMS_INFO_3 = 30
    """Undocumented; possibly describes the adjustable variables, the purpose of CMD_GET_PARAMS_3.
    """
    CMD_SET_ADJ_VARS_VAL = 31
    """Values of adjustable variables."""
    CMD_READ_PARAMS_EXT = 33
    """More parameters of one profile: filters, encoders, magnetometer."""
    CMD_AUTO_PID = 35
    """Tune the PID controllers automatically."""
    CMD_BODE_TEST_START_STOP = 37
    """Record a frequency response."""
    CMD_BODE_TEST_DATA = 38
    """Samples of a frequency response."""
    CMD_I2C_READ_REG_BUF = 40
    """Data from a device on an I2C bus."""
    CMD_READ_EXTERNAL_DATA = 42
    """User data in the EEPROM."""
    CMD_READ_ADJ_VARS_CFG = 43
    """RC signals that trigger actions or change adjustable variables."""
    CMD_ADJ_VARS_STATE = 46
    """Current state of one trigger slot and one analog slot."""
    CMD_EEPROM_READ = 48
    """A block of the EEPROM."""
    CMD_CALIB_INFO = 49
    """Calibration status for display."""
    CMD_SIGN_MESSAGE = 50
    """Signature of a message."""
    CMD_SYSTEM_STATE = 52
    """Undocumented; by its name, the state of the system."""
    CMD_READ_FILE = 53
    """Part of a file."""
    CMD_AHRS_HELPER = 56
    """Attitude of an IMU as two unit vectors."""
    CMD_SCRIPT_DEBUG = 58
    """Progress of a script started with debugging."""
    CMD_UART_BYPASS = 60
    """Undocumented; by its name, connects two serial ports of the board."""
    CMD_GET_ANGLES_EXT = 61
    """Camera angles, targets and joint angles."""
    CMD_READ_PARAMS_EXT2 = 62
    """The third set of parameters of one profile."""
    CMD_CONFIRM = 67
    """The board executed a command."""
    CMD_GET_ANGLES = 73
    """Camera angles and targets."""
    CMD_CALIB_MOTOR_MAG_LINK = 74
    """Undocumented; by its name, calibrates the magnetic linkage of the motors."""
    CMD_MODULE_LIST = 76
    """Modules connected to the board."""
    CMD_READ_PARAMS = 82
    """Older id of CMD_READ_PARAMS_3."""
    CMD_BOARD_INFO = 86
    """Board version and features."""
    CMD_REALTIME_DATA_CUSTOM = 88
    """Live data of the requested blocks."""
    CMD_COGGING_CALIB_INFO = 92
    """Undocumented; by its name, the state of the calibration of the cogging."""
    CMD_CAN_DEVICE_SCAN = 96
    """Devices on the CAN bus."""
    CMD_CAN_DRV_HARD_PARAMS = 97
    """Undocumented; by its name, hardware parameters of a CAN motor driver."""
    CMD_CAN_DRV_STATE = 98
    """Undocumented; by its name, the state of a CAN motor driver."""
    CMD_CAN_DRV_CALIBRATE = 99
    """Undocumented; by its name, calibrates a CAN motor driver."""
    CMD_READ_RC_INPUTS = 100
    """RC signals of selected inputs."""
    CMD_REALTIME_DATA_CAN_DRV = 101
    """Undocumented; by its name, live data of a CAN motor driver."""
    CMD_EVENT = 102
    """An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL."""
    CMD_READ_PARAMS_EXT3 = 104
    """The fourth set of parameters of one profile."""
    CMD_EXT_IMU_DEBUG_INFO = 106
    """State of the attitude estimation and of the external IMU."""
    CMD_SET_DEVICE_ADDR = 107
    """Undocumented; by its name, sets the address of a device."""
    CMD_EXT_IMU_CMD = 110
    """A command of the external IMU's own protocol."""
    CMD_READ_STATE_VARS = 111
    """Statistics of the board's whole life."""
    CMD_SERIAL_PROXY = 113
    """Undocumented; by its name, passes data on to a serial port."""
    CMD_RESET = 114
    """The board restarts."""
    CMD_IMU_ADVANCED_CALIB = 115
    """Undocumented; by its name, calibrates an IMU in an advanced way."""
    CMD_CALIB_ENCODER_LUT = 117
    """Undocumented; by its name, calibrates the correction table of an encoder."""
    CMD_CALIB_ENCODER_LUT_RES = 118
    """Undocumented; by its name, the result of the calibration of an encoder's correction table."""
    CMD_CALIB_CUR_SENS = 120
    """Undocumented; by its name, calibrates the current sensors."""
    CMD_ENC_INT_CALIB = 122
    """Undocumented; by its name, calibrates an encoder internally."""
    CMD_EXT_LICENSE_INFO = 124
    """Undocumented; by its name, information about extended licenses."""
    CMD_VIBRATION_TEST_START_STOP = 125
    """Undocumented; by its name, starts or stops a vibration test."""
    CMD_VIBRATION_TEST_DATA = 126
    """Undocumented; by its name, data of a vibration test."""
    CMD_CAN_DRV_TELEMETRY = 127
    """Live data of a CAN motor driver."""
    CMD_EXT_MOTORS_STATE = 131
    """State of an external motor."""
    CMD_ADJ_VARS_INFO = 132
    """Names, ranges and values of adjustable variables."""
    CMD_SET_ADJ_VARS_VAL_F = 134
    """Values of adjustable variables in floating point."""
    CMD_PASS_PROTECT_READ = 136
    """What a password protects."""
    CMD_REALTIME_DATA_CUSTOM2 = 139
    """More live data of the requested blocks."""
    CMD_CONTROL_QUAT_STATUS = 141
    """State of the control with quaternions."""
    CMD_EXT_SENS_CMD = 150
    """A message of an external sensor's own protocol."""
    CMD_TRANSPARENT_SAPI = 151
    """Data from a serial port of a device on the CAN bus."""
    CMD_SET_DEBUG_PORT = 249
    """Copy of a message on another port of the board."""
    CMD_MAVLINK_INFO = 250
    """Undocumented; by its name, information about a MAVLink connection."""
    CMD_MAVLINK_DEBUG = 251
    """Undocumented; by its name, debugging of a MAVLink connection."""
    CMD_DEBUG_VARS_INFO_3 = 253
    """Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3."""
    CMD_DEBUG_VARS_3 = 254
    """Values of the debug variables."""
    CMD_ERROR = 255
    """The board could not execute a command."""


class VariableId(OpenEnum):
    """The adjustable variables."""

    P_ROLL = 0
    """Proportional gain of roll."""
    P_PITCH = 1
    """Proportional gain of pitch."""
    P_YAW = 2
    """Proportional gain of yaw."""
    I_ROLL = 3
    """Integral gain of roll."""
    I_PITCH = 4
    """Integral gain of pitch."""
    I_YAW = 5
    """Integral gain of yaw."""
    D_ROLL = 6
    """Derivative gain of roll."""
    D_PITCH = 7
    """Derivative gain of pitch."""
    D_YAW = 8
    """Derivative gain of yaw."""
    POWER_ROLL = 9
    """Power of the roll motor."""
    POWER_PITCH = 10
    """Power of the pitch motor."""
    POWER_YAW = 11
    """Power of the yaw motor."""
    ACC_LIMITER = 12
    """Acceleration limit of all axes."""
    FOLLOW_SPEED_ROLL = 13
    """Follow mode speed of roll."""
    FOLLOW_SPEED_PITCH = 14
    """Follow mode speed of pitch."""
    FOLLOW_SPEED_YAW = 15
    """Follow mode speed of yaw."""
    FOLLOW_LPF_ROLL = 16
    """Follow mode low-pass filter of roll."""
    FOLLOW_LPF_PITCH = 17
    """Follow mode low-pass filter of pitch."""
    FOLLOW_LPF_YAW = 18
    """Follow mode low-pass filter of yaw."""
    RC_SPEED_ROLL = 19
    """RC control speed of roll."""
    RC_SPEED_PITCH = 20
    """RC control speed of pitch."""
    RC_SPEED_YAW = 21
    """RC control speed of yaw."""
    RC_LPF_ROLL = 22
    """RC low-pass filter of roll."""
    RC_LPF_PITCH = 23
    """RC low-pass filter of pitch."""
    RC_LPF_YAW = 24
    """RC low-pass filter of yaw."""
    RC_TRIM_ROLL = 25
    """RC trim of roll."""
    RC_TRIM_PITCH = 26
    """RC trim of pitch."""
    RC_TRIM_YAW = 27
    """RC trim of yaw."""
    RC_DEADBAND = 28
    """Dead band around the center of the RC signals."""
    RC_EXPO_RATE = 29
    """Expo rate of the RC signals."""
    FOLLOW_MODE = 30
    """What the camera follows: 0 nothing, 1 the flight controller, 2 pitch and roll of the frame.
    Later firmware calls it FOLLOW_PITCH, from 0 to 1.
    """
    RC_FOLLOW_YAW = 31
    """1 if yaw follows the frame, otherwise 0. Later firmware calls it RC_FOLLOW_YAW_PITCH, from 0
    to 2.
    """
    FOLLOW_DEADBAND = 32
    """Dead band of the follow mode."""
    FOLLOW_EXPO_RATE = 33
    """Expo rate of the follow mode."""
    FOLLOW_ROLL_MIX_START = 34
    """Angle at which pitch starts to follow roll."""
    FOLLOW_ROLL_MIX_RANGE = 35
    """Angle over which pitch continues to follow roll."""
    GYRO_TRUST = 36
    """Trust in the gyroscope relative to the accelerometer."""
    FRAME_HEADING_ANGLE = 37
    """Heading of the frame; in later firmware 32767 has a special meaning."""
    GYRO_HEADING_CORRECTION = 38
    """Gyroscope correction about the vertical."""
    ACC_LIMITER_ROLL = 39
    """Acceleration limit of roll."""
    ACC_LIMITER_PITCH = 40
    """Acceleration limit of pitch."""
    ACC_LIMITER_YAW = 41
    """Acceleration limit of yaw."""
    PID_GAIN_ROLL = 42
    """Factor for P, I and D of roll."""
    PID_GAIN_PITCH = 43
    """Factor for P, I and D of pitch."""
    PID_GAIN_YAW = 44
    """Factor for P, I and D of yaw."""
    LPF_FREQ_ROLL = 45
    """Low-pass filter of roll."""
    LPF_FREQ_PITCH = 46
    """Low-pass filter of pitch."""
    LPF_FREQ_YAW = 47
    """Low-pass filter of yaw."""
    TIMELAPSE_TIME = 48
    """Duration of a time lapse. Since firmware 2.60."""
    MAV_CTRL_MODE = 49
    """What MAVLink controls: 0 nothing, 1 roll and pitch, 2 all axes. Since firmware 2.66."""
    H_CORR_FACTOR = 50
    """Strength of the heading correction. Since firmware 2.68b7."""
    SW_LIM_MIN_ROLL = 51
    """Lowest angle of the roll joint. Since firmware 2.68b8."""
    SW_LIM_MAX_ROLL = 52
    """Highest angle of the roll joint. Since firmware 2.68b8."""
    SW_LIM_MIN_PITCH = 53
    """Lowest angle of the pitch joint. Since firmware 2.68b8."""
    SW_LIM_MAX_PITCH = 54
    """Highest angle of the pitch joint. Since firmware 2.68b8."""
    SW_LIM_MIN_YAW = 55
    """Lowest angle of the yaw joint. Since firmware 2.68b8."""
    SW_LIM_MAX_YAW = 56
    """Highest angle of the yaw joint. Since firmware 2.68b8."""
    FOLLOW_RANGE_ROLL = 57
    """Range of the follow mode of roll. Since firmware 2.68b9."""
    FOLLOW_RANGE_PITCH = 58
    """Range of the follow mode of pitch. Since firmware 2.68b9."""
    FOLLOW_RANGE_YAW = 59
    """Range of the follow mode of yaw. Since firmware 2.68b9."""
    AUTO_PID_TARGET = 60
    """Target of the automatic PID tuning. Since firmware 2.68b9."""
    RC_MODE_ROLL = 61
    """What the RC signal of roll controls, as in RC_MODE. Since firmware 2.69b3."""
    RC_MODE_PITCH = 62
    """What the RC signal of pitch controls, as in RC_MODE. Since firmware 2.69b3."""
    RC_MODE_YAW = 63
    """What the RC signal of yaw controls, as in RC_MODE. Since firmware 2.69b3."""
    EULER_ORDER = 64
    """Order of the Euler angles. Since firmware 2.69b3."""
    FOLLOW_IN_DBAND = 65
    """How much to follow inside the follow mode's dead band. Since firmware 2.70b4."""
    RC_LIMIT_MIN_ROLL = 66
    """Angle of roll at the lowest RC signal. Since firmware 2.72."""
    RC_LIMIT_MAX_ROLL = 67
    """Angle of roll at the highest RC signal. Since firmware 2.72."""
    RC_LIMIT_MIN_PITCH = 68
    """Angle of pitch at the lowest RC signal. Since firmware 2.72."""
    RC_LIMIT_MAX_PITCH = 69
    """Angle of pitch at the highest RC signal. Since firmware 2.72."""
    RC_LIMIT_MIN_YAW = 70
    """Angle of yaw at the lowest RC signal. Since firmware 2.72."""
    RC_LIMIT_MAX_YAW = 71
    """Angle of yaw at the highest RC signal. Since firmware 2.72."""
    RC_DEADBAND_PITCH = 72
    """Dead band around the center of the RC signal of pitch. Since firmware 2.72."""
    RC_DEADBAND_YAW = 73
    """Dead band around the center of the RC signal of yaw. Since firmware 2.72."""
    RC_EXPO_RATE_PITCH = 74
    """Expo rate of the RC signal of pitch. Since firmware 2.72."""
    RC_EXPO_RATE_YAW = 75
    """Expo rate of the RC signal of yaw. Since firmware 2.72."""
    SHAKE_AMP_ROLL = 76
    """Amplitude of the shake generator in roll. Since firmware 2.73."""
    SHAKE_AMP_TILT = 77
    """Amplitude of the shake generator in tilt. Since firmware 2.73."""
    SHAKE_AMP_PAN = 78
    """Amplitude of the shake generator in pan. Since firmware 2.73."""
    SHAKE_FREQ = 79
    """Base frequency of the shake generator. Since firmware 2.73."""
    SHAKE_FREQ_RANGE = 80
    """Frequency range of the shake generator. Since firmware 2.73."""
    SHAKE_PAUSE_PERIOD = 81
    """Period of the pauses of the shake generator. Since firmware 2.73."""
    SHAKE_PAUSE_BALANCE = 82
    """Share of the pauses of the shake generator. Since firmware 2.73."""
    SHAKE_PAUSE_RANDOMNESS = 83
    """Randomness of the pauses of the shake generator. Since firmware 2.73."""
    SHAKE_RESONANCE_GAIN_ROLL = 84
    """Gain of the shake generator's resonance in roll. Since firmware 2.73."""
    SHAKE_RESONANCE_GAIN_TILT = 85
    """Gain of the shake generator's resonance in tilt. Since firmware 2.73."""
    SHAKE_RESONANCE_GAIN_PAN = 86
    """Gain of the shake generator's resonance in pan. Since firmware 2.73."""
    SHAKE_FREQ_SHIFT_ROLL = 87
    """Shift of the shake generator's frequency in roll. Since firmware 2.73."""
    SHAKE_FREQ_SHIFT_TILT = 88
    """Shift of the shake generator's frequency in tilt. Since firmware 2.73."""
    SHAKE_FREQ_SHIFT_PAN = 89
    """Shift of the shake generator's frequency in pan. Since firmware 2.73."""
    SHAKE_MASTER_GAIN = 90
    """Gain of the shake generator in all directions. Since firmware 2.73."""
    OUTER_P_ROLL = 91
    """Proportional gain of the outer loop of roll. Since firmware 2.73.7."""
    OUTER_P_PITCH = 92
    """Proportional gain of the outer loop of pitch. Since firmware 2.73.7."""
    OUTER_P_YAW = 93
    """Proportional gain of the outer loop of yaw. Since firmware 2.73.7."""
    D_LPF_FREQ_ROLL = 94
    """Low-pass filter of the derivative term of roll. Since firmware 2.73.7."""
    D_LPF_FREQ_PITCH = 95
    """Low-pass filter of the derivative term of pitch. Since firmware 2.73.7."""
    D_LPF_FREQ_YAW = 96
    """Low-pass filter of the derivative term of yaw. Since firmware 2.73.7."""
    IMU_ANGLE_CORR_ROLL = 97
    """Correction of the roll angle of the IMU. Since firmware 2.73.8."""
    IMU_ANGLE_CORR_PITCH = 98
    """Correction of the pitch angle of the IMU. Since firmware 2.73.8."""
    SW_LIM_WIDTH_ROLL = 99
    """Width of the soft limits of the roll joint. Since firmware 2.73.8."""
    SW_LIM_WIDTH_PITCH = 100
    """Width of the soft limits of the pitch joint. Since firmware 2.73.8."""
    SW_LIM_WIDTH_YAW = 101
    """Width of the soft limits of the yaw joint. Since firmware 2.73.8."""


class BoardErrorCode(OpenEnum):
    """Reason that the board did not execute a command."""

    CMD_SIZE = 1
    """The command has no body of this size."""
    WRONG_PARAMS = 2
    """A value is invalid."""
    GET_DEVICE_ID = 3
    """The board cannot read its device id. Unconfirmed."""
    CRYPTO = 4
    """A key or signature check failed."""
    CALIBRATE_BAT = 5
    """The calibration of the battery voltage failed. Unconfirmed."""
    UNKNOWN_COMMAND = 6
    """The board does not know the command."""
    WRONG_STATE = 8
    """Not possible in the current state."""
    NOT_SUPPORTED = 9
    """The board lacks a feature that the command requires."""
    OPERATION_FAILED = 10
    """The board tried and failed."""
    TEMPORARY = 11
    """Temporarily not possible; retry later."""


class RcModeKind(OpenEnum):
    """What an RC signal controls."""

    RC_MODE_ANGLE = 0
    """The angle of the camera."""
    RC_MODE_SPEED = 1
    """The speed of the camera."""


class PwmFrequency(OpenEnum):
    """PWM frequency of the motor drivers."""

    PWM_FREQ_LOW = 0
    """Low."""
    PWM_FREQ_HIGH = 1
    """High."""
    PWM_FREQ_ULTRA_HIGH = 2
    """Ultra high. Since board 3.0."""


class SerialSpeed(OpenEnum):
    """Baud rate of the serial port."""

    BAUD_115200 = 0
    """115200 baud."""
    BAUD_57600 = 1
    """57600 baud."""
    BAUD_38400 = 2
    """38400 baud."""
    BAUD_19200 = 3
    """19200 baud."""
    BAUD_9600 = 4
    """9600 baud."""
    BAUD_256000 = 5
    """256000 baud."""


class RcVirtualMode(OpenEnum):
    """Signal at the RC_ROLL input pin."""

    RC_VIRT_MODE_NORMAL = 0
    """One PWM signal."""
    RC_VIRT_MODE_CPPM = 1
    """Sum-PPM."""
    RC_VIRT_MODE_SBUS = 2
    """S.BUS. Since board 3.0."""
    RC_VIRT_MODE_SPEKTRUM = 3
    """Spektrum satellite. Since board 3.0."""
    RC_VIRT_MODE_API = 10
    """A serial port on the pins RC_ROLL and RC_YAW. Since board 3.0."""


class RcInput(OpenEnum):
    """Named inputs of RC_MAP: pins for PWM or an analog voltage."""

    INPUT_NO = 0
    """No input."""
    RC_INPUT_ROLL = 1
    """PWM at the RC_ROLL pin."""
    RC_INPUT_PITCH = 2
    """PWM at the RC_PITCH pin."""
    EXT_FC_INPUT_ROLL = 3
    """PWM at the FC_ROLL pin."""
    EXT_FC_INPUT_PITCH = 4
    """PWM at the FC_PITCH pin."""
    RC_INPUT_YAW = 5
    """PWM at the RC_YAW pin. Since board 3.0."""
    ADC1 = 33
    """Analog input 1; RC_INPUT_ROLL on older boards. Since board 3.0."""
    ADC2 = 34
    """Analog input 2; RC_INPUT_PITCH on older boards. Since board 3.0."""
    ADC3 = 35
    """Analog input 3; EXT_FC_INPUT_ROLL on older boards. Since board 3.0."""
    ADC4 = 36
    """Analog input 4; EXT_FC_INPUT_PITCH on older boards."""


class RcSource(OpenEnum):
    """Kind of signal selected by RC_MAP."""

    PWM = 0
    """A PWM signal."""
    ANALOG = 32
    """An analog voltage."""
    SERIAL = 64
    """A virtual channel of Sum-PPM, S.BUS or Spektrum."""
    API = 128
    """A virtual channel that CMD_API_VIRT_CH_CONTROL sets."""
    STEP_SIGNAL = 160
    """A step signal, 1 to 6."""


class MixTarget(OpenEnum):
    """RC channel into which a flight controller's signal is mixed."""

    NO_MIX = 0
    """None."""
    ROLL = 1
    """Roll."""
    PITCH = 2
    """Pitch."""
    YAW = 3
    """Yaw."""


class FollowMode(OpenEnum):
    """What the camera follows."""

    FOLLOW_MODE_DISABLED = 0
    """Nothing."""
    FOLLOW_MODE_FC = 1
    """The flight controller."""
    FOLLOW_MODE_PITCH = 2
    """Pitch and roll of the frame."""


class SensorAxis(OpenEnum):
    """Direction of a sensor's axis."""

    X = 1
    """X axis."""
    Y = 2
    """Y axis."""
    Z = 3
    """Z axis."""
    MINUS_X = -1
    """Against the X axis."""
    MINUS_Y = -2
    """Against the Y axis."""
    MINUS_Z = -3
    """Against the Z axis."""


class FrameImuPosition(OpenEnum):
    """Location of the frame IMU."""

    FRAME_IMU_DISABLED = 0
    """There is none."""
    FRAME_IMU_BELOW_YAW = 1
    """Below the yaw motor."""
    FRAME_IMU_ABOVE_YAW = 2
    """Above the yaw motor."""
    FRAME_IMU_BELOW_YAW_PID_SOURCE = 3
    """Below the yaw motor, and the input of the PID controller."""


class SkipGyroCalibration(OpenEnum):
    """Gyroscope calibration at start-up."""

    DO_NOT_SKIP = 0
    """Calibrate."""
    SKIP_ALWAYS = 1
    """Never calibrate."""
    SKIP_IF_MOVING = 2
    """Calibrate unless the board moves."""


class MenuCommand(OpenEnum):
    """Actions of the menu button, an RC signal or CMD_EXECUTE_MENU."""

    MENU_CMD_NO = 0
    """Nothing."""
    MENU_CMD_PROFILE1 = 1
    """Switch to profile 1."""
    MENU_CMD_PROFILE2 = 2
    """Switch to profile 2."""
    MENU_CMD_PROFILE3 = 3
    """Switch to profile 3."""
    MENU_CMD_SWAP_PITCH_ROLL = 4
    """Swap the RC signals of pitch and roll."""
    MENU_CMD_SWAP_YAW_ROLL = 5
    """Swap the RC signals of yaw and roll."""
    MENU_CMD_CALIB_ACC = 6
    """Calibrate the accelerometer."""
    MENU_CMD_RESET = 7
    """Restart the board."""
    MENU_CMD_SET_ANGLE = 8
    """Make the current angle the initial angle."""
    MENU_CMD_CALIB_GYRO = 9
    """Calibrate the gyroscope."""
    MENU_CMD_MOTOR_TOGGLE = 10
    """Turn the motors on or off."""
    MENU_CMD_MOTOR_ON = 11
    """Turn the motors on."""
    MENU_CMD_MOTOR_OFF = 12
    """Turn the motors off."""
    MENU_CMD_FRAME_UPSIDE_DOWN = 13
    """Treat the frame as upside down."""
    MENU_CMD_PROFILE4 = 14
    """Switch to profile 4."""
    MENU_CMD_PROFILE5 = 15
    """Switch to profile 5."""
    MENU_CMD_AUTO_PID = 16
    """Tune the PID controllers."""
    MENU_CMD_LOOK_DOWN = 17
    """Point the camera downwards."""
    MENU_CMD_HOME_POSITION = 18
    """Return the camera to its home position."""
    MENU_CMD_RC_BIND = 19
    """Bind an RC receiver."""
    MENU_CMD_CALIB_GYRO_TEMP = 20
    """Calibrate the gyroscope over temperature."""
    MENU_CMD_CALIB_ACC_TEMP = 21
    """Calibrate the accelerometer over temperature."""
    MENU_CMD_BUTTON_PRESS = 22
    """Press the menu button."""
    MENU_CMD_RUN_SCRIPT1 = 23
    """Run script 1."""
    MENU_CMD_RUN_SCRIPT2 = 24
    """Run script 2."""
    MENU_CMD_RUN_SCRIPT3 = 25
    """Run script 3."""
    MENU_CMD_RUN_SCRIPT4 = 26
    """Run script 4."""
    MENU_CMD_RUN_SCRIPT5 = 27
    """Run script 5."""
    MENU_CMD_RUN_SCRIPT6 = 28
    """Run script 6. Unconfirmed."""
    MENU_CMD_RUN_SCRIPT7 = 29
    """Run script 7. Unconfirmed."""
    MENU_CMD_RUN_SCRIPT8 = 30
    """Run script 8. Unconfirmed."""
    MENU_CMD_RUN_SCRIPT9 = 31
    """Run script 9. Unconfirmed."""
    MENU_CMD_RUN_SCRIPT10 = 32
    """Run script 10. Unconfirmed."""
    MENU_CMD_CALIB_MAG = 33
    """Calibrate the magnetometer."""
    MENU_CMD_LEVEL_ROLL_PITCH = 34
    """Level roll and pitch."""
    MENU_CMD_CENTER_YAW = 35
    """Center yaw."""
    MENU_CMD_UNTWIST_CABLES = 36
    """Turn back to untwist the cables."""
    MENU_CMD_SET_ANGLE_NO_SAVE = 37
    """Make the current angle the initial angle, without saving it."""
    MENU_CMD_HOME_POSITION_SHORTEST = 38
    """Return the camera to its home position by the shortest way."""
    MENU_CMD_CENTER_YAW_SHORTEST = 39
    """Center yaw by the shortest way."""
    MENU_CMD_ROTATE_YAW_180 = 40
    """Turn yaw by half a turn."""
    MENU_CMD_ROTATE_YAW_180_FRAME_REL = 41
    """Turn yaw by half a turn relative to the frame."""
    MENU_CMD_SWITCH_YAW_180_FRAME_REL = 42
    """Switch yaw between forwards and backwards relative to the frame."""
    MENU_CMD_SWITCH_POS_ROLL_90 = 43
    """Switch roll between two positions 90 degrees apart."""
    MENU_CMD_START_TIMELAPSE = 44
    """Start a time-lapse motion."""
    MENU_CMD_CALIB_MOMENTUM = 45
    """Calibrate the momentum of the axes."""
    MENU_CMD_LEVEL_ROLL = 46
    """Level roll."""
    MENU_CMD_REPEAT_TIMELAPSE = 47
    """Repeat the time-lapse motion."""
    MENU_CMD_LOAD_PROFILE_SET1 = 48
    """Load profile set 1."""
    MENU_CMD_LOAD_PROFILE_SET2 = 49
    """Load profile set 2."""
    MENU_CMD_LOAD_PROFILE_SET3 = 50
    """Load profile set 3."""
    MENU_CMD_LOAD_PROFILE_SET4 = 51
    """Load profile set 4."""
    MENU_CMD_LOAD_PROFILE_SET5 = 52
    """Load profile set 5."""
    MENU_CMD_LOAD_PROFILE_SET_BACKUP = 53
    """Load the backup profile set."""
    MENU_CMD_INVERT_RC_ROLL = 54
    """Invert the RC signal of roll."""
    MENU_CMD_INVERT_RC_PITCH = 55
    """Invert the RC signal of pitch."""
    MENU_CMD_INVERT_RC_YAW = 56
    """Invert the RC signal of yaw."""
    MENU_CMD_SNAP_TO_FIXED_POSITION = 57
    """Move to the nearest fixed position."""
    MENU_CMD_CAMERA_REC_PHOTO_EVENT = 58
    """Send a CMD_EVENT for the camera, to record a video or take a photo."""
    MENU_CMD_CAMERA_PHOTO_EVENT = 59
    """Send a CMD_EVENT for the camera, to take a photo."""
    MENU_CMD_MOTORS_SAFE_STOP = 60
    """Stop the motors safely, then turn them off."""
    MENU_CMD_CALIB_ACC_AUTO = 61
    """Calibrate the accelerometer automatically."""
    MENU_CMD_RESET_IMU = 62
    """Reset the IMU."""
    MENU_CMD_FORCED_FOLLOW_TOGGLE = 63
    """Turn the forced follow mode on or off."""
    MENU_CMD_AUTO_PID_GAIN_ONLY = 64
    """Tune the PID controllers, but only their gain."""
    MENU_CMD_LEVEL_PITCH = 65
    """Level pitch."""
    MENU_CMD_MOTORS_SAFE_TOGGLE = 66
    """Turn the motors on, or stop them safely and turn them off."""
    MENU_CMD_TIMELAPSE_STEP1 = 67
    """Do the first step of a time-lapse motion."""
    MENU_CMD_EXT_GYRO_ONLINE_CALIB = 68
    """Calibrate the external gyroscope during operation."""
    MENU_CMD_DISABLE_FOLLOW_TOGGLE = 69
    """Turn the follow mode off or on again."""
    MENU_CMD_SET_CUR_POS_AS_HOME = 70
    """Make the current position the home position."""
    MENU_CMD_STOP_SCRIPT = 71
    """Stop the running script."""
    MENU_CMD_TRIPOD_MODE_OFF = 72
    """Turn the tripod mode off."""
    MENU_CMD_TRIPOD_MODE_ON = 73
    """Turn the tripod mode on."""
    MENU_CMD_SET_RC_TRIM = 74
    """Set the RC trim to the current signals."""
    MENU_CMD_HOME_POSITION_MOTORS = 75
    """Return the motors to their home positions."""
    MENU_CMD_RETRACTED_POSITION = 76
    """Move to the retracted position."""
    MENU_CMD_SHAKE_GENERATOR_OFF = 77
    """Turn the shake generator off."""
    MENU_CMD_SHAKE_GENERATOR_ON = 78
    """Turn the shake generator on."""
    MENU_CMD_SERVO_MODE_ON = 79
    """Turn the servo mode on."""
    MENU_CMD_SERVO_MODE_OFF = 80
    """Turn the servo mode off."""
    MENU_CMD_SERVO_MODE_TOGGLE = 81
    """Turn the servo mode on or off."""


class MotorOutput(OpenEnum):
    """Motor output that drives an axis."""

    DISABLED = 0
    """None."""
    ROLL = 1
    """The ROLL output."""
    PITCH = 2
    """The PITCH output."""
    YAW = 3
    """The YAW output."""
    I2C_DRV1 = 4
    """The first motor driver on the I2C bus."""
    I2C_DRV2 = 5
    """The second motor driver on the I2C bus."""
    I2C_DRV3 = 6
    """The third motor driver on the I2C bus."""
    I2C_DRV4 = 7
    """The fourth motor driver on the I2C bus."""


class SelectedImu(OpenEnum):
    """Which IMU is selected."""

    IMU_TYPE_MAIN = 1
    """The main IMU on the camera."""
    IMU_TYPE_FRAME = 2
    """The IMU on the frame."""


class SpektrumMode(OpenEnum):
    """Protocol of a Spektrum satellite."""

    AUTO = 0
    """Detected."""
    DSM2_11MS_10BIT = 1
    """DSM2, 11 ms, 10 bits."""
    DSM2_11MS_11BIT = 2
    """DSM2, 11 ms, 11 bits."""
    DSM2_22MS_10BIT = 3
    """DSM2, 22 ms, 10 bits."""
    DSM2_22MS_11BIT = 4
    """DSM2, 22 ms, 11 bits."""
    DSMX_11MS_10BIT = 5
    """DSMX, 11 ms, 10 bits."""
    DSMX_11MS_11BIT = 6
    """DSMX, 11 ms, 11 bits."""
    DSMX_22MS_10BIT = 7
    """DSMX, 22 ms, 10 bits."""
    DSMX_22MS_11BIT = 8
    """DSMX, 22 ms, 11 bits."""


class AxisOrder(OpenEnum):
    """Order of the motor axes, counted from the camera."""

    PITCH_ROLL_YAW = 0
    """Pitch, roll, yaw."""
    YAW_ROLL_PITCH = 1
    """Yaw, roll, pitch."""
    ROLL_YAW_PITCH = 2
    """Roll, yaw, pitch; not implemented."""
    ROLL_PITCH_YAW = 3
    """Roll, pitch, yaw."""


class EulerOrder(OpenEnum):
    """Order of the Euler angles of camera and target."""

    PITCH_ROLL_YAW = 0
    """Pitch, roll, yaw."""
    ROLL_PITCH_YAW = 1
    """Roll, pitch, yaw."""
    LOCAL_ROLL = 2
    """Local, roll; for two-axis systems. Later: pitch of the motor, roll, yaw of the motor."""
    ROLL_LOCAL = 3
    """Roll, local; for two-axis systems. Later: roll, pitch of the motor, yaw of the motor."""
    YAW_ROLL_PITCH = 4
    """Yaw, roll, pitch."""
    YAW_PITCH_ROLL = 5
    """Yaw, pitch, roll."""


class ProfileSetAction(OpenEnum):
    """Operation on a profile set."""

    SAVE = 1
    """Save the parameters in use as a profile set."""
    CLEAR = 2
    """Clear the profile set."""
    LOAD = 3
    """Load the profile set."""


class EncoderModel(OpenEnum):
    """Kind of encoder."""

    ENC_TYPE_AS5048A = 1
    """AS5048A, over SPI."""
    ENC_TYPE_AS5048B = 2
    """AS5048B, over I2C."""
    ENC_TYPE_AS5048_PWM = 3
    """AS5048, over PWM."""
    ENC_TYPE_AMT203 = 4
    """AMT203."""
    ENC_TYPE_MA3_10BIT = 5
    """MA3 with 10 bits."""
    ENC_TYPE_MA3_12BIT = 6
    """MA3 with 12 bits."""
    ENC_TYPE_ANALOG = 7
    """Analog."""
    ENC_TYPE_I2C_DRV1 = 8
    """I2C driver 1."""
    ENC_TYPE_I2C_DRV2 = 9
    """I2C driver 2."""
    ENC_TYPE_I2C_DRV3 = 10
    """I2C driver 3."""
    ENC_TYPE_I2C_DRV4 = 11
    """I2C driver 4."""
    ENC_TYPE_AS5600_PWM = 12
    """AS5600, over PWM."""
    ENC_TYPE_AS5600_I2C = 13
    """AS5600, over I2C."""
    ENC_TYPE_RLS_ORBIS = 14
    """RLS Orbis."""
    ENC_TYPE_RLS_ORBIS_PWM = 15
    """RLS Orbis, over PWM."""


class EncoderConfig(OpenEnum):
    """Clock of an SPI encoder; for an I2C driver, the kind of encoder in it."""

    SPI_SPEED_1MHz = 0
    """SPI clock of 1 MHz."""
    SPI_SPEED_2MHz = 1
    """SPI clock of 2 MHz."""
    SPI_SPEED_4MHz = 2
    """SPI clock of 4 MHz."""
    SPI_SPEED_500kHz = 3
    """SPI clock of 500 kHz."""


class BoardPort(OpenEnum):
    """Serial port of the board."""

    DISABLED = 0
    """None."""
    UART1 = 1
    """UART 1."""
    RC_SERIAL = 2
    """The serial RC input."""
    UART2 = 3
    """UART 2."""
    USB_VCP = 4
    """The virtual port of the USB connection."""


class MavControlMode(OpenEnum):
    """Axes that a MAVLink host controls."""

    DISABLED = 0
    """None."""
    ROLL_PITCH = 1
    """Roll and pitch."""
    ALL_AXES = 2
    """All."""


class StabilizedAxis(OpenEnum):
    """Axis that a motor stabilizes."""

    STAB_AXIS_DEFAULT = 0
    """The axis of the motor."""
    STAB_AXIS_ROLL = 1
    """Roll."""
    STAB_AXIS_PITCH = 2
    """Pitch."""
    STAB_AXIS_YAW = 3
    """Yaw."""


class SnapAngle(OpenEnum):
    """Distance between the fixed positions of an axis."""

    SNAP_ANGLE_0 = 0
    """0 degrees."""
    SNAP_ANGLE_45 = 1
    """45 degrees."""
    SNAP_ANGLE_90 = 2
    """90 degrees."""
    SNAP_ANGLE_180 = 3
    """180 degrees."""


class StepCount(OpenEnum):
    """Number of steps of a step signal."""

    STEPS_2 = 0
    """2 steps."""
    STEPS_3 = 1
    """3 steps."""
    STEPS_5 = 2
    """5 steps."""
    STEPS_10 = 3
    """10 steps."""
    STEPS_15 = 4
    """15 steps."""
    STEPS_25 = 5
    """25 steps."""
    STEPS_50 = 6
    """50 steps."""
    STEPS_100 = 7
    """100 steps."""


class StepTrigger(OpenEnum):
    """Level of an RC signal that triggers a step."""

    LEVEL_LOW = 0
    """Low."""
    LEVEL_HIGH = 1
    """High."""
    LEVEL_LOW_HIGH = 2
    """Low and high."""


class WriteParamsAction(OpenEnum):
    """Begin or end of a series of writes."""

    FINISH = 0
    """The series ends."""
    START = 1
    """The series begins."""


class ExtImuModel(OpenEnum):
    """Model of the external IMU."""

    MAVLINK1 = 1
    """Any, over MAVLink 1."""
    MAVLINK2 = 2
    """Any, over MAVLink 2."""
    VECTORNAV_VN200 = 3
    """VectorNav VN-200."""
    INERTIALSENSE_UAHRS = 4
    """Inertial Sense uAHRS."""


class ExtImuPosition(OpenEnum):
    """Location of the external IMU."""

    BELOW_OUTER = 1
    """Below the outer motor."""
    ABOVE_OUTER = 2
    """Above the outer motor."""
    BELOW_MIDDLE = 8
    """Below the middle motor."""
    MAIN_IMU = 9
    """At the main IMU."""


class ExtImuAxis(OpenEnum):
    """Direction of an axis of the external IMU."""

    X = 0
    """X axis."""
    Y = 1
    """Y axis."""
    Z = 2
    """Z axis."""
    MINUS_X = 3
    """Against the X axis."""
    MINUS_Y = 4
    """Against the Y axis."""
    MINUS_Z = 5
    """Against the Z axis."""


class MultiTurn(OpenEnum):
    """Number of bits in which an encoder counts its turns."""

    MULTI_TURN_NO = 0
    """It does not count turns."""
    MULTI_TURN_12 = 1
    """12 bits."""
    MULTI_TURN_16 = 2
    """16 bits."""
    MULTI_TURN_20 = 3
    """20 bits."""
    MULTI_TURN_24 = 4
    """24 bits."""


class CanImuSensor(OpenEnum):
    """External sensor of the CAN IMU."""

    DISABLED = 0
    """None."""
    KVH_1725 = 1
    """KVH 1725."""
    KVH_1750_ACC_2G = 2
    """KVH 1750, accelerometer up to 2 g."""
    KVH_1750_ACC_10G = 3
    """KVH 1750, accelerometer up to 10 g."""
    KVH_1750_ACC_30G = 4
    """KVH 1750, accelerometer up to 30 g."""
    KVH_1775_ACC_10G = 5
    """KVH 1775, accelerometer up to 10 g."""
    KVH_1775_ACC_25G = 6
    """KVH 1775, accelerometer up to 25 g."""
    KVH_1760 = 7
    """KVH 1760."""
    ADXRS453 = 8
    """ADXRS453."""
    ADIS16460 = 9
    """ADIS16460."""
    STIM210 = 10
    """STIM210."""
    STIM300 = 11
    """STIM300."""
    SCHA63X = 12
    """SCHA63x."""
    VECTORNAV_VN100_200_UART = 64
    """VectorNav VN-100 or VN-200, over a UART."""
    VECTORNAV_VN100_200_SPI = 65
    """VectorNav VN-100 or VN-200, over SPI."""


class InputState(OpenEnum):
    """State of an input."""

    LOW = 0
    """Low."""
    HIGH = 1
    """High."""
    UNAVAILABLE = 2
    """Unavailable or not assigned."""


class SystemSubError(OpenEnum):
    """Reason for an emergency stop."""

    NONE = 0
    """No emergency stop."""
    SUB_ERR_I2C_ERRORS = 1
    """Too many errors on the I2C bus."""
    SUB_ERR_DRV_OTW = 2
    """A motor driver reports an overtemperature warning."""
    SUB_ERR_DRV_FAULT = 3
    """A motor driver failed."""
    SUB_ERR_ENCODER_IMU_ANGLE = 4
    """Encoder and IMU disagree."""
    SUB_ERR_CALIBRATION_FAILED = 5
    """A calibration failed."""
    SUB_ERR_INTERNAL_SYSTEM_ERROR = 6
    """Internal error."""
    SUB_ERR_ENCODER_CALIB_BAD_SCALE = 7
    """The scale of an encoder is wrong."""
    SUB_ERR_OVER_TEMPERATURE = 8
    """Overtemperature."""
    SUB_ERR_BAD_MOTOR_POLES_INVERT = 9
    """Wrong poles or direction of a motor."""
    SUB_ERR_NOT_ENOUGH_MEMORY = 10
    """Out of memory."""
    SUB_ERR_IMU_SENSOR_NOT_RESPONDING = 11
    """The IMU sensor does not respond."""
    SUB_ERR_CAN_HARD = 12
    """The hardware of the CAN bus failed."""
    SUB_ERR_MOTOR_OVERHEAT_PROTECTION = 13
    """A motor overheated."""
    SUB_ERR_MOTOR_IS_LOCKED = 14
    """A motor cannot turn."""
    SUB_ERR_BAD_IMU_HEALTH = 15
    """The IMU sensor is unreliable."""
    SUB_ERR_INFINITE_RESET = 16
    """The board restarts again and again."""
    SUB_ERR_WRONG_INITIAL_POSITION = 17
    """The position at start-up is wrong."""
    SUB_ERR_MOTOR_LOAD_TIME_EXCEEDED = 18
    """A motor was overloaded for too long."""
    SUB_ERR_CAN_DRV_OVERCURRENT = 19
    """Overcurrent in a CAN motor driver."""
    SUB_ERR_CAN_DRV_UNDERVOLTAGE = 20
    """Undervoltage in a CAN motor driver."""
    SUB_ERR_CAN_DRV_EMERGENCY_PIN = 21
    """The emergency pin of a CAN motor driver is active."""
    SUB_ERR_CAN_DRV_FOC_DURATION = 22
    """The motor control of a CAN motor driver takes too long."""
    SUB_ERR_CAN_DRV_MCU_OVERHEAT = 23
    """The microcontroller of a CAN motor driver overheated."""
    SUB_ERR_CAN_DRV_MOTOR_OVERHEAT = 24
    """A motor of a CAN motor driver overheated."""
    SUB_ERR_CAN_DRV_OVERCURRENT_SOFT = 25
    """The software of a CAN motor driver detected an overcurrent."""
    SUB_ERR_CAN_DRV_SEVERAL = 26
    """Several CAN motor drivers failed."""
    SUB_ERR_CAN_EXT_BUS_OFF = 27
    """The external CAN bus is off."""
    SUB_ERR_CAN_INT_BUS_OFF = 28
    """The internal CAN bus is off."""
    SUB_ERR_ENCODER_NOT_FOUND = 29
    """An encoder is missing."""
    SUB_ERR_CAN_DRV_NOT_RESPONDING = 30
    """A CAN motor driver does not respond."""
    SUB_ERR_CAN_DRV_WRONG_PARAMS = 31
    """Parameters of a CAN motor driver are wrong."""
    SUB_ERR_OVERCURRENT = 32
    """Overcurrent."""
    SUB_ERR_UNSAFE_VOLTAGE = 33
    """The supply voltage is unsafe."""
    SUB_ERR_WRONG_FULL_BAT_VOLTAGE_PARAM = 34
    """The parameter for the voltage of a full battery is wrong."""
    SUB_ERR_EEPROM_PARAMS_CORRUPTED = 35
    """The parameters in the EEPROM are damaged."""
    SUB_ERR_ENCODER_UNSUPPORTED_TYPE = 36
    """The kind of encoder is not supported."""
    SUB_ERR_EXT_IMU_UNSUPPORTED_TYPE = 37
    """The kind of external IMU is not supported."""
    SUB_ERR_EXT_IMU_SENSOR_NOT_RESPONDING = 38
    """The external IMU does not respond."""
    SUB_ERR_EXT_IMU_WRONG_PARAMS = 39
    """Parameters of the external IMU are wrong."""
    SUB_ERR_DRIVER_INIT = 40
    """A motor driver cannot be initialized."""
    SUB_ERR_EEPROM_VARS_OUT_OF_BORDERS = 41
    """Variables in the EEPROM are out of range."""
    SUB_ERR_IWDG_RESET = 42
    """The watchdog restarted the board."""
    SUB_ERR_ADC_WAIT = 43
    """The analog-to-digital converter does not respond."""
    SUB_ERR_CALIB_MOTOR_OFF = 44
    """The motors were off during a calibration."""
    SUB_ERR_TIMEOUT = 45
    """Timeout."""
    SUB_ERR_CAN_DRV_CALIB_UNEXPECTED_RES = 46
    """The calibration of a CAN motor driver had an unexpected result."""
    SUB_ERR_MAG_SENSOR_NOT_RESPONDING = 47
    """The magnetometer does not respond."""
    SUB_ERR_CAN_DRV_OVERSPEED = 48
    """A motor of a CAN motor driver is too fast."""
    SUB_ERR_ENC_SELF_CALIB_FAILED = 49
    """The self-calibration of an encoder failed."""
    SUB_ERR_CAN_VERSION_MISMATCH = 50
    """The firmware of a CAN device does not match."""
    SUB_ERR_CAN_SERIAL_INIT = 51
    """The serial port over CAN cannot be initialized."""
    SUB_ERR_CAN_SERIAL_CONFLICT = 52
    """Serial ports over CAN conflict."""
    SUB_ERR_CAN_DRV_INIT_STAGE = 53
    """The start-up of a CAN motor driver failed."""
    SUB_ERR_ENCODER_DATA_TIMEOUT = 54
    """An encoder sends no data."""
    SUB_ERR_CAN_CONNECTION_LOST = 55
    """The connection to a CAN device is lost."""
    SUB_ERR_HSE_START_FAIL = 56
    """The external oscillator does not start."""
    SUB_ERR_FRAME_IMU_SENSOR_NOT_RESPONDING = 57
    """The sensor of the frame IMU does not respond."""
    SUB_ERR_PARAMETERS_MODIFIED = 58
    """The parameters were modified."""
    SUB_ERR_NOT_NORMAL_POSITION = 59
    """The camera is not in its normal position."""
    SUB_ERR_CAN_DRV_LIMIT_EXCEED = 60
    """There are more CAN motor drivers than allowed."""


class CalibMode(OpenEnum):
    """Calibration or other task that is running."""

    NONE = 0
    """None."""
    EXT_GAIN = 1
    """The gains of a flight controller's signals."""
    SET_ANGLE_AND_SAVE = 2
    """Make the current angle the initial angle and save it."""
    POLES = 3
    """The poles and directions of the motors."""
    ACC = 4
    """The accelerometer."""
    GYRO = 5
    """The gyroscope."""
    ENCODER_OFFSET = 6
    """The offsets of the encoders."""
    ENCODER_FLD_OFFSET = 7
    """The offsets between encoders and magnetic fields."""
    AUTO_PID = 8
    """Automatic tuning of the PID controllers."""
    BODE_TEST = 9
    """Recording a frequency response."""
    GYRO_TEMP = 10
    """The gyroscope over temperature."""
    ACC_TEMP = 11
    """The accelerometer over temperature."""
    MAG = 12
    """The magnetometer."""
    SET_ANGLE = 13
    """Make the current angle the initial angle."""
    SYSTEM_IDENT = 14
    """Identification of the system."""
    MOTOR_MAG_LINK = 15
    """The magnetic linkage of the motors."""
    SEARCH_LIMITS = 16
    """Searching the mechanical limits."""
    SET_OPERATION_POS = 17
    """Moving to the operating position."""
    IMU_ORIENTATION_CORR = 18
    """The orientation of the IMU."""
    TIMELAPSE = 19
    """A time-lapse motion."""
    MOMENTUM = 20
    """The moment of inertia."""
    MOMENTUM_AUTO = 21
    """The moment of inertia, automatically."""
    COGGING = 22
    """The cogging of the motors."""
    ACC_EXT_REF = 23
    """The accelerometer, by an external reference."""
    SAFE_STOP = 24
    """A safe stop."""
    ACC_SPHERE = 25
    """The accelerometer on a sphere."""
    GYRO_AXES_ALIGNMENT = 26
    """The alignment of the gyroscope's axes."""
    EXT_IMU_GYRO = 27
    """The gyroscope of the external IMU."""
    EXT_IMU_ALIGN = 28
    """The alignment of the external IMU."""
    ACC_GYRO_MULTIPOINT = 34
    """Accelerometer and gyroscope in several positions."""
    ENCODER_LUT = 35
    """The correction tables of the encoders."""
    WRITE_PARAMS = 36
    """Writing parameters."""
    CUR_SENS = 37
    """The current sensors."""
    MOVE_HOME_MOTORS = 38
    """Moving the motors to their home positions."""
    ENCODER_INT = 39
    """The internal calibration of the encoders."""
    VIBRATION_TEST = 40
    """A vibration test."""
    RETRACTED_POSITION = 41
    """Moving to the retracted position."""
    RETRACTED_POSITION_RC_CONTROL = 42
    """Moving to or from the retracted position by RC."""


class PowerState(OpenEnum):
    """State of the motor power."""

    ON_FROM_BACKUP = -2
    """On, after a restart."""
    STARTUP = -1
    """The board is starting."""
    OFF = 0
    """Off."""
    ON = 1
    """On."""
    OFF_TEMPORARY = 2
    """Temporarily off."""
    OFF_PARKING = 3
    """Off, in the parking position."""
    ON_SAFE_STOP = 4
    """On, until a safe stop is complete."""


class StreamSync(OpenEnum):
    """Event that triggers the samples of a data stream."""

    OFF = 0
    """None; the samples follow the clock."""
    IMU_ATTITUDE = 1
    """A new attitude of the IMU."""


class ControlModeKind(OpenEnum):
    """Meaning of SPEED and ANGLE in a control command."""

    MODE_NO_CONTROL = 0
    """Serial control ends and RC takes over."""
    MODE_SPEED = 1
    """Turn at the given speed, in Euler coordinates, until the next command; the angle is ignored.
    """
    MODE_ANGLE = 2
    """Go to the given angle, in Euler coordinates, at the given speed; speed 0 selects the speed
    from the parameters.
    """
    MODE_SPEED_ANGLE = 3
    """Follow the given speed while the controller holds the given angle; the most precise mode."""
    MODE_RC = 4
    """The angle replaces the RC signal, -500 to 500, or -10000 for a lost signal; firmware before
    2.61 ignores the speed.
    """
    MODE_ANGLE_REL_FRAME = 5
    """Go to the given angle relative to the frame's neutral point; undoes full turns, so it
    untwists cables. Speed 0 selects the speed from the parameters.
    """
    MODE_RC_HIGH_RES = 6
    """Like MODE_RC, with a finer signal: -16384 to 16384, or -32768 for a lost signal. Since
    firmware 2.66b2.
    """
    MODE_IGNORE = 7
    """The axis keeps its state; its speed and angle are ignored. Since firmware 2.70b4."""
    MODE_ANGLE_SHORTEST = 8
    """Like MODE_ANGLE, but by the shortest way that the software limits leave open. Since firmware
    2.70b7.
    """


class MotorsOffMode(OpenEnum):
    """How to turn the motors off."""

    NORMAL = 0
    """They turn freely, without current."""
    BRAKE = 1
    """They brake."""
    SAFE_STOP = 2
    """Their power falls until they stand still, then they are off."""


class CoordinateSystem(OpenEnum):
    """Coordinate system of data from an external system."""

    COORD_SYS_GROUND_YAW_ROTATED = 1
    """Ground coordinates rotated with the camera about Z: Z points up, X right, Y forward. The
    default.
    """
    COORD_SYS_GROUND_END = 2
    """Ground coordinates: X points east, Y north, Z down."""
    COORD_SYS_FRAME = 3
    """Coordinates of the frame."""


class EulerOrderChange(OpenEnum):
    """Order of the Euler angles to change to."""

    KEEP = 0
    """The order does not change."""
    PITCH_ROLL_YAW = 1
    """Pitch, roll, yaw."""
    ROLL_PITCH_YAW = 2
    """Roll, pitch, yaw."""
    LOCAL_ROLL = 3
    """Pitch of the motor, roll, yaw of the motor."""
    ROLL_LOCAL = 4
    """Roll, pitch of the motor, yaw of the motor."""
    YAW_ROLL_PITCH = 5
    """Yaw, roll, pitch."""
    YAW_PITCH_ROLL = 6
    """Yaw, pitch, roll. Unconfirmed."""


class ControlQuatMode(OpenEnum):
    """Meaning of attitude and speed in CMD_CONTROL_QUAT."""

    DISABLED = 0
    """Control with quaternions ends."""
    SPEED = 1
    """Turn at the given speed, without a motion profile."""
    ATTITUDE = 2
    """Go to the given attitude with the configured motion profile."""
    SPEED_ATTITUDE = 5
    """Turn at the given speed and correct deviations from the given attitude."""
    SPEED_LIMITED = 9
    """Turn at the given speed, reached with the configured motion profile."""


class QuaternionComponent(OpenEnum):
    """Component of a quaternion."""

    W = 0
    """The scalar component."""
    X = 1
    """The X component."""
    Y = 2
    """The Y component."""
    Z = 3
    """The Z component."""


class SyncMotorAxis(OpenEnum):
    """Motor of CMD_SYNC_MOTORS."""

    ROLL = 0
    """Roll."""
    PITCH = 1
    """Pitch."""
    YAW = 2
    """Yaw."""


class EventId(OpenEnum):
    """What has happened."""

    MENU_BUTTON = 1
    """The menu button was pressed or released."""
    MOTOR_STATE = 2
    """The motors were turned on or off."""
    EMERGENCY_STOP = 3
    """An emergency stop began or ended."""
    CAMERA = 4
    """The camera is to record or to take a photo."""
    SCRIPT = 5
    """A script started or ended. Since firmware 2.68b8."""
    RETRACTED_POSITION = 6
    """The retracted position was reached or left. Since firmware 2.73.1."""


class ExtMotorActionKind(OpenEnum):
    """What external motors do."""

    OFF_FLOATING = 1
    """Turn off and rotate freely."""
    OFF_BRAKE = 2
    """Turn off and brake."""
    OFF_SAFE = 3
    """Slow down against external forces, then turn off and brake."""
    ON = 4
    """Turn on."""
    HOME_POSITION = 5
    """Move to the home position."""
    SEARCH_HOME = 6
    """Search the home position of a geared motor, or of one that makes several turns."""


class ExtMotorMode(OpenEnum):
    """What the setpoint of an external motor controls."""

    POSITION = 0
    """Its angle."""
    SPEED = 1
    """Its speed."""
    TORQUE = 2
    """Its torque."""


class ExtMotorPower(OpenEnum):
    """Whether an external motor has power."""

    OFF_BRAKE = 0
    """It is off and brakes."""
    ON = 1
    """It is on."""
    OFF_FLOATING = 2
    """It is off and rotates freely."""
    OFF_SAFE_STOP = 3
    """It is off after a safe stop."""


class BodeAxis(OpenEnum):
    """Axis of a frequency response."""

    ROLL = 0
    """Roll."""
    PITCH = 1
    """Pitch."""
    YAW = 2
    """Yaw."""


class BodeStimulus(OpenEnum):
    """Stimulus of a frequency response."""

    WHITE_NOISE = 1
    """White noise."""
    SINE_SWEEP = 2
    """A sine with rising frequency."""
    EXPONENTIAL_SWEEP = 3
    """A sine with exponentially rising frequency."""


class BodeSystem(OpenEnum):
    """What a frequency response describes."""

    CONTROLLER = 3
    """The controller."""
    OPEN_LOOP_PLANT_WITH_FILTERS = 6
    """The plant with notch filters, open loop."""
    OPEN_LOOP_CONTROLLER_AND_PLANT = 7
    """Controller and plant, open loop."""
    OVERALL = 11
    """The overall response of the system."""
    OPEN_LOOP_PLANT = 70
    """The plant alone, open loop."""
    CLOSED_LOOP_PLANT_WITH_FILTERS = 134
    """The plant with notch filters, closed loop."""
    CLOSED_LOOP_CONTROLLER_AND_PLANT = 135
    """Controller and plant, closed loop."""
    CLOSED_LOOP_PLANT = 198
    """The plant alone, closed loop."""


class CalibImu(OpenEnum):
    """IMU to calibrate."""

    ACTIVE = 0
    """The active IMU."""
    MAIN = 1
    """The main IMU on the camera."""
    FRAME = 2
    """The IMU on the frame."""


class CalibAction(OpenEnum):
    """Kind of calibration."""

    REGULAR = 1
    """Calibrate at the current temperature."""
    RESET = 2
    """Erase all calibrations and restart."""
    TEMPERATURE = 3
    """Calibrate over temperature."""
    ENABLE_TEMPERATURE = 4
    """Enable the calibration over temperature, if there is one, and restart."""
    DISABLE_TEMPERATURE = 5
    """Disable the calibration over temperature, but keep it in memory, and restart."""
    RESTORE_FACTORY = 6
    """Copy the calibration from the sensor's EEPROM to the main EEPROM."""
    STORE_IN_SENSOR = 7
    """Copy the calibration from the main EEPROM to the sensor's EEPROM."""


class CalibMotor(OpenEnum):
    """Motor whose encoder to calibrate."""

    ROLL = 0
    """The roll motor."""
    PITCH = 1
    """The pitch motor."""
    YAW = 2
    """The yaw motor."""
    ALL = 255
    """All motors."""


class AutoPid2Action(OpenEnum):
    """Operation of CMD_AUTO_PID2."""

    START = 1
    """Start the tuning with this configuration."""
    START_SAVE = 2
    """Save this configuration and start the tuning."""
    SAVE = 3
    """Save this configuration."""
    STOP = 5
    """Stop the tuning."""
    READ = 6
    """Read the saved configuration."""


class CoggingAction(OpenEnum):
    """Operation of CMD_CALIB_COGGING."""

    CALIBRATE = 1
    """Calibrate the motors."""
    DELETE = 2
    """Delete the calibration of the motors."""


class ImuIndex(OpenEnum):
    """IMU, counted from 0."""

    MAIN = 0
    """The main IMU on the camera."""
    FRAME = 1
    """The IMU on the frame."""


class AhrsReference(OpenEnum):
    """Reference that corrects an estimate of the attitude."""

    NONE = 0
    """None."""
    INTERNAL = 1
    """The board's own sensor."""
    EXTERNAL = 2
    """An external sensor."""
    TRANSLATE = 3
    """The other IMU, translated by the motor angles."""


class ExtImuState(OpenEnum):
    """State of the external IMU."""

    DISABLED = 0
    """Disabled."""
    NOT_CONNECTED = 1
    """Not connected."""
    UNKNOWN = 2
    """Unknown."""
    ERROR = 3
    """It reports an error."""
    BAD = 4
    """Its data are bad."""
    COARSE = 5
    """Its data are coarse."""
    GOOD = 6
    """Its data are good."""
    FINE = 7
    """Its data are precise."""


class ExtSensCommand(OpenEnum):
    """Commands of the GPS_IMU sensor's own protocol."""

    CONFIRM = 1
    """Confirmation."""
    RESET = 2
    """Restart the sensor."""
    RESET_NOTIFY = 3
    """The sensor restarts."""
    GET_DEVICE_INFO = 4
    """Request information about the sensor."""
    DEVICE_INFO = 5
    """Information about the sensor."""
    GET_DATA = 6
    """Request data."""
    GET_DATA_STREAM = 7
    """Request a stream of data."""
    DATA = 8
    """Data."""
    CALIB = 9
    """Calibrate the sensor."""
    BOOT_MODE = 10
    """Enter the bootloader of the sensor."""
    USER_DATA_LOG = 11
    """Log the user's data."""
    GET_USER_CONF_LOG = 12
    """Request the configuration of the log."""
    USER_CONF_LOG = 13
    """Configuration of the log."""


class BoardPin(OpenEnum):
    """Pins of the board that a host can switch."""

    RC_INPUT_ROLL = 1
    """The RC_ROLL pin."""
    RC_INPUT_PITCH = 2
    """The RC_PITCH pin."""
    EXT_FC_INPUT_ROLL = 3
    """The FC_ROLL pin."""
    EXT_FC_INPUT_PITCH = 4
    """The FC_PITCH pin."""
    RC_INPUT_YAW = 5
    """The RC_YAW pin. Since board 3.0."""
    PIN_AUX1 = 16
    """The AUX1 pin; on 1.x boards, pin 2 of the microcontroller."""
    PIN_AUX2 = 17
    """The AUX2 pin; on 1.x boards, pin 11 of the microcontroller."""
    PIN_AUX3 = 18
    """The AUX3 pin; on 1.x boards, pin 12 of the microcontroller."""
    PIN_BUZZER = 32
    """The buzzer; on 1.x boards, pin 32 of the microcontroller."""
    PIN_SSAT_POWER = 33
    """The 3.3 V supply of the Spektrum connector; LOW turns it on."""


class OutputPin(OpenEnum):
    """Pins that a host can switch."""

    RC_INPUT_ROLL = 1
    """The RC_ROLL pin."""
    RC_INPUT_PITCH = 2
    """The RC_PITCH pin."""
    EXT_FC_INPUT_ROLL = 3
    """The FC_ROLL pin."""
    EXT_FC_INPUT_PITCH = 4
    """The FC_PITCH pin."""
    RC_INPUT_YAW = 5
    """The RC_YAW pin. Since board 3.0."""
    PIN_AUX1 = 16
    """The AUX1 pin; on 1.x boards, pin 2 of the microcontroller."""
    PIN_AUX2 = 17
    """The AUX2 pin; on 1.x boards, pin 11 of the microcontroller."""
    PIN_AUX3 = 18
    """The AUX3 pin; on 1.x boards, pin 12 of the microcontroller."""
    PIN_BUZZER = 32
    """The buzzer; on 1.x boards, pin 32 of the microcontroller."""
    PIN_SSAT_POWER = 33
    """The 3.3 V supply of the Spektrum connector; LOW turns it on."""
    CAN_DRV1_AUX1 = 64
    """The AUX1 pin of CAN motor driver 1."""
    CAN_DRV1_AUX2 = 65
    """The AUX2 pin of CAN motor driver 1."""
    CAN_DRV1_AUX3 = 66
    """The AUX3 pin of CAN motor driver 1."""
    CAN_DRV2_AUX1 = 67
    """The AUX1 pin of CAN motor driver 2."""
    CAN_DRV2_AUX2 = 68
    """The AUX2 pin of CAN motor driver 2."""
    CAN_DRV2_AUX3 = 69
    """The AUX3 pin of CAN motor driver 2."""
    CAN_DRV3_AUX1 = 70
    """The AUX1 pin of CAN motor driver 3."""
    CAN_DRV3_AUX2 = 71
    """The AUX2 pin of CAN motor driver 3."""
    CAN_DRV3_AUX3 = 72
    """The AUX3 pin of CAN motor driver 3."""
    CAN_DRV4_AUX1 = 73
    """The AUX1 pin of CAN motor driver 4."""
    CAN_DRV4_AUX2 = 74
    """The AUX2 pin of CAN motor driver 4."""
    CAN_DRV4_AUX3 = 75
    """The AUX3 pin of CAN motor driver 4."""
    CAN_DRV5_AUX1 = 76
    """The AUX1 pin of CAN motor driver 5."""
    CAN_DRV5_AUX2 = 77
    """The AUX2 pin of CAN motor driver 5."""
    CAN_DRV5_AUX3 = 78
    """The AUX3 pin of CAN motor driver 5."""
    CAN_DRV6_AUX1 = 79
    """The AUX1 pin of CAN motor driver 6."""
    CAN_DRV6_AUX2 = 80
    """The AUX2 pin of CAN motor driver 6."""
    CAN_DRV6_AUX3 = 81
    """The AUX3 pin of CAN motor driver 6."""
    CAN_DRV7_AUX1 = 82
    """The AUX1 pin of CAN motor driver 7."""
    CAN_DRV7_AUX2 = 83
    """The AUX2 pin of CAN motor driver 7."""
    CAN_DRV7_AUX3 = 84
    """The AUX3 pin of CAN motor driver 7."""
    CAN_IMU_AUX1 = 85
    """The AUX1 pin of the main CAN IMU."""
    CAN_IMU_AUX2 = 86
    """The AUX2 pin of the main CAN IMU."""
    CAN_IMU_FRAME_AUX1 = 88
    """The AUX1 pin of the CAN IMU of the frame."""
    CAN_IMU_FRAME_AUX2 = 89
    """The AUX2 pin of the CAN IMU of the frame."""


class PinState(OpenEnum):
    """State of a pin."""

    LOW = 0
    """Low; sinks up to 40 mA."""
    HIGH = 1
    """High; supplies up to 40 mA."""
    FLOATING = 2
    """Floating. Since firmware 2.66."""
    INPUT_PULL_UP = 3
    """An input that is pulled up. Since firmware 2.74.3."""
    INPUT_PULL_DOWN = 4
    """An input that is pulled down. Since firmware 2.74.3."""


class I2cPort(OpenEnum):
    """I2C bus of the board."""

    MAIN = 0
    """The bus of the sensors."""
    SECOND = 1
    """The bus of the EEPROM."""


class ModuleId(OpenEnum):
    """Module of CMD_MODULE_LIST."""

    IMU_MAIN = 1
    """Main IMU."""
    IMU_FRAME = 2
    """Frame IMU."""
    CAN_DRV1 = 3
    """CAN motor driver 1."""
    CAN_DRV2 = 4
    """CAN motor driver 2."""
    CAN_DRV3 = 5
    """CAN motor driver 3."""
    CAN_DRV4 = 6
    """CAN motor driver 4."""
    CAN_DRV5 = 7
    """CAN motor driver 5."""
    CAN_DRV6 = 8
    """CAN motor driver 6."""
    CAN_DRV7 = 9
    """CAN motor driver 7."""
    GPS_IMU = 10
    """GPS_IMU."""
    CAN_HUB_GNSS = 11
    """CAN hub with a GNSS receiver."""
    CAN_HUB1 = 12
    """CAN hub 1."""
    CAN_HUB2 = 13
    """CAN hub 2."""
    UDRV1 = 14
    """uDrv module 1."""
    UDRV2 = 15
    """uDrv module 2."""
    UDRV3 = 16
    """uDrv module 3."""
    UDRV4 = 17
    """uDrv module 4."""


class CanDeviceId(OpenEnum):
    """Id of a device on the CAN bus."""

    NOT_ASSIGNED = 0
    """None assigned."""
    CAN_IMU_MAIN = 5
    """Main IMU."""
    CAN_IMU_FRAME = 6
    """Frame IMU."""
    GPS_IMU_MAIN = 7
    """GPS_IMU as the main IMU."""
    CAN_DRV1 = 17
    """CAN motor driver 1."""
    CAN_DRV2 = 18
    """CAN motor driver 2."""
    CAN_DRV3 = 19
    """CAN motor driver 3."""
    CAN_DRV4 = 20
    """CAN motor driver 4."""
    CAN_DRV5 = 21
    """CAN motor driver 5."""
    CAN_DRV6 = 22
    """CAN motor driver 6."""
    CAN_DRV7 = 23
    """CAN motor driver 7."""
    CAN_IMU_MAIN_OLD = 28
    """Main IMU of an older kind."""
    CAN_IMU_FRAME_OLD = 29
    """Frame IMU of an older kind."""


class CanDeviceKind(OpenEnum):
    """Kind of a device on the CAN bus."""

    MOTOR_DRIVER = 1
    """Motor driver."""
    IMU = 2
    """IMU."""


class TransparentDevice(OpenEnum):
    """Device at the far end of a transparent connection."""

    SBGC32 = 1
    """The board itself."""
    GPS_IMU = 2
    """GPS_IMU."""
    CAN_IMU_MAIN = 3
    """Main IMU."""
    CAN_IMU_FRAME = 4
    """Frame IMU."""
    GPS_SPLIT_RCVR = 5
    """Split GPS receiver."""
    CAN_SERIAL_HUB1 = 6
    """CAN hub 1."""
    CAN_SERIAL_HUB2 = 7
    """CAN hub 2."""
    CAN_DRV1 = 8
    """CAN motor driver 1."""
    CAN_DRV2 = 9
    """CAN motor driver 2."""
    CAN_DRV3 = 10
    """CAN motor driver 3."""
    CAN_DRV4 = 11
    """CAN motor driver 4."""


class FileError(OpenEnum):
    """Result of an operation on the board's file system."""

    NO_ERROR = 0
    """Success."""
    ERR_EEPROM_FAULT = 1
    """The memory chip does not respond."""
    ERR_FILE_NOT_FOUND = 2
    """No file has this id."""
    ERR_FAT = 3
    """The file table is damaged."""
    ERR_NO_FREE_SPACE = 4
    """The memory is full."""
    ERR_FAT_IS_FULL = 5
    """The file table is full."""
    ERR_FILE_SIZE = 6
    """The size is invalid."""
    ERR_CRC = 7
    """Checksum mismatch."""
    ERR_LIMIT_REACHED = 8
    """The file system reached a limit."""
    ERR_FILE_CORRUPTED = 9
    """The file is damaged."""
    ERR_WRONG_PARAMS = 10
    """A value of the request is invalid."""


class ScriptMode(OpenEnum):
    """Operation on a script."""

    STOP = 0
    """Stop it."""
    START = 1
    """Start it."""
    START_DEBUG = 2
    """Start it and report progress with CMD_SCRIPT_DEBUG."""


class DebugVarKind(OpenEnum):
    """Type of a debug variable."""

    VAR_TYPE_UINT8 = 1
    """Unsigned, 8 bits."""
    VAR_TYPE_INT8 = 2
    """Signed, 8 bits."""
    VAR_TYPE_UINT16 = 3
    """Unsigned, 16 bits."""
    VAR_TYPE_INT16 = 4
    """Signed, 16 bits."""
    VAR_TYPE_UINT32 = 5
    """Unsigned, 32 bits."""
    VAR_TYPE_INT32 = 6
    """Signed, 32 bits."""
    VAR_TYPE_FLOAT = 7
    """Floating point, IEEE-754, 32 bits."""


class DebugVarAxis(OpenEnum):
    """Axis of a debug variable."""

    NO_AXIS = 0
    """None."""
    VAR_FLAG_ROLL = 16
    """Roll."""
    VAR_FLAG_PITCH = 32
    """Pitch."""
    VAR_FLAG_YAW = 48
    """Yaw."""


class DebugPortAction(OpenEnum):
    """Operation on the debug port."""

    STOP = 0
    """Stop copying messages."""
    START = 1
    """Copy messages to this port."""


class BoardFeatures(Flags16):
    """Features of the board's hardware and firmware."""

    BOARD_FEATURE_3AXIS = 0x01
    """Drives three motors."""
    BOARD_FEATURE_BAT_MONITORING = 0x02
    """Measures the battery voltage."""
    BOARD_FEATURE_ENCODERS = 0x04
    """Supports motor encoders."""
    BOARD_FEATURE_BODE_TEST = 0x08
    """Can record a frequency response."""
    BOARD_FEATURE_SCRIPTING = 0x10
    """Runs user scripts."""
    BOARD_FEATURE_CURRENT_SENSOR = 0x20
    """Measures the supply current."""
    BOARD_FEATURE_MAG_SENSOR = 0x40
    """Supports a magnetometer."""
    BOARD_FEATURE_ORDER_OF_AXES_LETUS = 0x80
    """Supports the order of axes of a Letus gimbal."""
    BOARD_FEATURE_IMU_EEPROM = 0x100
    """The main IMU has an EEPROM."""
    BOARD_FEATURE_FRAME_IMU_EEPROM = 0x200
    """The frame IMU has an EEPROM."""
    BOARD_FEATURE_CAN_PORT = 0x400
    """Has a CAN bus."""
    BOARD_FEATURE_MOMENTUM = 0x800
    """Compensates the moment of inertia."""
    BOARD_FEATURE_COGGING_CORRECTION = 0x1000
    """Corrects the cogging of motors."""
    BOARD_FEATURE_MOTOR4_CONTROL = 0x2000
    """Drives a fourth motor."""
    BOARD_FEATURE_ACC_AUTO_CALIB = 0x4000
    """Calibrates the accelerometer automatically."""
    BOARD_FEATURE_BIG_FLASH = 0x8000
    """Has a large flash memory."""


class BoardFeaturesExt(Flags16):
    """More features of the board's hardware and firmware."""

    EXT_IMU = 0x01
    """Supports an external IMU."""
    STATE_VARS = 0x04
    """Keeps statistics; see CMD_READ_STATE_VARS."""
    POWER_MANAGEMENT = 0x08
    """Manages its power supply."""
    GYRO_ADVANCED_CALIB = 0x10
    """Has an advanced calibration of the gyroscope."""
    LIMITED_VERSION = 0x20
    """Has a limited set of functions."""
    REACTION = 0x40
    """Has a feature of this name, which no source explains."""
    ENCODER_LUT = 0x80
    """Corrects encoders with a lookup table."""


class BoardFeaturesExt2(Flags32):
    """Features of the board from firmware 2.73 on."""

    PLUS_VER = 0x01
    """The firmware is a "plus" version."""
    SHAKE_GENERATOR = 0x02
    """Can shake the camera on purpose."""
    EXT_MOTORS = 0x04
    """Drives auxiliary motors."""
    QUAT_CONTROL = 0x08
    """Can be controlled with quaternions."""
    ADC4 = 0x10
    """Has a fourth analog input."""


class BoardStateFlags(Flags8):
    """State of the board."""

    DEBUG_MODE = 0x01
    """A host should show its debug output."""
    IS_FRAME_INVERTED = 0x02
    """The frame is upside down."""
    INIT_STEP1_DONE = 0x04
    """The first step of the start-up is done."""
    INIT_STEP2_DONE = 0x08
    """The second step of the start-up is done."""
    STARTUP_AUTO_ROUTINE_DONE = 0x10
    """The automatic actions at start-up are done."""
    POWER_MANAGER_ENABLED = 0x20
    """Power management is on."""


class HardwareFlags(Flags16):
    """Hardware on the board."""

    ONE_WIRE_CRYPTO_IC = 0x01
    """A one-wire crypto chip is installed."""


class StoredProfileSets(Flags8):
    """Profile sets in the board's memory."""

    PROFILE_SET1 = 0x01
    """Profile set 1."""
    PROFILE_SET2 = 0x02
    """Profile set 2."""
    PROFILE_SET3 = 0x04
    """Profile set 3."""
    PROFILE_SET4 = 0x08
    """Profile set 4."""
    PROFILE_SET5 = 0x10
    """Profile set 5."""
    PROFILE_SET_BACKUP = 0x20
    """The backup."""


class ConnectionFlags(Flags8):
    """How the host is connected to the board."""

    CONNECTION_USB = 0x01
    """The host is connected over USB, not over a UART."""


class ResetOptions(Flags8):
    """What the board does before a restart."""

    NOTIFY = 0x01
    """Send CMD_RESET back first."""
    RESTORE_STATE = 0x02
    """Keep the state and restore it after the restart; not for CMD_BOOT_MODE_3."""


class PassProtectFlags(Flags32):
    """What a password protects."""

    ENCRYPT_PARAMS = 0x02
    """Parameters are encrypted."""
    SILENT = 0x04
    """By its name, protected ports do not respond without the password."""
    CHANNEL_1_ENABLED = 0x10
    """Port 1 is protected, by the name."""
    CHANNEL_2_ENABLED = 0x20
    """Port 2 is protected, by the name."""
    CHANNEL_3_ENABLED = 0x40
    """Port 3 is protected, by the name."""
    CHANNEL_4_ENABLED = 0x80
    """Port 4 is protected, by the name."""
    CHANNEL_5_ENABLED = 0x100
    """Port 5 is protected, by the name."""
    CHANNEL_6_ENABLED = 0x200
    """Port 6 is protected, by the name."""
    CHANNEL_1_ALLOW_CONTROL = 0x400
    """Port 1 accepts control without the password, by the name."""
    CHANNEL_2_ALLOW_CONTROL = 0x800
    """Port 2 accepts control without the password, by the name."""
    CHANNEL_3_ALLOW_CONTROL = 0x1000
    """Port 3 accepts control without the password, by the name."""
    CHANNEL_4_ALLOW_CONTROL = 0x2000
    """Port 4 accepts control without the password, by the name."""
    CHANNEL_5_ALLOW_CONTROL = 0x4000
    """Port 5 accepts control without the password, by the name."""
    CHANNEL_6_ALLOW_CONTROL = 0x8000
    """Port 6 accepts control without the password, by the name."""


class FilterSwitches(Flags8):
    """Enabled filters of an axis; 0 disables all."""

    EN_NOTCH1 = 0x01
    """First notch filter."""
    EN_NOTCH2 = 0x02
    """Second notch filter."""
    EN_NOTCH3 = 0x04
    """Third notch filter."""
    EN_LPF = 0x08
    """Low-pass filter."""


class EncoderFlags(Flags8):
    """Options in the upper half of the encoder type byte."""

    SKIP_DETECTION = 0x10
    """Do not detect whether the encoder is present."""
    ENCODER_IS_GEARED = 0x80
    """There is a gear between motor and encoder."""


class BeeperModes(Flags8):
    """When the board makes a sound."""

    BEEPER_MODE_CALIBRATE = 0x01
    """During calibrations."""
    BEEPER_MODE_CONFIRM = 0x02
    """To confirm commands."""
    BEEPER_MODE_ERROR = 0x04
    """On errors."""
    BEEPER_MODE_ALARM = 0x08
    """On alarms."""
    BEEP_BY_MOTORS = 0x80
    """The motors make the sound instead of the buzzer."""


class AdaptivePidAxes(Flags8):
    """Axes with adaptive PID control; 0 disables it."""

    EN_ROLL = 0x01
    """Roll."""
    EN_PITCH = 0x02
    """Pitch."""
    EN_YAW = 0x04
    """Yaw."""


class GeneralFlags(Flags16):
    """Options of the whole board."""

    REMEMBER_LAST_USED_PROFILE = 0x01
    """Start with the last used profile."""
    UPSIDE_DOWN_AUTO = 0x02
    """Detect an upside-down frame."""
    SWAP_FRAME_MAIN_IMU = 0x04
    """Swap frame IMU and main IMU."""
    BLINK_PROFILE = 0x08
    """Blink the profile number."""
    EMERGENCY_STOP = 0x10
    """Stop in an emergency."""
    MAGNETOMETER_POS_FRAME = 0x20
    """The magnetometer is on the frame."""
    FRAME_IMU_FF = 0x40
    """Feed forward from the frame IMU."""
    OVERHEAT_STOP_MOTORS = 0x80
    """Stop the motors when they overheat."""
    CENTER_YAW_AT_STARTUP = 0x100
    """Center yaw at start-up."""
    SWAP_RC_SERIAL_UART_B = 0x200
    """Swap the serial RC input and UART B."""
    UART_B_SERIAL_API = 0x400
    """UART B speaks this protocol."""
    BLINK_BAT_LEVEL = 0x800
    """Blink the battery level."""
    ADAPTIVE_GYRO_TRUST = 0x1000
    """Adapt the trust in the gyroscope."""
    IS_UPSIDE_DOWN = 0x2000
    """The frame is upside down. Since firmware 2.66."""
    UART_3_SERIAL_API = 0x4000
    """UART 3 speaks this protocol. Since firmware 2.66."""
    FRAME_INV_RC_INV = 0x8000
    """Invert the RC signals while the frame is upside down. Since firmware 2.66."""


class GeneralFlags2(Flags16):
    """More options of the whole board."""

    SEARCH_LIMIT_ROLL = 0x01
    """Search the mechanical limits of roll at start-up. Since firmware 2.61."""
    SEARCH_LIMIT_PITCH = 0x02
    """Search the mechanical limits of pitch at start-up. Since firmware 2.61."""
    SEARCH_LIMIT_YAW = 0x04
    """Search the mechanical limits of yaw at start-up. Since firmware 2.61."""
    AUTO_CALIBRATE_MOMENTUM = 0x08
    """Calibrate the momentum automatically. Since firmware 2.62b7."""
    USE_MOMENTUM_FEED_FORWARD = 0x10
    """Feed forward from the momentum. Since firmware 2.62b7."""
    MOTORS_OFF_AT_STARTUP = 0x20
    """Leave the motors off at start-up. Since firmware 2.62b7."""
    FC_BELOW_OUTER = 0x40
    """The flight controller is below the outer motor. Since firmware 2.62b7."""
    DO_NOT_CHECK_ENCODER_LIMITS = 0x80
    """Do not check the limits of the encoders. Since firmware 2.66."""
    AUTO_SAVE_BACKUP_SLOT = 0x100
    """Save the profiles to the backup slot automatically. Since firmware 2.66."""
    FC_BELOW_MIDDLE = 0x200
    """The flight controller is below the middle motor. Since firmware 2.66."""
    ENVIRONMENT_TEMP_UNKNOWN = 0x400
    """The temperature of the environment is unknown. Since firmware 2.67b2."""
    LPF_EXTENDED_RANGE = 0x800
    """The low-pass filters of RC signals range to 255, not 15. Since firmware 2.67b2."""
    SAVE_SYSTEM_STAT = 0x1000
    """Save statistics of the system. Since firmware 2.67b2."""
    DISABLE_ACC = 0x2000
    """Do not use the accelerometer. Since firmware 2.67b2."""
    DISABLE_POWER_MANAGER = 0x4000
    """Do not use the power manager. Since firmware 2.67b2."""
    ALLOW_ONBOARD_IMU_AS_MAIN = 0x8000
    """The IMU on the board may be the main IMU. Since firmware 2.67b2."""


class ProfileFlags(Flags16):
    """Options of one profile."""

    ADC1_AUTO_DETECTION = 0x01
    """Detect whether analog input 1 is connected."""
    ADC2_AUTO_DETECTION = 0x02
    """Detect whether analog input 2 is connected."""
    ADC3_AUTO_DETECTION = 0x04
    """Detect whether analog input 3 is connected."""
    FOLLOW_USE_FRAME_IMU = 0x10
    """Follow mode uses the frame IMU."""
    BRIEFCASE_AUTO_DETECTION = 0x20
    """Detect when the gimbal is carried like a briefcase."""
    UPSIDE_DOWN_AUTO_ROTATE = 0x40
    """Turn the camera when the frame is upside down."""
    FOLLOW_LOCK_OFFSET_CORRECTION = 0x80
    """Do not correct the offset in follow mode."""
    START_NEUTRAL_POSITION = 0x100
    """Start in the neutral position."""
    MENU_BUTTON_DISABLE_FOLLOW = 0x200
    """The menu button suspends the follow mode."""
    TIMELAPSE_FRAME_FIXED = 0x400
    """The frame does not move during a time lapse."""
    RC_KEEP_MIX_RATE = 0x800
    """Keep the mix rate of the RC channels."""
    RC_KEEP_CUR_POS_ON_INIT = 0x1000
    """Keep the current position when RC control starts."""
    OUTER_MOTOR_LIMIT_FREE_ROTATION = 0x2000
    """Limit the free rotation of the outer motor. Since firmware 2.66."""
    EULER_ORDER_AUTO = 0x4000
    """Select the order of the Euler angles automatically. Since firmware 2.67b1. Unconfirmed."""
    CAM_UPSIDE_DOWN_WORKING = 0x8000
    """The camera may work upside down. Unconfirmed."""


class ParkingBorders(Flags8):
    """Limits at which an axis parks."""

    ROLL_NEG = 0x01
    """The lower limit of roll."""
    ROLL_POS = 0x02
    """The upper limit of roll."""
    PITCH_NEG = 0x04
    """The lower limit of pitch."""
    PITCH_POS = 0x08
    """The upper limit of pitch."""
    YAW_NEG = 0x10
    """The lower limit of yaw."""
    YAW_POS = 0x20
    """The upper limit of yaw."""


class EulerOrderFlags(Flags8):
    """Options of the order of the Euler angles."""

    CONTROL_LOCAL_XYZ = 0x10
    """Control commands turn the camera about its own axes; not for LOCAL_ROLL and ROLL_LOCAL."""
    STAB_CONTROL_LOCAL_XYZ = 0x20
    """Stabilization and control use the camera's own axes; not for LOCAL_ROLL and ROLL_LOCAL. Since
    firmware 2.74.
    """


class ExtImuFlags(Flags16):
    """Use of the external IMU."""

    ACC_COMP_ONLY = 0x02
    """Only compensate linear accelerations."""
    REPLACE = 0x04
    """Replace the attitude of the internal IMU."""
    Z = 0x08
    """Correct the vertical."""
    H = 0x10
    """Correct the heading."""
    FRAME_UPSIDE_DOWN_UPDATE = 0x20
    """Take into account that the frame is upside down."""
    AS_FRAME_IMU = 0x40
    """Use it as the frame IMU."""
    GYRO_CORR = 0x80
    """Correct the gyroscope. Since firmware 2.68b7."""


class GeneralFlags3(Flags32):
    """Still more options of the whole board."""

    ENC_LUT_EN_ROLL = 0x01
    """Use the look-up table of the roll encoder."""
    ENC_LUT_EN_PITCH = 0x02
    """Use the look-up table of the pitch encoder."""
    ENC_LUT_EN_YAW = 0x04
    """Use the look-up table of the yaw encoder."""
    MAVLINK_YAW_ABSOLUTE = 0x08
    """The yaw of MAVLink commands is absolute."""
    EXT_SENS_AS_REFERENCE = 0x10
    """Use the external sensor as a reference."""
    DISABLE_BT = 0x20
    """Turn Bluetooth off."""
    ALLOW_SENSOR_RECOVERY = 0x40
    """Try to recover a sensor that fails."""
    UART2_ALT = 0x80
    """Use the alternative pins of UART 2."""
    PASS_LIMIT_ROLL = 0x100
    """Roll may pass its limits."""
    PASS_LIMIT_PITCH = 0x200
    """Pitch may pass its limits."""
    PASS_LIMIT_YAW = 0x400
    """Yaw may pass its limits."""
    DONT_PUSH_SOFT_LIMITS_ROLL = 0x800
    """Do not push roll away from its software limits."""
    DONT_PUSH_SOFT_LIMITS_PITCH = 0x1000
    """Do not push pitch away from its software limits."""
    DONT_PUSH_SOFT_LIMITS_YAW = 0x2000
    """Do not push yaw away from its software limits."""
    TRIPOD_MODE_AUTO = 0x4000
    """Start the tripod mode automatically."""
    TRIPOD_MODE_GYRO_ONLINE_CALIB = 0x8000
    """Calibrate the gyroscope in tripod mode."""
    RETRACTED_POSITION_MOTORS_OFF = 0x10000
    """Turn the motors off in the retracted position."""
    CAN_IMU_THERMOSTAT_ENABLE = 0x20000
    """The CAN IMU keeps its temperature constant."""
    RETRACTED_POSITION_SHORTEST = 0x40000
    """Take the shortest path to the retracted position."""
    RETRACTED_POSITION_RC_CONTROL = 0x80000
    """RC controls the retracted position."""
    ACC_LIMIT_EXT_RANGE = 0x100000
    """The acceleration limits have a wider range."""
    MOVE_SHORT_PATH_ROLL = 0x200000
    """Roll moves on the shortest path."""
    MOVE_SHORT_PATH_PITCH = 0x400000
    """Pitch moves on the shortest path."""
    MOVE_SHORT_PATH_YAW = 0x800000
    """Yaw moves on the shortest path."""
    FRAME_INV_SOFT_LIMIT_MIDDLE = 0x1000000
    """An upside-down frame changes the software limits of the middle motor."""
    FRAME_INV_SOFT_LIMIT_OUTER = 0x2000000
    """An upside-down frame changes the software limits of the outer motor."""
    CAN_IMU_SERVO1_DUTY_MODE = 0x4000000
    """Servo output 1 of the CAN IMU sets the duty cycle."""
    CAN_IMU_SERVO2_DUTY_MODE = 0x8000000
    """Servo output 2 of the CAN IMU sets the duty cycle."""


class GeneralFlags4(Flags32):
    """The last options of the whole board."""

    ACC_LIMIT_BY_MOMENTUM = 0x01
    """The momentum determines the acceleration limits."""
    CALIB_MOMENTUM_IN_NORMAL_POS = 0x02
    """Calibrate the momentum in the normal position."""
    EULER_MIDDLE_AXIS = 0x04
    """The middle axis determines the initial Euler angles. Unconfirmed."""
    EULER_MATCH_MOTOR_ROTATION = 0x08
    """The rotation of the motors determines the initial Euler angles. Unconfirmed."""


class ProfileFlags2(Flags16):
    """More options of one profile."""

    FOLLOW_PITCH_DISABLED = 0x01
    """Pitch does not follow the frame."""
    LOW_ANGLE_PRIOR_ROLL = 0x02
    """Roll prefers small angles."""
    LOW_ANGLE_PRIOR_PITCH = 0x04
    """Pitch prefers small angles."""
    LOW_ANGLE_PRIOR_YAW = 0x08
    """Yaw prefers small angles."""
    HEADING_TRIPOD_MODE = 0x10
    """The tripod mode applies to the heading."""
    MOT_ROLL_DISABLED = 0x20
    """The roll motor is off."""
    MOT_PITCH_DISABLED = 0x40
    """The pitch motor is off."""
    MOT_YAW_DISABLED = 0x80
    """The yaw motor is off."""
    RC_OUT_DUTY1 = 0x100
    """Servo output 1 sets the duty cycle."""
    RC_OUT_DUTY2 = 0x200
    """Servo output 2 sets the duty cycle."""
    RC_OUT_DUTY3 = 0x400
    """Servo output 3 sets the duty cycle."""
    RC_OUT_DUTY4 = 0x800
    """Servo output 4 sets the duty cycle."""
    DISABLE_FOLLOW_STARTUP = 0x1000
    """Do not follow at start-up."""
    SERVO_MODE = 0x2000
    """Servo mode."""
    RC_EXPO_DEADBAND_SPLIT = 0x4000
    """Pitch and yaw have their own RC dead band and expo rate."""


class ProfileFlags3(Flags32):
    """Still more options of one profile."""

    ACC_LIMIT_AUTO_R = 0x01
    """The board determines the acceleration limit of roll."""
    ACC_LIMIT_AUTO_P = 0x02
    """The board determines the acceleration limit of pitch."""
    ACC_LIMIT_AUTO_Y = 0x04
    """The board determines the acceleration limit of yaw."""
    SHAKE_GENERATOR_ENABLED = 0x08
    """The shake generator runs."""
    ERR_CORR_LONG_R = 0x10
    """Correct long errors of roll."""
    ERR_CORR_LONG_P = 0x20
    """Correct long errors of pitch."""
    ERR_CORR_LONG_Y = 0x40
    """Correct long errors of yaw."""


class SystemErrors(Flags16):
    """Errors detected by the board."""

    ERR_NO_SENSOR = 0x01
    """The IMU sensor does not respond."""
    ERR_CALIB_ACC = 0x02
    """The accelerometer is not calibrated."""
    ERR_SET_POWER = 0x04
    """The motor power is not set."""
    ERR_CALIB_POLES = 0x08
    """The motor poles are not calibrated."""
    ERR_PROTECTION = 0x10
    """The driver protection tripped."""
    ERR_SERIAL = 0x20
    """Errors on the serial line."""
    ERR_LOW_BAT1 = 0x40
    """The battery is below the alarm threshold."""
    ERR_LOW_BAT2 = 0x80
    """The battery is below the motor stop threshold."""
    ERR_GUI_VERSION = 0x100
    """The host software does not match the firmware."""
    ERR_MISS_STEPS = 0x200
    """A motor lost steps."""
    ERR_SYSTEM = 0x400
    """System error."""
    ERR_EMERGENCY_STOP = 0x800
    """Emergency stop; SYSTEM_SUB_ERROR gives the reason."""


class OtherFlags(Flags8):
    """State of the motors."""

    MOTORS_ON = 0x01
    """The motors are on."""


class RealtimeDataCustomFlags(Flags32):
    """Data blocks of CMD_REALTIME_DATA_CUSTOM."""

    IMU_ANGLES = 0x01
    """Angles of the main IMU."""
    TARGET_ANGLES = 0x02
    """RC target angles."""
    TARGET_SPEED = 0x04
    """RC target speed."""
    STATOR_ROTOR_ANGLE = 0x08
    """Joint angles."""
    GYRO_DATA = 0x10
    """Gyroscope of the IMU."""
    RC_DATA = 0x20
    """RC signals of the standard inputs."""
    Z1_H1_VECTORS = 0x40
    """Attitude of the IMU as a rotation matrix."""
    RC_CHANNELS = 0x80
    """All RC channels of S.BUS, Sum-PPM or Spektrum."""
    ACC_DATA = 0x100
    """Accelerometer of the IMU."""
    MOTOR4_CONTROL = 0x200
    """Control of a fourth motor."""
    AHRS_DEBUG_INFO = 0x400
    """State of the attitude estimation."""
    ENCODER_RAW24 = 0x800
    """Raw values of the encoders. Since firmware 2.68."""
    IMU_ANGLES_RAD = 0x1000
    """Angles of the main IMU in radians. Since firmware 2.68b7."""
    SCRIPT_VARS_FLOAT = 0x2000
    """Floating-point variables of the script."""
    SCRIPT_VARS_INT16 = 0x4000
    """Integer variables of the script."""
    SYSTEM_POWER_STATE = 0x8000
    """State of the motors and of the supply. Since firmware 2.70b6."""
    FRAME_CAM_RATE = 0x10000
    """Speed of the camera relative to the frame. Since firmware 2.70b6."""
    IMU_ANGLES_20 = 0x20000
    """Angles of the main IMU in high resolution. Since firmware 2.70b8."""
    TARGET_ANGLES_20 = 0x40000
    """Target angles in high resolution. Since firmware 2.70b8."""
    COMM_ERRORS = 0x80000
    """Counters of communication errors. Since firmware 2.72."""
    SYSTEM_STATE = 0x100000
    """State of the system. Since firmware 2.73."""
    IMU_QUAT = 0x200000
    """Attitude of the main IMU as a quaternion. Since firmware 2.73."""
    TARGET_QUAT = 0x400000
    """Target attitude as a quaternion. Since firmware 2.73."""
    IMU_TO_FRAME_QUAT = 0x800000
    """Rotation from the main IMU to the frame as a quaternion. Since firmware 2.73."""
    ADC_CH_RAW = 0x1000000
    """Raw values of the analog inputs. Since firmware 2.73."""
    SW_LIMITS_DIST = 0x2000000
    """Distances to the software limits. Since firmware 2.73.8."""
    FOLLOW_DIST = 0x4000000
    """Distance in follow mode. Since firmware 2.73.8."""
    EXT_TARGET_LIMIT = 0x8000000
    """Limits of an external target. Since firmware 2.73.8."""
    FRAME_CAM_ANGLE_20 = 0x10000000
    """Joint angles in high resolution."""
    MAIN_IMU_STATE = 0x20000000
    """State of the main IMU."""
    INCLUDE_FLAGS = 0x80000000
    """FLAGS in each sample."""


class RealtimeDataCustom2Flags(Flags32):
    """Data blocks of CMD_REALTIME_DATA_CUSTOM2."""

    FRAME_IMU_ANGLES = 0x01
    """Angles of the frame IMU."""
    FRAME_GYRO = 0x02
    """Gyroscope of the frame IMU."""
    FRAME_ACC = 0x04
    """Accelerometer of the frame IMU."""
    DEBUG = 0x08
    """Values for debugging."""
    MAG_SENS_DATA = 0x10
    """Magnetometer."""
    PIN_STATE = 0x20
    """State of the inputs."""
    STAB_ERR_AMPL = 0x40
    """Amplitude of the stabilization error. Since firmware 2.74.4."""
    INCLUDE_FLAGS = 0x80000000
    """FLAGS in each sample."""


class StateFlags(Flags32):
    """State of the system."""

    DEBUG_MODE = 0x01
    """A host should show its debug output."""
    IS_FRAME_INVERTED = 0x02
    """The frame is upside down."""
    INIT_STEP1_DONE = 0x04
    """The first step of the start-up is done."""
    INIT_STEP2_DONE = 0x08
    """The second step of the start-up is done."""
    STARTUP_AUTO_ROUTINE_DONE = 0x10
    """The automatic actions at start-up are done."""
    POWER_MANAGER_ENABLED = 0x20
    """Power management is on."""
    SHAKE_GEN_ENABLED = 0x100
    """The shake generator is enabled."""
    SERVO_MODE_ENABLED = 0x200
    """The servo mode is enabled."""
    FOLLOW_MODE_ROLL = 0x400
    """Roll is in follow mode."""
    FOLLOW_MODE_PITCH = 0x800
    """Pitch is in follow mode."""
    FOLLOW_MODE_YAW = 0x1000
    """Yaw is in follow mode."""
    TRIPOD_MODE_ENABLED = 0x2000
    """The tripod mode is enabled. Since firmware 2.73.9."""
    RETRACTED_POSITION = 0x4000
    """The camera is in its retracted position. Since firmware 2.74."""


class MotorPowerFlags(Flags16):
    """State of a motor."""

    SW_LIMIT_VIOLATED = 0x01
    """The motor is beyond a software limit."""
    CURRENT_EXCEEDS_LIMIT = 0x02
    """The current exceeds its limit."""
    DRIVER_ENABLED = 0x04
    """The driver is enabled."""


class SystemPowerFlags(Flags16):
    """Problems with the motors or their drivers."""

    SW_LIMIT_VIOLATED = 0x01
    """A motor is beyond a software limit."""
    OVERHEAT_WARNING = 0x02
    """A motor or a driver is too warm."""
    DRIVER_OTW = 0x04
    """A motor driver reports an overtemperature warning. Unconfirmed."""
    DRIVER_FAULT = 0x08
    """A motor driver failed. Unconfirmed."""


class CanErrorFlags(Flags8):
    """State of the CAN bus."""

    WARN = 0x01
    """The number of errors exceeds the warning level."""
    PASSIVE = 0x02
    """The controller is error-passive."""
    BUS_OFF = 0x04
    """The controller has left the bus."""


class CanDrvTelemetryFlags(Flags32):
    """Data of CMD_CAN_DRV_TELEMETRY."""

    CAN_BUS_FLAGS = 0x01
    """State of the CAN bus."""
    CAN_BUS_ERR_CNT = 0x02
    """Errors of the CAN bus."""
    TEMP_BOARD = 0x04
    """Temperature of the driver."""
    TEMP_MOTOR = 0x08
    """Temperature of the motor."""
    AVG_CURRENT = 0x10
    """Average current."""
    BUS_VOLTAGE = 0x20
    """Supply voltage."""
    PIN_STATE = 0x40
    """State of the pins."""
    PHASE_CURRENT = 0x80
    """Current of each phase."""
    ENCODER_ERROR_CNT = 0x100
    """Errors of the encoder."""
    IQ_ID_CURRENT = 0x200
    """Currents that make torque and field."""
    MOTOR_SPEED = 0x400
    """Speed of the motor."""
    PID_POS_ERR = 0x800
    """Error of the position controller."""
    PID_SPEED_ERR = 0x1000
    """Error of the speed controller."""
    IQ_REF = 0x2000
    """Target of the torque current."""
    PID_CURRENT_ERR = 0x4000
    """Error of the current controller."""


class CanDrvPins(Flags8):
    """Pins of a CAN motor driver."""

    LIMIT = 0x01
    """Limit switch."""
    INDEX = 0x02
    """Index of the encoder."""
    EMERGENCY = 0x04
    """Emergency stop."""
    AUX1 = 0x08
    """The AUX1 pin."""
    AUX2 = 0x10
    """The AUX2 pin."""
    AUX3 = 0x20
    """The AUX3 pin."""
    HALF_BRIDGE_ENABLE = 0x40
    """Enables the half bridges."""
    ENCODER_SPI_CS = 0x80
    """Selects the encoder on the SPI bus."""


class ControlFlags(Flags8):
    """Options in the upper half of a control mode byte."""

    CONTROL_FLAG_MIX_FOLLOW = 0x10
    """The motion is added to that of the follow mode instead of replacing it; for MODE_SPEED,
    MODE_ANGLE, MODE_ANGLE_SHORTEST and MODE_RC. Since firmware 2.70b5.
    """
    CONTROL_FLAG_TARGET_PRECISE = 0x20
    """The motion does not slow down near its target; for MODE_ANGLE, MODE_ANGLE_SHORTEST and
    MODE_ANGLE_REL_FRAME. Since firmware 2.70b1.
    """
    CONTROL_FLAG_AUTO_TASK = 0x40
    """In MODE_ANGLE and MODE_ANGLE_REL_FRAME, move as fast as automatic tasks do, and confirm when
    the target is reached. In MODE_RC the bit is CONTROL_FLAG_FORCE_RC_SPEED: the signal
    controls the speed, whatever the parameters say. Since firmware 2.62b7.
    """
    CONTROL_FLAG_HIGH_RES_SPEED = 0x80
    """Speeds are in 0.001 deg/s. Since firmware 2.59."""


class ControlExtFields(Flags16):
    """Data of CMD_CONTROL_EXT: five bits for each axis, the last of which is not used."""

    ROLL_SPEED = 0x01
    """The speed of roll is given."""
    ROLL_ANGLE = 0x02
    """The angle of roll is given."""
    ROLL_ANGLE_32BIT = 0x04
    """The angle of roll has 32 bits."""
    ROLL_SPEED_32BIT = 0x08
    """The speed of roll has 32 bits. Since firmware 2.72."""
    PITCH_SPEED = 0x20
    """The speed of pitch is given."""
    PITCH_ANGLE = 0x40
    """The angle of pitch is given."""
    PITCH_ANGLE_32BIT = 0x80
    """The angle of pitch has 32 bits."""
    PITCH_SPEED_32BIT = 0x100
    """The speed of pitch has 32 bits. Since firmware 2.72."""
    YAW_SPEED = 0x400
    """The speed of yaw is given."""
    YAW_ANGLE = 0x800
    """The angle of yaw is given."""
    YAW_ANGLE_32BIT = 0x1000
    """The angle of yaw has 32 bits."""
    YAW_SPEED_32BIT = 0x2000
    """The speed of yaw has 32 bits. Since firmware 2.72."""


class ControlExtFlags(Flags8):
    """Further options of the motion of an axis."""

    DISABLE_ANGLE_ERR_CORR = 0x01
    """Do not correct deviations from the target angle, as with an OUTER_P of 0."""


class ControlConfigFlags(Flags16):
    """Options of serial control."""

    CONTROL_CONFIG_FLAG_NO_CONFIRM = 0x01
    """Do not confirm control commands."""
    CONTROL_CONFIG_FLAG_SERVO_MODE_ENABLE = 0x02
    """Turn the servo mode on, in which angles are those of the motors. Since firmware 2.72."""
    CONTROL_CONFIG_FLAG_SERVO_MODE_DISABLE = 0x04
    """Turn the servo mode off. Since firmware 2.72."""
    CONTROL_CONFIG_FLAG_LPF_EXT_RANGE = 0x08
    """The filters have an extended range. Since firmware 2.72b3."""
    CONTROL_CONFIG_FLAG_LPF_FREQUENCY_HZ = 0x10
    """The filters are frequencies in Hz, by the name. Since firmware 2.74.1."""


class ControlQuatFlags(Flags8):
    """Options of CMD_CONTROL_QUAT."""

    CONFIRM = 0x01
    """Confirm the command."""
    ATTITUDE_PACKED = 0x02
    """The attitude is packed into 8 bytes."""
    ATTITUDE_LIMITED_180 = 0x04
    """Attitudes are within half a turn, and each is reached from the last one by the shortest way.
    """
    ATTITUDE_REMOVE_ABSENT_AXES = 0x08
    """By its name, axes without a motor are taken out of the attitude. Since firmware 2.74.1."""
    AUTO_TASK = 0x40
    """For ATTITUDE: move as fast as automatic tasks do, and confirm when the attitude is reached
    within 1 degree. The motion ends after 10 s in any case.
    """


class ControlQuatStatusFlags(Flags16):
    """Options of the current control with quaternions."""

    CONFIRM = 0x01
    """Commands are confirmed."""
    ATTITUDE_PACKED = 0x02
    """Attitudes are packed into 8 bytes."""
    ATTITUDE_LIMITED_180 = 0x04
    """Attitudes are within half a turn."""
    ATTITUDE_REMOVE_ABSENT_AXES = 0x08
    """Axes without a motor are taken out of the attitude."""
    AUTO_TASK = 0x40
    """The motion is an automatic task."""


class ControlQuatStatusFields(Flags16):
    """Data of CMD_CONTROL_QUAT_STATUS."""

    MODE = 0x01
    """Mode and flags."""
    TARGET_ATTITUDE = 0x02
    """Attitude of the last command."""
    SETPOINT_ATTITUDE = 0x04
    """Attitude that the board stabilizes."""
    ACTUAL_ATTITUDE = 0x08
    """Measured attitude."""
    TARGET_SPEED = 0x10
    """Speed of the last command."""
    SETPOINT_SPEED = 0x20
    """Speed that the board stabilizes."""
    ACTUAL_SPEED = 0x40
    """Measured speed."""
    TARGET_ATTITUDE_PACKED = 0x80
    """Attitude of the last command, packed."""
    SETPOINT_ATTITUDE_PACKED = 0x100
    """Attitude that the board stabilizes, packed."""
    ACTUAL_ATTITUDE_PACKED = 0x200
    """Measured attitude, packed."""


class ControlQuatConfigFields(Flags16):
    """Data of CMD_CONTROL_QUAT_CONFIG."""

    MAX_SPEED = 0x01
    """Speed limits."""
    ACC_LIMIT = 0x02
    """Acceleration limits."""
    JERK_SLOPE = 0x04
    """Times in which the acceleration rises."""
    FLAGS = 0x08
    """Options."""
    ATTITUDE_LPF_FREQ = 0x10
    """Low-pass filter of the attitude."""
    SPEED_LPF_FREQ = 0x20
    """Low-pass filter of the speed."""


class ControlQuatConfigFlags(Flags16):
    """Options of the motion profile of CMD_CONTROL_QUAT."""

    MOTION_PROFILE_SPLIT_XYZ = 0x01
    """Each axis has its own profile. Otherwise the profile of X applies along the shortest way."""


class HelperDataFlags(Flags8):
    """Options of CMD_HELPER_DATA."""

    EULER_ORDER_ROLL_PITCH_YAW = 0x40
    """The tilt is given in the Euler order roll, pitch, yaw. Since firmware 2.70b7."""
    USE_FRAME_HEADING = 0x80
    """The heading of the frame is given. Since firmware 2.62b7."""


class ExecuteMenuFlags(Flags8):
    """Confirmations of CMD_EXECUTE_MENU."""

    CONFIRM = 0x01
    """Confirm the start of the action."""
    CONFIRM_ON_FINISH = 0x02
    """Confirm the end of the action."""


class EventTypes(Flags8):
    """Kind of an event."""

    OFF = 0x01
    """It ended; for CAMERA, REC_PHOTO: record a video or take a photo."""
    ON = 0x02
    """It began; for CAMERA, PHOTO: take a photo."""
    HOLD = 0x04
    """It continues."""


class ExtMotors(Flags8):
    """External motors."""

    MOTOR1 = 0x01
    """Motor 1."""
    MOTOR2 = 0x02
    """Motor 2."""
    MOTOR3 = 0x04
    """Motor 3."""
    MOTOR4 = 0x08
    """Motor 4."""
    MOTOR5 = 0x10
    """Motor 5."""
    MOTOR6 = 0x20
    """Motor 6."""
    MOTOR7 = 0x40
    """Motor 7."""


class ExtMotorTargets(Flags8):
    """External motors of a command, and whether to confirm it."""

    MOTOR1 = 0x01
    """Motor 1."""
    MOTOR2 = 0x02
    """Motor 2."""
    MOTOR3 = 0x04
    """Motor 3."""
    MOTOR4 = 0x08
    """Motor 4."""
    MOTOR5 = 0x10
    """Motor 5."""
    MOTOR6 = 0x20
    """Motor 6."""
    MOTOR7 = 0x40
    """Motor 7."""
    CONFIRM = 0x80
    """Confirm the command."""


class ExtMotorsControlFields(Flags8):
    """Format of CMD_EXT_MOTORS_CONTROL."""

    SETPOINT_32BIT = 0x01
    """Setpoints have 32 bits, otherwise 16."""
    PARAM1_16BIT = 0x02
    """A parameter follows each setpoint, with 16 bits."""
    PARAM1_32BIT = 0x04
    """A parameter follows each setpoint, with 32 bits."""


class ExtMotorsControlConfigFields(Flags16):
    """Data of CMD_EXT_MOTORS_CONTROL_CONFIG."""

    MODE = 0x01
    """Mode."""
    MAX_SPEED = 0x02
    """Speed limit."""
    MAX_ACCELERATION = 0x04
    """Acceleration limit."""
    JERK_SLOPE = 0x08
    """Time in which the acceleration rises."""
    MAX_TORQUE = 0x10
    """Torque limit."""


class ExtMotorsStateFields(Flags32):
    """Data of CMD_EXT_MOTORS_STATE."""

    CONTROL_MODE = 0x01
    """Mode."""
    TORQUE = 0x02
    """Torque."""
    TORQUE_SETPOINT = 0x04
    """Target torque."""
    SPEED16 = 0x08
    """Speed, 16 bits."""
    SPEED16_SETPOINT = 0x10
    """Target speed, 16 bits."""
    SPEED32 = 0x20
    """Speed, 32 bits."""
    SPEED32_SETPOINT = 0x40
    """Target speed, 32 bits."""
    ANGLE16 = 0x80
    """Angle, 16 bits."""
    ANGLE16_SETPOINT = 0x100
    """Target angle, 16 bits."""
    ANGLE32 = 0x200
    """Angle, 32 bits."""
    ANGLE32_SETPOINT = 0x400
    """Target angle, 32 bits."""
    STATE_FLAGS = 0x800
    """State."""
    MAX_SPEED = 0x1000
    """Speed limit."""
    MAX_ACCELERATION = 0x2000
    """Acceleration limit."""
    JERK_SLOPE = 0x4000
    """Time in which the acceleration rises."""
    MAX_TORQUE = 0x8000
    """Torque limit."""
    CURRENT = 0x10000
    """Current."""
    BATTERY_VOLTAGE = 0x20000
    """Supply voltage."""
    MOTOR_TEMPERATURE = 0x40000
    """Temperature of the motor."""
    DRIVER_TEMPERATURE = 0x80000
    """Temperature of the driver."""


class ExtMotorPins(Flags16):
    """Pins of the driver of an external motor."""

    INDEX_PIN_STATE = 0x04
    """The index pin is active. Unconfirmed."""


class AutoPidFlags(Flags8):
    """Options of automatic PID tuning."""

    AUTO_PID_STOP = 0x00
    """Not a bit: the whole value 0 stops the tuning."""
    AUTO_PID_CFG_ROLL = 0x01
    """Tune roll."""
    AUTO_PID_CFG_PITCH = 0x02
    """Tune pitch."""
    AUTO_PID_CFG_YAW = 0x04
    """Tune yaw."""
    AUTO_PID_CFG_SEND_GUI = 0x08
    """Report progress with CMD_AUTO_PID."""
    AUTO_PID_CFG_KEEP_CURRENT = 0x10
    """Start from the current gains."""
    AUTO_PID_CFG_TUNE_LPF_FREQ = 0x20
    """Tune the low-pass filter as well."""
    AUTO_PID_CFG_ALL_PROFILES = 0x40
    """Store the result in all profiles."""


class CalibratedLimits(Flags8):
    """Calibrated directions of the accelerometer."""

    PLUS_X = 0x01
    """Limit +X."""
    MINUS_X = 0x02
    """Limit -X."""
    PLUS_Y = 0x04
    """Limit +Y."""
    MINUS_Y = 0x08
    """Limit -Y."""
    PLUS_Z = 0x10
    """Limit +Z."""
    MINUS_Z = 0x20
    """Limit -Z."""


class FieldOffsetFlags(Flags16):
    """Checks that the calibration of field offsets omits."""

    IGNORE_IMU_CHECK = 0x01
    """Do not compare with the IMU."""
    IGNORE_ENCODER_CHECK = 0x02
    """Do not check the encoder."""


class CoggingAxes(Flags8):
    """Motors whose cogging to calibrate."""

    ROLL = 0x01
    """The roll motor."""
    PITCH = 0x02
    """The pitch motor."""
    YAW = 0x04
    """The yaw motor."""


class AutoPid2CommandFlags(Flags16):
    """Options of CMD_AUTO_PID2."""

    SEND_CONFIG = 0x01
    """Send the configuration when the tuning ends."""


class AutoPid2Flags(Flags16):
    """Options of the automatic tuning of later firmware."""

    START_FROM_CURRENT = 0x01
    """Start from the current parameters."""
    ALL_PROFILES = 0x02
    """Store the result in all profiles."""
    TUNE_GAIN_ONLY = 0x04
    """Tune the gains only."""
    AUTOSAVE = 0x10
    """Save the result."""
    RUN_AT_START_ALL = 0x4000
    """Tune everything at each start-up."""
    RUN_AT_START_GAIN = 0x8000
    """Tune the gains at each start-up."""


class TuningPositions(Flags8):
    """Positions in which to tune."""

    POSITION1 = 0x01
    """Position 1."""
    POSITION2 = 0x02
    """Position 2."""
    POSITION3 = 0x04
    """Position 3."""
    POSITION4 = 0x08
    """Position 4."""


class ExtSensOptions(Flags8):
    """Options of CMD_EXT_SENS_CMD."""

    HIGH_PRIORITY = 0x01
    """Forward the command before others."""


class AhrsHelperMode(Flags8):
    """Operation of CMD_AHRS_HELPER. Without SET it is a query, in which only FRAME_IMU matters."""

    SET = 0x01
    """Set the attitude instead of querying it."""
    FRAME_IMU = 0x02
    """The frame IMU instead of the main one."""
    REFERENCE_ONLY = 0x04
    """Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it."""
    TRANSLATE = 0x08
    """Translate between camera and frame and use the result as a reference; requires known motor
    angles.
    """
    Z1_ONLY = 0x10
    """Use Z1_VECTOR only."""
    H1_ONLY = 0x20
    """Use H1_VECTOR only."""


class AhrsHelperWideMode(Flags16):
    """Operation of the forms of CMD_AHRS_HELPER with a two-byte mode. Without SET they are queries.
    """

    SET = 0x01
    """Set the attitude instead of querying it."""
    FRAME_IMU = 0x02
    """The frame IMU instead of the main one."""
    REFERENCE_ONLY = 0x04
    """Correct the estimate, as far as GYRO_TRUST allows, instead of replacing it."""
    TRANSLATE = 0x08
    """Translate between camera and frame and use the result as a reference; requires known motor
    angles.
    """
    Z1_ONLY = 0x10
    """Use Z1_VECTOR only."""
    H1_ONLY = 0x20
    """Use H1_VECTOR only."""
    TRANSLATE_Z1_ONLY = 0x40
    """Translate Z1_VECTOR only."""
    TRANSLATE_H1_ONLY = 0x80
    """Translate H1_VECTOR only."""
    ON_FRAME = 0x100
    """The sensor is on the frame, whatever the place of the frame IMU."""
    BELOW_OUTER = 0x200
    """The sensor is below the outer motor."""
    DISABLE_CORRECTION = 0x400
    """Turn the correction off. Since firmware 2.70b1."""


class BeepModes(Flags16):
    """Sounds of CMD_BEEP_SOUND."""

    BEEPER_MODE_CALIBRATE = 0x01
    """The calibration sound."""
    BEEPER_MODE_CONFIRM = 0x02
    """The confirmation sound."""
    BEEPER_MODE_ERROR = 0x04
    """The error sound."""
    BEEPER_MODE_CLICK = 0x10
    """A click."""
    BEEPER_MODE_COMPLETE = 0x20
    """The completion sound."""
    BEEPER_MODE_INTRO = 0x40
    """The start-up sound."""
    BEEPER_MODE_CUSTOM_MELODY = 0x8000
    """The notes of this message."""


class ServoOutputs(Flags32):
    """Servo outputs of the board and of its CAN motor drivers."""

    SERVO1 = 0x01
    """The FC_ROLL pin."""
    SERVO2 = 0x02
    """The FC_PITCH pin."""
    SERVO3 = 0x04
    """The RC_PITCH pin."""
    SERVO4 = 0x08
    """The AUX1 pin."""
    CAN_DRV1_SERVO1 = 0x10
    """First pin of CAN motor driver 1."""
    CAN_DRV1_SERVO2 = 0x20
    """Second pin of CAN motor driver 1."""
    CAN_DRV2_SERVO1 = 0x40
    """First pin of CAN motor driver 2."""
    CAN_DRV2_SERVO2 = 0x80
    """Second pin of CAN motor driver 2."""
    CAN_DRV3_SERVO1 = 0x100
    """First pin of CAN motor driver 3."""
    CAN_DRV3_SERVO2 = 0x200
    """Second pin of CAN motor driver 3."""
    CAN_DRV4_SERVO1 = 0x400
    """First pin of CAN motor driver 4."""
    CAN_DRV4_SERVO2 = 0x800
    """Second pin of CAN motor driver 4."""
    CAN_DRV5_SERVO1 = 0x1000
    """First pin of CAN motor driver 5."""
    CAN_DRV5_SERVO2 = 0x2000
    """Second pin of CAN motor driver 5."""
    CAN_DRV6_SERVO1 = 0x4000
    """First pin of CAN motor driver 6."""
    CAN_DRV6_SERVO2 = 0x8000
    """Second pin of CAN motor driver 6."""
    CAN_DRV7_SERVO1 = 0x10000
    """First pin of CAN motor driver 7."""
    CAN_DRV7_SERVO2 = 0x20000
    """Second pin of CAN motor driver 7."""


class RcInputOptions(Flags16):
    """Options of CMD_READ_RC_INPUTS."""

    INIT_IF_NEEDED = 0x01
    """Initialize each input that is not in use yet."""


class DebugVarFlags(Flags8):
    """Properties of a debug variable."""

    VAR_FLAG_ANGLE14 = 0x40
    """An angle, 16384 counts per turn."""


class DebugPortCommands(Flags32):
    """Frequent messages to filter on the debug port."""

    REALTIME_DATA_3 = 0x01
    """CMD_REALTIME_DATA_3."""
    REALTIME_DATA_4 = 0x02
    """CMD_REALTIME_DATA_4."""
    REALTIME_DATA_CUSTOM = 0x04
    """CMD_REALTIME_DATA_CUSTOM."""
    DEBUG_VARS_3 = 0x08
    """CMD_DEBUG_VARS_3."""
    MAVLINK_DEBUG = 0x10
    """CMD_MAVLINK_DEBUG."""
    GET_ANGLES = 0x20
    """CMD_GET_ANGLES."""
    GET_ANGLES_EXT = 0x40
    """CMD_GET_ANGLES_EXT."""
    BODE_TEST_DATA = 0x80
    """CMD_BODE_TEST_DATA."""
    HELPER_DATA = 0x100
    """CMD_HELPER_DATA."""
    AHRS_HELPER = 0x200
    """CMD_AHRS_HELPER."""
    GYRO_CORRECTION = 0x400
    """CMD_GYRO_CORRECTION."""
    CONTROL = 0x800
    """CMD_CONTROL."""
    SET_ADJ_VARS_VAL = 0x1000
    """CMD_SET_ADJ_VARS_VAL."""
    API_VIRT_CH_CONTROL = 0x2000
    """CMD_API_VIRT_CH_CONTROL."""
    API_VIRT_CH_HIGH_RES = 0x4000
    """CMD_API_VIRT_CH_HIGH_RES."""
