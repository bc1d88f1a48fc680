/// Sampling by polling at a fixed rate.
#pragma once

#include <functional>

#include <sbgc/analysis/uniform_samples.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::doctor {

/// Returns the newest values, after the response time of the board.
using Ask = std::function<Task<Result<Axes<double>>>()>;

/// Polls once per interval for `time`. A late answer is the sample of its arrival time, so that
/// others are missing. Ends as soon as too many are: then the samples are unusable.
Task<Result<analysis::UniformSamples>> poll_at(Ask ask, Duration interval, Duration time);

/// Samples for `time` at the highest rate at which the board keeps up: begins with the interval in
/// which it answers almost always, and retries at half the rate if too many samples are missing.
Task<Result<analysis::UniformSamples>> poll_often(Ask ask, Duration time);

constexpr double in_seconds(Duration duration) { return 1e-6 * static_cast<double>(duration.us); }

}  // namespace sbgc::doctor
