/// A clock that advances only on request.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <utility>

#include <sbgc/client/clock.hpp>

namespace sbgc::test {

/// A sleeping thread advances the time; a waiting thread wakes up when another one advances it.
class ManualClock final : public Clock {
 public:
  TimePoint now() override {
    const std::scoped_lock lock(mutex_);
    return now_;
  }
  void sleep_until(TimePoint until) override { move_to(until); }
  void wait_until(std::unique_lock<std::mutex>& lock, std::condition_variable& changed,
                  TimePoint until) override {
    Waiter waiter{lock.mutex(), &changed};
    {
      const std::scoped_lock own(mutex_);
      if (now_ >= until) return;
      waiters_.insert(waiter);
    }
    // advance() locks the mutex of a waiter before it notifies, so no notification is missed.
    changed.wait(lock);
    const std::scoped_lock own(mutex_);
    waiters_.erase(waiters_.find(waiter));
  }

  /// Calls `follow` with each advance before the new time is visible. Must be called before threads
  /// start.
  void on_move(std::function<void(std::chrono::milliseconds)> follow) {
    follow_ = std::move(follow);
  }
  void advance(std::chrono::milliseconds duration) { move_to(now() + duration); }

 private:
  using Waiter = std::pair<std::mutex*, std::condition_variable*>;

  void move_to(TimePoint time) {
    std::multiset<Waiter> waiters;
    const TimePoint before = now();
    if (follow_ && time > before) {
      follow_(std::chrono::ceil<std::chrono::milliseconds>(time - before));
    }
    {
      const std::scoped_lock lock(mutex_);
      now_ = std::max(now_, time);
      waiters = waiters_;
    }
    for (const auto& [mutex, changed] : waiters) {
      const std::scoped_lock lock(*mutex);
      changed->notify_all();
    }
  }

  std::function<void(std::chrono::milliseconds)> follow_{};
  std::mutex mutex_;
  TimePoint now_{std::chrono::hours(1)};
  std::multiset<Waiter> waiters_;
};

}  // namespace sbgc::test
