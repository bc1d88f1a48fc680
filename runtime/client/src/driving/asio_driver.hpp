/// Drives a task in an Asio program, without a thread.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include <asio/any_io_executor.hpp>
#include <asio/steady_timer.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/conversation.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::detail {

/// Lives until the task is done. start() and cancel() may be called from any thread; the task runs
/// on a strand of the executor.
class AsioDriver : public std::enable_shared_from_this<AsioDriver> {
 public:
  AsioDriver(const asio::any_io_executor& executor, Conversation conversation,
             std::shared_ptr<TaskMachine> task, std::function<void()> done);

  void start();
  /// See TaskMachine::cancel().
  void cancel();

 private:
  using Input = std::function<void(TaskMachine&)>;

  /// Takes an input on the strand.
  void post(Input input);
  /// Passes the task to `input`, then advances it.
  void take(const Input& input);
  void advance();
  void begin_call(TaskStep step);
  void cancel_call(std::uint32_t number);
  void wait(Instant until);

  asio::strand<asio::any_io_executor> strand_;
  asio::steady_timer timer_;
  Conversation conversation_;
  std::shared_ptr<TaskMachine> task_;
  std::function<void()> done_;  // empty once the task is done
  Subscription notices_;
  std::unordered_map<std::uint32_t, Conversation::Ticket> calls_{};  // running
};

}  // namespace sbgc::detail
