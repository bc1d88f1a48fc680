/// Drives a task on a waiting thread.
#pragma once

#include <memory>
#include <unordered_map>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/task.hpp>

#include "conversation/state.hpp"
#include "driving/task_inbox.hpp"

namespace sbgc::detail {

class BlockingDriver {
 public:
  BlockingDriver(Conversation conversation, Clock& clock);
  BlockingDriver(const BlockingDriver&) = delete;
  BlockingDriver& operator=(const BlockingDriver&) = delete;
  /// Cancels the remaining calls of a task that threw.
  ~BlockingDriver();

  /// Returns when the task is done. Must be called only once.
  void run(TaskMachine& task);
  /// See TaskMachine::wake(). Thread-safe.
  void wake() {
    inbox_->put([](TaskMachine& task) { task.wake(); });
  }

 private:
  void begin_call(TaskMachine& task, TaskStep step);
  void cancel_call(std::uint32_t number);
  void wait(const TaskStep& step);
  void end_overdue_calls();

  Conversation conversation_;
  Clock& clock_;
  std::shared_ptr<TaskInbox> inbox_ = std::make_shared<TaskInbox>();
  Subscription notices_;
  std::unordered_map<std::uint32_t, Conversation::State::StartedCall> calls_{};  // running
};

}  // namespace sbgc::detail
