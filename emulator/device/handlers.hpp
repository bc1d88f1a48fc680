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
Reaction handle(RequestContext&, const msg::GetAdjVarsVal&, Parameters&);
Reaction handle(RequestContext&, const msg::SetAdjVarsVal&, Device&);
Reaction handle(RequestContext&, const msg::AdjVarsStateRequest&, Device&);
Reaction handle(RequestContext&, const msg::AdjVarsStateRequestExt&, Device&);
Reaction handle(RequestContext&, const msg::AdjVarsInfoRequest&, Parameters&);
Reaction handle(RequestContext&, const msg::AdjVarsInfoRequestAll&, Parameters&);
Reaction handle(RequestContext&, const msg::SetAdjVarsValF&, Device&);
Reaction handle(RequestContext&, const msg::GetAdjVarsValF&, Parameters&);

// calibration
Reaction handle(RequestContext&, const msg::CalibAcc&, Device&);
Reaction handle(RequestContext&, const msg::CalibAccExt&, Device&);
Reaction handle(RequestContext&, const msg::CalibGyro&, Device&);
Reaction handle(RequestContext&, const msg::CalibGyroExt&, Device&);
Reaction handle(RequestContext&, const msg::CalibMag&, Device&);
Reaction handle(RequestContext&, const msg::CalibExtGain&, Device&);
Reaction handle(RequestContext&, const msg::CalibPoles&, Device&);
Reaction handle(RequestContext&, const msg::CalibOffset&, Device&);
Reaction handle(RequestContext&, const msg::CalibBat&, Device&);
Reaction handle(RequestContext&, const msg::EncodersCalibOffset4&, Device&);
Reaction handle(RequestContext&, const msg::EncodersCalibFldOffset4&, Device&);
Reaction handle(RequestContext&, const msg::CalibInfoRequest&, Device&);
Reaction handle(RequestContext&, const msg::AutoPidRequest&, Device&);
Reaction handle(RequestContext&, const msg::CalibMagExt&, Device&);
Reaction handle(RequestContext&, const msg::CalibOrientCorr&, Device&);
Reaction handle(RequestContext&, const msg::CalibCogging&, Device&);
Reaction handle(RequestContext&, const msg::CalibAccExtRef&, Device&);
Reaction handle(RequestContext&, const msg::AutoPid2&, Device&);

// control
Reaction handle(RequestContext&, const msg::Control&, Device&);
Reaction handle(RequestContext&, const msg::ControlExt&, Device&);
Reaction handle(RequestContext&, const msg::GetAnglesRequest&, Device&);
Reaction handle(RequestContext&, const msg::GetAnglesExtRequest&, Device&);
Reaction handle(RequestContext&, const msg::MotorsOn&, Device&);
Reaction handle(RequestContext&, const msg::MotorsOff&, Device&);
Reaction handle(RequestContext&, const msg::MotorsOffExt&, Device&);
Reaction handle(RequestContext&, const msg::ExecuteMenu&, Device&);
Reaction handle(RequestContext&, const msg::ExecuteMenuExt&, Device&);
Reaction handle(RequestContext&, const msg::HelperData&, Device&);
Reaction handle(RequestContext&, const msg::HelperDataExt&, Device&);
Reaction handle(RequestContext&, const msg::ControlExtCommand&, Device&);
Reaction handle(RequestContext&, const msg::ControlConfig&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatDisabled&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeed&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatAttitude&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatAttitudePacked&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeedAttitude&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeedAttitudePacked&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatStatusRequest&, Device&);
Reaction handle(RequestContext&, const msg::ControlQuatConfig&, Device&);
Reaction handle(RequestContext&, const msg::SyncMotors&, Device&);

// debug
Reaction handle(RequestContext&, const msg::DebugVarsInfo3Request&);
Reaction handle(RequestContext&, const msg::DebugVars3Request&, Device&);
Reaction handle(RequestContext&, const msg::DebugVars3RequestSelected&, Device&);
Reaction handle(RequestContext&, const msg::SetDebugPortRequest&, DebugCopies&);

// external_motors
Reaction handle(RequestContext&, const msg::ExtMotorsAction&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsControl&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsControlConfig&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsStateRequest&, ExternalMotors&, Gimbal&);

