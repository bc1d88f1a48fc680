#include "tasks/hold_speed.hpp"

#include <cstddef>
#include <utility>

#include <sbgc/messages/control.hpp>

#include "tasks/motion_tools.hpp"
#include "tasks/tools.hpp"

namespace sbgc::detail {

namespace {

/// True if nothing can be sent any more.
bool is_final(ErrorCode code) noexcept {
  return code == ErrorCode::link_lost || code == ErrorCode::not_connected ||
         code == ErrorCode::cancelled;
}

/// Detects restarts of the board.
class Restarts {
 public:
  explicit Restarts(TaskMachine& task)
      : task_(task), listener_(task.listen([this](const Notice& notice) {
          if (notice.kind == NoticeKind::board_reset) has_restarted_ = true;
        })) {}
  Restarts(const Restarts&) = delete;
  Restarts& operator=(const Restarts&) = delete;
  Restarts(Restarts&&) = delete;
  Restarts& operator=(Restarts&&) = delete;
  ~Restarts() { task_.stop_listening(listener_); }

  bool has_restarted() const noexcept { return has_restarted_; }

 private:
  TaskMachine& task_;
  bool has_restarted_ = false;
  TaskMachine::Listener listener_;
};

constexpr const char* stopped = "the camera has been stopped";

ClientError restart_error() {
  return {ErrorCode::board_reset, "the board has restarted, which ended the motion"};
}

/// Detects that something else has stopped the camera: the axes that should turn have begun to, and
/// two polls show that they no longer do. A command may be lost, so it is repeated until they
/// begin.
class Yielding {
 public:
  /// Reads the angles before a speed is repeated; fails if it must not be. If the answer is late,
  /// the speed may be repeated without it, as long as the patience lasts.
  Task<Result<void>> look(DeadMansSwitch::Speed speed, BoundedTurn& motion) {
    TaskMachine& task = co_await tasks::this_task();
    if (!(speed == speed_)) {
      *this = Yielding();
      speed_ = speed;
      since_ = task.now();
      motion.polls().forget(task);
      co_return Result<void>();
    }
    if (speed == DeadMansSwitch::Speed{}) co_return Result<void>();
    for (int polls = 0; polls < 2; ++polls) {
      if (polls != 0) {
        if (auto waited = co_await tasks::wait_until(task.now() + pause); !waited) co_return waited;
      }
      const bool may_go_on = polls == 0 && has_begun_;
      const Instant until = may_go_on ? motion.next_command(task.now()) : Instant::never;
      const Result<bool> read = co_await motion.polls().update(until);
      if (!read) co_return read.error();
      if (!*read) co_return Result<void>();
      for (std::size_t i = 0; i < speed.size(); ++i) {
        if (speed[i].raw() != 0 && motion.polls().last()->axes[i].rc_speed.raw() != 0) {
          has_begun_ = true;
          co_return Result<void>();
        }
      }
      if (!has_begun_) break;
    }
    if (has_begun_) {
      co_return ClientError{ErrorCode::interrupted,
                            motion.has_lapsed(task.now())
                                ? "the camera no longer turns: the board answers so late that the "
                                  "motion has ended, or something else has stopped it"
                                : "the camera no longer turns: another program, RC, a limit or the "
                                  "control timeout has stopped it"};
    }
    if (task.now() - since_ < patience) co_return Result<void>();
    co_return ClientError{ErrorCode::timeout,
                          "the camera did not begin to turn; are the motors on?"};
  }

 private:
  static constexpr Duration pause = milliseconds(50);

