// spec/peripherals.yaml: pins, servos, sounds, I2C, virtual channels.

#include "device/handlers.hpp"

#include <cstdint>

#include "device/control/menu.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/i2c_bus.hpp"
#include "device/peripherals/outputs.hpp"
#include "device/peripherals/remote_control.hpp"
#include "device/storage/eeprom.hpp"

namespace sbgc::emulator {

Reaction handle(RequestContext& context, const msg::TriggerPin& request, Outputs& outputs,
                const Parameters& parameters) {
  const bool switched =
      outputs.set_pin(parameters, context.versions(), request.pin_id, request.state);
  using enum msg::PinState;
  const bool is_input = request.state == input_pull_up || request.state == input_pull_down;
  if (!is_input) return switched ? context.confirm() : RequestContext::ignore();
  if (!knows(context.versions(), request.state)) return RequestContext::ignore();
  // Nothing is connected, so the pull decides.
  const std::int8_t level = request.state == input_pull_up ? 1 : 0;
  return context.confirm(
      {.pin_id = request.pin_id, .pin_state = switched ? level : msg::Confirm::pin_unavailable});
}

Reaction handle(RequestContext& context, const msg::ServoOut& request, Outputs& outputs,
                const Parameters& parameters) {
  const bool fits = outputs.set_servos(parameters, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::ServoOutExt& request, Outputs& outputs,
                const Parameters& parameters) {
  const bool fits = outputs.set_servos(parameters, request);
  return fits ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::BeepSound& request, Outputs& outputs) {
  const bool plays = outputs.play(request, context.now);
  return plays ? context.confirm() : context.refuse(msg::BoardErrorCode::wrong_params);
}

Reaction handle(RequestContext& context, const msg::I2cReadRegBufRequest& request,
                const I2cBus& i2c, const BoardOptions& options, const Eeprom& memory,
                Gimbal& gimbal) {
  const auto bytes = i2c.read(options, memory, gimbal, request.device_addr, request.reg_addr,
                              request.data_len.raw(), context.now);
  if (!bytes) return context.refuse(msg::BoardErrorCode::operation_failed);
  if (bytes->empty()) return context.refuse(msg::BoardErrorCode::wrong_params);
  msg::I2cReadRegBuf answer;
  for (const std::uint8_t byte : *bytes) answer.data.push_back(byte);
  return context.answer(answer);
}
Reaction handle(RequestContext& context, const msg::I2cWriteRegBuf& request, I2cBus& i2c,
                const BoardOptions& options, Eeprom& memory) {
  const bool answers =
      i2c.write(options, memory, request.device_addr, request.reg_addr, request.data);
  return answers ? context.confirm() : context.refuse(msg::BoardErrorCode::operation_failed);
}

// A signal may start any action of the menu.
Reaction handle(RequestContext& context, const msg::ApiVirtChControl& request,
                RemoteControl& remote, MenuParts& parts) {
  remote.set_channels(parts, request, context.now);
  return context.confirm();
}
Reaction handle(RequestContext& context, const msg::ApiVirtChHighRes& request,
                RemoteControl& remote, MenuParts& parts) {
  remote.set_channels(parts, request, context.now);
  return context.confirm();
}

/// Inputs that are not in use read as undefined, even if the host lets the board set them up.
Reaction handle(RequestContext& context, const msg::ReadRcInputsRequest& request,
                const RemoteControl& remote) {
  msg::ReadRcInputs answer;
  for (const msg::RcMap source : request.rc_src) {
    answer.rc_val.push_back(fine_signal(remote.signal(source)));
  }
  return context.answer(answer);
}

}  // namespace sbgc::emulator
