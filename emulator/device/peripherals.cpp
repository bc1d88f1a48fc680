/// Requests about pins, servos, sound and I2C.
#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {

Outcome handle(Turn& turn, const msg::TriggerPin& request) {
  const bool switched = turn.machine.outputs.set_pin(turn.machine, request.pin_id, request.state);
  return switched ? turn.confirm() : Turn::ignore();
}

Outcome handle(Turn& turn, const msg::ServoOut& request) {
  const bool fits = turn.machine.outputs.set_servos(turn.machine, request);
  return fits ? turn.confirm() : turn.refuse(msg::BoardErrorCode::wrong_params);
}

Outcome handle(Turn& turn, const msg::BeepSound& request) {
  const bool plays = turn.machine.outputs.play(request, turn.now);
  return plays ? turn.confirm() : turn.refuse(msg::BoardErrorCode::wrong_params);
}

Outcome handle(Turn& turn, const msg::I2cReadRegBufRequest& request) {
  Machine& machine = turn.machine;
  if (!I2cBus::answers(machine, request.device_addr)) {
    return turn.refuse(msg::BoardErrorCode::operation_failed);
  }
  if (request.data_len.raw() == 0) return turn.refuse(msg::BoardErrorCode::wrong_params);
  const auto bytes = machine.i2c.read(machine, request.device_addr, request.reg_addr,
                                      request.data_len.raw(), turn.now);
  msg::I2cReadRegBuf answer;
  for (const std::uint8_t byte : bytes) answer.data.push_back(byte);
  return turn.answer(answer);
}

Outcome handle(Turn& turn, const msg::I2cWriteRegBuf& request) {
  Machine& machine = turn.machine;
  if (!I2cBus::answers(machine, request.device_addr)) {
    return turn.refuse(msg::BoardErrorCode::operation_failed);
  }
  machine.i2c.write(machine, request.device_addr, request.reg_addr, request.data);
  return turn.confirm();
}

}  // namespace sbgc::board
