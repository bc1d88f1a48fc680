/// A connected board, and the thread that serves its line.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <sys/types.h>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/task.hpp>

#include "connect.hpp"
#include "driving/asio_driver.hpp"
#include "operation.hpp"
#include "reconnecting/reconnection.hpp"

namespace sbgc::python {

/// Raises the exception for an error of the client.
[[noreturn]] void raise_client(const ClientError& error);

inline py::object to_python(const Result<void>& result) {
  if (!result) raise_client(result.error());
  return py::none();
}

using Reconnecting = detail::Reconnection;

/// Python owns it, and destroys it on any of its threads. In a forked child it has no thread: it
/// refuses everything there, and leaves its memory alone.
class Link : public std::enable_shared_from_this<Link> {
 public:
  Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link();

  /// Connects to the address, or, with a factory, over its transports.
  std::shared_ptr<Operation> connect(const std::string& address, const TransportFactory& make,
                                     const ConnectOptions& options, bool reconnects);

  /// Runs a task; `convert(result)` makes its result for Python.
  template <class R, class Convert>
  std::shared_ptr<Operation> run(Task<R> task, Convert convert) {
    const auto operation = begin();
    return run(operation, std::move(task), std::move(convert));
  }
  /// The same for an operation that the task already knows.
  template <class R, class Convert>
  std::shared_ptr<Operation> run(const std::shared_ptr<Operation>& operation, Task<R> task,
                                 Convert convert) {
    const auto shared = std::make_shared<Task<R>>(std::move(task));
    drive(operation, shared->begin(conversation().identity()), [operation, shared, convert] {
      const auto result = std::make_shared<R>(std::move(*shared).result());
      operation->end([result, convert] { return convert(*result); });
    });
    return operation;
  }
  /// Returns a new operation; raises if there is no board.
  std::shared_ptr<Operation> begin();
  /// Drives a task until `done` is called; returns what wakes it.
  std::function<void()> drive(const std::shared_ptr<Operation>& operation, TaskMachine& task,
                              std::function<void()> done);
  /// Ends an operation with the result of `work`, which can block, on a thread of its own.
  void block(const std::shared_ptr<Operation>& operation, std::function<Operation::Result()> work);

  /// Runs in virtual time; precedes connect().
  void use(VirtualTimePointer time) { state_->time = std::move(time); }
  const VirtualTimePointer& time() const { return state_->time; }
  Instant now() const { return state_->time ? state_->time->now() : io::now(); }

  /// With the board that is connected now; raises if there is none.
  detail::Conversation conversation() const;
  /// Null unless the client reconnects. Raises if it is closed, as all below.
  std::shared_ptr<Reconnecting> reconnecting() const;
  bool is_connected() const;
  /// Of the current or the last connection.
  BoardIdentity identity() const;
  std::string description() const;
  /// Cancels what runs, which stops a moving camera, and closes the line.
  void close();
  const std::shared_ptr<Bell>& bell() const { return state_->bell; }

 private:
  struct State {
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    VirtualTimePointer time{};
    std::shared_ptr<Bell> bell = std::make_shared<Bell>();
    std::mutex mutex{};
    detail::Conversation conversation{};  // also of an attempt to connect
    std::shared_ptr<Reconnecting> reconnecting{};
    Subscription changes{};                           // of its state
    std::vector<std::weak_ptr<Operation>> running{};  // the tasks
    bool is_connected = false;                        // until close()
    bool is_closed = false;
    std::vector<std::future<void>> blocked{};
    std::thread thread{};

    asio::any_io_executor executor() {
      if (time) return time->executor();
      return context.get_executor();
    }
  };

  void add(const std::shared_ptr<Operation>& operation);

  pid_t process_;
  std::unique_ptr<State> state_;
};

}  // namespace sbgc::python
