/// A thread that works on demand.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace sbgc::tools {

class Worker {
 public:
  /// When `work` throws, the thread ends, and `on_failure` is called.
  Worker(std::function<void()> work, std::function<void()> on_failure)
      : work_(std::move(work)), on_failure_(std::move(on_failure)) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { finish(); }

  void start() {
    thread_ = std::thread([this] { run(); });
  }
  /// Works once more, unless it has failed, and ends the thread.
  void finish() {
    {
      const std::scoped_lock lock(mutex_);
      is_ending_ = true;
    }
    woken_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  // Any thread.

  void wake() {
    {
      const std::scoped_lock lock(mutex_);
      has_work_ = true;
    }
    woken_.notify_one();
  }
  /// Throws std::runtime_error with the error of `work`.
  void check() const {
    const std::scoped_lock lock(mutex_);
    if (!problem_.empty()) throw std::runtime_error(problem_);
  }

 private:
  void run() {
    try {
      for (bool is_ending = false; !is_ending;) {
        {
          std::unique_lock lock(mutex_);
          woken_.wait(lock, [&] { return has_work_ || is_ending_; });
          has_work_ = false;
          is_ending = is_ending_;
        }
        work_();
      }
    } catch (const std::exception& error) {
      {
        const std::scoped_lock lock(mutex_);
        problem_ = error.what();
      }
      on_failure_();
    }
  }

  const std::function<void()> work_;
  const std::function<void()> on_failure_;
  std::thread thread_{};
  mutable std::mutex mutex_{};
  std::condition_variable woken_{};
  bool has_work_ = false;
  bool is_ending_ = false;
  std::string problem_{};
};

}  // namespace sbgc::tools
