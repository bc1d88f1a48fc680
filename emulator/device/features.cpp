#include "device/features.hpp"

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/meta/system.hpp>

namespace sbgc::emulator {

Availability versions_of(const BoardOptions& options) {
  return {options.firmware.raw(), options.board.raw()};
}

msg::BoardFeatures features_of(const BoardOptions& options) {
  msg::BoardFeatures features = options.features;
  // Assumption: boards since 3.6 have a CAN bus.
  constexpr std::uint8_t first_with_can = 36;
  if (options.board.raw() >= first_with_can) features.set(msg::BoardFeature::can_port);
  return features;
}

/// A feature shows only if the firmware has its commands.
msg::BoardFeaturesExt features_ext_of(const BoardOptions& options) {
  using enum msg::BoardFeaturesExtBit;
  const Availability versions = versions_of(options);
  msg::BoardFeaturesExt features = options.features_ext;
  if (!is_supported<msg::ExtImuDebugInfoRequest>(versions)) features.set(ext_imu, false);
  if (!is_supported<msg::ReadStateVarsRequest>(versions)) features.set(state_vars, false);
  return features;
}

msg::BoardFeaturesExt2 features_ext2_of(const BoardOptions& options) {
  constexpr Availability since =
      sbgc::detail::field_info<msg::BoardInfo3>("board_features_ext2").since;
  return is_available(since, versions_of(options)) ? options.features_ext2
                                                   : msg::BoardFeaturesExt2{};
}

}  // namespace sbgc::emulator
