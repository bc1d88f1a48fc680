/// How asynchronous clients start operations, and what carries them out.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/associated_cancellation_slot.hpp>
#include <asio/associated_executor.hpp>
#include <asio/async_result.hpp>
#include <asio/cancellation_type.hpp>
#include <asio/execution/outstanding_work.hpp>
#include <asio/post.hpp>
#include <asio/prefer.hpp>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::detail {

/// Takes the result of an operation, once, on any thread.
template <class R>
using Completion = std::function<void(R)>;
/// Cancels an operation; may be empty.
using Stop = std::function<void()>;

/// The untyped operations of an asynchronous client. Thread-safe. A completion may run before the
/// function that starts the operation returns.
class AsyncOperations {
 public:
  /// Prepares a request for the board of a conversation.
  using Prepare = std::function<Result<Request>(const Conversation&)>;
  /// The same for a data stream.
  using PrepareStream = std::function<Conversation::StreamRequests(const Conversation&)>;
  /// Starts a task for a board.
  using BeginTask = std::function<TaskMachine&(const BoardIdentity&)>;

  AsyncOperations() = default;
  AsyncOperations(const AsyncOperations&) = delete;
  AsyncOperations& operator=(const AsyncOperations&) = delete;
  virtual ~AsyncOperations() = default;

  virtual const asio::any_io_executor& executor() const noexcept = 0;

  virtual Stop call(const Prepare& prepare, const CallOptions& options,
                    const Completion<Result<Reply>>& done) = 0;
  virtual Stop stream(const PrepareStream& prepare, MessageKey key,
                      Conversation::MessageHandler handler, std::chrono::microseconds interval,
                      const CallOptions& options, const Completion<Result<Subscription>>& done) = 0;
  /// Completes with the error of a task that could not be started.
  virtual Stop run(const BeginTask& begin, const Completion<std::optional<ClientError>>& done) = 0;

  virtual Subscription subscribe(MessageKey key, Conversation::MessageHandler handler) = 0;
  virtual Subscription on_notice(std::function<void(const Notice&)> handler) = 0;

  virtual bool is_connected() const = 0;
  virtual BoardIdentity identity() const = 0;
  virtual std::string description() const = 0;
  virtual ClientStatistics statistics() const = 0;
  virtual void close() noexcept = 0;
};

/// Starts an operation with `begin(completion)`, which returns its Stop; the completion calls the
/// token's handler.
template <class R, class Token, class Begin>
auto initiate(const asio::any_io_executor& executor, Token& token, Begin&& begin) {
  return asio::async_initiate<Token, void(R)>(
      [executor](auto handler, std::decay_t<Begin> start) {
        auto on = asio::prefer(asio::get_associated_executor(handler, executor),
                               asio::execution::outstanding_work_t::tracked);
        // `stop` is set below. Before that, and after the operation has ended, there is nothing
        // to cancel. The operation does not hold `stop`, which may hold the operation.
        const auto is_over = std::make_shared<std::atomic<bool>>(false);
        const auto stop = std::make_shared<Stop>();
        if (auto slot = asio::get_associated_cancellation_slot(handler); slot.is_connected()) {
          slot.assign([stop, is_over](asio::cancellation_type) {
            if (*stop && !*is_over) (*stop)();
          });
        }
        // Handlers may be move-only, but std::function requires a copyable target.
        struct Pending {
          decltype(handler) complete;
          decltype(on) executor;
        };
        const auto pending = std::make_shared<Pending>(Pending{std::move(handler), std::move(on)});
        *stop = start(Completion<R>([pending, is_over](R result) {
          *is_over = true;
          auto last = std::move(pending->executor);
          asio::post(last, [pending, result = std::move(result)]() mutable {
            auto complete = std::move(pending->complete);
            complete(std::move(result));
          });
        }));
      },
      token, std::forward<Begin>(begin));
}

}  // namespace sbgc::detail
