// spec/realtime.yaml: live data, on request or streamed.

#include "device/handlers.hpp"

#include "device/realtime/live_data.hpp"

namespace sbgc::emulator {
namespace {

msg::RealtimeData3 data_3(RequestContext& context, Device& device) {
  msg::RealtimeData3 data;
  measure(device, context.port, context.now, data);
  return data;
}

}  // namespace

Reaction handle(RequestContext& context, const msg::RealtimeData& /*request*/, Device& device) {
  return context.answer_anyway(data_3(context, device));
}

Reaction handle(RequestContext& context, const msg::RealtimeData3Request& /*request*/,
                Device& device) {
  return context.answer(data_3(context, device));
}

Reaction handle(RequestContext& context, const msg::RealtimeData4Request& /*request*/,
                Device& device) {
  msg::RealtimeData4 data;
  measure(device, context.port, context.now, data);
  return context.answer(data);
}

Reaction handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request,
                Device& device) {
  const auto blocks = known_blocks(device, request.flags);
  if (!blocks) return context.refuse(msg::BoardErrorCode::wrong_params, request.flags.raw());
  msg::RealtimeDataCustom data;
  measure(device, context.port, *blocks, context.now, data);
  return context.answer(data);
}

Reaction handle(RequestContext& context, const msg::RealtimeDataCustom2Request& request,
                Device& device) {
  msg::RealtimeDataCustom2Request known = request;
  limit_to(device.versions(), known);
  msg::RealtimeDataCustom2 data;
  measure(device, known.flags, context.now, data);
  return context.answer(data);
}

Reaction handle(RequestContext& context, const msg::DataStreamInterval& request, Device& device) {
  switch (device.streams.change(device, context.port, request, context.now)) {
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
