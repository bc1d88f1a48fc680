/// Handlers of the requests that need specific code, grouped by the family in spec/:
/// device/<family>/handlers.cpp implements them. A handler takes the parts of the device that it
/// uses. equivalents.hpp has the requests that are equivalent to another one. All others are
/// answered from the model alone: parameters/access.hpp reads and writes parameters,
/// default_response.hpp handles the rest.
#pragma once

#include <sbgc/messages.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

class Calibrations;
class ControlLink;
class DebugCopies;
class Eeprom;
class ExternalMotors;
class FileSystem;
class I2cBus;
class ModuleFlash;
class Outputs;
class Parameters;
class QuaternionControl;
class RemoteControl;
class Restarts;
class Scripts;
class Slots;
class StateVariables;
class Streams;
class Tasks;
struct CalibrationParts;
struct ControlParts;
struct Imus;
struct MeasuredParts;
struct MenuParts;
struct Modes;

/// True if the handler itself handles values that the firmware does not know.
template <class M>
inline constexpr bool checks_values = false;
/// Requests for nonexistent pins and states are not answered.
template <>
inline constexpr bool checks_values<msg::TriggerPin> = true;

// adjustable_variables
Reaction handle(RequestContext&, const msg::GetAdjVarsVal&, const Parameters&);
Reaction handle(RequestContext&, const msg::SetAdjVarsVal&, Parameters&);
Reaction handle(RequestContext&, const msg::AdjVarsStateRequest&, const Slots&,
                const RemoteControl&, const Parameters&);
Reaction handle(RequestContext&, const msg::AdjVarsStateRequestExt&, const Slots&,
                const RemoteControl&, const Parameters&);
Reaction handle(RequestContext&, const msg::AdjVarsInfoRequest&, const Parameters&);
Reaction handle(RequestContext&, const msg::SetAdjVarsValF&, Parameters&);
Reaction handle(RequestContext&, const msg::GetAdjVarsValF&, const Parameters&);

// calibration
Reaction handle(RequestContext&, const msg::CalibAccExt&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibGyroExt&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibExtGain&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibPoles&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibOffset&, Gimbal&, Parameters&);
Reaction handle(RequestContext&, const msg::CalibBat&, const BoardOptions&, Memory&, Gimbal&,
                Parameters&);
Reaction handle(RequestContext&, const msg::EncodersCalibOffset4&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::EncodersCalibFldOffset4&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibInfoRequest&, const Calibrations&, const Imus&,
                const Memory&, Gimbal&);
Reaction handle(RequestContext&, const msg::AutoPidRequest&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibMagExt&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibOrientCorr&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibCogging&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::CalibAccExtRef&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::AutoPid2&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::BodeTestStartStopRequest&, CalibrationParts&);
/// Executes an operation on the gyroscope of an IMU. A `length` of 0 is the usual duration.
Reaction calibrate_gyro(RequestContext&, CalibrationParts&, msg::CalibImu, msg::CalibAction,
                        Duration length);

// control
Reaction handle(RequestContext&, const msg::ControlExt&, ControlParts&);
Reaction handle(RequestContext&, const msg::GetAnglesRequest&, Gimbal&);
Reaction handle(RequestContext&, const msg::GetAnglesExtRequest&, Gimbal&, const Imus&,
                const BoardOptions&);
Reaction handle(RequestContext&, const msg::MotorsOn&, Tasks&, Gimbal&);
Reaction handle(RequestContext&, const msg::MotorsOffExt&, Tasks&, Gimbal&);
Reaction handle(RequestContext&, const msg::ExecuteMenuExt&, MenuParts&);
Reaction handle(RequestContext&, const msg::HelperDataExt&, Gimbal&);
Reaction handle(RequestContext&, const msg::ControlExtCommand&, ControlParts&);
Reaction handle(RequestContext&, const msg::ControlConfig&, ControlLink&, Modes&, Parameters&);
Reaction handle(RequestContext&, const msg::ControlQuatDisabled&, QuaternionControl&,
                ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeed&, QuaternionControl&, ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatAttitude&, QuaternionControl&,
                ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatAttitudePacked&, QuaternionControl&,
                ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeedAttitude&, QuaternionControl&,
                ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatSpeedAttitudePacked&, QuaternionControl&,
                ControlParts&);
Reaction handle(RequestContext&, const msg::ControlQuatStatusRequest&, const QuaternionControl&,
                Gimbal&, const Tuning&);
Reaction handle(RequestContext&, const msg::ControlQuatConfig&, QuaternionControl&);
Reaction handle(RequestContext&, const msg::SyncMotors&, Tasks&, Gimbal&);

// debug
Reaction handle(RequestContext&, const msg::DebugVarsInfo3Request&);
Reaction handle(RequestContext&, const msg::DebugVars3Request&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::DebugVars3RequestSelected&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::SetDebugPortRequest&, DebugCopies&);

// external_motors
Reaction handle(RequestContext&, const msg::ExtMotorsAction&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsControl&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsControlConfig&, ExternalMotors&);
Reaction handle(RequestContext&, const msg::ExtMotorsStateRequest&, ExternalMotors&, Gimbal&);

