// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Selects the message type of a body, and keeps the context needed to decode it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/messages.hpp>
#include <sbgc/meta.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc {

/// All messages, in the order of the specification's families.
using AllMessages = TypeList<
    msg::BoardInfo,
    msg::BoardInfoRequest,
    msg::BoardInfoRequestOneByte,
    msg::BoardInfoRequestExt,
    msg::Confirm,
    msg::Error,
    msg::ErrorExt,
    msg::BoardInfo3,
    msg::BoardInfo3Request,
    msg::Reset,
    msg::ResetRequest,
    msg::ResetRequestExt,
    msg::BootMode3,
    msg::BootMode3Ext,
    msg::ReadStateVars,
    msg::ReadStateVarsRequest,
    msg::SignMessage,
    msg::SignMessageRequest,
    msg::PassProtectRead,
    msg::PassProtectReadRequest,
    msg::PassProtectWrite,
    msg::QueueParamsInfo3,
    msg::QueueParamsInfo3Request,
    msg::SystemState,
    msg::SystemStateRequest,
    msg::MavlinkInfo,
    msg::MavlinkInfoRequest,
    msg::MavlinkDebug,
    msg::MavlinkDebugRequest,
    msg::ExtLicenseInfo,
    msg::ExtLicenseInfoRequest,
    msg::WriteStateVars,
    msg::ReadParams3,
    msg::ReadParams3Request,
    msg::ReadParams,
    msg::ReadParamsExt,
    msg::ReadParamsExtRequest,
    msg::ReadParamsExt2,
    msg::ReadParamsExt2Request,
    msg::WriteParamsSet,
    msg::ReadProfileNames,
    msg::ReadProfileNamesRequest,
    msg::ProfileSet,
    msg::SaveParams3,
    msg::UseDefaults,
    msg::WriteParams3,
    msg::ReadParamsAnswer,
    msg::WriteParams,
    msg::WriteParamsExt,
    msg::WriteParamsExt2,
    msg::WriteProfileNames,
    msg::ReadParamsExt3,
    msg::ReadParamsExt3Request,
    msg::WriteParamsExt3,
    msg::RealtimeData,
    msg::RealtimeData3,
    msg::RealtimeData3Request,
    msg::RealtimeData4,
    msg::RealtimeData4Request,
    msg::RealtimeDataCustom,
    msg::RealtimeDataCustomRequest,
    msg::RealtimeDataCustom2,
    msg::RealtimeDataCustom2Request,
    msg::DataStreamInterval,
    msg::CanDrvTelemetry,
    msg::CanDrvState,
    msg::CanDrvStateRequest,
    msg::RealtimeDataCanDrv,
    msg::RealtimeDataCanDrvRequest,
    msg::Control,
    msg::ControlExt,
    msg::ControlExtCommand,
    msg::ControlConfig,
    msg::ControlQuatDisabled,
    msg::ControlQuatSpeed,
    msg::ControlQuatAttitude,
    msg::ControlQuatAttitudePacked,
    msg::ControlQuatSpeedAttitude,
    msg::ControlQuatSpeedAttitudePacked,
    msg::ControlQuatStatus,
    msg::ControlQuatStatusRequest,
    msg::ControlQuatConfig,
    msg::GetAngles,
    msg::GetAnglesRequest,
    msg::GetAnglesExt,
    msg::GetAnglesExtRequest,
    msg::MotorsOn,
    msg::MotorsOff,
    msg::MotorsOffExt,
    msg::SyncMotors,
    msg::Event,
    msg::ExecuteMenu,
    msg::ExecuteMenuExt,
    msg::HelperData,
    msg::HelperDataExt,
    msg::ExtMotorsAction,
    msg::ExtMotorsControl,
    msg::ExtMotorsControlConfig,
    msg::ExtMotorsState,
    msg::ExtMotorsStateRequest,
    msg::CalibAcc,
    msg::CalibAccExt,
    msg::CalibGyro,
    msg::CalibGyroExt,
    msg::CalibMag,
    msg::CalibMagExt,
    msg::CalibExtGain,
    msg::CalibPoles,
    msg::CalibOffset,
    msg::CalibBat,
    msg::CalibInfo,
    msg::CalibInfoRequest,
    msg::CalibMotorMagLink,
    msg::CalibMotorMagLinkRequest,
    msg::EncodersCalibOffset4,
    msg::EncodersCalibFldOffset4,
    msg::AutoPid,
    msg::AutoPidRequest,
    msg::AutoPid2,
    msg::CalibOrientCorr,
    msg::CalibCogging,
    msg::CalibAccExtRef,
    msg::BodeTestStartStop,
    msg::BodeTestStartStopRequest,
    msg::BodeTestData,
    msg::CoggingCalibInfo,
    msg::CoggingCalibInfoRequest,
    msg::CanDrvHardParams,
    msg::CanDrvHardParamsRequest,
    msg::CanDrvCalibrate,
    msg::CanDrvCalibrateRequest,
    msg::CalibEncoderLut,
    msg::CalibEncoderLutRequest,
    msg::CalibEncoderLutRes,
    msg::CalibEncoderLutResRequest,
    msg::CalibCurSens,
    msg::CalibCurSensRequest,
    msg::EncIntCalib,
    msg::EncIntCalibRequest,
    msg::VibrationTestStartStop,
    msg::VibrationTestStartStopRequest,
    msg::VibrationTestData,
    msg::VibrationTestDataRequest,
    msg::SelectImu3,
    msg::SelectImu3Ext,
    msg::SelectImu3CalibrateShort,
    msg::SelectImu3Calibrate,
    msg::AhrsHelper,
    msg::AhrsHelperRequest,
    msg::AhrsHelperRequestWide,
    msg::AhrsHelperRequestExt,
    msg::AhrsHelperRequestExtWide,
    msg::GyroCorrection,
    msg::ExtImuDebugInfo,
    msg::ExtImuDebugInfoRequest,
    msg::ExtImuCmd,
    msg::ExtSensCmd,
    msg::ExtSensCmdRequest,
    msg::ImuAdvancedCalib,
    msg::ImuAdvancedCalibRequest,
    msg::BeepSound,
    msg::TriggerPin,
    msg::ServoOut,
    msg::ServoOutFour,
    msg::ServoOutExt,
    msg::I2cWriteRegBuf,
    msg::I2cReadRegBuf,
    msg::I2cReadRegBufRequest,
    msg::I2cReadRegBufRequestNoRegister,
    msg::I2cReadRegBufRequestWideRegister,
    msg::ApiVirtChControl,
    msg::ApiVirtChHighRes,
    msg::ReadRcInputs,
    msg::ReadRcInputsRequest,
    msg::ModuleList,
    msg::ModuleListRequest,
    msg::CanDeviceScan,
    msg::CanDeviceScanRequest,
    msg::TransparentSapi,
    msg::TransparentSapiRequest,
    msg::ModuleFlashStart,
    msg::ModuleFlashWrite,
    msg::ModuleFlashFinish,
    msg::UdrvDeviceScan,
    msg::SetTranspProxy,
    msg::UartBypass,
    msg::UartBypassRequest,
    msg::SetDeviceAddr,
    msg::SetDeviceAddrRequest,
    msg::SerialProxy,
    msg::SerialProxyRequest,
    msg::SetAdjVarsVal,
    msg::GetAdjVarsVal,
    msg::ReadAdjVarsCfg,
    msg::ReadAdjVarsCfgRequest,
    msg::AdjVarsState,
    msg::AdjVarsStateExt,
    msg::AdjVarsStateRequest,
    msg::AdjVarsStateRequestExt,
    msg::AdjVarsInfo,
    msg::AdjVarsInfoRequest,
    msg::AdjVarsInfoRequestAll,
    msg::SetAdjVarsValF,
    msg::GetAdjVarsValF,
    msg::WriteAdjVarsCfg,
    msg::EepromWrite,
    msg::ReadFile,
    msg::ReadFileError,
    msg::ReadFileRequest,
    msg::WriteFile,
    msg::FsClearAll,
    msg::EepromRead,
    msg::EepromReadRequest,
    msg::ReadExternalData,
    msg::ReadExternalDataRequest,
    msg::WriteExternalData,
    msg::RunScript,
    msg::ScriptDebug,
    msg::DebugVarsInfo3,
    msg::DebugVarsInfo3Request,
    msg::DebugVars3,
    msg::DebugVars3Request,
    msg::DebugVars3RequestSelected,
    msg::SetDebugPort,
    msg::SetDebugPortRequest>;

