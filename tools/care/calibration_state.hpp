/// The state of calibrations.
#pragma once

#include <string>

#include <sbgc/client/client.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc::tools {

/// The directions of the accelerometer that are calibrated, such as "+X, -Z", or "none".
std::string calibrated_positions(const msg::CalibInfo& state);
/// Those that are not; "" if all six are.
std::string missing_positions(const msg::CalibInfo& state);

/// Prints what is calibrated, for people. Throws CommandError.
void print_calibration_state(Client& client);

}  // namespace sbgc::tools
