/// Requests that the board carries out with code of its own. All others are answered by settings.hpp
/// and default_answer.hpp from the model alone.
#pragma once

#include <sbgc/messages.hpp>

#include "turn.hpp"

namespace sbgc::board {

// handlers_system.cpp
Outcome handle(Turn& turn, const BoardInfoRequest& request);
Outcome handle(Turn& turn, const BoardInfoRequestExt& request);
Outcome handle(Turn& turn, const BoardInfo3Request& request);
Outcome handle(Turn& turn, const ResetRequest& request);
Outcome handle(Turn& turn, const ResetRequestExt& request);
Outcome handle(Turn& turn, const BootMode3& request);
Outcome handle(Turn& turn, const BootMode3Ext& request);

// handlers_storage.cpp
Outcome handle(Turn& turn, const SaveParams3& request);
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
Outcome handle(Turn& turn, const AhrsHelperRequestExt& request);

}  // namespace sbgc::board
