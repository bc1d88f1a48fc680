/// The end of a recording.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>

#include <poll.h>
#include <sys/epoll.h>
#include <sys/timerfd.h>

#include <sbgc/io/internal/descriptor.hpp>

#include "command/interruption.hpp"

namespace sbgc::tools {

/// A signal or the time for a recording, as one descriptor: who waits for the reader of a capture
/// must notice either.
class RecordingEnd {
 public:
  /// A reader who does not even take the beginning may have the time, too.
  explicit RecordingEnd(std::optional<std::chrono::milliseconds> time)
      : time_(time),
        timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC)),
        any_(::epoll_create1(EPOLL_CLOEXEC)) {
    add(timer_.get());
    set_timer();
  }

  /// From now on, signals ask for the end. The time begins again.
  void begin() {
    interruption_.emplace();
    add(interruption_descriptor());
    set_timer();
  }

  /// Becomes readable at the end.
  int descriptor() const noexcept { return any_.get(); }
  /// Waits for the end, or for a moment. Returns true if it has come.
  bool comes_soon() const {
    constexpr int moment = 50;  // ms
    pollfd waiting{any_.get(), POLLIN, 0};
    return ::poll(&waiting, 1, moment) > 0;
  }

 private:
  void set_timer() const {
    using std::chrono::nanoseconds;
    if (!time_) return;
    const nanoseconds left = std::max<nanoseconds>(*time_, nanoseconds(1));  // 0 would stop it
    const auto seconds = std::chrono::floor<std::chrono::seconds>(left);
    itimerspec at{};
    at.it_value.tv_sec = static_cast<std::time_t>(seconds.count());
    at.it_value.tv_nsec = static_cast<long>((left - seconds).count());
    ::timerfd_settime(timer_.get(), 0, &at, nullptr);
  }

  void add(int descriptor) const {
    epoll_event event{};
    event.events = EPOLLIN;
    ::epoll_ctl(any_.get(), EPOLL_CTL_ADD, descriptor, &event);
  }

  std::optional<std::chrono::milliseconds> time_;
  std::optional<Interruption> interruption_{};
  io::detail::Descriptor timer_;
  io::detail::Descriptor any_;
};

}  // namespace sbgc::tools