  DeadMansSwitch::Speed speed_{};
  Instant since_{};
  bool has_begun_ = false;
};

}  // namespace

Result<void> HeldSpeed::set(const DeadMansSwitch::Speed& speed, Instant now) {
  const Holding holding(lock_);
  if (error_) return *error_;
  if (is_closing_) return ClientError{ErrorCode::cancelled, stopped};
  const bool turns = rules_.state() == DeadMansSwitch::State::turning;
  if (turns && order_.is_superseded(task_)) note_superseded();
  if (superseded_) return *std::exchange(superseded_, std::nullopt);
  if (!turns) task_ = order_.begin();
  rules_.set(speed, now);
  return {};
}

Result<void> HeldSpeed::refresh(Instant now) {
  const Holding holding(lock_);
  if (error_) return *error_;
  if (superseded_) return *superseded_;
  if (is_closing_ || rules_.state() != DeadMansSwitch::State::turning) {
    return ClientError{ErrorCode::cancelled, stopped};
  }
  rules_.refresh(now);
  return {};
}

void HeldSpeed::note_superseded() {
  rules_.let_go();
  superseded_ = {ErrorCode::superseded,
                 "the camera no longer turns at this speed: a later command stops it or moves it"};
}

HeldSpeed::Next HeldSpeed::next(Instant now) {
  const Holding holding(lock_);
  Next next{rules_.next(now), rules_.speed(), task_, false, Instant::never};
  is_idle_ = next.action == DeadMansSwitch::Action::none;
  if (!is_idle_) return next;
  next.is_last = is_closing_;
  next.until = rules_.deadline(now);
  idle();
  return next;
}

void HeldSpeed::done(const Next& what, Result<void> result, Instant now) {
  const Holding holding(lock_);
  if (!result && result.error().code == ErrorCode::superseded) {
    // Unless its owner has begun a new motion.
    const bool turns = rules_.state() == DeadMansSwitch::State::turning;
    if (what.task == task_ && turns) note_superseded();
    if (!turns) rules_.let_go();
    return;
  }
  if (what.action == DeadMansSwitch::Action::stop) {
    if (result || is_final(result.error().code)) {
      rules_.stopped();
    } else {
      rules_.not_stopped(now);
    }
  }
  if (result) return;
  if (result.error().code == ErrorCode::interrupted) rules_.let_go();
  if (!error_) error_ = std::move(result).error();
  rules_.fail();
}

Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed, BoundedTurn motion, bool yields) {
  using Action = DeadMansSwitch::Action;
  TaskMachine& task = co_await tasks::this_task();
  Refusals refusals(task, msg::CommandToBoard::control);
  const Restarts restarts(task);
  Yielding yielding;
  while (true) {
    const HeldSpeed::Next next = speed->next(task.now());
    if (next.is_last) co_return Result<void>();
    if (next.action == Action::none) {
      const Result<void> waited = co_await tasks::wait_for_wake(next.until);
      if (!waited && waited.error().code == ErrorCode::cancelled) speed->close();
      continue;
    }
    if (task.number() != next.task) motion.polls().forget(task);
    task.set_number(next.task);
    Result<void> result;
    if (next.action == Action::stop) {
      yielding = Yielding();
      result = co_await motion.stop([&] { return speed->is_turning(); });
      // A camera that still turns may do so because of this motion: it is stopped again, and the
      // control timeout stays.
      if (!result && result.error().code == ErrorCode::interrupted) {
        result = ClientError{ErrorCode::timeout, result.error().message};
      }
    } else if (restarts.has_restarted()) {
      result = restart_error();  // the camera must not turn again without a command
    } else if (auto refused = refusals.take()) {
      result = *std::move(refused);  // of the previous command
    } else {
      if (yields) result = co_await yielding.look(next.speed, motion);
      // A request that is sent later could follow a stop from elsewhere.
      const Instant not_after = yields ? task.now() + patience : Instant::never;
      if (result) result = co_await motion.turn(next.speed, not_after);
    }
    const bool is_stopped = !result && result.error().code == ErrorCode::interrupted;
    if (is_stopped && restarts.has_restarted()) result = restart_error();
    if (!result && is_in_other_hands(result.error().code)) {
      static_cast<void>(co_await motion.let_go());
    }
    speed->done(next, std::move(result), task.now());
  }
}

}  // namespace sbgc::detail
