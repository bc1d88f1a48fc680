#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>

#include "refusals.hpp"
#include "task.hpp"

namespace sbgc {
namespace {

constexpr std::array<const char*, 3> axis_names{"roll", "pitch", "yaw"};
/// How long a camera that stands still elsewhere may do so before the command is sent again.
constexpr std::chrono::milliseconds patience{500};

/// The way from one angle to another. Both count two turns in each direction and then begin again.
double degrees_between(msg::Angle14 from, msg::Angle14 to) noexcept {
  const auto raw = static_cast<std::uint16_t>(to.raw() - from.raw());
  return msg::Angle14(static_cast<std::int16_t>(raw)).degrees();
}

/// move_to() as it goes on.
class Move {
 public:
  Move(Client& client, const MoveTarget& target, msg::ControlSpeed speed,
       const MoveOptions& options)
      : client_(client),
        target_(target),
        speed_(speed),
        options_(options),
        start_(options.clock.now()),
        deadline_(options.clock, options.timeout) {}

  Result<MoveProgress> run() {
    Result<MoveProgress> result = arrive();
    if (result || !sent_ || !options_.stop_on_failure) return result;
    ClientError error = result.error();
    const Result<void> stopped = stop(client_, {.clock = options_.clock});
    if (!stopped) {
      error.message += fmt::format("; stopping it failed: {}", stopped.error().message);
    } else {
      // A board that refuses the target refuses the stop as well.
      error.message += error.code == ErrorCode::board_error ? "; the camera stands still"
                                                            : "; it has been stopped";
    }
    return error;
  }

 private:
  Result<MoveProgress> arrive() {
    constexpr Clock::TimePoint never = Clock::TimePoint::max();
    Clock::TimePoint close_since = never;
    Clock::TimePoint sent_at{};
    while (true) {
      // Without an answer there is no use in commands, and old firmware has to be told where axes
      // are that are left alone.
      const Result<msg::GetAngles> state =
          client_.call(msg::GetAnglesRequest{}, detail::options_within(deadline_));
      if (!state) return detail::during(where(), state.error());
      if (auto refused = refusals_.take(); refused && sent_) return *std::move(refused);
      const Clock::TimePoint now = options_.clock.now();
      see(*state, now);
      const bool stands_still = !seen_->is_close && !turns(*state) && now - sent_at >= patience;
      if (!sent_ || stands_still) {
        if (Result<void> sent = send(*state); !sent) {
          return detail::during("sending the target", sent.error());
        }
        sent_ = true;
        sent_at = now;
      }
      if (options_.progress && !options_.progress(*seen_)) {
        return detail::cancelled_error("the move; " + where());
      }
      close_since = seen_->is_close ? std::min(close_since, now) : never;
      if (seen_->is_close && now - close_since >= options_.settle) return *seen_;
      if (deadline_.is_over()) {
        return ClientError{ErrorCode::timeout, fmt::format("the camera did not arrive within {} "
                                                           "ms: {}",
                                                           options_.timeout.count(), where())};
      }
      options_.clock.sleep_until(std::min(now + options_.interval, deadline_.end()));
    }
  }

  void see(const msg::GetAngles& state, Clock::TimePoint now) {
    MoveProgress& seen = seen_.emplace();
    seen.is_close = true;
    seen.elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(now - start_);
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      seen.angles[i] = state.axes[i].imu_angle;
      if (!target_[i]) continue;
      seen.remaining[i] = degrees_between(seen.angles[i], *target_[i]);
      if (std::abs(seen.remaining[i]) > options_.tolerance) seen.is_close = false;
    }
  }

  /// Whether an axis that is moved has a speed.
  bool turns(const msg::GetAngles& state) const {
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (target_[i] && state.axes[i].rc_speed.raw() != 0) return true;
    }
    return false;
  }

