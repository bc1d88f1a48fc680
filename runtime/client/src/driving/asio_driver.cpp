#include "driving/asio_driver.hpp"

#include <functional>
#include <system_error>
#include <utility>

#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

AsioDriver::AsioDriver(const asio::any_io_executor& executor, Conversation conversation,
                       std::shared_ptr<TaskMachine> task, std::function<void()> done)
    : strand_(asio::make_strand(executor)),
      timer_(strand_),
      conversation_(std::move(conversation)),
      task_(std::move(task)),
      done_(std::move(done)) {}

void AsioDriver::post(Input input) {
  asio::post(strand_, std::bind_front(&AsioDriver::take, shared_from_this(), std::move(input)));
}

void AsioDriver::take(const Input& input) {
  if (!done_) return;
  input(*task_);
  advance();
}

void AsioDriver::start() {
  notices_ = conversation_.on_notice([weak = weak_from_this()](const Notice& notice) {
    const auto self = weak.lock();
    if (self) self->post([notice](TaskMachine& task) { task.notice(notice); });
  });
  post([](TaskMachine&) {});
}

void AsioDriver::cancel() {
  post([](TaskMachine& task) { task.cancel(); });
}

void AsioDriver::advance() {
  while (true) {
    TaskStep step = task_->step(io::now());
    switch (step.kind) {
      case TaskStep::Kind::call: begin_call(std::move(step)); break;
      case TaskStep::Kind::cancel: cancel_call(step.number); break;
      case TaskStep::Kind::wait: return wait(step.until);
      case TaskStep::Kind::done:
        timer_.cancel();
        notices_.cancel();
        std::exchange(done_, nullptr)();
        task_.reset();
        return;
    }
  }
}

void AsioDriver::begin_call(TaskStep step) {
  const std::uint32_t number = step.number;
  step.options.on_confirmation = [self = shared_from_this(), number](unsigned) {
    self->post([number](TaskMachine& task) { task.confirmed(number); });
  };
  calls_[number] = 0;
  calls_[number] =
      conversation_.start(std::move(step.request), step.options,
                          [self = shared_from_this(), number](const Result<Reply>& reply) {
                            self->post([self, number, reply](TaskMachine& task) {
                              self->calls_.erase(number);
                              task.replied(number, reply);
                            });
                          });
}

void AsioDriver::cancel_call(std::uint32_t number) {
  const auto call = calls_.find(number);
  if (call == calls_.end()) return;
  conversation_.cancel(call->second);
  calls_.erase(call);
}

void AsioDriver::wait(Instant until) {
  if (until == Instant::never) {
    timer_.cancel();
    return;
  }
  timer_.expires_at(io::to_chrono(until));
  timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
    if (!error && self->done_) self->advance();
  });
}

}  // namespace sbgc::detail
