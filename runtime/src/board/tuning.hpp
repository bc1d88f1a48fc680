/// What the settings mean for the mechanics.
#pragma once

#include <optional>

#include <sbgc/availability.hpp>
#include <sbgc/board/gimbal.hpp>
#include <sbgc/units.hpp>

#include "settings.hpp"

namespace sbgc::board {

/// `home`: start angles instead of those of the settings. `battery_factor`: what the sensor shows
/// of one volt; 0: there is no sensor.
Tuning tuning_of(const Settings& settings, const Availability& versions,
                 const std::optional<Axes<Angle14>>& home, double battery_factor);

/// The angles that the camera starts with and comes home to.
Axes<double> home_angles(const Settings& settings, const std::optional<Axes<Angle14>>& home);

}  // namespace sbgc::board
