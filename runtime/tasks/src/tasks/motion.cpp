#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/motion.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>

#include "tasks/agreement.hpp"
#include "tasks/motion_tools.hpp"
#include "tasks/tools.hpp"

namespace sbgc {
namespace {

using detail::axis_names;
using detail::degrees_between;

/// The interval for repeating a target while nothing shows that the board has received it.
constexpr Duration repetition = milliseconds(100);
/// If an answer takes longer, the board was silent.
constexpr Duration longest_answer = milliseconds(500);
/// Target angles with a smaller difference, in degrees, are equal.
constexpr double noise = 0.05;

/// A command whose confirmation is optional: whether it arrived is known later.
class Sending {
 public:
  explicit Sending(TaskMachine& task) : task_(task) {}
  Sending(const Sending&) = delete;
  Sending& operator=(const Sending&) = delete;
  ~Sending() { task_.end(id_); }

  /// Sends a command; forgets the last one.
  template <Message M>
  void send(const M& command) {
    task_.end(id_);
    CallOptions options;
    options.expect_confirmation = true;
    id_ = task_.begin(command, options);
  }
  bool is_confirmed() const { return task_.has_started(id_); }
  std::optional<ClientError> error() const {
    const Result<Reply>* const reply = task_.reply(id_);
    if (reply == nullptr || *reply) return std::nullopt;
    return reply->error();
  }

 private:
  TaskMachine& task_;
  CallId id_{};
};

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

  /// Throws the exception of the progress handler, if there was one.
  void rethrow() const {
#if defined(__cpp_exceptions)
    if (exception_) std::rethrow_exception(exception_);
#endif
  }

  /// Sends the target, and waits until the camera turns to it or, `to_the_end`, is there.
  Task<Result<MoveProgress>> run(bool to_the_end) {
    Instant close_since = Instant::never;
    while (true) {
      // Read the angles first: commands to a silent board are useless, and old firmware needs the
      // current targets of the other axes.
      const Result<msg::GetAngles> state =
          co_await tasks::call(msg::GetAnglesRequest{}, options_of_poll());
      if (!state && is_cut_short(state.error())) co_return late(to_the_end);
      if (!state) co_return ended(state.error());
      auto refused = refusals_.take();
      if (!refused) refused = sending_.error();
      if (refused && sent_) co_return ended(*refused, "sending the target");
      const Instant now = task_.now();
      see(*state, now);
      if (to_the_end && options_.progress && !goes_on()) {
        co_return ended({ErrorCode::cancelled, ""});
      }
      if (const auto over = follow(*state, now)) co_return *over;
      const bool is_due =
          !sent_ || (now - start_ < detail::patience && now - last_sent_ >= repetition);
      if (!has_begun_ && is_due) {
        send(*state);
        last_sent_ = now;
        if (!sent_) rest_since_ = now;
        sent_ = true;
      } else if (!to_the_end && (seen_->is_close || turns(*state))) {
        co_return *seen_;
      }
      close_since = seen_->is_close ? earlier(close_since, now) : Instant::never;
      if (to_the_end && seen_->is_close &&
          now - close_since >= detail::duration_of(options_.settle)) {
        co_return *seen_;
      }
      const Instant next = now + detail::duration_of(options_.interval);
      const Result<void> waited = co_await tasks::wait_until(earlier(next, deadline_.end()));
      if (!waited) co_return ended(waited.error());
      if (deadline_.is_over()) co_return late(to_the_end);
    }
  }

 private:
  /// Calls the progress handler. The camera stops before an exception goes on.
  bool goes_on() {
#if defined(__cpp_exceptions)
    try {
      return options_.progress(*seen_);
    } catch (...) {
      exception_ = std::current_exception();
      return false;
    }
#else
    return options_.progress(*seen_);
#endif
  }
  /// The target is not sent after the patience of its beginning.
  CallOptions options_of_poll() const {
    CallOptions options = detail::options_within(deadline_);
    if (sent_) return options;
    const auto left = detail::whole_milliseconds(start_ + detail::patience - task_.now());
    options.timeout = std::min(options.timeout.value_or(left), left);
    return options;
  }
  /// True if a call failed because it had no time left.
  bool is_cut_short(const ClientError& error) const {
    return error.code == ErrorCode::timeout && seen_ && deadline_.is_over();
  }
  ClientError late(bool to_the_end) const {
    const bool never_began = !to_the_end || !has_begun_;
    return {ErrorCode::timeout,
            fmt::format("the camera did not {} within {} ms{}{}",
                        never_began ? "begin to turn" : "arrive", options_.timeout.count(),
                        never_began ? "; are the motors on? " : ": ", where())};
  }
  ClientError not_begun() const {
    return {ErrorCode::timeout,
            fmt::format("the camera did not begin to turn within {} ms; are the "
                        "motors on? {}",
                        detail::whole_milliseconds(detail::patience).count(), where())};
  }
  /// Returns the error of a move that ends for another reason: a cancellation, a later command of
  /// this client, or a failure.
  ClientError ended(const ClientError& why, const char* during = nullptr) const {
    if (why.code == ErrorCode::cancelled) {
      return detail::cancelled_error("the move (" + where() + ")");
    }
    if (why.code == ErrorCode::superseded) {
      return {
          why.code,
          "the move has ended, because a later command stops the camera or moves it; " + where()};
    }
    if (why.code == ErrorCode::board_error) return why;
    return detail::during(during != nullptr ? during : where(), why);
  }
  /// Returns the error of a move whose target the board no longer has.
  ClientError interrupted() const {
    std::string text;
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (!target_[i]) continue;
      text += fmt::format("{}{} stands at {:.2f} deg, its target is {} {:.2f}",
                          text.empty() ? "" : ", ", axis_names[i], seen_->angles[i].degrees(),
                          is_own(i) ? "still" : "no longer", target_[i]->degrees());
    }
    text += has_turned_ ? ": another program, RC, a limit or the control timeout"
                        : ": are the motors on? Or another program, RC or a limit";
    return {ErrorCode::interrupted, text};
  }

