/// Drives a task on the calling thread, or in an Asio program: starts its calls and passes it their
/// results.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/link.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/io/internal/timer.hpp>

namespace sbgc::detail {

/// Runs the task on the thread of run(); a derived class can do it without waiting. Everything but
/// put() belongs to one thread or strand. The handlers of calls keep the driver alive.
class TaskDriver : public std::enable_shared_from_this<TaskDriver> {
 public:
  using Input = std::function<void(TaskMachine&)>;

  /// The task must live until the driver has returned TaskStep::Kind::done, or has ended.
  TaskDriver(Conversation conversation, TaskMachine& task);
  TaskDriver(const TaskDriver&) = delete;
  TaskDriver& operator=(const TaskDriver&) = delete;
  virtual ~TaskDriver() = default;

  /// Passes an input to the task before its next step. Thread-safe.
  void put(Input input);
  /// Runs the task to its end, and waits on `clock` meanwhile.
  void run(Clock& clock);

 protected:
  /// Called on any thread when an input has arrived.
  virtual void input_arrived() {}

  void listen();
  /// Runs the task as far as possible; returns a step that waits, or the last one.
  TaskStep advance(const std::function<Instant()>& now);
  /// Cancels the remaining calls of a task that is done, or threw.
  void end();

 private:
  void take_inputs();
  /// Listens for messages that belong to no call, as long as the task wants them.
  void follow_overhearing();
  void begin_call(TaskStep step);
  void begin_stream(TaskStep step);
  void join_order();
  void leave_order();
  void wait(const TaskStep& step, Clock& clock);

  Conversation conversation_;
  TaskMachine& task_;
  Subscription notices_;
  Subscription overhearing_;
  TaskNumber joined_{};  // the number of the task in the order of motion; or 0

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Input> inputs_;
};

/// Drives a task to completion on the calling thread.
void drive(const Conversation& conversation, TaskMachine& task, Clock& clock);

/// Runs the task on a strand of the executor. Lives until the task is done.
class AsioDriver : public TaskDriver {
 public:
  /// `done` owns the task.
  AsioDriver(const asio::any_io_executor& executor, Conversation conversation, TaskMachine& task,
             std::function<void()> done);

  void start();

 private:
  void input_arrived() override;
  void proceed();

  asio::strand<asio::any_io_executor> strand_;
  io::detail::Timer timer_;
  std::function<void()> done_;  // empty once the task is done
};

/// The tasks that an asynchronous client drives. Thread-safe.
class RunningTasks {
 public:
  /// Drives a task to its end; `done` owns it.
  Stop run(const asio::any_io_executor& executor, const Conversation& conversation,
           TaskMachine& task, std::function<void()> done) {
    const auto driver = std::make_shared<AsioDriver>(executor, conversation, task, std::move(done));
    {
      const std::lock_guard lock(mutex_);
      std::erase_if(drivers_, [](const auto& one) { return one.expired(); });
      drivers_.push_back(driver);
    }
    driver->start();
    return [weak = std::weak_ptr(driver)] { cancel(weak); };
  }

  void cancel_all() {
    std::vector<std::weak_ptr<AsioDriver>> drivers;
    {
      const std::lock_guard lock(mutex_);
      drivers.swap(drivers_);
    }
    for (const auto& driver : drivers) cancel(driver);
  }

 private:
  static void cancel(const std::weak_ptr<AsioDriver>& weak) {
    if (const auto driver = weak.lock()) driver->put([](TaskMachine& task) { task.cancel(); });
  }

  std::mutex mutex_;
  std::vector<std::weak_ptr<AsioDriver>> drivers_;
};

}  // namespace sbgc::detail
