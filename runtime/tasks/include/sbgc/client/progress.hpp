/// Progress of tasks that exchange many messages.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace sbgc {

/// The progress of a task. `what` is the next step; valid only during the call.
struct Progress {
  std::size_t done{};
  std::size_t total{};
  std::string_view what{};
};

/// Called before each step and at the end, on the thread of the task. Returning false cancels it.
using ProgressHandler = std::function<bool(const Progress&)>;

}  // namespace sbgc
