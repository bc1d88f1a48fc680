/// Events for a task from other threads.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include <sbgc/client/task.hpp>

namespace sbgc::detail {

/// Thread-safe. Shared with handlers, which may run after the task is done.
class TaskInbox {
 public:
  using Input = std::function<void(TaskMachine&)>;

  void put(Input input) {
    {
      const std::lock_guard lock(mutex_);
      inputs_.push_back(std::move(input));
    }
    changed_.notify_all();
  }

  /// Passes all events to the task.
  void empty_into(TaskMachine& task) {
    std::vector<Input> inputs;
    {
      const std::lock_guard lock(mutex_);
      inputs.swap(inputs_);
    }
    for (const Input& input : inputs) input(task);
  }

  /// Calls `wait(lock, changed)` if the inbox is empty; put() notifies `changed`.
  template <class Wait>
  void wait(const Wait& wait) {
    std::unique_lock lock(mutex_);
    if (inputs_.empty()) wait(lock, changed_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Input> inputs_;
};

}  // namespace sbgc::detail
