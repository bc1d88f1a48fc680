#include "gateway/gimbal_tasks.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include <asio/bind_cancellation_slot.hpp>
#include <asio/bind_executor.hpp>
#include <asio/post.hpp>

#include <sbgc/client/calibration.hpp>
#include <sbgc/messages/realtime.hpp>

#include "gateway/parameter_tasks.hpp"
#include "values/axis_values.hpp"
#include "values/message_json.hpp"

namespace sbgc::tools {

namespace {

/// The interval at which a moving gimbal checks that the broker is alive.
constexpr std::chrono::milliseconds look_interval{100};

TaskOutcome failed_outcome(const ClientError& error) {
  // The client may end a running motion before its cancellation; "superseded" has not begun.
  const bool is_ended = error.code == ErrorCode::superseded;
  return {error.code == ErrorCode::unconfirmed ? "unknown" : "failed",
          name(is_ended ? ErrorCode::cancelled : error.code),
          error.message,
          {}};
}

Json angles_json(const MoveProgress& progress) {
  Json angles;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    angles[axis_names[i]] = progress.angles[i].degrees();
  }
  return {{"angles", std::move(angles)}};
}

Json response_json(const std::optional<AnyMessage>& response) {
  if (!response) return {};
  return {{"message", response->type().info->name}, {"fields", Json::parse(response->to_json())}};
}

const char* calibration_text(CalibrationEnd end) {
  switch (end) {
    case CalibrationEnd::finished: return "finished";
    case CalibrationEnd::accepted: return "accepted";
  }
  return "unknown";
}

}  // namespace

GimbalTasks::GimbalTasks(Gimbal& gimbal, Hooks hooks, std::optional<std::int64_t> moved_by)
    : gimbal_(gimbal),
      hooks_(std::move(hooks)),
      timer_(gimbal.executor()),
      stops_(gimbal,
             {[this] { return shared_from_this(); }, hooks_.notify,
              [this] { return !speed_ || speed_->has_settled(); }, [this] { stops_changed(); }}),
      was_left_moving_(moved_by.has_value()) {
  if (!moved_by) return;
  last_motion_ = *moved_by;
  moves_until_ = Clock::time_point::max();
}

void GimbalTasks::run(Job job) {
  if (std::holds_alternative<StopOrder>(job.order.what)) ++stop_count_;
  asio::post(gimbal_.executor(), [self = shared_from_this(), job = std::move(job)]() mutable {
    self->add(std::move(job));
  });
}

void GimbalTasks::recorded(std::int64_t stop) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), stop] {
    self->last_motion_ = std::max(self->last_motion_, stop);
    self->report_rest();
  });
}

void GimbalTasks::link_changed(bool is_online) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), is_online] {
    if (std::exchange(self->was_left_moving_, false)) {
      self->halt("the gateway ended while the camera could move", true);
    }
    if (std::exchange(self->is_online_, is_online) == is_online) return;
    self->heard_ = Clock::now();
    if (!is_online) {
      // No queued command may move the camera when the line is back.
      self->end_waiting_motions("link_lost", "the line to the gimbal was lost");
      if (self->is_moving()) self->halt("the line was lost while the camera could move");
      self->report_rest();
    }
    self->stops_.link_changed(is_online);
    if (is_online) self->watch();
  });
}

void GimbalTasks::board_restarted() {
  asio::post(gimbal_.executor(), [self = shared_from_this()] { self->stops_.board_restarted(); });
}

void GimbalTasks::shut_down(std::function<void()> done) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), done = std::move(done)] {
    self->is_shut_down_ = true;
    self->timer_.cancel();
    while (!self->waiting_.empty()) {
      const Job job = std::exchange(self->waiting_.front(), {});
      self->waiting_.pop_front();
      self->end(job, {"refused", "closing", "the gateway ends", {}});
    }
    const bool was_moving = self->is_moving();
    // Writing parameters is not interrupted.
    const bool writes =
        self->current_ && std::holds_alternative<SetOrder>(self->current_->order.what);
    if (self->current_ && self->cancel_ && !writes) {
      self->cancel_->emit(asio::cancellation_type::terminal);
    }
    self->shut_down_ = done;
    if (was_moving) self->stop([](const TaskOutcome&) {});
    if (!self->stops_.is_owed()) self->stops_changed();
  });
}

