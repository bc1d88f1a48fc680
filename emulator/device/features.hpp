/// What a board and its firmware have, by its options.
#pragma once

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board_options.hpp>

namespace sbgc::emulator {

Availability versions_of(const BoardOptions& options);
msg::BoardFeatures features_of(const BoardOptions& options);
msg::BoardFeaturesExt features_ext_of(const BoardOptions& options);
msg::BoardFeaturesExt2 features_ext2_of(const BoardOptions& options);
/// True if there are encoders, which measure the joint angles.
bool has_encoders(const BoardOptions& options);
/// True if there is a sensor for the battery voltage.
bool has_battery_meter(const BoardOptions& options);

}  // namespace sbgc::emulator
