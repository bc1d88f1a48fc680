/// The asynchronous client: talks to a gimbal from an Asio program, with completion tokens.
///
///     sbgc::AsyncClient client(context.get_executor());
///     client.async_connect("/dev/ttyUSB0", [&](sbgc::Result<void> connected) {
///       client.async_call(sbgc::msg::GetAnglesRequest{},
///                         [](sbgc::Result<sbgc::msg::GetAngles> angles) { … });
///
/// or in a coroutine (examples/coroutine.cpp):
///
///     auto connected = co_await client.async_connect("/dev/ttyUSB0", asio::use_awaitable);
///
/// Include the messages you use, such as <sbgc/messages/realtime.hpp>.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
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

#include <sbgc/client/client.hpp>
#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// A connected board, driven by an execution context.
///
/// Each operation calls its completion handler, `void(Result<T>)`, exactly once, through the
/// handler's associated executor (by default the one passed to the constructor), and never from
/// inside the initiating function. Every asio::cancellation_type ends an operation with
/// ErrorCode::cancelled. The errors are those of Client.
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
///
/// Destroying the client ends all operations with ErrorCode::cancelled. The execution context must
/// outlive the client, and must run for operations to make progress.
class AsyncClient {
 public:
  explicit AsyncClient(const asio::any_io_executor& executor);
  AsyncClient(AsyncClient&&) noexcept = default;
  AsyncClient& operator=(AsyncClient&&) noexcept = default;
  AsyncClient(const AsyncClient&) = delete;
  AsyncClient& operator=(const AsyncClient&) = delete;
  /// Waits for a pending open (resolving a host name, connecting over TCP).
  ~AsyncClient() = default;

  asio::any_io_executor executor() const;

  /// Like Client::connect(). Handler: void(Result<void>). Other operations fail with
  /// ErrorCode::not_connected until it has succeeded, and again after another attempt has started.
  template <class Token>
  auto async_connect(const std::string& address, const ConnectOptions& options, Token&& token) {
    return initiate<Result<void>>(
        token, [&impl = *impl_, address, options](const Completion<Result<void>>& done) {
          return begin_connect(impl, address, options, done);
        });
  }
  template <class Token>
  auto async_connect(const std::string& address, Token&& token) {
    return async_connect(address, ConnectOptions(), std::forward<Token>(token));
  }
  /// Like connect_over().
  template <class Token>
  auto async_connect_over(const TransportFactory& make, const ConnectOptions& options,
                          Token&& token) {
    return initiate<Result<void>>(
        token, [&impl = *impl_, make, options](const Completion<Result<void>>& done) {
          return begin_connect(impl, make, options, done);
        });
  }
  template <class Token>
  auto async_connect_over(const TransportFactory& make, Token&& token) {
    return async_connect_over(make, ConnectOptions(), std::forward<Token>(token));
  }

