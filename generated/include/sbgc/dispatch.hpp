// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Which message a body is, and what must be known to read it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/messages.hpp>
#include <sbgc/meta.hpp>

namespace sbgc {

/// All messages, in the order of the specification's families.
using AllMessages = TypeList<
    BoardInfo,
    BoardInfoRequest,
    BoardInfoRequestOneByte,
    BoardInfoRequestExt,
    Confirm,
    Error,
    ErrorExt,
    BoardInfo3,
    BoardInfo3Request,
    Reset,
    ResetRequest,
    ResetRequestExt,
    BootMode3,
    BootMode3Ext,
    QueueParamsInfo3,
    QueueParamsInfo3Request,
    SystemState,
    SystemStateRequest,
    MavlinkInfo,
    MavlinkInfoRequest,
    MavlinkDebug,
    MavlinkDebugRequest,
    ReadParams3,
    ReadParams3Request,
    ReadParams,
    ReadParamsExt,
    ReadParamsExtRequest,
    ReadParamsExt2,
    ReadParamsExt2Request,
    ReadProfileNames,
    ReadProfileNamesRequest,
    SaveParams3,
    UseDefaults,
    WriteParams3,
    WriteParams,
    WriteParamsExt,
    WriteParamsExt2,
    WriteProfileNames,
    RealtimeData,
    RealtimeData3,
    RealtimeData3Request,
    RealtimeData4,
    RealtimeData4Request,
    RealtimeDataCustom,
    RealtimeDataCustomRequest,
    DataStreamInterval,
    Control,
    ControlExt,
    GetAngles,
    GetAnglesRequest,
    GetAnglesExt,
    GetAnglesExtRequest,
    MotorsOn,
    MotorsOff,
    MotorsOffExt,
    ExecuteMenu,
    ExecuteMenuExt,
    HelperData,
    HelperDataExt,
    CalibAcc,
    CalibAccExt,
    CalibGyro,
    CalibGyroExt,
    CalibMag,
    CalibExtGain,
    CalibPoles,
    CalibOffset,
    CalibBat,
    CalibInfo,
    CalibInfoRequest,
    CalibMotorMagLink,
    CalibMotorMagLinkRequest,
    EncodersCalibOffset4,
    EncodersCalibFldOffset4,
    AutoPid,
    AutoPidRequest,
    SelectImu3,
    SelectImu3Ext,
    AhrsHelper,
    AhrsHelperRequest,
    AhrsHelperRequestWide,
    AhrsHelperRequestExt,
    AhrsHelperRequestExtWide,
    GyroCorrection,
    BeepSound,
    TriggerPin,
    ServoOut,
    I2cWriteRegBuf,
    I2cReadRegBuf,
    I2cReadRegBufRequest,
    ApiVirtChControl,
    SetAdjVarsVal,
    GetAdjVarsVal,
    ReadAdjVarsCfg,
    ReadAdjVarsCfgRequest,
    AdjVarsState,
    AdjVarsStateRequest,
    AdjVarsStateRequestExt,
    WriteAdjVarsCfg,
    EepromWrite,
    ReadFile,
    ReadFileError,
    ReadFileRequest,
    WriteFile,
    FsClearAll,
    EepromRead,
    EepromReadRequest,
    ReadExternalData,
    ReadExternalDataRequest,
    WriteExternalData,
    RunScript,
    ScriptDebug,
    DebugVarsInfo3,
    DebugVarsInfo3Request,
    DebugVars3,
    DebugVars3Request>;

/// What earlier messages of a conversation say about how to read later ones.
struct Contexts {
  RealtimeDataCustom::Context realtime_data_custom{};
  DebugVars3::Context debug_vars3{};

