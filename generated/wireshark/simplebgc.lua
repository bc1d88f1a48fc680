-- Dissects the SimpleBGC Serial API in Wireshark. Generated: do not edit.
--
-- Copy this file to the folder of Lua plugins that Wireshark shows under Help > About > Folders.
-- The protocol is a table, which the rest of the file interprets; each part is a function of its own,
-- because one has at most 200 local variables.

-- Integers bit by bit: the library of Lua 5.2, or the operators of later versions, which 5.2 cannot read.
local bitwise = bit32 or load([[return {
  band = function(a, b) return a & b end, bxor = function(a, b) return a ~ b end,
  bnot = function(a) return ~a & 0xFFFFFFFF end,
  lshift = function(a, n) return a << n & 0xFFFFFFFF end, rshift = function(a, n) return a >> n end,
}]])()

local protocol = (function()
  local enums, packed, structs, messages = {}, {}, {}, {}
  enums.CommandToBoard = {values = {{20, "CMD_BOARD_INFO_3", "board_info_3"}, {21, "CMD_READ_PARAMS_3", "read_params_3"}, {22, "CMD_WRITE_PARAMS_3", "write_params_3"}, {23, "CMD_REALTIME_DATA_3", "realtime_data_3"}, {24, "CMD_SELECT_IMU_3", "select_imu_3"}, {25, "CMD_REALTIME_DATA_4", "realtime_data_4"}, {26, "CMD_ENCODERS_CALIB_OFFSET_4", "encoders_calib_offset_4"}, {27, "CMD_ENCODERS_CALIB_FLD_OFFSET_4", "encoders_calib_fld_offset_4"}, {28, "CMD_READ_PROFILE_NAMES", "read_profile_names"}, {29, "CMD_WRITE_PROFILE_NAMES", "write_profile_names"}, {30, "CMD_QUEUE_PARAMS_INFO_3", "queue_params_info_3"}, {31, "CMD_SET_ADJ_VARS_VAL", "set_adj_vars_val"}, {32, "CMD_SAVE_PARAMS_3", "save_params_3"}, {33, "CMD_READ_PARAMS_EXT", "read_params_ext"}, {34, "CMD_WRITE_PARAMS_EXT", "write_params_ext"}, {35, "CMD_AUTO_PID", "auto_pid"}, {36, "CMD_SERVO_OUT", "servo_out"}, {37, "CMD_BODE_TEST_START_STOP", "bode_test_start_stop"}, {39, "CMD_I2C_WRITE_REG_BUF", "i2c_write_reg_buf"}, {40, "CMD_I2C_READ_REG_BUF", "i2c_read_reg_buf"}, {41, "CMD_WRITE_EXTERNAL_DATA", "write_external_data"}, {42, "CMD_READ_EXTERNAL_DATA", "read_external_data"}, {43, "CMD_READ_ADJ_VARS_CFG", "read_adj_vars_cfg"}, {44, "CMD_WRITE_ADJ_VARS_CFG", "write_adj_vars_cfg"}, {45, "CMD_API_VIRT_CH_CONTROL", "api_virt_ch_control"}, {46, "CMD_ADJ_VARS_STATE", "adj_vars_state"}, {47, "CMD_EEPROM_WRITE", "eeprom_write"}, {48, "CMD_EEPROM_READ", "eeprom_read"}, {49, "CMD_CALIB_INFO", "calib_info"}, {50, "CMD_SIGN_MESSAGE", "sign_message"}, {51, "CMD_BOOT_MODE_3", "boot_mode_3"}, {52, "CMD_SYSTEM_STATE", "system_state"}, {53, "CMD_READ_FILE", "read_file"}, {54, "CMD_WRITE_FILE", "write_file"}, {55, "CMD_FS_CLEAR_ALL", "fs_clear_all"}, {56, "CMD_AHRS_HELPER", "ahrs_helper"}, {57, "CMD_RUN_SCRIPT", "run_script"}, {59, "CMD_CALIB_MAG", "calib_mag"}, {60, "CMD_UART_BYPASS", "uart_bypass"}, {61, "CMD_GET_ANGLES_EXT", "get_angles_ext"}, {62, "CMD_READ_PARAMS_EXT2", "read_params_ext2"}, {63, "CMD_WRITE_PARAMS_EXT2", "write_params_ext2"}, {64, "CMD_GET_ADJ_VARS_VAL", "get_adj_vars_val"}, {65, "CMD_CALIB_ACC", "calib_acc"}, {66, "CMD_CALIB_BAT", "calib_bat"}, {67, "CMD_CONTROL", "control"}, {68, "CMD_REALTIME_DATA", "realtime_data"}, {69, "CMD_EXECUTE_MENU", "execute_menu"}, {70, "CMD_USE_DEFAULTS", "use_defaults"}, {71, "CMD_CALIB_EXT_GAIN", "calib_ext_gain"}, {72, "CMD_HELPER_DATA", "helper_data"}, {73, "CMD_GET_ANGLES", "get_angles"}, {74, "CMD_CALIB_MOTOR_MAG_LINK", "calib_motor_mag_link"}, {75, "CMD_GYRO_CORRECTION", "gyro_correction"}, {76, "CMD_MODULE_LIST", "module_list"}, {77, "CMD_MOTORS_ON", "motors_on"}, {78, "CMD_MODULE_FLASH_START", "module_flash_start"}, {79, "CMD_CALIB_OFFSET", "calib_offset"}, {80, "CMD_CALIB_POLES", "calib_poles"}, {81, "CMD_MODULE_FLASH_WRITE", "module_flash_write"}, {82, "CMD_READ_PARAMS", "read_params"}, {83, "CMD_MODULE_FLASH_FINISH", "module_flash_finish"}, {84, "CMD_TRIGGER_PIN", "trigger_pin"}, {85, "CMD_DATA_STREAM_INTERVAL", "data_stream_interval"}, {86, "CMD_BOARD_INFO", "board_info"}, {87, "CMD_WRITE_PARAMS", "write_params"}, {88, "CMD_REALTIME_DATA_CUSTOM", "realtime_data_custom"}, {89, "CMD_BEEP_SOUND", "beep_sound"}, {90, "CMD_CONTROL_CONFIG", "control_config"}, {91, "CMD_CALIB_ORIENT_CORR", "calib_orient_corr"}, {92, "CMD_COGGING_CALIB_INFO", "cogging_calib_info"}, {93, "CMD_CALIB_COGGING", "calib_cogging"}, {94, "CMD_CALIB_ACC_EXT_REF", "calib_acc_ext_ref"}, {95, "CMD_PROFILE_SET", "profile_set"}, {96, "CMD_CAN_DEVICE_SCAN", "can_device_scan"}, {97, "CMD_CAN_DRV_HARD_PARAMS", "can_drv_hard_params"}, {98, "CMD_CAN_DRV_STATE", "can_drv_state"}, {99, "CMD_CAN_DRV_CALIBRATE", "can_drv_calibrate"}, {100, "CMD_READ_RC_INPUTS", "read_rc_inputs"}, {101, "CMD_REALTIME_DATA_CAN_DRV", "realtime_data_can_drv"}, {103, "CMD_CALIB_GYRO", "calib_gyro"}, {104, "CMD_READ_PARAMS_EXT3", "read_params_ext3"}, {105, "CMD_WRITE_PARAMS_EXT3", "write_params_ext3"}, {106, "CMD_EXT_IMU_DEBUG_INFO", "ext_imu_debug_info"}, {107, "CMD_SET_DEVICE_ADDR", "set_device_addr"}, {108, "CMD_AUTO_PID2", "auto_pid2"}, {109, "CMD_MOTORS_OFF", "motors_off"}, {110, "CMD_EXT_IMU_CMD", "ext_imu_cmd"}, {111, "CMD_READ_STATE_VARS", "read_state_vars"}, {112, "CMD_WRITE_STATE_VARS", "write_state_vars"}, {113, "CMD_SERIAL_PROXY", "serial_proxy"}, {114, "CMD_RESET", "reset"}, {115, "CMD_IMU_ADVANCED_CALIB", "imu_advanced_calib"}, {116, "CMD_API_VIRT_CH_HIGH_RES", "api_virt_ch_high_res"}, {117, "CMD_CALIB_ENCODER_LUT", "calib_encoder_lut"}, {118, "CMD_CALIB_ENCODER_LUT_RES", "calib_encoder_lut_res"}, {119, "CMD_WRITE_PARAMS_SET", "write_params_set"}, {120, "CMD_CALIB_CUR_SENS", "calib_cur_sens"}, {121, "CMD_CONTROL_EXT", "control_ext"}, {122, "CMD_ENC_INT_CALIB", "enc_int_calib"}, {123, "CMD_SYNC_MOTORS", "sync_motors"}, {124, "CMD_EXT_LICENSE_INFO", "ext_license_info"}, {125, "CMD_VIBRATION_TEST_START_STOP", "vibration_test_start_stop"}, {126, "CMD_VIBRATION_TEST_DATA", "vibration_test_data"}, {128, "CMD_EXT_MOTORS_ACTION", "ext_motors_action"}, {129, "CMD_EXT_MOTORS_CONTROL", "ext_motors_control"}, {130, "CMD_EXT_MOTORS_CONTROL_CONFIG", "ext_motors_control_config"}, {131, "CMD_EXT_MOTORS_STATE", "ext_motors_state"}, {132, "CMD_ADJ_VARS_INFO", "adj_vars_info"}, {133, "CMD_SERVO_OUT_EXT", "servo_out_ext"}, {134, "CMD_SET_ADJ_VARS_VAL_F", "set_adj_vars_val_f"}, {135, "CMD_GET_ADJ_VARS_VAL_F", "get_adj_vars_val_f"}, {136, "CMD_PASS_PROTECT_READ", "pass_protect_read"}, {137, "CMD_PASS_PROTECT_WRITE", "pass_protect_write"}, {139, "CMD_REALTIME_DATA_CUSTOM2", "realtime_data_custom2"}, {140, "CMD_CONTROL_QUAT", "control_quat"}, {141, "CMD_CONTROL_QUAT_STATUS", "control_quat_status"}, {142, "CMD_CONTROL_QUAT_CONFIG", "control_quat_config"}, {143, "CMD_SET_TRANSP_PROXY", "set_transp_proxy"}, {144, "CMD_UDRV_DEVICE_SCAN", "udrv_device_scan"}, {150, "CMD_EXT_SENS_CMD", "ext_sens_cmd"}, {151, "CMD_TRANSPARENT_SAPI", "transparent_sapi"}, {249, "CMD_SET_DEBUG_PORT", "set_debug_port"}, {250, "CMD_MAVLINK_INFO", "mavlink_info"}, {251, "CMD_MAVLINK_DEBUG", "mavlink_debug"}, {253, "CMD_DEBUG_VARS_INFO_3", "debug_vars_info_3"}, {254, "CMD_DEBUG_VARS_3", "debug_vars_3"}}}
  enums.CommandFromBoard = {values = {{20, "CMD_BOARD_INFO_3", "board_info_3"}, {21, "CMD_READ_PARAMS_3", "read_params_3"}, {23, "CMD_REALTIME_DATA_3", "realtime_data_3"}, {25, "CMD_REALTIME_DATA_4", "realtime_data_4"}, {28, "CMD_READ_PROFILE_NAMES", "read_profile_names"}, {30, "CMD_QUEUE_PARAMS_INFO_3", "queue_params_info_3"}, {31, "CMD_SET_ADJ_VARS_VAL", "set_adj_vars_val"}, {33, "CMD_READ_PARAMS_EXT", "read_params_ext"}, {35, "CMD_AUTO_PID", "auto_pid"}, {37, "CMD_BODE_TEST_START_STOP", "bode_test_start_stop"}, {38, "CMD_BODE_TEST_DATA", "bode_test_data"}, {40, "CMD_I2C_READ_REG_BUF", "i2c_read_reg_buf"}, {42, "CMD_READ_EXTERNAL_DATA", "read_external_data"}, {43, "CMD_READ_ADJ_VARS_CFG", "read_adj_vars_cfg"}, {46, "CMD_ADJ_VARS_STATE", "adj_vars_state"}, {48, "CMD_EEPROM_READ", "eeprom_read"}, {49, "CMD_CALIB_INFO", "calib_info"}, {50, "CMD_SIGN_MESSAGE", "sign_message"}, {52, "CMD_SYSTEM_STATE", "system_state"}, {53, "CMD_READ_FILE", "read_file"}, {56, "CMD_AHRS_HELPER", "ahrs_helper"}, {58, "CMD_SCRIPT_DEBUG", "script_debug"}, {60, "CMD_UART_BYPASS", "uart_bypass"}, {61, "CMD_GET_ANGLES_EXT", "get_angles_ext"}, {62, "CMD_READ_PARAMS_EXT2", "read_params_ext2"}, {67, "CMD_CONFIRM", "confirm"}, {73, "CMD_GET_ANGLES", "get_angles"}, {74, "CMD_CALIB_MOTOR_MAG_LINK", "calib_motor_mag_link"}, {76, "CMD_MODULE_LIST", "module_list"}, {82, "CMD_READ_PARAMS", "read_params"}, {86, "CMD_BOARD_INFO", "board_info"}, {88, "CMD_REALTIME_DATA_CUSTOM", "realtime_data_custom"}, {92, "CMD_COGGING_CALIB_INFO", "cogging_calib_info"}, {96, "CMD_CAN_DEVICE_SCAN", "can_device_scan"}, {97, "CMD_CAN_DRV_HARD_PARAMS", "can_drv_hard_params"}, {98, "CMD_CAN_DRV_STATE", "can_drv_state"}, {99, "CMD_CAN_DRV_CALIBRATE", "can_drv_calibrate"}, {100, "CMD_READ_RC_INPUTS", "read_rc_inputs"}, {101, "CMD_REALTIME_DATA_CAN_DRV", "realtime_data_can_drv"}, {102, "CMD_EVENT", "event"}, {104, "CMD_READ_PARAMS_EXT3", "read_params_ext3"}, {106, "CMD_EXT_IMU_DEBUG_INFO", "ext_imu_debug_info"}, {107, "CMD_SET_DEVICE_ADDR", "set_device_addr"}, {110, "CMD_EXT_IMU_CMD", "ext_imu_cmd"}, {111, "CMD_READ_STATE_VARS", "read_state_vars"}, {113, "CMD_SERIAL_PROXY", "serial_proxy"}, {114, "CMD_RESET", "reset"}, {115, "CMD_IMU_ADVANCED_CALIB", "imu_advanced_calib"}, {117, "CMD_CALIB_ENCODER_LUT", "calib_encoder_lut"}, {118, "CMD_CALIB_ENCODER_LUT_RES", "calib_encoder_lut_res"}, {120, "CMD_CALIB_CUR_SENS", "calib_cur_sens"}, {122, "CMD_ENC_INT_CALIB", "enc_int_calib"}, {124, "CMD_EXT_LICENSE_INFO", "ext_license_info"}, {125, "CMD_VIBRATION_TEST_START_STOP", "vibration_test_start_stop"}, {126, "CMD_VIBRATION_TEST_DATA", "vibration_test_data"}, {127, "CMD_CAN_DRV_TELEMETRY", "can_drv_telemetry"}, {131, "CMD_EXT_MOTORS_STATE", "ext_motors_state"}, {132, "CMD_ADJ_VARS_INFO", "adj_vars_info"}, {134, "CMD_SET_ADJ_VARS_VAL_F", "set_adj_vars_val_f"}, {136, "CMD_PASS_PROTECT_READ", "pass_protect_read"}, {139, "CMD_REALTIME_DATA_CUSTOM2", "realtime_data_custom2"}, {141, "CMD_CONTROL_QUAT_STATUS", "control_quat_status"}, {150, "CMD_EXT_SENS_CMD", "ext_sens_cmd"}, {151, "CMD_TRANSPARENT_SAPI", "transparent_sapi"}, {249, "CMD_SET_DEBUG_PORT", "set_debug_port"}, {250, "CMD_MAVLINK_INFO", "mavlink_info"}, {251, "CMD_MAVLINK_DEBUG", "mavlink_debug"}, {253, "CMD_DEBUG_VARS_INFO_3", "debug_vars_info_3"}, {254, "CMD_DEBUG_VARS_3", "debug_vars_3"}, {255, "CMD_ERROR", "error"}}}
  enums.VariableId = {values = {{0, "P_ROLL", "p_roll"}, {1, "P_PITCH", "p_pitch"}, {2, "P_YAW", "p_yaw"}, {3, "I_ROLL", "i_roll"}, {4, "I_PITCH", "i_pitch"}, {5, "I_YAW", "i_yaw"}, {6, "D_ROLL", "d_roll"}, {7, "D_PITCH", "d_pitch"}, {8, "D_YAW", "d_yaw"}, {9, "POWER_ROLL", "power_roll"}, {10, "POWER_PITCH", "power_pitch"}, {11, "POWER_YAW", "power_yaw"}, {12, "ACC_LIMITER", "acc_limiter"}, {13, "FOLLOW_SPEED_ROLL", "follow_speed_roll"}, {14, "FOLLOW_SPEED_PITCH", "follow_speed_pitch"}, {15, "FOLLOW_SPEED_YAW", "follow_speed_yaw"}, {16, "FOLLOW_LPF_ROLL", "follow_lpf_roll"}, {17, "FOLLOW_LPF_PITCH", "follow_lpf_pitch"}, {18, "FOLLOW_LPF_YAW", "follow_lpf_yaw"}, {19, "RC_SPEED_ROLL", "rc_speed_roll"}, {20, "RC_SPEED_PITCH", "rc_speed_pitch"}, {21, "RC_SPEED_YAW", "rc_speed_yaw"}, {22, "RC_LPF_ROLL", "rc_lpf_roll"}, {23, "RC_LPF_PITCH", "rc_lpf_pitch"}, {24, "RC_LPF_YAW", "rc_lpf_yaw"}, {25, "RC_TRIM_ROLL", "rc_trim_roll"}, {26, "RC_TRIM_PITCH", "rc_trim_pitch"}, {27, "RC_TRIM_YAW", "rc_trim_yaw"}, {28, "RC_DEADBAND", "rc_deadband"}, {29, "RC_EXPO_RATE", "rc_expo_rate"}, {30, "FOLLOW_MODE", "follow_mode"}, {31, "RC_FOLLOW_YAW", "rc_follow_yaw"}, {32, "FOLLOW_DEADBAND", "follow_deadband"}, {33, "FOLLOW_EXPO_RATE", "follow_expo_rate"}, {34, "FOLLOW_ROLL_MIX_START", "follow_roll_mix_start"}, {35, "FOLLOW_ROLL_MIX_RANGE", "follow_roll_mix_range"}, {36, "GYRO_TRUST", "gyro_trust"}, {37, "FRAME_HEADING_ANGLE", "frame_heading_angle"}, {38, "GYRO_HEADING_CORRECTION", "gyro_heading_correction"}, {39, "ACC_LIMITER_ROLL", "acc_limiter_roll"}, {40, "ACC_LIMITER_PITCH", "acc_limiter_pitch"}, {41, "ACC_LIMITER_YAW", "acc_limiter_yaw"}, {42, "PID_GAIN_ROLL", "pid_gain_roll"}, {43, "PID_GAIN_PITCH", "pid_gain_pitch"}, {44, "PID_GAIN_YAW", "pid_gain_yaw"}, {45, "LPF_FREQ_ROLL", "lpf_freq_roll"}, {46, "LPF_FREQ_PITCH", "lpf_freq_pitch"}, {47, "LPF_FREQ_YAW", "lpf_freq_yaw"}, {48, "TIMELAPSE_TIME", "timelapse_time"}, {49, "MAV_CTRL_MODE", "mav_ctrl_mode"}, {50, "H_CORR_FACTOR", "h_corr_factor"}, {51, "SW_LIM_MIN_ROLL", "sw_lim_min_roll"}, {52, "SW_LIM_MAX_ROLL", "sw_lim_max_roll"}, {53, "SW_LIM_MIN_PITCH", "sw_lim_min_pitch"}, {54, "SW_LIM_MAX_PITCH", "sw_lim_max_pitch"}, {55, "SW_LIM_MIN_YAW", "sw_lim_min_yaw"}, {56, "SW_LIM_MAX_YAW", "sw_lim_max_yaw"}, {57, "FOLLOW_RANGE_ROLL", "follow_range_roll"}, {58, "FOLLOW_RANGE_PITCH", "follow_range_pitch"}, {59, "FOLLOW_RANGE_YAW", "follow_range_yaw"}, {60, "AUTO_PID_TARGET", "auto_pid_target"}, {61, "RC_MODE_ROLL", "rc_mode_roll"}, {62, "RC_MODE_PITCH", "rc_mode_pitch"}, {63, "RC_MODE_YAW", "rc_mode_yaw"}, {64, "EULER_ORDER", "euler_order"}, {65, "FOLLOW_IN_DBAND", "follow_in_dband"}, {66, "RC_LIMIT_MIN_ROLL", "rc_limit_min_roll"}, {67, "RC_LIMIT_MAX_ROLL", "rc_limit_max_roll"}, {68, "RC_LIMIT_MIN_PITCH", "rc_limit_min_pitch"}, {69, "RC_LIMIT_MAX_PITCH", "rc_limit_max_pitch"}, {70, "RC_LIMIT_MIN_YAW", "rc_limit_min_yaw"}, {71, "RC_LIMIT_MAX_YAW", "rc_limit_max_yaw"}, {72, "RC_DEADBAND_PITCH", "rc_deadband_pitch"}, {73, "RC_DEADBAND_YAW", "rc_deadband_yaw"}, {74, "RC_EXPO_RATE_PITCH", "rc_expo_rate_pitch"}, {75, "RC_EXPO_RATE_YAW", "rc_expo_rate_yaw"}, {76, "SHAKE_AMP_ROLL", "shake_amp_roll"}, {77, "SHAKE_AMP_TILT", "shake_amp_tilt"}, {78, "SHAKE_AMP_PAN", "shake_amp_pan"}, {79, "SHAKE_FREQ", "shake_freq"}, {80, "SHAKE_FREQ_RANGE", "shake_freq_range"}, {81, "SHAKE_PAUSE_PERIOD", "shake_pause_period"}, {82, "SHAKE_PAUSE_BALANCE", "shake_pause_balance"}, {83, "SHAKE_PAUSE_RANDOMNESS", "shake_pause_randomness"}, {84, "SHAKE_RESONANCE_GAIN_ROLL", "shake_resonance_gain_roll"}, {85, "SHAKE_RESONANCE_GAIN_TILT", "shake_resonance_gain_tilt"}, {86, "SHAKE_RESONANCE_GAIN_PAN", "shake_resonance_gain_pan"}, {87, "SHAKE_FREQ_SHIFT_ROLL", "shake_freq_shift_roll"}, {88, "SHAKE_FREQ_SHIFT_TILT", "shake_freq_shift_tilt"}, {89, "SHAKE_FREQ_SHIFT_PAN", "shake_freq_shift_pan"}, {90, "SHAKE_MASTER_GAIN", "shake_master_gain"}, {91, "OUTER_P_ROLL", "outer_p_roll"}, {92, "OUTER_P_PITCH", "outer_p_pitch"}, {93, "OUTER_P_YAW", "outer_p_yaw"}, {94, "D_LPF_FREQ_ROLL", "d_lpf_freq_roll"}, {95, "D_LPF_FREQ_PITCH", "d_lpf_freq_pitch"}, {96, "D_LPF_FREQ_YAW", "d_lpf_freq_yaw"}, {97, "IMU_ANGLE_CORR_ROLL", "imu_angle_corr_roll"}, {98, "IMU_ANGLE_CORR_PITCH", "imu_angle_corr_pitch"}, {99, "SW_LIM_WIDTH_ROLL", "sw_lim_width_roll"}, {100, "SW_LIM_WIDTH_PITCH", "sw_lim_width_pitch"}, {101, "SW_LIM_WIDTH_YAW", "sw_lim_width_yaw"}}}
  enums.BoardErrorCode = {values = {{1, "CMD_SIZE", "cmd_size"}, {2, "WRONG_PARAMS", "wrong_params"}, {3, "GET_DEVICE_ID", "get_device_id"}, {4, "CRYPTO", "crypto"}, {5, "CALIBRATE_BAT", "calibrate_bat"}, {6, "UNKNOWN_COMMAND", "unknown_command"}, {8, "WRONG_STATE", "wrong_state"}, {9, "NOT_SUPPORTED", "not_supported"}, {10, "OPERATION_FAILED", "operation_failed"}, {11, "TEMPORARY", "temporary"}}}
  enums.RcModeKind = {values = {{0, "RC_MODE_ANGLE", "angle"}, {1, "RC_MODE_SPEED", "speed"}}}
  enums.PwmFrequency = {values = {{0, "PWM_FREQ_LOW", "low"}, {1, "PWM_FREQ_HIGH", "high"}, {2, "PWM_FREQ_ULTRA_HIGH", "ultra_high"}}}
  enums.SerialSpeed = {values = {{0, "BAUD_115200", "baud_115200"}, {1, "BAUD_57600", "baud_57600"}, {2, "BAUD_38400", "baud_38400"}, {3, "BAUD_19200", "baud_19200"}, {4, "BAUD_9600", "baud_9600"}, {5, "BAUD_256000", "baud_256000"}}}
  enums.RcVirtualMode = {values = {{0, "RC_VIRT_MODE_NORMAL", "normal"}, {1, "RC_VIRT_MODE_CPPM", "cppm"}, {2, "RC_VIRT_MODE_SBUS", "sbus"}, {3, "RC_VIRT_MODE_SPEKTRUM", "spektrum"}, {10, "RC_VIRT_MODE_API", "api"}}}
  enums.RcInput = {values = {{0, "INPUT_NO", "input_no"}, {1, "RC_INPUT_ROLL", "rc_input_roll"}, {2, "RC_INPUT_PITCH", "rc_input_pitch"}, {3, "EXT_FC_INPUT_ROLL", "ext_fc_input_roll"}, {4, "EXT_FC_INPUT_PITCH", "ext_fc_input_pitch"}, {5, "RC_INPUT_YAW", "rc_input_yaw"}, {33, "ADC1", "adc1"}, {34, "ADC2", "adc2"}, {35, "ADC3", "adc3"}, {36, "ADC4", "adc4"}}}
  enums.RcSource = {values = {{0, "PWM", "pwm"}, {32, "ANALOG", "analog"}, {64, "SERIAL", "serial"}, {128, "API", "api"}, {160, "STEP_SIGNAL", "step_signal"}}}
  enums.MixTarget = {values = {{0, "NO_MIX", "no_mix"}, {1, "ROLL", "roll"}, {2, "PITCH", "pitch"}, {3, "YAW", "yaw"}}}
  enums.FollowMode = {values = {{0, "FOLLOW_MODE_DISABLED", "disabled"}, {1, "FOLLOW_MODE_FC", "fc"}, {2, "FOLLOW_MODE_PITCH", "pitch"}}}
  enums.SensorAxis = {values = {{1, "X", "x"}, {2, "Y", "y"}, {3, "Z", "z"}, {-1, "-X", "minus_x"}, {-2, "-Y", "minus_y"}, {-3, "-Z", "minus_z"}}}
  enums.FrameImuPosition = {values = {{0, "FRAME_IMU_DISABLED", "disabled"}, {1, "FRAME_IMU_BELOW_YAW", "below_yaw"}, {2, "FRAME_IMU_ABOVE_YAW", "above_yaw"}, {3, "FRAME_IMU_BELOW_YAW_PID_SOURCE", "below_yaw_pid_source"}}}
  enums.SkipGyroCalibration = {values = {{0, "DO_NOT_SKIP", "do_not_skip"}, {1, "SKIP_ALWAYS", "skip_always"}, {2, "SKIP_IF_MOVING", "skip_if_moving"}}}
  enums.MenuCommand = {values = {{0, "MENU_CMD_NO", "none"}, {1, "MENU_CMD_PROFILE1", "profile1"}, {2, "MENU_CMD_PROFILE2", "profile2"}, {3, "MENU_CMD_PROFILE3", "profile3"}, {4, "MENU_CMD_SWAP_PITCH_ROLL", "swap_pitch_roll"}, {5, "MENU_CMD_SWAP_YAW_ROLL", "swap_yaw_roll"}, {6, "MENU_CMD_CALIB_ACC", "calib_acc"}, {7, "MENU_CMD_RESET", "reset"}, {8, "MENU_CMD_SET_ANGLE", "set_angle"}, {9, "MENU_CMD_CALIB_GYRO", "calib_gyro"}, {10, "MENU_CMD_MOTOR_TOGGLE", "motor_toggle"}, {11, "MENU_CMD_MOTOR_ON", "motor_on"}, {12, "MENU_CMD_MOTOR_OFF", "motor_off"}, {13, "MENU_CMD_FRAME_UPSIDE_DOWN", "frame_upside_down"}, {14, "MENU_CMD_PROFILE4", "profile4"}, {15, "MENU_CMD_PROFILE5", "profile5"}, {16, "MENU_CMD_AUTO_PID", "auto_pid"}, {17, "MENU_CMD_LOOK_DOWN", "look_down"}, {18, "MENU_CMD_HOME_POSITION", "home_position"}, {19, "MENU_CMD_RC_BIND", "rc_bind"}, {20, "MENU_CMD_CALIB_GYRO_TEMP", "calib_gyro_temp"}, {21, "MENU_CMD_CALIB_ACC_TEMP", "calib_acc_temp"}, {22, "MENU_CMD_BUTTON_PRESS", "button_press"}, {23, "MENU_CMD_RUN_SCRIPT1", "run_script1"}, {24, "MENU_CMD_RUN_SCRIPT2", "run_script2"}, {25, "MENU_CMD_RUN_SCRIPT3", "run_script3"}, {26, "MENU_CMD_RUN_SCRIPT4", "run_script4"}, {27, "MENU_CMD_RUN_SCRIPT5", "run_script5"}, {28, "MENU_CMD_RUN_SCRIPT6", "run_script6"}, {29, "MENU_CMD_RUN_SCRIPT7", "run_script7"}, {30, "MENU_CMD_RUN_SCRIPT8", "run_script8"}, {31, "MENU_CMD_RUN_SCRIPT9", "run_script9"}, {32, "MENU_CMD_RUN_SCRIPT10", "run_script10"}, {33, "MENU_CMD_CALIB_MAG", "calib_mag"}, {34, "MENU_CMD_LEVEL_ROLL_PITCH", "level_roll_pitch"}, {35, "MENU_CMD_CENTER_YAW", "center_yaw"}, {36, "MENU_CMD_UNTWIST_CABLES", "untwist_cables"}, {37, "MENU_CMD_SET_ANGLE_NO_SAVE", "set_angle_no_save"}, {38, "MENU_CMD_HOME_POSITION_SHORTEST", "home_position_shortest"}, {39, "MENU_CMD_CENTER_YAW_SHORTEST", "center_yaw_shortest"}, {40, "MENU_CMD_ROTATE_YAW_180", "rotate_yaw_180"}, {41, "MENU_CMD_ROTATE_YAW_180_FRAME_REL", "rotate_yaw_180_frame_rel"}, {42, "MENU_CMD_SWITCH_YAW_180_FRAME_REL", "switch_yaw_180_frame_rel"}, {43, "MENU_CMD_SWITCH_POS_ROLL_90", "switch_pos_roll_90"}, {44, "MENU_CMD_START_TIMELAPSE", "start_timelapse"}, {45, "MENU_CMD_CALIB_MOMENTUM", "calib_momentum"}, {46, "MENU_CMD_LEVEL_ROLL", "level_roll"}, {47, "MENU_CMD_REPEAT_TIMELAPSE", "repeat_timelapse"}, {48, "MENU_CMD_LOAD_PROFILE_SET1", "load_profile_set1"}, {49, "MENU_CMD_LOAD_PROFILE_SET2", "load_profile_set2"}, {50, "MENU_CMD_LOAD_PROFILE_SET3", "load_profile_set3"}, {51, "MENU_CMD_LOAD_PROFILE_SET4", "load_profile_set4"}, {52, "MENU_CMD_LOAD_PROFILE_SET5", "load_profile_set5"}, {53, "MENU_CMD_LOAD_PROFILE_SET_BACKUP", "load_profile_set_backup"}, {54, "MENU_CMD_INVERT_RC_ROLL", "invert_rc_roll"}, {55, "MENU_CMD_INVERT_RC_PITCH", "invert_rc_pitch"}, {56, "MENU_CMD_INVERT_RC_YAW", "invert_rc_yaw"}, {57, "MENU_CMD_SNAP_TO_FIXED_POSITION", "snap_to_fixed_position"}, {58, "MENU_CMD_CAMERA_REC_PHOTO_EVENT", "camera_rec_photo_event"}, {59, "MENU_CMD_CAMERA_PHOTO_EVENT", "camera_photo_event"}, {60, "MENU_CMD_MOTORS_SAFE_STOP", "motors_safe_stop"}, {61, "MENU_CMD_CALIB_ACC_AUTO", "calib_acc_auto"}, {62, "MENU_CMD_RESET_IMU", "reset_imu"}, {63, "MENU_CMD_FORCED_FOLLOW_TOGGLE", "forced_follow_toggle"}, {64, "MENU_CMD_AUTO_PID_GAIN_ONLY", "auto_pid_gain_only"}, {65, "MENU_CMD_LEVEL_PITCH", "level_pitch"}, {66, "MENU_CMD_MOTORS_SAFE_TOGGLE", "motors_safe_toggle"}, {67, "MENU_CMD_TIMELAPSE_STEP1", "timelapse_step1"}, {68, "MENU_CMD_EXT_GYRO_ONLINE_CALIB", "ext_gyro_online_calib"}, {69, "MENU_CMD_DISABLE_FOLLOW_TOGGLE", "disable_follow_toggle"}, {70, "MENU_CMD_SET_CUR_POS_AS_HOME", "set_cur_pos_as_home"}, {71, "MENU_CMD_STOP_SCRIPT", "stop_script"}, {72, "MENU_CMD_TRIPOD_MODE_OFF", "tripod_mode_off"}, {73, "MENU_CMD_TRIPOD_MODE_ON", "tripod_mode_on"}, {74, "MENU_CMD_SET_RC_TRIM", "set_rc_trim"}, {75, "MENU_CMD_HOME_POSITION_MOTORS", "home_position_motors"}, {76, "MENU_CMD_RETRACTED_POSITION", "retracted_position"}, {77, "MENU_CMD_SHAKE_GENERATOR_OFF", "shake_generator_off"}, {78, "MENU_CMD_SHAKE_GENERATOR_ON", "shake_generator_on"}, {79, "MENU_CMD_SERVO_MODE_ON", "servo_mode_on"}, {80, "MENU_CMD_SERVO_MODE_OFF", "servo_mode_off"}, {81, "MENU_CMD_SERVO_MODE_TOGGLE", "servo_mode_toggle"}}}
  enums.MotorOutput = {values = {{0, "DISABLED", "disabled"}, {1, "ROLL", "roll"}, {2, "PITCH", "pitch"}, {3, "YAW", "yaw"}, {4, "I2C_DRV1", "i2c_drv1"}, {5, "I2C_DRV2", "i2c_drv2"}, {6, "I2C_DRV3", "i2c_drv3"}, {7, "I2C_DRV4", "i2c_drv4"}}}
  enums.SelectedImu = {values = {{1, "IMU_TYPE_MAIN", "main"}, {2, "IMU_TYPE_FRAME", "frame"}}}
  enums.SpektrumMode = {values = {{0, "AUTO", "auto_detect"}, {1, "DSM2_11MS_10BIT", "dsm2_11ms_10bit"}, {2, "DSM2_11MS_11BIT", "dsm2_11ms_11bit"}, {3, "DSM2_22MS_10BIT", "dsm2_22ms_10bit"}, {4, "DSM2_22MS_11BIT", "dsm2_22ms_11bit"}, {5, "DSMX_11MS_10BIT", "dsmx_11ms_10bit"}, {6, "DSMX_11MS_11BIT", "dsmx_11ms_11bit"}, {7, "DSMX_22MS_10BIT", "dsmx_22ms_10bit"}, {8, "DSMX_22MS_11BIT", "dsmx_22ms_11bit"}}}
  enums.AxisOrder = {values = {{0, "PITCH_ROLL_YAW", "pitch_roll_yaw"}, {1, "YAW_ROLL_PITCH", "yaw_roll_pitch"}, {2, "ROLL_YAW_PITCH", "roll_yaw_pitch"}, {3, "ROLL_PITCH_YAW", "roll_pitch_yaw"}}}
  enums.EulerOrder = {values = {{0, "PITCH_ROLL_YAW", "pitch_roll_yaw"}, {1, "ROLL_PITCH_YAW", "roll_pitch_yaw"}, {2, "LOCAL_ROLL", "local_roll"}, {3, "ROLL_LOCAL", "roll_local"}, {4, "YAW_ROLL_PITCH", "yaw_roll_pitch"}, {5, "YAW_PITCH_ROLL", "yaw_pitch_roll"}}}
  enums.ProfileSetAction = {values = {{1, "SAVE", "save"}, {2, "CLEAR", "clear"}, {3, "LOAD", "load"}}}
  enums.EncoderModel = {values = {{1, "ENC_TYPE_AS5048A", "as5048a"}, {2, "ENC_TYPE_AS5048B", "as5048b"}, {3, "ENC_TYPE_AS5048_PWM", "as5048_pwm"}, {4, "ENC_TYPE_AMT203", "amt203"}, {5, "ENC_TYPE_MA3_10BIT", "ma3_10bit"}, {6, "ENC_TYPE_MA3_12BIT", "ma3_12bit"}, {7, "ENC_TYPE_ANALOG", "analog"}, {8, "ENC_TYPE_I2C_DRV1", "i2c_drv1"}, {9, "ENC_TYPE_I2C_DRV2", "i2c_drv2"}, {10, "ENC_TYPE_I2C_DRV3", "i2c_drv3"}, {11, "ENC_TYPE_I2C_DRV4", "i2c_drv4"}, {12, "ENC_TYPE_AS5600_PWM", "as5600_pwm"}, {13, "ENC_TYPE_AS5600_I2C", "as5600_i2c"}, {14, "ENC_TYPE_RLS_ORBIS", "rls_orbis"}, {15, "ENC_TYPE_RLS_ORBIS_PWM", "rls_orbis_pwm"}}}
  enums.EncoderConfig = {values = {{0, "SPI_SPEED_1MHz", "spi_1_mhz"}, {1, "SPI_SPEED_2MHz", "spi_2_mhz"}, {2, "SPI_SPEED_4MHz", "spi_4_mhz"}, {3, "SPI_SPEED_500kHz", "spi_500_khz"}}}
  enums.BoardPort = {values = {{0, "DISABLED", "disabled"}, {1, "UART1", "uart1"}, {2, "RC_SERIAL", "rc_serial"}, {3, "UART2", "uart2"}, {4, "USB_VCP", "usb_vcp"}}}
  enums.MavControlMode = {values = {{0, "DISABLED", "disabled"}, {1, "ROLL_PITCH", "roll_pitch"}, {2, "ALL_AXES", "all_axes"}}}
  enums.StabilizedAxis = {values = {{0, "STAB_AXIS_DEFAULT", "default_axis"}, {1, "STAB_AXIS_ROLL", "roll"}, {2, "STAB_AXIS_PITCH", "pitch"}, {3, "STAB_AXIS_YAW", "yaw"}}}
  enums.SnapAngle = {values = {{0, "SNAP_ANGLE_0", "snap_angle_0"}, {1, "SNAP_ANGLE_45", "snap_angle_45"}, {2, "SNAP_ANGLE_90", "snap_angle_90"}, {3, "SNAP_ANGLE_180", "snap_angle_180"}}}
  enums.StepCount = {values = {{0, "STEPS_2", "steps_2"}, {1, "STEPS_3", "steps_3"}, {2, "STEPS_5", "steps_5"}, {3, "STEPS_10", "steps_10"}, {4, "STEPS_15", "steps_15"}, {5, "STEPS_25", "steps_25"}, {6, "STEPS_50", "steps_50"}, {7, "STEPS_100", "steps_100"}}}
  enums.StepTrigger = {values = {{0, "LEVEL_LOW", "level_low"}, {1, "LEVEL_HIGH", "level_high"}, {2, "LEVEL_LOW_HIGH", "level_low_high"}}}
  enums.WriteParamsAction = {values = {{0, "FINISH", "finish"}, {1, "START", "start"}}}
  enums.ExtImuModel = {values = {{1, "MAVLINK1", "mavlink1"}, {2, "MAVLINK2", "mavlink2"}, {3, "VECTORNAV_VN200", "vectornav_vn200"}, {4, "INERTIALSENSE_UAHRS", "inertialsense_uahrs"}}}
  enums.ExtImuPosition = {values = {{1, "BELOW_OUTER", "below_outer"}, {2, "ABOVE_OUTER", "above_outer"}, {8, "BELOW_MIDDLE", "below_middle"}, {9, "MAIN_IMU", "main_imu"}}}
  enums.ExtImuAxis = {values = {{0, "X", "x"}, {1, "Y", "y"}, {2, "Z", "z"}, {3, "-X", "minus_x"}, {4, "-Y", "minus_y"}, {5, "-Z", "minus_z"}}}
  enums.MultiTurn = {values = {{0, "MULTI_TURN_NO", "multi_turn_no"}, {1, "MULTI_TURN_12", "multi_turn_12"}, {2, "MULTI_TURN_16", "multi_turn_16"}, {3, "MULTI_TURN_20", "multi_turn_20"}, {4, "MULTI_TURN_24", "multi_turn_24"}}}
  enums.CanImuSensor = {values = {{0, "DISABLED", "disabled"}, {1, "KVH_1725", "kvh_1725"}, {2, "KVH_1750_ACC_2G", "kvh_1750_acc_2g"}, {3, "KVH_1750_ACC_10G", "kvh_1750_acc_10g"}, {4, "KVH_1750_ACC_30G", "kvh_1750_acc_30g"}, {5, "KVH_1775_ACC_10G", "kvh_1775_acc_10g"}, {6, "KVH_1775_ACC_25G", "kvh_1775_acc_25g"}, {7, "KVH_1760", "kvh_1760"}, {8, "ADXRS453", "adxrs453"}, {9, "ADIS16460", "adis16460"}, {10, "STIM210", "stim210"}, {11, "STIM300", "stim300"}, {12, "SCHA63X", "scha63x"}, {64, "VECTORNAV_VN100_200_UART", "vectornav_vn100_200_uart"}, {65, "VECTORNAV_VN100_200_SPI", "vectornav_vn100_200_spi"}}}
  enums.InputState = {values = {{0, "LOW", "low"}, {1, "HIGH", "high"}, {2, "UNAVAILABLE", "unavailable"}}}
  enums.SystemSubError = {values = {{0, "NONE", "none"}, {1, "SUB_ERR_I2C_ERRORS", "i2c_errors"}, {2, "SUB_ERR_DRV_OTW", "drv_otw"}, {3, "SUB_ERR_DRV_FAULT", "drv_fault"}, {4, "SUB_ERR_ENCODER_IMU_ANGLE", "encoder_imu_angle"}, {5, "SUB_ERR_CALIBRATION_FAILED", "calibration_failed"}, {6, "SUB_ERR_INTERNAL_SYSTEM_ERROR", "internal_system_error"}, {7, "SUB_ERR_ENCODER_CALIB_BAD_SCALE", "encoder_calib_bad_scale"}, {8, "SUB_ERR_OVER_TEMPERATURE", "over_temperature"}, {9, "SUB_ERR_BAD_MOTOR_POLES_INVERT", "bad_motor_poles_invert"}, {10, "SUB_ERR_NOT_ENOUGH_MEMORY", "not_enough_memory"}, {11, "SUB_ERR_IMU_SENSOR_NOT_RESPONDING", "imu_sensor_not_responding"}, {12, "SUB_ERR_CAN_HARD", "can_hard"}, {13, "SUB_ERR_MOTOR_OVERHEAT_PROTECTION", "motor_overheat_protection"}, {14, "SUB_ERR_MOTOR_IS_LOCKED", "motor_is_locked"}, {15, "SUB_ERR_BAD_IMU_HEALTH", "bad_imu_health"}, {16, "SUB_ERR_INFINITE_RESET", "infinite_reset"}, {17, "SUB_ERR_WRONG_INITIAL_POSITION", "wrong_initial_position"}, {18, "SUB_ERR_MOTOR_LOAD_TIME_EXCEEDED", "motor_load_time_exceeded"}, {19, "SUB_ERR_CAN_DRV_OVERCURRENT", "can_drv_overcurrent"}, {20, "SUB_ERR_CAN_DRV_UNDERVOLTAGE", "can_drv_undervoltage"}, {21, "SUB_ERR_CAN_DRV_EMERGENCY_PIN", "can_drv_emergency_pin"}, {22, "SUB_ERR_CAN_DRV_FOC_DURATION", "can_drv_foc_duration"}, {23, "SUB_ERR_CAN_DRV_MCU_OVERHEAT", "can_drv_mcu_overheat"}, {24, "SUB_ERR_CAN_DRV_MOTOR_OVERHEAT", "can_drv_motor_overheat"}, {25, "SUB_ERR_CAN_DRV_OVERCURRENT_SOFT", "can_drv_overcurrent_soft"}, {26, "SUB_ERR_CAN_DRV_SEVERAL", "can_drv_several"}, {27, "SUB_ERR_CAN_EXT_BUS_OFF", "can_ext_bus_off"}, {28, "SUB_ERR_CAN_INT_BUS_OFF", "can_int_bus_off"}, {29, "SUB_ERR_ENCODER_NOT_FOUND", "encoder_not_found"}, {30, "SUB_ERR_CAN_DRV_NOT_RESPONDING", "can_drv_not_responding"}, {31, "SUB_ERR_CAN_DRV_WRONG_PARAMS", "can_drv_wrong_params"}, {32, "SUB_ERR_OVERCURRENT", "overcurrent"}, {33, "SUB_ERR_UNSAFE_VOLTAGE", "unsafe_voltage"}, {34, "SUB_ERR_WRONG_FULL_BAT_VOLTAGE_PARAM", "wrong_full_bat_voltage_param"}, {35, "SUB_ERR_EEPROM_PARAMS_CORRUPTED", "eeprom_params_corrupted"}, {36, "SUB_ERR_ENCODER_UNSUPPORTED_TYPE", "encoder_unsupported_type"}, {37, "SUB_ERR_EXT_IMU_UNSUPPORTED_TYPE", "ext_imu_unsupported_type"}, {38, "SUB_ERR_EXT_IMU_SENSOR_NOT_RESPONDING", "ext_imu_sensor_not_responding"}, {39, "SUB_ERR_EXT_IMU_WRONG_PARAMS", "ext_imu_wrong_params"}, {40, "SUB_ERR_DRIVER_INIT", "driver_init"}, {41, "SUB_ERR_EEPROM_VARS_OUT_OF_BORDERS", "eeprom_vars_out_of_borders"}, {42, "SUB_ERR_IWDG_RESET", "iwdg_reset"}, {43, "SUB_ERR_ADC_WAIT", "adc_wait"}, {44, "SUB_ERR_CALIB_MOTOR_OFF", "calib_motor_off"}, {45, "SUB_ERR_TIMEOUT", "timeout"}, {46, "SUB_ERR_CAN_DRV_CALIB_UNEXPECTED_RES", "can_drv_calib_unexpected_res"}, {47, "SUB_ERR_MAG_SENSOR_NOT_RESPONDING", "mag_sensor_not_responding"}, {48, "SUB_ERR_CAN_DRV_OVERSPEED", "can_drv_overspeed"}, {49, "SUB_ERR_ENC_SELF_CALIB_FAILED", "enc_self_calib_failed"}, {50, "SUB_ERR_CAN_VERSION_MISMATCH", "can_version_mismatch"}, {51, "SUB_ERR_CAN_SERIAL_INIT", "can_serial_init"}, {52, "SUB_ERR_CAN_SERIAL_CONFLICT", "can_serial_conflict"}, {53, "SUB_ERR_CAN_DRV_INIT_STAGE", "can_drv_init_stage"}, {54, "SUB_ERR_ENCODER_DATA_TIMEOUT", "encoder_data_timeout"}, {55, "SUB_ERR_CAN_CONNECTION_LOST", "can_connection_lost"}, {56, "SUB_ERR_HSE_START_FAIL", "hse_start_fail"}, {57, "SUB_ERR_FRAME_IMU_SENSOR_NOT_RESPONDING", "frame_imu_sensor_not_responding"}, {58, "SUB_ERR_PARAMETERS_MODIFIED", "parameters_modified"}, {59, "SUB_ERR_NOT_NORMAL_POSITION", "not_normal_position"}, {60, "SUB_ERR_CAN_DRV_LIMIT_EXCEED", "can_drv_limit_exceed"}}}
  enums.CalibMode = {values = {{0, "NONE", "none"}, {1, "EXT_GAIN", "ext_gain"}, {2, "SET_ANGLE_AND_SAVE", "set_angle_and_save"}, {3, "POLES", "poles"}, {4, "ACC", "acc"}, {5, "GYRO", "gyro"}, {6, "ENCODER_OFFSET", "encoder_offset"}, {7, "ENCODER_FLD_OFFSET", "encoder_fld_offset"}, {8, "AUTO_PID", "auto_pid"}, {9, "BODE_TEST", "bode_test"}, {10, "GYRO_TEMP", "gyro_temp"}, {11, "ACC_TEMP", "acc_temp"}, {12, "MAG", "mag"}, {13, "SET_ANGLE", "set_angle"}, {14, "SYSTEM_IDENT", "system_ident"}, {15, "MOTOR_MAG_LINK", "motor_mag_link"}, {16, "SEARCH_LIMITS", "search_limits"}, {17, "SET_OPERATION_POS", "set_operation_pos"}, {18, "IMU_ORIENTATION_CORR", "imu_orientation_corr"}, {19, "TIMELAPSE", "timelapse"}, {20, "MOMENTUM", "momentum"}, {21, "MOMENTUM_AUTO", "momentum_auto"}, {22, "COGGING", "cogging"}, {23, "ACC_EXT_REF", "acc_ext_ref"}, {24, "SAFE_STOP", "safe_stop"}, {25, "ACC_SPHERE", "acc_sphere"}, {26, "GYRO_AXES_ALIGNMENT", "gyro_axes_alignment"}, {27, "EXT_IMU_GYRO", "ext_imu_gyro"}, {28, "EXT_IMU_ALIGN", "ext_imu_align"}, {34, "ACC_GYRO_MULTIPOINT", "acc_gyro_multipoint"}, {35, "ENCODER_LUT", "encoder_lut"}, {36, "WRITE_PARAMS", "write_params"}, {37, "CUR_SENS", "cur_sens"}, {38, "MOVE_HOME_MOTORS", "move_home_motors"}, {39, "ENCODER_INT", "encoder_int"}, {40, "VIBRATION_TEST", "vibration_test"}, {41, "RETRACTED_POSITION", "retracted_position"}, {42, "RETRACTED_POSITION_RC_CONTROL", "retracted_position_rc_control"}}}
  enums.PowerState = {values = {{-2, "ON_FROM_BACKUP", "on_from_backup"}, {-1, "STARTUP", "startup"}, {0, "OFF", "off"}, {1, "ON", "on"}, {2, "OFF_TEMPORARY", "off_temporary"}, {3, "OFF_PARKING", "off_parking"}, {4, "ON_SAFE_STOP", "on_safe_stop"}}}
  enums.StreamSync = {values = {{0, "OFF", "off"}, {1, "IMU_ATTITUDE", "imu_attitude"}}}
  enums.ControlModeKind = {values = {{0, "MODE_NO_CONTROL", "no_control"}, {1, "MODE_SPEED", "speed"}, {2, "MODE_ANGLE", "angle"}, {3, "MODE_SPEED_ANGLE", "speed_angle"}, {4, "MODE_RC", "rc"}, {5, "MODE_ANGLE_REL_FRAME", "angle_rel_frame"}, {6, "MODE_RC_HIGH_RES", "rc_high_res"}, {7, "MODE_IGNORE", "ignore"}, {8, "MODE_ANGLE_SHORTEST", "angle_shortest"}}}
  enums.MotorsOffMode = {values = {{0, "NORMAL", "normal"}, {1, "BRAKE", "brake"}, {2, "SAFE_STOP", "safe_stop"}}}
  enums.CoordinateSystem = {values = {{1, "COORD_SYS_GROUND_YAW_ROTATED", "ground_yaw_rotated"}, {2, "COORD_SYS_GROUND_END", "ground_end"}, {3, "COORD_SYS_FRAME", "frame"}}}
  enums.EulerOrderChange = {values = {{0, "KEEP", "keep"}, {1, "PITCH_ROLL_YAW", "pitch_roll_yaw"}, {2, "ROLL_PITCH_YAW", "roll_pitch_yaw"}, {3, "LOCAL_ROLL", "local_roll"}, {4, "ROLL_LOCAL", "roll_local"}, {5, "YAW_ROLL_PITCH", "yaw_roll_pitch"}, {6, "YAW_PITCH_ROLL", "yaw_pitch_roll"}}}
  enums.ControlQuatMode = {values = {{0, "DISABLED", "disabled"}, {1, "SPEED", "speed"}, {2, "ATTITUDE", "attitude"}, {5, "SPEED_ATTITUDE", "speed_attitude"}, {9, "SPEED_LIMITED", "speed_limited"}}}
  enums.QuaternionComponent = {values = {{0, "W", "w"}, {1, "X", "x"}, {2, "Y", "y"}, {3, "Z", "z"}}}
  enums.SyncMotorAxis = {values = {{0, "ROLL", "roll"}, {1, "PITCH", "pitch"}, {2, "YAW", "yaw"}}}
  enums.EventId = {values = {{1, "MENU_BUTTON", "menu_button"}, {2, "MOTOR_STATE", "motor_state"}, {3, "EMERGENCY_STOP", "emergency_stop"}, {4, "CAMERA", "camera"}, {5, "SCRIPT", "script"}, {6, "RETRACTED_POSITION", "retracted_position"}}}
  enums.ExtMotorActionKind = {values = {{1, "OFF_FLOATING", "off_floating"}, {2, "OFF_BRAKE", "off_brake"}, {3, "OFF_SAFE", "off_safe"}, {4, "ON", "on"}, {5, "HOME_POSITION", "home_position"}, {6, "SEARCH_HOME", "search_home"}}}
  enums.ExtMotorMode = {values = {{0, "POSITION", "position"}, {1, "SPEED", "speed"}, {2, "TORQUE", "torque"}}}
  enums.ExtMotorPower = {values = {{0, "OFF_BRAKE", "off_brake"}, {1, "ON", "on"}, {2, "OFF_FLOATING", "off_floating"}, {3, "OFF_SAFE_STOP", "off_safe_stop"}}}
  enums.BodeAxis = {values = {{0, "ROLL", "roll"}, {1, "PITCH", "pitch"}, {2, "YAW", "yaw"}}}
  enums.BodeStimulus = {values = {{1, "WHITE_NOISE", "white_noise"}, {2, "SINE_SWEEP", "sine_sweep"}, {3, "EXPONENTIAL_SWEEP", "exponential_sweep"}}}
  enums.BodeSystem = {values = {{3, "CONTROLLER", "controller"}, {6, "OPEN_LOOP_PLANT_WITH_FILTERS", "open_loop_plant_with_filters"}, {7, "OPEN_LOOP_CONTROLLER_AND_PLANT", "open_loop_controller_and_plant"}, {11, "OVERALL", "overall"}, {70, "OPEN_LOOP_PLANT", "open_loop_plant"}, {134, "CLOSED_LOOP_PLANT_WITH_FILTERS", "closed_loop_plant_with_filters"}, {135, "CLOSED_LOOP_CONTROLLER_AND_PLANT", "closed_loop_controller_and_plant"}, {198, "CLOSED_LOOP_PLANT", "closed_loop_plant"}}}
  enums.CalibImu = {values = {{0, "ACTIVE", "active"}, {1, "MAIN", "main"}, {2, "FRAME", "frame"}}}
  enums.CalibAction = {values = {{1, "REGULAR", "regular"}, {2, "RESET", "reset"}, {3, "TEMPERATURE", "temperature"}, {4, "ENABLE_TEMPERATURE", "enable_temperature"}, {5, "DISABLE_TEMPERATURE", "disable_temperature"}, {6, "RESTORE_FACTORY", "restore_factory"}, {7, "STORE_IN_SENSOR", "store_in_sensor"}}}
  enums.CalibMotor = {values = {{0, "ROLL", "roll"}, {1, "PITCH", "pitch"}, {2, "YAW", "yaw"}, {255, "ALL", "all"}}}
  enums.AutoPid2Action = {values = {{1, "START", "start"}, {2, "START_SAVE", "start_save"}, {3, "SAVE", "save"}, {5, "STOP", "stop"}, {6, "READ", "read"}}}
  enums.CoggingAction = {values = {{1, "CALIBRATE", "calibrate"}, {2, "DELETE", "erase"}}}
  enums.ImuIndex = {values = {{0, "MAIN", "main"}, {1, "FRAME", "frame"}}}
  enums.AhrsReference = {values = {{0, "NONE", "none"}, {1, "INTERNAL", "internal"}, {2, "EXTERNAL", "external"}, {3, "TRANSLATE", "translate"}}}
  enums.ExtImuState = {values = {{0, "DISABLED", "disabled"}, {1, "NOT_CONNECTED", "not_connected"}, {2, "UNKNOWN", "unknown"}, {3, "ERROR", "error"}, {4, "BAD", "bad"}, {5, "COARSE", "coarse"}, {6, "GOOD", "good"}, {7, "FINE", "fine"}}}
  enums.ExtSensCommand = {values = {{1, "CONFIRM", "confirm"}, {2, "RESET", "reset"}, {3, "RESET_NOTIFY", "reset_notify"}, {4, "GET_DEVICE_INFO", "get_device_info"}, {5, "DEVICE_INFO", "device_info"}, {6, "GET_DATA", "get_data"}, {7, "GET_DATA_STREAM", "get_data_stream"}, {8, "DATA", "data"}, {9, "CALIB", "calib"}, {10, "BOOT_MODE", "boot_mode"}, {11, "USER_DATA_LOG", "user_data_log"}, {12, "GET_USER_CONF_LOG", "get_user_conf_log"}, {13, "USER_CONF_LOG", "user_conf_log"}}}
  enums.BoardPin = {values = {{1, "RC_INPUT_ROLL", "rc_input_roll"}, {2, "RC_INPUT_PITCH", "rc_input_pitch"}, {3, "EXT_FC_INPUT_ROLL", "ext_fc_input_roll"}, {4, "EXT_FC_INPUT_PITCH", "ext_fc_input_pitch"}, {5, "RC_INPUT_YAW", "rc_input_yaw"}, {16, "PIN_AUX1", "pin_aux1"}, {17, "PIN_AUX2", "pin_aux2"}, {18, "PIN_AUX3", "pin_aux3"}, {32, "PIN_BUZZER", "pin_buzzer"}, {33, "PIN_SSAT_POWER", "pin_ssat_power"}}}
  enums.OutputPin = {values = {{1, "RC_INPUT_ROLL", "rc_input_roll"}, {2, "RC_INPUT_PITCH", "rc_input_pitch"}, {3, "EXT_FC_INPUT_ROLL", "ext_fc_input_roll"}, {4, "EXT_FC_INPUT_PITCH", "ext_fc_input_pitch"}, {5, "RC_INPUT_YAW", "rc_input_yaw"}, {16, "PIN_AUX1", "pin_aux1"}, {17, "PIN_AUX2", "pin_aux2"}, {18, "PIN_AUX3", "pin_aux3"}, {32, "PIN_BUZZER", "pin_buzzer"}, {33, "PIN_SSAT_POWER", "pin_ssat_power"}, {64, "CAN_DRV1_AUX1", "can_drv1_aux1"}, {65, "CAN_DRV1_AUX2", "can_drv1_aux2"}, {66, "CAN_DRV1_AUX3", "can_drv1_aux3"}, {67, "CAN_DRV2_AUX1", "can_drv2_aux1"}, {68, "CAN_DRV2_AUX2", "can_drv2_aux2"}, {69, "CAN_DRV2_AUX3", "can_drv2_aux3"}, {70, "CAN_DRV3_AUX1", "can_drv3_aux1"}, {71, "CAN_DRV3_AUX2", "can_drv3_aux2"}, {72, "CAN_DRV3_AUX3", "can_drv3_aux3"}, {73, "CAN_DRV4_AUX1", "can_drv4_aux1"}, {74, "CAN_DRV4_AUX2", "can_drv4_aux2"}, {75, "CAN_DRV4_AUX3", "can_drv4_aux3"}, {76, "CAN_DRV5_AUX1", "can_drv5_aux1"}, {77, "CAN_DRV5_AUX2", "can_drv5_aux2"}, {78, "CAN_DRV5_AUX3", "can_drv5_aux3"}, {79, "CAN_DRV6_AUX1", "can_drv6_aux1"}, {80, "CAN_DRV6_AUX2", "can_drv6_aux2"}, {81, "CAN_DRV6_AUX3", "can_drv6_aux3"}, {82, "CAN_DRV7_AUX1", "can_drv7_aux1"}, {83, "CAN_DRV7_AUX2", "can_drv7_aux2"}, {84, "CAN_DRV7_AUX3", "can_drv7_aux3"}, {85, "CAN_IMU_AUX1", "can_imu_aux1"}, {86, "CAN_IMU_AUX2", "can_imu_aux2"}, {88, "CAN_IMU_FRAME_AUX1", "can_imu_frame_aux1"}, {89, "CAN_IMU_FRAME_AUX2", "can_imu_frame_aux2"}}}
  enums.PinState = {values = {{0, "LOW", "low"}, {1, "HIGH", "high"}, {2, "FLOATING", "floating"}, {3, "INPUT_PULL_UP", "input_pull_up"}, {4, "INPUT_PULL_DOWN", "input_pull_down"}}}
  enums.I2cPort = {values = {{0, "MAIN", "main"}, {1, "SECOND", "second"}}}
  enums.ModuleId = {values = {{1, "IMU_MAIN", "imu_main"}, {2, "IMU_FRAME", "imu_frame"}, {3, "CAN_DRV1", "can_drv1"}, {4, "CAN_DRV2", "can_drv2"}, {5, "CAN_DRV3", "can_drv3"}, {6, "CAN_DRV4", "can_drv4"}, {7, "CAN_DRV5", "can_drv5"}, {8, "CAN_DRV6", "can_drv6"}, {9, "CAN_DRV7", "can_drv7"}, {10, "GPS_IMU", "gps_imu"}, {11, "CAN_HUB_GNSS", "can_hub_gnss"}, {12, "CAN_HUB1", "can_hub1"}, {13, "CAN_HUB2", "can_hub2"}, {14, "UDRV1", "udrv1"}, {15, "UDRV2", "udrv2"}, {16, "UDRV3", "udrv3"}, {17, "UDRV4", "udrv4"}}}
  enums.CanDeviceId = {values = {{0, "NOT_ASSIGNED", "not_assigned"}, {5, "CAN_IMU_MAIN", "can_imu_main"}, {6, "CAN_IMU_FRAME", "can_imu_frame"}, {7, "GPS_IMU_MAIN", "gps_imu_main"}, {17, "CAN_DRV1", "can_drv1"}, {18, "CAN_DRV2", "can_drv2"}, {19, "CAN_DRV3", "can_drv3"}, {20, "CAN_DRV4", "can_drv4"}, {21, "CAN_DRV5", "can_drv5"}, {22, "CAN_DRV6", "can_drv6"}, {23, "CAN_DRV7", "can_drv7"}, {28, "CAN_IMU_MAIN_OLD", "can_imu_main_old"}, {29, "CAN_IMU_FRAME_OLD", "can_imu_frame_old"}}}
  enums.CanDeviceKind = {values = {{1, "MOTOR_DRIVER", "motor_driver"}, {2, "IMU", "imu"}}}
  enums.TransparentDevice = {values = {{1, "SBGC32", "sbgc32"}, {2, "GPS_IMU", "gps_imu"}, {3, "CAN_IMU_MAIN", "can_imu_main"}, {4, "CAN_IMU_FRAME", "can_imu_frame"}, {5, "GPS_SPLIT_RCVR", "gps_split_rcvr"}, {6, "CAN_SERIAL_HUB1", "can_serial_hub1"}, {7, "CAN_SERIAL_HUB2", "can_serial_hub2"}, {8, "CAN_DRV1", "can_drv1"}, {9, "CAN_DRV2", "can_drv2"}, {10, "CAN_DRV3", "can_drv3"}, {11, "CAN_DRV4", "can_drv4"}}}
  enums.FileError = {values = {{0, "NO_ERROR", "no_error"}, {1, "ERR_EEPROM_FAULT", "eeprom_fault"}, {2, "ERR_FILE_NOT_FOUND", "file_not_found"}, {3, "ERR_FAT", "fat"}, {4, "ERR_NO_FREE_SPACE", "no_free_space"}, {5, "ERR_FAT_IS_FULL", "fat_is_full"}, {6, "ERR_FILE_SIZE", "file_size"}, {7, "ERR_CRC", "crc"}, {8, "ERR_LIMIT_REACHED", "limit_reached"}, {9, "ERR_FILE_CORRUPTED", "file_corrupted"}, {10, "ERR_WRONG_PARAMS", "wrong_params"}}}
  enums.ScriptMode = {values = {{0, "STOP", "stop"}, {1, "START", "start"}, {2, "START_DEBUG", "start_debug"}}}
  enums.DebugVarKind = {values = {{1, "VAR_TYPE_UINT8", "uint8"}, {2, "VAR_TYPE_INT8", "int8"}, {3, "VAR_TYPE_UINT16", "uint16"}, {4, "VAR_TYPE_INT16", "int16"}, {5, "VAR_TYPE_UINT32", "uint32"}, {6, "VAR_TYPE_INT32", "int32"}, {7, "VAR_TYPE_FLOAT", "float32"}}}
  enums.DebugVarAxis = {values = {{0, "NO_AXIS", "no_axis"}, {16, "VAR_FLAG_ROLL", "roll"}, {32, "VAR_FLAG_PITCH", "pitch"}, {48, "VAR_FLAG_YAW", "yaw"}}}
  enums.DebugPortAction = {values = {{0, "STOP", "stop"}, {1, "START", "start"}}}
  enums.BoardFeatures = {is_flags = true, values = {{1, "BOARD_FEATURE_3AXIS", "three_axis"}, {2, "BOARD_FEATURE_BAT_MONITORING", "bat_monitoring"}, {4, "BOARD_FEATURE_ENCODERS", "encoders"}, {8, "BOARD_FEATURE_BODE_TEST", "bode_test"}, {16, "BOARD_FEATURE_SCRIPTING", "scripting"}, {32, "BOARD_FEATURE_CURRENT_SENSOR", "current_sensor"}, {64, "BOARD_FEATURE_MAG_SENSOR", "mag_sensor"}, {128, "BOARD_FEATURE_ORDER_OF_AXES_LETUS", "order_of_axes_letus"}, {256, "BOARD_FEATURE_IMU_EEPROM", "imu_eeprom"}, {512, "BOARD_FEATURE_FRAME_IMU_EEPROM", "frame_imu_eeprom"}, {1024, "BOARD_FEATURE_CAN_PORT", "can_port"}, {2048, "BOARD_FEATURE_MOMENTUM", "momentum"}, {4096, "BOARD_FEATURE_COGGING_CORRECTION", "cogging_correction"}, {8192, "BOARD_FEATURE_MOTOR4_CONTROL", "motor4_control"}, {16384, "BOARD_FEATURE_ACC_AUTO_CALIB", "acc_auto_calib"}, {32768, "BOARD_FEATURE_BIG_FLASH", "big_flash"}}}
  enums.BoardFeaturesExt = {is_flags = true, values = {{1, "EXT_IMU", "ext_imu"}, {4, "STATE_VARS", "state_vars"}, {8, "POWER_MANAGEMENT", "power_management"}, {16, "GYRO_ADVANCED_CALIB", "gyro_advanced_calib"}, {32, "LIMITED_VERSION", "limited_version"}, {64, "REACTION", "reaction"}, {128, "ENCODER_LUT", "encoder_lut"}}}
  enums.BoardFeaturesExt2 = {is_flags = true, values = {{1, "PLUS_VER", "plus_ver"}, {2, "SHAKE_GENERATOR", "shake_generator"}, {4, "EXT_MOTORS", "ext_motors"}, {8, "QUAT_CONTROL", "quat_control"}, {16, "ADC4", "adc4"}}}
  enums.BoardStateFlags = {is_flags = true, values = {{1, "DEBUG_MODE", "debug_mode"}, {2, "IS_FRAME_INVERTED", "is_frame_inverted"}, {4, "INIT_STEP1_DONE", "init_step1_done"}, {8, "INIT_STEP2_DONE", "init_step2_done"}, {16, "STARTUP_AUTO_ROUTINE_DONE", "startup_auto_routine_done"}, {32, "POWER_MANAGER_ENABLED", "power_manager_enabled"}}}
  enums.HardwareFlags = {is_flags = true, values = {{1, "ONE_WIRE_CRYPTO_IC", "one_wire_crypto_ic"}}}
  enums.StoredProfileSets = {is_flags = true, values = {{1, "PROFILE_SET1", "set1"}, {2, "PROFILE_SET2", "set2"}, {4, "PROFILE_SET3", "set3"}, {8, "PROFILE_SET4", "set4"}, {16, "PROFILE_SET5", "set5"}, {32, "PROFILE_SET_BACKUP", "set_backup"}}}
  enums.ConnectionFlags = {is_flags = true, values = {{1, "CONNECTION_USB", "usb"}}}
  enums.ResetOptions = {is_flags = true, values = {{1, "NOTIFY", "notify"}, {2, "RESTORE_STATE", "restore_state"}}}
  enums.PassProtectFlags = {is_flags = true, values = {{2, "ENCRYPT_PARAMS", "encrypt_params"}, {4, "SILENT", "silent"}, {16, "CHANNEL_1_ENABLED", "channel_1_enabled"}, {32, "CHANNEL_2_ENABLED", "channel_2_enabled"}, {64, "CHANNEL_3_ENABLED", "channel_3_enabled"}, {128, "CHANNEL_4_ENABLED", "channel_4_enabled"}, {256, "CHANNEL_5_ENABLED", "channel_5_enabled"}, {512, "CHANNEL_6_ENABLED", "channel_6_enabled"}, {1024, "CHANNEL_1_ALLOW_CONTROL", "channel_1_allow_control"}, {2048, "CHANNEL_2_ALLOW_CONTROL", "channel_2_allow_control"}, {4096, "CHANNEL_3_ALLOW_CONTROL", "channel_3_allow_control"}, {8192, "CHANNEL_4_ALLOW_CONTROL", "channel_4_allow_control"}, {16384, "CHANNEL_5_ALLOW_CONTROL", "channel_5_allow_control"}, {32768, "CHANNEL_6_ALLOW_CONTROL", "channel_6_allow_control"}}}
  enums.FilterSwitches = {is_flags = true, values = {{1, "EN_NOTCH1", "notch1"}, {2, "EN_NOTCH2", "notch2"}, {4, "EN_NOTCH3", "notch3"}, {8, "EN_LPF", "lpf"}}}
  enums.EncoderFlags = {is_flags = true, values = {{16, "SKIP_DETECTION", "skip_detection"}, {128, "ENCODER_IS_GEARED", "encoder_is_geared"}}}
  enums.BeeperModes = {is_flags = true, values = {{1, "BEEPER_MODE_CALIBRATE", "calibrate"}, {2, "BEEPER_MODE_CONFIRM", "confirm"}, {4, "BEEPER_MODE_ERROR", "error"}, {8, "BEEPER_MODE_ALARM", "alarm"}, {128, "BEEP_BY_MOTORS", "by_motors"}}}
  enums.AdaptivePidAxes = {is_flags = true, values = {{1, "EN_ROLL", "roll"}, {2, "EN_PITCH", "pitch"}, {4, "EN_YAW", "yaw"}}}
  enums.GeneralFlags = {is_flags = true, values = {{1, "REMEMBER_LAST_USED_PROFILE", "remember_last_used_profile"}, {2, "UPSIDE_DOWN_AUTO", "upside_down_auto"}, {4, "SWAP_FRAME_MAIN_IMU", "swap_frame_main_imu"}, {8, "BLINK_PROFILE", "blink_profile"}, {16, "EMERGENCY_STOP", "emergency_stop"}, {32, "MAGNETOMETER_POS_FRAME", "magnetometer_pos_frame"}, {64, "FRAME_IMU_FF", "frame_imu_ff"}, {128, "OVERHEAT_STOP_MOTORS", "overheat_stop_motors"}, {256, "CENTER_YAW_AT_STARTUP", "center_yaw_at_startup"}, {512, "SWAP_RC_SERIAL_UART_B", "swap_rc_serial_uart_b"}, {1024, "UART_B_SERIAL_API", "uart_b_serial_api"}, {2048, "BLINK_BAT_LEVEL", "blink_bat_level"}, {4096, "ADAPTIVE_GYRO_TRUST", "adaptive_gyro_trust"}, {8192, "IS_UPSIDE_DOWN", "is_upside_down"}, {16384, "UART_3_SERIAL_API", "uart_3_serial_api"}, {32768, "FRAME_INV_RC_INV", "frame_inv_rc_inv"}}}
  enums.GeneralFlags2 = {is_flags = true, values = {{1, "SEARCH_LIMIT_ROLL", "search_limit_roll"}, {2, "SEARCH_LIMIT_PITCH", "search_limit_pitch"}, {4, "SEARCH_LIMIT_YAW", "search_limit_yaw"}, {8, "AUTO_CALIBRATE_MOMENTUM", "auto_calibrate_momentum"}, {16, "USE_MOMENTUM_FEED_FORWARD", "use_momentum_feed_forward"}, {32, "MOTORS_OFF_AT_STARTUP", "motors_off_at_startup"}, {64, "FC_BELOW_OUTER", "fc_below_outer"}, {128, "DO_NOT_CHECK_ENCODER_LIMITS", "do_not_check_encoder_limits"}, {256, "AUTO_SAVE_BACKUP_SLOT", "auto_save_backup_slot"}, {512, "FC_BELOW_MIDDLE", "fc_below_middle"}, {1024, "ENVIRONMENT_TEMP_UNKNOWN", "environment_temp_unknown"}, {2048, "LPF_EXTENDED_RANGE", "lpf_extended_range"}, {4096, "SAVE_SYSTEM_STAT", "save_system_stat"}, {8192, "DISABLE_ACC", "disable_acc"}, {16384, "DISABLE_POWER_MANAGER", "disable_power_manager"}, {32768, "ALLOW_ONBOARD_IMU_AS_MAIN", "allow_onboard_imu_as_main"}}}
  enums.ProfileFlags = {is_flags = true, values = {{1, "ADC1_AUTO_DETECTION", "adc1_auto_detection"}, {2, "ADC2_AUTO_DETECTION", "adc2_auto_detection"}, {4, "ADC3_AUTO_DETECTION", "adc3_auto_detection"}, {16, "FOLLOW_USE_FRAME_IMU", "follow_use_frame_imu"}, {32, "BRIEFCASE_AUTO_DETECTION", "briefcase_auto_detection"}, {64, "UPSIDE_DOWN_AUTO_ROTATE", "upside_down_auto_rotate"}, {128, "FOLLOW_LOCK_OFFSET_CORRECTION", "follow_lock_offset_correction"}, {256, "START_NEUTRAL_POSITION", "start_neutral_position"}, {512, "MENU_BUTTON_DISABLE_FOLLOW", "menu_button_disable_follow"}, {1024, "TIMELAPSE_FRAME_FIXED", "timelapse_frame_fixed"}, {2048, "RC_KEEP_MIX_RATE", "rc_keep_mix_rate"}, {4096, "RC_KEEP_CUR_POS_ON_INIT", "rc_keep_cur_pos_on_init"}, {8192, "OUTER_MOTOR_LIMIT_FREE_ROTATION", "outer_motor_limit_free_rotation"}, {16384, "EULER_ORDER_AUTO", "euler_order_auto"}, {32768, "CAM_UPSIDE_DOWN_WORKING", "cam_upside_down_working"}}}
  enums.ParkingBorders = {is_flags = true, values = {{1, "ROLL_NEG", "roll_neg"}, {2, "ROLL_POS", "roll_pos"}, {4, "PITCH_NEG", "pitch_neg"}, {8, "PITCH_POS", "pitch_pos"}, {16, "YAW_NEG", "yaw_neg"}, {32, "YAW_POS", "yaw_pos"}}}
  enums.EulerOrderFlags = {is_flags = true, values = {{16, "CONTROL_LOCAL_XYZ", "control_local_xyz"}, {32, "STAB_CONTROL_LOCAL_XYZ", "stab_control_local_xyz"}}}
  enums.ExtImuFlags = {is_flags = true, values = {{2, "ACC_COMP_ONLY", "acc_comp_only"}, {4, "REPLACE", "replace"}, {8, "Z", "z"}, {16, "H", "h"}, {32, "FRAME_UPSIDE_DOWN_UPDATE", "frame_upside_down_update"}, {64, "AS_FRAME_IMU", "as_frame_imu"}, {128, "GYRO_CORR", "gyro_corr"}}}
  enums.GeneralFlags3 = {is_flags = true, values = {{1, "ENC_LUT_EN_ROLL", "enc_lut_en_roll"}, {2, "ENC_LUT_EN_PITCH", "enc_lut_en_pitch"}, {4, "ENC_LUT_EN_YAW", "enc_lut_en_yaw"}, {8, "MAVLINK_YAW_ABSOLUTE", "mavlink_yaw_absolute"}, {16, "EXT_SENS_AS_REFERENCE", "ext_sens_as_reference"}, {32, "DISABLE_BT", "disable_bt"}, {64, "ALLOW_SENSOR_RECOVERY", "allow_sensor_recovery"}, {128, "UART2_ALT", "uart2_alt"}, {256, "PASS_LIMIT_ROLL", "pass_limit_roll"}, {512, "PASS_LIMIT_PITCH", "pass_limit_pitch"}, {1024, "PASS_LIMIT_YAW", "pass_limit_yaw"}, {2048, "DONT_PUSH_SOFT_LIMITS_ROLL", "dont_push_soft_limits_roll"}, {4096, "DONT_PUSH_SOFT_LIMITS_PITCH", "dont_push_soft_limits_pitch"}, {8192, "DONT_PUSH_SOFT_LIMITS_YAW", "dont_push_soft_limits_yaw"}, {16384, "TRIPOD_MODE_AUTO", "tripod_mode_auto"}, {32768, "TRIPOD_MODE_GYRO_ONLINE_CALIB", "tripod_mode_gyro_online_calib"}, {65536, "RETRACTED_POSITION_MOTORS_OFF", "retracted_position_motors_off"}, {131072, "CAN_IMU_THERMOSTAT_ENABLE", "can_imu_thermostat_enable"}, {262144, "RETRACTED_POSITION_SHORTEST", "retracted_position_shortest"}, {524288, "RETRACTED_POSITION_RC_CONTROL", "retracted_position_rc_control"}, {1048576, "ACC_LIMIT_EXT_RANGE", "acc_limit_ext_range"}, {2097152, "MOVE_SHORT_PATH_ROLL", "move_short_path_roll"}, {4194304, "MOVE_SHORT_PATH_PITCH", "move_short_path_pitch"}, {8388608, "MOVE_SHORT_PATH_YAW", "move_short_path_yaw"}, {16777216, "FRAME_INV_SOFT_LIMIT_MIDDLE", "frame_inv_soft_limit_middle"}, {33554432, "FRAME_INV_SOFT_LIMIT_OUTER", "frame_inv_soft_limit_outer"}, {67108864, "CAN_IMU_SERVO1_DUTY_MODE", "can_imu_servo1_duty_mode"}, {134217728, "CAN_IMU_SERVO2_DUTY_MODE", "can_imu_servo2_duty_mode"}}}
  enums.GeneralFlags4 = {is_flags = true, values = {{1, "ACC_LIMIT_BY_MOMENTUM", "acc_limit_by_momentum"}, {2, "CALIB_MOMENTUM_IN_NORMAL_POS", "calib_momentum_in_normal_pos"}, {4, "EULER_MIDDLE_AXIS", "euler_middle_axis"}, {8, "EULER_MATCH_MOTOR_ROTATION", "euler_match_motor_rotation"}}}
  enums.ProfileFlags2 = {is_flags = true, values = {{1, "FOLLOW_PITCH_DISABLED", "follow_pitch_disabled"}, {2, "LOW_ANGLE_PRIOR_ROLL", "low_angle_prior_roll"}, {4, "LOW_ANGLE_PRIOR_PITCH", "low_angle_prior_pitch"}, {8, "LOW_ANGLE_PRIOR_YAW", "low_angle_prior_yaw"}, {16, "HEADING_TRIPOD_MODE", "heading_tripod_mode"}, {32, "MOT_ROLL_DISABLED", "mot_roll_disabled"}, {64, "MOT_PITCH_DISABLED", "mot_pitch_disabled"}, {128, "MOT_YAW_DISABLED", "mot_yaw_disabled"}, {256, "RC_OUT_DUTY1", "rc_out_duty1"}, {512, "RC_OUT_DUTY2", "rc_out_duty2"}, {1024, "RC_OUT_DUTY3", "rc_out_duty3"}, {2048, "RC_OUT_DUTY4", "rc_out_duty4"}, {4096, "DISABLE_FOLLOW_STARTUP", "disable_follow_startup"}, {8192, "SERVO_MODE", "servo_mode"}, {16384, "RC_EXPO_DEADBAND_SPLIT", "rc_expo_deadband_split"}}}
  enums.ProfileFlags3 = {is_flags = true, values = {{1, "ACC_LIMIT_AUTO_R", "acc_limit_auto_r"}, {2, "ACC_LIMIT_AUTO_P", "acc_limit_auto_p"}, {4, "ACC_LIMIT_AUTO_Y", "acc_limit_auto_y"}, {8, "SHAKE_GENERATOR_ENABLED", "shake_generator_enabled"}, {16, "ERR_CORR_LONG_R", "err_corr_long_r"}, {32, "ERR_CORR_LONG_P", "err_corr_long_p"}, {64, "ERR_CORR_LONG_Y", "err_corr_long_y"}}}
  enums.SystemErrors = {is_flags = true, values = {{1, "ERR_NO_SENSOR", "no_sensor"}, {2, "ERR_CALIB_ACC", "calib_acc"}, {4, "ERR_SET_POWER", "set_power"}, {8, "ERR_CALIB_POLES", "calib_poles"}, {16, "ERR_PROTECTION", "protection"}, {32, "ERR_SERIAL", "serial"}, {64, "ERR_LOW_BAT1", "low_bat1"}, {128, "ERR_LOW_BAT2", "low_bat2"}, {256, "ERR_GUI_VERSION", "gui_version"}, {512, "ERR_MISS_STEPS", "miss_steps"}, {1024, "ERR_SYSTEM", "system"}, {2048, "ERR_EMERGENCY_STOP", "emergency_stop"}}}
  enums.OtherFlags = {is_flags = true, values = {{1, "MOTORS_ON", "motors_on"}}}
  enums.RealtimeDataCustomFlags = {is_flags = true, values = {{1, "IMU_ANGLES", "imu_angles"}, {2, "TARGET_ANGLES", "target_angles"}, {4, "TARGET_SPEED", "target_speed"}, {8, "STATOR_ROTOR_ANGLE", "stator_rotor_angle"}, {16, "GYRO_DATA", "gyro_data"}, {32, "RC_DATA", "rc_data"}, {64, "Z1_H1_VECTORS", "z1_h1_vectors"}, {128, "RC_CHANNELS", "rc_channels"}, {256, "ACC_DATA", "acc_data"}, {512, "MOTOR4_CONTROL", "motor4_control"}, {1024, "AHRS_DEBUG_INFO", "ahrs_debug_info"}, {2048, "ENCODER_RAW24", "encoder_raw24"}, {4096, "IMU_ANGLES_RAD", "imu_angles_rad"}, {8192, "SCRIPT_VARS_FLOAT", "script_vars_float"}, {16384, "SCRIPT_VARS_INT16", "script_vars_int16"}, {32768, "SYSTEM_POWER_STATE", "system_power_state"}, {65536, "FRAME_CAM_RATE", "frame_cam_rate"}, {131072, "IMU_ANGLES_20", "imu_angles_20"}, {262144, "TARGET_ANGLES_20", "target_angles_20"}, {524288, "COMM_ERRORS", "comm_errors"}, {1048576, "SYSTEM_STATE", "system_state"}, {2097152, "IMU_QUAT", "imu_quat"}, {4194304, "TARGET_QUAT", "target_quat"}, {8388608, "IMU_TO_FRAME_QUAT", "imu_to_frame_quat"}, {16777216, "ADC_CH_RAW", "adc_ch_raw"}, {33554432, "SW_LIMITS_DIST", "sw_limits_dist"}, {67108864, "FOLLOW_DIST", "follow_dist"}, {134217728, "EXT_TARGET_LIMIT", "ext_target_limit"}, {268435456, "FRAME_CAM_ANGLE_20", "frame_cam_angle_20"}, {536870912, "MAIN_IMU_STATE", "main_imu_state"}, {2147483648, "INCLUDE_FLAGS", "include_flags"}}}
  enums.RealtimeDataCustom2Flags = {is_flags = true, values = {{1, "FRAME_IMU_ANGLES", "frame_imu_angles"}, {2, "FRAME_GYRO", "frame_gyro"}, {4, "FRAME_ACC", "frame_acc"}, {8, "DEBUG", "debug"}, {16, "MAG_SENS_DATA", "mag_sens_data"}, {32, "PIN_STATE", "pin_state"}, {64, "STAB_ERR_AMPL", "stab_err_ampl"}, {2147483648, "INCLUDE_FLAGS", "include_flags"}}}
  enums.StateFlags = {is_flags = true, values = {{1, "DEBUG_MODE", "debug_mode"}, {2, "IS_FRAME_INVERTED", "is_frame_inverted"}, {4, "INIT_STEP1_DONE", "init_step1_done"}, {8, "INIT_STEP2_DONE", "init_step2_done"}, {16, "STARTUP_AUTO_ROUTINE_DONE", "startup_auto_routine_done"}, {32, "POWER_MANAGER_ENABLED", "power_manager_enabled"}, {256, "SHAKE_GEN_ENABLED", "shake_gen_enabled"}, {512, "SERVO_MODE_ENABLED", "servo_mode_enabled"}, {1024, "FOLLOW_MODE_ROLL", "follow_mode_roll"}, {2048, "FOLLOW_MODE_PITCH", "follow_mode_pitch"}, {4096, "FOLLOW_MODE_YAW", "follow_mode_yaw"}, {8192, "TRIPOD_MODE_ENABLED", "tripod_mode_enabled"}, {16384, "RETRACTED_POSITION", "retracted_position"}}}
  enums.MotorPowerFlags = {is_flags = true, values = {{1, "SW_LIMIT_VIOLATED", "sw_limit_violated"}, {2, "CURRENT_EXCEEDS_LIMIT", "current_exceeds_limit"}, {4, "DRIVER_ENABLED", "driver_enabled"}}}
  enums.SystemPowerFlags = {is_flags = true, values = {{1, "SW_LIMIT_VIOLATED", "sw_limit_violated"}, {2, "OVERHEAT_WARNING", "overheat_warning"}, {4, "DRIVER_OTW", "driver_otw"}, {8, "DRIVER_FAULT", "driver_fault"}}}
  enums.CanErrorFlags = {is_flags = true, values = {{1, "WARN", "warn"}, {2, "PASSIVE", "passive"}, {4, "BUS_OFF", "bus_off"}}}
  enums.CanDrvTelemetryFlags = {is_flags = true, values = {{1, "CAN_BUS_FLAGS", "can_bus_flags"}, {2, "CAN_BUS_ERR_CNT", "can_bus_err_cnt"}, {4, "TEMP_BOARD", "temp_board"}, {8, "TEMP_MOTOR", "temp_motor"}, {16, "AVG_CURRENT", "avg_current"}, {32, "BUS_VOLTAGE", "bus_voltage"}, {64, "PIN_STATE", "pin_state"}, {128, "PHASE_CURRENT", "phase_current"}, {256, "ENCODER_ERROR_CNT", "encoder_error_cnt"}, {512, "IQ_ID_CURRENT", "iq_id_current"}, {1024, "MOTOR_SPEED", "motor_speed"}, {2048, "PID_POS_ERR", "pid_pos_err"}, {4096, "PID_SPEED_ERR", "pid_speed_err"}, {8192, "IQ_REF", "iq_ref"}, {16384, "PID_CURRENT_ERR", "pid_current_err"}}}
  enums.CanDrvPins = {is_flags = true, values = {{1, "LIMIT", "limit"}, {2, "INDEX", "index"}, {4, "EMERGENCY", "emergency"}, {8, "AUX1", "aux1"}, {16, "AUX2", "aux2"}, {32, "AUX3", "aux3"}, {64, "HALF_BRIDGE_ENABLE", "half_bridge_enable"}, {128, "ENCODER_SPI_CS", "encoder_spi_cs"}}}
  enums.ControlFlags = {is_flags = true, values = {{16, "CONTROL_FLAG_MIX_FOLLOW", "mix_follow"}, {32, "CONTROL_FLAG_TARGET_PRECISE", "target_precise"}, {64, "CONTROL_FLAG_AUTO_TASK", "auto_task"}, {128, "CONTROL_FLAG_HIGH_RES_SPEED", "high_res_speed"}}}
  enums.ControlExtFields = {is_flags = true, values = {{1, "ROLL_SPEED", "roll_speed"}, {2, "ROLL_ANGLE", "roll_angle"}, {4, "ROLL_ANGLE_32BIT", "roll_angle_32bit"}, {8, "ROLL_SPEED_32BIT", "roll_speed_32bit"}, {32, "PITCH_SPEED", "pitch_speed"}, {64, "PITCH_ANGLE", "pitch_angle"}, {128, "PITCH_ANGLE_32BIT", "pitch_angle_32bit"}, {256, "PITCH_SPEED_32BIT", "pitch_speed_32bit"}, {1024, "YAW_SPEED", "yaw_speed"}, {2048, "YAW_ANGLE", "yaw_angle"}, {4096, "YAW_ANGLE_32BIT", "yaw_angle_32bit"}, {8192, "YAW_SPEED_32BIT", "yaw_speed_32bit"}}}
  enums.ControlExtFlags = {is_flags = true, values = {{1, "DISABLE_ANGLE_ERR_CORR", "disable_angle_err_corr"}}}
  enums.ControlConfigFlags = {is_flags = true, values = {{1, "CONTROL_CONFIG_FLAG_NO_CONFIRM", "no_confirm"}, {2, "CONTROL_CONFIG_FLAG_SERVO_MODE_ENABLE", "servo_mode_enable"}, {4, "CONTROL_CONFIG_FLAG_SERVO_MODE_DISABLE", "servo_mode_disable"}, {8, "CONTROL_CONFIG_FLAG_LPF_EXT_RANGE", "lpf_ext_range"}, {16, "CONTROL_CONFIG_FLAG_LPF_FREQUENCY_HZ", "lpf_frequency_hz"}}}
  enums.ControlQuatFlags = {is_flags = true, values = {{1, "CONFIRM", "confirm"}, {2, "ATTITUDE_PACKED", "attitude_packed"}, {4, "ATTITUDE_LIMITED_180", "attitude_limited_180"}, {8, "ATTITUDE_REMOVE_ABSENT_AXES", "attitude_remove_absent_axes"}, {64, "AUTO_TASK", "auto_task"}}}
  enums.ControlQuatStatusFlags = {is_flags = true, values = {{1, "CONFIRM", "confirm"}, {2, "ATTITUDE_PACKED", "attitude_packed"}, {4, "ATTITUDE_LIMITED_180", "attitude_limited_180"}, {8, "ATTITUDE_REMOVE_ABSENT_AXES", "attitude_remove_absent_axes"}, {64, "AUTO_TASK", "auto_task"}}}
  enums.ControlQuatStatusFields = {is_flags = true, values = {{1, "MODE", "mode"}, {2, "TARGET_ATTITUDE", "target_attitude"}, {4, "SETPOINT_ATTITUDE", "setpoint_attitude"}, {8, "ACTUAL_ATTITUDE", "actual_attitude"}, {16, "TARGET_SPEED", "target_speed"}, {32, "SETPOINT_SPEED", "setpoint_speed"}, {64, "ACTUAL_SPEED", "actual_speed"}, {128, "TARGET_ATTITUDE_PACKED", "target_attitude_packed"}, {256, "SETPOINT_ATTITUDE_PACKED", "setpoint_attitude_packed"}, {512, "ACTUAL_ATTITUDE_PACKED", "actual_attitude_packed"}}}
  enums.ControlQuatConfigFields = {is_flags = true, values = {{1, "MAX_SPEED", "max_speed"}, {2, "ACC_LIMIT", "acc_limit"}, {4, "JERK_SLOPE", "jerk_slope"}, {8, "FLAGS", "flags"}, {16, "ATTITUDE_LPF_FREQ", "attitude_lpf_freq"}, {32, "SPEED_LPF_FREQ", "speed_lpf_freq"}}}
  enums.ControlQuatConfigFlags = {is_flags = true, values = {{1, "MOTION_PROFILE_SPLIT_XYZ", "motion_profile_split_xyz"}}}
  enums.HelperDataFlags = {is_flags = true, values = {{64, "EULER_ORDER_ROLL_PITCH_YAW", "euler_order_roll_pitch_yaw"}, {128, "USE_FRAME_HEADING", "use_frame_heading"}}}
  enums.ExecuteMenuFlags = {is_flags = true, values = {{1, "CONFIRM", "confirm"}, {2, "CONFIRM_ON_FINISH", "confirm_on_finish"}}}
  enums.EventTypes = {is_flags = true, values = {{1, "OFF", "off"}, {2, "ON", "on"}, {4, "HOLD", "hold"}}}
  enums.ExtMotors = {is_flags = true, values = {{1, "MOTOR1", "motor1"}, {2, "MOTOR2", "motor2"}, {4, "MOTOR3", "motor3"}, {8, "MOTOR4", "motor4"}, {16, "MOTOR5", "motor5"}, {32, "MOTOR6", "motor6"}, {64, "MOTOR7", "motor7"}}}
  enums.ExtMotorTargets = {is_flags = true, values = {{1, "MOTOR1", "motor1"}, {2, "MOTOR2", "motor2"}, {4, "MOTOR3", "motor3"}, {8, "MOTOR4", "motor4"}, {16, "MOTOR5", "motor5"}, {32, "MOTOR6", "motor6"}, {64, "MOTOR7", "motor7"}, {128, "CONFIRM", "confirm"}}}
  enums.ExtMotorsControlFields = {is_flags = true, values = {{1, "SETPOINT_32BIT", "setpoint_32bit"}, {2, "PARAM1_16BIT", "param1_16bit"}, {4, "PARAM1_32BIT", "param1_32bit"}}}
  enums.ExtMotorsControlConfigFields = {is_flags = true, values = {{1, "MODE", "mode"}, {2, "MAX_SPEED", "max_speed"}, {4, "MAX_ACCELERATION", "max_acceleration"}, {8, "JERK_SLOPE", "jerk_slope"}, {16, "MAX_TORQUE", "max_torque"}}}
  enums.ExtMotorsStateFields = {is_flags = true, values = {{1, "CONTROL_MODE", "control_mode"}, {2, "TORQUE", "torque"}, {4, "TORQUE_SETPOINT", "torque_setpoint"}, {8, "SPEED16", "speed16"}, {16, "SPEED16_SETPOINT", "speed16_setpoint"}, {32, "SPEED32", "speed32"}, {64, "SPEED32_SETPOINT", "speed32_setpoint"}, {128, "ANGLE16", "angle16"}, {256, "ANGLE16_SETPOINT", "angle16_setpoint"}, {512, "ANGLE32", "angle32"}, {1024, "ANGLE32_SETPOINT", "angle32_setpoint"}, {2048, "STATE_FLAGS", "state_flags"}, {4096, "MAX_SPEED", "max_speed"}, {8192, "MAX_ACCELERATION", "max_acceleration"}, {16384, "JERK_SLOPE", "jerk_slope"}, {32768, "MAX_TORQUE", "max_torque"}, {65536, "CURRENT", "current"}, {131072, "BATTERY_VOLTAGE", "battery_voltage"}, {262144, "MOTOR_TEMPERATURE", "motor_temperature"}, {524288, "DRIVER_TEMPERATURE", "driver_temperature"}}}
  enums.ExtMotorPins = {is_flags = true, values = {{4, "INDEX_PIN_STATE", "index_pin_state"}}}
  enums.AutoPidFlags = {is_flags = true, values = {{0, "AUTO_PID_STOP", "stop"}, {1, "AUTO_PID_CFG_ROLL", "roll"}, {2, "AUTO_PID_CFG_PITCH", "pitch"}, {4, "AUTO_PID_CFG_YAW", "yaw"}, {8, "AUTO_PID_CFG_SEND_GUI", "send_gui"}, {16, "AUTO_PID_CFG_KEEP_CURRENT", "keep_current"}, {32, "AUTO_PID_CFG_TUNE_LPF_FREQ", "tune_lpf_freq"}, {64, "AUTO_PID_CFG_ALL_PROFILES", "all_profiles"}}}
  enums.CalibratedLimits = {is_flags = true, values = {{1, "PLUS_X", "plus_x"}, {2, "MINUS_X", "minus_x"}, {4, "PLUS_Y", "plus_y"}, {8, "MINUS_Y", "minus_y"}, {16, "PLUS_Z", "plus_z"}, {32, "MINUS_Z", "minus_z"}}}
  enums.FieldOffsetFlags = {is_flags = true, values = {{1, "IGNORE_IMU_CHECK", "ignore_imu_check"}, {2, "IGNORE_ENCODER_CHECK", "ignore_encoder_check"}}}
  enums.CoggingAxes = {is_flags = true, values = {{1, "ROLL", "roll"}, {2, "PITCH", "pitch"}, {4, "YAW", "yaw"}}}
  enums.AutoPid2CommandFlags = {is_flags = true, values = {{1, "SEND_CONFIG", "send_config"}}}
  enums.AutoPid2Flags = {is_flags = true, values = {{1, "START_FROM_CURRENT", "start_from_current"}, {2, "ALL_PROFILES", "all_profiles"}, {4, "TUNE_GAIN_ONLY", "tune_gain_only"}, {16, "AUTOSAVE", "autosave"}, {16384, "RUN_AT_START_ALL", "run_at_start_all"}, {32768, "RUN_AT_START_GAIN", "run_at_start_gain"}}}
  enums.TuningPositions = {is_flags = true, values = {{1, "POSITION1", "position1"}, {2, "POSITION2", "position2"}, {4, "POSITION3", "position3"}, {8, "POSITION4", "position4"}}}
  enums.ExtSensOptions = {is_flags = true, values = {{1, "HIGH_PRIORITY", "high_priority"}}}
  enums.AhrsHelperMode = {is_flags = true, values = {{1, "SET", "set"}, {2, "FRAME_IMU", "frame_imu"}, {4, "REFERENCE_ONLY", "reference_only"}, {8, "TRANSLATE", "translate"}, {16, "Z1_ONLY", "z1_only"}, {32, "H1_ONLY", "h1_only"}}}
  enums.AhrsHelperWideMode = {is_flags = true, values = {{1, "SET", "set"}, {2, "FRAME_IMU", "frame_imu"}, {4, "REFERENCE_ONLY", "reference_only"}, {8, "TRANSLATE", "translate"}, {16, "Z1_ONLY", "z1_only"}, {32, "H1_ONLY", "h1_only"}, {64, "TRANSLATE_Z1_ONLY", "translate_z1_only"}, {128, "TRANSLATE_H1_ONLY", "translate_h1_only"}, {256, "ON_FRAME", "on_frame"}, {512, "BELOW_OUTER", "below_outer"}, {1024, "DISABLE_CORRECTION", "disable_correction"}}}
  enums.BeepModes = {is_flags = true, values = {{1, "BEEPER_MODE_CALIBRATE", "calibrate"}, {2, "BEEPER_MODE_CONFIRM", "confirm"}, {4, "BEEPER_MODE_ERROR", "error"}, {16, "BEEPER_MODE_CLICK", "click"}, {32, "BEEPER_MODE_COMPLETE", "complete"}, {64, "BEEPER_MODE_INTRO", "intro"}, {32768, "BEEPER_MODE_CUSTOM_MELODY", "custom_melody"}}}
  enums.ServoOutputs = {is_flags = true, values = {{1, "SERVO1", "servo1"}, {2, "SERVO2", "servo2"}, {4, "SERVO3", "servo3"}, {8, "SERVO4", "servo4"}, {16, "CAN_DRV1_SERVO1", "can_drv1_servo1"}, {32, "CAN_DRV1_SERVO2", "can_drv1_servo2"}, {64, "CAN_DRV2_SERVO1", "can_drv2_servo1"}, {128, "CAN_DRV2_SERVO2", "can_drv2_servo2"}, {256, "CAN_DRV3_SERVO1", "can_drv3_servo1"}, {512, "CAN_DRV3_SERVO2", "can_drv3_servo2"}, {1024, "CAN_DRV4_SERVO1", "can_drv4_servo1"}, {2048, "CAN_DRV4_SERVO2", "can_drv4_servo2"}, {4096, "CAN_DRV5_SERVO1", "can_drv5_servo1"}, {8192, "CAN_DRV5_SERVO2", "can_drv5_servo2"}, {16384, "CAN_DRV6_SERVO1", "can_drv6_servo1"}, {32768, "CAN_DRV6_SERVO2", "can_drv6_servo2"}, {65536, "CAN_DRV7_SERVO1", "can_drv7_servo1"}, {131072, "CAN_DRV7_SERVO2", "can_drv7_servo2"}}}
  enums.RcInputOptions = {is_flags = true, values = {{1, "INIT_IF_NEEDED", "init_if_needed"}}}
  enums.DebugVarFlags = {is_flags = true, values = {{64, "VAR_FLAG_ANGLE14", "angle14"}}}
  enums.DebugPortCommands = {is_flags = true, values = {{1, "REALTIME_DATA_3", "realtime_data_3"}, {2, "REALTIME_DATA_4", "realtime_data_4"}, {4, "REALTIME_DATA_CUSTOM", "realtime_data_custom"}, {8, "DEBUG_VARS_3", "debug_vars_3"}, {16, "MAVLINK_DEBUG", "mavlink_debug"}, {32, "GET_ANGLES", "get_angles"}, {64, "GET_ANGLES_EXT", "get_angles_ext"}, {128, "BODE_TEST_DATA", "bode_test_data"}, {256, "HELPER_DATA", "helper_data"}, {512, "AHRS_HELPER", "ahrs_helper"}, {1024, "GYRO_CORRECTION", "gyro_correction"}, {2048, "CONTROL", "control"}, {4096, "SET_ADJ_VARS_VAL", "set_adj_vars_val"}, {8192, "API_VIRT_CH_CONTROL", "api_virt_ch_control"}, {16384, "API_VIRT_CH_HIGH_RES", "api_virt_ch_high_res"}}}
  packed.BoardVersion = {display = "{major}.{minor}", later_from = 0, parts = {{name = "major", most = 255, shift = 0, divide = 10}, {name = "minor", most = 255, shift = 0, modulo = 10}}}
  packed.FirmwareVersion = {display = "{major}.{minor:02}[b{beta}]", later_from = 2730, later_display = "{major}.{minor:02}[.{beta}]", parts = {{name = "major", most = 65535, shift = 0, divide = 1000}, {name = "minor", most = 65535, shift = 0, divide = 10, modulo = 100}, {name = "beta", most = 65535, shift = 0, modulo = 10}}}
  packed.EulerOrderSetting = {later_from = 0, parts = {{name = "order", most = 15, shift = 0, enum = "EulerOrder"}, {name = "flags", most = 48, shift = 0, enum = "EulerOrderFlags"}}}
  packed.RcMode = {later_from = 0, parts = {{name = "mode", most = 7, shift = 0, enum = "RcModeKind"}, {name = "inverted", most = 1, shift = 3, is_bool = true}}}
  packed.RcMap = {later_from = 0, names = "RcInput", parts = {{name = "channel", most = 31, shift = 0}, {name = "source", most = 224, shift = 0, enum = "RcSource"}}}
  packed.RcMix = {later_from = 0, parts = {{name = "rate", most = 63, shift = 0}, {name = "target", most = 3, shift = 6, enum = "MixTarget"}}}
  packed.EncoderType = {later_from = 0, parts = {{name = "model", most = 15, shift = 0, enum = "EncoderModel"}, {name = "flags", most = 240, shift = 0, enum = "EncoderFlags"}}}
  packed.MavConfig = {later_from = 0, parts = {{name = "baud", most = 7, shift = 0, enum = "SerialSpeed"}, {name = "parity_even", most = 1, shift = 3, is_bool = true}, {name = "heartbeat", most = 1, shift = 4, is_bool = true}, {name = "debug", most = 1, shift = 5, is_bool = true}, {name = "rc", most = 1, shift = 6, is_bool = true}}}
  packed.StabAxis = {later_from = 0, parts = {{name = "axis", most = 3, shift = 0, enum = "StabilizedAxis"}, {name = "automatic_roll", most = 1, shift = 2, is_bool = true}, {name = "automatic_pitch", most = 1, shift = 3, is_bool = true}, {name = "automatic_yaw", most = 1, shift = 4, is_bool = true}}}
  packed.StartupAction = {later_from = 0, parts = {{name = "action", most = 127, shift = 0, enum = "MenuCommand"}, {name = "button_pressed", most = 1, shift = 7, is_bool = true}}}
  packed.ForcePositionConfig = {later_from = 0, parts = {{name = "snap", most = 7, shift = 0, enum = "SnapAngle"}, {name = "on_button", most = 1, shift = 4, is_bool = true}, {name = "at_startup", most = 1, shift = 5, is_bool = true}, {name = "ignore_limits", most = 1, shift = 6, is_bool = true}, {name = "fine_adjust", most = 1, shift = 7, is_bool = true}}}
  packed.StepSignalConfig = {later_from = 0, parts = {{name = "steps", most = 7, shift = 0, enum = "StepCount"}, {name = "button_pressed", most = 1, shift = 3, is_bool = true}, {name = "start_at_zero", most = 1, shift = 5, is_bool = true}, {name = "trigger", most = 3, shift = 6, enum = "StepTrigger"}}}
  packed.InterruptConfig = {later_from = 0, parts = {{name = "pin", most = 31, shift = 0}, {name = "on_emergency_stop", most = 1, shift = 5, is_bool = true}, {name = "on_parking", most = 1, shift = 6, is_bool = true}}}
  packed.ExtImuOrientation = {later_from = 0, parts = {{name = "top", most = 7, shift = 0, enum = "ExtImuAxis"}, {name = "right", most = 7, shift = 3, enum = "ExtImuAxis"}}}
  packed.ExtraButton = {later_from = 0, parts = {{name = "pin", most = 63, shift = 0, enum = "BoardPin"}, {name = "latching", most = 1, shift = 6, is_bool = true}, {name = "inverted", most = 1, shift = 7, is_bool = true}}}
  packed.EncoderConfigExt = {later_from = 0, parts = {{name = "resolution", most = 31, shift = 0}, {name = "multi_turn", most = 7, shift = 5, enum = "MultiTurn"}}}
  packed.InputStates = {later_from = 0, parts = {{name = "input_1", most = 3, shift = 0, enum = "InputState"}, {name = "input_2", most = 3, shift = 2, enum = "InputState"}, {name = "input_3", most = 3, shift = 4, enum = "InputState"}, {name = "input_4", most = 3, shift = 6, enum = "InputState"}, {name = "input_5", most = 3, shift = 8, enum = "InputState"}, {name = "input_6", most = 3, shift = 10, enum = "InputState"}, {name = "input_7", most = 3, shift = 12, enum = "InputState"}, {name = "input_8", most = 3, shift = 14, enum = "InputState"}}}
  packed.ControlMode = {later_from = 0, parts = {{name = "mode", most = 15, shift = 0, enum = "ControlModeKind"}, {name = "flags", most = 240, shift = 0, enum = "ControlFlags"}}}
  packed.EulerOrderChoice = {later_from = 0, parts = {{name = "order", most = 15, shift = 0, enum = "EulerOrderChange"}, {name = "flags", most = 48, shift = 0, enum = "EulerOrderFlags"}}}
  packed.HelperCoordinates = {later_from = 0, parts = {{name = "system", most = 7, shift = 0, enum = "CoordinateSystem"}, {name = "flags", most = 192, shift = 0, enum = "HelperDataFlags"}}}
  packed.PackedQuaternion = {later_from = 0, parts = {{name = "a", most = 524287, shift = 0, sign = 19, scale = 1.3487017247928233e-06, add = 0}, {name = "b", most = 524287, shift = 20, sign = 39, scale = 1.3487017247928233e-06, add = 0}, {name = "c", most = 524287, shift = 40, sign = 59, scale = 1.3487017247928233e-06, add = 0}, {name = "largest", most = 3, shift = 60, enum = "QuaternionComponent"}, {name = "largest_sign", most = 1, shift = 62, is_bool = true}}}
  packed.ExtMotorStatus = {later_from = 0, parts = {{name = "power", most = 3, shift = 0, enum = "ExtMotorPower"}, {name = "pins", most = 65532, shift = 0, enum = "ExtMotorPins"}}}
  packed.AxisTuningOptions = {later_from = 0, parts = {{name = "enabled", most = 1, shift = 0, is_bool = true}, {name = "tune_lpf", most = 1, shift = 1, is_bool = true}, {name = "notch_filters", most = 3, shift = 2}}}
  packed.AhrsReferences = {later_from = 0, parts = {{name = "attitude", most = 7, shift = 0, enum = "AhrsReference"}, {name = "heading", most = 7, shift = 3, enum = "AhrsReference"}, {name = "internal_used", most = 1, shift = 6, is_bool = true}, {name = "enabled", most = 1, shift = 7, is_bool = true}}}
  packed.ExtImuStatus = {later_from = 0, parts = {{name = "state", most = 7, shift = 0, enum = "ExtImuState"}, {name = "bad_mag", most = 1, shift = 6, is_bool = true}, {name = "no_gps_signal", most = 1, shift = 7, is_bool = true}}}
  packed.I2cDevice = {later_from = 0, parts = {{name = "port", most = 1, shift = 0, enum = "I2cPort"}, {name = "address", most = 127, shift = 1}}}
  packed.ModuleVersion = {display = "{major}.{minor:02}", later_from = 0, parts = {{name = "major", most = 65535, shift = 0, divide = 100}, {name = "minor", most = 65535, shift = 0, modulo = 100}}}
  packed.CanDeviceType = {later_from = 0, parts = {{name = "kind", most = 127, shift = 0, enum = "CanDeviceKind"}, {name = "hardware_assigned", most = 1, shift = 7, is_bool = true}}}
  packed.TransparentTarget = {later_from = 0, parts = {{name = "port", most = 3, shift = 0}, {name = "device", most = 15, shift = 2, enum = "TransparentDevice"}, {name = "wait", most = 1, shift = 6, is_bool = true}}}
  packed.DebugPortLine = {later_from = 0, parts = {{name = "port", most = 127, shift = 0}, {name = "direction", most = 1, shift = 7, is_bool = true}}}
  packed.DebugVarType = {later_from = 0, parts = {{name = "kind", most = 15, shift = 0, enum = "DebugVarKind"}, {name = "axis", most = 48, shift = 0, enum = "DebugVarAxis"}, {name = "flags", most = 192, shift = 0, enum = "DebugVarFlags"}}}
  structs.AxisPid0 = {size = 6, fields = {{name = "p", type = "u8", count = 1, fixed = 1, min = 0, max = 255, later = {{firmware = 2731, type = "u8", scale = 5, add = -5, ratio = 52, over = 255, min = 0, max = 255}}}, {name = "i", type = "u8", scale = 0.01, count = 1, fixed = 1, min = 0, max = 255, later = {{firmware = 2731, type = "u8", scale = 5, add = -5, ratio = 52, over = 255, min = 0, max = 255}}}, {name = "d", type = "u8", count = 1, fixed = 1, min = 0, max = 255, later = {{firmware = 2731, type = "u8", scale = 5, add = -5, ratio = 52, over = 255, min = 0, max = 255}}}, {name = "power", type = "u8", count = 1, fixed = 1, min = 0, max = 255}, {name = "invert", type = "u8", count = 1, fixed = 1, min = 0, max = 1}, {name = "poles", type = "u8", count = 1, fixed = 1, min = 0, max = 255}}}
  structs.AxisRc1 = {size = 8, fields = {{name = "rc_min_angle", type = "i16", unit = "deg", count = 1, fixed = 2, min = -720, max = 720, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "rc_max_angle", type = "i16", unit = "deg", count = 1, fixed = 2, min = -720, max = 720, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "rc_mode", type = "u8", packed = "RcMode", count = 1, fixed = 1}, {name = "rc_lpf", type = "u8", count = 1, fixed = 1, min = 0, max = 255}, {name = "rc_speed", type = "u8", count = 1, fixed = 1, min = 0, max = 255}, {name = "rc_follow", type = "i8", count = 1, fixed = 1, min = -127, max = 127}}}
  structs.AxisNotches2 = {size = 6, fields = {{name = "notch_freq", type = "u8", unit = "Hz", scale = 2, dim = "fixed", count = 3, fixed = 3, min = 0, max = 255}, {name = "notch_width", type = "u8", unit = "Hz", dim = "fixed", count = 3, fixed = 3, min = 0, max = 255}}}
  structs.MavChannel3 = {size = 8, fields = {{name = "mav_src", type = "u8", enum = "BoardPort", count = 1, fixed = 1}, {name = "mav_sys_id", type = "u8", count = 1, fixed = 1}, {name = "mav_comp_id", type = "u8", count = 1, fixed = 1}, {name = "mav_cfg_flags", type = "u8", packed = "MavConfig", count = 1, fixed = 1}, {name = "reserved", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true}}}
  structs.StepSignal4 = {size = 2, fields = {{name = "step_signal_src", type = "u8", packed = "RcMap", count = 1, fixed = 1}, {name = "step_signal_cfg", type = "u8", packed = "StepSignalConfig", count = 1, fixed = 1}}}
  structs.RcCalibration5 = {size = 4, fields = {{name = "rc_calib_src", type = "u8", packed = "RcMap", count = 1, fixed = 1}, {name = "rc_calib_offset", type = "i8", scale = 0.0078125, count = 1, fixed = 1}, {name = "rc_calib_neg_scale", type = "u8", unit = "%", scale = 1, add = 80, count = 1, fixed = 1}, {name = "rc_calib_pos_scale", type = "u8", unit = "%", scale = 1, add = 80, count = 1, fixed = 1}}}
  structs.ShakeGenerator6 = {size = 22, fields = {{name = "amplitude", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3}, {name = "base_freq", type = "u8", unit = "Hz", scale = 0.05, add = 0.3, count = 1, fixed = 1}, {name = "freq_range", type = "u8", scale = 0.1, add = 1.5, count = 1, fixed = 1, min = 0, max = 100}, {name = "pause_period", type = "u8", unit = "ms", scale = 20, add = 500, count = 1, fixed = 1}, {name = "pause_balance", type = "u8", count = 1, fixed = 1, min = 0, max = 100}, {name = "pause_attenuation", type = "u8", count = 1, fixed = 1, min = 0, max = 100}, {name = "pause_randomness", type = "u8", count = 1, fixed = 1, min = 0, max = 100}, {name = "pause_phase_var", type = "u8", count = 1, fixed = 1, min = 0, max = 100}, {name = "resonance_gain", type = "u8", unit = "dB", scale = 0.2, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3}, {name = "resonance_freq", type = "u8", unit = "Hz", scale = 0.1, add = 0.3, count = 1, fixed = 1}, {name = "freq_shift", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127}, {name = "reserved", blob = "bytes", size = 5, count = 1, fixed = 5, reserved = true}}}
  structs.AxisSensors7 = {size = 4, fields = {{name = "acc_data", type = "i16", unit = "g", scale = 0.001953125, count = 1, fixed = 2}, {name = "gyro_data", type = "i16", unit = "deg/s", scale = 0.061037018951994385, count = 1, fixed = 2}}}
  structs.Motor4Control8 = {size = 8, fields = {{name = "ff_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "angle_error", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "pid_out", type = "f32", count = 1, fixed = 4}}}
  structs.AhrsDebugInfo9 = {size = 26, fields = {{name = "main_imu_ref_src", type = "u8", packed = "AhrsReferences", count = 1, fixed = 1}, {name = "frame_imu_ref_src", type = "u8", packed = "AhrsReferences", count = 1, fixed = 1}, {name = "main_z_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "main_h_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "frame_z_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "frame_h_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "ext_imu_status", type = "u8", packed = "ExtImuStatus", count = 1, fixed = 1}, {name = "ext_imu_packets", type = "u16", count = 1, fixed = 2}, {name = "ext_imu_parse_err", type = "u16", count = 1, fixed = 2}, {name = "ext_corr_h_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "ext_corr_z_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "reserved", blob = "bytes", size = 13, count = 1, fixed = 13, reserved = true}}}
  structs.MotorPowerState10 = {size = 13, fields = {{name = "mot_power", type = "i16", count = 1, fixed = 2, min = -10000, max = 10000}, {name = "mot_current", type = "u16", unit = "mA", count = 1, fixed = 2}, {name = "mot_temp", type = "i8", unit = "degC", count = 1, fixed = 1}, {name = "mot_flags", type = "u16", enum = "MotorPowerFlags", count = 1, fixed = 2}, {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true}}}
  structs.SystemPowerState11 = {size = 46, fields = {{name = "motors", struct = "MotorPowerState10", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 39}, {name = "state", type = "i8", enum = "PowerState", count = 1, fixed = 1}, {name = "battery_voltage", type = "u16", unit = "V", scale = 0.01, count = 1, fixed = 2}, {name = "total_current", type = "u16", unit = "mA", count = 1, fixed = 2}, {name = "system_flags", type = "u16", enum = "SystemPowerFlags", count = 1, fixed = 2}}}
  structs.CommErrors12 = {size = 7, fields = {{name = "i2c_errors", type = "u16", count = 1, fixed = 2}, {name = "serial_errors", type = "u16", count = 1, fixed = 2}, {name = "can_errors", type = "u16", count = 1, fixed = 2}, {name = "can_err_flags", type = "u8", enum = "CanErrorFlags", count = 1, fixed = 1}}}
  structs.SystemStatus13 = {size = 13, fields = {{name = "flags", type = "u32", enum = "StateFlags", count = 1, fixed = 4}, {name = "calib_mode", type = "u8", enum = "CalibMode", count = 1, fixed = 1}, {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true}}}
  structs.SoftLimitDistances14 = {size = 4, fields = {{name = "dist", type = "i16", unit = "deg", scale = 0.02197265625, dim = "fixed", count = 2, fixed = 4, special = {[32767] = "not set or unknown"}}}}
  structs.MainImuState15 = {size = 11, fields = {{name = "g_ref_error", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "h_ref_error", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1}, {name = "flags", type = "u8", count = 1, fixed = 1}, {name = "ext_sensor_error", type = "u8", count = 1, fixed = 1}, {name = "reserved", blob = "bytes", size = 7, count = 1, fixed = 7, reserved = true}}}
  structs.PinStates16 = {size = 8, fields = {{name = "extra_buttons_state", type = "u16", packed = "InputStates", count = 1, fixed = 2}, {name = "pin_state", type = "u16", packed = "InputStates", count = 1, fixed = 2}, {name = "reserved", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true}}}
  structs.StreamConfig17 = {size = 8, is_region = true, fields = {{name = "flags", type = "u32", enum = "RealtimeDataCustomFlags", count = 1, fixed = 4, when = {steps = {"cmd_id"}, numbers = {[88] = true}}}, {name = "imu_type", type = "u8", enum = "ImuIndex", count = 1, fixed = 1, when = {steps = {"cmd_id"}, numbers = {[56] = true}}}, {name = "event_id", type = "u8", enum = "EventId", count = 1, fixed = 1, when = {steps = {"cmd_id"}, numbers = {[102] = true}}}, {name = "event_type", type = "u8", enum = "EventTypes", count = 1, fixed = 1, when = {steps = {"cmd_id"}, numbers = {[102] = true}}}, {name = "telemetry_flags", type = "u32", enum = "CanDrvTelemetryFlags", count = 1, fixed = 4, when = {steps = {"cmd_id"}, numbers = {[127] = true}}}, {name = "drv_id", type = "u8", count = 1, fixed = 1, min = 0, max = 6, when = {steps = {"cmd_id"}, numbers = {[127] = true}}}, {name = "motor", type = "u8", count = 1, fixed = 1, when = {steps = {"cmd_id"}, numbers = {[131] = true}}}, {name = "data_set", type = "u32", enum = "ExtMotorsStateFields", count = 1, fixed = 4, when = {steps = {"cmd_id"}, numbers = {[131] = true}}}, {name = "custom2_flags", type = "u32", enum = "RealtimeDataCustom2Flags", count = 1, fixed = 4, when = {steps = {"cmd_id"}, numbers = {[139] = true}}}, {name = "rest", blob = "bytes", dim = "rest", capacity = 8, reserved = true}}}
  structs.ControlAxis18 = {size = 4, fields = {{name = "speed", type = "i16", unit = "deg/s", scale = 0.12207403790398877, count = 1, fixed = 2, alternative = {field = "control_mode", mask = 128, unit = "deg/s", scale = 0.001}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}}}
  structs.ControlExtAxis19 = {looks_outside = true, fields = {{name = "mode", type = "u8", packed = "ControlMode", count = 1, fixed = 1, when = {steps = {"data_set"}, outside = true, any = {1, 2}, elements = {roll = {steps = {"data_set"}, outside = true, any = {1, 2}}, pitch = {steps = {"data_set"}, outside = true, any = {32, 64}}, yaw = {steps = {"data_set"}, outside = true, any = {1024, 2048}}}}}, {name = "flags", type = "u8", enum = "ControlExtFlags", count = 1, fixed = 1, when = {steps = {"data_set"}, outside = true, any = {1, 2}, elements = {roll = {steps = {"data_set"}, outside = true, any = {1, 2}}, pitch = {steps = {"data_set"}, outside = true, any = {32, 64}}, yaw = {steps = {"data_set"}, outside = true, any = {1024, 2048}}}}}, {name = "speed", type = "i16", unit = "deg/s", scale = 0.12207403790398877, count = 1, fixed = 2, when = {steps = {"data_set"}, outside = true, all = 1, none = {8}, elements = {roll = {steps = {"data_set"}, outside = true, all = 1, none = {8}}, pitch = {steps = {"data_set"}, outside = true, all = 32, none = {256}}, yaw = {steps = {"data_set"}, outside = true, all = 1024, none = {8192}}}}, alternative = {field = "mode", mask = 128, in_group = true, unit = "deg/s", scale = 0.001}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "speed_32", type = "i32", unit = "deg/s", scale = 0.001, count = 1, fixed = 4, when = {steps = {"data_set"}, outside = true, all = 9, elements = {roll = {steps = {"data_set"}, outside = true, all = 9}, pitch = {steps = {"data_set"}, outside = true, all = 288}, yaw = {steps = {"data_set"}, outside = true, all = 9216}}}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, when = {steps = {"data_set"}, outside = true, all = 2, none = {4}, elements = {roll = {steps = {"data_set"}, outside = true, all = 2, none = {4}}, pitch = {steps = {"data_set"}, outside = true, all = 64, none = {128}}, yaw = {steps = {"data_set"}, outside = true, all = 2048, none = {4096}}}}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "angle_32", type = "i32", unit = "deg", scale = 0.00034332275390625, count = 1, fixed = 4, when = {steps = {"data_set"}, outside = true, all = 6, elements = {roll = {steps = {"data_set"}, outside = true, all = 6}, pitch = {steps = {"data_set"}, outside = true, all = 192}, yaw = {steps = {"data_set"}, outside = true, all = 6144}}}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}}}
  structs.ControlConfigAxis20 = {size = 7, fields = {{name = "angle_lpf", type = "u8", count = 1, fixed = 1}, {name = "speed_lpf", type = "u8", count = 1, fixed = 1}, {name = "rc_lpf", type = "u8", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "the filter does not change"}}, {name = "acc_limit", type = "u16", unit = "deg/s^2", count = 1, fixed = 2, min = 1, max = 65535, special = {[0] = "the limit does not change"}}, {name = "jerk_slope", type = "u8", unit = "ms", scale = 20, count = 1, fixed = 1, min = 2, max = 255, special = {[0] = "the time does not change", [1] = "the acceleration changes at once"}}, {name = "reserved", blob = "bytes", size = 1, count = 1, fixed = 1, reserved = true}}}
  structs.AxisState21 = {size = 6, fields = {{name = "imu_angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "rc_target_angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "rc_speed", type = "i16", unit = "deg/s", scale = 0.12207403790398877, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}}}
  structs.AxisStateExt22 = {size = 18, fields = {{name = "imu_angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "rc_target_angle", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "stator_rotor_angle", type = "i32", unit = "deg", scale = 0.02197265625, count = 1, fixed = 4, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "reserved", blob = "bytes", size = 10, count = 1, fixed = 10, reserved = true}}}
  structs.ExtMotorTarget1623 = {size = 4, fields = {{name = "setpoint", type = "i16", count = 1, fixed = 2}, {name = "param1", type = "i16", count = 1, fixed = 2}}}
  structs.ExtMotorTarget16Param3224 = {size = 6, fields = {{name = "setpoint", type = "i16", count = 1, fixed = 2}, {name = "param1", type = "i32", count = 1, fixed = 4}}}
  structs.ExtMotorTarget32Param1625 = {size = 6, fields = {{name = "setpoint", type = "i32", count = 1, fixed = 4}, {name = "param1", type = "i16", count = 1, fixed = 2}}}
  structs.ExtMotorTarget3226 = {size = 8, fields = {{name = "setpoint", type = "i32", count = 1, fixed = 4}, {name = "param1", type = "i32", count = 1, fixed = 4}}}
  structs.AxisTuning27 = {size = 10, fields = {{name = "tracking_error", type = "f32", count = 1, fixed = 4}, {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true}}}
  structs.AxisTuningConfig28 = {size = 13, fields = {{name = "axis_flags", type = "u8", packed = "AxisTuningOptions", count = 1, fixed = 1}, {name = "gain", type = "u8", count = 1, fixed = 1}, {name = "stimulus_gain", type = "u16", count = 1, fixed = 2}, {name = "effective_freq", type = "u8", unit = "Hz", count = 1, fixed = 1}, {name = "problem_freq", type = "u8", unit = "Hz", count = 1, fixed = 1}, {name = "problem_margin", type = "u8", unit = "dB", scale = 0.1, count = 1, fixed = 1}, {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true}}}
  structs.AutoPid2Config29 = {size = 62, fields = {{name = "cfg_version", type = "u8", count = 1, fixed = 1, min = 1, max = 1}, {name = "axes", struct = "AxisTuningConfig28", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 39}, {name = "general_flags", type = "u16", enum = "AutoPid2Flags", count = 1, fixed = 2}, {name = "reserved_1", blob = "bytes", size = 1, count = 1, fixed = 1, reserved = true}, {name = "test_freq_from", type = "u8", unit = "Hz", scale = 0.1, count = 1, fixed = 1}, {name = "test_freq_to", type = "u8", unit = "Hz", scale = 2, count = 1, fixed = 1}, {name = "multi_pos_flag", type = "u8", enum = "TuningPositions", count = 1, fixed = 1}, {name = "multi_pos_angle", type = "i8", unit = "deg", scale = 3, dim = "fixed", count = 4, fixed = 4, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}}, {name = "reserved_2", blob = "bytes", size = 12, count = 1, fixed = 12, reserved = true}}}
  structs.CoggingMotor30 = {size = 15, fields = {{name = "angle", type = "u16", unit = "deg", count = 1, fixed = 2, min = 20, max = 360}, {name = "smooth", type = "u8", unit = "%", count = 1, fixed = 1, min = 0, max = 100}, {name = "speed", type = "u8", count = 1, fixed = 1}, {name = "period", type = "u16", unit = "deg", count = 1, fixed = 2, special = {[0] = "automatic"}}, {name = "reserved", blob = "bytes", size = 9, count = 1, fixed = 9, reserved = true}}}
  structs.BodeSample31 = {size = 4, fields = {{name = "input", type = "u16", count = 1, fixed = 2, min = 0, max = 65534}, {name = "output", type = "u16", count = 1, fixed = 2, min = 0, max = 65534}}}
  structs.ModuleInfo32 = {size = 13, fields = {{name = "id", type = "u8", enum = "ModuleId", count = 1, fixed = 1}, {name = "board_ver", type = "u16", packed = "ModuleVersion", count = 1, fixed = 2}, {name = "bootloader_ver", type = "u16", packed = "ModuleVersion", count = 1, fixed = 2}, {name = "firmware_ver", type = "u16", packed = "ModuleVersion", count = 1, fixed = 2}, {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true}}}
  structs.CanDevice33 = {size = 14, fields = {{name = "uid", blob = "bytes", size = 12, count = 1, fixed = 12}, {name = "id", type = "u8", enum = "CanDeviceId", count = 1, fixed = 1}, {name = "type", type = "u8", packed = "CanDeviceType", count = 1, fixed = 1}}}
  structs.AdjVarValue34 = {size = 5, fields = {{name = "param_id", type = "u8", enum = "VariableId", count = 1, fixed = 1}, {name = "param_value", type = "i32", count = 1, fixed = 4}}}
  structs.TriggerSlot35 = {size = 6, fields = {{name = "src_ch", type = "u8", packed = "RcMap", count = 1, fixed = 1}, {name = "action", type = "u8", enum = "MenuCommand", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 5}}}
  structs.AnalogSlot36 = {size = 4, fields = {{name = "src_ch", type = "u8", packed = "RcMap", count = 1, fixed = 1}, {name = "param_id", type = "u8", enum = "VariableId", count = 1, fixed = 1}, {name = "min_val", type = "u8", count = 1, fixed = 1}, {name = "max_val", type = "u8", count = 1, fixed = 1}}}
  structs.AdjVarInfo37 = {fields = {{name = "var_id", type = "u8", enum = "VariableId", count = 1, fixed = 1}, {name = "name", blob = "string", size = 255, count = 1}, {name = "range_min", type = "i16", count = 1, fixed = 2}, {name = "range_max", type = "i16", count = 1, fixed = 2}, {name = "value", type = "i32", count = 1, fixed = 4}}}
  structs.AdjVarFloat38 = {size = 5, fields = {{name = "id", type = "u8", enum = "VariableId", count = 1, fixed = 1}, {name = "value", type = "f32", count = 1, fixed = 4}}}
  structs.DebugVarInfo39 = {fields = {{name = "var_name", blob = "string", size = 255, count = 1}, {name = "var_type", type = "u8", packed = "DebugVarType", count = 1, fixed = 1}, {name = "arr_size", type = "u16", count = 1, fixed = 2, special = {[0] = "a scalar", [1] = "a scalar"}}}}

  messages[1] = {name = "BoardInfo", filter = "board_info", command = "CMD_BOARD_INFO", id = 86, min = 18, max = 18, open = true, keeps_tail = true, tail = 237, role = {is = "introduction", firmware = "firmware_ver", board = "board_ver"}}
  messages[1].fields = {
    {name = "board_ver", type = "u8", packed = "BoardVersion", count = 1, fixed = 1},
    {name = "firmware_ver", type = "u16", packed = "FirmwareVersion", count = 1, fixed = 2, special = {[0] = "unknown; the sensors are often unplugged"}},
    {name = "debug_mode", type = "u8", enum = "BoardStateFlags", count = 1, fixed = 1},
    {name = "board_features", type = "u16", enum = "BoardFeatures", count = 1, fixed = 2},
    {name = "connection_flags", type = "u8", enum = "ConnectionFlags", count = 1, fixed = 1},
    {name = "frw_extra_id", type = "u32", count = 1, fixed = 4},
    {name = "board_features_ext", type = "u16", enum = "BoardFeaturesExt", count = 1, fixed = 2},
    {name = "main_imu_sens_model", type = "u8", count = 1, fixed = 1},
    {name = "frame_imu_sens_model", type = "u8", count = 1, fixed = 1},
    {name = "build_number", type = "u8", count = 1, fixed = 1},
    {name = "base_frw_ver", type = "u16", packed = "FirmwareVersion", count = 1, fixed = 2},
  }

  messages[2] = {name = "BoardInfoRequest", filter = "board_info_request", command = "CMD_BOARD_INFO", id = 86, to_board = true, min = 0, max = 0, tail = 255, does = {"reads"}, answers = {{messages = {"BoardInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[2].fields = {
  }

  messages[3] = {name = "BoardInfoRequestOneByte", filter = "board_info_request_one_byte", command = "CMD_BOARD_INFO", id = 86, to_board = true, min = 1, max = 1, tail = 254, does = {"reads"}, answers = {{messages = {"BoardInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[3].fields = {
    {name = "reserved", blob = "bytes", size = 1, count = 1, fixed = 1, reserved = true},
  }

  messages[4] = {name = "BoardInfoRequestExt", filter = "board_info_request_ext", command = "CMD_BOARD_INFO", id = 86, to_board = true, min = 2, max = 255, open = true, tail = 253, does = {"sets"}, secret_from = 2, answers = {{messages = {"BoardInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[4].fields = {
    {name = "cfg", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "password", blob = "string", size = 32, count = 1, secret = true, fits_rest = true},
    {name = "reserved", blob = "bytes", dim = "rest", count = 1, capacity = 253, reserved = true},
  }

  messages[5] = {name = "Confirm", filter = "confirm", command = "CMD_CONFIRM", id = 67, min = 1, max = 6, open = true, tail = 254, role = {is = "confirmation", command = "cmd"}}
  messages[5].fields = {
    {name = "cmd", type = "u8", enum = "CommandToBoard", count = 1, fixed = 1},
    {name = "addr", type = "u32", count = 1, fixed = 4, when = {steps = {"cmd"}, numbers = {[47] = true}, missing = true}},
    {name = "err_code", type = "u8", enum = "FileError", count = 1, fixed = 1, when = {steps = {"cmd"}, numbers = {[54] = true, [55] = true}, missing = true}},
    {name = "pin_id", type = "u8", enum = "OutputPin", count = 1, fixed = 1, when = {steps = {"cmd"}, numbers = {[84] = true}, missing = true}},
    {name = "pin_state", type = "i8", count = 1, fixed = 1, min = 0, max = 1, special = {[-1] = "the pin is unavailable"}, when = {steps = {"cmd"}, numbers = {[84] = true}, missing = true}},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[6] = {name = "Error", filter = "error", command = "CMD_ERROR", id = 255, min = 5, max = 5, tail = 250, role = {is = "error", code = "error_code"}}
  messages[6].fields = {
    {name = "error_code", type = "u8", enum = "BoardErrorCode", count = 1, fixed = 1},
    {name = "error_data", blob = "bytes", size = 4, count = 1, fixed = 4},
  }

  messages[7] = {name = "ErrorExt", filter = "error_ext", command = "CMD_ERROR", id = 255, min = 6, max = 6, open = true, keeps_tail = true, tail = 249, role = {is = "error", code = "error_code", command = "cmd_id"}}
  messages[7].fields = {
    {name = "cmd_id", type = "u8", enum = "CommandToBoard", count = 1, fixed = 1},
    {name = "error_code", type = "u8", enum = "BoardErrorCode", count = 1, fixed = 1},
    {name = "error_data", blob = "bytes", size = 4, count = 1, fixed = 4},
  }

  messages[8] = {name = "BoardInfo3", filter = "board_info3", command = "CMD_BOARD_INFO_3", id = 20, min = 69, max = 69, open = true, keeps_tail = true, tail = 186, role = {is = "details", serial_number = "device_id", eeprom_size = "eeprom_size"}}
  messages[8].fields = {
    {name = "device_id", blob = "bytes", size = 9, count = 1, fixed = 9},
    {name = "mcu_id", blob = "bytes", size = 12, count = 1, fixed = 12},
    {name = "eeprom_size", type = "u32", unit = "byte", count = 1, fixed = 4},
    {name = "script_slot_size", type = "u16", unit = "byte", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 10, special = {[0] = "the slot is empty"}},
    {name = "profile_set_slots", type = "u8", enum = "StoredProfileSets", count = 1, fixed = 1},
    {name = "profile_set_cur", type = "u8", count = 1, fixed = 1, min = 1, max = 6, special = {[0] = "earlier firmware has no profile sets"}},
    {name = "flash_size", type = "u8", unit = "byte", scale = 32768, count = 1, fixed = 1},
    {name = "imu_calib_info", blob = "bytes", size = 2, count = 1, fixed = 2},
    {name = "script_slot_6_to_10_size", type = "u16", unit = "byte", dim = "fixed", index = {"6", "7", "8", "9", "10"}, count = 5, fixed = 10, special = {[0] = "the slot is empty"}},
    {name = "hw_flags", type = "u16", enum = "HardwareFlags", count = 1, fixed = 2},
    {name = "board_features_ext2", type = "u32", enum = "BoardFeaturesExt2", count = 1, fixed = 4},
    {name = "can_drv_main_limit", type = "u8", count = 1, fixed = 1},
    {name = "can_drv_aux_limit", type = "u8", count = 1, fixed = 1},
    {name = "adj_vars_total_num", type = "u8", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 10, count = 1, fixed = 10, reserved = true},
  }

  messages[9] = {name = "BoardInfo3Request", filter = "board_info3request", command = "CMD_BOARD_INFO_3", id = 20, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"BoardInfo3"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[9].fields = {
  }

  messages[10] = {name = "Reset", filter = "reset", command = "CMD_RESET", id = 114, min = 0, max = 0, open = true, keeps_tail = true, tail = 255, role = {is = "reset"}}
  messages[10].fields = {
  }

  messages[11] = {name = "ResetRequest", filter = "reset_request", command = "CMD_RESET", id = 114, to_board = true, min = 0, max = 0, tail = 255, does = {"restarts"}, answers = {{timeout = 0.5}}}
  messages[11].fields = {
  }

  messages[12] = {name = "ResetRequestExt", filter = "reset_request_ext", command = "CMD_RESET", id = 114, to_board = true, min = 3, max = 3, open = true, takes_surplus = true, tail = 252, does = {"restarts"}, answers = {{when = {steps = {"confirm"}, all = 1}, messages = {"Reset"}, certain = true, timeout = 0.5, repeated = {}}, {timeout = 0.5}}}
  messages[12].fields = {
    {name = "confirm", type = "u8", enum = "ResetOptions", count = 1, fixed = 1},
    {name = "delay_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
  }

  messages[13] = {name = "BootMode3", filter = "boot_mode3", command = "CMD_BOOT_MODE_3", id = 51, to_board = true, min = 0, max = 0, tail = 255, does = {"restarts", "disconnects"}, answers = {{timeout = 0.5}}}
  messages[13].fields = {
  }

  messages[14] = {name = "BootMode3Ext", filter = "boot_mode3ext", command = "CMD_BOOT_MODE_3", id = 51, to_board = true, min = 3, max = 3, open = true, takes_surplus = true, tail = 252, does = {"restarts", "disconnects"}, answers = {{when = {steps = {"confirm"}, all = 1}, messages = {"Reset"}, certain = true, timeout = 0.5, repeated = {}}, {timeout = 0.5}}}
  messages[14].fields = {
    {name = "confirm", type = "u8", enum = "ResetOptions", count = 1, fixed = 1},
    {name = "delay_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
  }

  messages[15] = {name = "ReadStateVars", filter = "read_state_vars", command = "CMD_READ_STATE_VARS", id = 111, min = 192, max = 192, open = true, keeps_tail = true, tail = 63}
  messages[15].fields = {
    {name = "step_signal_val", type = "u8", dim = "fixed", count = 6, fixed = 6},
    {name = "sub_error", type = "u8", enum = "SystemSubError", count = 1, fixed = 1},
    {name = "max_acc", type = "u8", unit = "g", scale = 0.0625, count = 1, fixed = 1},
    {name = "work_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "startup_cnt", type = "u16", count = 1, fixed = 2},
    {name = "max_current", type = "u16", unit = "mA", count = 1, fixed = 2},
    {name = "imu_temp_min", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "imu_temp_max", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "mcu_temp_min", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "mcu_temp_max", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "shock_cnt", type = "u8", dim = "fixed", count = 4, fixed = 4},
    {name = "energy_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "energy", type = "f32", unit = "Wh", count = 1, fixed = 4},
    {name = "avg_current_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "avg_current", type = "f32", unit = "mA", scale = 1000, count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 152, count = 1, fixed = 152, reserved = true},
  }

  messages[16] = {name = "ReadStateVarsRequest", filter = "read_state_vars_request", command = "CMD_READ_STATE_VARS", id = 111, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ReadStateVars"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[16].fields = {
  }

  messages[17] = {name = "WriteStateVars", filter = "write_state_vars", command = "CMD_WRITE_STATE_VARS", id = 112, to_board = true, min = 192, max = 192, open = true, keeps_tail = true, tail = 63, does = {"stores"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[17].fields = {
    {name = "step_signal_val", type = "u8", dim = "fixed", count = 6, fixed = 6},
    {name = "sub_error", type = "u8", enum = "SystemSubError", count = 1, fixed = 1},
    {name = "max_acc", type = "u8", unit = "g", scale = 0.0625, count = 1, fixed = 1},
    {name = "work_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "startup_cnt", type = "u16", count = 1, fixed = 2},
    {name = "max_current", type = "u16", unit = "mA", count = 1, fixed = 2},
    {name = "imu_temp_min", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "imu_temp_max", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "mcu_temp_min", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "mcu_temp_max", type = "u8", unit = "degC", count = 1, fixed = 1},
    {name = "shock_cnt", type = "u8", dim = "fixed", count = 4, fixed = 4},
    {name = "energy_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "energy", type = "f32", unit = "Wh", count = 1, fixed = 4},
    {name = "avg_current_time", type = "u32", unit = "ms", scale = 1000, count = 1, fixed = 4},
    {name = "avg_current", type = "f32", unit = "mA", scale = 1000, count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 152, count = 1, fixed = 152, reserved = true},
  }

  messages[18] = {name = "SignMessage", filter = "sign_message", command = "CMD_SIGN_MESSAGE", id = 50, min = 32, max = 32, open = true, keeps_tail = true, tail = 223}
  messages[18].fields = {
    {name = "signature", blob = "bytes", size = 32, count = 1, fixed = 32},
  }

  messages[19] = {name = "SignMessageRequest", filter = "sign_message_request", command = "CMD_SIGN_MESSAGE", id = 50, to_board = true, min = 33, max = 33, open = true, takes_surplus = true, tail = 222, does = {"reads"}, answers = {{messages = {"SignMessage"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[19].fields = {
    {name = "sign_type", type = "u8", count = 1, fixed = 1},
    {name = "message", blob = "bytes", size = 32, count = 1, fixed = 32},
  }

  messages[20] = {name = "PassProtectRead", filter = "pass_protect_read", command = "CMD_PASS_PROTECT_READ", id = 136, min = 8, max = 8, open = true, keeps_tail = true, tail = 247}
  messages[20].fields = {
    {name = "flags", type = "u32", enum = "PassProtectFlags", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
  }

  messages[21] = {name = "PassProtectReadRequest", filter = "pass_protect_read_request", command = "CMD_PASS_PROTECT_READ", id = 136, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"PassProtectRead"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[21].fields = {
  }

  messages[22] = {name = "PassProtectWrite", filter = "pass_protect_write", command = "CMD_PASS_PROTECT_WRITE", id = 137, to_board = true, min = 9, max = 41, tail = 246, does = {"stores"}, secret_from = 8, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[22].fields = {
    {name = "flags", type = "u32", enum = "PassProtectFlags", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
    {name = "new_password", blob = "string", size = 32, count = 1, secret = true},
  }

  messages[23] = {name = "QueueParamsInfo3", filter = "queue_params_info3", command = "CMD_QUEUE_PARAMS_INFO_3", id = 30, min = 0, max = 255, open = true, tail = 255}
  messages[23].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[24] = {name = "QueueParamsInfo3Request", filter = "queue_params_info3request", command = "CMD_QUEUE_PARAMS_INFO_3", id = 30, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[24].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[25] = {name = "SystemState", filter = "system_state", command = "CMD_SYSTEM_STATE", id = 52, min = 0, max = 255, open = true, tail = 255}
  messages[25].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[26] = {name = "SystemStateRequest", filter = "system_state_request", command = "CMD_SYSTEM_STATE", id = 52, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[26].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[27] = {name = "MavlinkInfo", filter = "mavlink_info", command = "CMD_MAVLINK_INFO", id = 250, min = 0, max = 255, open = true, tail = 255}
  messages[27].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[28] = {name = "MavlinkInfoRequest", filter = "mavlink_info_request", command = "CMD_MAVLINK_INFO", id = 250, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[28].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[29] = {name = "MavlinkDebug", filter = "mavlink_debug", command = "CMD_MAVLINK_DEBUG", id = 251, min = 0, max = 255, open = true, tail = 255}
  messages[29].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[30] = {name = "MavlinkDebugRequest", filter = "mavlink_debug_request", command = "CMD_MAVLINK_DEBUG", id = 251, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[30].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[31] = {name = "ExtLicenseInfo", filter = "ext_license_info", command = "CMD_EXT_LICENSE_INFO", id = 124, min = 0, max = 255, open = true, tail = 255}
  messages[31].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[32] = {name = "ExtLicenseInfoRequest", filter = "ext_license_info_request", command = "CMD_EXT_LICENSE_INFO", id = 124, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[32].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[33] = {name = "ReadParams3", filter = "read_params3", command = "CMD_READ_PARAMS_3", id = 21, min = 134, max = 134, open = true, keeps_tail = true, tail = 121}
  messages[33].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "axes", struct = "AxisPid0", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "acc_limiter_all", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "disabled"}},
    {name = "ext_fc_gain_roll", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "ext_fc_gain_pitch", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "rc", struct = "AxisRc1", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 24},
    {name = "gyro_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "use_model", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "pwm_freq", type = "u8", enum = "PwmFrequency", count = 1, fixed = 1},
    {name = "serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "rc_trim", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "rc_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "rc_virt_mode", type = "u8", enum = "RcVirtualMode", count = 1, fixed = 1},
    {name = "rc_map", type = "u8", packed = "RcMap", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "rc_map_cmd", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_roll", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_pitch", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_mix_fc_roll", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "rc_mix_fc_pitch", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "follow_mode", type = "u8", enum = "FollowMode", count = 1, fixed = 1},
    {name = "follow_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "follow_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "follow_offset", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_imu_pos", type = "u8", enum = "FrameImuPosition", count = 1, fixed = 1},
    {name = "gyro_deadband", type = "u8", unit = "gyro unit", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "gyro_sens", type = "u8", count = 1, fixed = 1},
    {name = "i2c_internal_pullups", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "skip_gyro_calib", type = "u8", enum = "SkipGyroCalibration", count = 1, fixed = 1},
    {name = "rc_cmd_low", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_mid", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_high", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "menu_cmd", type = "u8", enum = "MenuCommand", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 5},
    {name = "menu_cmd_long", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "output", type = "u8", enum = "MotorOutput", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "bat_threshold_alarm", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_threshold_motors", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_comp_ref", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "beeper_modes", type = "u8", enum = "BeeperModes", count = 1, fixed = 1},
    {name = "follow_roll_mix_start", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "follow_roll_mix_range", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "booster_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "follow_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "frame_angle_from_motors", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "rc_memory", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "servo_out", type = "u8", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 4, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1, min = 5, max = 40},
    {name = "adaptive_pid_enabled", type = "u8", enum = "AdaptivePidAxes", count = 1, fixed = 1},
    {name = "adaptive_pid_threshold", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "adaptive_pid_rate", type = "u8", count = 1, fixed = 1, min = 1, max = 255},
    {name = "adaptive_pid_recovery_factor", type = "u8", count = 1, fixed = 1, min = 0, max = 10},
    {name = "follow_lpf", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 16},
    {name = "general_flags1", type = "u16", enum = "GeneralFlags", count = 1, fixed = 2},
    {name = "profile_flags1", type = "u16", enum = "ProfileFlags", count = 1, fixed = 2},
    {name = "spektrum_mode", type = "u8", enum = "SpektrumMode", count = 1, fixed = 1},
    {name = "order_of_axes", type = "u8", enum = "AxisOrder", count = 1, fixed = 1},
    {name = "euler_order", type = "u8", packed = "EulerOrderSetting", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
  }

  messages[34] = {name = "ReadParams3Request", filter = "read_params3request", command = "CMD_READ_PARAMS_3", id = 21, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"ReadParams3"}, certain = true, timeout = 0.5, repeated = {ReadParams3 = {{field = "profile_id", at = 0, size = 1}}}}}}
  messages[34].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
  }

  messages[35] = {name = "WriteParams3", filter = "write_params3", command = "CMD_WRITE_PARAMS_3", id = 22, to_board = true, min = 134, max = 134, open = true, keeps_tail = true, tail = 121, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[35].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "axes", struct = "AxisPid0", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "acc_limiter_all", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "disabled"}},
    {name = "ext_fc_gain_roll", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "ext_fc_gain_pitch", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "rc", struct = "AxisRc1", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 24},
    {name = "gyro_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "use_model", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "pwm_freq", type = "u8", enum = "PwmFrequency", count = 1, fixed = 1},
    {name = "serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "rc_trim", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "rc_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "rc_virt_mode", type = "u8", enum = "RcVirtualMode", count = 1, fixed = 1},
    {name = "rc_map", type = "u8", packed = "RcMap", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "rc_map_cmd", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_roll", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_pitch", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_mix_fc_roll", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "rc_mix_fc_pitch", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "follow_mode", type = "u8", enum = "FollowMode", count = 1, fixed = 1},
    {name = "follow_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "follow_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "follow_offset", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_imu_pos", type = "u8", enum = "FrameImuPosition", count = 1, fixed = 1},
    {name = "gyro_deadband", type = "u8", unit = "gyro unit", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "gyro_sens", type = "u8", count = 1, fixed = 1},
    {name = "i2c_internal_pullups", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "skip_gyro_calib", type = "u8", enum = "SkipGyroCalibration", count = 1, fixed = 1},
    {name = "rc_cmd_low", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_mid", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_high", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "menu_cmd", type = "u8", enum = "MenuCommand", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 5},
    {name = "menu_cmd_long", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "output", type = "u8", enum = "MotorOutput", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "bat_threshold_alarm", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_threshold_motors", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_comp_ref", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "beeper_modes", type = "u8", enum = "BeeperModes", count = 1, fixed = 1},
    {name = "follow_roll_mix_start", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "follow_roll_mix_range", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "booster_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "follow_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "frame_angle_from_motors", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "rc_memory", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "servo_out", type = "u8", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 4, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1, min = 5, max = 40},
    {name = "adaptive_pid_enabled", type = "u8", enum = "AdaptivePidAxes", count = 1, fixed = 1},
    {name = "adaptive_pid_threshold", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "adaptive_pid_rate", type = "u8", count = 1, fixed = 1, min = 1, max = 255},
    {name = "adaptive_pid_recovery_factor", type = "u8", count = 1, fixed = 1, min = 0, max = 10},
    {name = "follow_lpf", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 16},
    {name = "general_flags1", type = "u16", enum = "GeneralFlags", count = 1, fixed = 2},
    {name = "profile_flags1", type = "u16", enum = "ProfileFlags", count = 1, fixed = 2},
    {name = "spektrum_mode", type = "u8", enum = "SpektrumMode", count = 1, fixed = 1},
    {name = "order_of_axes", type = "u8", enum = "AxisOrder", count = 1, fixed = 1},
    {name = "euler_order", type = "u8", packed = "EulerOrderSetting", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
  }

  messages[36] = {name = "ReadParamsAnswer", filter = "read_params_answer", command = "CMD_READ_PARAMS", id = 82, min = 134, max = 134, open = true, keeps_tail = true, tail = 121}
  messages[36].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "axes", struct = "AxisPid0", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "acc_limiter_all", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "disabled"}},
    {name = "ext_fc_gain_roll", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "ext_fc_gain_pitch", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "rc", struct = "AxisRc1", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 24},
    {name = "gyro_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "use_model", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "pwm_freq", type = "u8", enum = "PwmFrequency", count = 1, fixed = 1},
    {name = "serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "rc_trim", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "rc_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "rc_virt_mode", type = "u8", enum = "RcVirtualMode", count = 1, fixed = 1},
    {name = "rc_map", type = "u8", packed = "RcMap", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "rc_map_cmd", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_roll", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_pitch", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_mix_fc_roll", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "rc_mix_fc_pitch", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "follow_mode", type = "u8", enum = "FollowMode", count = 1, fixed = 1},
    {name = "follow_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "follow_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "follow_offset", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_imu_pos", type = "u8", enum = "FrameImuPosition", count = 1, fixed = 1},
    {name = "gyro_deadband", type = "u8", unit = "gyro unit", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "gyro_sens", type = "u8", count = 1, fixed = 1},
    {name = "i2c_internal_pullups", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "skip_gyro_calib", type = "u8", enum = "SkipGyroCalibration", count = 1, fixed = 1},
    {name = "rc_cmd_low", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_mid", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_high", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "menu_cmd", type = "u8", enum = "MenuCommand", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 5},
    {name = "menu_cmd_long", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "output", type = "u8", enum = "MotorOutput", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "bat_threshold_alarm", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_threshold_motors", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_comp_ref", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "beeper_modes", type = "u8", enum = "BeeperModes", count = 1, fixed = 1},
    {name = "follow_roll_mix_start", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "follow_roll_mix_range", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "booster_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "follow_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "frame_angle_from_motors", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "rc_memory", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "servo_out", type = "u8", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 4, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1, min = 5, max = 40},
    {name = "adaptive_pid_enabled", type = "u8", enum = "AdaptivePidAxes", count = 1, fixed = 1},
    {name = "adaptive_pid_threshold", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "adaptive_pid_rate", type = "u8", count = 1, fixed = 1, min = 1, max = 255},
    {name = "adaptive_pid_recovery_factor", type = "u8", count = 1, fixed = 1, min = 0, max = 10},
    {name = "follow_lpf", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 16},
    {name = "general_flags1", type = "u16", enum = "GeneralFlags", count = 1, fixed = 2},
    {name = "profile_flags1", type = "u16", enum = "ProfileFlags", count = 1, fixed = 2},
    {name = "spektrum_mode", type = "u8", enum = "SpektrumMode", count = 1, fixed = 1},
    {name = "order_of_axes", type = "u8", enum = "AxisOrder", count = 1, fixed = 1},
    {name = "euler_order", type = "u8", packed = "EulerOrderSetting", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
  }

  messages[37] = {name = "ReadParams", filter = "read_params", command = "CMD_READ_PARAMS", id = 82, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"ReadParamsAnswer"}, certain = true, timeout = 0.5, repeated = {ReadParamsAnswer = {{field = "profile_id", at = 0, size = 1}}}}}}
  messages[37].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
  }

  messages[38] = {name = "WriteParams", filter = "write_params", command = "CMD_WRITE_PARAMS", id = 87, to_board = true, min = 134, max = 134, open = true, keeps_tail = true, tail = 121, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[38].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "axes", struct = "AxisPid0", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "acc_limiter_all", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "disabled"}},
    {name = "ext_fc_gain_roll", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "ext_fc_gain_pitch", type = "i8", count = 1, fixed = 1, min = -127, max = 127},
    {name = "rc", struct = "AxisRc1", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 24},
    {name = "gyro_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "use_model", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "pwm_freq", type = "u8", enum = "PwmFrequency", count = 1, fixed = 1},
    {name = "serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "rc_trim", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "rc_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "rc_virt_mode", type = "u8", enum = "RcVirtualMode", count = 1, fixed = 1},
    {name = "rc_map", type = "u8", packed = "RcMap", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "rc_map_cmd", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_roll", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_map_fc_pitch", type = "u8", packed = "RcMap", count = 1, fixed = 1},
    {name = "rc_mix_fc_roll", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "rc_mix_fc_pitch", type = "u8", packed = "RcMix", count = 1, fixed = 1},
    {name = "follow_mode", type = "u8", enum = "FollowMode", count = 1, fixed = 1},
    {name = "follow_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "follow_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "follow_offset", type = "i8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127},
    {name = "axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "frame_imu_pos", type = "u8", enum = "FrameImuPosition", count = 1, fixed = 1},
    {name = "gyro_deadband", type = "u8", unit = "gyro unit", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "gyro_sens", type = "u8", count = 1, fixed = 1},
    {name = "i2c_internal_pullups", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "skip_gyro_calib", type = "u8", enum = "SkipGyroCalibration", count = 1, fixed = 1},
    {name = "rc_cmd_low", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_mid", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "rc_cmd_high", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "menu_cmd", type = "u8", enum = "MenuCommand", dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 5},
    {name = "menu_cmd_long", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "output", type = "u8", enum = "MotorOutput", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "bat_threshold_alarm", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_threshold_motors", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "bat_comp_ref", type = "i16", unit = "V", scale = 0.01, count = 1, fixed = 2, min = -3000, max = 3000},
    {name = "beeper_modes", type = "u8", enum = "BeeperModes", count = 1, fixed = 1},
    {name = "follow_roll_mix_start", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "follow_roll_mix_range", type = "u8", unit = "deg", count = 1, fixed = 1, min = 0, max = 90},
    {name = "booster_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "follow_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "frame_angle_from_motors", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "rc_memory", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "servo_out", type = "u8", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 4, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1, min = 5, max = 40},
    {name = "adaptive_pid_enabled", type = "u8", enum = "AdaptivePidAxes", count = 1, fixed = 1},
    {name = "adaptive_pid_threshold", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "adaptive_pid_rate", type = "u8", count = 1, fixed = 1, min = 1, max = 255},
    {name = "adaptive_pid_recovery_factor", type = "u8", count = 1, fixed = 1, min = 0, max = 10},
    {name = "follow_lpf", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 16},
    {name = "general_flags1", type = "u16", enum = "GeneralFlags", count = 1, fixed = 2},
    {name = "profile_flags1", type = "u16", enum = "ProfileFlags", count = 1, fixed = 2},
    {name = "spektrum_mode", type = "u8", enum = "SpektrumMode", count = 1, fixed = 1},
    {name = "order_of_axes", type = "u8", enum = "AxisOrder", count = 1, fixed = 1},
    {name = "euler_order", type = "u8", packed = "EulerOrderSetting", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
  }

  messages[39] = {name = "ReadParamsExt", filter = "read_params_ext", command = "CMD_READ_PARAMS_EXT", id = 33, min = 104, max = 104, open = true, keeps_tail = true, tail = 151}
  messages[39].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "notches", struct = "AxisNotches2", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "lpf_freq", type = "u16", unit = "Hz", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 0, max = 1000},
    {name = "filters_en", type = "u8", enum = "FilterSwitches", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "encoder_offset", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_fld_offset", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_manual_set_time", type = "u8", unit = "ms", scale = 10, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_heating_factor", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_cooling_factor", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "reserved", blob = "bytes", size = 2, count = 1, fixed = 2, reserved = true},
    {name = "follow_inside_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "motor_mag_link", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_gearing", type = "u16", scale = 0.00390625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_limit_min", type = "i8", unit = "deg", scale = 3, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "encoder_limit_max", type = "i8", unit = "deg", scale = 3, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "notch1_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "notch2_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "notch3_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "beeper_volume", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "encoder_gear_ratio", type = "u16", scale = 0.001, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_type", type = "u8", packed = "EncoderType", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "encoder_cfg", type = "u8", enum = "EncoderConfig", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "outer_p", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "outer_i", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "mag_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "mag_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "mag_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "mag_declination", type = "i8", unit = "deg", count = 1, fixed = 1, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "acc_lpf_freq", type = "u16", unit = "Hz", scale = 0.01, count = 1, fixed = 2, min = 0, max = 1000},
    {name = "d_term_lpf_freq", type = "u8", unit = "Hz", scale = 10, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 60},
  }

  messages[40] = {name = "ReadParamsExtRequest", filter = "read_params_ext_request", command = "CMD_READ_PARAMS_EXT", id = 33, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"ReadParamsExt"}, certain = true, timeout = 0.5, repeated = {ReadParamsExt = {{field = "profile_id", at = 0, size = 1}}}}}}
  messages[40].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
  }

  messages[41] = {name = "WriteParamsExt", filter = "write_params_ext", command = "CMD_WRITE_PARAMS_EXT", id = 34, to_board = true, min = 104, max = 104, open = true, keeps_tail = true, tail = 151, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[41].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "notches", struct = "AxisNotches2", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
    {name = "lpf_freq", type = "u16", unit = "Hz", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 0, max = 1000},
    {name = "filters_en", type = "u8", enum = "FilterSwitches", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "encoder_offset", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_fld_offset", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_manual_set_time", type = "u8", unit = "ms", scale = 10, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_heating_factor", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_cooling_factor", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "reserved", blob = "bytes", size = 2, count = 1, fixed = 2, reserved = true},
    {name = "follow_inside_deadband", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "motor_mag_link", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "motor_gearing", type = "u16", scale = 0.00390625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_limit_min", type = "i8", unit = "deg", scale = 3, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "encoder_limit_max", type = "i8", unit = "deg", scale = 3, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "notch1_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "notch2_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "notch3_gain", type = "i8", unit = "dB", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = -100, max = 100},
    {name = "beeper_volume", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "encoder_gear_ratio", type = "u16", scale = 0.001, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "encoder_type", type = "u8", packed = "EncoderType", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "encoder_cfg", type = "u8", enum = "EncoderConfig", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "outer_p", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "outer_i", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255},
    {name = "mag_axis_top", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "mag_axis_right", type = "i8", enum = "SensorAxis", count = 1, fixed = 1},
    {name = "mag_trust", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "mag_declination", type = "i8", unit = "deg", count = 1, fixed = 1, min = -127, max = 127, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "acc_lpf_freq", type = "u16", unit = "Hz", scale = 0.01, count = 1, fixed = 2, min = 0, max = 1000},
    {name = "d_term_lpf_freq", type = "u8", unit = "Hz", scale = 10, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 60},
  }

  messages[42] = {name = "ReadParamsExt2", filter = "read_params_ext2", command = "CMD_READ_PARAMS_EXT2", id = 62, min = 151, max = 151, open = true, keeps_tail = true, tail = 104}
  messages[42].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "mav_channels", struct = "MavChannel3", dim = "fixed", count = 2, fixed = 16},
    {name = "motor_mag_link_fine", type = "u16", scale = 0.01, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 0, max = 65535},
    {name = "acc_limiter3", type = "u8", unit = "deg/s^2", scale = 5, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 200, special = {[0] = "disabled"}},
    {name = "pid_gain", type = "u8", scale = 0.02, add = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255, later = {{firmware = 2731, type = "u8", scale = 5, add = -5, ratio = 52, over = 255, min = 0, max = 255}}},
    {name = "frame_imu_lpf_freq", type = "u8", unit = "Hz", count = 1, fixed = 1, min = 0, max = 255},
    {name = "auto_pid_cfg", type = "u8", enum = "AutoPidFlags", count = 1, fixed = 1},
    {name = "auto_pid_gain", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "frame_cam_angle_min", type = "i16", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_cam_angle_max", type = "i16", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "general_flags2", type = "u16", enum = "GeneralFlags2", count = 1, fixed = 2},
    {name = "auto_speed", type = "u8", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "not set"}},
    {name = "auto_acc_limiter", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1},
    {name = "imu_orientation_corr", type = "i16", unit = "deg", scale = 0.01, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "timelapse_time", type = "u16", unit = "ms", scale = 1000, count = 1, fixed = 2},
    {name = "emergency_stop_restart_delay", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "timelapse_acc_part", type = "u8", unit = "%", scale = 0.2, count = 1, fixed = 1, min = 0, max = 250},
    {name = "momentum", type = "u16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "momentum_calib_stimulus", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 1, max = 255, special = {[0] = "not set"}},
    {name = "momentum_ellipticity", type = "u8", scale = 0.05, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "follow_range", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 1, max = 180, special = {[0] = "not set"}},
    {name = "stab_axis", type = "u8", packed = "StabAxis", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "outer_mot_tilt_angle", type = "i8", unit = "deg", count = 1, fixed = 1, min = -90, max = 90, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "startup_action", type = "u8", packed = "StartupAction", dim = "fixed", count = 4, fixed = 4},
    {name = "startup_action_src", type = "u8", packed = "RcMap", dim = "fixed", count = 8, fixed = 8},
    {name = "startup_action_threshold", type = "i8", dim = "fixed", count = 8, fixed = 8},
    {name = "force_position_cfg", type = "u8", packed = "ForcePositionConfig", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "step_signals", struct = "StepSignal4", dim = "fixed", count = 6, fixed = 12},
    {name = "rc_calibrations", struct = "RcCalibration5", dim = "fixed", count = 5, fixed = 20},
    {name = "parking_pos_cfg", type = "u8", enum = "ParkingBorders", count = 1, fixed = 1},
    {name = "ext_led_pin_id", type = "u8", enum = "OutputPin", count = 1, fixed = 1},
    {name = "interrupt_cfg", type = "u16", packed = "InterruptConfig", count = 1, fixed = 2},
    {name = "overload_time", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "auto_pid_momentum", type = "u8", count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "automatic"}},
    {name = "jerk_slope", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "mav_ctrl_mode", type = "u8", enum = "MavControlMode", count = 1, fixed = 1},
    {name = "rc_serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "uart2_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "motor_res", type = "u8", unit = "ohm", scale = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "current_limit", type = "u16", unit = "mA", scale = 10, count = 1, fixed = 2},
    {name = "middle_mot_tilt_angle", type = "i8", unit = "deg", count = 1, fixed = 1, min = -90, max = 90, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[43] = {name = "ReadParamsExt2Request", filter = "read_params_ext2request", command = "CMD_READ_PARAMS_EXT2", id = 62, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"ReadParamsExt2"}, certain = true, timeout = 0.5, repeated = {ReadParamsExt2 = {{field = "profile_id", at = 0, size = 1}}}}}}
  messages[43].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
  }

  messages[44] = {name = "WriteParamsExt2", filter = "write_params_ext2", command = "CMD_WRITE_PARAMS_EXT2", id = 63, to_board = true, min = 151, max = 151, open = true, keeps_tail = true, tail = 104, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[44].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "mav_channels", struct = "MavChannel3", dim = "fixed", count = 2, fixed = 16},
    {name = "motor_mag_link_fine", type = "u16", scale = 0.01, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 0, max = 65535},
    {name = "acc_limiter3", type = "u8", unit = "deg/s^2", scale = 5, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 200, special = {[0] = "disabled"}},
    {name = "pid_gain", type = "u8", scale = 0.02, add = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 0, max = 255, later = {{firmware = 2731, type = "u8", scale = 5, add = -5, ratio = 52, over = 255, min = 0, max = 255}}},
    {name = "frame_imu_lpf_freq", type = "u8", unit = "Hz", count = 1, fixed = 1, min = 0, max = 255},
    {name = "auto_pid_cfg", type = "u8", enum = "AutoPidFlags", count = 1, fixed = 1},
    {name = "auto_pid_gain", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "frame_cam_angle_min", type = "i16", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_cam_angle_max", type = "i16", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "general_flags2", type = "u16", enum = "GeneralFlags2", count = 1, fixed = 2},
    {name = "auto_speed", type = "u8", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "not set"}},
    {name = "auto_acc_limiter", type = "u8", unit = "deg/s^2", scale = 5, count = 1, fixed = 1},
    {name = "imu_orientation_corr", type = "i16", unit = "deg", scale = 0.01, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "timelapse_time", type = "u16", unit = "ms", scale = 1000, count = 1, fixed = 2},
    {name = "emergency_stop_restart_delay", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "timelapse_acc_part", type = "u8", unit = "%", scale = 0.2, count = 1, fixed = 1, min = 0, max = 250},
    {name = "momentum", type = "u16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "momentum_calib_stimulus", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 1, max = 255, special = {[0] = "not set"}},
    {name = "momentum_ellipticity", type = "u8", scale = 0.05, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "follow_range", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 1, max = 180, special = {[0] = "not set"}},
    {name = "stab_axis", type = "u8", packed = "StabAxis", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "outer_mot_tilt_angle", type = "i8", unit = "deg", count = 1, fixed = 1, min = -90, max = 90, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "startup_action", type = "u8", packed = "StartupAction", dim = "fixed", count = 4, fixed = 4},
    {name = "startup_action_src", type = "u8", packed = "RcMap", dim = "fixed", count = 8, fixed = 8},
    {name = "startup_action_threshold", type = "i8", dim = "fixed", count = 8, fixed = 8},
    {name = "force_position_cfg", type = "u8", packed = "ForcePositionConfig", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "step_signals", struct = "StepSignal4", dim = "fixed", count = 6, fixed = 12},
    {name = "rc_calibrations", struct = "RcCalibration5", dim = "fixed", count = 5, fixed = 20},
    {name = "parking_pos_cfg", type = "u8", enum = "ParkingBorders", count = 1, fixed = 1},
    {name = "ext_led_pin_id", type = "u8", enum = "OutputPin", count = 1, fixed = 1},
    {name = "interrupt_cfg", type = "u16", packed = "InterruptConfig", count = 1, fixed = 2},
    {name = "overload_time", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "auto_pid_momentum", type = "u8", count = 1, fixed = 1, min = 0, max = 255, special = {[0] = "automatic"}},
    {name = "jerk_slope", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "mav_ctrl_mode", type = "u8", enum = "MavControlMode", count = 1, fixed = 1},
    {name = "rc_serial_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "uart2_speed", type = "u8", enum = "SerialSpeed", count = 1, fixed = 1},
    {name = "motor_res", type = "u8", unit = "ohm", scale = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "current_limit", type = "u16", unit = "mA", scale = 10, count = 1, fixed = 2},
    {name = "middle_mot_tilt_angle", type = "i8", unit = "deg", count = 1, fixed = 1, min = -90, max = 90, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[45] = {name = "WriteParamsSet", filter = "write_params_set", command = "CMD_WRITE_PARAMS_SET", id = 119, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"sets", "moves", "restarts"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[45].fields = {
    {name = "action", type = "u8", enum = "WriteParamsAction", count = 1, fixed = 1},
  }

  messages[46] = {name = "ReadProfileNames", filter = "read_profile_names", command = "CMD_READ_PROFILE_NAMES", id = 28, min = 240, max = 240, open = true, keeps_tail = true, tail = 15}
  messages[46].fields = {
    {name = "profile_name", blob = "text", size = 48, dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 240},
  }

  messages[47] = {name = "ReadProfileNamesRequest", filter = "read_profile_names_request", command = "CMD_READ_PROFILE_NAMES", id = 28, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ReadProfileNames"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[47].fields = {
  }

  messages[48] = {name = "WriteProfileNames", filter = "write_profile_names", command = "CMD_WRITE_PROFILE_NAMES", id = 29, to_board = true, min = 240, max = 240, open = true, keeps_tail = true, tail = 15, does = {"stores"}, answers = {{confirm = true, timeout = 2}}}
  messages[48].fields = {
    {name = "profile_name", blob = "text", size = 48, dim = "fixed", index = {"1", "2", "3", "4", "5"}, count = 5, fixed = 240},
  }

  messages[49] = {name = "ProfileSet", filter = "profile_set", command = "CMD_PROFILE_SET", id = 95, to_board = true, min = 10, max = 10, open = true, takes_surplus = true, tail = 245, does = {"stores", "moves", "erases"}, answers = {{confirm = true, certain = true, timeout = 5}}}
  messages[49].fields = {
    {name = "slot", type = "u8", count = 1, fixed = 1, min = 1, max = 5, special = {[6] = "the backup"}},
    {name = "action", type = "u8", enum = "ProfileSetAction", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[50] = {name = "SaveParams3", filter = "save_params3", command = "CMD_SAVE_PARAMS_3", id = 32, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"stores"}, answers = {{confirm = true, timeout = 2}}}
  messages[50].fields = {
    {name = "param_id", type = "u8", enum = "VariableId", dim = "rest", capacity = 255},
  }

  messages[51] = {name = "UseDefaults", filter = "use_defaults", command = "CMD_USE_DEFAULTS", id = 70, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"stores", "moves", "erases"}, answers = {{confirm = true, timeout = 5}}}
  messages[51].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[253] = "erases the EEPROM", [254] = "resets the active profile"}},
  }

  messages[52] = {name = "ReadParamsExt3", filter = "read_params_ext3", command = "CMD_READ_PARAMS_EXT3", id = 104, min = 221, max = 221, open = true, keeps_tail = true, tail = 34}
  messages[52].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "reserved_1", blob = "bytes", size = 21, count = 1, fixed = 21, reserved = true},
    {name = "ext_imu_type", type = "u8", enum = "ExtImuModel", count = 1, fixed = 1},
    {name = "ext_imu_port", type = "u8", enum = "BoardPort", count = 1, fixed = 1},
    {name = "ext_imu_position", type = "u8", enum = "ExtImuPosition", count = 1, fixed = 1},
    {name = "ext_imu_orientation", type = "u8", packed = "ExtImuOrientation", count = 1, fixed = 1},
    {name = "ext_imu_flags", type = "u16", enum = "ExtImuFlags", count = 1, fixed = 2},
    {name = "ext_imu_align_correction", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "ext_imu_startup_delay", type = "u8", count = 1, fixed = 1},
    {name = "ext_imu_gyro_corr_rate", type = "u8", count = 1, fixed = 1},
    {name = "reserved_2", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
    {name = "soft_limit_width", type = "u8", unit = "deg", scale = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "adc_replace_src", type = "u8", packed = "RcMap", dim = "fixed", count = 3, fixed = 3},
    {name = "glock_mid_mot_pos_corr_rate", type = "u8", count = 1, fixed = 1},
    {name = "extra_btn_cfg", type = "u8", packed = "ExtraButton", dim = "fixed", count = 5, fixed = 5},
    {name = "overcurrent_protection", type = "u8", unit = "mA", scale = 500, count = 1, fixed = 1},
    {name = "power_on_delay", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "power_off_delay", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "power_on_limiter", type = "u8", count = 1, fixed = 1},
    {name = "reserved_3", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
    {name = "lpf_q_inv", type = "u8", scale = 0.02, add = 0.2, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "can_imu_ext_sens_type", type = "u8", enum = "CanImuSensor", count = 1, fixed = 1},
    {name = "profile_flags2", type = "u16", enum = "ProfileFlags2", count = 1, fixed = 2},
    {name = "reserved_4", blob = "bytes", size = 3, count = 1, fixed = 3, reserved = true},
    {name = "general_flags3", type = "u32", enum = "GeneralFlags3", count = 1, fixed = 4},
    {name = "follow_offset_ext", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -16384, max = 16384},
    {name = "motor_startup_delay", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "imu_model_main", type = "u8", count = 1, fixed = 1},
    {name = "imu_model_frame", type = "u8", count = 1, fixed = 1},
    {name = "stab_threshold_angle", type = "u8", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 15, max = 80, special = {[0] = "not set"}},
    {name = "ext_buzzer_pin", type = "u8", enum = "OutputPin", count = 1, fixed = 1},
    {name = "enc_limit_return_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "tripod_mode_auto_threshold", type = "u8", count = 1, fixed = 1},
    {name = "rc_deadband_pitch", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_deadband_yaw", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate_pitch", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate_yaw", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "profile_flags3", type = "u32", enum = "ProfileFlags3", count = 1, fixed = 4},
    {name = "default_profile", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
    {name = "retracted_angle", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "shake_generator", struct = "ShakeGenerator6", count = 1, fixed = 22},
    {name = "ext_motor_drv_ids", type = "u8", dim = "fixed", count = 7, fixed = 7},
    {name = "encoder_cfg_ext", type = "u16", packed = "EncoderConfigExt", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "ext_sens_params", blob = "bytes", size = 16, count = 1, fixed = 16},
    {name = "imu_angle_corr_r", type = "i16", unit = "deg", scale = 0.01, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "imu_angle_corr_p", type = "i16", unit = "deg", scale = 0.01, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "can_imu_servo_out", type = "u8", dim = "fixed", count = 2, fixed = 2, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "can_imu_servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1},
    {name = "servo_outer_p_mult", type = "u8", count = 1, fixed = 1},
    {name = "servo_outer_i", type = "u8", count = 1, fixed = 1},
    {name = "ext_pwr_sw_shunt_r", type = "u16", unit = "ohm", scale = 0.01, count = 1, fixed = 2},
    {name = "general_flags4", type = "u32", enum = "GeneralFlags4", count = 1, fixed = 4},
    {name = "auto_motion_timeout", type = "u8", count = 1, fixed = 1},
    {name = "reserved_5", blob = "bytes", size = 48, count = 1, fixed = 48, reserved = true},
  }

  messages[53] = {name = "ReadParamsExt3Request", filter = "read_params_ext3request", command = "CMD_READ_PARAMS_EXT3", id = 104, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"ReadParamsExt3"}, certain = true, timeout = 0.5, repeated = {ReadParamsExt3 = {{field = "profile_id", at = 0, size = 1}}}}}}
  messages[53].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
  }

  messages[54] = {name = "WriteParamsExt3", filter = "write_params_ext3", command = "CMD_WRITE_PARAMS_EXT3", id = 105, to_board = true, min = 221, max = 221, open = true, keeps_tail = true, tail = 34, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[54].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4, special = {[255] = "the active profile"}},
    {name = "reserved_1", blob = "bytes", size = 21, count = 1, fixed = 21, reserved = true},
    {name = "ext_imu_type", type = "u8", enum = "ExtImuModel", count = 1, fixed = 1},
    {name = "ext_imu_port", type = "u8", enum = "BoardPort", count = 1, fixed = 1},
    {name = "ext_imu_position", type = "u8", enum = "ExtImuPosition", count = 1, fixed = 1},
    {name = "ext_imu_orientation", type = "u8", packed = "ExtImuOrientation", count = 1, fixed = 1},
    {name = "ext_imu_flags", type = "u16", enum = "ExtImuFlags", count = 1, fixed = 2},
    {name = "ext_imu_align_correction", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "ext_imu_startup_delay", type = "u8", count = 1, fixed = 1},
    {name = "ext_imu_gyro_corr_rate", type = "u8", count = 1, fixed = 1},
    {name = "reserved_2", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
    {name = "soft_limit_width", type = "u8", unit = "deg", scale = 0.1, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "adc_replace_src", type = "u8", packed = "RcMap", dim = "fixed", count = 3, fixed = 3},
    {name = "glock_mid_mot_pos_corr_rate", type = "u8", count = 1, fixed = 1},
    {name = "extra_btn_cfg", type = "u8", packed = "ExtraButton", dim = "fixed", count = 5, fixed = 5},
    {name = "overcurrent_protection", type = "u8", unit = "mA", scale = 500, count = 1, fixed = 1},
    {name = "power_on_delay", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "power_off_delay", type = "u8", unit = "ms", scale = 100, count = 1, fixed = 1},
    {name = "power_on_limiter", type = "u8", count = 1, fixed = 1},
    {name = "reserved_3", blob = "bytes", size = 4, count = 1, fixed = 4, reserved = true},
    {name = "lpf_q_inv", type = "u8", scale = 0.02, add = 0.2, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "can_imu_ext_sens_type", type = "u8", enum = "CanImuSensor", count = 1, fixed = 1},
    {name = "profile_flags2", type = "u16", enum = "ProfileFlags2", count = 1, fixed = 2},
    {name = "reserved_4", blob = "bytes", size = 3, count = 1, fixed = 3, reserved = true},
    {name = "general_flags3", type = "u32", enum = "GeneralFlags3", count = 1, fixed = 4},
    {name = "follow_offset_ext", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -16384, max = 16384},
    {name = "motor_startup_delay", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "imu_model_main", type = "u8", count = 1, fixed = 1},
    {name = "imu_model_frame", type = "u8", count = 1, fixed = 1},
    {name = "stab_threshold_angle", type = "u8", unit = "deg", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3, min = 15, max = 80, special = {[0] = "not set"}},
    {name = "ext_buzzer_pin", type = "u8", enum = "OutputPin", count = 1, fixed = 1},
    {name = "enc_limit_return_speed", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "tripod_mode_auto_threshold", type = "u8", count = 1, fixed = 1},
    {name = "rc_deadband_pitch", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_deadband_yaw", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate_pitch", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "rc_expo_rate_yaw", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "profile_flags3", type = "u32", enum = "ProfileFlags3", count = 1, fixed = 4},
    {name = "default_profile", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
    {name = "retracted_angle", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "shake_generator", struct = "ShakeGenerator6", count = 1, fixed = 22},
    {name = "ext_motor_drv_ids", type = "u8", dim = "fixed", count = 7, fixed = 7},
    {name = "encoder_cfg_ext", type = "u16", packed = "EncoderConfigExt", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "ext_sens_params", blob = "bytes", size = 16, count = 1, fixed = 16},
    {name = "imu_angle_corr_r", type = "i16", unit = "deg", scale = 0.01, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "imu_angle_corr_p", type = "i16", unit = "deg", scale = 0.01, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "can_imu_servo_out", type = "u8", dim = "fixed", count = 2, fixed = 2, min = 1, max = 32, special = {[0] = "disabled"}},
    {name = "can_imu_servo_rate", type = "u8", unit = "Hz", scale = 10, count = 1, fixed = 1},
    {name = "servo_outer_p_mult", type = "u8", count = 1, fixed = 1},
    {name = "servo_outer_i", type = "u8", count = 1, fixed = 1},
    {name = "ext_pwr_sw_shunt_r", type = "u16", unit = "ohm", scale = 0.01, count = 1, fixed = 2},
    {name = "general_flags4", type = "u32", enum = "GeneralFlags4", count = 1, fixed = 4},
    {name = "auto_motion_timeout", type = "u8", count = 1, fixed = 1},
    {name = "reserved_5", blob = "bytes", size = 48, count = 1, fixed = 48, reserved = true},
  }

  messages[55] = {name = "RealtimeData", filter = "realtime_data", command = "CMD_REALTIME_DATA", id = 68, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"RealtimeData3"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[55].fields = {
  }

  messages[56] = {name = "RealtimeData3", filter = "realtime_data3", command = "CMD_REALTIME_DATA_3", id = 23, min = 63, max = 63, open = true, keeps_tail = true, tail = 192, role = {is = "battery", voltage = "bat_level"}}
  messages[56].fields = {
    {name = "axes", struct = "AxisSensors7", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12},
    {name = "serial_error_cnt", type = "u16", count = 1, fixed = 2},
    {name = "system_error", type = "u16", enum = "SystemErrors", count = 1, fixed = 2},
    {name = "system_sub_error", type = "u8", enum = "SystemSubError", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 3, count = 1, fixed = 3, reserved = true},
    {name = "rc", type = "i16", unit = "us", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 1000, max = 2000, special = {[-10000] = "no signal"}},
    {name = "rc_cmd", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[-10000] = "no signal"}},
    {name = "ext_fc_roll", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[0] = "the input serves RC control or commands", [-10000] = "no signal"}},
    {name = "ext_fc_pitch", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[0] = "the input serves RC control or commands", [-10000] = "no signal"}},
    {name = "angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_imu_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "rc_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "cycle_time", type = "u16", unit = "us", count = 1, fixed = 2},
    {name = "i2c_error_count", type = "u16", count = 1, fixed = 2},
    {name = "error_code", type = "u8", count = 1, fixed = 1},
    {name = "bat_level", type = "u16", unit = "V", scale = 0.01, count = 1, fixed = 2},
    {name = "other_flags", type = "u8", enum = "OtherFlags", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
    {name = "motor_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
  }

  messages[57] = {name = "RealtimeData3Request", filter = "realtime_data3request", command = "CMD_REALTIME_DATA_3", id = 23, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"RealtimeData3"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[57].fields = {
  }

  messages[58] = {name = "RealtimeData4", filter = "realtime_data4", command = "CMD_REALTIME_DATA_4", id = 25, min = 124, max = 124, open = true, keeps_tail = true, tail = 131}
  messages[58].fields = {
    {name = "axes", struct = "AxisSensors7", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12},
    {name = "serial_error_cnt", type = "u16", count = 1, fixed = 2},
    {name = "system_error", type = "u16", enum = "SystemErrors", count = 1, fixed = 2},
    {name = "system_sub_error", type = "u8", enum = "SystemSubError", count = 1, fixed = 1},
    {name = "reserved_1", blob = "bytes", size = 3, count = 1, fixed = 3, reserved = true},
    {name = "rc", type = "i16", unit = "us", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = 1000, max = 2000, special = {[-10000] = "no signal"}},
    {name = "rc_cmd", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[-10000] = "no signal"}},
    {name = "ext_fc_roll", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[0] = "the input serves RC control or commands", [-10000] = "no signal"}},
    {name = "ext_fc_pitch", type = "i16", unit = "us", count = 1, fixed = 2, min = 1000, max = 2000, special = {[0] = "the input serves RC control or commands", [-10000] = "no signal"}},
    {name = "angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_imu_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "rc_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -32768, max = 32767, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "cycle_time", type = "u16", unit = "us", count = 1, fixed = 2},
    {name = "i2c_error_count", type = "u16", count = 1, fixed = 2},
    {name = "error_code", type = "u8", count = 1, fixed = 1},
    {name = "bat_level", type = "u16", unit = "V", scale = 0.01, count = 1, fixed = 2},
    {name = "other_flags", type = "u8", enum = "OtherFlags", count = 1, fixed = 1},
    {name = "cur_imu", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "cur_profile", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
    {name = "motor_power", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "rotor_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "reserved_2", blob = "bytes", size = 1, count = 1, fixed = 1, reserved = true},
    {name = "balance_error", type = "i16", unit = "%", scale = 0.1953125, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -512, max = 512},
    {name = "current", type = "u16", unit = "mA", count = 1, fixed = 2},
    {name = "mag_data", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "imu_temperature", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "frame_imu_temperature", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "imu_g_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "imu_h_err", type = "u8", unit = "deg", scale = 0.1, count = 1, fixed = 1, min = 0, max = 255},
    {name = "motor_out", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, min = -10000, max = 10000},
    {name = "calib_mode", type = "u8", enum = "CalibMode", count = 1, fixed = 1},
    {name = "can_imu_ext_sens_err", type = "u8", count = 1, fixed = 1},
    {name = "actual_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "system_state_flags", type = "u32", enum = "StateFlags", count = 1, fixed = 4},
    {name = "reserved_3", blob = "bytes", size = 18, count = 1, fixed = 18, reserved = true},
  }

  messages[59] = {name = "RealtimeData4Request", filter = "realtime_data4request", command = "CMD_REALTIME_DATA_4", id = 25, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"RealtimeData4"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[59].fields = {
  }

  messages[60] = {name = "RealtimeDataCustom", filter = "realtime_data_custom", command = "CMD_REALTIME_DATA_CUSTOM", id = 88, min = 2, max = 255, open = true, keeps_tail = true, tail = 253, repeats = {name = "flags", at = 2, size = 4, mask = 2147483648}}
  messages[60].fields = {
    {name = "timestamp_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "flags", type = "u32", enum = "RealtimeDataCustomFlags", count = 1, fixed = 4, when = {context = "flags", all = 2147483648}},
    {name = "imu_angles", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 1}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "target_angles", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 2}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "target_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 4}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "stator_rotor_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 8}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "gyro_data", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 16}},
    {name = "rc_data", type = "i16", scale = 6.103515625e-05, dim = "fixed", count = 6, fixed = 12, min = -16384, max = 16384, special = {[-32768] = "undefined"}, when = {context = "flags", all = 32}},
    {name = "z1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1, when = {context = "flags", all = 64}},
    {name = "h1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1, when = {context = "flags", all = 64}},
    {name = "rc_channels", type = "i16", scale = 6.103515625e-05, dim = "fixed", count = 18, fixed = 36, min = -16384, max = 16384, special = {[-32768] = "undefined"}, when = {context = "flags", all = 128}},
    {name = "acc_data", type = "i16", unit = "g", scale = 0.001953125, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 256}},
    {name = "motor4_control", struct = "Motor4Control8", count = 1, fixed = 8, when = {context = "flags", all = 512}},
    {name = "ahrs_debug_info", struct = "AhrsDebugInfo9", count = 1, fixed = 26, when = {context = "flags", all = 1024}},
    {name = "encoder_raw24", type = "u24", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 9, when = {context = "flags", all = 2048}},
    {name = "imu_angles_rad", type = "f32", unit = "rad", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 4096}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "script_vars_float", type = "f32", dim = "fixed", count = 10, fixed = 40, when = {context = "flags", all = 8192}},
    {name = "script_vars_int16", type = "i16", dim = "fixed", count = 10, fixed = 20, when = {context = "flags", all = 16384}},
    {name = "system_power_state", struct = "SystemPowerState11", count = 1, fixed = 46, when = {context = "flags", all = 32768}},
    {name = "frame_cam_rate", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 65536}},
    {name = "imu_angles_20", type = "i32", unit = "deg", scale = 0.00034332275390625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 131072}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "target_angles_20", type = "i32", unit = "deg", scale = 0.00034332275390625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 262144}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "comm_errors", struct = "CommErrors12", count = 1, fixed = 7, when = {context = "flags", all = 524288}},
    {name = "system_state", struct = "SystemStatus13", count = 1, fixed = 13, when = {context = "flags", all = 1048576}},
    {name = "imu_quat", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {context = "flags", all = 2097152}},
    {name = "target_quat", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {context = "flags", all = 4194304}},
    {name = "imu_to_frame_quat", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {context = "flags", all = 8388608}},
    {name = "adc_ch_raw", type = "u16", dim = "fixed", count = 4, fixed = 8, min = 0, max = 4096, when = {context = "flags", all = 16777216}},
    {name = "sw_limits_dist", struct = "SoftLimitDistances14", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 33554432}},
    {name = "follow_dist", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 67108864}},
    {name = "ext_target_limit_min", type = "i32", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 134217728}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "ext_target_limit_max", type = "i32", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 134217728}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_cam_angle_20", type = "i32", unit = "deg", scale = 0.00034332275390625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12, when = {context = "flags", all = 268435456}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "main_imu_state", struct = "MainImuState15", count = 1, fixed = 11, when = {context = "flags", all = 536870912}},
  }

  messages[61] = {name = "RealtimeDataCustomRequest", filter = "realtime_data_custom_request", command = "CMD_REALTIME_DATA_CUSTOM", id = 88, to_board = true, min = 10, max = 10, open = true, takes_surplus = true, tail = 245, does = {"reads"}, answers = {{messages = {"RealtimeDataCustom"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[61].fields = {
    {name = "flags", type = "u32", enum = "RealtimeDataCustomFlags", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true},
  }

  messages[62] = {name = "RealtimeDataCustom2", filter = "realtime_data_custom2", command = "CMD_REALTIME_DATA_CUSTOM2", id = 139, min = 2, max = 52, open = true, keeps_tail = true, tail = 253, repeats = {name = "flags", at = 2, size = 4, mask = 2147483648}}
  messages[62].fields = {
    {name = "timestamp_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "flags", type = "u32", enum = "RealtimeDataCustom2Flags", count = 1, fixed = 4, when = {context = "flags", all = 2147483648}},
    {name = "frame_imu_angles", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 1}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_gyro", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 2}},
    {name = "frame_acc", type = "i16", unit = "g", scale = 0.001953125, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 4}},
    {name = "debug", type = "i16", dim = "fixed", count = 4, fixed = 8, when = {context = "flags", all = 8}},
    {name = "mag_sens_data", type = "i16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 16}},
    {name = "pin_state", struct = "PinStates16", count = 1, fixed = 8, when = {context = "flags", all = 32}},
    {name = "stab_err_ampl", type = "u16", unit = "deg", scale = 0.001, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, when = {context = "flags", all = 64}},
  }

  messages[63] = {name = "RealtimeDataCustom2Request", filter = "realtime_data_custom2request", command = "CMD_REALTIME_DATA_CUSTOM2", id = 139, to_board = true, min = 10, max = 10, open = true, takes_surplus = true, tail = 245, does = {"reads"}, answers = {{messages = {"RealtimeDataCustom2"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[63].fields = {
    {name = "flags", type = "u32", enum = "RealtimeDataCustom2Flags", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true},
  }

  messages[64] = {name = "DataStreamInterval", filter = "data_stream_interval", command = "CMD_DATA_STREAM_INTERVAL", id = 85, to_board = true, min = 21, max = 21, open = true, takes_surplus = true, tail = 234, does = {"sets"}, role = {is = "stream_request", command = "cmd_id", interval = "interval_ms", config = "config"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[64].fields = {
    {name = "cmd_id", type = "u8", enum = "CommandFromBoard", count = 1, fixed = 1},
    {name = "interval_ms", type = "u16", unit = "ms", count = 1, fixed = 2, special = {[0] = "ends the stream", [1] = "a sample in every cycle, 0.8 ms"}},
    {name = "config", struct = "StreamConfig17", count = 1, fixed = 8},
    {name = "sync_to_data", type = "u8", enum = "StreamSync", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 9, count = 1, fixed = 9, reserved = true},
  }

  messages[65] = {name = "CanDrvTelemetry", filter = "can_drv_telemetry", command = "CMD_CAN_DRV_TELEMETRY", id = 127, min = 3, max = 35, open = true, keeps_tail = true, tail = 252}
  messages[65].fields = {
    {name = "drv_id", type = "u8", count = 1, fixed = 1, min = 0, max = 6},
    {name = "timestamp_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "can_bus_flags", type = "u8", count = 1, fixed = 1, when = {context = "flags", all = 1}},
    {name = "can_bus_err_cnt", type = "u16", count = 1, fixed = 2, when = {context = "flags", all = 2}},
    {name = "temp_board", type = "i8", unit = "degC", count = 1, fixed = 1, when = {context = "flags", all = 4}},
    {name = "temp_motor", type = "i8", unit = "degC", count = 1, fixed = 1, when = {context = "flags", all = 8}},
    {name = "avg_current", type = "u16", unit = "mA", count = 1, fixed = 2, when = {context = "flags", all = 16}},
    {name = "bus_voltage", type = "u16", unit = "V", scale = 0.001, count = 1, fixed = 2, when = {context = "flags", all = 32}},
    {name = "pin_state", type = "u8", enum = "CanDrvPins", count = 1, fixed = 1, when = {context = "flags", all = 64}},
    {name = "phase_current", type = "i16", unit = "mA", dim = "fixed", count = 3, fixed = 6, when = {context = "flags", all = 128}},
    {name = "encoder_error_cnt", type = "u16", count = 1, fixed = 2, when = {context = "flags", all = 256}},
    {name = "iq_current", type = "i16", unit = "mA", count = 1, fixed = 2, when = {context = "flags", all = 512}},
    {name = "id_current", type = "i16", unit = "mA", count = 1, fixed = 2, when = {context = "flags", all = 512}},
    {name = "motor_speed", type = "i16", unit = "rpm", count = 1, fixed = 2, when = {context = "flags", all = 1024}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "pid_pos_err", type = "i16", count = 1, fixed = 2, when = {context = "flags", all = 2048}},
    {name = "pid_speed_err", type = "i16", count = 1, fixed = 2, when = {context = "flags", all = 4096}},
    {name = "iq_ref", type = "i16", unit = "%", scale = 0.0030517578125, count = 1, fixed = 2, when = {context = "flags", all = 8192}},
    {name = "pid_current_err", type = "i16", count = 1, fixed = 2, when = {context = "flags", all = 16384}},
  }

  messages[66] = {name = "CanDrvState", filter = "can_drv_state", command = "CMD_CAN_DRV_STATE", id = 98, min = 0, max = 255, open = true, tail = 255}
  messages[66].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[67] = {name = "CanDrvStateRequest", filter = "can_drv_state_request", command = "CMD_CAN_DRV_STATE", id = 98, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[67].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[68] = {name = "RealtimeDataCanDrv", filter = "realtime_data_can_drv", command = "CMD_REALTIME_DATA_CAN_DRV", id = 101, min = 0, max = 255, open = true, tail = 255}
  messages[68].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[69] = {name = "RealtimeDataCanDrvRequest", filter = "realtime_data_can_drv_request", command = "CMD_REALTIME_DATA_CAN_DRV", id = 101, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[69].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[70] = {name = "Control", filter = "control", command = "CMD_CONTROL", id = 67, to_board = true, min = 13, max = 13, tail = 242, does = {"moves"}, answers = {{when = {joined = "all", terms = {{steps = {"control_mode"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"control_mode"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}, confirm = true, count = 2, timeout = 12}, {confirm = true, timeout = 0.5}}}
  messages[70].fields = {
    {name = "control_mode", type = "u8", packed = "ControlMode", count = 1, fixed = 1},
    {name = "axes", struct = "ControlAxis18", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12},
  }

  messages[71] = {name = "ControlExt", filter = "control_ext", command = "CMD_CONTROL", id = 67, to_board = true, min = 15, max = 15, open = true, takes_surplus = true, tail = 240, does = {"moves"}, answers = {{when = {joined = "one_of", terms = {{joined = "all", terms = {{steps = {"control_mode", "roll"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"control_mode", "roll"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}, {joined = "all", terms = {{steps = {"control_mode", "pitch"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"control_mode", "pitch"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}, {joined = "all", terms = {{steps = {"control_mode", "yaw"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"control_mode", "yaw"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}}}, confirm = true, count = 2, timeout = 12}, {confirm = true, timeout = 0.5}}}
  messages[71].fields = {
    {name = "control_mode", type = "u8", packed = "ControlMode", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "axes", struct = "ControlAxis18", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 12},
  }

  messages[72] = {name = "ControlExtCommand", filter = "control_ext_command", command = "CMD_CONTROL_EXT", id = 121, to_board = true, min = 2, max = 32, open = true, takes_surplus = true, tail = 253, does = {"moves"}, answers = {{when = {joined = "one_of", terms = {{joined = "all", terms = {{steps = {"axes", "roll", "mode"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"axes", "roll", "mode"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}, {joined = "all", terms = {{steps = {"axes", "pitch", "mode"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"axes", "pitch", "mode"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}, {joined = "all", terms = {{steps = {"axes", "yaw", "mode"}, part = {most = 240, shift = 0, enum = "ControlFlags"}, all = 64}, {steps = {"axes", "yaw", "mode"}, part = {most = 15, shift = 0, enum = "ControlModeKind"}, numbers = {[2] = true, [5] = true}}}}}}, confirm = true, count = 2, timeout = 12}, {confirm = true, timeout = 0.5}}}
  messages[72].fields = {
    {name = "data_set", type = "u16", enum = "ControlExtFields", count = 1, fixed = 2},
    {name = "axes", struct = "ControlExtAxis19", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3},
  }

  messages[73] = {name = "ControlConfig", filter = "control_config", command = "CMD_CONTROL_CONFIG", id = 90, to_board = true, min = 41, max = 41, open = true, takes_surplus = true, tail = 214, does = {"sets", "moves"}, answers = {{when = {steps = {"flags"}, all = 1}, confirm = true, timeout = 0.5}, {confirm = true, certain = true, timeout = 0.5}}}
  messages[73].fields = {
    {name = "timeout_ms", type = "u16", unit = "ms", count = 1, fixed = 2, special = {[0] = "no timeout"}},
    {name = "ch_priority", type = "u8", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 4, min = 1, max = 255, special = {[0] = "the priority does not change"}},
    {name = "this_ch_priority", type = "u8", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "the priority does not change"}},
    {name = "axes", struct = "ControlConfigAxis20", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 21},
    {name = "rc_expo_rate", type = "u8", count = 1, fixed = 1, min = 0, max = 100},
    {name = "flags", type = "u16", enum = "ControlConfigFlags", count = 1, fixed = 2},
    {name = "euler_order", type = "u8", packed = "EulerOrderChoice", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 9, count = 1, fixed = 9, reserved = true},
  }

  messages[74] = {name = "ControlQuatDisabled", filter = "control_quat_disabled", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 2, max = 2, tail = 253, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[74].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, min = 0, max = 0},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
  }

  messages[75] = {name = "ControlQuatSpeed", filter = "control_quat_speed", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 14, max = 14, tail = 241, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[75].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
    {name = "target_speed", type = "f32", unit = "rad/s", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[76] = {name = "ControlQuatAttitude", filter = "control_quat_attitude", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 18, max = 18, tail = 237, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 65}, confirm = true, certain = true, count = 2, timeout = 11}, {when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"flags"}, all = 64}, confirm = true, certain = true, timeout = 11}, {timeout = 0.5}}}
  messages[76].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, min = 2, max = 2},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
    {name = "target_attitude", type = "f32", dim = "fixed", count = 4, fixed = 16, min = -1, max = 1},
  }

  messages[77] = {name = "ControlQuatAttitudePacked", filter = "control_quat_attitude_packed", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 10, max = 10, tail = 245, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 65}, confirm = true, certain = true, count = 2, timeout = 11}, {when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"flags"}, all = 64}, confirm = true, certain = true, timeout = 11}, {timeout = 0.5}}}
  messages[77].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, min = 2, max = 2},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
    {name = "target_attitude", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8},
  }

  messages[78] = {name = "ControlQuatSpeedAttitude", filter = "control_quat_speed_attitude", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 30, max = 30, open = true, takes_surplus = true, tail = 225, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[78].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, min = 5, max = 5},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
    {name = "target_attitude", type = "f32", dim = "fixed", count = 4, fixed = 16, min = -1, max = 1},
    {name = "target_speed", type = "f32", unit = "rad/s", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[79] = {name = "ControlQuatSpeedAttitudePacked", filter = "control_quat_speed_attitude_packed", command = "CMD_CONTROL_QUAT", id = 140, to_board = true, min = 22, max = 22, tail = 233, does = {"moves"}, answers = {{when = {steps = {"flags"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[79].fields = {
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, min = 5, max = 5},
    {name = "flags", type = "u8", enum = "ControlQuatFlags", count = 1, fixed = 1},
    {name = "target_attitude", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8},
    {name = "target_speed", type = "f32", unit = "rad/s", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[80] = {name = "ControlQuatStatus", filter = "control_quat_status", command = "CMD_CONTROL_QUAT_STATUS", id = 141, min = 2, max = 97, open = true, keeps_tail = true, tail = 253, fits = true}
  messages[80].fields = {
    {name = "data_set", type = "u16", enum = "ControlQuatStatusFields", count = 1, fixed = 2},
    {name = "data_set_high", type = "u16", count = 1, fixed = 2, fits = true},
    {name = "mode", type = "u8", enum = "ControlQuatMode", count = 1, fixed = 1, when = {steps = {"data_set"}, all = 1}},
    {name = "flags", type = "u16", enum = "ControlQuatStatusFlags", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 1}},
    {name = "target_attitude", type = "f32", dim = "fixed", count = 4, fixed = 16, min = -1, max = 1, when = {steps = {"data_set"}, all = 2}},
    {name = "setpoint_attitude", type = "f32", dim = "fixed", count = 4, fixed = 16, min = -1, max = 1, when = {steps = {"data_set"}, all = 4}},
    {name = "actual_attitude", type = "f32", dim = "fixed", count = 4, fixed = 16, min = -1, max = 1, when = {steps = {"data_set"}, all = 8}},
    {name = "target_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, when = {steps = {"data_set"}, all = 16}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "setpoint_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, when = {steps = {"data_set"}, all = 32}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "actual_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, when = {steps = {"data_set"}, all = 64}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "target_attitude_packed", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {steps = {"data_set"}, all = 128}},
    {name = "setpoint_attitude_packed", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {steps = {"data_set"}, all = 256}},
    {name = "actual_attitude_packed", type = "u64", packed = "PackedQuaternion", count = 1, fixed = 8, when = {steps = {"data_set"}, all = 512}},
  }

  messages[81] = {name = "ControlQuatStatusRequest", filter = "control_quat_status_request", command = "CMD_CONTROL_QUAT_STATUS", id = 141, to_board = true, min = 4, max = 4, open = true, takes_surplus = true, tail = 251, does = {"reads"}, answers = {{messages = {"ControlQuatStatus"}, certain = true, timeout = 0.5, repeated = {ControlQuatStatus = {{field = "data_set", at = 0, size = 2}}}}}}
  messages[81].fields = {
    {name = "data_set", type = "u16", enum = "ControlQuatStatusFields", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 2, count = 1, fixed = 2, reserved = true},
  }

  messages[82] = {name = "ControlQuatConfig", filter = "control_quat_config", command = "CMD_CONTROL_QUAT_CONFIG", id = 142, to_board = true, min = 2, max = 24, open = true, takes_surplus = true, tail = 253, does = {"sets"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[82].fields = {
    {name = "data_set", type = "u16", enum = "ControlQuatConfigFields", count = 1, fixed = 2},
    {name = "max_speed", type = "u16", unit = "deg/s", scale = 0.12207403790398877, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, when = {steps = {"data_set"}, all = 1}},
    {name = "acc_limit", type = "u16", unit = "deg/s^2", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, min = 1, max = 65535, special = {[0] = "no limit"}, when = {steps = {"data_set"}, all = 2}},
    {name = "jerk_slope", type = "u16", unit = "ms", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, min = 1, max = 65535, special = {[0] = "the acceleration changes at once"}, when = {steps = {"data_set"}, all = 4}},
    {name = "flags", type = "u16", enum = "ControlQuatConfigFlags", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 8}},
    {name = "attitude_lpf_freq", type = "u8", unit = "Hz", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "no filter"}, when = {steps = {"data_set"}, all = 16}},
    {name = "speed_lpf_freq", type = "u8", unit = "Hz", count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "no filter"}, when = {steps = {"data_set"}, all = 32}},
  }

  messages[83] = {name = "GetAngles", filter = "get_angles", command = "CMD_GET_ANGLES", id = 73, min = 18, max = 18, open = true, keeps_tail = true, tail = 237, role = {is = "angles", angle = "imu_angle"}}
  messages[83].fields = {
    {name = "axes", struct = "AxisState21", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 18},
  }

  messages[84] = {name = "GetAnglesRequest", filter = "get_angles_request", command = "CMD_GET_ANGLES", id = 73, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"GetAngles"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[84].fields = {
  }

  messages[85] = {name = "GetAnglesExt", filter = "get_angles_ext", command = "CMD_GET_ANGLES_EXT", id = 61, min = 54, max = 54, open = true, keeps_tail = true, tail = 201}
  messages[85].fields = {
    {name = "axes", struct = "AxisStateExt22", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 54},
  }

  messages[86] = {name = "GetAnglesExtRequest", filter = "get_angles_ext_request", command = "CMD_GET_ANGLES_EXT", id = 61, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"GetAnglesExt"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[86].fields = {
  }

  messages[87] = {name = "MotorsOn", filter = "motors_on", command = "CMD_MOTORS_ON", id = 77, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"moves"}, role = {is = "motors_on"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[87].fields = {
  }

  messages[88] = {name = "MotorsOff", filter = "motors_off", command = "CMD_MOTORS_OFF", id = 109, to_board = true, min = 0, max = 0, tail = 255, does = {"moves"}, role = {is = "motors_off"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[88].fields = {
  }

  messages[89] = {name = "MotorsOffExt", filter = "motors_off_ext", command = "CMD_MOTORS_OFF", id = 109, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"moves"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[89].fields = {
    {name = "mode", type = "u8", enum = "MotorsOffMode", count = 1, fixed = 1},
  }

  messages[90] = {name = "SyncMotors", filter = "sync_motors", command = "CMD_SYNC_MOTORS", id = 123, to_board = true, min = 6, max = 6, open = true, takes_surplus = true, tail = 249, does = {"moves"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[90].fields = {
    {name = "axis", type = "u8", enum = "SyncMotorAxis", count = 1, fixed = 1},
    {name = "power", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "angle", type = "u16", count = 1, fixed = 2, special = {[0] = "the motor holds its position"}},
  }

  messages[91] = {name = "Event", filter = "event", command = "CMD_EVENT", id = 102, min = 4, max = 4, open = true, keeps_tail = true, tail = 251}
  messages[91].fields = {
    {name = "event_id", type = "u8", enum = "EventId", count = 1, fixed = 1},
    {name = "event_type", type = "u8", enum = "EventTypes", count = 1, fixed = 1},
    {name = "param", blob = "bytes", size = 2, count = 1, fixed = 2},
  }

  messages[92] = {name = "ExecuteMenu", filter = "execute_menu", command = "CMD_EXECUTE_MENU", id = 69, to_board = true, min = 1, max = 1, tail = 254, does = {"sets", "stores", "moves", "restarts"}, answers = {{when = {steps = {"cmd_id"}, numbers = {[0] = true, [1] = true, [2] = true, [3] = true, [14] = true, [15] = true, [8] = true, [37] = true, [11] = true, [12] = true, [17] = true, [18] = true, [38] = true, [75] = true, [34] = true, [46] = true, [65] = true, [35] = true, [39] = true, [36] = true, [57] = true, [76] = true, [60] = true, [70] = true, [71] = true, [72] = true, [73] = true, [77] = true, [78] = true, [79] = true, [80] = true}}, confirm = true, timeout = 0.5}, {confirm = true, timeout = 0.5}}}
  messages[92].fields = {
    {name = "cmd_id", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
  }

  messages[93] = {name = "ExecuteMenuExt", filter = "execute_menu_ext", command = "CMD_EXECUTE_MENU", id = 69, to_board = true, min = 2, max = 2, open = true, takes_surplus = true, tail = 253, does = {"sets", "stores", "moves", "restarts"}, answers = {{when = {steps = {"param"}, all = 3}, confirm = true, certain = true, count = 2, timeout = 60}, {when = {joined = "all", terms = {{steps = {"param"}, all = 1}, {steps = {"cmd_id"}, numbers = {[0] = true, [1] = true, [2] = true, [3] = true, [14] = true, [15] = true, [8] = true, [37] = true, [11] = true, [12] = true, [17] = true, [18] = true, [38] = true, [75] = true, [34] = true, [46] = true, [65] = true, [35] = true, [39] = true, [36] = true, [57] = true, [76] = true, [60] = true, [70] = true, [71] = true, [72] = true, [73] = true, [77] = true, [78] = true, [79] = true, [80] = true}}}}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"param"}, all = 1}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"param"}, all = 2}, confirm = true, certain = true, timeout = 60}, {confirm = true, timeout = 0.5}}}
  messages[93].fields = {
    {name = "cmd_id", type = "u8", enum = "MenuCommand", count = 1, fixed = 1},
    {name = "param", type = "u8", enum = "ExecuteMenuFlags", count = 1, fixed = 1},
  }

  messages[94] = {name = "HelperData", filter = "helper_data", command = "CMD_HELPER_DATA", id = 72, to_board = true, min = 10, max = 10, tail = 245, does = {"moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[94].fields = {
    {name = "frame_acc", type = "i16", unit = "g", scale = 0.001953125, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_angle_roll", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, special = {[0] = "with FRAME_ANGLE_PITCH 0 too, not used"}},
    {name = "frame_angle_pitch", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, special = {[0] = "with FRAME_ANGLE_ROLL 0 too, not used"}},
  }

  messages[95] = {name = "HelperDataExt", filter = "helper_data_ext", command = "CMD_HELPER_DATA", id = 72, to_board = true, min = 20, max = 20, open = true, takes_surplus = true, tail = 235, does = {"moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[95].fields = {
    {name = "frame_acc", type = "i16", unit = "g", scale = 0.001953125, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_angle_roll", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, special = {[0] = "with FRAME_ANGLE_PITCH 0 too, not used"}},
    {name = "frame_angle_pitch", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -32768, max = 32767, special = {[0] = "with FRAME_ANGLE_ROLL 0 too, not used"}},
    {name = "coord_sys", type = "u8", packed = "HelperCoordinates", count = 1, fixed = 1},
    {name = "frame_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, special = {[0] = "with all three 0, not used"}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "frame_heading", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, min = -16384, max = 16384, special = {[32767] = "stops the correction of the heading"}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "reserved", blob = "bytes", size = 1, count = 1, fixed = 1, reserved = true},
  }

  messages[96] = {name = "ExtMotorsAction", filter = "ext_motors_action", command = "CMD_EXT_MOTORS_ACTION", id = 128, to_board = true, min = 2, max = 255, open = true, tail = 253, does = {"moves"}, answers = {{when = {steps = {"for_motors"}, all = 128}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[96].fields = {
    {name = "for_motors", type = "u8", enum = "ExtMotorTargets", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "ExtMotorActionKind", count = 1, fixed = 1},
    {name = "args", blob = "bytes", dim = "rest", count = 1, capacity = 253, reserved = true},
  }

  messages[97] = {name = "ExtMotorsControl", filter = "ext_motors_control", command = "CMD_EXT_MOTORS_CONTROL", id = 129, to_board = true, min = 2, max = 58, tail = 253, does = {"moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[97].fields = {
    {name = "for_motors", type = "u8", enum = "ExtMotors", count = 1, fixed = 1},
    {name = "data_set", type = "u8", enum = "ExtMotorsControlFields", count = 1, fixed = 1},
    {name = "setpoint16", type = "i16", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, none = {1, 2, 4}}},
    {name = "setpoint32", type = "i32", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, all = 1, none = {2, 4}}},
    {name = "setpoint16_param16", struct = "ExtMotorTarget1623", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, all = 2, none = {1}}},
    {name = "setpoint16_param32", struct = "ExtMotorTarget16Param3224", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, all = 4, none = {1, 2}}},
    {name = "setpoint32_param16", struct = "ExtMotorTarget32Param1625", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, all = 3}},
    {name = "setpoint32_param32", struct = "ExtMotorTarget3226", dim = "counted", capacity = 8, counter = "for_motors", counting = "bits", when = {steps = {"data_set"}, all = 5, none = {2}}},
  }

  messages[98] = {name = "ExtMotorsControlConfig", filter = "ext_motors_control_config", command = "CMD_EXT_MOTORS_CONTROL_CONFIG", id = 130, to_board = true, min = 3, max = 12, open = true, takes_surplus = true, tail = 252, does = {"sets"}, answers = {{when = {steps = {"for_motors"}, all = 128}, confirm = true, certain = true, timeout = 0.5}, {timeout = 0.5}}}
  messages[98].fields = {
    {name = "for_motors", type = "u8", enum = "ExtMotorTargets", count = 1, fixed = 1},
    {name = "data_set", type = "u16", enum = "ExtMotorsControlConfigFields", count = 1, fixed = 2},
    {name = "mode", type = "u8", enum = "ExtMotorMode", count = 1, fixed = 1, when = {steps = {"data_set"}, all = 1}},
    {name = "max_speed", type = "u16", unit = "deg/s", scale = 2, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 2}},
    {name = "max_acceleration", type = "u16", unit = "deg/s^2", scale = 2, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 4}},
    {name = "jerk_slope", type = "u16", unit = "ms", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 8}},
    {name = "max_torque", type = "u16", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 16}},
  }

  messages[99] = {name = "ExtMotorsState", filter = "ext_motors_state", command = "CMD_EXT_MOTORS_STATE", id = 131, min = 5, max = 50, open = true, keeps_tail = true, tail = 250}
  messages[99].fields = {
    {name = "motor_id", type = "u8", count = 1, fixed = 1, min = 0, max = 6},
    {name = "data_set", type = "u32", enum = "ExtMotorsStateFields", count = 1, fixed = 4},
    {name = "control_mode", type = "u8", enum = "ExtMotorMode", count = 1, fixed = 1, when = {steps = {"data_set"}, all = 1}},
    {name = "torque", type = "i16", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 2}},
    {name = "torque_setpoint", type = "i16", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 4}},
    {name = "speed16", type = "i16", unit = "deg/s", scale = 0.12207403790398877, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 8}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "speed16_setpoint", type = "i16", unit = "deg/s", scale = 0.12207403790398877, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 16}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "speed32", type = "i32", unit = "rad/s", scale = 1e-06, count = 1, fixed = 4, when = {steps = {"data_set"}, all = 32}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "speed32_setpoint", type = "i32", unit = "rad/s", scale = 1e-06, count = 1, fixed = 4, when = {steps = {"data_set"}, all = 64}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "angle16", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 128}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "angle16_setpoint", type = "i16", unit = "deg", scale = 0.02197265625, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 256}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "angle32", type = "i32", unit = "deg", scale = 0.00034332275390625, count = 1, fixed = 4, when = {steps = {"data_set"}, all = 512}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "angle32_setpoint", type = "i32", unit = "deg", scale = 0.00034332275390625, count = 1, fixed = 4, when = {steps = {"data_set"}, all = 1024}, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "state_flags", type = "u16", packed = "ExtMotorStatus", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 2048}},
    {name = "max_speed", type = "u16", unit = "deg/s", scale = 2, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 4096}},
    {name = "max_acceleration", type = "u16", unit = "deg/s^2", scale = 2, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 8192}},
    {name = "jerk_slope", type = "u16", unit = "ms", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 16384}},
    {name = "max_torque", type = "u16", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 32768}},
    {name = "current", type = "u16", unit = "mA", count = 1, fixed = 2, when = {steps = {"data_set"}, all = 65536}},
    {name = "battery_voltage", type = "u16", unit = "V", scale = 0.001, count = 1, fixed = 2, when = {steps = {"data_set"}, all = 131072}},
    {name = "motor_temperature", type = "i8", unit = "degC", count = 1, fixed = 1, when = {steps = {"data_set"}, all = 262144}},
    {name = "driver_temperature", type = "i8", unit = "degC", count = 1, fixed = 1, when = {steps = {"data_set"}, all = 524288}},
  }

  messages[100] = {name = "ExtMotorsStateRequest", filter = "ext_motors_state_request", command = "CMD_EXT_MOTORS_STATE", id = 131, to_board = true, min = 5, max = 5, open = true, takes_surplus = true, tail = 250, does = {"reads"}, answers = {{messages = {"ExtMotorsState"}, certain = true, timeout = 0.5, repeated = {ExtMotorsState = {{field = "data_set", at = 1, size = 4}}}}}}
  messages[100].fields = {
    {name = "for_motors", type = "u8", enum = "ExtMotors", count = 1, fixed = 1},
    {name = "data_set", type = "u32", enum = "ExtMotorsStateFields", count = 1, fixed = 4},
  }

  messages[101] = {name = "CalibAcc", filter = "calib_acc", command = "CMD_CALIB_ACC", id = 65, to_board = true, min = 0, max = 0, tail = 255, does = {"stores"}, answers = {{confirm = true, certain = true, count = 2, timeout = 30}}}
  messages[101].fields = {
  }

  messages[102] = {name = "CalibAccExt", filter = "calib_acc_ext", command = "CMD_CALIB_ACC", id = 65, to_board = true, min = 12, max = 12, open = true, takes_surplus = true, tail = 243, does = {"stores", "restarts", "erases"}, answers = {{when = {steps = {"action"}, numbers = {[2] = true, [4] = true, [5] = true}}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"action"}, numbers = {[3] = true}}, confirm = true, certain = true, count = 2, timeout = 3600}, {confirm = true, certain = true, count = 2, timeout = 30}}}
  messages[102].fields = {
    {name = "imu_idx", type = "u8", enum = "CalibImu", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "CalibAction", count = 1, fixed = 1},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[103] = {name = "CalibGyro", filter = "calib_gyro", command = "CMD_CALIB_GYRO", id = 103, to_board = true, min = 0, max = 0, tail = 255, does = {"stores"}, role = {is = "gyro_calibration"}, answers = {{confirm = true, certain = true, count = 2, timeout = 30}}}
  messages[103].fields = {
  }

  messages[104] = {name = "CalibGyroExt", filter = "calib_gyro_ext", command = "CMD_CALIB_GYRO", id = 103, to_board = true, min = 12, max = 12, open = true, takes_surplus = true, tail = 243, does = {"stores", "restarts", "erases"}, answers = {{when = {steps = {"action"}, numbers = {[2] = true, [4] = true, [5] = true}}, confirm = true, certain = true, timeout = 0.5}, {when = {steps = {"action"}, numbers = {[3] = true}}, confirm = true, certain = true, count = 2, timeout = 3600}, {confirm = true, certain = true, count = 2, timeout = 30}}}
  messages[104].fields = {
    {name = "imu_idx", type = "u8", enum = "CalibImu", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "CalibAction", count = 1, fixed = 1},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2, special = {[0] = "about 4 s"}},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[105] = {name = "CalibMag", filter = "calib_mag", command = "CMD_CALIB_MAG", id = 59, to_board = true, min = 0, max = 0, tail = 255, does = {"stores"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[105].fields = {
  }

  messages[106] = {name = "CalibMagExt", filter = "calib_mag_ext", command = "CMD_CALIB_MAG", id = 59, to_board = true, min = 12, max = 12, open = true, takes_surplus = true, tail = 243, does = {"stores", "restarts", "erases"}, answers = {{when = {steps = {"action"}, numbers = {[2] = true, [4] = true, [5] = true}}, confirm = true, timeout = 0.5}, {confirm = true, timeout = 0.5}}}
  messages[106].fields = {
    {name = "imu_idx", type = "u8", enum = "CalibImu", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "CalibAction", count = 1, fixed = 1},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[107] = {name = "CalibExtGain", filter = "calib_ext_gain", command = "CMD_CALIB_EXT_GAIN", id = 71, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 30}}}
  messages[107].fields = {
  }

  messages[108] = {name = "CalibPoles", filter = "calib_poles", command = "CMD_CALIB_POLES", id = 80, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 30}}}
  messages[108].fields = {
  }

  messages[109] = {name = "CalibOffset", filter = "calib_offset", command = "CMD_CALIB_OFFSET", id = 79, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[109].fields = {
  }

  messages[110] = {name = "CalibBat", filter = "calib_bat", command = "CMD_CALIB_BAT", id = 66, to_board = true, min = 2, max = 2, open = true, takes_surplus = true, tail = 253, does = {"stores"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[110].fields = {
    {name = "actual_voltage", type = "u16", unit = "V", scale = 0.01, count = 1, fixed = 2},
  }

  messages[111] = {name = "CalibInfo", filter = "calib_info", command = "CMD_CALIB_INFO", id = 49, min = 33, max = 33, open = true, keeps_tail = true, tail = 222}
  messages[111].fields = {
    {name = "progress", type = "u8", unit = "%", count = 1, fixed = 1, min = 0, max = 100},
    {name = "imu_type", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "acc_data", type = "i16", unit = "g", scale = 0.001953125, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "gyro_abs_val", type = "u16", count = 1, fixed = 2},
    {name = "acc_cur_axis", type = "u8", count = 1, fixed = 1, min = 0, max = 2},
    {name = "acc_limits_info", type = "u8", enum = "CalibratedLimits", count = 1, fixed = 1},
    {name = "imu_temp_cels", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "temp_calib_gyro_enabled", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "temp_calib_gyro_t_min_cels", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "temp_calib_gyro_t_max_cels", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "temp_calib_acc_enabled", type = "u8", count = 1, fixed = 1, min = 0, max = 1},
    {name = "temp_calib_acc_slot_num", type = "u8", dim = "fixed", count = 6, fixed = 6, min = 0, max = 3},
    {name = "temp_calib_acc_t_min_cels", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "temp_calib_acc_t_max_cels", type = "i8", unit = "degC", count = 1, fixed = 1, min = -127, max = 127},
    {name = "h1_err_length", type = "u8", scale = 0.01, count = 1, fixed = 1, min = 0, max = 255},
    {name = "reserved", blob = "bytes", size = 7, count = 1, fixed = 7, reserved = true},
  }

  messages[112] = {name = "CalibInfoRequest", filter = "calib_info_request", command = "CMD_CALIB_INFO", id = 49, to_board = true, min = 12, max = 12, open = true, takes_surplus = true, tail = 243, does = {"reads"}, answers = {{messages = {"CalibInfo"}, certain = true, timeout = 0.5, repeated = {CalibInfo = {{field = "imu_type", at = 1, size = 1}}}}}}
  messages[112].fields = {
    {name = "imu_type", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 11, count = 1, fixed = 11, reserved = true},
  }

  messages[113] = {name = "CalibMotorMagLink", filter = "calib_motor_mag_link", command = "CMD_CALIB_MOTOR_MAG_LINK", id = 74, min = 0, max = 255, open = true, tail = 255}
  messages[113].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[114] = {name = "CalibMotorMagLinkRequest", filter = "calib_motor_mag_link_request", command = "CMD_CALIB_MOTOR_MAG_LINK", id = 74, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[114].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[115] = {name = "EncodersCalibOffset4", filter = "encoders_calib_offset4", command = "CMD_ENCODERS_CALIB_OFFSET_4", id = 26, to_board = true, min = 0, max = 1, open = true, takes_surplus = true, tail = 255, does = {"stores"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[115].fields = {
    {name = "for_motor", type = "u8", enum = "CalibMotor", count = 1, fixed = 1, appended = true},
  }

  messages[116] = {name = "EncodersCalibFldOffset4", filter = "encoders_calib_fld_offset4", command = "CMD_ENCODERS_CALIB_FLD_OFFSET_4", id = 27, to_board = true, min = 0, max = 14, open = true, takes_surplus = true, tail = 255, does = {"stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[116].fields = {
    {name = "calib_angle", type = "i16", unit = "deg", scale = 0.02197265625, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, appended = true},
    {name = "calib_speed", type = "i16", unit = "deg/s", scale = 0.061037018951994385, dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6, appended = true},
    {name = "calib_flags", type = "u16", enum = "FieldOffsetFlags", count = 1, fixed = 2, appended = true},
  }

  messages[117] = {name = "AutoPid", filter = "auto_pid", command = "CMD_AUTO_PID", id = 35, min = 57, max = 57, open = true, keeps_tail = true, tail = 198}
  messages[117].fields = {
    {name = "p", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "i", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "d", type = "u8", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 3},
    {name = "lpf_freq", type = "u16", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 6},
    {name = "iter_num", type = "u16", count = 1, fixed = 2},
    {name = "axes", struct = "AxisTuning27", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 30},
    {name = "reserved", blob = "bytes", size = 10, count = 1, fixed = 10, reserved = true},
  }

  messages[118] = {name = "AutoPidRequest", filter = "auto_pid_request", command = "CMD_AUTO_PID", id = 35, to_board = true, min = 19, max = 19, open = true, takes_surplus = true, tail = 236, does = {"stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[118].fields = {
    {name = "profile_id", type = "u8", count = 1, fixed = 1, min = 0, max = 4},
    {name = "cfg_flags", type = "u8", enum = "AutoPidFlags", count = 1, fixed = 1, special = {[0] = "stops the tuning"}},
    {name = "gain_vs_stability", type = "u8", count = 1, fixed = 1, min = 0, max = 255},
    {name = "momentum", type = "u8", count = 1, fixed = 1, special = {[0] = "automatic"}},
    {name = "action", type = "u8", count = 1, fixed = 1, special = {[0] = "starts the tuning"}},
    {name = "reserved", blob = "bytes", size = 14, count = 1, fixed = 14, reserved = true},
  }

  messages[119] = {name = "AutoPid2", filter = "auto_pid2", command = "CMD_AUTO_PID2", id = 108, to_board = true, min = 11, max = 73, open = true, takes_surplus = true, tail = 244, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[119].fields = {
    {name = "action", type = "u8", enum = "AutoPid2Action", count = 1, fixed = 1},
    {name = "cmd_flags", type = "u16", enum = "AutoPid2CommandFlags", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
    {name = "config", struct = "AutoPid2Config29", count = 1, fixed = 62, when = {steps = {"action"}, numbers = {[1] = true, [2] = true, [3] = true}}},
  }

  messages[120] = {name = "CalibOrientCorr", filter = "calib_orient_corr", command = "CMD_CALIB_ORIENT_CORR", id = 91, to_board = true, min = 16, max = 16, open = true, takes_surplus = true, tail = 239, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 30}}}
  messages[120].fields = {
    {name = "reserved", blob = "bytes", size = 16, count = 1, fixed = 16, reserved = true},
  }

  messages[121] = {name = "CalibCogging", filter = "calib_cogging", command = "CMD_CALIB_COGGING", id = 93, to_board = true, min = 57, max = 57, open = true, takes_surplus = true, tail = 198, does = {"stores", "moves", "erases"}, answers = {{confirm = true, certain = true, timeout = 30}}}
  messages[121].fields = {
    {name = "action", type = "u8", enum = "CoggingAction", count = 1, fixed = 1},
    {name = "axes", type = "u8", enum = "CoggingAxes", count = 1, fixed = 1},
    {name = "motors", struct = "CoggingMotor30", dim = "axis", index = {"roll", "pitch", "yaw"}, count = 3, fixed = 45, used_when = {joined = "all", terms = {{steps = {"action"}, numbers = {[2] = true}, negated = true}, {steps = {"axes"}, all = 1, elements = {roll = {steps = {"axes"}, all = 1}, pitch = {steps = {"axes"}, all = 2}, yaw = {steps = {"axes"}, all = 4}}}}}},
    {name = "iterations_num", type = "u8", count = 1, fixed = 1, min = 2, max = 255, used_when = {steps = {"action"}, numbers = {[2] = true}, negated = true}},
    {name = "reserved", blob = "bytes", size = 9, count = 1, fixed = 9, reserved = true},
  }

  messages[122] = {name = "CalibAccExtRef", filter = "calib_acc_ext_ref", command = "CMD_CALIB_ACC_EXT_REF", id = 94, to_board = true, min = 20, max = 20, open = true, takes_surplus = true, tail = 235, does = {"stores"}, answers = {{confirm = true, certain = true, timeout = 30}}}
  messages[122].fields = {
    {name = "acc_ref", type = "i16", unit = "g", scale = 0.001953125, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "reserved", blob = "bytes", size = 14, count = 1, fixed = 14, reserved = true},
  }

  messages[123] = {name = "BodeTestStartStop", filter = "bode_test_start_stop", command = "CMD_BODE_TEST_START_STOP", id = 37, min = 22, max = 22, open = true, keeps_tail = true, tail = 233}
  messages[123].fields = {
    {name = "samples_count", type = "u32", count = 1, fixed = 4},
    {name = "error_code", type = "u16", count = 1, fixed = 2, special = {[0] = "success"}},
    {name = "mode", type = "u8", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 15, count = 1, fixed = 15, reserved = true},
  }

  messages[124] = {name = "BodeTestStartStopRequest", filter = "bode_test_start_stop_request", command = "CMD_BODE_TEST_START_STOP", id = 37, to_board = true, min = 30, max = 30, open = true, takes_surplus = true, tail = 225, does = {"moves"}, answers = {{messages = {"BodeTestStartStop"}, confirm = true, certain = true, timeout = 3600, repeated = {}}}}
  messages[124].fields = {
    {name = "axis", type = "u8", enum = "BodeAxis", count = 1, fixed = 1},
    {name = "stimulus_type", type = "u8", enum = "BodeStimulus", count = 1, fixed = 1},
    {name = "stimulus_gain", type = "u16", count = 1, fixed = 2, min = 1, max = 65535},
    {name = "end_freq", type = "u16", unit = "Hz", count = 1, fixed = 2},
    {name = "system", type = "u8", enum = "BodeSystem", count = 1, fixed = 1},
    {name = "samples_num", type = "u32", count = 1, fixed = 4},
    {name = "mode", type = "u8", count = 1, fixed = 1, min = 0, max = 0},
    {name = "start_freq", type = "u16", unit = "Hz", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 16, count = 1, fixed = 16, reserved = true},
  }

  messages[125] = {name = "BodeTestData", filter = "bode_test_data", command = "CMD_BODE_TEST_DATA", id = 38, min = 17, max = 97, open = true, tail = 238}
  messages[125].fields = {
    {name = "sample_counter", type = "u8", count = 1, fixed = 1},
    {name = "input_min", type = "f32", count = 1, fixed = 4},
    {name = "output_min", type = "f32", count = 1, fixed = 4},
    {name = "input_max", type = "f32", count = 1, fixed = 4},
    {name = "output_max", type = "f32", count = 1, fixed = 4},
    {name = "samples", struct = "BodeSample31", dim = "rest", capacity = 59},
  }

  messages[126] = {name = "CoggingCalibInfo", filter = "cogging_calib_info", command = "CMD_COGGING_CALIB_INFO", id = 92, min = 0, max = 255, open = true, tail = 255}
  messages[126].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[127] = {name = "CoggingCalibInfoRequest", filter = "cogging_calib_info_request", command = "CMD_COGGING_CALIB_INFO", id = 92, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[127].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[128] = {name = "CanDrvHardParams", filter = "can_drv_hard_params", command = "CMD_CAN_DRV_HARD_PARAMS", id = 97, min = 0, max = 255, open = true, tail = 255}
  messages[128].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[129] = {name = "CanDrvHardParamsRequest", filter = "can_drv_hard_params_request", command = "CMD_CAN_DRV_HARD_PARAMS", id = 97, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[129].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[130] = {name = "CanDrvCalibrate", filter = "can_drv_calibrate", command = "CMD_CAN_DRV_CALIBRATE", id = 99, min = 0, max = 255, open = true, tail = 255}
  messages[130].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[131] = {name = "CanDrvCalibrateRequest", filter = "can_drv_calibrate_request", command = "CMD_CAN_DRV_CALIBRATE", id = 99, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[131].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[132] = {name = "CalibEncoderLut", filter = "calib_encoder_lut", command = "CMD_CALIB_ENCODER_LUT", id = 117, min = 0, max = 255, open = true, tail = 255}
  messages[132].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[133] = {name = "CalibEncoderLutRequest", filter = "calib_encoder_lut_request", command = "CMD_CALIB_ENCODER_LUT", id = 117, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[133].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[134] = {name = "CalibEncoderLutRes", filter = "calib_encoder_lut_res", command = "CMD_CALIB_ENCODER_LUT_RES", id = 118, min = 0, max = 255, open = true, tail = 255}
  messages[134].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[135] = {name = "CalibEncoderLutResRequest", filter = "calib_encoder_lut_res_request", command = "CMD_CALIB_ENCODER_LUT_RES", id = 118, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[135].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[136] = {name = "CalibCurSens", filter = "calib_cur_sens", command = "CMD_CALIB_CUR_SENS", id = 120, min = 0, max = 255, open = true, tail = 255}
  messages[136].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[137] = {name = "CalibCurSensRequest", filter = "calib_cur_sens_request", command = "CMD_CALIB_CUR_SENS", id = 120, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[137].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[138] = {name = "EncIntCalib", filter = "enc_int_calib", command = "CMD_ENC_INT_CALIB", id = 122, min = 0, max = 255, open = true, tail = 255}
  messages[138].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[139] = {name = "EncIntCalibRequest", filter = "enc_int_calib_request", command = "CMD_ENC_INT_CALIB", id = 122, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[139].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[140] = {name = "VibrationTestStartStop", filter = "vibration_test_start_stop", command = "CMD_VIBRATION_TEST_START_STOP", id = 125, min = 0, max = 255, open = true, tail = 255}
  messages[140].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[141] = {name = "VibrationTestStartStopRequest", filter = "vibration_test_start_stop_request", command = "CMD_VIBRATION_TEST_START_STOP", id = 125, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[141].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[142] = {name = "VibrationTestData", filter = "vibration_test_data", command = "CMD_VIBRATION_TEST_DATA", id = 126, min = 0, max = 255, open = true, tail = 255}
  messages[142].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[143] = {name = "VibrationTestDataRequest", filter = "vibration_test_data_request", command = "CMD_VIBRATION_TEST_DATA", id = 126, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[143].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[144] = {name = "SelectImu3", filter = "select_imu3", command = "CMD_SELECT_IMU_3", id = 24, to_board = true, min = 1, max = 1, tail = 254, does = {"sets"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[144].fields = {
    {name = "imu_type", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
  }

  messages[145] = {name = "SelectImu3Ext", filter = "select_imu3ext", command = "CMD_SELECT_IMU_3", id = 24, to_board = true, min = 2, max = 10, tail = 253, does = {"sets"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[145].fields = {
    {name = "imu_type", type = "u8", enum = "SelectedImu", count = 1, fixed = 1},
    {name = "param", type = "u8", count = 1, fixed = 1},
    {name = "params", blob = "bytes", dim = "rest", count = 1, capacity = 253},
  }

  messages[146] = {name = "SelectImu3CalibrateShort", filter = "select_imu3calibrate_short", command = "CMD_SELECT_IMU_3", id = 24, to_board = true, min = 11, max = 11, tail = 244, does = {"stores", "restarts", "erases"}, answers = {{when = {steps = {"action"}, numbers = {[2] = true, [4] = true, [5] = true}}, confirm = true, timeout = 0.5}, {when = {steps = {"action"}, numbers = {[3] = true}}, confirm = true, count = 2, timeout = 3600}, {confirm = true, count = 2, timeout = 30}}}
  messages[146].fields = {
    {name = "imu_type", type = "u8", enum = "CalibImu", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "CalibAction", count = 1, fixed = 1},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 7, count = 1, fixed = 7, reserved = true},
  }

  messages[147] = {name = "SelectImu3Calibrate", filter = "select_imu3calibrate", command = "CMD_SELECT_IMU_3", id = 24, to_board = true, min = 12, max = 12, open = true, takes_surplus = true, tail = 243, does = {"stores", "restarts", "erases"}, answers = {{when = {steps = {"action"}, numbers = {[2] = true, [4] = true, [5] = true}}, confirm = true, timeout = 0.5}, {when = {steps = {"action"}, numbers = {[3] = true}}, confirm = true, count = 2, timeout = 3600}, {confirm = true, count = 2, timeout = 30}}}
  messages[147].fields = {
    {name = "imu_type", type = "u8", enum = "CalibImu", count = 1, fixed = 1},
    {name = "action", type = "u8", enum = "CalibAction", count = 1, fixed = 1},
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[148] = {name = "AhrsHelper", filter = "ahrs_helper", command = "CMD_AHRS_HELPER", id = 56, min = 24, max = 24, open = true, keeps_tail = true, tail = 231}
  messages[148].fields = {
    {name = "z1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
    {name = "h1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
  }

  messages[149] = {name = "AhrsHelperRequest", filter = "ahrs_helper_request", command = "CMD_AHRS_HELPER", id = 56, to_board = true, min = 1, max = 1, tail = 254, does = {"reads"}, answers = {{messages = {"AhrsHelper"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[149].fields = {
    {name = "mode", type = "u8", enum = "AhrsHelperMode", count = 1, fixed = 1},
  }

  messages[150] = {name = "AhrsHelperRequestWide", filter = "ahrs_helper_request_wide", command = "CMD_AHRS_HELPER", id = 56, to_board = true, min = 2, max = 2, tail = 253, does = {"reads"}, answers = {{messages = {"AhrsHelper"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[150].fields = {
    {name = "mode", type = "u16", enum = "AhrsHelperWideMode", count = 1, fixed = 2},
  }

  messages[151] = {name = "AhrsHelperRequestExt", filter = "ahrs_helper_request_ext", command = "CMD_AHRS_HELPER", id = 56, to_board = true, min = 25, max = 25, tail = 230, does = {"moves"}, answers = {{when = {steps = {"mode"}, all = 1}, confirm = true, timeout = 0.5}, {messages = {"AhrsHelper"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[151].fields = {
    {name = "mode", type = "u8", enum = "AhrsHelperMode", count = 1, fixed = 1},
    {name = "z1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
    {name = "h1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
  }

  messages[152] = {name = "AhrsHelperRequestExtWide", filter = "ahrs_helper_request_ext_wide", command = "CMD_AHRS_HELPER", id = 56, to_board = true, min = 26, max = 26, open = true, takes_surplus = true, tail = 229, does = {"moves"}, answers = {{when = {steps = {"mode"}, all = 1}, confirm = true, timeout = 0.5}, {messages = {"AhrsHelper"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[152].fields = {
    {name = "mode", type = "u16", enum = "AhrsHelperWideMode", count = 1, fixed = 2},
    {name = "z1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
    {name = "h1_vector", type = "f32", dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 12, min = -1, max = 1},
  }

  messages[153] = {name = "GyroCorrection", filter = "gyro_correction", command = "CMD_GYRO_CORRECTION", id = 75, to_board = true, min = 9, max = 9, open = true, takes_surplus = true, tail = 246, does = {"stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[153].fields = {
    {name = "imu_type", type = "u8", enum = "ImuIndex", count = 1, fixed = 1},
    {name = "gyro_zero_corr", type = "i16", unit = "gyro unit", scale = 0.001, dim = "xyz", index = {"x", "y", "z"}, count = 3, fixed = 6, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
    {name = "gyro_zero_heading_corr", type = "i16", unit = "gyro unit", scale = 0.001, count = 1, fixed = 2, ways = {pitch = {"down", "up"}, yaw = {"right", "left"}}},
  }

  messages[154] = {name = "ExtImuDebugInfo", filter = "ext_imu_debug_info", command = "CMD_EXT_IMU_DEBUG_INFO", id = 106, min = 74, max = 74, open = true, keeps_tail = true, tail = 181}
  messages[154].fields = {
    {name = "ahrs_debug_info", struct = "AhrsDebugInfo9", count = 1, fixed = 26},
    {name = "dcm", type = "f32", dim = "fixed", count = 9, fixed = 36},
    {name = "acc_body", type = "f32", dim = "fixed", count = 3, fixed = 12},
  }

  messages[155] = {name = "ExtImuDebugInfoRequest", filter = "ext_imu_debug_info_request", command = "CMD_EXT_IMU_DEBUG_INFO", id = 106, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ExtImuDebugInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[155].fields = {
  }

  messages[156] = {name = "ExtImuCmd", filter = "ext_imu_cmd", command = "CMD_EXT_IMU_CMD", id = 110, min = 1, max = 255, open = true, tail = 254}
  messages[156].fields = {
    {name = "cmd_id", type = "u8", count = 1, fixed = 1},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[157] = {name = "ExtImuCmd", filter = "ext_imu_cmd", command = "CMD_EXT_IMU_CMD", id = 110, to_board = true, min = 1, max = 255, open = true, tail = 254, does = {"sets", "stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[157].fields = {
    {name = "cmd_id", type = "u8", count = 1, fixed = 1},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[158] = {name = "ExtSensCmd", filter = "ext_sens_cmd", command = "CMD_EXT_SENS_CMD", id = 150, min = 1, max = 255, open = true, tail = 254}
  messages[158].fields = {
    {name = "cmd_id", type = "u8", enum = "ExtSensCommand", count = 1, fixed = 1},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[159] = {name = "ExtSensCmdRequest", filter = "ext_sens_cmd_request", command = "CMD_EXT_SENS_CMD", id = 150, to_board = true, min = 2, max = 255, open = true, tail = 253, does = {"sets", "stores", "moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[159].fields = {
    {name = "flags", type = "u8", enum = "ExtSensOptions", count = 1, fixed = 1},
    {name = "cmd_id", type = "u8", enum = "ExtSensCommand", count = 1, fixed = 1},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 253},
  }

  messages[160] = {name = "ImuAdvancedCalib", filter = "imu_advanced_calib", command = "CMD_IMU_ADVANCED_CALIB", id = 115, min = 0, max = 255, open = true, tail = 255}
  messages[160].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[161] = {name = "ImuAdvancedCalibRequest", filter = "imu_advanced_calib_request", command = "CMD_IMU_ADVANCED_CALIB", id = 115, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[161].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[162] = {name = "BeepSound", filter = "beep_sound", command = "CMD_BEEP_SOUND", id = 89, to_board = true, min = 12, max = 112, open = true, tail = 243, does = {"sets"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[162].fields = {
    {name = "mode", type = "u16", enum = "BeepModes", count = 1, fixed = 2},
    {name = "note_length", type = "u8", unit = "ms", scale = 8, count = 1, fixed = 1, min = 1, max = 255, special = {[0] = "without meaning unless a custom melody is played"}},
    {name = "decay_factor", type = "u8", count = 1, fixed = 1, min = 0, max = 15, special = {[0] = "no envelope"}},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
    {name = "note_freq_hz", type = "u16", unit = "Hz", dim = "rest", capacity = 121, min = 554, max = 20999, special = {[21000] = "pause, then the envelope starts again"}},
  }

  messages[163] = {name = "TriggerPin", filter = "trigger_pin", command = "CMD_TRIGGER_PIN", id = 84, to_board = true, min = 2, max = 2, open = true, takes_surplus = true, tail = 253, does = {"sets"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[163].fields = {
    {name = "pin_id", type = "u8", enum = "OutputPin", count = 1, fixed = 1},
    {name = "state", type = "u8", enum = "PinState", count = 1, fixed = 1},
  }

  messages[164] = {name = "ServoOut", filter = "servo_out", command = "CMD_SERVO_OUT", id = 36, to_board = true, min = 16, max = 16, open = true, takes_surplus = true, tail = 239, does = {"moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[164].fields = {
    {name = "servo_time", type = "i16", unit = "us", dim = "fixed", index = {"1", "2", "3", "4", "5", "6", "7", "8"}, count = 8, fixed = 16, min = -1, max = 20000, special = {[-1] = "the pin is set free and floats", [0] = "the pin is low all the time"}},
  }

  messages[165] = {name = "ServoOutFour", filter = "servo_out_four", command = "CMD_SERVO_OUT", id = 36, to_board = true, min = 8, max = 8, tail = 247, does = {"moves"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[165].fields = {
    {name = "servo_time", type = "i16", unit = "us", dim = "fixed", index = {"1", "2", "3", "4"}, count = 4, fixed = 8, min = -1, max = 20000, special = {[-1] = "the pin is set free and floats", [0] = "the pin is low all the time"}},
  }

  messages[166] = {name = "ServoOutExt", filter = "servo_out_ext", command = "CMD_SERVO_OUT_EXT", id = 133, to_board = true, min = 4, max = 68, tail = 251, does = {"moves"}, answers = {{timeout = 0.5}}}
  messages[166].fields = {
    {name = "servo_bits", type = "u32", enum = "ServoOutputs", count = 1, fixed = 4},
    {name = "servo_time", type = "i16", unit = "us", dim = "counted", capacity = 32, counter = "servo_bits", counting = "bits", min = -1, max = 20000, special = {[-1] = "the pin is set free and floats", [0] = "the pin is low all the time"}},
  }

  messages[167] = {name = "I2cWriteRegBuf", filter = "i2c_write_reg_buf", command = "CMD_I2C_WRITE_REG_BUF", id = 39, to_board = true, min = 2, max = 255, open = true, tail = 253, does = {"sets", "stores"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[167].fields = {
    {name = "device_addr", type = "u8", packed = "I2cDevice", count = 1, fixed = 1},
    {name = "reg_addr", type = "u8", count = 1, fixed = 1},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 253},
  }

  messages[168] = {name = "I2cReadRegBuf", filter = "i2c_read_reg_buf", command = "CMD_I2C_READ_REG_BUF", id = 40, min = 0, max = 255, open = true, tail = 255}
  messages[168].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[169] = {name = "I2cReadRegBufRequest", filter = "i2c_read_reg_buf_request", command = "CMD_I2C_READ_REG_BUF", id = 40, to_board = true, min = 3, max = 3, tail = 252, does = {"reads"}, answers = {{messages = {"I2cReadRegBuf"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[169].fields = {
    {name = "device_addr", type = "u8", packed = "I2cDevice", count = 1, fixed = 1},
    {name = "reg_addr", type = "u8", count = 1, fixed = 1},
    {name = "data_len", type = "u8", unit = "byte", count = 1, fixed = 1, min = 1, max = 255},
  }

  messages[170] = {name = "I2cReadRegBufRequestNoRegister", filter = "i2c_read_reg_buf_request_no_register", command = "CMD_I2C_READ_REG_BUF", id = 40, to_board = true, min = 2, max = 2, tail = 253, does = {"reads"}, answers = {{messages = {"I2cReadRegBuf"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[170].fields = {
    {name = "device_addr", type = "u8", packed = "I2cDevice", count = 1, fixed = 1},
    {name = "data_len", type = "u8", unit = "byte", count = 1, fixed = 1, min = 1, max = 255},
  }

  messages[171] = {name = "I2cReadRegBufRequestWideRegister", filter = "i2c_read_reg_buf_request_wide_register", command = "CMD_I2C_READ_REG_BUF", id = 40, to_board = true, min = 4, max = 4, open = true, takes_surplus = true, tail = 251, does = {"reads"}, answers = {{messages = {"I2cReadRegBuf"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[171].fields = {
    {name = "device_addr", type = "u8", packed = "I2cDevice", count = 1, fixed = 1},
    {name = "reg_addr", type = "u16", count = 1, fixed = 2},
    {name = "data_len", type = "u8", unit = "byte", count = 1, fixed = 1, min = 1, max = 255},
  }

  messages[172] = {name = "ApiVirtChControl", filter = "api_virt_ch_control", command = "CMD_API_VIRT_CH_CONTROL", id = 45, to_board = true, min = 2, max = 64, open = true, tail = 253, does = {"sets", "stores", "moves", "restarts"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[172].fields = {
    {name = "val_ch", type = "i16", scale = 0.002, dim = "rest", index = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19", "20", "21", "22", "23", "24", "25", "26", "27", "28", "29", "30", "31", "32"}, capacity = 32, min_count = 1, min = -500, max = 500, special = {[-10000] = "undefined, as if the signal were lost"}},
  }

  messages[173] = {name = "ApiVirtChHighRes", filter = "api_virt_ch_high_res", command = "CMD_API_VIRT_CH_HIGH_RES", id = 116, to_board = true, min = 2, max = 64, open = true, tail = 253, does = {"sets", "stores", "moves", "restarts"}, answers = {{timeout = 0.5}}}
  messages[173].fields = {
    {name = "val_ch", type = "i16", scale = 6.103515625e-05, dim = "rest", index = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19", "20", "21", "22", "23", "24", "25", "26", "27", "28", "29", "30", "31", "32"}, capacity = 32, min_count = 1, min = -16384, max = 16384, special = {[-32768] = "undefined, as if the signal were lost"}},
  }

  messages[174] = {name = "ReadRcInputs", filter = "read_rc_inputs", command = "CMD_READ_RC_INPUTS", id = 100, min = 0, max = 254, open = true, tail = 255}
  messages[174].fields = {
    {name = "rc_val", type = "i16", scale = 6.103515625e-05, dim = "rest", capacity = 127, min = -16384, max = 16384, special = {[-32768] = "undefined"}},
  }

  messages[175] = {name = "ReadRcInputsRequest", filter = "read_rc_inputs_request", command = "CMD_READ_RC_INPUTS", id = 100, to_board = true, min = 2, max = 129, open = true, tail = 253, does = {"sets"}, answers = {{messages = {"ReadRcInputs"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[175].fields = {
    {name = "cfg_flags", type = "u16", enum = "RcInputOptions", count = 1, fixed = 2},
    {name = "rc_src", type = "u8", packed = "RcMap", dim = "rest", capacity = 253},
  }

  messages[176] = {name = "ModuleList", filter = "module_list", command = "CMD_MODULE_LIST", id = 76, min = 1, max = 222, open = true, keeps_tail = true, tail = 254}
  messages[176].fields = {
    {name = "device_num", type = "u8", count = 1, fixed = 1, min = 0, max = 17},
    {name = "modules", struct = "ModuleInfo32", dim = "counted", capacity = 19, counter = "device_num"},
  }

  messages[177] = {name = "ModuleListRequest", filter = "module_list_request", command = "CMD_MODULE_LIST", id = 76, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ModuleList"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[177].fields = {
  }

  messages[178] = {name = "CanDeviceScan", filter = "can_device_scan", command = "CMD_CAN_DEVICE_SCAN", id = 96, min = 0, max = 252, open = true, tail = 255}
  messages[178].fields = {
    {name = "devices", struct = "CanDevice33", dim = "rest", capacity = 18},
  }

  messages[179] = {name = "CanDeviceScanRequest", filter = "can_device_scan_request", command = "CMD_CAN_DEVICE_SCAN", id = 96, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"CanDeviceScan"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[179].fields = {
  }

  messages[180] = {name = "TransparentSapi", filter = "transparent_sapi", command = "CMD_TRANSPARENT_SAPI", id = 151, min = 1, max = 255, open = true, tail = 254}
  messages[180].fields = {
    {name = "target", type = "u8", packed = "TransparentTarget", count = 1, fixed = 1},
    {name = "payload", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[181] = {name = "TransparentSapiRequest", filter = "transparent_sapi_request", command = "CMD_TRANSPARENT_SAPI", id = 151, to_board = true, min = 1, max = 255, open = true, tail = 254, does = {"sets", "stores", "moves", "restarts", "erases"}, answers = {{timeout = 0.5}}}
  messages[181].fields = {
    {name = "target", type = "u8", packed = "TransparentTarget", count = 1, fixed = 1},
    {name = "payload", blob = "bytes", dim = "rest", count = 1, capacity = 254},
  }

  messages[182] = {name = "ModuleFlashStart", filter = "module_flash_start", command = "CMD_MODULE_FLASH_START", id = 78, to_board = true, min = 5, max = 5, open = true, takes_surplus = true, tail = 250, does = {"restarts", "erases"}, answers = {{confirm = true, certain = true, timeout = 5}}}
  messages[182].fields = {
    {name = "device_id", type = "u8", enum = "ModuleId", count = 1, fixed = 1},
    {name = "firmware_size", type = "u32", unit = "byte", scale = 4, count = 1, fixed = 4, min = 1, max = 4294967295},
  }

  messages[183] = {name = "ModuleFlashWrite", filter = "module_flash_write", command = "CMD_MODULE_FLASH_WRITE", id = 81, to_board = true, min = 14, max = 138, open = true, tail = 241, does = {"stores"}, answers = {{confirm = true, certain = true, timeout = 5}}}
  messages[183].fields = {
    {name = "device_id", type = "u8", enum = "ModuleId", count = 1, fixed = 1},
    {name = "packet_id", type = "u8", count = 1, fixed = 1},
    {name = "address", type = "u32", count = 1, fixed = 4},
    {name = "data_crc32", type = "u32", count = 1, fixed = 4},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 245, min_count = 4},
  }

  messages[184] = {name = "ModuleFlashFinish", filter = "module_flash_finish", command = "CMD_MODULE_FLASH_FINISH", id = 83, to_board = true, min = 5, max = 5, open = true, takes_surplus = true, tail = 250, does = {"stores"}, answers = {{confirm = true, certain = true, timeout = 5}}}
  messages[184].fields = {
    {name = "device_id", type = "u8", enum = "ModuleId", count = 1, fixed = 1},
    {name = "file_crc32", type = "u32", count = 1, fixed = 4},
  }

  messages[185] = {name = "UdrvDeviceScan", filter = "udrv_device_scan", command = "CMD_UDRV_DEVICE_SCAN", id = 144, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"stores"}, answers = {{messages = {"CanDeviceScan"}, certain = true, timeout = 5, repeated = {}}}}
  messages[185].fields = {
  }

  messages[186] = {name = "SetTranspProxy", filter = "set_transp_proxy", command = "CMD_SET_TRANSP_PROXY", id = 143, to_board = true, min = 2, max = 2, open = true, takes_surplus = true, tail = 253, does = {"sets", "disconnects"}, answers = {{timeout = 0.5}}}
  messages[186].fields = {
    {name = "port1", type = "u8", count = 1, fixed = 1, special = {[0] = "the port of this request"}},
    {name = "port2", type = "u8", count = 1, fixed = 1, special = {[0] = "the port of this request"}},
  }

  messages[187] = {name = "UartBypass", filter = "uart_bypass", command = "CMD_UART_BYPASS", id = 60, min = 0, max = 255, open = true, tail = 255}
  messages[187].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[188] = {name = "UartBypassRequest", filter = "uart_bypass_request", command = "CMD_UART_BYPASS", id = 60, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[188].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[189] = {name = "SetDeviceAddr", filter = "set_device_addr", command = "CMD_SET_DEVICE_ADDR", id = 107, min = 0, max = 255, open = true, tail = 255}
  messages[189].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[190] = {name = "SetDeviceAddrRequest", filter = "set_device_addr_request", command = "CMD_SET_DEVICE_ADDR", id = 107, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[190].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[191] = {name = "SerialProxy", filter = "serial_proxy", command = "CMD_SERIAL_PROXY", id = 113, min = 0, max = 255, open = true, tail = 255}
  messages[191].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[192] = {name = "SerialProxyRequest", filter = "serial_proxy_request", command = "CMD_SERIAL_PROXY", id = 113, to_board = true, min = 0, max = 255, open = true, tail = 255, does = {"unknown"}, answers = {{confirm = true, timeout = 0.5}}}
  messages[192].fields = {
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 255},
  }

  messages[193] = {name = "SetAdjVarsVal", filter = "set_adj_vars_val", command = "CMD_SET_ADJ_VARS_VAL", id = 31, min = 1, max = 201, open = true, keeps_tail = true, tail = 254}
  messages[193].fields = {
    {name = "num_vars", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "params", struct = "AdjVarValue34", dim = "counted", capacity = 50, counter = "num_vars"},
  }

  messages[194] = {name = "SetAdjVarsVal", filter = "set_adj_vars_val", command = "CMD_SET_ADJ_VARS_VAL", id = 31, to_board = true, min = 1, max = 201, open = true, keeps_tail = true, tail = 254, does = {"sets", "moves"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[194].fields = {
    {name = "num_vars", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "params", struct = "AdjVarValue34", dim = "counted", capacity = 50, counter = "num_vars"},
  }

  messages[195] = {name = "GetAdjVarsVal", filter = "get_adj_vars_val", command = "CMD_GET_ADJ_VARS_VAL", id = 64, to_board = true, min = 1, max = 41, tail = 254, does = {"reads"}, answers = {{messages = {"SetAdjVarsVal"}, certain = true, timeout = 0.5, repeated = {SetAdjVarsVal = {{field = "param_id", at = 1, size = 1}}}}}}
  messages[195].fields = {
    {name = "num_vars", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "param_id", type = "u8", enum = "VariableId", dim = "counted", capacity = 254, counter = "num_vars"},
  }

  messages[196] = {name = "ReadAdjVarsCfg", filter = "read_adj_vars_cfg", command = "CMD_READ_ADJ_VARS_CFG", id = 43, min = 128, max = 128, open = true, keeps_tail = true, tail = 127}
  messages[196].fields = {
    {name = "trigger_slots", struct = "TriggerSlot35", dim = "fixed", count = 10, fixed = 60},
    {name = "analog_slots", struct = "AnalogSlot36", dim = "fixed", count = 15, fixed = 60},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[197] = {name = "ReadAdjVarsCfgRequest", filter = "read_adj_vars_cfg_request", command = "CMD_READ_ADJ_VARS_CFG", id = 43, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ReadAdjVarsCfg"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[197].fields = {
  }

  messages[198] = {name = "WriteAdjVarsCfg", filter = "write_adj_vars_cfg", command = "CMD_WRITE_ADJ_VARS_CFG", id = 44, to_board = true, min = 128, max = 128, open = true, keeps_tail = true, tail = 127, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[198].fields = {
    {name = "trigger_slots", struct = "TriggerSlot35", dim = "fixed", count = 10, fixed = 60},
    {name = "analog_slots", struct = "AnalogSlot36", dim = "fixed", count = 15, fixed = 60},
    {name = "reserved", blob = "bytes", size = 8, count = 1, fixed = 8, reserved = true},
  }

  messages[199] = {name = "AdjVarsState", filter = "adj_vars_state", command = "CMD_ADJ_VARS_STATE", id = 46, min = 15, max = 15, open = true, keeps_tail = true, tail = 240}
  messages[199].fields = {
    {name = "trigger_rc_data", type = "i16", scale = 0.002, count = 1, fixed = 2, min = -500, max = 500},
    {name = "trigger_action", type = "u8", enum = "MenuCommand", count = 1, fixed = 1, min = 0, max = 255},
    {name = "analog_rc_data", type = "i16", scale = 0.002, count = 1, fixed = 2, min = -500, max = 500},
    {name = "analog_value", type = "i32", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 6, count = 1, fixed = 6, reserved = true},
  }

  messages[200] = {name = "AdjVarsStateExt", filter = "adj_vars_state_ext", command = "CMD_ADJ_VARS_STATE", id = 46, min = 15, max = 15, open = true, asked = true, keeps_tail = true, tail = 240}
  messages[200].fields = {
    {name = "trigger_rc_data", type = "i16", scale = 6.103515625e-05, count = 1, fixed = 2, min = -16384, max = 16384},
    {name = "trigger_action", type = "u8", enum = "MenuCommand", count = 1, fixed = 1, min = 0, max = 255},
    {name = "analog_src_value", type = "i16", scale = 6.103515625e-05, count = 1, fixed = 2, min = -16384, max = 16384},
    {name = "analog_var_value", type = "f32", count = 1, fixed = 4},
    {name = "lut_src_value", type = "i16", scale = 6.103515625e-05, count = 1, fixed = 2, min = -16384, max = 16384},
    {name = "lut_var_value", type = "f32", count = 1, fixed = 4},
  }

  messages[201] = {name = "AdjVarsStateRequest", filter = "adj_vars_state_request", command = "CMD_ADJ_VARS_STATE", id = 46, to_board = true, min = 2, max = 2, tail = 253, does = {"reads"}, answers = {{messages = {"AdjVarsState"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[201].fields = {
    {name = "trigger_slot", type = "u8", count = 1, fixed = 1},
    {name = "analog_slot", type = "u8", count = 1, fixed = 1},
  }

  messages[202] = {name = "AdjVarsStateRequestExt", filter = "adj_vars_state_request_ext", command = "CMD_ADJ_VARS_STATE", id = 46, to_board = true, min = 7, max = 7, open = true, takes_surplus = true, tail = 248, does = {"reads"}, answers = {{messages = {"AdjVarsStateExt"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[202].fields = {
    {name = "trigger_slot", type = "u8", count = 1, fixed = 1, min = 0, max = 9},
    {name = "analog_src_id", type = "u16", count = 1, fixed = 2},
    {name = "analog_var_id", type = "u8", enum = "VariableId", count = 1, fixed = 1},
    {name = "lut_src_id", type = "u16", count = 1, fixed = 2},
    {name = "lut_var_id", type = "u8", enum = "VariableId", count = 1, fixed = 1},
  }

  messages[203] = {name = "AdjVarsInfo", filter = "adj_vars_info", command = "CMD_ADJ_VARS_INFO", id = 132, min = 1, max = 255, open = true, tail = 254}
  messages[203].fields = {
    {name = "total_number", type = "u8", count = 1, fixed = 1},
    {name = "vars", struct = "AdjVarInfo37", dim = "rest", capacity = 25},
  }

  messages[204] = {name = "AdjVarsInfoRequest", filter = "adj_vars_info_request", command = "CMD_ADJ_VARS_INFO", id = 132, to_board = true, min = 1, max = 1, open = true, takes_surplus = true, tail = 254, does = {"reads"}, answers = {{messages = {"AdjVarsInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[204].fields = {
    {name = "start_id", type = "u8", enum = "VariableId", count = 1, fixed = 1},
  }

  messages[205] = {name = "AdjVarsInfoRequestAll", filter = "adj_vars_info_request_all", command = "CMD_ADJ_VARS_INFO", id = 132, to_board = true, min = 0, max = 0, tail = 255, does = {"reads"}, answers = {{messages = {"AdjVarsInfo"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[205].fields = {
  }

  messages[206] = {name = "SetAdjVarsValF", filter = "set_adj_vars_val_f", command = "CMD_SET_ADJ_VARS_VAL_F", id = 134, min = 1, max = 201, open = true, keeps_tail = true, tail = 254}
  messages[206].fields = {
    {name = "num_params", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "params", struct = "AdjVarFloat38", dim = "counted", capacity = 50, counter = "num_params"},
  }

  messages[207] = {name = "SetAdjVarsValF", filter = "set_adj_vars_val_f", command = "CMD_SET_ADJ_VARS_VAL_F", id = 134, to_board = true, min = 1, max = 201, open = true, keeps_tail = true, tail = 254, does = {"sets", "moves"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[207].fields = {
    {name = "num_params", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "params", struct = "AdjVarFloat38", dim = "counted", capacity = 50, counter = "num_params"},
  }

  messages[208] = {name = "GetAdjVarsValF", filter = "get_adj_vars_val_f", command = "CMD_GET_ADJ_VARS_VAL_F", id = 135, to_board = true, min = 1, max = 41, tail = 254, does = {"reads"}, answers = {{messages = {"SetAdjVarsValF"}, certain = true, timeout = 0.5, repeated = {SetAdjVarsValF = {{field = "id", at = 1, size = 1}}}}}}
  messages[208].fields = {
    {name = "num_params", type = "u8", count = 1, fixed = 1, min = 1, max = 40},
    {name = "id", type = "u8", enum = "VariableId", dim = "counted", capacity = 254, counter = "num_params"},
  }

  messages[209] = {name = "EepromWrite", filter = "eeprom_write", command = "CMD_EEPROM_WRITE", id = 47, to_board = true, min = 4, max = 196, open = true, tail = 251, does = {"stores", "moves"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[209].fields = {
    {name = "addr", type = "u32", count = 1, fixed = 4},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 251},
  }

  messages[210] = {name = "ReadFile", filter = "read_file", command = "CMD_READ_FILE", id = 53, min = 4, max = 255, open = true, tail = 251}
  messages[210].fields = {
    {name = "file_size", type = "u16", unit = "byte", count = 1, fixed = 2},
    {name = "page_offset", type = "u16", unit = "byte", scale = 64, count = 1, fixed = 2},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 251},
  }

  messages[211] = {name = "ReadFileError", filter = "read_file_error", command = "CMD_READ_FILE", id = 53, min = 1, max = 1, tail = 254}
  messages[211].fields = {
    {name = "err_code", type = "u8", enum = "FileError", count = 1, fixed = 1},
  }

  messages[212] = {name = "ReadFileRequest", filter = "read_file_request", command = "CMD_READ_FILE", id = 53, to_board = true, min = 20, max = 20, open = true, takes_surplus = true, tail = 235, does = {"reads"}, answers = {{messages = {"ReadFile", "ReadFileError"}, certain = true, timeout = 0.5, repeated = {ReadFile = {{field = "page_offset", at = 2, size = 2}}}}}}
  messages[212].fields = {
    {name = "file_id", type = "u16", count = 1, fixed = 2},
    {name = "page_offset", type = "u16", unit = "byte", scale = 64, count = 1, fixed = 2},
    {name = "max_data_size", type = "u16", unit = "byte", count = 1, fixed = 2, min = 0, max = 251},
    {name = "reserved", blob = "bytes", size = 14, count = 1, fixed = 14, reserved = true},
  }

  messages[213] = {name = "WriteFile", filter = "write_file", command = "CMD_WRITE_FILE", id = 54, to_board = true, min = 6, max = 255, open = true, tail = 249, does = {"stores", "erases"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[213].fields = {
    {name = "file_id", type = "u16", count = 1, fixed = 2},
    {name = "file_size", type = "u16", unit = "byte", count = 1, fixed = 2},
    {name = "page_offset", type = "u16", unit = "byte", scale = 64, count = 1, fixed = 2},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 249},
  }

  messages[214] = {name = "FsClearAll", filter = "fs_clear_all", command = "CMD_FS_CLEAR_ALL", id = 55, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"erases"}, answers = {{confirm = true, certain = true, timeout = 2}}}
  messages[214].fields = {
  }

  messages[215] = {name = "EepromRead", filter = "eeprom_read", command = "CMD_EEPROM_READ", id = 48, min = 4, max = 196, open = true, tail = 251}
  messages[215].fields = {
    {name = "addr", type = "u32", count = 1, fixed = 4},
    {name = "data", blob = "bytes", dim = "rest", count = 1, capacity = 251},
  }

  messages[216] = {name = "EepromReadRequest", filter = "eeprom_read_request", command = "CMD_EEPROM_READ", id = 48, to_board = true, min = 6, max = 6, open = true, takes_surplus = true, tail = 249, does = {"reads"}, answers = {{messages = {"EepromRead"}, certain = true, timeout = 0.5, repeated = {EepromRead = {{field = "addr", at = 0, size = 4}}}}}}
  messages[216].fields = {
    {name = "addr", type = "u32", count = 1, fixed = 4},
    {name = "size", type = "u16", unit = "byte", count = 1, fixed = 2, min = 0, max = 192},
  }

  messages[217] = {name = "ReadExternalData", filter = "read_external_data", command = "CMD_READ_EXTERNAL_DATA", id = 42, min = 128, max = 128, open = true, keeps_tail = true, tail = 127}
  messages[217].fields = {
    {name = "data", blob = "bytes", size = 128, count = 1, fixed = 128},
  }

  messages[218] = {name = "ReadExternalDataRequest", filter = "read_external_data_request", command = "CMD_READ_EXTERNAL_DATA", id = 42, to_board = true, min = 0, max = 0, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"ReadExternalData"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[218].fields = {
  }

  messages[219] = {name = "WriteExternalData", filter = "write_external_data", command = "CMD_WRITE_EXTERNAL_DATA", id = 41, to_board = true, min = 128, max = 128, open = true, keeps_tail = true, tail = 127, does = {"stores"}, answers = {{confirm = true, timeout = 2}}}
  messages[219].fields = {
    {name = "data", blob = "bytes", size = 128, count = 1, fixed = 128},
  }

  messages[220] = {name = "RunScript", filter = "run_script", command = "CMD_RUN_SCRIPT", id = 57, to_board = true, min = 34, max = 34, open = true, takes_surplus = true, tail = 221, does = {"sets", "stores", "moves", "restarts"}, answers = {{when = {steps = {"mode"}, numbers = {[0] = true}}, confirm = true, timeout = 0.5}, {confirm = true, timeout = 0.5}}}
  messages[220].fields = {
    {name = "mode", type = "u8", enum = "ScriptMode", count = 1, fixed = 1},
    {name = "slot", type = "u8", count = 1, fixed = 1},
    {name = "reserved", blob = "bytes", size = 32, count = 1, fixed = 32, reserved = true},
  }

  messages[221] = {name = "ScriptDebug", filter = "script_debug", command = "CMD_SCRIPT_DEBUG", id = 58, min = 3, max = 3, open = true, keeps_tail = true, tail = 252}
  messages[221].fields = {
    {name = "cmd_count", type = "u16", count = 1, fixed = 2},
    {name = "err_code", type = "u8", enum = "FileError", count = 1, fixed = 1},
  }

  messages[222] = {name = "DebugVarsInfo3", filter = "debug_vars_info3", command = "CMD_DEBUG_VARS_INFO_3", id = 253, min = 1, max = 255, open = true, keeps_tail = true, tail = 254}
  messages[222].fields = {
    {name = "debug_vars_num", type = "u8", count = 1, fixed = 1, min = 1, max = 255},
    {name = "vars", struct = "DebugVarInfo39", dim = "counted", capacity = 63, counter = "debug_vars_num"},
  }

  messages[223] = {name = "DebugVarsInfo3Request", filter = "debug_vars_info3request", command = "CMD_DEBUG_VARS_INFO_3", id = 253, to_board = true, min = 0, max = 1, open = true, takes_surplus = true, tail = 255, does = {"reads"}, answers = {{messages = {"DebugVarsInfo3"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[223].fields = {
    {name = "start_idx", type = "u8", count = 1, fixed = 1, appended = true},
  }

  messages[224] = {name = "DebugVars3", filter = "debug_vars3", command = "CMD_DEBUG_VARS_3", id = 254, min = 0, max = 255, open = true, keeps_tail = true, tail = 255}
  messages[224].fields = {
    {name = "var_value", announced = "types", dim = "rest", capacity = 255},
  }

  messages[225] = {name = "DebugVars3Request", filter = "debug_vars3request", command = "CMD_DEBUG_VARS_3", id = 254, to_board = true, min = 0, max = 0, tail = 255, does = {"reads"}, answers = {{messages = {"DebugVars3"}, certain = true, timeout = 0.5, repeated = {}}}}
  messages[225].fields = {
  }

  messages[226] = {name = "DebugVars3RequestSelected", filter = "debug_vars3request_selected", command = "CMD_DEBUG_VARS_3", id = 254, to_board = true, min = 4, max = 32, open = true, tail = 251, does = {"reads"}, answers = {{timeout = 0.5}}}
  messages[226].fields = {
    {name = "selected_mask", type = "u32", dim = "rest", capacity = 63, min_count = 1},
  }

  messages[227] = {name = "SetDebugPort", filter = "set_debug_port", command = "CMD_SET_DEBUG_PORT", id = 249, min = 4, max = 255, open = true, tail = 251}
  messages[227].fields = {
    {name = "time_ms", type = "u16", unit = "ms", count = 1, fixed = 2},
    {name = "port_and_dir", type = "u8", packed = "DebugPortLine", count = 1, fixed = 1},
    {name = "cmd_id", type = "u8", count = 1, fixed = 1},
    {name = "payload", blob = "bytes", dim = "rest", count = 1, capacity = 251},
  }

  messages[228] = {name = "SetDebugPortRequest", filter = "set_debug_port_request", command = "CMD_SET_DEBUG_PORT", id = 249, to_board = true, min = 16, max = 16, open = true, takes_surplus = true, tail = 239, does = {"sets"}, answers = {{confirm = true, certain = true, timeout = 0.5}}}
  messages[228].fields = {
    {name = "action", type = "u8", enum = "DebugPortAction", count = 1, fixed = 1},
    {name = "cmd_filter", type = "u32", enum = "DebugPortCommands", count = 1, fixed = 4},
    {name = "reserved", blob = "bytes", size = 11, count = 1, fixed = 11, reserved = true},
  }

  return {
    name = "SimpleBGC Serial API",
    short = "SBGC",
    filter = "sbgc",
    prefix = "CMD_",
    commands = {
      { 86, "CMD_BOARD_INFO" },
      { 67, "CMD_CONFIRM" },
      { 255, "CMD_ERROR" },
      { 20, "CMD_BOARD_INFO_3" },
      { 114, "CMD_RESET" },
      { 51, "CMD_BOOT_MODE_3" },
      { 111, "CMD_READ_STATE_VARS" },
      { 112, "CMD_WRITE_STATE_VARS" },
      { 50, "CMD_SIGN_MESSAGE" },
      { 136, "CMD_PASS_PROTECT_READ" },
      { 137, "CMD_PASS_PROTECT_WRITE" },
      { 30, "CMD_QUEUE_PARAMS_INFO_3" },
      { 52, "CMD_SYSTEM_STATE" },
      { 250, "CMD_MAVLINK_INFO" },
      { 251, "CMD_MAVLINK_DEBUG" },
      { 124, "CMD_EXT_LICENSE_INFO" },
      { 21, "CMD_READ_PARAMS_3" },
      { 22, "CMD_WRITE_PARAMS_3" },
      { 82, "CMD_READ_PARAMS" },
      { 87, "CMD_WRITE_PARAMS" },
      { 33, "CMD_READ_PARAMS_EXT" },
      { 34, "CMD_WRITE_PARAMS_EXT" },
      { 62, "CMD_READ_PARAMS_EXT2" },
      { 63, "CMD_WRITE_PARAMS_EXT2" },
      { 119, "CMD_WRITE_PARAMS_SET" },
      { 28, "CMD_READ_PROFILE_NAMES" },
      { 29, "CMD_WRITE_PROFILE_NAMES" },
      { 95, "CMD_PROFILE_SET" },
      { 32, "CMD_SAVE_PARAMS_3" },
      { 70, "CMD_USE_DEFAULTS" },
      { 104, "CMD_READ_PARAMS_EXT3" },
      { 105, "CMD_WRITE_PARAMS_EXT3" },
      { 68, "CMD_REALTIME_DATA" },
      { 23, "CMD_REALTIME_DATA_3" },
      { 25, "CMD_REALTIME_DATA_4" },
      { 88, "CMD_REALTIME_DATA_CUSTOM" },
      { 139, "CMD_REALTIME_DATA_CUSTOM2" },
      { 85, "CMD_DATA_STREAM_INTERVAL" },
      { 127, "CMD_CAN_DRV_TELEMETRY" },
      { 98, "CMD_CAN_DRV_STATE" },
      { 101, "CMD_REALTIME_DATA_CAN_DRV" },
      { 67, "CMD_CONTROL" },
      { 121, "CMD_CONTROL_EXT" },
      { 90, "CMD_CONTROL_CONFIG" },
      { 140, "CMD_CONTROL_QUAT" },
      { 141, "CMD_CONTROL_QUAT_STATUS" },
      { 142, "CMD_CONTROL_QUAT_CONFIG" },
      { 73, "CMD_GET_ANGLES" },
      { 61, "CMD_GET_ANGLES_EXT" },
      { 77, "CMD_MOTORS_ON" },
      { 109, "CMD_MOTORS_OFF" },
      { 123, "CMD_SYNC_MOTORS" },
      { 102, "CMD_EVENT" },
      { 69, "CMD_EXECUTE_MENU" },
      { 72, "CMD_HELPER_DATA" },
      { 128, "CMD_EXT_MOTORS_ACTION" },
      { 129, "CMD_EXT_MOTORS_CONTROL" },
      { 130, "CMD_EXT_MOTORS_CONTROL_CONFIG" },
      { 131, "CMD_EXT_MOTORS_STATE" },
      { 65, "CMD_CALIB_ACC" },
      { 103, "CMD_CALIB_GYRO" },
      { 59, "CMD_CALIB_MAG" },
      { 71, "CMD_CALIB_EXT_GAIN" },
      { 80, "CMD_CALIB_POLES" },
      { 79, "CMD_CALIB_OFFSET" },
      { 66, "CMD_CALIB_BAT" },
      { 49, "CMD_CALIB_INFO" },
      { 74, "CMD_CALIB_MOTOR_MAG_LINK" },
      { 26, "CMD_ENCODERS_CALIB_OFFSET_4" },
      { 27, "CMD_ENCODERS_CALIB_FLD_OFFSET_4" },
      { 35, "CMD_AUTO_PID" },
      { 108, "CMD_AUTO_PID2" },
      { 91, "CMD_CALIB_ORIENT_CORR" },
      { 93, "CMD_CALIB_COGGING" },
      { 94, "CMD_CALIB_ACC_EXT_REF" },
      { 37, "CMD_BODE_TEST_START_STOP" },
      { 38, "CMD_BODE_TEST_DATA" },
      { 92, "CMD_COGGING_CALIB_INFO" },
      { 97, "CMD_CAN_DRV_HARD_PARAMS" },
      { 99, "CMD_CAN_DRV_CALIBRATE" },
      { 117, "CMD_CALIB_ENCODER_LUT" },
      { 118, "CMD_CALIB_ENCODER_LUT_RES" },
      { 120, "CMD_CALIB_CUR_SENS" },
      { 122, "CMD_ENC_INT_CALIB" },
      { 125, "CMD_VIBRATION_TEST_START_STOP" },
      { 126, "CMD_VIBRATION_TEST_DATA" },
      { 24, "CMD_SELECT_IMU_3" },
      { 56, "CMD_AHRS_HELPER" },
      { 75, "CMD_GYRO_CORRECTION" },
      { 106, "CMD_EXT_IMU_DEBUG_INFO" },
      { 110, "CMD_EXT_IMU_CMD" },
      { 150, "CMD_EXT_SENS_CMD" },
      { 115, "CMD_IMU_ADVANCED_CALIB" },
      { 89, "CMD_BEEP_SOUND" },
      { 84, "CMD_TRIGGER_PIN" },
      { 36, "CMD_SERVO_OUT" },
      { 133, "CMD_SERVO_OUT_EXT" },
      { 39, "CMD_I2C_WRITE_REG_BUF" },
      { 40, "CMD_I2C_READ_REG_BUF" },
      { 45, "CMD_API_VIRT_CH_CONTROL" },
      { 116, "CMD_API_VIRT_CH_HIGH_RES" },
      { 100, "CMD_READ_RC_INPUTS" },
      { 76, "CMD_MODULE_LIST" },
      { 96, "CMD_CAN_DEVICE_SCAN" },
      { 151, "CMD_TRANSPARENT_SAPI" },
      { 78, "CMD_MODULE_FLASH_START" },
      { 81, "CMD_MODULE_FLASH_WRITE" },
      { 83, "CMD_MODULE_FLASH_FINISH" },
      { 144, "CMD_UDRV_DEVICE_SCAN" },
      { 143, "CMD_SET_TRANSP_PROXY" },
      { 60, "CMD_UART_BYPASS" },
      { 107, "CMD_SET_DEVICE_ADDR" },
      { 113, "CMD_SERIAL_PROXY" },
      { 31, "CMD_SET_ADJ_VARS_VAL" },
      { 64, "CMD_GET_ADJ_VARS_VAL" },
      { 43, "CMD_READ_ADJ_VARS_CFG" },
      { 44, "CMD_WRITE_ADJ_VARS_CFG" },
      { 46, "CMD_ADJ_VARS_STATE" },
      { 132, "CMD_ADJ_VARS_INFO" },
      { 134, "CMD_SET_ADJ_VARS_VAL_F" },
      { 135, "CMD_GET_ADJ_VARS_VAL_F" },
      { 47, "CMD_EEPROM_WRITE" },
      { 53, "CMD_READ_FILE" },
      { 54, "CMD_WRITE_FILE" },
      { 55, "CMD_FS_CLEAR_ALL" },
      { 48, "CMD_EEPROM_READ" },
      { 42, "CMD_READ_EXTERNAL_DATA" },
      { 41, "CMD_WRITE_EXTERNAL_DATA" },
      { 57, "CMD_RUN_SCRIPT" },
      { 58, "CMD_SCRIPT_DEBUG" },
      { 253, "CMD_DEBUG_VARS_INFO_3" },
      { 254, "CMD_DEBUG_VARS_3" },
      { 249, "CMD_SET_DEBUG_PORT" },
    },
    framings = {
      {name = "v1", start = 62, header = 4, trailer = 1, most = 255, id = 1, size = 2, in_header = {{kind = "sum8", is_first = true, at = 3, bytes = 1, from = 1, to = 3}}, in_trailer = {{kind = "sum8", at = 0, bytes = 1, from = 4}}},
      {name = "v2", start = 36, header = 4, trailer = 2, most = 255, id = 1, size = 2, in_header = {{kind = "sum8", is_first = true, at = 3, bytes = 1, from = 1, to = 3}}, in_trailer = {{kind = "crc16", at = 0, bytes = 2, from = 1, width = 16, polynomial = 32773, initial = 0, reflect_in = true, final = 0}}},
    },
    learns = {
      {from = "AdjVarsStateRequest", ["for"] = 46, name = "asked", is = "AdjVarsState"},
      {from = "AdjVarsStateRequestExt", ["for"] = 46, name = "asked", is = "AdjVarsStateExt"},
      {from = "RealtimeDataCustomRequest", path = {"flags"}, ["for"] = "RealtimeDataCustom", name = "flags"},
      {from = "DataStreamInterval", path = {"config", "flags"}, ["for"] = "RealtimeDataCustom", name = "flags"},
      {from = "RealtimeDataCustom2Request", path = {"flags"}, ["for"] = "RealtimeDataCustom2", name = "flags"},
      {from = "DataStreamInterval", path = {"config", "custom2_flags"}, ["for"] = "RealtimeDataCustom2", name = "flags"},
      {from = "DataStreamInterval", path = {"config", "telemetry_flags"}, ["for"] = "CanDrvTelemetry", name = "flags"},
      {from = "DebugVarsInfo3", list = "vars", kind = {"var_type", "kind"}, count = "arr_size", types = {part = {most = 15, shift = 0, enum = "DebugVarKind"}, types = {[1] = "u8", [2] = "i8", [3] = "u16", [4] = "i16", [5] = "u32", [6] = "i32", [7] = "f32"}}, ["for"] = "DebugVars3", name = "types"},
    },
    enums = enums,
    packed = packed,
    structs = structs,
    messages = messages,
  }
end)()

local numbers = (function()
-- Numbers: on the wire, in packed values, and in their units.

local M = {}

-- The format for Struct, the size, the type of a field of Wireshark.
M.types = {
  u8 = {"<B", 1, ftypes.UINT8}, i8 = {"<b", 1, ftypes.INT8},
  u16 = {"<I2", 2, ftypes.UINT16}, i16 = {"<i2", 2, ftypes.INT16},
  u24 = {"<I3", 3, ftypes.UINT24}, i24 = {"<i3", 3, ftypes.INT24},
  u32 = {"<I4", 4, ftypes.UINT32}, i32 = {"<i4", 4, ftypes.INT32},
  u64 = {"<E", 8, ftypes.UINT64}, i64 = {"<e", 8, ftypes.INT64},
  f32 = {"<f", 4, ftypes.FLOAT}, f64 = {"<d", 8, ftypes.DOUBLE},
}

-- The number at a place, which counts from 0; 64 bits are an object.
function M.read(type, bytes, at)
  return (Struct.unpack(M.types[type][1], bytes, at + 1))
end

-- The bits of an integer of up to 32 bits as an unsigned number.
local function bits_of(value)
  return value % 4294967296
end

function M.has(value, mask)
  return bitwise.band(bits_of(value), mask) == mask
end

-- The bits of an integer of up to 64 bits from a place on, up to the number `most`.
local function bits_at(value, shift, most)
  if type(value) == "number" then return bitwise.band(bitwise.rshift(bits_of(value), shift), most) end
  return value:rshift(shift):band(UInt64(most)):tonumber()
end

-- The value of a part of a packed value.
function M.part(part, value)
  local most = part.most
  local number = math.floor(bits_at(value, part.shift, most) / (part.divide or 1))
  if part.signed and number > (most - 1) / 2 then return number - most - 1 end
  if part.sign and bits_at(value, part.sign, 1) == 1 then return 0 - number end
  return part.modulo and number % part.modulo or number
end

-- The value of a raw number in the unit of a quantity.
function M.real(quantity, raw)
  local value = raw
  if quantity.ratio then value = quantity.ratio ^ (raw / quantity.over) end
  return value * (quantity.scale or 1) + (quantity.add or 0)
end

-- A raw value in decimals. Lua 5.3 and later would print whole floats with ".0".
function M.text(value)
  return type(value) == "number" and string.format("%.14g", value) or tostring(value)
end

-- True if the values in the unit are the raw numbers.
function M.is_plain(quantity)
  return not (quantity.scale or quantity.add or quantity.ratio)
end

return M
end)()

local frames = (function()
-- Finds frames in bytes: a candidate that fails a check does not swallow a frame behind it.

local M = {}
local byte, find = string.byte, string.find

local function sum(bytes, from, to)
  local total = 0
  while from + 15 <= to do -- several at once, because a call takes longer than an addition
    local a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p = byte(bytes, from, from + 15)
    total = total + a + b + c + d + e + f + g + h + i + j + k + l + m + n + o + p
    from = from + 16
  end
  if from + 7 <= to then
    local a, b, c, d, e, f, g, h = byte(bytes, from, from + 7)
    total = total + a + b + c + d + e + f + g + h
    from = from + 8
  end
  for at = from, to do total = total + byte(bytes, at) end
  return total
end

local function reversed(value, width)
  local result = 0
  for _ = 1, width do
    result = result * 2 + value % 2
    value = math.floor(value / 2)
  end
  return result
end

-- The exclusive or of two bytes, a table, because its calls take ten times as long.
local either = {}
local function fill_either()
  if either[0] then return end
  for a = 0, 255 do
    for b = 0, 255 do either[a * 256 + b] = bitwise.bxor(a, b) end
  end
end

-- A function for a cyclic redundancy check. The register is a list of bytes, the first one on top.
local function crc(check)
  fill_either()
  local size, steps, entering = check.bytes, {}, {}
  for place = 1, size do steps[place] = {} end
  for value = 0, 255 do
    local register = bitwise.lshift(value, 8 * (size - 1))
    for _ = 1, 8 do
      local out = register >= 2 ^ (check.width - 1)
      register = register * 2 % 2 ^ check.width
      if out then register = bitwise.bxor(register, check.polynomial) end
    end
    for place = size, 1, -1 do
      steps[place][value] = math.floor(register % 256)
      register = math.floor(register / 256)
    end
    entering[value] = check.reflect_in and reversed(value, 8) or value
  end
  local function finish(register)
    if check.reflect_out then register = reversed(register, check.width) end
    return bitwise.bxor(register, check.final or 0)
  end
  if size == 2 then -- without a loop over the bytes of the register
    local first, second = steps[1], steps[2]
    return function(bytes, from, to)
      local high, low = math.floor((check.initial or 0) / 256), (check.initial or 0) % 256
      for at = from, to do
        local step = either[high * 256 + entering[byte(bytes, at)]]
        high, low = either[low * 256 + first[step]], second[step]
      end
      return finish(high * 256 + low)
    end
  end
  return function(bytes, from, to)
    local register = {}
    for place = 1, size do
      register[place] = math.floor((check.initial or 0) / 256 ^ (size - place)) % 256
    end
    register[size + 1] = 0
    for at = from, to do
      local step = either[register[1] * 256 + entering[byte(bytes, at)]]
      for place = 1, size do
        register[place] = either[register[place + 1] * 256 + steps[place][step]]
      end
    end
    local value = 0
    for place = 1, size do value = value * 256 + register[place] end
    return finish(value)
  end
end

local KINDS = {
  sum8 = function() return function(bytes, from, to) return sum(bytes, from, to) % 256 end end,
  sum16 = function() return function(bytes, from, to) return sum(bytes, from, to) % 65536 end end,
  xor8 = function()
    fill_either()
    return function(bytes, from, to)
      local value = 0
      for at = from, to do value = either[value * 256 + byte(bytes, at)] end
      return value
    end
  end,
  crc8 = crc, crc16 = crc, crc32 = crc,
}

local framings, starts = {}, ""
for _, framing in ipairs(protocol.framings) do
  framings[framing.start] = framing
  starts = starts .. string.char(framing.start)
  framing.in_header, framing.in_trailer = framing.in_header or {}, framing.in_trailer or {}
  for _, list in ipairs({framing.in_header, framing.in_trailer}) do
    for _, check in ipairs(list) do
      check.value, check.from = KINDS[check.kind](check), check.from or 0
    end
  end
end
local pattern = "[" .. starts:gsub("%p", "%%%0") .. "]" -- no letters: %a would be a class

local function stored(bytes, at, size)
  if size == 1 then return byte(bytes, at) end
  local value = 0
  for place = size - 1, 0, -1 do value = value * 256 + byte(bytes, at + place) end
  return value
end

-- Judges the candidate at the place `at`, which counts from 1, of bytes that end at `stop`. Returns
-- its size; or nil and the reason; "incomplete" if it may be a frame with the bytes that follow.
local function judge(framing, bytes, at, stop)
  if at + framing.header - 1 > stop then return nil, "incomplete" end
  if byte(bytes, at + framing.id) == 0 then return nil, "id 0" end
  local size = byte(bytes, at + framing.size)
  if size > framing.most then return nil, "too large" end
  for _, check in ipairs(framing.in_header) do
    if check.value(bytes, at + check.from, at + check.to - 1)
       ~= stored(bytes, at + check.at, check.bytes) then
      return nil, "bad header checksum"
    end
  end
  local trailer = at + framing.header + size
  if trailer + framing.trailer - 1 > stop then return nil, "incomplete" end
  for _, check in ipairs(framing.in_trailer) do
    if check.value(bytes, at + check.from, trailer - 1)
       ~= stored(bytes, trailer + check.at, check.bytes) then
      return nil, "bad body checksum"
    end
  end
  return framing.header + size + framing.trailer
end

-- Finds the frames in bytes. Returns them, the rejected candidates behind a whole header, and the
-- place from which on bytes may be the beginning of a frame, unless they are the `last` ones.
-- Places count from 0.
function M.scan(bytes, last)
  local found, rejected, at, stop = {}, {}, 1, #bytes
  while true do
    at = find(bytes, pattern, at)
    if not at then return found, rejected, stop end
    local framing = framings[byte(bytes, at)]
    local size, reason = judge(framing, bytes, at, stop)
    if size then
      found[#found + 1] = {
        at = at - 1, size = size, framing = framing, id = byte(bytes, at + framing.id),
        body = at - 1 + framing.header, body_size = size - framing.header - framing.trailer,
      }
      at = at + size
    elseif reason == "incomplete" and not last then
      return found, rejected, at - 1
    else
      if reason == "bad body checksum" or reason == "incomplete" then
        rejected[#rejected + 1] = {at = at - 1, reason = reason}
      end
      at = at + 1
    end
  end
end

return M
end)()

local nodes = (function(numbers)
-- The fields of messages with their display filters: every message as a tree of nodes.

local M = {proto = Proto(protocol.filter, protocol.name), all = {}}
local AXES = "axes" -- the name of a group of axes that has no other; filters omit it

-- The fields that Wireshark shows, by their display filters; messages may share one.
local fields, list = {}, {}
local of_message = {} -- those of the message that is being expanded
local function register(filter, make)
  filter = protocol.filter .. "." .. filter
  if not fields[filter] then
    fields[filter] = make(filter)
    list[#list + 1] = fields[filter]
  end
  of_message[#of_message + 1] = fields[filter]
  return fields[filter]
end
M.register = register

local function names_of(enum)
  if not enum or enum.is_flags then return nil end
  local names = {}
  for _, value in ipairs(enum.values or {}) do names[value[1]] = value[2] end
  return names
end
for _, enum in pairs(protocol.enums) do enum.names = names_of(enum) or {} end

-- The fields of single flags.
local function flags_of(enum, path, bits, shift)
  if not enum or not enum.is_flags then return nil end
  local flags = {}
  for _, value in ipairs(enum.values or {}) do
    local mask = value[1] * 2 ^ shift
    flags[#flags + 1] = mask ~= 0 and register(path .. "." .. value[3], function(filter)
      return ProtoField.bool(filter, value[2], bits, nil, mask)
    end) or nil
  end
  return flags
end

local function parts_of(packed, path, bits)
  if not packed then return nil end
  local parts = {}
  for _, part in ipairs(packed.parts) do
    local here = path .. "." .. part.name
    local enum = protocol.enums[part.enum]
    local is_real = part.scale or part.add
    local has_mask = part.is_bool and part.shift < 32 -- as many as the masks of Lua have
    parts[#parts + 1] = {
      part = part,
      has_mask = has_mask,
      flags = flags_of(enum, here, bits, part.shift),
      field = register(here, function(filter)
        if has_mask then return ProtoField.bool(filter, part.name, bits, nil, 2 ^ part.shift) end
        if is_real then return ProtoField.double(filter, part.name) end
        return ProtoField.int32(filter, part.name, base.DEC, names_of(enum))
      end),
    }
  end
  return parts
end

-- A value: its field, the field of its raw number if that differs, and those of its flags and parts.
local function leaf(field, path, axis)
  local made = {field = field, name = field.name, path = path, way = (field.ways or {})[axis or field.axis]}
  if field.blob then
    made.shown = register(path, function(filter)
      if field.blob == "bytes" then return ProtoField.bytes(filter, field.name) end
      return ProtoField.string(filter, field.name)
    end)
    return made
  end
  if field.announced then
    made.shown = register(path, function(filter) return ProtoField.double(filter, field.name) end)
    return made
  end
  local type = numbers.types[field.type]
  local is_real = field.alternative or not numbers.is_plain(field)
  for _, later in ipairs(field.later or {}) do is_real = is_real or not numbers.is_plain(later) end
  local enum, packed = protocol.enums[field.enum], protocol.packed[field.packed]
  local bits = 8 * type[2]
  local shows_bits = (packed or enum and enum.is_flags) and field.type:sub(1, 1) == "u"
  local function number(filter, label)
    local names = names_of(enum or packed and protocol.enums[packed.names])
    if field.type:sub(1, 1) == "f" then return ProtoField.new(label or field.name, filter, type[3]) end
    return ProtoField.new(label or field.name, filter, type[3], names, shows_bits and base.HEX or base.DEC)
  end
  made.size = type[2]
  if is_real then
    made.shown = register(path, function(filter) return ProtoField.double(filter, field.name) end)
    made.raw = register(path .. ".raw", function(filter) return number(filter, "raw value") end)
  else
    made.shown = register(path, number)
  end
  made.enum, made.packed = enum, packed
  made.flags = flags_of(enum, path, bits, 0)
  made.parts = parts_of(packed, path, bits)
  return made
end


-- The condition for an element of an index.
local function condition_of(when, element)
  if not when then return nil end
  if when.terms then
    local terms = {}
    for i, term in ipairs(when.terms) do terms[i] = condition_of(term, element) end
    return {joined = when.joined, terms = terms, missing = when.missing}
  end
  return (when.elements or {})[element] or when
end

local function expand(inner, path, element)
  local made = {}
  for i, field in ipairs(inner or {}) do
    local here = field.struct and field.name == AXES and path or path .. "." .. field.name
    local by_word = (field.dim == "axis" or field.dim == "xyz") and field.index
    local node = {field = field, name = field.name, when = condition_of(field.when, element), words = by_word}
    if field.used_when then
      node.used = {}
      for _, word in ipairs(by_word or {""}) do node.used[word] = condition_of(field.used_when, word) end
    end
    if field.struct then
      node.struct, node.kids = protocol.structs[field.struct], {}
      for _, word in ipairs(by_word or {""}) do
        node.kids[word] = expand(node.struct.fields, word == "" and here or here .. "." .. word, word)
      end
    elseif by_word then
      node.leaves = {}
      for _, word in ipairs(by_word) do node.leaves[word] = leaf(field, here .. "." .. word, word) end
    else
      node.leaf = leaf(field, here, element)
    end
    made[i] = node
  end
  return made
end

-- The messages by direction and id, in the order of the spec; and by name and direction.
M.forms = {[true] = {}, [false] = {}}
M.by_name = {}
M.commands = {}
for _, command in ipairs(protocol.commands) do M.commands[command[1]] = command[2] end
for _, message in ipairs(protocol.messages) do
  of_message = {}
  message.nodes = expand(message.fields, message.filter, nil)
  message.tail_field = register(message.filter .. ".tail", function(filter)
    return ProtoField.bytes(filter, "tail")
  end)
  message.shown = of_message
  message.to_board = message.to_board or false
  local forms = M.forms[message.to_board]
  forms[message.id] = forms[message.id] or {}
  table.insert(forms[message.id], message)
  M.by_name[message.name .. (message.to_board and ">" or "<")] = message
  M.commands[message.id] = M.commands[message.id] or message.command
end

-- The message of a body, or nil and the reason; of several of one size, the one that was asked for.
function M.choose(to_board, id, size, asked)
  local forms = M.forms[to_board][id]
  if not forms then return nil, "unknown command" end
  if #forms == 1 then return forms[1] end
  local found
  for _, form in ipairs(forms) do
    if (form.min or 0) <= size and (form.open or size <= (form.max or 0)) then
      if form.name == asked then return form end
      if not form.asked then found = found or form end
    end
  end
  if found then return found end
  return nil, "no form of the command has " .. size .. " bytes"
end

-- To be called when all fields have been made.
function M.finish()
  M.proto.fields = list
end

return M
end)(numbers)

local bodies = (function(numbers)
-- Decodes bodies. The result is a list of items, each with its place in the body: values, which have a
-- leaf, and groups, which have a list of items.

local M = {}
local byte = string.byte

local function fail(reader, code, field)
  error({code = code, field = field, at = reader.at}, 0)
end

local function left(reader) return reader.stop - reader.at end

local function need(reader, size, field)
  if left(reader) < size then fail(reader, "too short", field) end
end

local function add(reader, leaf, size, value, label)
  local item = {leaf = leaf, at = reader.at, size = size, value = value, label = label, unused = reader.unused}
  reader.items[#reader.items + 1] = item
  reader.at = reader.at + size
  return item
end

-- Reads into a group of its own, whose size may be fixed.
local function group(reader, label, size, read)
  if size then need(reader, size, label) end
  local items, stop, at = reader.items, reader.stop, reader.at
  local item = {label = label, at = at, items = {}}
  items[#items + 1] = item
  reader.items = item.items
  if size then reader.stop = at + size end
  local value = read()
  reader.items, reader.stop = items, stop
  item.size = reader.at - at
  return value
end

-- The value at a path in the fields of a level; nil if it is missing.
local function value_at(values, steps)
  local found = values
  for _, step in ipairs(steps) do
    if type(found) ~= "table" then return nil end
    found = found[step]
  end
  return found
end

local function accepts(when, value)
  if type(value) ~= "number" then return false end
  if when.part then value = numbers.part(when.part, value) end
  if when.all and not numbers.has(value, when.all) then return false end
  if when.any then
    local has = false
    for _, flag in ipairs(when.any) do has = has or numbers.has(value, flag) end
    if not has then return false end
  end
  for _, flag in ipairs(when.none or {}) do
    if numbers.has(value, flag) then return false end
  end
  if when.numbers and (when.numbers[value] or false) == (when.negated or false) then return false end
  return (not when.at_least or value >= when.at_least) and (not when.at_most or value <= when.at_most)
end

-- True if a condition holds for the fields of a level.
local function holds(when, level, context)
  if when.terms then
    for _, term in ipairs(when.terms) do
      if holds(term, level, context) ~= (when.joined == "all") then return when.joined ~= "all" end
    end
    return when.joined == "all"
  end
  if when.context then return accepts(when, context[when.context] or 0) end
  local values = when.outside and level.outer and level.outer.values or level.values
  return accepts(when, value_at(values, when.steps))
end
M.holds = function(when, values) return holds(when, {values = values}, {}) end

local function is_present(node, reader, level)
  local field, when = node.field, node.when
  if field.fits_rest then
    local size = left(reader) - 1
    if size < 1 or size > field.size or byte(reader.bytes, reader.at + 1) ~= size then return false end
    return not reader.bytes:find("[\0-\31]", reader.at + 2)
  end
  if field.fits then return reader.context[""] end
  if field.appended and left(reader) == 0 then return false end
  if not when then return true end
  if when.missing and left(reader) < (field.fixed or 0) then return false end
  return holds(when, level, reader.context)
end

-- What the number of a field means: its quantity, as a flag or the firmware chooses.
local function meaning(field, level, reader)
  local other = field.alternative
  if other then
    local values = other.in_group and level.values or reader.top.values
    local flags = values[other.field]
    if type(flags) == "table" then flags = flags[level.word] end -- one for each axis
    if type(flags) == "number" and numbers.has(flags, other.mask) then return other end
  end
  local result = field
  for _, later in ipairs(field.later or {}) do
    if (reader.context.firmware or 0) >= later.firmware then result = later end
  end
  return result
end

local function read_leaf(leaf, reader, level, label)
  local field = leaf.field
  if field.blob == "string" then
    need(reader, 1, field.name)
    local size = byte(reader.bytes, reader.at + 1)
    if left(reader) < size + 1 then fail(reader, "too short", field.name) end
    if size > field.size then fail(reader, "text too long", field.name) end
    local text = reader.bytes:sub(reader.at + 2, reader.at + 1 + size)
    add(reader, leaf, size + 1, text, label)
    return text
  end
  if field.blob then
    need(reader, field.size, field.name)
    local text = reader.bytes:sub(reader.at + 1, reader.at + field.size)
    if field.blob == "text" then text = text:gsub("\0*$", "") end
    add(reader, leaf, field.size, text, label)
    return text
  end
  need(reader, leaf.size, field.name)
  local value = numbers.read(field.type, reader.bytes, reader.at)
  add(reader, leaf, leaf.size, value, label).meaning = meaning(field, level, reader)
  return value
end

local read_fields

-- `size` is that of an element of a list that grew.
local function read_element(node, kids, label, reader, level, size)
  if not node.struct then return read_leaf(node.leaf, reader, level, label) end
  local struct = node.struct
  local inner = {values = {}, outer = level, word = label}
  local asked = struct.is_region and level or inner
  return group(reader, label, size or struct.size, function()
    read_fields(kids, reader, inner, asked)
    return inner.values
  end)
end

local function size_of(node)
  if node.struct then return node.struct.size end
  return node.field.blob and (node.field.blob == "bytes" and (node.field.size or 1) or
                              node.field.blob == "text" and node.field.size or nil) or node.leaf.size
end

-- The number of elements; nil if they end by themselves.
local function count_of(node, reader, level)
  local field, size = node.field, size_of(node)
  if field.dim == "fixed" then return field.count end
  if field.dim == "counted" then
    local count = level.values[field.counter]
    if field.counter_part then count = numbers.part(field.counter_part, count) end
    if field.counting == "bytes" then
      if count % size ~= 0 then fail(reader, "count mismatch", field.name) end
      count = math.floor(count / size)
    elseif field.counting == "bits" then
      local set, rest = 0, count % 4294967296
      while rest > 0 do set, rest = set + rest % 2, math.floor(rest / 2) end
      count = set
    elseif field.counting == "minus_1" then
      count = count + 1
    end
    if count > field.capacity then fail(reader, "too short", field.name) end
    return count
  end
  if not size and not field.element_sizes then return nil end
  for _, known in ipairs(field.element_sizes or {}) do
    if not size and left(reader) % known == 0 then size = known end
  end
  size = size or field.element_sizes[1]
  local count = math.floor(left(reader) / size)
  if left(reader) % size ~= 0 or count < (field.min_count or 0) then fail(reader, "too short", field.name) end
  if count > field.capacity then fail(reader, "too long", field.name) end
  return count
end

local function read_announced(node, reader)
  for i, type in ipairs(reader.context[node.field.announced] or {}) do
    local size = numbers.types[type][2]
    if left(reader) < size then break end
    add(reader, node.leaf, size, numbers.read(type, reader.bytes, reader.at),
        node.name .. "[" .. i - 1 .. "] (" .. type .. ")")
  end
end

local function read_list(node, reader, level)
  local field, count = node.field, count_of(node, reader, level)
  if field.blob == "bytes" and not field.size then
    need(reader, count, field.name)
    local text = reader.bytes:sub(reader.at + 1, reader.at + count)
    add(reader, node.leaf, count, text)
    return text
  end
  local values = {}
  if count and not node.struct then need(reader, count * (size_of(node) or 0), field.name) end
  local size
  if field.element_sizes and count > 0 then
    local is_known = false
    size = math.floor(left(reader) / count)
    for _, known in ipairs(field.element_sizes) do is_known = is_known or known * count == left(reader) end
    if not is_known then fail(reader, "count mismatch", field.name) end
  end
  local i = 0
  while count and i < count or not count and left(reader) > 0 do
    if not count and i == field.capacity then fail(reader, "too long", field.name) end
    values[i] = read_element(node, (node.kids or {})[""], field.name .. "[" .. i .. "]", reader, level,
                             size)
    i = i + 1
  end
  if i < (field.min_count or 0) then fail(reader, "too short", field.name) end
  return values
end

-- Notes whether the board uses a field, or the element `word` of it.
local function note_use(node, reader, level, word)
  if node.used then reader.unused = not holds(node.used[word], level, reader.context) end
end

local function read_field(node, reader, level)
  local field = node.field
  if node.words then
    if node.leaves then
      local first = node.leaves[node.words[1]]
      need(reader, #node.words * (first.size or field.size or 0), field.name)
    end
    return group(reader, field.name, nil, function()
      local values = {}
      for _, word in ipairs(node.words) do
        note_use(node, reader, level, word)
        if node.leaves then
          values[word] = read_leaf(node.leaves[word], reader, level, word)
        else
          values[word] = read_element(node, node.kids[word], word, reader, level)
        end
      end
      return values
    end)
  end
  note_use(node, reader, level, "")
  if field.announced then return read_announced(node, reader) end
  if field.dim then return read_list(node, reader, level) end
  return read_element(node, (node.kids or {})[""], field.name, reader, level)
end

-- `asked` are the fields that the conditions look at: in a tagged union, those around it.
read_fields = function(nodes, reader, level, asked)
  for _, node in ipairs(nodes) do
    if is_present(node, reader, asked) then level.values[node.name] = read_field(node, reader, level) end
    if node.used then reader.unused = nil end
  end
end

local function read_message(message, reader)
  read_fields(message.nodes, reader, reader.top, reader.top)
  local size = left(reader)
  if size == 0 then return end
  local has_surplus = message.takes_surplus and #reader.bytes > message.max
  if not (message.keeps_tail or has_surplus) or size > message.tail then
    fail(reader, "too long", "")
  end
  reader.tail = {at = reader.at, size = size}
end

local function attempt(message, bytes, context)
  local top = {values = {}}
  local reader = {
    bytes = bytes, at = 0, stop = #bytes, items = {}, context = context, top = top, values = top.values,
  }
  reader.all = reader.items
  local is_done, problem = pcall(read_message, message, reader)
  if not is_done then
    if type(problem) ~= "table" then error(problem, 0) end
    reader.problem = problem
  end
  return reader
end

local function with(context, name, value)
  local copy = {}
  for key, known in pairs(context) do copy[key] = known end
  copy[name] = value
  return copy
end
M.with = with

-- The contexts to try, as the body may repeat its context, or end with a field that may fit.
local function contexts_of(message, bytes, context)
  if message.fits then return {context, with(context, "", true)}, context end
  local repeats = message.repeats
  if not repeats then return {context}, context end
  local given, own = context[repeats.name] or 0, 0
  if #bytes >= repeats.at + repeats.size then
    own = numbers.read("u" .. 8 * repeats.size, bytes, repeats.at)
  end
  local tries = {with(context, repeats.name, bitwise.band(given, bitwise.bnot(repeats.mask)))}
  if numbers.has(own, repeats.mask) then tries[2] = with(context, repeats.name, own) end
  if numbers.has(given, repeats.mask) and tries[2] then tries = {tries[2], tries[1]} end
  return tries, tries[1]
end

-- Decodes a body: `all` are its items, `values` its fields, `tail` the place of what is behind them,
-- and `problem` why it could not be decoded.
function M.decode(message, bytes, context)
  local tries, usual = contexts_of(message, bytes, context)
  local first
  for _, known in ipairs(tries) do
    local reader = attempt(message, bytes, known)
    if not reader.problem and not reader.tail then return reader end
    if known == usual then first = reader end
  end
  return first
end

return M
end)(numbers)

local words = (function(numbers)
-- Words for values, and a line of text that tells what a message says.

local M = {}
local format, concat, unpack_number = string.format, table.concat, Struct.unpack
local MOST = 6 -- values in a line

-- "NAME | NAME | 0x40"
local function flags_text(enum, value)
  local names, bits = {}, value % 4294967296
  for _, flag in ipairs(enum.values or {}) do
    if flag[1] ~= 0 and numbers.has(bits, flag[1]) then
      names[#names + 1] = flag[2]
      bits = bitwise.band(bits, bitwise.bnot(flag[1]))
    end
  end
  if bits ~= 0 then names[#names + 1] = string.format("0x%x", bits) end
  return table.concat(names, " | ")
end

-- The bits of a flag set without a name.
function M.unknown_flags(enum, value)
  local unknown = value % 4294967296
  for _, flag in ipairs(enum.values or {}) do unknown = bitwise.band(unknown, bitwise.bnot(flag[1])) end
  return unknown
end

-- "; the nearest: ONE (23), OTHER (25)"
function M.nearest_text(enum, value)
  local found, least = {}, nil
  for _, one in ipairs(enum.values or {}) do
    local distance = math.abs(one[1] - value)
    if not least or distance < least then found, least = {}, distance end
    if distance == least then found[#found + 1] = string.format("%s (%d)", one[2], one[1]) end
  end
  return #found > 0 and "; the nearest: " .. table.concat(found, ", ") or ""
end

local function enum_text(enum, value)
  if enum.is_flags then return flags_text(enum, value) end
  return enum.names[value] or ""
end
M.enum_text = enum_text

local function display_text(packed, value)
  local values = {}
  for _, part in ipairs(packed.parts) do values[part.name] = numbers.part(part, value) end
  local display = packed.display
  if packed.later_display and value >= packed.later_from then display = packed.later_display end
  local function filled(text)
    return (text:gsub("{(%w+):?0?(%d*)}", function(name, digits)
      return string.format("%0" .. (digits == "" and "1" or digits) .. "d", values[name] or 0)
    end))
  end
  display = display:gsub("%[([^]]*)%]", function(inner)
    return filled(inner):find("[1-9]") and inner or ""
  end)
  return filled(display)
end

-- The value of a part of a packed value: "RC_MODE_ANGLE", "inverted 1"; "" for an unnamed 0 of an enum.
function M.part_text(part, number)
  local enum = protocol.enums[part.enum]
  local text = enum and enum_text(enum, number) or ""
  if enum and (text ~= "" or number == 0) then return text end
  local value = part.is_bool and number or numbers.real(part, number)
  return string.format("%s %.6g", part.name, value) .. (part.unit and " " .. part.unit or "")
end

-- With `is_short`, without numbers that are 0.
function M.packed_text(packed, value, is_short)
  if packed.display then return display_text(packed, value) end
  local names = protocol.enums[packed.names]
  if names and names.names[value] then return names.names[value] end
  local texts = {}
  for _, part in ipairs(packed.parts) do
    local number = numbers.part(part, value)
    local text = M.part_text(part, number)
    local is_left_out = is_short and number == 0 and not part.enum
    if text ~= "" and not is_left_out then texts[#texts + 1] = text end
  end
  return table.concat(texts, ", ")
end

-- A number with its unit; with a direction, it is not negative.
function M.quantity_text(leaf, meaning, raw)
  local value = numbers.real(meaning, raw)
  local unit = meaning.unit and " " .. meaning.unit or ""
  local way = leaf.way and value ~= 0 and (value > 0 and leaf.way[1] or leaf.way[2]) or ""
  if way ~= "" then return string.format("%.6g%s %s", math.abs(value), unit, way) end
  return string.format("%.6g%s", value, unit)
end

function M.special_text(leaf, value)
  return type(value) == "number" and (leaf.field.special or {})[value]
end

-- A value in words; "" if the number says it all.
function M.value_text(item, is_short)
  local leaf, value = item.leaf, item.value
  if type(value) ~= "number" and not leaf.packed then return "" end
  local special = M.special_text(leaf, value)
  if special then return special end
  if leaf.enum then return enum_text(leaf.enum, value) end
  if leaf.packed then return M.packed_text(leaf.packed, value, is_short) end
  local meaning = item.meaning or leaf.field
  if meaning.unit or not numbers.is_plain(meaning) then return M.quantity_text(leaf, meaning, value) end
  return ""
end

-- Values that say most: first the angles and speeds of a motion, then what has a name.
local function rank(leaf)
  local unit = leaf.field.unit
  if leaf.field.reserved or leaf.field.secret then return nil end
  if leaf.field.ways and unit == "deg" then return 1 end
  if leaf.field.ways and unit == "deg/s" then return 2 end
  if leaf.enum or leaf.packed then return 3 end
  return leaf.size and 4 or nil
end

-- The leaves of a message at fixed places, which a line of text can tell without decoding the rest.
local function fixed_leaves(message)
  local found, at = {}, 0
  local function visit(nodes, group)
    for _, node in ipairs(nodes) do
      local field = node.field
      if not field.fixed or field.when or field.appended or field.fits or field.looks_outside
         or node.struct and (node.struct.is_region or not node.struct.size) then
        return false
      end
      local words = node.words or {""}
      if field.dim == "fixed" then
        at = at + field.fixed
      elseif node.kids then
        for _, word in ipairs(words) do
          if not visit(node.kids[word], word ~= "" and word or group) then return false end
        end
      else
        for _, word in ipairs(words) do
          local leaf = node.leaves and node.leaves[word] or node.leaf
          local size = leaf.size or field.size
          found[#found + 1] = {
            leaf = leaf, at = at, size = size, rank = rank(leaf),
            group = word ~= "" and word or group, order = #found,
          }
          at = at + size
        end
      end
    end
    return true
  end
  visit(message.nodes, nil)
  return found
end

local function line_of(message)
  local all, chosen, told = fixed_leaves(message), {}, {}
  local places = {} -- of fields, for alternatives
  for _, one in ipairs(all) do
    places[one.leaf.name .. " " .. (one.group or "")] = one
    if one.rank and one.rank <= 2 then -- the first angle and the first speed of an axis speak for themselves
      local key = one.rank .. (one.group or one.leaf.name)
      if told[key] then one.rank = 4 end
      told[key] = true
    end
    if one.rank then chosen[#chosen + 1] = one end
  end
  if #chosen > 2 * MOST then
    table.sort(chosen, function(a, b)
      return a.rank < b.rank or a.rank == b.rank and a.order < b.order
    end)
    -- Of a large message, its motion is enough.
    for i = #chosen, 4, -1 do
      if i > MOST or chosen[i].rank > 2 then chosen[i] = nil end
    end
  end
  -- Within an axis, the angle precedes the speed.
  local first = {}
  for _, one in ipairs(chosen) do
    local key = one.group or one
    first[key] = math.min(first[key] or one.order, one.order)
  end
  table.sort(chosen, function(a, b)
    local x, y = first[a.group or a], first[b.group or b]
    if x ~= y then return x < y end
    return a.rank < b.rank or a.rank == b.rank and a.order < b.order
  end)
  local head = message.name
  local does = message.does and message.does[1]
  if does and does ~= "reads" and does ~= "unknown" then head = head .. " " .. does end
  for _, one in ipairs(chosen) do
    local field, leaf = one.leaf.field, one.leaf
    one.format = numbers.types[field.type][1]
    one.shows_zero = leaf.enum and not leaf.enum.is_flags and leaf.enum.names[0]
    one.prefix = one.group and one.group .. " " or ""
    if one.rank == 4 then one.prefix = one.prefix .. leaf.name .. " " end
    -- Most values are quantities with one meaning, which need no more than this.
    one.is_simple = not (leaf.enum or leaf.packed or field.special or field.alternative or field.ratio)
    one.scale, one.add = field.scale or 1, field.add or 0
    local unit = field.unit and " " .. field.unit:gsub("%%", "%%%%") or ""
    one.up = "%s%.6g" .. unit .. (leaf.way and " " .. leaf.way[1] or "")
    one.down = "%s%.6g" .. unit .. (leaf.way and " " .. leaf.way[2] or "")
    one.sign = leaf.way and -1 or 1
    one.is_speed = one.rank == 2
  end
  return {leaves = chosen, places = places, head = head, size = #chosen}
end

local lines = {}

-- The text of a value that is not simple.
local function detail(one, line, bytes, value)
  local item = {leaf = one.leaf, value = value, meaning = one.leaf.field}
  local other = one.leaf.field.alternative
  if other then
    local flags = line.places[other.field .. " " .. (one.group or "")] or line.places[other.field .. " "]
    if flags and flags.at + flags.size <= #bytes
       and numbers.has(numbers.read(flags.leaf.field.type, bytes, flags.at), other.mask) then
      item.meaning = other
    end
  end
  local text = M.value_text(item, true)
  if text == "" then return one.prefix .. (one.rank == 4 and "" or one.leaf.name .. " ") .. numbers.text(value) end
  return one.prefix .. text
end

-- A line for a frame: "Control moves: pitch 30 deg down at 10 deg/s". Values that are 0 are left out.
function M.line(message, bytes)
  local line = lines[message]
  if not line then
    line = line_of(message)
    lines[message] = line
  end
  local texts, count, last, stop = {}, 0, nil, #bytes
  for i = 1, line.size do
    local one = line.leaves[i]
    local value = one.at + one.size <= stop and unpack_number(one.format, bytes, one.at + 1) or 0
    if value ~= 0 or one.shows_zero then
      local text
      if one.is_simple and type(value) == "number" then
        local real = value * one.scale + one.add
        text = real < 0 and format(one.down, one.prefix, real * one.sign) or format(one.up, one.prefix, real)
      else
        text = detail(one, line, bytes, value)
      end
      if one.is_speed and last == one.group and last then
        texts[count] = texts[count] .. " at " .. text:sub(#one.prefix + 1):gsub(" %a+$", "")
      else
        count = count + 1
        texts[count] = text
      end
      last = one.group
      if count == MOST then break end
    end
  end
  if count == 0 then return line.head end
  return line.head .. ": " .. concat(texts, ", ", 1, count)
end

return M
end)(numbers)

local conversations = (function(bodies, numbers)
-- What is known of the conversations: bytes that wait for the rest of a frame, facts that later bodies
-- need, and which response belongs to which request. It is collected when a packet is seen first, and
-- looked up by the number of the packet afterwards.

local M = {}
local MOST_CONVERSATIONS = 1000
local MOST_RECORDS = 12000000 -- bytes of all records, about
local RECORD = 120 -- bytes of a record without its content, about
local MOST_FACTS = 10000 -- changes of facts in a conversation
local MOST_PENDING = 64 -- requests without a response

local known, order, weight = {}, {}, 0

function M.forget_all()
  known, order, weight = {}, {}, 0
end

local function side()
  return {waiting = ""}
end

local function forget_records(one)
  weight = weight - one.weight
  one.weight, one.before, one.links, one.ended = 0, {}, {}, {}
end

-- The oldest conversation forgets first. The one in use keeps at least its facts.
local function shrink()
  for _, one in ipairs(order) do
    if weight <= MOST_RECORDS then return end
    if one.weight > 0 then forget_records(one) end
  end
end

-- The conversation with this key, new if there is none.
function M.get(key)
  local one = known[key]
  if one then return one end
  one = {key = key, sides = {[true] = side(), [false] = side()}, facts = {}, pending = {},
         before = {}, links = {}, ended = {}, weight = 0}
  known[key] = one
  order[#order + 1] = one
  if #order > MOST_CONVERSATIONS then
    local oldest = table.remove(order, 1)
    forget_records(oldest)
    known[oldest.key] = nil
  end
  return one
end

-- The conversation with one of these keys; nil if there is none.
function M.find(key, other)
  if known[key] then return known[key], false end
  return known[other], true
end

function M.note(one, records, number, value, size)
  records[number] = value
  one.weight = one.weight + RECORD + size
  weight = weight + RECORD + size
  if weight > MOST_RECORDS then shrink() end
end

-- The facts before a packet; `facts` are in the order of packets.
function M.facts_before(one, number)
  local low, high = 0, #one.facts
  while low < high do
    local middle = math.ceil((low + high) / 2)
    if one.facts[middle].number < number then low = middle else high = middle - 1 end
  end
  return low > 0 and one.facts[low].known or {}
end

-- Remembers facts that begin behind a packet.
function M.remember(one, number, known_facts)
  one.facts[#one.facts + 1] = {number = number, known = known_facts}
  if #one.facts > MOST_FACTS then table.remove(one.facts, 1) end
end

-- Ends what has not ended: what comes behind this packet knows nothing of what came before.
function M.begin_session(one, number)
  for _, side in pairs(one.sides) do
    if side.waiting ~= "" then one.ended[side.last] = true end
    side.waiting = ""
  end
  one.pending = {}
  M.remember(one, number, {})
end

local learners = {}
for _, fact in ipairs(protocol.learns) do
  learners[fact.from] = learners[fact.from] or {}
  table.insert(learners[fact.from], fact)
end

local function types_in(fact, values)
  local types = {}
  for i = 0, 255 do
    local element = (values[fact.list] or {})[i]
    if not element then break end
    local raw = element[fact.kind[1]]
    local kind = fact.types.part and numbers.part(fact.types.part, raw) or raw
    local name = fact.types.types[kind]
    if not name or name == "" then break end
    for _ = 1, math.max(1, element[fact.count]) do
      if #types == 255 then return types end
      types[#types + 1] = name
    end
  end
  return types
end

function M.is_learned_from(message)
  return learners[message.name] or message.role and message.role.is == "introduction"
end

-- The facts for the bodies of a message.
function M.context_for(known_facts, message)
  local context = known_facts[message.name]
  local firmware = known_facts[""]
  if not firmware then return context or {} end
  return bodies.with(context or {}, "firmware", firmware)
end

-- The facts after a message, a new table if they have changed.
function M.learn(known_facts, message, values)
  local result = known_facts
  for _, fact in ipairs(learners[message.name] or {}) do
    local value
    if fact.is then
      value = fact.is
    elseif fact.list then
      value = types_in(fact, values)
    else
      value = values
      for _, step in ipairs(fact.path) do value = type(value) == "table" and value[step] or nil end
    end
    local old = (result[fact["for"]] or {})[fact.name]
    if value ~= nil and value ~= old then
      result = bodies.with(result, fact["for"], bodies.with(result[fact["for"]] or {}, fact.name, value))
    end
  end
  if message.role and message.role.is == "introduction" and message.role.firmware then
    result = bodies.with(result, "", values[message.role.firmware])
  end
  return result
end

-- The case of the answer that holds for a request.
local function answer_of(message, values)
  for _, case in ipairs(message.answers or {}) do
    if not case.when or bodies.holds(case.when, values) then return case end
  end
end

local function names(case, message)
  for _, name in ipairs(case.messages or {}) do
    if name == message.name then return true end
  end
  return false
end

-- True if a response repeats what this request says.
local function repeats(request, message, bytes)
  for _, field in ipairs((request.case.repeated or {})[message.name] or {}) do
    local asked = request.values[field.field]
    if type(asked) == "number" and field.at + field.size <= #bytes then
      local said = numbers.read("u" .. 8 * field.size, bytes, field.at)
      if said ~= asked % 256 ^ field.size then return false end
    end
  end
  return true
end

-- Remembers a request.
function M.ask(one, message, values, frame)
  local case = answer_of(message, values)
  if not case then return end
  local pending = one.pending
  pending[#pending + 1] = {message = message, values = values, case = case, frame = frame, left = case.count or 1}
  if #pending > MOST_PENDING then table.remove(pending, 1) end
end

local function link(one, frame)
  local links = one.links[frame.number]
  if not links then
    links = {}
    M.note(one, one.links, frame.number, links, 0)
  end
  links[frame.ordinal] = links[frame.ordinal] or {}
  return links[frame.ordinal]
end

-- Finds the request of a response, the oldest one that it can belong to.
function M.answer(one, message, values, bytes, frame)
  local role = message.role
  local is_about = role and (role.is == "confirmation" or role.is == "error")
  for i, request in ipairs(one.pending) do
    local fits
    if is_about then
      local command = role.command and values[role.command]
      fits = (not command or command == request.message.id)
             and (role.is == "error" or request.case.confirm)
    else
      fits = names(request.case, message) and repeats(request, message, bytes)
    end
    if fits then
      request.left = request.left - 1
      if request.left <= 0 or role and role.is == "error" then table.remove(one.pending, i) end
      local delay = frame.time - request.frame.time
      local from, to = link(one, request.frame), link(one, frame)
      if not from.response then from.response, from.delay = frame.number, delay end
      to.request, to.delay = request.frame.number, delay
      to.late = delay > request.case.timeout and request.case.timeout or nil
      return
    end
  end
end

return M
end)(bodies, numbers)

local trees = (function(nodes, words, numbers)
-- Shows frames and their bodies as trees.

local M = {}
local filter = protocol.filter
local register = nodes.register

local directions = {[0] = "from the board", [1] = "to the board"}
local own = {
  framing = register("framing", function(f) return ProtoField.string(f, "Framing") end),
  id = register("id", function(f) return ProtoField.uint8(f, "Command", base.DEC, nodes.commands) end),
  size = register("size", function(f) return ProtoField.uint8(f, "Size of the body") end),
  direction = register("direction", function(f)
    return ProtoField.uint8(f, "Direction", base.DEC, directions)
  end),
  message = register("message", function(f) return ProtoField.string(f, "Message") end),
  command = register("command", function(f) return ProtoField.string(f, "Command name") end),
  body = register("body", function(f) return ProtoField.bytes(f, "Body") end),
  undecoded = register("undecoded", function(f) return ProtoField.bytes(f, "Undecoded body") end),
  checksum = register("checksum", function(f) return ProtoField.bytes(f, "Checksum") end),
  skipped = register("skipped", function(f) return ProtoField.bytes(f, "No frame") end),
  request_in = register("request_in", function(f)
    return ProtoField.framenum(f, "Request in", base.NONE, frametype.REQUEST)
  end),
  response_in = register("response_in", function(f)
    return ProtoField.framenum(f, "Response in", base.NONE, frametype.RESPONSE)
  end),
  response_time = register("response_time", function(f)
    return ProtoField.double(f, "Response time")
  end),
}
nodes.finish()

local function expert_of(name, text, kind, severity)
  return ProtoExpert.new(filter .. ".expert." .. name, text, kind, severity)
end
local experts = {
  malformed = expert_of("malformed", "The body cannot be decoded", expert.group.MALFORMED, expert.severity.ERROR),
  unknown = expert_of("unknown", "Unknown message", expert.group.UNDECODED, expert.severity.WARN),
  checksum = expert_of("checksum", "Bad checksum", expert.group.CHECKSUM, expert.severity.ERROR),
  incomplete = expert_of("incomplete", "Incomplete frame", expert.group.REASSEMBLE, expert.severity.NOTE),
  skipped = expert_of("skipped", "Bytes that are no frame", expert.group.PROTOCOL, expert.severity.WARN),
  value = expert_of("value", "Unknown value", expert.group.PROTOCOL, expert.severity.NOTE),
  range = expert_of("range", "Value out of range", expert.group.PROTOCOL, expert.severity.WARN),
  tail = expert_of("tail", "Bytes behind the known fields", expert.group.UNDECODED, expert.severity.NOTE),
  late = expert_of("late", "Late response", expert.group.SEQUENCE, expert.severity.NOTE),
}
local list = {}
for _, one in pairs(experts) do list[#list + 1] = one end
nodes.proto.experts = list

local function check_range(item, tree)
  local field, value, meaning = item.leaf.field, item.value, item.meaning or item.leaf.field
  if type(value) ~= "number" or (field.special or {})[value] or item.unused then return end
  local low, high = meaning.min, meaning.max
  if low and value < low then
    tree:add_proto_expert_info(experts.range, item.leaf.name .. ": " .. numbers.text(value) .. " is below " .. numbers.text(low))
  elseif high and value > high then
    tree:add_proto_expert_info(experts.range, item.leaf.name .. ": " .. numbers.text(value) .. " is above " .. numbers.text(high))
  end
end

local function check_name(enum, value, name, tree)
  if not enum or type(value) ~= "number" then return end
  if enum.is_flags then
    local unknown = words.unknown_flags(enum, value)
    if unknown ~= 0 then
      tree:add_proto_expert_info(experts.value, string.format("%s: no name for 0x%x", name, unknown))
    end
  elseif not enum.names[value] then
    tree:add_proto_expert_info(experts.value, name .. ": no name for " .. numbers.text(value) .. words.nearest_text(enum, value))
  end
end

local function show_flags(flags, tree, range)
  for _, field in ipairs(flags or {}) do tree:add_le(field, range) end
end

local function show_parts(item, tree, range)
  for _, one in ipairs(item.leaf.parts or {}) do
    local part, number = one.part, numbers.part(one.part, item.value)
    if one.has_mask then
      tree:add_le(one.field, range)
    else
      local is_real = part.scale or part.add
      local shown = tree:add(one.field, range, is_real and numbers.real(part, number) or number)
      if part.enum or part.unit then
        local text = words.part_text(part, number)
        shown:set_text(part.name .. ": " .. (text ~= "" and text or numbers.text(number)))
      end
      show_flags(one.flags, shown, range)
      check_name(protocol.enums[part.enum], number, part.name, shown)
    end
  end
end

local function show_text(item, tree, range)
  local leaf, skipped = item.leaf, item.leaf.field.blob == "string" and 1 or 0
  if leaf.field.secret then return tree:add(range, item.label .. ": (hidden)") end
  if leaf.field.blob == "bytes" then return tree:add(leaf.shown, range) end
  local size = #item.value
  if size == 0 then return tree:add(leaf.shown, range, "") end
  tree:add_packet_field(leaf.shown, range(skipped, size), ENC_UTF_8 + ENC_STRING)
end

local function show_value(item, tree, place, is_visible)
  local leaf = item.leaf
  local is_asked = is_visible or tree:referenced(leaf.shown)
  if not is_asked and not (leaf.raw or leaf.flags or leaf.parts) then return end
  if item.size == 0 then
    return is_visible and tree:add(place(item.at, 0), item.label .. ": (empty)")
  end
  local range = place(item.at, item.size)
  if leaf.field.blob then return show_text(item, tree, range) end
  if leaf.field.announced then
    local value = type(item.value) == "number" and item.value or tonumber(tostring(item.value))
    return tree:add(leaf.shown, range, value):set_text(item.label .. ": " .. numbers.text(item.value))
  end
  local shown
  if leaf.raw then
    shown = tree:add(leaf.shown, range, numbers.real(item.meaning, item.value))
    shown:add_le(leaf.raw, range)
  else
    shown = tree:add_le(leaf.shown, range)
  end
  if is_visible then
    local text = words.value_text(item)
    if leaf.raw or item.label ~= leaf.name then
      shown:set_text(item.label .. ": " .. (text ~= "" and text or numbers.text(item.value)))
    elseif text ~= "" and not (leaf.enum and not leaf.enum.is_flags) then
      shown:append_text(" (" .. text .. ")")
    end
  end
  show_flags(leaf.flags, shown, range)
  if leaf.parts then show_parts(item, shown, range) end
  check_range(item, shown)
  check_name(leaf.enum, item.value, leaf.name, shown)
end

local function show_items(items, tree, place, is_visible)
  for _, item in ipairs(items) do
    if not item.items then
      item.label = item.label or item.leaf.name
      show_value(item, tree, place, is_visible)
    else
      local inner = is_visible and tree:add(place(item.at, item.size or 0), item.label) or tree
      show_items(item.items, inner, place, is_visible)
    end
  end
end

-- True if a tree needs the values of a message: one that is seen, or that a filter looks at. A filter
-- does not change before an earlier packet, or the same one, comes again.
local asked, last = {}, 0
function M.wants_values(tree, message, number)
  if tree.visible then return true end
  if number < last then asked = {} end
  last = number
  if asked[message] == nil then
    asked[message] = false
    for _, field in ipairs(message.shown) do
      if tree:referenced(field) then asked[message] = true end
    end
  end
  return asked[message]
end

-- Shows a frame. `decoded` is its body; without one, `reason` says why. `links` belong to the packets of
-- its request or response.
function M.show(tree, range, frame, message, decoded, reason, to_board, line, links)
  local root = tree:add(nodes.proto, range, protocol.short .. ", " .. directions[to_board and 1 or 0] .. ", " .. line)
  local is_visible = tree.visible
  root:add(own.direction, range, to_board and 1 or 0):set_generated()
  root:add(own.framing, range(0, 1), frame.framing.name)
  root:add(own.id, range(frame.framing.id, 1))
  root:add(own.size, range(frame.framing.size, 1))
  local header = frame.framing.header
  local body = frame.body_size > 0 and range(header, frame.body_size)
  local hides = message and message.secret_from and frame.body_size > message.secret_from + 1 -- but the bytes of the packet show it
  if body and not hides then root:add(own.body, body):set_hidden() end
  root:add(own.checksum, range(header + frame.body_size, frame.framing.trailer))
  local name = message and message.command or nodes.commands[frame.id]
  if name then root:add(own.command, range(frame.framing.id, 1), name):set_generated() end
  if links and links.request then root:add(own.request_in, range, links.request):set_generated() end
  if links and links.response then root:add(own.response_in, range, links.response):set_generated() end
  if links and links.delay then
    root:add(own.response_time, range, links.delay):set_text(
      string.format("Response time: %.3f ms", 1000 * links.delay)):set_generated()
  end
  if links and links.late then
    root:add_proto_expert_info(experts.late, string.format("The response took over %g s", links.late))
  end
  if not message then
    if body then root:add(own.undecoded, body) end
    root:add_proto_expert_info(experts.unknown, reason)
    return
  end
  local inner = root:add(own.message, body or range(0, header), message.name)
  if not decoded then return end
  local function place(at, size)
    if size == 0 then at = math.min(at, frame.body_size - 1) end
    return range(header + math.max(at, 0), math.max(size, 1))
  end
  show_items(decoded.all, inner, place, is_visible)
  if decoded.tail then
    local tail = inner:add(message.tail_field, place(decoded.tail.at, decoded.tail.size))
    tail:add_proto_expert_info(experts.tail)
  end
  if decoded.problem then
    local problem = decoded.problem
    local where = problem.field ~= "" and " at " .. problem.field or ""
    inner:add_proto_expert_info(experts.malformed,
      "The body is " .. problem.code .. where .. ", offset " .. problem.at)
    if hides then
      root:add(body or range(0, header), "Undecoded body: (hidden)")
    else
      root:add(own.undecoded, body or range(0, header))
    end
  end
end

-- Shows bytes that are no frame, and the candidates among them.
function M.show_skipped(tree, range, reasons)
  local root = tree:add(nodes.proto, range, protocol.short .. ", no frame: " .. range:len() .. " bytes")
  local skipped = root:add(own.skipped, range)
  skipped:add_proto_expert_info(experts.skipped)
  for _, one in ipairs(reasons) do
    local kind = one.reason == "incomplete" and experts.incomplete or experts.checksum
    skipped:add_proto_expert_info(kind, one.reason .. " of the candidate at byte " .. one.at)
  end
end

-- Shows bytes that wait for more.
function M.show_waiting(tree, range)
  local root = tree:add(nodes.proto, range, protocol.short .. ", " .. range:len() .. " bytes of a frame that goes on")
  root:add_proto_expert_info(experts.incomplete, "The frame goes on in a later packet, or is none")
end

return M
end)(nodes, words, numbers)

local dissector = (function(nodes, frames, bodies, words, conversations, trees)
-- What Wireshark calls: for packets of a recorded line, of TCP and of UDP.

local NONE = {}
local MOST_LINES = 6 -- frames of a packet that the column tells

-- Recorded lines have this link type (see docs/18-wireshark.md).
local LINK_TYPE = wtap.USER13

local proto = nodes.proto
proto.prefs.tcp = Pref.range("TCP ports of boards", "", "Ports of bridges and emulated boards", 65535)
proto.prefs.udp = Pref.range("UDP ports of boards", "", "Ports of bridges and emulated boards", 65535)

local function has_item(tree)
  return tree.visible or not tostring(tree):find("has item=false", 1, true)
end

-- True if more of the frames in bytes are messages to the board than messages from it.
local function are_to_board(bytes)
  local balance, first = 0, nil
  for _, frame in ipairs((frames.scan(bytes, true))) do
    for to_board, weight in pairs({[true] = 1, [false] = -1}) do
      if nodes.choose(to_board, frame.id, frame.body_size) then balance = balance + weight end
    end
  end
  if balance ~= 0 then return balance > 0 end
  return nil
end

-- Decodes a frame as far as it is asked: for its tree, for what later bodies need, or for its request.
local function take(one, frame, all, known, pinfo, ordinal, to_board, tree, wants_tree)
  local asked = not to_board and (known[frame.id] or {}).asked
  local message, reason = nodes.choose(to_board, frame.id, frame.body_size, asked)
  local taken = {frame = frame, message = message, reason = reason}
  if not message then
    local name = nodes.commands[frame.id] or protocol.prefix .. frame.id
    taken.line = name .. " (" .. reason .. ")"
    return taken, known
  end
  local body = all:sub(frame.body + 1, frame.body + frame.body_size)
  local learns = conversations.is_learned_from(message)
  local is_first = not pinfo.visited
  local role = message.role and message.role.is
  local answers = is_first and not to_board and #one.pending > 0
  local asks = is_first and to_board and message.answers
  if wants_tree and trees.wants_values(tree, message, pinfo.number) or learns or asks or answers and (role == "confirmation" or role == "error") then
    taken.decoded = bodies.decode(message, body, conversations.context_for(known, message))
  end
  local decoded = taken.decoded
  local is_sound = not (decoded and decoded.problem)
  if is_sound and (asks or answers) then
    local place = {number = pinfo.number, ordinal = ordinal, time = pinfo.rel_ts}
    if asks then
      conversations.ask(one, message, decoded.values, place)
    else
      conversations.answer(one, message, decoded and decoded.values or {}, body, place)
    end
  end
  if is_sound and learns then
    local now = conversations.learn(known, message, decoded.values)
    if is_first and now ~= known then conversations.remember(one, pinfo.number, now) end
    known = now
  end
  taken.line = ordinal <= MOST_LINES and (words.line(message, body)) or message.name
  if not is_sound then taken.line = message.name .. " (malformed)" end
  return taken, known
end

local function reasons_in(rejected, from, to)
  local found = {}
  for _, one in ipairs(rejected) do
    if one.at >= from and one.at < to then found[#found + 1] = one end
  end
  return found
end

-- Dissects the next bytes of one direction of a conversation.
local function dissect(tvb, pinfo, tree, one, to_board)
  local side, number, visited = one.sides[to_board], pinfo.number, pinfo.visited
  local is_last = visited and (side.last == number or one.ended[number])
  local before = visited and (one.before[number] or "") or side.waiting
  local all = before .. tvb:raw()
  local found, rejected, rest = frames.scan(all, is_last)
  if not visited then
    side.waiting, side.last = all:sub(rest + 1), number
    if before ~= "" then conversations.note(one, one.before, number, before, #before) end
  end
  local columns = pinfo.cols
  columns.protocol = protocol.short
  local wants_tree = has_item(tree)
  local joined = wants_tree and before ~= "" and ByteArray.new(all, true):tvb("Bytes of a frame in several packets")
  local function range(at, size)
    if at >= #before then return tvb(at - #before, size) end
    return joined(at, size)
  end
  local known = conversations.facts_before(one, number)
  local links = one.links[number] or NONE
  local lines, skipped, place = {}, 0, 0
  local function skip(to)
    if to <= place then return end
    skipped = skipped + to - place
    if wants_tree then trees.show_skipped(tree, range(place, to - place), reasons_in(rejected, place, to)) end
  end
  for ordinal, frame in ipairs(found) do
    skip(frame.at)
    local taken
    taken, known = take(one, frame, all, known, pinfo, ordinal, to_board, tree, wants_tree)
    if ordinal <= MOST_LINES then lines[ordinal] = taken.line end
    if wants_tree then
      links = one.links[number] or links
      trees.show(tree, range(frame.at, frame.size), frame, taken.message, taken.decoded, taken.reason,
                 to_board, taken.line, links[ordinal])
    end
    place = frame.at + frame.size
  end
  skip(rest)
  if rest < #all and wants_tree then trees.show_waiting(tree, range(rest, #all - rest)) end
  if #found > MOST_LINES then lines[#lines + 1] = #found - MOST_LINES .. " more frames" end
  if skipped > 0 then lines[#lines + 1] = "no frame: " .. skipped .. " bytes" end
  if #found == 0 and rest < #all then lines[#lines + 1] = #all - rest .. " bytes of a frame that goes on" end
  columns.info = (to_board and "> " or "< ") .. table.concat(lines, " | ")
end

-- A recorded line: the flags of a packet say its direction. One without bytes begins a session, which
-- knows nothing of the one before.
local function dissect_line(tvb, pinfo, tree)
  local one = conversations.get("line")
  if tvb:len() > 0 then return dissect(tvb, pinfo, tree, one, pinfo.p2p_dir == 0) end
  if not pinfo.visited then conversations.begin_session(one, pinfo.number) end
  pinfo.cols.protocol = protocol.short
  pinfo.cols.info = "a session begins"
end

-- The conversation of a packet of TCP or UDP, and whether its sender is the host. The board has the port
-- by which Wireshark found this dissector; otherwise the frames tell, or else the lower port is its.
local function conversation_of(tvb, pinfo)
  local from = tostring(pinfo.src) .. ":" .. pinfo.src_port
  local to = tostring(pinfo.dst) .. ":" .. pinfo.dst_port
  local one = conversations.find(from .. " " .. to, to .. " " .. from)
  if not one then
    local is_to_board
    if pinfo.src_port ~= pinfo.dst_port and pinfo.match_uint == pinfo.dst_port then
      is_to_board = true
    elseif pinfo.src_port ~= pinfo.dst_port and pinfo.match_uint == pinfo.src_port then
      is_to_board = false
    else
      is_to_board = are_to_board(tvb:raw(0, tvb:len()))
      if is_to_board == nil then is_to_board = pinfo.dst_port <= pinfo.src_port end
    end
    one = conversations.get(from .. " " .. to)
    one.board = is_to_board and to or from
  end
  return one, one.board == to
end

function proto.dissector(tvb, pinfo, tree)
  local is_line = pinfo.src_port == 0 and pinfo.dst_port == 0
  if is_line then
    dissect_line(tvb, pinfo, tree)
  elseif tvb:len() > 0 then
    local one, to_board = conversation_of(tvb, pinfo)
    dissect(tvb, pinfo, tree, one, to_board)
  end
  return tvb:len()
end

-- True for packets that begin with a frame of a known message.
local function begins_with_frame(tvb)
  local size = tvb:len()
  if size < 5 then return false end
  local found = frames.scan(tvb:raw(0, math.min(size, 300)), true)
  local first = found[1]
  return first and first.at == 0 and (nodes.choose(true, first.id, first.body_size)
                                      or nodes.choose(false, first.id, first.body_size)) and true
end

local function heuristic(tvb, pinfo, tree)
  if not begins_with_frame(tvb) then return false end
  pinfo.conversation = proto
  proto.dissector(tvb, pinfo, tree)
  return true
end

function proto.init()
  conversations.forget_all()
end

local registered = {tcp = "", udp = ""}
function proto.prefs_changed()
  for _, kind in ipairs({"tcp", "udp"}) do
    local ports = proto.prefs[kind]
    local ports_table = DissectorTable.get(kind .. ".port")
    if registered[kind] ~= "" then ports_table:remove(registered[kind], proto) end
    if ports ~= "" then ports_table:add(ports, proto) end
    registered[kind] = ports
  end
end

DissectorTable.get("wtap_encap"):add(LINK_TYPE, proto)
for _, kind in ipairs({"tcp", "udp"}) do
  DissectorTable.get(kind .. ".port"):add_for_decode_as(proto)
  proto:register_heuristic(kind, heuristic)
end
end)(nodes, frames, bodies, words, conversations, trees)
