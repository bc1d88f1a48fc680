/// Drives a task in an Asio program, without a thread.
#pragma once

#include <functional>
#include <memory>

#include <asio/any_io_executor.hpp>
#include <asio/strand.hpp>

#include <sbgc/io/internal/timer.hpp>

#include "driving/task_driver.hpp"

namespace sbgc::detail {

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

}  // namespace sbgc::detail