// imu
Reaction handle(RequestContext&, const msg::SelectImu3&, Imus&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequest&, Gimbal&, const Imus&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestWide&, Gimbal&, const Imus&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestExt&, Gimbal&, const Imus&,
                const BoardOptions&);
Reaction handle(RequestContext&, const msg::AhrsHelperRequestExtWide&, Gimbal&, const Imus&,
                const BoardOptions&);
Reaction handle(RequestContext&, const msg::GyroCorrection&, Imus&, Memory&, Gimbal&,
                const Parameters&);
Reaction handle(RequestContext&, const msg::SelectImu3Calibrate&, Imus&, CalibrationParts&);
Reaction handle(RequestContext&, const msg::ExtImuDebugInfoRequest&, const BoardOptions&, Gimbal&,
                const Imus&, const Parameters&, const Tuning&);
Reaction handle(RequestContext&, const msg::ExtImuCmd&, const BoardOptions&);
Reaction handle(RequestContext&, const msg::ExtSensCmdRequest&, const BoardOptions&);

// modules
Reaction handle(RequestContext&, const msg::ModuleListRequest&, const BoardOptions&);
Reaction handle(RequestContext&, const msg::CanDeviceScanRequest&, const BoardOptions&);
Reaction handle(RequestContext&, const msg::TransparentSapiRequest&, const BoardOptions&);
Reaction handle(RequestContext&, const msg::ModuleFlashStart&, const BoardOptions&, ModuleFlash&);
Reaction handle(RequestContext&, const msg::ModuleFlashWrite&, ModuleFlash&);
Reaction handle(RequestContext&, const msg::ModuleFlashFinish&, ModuleFlash&);

// parameters
Reaction handle(RequestContext&, const msg::SaveParams3&, Parameters&);
Reaction handle(RequestContext&, const msg::UseDefaults&, Parameters&, Memory&, Imus&);
Reaction handle(RequestContext&, const msg::WriteParamsSet&, Modes&, Parameters&);
Reaction handle(RequestContext&, const msg::ProfileSet&, Parameters&);

// peripherals
Reaction handle(RequestContext&, const msg::TriggerPin&, Outputs&, const Parameters&);
Reaction handle(RequestContext&, const msg::ServoOut&, Outputs&, const Parameters&);
Reaction handle(RequestContext&, const msg::BeepSound&, Outputs&);
Reaction handle(RequestContext&, const msg::I2cReadRegBufRequest&, const I2cBus&,
                const BoardOptions&, const Eeprom&, Gimbal&);
Reaction handle(RequestContext&, const msg::I2cWriteRegBuf&, I2cBus&, const BoardOptions&, Eeprom&);
Reaction handle(RequestContext&, const msg::ApiVirtChControl&, RemoteControl&, MenuParts&);
Reaction handle(RequestContext&, const msg::ServoOutExt&, Outputs&, const Parameters&);
Reaction handle(RequestContext&, const msg::ApiVirtChHighRes&, RemoteControl&, MenuParts&);
Reaction handle(RequestContext&, const msg::ReadRcInputsRequest&, const RemoteControl&);

// realtime
Reaction handle(RequestContext&, const msg::RealtimeData&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::RealtimeData3Request&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::RealtimeData4Request&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::RealtimeDataCustomRequest&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::RealtimeDataCustom2Request&, MeasuredParts&);
Reaction handle(RequestContext&, const msg::DataStreamInterval&, Streams&, Ports&,
                const BoardOptions&, const Imus&, Gimbal&);

// scripting
Reaction handle(RequestContext&, const msg::RunScript&, Scripts&, const FileSystem&);

// storage
Reaction handle(RequestContext&, const msg::EepromReadRequest&, const Eeprom&);
Reaction handle(RequestContext&, const msg::EepromWrite&, Eeprom&);
Reaction handle(RequestContext&, const msg::ReadFileRequest&, const FileSystem&);
Reaction handle(RequestContext&, const msg::WriteFile&, FileSystem&);
Reaction handle(RequestContext&, const msg::FsClearAll&, FileSystem&);

// system
Reaction handle(RequestContext&, const msg::BoardInfoRequest&, const BoardOptions&, Gimbal&,
                const Modes&, const Tuning&);
Reaction handle(RequestContext&, const msg::BoardInfo3Request&, const BoardOptions&, const Memory&,
                const FileSystem&, const Parameters&);
Reaction handle(RequestContext&, const msg::ResetRequestExt&, Restarts&);
Reaction handle(RequestContext&, const msg::BootMode3Ext&, Restarts&);
Reaction handle(RequestContext&, const msg::ReadStateVarsRequest&, StateVariables&, Gimbal&);
Reaction handle(RequestContext&, const msg::WriteStateVars&, StateVariables&, Memory&);
Reaction handle(RequestContext&, const msg::PassProtectReadRequest&, const Memory&);
Reaction handle(RequestContext&, const msg::PassProtectWrite&, Memory&, BoardOptions&);
Reaction handle(RequestContext&, const msg::SignMessageRequest&, const BoardOptions&);

}  // namespace sbgc::emulator
