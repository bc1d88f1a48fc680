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
Outcome handle(RequestContext& context, const msg::GetAdjVarsVal& request);
Outcome handle(RequestContext& context, const msg::SetAdjVarsVal& request);
Outcome handle(RequestContext& context, const msg::AdjVarsStateRequest& request);
Outcome handle(RequestContext& context, const msg::AdjVarsStateRequestExt& request);
Outcome handle(RequestContext& context, const msg::AdjVarsInfoRequest& request);
Outcome handle(RequestContext& context, const msg::AdjVarsInfoRequestAll& request);
Outcome handle(RequestContext& context, const msg::SetAdjVarsValF& request);
Outcome handle(RequestContext& context, const msg::GetAdjVarsValF& request);

// calibration
Outcome handle(RequestContext& context, const msg::CalibAcc& request);
Outcome handle(RequestContext& context, const msg::CalibAccExt& request);
Outcome handle(RequestContext& context, const msg::CalibGyro& request);
Outcome handle(RequestContext& context, const msg::CalibGyroExt& request);
Outcome handle(RequestContext& context, const msg::CalibMag& request);
Outcome handle(RequestContext& context, const msg::CalibExtGain& request);
Outcome handle(RequestContext& context, const msg::CalibPoles& request);
Outcome handle(RequestContext& context, const msg::CalibOffset& request);
Outcome handle(RequestContext& context, const msg::CalibBat& request);
Outcome handle(RequestContext& context, const msg::EncodersCalibOffset4& request);
Outcome handle(RequestContext& context, const msg::EncodersCalibFldOffset4& request);
Outcome handle(RequestContext& context, const msg::CalibInfoRequest& request);
Outcome handle(RequestContext& context, const msg::AutoPidRequest& request);
Outcome handle(RequestContext& context, const msg::CalibMagExt& request);
Outcome handle(RequestContext& context, const msg::CalibOrientCorr& request);
Outcome handle(RequestContext& context, const msg::CalibCogging& request);
Outcome handle(RequestContext& context, const msg::CalibAccExtRef& request);
Outcome handle(RequestContext& context, const msg::AutoPid2& request);

// control
Outcome handle(RequestContext& context, const msg::Control& request);
Outcome handle(RequestContext& context, const msg::ControlExt& request);
Outcome handle(RequestContext& context, const msg::GetAnglesRequest& request);
Outcome handle(RequestContext& context, const msg::GetAnglesExtRequest& request);
Outcome handle(RequestContext& context, const msg::MotorsOn& request);
Outcome handle(RequestContext& context, const msg::MotorsOff& request);
Outcome handle(RequestContext& context, const msg::MotorsOffExt& request);
Outcome handle(RequestContext& context, const msg::ExecuteMenu& request);
Outcome handle(RequestContext& context, const msg::ExecuteMenuExt& request);
Outcome handle(RequestContext& context, const msg::HelperData& request);
Outcome handle(RequestContext& context, const msg::HelperDataExt& request);
Outcome handle(RequestContext& context, const msg::ControlExtCommand& request);
Outcome handle(RequestContext& context, const msg::ControlConfig& request);
Outcome handle(RequestContext& context, const msg::ControlQuatDisabled& request);
Outcome handle(RequestContext& context, const msg::ControlQuatSpeed& request);
Outcome handle(RequestContext& context, const msg::ControlQuatAttitude& request);
Outcome handle(RequestContext& context, const msg::ControlQuatAttitudePacked& request);
Outcome handle(RequestContext& context, const msg::ControlQuatSpeedAttitude& request);
Outcome handle(RequestContext& context, const msg::ControlQuatSpeedAttitudePacked& request);
Outcome handle(RequestContext& context, const msg::ControlQuatStatusRequest& request);
Outcome handle(RequestContext& context, const msg::ControlQuatConfig& request);
Outcome handle(RequestContext& context, const msg::SyncMotors& request);

// debug
Outcome handle(RequestContext& context, const msg::DebugVarsInfo3Request& request);
Outcome handle(RequestContext& context, const msg::DebugVars3Request& request);
Outcome handle(RequestContext& context, const msg::DebugVars3RequestSelected& request);
Outcome handle(RequestContext& context, const msg::SetDebugPortRequest& request);

