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

#include <sbgc/client/async_client.hpp>

#include "operation.hpp"

namespace sbgc::python {

/// Raises the exception for an error of the client.
[[noreturn]] void raise_client(const ClientError& error);

inline py::object to_python(const Result<void>& result) {
  if (!result) raise_client(result.error());
  return py::none();
}

/// Python owns it, and destroys it on any of its threads. In a forked child it has no thread:
/// there, it rejects all calls, and leaks its memory.
class Link : public std::enable_shared_from_this<Link> {
 public:
  Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link();

  /// Connects to the address, or, with a factory, over its transports.
  std::shared_ptr<Operation> connect(const std::string& address, const TransportFactory& make,
                                     const ConnectOptions& options, bool reconnects);

  /// Returns a new operation; raises if there is no board.
  std::shared_ptr<Operation> make_operation();
  /// Makes close() cancel the operation.
  void add(const std::shared_ptr<Operation>& operation);
  /// Receives the result of an operation of the client, and allows canceling it.
  template <class R>
  using Token = asio::cancellation_slot_binder<std::function<void(R)>, asio::cancellation_slot>;
  /// Makes Operation::begin() start an operation of the client, `start(client, token)`, whose end
  /// ends this one with `convert(result)`. `convert` is called on the client's thread, and returns
  /// a function that makes the result for Python.
  template <class R, class Start, class Convert>
  void prepare(Operation& operation, Start start, Convert convert) {
    operation.set_begin([link = shared_from_this(), start = std::move(start),
                         convert = std::move(convert)](const std::shared_ptr<Operation>& one) {
      AsyncClient& client = link->client();
      const auto signal = std::make_shared<asio::cancellation_signal>();
      one->set_cancel([signal] { signal->emit(asio::cancellation_type::terminal); });
      link->add(one);
      start(client, Token<R>(signal->slot(),
                             [one, convert](R result) { one->end(convert(std::move(result))); }));
    });
  }
  /// The same with a task; `convert(result)` makes its result for Python.
  template <class R, class Convert>
  void prepare_task(Operation& operation, Task<R> task, Convert convert) {
    prepare<R>(
        operation,
        [shared = std::make_shared<Task<R>>(std::move(task))](AsyncClient& client, auto token) {
          client.async_run(std::move(*shared), std::move(token));
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

  /// Lets time pass.
  void pause(Duration time) const {
    if (state_->time) {
      state_->time->run([] { return false; }, now() + time);
    } else {
      std::this_thread::sleep_for(std::chrono::microseconds(time.us));
    }
  }

  bool is_forked() const noexcept { return process_.is_forked(); }
  void require_this_process() const { process_.require("the client"); }
  /// Raises if it is not connected or is closed.
  AsyncClient& client() const;
  bool is_connected() const;
  /// Cancels all operations, which stops a moving camera; close() then closes the line.
  void begin_close();
  /// True when everything that begin_close() has cancelled is over.
  bool is_still() const;
  /// Does both, and waits in between, until this time at the latest.
  void close(Instant until);
  /// The changes of the connection since the last call, with retries: a name and a sentence.
  using Events = std::vector<std::pair<std::string, std::string>>;
  Events take_events();
  const std::shared_ptr<Bell>& bell() const { return state_->bell; }

 private:
  struct State {
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    VirtualTimePointer time{};
    std::shared_ptr<Bell> bell = std::make_shared<Bell>();
    std::mutex mutex{};
    std::vector<std::weak_ptr<Operation>> running{};
    Events events{};
    std::atomic<bool> is_connected = false;  // until close()
    std::atomic<bool> is_closed = false;
    std::unique_ptr<AsyncClient> client{};
    Subscription changes{};  // of its state
    Subscription notices{};
    std::thread thread{};

    void happened(const char* name, const std::string& sentence) {
      {
        const std::scoped_lock lock(mutex);
        if (events.size() < 256) events.emplace_back(name, sentence);
      }
      bell->ring();
    }
    asio::any_io_executor executor() {
      if (time) return time->executor();
      return context.get_executor();
    }
  };

  Process process_{};
  std::unique_ptr<State> state_;
  std::uint64_t retries_ = 0;  // already returned by take_events()
};

}  // namespace sbgc::python