  /// Evaluates the board's response to the target since it was sent: whether the move has begun,
  /// and whether it is over because something else has changed the target.
  std::optional<ClientError> follow(const msg::GetAngles& state, Instant now) {
    if (!sent_) {
      before_ = last_ = state;
      return std::nullopt;
    }
    if (turns(state) || has_other_target(last_, state)) {
      rest_since_ = now;
      last_ = state;
    }
    has_turned_ = has_turned_ || turns(state) || has_other_target(before_, state);
    const bool has_own = is_own(0) && is_own(1) && is_own(2);
    if (!has_begun_) {
      has_begun_ = has_turned_ || sending_.is_confirmed() || has_left(before_, state);
      const bool may_repeat = now - start_ < detail::patience;
      if (!has_begun_ && !may_repeat && now - last_sent_ >= repetition) {
        if (!has_own && !seen_->is_close) return not_begun();
        has_begun_ = true;  // the board had this target before
      }
    }
    if (!has_begun_ || seen_->is_close || has_own || now - rest_since_ < detail::rest) {
      return std::nullopt;
    }
    return interrupted();
  }

  /// True if the axis has no target, or the board has the one of this move. Boards may count turns
  /// differently.
  bool is_own(std::size_t axis) const {
    if (!target_[axis]) return true;
    const double off = degrees_between(last_.axes[axis].rc_target_angle, *target_[axis]);
    return std::abs(std::remainder(off, 360)) <= noise;
  }
  bool has_other_target(const msg::GetAngles& before, const msg::GetAngles& now) const {
    return any_axis([&](std::size_t i) {
      const double way =
          degrees_between(before.axes[i].rc_target_angle, now.axes[i].rc_target_angle);
      return std::abs(way) > noise;
    });
  }
  bool has_left(const msg::GetAngles& before, const msg::GetAngles& now) const {
    return any_axis([&](std::size_t i) {
      const double way = degrees_between(before.axes[i].imu_angle, now.axes[i].imu_angle);
      return std::abs(way) > options_.tolerance;
    });
  }
  template <class Condition>
  bool any_axis(const Condition& holds) const {
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      if (target_[i] && holds(i)) return true;
    }
    return false;
  }

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
    return any_axis([&](std::size_t i) { return state.axes[i].rc_speed.raw() != 0; });
  }

  void send(const msg::GetAngles& state) {
    const bool all = target_.roll && target_.pitch && target_.yaw;
    if (!all && is_supported<msg::ControlExt>(task_.identity().versions())) {
      msg::ControlExt command;
      for (std::size_t i = 0; i < axis_names.size(); ++i) {
        if (!target_[i]) continue;  // no control, which is 0
        command.control_mode[i].set_mode(msg::ControlModeKind::angle);
        command.axes[i] = {options_.speed, *target_[i]};
      }
      return sending_.send(command);
    }
    msg::Control command;
    command.control_mode.set_mode(msg::ControlModeKind::angle);
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
      command.axes[i] = {options_.speed, target_[i] ? *target_[i] : state.axes[i].rc_target_angle};
    }
    sending_.send(command);
  }

  /// Returns, for example, "roll is at 1.50 deg, 3.00 deg from its target, yaw …".
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
  Sending sending_{task_};
  bool sent_ = false;
  Instant last_sent_{};
  bool has_begun_ = false;   // something shows that the board has the target
  bool has_turned_ = false;  // the axes, or their targets
  msg::GetAngles before_{};  // the first sending
  msg::GetAngles last_{};    // the last change
  Instant rest_since_{};     // that change
  std::optional<MoveProgress> seen_{};
#if defined(__cpp_exceptions)
  std::exception_ptr exception_{};
#endif
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

/// Returns, for example, "yaw at 61.04 deg/s"; "" if no axis turns.
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

