// spec/realtime.yaml: live data, on request or streamed.

#include "device/handlers.hpp"

#include "device/device.hpp"
#include "device/realtime/live_data.hpp"

namespace sbgc::emulator {
namespace {

msg::RealtimeData3 data_3(RequestContext& context) {
  msg::RealtimeData3 data;
  measure(context.device, context.port, context.now, data);
  return data;
}

}  // namespace

Verdict handle(RequestContext& context, const msg::RealtimeData& /*request*/) {
  return context.answer_anyway(data_3(context));
}

Verdict handle(RequestContext& context, const msg::RealtimeData3Request& /*request*/) {
  return context.answer(data_3(context));
}

Verdict handle(RequestContext& context, const msg::RealtimeData4Request& /*request*/) {
  msg::RealtimeData4 data;
  measure(context.device, context.port, context.now, data);
  return context.answer(data);
}

Verdict handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request) {
  const auto blocks = known_blocks(context.device, request.flags);
  if (!blocks) return context.refuse(msg::BoardErrorCode::wrong_params, request.flags.raw());
  msg::RealtimeDataCustom data;
  measure(context.device, context.port, *blocks, context.now, data);
  return context.answer(data);
}

Verdict handle(RequestContext& context, const msg::DataStreamInterval& request) {
  switch (context.device.streams.change(context.device, context.port, request, context.now)) {
    case Streams::Change::done: break;
    case Streams::Change::no_room:
      return context.refuse(msg::BoardErrorCode::temporary,
                            static_cast<std::uint32_t>(request.cmd_id));
    case Streams::Change::bad_command:
      return context.refuse(msg::BoardErrorCode::wrong_params,
                            static_cast<std::uint32_t>(request.cmd_id));
  }
  return context.confirm();
}

}  // namespace sbgc::emulator
