#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>

#include "tasks/agreement.hpp"
#include "tasks/control_timeout.hpp"
#include "tasks/tools.hpp"

namespace sbgc {
namespace {

constexpr std::array<const char*, 3> axis_names{"roll", "pitch", "yaw"};
/// How long a camera may stand still off its target before the command is repeated.
constexpr Duration patience = milliseconds(500);

/// Returns the signed difference of two angles, which wrap around after two turns in each
/// direction.
double degrees_between(msg::Angle14 from, msg::Angle14 to) noexcept {
  const auto raw = static_cast<std::uint16_t>(to.raw() - from.raw());
  return msg::Angle14(static_cast<std::int16_t>(raw)).degrees();
}

/// The state of a running move_to().
class Move {
 public:
  Move(TaskMachine& task, const MoveTarget& target, const MoveOptions& options)
      : task_(task),
        target_(target),
        options_(options),
        start_(task.now()),
        deadline_(task, options.timeout) {}

  bool was_sent() const noexcept { return sent_; }

  /// Sends the target until the camera turns to it or is there.
  Task<Result<MoveProgress>> begin() {
    while (true) {
      const Result<msg::GetAngles> state =
          co_await tasks::call(msg::GetAnglesRequest{}, detail::options_within(deadline_));
      if (!state && is_cut_short(state.error()))
        co_return late("begin to turn", "; are the motors on? ");
      if (!state) co_return detail::during(where(), state.error());
      if (auto refused = refusals_.take(); refused && sent_) co_return *std::move(refused);
      see(*state, task_.now());
      if (sent_ && (seen_->is_close || turns(*state))) co_return *seen_;
      const Result<void> sent = co_await send(*state);
      if (!sent) co_return detail::during("sending the target", sent.error());
      sent_ = true;
      const Instant next = task_.now() + detail::duration_of(options_.interval);
      const Result<void> waited = co_await tasks::wait_until(earlier(next, deadline_.end()));
      if (!waited) co_return cancelled();
      if (deadline_.is_over()) co_return late("begin to turn", "; are the motors on? ");
    }
  }

  Task<Result<MoveProgress>> arrive() {
    Instant close_since = Instant::never;
    Instant sent_at{};
    while (true) {
      // Read the angles first: commands are useless to a silent board, and old firmware needs the
      // current targets of axes that are left alone.
      const Result<msg::GetAngles> state =
          co_await tasks::call(msg::GetAnglesRequest{}, detail::options_within(deadline_));
      if (!state && is_cut_short(state.error())) co_return late("arrive", ": ");
      if (!state) co_return detail::during(where(), state.error());
      if (auto refused = refusals_.take(); refused && sent_) co_return *std::move(refused);
      const Instant now = task_.now();
      see(*state, now);
      if (options_.progress && !options_.progress(*seen_)) co_return cancelled();
      const bool stands_still = !seen_->is_close && !turns(*state) && now - sent_at >= patience;
      if (!sent_ || stands_still) {
        const Result<void> sent = co_await send(*state);
        if (!sent) co_return detail::during("sending the target", sent.error());
        sent_ = true;
        sent_at = now;
      }
      close_since = seen_->is_close ? earlier(close_since, now) : Instant::never;
      if (seen_->is_close && now - close_since >= detail::duration_of(options_.settle)) {
        co_return *seen_;
      }
      const Instant next = now + detail::duration_of(options_.interval);
      const Result<void> waited = co_await tasks::wait_until(earlier(next, deadline_.end()));
      if (!waited) co_return cancelled();
      if (deadline_.is_over()) co_return late("arrive", ": ");
    }
  }

 private:
  /// True if a call failed because there was no time left for it.
  bool is_cut_short(const ClientError& error) const {
    return error.code == ErrorCode::timeout && seen_ && deadline_.is_over();
  }
  ClientError late(const char* what, const char* separator) const {
    return {ErrorCode::timeout, fmt::format("the camera did not {} within {} ms{}{}", what,
                                            options_.timeout.count(), separator, where())};
  }
  ClientError cancelled() const { return detail::cancelled_error("the move (" + where() + ")"); }

