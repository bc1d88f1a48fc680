#include "tasks/hold_speed.hpp"

#include <utility>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>

#include "tasks/tools.hpp"

namespace sbgc::detail {

namespace {

/// True if nothing can ever be sent again.
bool is_final(ErrorCode code) noexcept {
  return code == ErrorCode::link_lost || code == ErrorCode::not_connected ||
         code == ErrorCode::cancelled;
}

Task<Result<void>> send_speed(DeadMansSwitch::Speed speed) {
  msg::Control command;
  command.control_mode.set_mode(msg::ControlModeKind::speed);
  for (std::size_t i = 0; i < DeadMansSwitch::Speed::size(); ++i) {
    command.axes[i].speed = speed[i];
  }
  // A short timeout: a stop must not wait long behind a queued command.
  CallOptions options;
  options.timeout = std::chrono::seconds(1);
  co_return co_await tasks::call(command, options);
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

Task<Result<void>> hold_speed(std::shared_ptr<HeldSpeed> speed) {
  using Action = DeadMansSwitch::Action;
  TaskMachine& task = co_await tasks::this_task();
  Refusals refusals(task, msg::CommandToBoard::control);
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
      result = co_await tasks::stop();
    } else if (auto refused = refusals.take()) {
      result = *std::move(refused);  // of the previous command
    } else {
      result = co_await send_speed(order.speed);
    }
    speed->done(order.action, std::move(result), task.now());
  }
}

}  // namespace sbgc::detail
