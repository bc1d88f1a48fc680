/// Handlers of the requests that need code of their own, grouped by the family in spec/:
/// device/<family>/handlers.cpp implements them. All other requests are answered from the model
/// alone: parameters/access.hpp reads and writes parameters, default_response.hpp handles the rest.
#pragma once

#include <sbgc/messages.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

/// True if the handler itself decides about values that the firmware does not know.
template <class M>
inline constexpr bool checks_values = false;
/// Pins and states that do not exist are met with silence.
template <>
inline constexpr bool checks_values<msg::TriggerPin> = true;

// adjustable_variables
Verdict handle(RequestContext& context, const msg::GetAdjVarsVal& request);
Verdict handle(RequestContext& context, const msg::SetAdjVarsVal& request);
Verdict handle(RequestContext& context, const msg::AdjVarsStateRequest& request);
Verdict handle(RequestContext& context, const msg::AdjVarsStateRequestExt& request);
Verdict handle(RequestContext& context, const msg::AdjVarsInfoRequest& request);
Verdict handle(RequestContext& context, const msg::AdjVarsInfoRequestAll& request);
Verdict handle(RequestContext& context, const msg::SetAdjVarsValF& request);
Verdict handle(RequestContext& context, const msg::GetAdjVarsValF& request);

// calibration
Verdict handle(RequestContext& context, const msg::CalibAcc& request);
Verdict handle(RequestContext& context, const msg::CalibAccExt& request);
Verdict handle(RequestContext& context, const msg::CalibGyro& request);
Verdict handle(RequestContext& context, const msg::CalibGyroExt& request);
Verdict handle(RequestContext& context, const msg::CalibMag& request);
Verdict handle(RequestContext& context, const msg::CalibExtGain& request);
Verdict handle(RequestContext& context, const msg::CalibPoles& request);
Verdict handle(RequestContext& context, const msg::CalibOffset& request);
Verdict handle(RequestContext& context, const msg::CalibBat& request);
Verdict handle(RequestContext& context, const msg::EncodersCalibOffset4& request);
Verdict handle(RequestContext& context, const msg::EncodersCalibFldOffset4& request);
Verdict handle(RequestContext& context, const msg::CalibInfoRequest& request);
Verdict handle(RequestContext& context, const msg::AutoPidRequest& request);
Verdict handle(RequestContext& context, const msg::CalibMagExt& request);
Verdict handle(RequestContext& context, const msg::CalibOrientCorr& request);
Verdict handle(RequestContext& context, const msg::CalibCogging& request);
Verdict handle(RequestContext& context, const msg::CalibAccExtRef& request);
Verdict handle(RequestContext& context, const msg::AutoPid2& request);

// control
Verdict handle(RequestContext& context, const msg::Control& request);
Verdict handle(RequestContext& context, const msg::ControlExt& request);
Verdict handle(RequestContext& context, const msg::GetAnglesRequest& request);
Verdict handle(RequestContext& context, const msg::GetAnglesExtRequest& request);
Verdict handle(RequestContext& context, const msg::MotorsOn& request);
Verdict handle(RequestContext& context, const msg::MotorsOff& request);
Verdict handle(RequestContext& context, const msg::MotorsOffExt& request);
Verdict handle(RequestContext& context, const msg::ExecuteMenu& request);
Verdict handle(RequestContext& context, const msg::ExecuteMenuExt& request);
Verdict handle(RequestContext& context, const msg::HelperData& request);
Verdict handle(RequestContext& context, const msg::HelperDataExt& request);
Verdict handle(RequestContext& context, const msg::ControlExtCommand& request);
Verdict handle(RequestContext& context, const msg::ControlConfig& request);
Verdict handle(RequestContext& context, const msg::ControlQuatDisabled& request);
Verdict handle(RequestContext& context, const msg::ControlQuatSpeed& request);
Verdict handle(RequestContext& context, const msg::ControlQuatAttitude& request);
Verdict handle(RequestContext& context, const msg::ControlQuatAttitudePacked& request);
Verdict handle(RequestContext& context, const msg::ControlQuatSpeedAttitude& request);
Verdict handle(RequestContext& context, const msg::ControlQuatSpeedAttitudePacked& request);
Verdict handle(RequestContext& context, const msg::ControlQuatStatusRequest& request);
Verdict handle(RequestContext& context, const msg::ControlQuatConfig& request);
Verdict handle(RequestContext& context, const msg::SyncMotors& request);