void GimbalTasks::give_up() {
  asio::post(gimbal_.executor(), [self = shared_from_this()] { self->stops_.close(); });
}

void GimbalTasks::add(Job job) {
  if (is_shut_down_) return end(job, {"refused", "closing", "the gateway ends", {}});
  if (std::holds_alternative<StopOrder>(job.order.what)) {
    end_waiting_motions("superseded", "a later command stops the camera");
    return stop(std::move(job.done));
  }
  if (job.order.is_urgent) return turn_motors_off(std::move(job));
  if (job.order.must_not_wait && job.stops < stop_count_) {
    return end(job, {"refused", "superseded", "a later command stops the camera", {}});
  }
  constexpr std::size_t most_waiting = 16;
  if (waiting_.size() >= most_waiting) {
    return end(job, {"refused", "overload", "too many commands wait for this gimbal", {}});
  }
  waiting_.push_back(std::move(job));
  begin_next();
}

void GimbalTasks::begin_next() {
  while (!current_ && !stops_.is_stopping() && !waiting_.empty()) {
    Job job = std::move(waiting_.front());
    waiting_.pop_front();
    const Order& order = job.order;
    const bool is_speed = std::holds_alternative<SpeedOrder>(order.what);
    const bool ends_speed = is_turning_ && order.must_not_wait && !is_speed;
    if (job.deadline && std::chrono::system_clock::now() > *job.deadline) {
      end(job, {"refused", "expired", "its deadline passed before it could begin", {}});
    } else if (is_speed && Clock::now() > job.arrived + longest_silence) {
      end(job, {"refused", "expired", "a speed that could not begin at once is not wanted", {}});
    } else if (order.must_not_wait && stops_.is_late()) {
      end(job, {"refused", "stopping", "a stop of the camera has not succeeded yet", {}});
    } else if (order.must_not_wait && !hooks_.is_broker_there()) {
      end(job, {"refused", "no_broker", "the broker is gone, so nothing would stop it", {}});
    } else if (order.sets_in_motion() && !is_online_) {
      end(job, {"failed", name(ErrorCode::not_connected), "the gimbal is not online", {}});
    } else {
      current_.emplace(std::move(job));
      ends_speed ? begin_after_speed() : begin(current_->order);
    }
  }
}

/// The stop of the speed must not overtake the next motion.
void GimbalTasks::begin_after_speed() {
  is_preparing_ = true;
  end_motion();
  stops_.stop([self = shared_from_this()](const Result<void>& stopped) {
    // Another stop may have ended the wait.
    const bool is_cancelled = !std::exchange(self->is_preparing_, false) || self->is_shut_down_;
    if (is_cancelled) {
      self->finish({"failed", name(ErrorCode::cancelled), "a later command stops the camera", {}});
    } else if (!stopped) {
      self->finish(failed_outcome(stopped.error()));
    } else {
      self->begin(self->current_->order);
    }
  });
}

template <class R>
auto GimbalTasks::handler(std::function<TaskOutcome(const Result<R>&)> read) {
  cancel_ = std::make_unique<asio::cancellation_signal>();
  return asio::bind_cancellation_slot(
      cancel_->slot(),
      asio::bind_executor(gimbal_.executor(),
                          [self = shared_from_this(), read = std::move(read)](
                              const Result<R>& result) { self->finish(read(result)); }));
}

template <class R>
void GimbalTasks::start(Task<Result<R>> task, std::function<TaskOutcome(const R&)> read) {
  gimbal_.client().async_run(std::move(task), handler<R>([read](const Result<R>& result) {
                               return result ? read(*result) : failed_outcome(result.error());
                             }));
}

