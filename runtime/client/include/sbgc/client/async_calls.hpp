/// The operations that both asynchronous clients have.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <sbgc/client/async_operations.hpp>
#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/stream_requests.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// The operations of AsyncClient and AsyncReconnectingClient.
///
/// Each calls its completion handler, `void(Result<T>)`, exactly once, through the handler's
/// associated executor (by default the one passed to the constructor), and never from inside the
/// initiating function. Every asio::cancellation_type ends an operation with ErrorCode::cancelled.
/// The errors are those of Client.
///
/// Functions may be called from any thread, also concurrently. Subscription handlers run one at a
/// time, on the executor.
///
/// g++ 12 mishandles a co_await expression with a temporary aggregate or lambda: it copies the
/// bytes of such an object, and destroys both. That does no harm to options of numbers, as in
/// `{.speed = 10_deg_per_s}`, but handlers, names of files and lambdas that own something are freed
/// twice. Put them into variables, or start the operation in a statement of its own:
///
///     auto move = client.async_run(tasks::move_to(target, {.progress = show}),
///                                  asio::use_awaitable);
///     auto moved = co_await std::move(move);
class AsyncCalls {
 public:
  AsyncCalls(AsyncCalls&&) noexcept = default;
  AsyncCalls& operator=(AsyncCalls&&) noexcept = default;
  AsyncCalls(const AsyncCalls&) = delete;
  AsyncCalls& operator=(const AsyncCalls&) = delete;

  asio::any_io_executor executor() const { return operations_->executor(); }

  /// Like Client::call(). Handler: void(CallResult<M>).
  template <Callable M, class Token>
  auto async_call(const M& request, const CallOptions& options, Token&& token) {
    return initiate<CallResult<M>>(
        token, [operations = operations_.get(), prepare = preparer(request, options),
                options](Completion<CallResult<M>> done) {
          return operations->call(prepare, options,
                                  [done = std::move(done)](const Result<Reply>& reply) {
                                    done(detail::read_response<M>(reply));
                                  });
        });
  }
  template <Callable M, class Token>
  auto async_call(const M& request, Token&& token) {
    return async_call(request, CallOptions(), std::forward<Token>(token));
  }

  /// Like Client::transact(). Handler: void(Result<Reply>).
  template <Callable M, class Token>
  auto async_transact(const M& request, const CallOptions& options, Token&& token) {
    return initiate<Result<Reply>>(
        token, [operations = operations_.get(), prepare = preparer(request, options),
                options](const Completion<Result<Reply>>& done) {
          return operations->call(prepare, options, done);
        });
  }
  template <Callable M, class Token>
  auto async_transact(const M& request, Token&& token) {
    return async_transact(request, CallOptions(), std::forward<Token>(token));
  }

  /// Like Client::stream(). Handler: void(Result<Subscription>).
  template <Message M, class Token, class Request = roles::StreamRequest>
  auto async_stream(std::chrono::milliseconds interval, std::function<void(const M&)> handler,
                    const CallOptions& options, Token&& token) {
    return register_typed<M>(detail::stream_request<Request>(interval), std::move(handler), options,
                             token);
  }
  template <Message M, class Token, Message Request = roles::StreamRequest>
  auto async_stream(Request request, std::function<void(const M&)> handler,
                    const CallOptions& options, Token&& token) {
    return register_typed<M>(Result<Request>(std::move(request)), std::move(handler), options,
                             token);
  }
  template <Message M, class Token, class Request = roles::StreamRequest>
  auto async_stream(std::chrono::milliseconds interval, std::function<void(const M&)> handler,
                    Token&& token) {
    return async_stream<M>(interval, std::move(handler), CallOptions(), std::forward<Token>(token));
  }
  template <Message M, class Token, Message Request = roles::StreamRequest>
  auto async_stream(Request request, std::function<void(const M&)> handler, Token&& token) {
    return async_stream<M>(std::move(request), std::move(handler), CallOptions(),
                           std::forward<Token>(token));
  }

