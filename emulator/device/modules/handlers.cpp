// spec/modules.yaml: modules on the CAN bus.

#include "device/handlers.hpp"

#include <algorithm>
#include <array>

#include <sbgc/framing.hpp>
#include <sbgc/roles.hpp>

#include "device/features.hpp"
#include "device/modules/modules.hpp"

namespace sbgc::emulator {
namespace {

constexpr msg::ModuleVersion hardware_version(100);

/// The only request that the emulated modules answer: their identity.
Reaction introduce(RequestContext& context, const BoardOptions& options,
                   const msg::TransparentSapiRequest& request, std::uint16_t firmware) {
  msg::BoardInfo info;
  info.board_ver = options.board;
  info.firmware_ver = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware * 10U));
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = encode_frame(info, frame);
  msg::TransparentSapi answer;
  answer.target = request.target;
  for (std::size_t i = 0; i < written.size; ++i) answer.payload.push_back(frame[i]);
  return context.answer(answer);
}

/// Refuses with the module and the part, as in errors of these requests.
Reaction refuse_part(RequestContext& context, msg::ModuleId module, std::uint8_t packet) {
  return context.refuse(msg::BoardErrorCode::wrong_params,
                        static_cast<std::uint32_t>(module) | std::uint32_t{packet} << 16U);
}

}  // namespace

Reaction handle(RequestContext& context, const msg::ModuleFlashStart& request,
                const BoardOptions& options, ModuleFlash& flash) {
  const auto modules = modules_of(options);
  const bool exists = std::any_of(modules.begin(), modules.end(), [&](const Module& module) {
    return module.id == request.device_id;
  });
  if (!exists || !flash.start(request)) return refuse_part(context, request.device_id, 0);
  return context.confirm();
}
Reaction handle(RequestContext& context, const msg::ModuleFlashWrite& request, ModuleFlash& flash) {
  if (!flash.write(request)) return refuse_part(context, request.device_id, flash.next_packet());
  return context.confirm();
}
Reaction handle(RequestContext& context, const msg::ModuleFlashFinish& request,
                ModuleFlash& flash) {
  if (!flash.finish(request)) return refuse_part(context, request.device_id, flash.next_packet());
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ModuleListRequest&,
                const BoardOptions& options) {
  msg::ModuleList list;
  for (const Module& module : modules_of(options)) {
    msg::ModuleInfo info;
    info.id = module.id;
    info.board_ver = info.bootloader_ver = hardware_version;
    info.firmware_ver = msg::ModuleVersion(module.firmware);
    list.modules.push_back(info);
  }
  return context.answer(list);
}

Reaction handle(RequestContext& context, const msg::CanDeviceScanRequest&,
                const BoardOptions& options) {
  if (!features_of(options).has(msg::BoardFeature::can_port)) {
    return context.refuse(msg::BoardErrorCode::not_supported);
  }
  msg::CanDeviceScan scan;
  for (const Module& module : modules_of(options)) {
    msg::CanDevice one;
    // Derived from the id of the board, so that no two emulated boards have the same device.
    one.uid = options.mcu_id;
    one.uid[0] = static_cast<std::uint8_t>(module.can_id);
    one.id = module.can_id;
    static_cast<void>(one.type.set_kind(module.kind));
    scan.devices.push_back(one);
  }
  return context.answer(scan);
}

/// Assumption: data for a device that does not exist are lost.
Reaction handle(RequestContext& context, const msg::TransparentSapiRequest& request,
                const BoardOptions& options) {
  for (const Module& module : modules_of(options)) {
    if (module.transparent == msg::TransparentDevice{}) continue;
    if (module.transparent != request.target.device()) continue;
    Reaction reaction = Reaction::executed;
    Parser parser;
    parser.feed(std::span(request.payload.data(), request.payload.size()), [&](const Frame& frame) {
      if (frame.id != roles::introduction_request_id) return;
      reaction = introduce(context, options, request, module.firmware);
    });
    return reaction;
  }
  return RequestContext::ignore();
}

}  // namespace sbgc::emulator
