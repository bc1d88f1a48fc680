// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The sizes of requests.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/messages.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc {

/// Returns the size of the largest form of a request that a board with these versions has. The
/// board ignores the bytes after it. Returns max_body_size if there are none, because the form
/// ends in a list or keeps a tail.
constexpr std::size_t largest_request(
    std::uint8_t id, [[maybe_unused]] const Availability& versions) noexcept {
  switch (id) {
    case 20:  // CMD_BOARD_INFO_3
      return 0;
    case 21:  // CMD_READ_PARAMS_3
      return 1;
    case 23:  // CMD_REALTIME_DATA_3
      return 0;
    case 24:  // CMD_SELECT_IMU_3
      if (is_supported<msg::SelectImu3Calibrate>(versions)) return 12;
      if (is_supported<msg::SelectImu3CalibrateShort>(versions)) return 11;
      if (is_supported<msg::SelectImu3Ext>(versions)) return max_body_size;
      return 1;
    case 25:  // CMD_REALTIME_DATA_4
      return 0;
    case 26:  // CMD_ENCODERS_CALIB_OFFSET_4
      if (is_supported<msg::EncodersCalibOffset4>(versions) && is_available({.firmware = 2687} ,
          versions)) return 1;
      return 0;
    case 27:  // CMD_ENCODERS_CALIB_FLD_OFFSET_4
      if (is_supported<msg::EncodersCalibFldOffset4>(versions) && is_available({.firmware = 2708} ,
          versions)) return 14;
      if (is_supported<msg::EncodersCalibFldOffset4>(versions) && is_available({.firmware = 2626} ,
          versions)) return 6;
      return 0;
    case 28:  // CMD_READ_PROFILE_NAMES
      return 0;
    case 32:  // CMD_SAVE_PARAMS_3
      if (is_supported<msg::SaveParams3>(versions) && is_available({.firmware = 2689} , versions))
          return max_body_size;
      return 0;
    case 33:  // CMD_READ_PARAMS_EXT
      return 1;
    case 35:  // CMD_AUTO_PID
      return 19;
    case 36:  // CMD_SERVO_OUT
      if (is_supported<msg::ServoOut>(versions)) return 16;
      return 8;
    case 37:  // CMD_BODE_TEST_START_STOP
      return 30;
    case 40:  // CMD_I2C_READ_REG_BUF
      if (is_supported<msg::I2cReadRegBufRequestWideRegister>(versions)) return 4;
      if (is_supported<msg::I2cReadRegBufRequest>(versions)) return 3;
      return 2;
    case 42:  // CMD_READ_EXTERNAL_DATA
      return 0;
    case 43:  // CMD_READ_ADJ_VARS_CFG
      return 0;
    case 46:  // CMD_ADJ_VARS_STATE
      if (is_supported<msg::AdjVarsStateRequestExt>(versions)) return 7;
      return 2;
    case 48:  // CMD_EEPROM_READ
      return 6;
    case 49:  // CMD_CALIB_INFO
      return 12;
    case 50:  // CMD_SIGN_MESSAGE
      return 33;
    case 51:  // CMD_BOOT_MODE_3
      if (is_supported<msg::BootMode3Ext>(versions)) return 3;
      return 0;
    case 53:  // CMD_READ_FILE
      return 20;
    case 55:  // CMD_FS_CLEAR_ALL
      return 0;
    case 56:  // CMD_AHRS_HELPER
      if (is_supported<msg::AhrsHelperRequestExtWide>(versions)) return 26;
      if (is_supported<msg::AhrsHelperRequestExt>(versions)) return 25;
      if (is_supported<msg::AhrsHelperRequestWide>(versions)) return 2;
      return 1;
    case 57:  // CMD_RUN_SCRIPT
      return 34;
    case 59:  // CMD_CALIB_MAG
      if (is_supported<msg::CalibMagExt>(versions)) return 12;
      return 0;
    case 61:  // CMD_GET_ANGLES_EXT
      return 0;
    case 62:  // CMD_READ_PARAMS_EXT2
      return 1;
    case 65:  // CMD_CALIB_ACC
      if (is_supported<msg::CalibAccExt>(versions)) return 12;
      return 0;
    case 66:  // CMD_CALIB_BAT
      return 2;
    case 67:  // CMD_CONTROL
      if (is_supported<msg::ControlExt>(versions)) return 15;
      return 13;
    case 68:  // CMD_REALTIME_DATA
      return 0;
    case 69:  // CMD_EXECUTE_MENU
      if (is_supported<msg::ExecuteMenuExt>(versions)) return 2;
      return 1;
    case 70:  // CMD_USE_DEFAULTS
      return 1;
    case 71:  // CMD_CALIB_EXT_GAIN
      return 0;
    case 72:  // CMD_HELPER_DATA
      if (is_supported<msg::HelperDataExt>(versions)) return 20;
      return 10;
    case 73:  // CMD_GET_ANGLES
      return 0;
    case 75:  // CMD_GYRO_CORRECTION
      return 9;
    case 76:  // CMD_MODULE_LIST
      return 0;
    case 77:  // CMD_MOTORS_ON
      return 0;
    case 78:  // CMD_MODULE_FLASH_START
      return 5;
    case 79:  // CMD_CALIB_OFFSET
      return 0;
    case 80:  // CMD_CALIB_POLES
      return 0;
    case 82:  // CMD_READ_PARAMS
      return 1;
    case 83:  // CMD_MODULE_FLASH_FINISH
      return 5;
    case 84:  // CMD_TRIGGER_PIN
      return 2;
    case 85:  // CMD_DATA_STREAM_INTERVAL
      return 21;
    case 86:  // CMD_BOARD_INFO
      if (is_supported<msg::BoardInfoRequestExt>(versions)) return max_body_size;
      if (is_supported<msg::BoardInfoRequestOneByte>(versions)) return 1;
      return 0;
    case 88:  // CMD_REALTIME_DATA_CUSTOM
      return 10;
    case 90:  // CMD_CONTROL_CONFIG
      return 41;
    case 91:  // CMD_CALIB_ORIENT_CORR
      return 16;
    case 93:  // CMD_CALIB_COGGING
      return 57;
    case 94:  // CMD_CALIB_ACC_EXT_REF
      return 20;
    case 95:  // CMD_PROFILE_SET
      return 10;
    case 96:  // CMD_CAN_DEVICE_SCAN
      return 0;
    case 103:  // CMD_CALIB_GYRO
      if (is_supported<msg::CalibGyroExt>(versions)) return 12;
      return 0;
    case 104:  // CMD_READ_PARAMS_EXT3
      return 1;
    case 106:  // CMD_EXT_IMU_DEBUG_INFO
      return 0;
    case 108:  // CMD_AUTO_PID2
      return 73;
    case 109:  // CMD_MOTORS_OFF
      if (is_supported<msg::MotorsOffExt>(versions)) return 1;
      return 0;
    case 111:  // CMD_READ_STATE_VARS
      return 0;
    case 114:  // CMD_RESET
      if (is_supported<msg::ResetRequestExt>(versions)) return 3;
      return 0;
    case 119:  // CMD_WRITE_PARAMS_SET
      return 1;
    case 121:  // CMD_CONTROL_EXT
      return 32;
    case 123:  // CMD_SYNC_MOTORS
      return 6;
    case 130:  // CMD_EXT_MOTORS_CONTROL_CONFIG
      return 12;
    case 131:  // CMD_EXT_MOTORS_STATE
      return 5;
    case 132:  // CMD_ADJ_VARS_INFO
      if (is_supported<msg::AdjVarsInfoRequest>(versions)) return 1;
      return 0;
    case 136:  // CMD_PASS_PROTECT_READ
      return 0;
    case 139:  // CMD_REALTIME_DATA_CUSTOM2
      return 10;
    case 140:  // CMD_CONTROL_QUAT
      if (is_supported<msg::ControlQuatSpeedAttitude>(versions)) return 30;
      if (is_supported<msg::ControlQuatSpeedAttitudePacked>(versions)) return 22;
      if (is_supported<msg::ControlQuatAttitude>(versions)) return 18;
      if (is_supported<msg::ControlQuatSpeed>(versions)) return 14;
      if (is_supported<msg::ControlQuatAttitudePacked>(versions)) return 10;
      return 2;
    case 141:  // CMD_CONTROL_QUAT_STATUS
      return 4;
    case 142:  // CMD_CONTROL_QUAT_CONFIG
      return 24;
    case 143:  // CMD_SET_TRANSP_PROXY
      return 2;
    case 144:  // CMD_UDRV_DEVICE_SCAN
      return 0;
    case 249:  // CMD_SET_DEBUG_PORT
      return 16;
    case 253:  // CMD_DEBUG_VARS_INFO_3
      if (is_supported<msg::DebugVarsInfo3Request>(versions) && is_available({.firmware = 2720} ,
          versions)) return 1;
      return 0;
    case 254:  // CMD_DEBUG_VARS_3
      if (is_supported<msg::DebugVars3RequestSelected>(versions)) return max_body_size;
      return 0;
    default: return max_body_size;
  }
}

}  // namespace sbgc

#pragma GCC diagnostic pop
