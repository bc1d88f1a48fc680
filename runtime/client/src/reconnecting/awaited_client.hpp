/// Operations without a thread: waiting for a connection, and an operation of several steps that
/// can be stopped.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/post.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/link.hpp>
#include <sbgc/io/internal/timer.hpp>

namespace sbgc::detail {

/// Checks for a client now, after each change, and at the timeout. Thread-safe; everything happens
/// on the strand, where a pending timer or check keeps the object alive.
class AwaitedClient : public std::enable_shared_from_this<AwaitedClient> {
 public:
  using Found = Result<std::shared_ptr<Connection>>;
  /// Returns nothing while there is neither a client nor an error.
  using Look = std::function<std::optional<Found>()>;
  using Use = std::function<void(Found)>;

  /// `use` is called once: with the result of `look`, or with `too_late()`.
  AwaitedClient(const asio::strand<asio::any_io_executor>& strand, Look look,
                std::function<ClientError()> too_late, Use use)
      : strand_(strand),
        timer_(strand),
        look_(std::move(look)),
        too_late_(std::move(too_late)),
        use_(std::move(use)) {}

  void start(Duration left) {
    asio::post(strand_, [self = shared_from_this(), left] {
      if (!self->use_) return;  // canceled
      self->timer_.start(self->timer_.now() + left, [self] { self->end(self->too_late_()); });
      self->look();
    });
  }
  void look_again() {
    asio::post(strand_, [self = shared_from_this()] { self->look(); });
  }
  void cancel() {
    asio::post(strand_, [self = shared_from_this()] {
      self->end(ClientError{ErrorCode::cancelled, "the operation was canceled"});
    });
  }

 private:
  void look() {
    if (!use_) return;
    if (auto found = look_()) end(*std::move(found));
  }
  void end(Found found) {
    if (!use_) return;
    timer_.cancel();
    std::exchange(use_, nullptr)(std::move(found));
  }

  asio::strand<asio::any_io_executor> strand_;
  io::detail::Timer timer_;
  Look look_;
  std::function<ClientError()> too_late_;
  Use use_;
};

/// Stops the current step, and each later one as soon as it is set. Thread-safe.
class CurrentStop {
 public:
  void set(const Stop& step) {
    {
      const std::lock_guard lock(mutex_);
      step_ = step;
      if (!is_stopped_) return;
    }
    step();
  }
  void stop() {
    Stop step;
    {
      const std::lock_guard lock(mutex_);
      is_stopped_ = true;
      step = step_;
    }
    if (step) step();
  }
  /// Stops a step again that was set before it could be stopped.
  void check() {
    Stop step;
    {
      const std::lock_guard lock(mutex_);
      if (is_stopped_) step = step_;
    }
    if (step) step();
  }

 private:
  std::mutex mutex_;
  Stop step_;
  bool is_stopped_ = false;
};

}  // namespace sbgc::detail
