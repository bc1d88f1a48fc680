/// Holding a speed for an owner in another thread.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include <sbgc/client/task.hpp>

#include "tasks/dead_mans_switch.hpp"

namespace sbgc::detail {

/// What the owner of a speed wants, and what has become of it. Thread-safe. After a change the task
/// is to be woken.
class HeldSpeed {
 public:
  explicit HeldSpeed(const DeadMansSwitch& rules) : rules_(rules) {}

  // For the owner

  /// Changes it with `change(rules)`, unless sending has failed.
  template <class Change>
  Result<void> with(const Change& change) {
    const std::scoped_lock lock(mutex_);
    if (error_) return *error_;
    return change(rules_);
  }
  /// Waits until nothing is to be sent; `now()` is the time of the task.
  template <class Now>
  Result<void> wait(const Now& now) {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [&] { return is_idle_ && rules_.deadline(now()) > now(); });
    return error_ ? Result<void>(*error_) : Result<void>();
  }
  DeadMansSwitch::State state() const {
    const std::scoped_lock lock(mutex_);
    return rules_.state();
  }
  /// Stops the camera and ends the task.
  void close() {
    const std::scoped_lock lock(mutex_);
    rules_.stop();
    is_closing_ = true;
  }

  // For the task

  struct Order {
    DeadMansSwitch::Action action{};
    DeadMansSwitch::Speed speed{};
    bool is_last = false;            ///< nothing is to be done any more
    Instant until = Instant::never;  ///< of Action::none: when to ask again
  };
  Order next(Instant now);
  void done(DeadMansSwitch::Action action, Result<void> result, Instant now);

 private:
  mutable std::mutex mutex_;
  std::condition_variable idle_;
  DeadMansSwitch rules_;
  std::optional<ClientError> error_{};
  bool is_closing_ = false;
  bool is_idle_ = false;
};

/// Sends what the owner wants until that closes it.
Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed);

}  // namespace sbgc::detail
