/// Drives a task from a thread that waits.
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
  /// Cancels what a task that has thrown leaves behind.
  ~BlockingDriver();

  /// Returns when the task is over. Once.
  void run(TaskMachine& task);
  /// See TaskMachine::wake(). From any thread.
  void wake() {
    inbox_->put([](TaskMachine& task) { task.wake(); });
  }

 private:
  void begin_call(TaskMachine& task, TaskStep step);
  void cancel_call(std::uint32_t number);
  void wait(const TaskStep& step);
  void end_stuck_calls();

  Conversation conversation_;
  Clock& clock_;
  std::shared_ptr<TaskInbox> inbox_ = std::make_shared<TaskInbox>();
  Subscription notices_;
  std::unordered_map<std::uint32_t, Conversation::State::Begun> calls_{};  // under way
};

}  // namespace sbgc::detail