  void see(const msg::GetAngles& state, Instant now) {
    MoveProgress& seen = seen_.emplace();
    seen.is_close = true;
    seen.elapsed = detail::whole_milliseconds(now - start_);
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      seen.angles[i] = state.axes[i].imu_angle;
      if (!target_[i]) continue;
      seen.remaining[i] = degrees_between(seen.angles[i], *target_[i]);
      if (std::abs(seen.remaining[i]) > options_.tolerance) seen.is_close = false;
    }
  }

  /// True if a target axis has a speed.
  bool turns(const msg::GetAngles& state) const {
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (target_[i] && state.axes[i].rc_speed.raw() != 0) return true;
    }
    return false;
  }

  Task<Result<void>> send(msg::GetAngles state) {
    const CallOptions options = detail::options_within(deadline_);
    const bool all = target_.roll && target_.pitch && target_.yaw;
    if (!all && is_supported<msg::ControlExt>(task_.identity().versions())) {
      msg::ControlExt command;
      for (std::size_t i = 0; i < axis_names.size(); ++i) {
        if (!target_[i]) continue;  // no control, which is 0
        command.control_mode[i].set_mode(msg::ControlModeKind::angle);
        command.axes[i] = {options_.speed, *target_[i]};
      }
      co_return co_await tasks::call(command, options);
    }
    msg::Control command;
    command.control_mode.set_mode(msg::ControlModeKind::angle);
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      command.axes[i] = {options_.speed, target_[i] ? *target_[i] : state.axes[i].rc_target_angle};
    }
    co_return co_await tasks::call(command, options);
  }

  /// For example "roll is at 1.50 deg, 3.00 deg from its target, yaw …".
  std::string where() const {
    if (!seen_) return "reading the camera angles";
    std::string result;
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (!target_[i]) continue;
      result += fmt::format("{}{} is at {:.2f} deg, {:.2f} deg from its target",
                            result.empty() ? "" : ", ", axis_names[i], seen_->angles[i].degrees(),
                            std::abs(seen_->remaining[i]));
    }
    return result;
  }

  TaskMachine& task_;
  const MoveTarget& target_;
  const MoveOptions& options_;
  Instant start_;
  detail::Deadline deadline_;
  detail::Refusals refusals_{task_, msg::CommandToBoard::control};
  bool sent_ = false;
  std::optional<MoveProgress> seen_{};
};

Result<void> check(const MoveTarget& target, const MoveOptions& options) {
  if (!target.roll && !target.pitch && !target.yaw) {
    return ClientError{ErrorCode::invalid, "a move needs a target for at least one axis"};
  }
  if (options.speed.raw() < 0) {
    return ClientError{ErrorCode::invalid, "the speed of a move must not be negative"};
  }
  if (!(options.tolerance > 0) || options.interval.count() <= 0) {
    return ClientError{ErrorCode::invalid, "the tolerance and interval of a move must be positive"};
  }
  return {};
}

/// For example "yaw at 61.04 deg/s"; "" if no axis turns.
std::string turning(const msg::GetAngles& state) {
  std::string result;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    const msg::ControlSpeed speed = state.axes[i].rc_speed;
    if (speed.raw() == 0) continue;
    result += fmt::format("{}{} at {:.2f} deg/s", result.empty() ? "" : ", ", axis_names[i],
                          speed.degrees_per_second());
  }
  return result;
}

/// Ends a move: stops the camera if it failed.
Task<Result<MoveProgress>> finish(Result<MoveProgress> result, bool was_sent,
                                  bool stop_on_failure) {
  if (result || !was_sent || !stop_on_failure) co_return result;
  ClientError error = result.error();
  const Result<void> stopped = co_await tasks::stop();
  if (!stopped) {
    error.message += fmt::format("; stopping it failed: {}", stopped.error().message);
  } else {
    // A board that rejects the target also rejects the stop.
    error.message += error.code == ErrorCode::board_error ? "; the camera is not turning"
                                                          : "; it has been stopped";
  }
  co_return error;
}

}  // namespace

