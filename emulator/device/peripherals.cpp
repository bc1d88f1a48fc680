// spec/peripherals.yaml: pins, servos, sounds, I2C, virtual channels.

#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {

Outcome handle(RequestContext& context, const msg::TriggerPin& request) {
  const bool switched =
      context.device.outputs.set_pin(context.device, request.pin_id, request.state);
  return switched ? context.confirm() : RequestContext::ignore();
}

Outcome handle(RequestContext& context, const msg::ServoOut& request) {
  const bool fits = context.device.outputs.set_servos(context.device, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Outcome handle(RequestContext& context, const msg::BeepSound& request) {
  const bool plays = context.device.outputs.play(request, context.now);
  return plays ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Outcome handle(RequestContext& context, const msg::I2cReadRegBufRequest& request) {
  Device& device = context.device;
  if (!I2cBus::answers(device, request.device_addr)) {
    return context.refuse(msg::BoardErrorCode::operation_failed);
  }
  if (request.data_len.raw() == 0) return context.refuse(msg::BoardErrorCode::wrong_params);
  const auto bytes = device.i2c.read(device, request.device_addr, request.reg_addr,
                                     request.data_len.raw(), context.now);
  msg::I2cReadRegBuf answer;
  for (const std::uint8_t byte : bytes) answer.data.push_back(byte);
  return context.answer(answer);
}

Outcome handle(RequestContext& context, const msg::I2cWriteRegBuf& request) {
  Device& device = context.device;
  if (!I2cBus::answers(device, request.device_addr)) {
    return context.refuse(msg::BoardErrorCode::operation_failed);
  }
  device.i2c.write(device, request.device_addr, request.reg_addr, request.data);
  return context.confirm();
}

Outcome handle(RequestContext& context, const msg::ApiVirtChControl& request) {
  context.device.remote.set_channels(context.device, request, context.now);
  return context.confirm();
}

}  // namespace sbgc::emulator
