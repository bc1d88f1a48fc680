// spec/system.yaml: identity and restarts of the board.

#include "device/handlers.hpp"

#include <sbgc/detail/meta_limits.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/roles.hpp>

#include "device/modules/modules.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {
namespace {

Reaction introduce(RequestContext& context, Device& device) {
  const BoardOptions& options = device.options;
  msg::BoardInfo info;
  info.board_ver = options.board;
  info.firmware_ver = options.firmware;
  info.board_features = device.features();
  info.board_features_ext = device.features_ext();
  if (device.ports.is_usb(context.port)) info.connection_flags.set(msg::ConnectionFlag::usb);
  // Earlier firmware only says whether debug output is enabled.
  constexpr Availability since =
      sbgc::detail::field_info<msg::RealtimeData4>("system_state_flags").since;
  if (is_available(since, context.versions())) {
    info.debug_mode =
        msg::BoardStateFlags(static_cast<std::uint8_t>(state_flags(device, context.now).raw()));
    info.base_frw_ver = options.firmware;
  }
  return context.answer(info);
}

/// Without a notice there is no response, because the board restarts.
Reaction restart(RequestContext& context, Restarts& restarts, bool notify, msg::Milliseconds delay,
                 bool to_bootloader) {
  if (notify) static_cast<void>(context.answer(roles::Reset{}));
  restarts.schedule(context.now + milliseconds(delay.raw()), to_bootloader);
  return Reaction::executed;
}

}  // namespace

Reaction handle(RequestContext& context, const msg::BoardInfoRequest& /*request*/, Device& device) {
  return introduce(context, device);
}

Reaction handle(RequestContext& context, const msg::BoardInfoRequestOneByte& /*request*/,
                Device& device) {
  return introduce(context, device);
}

// The configuration is for Bluetooth LE modules between board and host, which are not emulated.
Reaction handle(RequestContext& context, const msg::BoardInfoRequestExt& /*request*/,
                Device& device) {
  return introduce(context, device);
}

Reaction handle(RequestContext& context, const msg::BoardInfo3Request& /*request*/,
                Device& device) {
  msg::BoardInfo3 info;
  info.device_id = device.options.device_id;
  info.mcu_id = device.options.mcu_id;
  info.eeprom_size = msg::LongByteCount(static_cast<std::uint32_t>(device.eeprom.size()));
  // Assumption: the script of a slot is the file with the number of the slot.
  std::uint16_t file = 0;
  for (msg::ByteCount& size : info.script_slot_size)
    size = msg::ByteCount(device.files.size(file++));
  for (msg::ByteCount& size : info.script_slot_6_to_10_size)
    size = msg::ByteCount(device.files.size(file++));
  if (is_supported<msg::ProfileSet>(context.versions())) {
    std::uint8_t slots = 0;
    for (std::size_t i = 0; i < device.memory.profile_sets.size(); ++i) {
      if (!device.memory.profile_sets[i].empty()) slots |= static_cast<std::uint8_t>(1U << i);
    }
    info.profile_set_slots = msg::StoredProfileSets(slots);
    info.profile_set_cur = device.memory.profile_set;
  }
  info.board_features_ext2 = device.features_ext2();
  info.can_drv_main_limit = static_cast<std::uint8_t>(can_drivers(device) == 0 ? 0 : 3);
  info.can_drv_aux_limit =
      static_cast<std::uint8_t>(ExternalMotors::are_supported(device) ? ExternalMotors::count : 0);
  info.adj_vars_total_num = device.parameters.variable_count();
  return context.answer(info);
}

Reaction handle(RequestContext& context, const msg::ResetRequest& /*request*/, Restarts& restarts) {
  return restart(context, restarts, false, {}, false);
}

Reaction handle(RequestContext& context, const msg::ResetRequestExt& request, Restarts& restarts) {
  return restart(context, restarts, request.confirm.has(msg::ResetOption::notify), request.delay_ms,
                 false);
}

Reaction handle(RequestContext& context, const msg::BootMode3& /*request*/, Restarts& restarts) {
  return restart(context, restarts, false, {}, true);
}

Reaction handle(RequestContext& context, const msg::BootMode3Ext& request, Restarts& restarts) {
  return restart(context, restarts, request.confirm.has(msg::ResetOption::notify), request.delay_ms,
                 true);
}

Reaction handle(RequestContext& context, const msg::ReadStateVarsRequest&,
                StateVariables& state_variables, Gimbal& gimbal) {
  return context.answer(state_variables.values(gimbal, context.now));
}

Reaction handle(RequestContext& context, const msg::WriteStateVars& request,
                StateVariables& state_variables, Memory& memory) {
  state_variables.write(memory, request, context.now);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::PassProtectReadRequest& /*request*/,
                Memory& memory) {
  return context.answer(msg::PassProtectRead{.flags = msg::PassProtectFlags(memory.pass_protect)});
}

/// Only the flags are kept: the emulated board asks nobody for a password.
Reaction handle(RequestContext& context, const msg::PassProtectWrite& request, Memory& memory) {
  if (memory.is_unsaved || memory.pass_protect != request.flags.raw()) ++memory.revision;
  memory.pass_protect = request.flags.raw();
  return context.confirm();
}

/// The keys of real boards are secret: this signature only depends on board and message.
Reaction handle(RequestContext& context, const msg::SignMessageRequest& request,
                const BoardOptions& options) {
  msg::SignMessage answer;
  std::uint64_t state = request.sign_type;
  for (const std::uint8_t byte : options.device_id) {
    state = random_bits(state, byte);
  }
  for (const std::uint8_t byte : request.message) state = random_bits(state, byte);
  std::uint64_t index = 0;
  for (std::uint8_t& byte : answer.signature) {
    byte = static_cast<std::uint8_t>(random_bits(state, index++));
  }
  return context.answer(answer);
}

}  // namespace sbgc::emulator
