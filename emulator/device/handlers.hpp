/// Handlers of the requests that need code of their own, grouped by the family in spec/:
/// device/<family>.cpp implements them. All other requests are answered from the model alone:
/// parameter_access.hpp reads and writes parameters, default_response.hpp handles the rest.
#pragma once

#include <sbgc/messages.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

// adjustable_variables.cpp
Outcome handle(RequestContext& context, const msg::GetAdjVarsVal& request);
Outcome handle(RequestContext& context, const msg::SetAdjVarsVal& request);
Outcome handle(RequestContext& context, const msg::AdjVarsStateRequest& request);
Outcome handle(RequestContext& context, const msg::AdjVarsStateRequestExt& request);

// calibration.cpp
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

// control.cpp
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

// debug.cpp
Outcome handle(RequestContext& context, const msg::DebugVarsInfo3Request& request);
Outcome handle(RequestContext& context, const msg::DebugVars3Request& request);

// imu.cpp
Outcome handle(RequestContext& context, const msg::SelectImu3& request);
Outcome handle(RequestContext& context, const msg::SelectImu3Ext& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequest& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestWide& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExt& request);
Outcome handle(RequestContext& context, const msg::AhrsHelperRequestExtWide& request);
Outcome handle(RequestContext& context, const msg::GyroCorrection& request);

// parameters.cpp
Outcome handle(RequestContext& context, const msg::SaveParams3& request);
Outcome handle(RequestContext& context, const msg::UseDefaults& request);

// peripherals.cpp
Outcome handle(RequestContext& context, const msg::TriggerPin& request);
Outcome handle(RequestContext& context, const msg::ServoOut& request);
Outcome handle(RequestContext& context, const msg::BeepSound& request);
Outcome handle(RequestContext& context, const msg::I2cReadRegBufRequest& request);
Outcome handle(RequestContext& context, const msg::I2cWriteRegBuf& request);
Outcome handle(RequestContext& context, const msg::ApiVirtChControl& request);

// realtime.cpp
Outcome handle(RequestContext& context, const msg::RealtimeData& request);
Outcome handle(RequestContext& context, const msg::RealtimeData3Request& request);
Outcome handle(RequestContext& context, const msg::RealtimeData4Request& request);
Outcome handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request);
Outcome handle(RequestContext& context, const msg::DataStreamInterval& request);

// scripting.cpp
Outcome handle(RequestContext& context, const msg::RunScript& request);

// storage.cpp
Outcome handle(RequestContext& context, const msg::EepromReadRequest& request);
Outcome handle(RequestContext& context, const msg::EepromWrite& request);
Outcome handle(RequestContext& context, const msg::ReadFileRequest& request);
Outcome handle(RequestContext& context, const msg::WriteFile& request);
Outcome handle(RequestContext& context, const msg::FsClearAll& request);

// system.cpp
Outcome handle(RequestContext& context, const msg::BoardInfoRequest& request);
Outcome handle(RequestContext& context, const msg::BoardInfoRequestOneByte& request);
Outcome handle(RequestContext& context, const msg::BoardInfoRequestExt& request);
Outcome handle(RequestContext& context, const msg::BoardInfo3Request& request);
Outcome handle(RequestContext& context, const msg::ResetRequest& request);
Outcome handle(RequestContext& context, const msg::ResetRequestExt& request);
Outcome handle(RequestContext& context, const msg::BootMode3& request);
Outcome handle(RequestContext& context, const msg::BootMode3Ext& request);

}  // namespace sbgc::emulator
