/// Threading primitives of clients: a lock, and waiting for a value from another thread.
#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "lock.hpp"

namespace sbgc::detail {

/// Lets one thread wait for a value from another.
template <class T>
class Waiter {
 public:
  void put(T value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
    ready_.notify_one();
  }

  /// Returns nothing if no value arrives in time.
  std::optional<T> wait_until(std::chrono::steady_clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    ready_.wait_until(lock, deadline, [this] { return value_.has_value(); });
    return std::exchange(value_, std::nullopt);
  }

  bool is_ready() {
    const std::lock_guard lock(mutex_);
    return value_.has_value();
  }

  T wait() {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [this] { return value_.has_value(); });
    return *std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable ready_;
  std::optional<T> value_;
};

class Mutex final : public Lock {
 public:
  void lock() override { mutex_.lock(); }
  void unlock() override { mutex_.unlock(); }

 private:
  std::recursive_mutex mutex_;
};

inline LockPointer make_mutex() { return std::make_unique<Mutex>(); }

}  // namespace sbgc::detail
