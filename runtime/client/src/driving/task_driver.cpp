#include "driving/task_driver.hpp"

#include <memory>
#include <thread>
#include <utility>

#include <asio/post.hpp>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/link.hpp>
#include <sbgc/io/clock.hpp>

#include "conversation/state.hpp"

namespace sbgc::detail {

TaskDriver::TaskDriver(Conversation conversation, TaskMachine& task)
    : conversation_(std::move(conversation)), task_(task) {
  task_.set_repeating_line(conversation_.state()->may_repeat());
  task_.set_number(conversation_.state()->calls()->order().begin());
}

void TaskDriver::put(Input input) {
  {
    const std::lock_guard lock(mutex_);
    inputs_.push_back(std::move(input));
  }
  changed_.notify_all();
  input_arrived();
}

void TaskDriver::listen() {
  notices_ = conversation_.on_notice([weak = weak_from_this()](const Notice& notice) {
    const auto self = weak.lock();
    if (self) self->put([notice](TaskMachine& task) { task.notice(notice); });
  });
}

void TaskDriver::run(Clock& clock) {
  // Also if the task throws.
  const auto end_it = [](TaskDriver* driver) { driver->end(); };
  const std::unique_ptr<TaskDriver, decltype(end_it)> ending(this, end_it);
  listen();
  const auto now = [&clock] { return io::from_chrono(clock.now()); };
  for (TaskStep step = advance(now); step.kind != TaskStep::Kind::done; step = advance(now)) {
    wait(step, clock);
  }
}

TaskStep TaskDriver::advance(const std::function<Instant()>& now) {
  while (true) {
    take_inputs();
    TaskStep step = task_.step(now());
    if (step.kind == TaskStep::Kind::call) {
      begin_call(std::move(step));
    } else if (step.kind == TaskStep::Kind::cancel) {
      conversation_.cancel(step.call);
    } else {
      follow_overhearing();
      return step;
    }
  }
}

void TaskDriver::take_inputs() {
  std::vector<Input> inputs;
  {
    const std::lock_guard lock(mutex_);
    inputs.swap(inputs_);
  }
  for (Input& input : inputs) input(task_);
}

void TaskDriver::follow_overhearing() {
  if (!task_.overhears()) return overhearing_.cancel();
  if (overhearing_) return;
  overhearing_ = conversation_.on_frame([weak = weak_from_this()](const BoardFrame& one) {
    if (one.belongs_to_call) return;
    const auto self = weak.lock();
    if (!self) return;
    self->put([id = one.frame.id, body = std::vector(one.frame.body.begin(), one.frame.body.end())](
                  TaskMachine& task) { task.overheard(id, body); });
  });
}

void TaskDriver::begin_call(TaskStep step) {
  const CallId id = step.call;
  Conversation::State& state = *conversation_.state();
  if (state.runs_in_this_thread()) return task_.replied(id, handler_waits_error());
  if (step.stream_end) return begin_stream(std::move(step));
  if (step.request && step.request->is_motion) join_order();
  step.options.on_confirmation = [self = shared_from_this(), id](unsigned) {
    self->put([id](TaskMachine& task) { task.confirmed(id); });
  };
  step.options.on_series = [self = shared_from_this(), id](const Frame& frame) {
    std::vector<std::uint8_t> body(frame.body.begin(), frame.body.end());
    self->put([id, body = std::move(body)](TaskMachine& task) mutable {
      task.received(id, std::move(body));
    });
  };
  auto replied = [self = shared_from_this(), id](Result<Reply> reply) {
    self->put([id, reply = std::move(reply)](TaskMachine& task) mutable {
      task.replied(id, std::move(reply));
    });
  };
  state.start(id, std::move(step.request), step.options, std::move(replied), task_.number());
}

void TaskDriver::begin_stream(TaskStep step) {
  const CallId id = step.call;
  MessageKey key{.is_raw = true};
  if (step.request) key.id = step.request->policy.stream.command;
  auto take = [weak = weak_from_this(), id](const Frame& frame) {
    const auto self = weak.lock();
    if (!self) return;
    self->put([id, body = std::vector(frame.body.begin(), frame.body.end())](
                  TaskMachine& task) mutable { task.received(id, std::move(body)); });
  };
  auto started = [self = shared_from_this(), id](Result<Subscription> stream) {
    // Shared, because a function must be copyable.
    self->put([id, stream = std::make_shared<Result<Subscription>>(std::move(stream))](
                  TaskMachine& task) {
      if (!*stream) return task.replied(id, stream->error());
      task.keep(id, std::move(**stream));
      task.replied(id, Reply{});
    });
  };
  conversation_.state()->start_stream(id, {std::move(step.request), *std::move(step.stream_end)},
                                      key, typed_handler<Frame>(std::move(take)), step.options,
                                      std::move(started));
}

/// The task must be known before its motion can be superseded.
void TaskDriver::join_order() {
  const TaskNumber number = task_.number();
  if (number == joined_) return;
  leave_order();
  joined_ = number;
  conversation_.state()->calls()->order().join(number, [weak = weak_from_this()](TaskNumber by) {
    const auto self = weak.lock();
    if (self) self->put([by](TaskMachine& task) { task.supersede(by); });
  });
}

void TaskDriver::leave_order() {
  if (joined_ != 0) conversation_.state()->calls()->order().leave(std::exchange(joined_, 0));
}

void TaskDriver::wait(const TaskStep& step, Clock& clock) {
  if (!task_.is_calling() && !step.can_be_woken) {
    return clock.sleep_until(io::to_chrono(step.until));
  }
  // The deadline of any call of the conversation: ending a call of another thread is harmless.
  Conversation::State& state = *conversation_.state();
  const Instant last = state.calls()->deadline();
  {
    std::unique_lock lock(mutex_);
    if (!inputs_.empty()) return;
    if (step.until == Instant::never) {
      changed_.wait_until(lock, io::to_chrono(last));
    } else {
      const Duration left = last == Instant::never ? seconds(3600) : last - io::now();
      const Instant now = io::from_chrono(clock.now());
      clock.wait_until(lock, changed_, io::to_chrono(earlier(step.until, now + left)));
    }
  }
  state.end_overdue(io::now());
}

void TaskDriver::end() {
  leave_order();
  notices_.cancel();
  overhearing_.cancel();
  task_.abandon();
  for (TaskStep left = task_.step({}); left.kind != TaskStep::Kind::done; left = task_.step({})) {
    conversation_.cancel(left.call);
  }
}

void drive(const Conversation& conversation, TaskMachine& task, Clock& clock) {
  std::make_shared<TaskDriver>(conversation, task)->run(clock);
}

AsioDriver::AsioDriver(const asio::any_io_executor& executor, Conversation conversation,
                       TaskMachine& task, std::function<void()> done)
    : TaskDriver(std::move(conversation), task),
      strand_(asio::make_strand(executor)),
      timer_(strand_),
      done_(std::move(done)) {}

void AsioDriver::start() {
  listen();
  input_arrived();
}

void AsioDriver::input_arrived() {
  asio::post(strand_, [this, self = shared_from_this()] { proceed(); });
}

void AsioDriver::proceed() {
  if (!done_) return;
  // If a handler throws, the task is over.
  const auto give_up = [](AsioDriver* driver) {
    driver->timer_.cancel();
    driver->end();
    driver->done_ = nullptr;
  };
  std::unique_ptr<AsioDriver, decltype(give_up)> ending(this, give_up);
  const TaskStep step = advance([this] { return timer_.now(); });
  static_cast<void>(ending.release());
  if (step.kind == TaskStep::Kind::done) {
    timer_.cancel();
    end();
    return std::exchange(done_, nullptr)();
  }
  timer_.start(step.until, [this, self = shared_from_this()] { proceed(); });
}

}  // namespace sbgc::detail

namespace sbgc {
namespace {

class SystemClock final : public Clock {
 public:
  TimePoint now() override { return std::chrono::steady_clock::now(); }
  void sleep_until(TimePoint until) override { std::this_thread::sleep_until(until); }
  void wait_until(std::unique_lock<std::mutex>& lock, std::condition_variable& changed,
                  TimePoint until) override {
    changed.wait_until(lock, until);
  }
};

}  // namespace

Clock& Clock::system() noexcept {
  static SystemClock clock;
  return clock;
}

}  // namespace sbgc
