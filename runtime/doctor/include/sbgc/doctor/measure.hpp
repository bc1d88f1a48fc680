/// Measuring a gimbal.
#pragma once

#include <chrono>
#include <functional>

#include <sbgc/client/task.hpp>
#include <sbgc/doctor/measurements.hpp>

namespace sbgc {

/// Options of measure().
struct MeasureOptions {
  /// The time for the samples; reading the state takes a little more.
  std::chrono::milliseconds time{5'000};
  /// Called several times per second with the elapsed time. Returning false ends the measurement
  /// with ErrorCode::cancelled.
  std::function<bool(double seconds)> progress{};
};

namespace tasks {

/// Measures a gimbal for some time; doctor::findings_of() judges the result. Only reads: it starts
/// its own data stream if the firmware has streams and no other host of the line uses the same one,
/// and otherwise polls each sample. Fails if the board does not answer. The results do not include
/// measurements of the line: add() takes them from the client.
Task<Result<doctor::Measurements>> measure(MeasureOptions options = {});

}  // namespace tasks
}  // namespace sbgc
