/// The rules of speed control: when to send a speed, and when to stop because the owner is silent.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <sbgc/client/motion_bound.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc::detail {

class DeadMansSwitch {
 public:
  using State = SpeedControlState;
  using Speed = Axes<msg::ControlSpeed>;

  /// The board takes at most 50 commands per second.
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
  /// The camera is in other hands: neither turn nor stop it.
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

}  // namespace sbgc::detail