/// Facts from earlier messages of a conversation that later bodies need for decoding.
struct Contexts {
  msg::RealtimeDataCustom::Context realtime_data_custom{};
  msg::RealtimeDataCustom2::Context realtime_data_custom2{};
  msg::CanDrvTelemetry::Context can_drv_telemetry{};
  msg::DebugVars3::Context debug_vars3{};
  /// The form of CMD_ADJ_VARS_STATE that the last request asked for; `only` if there was none.
  Form adj_vars_state_form = Form::only;

  constexpr const msg::RealtimeDataCustom::Context& of(const msg::RealtimeDataCustom&) const noexcept {
    return realtime_data_custom;
  }
  constexpr const msg::RealtimeDataCustom2::Context& of(const msg::RealtimeDataCustom2&) const noexcept {
    return realtime_data_custom2;
  }
  constexpr const msg::CanDrvTelemetry::Context& of(const msg::CanDrvTelemetry&) const noexcept {
    return can_drv_telemetry;
  }
  constexpr const msg::DebugVars3::Context& of(const msg::DebugVars3&) const noexcept {
    return debug_vars3;
  }
  constexpr void learn(const msg::RealtimeDataCustomRequest& message) noexcept {
    detail::learn(message.flags, realtime_data_custom.flags);
  }
  constexpr void learn(const msg::DataStreamInterval& message) noexcept {
    detail::learn(message.config.flags, realtime_data_custom.flags);
    detail::learn(message.config.custom2_flags, realtime_data_custom2.flags);
    detail::learn(message.config.telemetry_flags, can_drv_telemetry.flags);
  }
  constexpr void learn(const msg::RealtimeDataCustom2Request& message) noexcept {
    detail::learn(message.flags, realtime_data_custom2.flags);
  }
  constexpr void learn(const msg::DebugVarsInfo3& message) noexcept {
    debug_vars3.types.clear();
    for (const auto& item : message.vars) {
      const NumberType type = number_type(item.var_type.kind());
      if (!detail::announce(debug_vars3.types, type, item.arr_size)) break;
    }
  }
  constexpr void learn(const msg::AdjVarsStateRequest&) noexcept {
    adj_vars_state_form = Form::simple;
  }
  constexpr void learn(const msg::AdjVarsStateRequestExt&) noexcept {
    adj_vars_state_form = Form::extended;
  }
  /// Stores the facts of a message that later ones need. Most messages have none.
  template <class M>
  constexpr void learn(const M&) noexcept {}

