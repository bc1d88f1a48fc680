// spec/peripherals.yaml: pins, servos, sounds, I2C, virtual channels.

#include "device/handlers.hpp"

#include "device/device.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

Verdict read_i2c(RequestContext& context, msg::I2cDevice chip, std::uint8_t address,
                 msg::SmallByteCount size) {
  Device& device = context.device;
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

Verdict handle(RequestContext& context, const msg::TriggerPin& request) {
  const bool switched =
      context.device.outputs.set_pin(context.device, request.pin_id, request.state);
  return switched ? context.confirm() : RequestContext::ignore();
}

Verdict handle(RequestContext& context, const msg::ServoOut& request) {
  const bool fits = context.device.outputs.set_servos(context.device, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Verdict handle(RequestContext& context, const msg::ServoOutExt& request) {
  const bool fits = context.device.outputs.set_servos(context.device, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Verdict handle(RequestContext& context, const msg::BeepSound& request) {
  const bool plays = context.device.outputs.play(request, context.now);
  return plays ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequest& request) {
  return read_i2c(context, request.device_addr, request.reg_addr, request.data_len);
}
/// Assumption: the first register, as the emulated chips have no pointer of their own.
Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequestNoRegister& request) {
  return read_i2c(context, request.device_addr, 0, request.data_len);
}
/// Assumption: the emulated chips use the lower byte of the address.
Verdict handle(RequestContext& context, const msg::I2cReadRegBufRequestWideRegister& request) {
  return read_i2c(context, request.device_addr, static_cast<std::uint8_t>(request.reg_addr),
                  request.data_len);
}

Verdict handle(RequestContext& context, const msg::I2cWriteRegBuf& request) {
  Device& device = context.device;
  if (!I2cBus::answers(device, request.device_addr)) {
    return context.refuse(msg::BoardErrorCode::operation_failed);
  }
  device.i2c.write(device, request.device_addr, request.reg_addr, request.data);
  return context.confirm();
}

Verdict handle(RequestContext& context, const msg::ApiVirtChControl& request) {
  context.device.remote.set_channels(context.device, request, context.now);
  return context.confirm();
}

Verdict handle(RequestContext& context, const msg::ApiVirtChHighRes& request) {
  context.device.remote.set_channels(context.device, request, context.now);
  return context.confirm();
}

/// Inputs that are not in use read as undefined, even if the host lets the board set them up.
Verdict handle(RequestContext& context, const msg::ReadRcInputsRequest& request) {
  msg::ReadRcInputs answer;
  for (const msg::RcMap source : request.rc_src) {
    const auto signal = context.device.remote.signal(source);
    answer.rc_val.push_back(signal ? saturated<msg::FineRcSignal>(*signal)
                                   : msg::FineRcSignal(msg::RealtimeDataCustom::undefined));
  }
  return context.answer(answer);
}

}  // namespace sbgc::emulator
