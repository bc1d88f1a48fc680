/// Requests that the board carries out with code of its own. All others are answered by
/// settings.hpp and default_answer.hpp from the model alone.
#pragma once

#include <sbgc/messages.hpp>

#include "device/request_context.hpp"

namespace sbgc::board {

// handlers_system.cpp
Outcome handle(Turn& turn, const msg::BoardInfoRequest& request);
Outcome handle(Turn& turn, const msg::BoardInfoRequestOneByte& request);
Outcome handle(Turn& turn, const msg::BoardInfoRequestExt& request);
Outcome handle(Turn& turn, const msg::BoardInfo3Request& request);
Outcome handle(Turn& turn, const msg::ResetRequest& request);
Outcome handle(Turn& turn, const msg::ResetRequestExt& request);
Outcome handle(Turn& turn, const msg::BootMode3& request);
Outcome handle(Turn& turn, const msg::BootMode3Ext& request);

// handlers_storage.cpp
Outcome handle(Turn& turn, const msg::UseDefaults& request);
Outcome handle(Turn& turn, const msg::EepromReadRequest& request);
Outcome handle(Turn& turn, const msg::EepromWrite& request);
Outcome handle(Turn& turn, const msg::ReadFileRequest& request);
Outcome handle(Turn& turn, const msg::WriteFile& request);
Outcome handle(Turn& turn, const msg::FsClearAll& request);

// handlers_control.cpp
Outcome handle(Turn& turn, const msg::Control& request);
Outcome handle(Turn& turn, const msg::ControlExt& request);
Outcome handle(Turn& turn, const msg::MotorsOn& request);
Outcome handle(Turn& turn, const msg::MotorsOff& request);
Outcome handle(Turn& turn, const msg::MotorsOffExt& request);
Outcome handle(Turn& turn, const msg::ExecuteMenu& request);
Outcome handle(Turn& turn, const msg::ExecuteMenuExt& request);
Outcome handle(Turn& turn, const msg::HelperData& request);
Outcome handle(Turn& turn, const msg::HelperDataExt& request);
Outcome handle(Turn& turn, const msg::ApiVirtChControl& request);

// handlers_realtime.cpp
Outcome handle(Turn& turn, const msg::RealtimeData& request);
Outcome handle(Turn& turn, const msg::RealtimeData3Request& request);
Outcome handle(Turn& turn, const msg::RealtimeData4Request& request);
Outcome handle(Turn& turn, const msg::RealtimeDataCustomRequest& request);
Outcome handle(Turn& turn, const msg::GetAnglesRequest& request);
Outcome handle(Turn& turn, const msg::GetAnglesExtRequest& request);
Outcome handle(Turn& turn, const msg::DataStreamInterval& request);

// handlers_attitude.cpp
Outcome handle(Turn& turn, const msg::AhrsHelperRequest& request);
Outcome handle(Turn& turn, const msg::AhrsHelperRequestWide& request);
Outcome handle(Turn& turn, const msg::AhrsHelperRequestExt& request);
Outcome handle(Turn& turn, const msg::AhrsHelperRequestExtWide& request);

// answer_calibration.cpp
Outcome handle(Turn& turn, const msg::CalibAcc& request);
Outcome handle(Turn& turn, const msg::CalibAccExt& request);
Outcome handle(Turn& turn, const msg::CalibGyro& request);
Outcome handle(Turn& turn, const msg::CalibGyroExt& request);
Outcome handle(Turn& turn, const msg::CalibMag& request);
Outcome handle(Turn& turn, const msg::CalibExtGain& request);
Outcome handle(Turn& turn, const msg::CalibPoles& request);
Outcome handle(Turn& turn, const msg::CalibOffset& request);
Outcome handle(Turn& turn, const msg::CalibBat& request);
Outcome handle(Turn& turn, const msg::EncodersCalibOffset4& request);
Outcome handle(Turn& turn, const msg::EncodersCalibFldOffset4& request);
Outcome handle(Turn& turn, const msg::CalibInfoRequest& request);
Outcome handle(Turn& turn, const msg::AutoPidRequest& request);

// answer_imu.cpp
Outcome handle(Turn& turn, const msg::SelectImu3& request);
Outcome handle(Turn& turn, const msg::SelectImu3Ext& request);
Outcome handle(Turn& turn, const msg::GyroCorrection& request);

// answer_peripherals.cpp
Outcome handle(Turn& turn, const msg::TriggerPin& request);
Outcome handle(Turn& turn, const msg::ServoOut& request);
Outcome handle(Turn& turn, const msg::BeepSound& request);
Outcome handle(Turn& turn, const msg::I2cReadRegBufRequest& request);
Outcome handle(Turn& turn, const msg::I2cWriteRegBuf& request);

// answer_scripting.cpp
Outcome handle(Turn& turn, const msg::RunScript& request);

// answer_debug.cpp
Outcome handle(Turn& turn, const msg::DebugVarsInfo3Request& request);
Outcome handle(Turn& turn, const msg::DebugVars3Request& request);

// answer_variables.cpp
Outcome handle(Turn& turn, const msg::GetAdjVarsVal& request);
Outcome handle(Turn& turn, const msg::SetAdjVarsVal& request);
Outcome handle(Turn& turn, const msg::SaveParams3& request);
Outcome handle(Turn& turn, const msg::AdjVarsStateRequest& request);
Outcome handle(Turn& turn, const msg::AdjVarsStateRequestExt& request);

}  // namespace sbgc::board
