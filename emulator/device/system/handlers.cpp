// spec/system.yaml: identity and restarts of the board.

#include "device/handlers.hpp"

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/roles.hpp>

#include "device/control/reported_state.hpp"
#include "device/external_motors/external_motors.hpp"
#include "device/features.hpp"
#include "device/modules/modules.hpp"
#include "device/parameters/parameters.hpp"
#include "device/storage/file_system.hpp"
#include "device/system/restarts.hpp"
#include "device/system/state_variables.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {
namespace {

/// Without a notice there is no response, because the board restarts.
template <class Request>
Reaction restart(RequestContext& context, Restarts& restarts, const Request& request,
                 bool to_bootloader) {
  if (request.confirm.has(msg::ResetOption::notify)) {
    static_cast<void>(context.answer(roles::Reset{}));
  }
  restarts.schedule(context.now + milliseconds(request.delay_ms.raw()), to_bootloader);
  return Reaction::executed;
}

}  // namespace

Reaction handle(RequestContext& context, const msg::BoardInfoRequest&, const BoardOptions& options,
                Gimbal& gimbal, const Modes& modes, const Tuning& tuning) {
  msg::BoardInfo info;
  info.board_ver = options.board;
  info.firmware_ver = options.firmware;
  info.board_features = features_of(options);
  info.board_features_ext = features_ext_of(options);
  if (context.is_usb()) info.connection_flags.set(msg::ConnectionFlag::usb);
  // Earlier firmware only says whether debug output is enabled.
  constexpr Availability since =
      sbgc::detail::field_info<msg::RealtimeData4>("system_state_flags").since;
  if (is_available(since, context.versions())) {
    info.debug_mode = msg::BoardStateFlags(
        static_cast<std::uint8_t>(state_flags(gimbal, modes, tuning, context.now).raw()));
    info.base_frw_ver = options.firmware;
  }
  return context.answer(info);
}

Reaction handle(RequestContext& context, const msg::BoardInfo3Request&, const BoardOptions& options,
                const Memory& memory, const FileSystem& files, const Parameters& parameters) {
  msg::BoardInfo3 info;
  info.device_id = options.device_id;
  info.mcu_id = options.mcu_id;
  info.eeprom_size = msg::LongByteCount(static_cast<std::uint32_t>(memory.eeprom.size()));
  // Assumption: the script of a slot is the file with the number of the slot.
  std::uint16_t file = 0;
  for (msg::ByteCount& size : info.script_slot_size) size = msg::ByteCount(files.size(file++));
  for (msg::ByteCount& size : info.script_slot_6_to_10_size)
    size = msg::ByteCount(files.size(file++));
  if (is_supported<msg::ProfileSet>(context.versions())) {
    std::uint8_t slots = 0;
    for (std::size_t i = 0; i < memory.profile_sets.size(); ++i) {
      if (!memory.profile_sets[i].empty()) slots |= static_cast<std::uint8_t>(1U << i);
    }
    info.profile_set_slots = msg::StoredProfileSets(slots);
    info.profile_set_cur = memory.profile_set;
  }
  info.board_features_ext2 = features_ext2_of(options);
  info.can_drv_main_limit = static_cast<std::uint8_t>(can_drivers(options) == 0 ? 0 : 3);
  info.can_drv_aux_limit =
      static_cast<std::uint8_t>(ExternalMotors::are_supported(options) ? ExternalMotors::count : 0);
  info.adj_vars_total_num = parameters.variable_count();
  return context.answer(info);
}

Reaction handle(RequestContext& context, const msg::ResetRequestExt& request, Restarts& restarts) {
  return restart(context, restarts, request, false);
}

Reaction handle(RequestContext& context, const msg::BootMode3Ext& request, Restarts& restarts) {
  return restart(context, restarts, request, true);
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

Reaction handle(RequestContext& context, const msg::PassProtectReadRequest&, const Memory& memory) {
  return context.answer(msg::PassProtectRead{.flags = msg::PassProtectFlags(memory.pass_protect)});
}

/// The flags are kept. A board without a password never requires one, whatever is written.
Reaction handle(RequestContext& context, const msg::PassProtectWrite& request, Memory& memory,
                BoardOptions& options) {
  if (!options.password.empty() && request.new_password.size() != 0) {
    options.password.assign(request.new_password.data(), request.new_password.size());
  }
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
