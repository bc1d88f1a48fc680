/// Sampling with requests, at a fixed rate.
#pragma once

#include <functional>

#include <sbgc/types.hpp>

#include "signal/uniform_samples.hpp"

namespace sbgc::tools {

/// What sampling needs of its surroundings. Times are in seconds from any start.
struct PollingParts {
  std::function<double()> now{};
  std::function<void(double time)> wait_until{};
  /// Returns the newest values, after the time that an answer takes.
  std::function<Axes<double>()> ask{};
  std::function<bool()> must_end{};
};

/// Asks once per interval for `time`. An answer that is late is the sample of its time, so that
/// others are missing. Ends as soon as too many are: then, the samples are not usable.
UniformSamples poll_at(const PollingParts& parts, double interval, double time);

/// Samples for `time` at the highest rate at which the board keeps up: begins with the time in
/// which it answers almost always, and again at half of the rate if too many samples are missing.
UniformSamples poll_often(const PollingParts& parts, double time);

}  // namespace sbgc::tools