  /// True if learn() stores facts of an M.
  template <class M>
  static constexpr bool learns_from =
      std::is_same_v<M, msg::RealtimeDataCustomRequest> ||
      std::is_same_v<M, msg::DataStreamInterval> ||
      std::is_same_v<M, msg::RealtimeDataCustom2Request> ||
      std::is_same_v<M, msg::DebugVarsInfo3> ||
      std::is_same_v<M, msg::AdjVarsStateRequest> ||
      std::is_same_v<M, msg::AdjVarsStateRequestExt>;
};

/// The other messages that a body of an M may be: the request decides. Most messages have none.
template <class M>
struct OtherForms {
  using Types = TypeList<>;
};
template <>
struct OtherForms<msg::AdjVarsState> {
  using Types = TypeList<msg::AdjVarsStateExt>;
  static constexpr auto asked = &Contexts::adj_vars_state_form;
};
template <>
struct OtherForms<msg::AdjVarsStateExt> {
  using Types = TypeList<msg::AdjVarsState>;
  static constexpr auto asked = &Contexts::adj_vars_state_form;
};

namespace detail {
inline constexpr Contexts nothing_known{};

/// True if the request decides which message a body of an M is.
template <class M>
concept IsAsked = requires { OtherForms<M>::asked; };
}  // namespace detail

