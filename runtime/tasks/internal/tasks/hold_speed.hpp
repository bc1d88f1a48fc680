/// A held speed, shared by its owner and the task that sends it.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <sbgc/client/task.hpp>

#include "lock.hpp"
#include "tasks/bounded_turn.hpp"
#include "tasks/dead_mans_switch.hpp"

namespace sbgc::detail {

/// The wishes of the owner and their results. With a lock, thread-safe. Wake the task after each
/// change.
class HeldSpeed {
 public:
  /// The order of the client's tasks: a new number, and whether one is superseded.
  struct Order {
    std::function<TaskNumber()> begin{};
    std::function<bool(TaskNumber)> is_superseded{};
  };

  HeldSpeed(const DeadMansSwitch& rules, Order order, LockPointer lock = nullptr)
      : lock_(std::move(lock)), rules_(rules), order_(std::move(order)) {}
  HeldSpeed(const HeldSpeed&) = delete;
  HeldSpeed& operator=(const HeldSpeed&) = delete;
  virtual ~HeldSpeed() = default;

  // For the owner.

  /// Turns with this speed. Fails if sending has failed, if the camera is to stop for ever, and
  /// once if another task has superseded the motion.
  Result<void> set(const DeadMansSwitch::Speed& speed, Instant now);
  /// Keeps the speed. Fails if the camera does not turn.
  Result<void> refresh(Instant now);
  /// Stops the camera, until it is to turn again.
  Result<void> stop() {
    const Holding holding(lock_);
    if (error_) return *error_;
    superseded_.reset();
    rules_.stop();
    return {};
  }
  /// The error of sending, if it has failed.
  Result<void> outcome() const {
    const Holding holding(lock_);
    return error_ ? Result<void>(*error_) : Result<void>();
  }
  /// True if nothing remains to be sent immediately.
  bool has_settled(Instant now) const {
    const Holding holding(lock_);
    return is_settled(now);
  }
  DeadMansSwitch::State state() const {
    const Holding holding(lock_);
    return rules_.state();
  }
  /// Stops the camera for ever, and ends the task.
  void close() {
    const Holding holding(lock_);
    rules_.stop();
    is_closing_ = true;
  }

  // For the task.

  struct Next {
    DeadMansSwitch::Action action{};
    DeadMansSwitch::Speed speed{};
    TaskNumber task{};
    bool is_last = false;            ///< nothing remains to be done
    Instant until = Instant::never;  ///< for Action::none: when to call next() again
  };
  Next next(Instant now);
  void done(const Next& what, Result<void> result, Instant now);
  /// True if the camera is to turn.
  bool is_turning() const { return state() == DeadMansSwitch::State::turning; }

 protected:
  const LockPointer& lock() const noexcept { return lock_; }
  /// Called, with the lock, when the task has nothing to send.
  virtual void idle() {}

 private:
  void note_superseded();
  bool is_settled(Instant now) const { return is_idle_ && rules_.deadline(now) > now; }

  const LockPointer lock_;
  DeadMansSwitch rules_;
  const Order order_;
  TaskNumber task_{};  // the motion's place among the client's tasks
  std::optional<ClientError> error_{};
  std::optional<ClientError> superseded_{};  // for the next set()
  bool is_closing_ = false;
  bool is_idle_ = false;
};

/// Turns with the speeds of the owner until it closes `speed`.
/// With `yields`, it ends with ErrorCode::interrupted when somebody else has stopped the camera.
Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed, BoundedTurn motion, bool yields);

}  // namespace sbgc::detail
