/// Handlers of the requests that need code of their own, grouped by the family in spec/:
/// device/<family>/handlers.cpp implements them. All other requests are answered from the model
/// alone: parameters/access.hpp reads and writes parameters, default_response.hpp handles the rest.
#pragma once

#include <sbgc/messages.hpp>

#include "device/device.hpp"
#include "device/request_context.hpp"

namespace sbgc::emulator {

/// True if the handler itself decides about values that the firmware does not know.
template <class M>
inline constexpr bool checks_values = false;
/// Pins and states that do not exist are met with silence.
template <>
inline constexpr bool checks_values<msg::TriggerPin> = true;

// adjustable_variables
Verdict handle(RequestContext&, const msg::GetAdjVarsVal&, Parameters&);
Verdict handle(RequestContext&, const msg::SetAdjVarsVal&, Device&);
Verdict handle(RequestContext&, const msg::AdjVarsStateRequest&, Device&);
Verdict handle(RequestContext&, const msg::AdjVarsStateRequestExt&, Device&);
Verdict handle(RequestContext&, const msg::AdjVarsInfoRequest&, Parameters&);
Verdict handle(RequestContext&, const msg::AdjVarsInfoRequestAll&, Parameters&);
Verdict handle(RequestContext&, const msg::SetAdjVarsValF&, Device&);
Verdict handle(RequestContext&, const msg::GetAdjVarsValF&, Parameters&);

// calibration
Verdict handle(RequestContext&, const msg::CalibAcc&, Device&);
Verdict handle(RequestContext&, const msg::CalibAccExt&, Device&);
Verdict handle(RequestContext&, const msg::CalibGyro&, Device&);
Verdict handle(RequestContext&, const msg::CalibGyroExt&, Device&);
Verdict handle(RequestContext&, const msg::CalibMag&, Device&);
Verdict handle(RequestContext&, const msg::CalibExtGain&, Device&);
Verdict handle(RequestContext&, const msg::CalibPoles&, Device&);
Verdict handle(RequestContext&, const msg::CalibOffset&, Device&);
Verdict handle(RequestContext&, const msg::CalibBat&, Device&);
Verdict handle(RequestContext&, const msg::EncodersCalibOffset4&, Device&);
Verdict handle(RequestContext&, const msg::EncodersCalibFldOffset4&, Device&);
Verdict handle(RequestContext&, const msg::CalibInfoRequest&, Device&);
Verdict handle(RequestContext&, const msg::AutoPidRequest&, Device&);
Verdict handle(RequestContext&, const msg::CalibMagExt&, Device&);
Verdict handle(RequestContext&, const msg::CalibOrientCorr&, Device&);
Verdict handle(RequestContext&, const msg::CalibCogging&, Device&);
Verdict handle(RequestContext&, const msg::CalibAccExtRef&, Device&);
Verdict handle(RequestContext&, const msg::AutoPid2&, Device&);

// control
Verdict handle(RequestContext&, const msg::Control&, Device&);
Verdict handle(RequestContext&, const msg::ControlExt&, Device&);
Verdict handle(RequestContext&, const msg::GetAnglesRequest&, Device&);
Verdict handle(RequestContext&, const msg::GetAnglesExtRequest&, Device&);
Verdict handle(RequestContext&, const msg::MotorsOn&, Device&);
Verdict handle(RequestContext&, const msg::MotorsOff&, Device&);
Verdict handle(RequestContext&, const msg::MotorsOffExt&, Device&);
Verdict handle(RequestContext&, const msg::ExecuteMenu&, Device&);
Verdict handle(RequestContext&, const msg::ExecuteMenuExt&, Device&);
Verdict handle(RequestContext&, const msg::HelperData&, Device&);
Verdict handle(RequestContext&, const msg::HelperDataExt&, Device&);
Verdict handle(RequestContext&, const msg::ControlExtCommand&, Device&);
Verdict handle(RequestContext&, const msg::ControlConfig&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatDisabled&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatSpeed&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatAttitude&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatAttitudePacked&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatSpeedAttitude&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatSpeedAttitudePacked&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatStatusRequest&, Device&);
Verdict handle(RequestContext&, const msg::ControlQuatConfig&, Device&);
Verdict handle(RequestContext&, const msg::SyncMotors&, Device&);

// debug
Verdict handle(RequestContext&, const msg::DebugVarsInfo3Request&);
Verdict handle(RequestContext&, const msg::DebugVars3Request&, Device&);
Verdict handle(RequestContext&, const msg::DebugVars3RequestSelected&, Device&);
Verdict handle(RequestContext&, const msg::SetDebugPortRequest&, DebugCopies&);

// external_motors
Verdict handle(RequestContext&, const msg::ExtMotorsAction&, ExternalMotors&);
Verdict handle(RequestContext&, const msg::ExtMotorsControl&, ExternalMotors&);
Verdict handle(RequestContext&, const msg::ExtMotorsControlConfig&, ExternalMotors&);
Verdict handle(RequestContext&, const msg::ExtMotorsStateRequest&, ExternalMotors&, Gimbal&);

// imu
Verdict handle(RequestContext&, const msg::SelectImu3&, Device&);
Verdict handle(RequestContext&, const msg::SelectImu3Ext&, Device&);
Verdict handle(RequestContext&, const msg::AhrsHelperRequest&, Device&);
Verdict handle(RequestContext&, const msg::AhrsHelperRequestWide&, Device&);
Verdict handle(RequestContext&, const msg::AhrsHelperRequestExt&, Device&);
Verdict handle(RequestContext&, const msg::AhrsHelperRequestExtWide&, Device&);
Verdict handle(RequestContext&, const msg::GyroCorrection&, Device&);
Verdict handle(RequestContext&, const msg::SelectImu3Calibrate&, Device&);
Verdict handle(RequestContext&, const msg::ExtImuDebugInfoRequest&, Device&);
Verdict handle(RequestContext&, const msg::ExtImuCmd&, Device&);
Verdict handle(RequestContext&, const msg::ExtSensCmdRequest&, Device&);

// modules
Verdict handle(RequestContext&, const msg::ModuleListRequest&, Device&);
Verdict handle(RequestContext&, const msg::CanDeviceScanRequest&, Device&);
Verdict handle(RequestContext&, const msg::TransparentSapiRequest&, Device&);

// parameters
Verdict handle(RequestContext&, const msg::SaveParams3&, Parameters&);
Verdict handle(RequestContext&, const msg::UseDefaults&, Device&);
Verdict handle(RequestContext&, const msg::WriteParamsSet&, Device&);
Verdict handle(RequestContext&, const msg::ProfileSet&, Device&);

// peripherals
Verdict handle(RequestContext&, const msg::TriggerPin&, Device&);
Verdict handle(RequestContext&, const msg::ServoOut&, Outputs&, Parameters&);
Verdict handle(RequestContext&, const msg::BeepSound&, Outputs&);
Verdict handle(RequestContext&, const msg::I2cReadRegBufRequest&, Device&);
Verdict handle(RequestContext&, const msg::I2cWriteRegBuf&, Device&);
Verdict handle(RequestContext&, const msg::ApiVirtChControl&, Device&);
Verdict handle(RequestContext&, const msg::ServoOutExt&, Outputs&, Parameters&);
Verdict handle(RequestContext&, const msg::I2cReadRegBufRequestNoRegister&, Device&);
Verdict handle(RequestContext&, const msg::I2cReadRegBufRequestWideRegister&, Device&);
Verdict handle(RequestContext&, const msg::ApiVirtChHighRes&, Device&);
Verdict handle(RequestContext&, const msg::ReadRcInputsRequest&, RemoteControl&);

// realtime
Verdict handle(RequestContext&, const msg::RealtimeData&, Device&);
Verdict handle(RequestContext&, const msg::RealtimeData3Request&, Device&);
Verdict handle(RequestContext&, const msg::RealtimeData4Request&, Device&);
Verdict handle(RequestContext&, const msg::RealtimeDataCustomRequest&, Device&);
Verdict handle(RequestContext&, const msg::DataStreamInterval&, Device&);

// scripting
Verdict handle(RequestContext&, const msg::RunScript&, Scripts&, FileSystem&);

// storage
Verdict handle(RequestContext&, const msg::EepromReadRequest&, Eeprom&);
Verdict handle(RequestContext&, const msg::EepromWrite&, Eeprom&);
Verdict handle(RequestContext&, const msg::ReadFileRequest&, FileSystem&);
Verdict handle(RequestContext&, const msg::WriteFile&, FileSystem&);
Verdict handle(RequestContext&, const msg::FsClearAll&, FileSystem&);

// system
Verdict handle(RequestContext&, const msg::BoardInfoRequest&, Device&);
Verdict handle(RequestContext&, const msg::BoardInfoRequestOneByte&, Device&);
Verdict handle(RequestContext&, const msg::BoardInfoRequestExt&, Device&);
Verdict handle(RequestContext&, const msg::BoardInfo3Request&, Device&);
Verdict handle(RequestContext&, const msg::ResetRequest&, Restarts&);
Verdict handle(RequestContext&, const msg::ResetRequestExt&, Restarts&);
Verdict handle(RequestContext&, const msg::BootMode3&, Restarts&);
Verdict handle(RequestContext&, const msg::BootMode3Ext&, Restarts&);
Verdict handle(RequestContext&, const msg::ReadStateVarsRequest&, StateVariables&, Gimbal&);
Verdict handle(RequestContext&, const msg::WriteStateVars&, StateVariables&, Memory&);
Verdict handle(RequestContext&, const msg::SignMessageRequest&, const BoardOptions&);

}  // namespace sbgc::emulator
