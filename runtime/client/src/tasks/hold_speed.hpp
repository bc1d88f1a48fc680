/// A held speed, shared by its owner and the task that sends it.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include <sbgc/client/task.hpp>

#include "tasks/bounded_turn.hpp"
#include "tasks/dead_mans_switch.hpp"

namespace sbgc::detail {

/// The wishes of the owner and their results. Thread-safe. Wake the task after each change.
class HeldSpeed {
 public:
  explicit HeldSpeed(const DeadMansSwitch& rules) : rules_(rules) {}

  // For the owner.

  /// Applies `change(rules)`, unless sending has failed, or the camera is to stop for ever.
  template <class Change>
  Result<void> with(const Change& change) {
    const std::scoped_lock lock(mutex_);
    if (error_) return *error_;
    if (is_closing_) return ClientError{ErrorCode::cancelled, "the camera has been stopped"};
    return change(rules_);
  }
  /// Stops the camera, until it is to turn again.
  Result<void> stop() {
    const std::scoped_lock lock(mutex_);
    if (error_) return *error_;
    rules_.stop();
    return {};
  }
  /// Waits until there is nothing to send; `now()` is the time of the task.
  template <class Now>
  Result<void> wait(const Now& now) {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [&] { return is_settled(now()); });
    return error_ ? Result<void>(*error_) : Result<void>();
  }
  /// True if wait() would return at once.
  bool has_settled(Instant now) const {
    const std::scoped_lock lock(mutex_);
    return is_settled(now);
  }
  DeadMansSwitch::State state() const {
    const std::scoped_lock lock(mutex_);
    return rules_.state();
  }
  /// Stops the camera for ever, and ends the task.
  void close() {
    const std::scoped_lock lock(mutex_);
    rules_.stop();
    is_closing_ = true;
  }

  // For the task.

  struct Order {
    DeadMansSwitch::Action action{};
    DeadMansSwitch::Speed speed{};
    bool is_last = false;            ///< nothing remains to be done
    Instant until = Instant::never;  ///< for Action::none: when to call next() again
  };
  Order next(Instant now);
  void done(DeadMansSwitch::Action action, Result<void> result, Instant now);

 private:
  bool is_settled(Instant now) const { return is_idle_ && rules_.deadline(now) > now; }

  mutable std::mutex mutex_;
  std::condition_variable idle_;
  DeadMansSwitch rules_;
  std::optional<ClientError> error_{};
  bool is_closing_ = false;
  bool is_idle_ = false;
};

/// Turns with the speeds of the owner until it closes `speed`.
Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed, BoundedTurn motion);

}  // namespace sbgc::detail