// debug
Verdict handle(RequestContext& context, const msg::DebugVarsInfo3Request& request);
Verdict handle(RequestContext& context, const msg::DebugVars3Request& request);
Verdict handle(RequestContext& context, const msg::DebugVars3RequestSelected& request);
Verdict handle(RequestContext& context, const msg::SetDebugPortRequest& request);

// external_motors
Verdict handle(RequestContext& context, const msg::ExtMotorsAction& request);
Verdict handle(RequestContext& context, const msg::ExtMotorsControl& request);
Verdict handle(RequestContext& context, const msg::ExtMotorsControlConfig& request);
Verdict handle(RequestContext& context, const msg::ExtMotorsStateRequest& request);

// imu
Verdict handle(RequestContext& context, const msg::SelectImu3& request);
Verdict handle(RequestContext& context, const msg::SelectImu3Ext& request);
Verdict handle(RequestContext& context, const msg::AhrsHelperRequest& request);
Verdict handle(RequestContext& context, const msg::AhrsHelperRequestWide& request);
Verdict handle(RequestContext& context, const msg::AhrsHelperRequestExt& request);
Verdict handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request);
Verdict handle(RequestContext& context, const msg::GyroCorrection& request);
Verdict handle(RequestContext& context, const msg::SelectImu3Calibrate& request);
Verdict handle(RequestContext& context, const msg::ExtImuDebugInfoRequest& request);
Verdict handle(RequestContext& context, const msg::ExtImuCmd& request);
Verdict handle(RequestContext& context, const msg::ExtSensCmdRequest& request);

// modules
Verdict handle(RequestContext& context, const msg::ModuleListRequest& request);
Verdict handle(RequestContext& context, const msg::CanDeviceScanRequest& request);
Verdict handle(RequestContext& context, const msg::TransparentSapiRequest& request);

// parameters
Verdict handle(RequestContext& context, const msg::SaveParams3& request);
Verdict handle(RequestContext& context, const msg::UseDefaults& request);
Verdict handle(RequestContext& context, const msg::WriteParamsSet& request);
Verdict handle(RequestContext& context, const msg::ProfileSet& request);

// peripherals
Verdict handle(RequestContext& context, const msg::TriggerPin& request);
Verdict handle(RequestContext& context, const msg::ServoOut& request);
Verdict handle(RequestContext& context, const msg::BeepSound& request);
Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequest& request);
Verdict handle(RequestContext& context, const msg::I2cWriteRegBuf& request);
Verdict handle(RequestContext& context, const msg::ApiVirtChControl& request);
Verdict handle(RequestContext& context, const msg::ServoOutExt& request);
Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequestNoRegister& request);
Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequestWideRegister& request);
Verdict handle(RequestContext& context, const msg::ApiVirtChHighRes& request);
Verdict handle(RequestContext& context, const msg::ReadRcInputsRequest& request);

// realtime
Verdict handle(RequestContext& context, const msg::RealtimeData& request);
Verdict handle(RequestContext& context, const msg::RealtimeData3Request& request);
Verdict handle(RequestContext& context, const msg::RealtimeData4Request& request);
Verdict handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request);
Verdict handle(RequestContext& context, const msg::DataStreamInterval& request);

// scripting
Verdict handle(RequestContext& context, const msg::RunScript& request);

// storage
Verdict handle(RequestContext& context, const msg::EepromReadRequest& request);
Verdict handle(RequestContext& context, const msg::EepromWrite& request);
Verdict handle(RequestContext& context, const msg::ReadFileRequest& request);
Verdict handle(RequestContext& context, const msg::WriteFile& request);
Verdict handle(RequestContext& context, const msg::FsClearAll& request);

// system
Verdict handle(RequestContext& context, const msg::BoardInfoRequest& request);
Verdict handle(RequestContext& context, const msg::BoardInfoRequestOneByte& request);
Verdict handle(RequestContext& context, const msg::BoardInfoRequestExt& request);
Verdict handle(RequestContext& context, const msg::BoardInfo3Request& request);
Verdict handle(RequestContext& context, const msg::ResetRequest& request);
Verdict handle(RequestContext& context, const msg::ResetRequestExt& request);
Verdict handle(RequestContext& context, const msg::BootMode3& request);
Verdict handle(RequestContext& context, const msg::BootMode3Ext& request);
Verdict handle(RequestContext& context, const msg::ReadStateVarsRequest& request);
Verdict handle(RequestContext& context, const msg::WriteStateVars& request);
Verdict handle(RequestContext& context, const msg::SignMessageRequest& request);

}  // namespace sbgc::emulator
