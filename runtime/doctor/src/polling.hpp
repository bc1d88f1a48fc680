/// Sampling with requests, at a fixed rate.
#pragma once

#include <functional>

#include <sbgc/analysis/uniform_samples.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::doctor {

/// Returns the newest values, after the time that an answer takes.
using Ask = std::function<Task<Result<Axes<double>>>()>;

/// Asks once per interval for `time`. An answer that is late is the sample of its time,
/// so that others are missing. Ends as soon as too many are: then, the samples are not usable.
Task<Result<analysis::UniformSamples>> poll_at(Ask ask, Duration interval, Duration time);

/// Samples for `time` at the highest rate at which the board keeps up: begins with the time in
/// which it answers almost always, and again at half of the rate if too many samples are missing.
Task<Result<analysis::UniformSamples>> poll_often(Ask ask, Duration time);

constexpr double in_seconds(Duration duration) { return 1e-6 * static_cast<double>(duration.us); }

}  // namespace sbgc::doctor
