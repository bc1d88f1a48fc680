/// Lines on their way from a handler to standard output, which may be slow.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace sbgc::tools {

/// Thread-safe. Drops lines if too much text is waiting.
class LineQueue {
 public:
  void put(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() + line.size() > most) {
      ++dropped_;
      return;
    }
    waiting_ += line;
    changed_.notify_one();
  }

  /// Returns what is waiting; waits for it until `deadline`.
  std::string take(std::chrono::steady_clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, deadline, [this] { return !waiting_.empty(); });
    return std::exchange(waiting_, {});
  }

  std::uint64_t dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  static constexpr std::size_t most = std::size_t{64} << 20;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::string waiting_;
  std::uint64_t dropped_ = 0;
};

}  // namespace sbgc::tools