/// Ends a move: stops the camera on failure, unless something else controls it.
Task<Result<MoveProgress>> finish(Result<MoveProgress> result, bool was_sent,
                                  bool stop_on_failure) {
  if (result || !was_sent || !stop_on_failure) co_return result;
  ClientError error = result.error();
  if (is_in_other_hands(error.code)) co_return error;
  const Result<void> stopped = co_await tasks::stop();
  if (!stopped && stopped.error().code == ErrorCode::superseded) {
    error.message += "; a later command stops the camera or moves it";
  } else if (!stopped) {
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
  if (options.settle >= options.timeout) {
    const std::string text =
        fmt::format("a move cannot end within {} ms: the camera must stay at its target for {} ms",
                    options.timeout.count(), options.settle.count());
    co_return ClientError{ErrorCode::invalid, text};
  }
  Move move(co_await this_task(), target, options);
  Result<MoveProgress> result = co_await move.run(true);
  result = co_await finish(std::move(result), move.was_sent(), options.stop_on_failure);
  move.rethrow();
  co_return result;
}

Task<Result<MoveProgress>> begin_move(MoveTarget target, MoveOptions options) {
  if (const Result<void> checked = check(target, options); !checked) co_return checked.error();
  Move move(co_await this_task(), target, options);
  Result<MoveProgress> result = co_await move.run(false);
  co_return co_await finish(std::move(result), move.was_sent(), options.stop_on_failure);
}

Task<Result<void>> stop(StopOptions options) {
  TaskMachine& task = co_await this_task();
  msg::Control halt;
  halt.control_mode.set_mode(msg::ControlModeKind::speed);
  const detail::Deadline deadline(task, options.timeout);
  detail::Refusals refusals(task, msg::CommandToBoard::control);
  Instant still_since = Instant::never;
  std::optional<std::string> turns;  // as far as is known
  std::string turned;                // what turned last
  bool was_silent = false;
  bool must_send = !options.reads_first;
  while (true) {
    // The confirmation is optional, so a loss may go unnoticed, and something else may turn the
    // camera: repeat the command while the camera turns.
    if (must_send && still_since == Instant::never) {
      const Result<void> sent = co_await call(halt, detail::options_within(deadline));
      if (!sent) co_return sent;
    }
    const Instant asked = task.now();
    const Result<msg::GetAngles> state =
        co_await call(msg::GetAnglesRequest{}, detail::options_within(deadline));
    if (!state && state.error().code == ErrorCode::superseded) co_return state.error();
    const auto unknown = [&] {
      return detail::during("checking whether the camera has stopped", state.error());
    };
    if (!state && state.error().code != ErrorCode::timeout) co_return unknown();
    // At the end, an answer has less time than it may need.
    const bool is_cut = deadline.is_over() && task.now() - asked < repetition;
    const bool is_late = task.now() - asked >= longest_answer;
    was_silent = was_silent || is_late || (!state && !is_cut);
    if (state) turns = turning(*state);
    const bool is_still = state && turns->empty();
    still_since = is_still ? earlier(still_since, task.now()) : Instant::never;
    if (is_still && task.now() - still_since >= detail::duration_of(options.rest))
      co_return Result<void>();
    if (is_still && options.goes_on && !options.goes_on()) co_return Result<void>();
    if (state && !is_still) {
      must_send = true;
      turned = *turns;
    }
    if (auto refused = refusals.take(); refused && !is_still) {
      refused->message += "; the camera still turns: " + turned;
      co_return *std::move(refused);
    }
    const Instant next = task.now() + detail::duration_of(options.interval);
    const Result<void> waited = co_await wait_until(earlier(next, deadline.end()));
    if (!waited && waited.error().code == ErrorCode::superseded) co_return waited;
    if (!waited) co_return detail::cancelled_error("stopping the camera");
    if (!deadline.is_over()) continue;
    if (!turns || (!state && !is_cut)) co_return unknown();
    const std::string seen = turned.empty() ? "" : "; at last: " + turned;
    // The board has always answered: if the camera still turns, something else turns it.
    co_return ClientError{was_silent ? ErrorCode::timeout : ErrorCode::interrupted,
                          turns->empty() ? "the camera has not come to rest" + seen
                                         : "the camera still turns: " + *turns};
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
  // No value leaves the rate unchanged: repeat the one of the parameters.
  msg::ReadParams3Request active;
  active.profile_id = msg::ReadParams3Request::active_profile;
  const std::string what = "reading the expo rate";
  const Result<msg::ReadParams3> parameters = co_await call_verified(active, what);
  if (!parameters) co_return during(what, parameters.error());
  msg::ControlConfig config;
  config.timeout_ms = msg::Milliseconds(static_cast<std::uint16_t>(timeout.count()));
  config.rc_expo_rate = parameters->rc_expo_rate;
  co_return config;
}

}  // namespace sbgc
