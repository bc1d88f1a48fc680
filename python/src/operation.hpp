/// An asynchronous operation: it runs on the thread of its client, and Python waits for it.
#pragma once

#include <cmath>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include <sys/types.h>
#include <unistd.h>

#include <sbgc/io/internal/virtual_time.hpp>

#include "binding.hpp"

namespace sbgc::python {

/// The process that made an object. A forked child has none of its threads, and its mutexes may be
/// locked forever.
class Process {
 public:
  bool is_forked() const noexcept { return id_ != getpid(); }
  /// Raises in a forked child.
  void require(const char* what) const {
    if (!is_forked()) return;
    raise("GimbalError", std::string(what) + " belongs to the process that forked this one",
          "invalid", 0);
  }

 private:
  pid_t id_ = getpid();
};

/// Null for real time.
using VirtualTimePointer = std::shared_ptr<io::detail::VirtualTime>;

inline Duration duration_of(double seconds) { return microseconds(std::llround(seconds * 1e6)); }

/// A file descriptor that becomes readable on an event: for asyncio, so that the client's thread
/// never needs the interpreter.
class Bell {
 public:
  Bell();
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;
  ~Bell();

  void ring() const noexcept;
  void drain() const noexcept;
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

/// An operation. Python begins it where an exception cancels it, calls wait() until it is over, and
/// then result().
class Operation : public std::enable_shared_from_this<Operation> {
 public:
  /// Makes the result for Python, or raises. Holds no Python objects.
  using Result = std::function<py::object()>;
  using Begin = std::function<void(const std::shared_ptr<Operation>&)>;

  /// Without `time`, it uses real time.
  explicit Operation(std::shared_ptr<Bell> bell, VirtualTimePointer time = nullptr)
      : bell_(std::move(bell)), time_(std::move(time)) {}

  /// Sets the action of begin(), once.
  void set_begin(Begin begin) { begin_ = std::move(begin); }
  void set_cancel(std::function<void()> cancel) {
    const std::scoped_lock lock(mutex_);
    cancel_ = std::move(cancel);
  }

  void end(Result result) {
    {
      const std::scoped_lock lock(mutex_);
      result_ = std::move(result);
    }
    changed_.notify_all();
    bell_->ring();
  }
  void report(Result progress) {
    {
      const std::scoped_lock lock(mutex_);
      progress_.swap(progress);
    }
    bell_->ring();
  }
  /// Ends it soon, with an error; an operation that moves the camera stops it first.
  void cancel() {
    std::function<void()> cancel;
    {
      const std::scoped_lock lock(mutex_);
      if (!result_) cancel = cancel_;
    }
    if (cancel) cancel();
  }
  /// Returns whether it is over by this time.
  bool wait_until(Instant time) {
    if (time_) return time_->run([this] { return is_over(); }, time);
    std::unique_lock lock(mutex_);
    return changed_.wait_until(lock, io::to_chrono(time),
                               [this] { return static_cast<bool>(result_); });
  }
  Instant now() const { return time_ ? time_->now() : io::now(); }
  bool is_over() const {
    const std::scoped_lock lock(mutex_);
    return static_cast<bool>(result_);
  }

  // For Python; the interpreter is released meanwhile.

  void begin() {
    process_.require("the client");
    const Begin begin = std::exchange(begin_, nullptr);
    if (!begin) return;
    has_begun_ = true;
    begin(shared_from_this());
  }
  bool wait(double seconds) {
    process_.require("the client");
    return released([&] { return wait_until(now() + duration_of(seconds)); });
  }
  void cancel_by_python() {
    if (process_.is_forked()) return;
    begin_ = nullptr;
    released([&] { return cancel(), true; });
  }
  py::object result() {
    Result result;
    {
      const std::scoped_lock lock(mutex_);
      result = result_;
    }
    if (!result) throw std::runtime_error("the operation is not over");
    return result();
  }
  /// Returns the last report, once; None without a new one.
  py::object progress() {
    Result progress;
    {
      const std::scoped_lock lock(mutex_);
      progress = std::exchange(progress_, nullptr);
    }
    return progress ? progress() : py::none();
  }
  /// True while it can be waited for.
  bool is_running() const { return has_begun_ && !is_over() && !process_.is_forked(); }

 private:
  Process process_{};
  std::shared_ptr<Bell> bell_;
  VirtualTimePointer time_;
  // Only for Python's threads.
  Begin begin_{};
  bool has_begun_ = false;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Result result_{};
  Result progress_{};
  std::function<void()> cancel_{};
};

}  // namespace sbgc::python