void GimbalTasks::begin(const Order& order) {
  moved_before_ = may_go_on();
  if (order.sets_in_motion()) {
    last_motion_ = std::max(last_motion_, current_->command);
    const bool is_bounded = order.goes_on.count() != 0 && order.goes_on != Order::forever;
    const auto until = is_bounded ? Clock::now() + order.goes_on : Clock::time_point::max();
    // The dead man's switch monitors a speed.
    if (!std::holds_alternative<SpeedOrder>(order.what)) {
      moves_until_ = std::max(moves_until_.value_or(until), until);
    }
    watch();
  }
  AsyncClient& client = gimbal_.client();
  const auto visit = [&](const auto& what) {
    using What = std::decay_t<decltype(what)>;
    if constexpr (std::is_same_v<What, MoveOrder>) {
      start<MoveProgress>(tasks::move_to(what.target, what.options), [](const MoveProgress& end) {
        return TaskOutcome{.result = angles_json(end)};
      });
    } else if constexpr (std::is_same_v<What, SpeedOrder>) {
      finish(set_speed(what));
    } else if constexpr (std::is_same_v<What, CallOrder>) {
      CallOptions options;
      options.expect_confirmation = true;
      client.async_call(
          what.request, options,
          handler<std::optional<AnyMessage>>([](const Result<std::optional<AnyMessage>>& response) {
            if (!response) return failed_outcome(response.error());
            return TaskOutcome{.result = response_json(*response)};
          }));
    } else if constexpr (std::is_same_v<What, CalibrateOrder>) {
      start<CalibrationEnd>(tasks::run_calibration(what.request), [](const CalibrationEnd& end) {
        return TaskOutcome{.result = {{"end", calibration_text(end)}}};
      });
    } else if constexpr (std::is_same_v<What, GetOrder>) {
      start<Json>(get_parameters(what),
                  [](const Json& json) { return TaskOutcome{.result = json}; });
    } else if constexpr (std::is_same_v<What, SetOrder>) {
      start<Json>(set_parameters(what),
                  [](const Json& json) { return TaskOutcome{.result = json}; });
    } else {
      static_assert(std::is_same_v<What, StopOrder>);  // add() does not queue it
    }
  };
  std::visit(visit, order.what);
}

void GimbalTasks::finish(TaskOutcome outcome) {
  const Job ended = std::move(*current_);
  current_.reset();
  if (std::holds_alternative<MoveOrder>(ended.order.what) && outcome.status == "done" &&
      !moved_before_) {
    moves_until_.reset();
  }
  end(ended, std::move(outcome));
  // Deferred, so that the stack does not grow with the queue.
  asio::post(gimbal_.executor(), [self = shared_from_this()] { self->begin_next(); });
}

void GimbalTasks::end(const Job& job, TaskOutcome outcome) {
  if (job.order.sets_in_motion()) last_motion_ = std::max(last_motion_, job.command);
  job.done(std::move(outcome));
  report_rest();
}

TaskOutcome GimbalTasks::set_speed(const SpeedOrder& order) {
  if (speed_ && speed_->state() == SpeedControl::State::failed) speed_.reset();
  if (!speed_) {
    speed_ = std::make_unique<SpeedControl>(gimbal_.client(),
                                            SpeedControlOptions{.silence = longest_silence});
  }
  if (Result<void> set = speed_->set(order.speed); !set) return failed_outcome(set.error());
  is_turning_ = true;
  return {.result = {{"lasts", longest_silence.count()}}};
}

void GimbalTasks::stop(Done done) {
  end_motion();
  is_preparing_ = false;
  stops_.stop([done = std::move(done)](const Result<void>& stopped) {
    done(stopped ? TaskOutcome() : failed_outcome(stopped.error()));
  });
}

void GimbalTasks::turn_motors_off(Job job) {
  end_waiting_motions("superseded", "a later command turns the motors off");
  end_motion();
  is_preparing_ = false;
  const AnyMessage request = std::get<CallOrder>(job.order.what).request;
  stops_.turn_motors_off(request, [self = shared_from_this(), job](const Result<void>& ended) {
    self->end(job, ended ? TaskOutcome() : failed_outcome(ended.error()));
  });
}

