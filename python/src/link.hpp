/// A client, and the thread that serves its line.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/bind_cancellation_slot.hpp>
#include <asio/cancellation_signal.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <sys/types.h>

#include <sbgc/client/async_client.hpp>

#include "operation.hpp"

namespace sbgc::python {

/// Raises the exception for an error of the client.
[[noreturn]] void raise_client(const ClientError& error);

inline py::object to_python(const Result<void>& result) {
  if (!result) raise_client(result.error());
  return py::none();
}

/// Python owns it, and destroys it on any of its threads. In a forked child it has no thread: it
/// refuses everything there, and leaves its memory alone.
class Link {
 public:
  Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link();

  /// Connects to the address, or, with a factory, over its transports.
  std::shared_ptr<Operation> connect(const std::string& address, const TransportFactory& make,
                                     const ConnectOptions& options, bool reconnects);

  /// Returns a new operation; raises if there is no board.
  std::shared_ptr<Operation> begin();
  /// close() cancels the operation and waits for its end.
  void add(const std::shared_ptr<Operation>& operation);
  /// Takes the result of an operation of the client, and lets it be cancelled.
  template <class R>
  using Token = asio::cancellation_slot_binder<std::function<void(R)>, asio::cancellation_slot>;
  /// Starts an operation of the client, `start(client, token)`, whose end ends this one with
  /// `convert(result)`. `convert` is called on the client's thread, and makes what makes the result
  /// for Python.
  template <class R, class Start, class Convert>
  void start(const std::shared_ptr<Operation>& operation, const Start& start, Convert convert) {
    const auto signal = std::make_shared<asio::cancellation_signal>();
    operation->set_cancel([signal] { signal->emit(asio::cancellation_type::terminal); });
    add(operation);
    start(client(), Token<R>(signal->slot(), [operation, convert = std::move(convert)](R result) {
            operation->end(convert(std::move(result)));
          }));
  }
  /// Runs a task; `convert(result)` makes its result for Python.
  template <class R, class Convert>
  void run(const std::shared_ptr<Operation>& operation, Task<R> task, Convert convert) {
    start<R>(
        operation,
        [&](AsyncClient& client, auto token) {
          client.async_run(std::move(task), std::move(token));
        },
        [convert](R result) -> Operation::Result {
          return [result = std::make_shared<R>(std::move(result)), convert] {
            return convert(*result);
          };
        });
  }

  /// Runs in virtual time; precedes connect().
  void use(VirtualTimePointer time) { state_->time = std::move(time); }
  const VirtualTimePointer& time() const { return state_->time; }
  Instant now() const { return state_->time ? state_->time->now() : io::now(); }

  bool is_forked() const noexcept;
  /// Raises if it is not connected or closed.
  AsyncClient& client() const;
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
    std::vector<std::weak_ptr<Operation>> running{};
    std::atomic<bool> is_connected = false;  // until close()
    bool is_closed = false;
    std::unique_ptr<AsyncClient> client{};
    Subscription changes{};  // of its state
    std::thread thread{};

    asio::any_io_executor executor() {
      if (time) return time->executor();
      return context.get_executor();
    }
  };

  pid_t process_;
  std::unique_ptr<State> state_;
};

}  // namespace sbgc::python
