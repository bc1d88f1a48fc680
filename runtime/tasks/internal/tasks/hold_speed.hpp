/// A held speed, shared by its owner and the task that sends it, and the rules of speed control.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <sbgc/client/motion_bound.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

#include "lock.hpp"
#include "tasks/bounded_turn.hpp"

namespace sbgc::detail {

/// Decides when to send a speed, and when to stop because the owner is silent.
class DeadMansSwitch {
 public:
  using State = SpeedControlState;
  using Speed = Axes<msg::ControlSpeed>;

  /// The board accepts at most 50 commands per second.
  static constexpr Duration fastest = milliseconds(20);

  enum class Action : std::uint8_t { none, send, stop };

  DeadMansSwitch(Duration silence, Duration repeat) noexcept : silence_(silence), repeat_(repeat) {}

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] const Speed& speed() const noexcept { return speed_; }

  void set(const Speed& speed, Instant now) noexcept {
    if (state_ == State::failed) return;
    // Send a new speed as soon as the pacing allows; repeat an unchanged one at its regular time.
    if (state_ != State::turning || !(speed == speed_)) due_ = later(now, sent_at_ + fastest);
    speed_ = speed;
    state_ = State::turning;
    must_stop_ = false;
    refresh(now);
  }
  void refresh(Instant now) noexcept { silent_at_ = now + silence_; }
  void stop() noexcept {
    end(State::idle);
    stop_due_ = long_ago;
  }
  /// Sending failed: only a stop remains to be done.
  void fail() noexcept {
    const bool turned = state_ == State::turning;
    state_ = State::failed;
    must_stop_ = must_stop_ || turned;
  }
  /// Something else controls the camera: neither turn nor stop it.
  void let_go() noexcept {
    state_ = State::idle;
    must_stop_ = false;
  }
  /// The camera has stopped, or can never be stopped.
  void stopped() noexcept { must_stop_ = false; }
  /// The camera may still turn: schedule another stop.
  void not_stopped(Instant now) noexcept { stop_due_ = now + std::max(repeat_, fastest); }

  /// Returns the next action; a send counts as done.
  Action next(Instant now) noexcept {
    if (state_ == State::turning && now >= silent_at_) end(State::silenced);
    if (must_stop_) return now < stop_due_ ? Action::none : Action::stop;
    if (state_ != State::turning || now < due_) return Action::none;
    sent_at_ = now;
    due_ = now + std::max(repeat_, fastest);
    return Action::send;
  }
  /// The time of the next call of next(), at the latest.
  [[nodiscard]] Instant deadline(Instant now) const noexcept {
    if (must_stop_) return later(now, stop_due_);
    if (state_ != State::turning) return now + seconds(3600);
    return earlier(due_, silent_at_);
  }

 private:
  void end(State state) noexcept {
    if (state_ != State::turning) return;
    state_ = state;
    must_stop_ = true;
    stop_due_ = long_ago;
  }

  static constexpr Instant long_ago{std::numeric_limits<std::int64_t>::min()};

  Duration silence_;
  Duration repeat_;
  State state_ = State::idle;
  bool must_stop_ = false;
  Speed speed_{};
  Instant sent_at_ = long_ago;
  Instant due_{};
  Instant silent_at_{};
  Instant stop_due_ = long_ago;
};

/// The commands of the owner and their results. With a lock, thread-safe. Wake the task after each
/// change.
class HeldSpeed {
 public:
  /// The order of the client's tasks: returns a new number, and whether one is superseded.
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

  /// Turns with this speed. Fails if sending has failed, if the camera must stop forever, and once
  /// if another task has superseded the motion.
  Result<void> set(const DeadMansSwitch::Speed& speed, Instant now);
  /// Keeps the speed. Fails if the camera does not turn.
  Result<void> refresh(Instant now);
  /// Stops the camera until set() is called again.
  Result<void> stop() {
    const Holding holding(lock_);
    if (error_) return *error_;
    superseded_.reset();
    rules_.stop();
    return {};
  }
  /// Returns the error of sending, if it has failed.
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
  /// Stops the camera forever, and ends the task.
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
  /// True if the camera should turn.
  bool is_turning() const { return state() == DeadMansSwitch::State::turning; }

 protected:
  const LockPointer& lock() const noexcept { return lock_; }
  /// Called, with the lock held, when the task has nothing to send.
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

/// Turns with the speeds of the owner until it closes `speed`. With `yields`, it ends with
/// ErrorCode::interrupted when something else has stopped the camera.
Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed, BoundedTurn motion, bool yields);

}  // namespace sbgc::detail
