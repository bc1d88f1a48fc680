/// Measuring a gimbal for `sbgc doctor`.
#pragma once

#include <chrono>
#include <functional>

#include <sbgc/client/client.hpp>

#include "care/doctor/measurements.hpp"

namespace sbgc::tools {

/// Measures for this long. Only reads: it starts a data stream of its own if the firmware has
/// streams and no other host of the line uses the same one, and otherwise asks for each sample.
/// `progress` is called several times per second. Ends early after a signal. Throws CommandError if
/// the board does not answer.
Measurements measure(Client& client, std::chrono::milliseconds time,
                     const std::function<void(double seconds)>& progress);

}  // namespace sbgc::tools
