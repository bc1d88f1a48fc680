/// The capabilities of a board and its firmware: features, and fields and values of messages.
#pragma once

#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board_options.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::emulator {

Availability versions_of(const BoardOptions& options);
msg::BoardFeatures features_of(const BoardOptions& options);
msg::BoardFeaturesExt features_ext_of(const BoardOptions& options);
msg::BoardFeaturesExt2 features_ext2_of(const BoardOptions& options);
/// True if there are encoders, which measure the joint angles.
inline bool has_encoders(const BoardOptions& options) {
  return options.features.has(msg::BoardFeature::encoders);
}
/// True if there is a sensor for the battery voltage.
inline bool has_battery_meter(const BoardOptions& options) {
  return options.features.has(msg::BoardFeature::bat_monitoring);
}

/// True if boards with these versions support a value.
template <class E>
constexpr bool knows(const Availability& versions, E value) {
  for (const ValueInfo& info : EnumMeta<E>::values) {
    if (info.value == static_cast<std::int64_t>(value)) return is_available(info.since, versions);
  }
  return false;
}

/// Limits the message with this table: removes optional fields that do not exist yet, and clears
/// fields that are still reserved and meaningless flags. Keeps enum values, but returns true if one
/// does not exist yet.
bool limit_to(const Availability& versions, const sbgc::detail::StructTable& table, void* message);

template <Message M>
bool limit_to(const Availability& versions, M& message) {
  return limit_to(versions, sbgc::detail::table_of<M>(), &message);
}

}  // namespace sbgc::emulator
