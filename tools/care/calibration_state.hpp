/// The state of calibrations.
#pragma once

#include <sbgc/client/client.hpp>

namespace sbgc::tools {

/// Prints what is calibrated, for people. Throws CommandError.
void print_calibration_state(Client& client);

}  // namespace sbgc::tools
