/// Requests that the board carries out with code of its own. All others are answered by
/// settings.hpp and default_answer.hpp from the model alone.
#pragma once

#include <sbgc/messages.hpp>

#include "turn.hpp"

namespace sbgc::board {

// handlers_system.cpp
Outcome handle(Turn& turn, const BoardInfoRequest& request);
Outcome handle(Turn& turn, const BoardInfoRequestOneByte& request);
Outcome handle(Turn& turn, const BoardInfoRequestExt& request);
Outcome handle(Turn& turn, const BoardInfo3Request& request);
Outcome handle(Turn& turn, const ResetRequest& request);
Outcome handle(Turn& turn, const ResetRequestExt& request);
Outcome handle(Turn& turn, const BootMode3& request);
Outcome handle(Turn& turn, const BootMode3Ext& request);

// handlers_storage.cpp
Outcome handle(Turn& turn, const UseDefaults& request);
Outcome handle(Turn& turn, const EepromReadRequest& request);
Outcome handle(Turn& turn, const EepromWrite& request);
Outcome handle(Turn& turn, const ReadFileRequest& request);
Outcome handle(Turn& turn, const WriteFile& request);
Outcome handle(Turn& turn, const FsClearAll& request);

// handlers_control.cpp
Outcome handle(Turn& turn, const Control& request);
Outcome handle(Turn& turn, const ControlExt& request);
Outcome handle(Turn& turn, const MotorsOn& request);
Outcome handle(Turn& turn, const MotorsOff& request);
Outcome handle(Turn& turn, const MotorsOffExt& request);
Outcome handle(Turn& turn, const ExecuteMenu& request);
Outcome handle(Turn& turn, const ExecuteMenuExt& request);
Outcome handle(Turn& turn, const HelperData& request);
Outcome handle(Turn& turn, const HelperDataExt& request);
Outcome handle(Turn& turn, const ApiVirtChControl& request);

// handlers_realtime.cpp
Outcome handle(Turn& turn, const RealtimeData& request);
Outcome handle(Turn& turn, const RealtimeData3Request& request);
Outcome handle(Turn& turn, const RealtimeData4Request& request);
Outcome handle(Turn& turn, const RealtimeDataCustomRequest& request);
Outcome handle(Turn& turn, const GetAnglesRequest& request);
Outcome handle(Turn& turn, const GetAnglesExtRequest& request);
Outcome handle(Turn& turn, const DataStreamInterval& request);

// handlers_attitude.cpp
Outcome handle(Turn& turn, const AhrsHelperRequest& request);
Outcome handle(Turn& turn, const AhrsHelperRequestWide& request);
Outcome handle(Turn& turn, const AhrsHelperRequestExt& request);
Outcome handle(Turn& turn, const AhrsHelperRequestExtWide& request);

// answer_calibration.cpp
Outcome handle(Turn& turn, const CalibAcc& request);
Outcome handle(Turn& turn, const CalibAccExt& request);
Outcome handle(Turn& turn, const CalibGyro& request);
Outcome handle(Turn& turn, const CalibGyroExt& request);
Outcome handle(Turn& turn, const CalibMag& request);
Outcome handle(Turn& turn, const CalibExtGain& request);
Outcome handle(Turn& turn, const CalibPoles& request);
Outcome handle(Turn& turn, const CalibOffset& request);
Outcome handle(Turn& turn, const CalibBat& request);
Outcome handle(Turn& turn, const EncodersCalibOffset4& request);
Outcome handle(Turn& turn, const EncodersCalibFldOffset4& request);
Outcome handle(Turn& turn, const CalibInfoRequest& request);
Outcome handle(Turn& turn, const AutoPidRequest& request);

// answer_imu.cpp
Outcome handle(Turn& turn, const SelectImu3& request);
Outcome handle(Turn& turn, const SelectImu3Ext& request);
Outcome handle(Turn& turn, const GyroCorrection& request);

// answer_peripherals.cpp
Outcome handle(Turn& turn, const TriggerPin& request);
Outcome handle(Turn& turn, const ServoOut& request);
Outcome handle(Turn& turn, const BeepSound& request);
Outcome handle(Turn& turn, const I2cReadRegBufRequest& request);
Outcome handle(Turn& turn, const I2cWriteRegBuf& request);

// answer_scripting.cpp
Outcome handle(Turn& turn, const RunScript& request);

// answer_debug.cpp
Outcome handle(Turn& turn, const DebugVarsInfo3Request& request);
Outcome handle(Turn& turn, const DebugVars3Request& request);

// answer_variables.cpp
Outcome handle(Turn& turn, const GetAdjVarsVal& request);
Outcome handle(Turn& turn, const SetAdjVarsVal& request);
Outcome handle(Turn& turn, const SaveParams3& request);
Outcome handle(Turn& turn, const AdjVarsStateRequest& request);
Outcome handle(Turn& turn, const AdjVarsStateRequestExt& request);

}  // namespace sbgc::board
