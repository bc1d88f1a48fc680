#include "tasks/hold_speed.hpp"

#include <utility>

#include <sbgc/messages/control.hpp>

#include "tasks/tools.hpp"

namespace sbgc::detail {

namespace {

/// True if nothing can ever be sent again.
bool is_final(ErrorCode code) noexcept {
  return code == ErrorCode::link_lost || code == ErrorCode::not_connected ||
         code == ErrorCode::cancelled;
}

/// Notices that the board restarts.
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

ClientError restart_error() {
  return {ErrorCode::board_reset, "the board has restarted, which ended the motion"};
}

}  // namespace

HeldSpeed::Order HeldSpeed::next(Instant now) {
  const std::scoped_lock lock(mutex_);
  Order order{rules_.next(now), rules_.speed(), false, Instant::never};
  is_idle_ = order.action == DeadMansSwitch::Action::none;
  if (!is_idle_) return order;
  order.is_last = is_closing_;
  order.until = rules_.deadline(now);
  idle_.notify_all();
  return order;
}

void HeldSpeed::done(DeadMansSwitch::Action action, Result<void> result, Instant now) {
  const std::scoped_lock lock(mutex_);
  if (action == DeadMansSwitch::Action::stop) {
    if (result || is_final(result.error().code)) {
      rules_.stopped();
    } else {
      rules_.not_stopped(now);
    }
  }
  if (result) return;
  if (!error_) error_ = std::move(result).error();
  rules_.fail();
}

Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed, BoundedTurn motion) {
  using Action = DeadMansSwitch::Action;
  TaskMachine& task = co_await tasks::this_task();
  Refusals refusals(task, msg::CommandToBoard::control);
  const Restarts restarts(task);
  while (true) {
    const HeldSpeed::Order order = speed->next(task.now());
    if (order.is_last) co_return Result<void>();
    if (order.action == Action::none) {
      const Result<void> waited = co_await tasks::wait_for_wake(order.until);
      if (!waited) speed->close();
      continue;
    }
    Result<void> result;
    if (order.action == Action::stop) {
      result = co_await motion.stop();
    } else if (restarts.has_restarted()) {
      result = restart_error();  // the camera must not turn again unasked
    } else if (auto refused = refusals.take()) {
      result = *std::move(refused);  // of the previous command
    } else {
      result = co_await motion.turn(order.speed);
    }
    speed->done(order.action, std::move(result), task.now());
  }
}

}  // namespace sbgc::detail
