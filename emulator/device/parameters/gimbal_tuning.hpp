/// Conversion of parameters to the tuning of the mechanics.
#pragma once

#include <array>
#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/types.hpp>

#include "device/parameters/parameters.hpp"

namespace sbgc::emulator {

/// Without encoders the joint limits do not apply. `battery_factor` is the reading of the sensor
/// per volt; 0 means no sensor.
Tuning tuning_of(const Parameters& parameters, const Availability& versions, bool has_encoders,
                 double battery_factor);

/// The axes from the camera outward: 0 roll, 1 pitch, 2 yaw.
std::array<std::uint8_t, 3> rotation_order_of(msg::EulerOrder order);

/// The start and home angles of the camera.
Axes<double> home_angles(const Parameters& parameters);

}  // namespace sbgc::emulator