  /// Like Client::stream_raw(). Handler: void(Result<Subscription>).
  template <class Token, class Request = roles::StreamRequest>
  auto async_stream_raw(std::type_identity_t<Request> request,
                        std::function<void(const Frame&)> handler, const CallOptions& options,
                        Token&& token) {
    const auto prepare = [request, options](const detail::Conversation& conversation) {
      return detail::stream_requests(conversation, request, options);
    };
    return register_stream(prepare, detail::raw_key(request),
                           detail::typed_handler<Frame>(std::move(handler)),
                           detail::stream_interval(request), options, token);
  }
  template <class Token, class Request = roles::StreamRequest>
  auto async_stream_raw(std::type_identity_t<Request> request,
                        std::function<void(const Frame&)> handler, Token&& token) {
    return async_stream_raw<Token, Request>(std::move(request), std::move(handler), CallOptions(),
                                            std::forward<Token>(token));
  }

  /// Like Client::run(): drives any of sbgc::tasks, or a task of your own, for example
  /// `client.async_run(tasks::move_to(target), token)`. Handler: void(R). Cancellation calls
  /// TaskMachine::cancel().
  template <class R, class Token>
  auto async_run(Task<R> task, Token&& token) {
    return initiate<R>(
        token, [operations = operations_.get(),
                shared = std::make_shared<Task<R>>(std::move(task))](const Completion<R>& done) {
          return operations->run(
              [shared](const BoardIdentity& board) -> TaskMachine& { return shared->begin(board); },
              [shared, done](const std::optional<ClientError>& refusal) {
                if (refusal) return done(*refusal);
                done(std::move(*shared).result());
              });
        });
  }

  /// Like Client::subscribe(). Returns an empty subscription before a connection.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return operations_->subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  Subscription on_notice(std::function<void(const Notice&)> handler) {
    return operations_->on_notice(std::move(handler));
  }

  bool is_connected() const { return operations_->is_connected(); }
  /// Empty before a connection.
  BoardIdentity identity() const { return operations_->identity(); }
  std::string description() const { return operations_->description(); }
  ClientStatistics statistics() const { return operations_->statistics(); }
  /// Ends every operation with ErrorCode::cancelled and closes the line.
  void close() noexcept { operations_->close(); }

 protected:
  template <class R>
  using Completion = detail::Completion<R>;

  explicit AsyncCalls(std::shared_ptr<detail::AsyncOperations> operations) noexcept
      : operations_(std::move(operations)) {}
  ~AsyncCalls() = default;

  template <class R, class Token, class Begin>
  auto initiate(Token& token, Begin&& begin) {
    return detail::initiate<R>(operations_->executor(), token, std::forward<Begin>(begin));
  }

  detail::AsyncOperations& operations() const noexcept { return *operations_; }

 private:
  template <Callable M>
  static auto preparer(const M& request, const CallOptions& options) {
    return [request, options](const detail::Conversation& conversation) {
      return conversation.prepare(request, options);
    };
  }

  /// Registers the stream of M, or completes with the error of `request`.
  template <Message M, class Request, class Token>
  auto register_typed(Result<Request> request, std::function<void(const M&)> handler,
                      const CallOptions& options, Token& token) {
    const auto interval = request ? detail::stream_interval(*request) : std::chrono::microseconds{};
    const auto prepare = [request = std::move(request),
                          options](const detail::Conversation& conversation) {
      if (!request) return detail::Conversation::StreamRequests{request.error(), request.error()};
      return detail::stream_requests<M>(conversation, *request, options);
    };
    return register_stream(prepare, detail::key_of<M>, detail::typed_handler<M>(std::move(handler)),
                           interval, options, token);
  }
  template <class Prepare, class Token>
  auto register_stream(const Prepare& prepare, detail::MessageKey key,
                       detail::Conversation::MessageHandler handler,
                       std::chrono::microseconds interval, const CallOptions& options,
                       Token& token) {
    return initiate<Result<Subscription>>(
        token, [operations = operations_.get(), prepare, key, handler = std::move(handler),
                interval, options](const Completion<Result<Subscription>>& done) {
          return operations->stream(prepare, key, handler, interval, options, done);
        });
  }

  std::shared_ptr<detail::AsyncOperations> operations_;
};

}  // namespace sbgc