  Result<void> send(const msg::GetAngles& state) {
    const CallOptions options = detail::options_within(deadline_);
    const bool all = target_.roll && target_.pitch && target_.yaw;
    if (!all && is_supported<msg::ControlExt>(client_.board().versions())) {
      msg::ControlExt command;
      for (std::size_t i = 0; i < axis_names.size(); ++i) {
        if (!target_[i]) continue;  // no control, which is 0
        command.control_mode[i].set_mode(msg::ControlModeKind::angle);
        command.axes[i] = {speed_, *target_[i]};
      }
      return client_.call(command, options);
    }
    msg::Control command;
    command.control_mode.set_mode(msg::ControlModeKind::angle);
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      command.axes[i] = {speed_, target_[i] ? *target_[i] : state.axes[i].rc_target_angle};
    }
    return client_.call(command, options);
  }

  /// "roll is at 1.5 deg, 3 deg before its target; …"
  std::string where() const {
    if (!seen_) return "asking where the camera is";
    std::string result;
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (!target_[i]) continue;
      result += fmt::format("{}{} is at {:.2f} deg, {:.2f} deg from its target",
                            result.empty() ? "" : ", ", axis_names[i], seen_->angles[i].degrees(),
                            std::abs(seen_->remaining[i]));
    }
    return result;
  }

  Client& client_;
  const MoveTarget& target_;
  msg::ControlSpeed speed_;
  const MoveOptions& options_;
  Clock::TimePoint start_;
  Deadline deadline_;
  detail::Refusals refusals_{client_, msg::CommandToBoard::control};
  bool sent_ = false;
  std::optional<MoveProgress> seen_{};
};

Result<void> check(const MoveTarget& target, msg::ControlSpeed speed, const MoveOptions& options) {
  if (!target.roll && !target.pitch && !target.yaw) {
    return ClientError{ErrorCode::invalid, "a move needs a target for at least one axis"};
  }
  if (speed.raw() < 0) {
    return ClientError{ErrorCode::invalid, "the speed of a move has no direction"};
  }
  if (!(options.tolerance > 0) || options.interval.count() <= 0) {
    return ClientError{ErrorCode::invalid, "tolerance and interval of a move are more than 0"};
  }
  return {};
}

}  // namespace

Result<MoveProgress> move_to(Client& client, const MoveTarget& target, msg::ControlSpeed speed,
                             const MoveOptions& options) {
  if (auto checked = check(target, speed, options); !checked) return checked.error();
  return Move(client, target, speed, options).run();
}

Result<void> stop(Client& client, const StopOptions& options) {
  msg::Control halt;
  halt.control_mode.set_mode(msg::ControlModeKind::speed);
  const Deadline deadline(options.clock, options.timeout);
  detail::Refusals refusals(client, msg::CommandToBoard::control);
  while (true) {
    // The command need not be confirmed, so it may be lost without notice: it is sent until the
    // board is seen to have obeyed.
    if (Result<void> sent = client.call(halt, detail::options_within(deadline)); !sent) return sent;
    const Result<msg::GetAngles> state =
        client.call(msg::GetAnglesRequest{}, detail::options_within(deadline));
    const bool is_silent = !state && state.error().code == ErrorCode::timeout;
    if ((!state && !is_silent) || (is_silent && deadline.is_over())) {
      return detail::during("looking whether the camera has stopped", state.error());
    }
    std::string turning;
    for (std::size_t i = 0; state && i < axis_names.size(); ++i) {
      const msg::ControlSpeed speed = state->axes[i].rc_speed;
      if (speed.raw() == 0) continue;
      turning += fmt::format("{}{} with {:.2f} deg/s", turning.empty() ? "" : ", ", axis_names[i],
                             speed.degrees_per_second());
    }
    if (state && turning.empty()) return {};
    if (auto refused = refusals.take()) {
      refused->message += "; the camera still turns: " + turning;
      return *std::move(refused);
    }
    if (deadline.is_over()) {
      return ClientError{ErrorCode::timeout, "the camera still turns: " + turning};
    }
    options.clock.sleep_until(std::min(options.clock.now() + options.interval, deadline.end()));
  }
}

Result<void> release(Client& client) { return client.call(msg::Control{}); }

}  // namespace sbgc
