/// A clock and a timer that follow the time of an executor, real or virtual.
#pragma once

#include <system_error>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/steady_timer.hpp>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/internal/virtual_time.hpp>

namespace sbgc::io::detail {

/// The clock of an executor, whose context must outlive it.
class ExecutorClock {
 public:
  explicit ExecutorClock(const asio::any_io_executor& executor)
      : virtual_(VirtualTime::of(executor)) {}

  Instant now() const noexcept { return virtual_ != nullptr ? virtual_->now() : io::now(); }
  /// Null for real time.
  VirtualTime* virtual_time() const noexcept { return virtual_; }

 private:
  VirtualTime* virtual_;
};

class Timer {
 public:
  explicit Timer(const asio::any_io_executor& executor) : clock_(executor), real_(executor) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() { cancel(); }

  Instant now() const noexcept { return clock_.now(); }

  /// Calls `handler()` on the executor at this time, unless the timer is started again, canceled or
  /// destroyed first.
  template <class Handler>
  void start(Instant at, Handler handler) {
    if (VirtualTime* const time = clock_.virtual_time()) {
      time->remove(place_);
      time->add(at, {real_.get_executor(), std::move(handler), &place_});
      return;
    }
    real_.expires_at(to_chrono(at));
    real_.async_wait([handler = std::move(handler)](const std::error_code& error) mutable {
      if (!error) handler();
    });
  }
  void cancel() {
    if (VirtualTime* const time = clock_.virtual_time()) return time->remove(place_);
    real_.cancel();
  }

 private:
  ExecutorClock clock_;
  asio::steady_timer real_;
  VirtualTime::Place place_{};
};

}  // namespace sbgc::io::detail
