/// The menu actions, started by a button, an RC signal or a request.
#pragma once

#include <cstddef>

#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

#include "device/calibration/calibrations.hpp"

namespace sbgc::emulator {

struct Device;

/// Executes an action. Returns false if there is no such action.
bool execute_menu(Device& device, msg::MenuCommand action, Instant now);

// Parts of actions

void move_to(Device& device, std::size_t axis, double angle, Instant now);
/// Starts a calibration of the selected IMU.
void begin_calibration(Device& device, Calibrations::Kind kind, Instant now);

}  // namespace sbgc::emulator
