// Live data, asked for or streamed.

#include "device/handlers.hpp"
#include "device/parts/live_data.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

msg::RealtimeData3 data_3(Turn& turn) {
  msg::RealtimeData3 data;
  measure(turn.machine, turn.port, turn.now, data);
  return data;
}

}  // namespace

Outcome handle(Turn& turn, const msg::RealtimeData& /*request*/) {
  return turn.answer_anyway(data_3(turn));
}

Outcome handle(Turn& turn, const msg::RealtimeData3Request& /*request*/) {
  return turn.answer(data_3(turn));
}

Outcome handle(Turn& turn, const msg::RealtimeData4Request& /*request*/) {
  msg::RealtimeData4 data;
  measure(turn.machine, turn.port, turn.now, data);
  return turn.answer(data);
}

Outcome handle(Turn& turn, const msg::RealtimeDataCustomRequest& request) {
  msg::RealtimeDataCustom data;
  measure(turn.machine, request.flags, turn.now, data);
  return turn.answer(data);
}

Outcome handle(Turn& turn, const msg::GetAnglesRequest& /*request*/) {
  msg::GetAngles data;
  measure(turn.machine, turn.now, data);
  return turn.answer(data);
}

Outcome handle(Turn& turn, const msg::GetAnglesExtRequest& /*request*/) {
  msg::GetAnglesExt data;
  measure(turn.machine, turn.now, data);
  return turn.answer(data);
}

Outcome handle(Turn& turn, const msg::DataStreamInterval& request) {
  switch (turn.machine.streams.change(turn.machine, turn.port, request, turn.now)) {
    case Streams::Change::done: break;
    case Streams::Change::no_room:
      return turn.refuse(msg::BoardErrorCode::temporary,
                         static_cast<std::uint32_t>(request.cmd_id));
    case Streams::Change::bad_command:
      return turn.refuse(msg::BoardErrorCode::wrong_params,
                         static_cast<std::uint32_t>(request.cmd_id));
  }
  return turn.confirm();
}

}  // namespace sbgc::board