// imu
Reaction handle(RequestContext&, const msg::SelectImu3&, Device&);
Reaction handle(RequestContext&, const msg::SelectImu3Ext&, Device&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequest&, Device&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestWide&, Device&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestExt&, Device&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestExtWide&, Device&);
Reaction handle(RequestContext&, const msg::GyroCorrection&, Device&);
Reaction handle(RequestContext&, const msg::SelectImu3Calibrate&, Device&);
Reaction handle(RequestContext&, const msg::SelectImu3CalibrateShort&, Device&);
Reaction handle(RequestContext&, const msg::ExtImuDebugInfoRequest&, Device&);
Reaction handle(RequestContext&, const msg::ExtImuCmd&, Device&);
Reaction handle(RequestContext&, const msg::ExtSensCmdRequest&, Device&);

// modules
Reaction handle(RequestContext&, const msg::ModuleListRequest&, Device&);
Reaction handle(RequestContext&, const msg::CanDeviceScanRequest&, Device&);
Reaction handle(RequestContext&, const msg::TransparentSapiRequest&, Device&);

// parameters
Reaction handle(RequestContext&, const msg::SaveParams3&, Parameters&);
Reaction handle(RequestContext&, const msg::UseDefaults&, Device&);
Reaction handle(RequestContext&, const msg::WriteParamsSet&, Device&);
Reaction handle(RequestContext&, const msg::ProfileSet&, Device&);

// peripherals
Reaction handle(RequestContext&, const msg::TriggerPin&, Device&);
Reaction handle(RequestContext&, const msg::ServoOut&, Outputs&, Parameters&);
Reaction handle(RequestContext&, const msg::ServoOutFour&, Outputs&, Parameters&);
Reaction handle(RequestContext&, const msg::BeepSound&, Outputs&);
Reaction handle(RequestContext&, const msg::I2cReadRegBufRequest&, Device&);
Reaction handle(RequestContext&, const msg::I2cWriteRegBuf&, Device&);
Reaction handle(RequestContext&, const msg::ApiVirtChControl&, Device&);
Reaction handle(RequestContext&, const msg::ServoOutExt&, Outputs&, Parameters&);
Reaction handle(RequestContext&, const msg::I2cReadRegBufRequestNoRegister&, Device&);
Reaction handle(RequestContext&, const msg::I2cReadRegBufRequestWideRegister&, Device&);
Reaction handle(RequestContext&, const msg::ApiVirtChHighRes&, Device&);
Reaction handle(RequestContext&, const msg::ReadRcInputsRequest&, RemoteControl&);

// realtime
Reaction handle(RequestContext&, const msg::RealtimeData&, Device&);
Reaction handle(RequestContext&, const msg::RealtimeData3Request&, Device&);
Reaction handle(RequestContext&, const msg::RealtimeData4Request&, Device&);
Reaction handle(RequestContext&, const msg::RealtimeDataCustomRequest&, Device&);
Reaction handle(RequestContext&, const msg::RealtimeDataCustom2Request&, Device&);
Reaction handle(RequestContext&, const msg::DataStreamInterval&, Device&);

// scripting
Reaction handle(RequestContext&, const msg::RunScript&, Scripts&, FileSystem&);

// storage
Reaction handle(RequestContext&, const msg::EepromReadRequest&, Eeprom&);
Reaction handle(RequestContext&, const msg::EepromWrite&, Eeprom&);
Reaction handle(RequestContext&, const msg::ReadFileRequest&, FileSystem&);
Reaction handle(RequestContext&, const msg::WriteFile&, FileSystem&);
Reaction handle(RequestContext&, const msg::FsClearAll&, FileSystem&);

// system
Reaction handle(RequestContext&, const msg::BoardInfoRequest&, Device&);
Reaction handle(RequestContext&, const msg::BoardInfoRequestOneByte&, Device&);
Reaction handle(RequestContext&, const msg::BoardInfoRequestExt&, Device&);
Reaction handle(RequestContext&, const msg::BoardInfo3Request&, Device&);
Reaction handle(RequestContext&, const msg::ResetRequest&, Restarts&);
Reaction handle(RequestContext&, const msg::ResetRequestExt&, Restarts&);
Reaction handle(RequestContext&, const msg::BootMode3&, Restarts&);
Reaction handle(RequestContext&, const msg::BootMode3Ext&, Restarts&);
Reaction handle(RequestContext&, const msg::ReadStateVarsRequest&, StateVariables&, Gimbal&);
Reaction handle(RequestContext&, const msg::WriteStateVars&, StateVariables&, Memory&);
Reaction handle(RequestContext&, const msg::PassProtectReadRequest&, Memory&);
Reaction handle(RequestContext&, const msg::PassProtectWrite&, Memory&);
Reaction handle(RequestContext&, const msg::SignMessageRequest&, const BoardOptions&);

}  // namespace sbgc::emulator
