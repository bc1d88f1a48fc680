/// What to send when, to hold a speed with a dead-man's switch: the rules, without thread or line.
#pragma once

#include <algorithm>
#include <chrono>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/speed_control.hpp>

namespace sbgc::detail {

class SpeedHold {
 public:
  using State = SpeedControl::State;
  using Speed = Axes<msg::ControlSpeed>;
  using TimePoint = Clock::TimePoint;

  /// The board takes at most 50 commands a second.
  static constexpr std::chrono::milliseconds fastest{20};

  enum class Action : std::uint8_t { none, send, stop };

  SpeedHold(std::chrono::milliseconds silence, std::chrono::milliseconds repeat) noexcept
      : silence_(silence), repeat_(repeat) {}

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] const Speed& speed() const noexcept { return speed_; }

  void set(const Speed& speed, TimePoint now) noexcept {
    if (state_ == State::failed) return;
    // A change is sent as soon as commands may follow each other, the same speed in its turn.
    if (state_ != State::turning || !(speed == speed_)) due_ = std::max(now, sent_at_ + fastest);
    speed_ = speed;
    state_ = State::turning;
    must_stop_ = false;
    refresh(now);
  }
  void refresh(TimePoint now) noexcept { silent_at_ = now + silence_; }
  void stop() noexcept {
    end(State::idle);
    stop_due_ = TimePoint::min();
  }
  /// Sending has failed: what is left to do is to stop.
  void fail() noexcept {
    const bool turned = state_ == State::turning;
    state_ = State::failed;
    must_stop_ = must_stop_ || turned;
  }
  /// The camera has been stopped, or never can be.
  void stopped() noexcept { must_stop_ = false; }
  /// It may turn on, and has to be stopped a little later.
  void not_stopped(TimePoint now) noexcept { stop_due_ = now + std::max(repeat_, fastest); }

  /// What has to be done now; a send counts as done.
  Action next(TimePoint now) noexcept {
    if (state_ == State::turning && now >= silent_at_) end(State::silenced);
    if (must_stop_) return now < stop_due_ ? Action::none : Action::stop;
    if (state_ != State::turning || now < due_) return Action::none;
    sent_at_ = now;
    due_ = now + std::max(repeat_, fastest);
    return Action::send;
  }
  /// When next() has to be asked again at the latest.
  [[nodiscard]] TimePoint deadline(TimePoint now) const noexcept {
    if (must_stop_) return std::max(now, stop_due_);
    if (state_ != State::turning) return now + std::chrono::hours(1);
    return std::min(due_, silent_at_);
  }

 private:
  void end(State state) noexcept {
    if (state_ != State::turning) return;
    state_ = state;
    must_stop_ = true;
    stop_due_ = TimePoint::min();
  }

  std::chrono::milliseconds silence_;
  std::chrono::milliseconds repeat_;
  State state_ = State::idle;
  bool must_stop_ = false;
  Speed speed_{};
  TimePoint sent_at_ = TimePoint::min();
  TimePoint due_{};
  TimePoint silent_at_{};
  TimePoint stop_due_ = TimePoint::min();
};

}  // namespace sbgc::detail
