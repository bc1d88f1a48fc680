// spec/peripherals.yaml: pins, servos, sounds, I2C, virtual channels.

#include "device/handlers.hpp"

#include <algorithm>
#include <cstdint>

#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

Reaction read_i2c(RequestContext& context, Device& device, msg::I2cDevice chip,
                  std::uint8_t address, msg::SmallByteCount size) {
  if (!I2cBus::answers(device, chip)) {
    return context.refuse(msg::BoardErrorCode::operation_failed);
  }
  if (size.raw() == 0) return context.refuse(msg::BoardErrorCode::wrong_params);
  const auto bytes = device.i2c.read(device, chip, address, size.raw(), context.now);
  msg::I2cReadRegBuf answer;
  for (const std::uint8_t byte : bytes) answer.data.push_back(byte);
  return context.answer(answer);
}

}  // namespace

Reaction handle(RequestContext& context, const msg::TriggerPin& request, Device& device) {
  using enum msg::PinState;
  const bool switched = device.outputs.set_pin(device, request.pin_id, request.state);
  if (!switched) return RequestContext::ignore();
  if (request.state != input_pull_up && request.state != input_pull_down) return context.confirm();
  // Nothing is connected, so the pull decides.
  const std::int8_t level = request.state == input_pull_up ? 1 : 0;
  return context.confirm({.pin_id = request.pin_id, .pin_state = level});
}

Reaction handle(RequestContext& context, const msg::ServoOut& request, Outputs& outputs,
                Parameters& parameters) {
  const bool fits = outputs.set_servos(parameters, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::ServoOutFour& request, Outputs& outputs,
                Parameters& parameters) {
  msg::ServoOut all;
  all.servo_time.fill(msg::ServoPulse(msg::ServoOut::floating));
  std::ranges::copy(request.servo_time, all.servo_time.begin());
  return handle(context, all, outputs, parameters);
}

Reaction handle(RequestContext& context, const msg::ServoOutExt& request, Outputs& outputs,
                Parameters& parameters) {
  const bool fits = outputs.set_servos(parameters, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::BeepSound& request, Outputs& outputs) {
  const bool plays = outputs.play(request, context.now);
  return plays ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::I2cReadRegBufRequest& request, Device& device) {
  return read_i2c(context, device, request.device_addr, request.reg_addr, request.data_len);
}
/// Assumption: the first register, as the emulated chips have no pointer of their own.
Reaction handle(RequestContext& context, const msg::I2cReadRegBufRequestNoRegister& request,
                Device& device) {
  return read_i2c(context, device, request.device_addr, 0, request.data_len);
}
/// Assumption: the emulated chips use the lower byte of the address.
Reaction handle(RequestContext& context, const msg::I2cReadRegBufRequestWideRegister& request,
                Device& device) {
  return read_i2c(context, device, request.device_addr, static_cast<std::uint8_t>(request.reg_addr),
                  request.data_len);
}

Reaction handle(RequestContext& context, const msg::I2cWriteRegBuf& request, Device& device) {
  if (!I2cBus::answers(device, request.device_addr)) {
    return context.refuse(msg::BoardErrorCode::operation_failed);
  }
  device.i2c.write(device, request.device_addr, request.reg_addr, request.data);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ApiVirtChControl& request, Device& device) {
  device.remote.set_channels(device, request, context.now);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ApiVirtChHighRes& request, Device& device) {
  device.remote.set_channels(device, request, context.now);
  return context.confirm();
}

/// Inputs that are not in use read as undefined, even if the host lets the board set them up.
Reaction handle(RequestContext& context, const msg::ReadRcInputsRequest& request,
                RemoteControl& remote) {
  msg::ReadRcInputs answer;
  for (const msg::RcMap source : request.rc_src) {
    const auto signal = remote.signal(source);
    answer.rc_val.push_back(signal ? saturated<msg::FineRcSignal>(*signal)
                                   : msg::FineRcSignal(msg::RealtimeDataCustom::undefined));
  }
  return context.answer(answer);
}

}  // namespace sbgc::emulator
