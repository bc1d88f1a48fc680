// spec/realtime.yaml: live data, on request or streamed.

#include "device/handlers.hpp"

#include "device/imu/imus.hpp"
#include "device/realtime/live_data.hpp"
#include "device/realtime/streams.hpp"

namespace sbgc::emulator {

Reaction handle(RequestContext& context, const msg::RealtimeData&, MeasuredParts& parts) {
  return context.answer_anyway(realtime_data_3(parts, context.port, context.now));
}

Reaction handle(RequestContext& context, const msg::RealtimeData3Request&, MeasuredParts& parts) {
  return context.answer(realtime_data_3(parts, context.port, context.now));
}

Reaction handle(RequestContext& context, const msg::RealtimeData4Request&, MeasuredParts& parts) {
  return context.answer(realtime_data_4(parts, context.port, context.now));
}

Reaction handle(RequestContext& context, const msg::RealtimeDataCustomRequest& request,
                MeasuredParts& parts) {
  const auto blocks = known_blocks(context.versions(), request.flags);
  if (!blocks) return context.refuse(msg::BoardErrorCode::wrong_params, request.flags.raw());
  return context.answer(custom_data(parts, context.port, *blocks, context.now));
}

Reaction handle(RequestContext& context, const msg::RealtimeDataCustom2Request& request,
                MeasuredParts& parts) {
  msg::RealtimeDataCustom2Request known = request;
  limit_to(context.versions(), known);
  return context.answer(custom_data_2(parts, known.flags, context.now));
}

Reaction handle(RequestContext& context, const msg::DataStreamInterval& request, Streams& streams,
                Ports& ports, const BoardOptions& options, const Imus& imus, Gimbal& gimbal) {
  const auto command = static_cast<std::uint32_t>(request.cmd_id);
  if (!can_stream(options, imus, gimbal, request, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, command);
  }
  if (!streams.change(ports, context.port, request, context.now)) {
    return context.refuse(msg::BoardErrorCode::temporary, command);
  }
  return context.confirm();
}

}  // namespace sbgc::emulator
