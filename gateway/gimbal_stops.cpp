#include "gateway/gimbal_stops.hpp"

#include <utility>

#include <asio/bind_executor.hpp>
#include <asio/post.hpp>
#include <fmt/format.h>

namespace sbgc::tools {

namespace {

/// The interval for checking waiting callers, and the pause after an attempt.
constexpr std::chrono::milliseconds attempt_interval{100};

}  // namespace

GimbalStops::GimbalStops(Gimbal& gimbal, Hooks hooks)
    : gimbal_(gimbal), hooks_(std::move(hooks)), timer_(gimbal.executor()) {}

void GimbalStops::stop(Then then) { add(stop_, OwedStop(), std::move(then)); }

void GimbalStops::stop_because(const std::string& reason, bool late) {
  if (stop_.reason.empty()) stop_.reason = reason;
  OwedStop owed;
  if (late) owed.line_lost();
  add(stop_, std::move(owed), {});
}

void GimbalStops::turn_motors_off(const AnyMessage& request, Then then) {
  add(motors_off_, OwedStop(request), std::move(then));
}

void GimbalStops::add(Debt& debt, OwedStop owed, Then then) {
  if (then) debt.waiters.push_back({Clock::now() + OwedStop::patience, std::move(then)});
  if (!debt.owed) {
    debt.owed.emplace(std::move(owed));
    debt.since = Clock::now();
    if (!is_online_) {
      debt.owed->line_lost();
      debt.last = {ErrorCode::not_connected, "the gimbal is not online"};
    }
  }
  attempt(debt);
  watch();
}

void GimbalStops::link_changed(bool is_online) {
  is_online_ = is_online;
  for (Debt* const debt : {&stop_, &motors_off_}) {
    if (!debt->owed) continue;
    debt->owed->line_lost();
    attempt(*debt);
  }
}

void GimbalStops::board_restarted() {
  for (Debt* const debt : {&stop_, &motors_off_}) {
    if (debt->owed) debt->owed->board_restarted();
  }
}

void GimbalStops::attempt(Debt& debt) {
  if (!debt.owed || debt.is_running || !is_online_ || is_closed_) return;
  debt.is_running = true;
  gimbal_.client().async_run(
      debt.owed->attempt(),
      asio::bind_executor(gimbal_.executor(),
                          [this, owner = hooks_.owner(), &debt, began = Clock::now()](
                              const Result<void>& ended) { take(debt, ended, began); }));
}

void GimbalStops::take(Debt& debt, const Result<void>& ended, Clock::time_point began) {
  debt.is_running = false;
  if (!ended) debt.last = ended.error();
  const OwedStop::State state = debt.owed->take(ended, began);
  if (state == OwedStop::State::owed) return;  // look() makes the next attempt
  // A request that was being sent may have arrived after this stop, or may still arrive.
  if (state == OwedStop::State::done && !hooks_.is_final()) return attempt(debt);
  end(debt, ended);
}

void GimbalStops::end(Debt& debt, const Result<void>& ended) {
  const Debt was = std::exchange(debt, Debt{debt.what});
  const bool are_motors_off = was.owed->turns_motors_off();
  changed();
  if (was.is_late || !was.reason.empty()) {
    hooks_.notify("stopped",
                  fmt::format("{}; {}", was.reason.empty() ? was.what : was.reason,
                              !ended ? "the camera may still turn: " + ended.error().message
                              : are_motors_off ? "the motors are off"
                                               : "the camera has stopped"));
  }
  Result<void> result = ended;
  if (ended && &debt == &motors_off_ && !are_motors_off) {
    result = ClientError{ErrorCode::board_reset, "the board has restarted; the camera has stopped"};
  }
  for (const Waiter& waiter : was.waiters) waiter.then(result);
}

void GimbalStops::watch() {
  if (is_watching_ || is_closed_ || !is_owed()) return;
  is_watching_ = true;
  timer_.expires_after(attempt_interval);
  timer_.async_wait([this, owner = hooks_.owner()](const std::error_code& error) {
    is_watching_ = false;
    if (error) return;
    look(stop_);
    look(motors_off_);
    watch();
  });
}

/// Completes the commands that have waited long enough with a result.
void GimbalStops::look(Debt& debt) {
  if (!debt.owed) return;
  const auto now = Clock::now();
  if (!debt.is_late && now >= debt.since + OwedStop::patience) {
    debt.is_late = true;
    changed();
    hooks_.notify("stopping", fmt::format("{} is still owed: {}", debt.what, debt.last.message));
  }
  std::vector<Waiter> waiters = std::exchange(debt.waiters, {});
  for (Waiter& waiter : waiters) {
    if (now < waiter.until) {
      debt.waiters.push_back(std::move(waiter));
    } else {
      waiter.then(ClientError{debt.last.code, "still trying: " + debt.last.message});
    }
  }
  attempt(debt);
}

void GimbalStops::changed() {
  gimbal_.set_stopping(is_late());
  hooks_.changed();
}

void GimbalStops::close() {
  is_closed_ = true;
  timer_.cancel();
}

}  // namespace sbgc::tools
