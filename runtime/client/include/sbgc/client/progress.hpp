/// How tasks of many messages tell how far they are.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace sbgc {

/// How far a task is; `what` is the step that is done next, valid during the call only.
struct Progress {
  std::size_t done{};
  std::size_t total{};
  std::string_view what{};
};

/// Called before each step and once at the end, on the thread of the task. False cancels the task.
using ProgressHandler = std::function<bool(const Progress&)>;

}  // namespace sbgc
