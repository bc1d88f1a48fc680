/// What tasks of several calls have in common.
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/progress.hpp>
#include <sbgc/client/result.hpp>

namespace sbgc::detail {

/// The options of a call that may not last longer than the task it belongs to. A call ends by
/// itself long before most tasks do, so that it can be sent again; only towards the end of a task
/// there is less time than that. The last one still gets enough for an answer to come.
inline CallOptions options_within(const Deadline& deadline) {
  constexpr std::chrono::seconds enough{10};
  constexpr std::chrono::milliseconds least{250};
  CallOptions options;
  if (deadline.left() < enough) options.timeout = std::max(deadline.left(), least);
  return options;
}

/// The same error with a beginning that says what was done: "reading the file 5: timeout".
inline ClientError during(const std::string& what, ClientError error) {
  error.message = fmt::format("{}: {}", what, error.message);
  return error;
}

inline ClientError cancelled_error(const std::string& what) {
  return {ErrorCode::cancelled, fmt::format("{} was cancelled by the caller", what)};
}

inline ClientError late_error(const std::string& what) {
  return {ErrorCode::timeout, fmt::format("{} was not done in time", what)};
}

/// Tells how far a task is. Fails when it has to end: cancelled, or its time is over.
inline Result<void> go_on(const std::string& task, const ProgressHandler& progress,
                          const Progress& state, const Deadline& deadline) {
  if (progress && !progress(state)) return cancelled_error(task);
  if (state.done < state.total && deadline.is_over()) return late_error(task);
  return {};
}

}  // namespace sbgc::detail
