/// Measuring a gimbal.
#pragma once

#include <chrono>
#include <functional>

#include <sbgc/client/task.hpp>
#include <sbgc/doctor/measurements.hpp>

namespace sbgc {

/// Options of measure().
struct MeasureOptions {
  /// For the samples; reading the state takes a little more.
  std::chrono::milliseconds time{5'000};
  /// Called several times per second with the time so far. Returning false ends the measuring with
  /// ErrorCode::cancelled.
  std::function<bool(double seconds)> progress{};
};

namespace tasks {

/// Measures a gimbal for some time; doctor::findings_of() judges the result. Only reads: it starts
/// a data stream of its own if the firmware has streams and no other host of the line uses the same
/// one, and otherwise asks for each sample. Fails if the board does not answer. Measurements of the
/// line are not among the results: add() takes them from the client.
Task<Result<doctor::Measurements>> measure(MeasureOptions options = {});

}  // namespace tasks
}  // namespace sbgc
