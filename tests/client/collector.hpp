/// A thread-safe collector of items.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

namespace sbgc::test {

/// Collects the arguments of handler calls.
template <class T>
class Collector {
 public:
  void add(const T& item) {
    const std::lock_guard lock(mutex_);
    items_.push_back(item);
    added_.notify_all();
  }

  /// Waits until there are `count` items and returns them; returns fewer only after a failure.
  std::vector<T> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(
        added_.wait_for(lock, std::chrono::seconds(60), [&] { return items_.size() >= count; }))
        << items_.size() << " of " << count << " items";
    return items_;
  }

  void clear() {
    const std::lock_guard lock(mutex_);
    items_.clear();
  }

  /// Waits until `done(items)` is true.
  template <class Done>
  bool wait_until(Done done) {
    std::unique_lock lock(mutex_);
    return added_.wait_for(lock, std::chrono::seconds(60), [&] { return done(items_); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable added_;
  std::vector<T> items_;
};

}  // namespace sbgc::test
