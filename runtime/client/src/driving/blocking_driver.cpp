#include "driving/blocking_driver.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

BlockingDriver::BlockingDriver(Conversation conversation, Clock& clock)
    : conversation_(std::move(conversation)),
      clock_(clock),
      notices_(conversation_.on_notice([inbox = inbox_](const Notice& notice) {
        inbox->put([notice](TaskMachine& task) { task.notice(notice); });
      })) {}

BlockingDriver::~BlockingDriver() {
  for (const auto& [number, begun] : calls_) conversation_.cancel(begun.ticket);
}

void BlockingDriver::run(TaskMachine& task) {
  while (true) {
    inbox_->empty_into(task);
    TaskStep step = task.step(io::from_chrono(clock_.now()));
    switch (step.kind) {
      case TaskStep::Kind::call: begin_call(task, std::move(step)); break;
      case TaskStep::Kind::cancel: cancel_call(step.number); break;
      case TaskStep::Kind::wait: wait(step); break;
      case TaskStep::Kind::done: return;
    }
  }
}

void BlockingDriver::begin_call(TaskMachine& task, TaskStep step) {
  const std::uint32_t number = step.number;
  if (conversation_.state()->runs_in_this_thread()) {
    return task.replied(number, handler_waits_error());
  }
  step.options.on_confirmation = [inbox = inbox_, number](unsigned) {
    inbox->put([number](TaskMachine& machine) { machine.confirmed(number); });
  };
  calls_[number] = {};
  const auto replied = [this, inbox = inbox_, number](const Result<Reply>& reply) {
    inbox->put([this, number, reply](TaskMachine& machine) {
      calls_.erase(number);  // runs on the driver's thread, which empties the inbox
      machine.replied(number, reply);
    });
  };
  calls_[number] = conversation_.state()->start(std::move(step.request), step.options, replied);
}

void BlockingDriver::cancel_call(std::uint32_t number) {
  const auto call = calls_.find(number);
  if (call == calls_.end()) return;
  conversation_.cancel(call->second.ticket);
  calls_.erase(call);
}

void BlockingDriver::wait(const TaskStep& step) {
  if (calls_.empty() && !step.can_be_woken) return clock_.sleep_until(io::to_chrono(step.until));
  Instant last = Instant::never;
  for (const auto& [number, begun] : calls_) last = earlier(last, begun.deadline);
  inbox_->wait([&](auto& lock, auto& changed) {
    if (step.until == Instant::never) {
      changed.wait_until(lock, io::to_chrono(last));
    } else {
      const Duration left = last == Instant::never ? seconds(3600) : last - io::now();
      const Instant now = io::from_chrono(clock_.now());
      clock_.wait_until(lock, changed, io::to_chrono(earlier(step.until, now + left)));
    }
  });
  end_overdue_calls();
}

void BlockingDriver::end_overdue_calls() {
  for (const auto& [number, begun] : calls_) {
    if (begun.deadline <= io::now()) conversation_.state()->end_overdue(begun.ticket);
  }
}

void drive(const Conversation& conversation, TaskMachine& task, Clock& clock) {
  BlockingDriver(conversation, clock).run(task);
}

}  // namespace sbgc::detail
