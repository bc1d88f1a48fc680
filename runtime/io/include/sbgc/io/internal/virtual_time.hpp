/// Virtual time: Asio programs that need ten minutes run at once, and deterministically.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/execution_context.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

namespace sbgc::io::detail {

/// The virtual time of an io_context that no thread runs; asio::use_service<VirtualTime>() adds it.
/// Time passes only in run(): from one Timer to the next, without waiting.
class VirtualTime : public asio::execution_context::service {
 public:
  using key_type = VirtualTime;
  // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): Asio wants it so
  static inline asio::execution_context::id id{};

  /// The context must be an io_context.
  explicit VirtualTime(asio::execution_context& context)
      : service(context), context_(static_cast<asio::io_context&>(context)) {}

  /// Returns the virtual time of an executor; null if the executor has real time.
  static VirtualTime* of(const asio::any_io_executor& executor) {
    asio::execution_context& context = asio::query(executor, asio::execution::context);
    return asio::has_service<VirtualTime>(context) ? &asio::use_service<VirtualTime>(context)
                                                   : nullptr;
  }

  Instant now() const noexcept { return {now_us_.load()}; }
  asio::io_context::executor_type executor() { return context_.get_executor(); }

  /// Runs the handlers of the context until `is_done()`, or until this time, which is not
  /// Instant::never. Returns is_done().
  /// Threads take turns; a handler must not call it.
  template <class IsDone>
  bool run(const IsDone& is_done, Instant until) {
    const std::scoped_lock lock(running_);
    while (!is_done()) {
      context_.restart();
      if (context_.poll_one() != 0 || fire(until)) continue;
      now_us_ = later(now(), until).us;
      return is_done();
    }
    return true;
  }
  /// Calls `action()` while no handler runs.
  template <class Action>
  auto between_handlers(const Action& action) {
    const std::scoped_lock lock(running_);
    return action();
  }

 private:
  friend class Timer;

  struct Waiting;
  using Timers = std::multimap<Instant, Waiting>;
  /// Empty if its timer is not running.
  using Place = std::optional<Timers::iterator>;
  struct Waiting {
    asio::any_io_executor executor;
    std::function<void()> handler;
    Place* place;

    /// As with handlers of Asio, a handler is destroyed on its executor: it may own the timer.
    void drop() {
      asio::post(executor, [dropped = std::move(handler)] {});
    }
  };

  void add(Instant at, Waiting waiting) {
    const std::scoped_lock lock(mutex_);
    Place& place = *waiting.place;
    place = timers_.emplace(at, std::move(waiting));
  }
  void remove(Place& place) {
    const std::scoped_lock lock(mutex_);
    if (!place) return;
    timers_.extract(*place).mapped().drop();
    place.reset();
  }
  /// Fires the first timer if it is due by this time; returns false otherwise.
  bool fire(Instant until) {
    const std::scoped_lock lock(mutex_);
    if (timers_.empty() || until < timers_.begin()->first) return false;
    if (timers_.begin()->first == Instant::never) return false;  // it only holds its handler
    now_us_ = later(now(), timers_.begin()->first).us;
    Waiting due = std::move(timers_.extract(timers_.begin()).mapped());
    due.place->reset();
    asio::post(due.executor, std::move(due.handler));
    return true;
  }
  void shutdown() override {
    Timers timers;
    {
      const std::scoped_lock lock(mutex_);
      timers.swap(timers_);
      for (auto& [at, waiting] : timers) waiting.place->reset();
    }
    // Destroys the handlers here, and the timers that they own.
  }

  asio::io_context& context_;
  std::atomic<std::int64_t> now_us_{1'000'000};
  std::mutex running_{};
  std::mutex mutex_{};  // of the timers
  Timers timers_{};
};

}  // namespace sbgc::io::detail