/// Begins to end the running command. Only a stop verifies that the camera stops.
void GimbalTasks::end_motion() {
  if (std::exchange(is_turning_, false)) moves_until_ = Clock::time_point::max();
  if (speed_) static_cast<void>(speed_->stop());
  // An unconfirmed request is not repeated either.
  if (current_ && !is_preparing_ && current_->order.sets_in_motion()) {
    cancel_->emit(asio::cancellation_type::terminal);
  }
}

/// Stops a camera without a stop command.
void GimbalTasks::halt(const char* reason, bool late) {
  end_waiting_motions("stopped", "the camera was stopped");
  end_motion();
  is_preparing_ = false;
  stops_.stop_because(reason, late);
}

/// During a pending stop, no command turns the camera.
void GimbalTasks::stops_changed() {
  if (!stops_.is_owed()) moves_until_.reset();
  report_rest();
  if (shut_down_ && !stops_.is_owed()) {
    speed_.reset();
    std::exchange(shut_down_, {})();
  }
  asio::post(gimbal_.executor(), [self = shared_from_this()] { self->begin_next(); });
}

void GimbalTasks::end_waiting_motions(const char* code, const char* message) {
  std::deque<Job> kept;
  std::deque<Job> ended;
  for (Job& job : waiting_) (job.order.must_not_wait ? ended : kept).push_back(std::move(job));
  waiting_ = std::move(kept);
  for (const Job& job : ended) end(job, {"refused", code, message, {}});
}

bool GimbalTasks::may_go_on() const { return moves_until_ && Clock::now() < *moves_until_; }

bool GimbalTasks::is_moving() const {
  return is_turning_ || may_go_on() || stops_.is_owed() ||
         (current_ && current_->order.sets_in_motion());
}

void GimbalTasks::report_rest() {
  if (is_moving() || reported_ == last_motion_) return;
  reported_ = last_motion_;
  hooks_.at_rest(last_motion_);
}

void GimbalTasks::watch() {
  if (is_watching_ || is_shut_down_) return;
  is_watching_ = true;
  timer_.expires_after(look_interval);
  timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
    self->is_watching_ = false;
    if (!error) self->look();
  });
}

void GimbalTasks::look() {
  if (is_turning_ && speed_->state() != SpeedControl::State::turning) {
    is_turning_ = false;
    const bool was_stopped = speed_->state() == SpeedControl::State::silenced;
    if (!was_stopped) moves_until_ = Clock::time_point::max();
    hooks_.notify("speed_ended",
                  was_stopped ? "the camera was stopped, because no further speed was commanded"
                              : "the speed could not be held");
  }
  if (!is_moving()) return report_rest();
  // While offline, link_changed() continues.
  if (!is_online_) return;
  if (!stops_.is_owed() && !hooks_.is_broker_there()) halt("the broker is gone");
  watch_silence();
  watch();
}

/// Requests the angles of a gimbal that may be moving when the line carries nothing. Our own calls
/// have their own timeouts.
void GimbalTasks::watch_silence() {
  constexpr std::chrono::milliseconds longest_unreported{1'500};
  const auto now = Clock::now();
  const bool is_called =
      current_ && !is_preparing_ && !std::holds_alternative<MoveOrder>(current_->order.what);
  const std::uint64_t frames = gimbal_.client().statistics().session.parser.frames;
  if (std::exchange(frames_, frames) != frames || is_called) {
    heard_ = now;
    is_silent_ = false;
  }
  const auto silence = now - heard_;
  if (silence < longest_silence) return;
  if (!std::exchange(is_asking_, true)) {
    gimbal_.client().async_call(
        msg::GetAnglesRequest{}, {.retries = 0},
        asio::bind_executor(gimbal_.executor(),
                            [self = shared_from_this()](const Result<msg::GetAngles>&) {
                              self->is_asking_ = false;
                            }));
  }
  if (silence >= longest_unreported && !std::exchange(is_silent_, true)) {
    hooks_.notify("silent", "the gimbal may move, and has not answered for 1.5 s");
  }
  if (silence < std::max(hooks_.stop_after, longest_unreported)) return;
  heard_ = now;
  if (!stops_.is_owed()) halt("the gimbal was silent while the camera could move");
  gimbal_.client().check();
}

}  // namespace sbgc::tools