/// Calls `use(Type<M>{})` with the message type M of a body of `size` bytes. Selects the form that
/// matches the size, and of several the one that the last request asked for; if the command has only
/// one, selects it for any size, so that decode() can report a wrong one. Returns ok, unknown_command
/// or unknown_form.
template <class Use>
constexpr Code select(Direction direction, std::uint8_t id, [[maybe_unused]] std::size_t size,
                      Use&& use,
                      [[maybe_unused]] const Contexts& contexts = detail::nothing_known) {
  if (direction == Direction::from_board) {
    switch (id) {
      case 20:  // CMD_BOARD_INFO_3
        return use(Type<msg::BoardInfo3>{}), Code::ok;
      case 21:  // CMD_READ_PARAMS_3
        return use(Type<msg::ReadParams3>{}), Code::ok;
      case 23:  // CMD_REALTIME_DATA_3
        return use(Type<msg::RealtimeData3>{}), Code::ok;
      case 25:  // CMD_REALTIME_DATA_4
        return use(Type<msg::RealtimeData4>{}), Code::ok;
      case 28:  // CMD_READ_PROFILE_NAMES
        return use(Type<msg::ReadProfileNames>{}), Code::ok;
      case 30:  // CMD_QUEUE_PARAMS_INFO_3
        return use(Type<msg::QueueParamsInfo3>{}), Code::ok;
      case 31:  // CMD_SET_ADJ_VARS_VAL
        return use(Type<msg::SetAdjVarsVal>{}), Code::ok;
      case 33:  // CMD_READ_PARAMS_EXT
        return use(Type<msg::ReadParamsExt>{}), Code::ok;
      case 35:  // CMD_AUTO_PID
        return use(Type<msg::AutoPid>{}), Code::ok;
      case 37:  // CMD_BODE_TEST_START_STOP
        return use(Type<msg::BodeTestStartStop>{}), Code::ok;
      case 38:  // CMD_BODE_TEST_DATA
        return use(Type<msg::BodeTestData>{}), Code::ok;
      case 40:  // CMD_I2C_READ_REG_BUF
        return use(Type<msg::I2cReadRegBuf>{}), Code::ok;
      case 42:  // CMD_READ_EXTERNAL_DATA
        return use(Type<msg::ReadExternalData>{}), Code::ok;
      case 43:  // CMD_READ_ADJ_VARS_CFG
        return use(Type<msg::ReadAdjVarsCfg>{}), Code::ok;
      case 46:  // CMD_ADJ_VARS_STATE
        if (contexts.adj_vars_state_form == Form::extended && size >= 15) return use(Type<msg::AdjVarsStateExt>{}), Code::ok;
        if (size >= 15) return use(Type<msg::AdjVarsState>{}), Code::ok;
        return Code::unknown_form;
      case 48:  // CMD_EEPROM_READ
        return use(Type<msg::EepromRead>{}), Code::ok;
      case 49:  // CMD_CALIB_INFO
        return use(Type<msg::CalibInfo>{}), Code::ok;
      case 50:  // CMD_SIGN_MESSAGE
        return use(Type<msg::SignMessage>{}), Code::ok;
      case 52:  // CMD_SYSTEM_STATE
        return use(Type<msg::SystemState>{}), Code::ok;
      case 53:  // CMD_READ_FILE
        if (size == 1) return use(Type<msg::ReadFileError>{}), Code::ok;
        if (size >= 4) return use(Type<msg::ReadFile>{}), Code::ok;
        return Code::unknown_form;
      case 56:  // CMD_AHRS_HELPER
        return use(Type<msg::AhrsHelper>{}), Code::ok;
      case 58:  // CMD_SCRIPT_DEBUG
        return use(Type<msg::ScriptDebug>{}), Code::ok;
      case 60:  // CMD_UART_BYPASS
        return use(Type<msg::UartBypass>{}), Code::ok;
      case 61:  // CMD_GET_ANGLES_EXT
        return use(Type<msg::GetAnglesExt>{}), Code::ok;
      case 62:  // CMD_READ_PARAMS_EXT2
        return use(Type<msg::ReadParamsExt2>{}), Code::ok;
      case 67:  // CMD_CONFIRM
        return use(Type<msg::Confirm>{}), Code::ok;
      case 73:  // CMD_GET_ANGLES
        return use(Type<msg::GetAngles>{}), Code::ok;
      case 74:  // CMD_CALIB_MOTOR_MAG_LINK
        return use(Type<msg::CalibMotorMagLink>{}), Code::ok;
      case 76:  // CMD_MODULE_LIST
        return use(Type<msg::ModuleList>{}), Code::ok;
      case 82:  // CMD_READ_PARAMS
        return use(Type<msg::ReadParamsAnswer>{}), Code::ok;
      case 86:  // CMD_BOARD_INFO
        return use(Type<msg::BoardInfo>{}), Code::ok;
      case 88:  // CMD_REALTIME_DATA_CUSTOM
        return use(Type<msg::RealtimeDataCustom>{}), Code::ok;
      case 92:  // CMD_COGGING_CALIB_INFO
        return use(Type<msg::CoggingCalibInfo>{}), Code::ok;
      case 96:  // CMD_CAN_DEVICE_SCAN
        return use(Type<msg::CanDeviceScan>{}), Code::ok;
      case 97:  // CMD_CAN_DRV_HARD_PARAMS
        return use(Type<msg::CanDrvHardParams>{}), Code::ok;
      case 98:  // CMD_CAN_DRV_STATE
        return use(Type<msg::CanDrvState>{}), Code::ok;
      case 99:  // CMD_CAN_DRV_CALIBRATE
        return use(Type<msg::CanDrvCalibrate>{}), Code::ok;
      case 100:  // CMD_READ_RC_INPUTS
        return use(Type<msg::ReadRcInputs>{}), Code::ok;
      case 101:  // CMD_REALTIME_DATA_CAN_DRV
        return use(Type<msg::RealtimeDataCanDrv>{}), Code::ok;
      case 102:  // CMD_EVENT
        return use(Type<msg::Event>{}), Code::ok;
      case 104:  // CMD_READ_PARAMS_EXT3
        return use(Type<msg::ReadParamsExt3>{}), Code::ok;
      case 106:  // CMD_EXT_IMU_DEBUG_INFO
        return use(Type<msg::ExtImuDebugInfo>{}), Code::ok;
      case 107:  // CMD_SET_DEVICE_ADDR
        return use(Type<msg::SetDeviceAddr>{}), Code::ok;
      case 110:  // CMD_EXT_IMU_CMD
        return use(Type<msg::ExtImuCmd>{}), Code::ok;
      case 111:  // CMD_READ_STATE_VARS
        return use(Type<msg::ReadStateVars>{}), Code::ok;
      case 113:  // CMD_SERIAL_PROXY
        return use(Type<msg::SerialProxy>{}), Code::ok;
      case 114:  // CMD_RESET
        return use(Type<msg::Reset>{}), Code::ok;
      case 115:  // CMD_IMU_ADVANCED_CALIB
        return use(Type<msg::ImuAdvancedCalib>{}), Code::ok;
      case 117:  // CMD_CALIB_ENCODER_LUT
        return use(Type<msg::CalibEncoderLut>{}), Code::ok;
      case 118:  // CMD_CALIB_ENCODER_LUT_RES
        return use(Type<msg::CalibEncoderLutRes>{}), Code::ok;
      case 120:  // CMD_CALIB_CUR_SENS
        return use(Type<msg::CalibCurSens>{}), Code::ok;
      case 122:  // CMD_ENC_INT_CALIB
        return use(Type<msg::EncIntCalib>{}), Code::ok;
      case 124:  // CMD_EXT_LICENSE_INFO
        return use(Type<msg::ExtLicenseInfo>{}), Code::ok;
      case 125:  // CMD_VIBRATION_TEST_START_STOP
        return use(Type<msg::VibrationTestStartStop>{}), Code::ok;
      case 126:  // CMD_VIBRATION_TEST_DATA
        return use(Type<msg::VibrationTestData>{}), Code::ok;
      case 127:  // CMD_CAN_DRV_TELEMETRY
        return use(Type<msg::CanDrvTelemetry>{}), Code::ok;
      case 131:  // CMD_EXT_MOTORS_STATE
        return use(Type<msg::ExtMotorsState>{}), Code::ok;
      case 132:  // CMD_ADJ_VARS_INFO
        return use(Type<msg::AdjVarsInfo>{}), Code::ok;
      case 134:  // CMD_SET_ADJ_VARS_VAL_F
        return use(Type<msg::SetAdjVarsValF>{}), Code::ok;
      case 136:  // CMD_PASS_PROTECT_READ
        return use(Type<msg::PassProtectRead>{}), Code::ok;
      case 139:  // CMD_REALTIME_DATA_CUSTOM2
        return use(Type<msg::RealtimeDataCustom2>{}), Code::ok;
      case 141:  // CMD_CONTROL_QUAT_STATUS
        return use(Type<msg::ControlQuatStatus>{}), Code::ok;
      case 150:  // CMD_EXT_SENS_CMD
        return use(Type<msg::ExtSensCmd>{}), Code::ok;
      case 151:  // CMD_TRANSPARENT_SAPI
        return use(Type<msg::TransparentSapi>{}), Code::ok;
      case 249:  // CMD_SET_DEBUG_PORT
        return use(Type<msg::SetDebugPort>{}), Code::ok;
      case 250:  // CMD_MAVLINK_INFO
        return use(Type<msg::MavlinkInfo>{}), Code::ok;
      case 251:  // CMD_MAVLINK_DEBUG
        return use(Type<msg::MavlinkDebug>{}), Code::ok;
      case 253:  // CMD_DEBUG_VARS_INFO_3
        return use(Type<msg::DebugVarsInfo3>{}), Code::ok;
      case 254:  // CMD_DEBUG_VARS_3
        return use(Type<msg::DebugVars3>{}), Code::ok;
      case 255:  // CMD_ERROR
        if (size == 5) return use(Type<msg::Error>{}), Code::ok;
        if (size >= 6) return use(Type<msg::ErrorExt>{}), Code::ok;
        return Code::unknown_form;
      default: return Code::unknown_command;
    }
  } else {
    switch (id) {
      case 20:  // CMD_BOARD_INFO_3
        return use(Type<msg::BoardInfo3Request>{}), Code::ok;
      case 21:  // CMD_READ_PARAMS_3
        return use(Type<msg::ReadParams3Request>{}), Code::ok;
      case 22:  // CMD_WRITE_PARAMS_3
        return use(Type<msg::WriteParams3>{}), Code::ok;
      case 23:  // CMD_REALTIME_DATA_3
        return use(Type<msg::RealtimeData3Request>{}), Code::ok;
      case 24:  // CMD_SELECT_IMU_3
        if (size == 1) return use(Type<msg::SelectImu3>{}), Code::ok;
        if (size >= 2 && size <= 10) return use(Type<msg::SelectImu3Ext>{}), Code::ok;
        if (size == 11) return use(Type<msg::SelectImu3CalibrateShort>{}), Code::ok;
        if (size == 12) return use(Type<msg::SelectImu3Calibrate>{}), Code::ok;
        return Code::unknown_form;
      case 25:  // CMD_REALTIME_DATA_4
        return use(Type<msg::RealtimeData4Request>{}), Code::ok;
      case 26:  // CMD_ENCODERS_CALIB_OFFSET_4
        return use(Type<msg::EncodersCalibOffset4>{}), Code::ok;
      case 27:  // CMD_ENCODERS_CALIB_FLD_OFFSET_4
        return use(Type<msg::EncodersCalibFldOffset4>{}), Code::ok;
      case 28:  // CMD_READ_PROFILE_NAMES
        return use(Type<msg::ReadProfileNamesRequest>{}), Code::ok;
      case 29:  // CMD_WRITE_PROFILE_NAMES
        return use(Type<msg::WriteProfileNames>{}), Code::ok;
      case 30:  // CMD_QUEUE_PARAMS_INFO_3
        return use(Type<msg::QueueParamsInfo3Request>{}), Code::ok;
      case 31:  // CMD_SET_ADJ_VARS_VAL
        return use(Type<msg::SetAdjVarsVal>{}), Code::ok;
      case 32:  // CMD_SAVE_PARAMS_3
        return use(Type<msg::SaveParams3>{}), Code::ok;
      case 33:  // CMD_READ_PARAMS_EXT
        return use(Type<msg::ReadParamsExtRequest>{}), Code::ok;
      case 34:  // CMD_WRITE_PARAMS_EXT
        return use(Type<msg::WriteParamsExt>{}), Code::ok;
      case 35:  // CMD_AUTO_PID
        return use(Type<msg::AutoPidRequest>{}), Code::ok;
      case 36:  // CMD_SERVO_OUT
        if (size == 8) return use(Type<msg::ServoOutFour>{}), Code::ok;
        if (size == 16) return use(Type<msg::ServoOut>{}), Code::ok;
        return Code::unknown_form;
      case 37:  // CMD_BODE_TEST_START_STOP
        return use(Type<msg::BodeTestStartStopRequest>{}), Code::ok;
      case 39:  // CMD_I2C_WRITE_REG_BUF
        return use(Type<msg::I2cWriteRegBuf>{}), Code::ok;
      case 40:  // CMD_I2C_READ_REG_BUF
        if (size == 2) return use(Type<msg::I2cReadRegBufRequestNoRegister>{}), Code::ok;
        if (size == 3) return use(Type<msg::I2cReadRegBufRequest>{}), Code::ok;
        if (size == 4) return use(Type<msg::I2cReadRegBufRequestWideRegister>{}), Code::ok;
        return Code::unknown_form;
      case 41:  // CMD_WRITE_EXTERNAL_DATA
        return use(Type<msg::WriteExternalData>{}), Code::ok;
      case 42:  // CMD_READ_EXTERNAL_DATA
        return use(Type<msg::ReadExternalDataRequest>{}), Code::ok;
      case 43:  // CMD_READ_ADJ_VARS_CFG
        return use(Type<msg::ReadAdjVarsCfgRequest>{}), Code::ok;
      case 44:  // CMD_WRITE_ADJ_VARS_CFG
        return use(Type<msg::WriteAdjVarsCfg>{}), Code::ok;
      case 45:  // CMD_API_VIRT_CH_CONTROL
        return use(Type<msg::ApiVirtChControl>{}), Code::ok;
      case 46:  // CMD_ADJ_VARS_STATE
        if (size == 2) return use(Type<msg::AdjVarsStateRequest>{}), Code::ok;
        if (size == 7) return use(Type<msg::AdjVarsStateRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 47:  // CMD_EEPROM_WRITE
        return use(Type<msg::EepromWrite>{}), Code::ok;
      case 48:  // CMD_EEPROM_READ
        return use(Type<msg::EepromReadRequest>{}), Code::ok;
      case 49:  // CMD_CALIB_INFO
        return use(Type<msg::CalibInfoRequest>{}), Code::ok;
      case 50:  // CMD_SIGN_MESSAGE
        return use(Type<msg::SignMessageRequest>{}), Code::ok;
      case 51:  // CMD_BOOT_MODE_3
        if (size == 0) return use(Type<msg::BootMode3>{}), Code::ok;
        if (size == 3) return use(Type<msg::BootMode3Ext>{}), Code::ok;
        return Code::unknown_form;
      case 52:  // CMD_SYSTEM_STATE
        return use(Type<msg::SystemStateRequest>{}), Code::ok;
      case 53:  // CMD_READ_FILE
        return use(Type<msg::ReadFileRequest>{}), Code::ok;
      case 54:  // CMD_WRITE_FILE
        return use(Type<msg::WriteFile>{}), Code::ok;
      case 55:  // CMD_FS_CLEAR_ALL
        return use(Type<msg::FsClearAll>{}), Code::ok;
      case 56:  // CMD_AHRS_HELPER
        if (size == 1) return use(Type<msg::AhrsHelperRequest>{}), Code::ok;
        if (size == 2) return use(Type<msg::AhrsHelperRequestWide>{}), Code::ok;
        if (size == 25) return use(Type<msg::AhrsHelperRequestExt>{}), Code::ok;
        if (size == 26) return use(Type<msg::AhrsHelperRequestExtWide>{}), Code::ok;
        return Code::unknown_form;
      case 57:  // CMD_RUN_SCRIPT
        return use(Type<msg::RunScript>{}), Code::ok;
      case 59:  // CMD_CALIB_MAG
        if (size == 0) return use(Type<msg::CalibMag>{}), Code::ok;
        if (size == 12) return use(Type<msg::CalibMagExt>{}), Code::ok;
        return Code::unknown_form;
      case 60:  // CMD_UART_BYPASS
        return use(Type<msg::UartBypassRequest>{}), Code::ok;
      case 61:  // CMD_GET_ANGLES_EXT
        return use(Type<msg::GetAnglesExtRequest>{}), Code::ok;
      case 62:  // CMD_READ_PARAMS_EXT2
        return use(Type<msg::ReadParamsExt2Request>{}), Code::ok;
      case 63:  // CMD_WRITE_PARAMS_EXT2
        return use(Type<msg::WriteParamsExt2>{}), Code::ok;
      case 64:  // CMD_GET_ADJ_VARS_VAL
        return use(Type<msg::GetAdjVarsVal>{}), Code::ok;
      case 65:  // CMD_CALIB_ACC
        if (size == 0) return use(Type<msg::CalibAcc>{}), Code::ok;
        if (size == 12) return use(Type<msg::CalibAccExt>{}), Code::ok;
        return Code::unknown_form;
      case 66:  // CMD_CALIB_BAT
        return use(Type<msg::CalibBat>{}), Code::ok;
      case 67:  // CMD_CONTROL
        if (size == 13) return use(Type<msg::Control>{}), Code::ok;
        if (size == 15) return use(Type<msg::ControlExt>{}), Code::ok;
        return Code::unknown_form;
      case 68:  // CMD_REALTIME_DATA
        return use(Type<msg::RealtimeData>{}), Code::ok;
      case 69:  // CMD_EXECUTE_MENU
        if (size == 1) return use(Type<msg::ExecuteMenu>{}), Code::ok;
        if (size == 2) return use(Type<msg::ExecuteMenuExt>{}), Code::ok;
        return Code::unknown_form;
      case 70:  // CMD_USE_DEFAULTS
        return use(Type<msg::UseDefaults>{}), Code::ok;
      case 71:  // CMD_CALIB_EXT_GAIN
        return use(Type<msg::CalibExtGain>{}), Code::ok;
      case 72:  // CMD_HELPER_DATA
        if (size == 10) return use(Type<msg::HelperData>{}), Code::ok;
        if (size == 20) return use(Type<msg::HelperDataExt>{}), Code::ok;
        return Code::unknown_form;
      case 73:  // CMD_GET_ANGLES
        return use(Type<msg::GetAnglesRequest>{}), Code::ok;
      case 74:  // CMD_CALIB_MOTOR_MAG_LINK
        return use(Type<msg::CalibMotorMagLinkRequest>{}), Code::ok;
      case 75:  // CMD_GYRO_CORRECTION
        return use(Type<msg::GyroCorrection>{}), Code::ok;
      case 76:  // CMD_MODULE_LIST
        return use(Type<msg::ModuleListRequest>{}), Code::ok;
      case 77:  // CMD_MOTORS_ON
        return use(Type<msg::MotorsOn>{}), Code::ok;
      case 78:  // CMD_MODULE_FLASH_START
        return use(Type<msg::ModuleFlashStart>{}), Code::ok;
      case 79:  // CMD_CALIB_OFFSET
        return use(Type<msg::CalibOffset>{}), Code::ok;
      case 80:  // CMD_CALIB_POLES
        return use(Type<msg::CalibPoles>{}), Code::ok;
      case 81:  // CMD_MODULE_FLASH_WRITE
        return use(Type<msg::ModuleFlashWrite>{}), Code::ok;
      case 82:  // CMD_READ_PARAMS
        return use(Type<msg::ReadParams>{}), Code::ok;
      case 83:  // CMD_MODULE_FLASH_FINISH
        return use(Type<msg::ModuleFlashFinish>{}), Code::ok;
      case 84:  // CMD_TRIGGER_PIN
        return use(Type<msg::TriggerPin>{}), Code::ok;
      case 85:  // CMD_DATA_STREAM_INTERVAL
        return use(Type<msg::DataStreamInterval>{}), Code::ok;
      case 86:  // CMD_BOARD_INFO
        if (size == 0) return use(Type<msg::BoardInfoRequest>{}), Code::ok;
        if (size == 1) return use(Type<msg::BoardInfoRequestOneByte>{}), Code::ok;
        if (size >= 2) return use(Type<msg::BoardInfoRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 87:  // CMD_WRITE_PARAMS
        return use(Type<msg::WriteParams>{}), Code::ok;
      case 88:  // CMD_REALTIME_DATA_CUSTOM
        return use(Type<msg::RealtimeDataCustomRequest>{}), Code::ok;
      case 89:  // CMD_BEEP_SOUND
        return use(Type<msg::BeepSound>{}), Code::ok;
      case 90:  // CMD_CONTROL_CONFIG
        return use(Type<msg::ControlConfig>{}), Code::ok;
      case 91:  // CMD_CALIB_ORIENT_CORR
        return use(Type<msg::CalibOrientCorr>{}), Code::ok;
      case 92:  // CMD_COGGING_CALIB_INFO
        return use(Type<msg::CoggingCalibInfoRequest>{}), Code::ok;
      case 93:  // CMD_CALIB_COGGING
        return use(Type<msg::CalibCogging>{}), Code::ok;
      case 94:  // CMD_CALIB_ACC_EXT_REF
        return use(Type<msg::CalibAccExtRef>{}), Code::ok;
      case 95:  // CMD_PROFILE_SET
        return use(Type<msg::ProfileSet>{}), Code::ok;
      case 96:  // CMD_CAN_DEVICE_SCAN
        return use(Type<msg::CanDeviceScanRequest>{}), Code::ok;
      case 97:  // CMD_CAN_DRV_HARD_PARAMS
        return use(Type<msg::CanDrvHardParamsRequest>{}), Code::ok;
      case 98:  // CMD_CAN_DRV_STATE
        return use(Type<msg::CanDrvStateRequest>{}), Code::ok;
      case 99:  // CMD_CAN_DRV_CALIBRATE
        return use(Type<msg::CanDrvCalibrateRequest>{}), Code::ok;
      case 100:  // CMD_READ_RC_INPUTS
        return use(Type<msg::ReadRcInputsRequest>{}), Code::ok;
      case 101:  // CMD_REALTIME_DATA_CAN_DRV
        return use(Type<msg::RealtimeDataCanDrvRequest>{}), Code::ok;
      case 103:  // CMD_CALIB_GYRO
        if (size == 0) return use(Type<msg::CalibGyro>{}), Code::ok;
        if (size == 12) return use(Type<msg::CalibGyroExt>{}), Code::ok;
        return Code::unknown_form;
      case 104:  // CMD_READ_PARAMS_EXT3
        return use(Type<msg::ReadParamsExt3Request>{}), Code::ok;
      case 105:  // CMD_WRITE_PARAMS_EXT3
        return use(Type<msg::WriteParamsExt3>{}), Code::ok;
      case 106:  // CMD_EXT_IMU_DEBUG_INFO
        return use(Type<msg::ExtImuDebugInfoRequest>{}), Code::ok;
      case 107:  // CMD_SET_DEVICE_ADDR
        return use(Type<msg::SetDeviceAddrRequest>{}), Code::ok;
      case 108:  // CMD_AUTO_PID2
        return use(Type<msg::AutoPid2>{}), Code::ok;
      case 109:  // CMD_MOTORS_OFF
        if (size == 0) return use(Type<msg::MotorsOff>{}), Code::ok;
        if (size == 1) return use(Type<msg::MotorsOffExt>{}), Code::ok;
        return Code::unknown_form;
      case 110:  // CMD_EXT_IMU_CMD
        return use(Type<msg::ExtImuCmd>{}), Code::ok;
      case 111:  // CMD_READ_STATE_VARS
        return use(Type<msg::ReadStateVarsRequest>{}), Code::ok;
      case 112:  // CMD_WRITE_STATE_VARS
        return use(Type<msg::WriteStateVars>{}), Code::ok;
      case 113:  // CMD_SERIAL_PROXY
        return use(Type<msg::SerialProxyRequest>{}), Code::ok;
      case 114:  // CMD_RESET
        if (size == 0) return use(Type<msg::ResetRequest>{}), Code::ok;
        if (size == 3) return use(Type<msg::ResetRequestExt>{}), Code::ok;
        return Code::unknown_form;
      case 115:  // CMD_IMU_ADVANCED_CALIB
        return use(Type<msg::ImuAdvancedCalibRequest>{}), Code::ok;
      case 116:  // CMD_API_VIRT_CH_HIGH_RES
        return use(Type<msg::ApiVirtChHighRes>{}), Code::ok;
      case 117:  // CMD_CALIB_ENCODER_LUT
        return use(Type<msg::CalibEncoderLutRequest>{}), Code::ok;
      case 118:  // CMD_CALIB_ENCODER_LUT_RES
        return use(Type<msg::CalibEncoderLutResRequest>{}), Code::ok;
      case 119:  // CMD_WRITE_PARAMS_SET
        return use(Type<msg::WriteParamsSet>{}), Code::ok;
      case 120:  // CMD_CALIB_CUR_SENS
        return use(Type<msg::CalibCurSensRequest>{}), Code::ok;
      case 121:  // CMD_CONTROL_EXT
        return use(Type<msg::ControlExtCommand>{}), Code::ok;
      case 122:  // CMD_ENC_INT_CALIB
        return use(Type<msg::EncIntCalibRequest>{}), Code::ok;
      case 123:  // CMD_SYNC_MOTORS
        return use(Type<msg::SyncMotors>{}), Code::ok;
      case 124:  // CMD_EXT_LICENSE_INFO
        return use(Type<msg::ExtLicenseInfoRequest>{}), Code::ok;
      case 125:  // CMD_VIBRATION_TEST_START_STOP
        return use(Type<msg::VibrationTestStartStopRequest>{}), Code::ok;
      case 126:  // CMD_VIBRATION_TEST_DATA
        return use(Type<msg::VibrationTestDataRequest>{}), Code::ok;
      case 128:  // CMD_EXT_MOTORS_ACTION
        return use(Type<msg::ExtMotorsAction>{}), Code::ok;
      case 129:  // CMD_EXT_MOTORS_CONTROL
        return use(Type<msg::ExtMotorsControl>{}), Code::ok;
      case 130:  // CMD_EXT_MOTORS_CONTROL_CONFIG
        return use(Type<msg::ExtMotorsControlConfig>{}), Code::ok;
      case 131:  // CMD_EXT_MOTORS_STATE
        return use(Type<msg::ExtMotorsStateRequest>{}), Code::ok;
      case 132:  // CMD_ADJ_VARS_INFO
        if (size == 0) return use(Type<msg::AdjVarsInfoRequestAll>{}), Code::ok;
        if (size == 1) return use(Type<msg::AdjVarsInfoRequest>{}), Code::ok;
        return Code::unknown_form;
      case 133:  // CMD_SERVO_OUT_EXT
        return use(Type<msg::ServoOutExt>{}), Code::ok;
      case 134:  // CMD_SET_ADJ_VARS_VAL_F
        return use(Type<msg::SetAdjVarsValF>{}), Code::ok;
      case 135:  // CMD_GET_ADJ_VARS_VAL_F
        return use(Type<msg::GetAdjVarsValF>{}), Code::ok;
      case 136:  // CMD_PASS_PROTECT_READ
        return use(Type<msg::PassProtectReadRequest>{}), Code::ok;
      case 137:  // CMD_PASS_PROTECT_WRITE
        return use(Type<msg::PassProtectWrite>{}), Code::ok;
      case 139:  // CMD_REALTIME_DATA_CUSTOM2
        return use(Type<msg::RealtimeDataCustom2Request>{}), Code::ok;
      case 140:  // CMD_CONTROL_QUAT
        if (size == 2) return use(Type<msg::ControlQuatDisabled>{}), Code::ok;
        if (size == 10) return use(Type<msg::ControlQuatAttitudePacked>{}), Code::ok;
        if (size == 14) return use(Type<msg::ControlQuatSpeed>{}), Code::ok;
        if (size == 18) return use(Type<msg::ControlQuatAttitude>{}), Code::ok;
        if (size == 22) return use(Type<msg::ControlQuatSpeedAttitudePacked>{}), Code::ok;
        if (size == 30) return use(Type<msg::ControlQuatSpeedAttitude>{}), Code::ok;
        return Code::unknown_form;
      case 141:  // CMD_CONTROL_QUAT_STATUS
        return use(Type<msg::ControlQuatStatusRequest>{}), Code::ok;
      case 142:  // CMD_CONTROL_QUAT_CONFIG
        return use(Type<msg::ControlQuatConfig>{}), Code::ok;
      case 143:  // CMD_SET_TRANSP_PROXY
        return use(Type<msg::SetTranspProxy>{}), Code::ok;
      case 144:  // CMD_UDRV_DEVICE_SCAN
        return use(Type<msg::UdrvDeviceScan>{}), Code::ok;
      case 150:  // CMD_EXT_SENS_CMD
        return use(Type<msg::ExtSensCmdRequest>{}), Code::ok;
      case 151:  // CMD_TRANSPARENT_SAPI
        return use(Type<msg::TransparentSapiRequest>{}), Code::ok;
      case 249:  // CMD_SET_DEBUG_PORT
        return use(Type<msg::SetDebugPortRequest>{}), Code::ok;
      case 250:  // CMD_MAVLINK_INFO
        return use(Type<msg::MavlinkInfoRequest>{}), Code::ok;
      case 251:  // CMD_MAVLINK_DEBUG
        return use(Type<msg::MavlinkDebugRequest>{}), Code::ok;
      case 253:  // CMD_DEBUG_VARS_INFO_3
        return use(Type<msg::DebugVarsInfo3Request>{}), Code::ok;
      case 254:  // CMD_DEBUG_VARS_3
        if (size == 0) return use(Type<msg::DebugVars3Request>{}), Code::ok;
        if (size >= 4) return use(Type<msg::DebugVars3RequestSelected>{}), Code::ok;
        return Code::unknown_form;
      default: return Code::unknown_command;
    }
  }
}

}  // namespace sbgc

#pragma GCC diagnostic pop
