// spec/system.yaml: identity and restarts of the board.

#include <sbgc/roles.hpp>

#include "device/device.hpp"
#include "device/handlers.hpp"

namespace sbgc::emulator {
namespace {

Outcome introduce(RequestContext& context) {
  const BoardOptions& options = context.device.options;
  msg::BoardInfo info;
  info.board_ver = options.board;
  info.firmware_ver = options.firmware;
  info.board_features = options.features;
  if (context.device.ports.is_usb(context.port))
    info.connection_flags.set(msg::ConnectionFlag::usb);
  return context.answer(info);
}

/// Without a notice there is no response, because the board restarts.
Outcome restart(RequestContext& context, bool notify, msg::Milliseconds delay, bool to_bootloader) {
  if (notify) static_cast<void>(context.answer(roles::Reset{}));
  context.device.restarts.schedule(context.now + milliseconds(delay.raw()), to_bootloader);
  return Outcome::executed;
}

}  // namespace

Outcome handle(RequestContext& context, const msg::BoardInfoRequest& /*request*/) {
  return introduce(context);
}

Outcome handle(RequestContext& context, const msg::BoardInfoRequestOneByte& /*request*/) {
  return introduce(context);
}

// The configuration is for Bluetooth LE modules between board and host, which are not emulated.
Outcome handle(RequestContext& context, const msg::BoardInfoRequestExt& /*request*/) {
  return introduce(context);
}

Outcome handle(RequestContext& context, const msg::BoardInfo3Request& /*request*/) {
  Device& device = context.device;
  msg::BoardInfo3 info;
  info.device_id = device.options.device_id;
  info.mcu_id = device.options.mcu_id;
  info.eeprom_size = msg::LongByteCount(static_cast<std::uint32_t>(device.eeprom.size()));
  // Assumption: the script of a slot is the file with the number of the slot.
  std::uint16_t file = 0;
  for (msg::ByteCount& size : info.script_slot_size)
    size = msg::ByteCount(device.files.size(file++));
  return context.answer(info);
}

Outcome handle(RequestContext& context, const msg::ResetRequest& /*request*/) {
  return restart(context, false, {}, false);
}

Outcome handle(RequestContext& context, const msg::ResetRequestExt& request) {
  return restart(context, request.confirm.has(msg::ResetOption::notify), request.delay_ms, false);
}

Outcome handle(RequestContext& context, const msg::BootMode3& /*request*/) {
  return restart(context, false, {}, true);
}

Outcome handle(RequestContext& context, const msg::BootMode3Ext& request) {
  return restart(context, request.confirm.has(msg::ResetOption::notify), request.delay_ms, true);
}

}  // namespace sbgc::emulator
