#include "gateway/gimbal_tasks.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include <asio/bind_cancellation_slot.hpp>
#include <asio/bind_executor.hpp>
#include <asio/post.hpp>

#include <sbgc/client/calibration.hpp>

#include "gateway/parameter_tasks.hpp"
#include "motion/axis_values.hpp"
#include "values/message_json.hpp"

namespace sbgc::tools {

namespace {

/// How often a moving gimbal looks for the broker.
constexpr std::chrono::milliseconds look_interval{100};

/// True if the camera must stop when the broker is gone.
bool is_motion(const Order& order) {
  return std::holds_alternative<MoveOrder>(order.what) ||
         std::holds_alternative<SpeedOrder>(order.what) || order.goes_on.count() != 0;
}

TaskOutcome failed_outcome(const ClientError& error) {
  return {"failed", name(error.code), error.message, {}};
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
    case CalibrationEnd::unconfirmed: return "unconfirmed";
  }
  return "unknown";
}

}  // namespace

GimbalTasks::GimbalTasks(Gimbal& gimbal, Hooks hooks)
    : gimbal_(gimbal), hooks_(std::move(hooks)), timer_(gimbal.executor()) {}

void GimbalTasks::run(Job job) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), job = std::move(job)]() mutable {
    self->add(std::move(job));
  });
}

void GimbalTasks::link_changed(bool is_online) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), is_online] {
    self->is_online_ = is_online;
    if (!is_online) {
      // Nothing that waits moves the camera when the line is back.
      self->end_waiting_motions("link_lost", "the line to the gimbal was lost");
    } else if (self->must_halt_) {
      self->halt("the broker was gone while the gimbal was offline");
    } else if (self->is_moving()) {
      self->watch();
    }
  });
}

void GimbalTasks::shut_down(std::function<void()> done) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), done = std::move(done)] {
    self->is_shut_down_ = true;
    self->timer_.cancel();
    while (!self->waiting_.empty()) {
      const Job job = std::exchange(self->waiting_.front(), {});
      self->waiting_.pop_front();
      job.done({"refused", "closing", "the gateway ends", {}});
    }
    const bool was_moving = self->is_moving();
    // Parameters are not left half written.
    const bool writes =
        self->current_ && std::holds_alternative<SetOrder>(self->current_->order.what);
    if (self->current_ && self->cancel_ && !writes) {
      self->cancel_->emit(asio::cancellation_type::terminal);
    }
    const auto end = [self, done](const TaskOutcome&) {
      self->speed_.reset();
      done();
    };
    was_moving ? self->stop(end) : end({});
  });
}

void GimbalTasks::add(Job job) {
  if (is_shut_down_) return job.done({"refused", "closing", "the gateway ends", {}});
  if (std::holds_alternative<StopOrder>(job.order.what)) {
    end_waiting_motions("superseded", "a later command stops the camera");
    return stop(std::move(job.done));
  }
  constexpr std::size_t most_waiting = 16;
  if (waiting_.size() >= most_waiting) {
    return job.done({"refused", "overload", "too many commands wait for this gimbal", {}});
  }
  waiting_.push_back(std::move(job));
  begin_next();
}

void GimbalTasks::begin_next() {
  while (!current_ && !waiting_.empty()) {
    Job job = std::move(waiting_.front());
    waiting_.pop_front();
    if (job.deadline && std::chrono::system_clock::now() > *job.deadline) {
      job.done({"refused", "expired", "its deadline passed before it could begin", {}});
      continue;
    }
    if (is_motion(job.order) && !hooks_.is_broker_there()) {
      job.done({"refused", "no_broker", "the broker is gone, so nothing would stop it", {}});
      continue;
    }
    current_.emplace(std::move(job));
    if (is_motion(current_->order)) watch();
    begin(current_->order);
  }
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
  if (order.moves && !std::holds_alternative<SpeedOrder>(order.what) && is_turning_) {
    is_turning_ = false;
    static_cast<void>(speed_->stop());
  }
  if (order.goes_on == Order::forever) moves_until_ = Clock::time_point::max();
  if (order.goes_on.count() != 0 && order.goes_on != Order::forever) {
    moves_until_ =
        std::max(moves_until_.value_or(Clock::time_point()), Clock::now() + order.goes_on);
  }
  AsyncReconnectingClient& client = gimbal_.client();
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
  ended.done(std::move(outcome));
  // Not at once: the stack does not grow with what waits.
  asio::post(gimbal_.executor(), [self = shared_from_this()] { self->begin_next(); });
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
  is_turning_ = false;
  if (speed_) static_cast<void>(speed_->stop());
  if (current_ && std::holds_alternative<MoveOrder>(current_->order.what)) {
    cancel_->emit(asio::cancellation_type::terminal);
  }
  gimbal_.client().async_run(
      tasks::stop(),
      asio::bind_executor(gimbal_.executor(), [self = shared_from_this(), done = std::move(done)](
                                                  const Result<void>& stopped) {
        if (stopped) {
          self->moves_until_.reset();
          self->must_halt_ = false;
        }
        done(stopped ? TaskOutcome() : failed_outcome(stopped.error()));
      }));
}

void GimbalTasks::halt(const std::string& reason) {
  if (is_halting_) return;
  is_halting_ = true;
  must_halt_ = true;
  end_waiting_motions("stopped", "the camera was stopped");
  stop([self = shared_from_this(), reason](const TaskOutcome& outcome) {
    self->is_halting_ = false;
    self->hooks_.notify("stopped",
                        outcome.code.empty()
                            ? reason + "; the camera has stopped"
                            : reason + "; the camera may still turn: " + outcome.message);
    if (self->must_halt_) self->watch();  // to try again
  });
}

void GimbalTasks::end_waiting_motions(const char* code, const char* message) {
  std::deque<Job> kept;
  std::deque<Job> ended;
  for (Job& job : waiting_) (job.order.moves ? ended : kept).push_back(std::move(job));
  waiting_ = std::move(kept);
  for (const Job& job : ended) job.done({"refused", code, message, {}});
}

bool GimbalTasks::is_moving() const {
  const bool goes_on = moves_until_ && Clock::now() < *moves_until_;
  return is_turning_ || goes_on || must_halt_ || (current_ && is_motion(current_->order));
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
    hooks_.notify("speed_ended",
                  speed_->state() == SpeedControl::State::silenced
                      ? "the camera was stopped, because no further speed was commanded"
                      : "the speed could not be held");
  }
  if (!is_moving()) return;
  if (!hooks_.is_broker_there()) must_halt_ = true;
  // Offline, link_changed() does it later.
  if (must_halt_ && is_online_) halt("the broker is gone");
  if (is_online_) watch();
}

}  // namespace sbgc::tools