  /// Like Client::call(). Handler: void(CallResult<M>).
  template <Callable M, class Token>
  auto async_call(const M& request, const CallOptions& options, Token&& token) {
    return initiate<CallResult<M>>(
        token, [&impl = *impl_, request, options](Completion<CallResult<M>> done) -> Stop {
          return begin_call(impl, request, options,
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
        token, [&impl = *impl_, request, options](Completion<Result<Reply>> done) -> Stop {
          return begin_call(impl, request, options, std::move(done));
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
    const auto requests = [request, options](const detail::Conversation& conversation) {
      return detail::stream_requests(conversation, request, options);
    };
    return register_stream(requests, detail::raw_key(request),
                           detail::typed_handler<Frame>(std::move(handler)), options, token);
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
    return initiate<R>(token,
                       [&impl = *impl_, shared = std::make_shared<Task<R>>(std::move(task))](
                           const Completion<R>& done) -> Stop {
                         const auto conversation = conversation_of(impl);
                         if (!conversation) return done(conversation.error()), Stop{};
                         return run(impl, *conversation, shared->begin(conversation->identity()),
                                    [shared, done] { done(std::move(*shared).result()); });
                       });
  }

  /// Like Client::subscribe(). Returns an empty subscription if the client is not connected.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return subscribe_to(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  Subscription on_notice(std::function<void(const Notice&)> handler);

  bool is_connected() const;
  /// Empty unless connected.
  BoardIdentity identity() const;
  std::string description() const;
  ClientStatistics statistics() const;
  /// Ends every operation with ErrorCode::cancelled and closes the line.
  void close() noexcept;

 private:
  class Impl;

  template <class R>
  using Completion = std::function<void(R)>;
  /// Cancels an operation; may be empty.
  using Stop = std::function<void()>;

  /// Registers the stream of M, or completes with the error of `request`.
  template <Message M, class Request, class Token>
  auto register_typed(Result<Request> request, std::function<void(const M&)> handler,
                      const CallOptions& options, Token& token) {
    const auto requests = [request = std::move(request),
                           options](const detail::Conversation& conversation) {
      if (!request) return detail::Conversation::StreamRequests{request.error(), request.error()};
      return detail::stream_requests<M>(conversation, *request, options);
    };
    return register_stream(requests, detail::key_of<M>,
                           detail::typed_handler<M>(std::move(handler)), options, token);
  }
  /// Registers the stream that `requests_of(conversation)` start and end.
  template <class Requests, class Token>
  auto register_stream(const Requests& requests_of, detail::MessageKey key,
                       detail::Conversation::MessageHandler handler, const CallOptions& options,
                       Token& token) {
    return initiate<Result<Subscription>>(
        token,
        [&impl = *impl_, requests_of, key, options, handler = std::move(handler)](
            const Completion<Result<Subscription>>& done) mutable -> Stop {
          const auto conversation = conversation_of(impl);
          if (!conversation) return done(conversation.error()), Stop{};
          const CallId id = conversation->start_stream(requests_of(*conversation), key,
                                                       std::move(handler), options, done);
          return [conversation = *conversation, id] { conversation.cancel(id); };
        });
  }

  template <Callable M>
  static Stop begin_call(Impl& impl, const M& request, const CallOptions& options,
                         Completion<Result<Reply>> done) {
    const auto conversation = conversation_of(impl);
    if (!conversation) return done(conversation.error()), Stop{};
    Result<detail::Request> prepared = conversation->prepare(request, options);
    const CallId id = conversation->start(std::move(prepared), options, std::move(done));
    return [conversation = *conversation, id] { conversation.cancel(id); };
  }

  /// Starts an operation with `begin(completion)`; the completion calls the token's handler.
  template <class R, class Token, class Begin>
  auto initiate(Token& token, Begin&& begin) {
    return asio::async_initiate<Token, void(R)>(
        [executor = executor()](auto handler, std::decay_t<Begin> start) {
          auto on = asio::prefer(asio::get_associated_executor(handler, executor),
                                 asio::execution::outstanding_work_t::tracked);
          // `stop` is set below. Before that, and after the operation has ended, there is nothing
          // to cancel.
          struct Canceller {
            Stop stop{};
            std::atomic<bool> is_over{false};
          };
          const auto canceller = std::make_shared<Canceller>();
          if (auto slot = asio::get_associated_cancellation_slot(handler); slot.is_connected()) {
            slot.assign([canceller](asio::cancellation_type) {
              if (canceller->stop && !canceller->is_over) canceller->stop();
            });
          }
          // Handlers may be move-only, but std::function requires a copyable target.
          struct Pending {
            decltype(handler) complete;
            decltype(on) executor;
          };
          const auto pending =
              std::make_shared<Pending>(Pending{std::move(handler), std::move(on)});
          canceller->stop = start([pending, canceller](R result) {
            canceller->is_over = true;
            auto last = std::move(pending->executor);
            asio::post(last, [pending, result = std::move(result)]() mutable {
              auto complete = std::move(pending->complete);
              complete(std::move(result));
            });
          });
        },
        token, std::forward<Begin>(begin));
  }

  static Stop begin_connect(Impl& impl, const std::string& address, const ConnectOptions& options,
                            const Completion<Result<void>>& done);
  static Stop begin_connect(Impl& impl, const TransportFactory& make, const ConnectOptions& options,
                            const Completion<Result<void>>& done);
  static Result<detail::Conversation> conversation_of(const Impl& impl);
  static Stop run(Impl& impl, const detail::Conversation& conversation, TaskMachine& task,
                  std::function<void()> done);
  Subscription subscribe_to(detail::MessageKey key, detail::Conversation::MessageHandler handler);

  std::shared_ptr<Impl> impl_;
};

}  // namespace sbgc
