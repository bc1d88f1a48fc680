/// Progress of tasks that exchange many messages.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace sbgc {

/// The progress of a task. `what` is the next step; valid only during the call.
struct Progress {
  std::size_t done{};  ///< of `total`, in the unit of the operation
  std::size_t total{};
  std::string_view what{};  ///< for people
};

/// Called before each step and at the end, on the thread of the task. Returning false cancels it.
using ProgressHandler = std::function<bool(const Progress&)>;

}  // namespace sbgc