// external_motors
Outcome handle(RequestContext& context, const msg::ExtMotorsAction& request);
Outcome handle(RequestContext& context, const msg::ExtMotorsControl& request);
Outcome handle(RequestContext& context, const msg::ExtMotorsControlConfig& request);
Outcome handle(RequestContext& context, const msg::ExtMotorsStateRequest& request);

// imu
Outcome handle(RequestContext& context, const msg::SelectImu3& request);
Outcome handle(RequestContext& context, const msg::SelectImu3Ext& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequest& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestWide& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExt& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request);
Outcome handle(RequestContext& context, const msg::GyroCorrection& request);
Outcome handle(RequestContext& context, const msg::SelectImu3Calibrate& request);
Outcome handle(RequestContext& context, const msg::ExtImuDebugInfoRequest& request);
Outcome handle(RequestContext& context, const msg::ExtImuCmd& request);
Outcome handle(RequestContext& context, const msg::ExtSensCmdRequest& request);

// modules
Outcome handle(RequestContext& context, const msg::ModuleListRequest& request);
Outcome handle(RequestContext& context, const msg::CanDeviceScanRequest& request);
Outcome handle(RequestContext& context, const msg::TransparentSapiRequest& request);

// parameters
Outcome handle(RequestContext& context, const msg::SaveParams3& request);
Outcome handle(RequestContext& context, const msg::UseDefaults& request);
Outcome handle(RequestContext& context, const msg::WriteParamsSet& request);
Outcome handle(RequestContext& context, const msg::ProfileSet& request);

// peripherals
Outcome handle(RequestContext& context, const msg::TriggerPin& request);
Outcome handle(RequestContext& context, const msg::ServoOut& request);
Outcome handle(RequestContext& context, const msg::BeepSound& request);
Outcome handle(RequestContext& context, const msg::I2cReadRegBufRequest& request);
Outcome handle(RequestContext& context, const msg::I2cWriteRegBuf& request);
Outcome handle(RequestContext& context, const msg::ApiVirtChControl& request);
Outcome handle(RequestContext& context, const msg::ServoOutExt& request);
Outcome handle(RequestContext& context, const msg::I2cReadRegBufRequestNoRegister& request);
Outcome handle(RequestContext& context, const msg::I2cReadRegBufRequestWideRegister& request);
Outcome handle(RequestContext& context, const msg::ApiVirtChHighRes& request);
Outcome handle(RequestContext& context, const msg::ReadRcInputsRequest& request);

// realtime
Outcome handle(RequestContext& context, const msg::RealtimeData& request);
Outcome handle(RequestContext& context, const msg::RealtimeData3Request& request);
Outcome handle(RequestContext& context, const msg::RealtimeData4Request& request);
Outcome handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request);
Outcome handle(RequestContext& context, const msg::DataStreamInterval& request);

// scripting
Outcome handle(RequestContext& context, const msg::RunScript& request);

// storage
Outcome handle(RequestContext& context, const msg::EepromReadRequest& request);
Outcome handle(RequestContext& context, const msg::EepromWrite& request);
Outcome handle(RequestContext& context, const msg::ReadFileRequest& request);
Outcome handle(RequestContext& context, const msg::WriteFile& request);
Outcome handle(RequestContext& context, const msg::FsClearAll& request);

// system
Outcome handle(RequestContext& context, const msg::BoardInfoRequest& request);
Outcome handle(RequestContext& context, const msg::BoardInfoRequestOneByte& request);
Outcome handle(RequestContext& context, const msg::BoardInfoRequestExt& request);
Outcome handle(RequestContext& context, const msg::BoardInfo3Request& request);
Outcome handle(RequestContext& context, const msg::ResetRequest& request);
Outcome handle(RequestContext& context, const msg::ResetRequestExt& request);
Outcome handle(RequestContext& context, const msg::BootMode3& request);
Outcome handle(RequestContext& context, const msg::BootMode3Ext& request);
Outcome handle(RequestContext& context, const msg::ReadStateVarsRequest& request);
Outcome handle(RequestContext& context, const msg::WriteStateVars& request);
Outcome handle(RequestContext& context, const msg::SignMessageRequest& request);

}  // namespace sbgc::emulator
