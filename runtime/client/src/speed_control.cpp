#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/messages/control.hpp>

#include "refusals.hpp"
#include "speed_hold.hpp"
#include "task.hpp"

namespace sbgc {

using detail::SpeedHold;

/// The thread that sends, and what it shares with the owner.
class SpeedControl::Keeper {
 public:
  Keeper(Client& client, const SpeedControlOptions& options)
      : client_(client),
        clock_(options.clock),
        hold_(options.silence, options.repeat),
        refusals_(client, msg::CommandToBoard::control),
        thread_([this] { run(); }) {}
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  Keeper(Keeper&&) = delete;
  Keeper& operator=(Keeper&&) = delete;
  ~Keeper() {
    {
      const std::scoped_lock lock(mutex_);
      hold_.stop();
      closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  /// Changes the state with `change(hold)` and wakes the thread.
  template <class Change>
  Result<void> with(Change&& change) {
    {
      const std::scoped_lock lock(mutex_);
      if (error_) return *error_;
      if (Result<void> changed = change(hold_); !changed) return changed;
    }
    changed_.notify_all();
    return {};
  }
  Result<void> wait() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [&] { return waiting_ && hold_.deadline(clock_.now()) > clock_.now(); });
    return error_ ? Result<void>(*error_) : Result<void>();
  }
  State state() const {
    const std::scoped_lock lock(mutex_);
    return hold_.state();
  }
  Clock& clock() noexcept { return clock_; }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      const SpeedHold::Action action = hold_.next(clock_.now());
      if (action == SpeedHold::Action::none) {
        if (closing_) return;
        waiting_ = true;
        idle_.notify_all();
        clock_.wait_until(lock, changed_, hold_.deadline(clock_.now()));
        waiting_ = false;
        continue;
      }
      const SpeedHold::Speed speed = hold_.speed();
      lock.unlock();
      Result<void> sent = action == SpeedHold::Action::send ? send(speed) : halt();
      lock.lock();
      if (action == SpeedHold::Action::stop) {
        if (sent || is_final(sent.error().code)) {
          hold_.stopped();
        } else {
          hold_.not_stopped(clock_.now());
        }
      }
      if (!sent) {
        if (!error_) error_ = std::move(sent).error();
        hold_.fail();
      }
    }
  }

  /// Whether nothing can ever be sent again.
  static bool is_final(ErrorCode code) noexcept {
    return code == ErrorCode::link_lost || code == ErrorCode::not_connected ||
           code == ErrorCode::cancelled;
  }

  Result<void> send(const SpeedHold::Speed& speed) {
    if (auto refused = refusals_.take()) return *std::move(refused);  // of the command before
    msg::Control command;
    command.control_mode.set_mode(msg::ControlModeKind::speed);
    for (std::size_t i = 0; i < SpeedHold::Speed::size(); ++i) command.axes[i].speed = speed[i];
    // A stop must not wait for long behind a command that finds no room.
    return client_.call(command, {.timeout = std::chrono::seconds(1)});
  }
  Result<void> halt() { return sbgc::stop(client_, {.clock = clock_}); }

  Client& client_;
  Clock& clock_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;  ///< for the thread
  std::condition_variable idle_;     ///< for wait()
  SpeedHold hold_;
  detail::Refusals refusals_;
  std::optional<ClientError> error_{};
  bool closing_ = false;
  bool waiting_ = false;
  std::thread thread_;
};

SpeedControl::SpeedControl(Client& client, const SpeedControlOptions& options)
    : keeper_(std::make_unique<Keeper>(client, options)) {}

SpeedControl::~SpeedControl() = default;

Result<void> SpeedControl::set(const Axes<msg::ControlSpeed>& speed) {
  return keeper_->with([&](SpeedHold& hold) -> Result<void> {
    hold.set(speed, keeper_->clock().now());
    return {};
  });
}

Result<void> SpeedControl::refresh() {
  return keeper_->with([&](SpeedHold& hold) -> Result<void> {
    if (hold.state() != State::turning) {
      return ClientError{ErrorCode::cancelled, "the camera has been stopped"};
    }
    hold.refresh(keeper_->clock().now());
    return {};
  });
}

Result<void> SpeedControl::stop() {
  return keeper_->with([](SpeedHold& hold) -> Result<void> {
    hold.stop();
    return {};
  });
}

Result<void> SpeedControl::wait() { return keeper_->wait(); }

SpeedControl::State SpeedControl::state() const { return keeper_->state(); }

}  // namespace sbgc
