/// Cancels an operation of several steps.
#pragma once

#include <mutex>
#include <utility>

#include <sbgc/client/link.hpp>

namespace sbgc::detail {

/// Stops the current step, and each later one as soon as it is set. Thread-safe.
class CurrentStop {
 public:
  void set(const Stop& step) {
    {
      const std::lock_guard lock(mutex_);
      step_ = step;
      if (!is_stopped_) return;
    }
    step();
  }
  void stop() {
    Stop step;
    {
      const std::lock_guard lock(mutex_);
      is_stopped_ = true;
      step = step_;
    }
    if (step) step();
  }
  /// Stops the step again that was set before it could be stopped.
  void check() {
    Stop step;
    {
      const std::lock_guard lock(mutex_);
      if (is_stopped_) step = step_;
    }
    if (step) step();
  }

 private:
  std::mutex mutex_;
  Stop step_;
  bool is_stopped_ = false;
};

}  // namespace sbgc::detail