  constexpr const RealtimeDataCustom::Context& of(const RealtimeDataCustom&) const noexcept {
    return realtime_data_custom;
  }
  constexpr const DebugVars3::Context& of(const DebugVars3&) const noexcept {
    return debug_vars3;
  }
  constexpr void learn(const RealtimeDataCustomRequest& message) noexcept {
    detail::learn(message.flags, realtime_data_custom.flags);
  }
  constexpr void learn(const DataStreamInterval& message) noexcept {
    detail::learn(message.config.flags, realtime_data_custom.flags);
  }
  constexpr void learn(const DebugVarsInfo3& message) noexcept {
    debug_vars3.types.clear();
    for (const auto& item : message.vars) {
      const NumberType type = number_type(item.var_type.kind());
      if (!detail::announce(debug_vars3.types, type, item.arr_size)) break;
    }
  }
  /// Takes from a message what later ones need; most messages tell nothing.
  template <class M>
  constexpr void learn(const M&) noexcept {}
};

/// Calls `use(Type<M>{})` with the message M that a body of `size` bytes is. Of several forms the
/// one that such a body fits is chosen; of a command with one form always that one, so that decode
/// can tell what is wrong with the size. Returns ok, unknown_command or unknown_form.
template <class Use>
constexpr Code select(Direction direction, std::uint8_t id, [[maybe_unused]] std::size_t size,
                      Use&& use) {
  if (direction == Direction::from_board) {
    switch (id) {
      case 20:  // CMD_BOARD_INFO_3
        return use(Type<sbgc::BoardInfo3>{}), Code::ok;
      case 21:  // CMD_READ_PARAMS_3
        return use(Type<sbgc::ReadParams3>{}), Code::ok;
      case 23:  // CMD_REALTIME_DATA_3
        return use(Type<sbgc::RealtimeData3>{}), Code::ok;
      case 25:  // CMD_REALTIME_DATA_4
        return use(Type<sbgc::RealtimeData4>{}), Code::ok;
      case 28:  // CMD_READ_PROFILE_NAMES
        return use(Type<sbgc::ReadProfileNames>{}), Code::ok;
      case 30:  // CMD_QUEUE_PARAMS_INFO_3
        return use(Type<sbgc::QueueParamsInfo3>{}), Code::ok;
      case 31:  // CMD_SET_ADJ_VARS_VAL
        return use(Type<sbgc::SetAdjVarsVal>{}), Code::ok;
      case 33:  // CMD_READ_PARAMS_EXT
        return use(Type<sbgc::ReadParamsExt>{}), Code::ok;
      case 35:  // CMD_AUTO_PID
        return use(Type<sbgc::AutoPid>{}), Code::ok;
      case 40:  // CMD_I2C_READ_REG_BUF
        return use(Type<sbgc::I2cReadRegBuf>{}), Code::ok;
      case 42:  // CMD_READ_EXTERNAL_DATA
        return use(Type<sbgc::ReadExternalData>{}), Code::ok;
      case 43:  // CMD_READ_ADJ_VARS_CFG
        return use(Type<sbgc::ReadAdjVarsCfg>{}), Code::ok;
      case 46:  // CMD_ADJ_VARS_STATE
        return use(Type<sbgc::AdjVarsState>{}), Code::ok;
      case 48:  // CMD_EEPROM_READ
        return use(Type<sbgc::EepromRead>{}), Code::ok;
      case 49:  // CMD_CALIB_INFO
        return use(Type<sbgc::CalibInfo>{}), Code::ok;
      case 52:  // CMD_SYSTEM_STATE
        return use(Type<sbgc::SystemState>{}), Code::ok;
      case 53:  // CMD_READ_FILE
        if (size == 1) return use(Type<sbgc::ReadFileError>{}), Code::ok;
        if (size >= 4) return use(Type<sbgc::ReadFile>{}), Code::ok;
        return Code::unknown_form;
      case 56:  // CMD_AHRS_HELPER
        return use(Type<sbgc::AhrsHelper>{}), Code::ok;
      case 58:  // CMD_SCRIPT_DEBUG
        return use(Type<sbgc::ScriptDebug>{}), Code::ok;
      case 61:  // CMD_GET_ANGLES_EXT
        return use(Type<sbgc::GetAnglesExt>{}), Code::ok;
      case 62:  // CMD_READ_PARAMS_EXT2
        return use(Type<sbgc::ReadParamsExt2>{}), Code::ok;
      case 67:  // CMD_CONFIRM
        return use(Type<sbgc::Confirm>{}), Code::ok;
      case 73:  // CMD_GET_ANGLES
        return use(Type<sbgc::GetAngles>{}), Code::ok;
      case 74:  // CMD_CALIB_MOTOR_MAG_LINK
        return use(Type<sbgc::CalibMotorMagLink>{}), Code::ok;
      case 86:  // CMD_BOARD_INFO
        return use(Type<sbgc::BoardInfo>{}), Code::ok;
      case 88:  // CMD_REALTIME_DATA_CUSTOM
        return use(Type<sbgc::RealtimeDataCustom>{}), Code::ok;
      case 114:  // CMD_RESET
        return use(Type<sbgc::Reset>{}), Code::ok;
      case 250:  // CMD_MAVLINK_INFO
        return use(Type<sbgc::MavlinkInfo>{}), Code::ok;
      case 251:  // CMD_MAVLINK_DEBUG
        return use(Type<sbgc::MavlinkDebug>{}), Code::ok;
      case 253:  // CMD_DEBUG_VARS_INFO_3
        return use(Type<sbgc::DebugVarsInfo3>{}), Code::ok;
      case 254:  // CMD_DEBUG_VARS_3
        return use(Type<sbgc::DebugVars3>{}), Code::ok;
      case 255:  // CMD_ERROR
        if (size == 5) return use(Type<sbgc::Error>{}), Code::ok;
        if (size >= 6) return use(Type<sbgc::ErrorExt>{}), Code::ok;
        return Code::unknown_form;
      default: return Code::unknown_command;
    }
  } else {
    switch (id) {
      case 20:  // CMD_BOARD_INFO_3
        return use(Type<sbgc::BoardInfo3Request>{}), Code::ok;
      case 21:  // CMD_READ_PARAMS_3
        return use(Type<sbgc::ReadParams3Request>{}), Code::ok;
      case 22:  // CMD_WRITE_PARAMS_3
        return use(Type<sbgc::WriteParams3>{}), Code::ok;
      case 23:  // CMD_REALTIME_DATA_3
        return use(Type<sbgc::RealtimeData3Request>{}), Code::ok;
      case 24:  // CMD_SELECT_IMU_3
        if (size == 1) return use(Type<sbgc::SelectImu3>{}), Code::ok;
        if (size >= 2) return use(Type<sbgc::SelectImu3Ext>{}), Code::ok;
        return Code::unknown_form;
      case 25:  // CMD_REALTIME_DATA_4
        return use(Type<sbgc::RealtimeData4Request>{}), Code::ok;
      case 26:  // CMD_ENCODERS_CALIB_OFFSET_4
        return use(Type<sbgc::EncodersCalibOffset4>{}), Code::ok;
      case 27:  // CMD_ENCODERS_CALIB_FLD_OFFSET_4
        return use(Type<sbgc::EncodersCalibFldOffset4>{}), Code::ok;
      case 28:  // CMD_READ_PROFILE_NAMES
        return use(Type<sbgc::ReadProfileNamesRequest>{}), Code::ok;
      case 29:  // CMD_WRITE_PROFILE_NAMES
        return use(Type<sbgc::WriteProfileNames>{}), Code::ok;
      case 30:  // CMD_QUEUE_PARAMS_INFO_3
        return use(Type<sbgc::QueueParamsInfo3Request>{}), Code::ok;
      case 31:  // CMD_SET_ADJ_VARS_VAL
        return use(Type<sbgc::SetAdjVarsVal>{}), Code::ok;
      case 32:  // CMD_SAVE_PARAMS_3
        return use(Type<sbgc::SaveParams3>{}), Code::ok;
      case 33:  // CMD_READ_PARAMS_EXT
        return use(Type<sbgc::ReadParamsExtRequest>{}), Code::ok;
      case 34:  // CMD_WRITE_PARAMS_EXT
        return use(Type<sbgc::WriteParamsExt>{}), Code::ok;
      case 35:  // CMD_AUTO_PID
        return use(Type<sbgc::AutoPidRequest>{}), Code::ok;
      case 36:  // CMD_SERVO_OUT
        return use(Type<sbgc::ServoOut>{}), Code::ok;
      case 39:  // CMD_I2C_WRITE_REG_BUF
        return use(Type<sbgc::I2cWriteRegBuf>{}), Code::ok;
      case 40:  // CMD_I2C_READ_REG_BUF
        return use(Type<sbgc::I2cReadRegBufRequest>{}), Code::ok;
      case 41:  // CMD_WRITE_EXTERNAL_DATA
        return use(Type<sbgc::WriteExternalData>{}), Code::ok;
      case 42:  // CMD_READ_EXTERNAL_DATA
        return use(Type<sbgc::ReadExternalDataRequest>{}), Code::ok;
      case 43:  // CMD_READ_ADJ_VARS_CFG
        return use(Type<sbgc::ReadAdjVarsCfgRequest>{}), Code::ok;
      case 44:  // CMD_WRITE_ADJ_VARS_CFG
        return use(Type<sbgc::WriteAdjVarsCfg>{}), Code::ok;
      case 45:  // CMD_API_VIRT_CH_CONTROL
        return use(Type<sbgc::ApiVirtChControl>{}), Code::ok;
      case 46:  // CMD_ADJ_VARS_STATE
        if (size == 2) return use(Type<sbgc::AdjVarsStateRequest>{}), Code::ok;
        if (size == 7) return use(Type<sbgc::AdjVarsStateRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 47:  // CMD_EEPROM_WRITE
        return use(Type<sbgc::EepromWrite>{}), Code::ok;
      case 48:  // CMD_EEPROM_READ
        return use(Type<sbgc::EepromReadRequest>{}), Code::ok;
      case 49:  // CMD_CALIB_INFO
        return use(Type<sbgc::CalibInfoRequest>{}), Code::ok;
      case 51:  // CMD_BOOT_MODE_3
        if (size == 0) return use(Type<sbgc::BootMode3>{}), Code::ok;
        if (size == 3) return use(Type<sbgc::BootMode3Ext>{}), Code::ok;
        return Code::unknown_form;
      case 52:  // CMD_SYSTEM_STATE
        return use(Type<sbgc::SystemStateRequest>{}), Code::ok;
      case 53:  // CMD_READ_FILE
        return use(Type<sbgc::ReadFileRequest>{}), Code::ok;
      case 54:  // CMD_WRITE_FILE
        return use(Type<sbgc::WriteFile>{}), Code::ok;
      case 55:  // CMD_FS_CLEAR_ALL
        return use(Type<sbgc::FsClearAll>{}), Code::ok;
      case 56:  // CMD_AHRS_HELPER
        if (size == 1) return use(Type<sbgc::AhrsHelperRequest>{}), Code::ok;
        if (size == 2) return use(Type<sbgc::AhrsHelperRequestWide>{}), Code::ok;
        if (size == 25) return use(Type<sbgc::AhrsHelperRequestExt>{}), Code::ok;
        if (size == 26) return use(Type<sbgc::AhrsHelperRequestExtWide>{}), Code::ok;
        return Code::unknown_form;
      case 57:  // CMD_RUN_SCRIPT
        return use(Type<sbgc::RunScript>{}), Code::ok;
      case 59:  // CMD_CALIB_MAG
        return use(Type<sbgc::CalibMag>{}), Code::ok;
      case 61:  // CMD_GET_ANGLES_EXT
        return use(Type<sbgc::GetAnglesExtRequest>{}), Code::ok;
      case 62:  // CMD_READ_PARAMS_EXT2
        return use(Type<sbgc::ReadParamsExt2Request>{}), Code::ok;
      case 63:  // CMD_WRITE_PARAMS_EXT2
        return use(Type<sbgc::WriteParamsExt2>{}), Code::ok;
      case 64:  // CMD_GET_ADJ_VARS_VAL
        return use(Type<sbgc::GetAdjVarsVal>{}), Code::ok;
      case 65:  // CMD_CALIB_ACC
        if (size == 0) return use(Type<sbgc::CalibAcc>{}), Code::ok;
        if (size == 12) return use(Type<sbgc::CalibAccExt>{}), Code::ok;
        return Code::unknown_form;
      case 66:  // CMD_CALIB_BAT
        return use(Type<sbgc::CalibBat>{}), Code::ok;
      case 67:  // CMD_CONTROL
        if (size == 13) return use(Type<sbgc::Control>{}), Code::ok;
        if (size == 15) return use(Type<sbgc::ControlExt>{}), Code::ok;
        return Code::unknown_form;
      case 68:  // CMD_REALTIME_DATA
        return use(Type<sbgc::RealtimeData>{}), Code::ok;
      case 69:  // CMD_EXECUTE_MENU
        if (size == 1) return use(Type<sbgc::ExecuteMenu>{}), Code::ok;
        if (size == 2) return use(Type<sbgc::ExecuteMenuExt>{}), Code::ok;
        return Code::unknown_form;
      case 70:  // CMD_USE_DEFAULTS
        return use(Type<sbgc::UseDefaults>{}), Code::ok;
      case 71:  // CMD_CALIB_EXT_GAIN
        return use(Type<sbgc::CalibExtGain>{}), Code::ok;
      case 72:  // CMD_HELPER_DATA
        if (size == 10) return use(Type<sbgc::HelperData>{}), Code::ok;
        if (size == 20) return use(Type<sbgc::HelperDataExt>{}), Code::ok;
        return Code::unknown_form;
      case 73:  // CMD_GET_ANGLES
        return use(Type<sbgc::GetAnglesRequest>{}), Code::ok;
      case 74:  // CMD_CALIB_MOTOR_MAG_LINK
        return use(Type<sbgc::CalibMotorMagLinkRequest>{}), Code::ok;
      case 75:  // CMD_GYRO_CORRECTION
        return use(Type<sbgc::GyroCorrection>{}), Code::ok;
      case 77:  // CMD_MOTORS_ON
        return use(Type<sbgc::MotorsOn>{}), Code::ok;
      case 79:  // CMD_CALIB_OFFSET
        return use(Type<sbgc::CalibOffset>{}), Code::ok;
      case 80:  // CMD_CALIB_POLES
        return use(Type<sbgc::CalibPoles>{}), Code::ok;
      case 82:  // CMD_READ_PARAMS
        return use(Type<sbgc::ReadParams>{}), Code::ok;
      case 84:  // CMD_TRIGGER_PIN
        return use(Type<sbgc::TriggerPin>{}), Code::ok;
      case 85:  // CMD_DATA_STREAM_INTERVAL
        return use(Type<sbgc::DataStreamInterval>{}), Code::ok;
      case 86:  // CMD_BOARD_INFO
        if (size == 0) return use(Type<sbgc::BoardInfoRequest>{}), Code::ok;
        if (size == 1) return use(Type<sbgc::BoardInfoRequestOneByte>{}), Code::ok;
        if (size >= 2) return use(Type<sbgc::BoardInfoRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 87:  // CMD_WRITE_PARAMS
        return use(Type<sbgc::WriteParams>{}), Code::ok;
      case 88:  // CMD_REALTIME_DATA_CUSTOM
        return use(Type<sbgc::RealtimeDataCustomRequest>{}), Code::ok;
      case 89:  // CMD_BEEP_SOUND
        return use(Type<sbgc::BeepSound>{}), Code::ok;
      case 103:  // CMD_CALIB_GYRO
        if (size == 0) return use(Type<sbgc::CalibGyro>{}), Code::ok;
        if (size == 12) return use(Type<sbgc::CalibGyroExt>{}), Code::ok;
        return Code::unknown_form;
      case 109:  // CMD_MOTORS_OFF
        if (size == 0) return use(Type<sbgc::MotorsOff>{}), Code::ok;
        if (size == 1) return use(Type<sbgc::MotorsOffExt>{}), Code::ok;
        return Code::unknown_form;
      case 114:  // CMD_RESET
        if (size == 0) return use(Type<sbgc::ResetRequest>{}), Code::ok;
        if (size == 3) return use(Type<sbgc::ResetRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 250:  // CMD_MAVLINK_INFO
        return use(Type<sbgc::MavlinkInfoRequest>{}), Code::ok;
      case 251:  // CMD_MAVLINK_DEBUG
        return use(Type<sbgc::MavlinkDebugRequest>{}), Code::ok;
      case 253:  // CMD_DEBUG_VARS_INFO_3
        return use(Type<sbgc::DebugVarsInfo3Request>{}), Code::ok;
      case 254:  // CMD_DEBUG_VARS_3
        return use(Type<sbgc::DebugVars3Request>{}), Code::ok;
      default: return Code::unknown_command;
    }
  }
}

}  // namespace sbgc
