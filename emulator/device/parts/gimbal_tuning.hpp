/// What the parameters mean for the mechanics.
#pragma once

#include <sbgc/availability.hpp>
#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/types.hpp>

#include "device/parts/parameters.hpp"

namespace sbgc::emulator {

/// Without encoders the limits of the joints are not kept. `battery_factor`: what the sensor shows
/// of one volt; 0: there is no sensor.
Tuning tuning_of(const Parameters& parameters, const Availability& versions, bool has_encoders,
                 double battery_factor);

/// The angles that the camera starts with and comes home to.
Axes<double> home_angles(const Parameters& parameters);

}  // namespace sbgc::emulator