namespace tasks {

Task<Result<MoveProgress>> move_to(MoveTarget target, MoveOptions options) {
  if (const Result<void> checked = check(target, options); !checked) co_return checked.error();
  Move move(co_await this_task(), target, options);
  Result<MoveProgress> result = co_await move.arrive();
  co_return co_await finish(std::move(result), move.was_sent(), options.stop_on_failure);
}

Task<Result<MoveProgress>> begin_move(MoveTarget target, MoveOptions options) {
  if (const Result<void> checked = check(target, options); !checked) co_return checked.error();
  Move move(co_await this_task(), target, options);
  Result<MoveProgress> result = co_await move.begin();
  co_return co_await finish(std::move(result), move.was_sent(), options.stop_on_failure);
}

Task<Result<void>> stop(StopOptions options) {
  TaskMachine& task = co_await this_task();
  msg::Control halt;
  halt.control_mode.set_mode(msg::ControlModeKind::speed);
  const detail::Deadline deadline(task, options.timeout);
  detail::Refusals refusals(task, msg::CommandToBoard::control);
  while (true) {
    // The board need not confirm the command, so a loss may go unnoticed: repeat it until the board
    // reports speed 0.
    const Result<void> sent = co_await call(halt, detail::options_within(deadline));
    if (!sent) co_return sent;
    const Result<msg::GetAngles> state =
        co_await call(msg::GetAnglesRequest{}, detail::options_within(deadline));
    const auto unknown = [&] {
      return detail::during("checking whether the camera has stopped", state.error());
    };
    if (!state && state.error().code != ErrorCode::timeout) co_return unknown();
    const std::string still = state ? turning(*state) : "";
    if (state && still.empty()) co_return Result<void>();
    if (auto refused = refusals.take()) {
      refused->message += "; the camera still turns: " + still;
      co_return *std::move(refused);
    }
    const Instant next = task.now() + detail::duration_of(options.interval);
    const Result<void> waited = co_await wait_until(earlier(next, deadline.end()));
    if (!waited) co_return detail::cancelled_error("stopping the camera");
    if (!deadline.is_over()) continue;
    co_return state ? ClientError{ErrorCode::timeout, "the camera still turns: " + still}
                    : unknown();
  }
}

Task<Result<void>> release() { co_return co_await call(msg::Control{}); }

Task<Result<void>> set_control_timeout(std::chrono::milliseconds timeout) {
  const Result<msg::ControlConfig> config = co_await detail::control_timeout_request(timeout);
  if (!config) co_return config.error();
  CallOptions options;
  options.validate = false;  // the board's own rate
  co_return co_await call(*config, options);
}

}  // namespace tasks

Task<Result<msg::ControlConfig>> detail::control_timeout_request(
    std::chrono::milliseconds timeout) {
  if (timeout.count() < 0 || timeout.count() > std::numeric_limits<std::uint16_t>::max()) {
    co_return ClientError{ErrorCode::invalid,
                          "the timeout of serial control must be 0 to 65535 ms"};
  }
  // The rate has no value that keeps it: repeat the one of the parameters.
  msg::ReadParams3Request active;
  active.profile_id = msg::ReadParams3Request::active_profile;
  const std::string what = "reading the expo rate";
  const Result<msg::ReadParams3> parameters = co_await call_surely(active, what);
  if (!parameters) co_return during(what, parameters.error());
  msg::ControlConfig config;
  config.timeout_ms = msg::Milliseconds(static_cast<std::uint16_t>(timeout.count()));
  config.rc_expo_rate = parameters->rc_expo_rate;
  co_return config;
}

}  // namespace sbgc
