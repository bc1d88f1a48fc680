/// The clock of tasks that wait; tests can replace it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace sbgc {

/// A steady clock to wait on.
class Clock {
 public:
  /// A point in time of the clock, which never goes back.
  using TimePoint = std::chrono::steady_clock::time_point;

  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  Clock(Clock&&) = delete;
  Clock& operator=(Clock&&) = delete;
  virtual ~Clock() = default;

  /// Returns the present time.
  virtual TimePoint now() = 0;
  /// Waits until `until`.
  virtual void sleep_until(TimePoint until) = 0;
  /// Returns when `changed` is notified, at `until`, or spuriously.
  virtual void wait_until(std::unique_lock<std::mutex>& lock, std::condition_variable& changed,
                          TimePoint until) = 0;

  /// The clock of the system.
  static Clock& system() noexcept;
};

}  // namespace sbgc
