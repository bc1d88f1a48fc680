// Who the board is, and its restarts.

#include <sbgc/roles.hpp>

#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

Outcome introduce(Turn& turn) {
  const Options& options = turn.machine.options;
  msg::BoardInfo info;
  info.board_ver = options.board;
  info.firmware_ver = options.firmware;
  info.board_features = options.features;
  if (turn.machine.ports.is_usb(turn.port)) info.connection_flags.set(msg::ConnectionFlag::usb);
  return turn.answer(info);
}

/// Without a notice nothing comes back: the restart is the answer.
Outcome restart(Turn& turn, bool notify, msg::Milliseconds delay, bool to_bootloader) {
  if (notify) static_cast<void>(turn.answer(roles::Reset{}));
  turn.machine.restarts.schedule(turn.now + milliseconds(delay.raw()), to_bootloader);
  return Outcome::carried_out;
}

}  // namespace

Outcome handle(Turn& turn, const msg::BoardInfoRequest& /*request*/) { return introduce(turn); }

Outcome handle(Turn& turn, const msg::BoardInfoRequestOneByte& /*request*/) {
  return introduce(turn);
}

// The configuration is for Bluetooth LE modules between board and host, of which there are none.
Outcome handle(Turn& turn, const msg::BoardInfoRequestExt& /*request*/) { return introduce(turn); }

Outcome handle(Turn& turn, const msg::BoardInfo3Request& /*request*/) {
  Machine& machine = turn.machine;
  msg::BoardInfo3 info;
  info.device_id = machine.options.device_id;
  info.mcu_id = machine.options.mcu_id;
  info.eeprom_size = msg::LongByteCount(static_cast<std::uint32_t>(machine.eeprom.size()));
  // Ours: the script of a slot is the file with the slot's number.
  std::uint16_t file = 0;
  for (msg::ByteCount& size : info.script_slot_size)
    size = msg::ByteCount(machine.files.size(file++));
  return turn.answer(info);
}

Outcome handle(Turn& turn, const msg::ResetRequest& /*request*/) {
  return restart(turn, false, {}, false);
}

Outcome handle(Turn& turn, const msg::ResetRequestExt& request) {
  return restart(turn, request.confirm.has(msg::ResetOption::notify), request.delay_ms, false);
}

Outcome handle(Turn& turn, const msg::BootMode3& /*request*/) {
  return restart(turn, false, {}, true);
}

Outcome handle(Turn& turn, const msg::BootMode3Ext& request) {
  return restart(turn, request.confirm.has(msg::ResetOption::notify), request.delay_ms, true);
}

}  // namespace sbgc::board
