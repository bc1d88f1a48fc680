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

#include <chrono>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/initiate.hpp>
#include <sbgc/client/link.hpp>
#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/stream_requests.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// A connection to a board on an execution context, which must outlive the client and must run for
/// operations to make progress.
///
/// Each operation calls its completion handler, `void(Result<T>)`, exactly once, through the
/// handler's associated executor (by default the one passed to the constructor), and never from
/// inside the initiating function. Every asio::cancellation_type ends an operation with
/// ErrorCode::cancelled. The errors are those of Client.
///
/// Functions may be called from any thread, also concurrently. Subscription handlers run one at a
/// time, on the executor. Connected with ReconnectOptions, the client restores its connection as
/// Client does; `context.run()` does not return while it is connected or searching: call close().
///
/// Destroying the client ends all operations with ErrorCode::cancelled or, if they wait for a
/// connection, with ErrorCode::not_connected; it waits for a pending open (resolving a host name,
/// connecting over TCP) on a thread of the client.
///
/// g++ 12 mishandles a co_await expression with a temporary aggregate or lambda: it copies the
/// bytes of such an object, and destroys both. That does no harm to options of numbers, as in
/// `{.speed = 10_deg_per_s}`, but handlers, names of files and lambdas that own something are freed
/// twice. Put them into variables, or start the operation in a statement of its own:
///
///     auto move = client.async_run(tasks::move_to(target, {.progress = show}),
///                                  asio::use_awaitable);
///     auto moved = co_await std::move(move);
class AsyncClient {
 public:
  /// Makes a client without a connection, whose handlers run on `executor`: see async_connect().
  explicit AsyncClient(const asio::any_io_executor& executor);
  AsyncClient(AsyncClient&&) noexcept = default;
  AsyncClient& operator=(AsyncClient&&) noexcept = default;
  AsyncClient(const AsyncClient&) = delete;
  AsyncClient& operator=(const AsyncClient&) = delete;
  ~AsyncClient() = default;

  /// The executor that was passed to the constructor.
  asio::any_io_executor executor() const { return executor_; }

  /// Like Client::connect(). Handler: void(Result<void>). Other operations fail with
  /// ErrorCode::not_connected until it has succeeded, and again after another attempt has started.
  /// Errors: those of Client::connect(), and `cancelled`.
  template <class Token>
  auto async_connect(const std::string& address, const ConnectOptions& options, Token&& token) {
    return begin_connect(address, TransportFactory(), options, token);
  }
  /// The same, but reconnects whenever the connection breaks. The first connection must succeed.
  /// Subscriptions and streams of an earlier connect end; new ones can begin at once. Errors: the
  /// same.
  template <std::same_as<ReconnectOptions> Options, class Token>
  auto async_connect(const std::string& address, const Options& options, Token&& token) {
    return begin_connect(address, TransportFactory(), options, token);
  }
  template <class Token>
  auto async_connect(const std::string& address, Token&& token) {
    return async_connect(address, ConnectOptions(), std::forward<Token>(token));
  }
  /// Like connect_over(). Errors: those of Client::connect(), and `cancelled`.
  template <class Token>
  auto async_connect_over(const TransportFactory& make, const ConnectOptions& options,
                          Token&& token) {
    return begin_connect(std::string(), make, options, token);
  }
  template <std::same_as<ReconnectOptions> Options, class Token>
  auto async_connect_over(const TransportFactory& make, const Options& options, Token&& token) {
    return begin_connect(std::string(), make, options, token);
  }
  template <class Token>
  auto async_connect_over(const TransportFactory& make, Token&& token) {
    return async_connect_over(make, ConnectOptions(), std::forward<Token>(token));
  }

  /// Like Client::call(). Handler: void(CallResult<M>). Errors: those of Client::call().
  template <Callable M, class Token>
  auto async_call(const M& request, const CallOptions& options, Token&& token) {
    return operate<CallResult<M>>(
        token, [prepare = preparer(request, options), options](
                   detail::Link& link, const detail::Completion<CallResult<M>>& done) {
          return link.start(prepare, options, [done](const Result<Reply>& reply) {
            done(detail::read_response<M>(reply));
          });
        });
  }
  template <Callable M, class Token>
  auto async_call(const M& request, Token&& token) {
    return async_call(request, CallOptions(), std::forward<Token>(token));
  }

  /// Like Client::transact(). Handler: void(Result<Reply>). Errors: those of Client::transact().
  template <Callable M, class Token>
  auto async_transact(const M& request, const CallOptions& options, Token&& token) {
    return operate<Result<Reply>>(
        token, [prepare = preparer(request, options), options](
                   detail::Link& link, const detail::Completion<Result<Reply>>& done) {
          return link.start(prepare, options, done);
        });
  }
  template <Callable M, class Token>
  auto async_transact(const M& request, Token&& token) {
    return async_transact(request, CallOptions(), std::forward<Token>(token));
  }

  /// Like Client::stream(). Handler: void(Result<Subscription>). Errors: those of Client::stream().
  template <Message M, class Token, class Request = roles::StreamRequest>
  auto async_stream(std::chrono::milliseconds interval, std::function<void(const M&)> handler,
                    const CallOptions& options, Token&& token) {
    return start_stream(detail::stream_of<M>(detail::stream_request<Request>(interval),
                                             std::move(handler), options),
                        options, token);
  }
  template <Message M, class Token, Message Request = roles::StreamRequest>
  auto async_stream(Request request, std::function<void(const M&)> handler,
                    const CallOptions& options, Token&& token) {
    return start_stream(
        detail::stream_of<M>(Result<Request>(std::move(request)), std::move(handler), options),
        options, token);
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

  /// The same for a message whose type is known only at run time. Errors: those of
  /// Client::stream().
  template <class Token>
  auto async_stream(const MessageType& type, const roles::StreamRequest& request,
                    std::function<void(const AnyMessage&)> handler, const CallOptions& options,
                    Token&& token) {
    return start_stream(
        detail::stream_of(type, request, detail::any_handler(type, std::move(handler)), options),
        options, token);
  }

  /// Like Client::stream_raw(). Handler: void(Result<Subscription>). Errors: those of
  /// Client::stream().
  template <class Token>
  auto async_stream_raw(const roles::StreamRequest& request,
                        std::function<void(const Frame&)> handler, const CallOptions& options,
                        Token&& token) {
    return start_stream(detail::raw_stream_of(request, std::move(handler), options), options,
                        token);
  }
  template <class Token>
  auto async_stream_raw(const roles::StreamRequest& request,
                        std::function<void(const Frame&)> handler, Token&& token) {
    return async_stream_raw(request, std::move(handler), CallOptions(), std::forward<Token>(token));
  }

  /// Like Client::run(): drives any of sbgc::tasks, or a task of your own, for example
  /// `client.async_run(tasks::move_to(target), token)`. Handler: void(R). Cancellation calls
  /// TaskMachine::cancel(). Errors: those of the task, and `not_connected` if it cannot begin.
  template <class R, class Token>
  auto async_run(Task<R> task, Token&& token) {
    return operate<R>(token, [shared = std::make_shared<Task<R>>(std::move(task))](
                                 detail::Link& link, const detail::Completion<R>& done) {
      return link.start_task(
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
    return subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  /// Like Client::on_notice(). Returns an empty subscription before a connection.
  Subscription on_notice(std::function<void(const Notice&)> handler);
  /// Calls `handler` with each change of the state of the connection, on the executor. Returns an
  /// empty subscription before async_connect().
  Subscription on_change(std::function<void(const LinkChange&)> handler);
  /// Like Client::check().
  void check();

  /// `closed` before a connection.
  LinkState state() const;
  /// True if state() is LinkState::connected.
  bool is_connected() const { return state() == LinkState::connected; }
  /// Returns the number of connections that have been made.
  std::uint64_t connections() const;
  /// Empty before a connection.
  BoardIdentity identity() const;
  /// Describes the current or the last line; empty before a connection.
  std::string description() const;
  /// Returns the counters of the current or the last connection; zeros before one.
  ClientStatistics statistics() const;
  /// Ends every operation with ErrorCode::cancelled and closes the line.
  void close() noexcept;

 private:
  class Links;
  friend class SpeedControl;

  template <Callable M>
  static auto preparer(const M& request, const CallOptions& options) {
    return [request, options](const detail::Conversation& board) {
      return board.prepare(request, options);
    };
  }

  /// Starts an operation with `start(link, completion)`, which returns its Stop.
  template <class R, class Token, class Start>
  auto operate(Token& token, Start&& start) {
    return detail::initiate<R>(
        executor_, token,
        [&links = *links_, start = std::forward<Start>(start)](const detail::Completion<R>& done) {
          if (const auto link = current(links)) return start(*link, done);
          done(ClientError{ErrorCode::not_connected, "the client is not connected"});
          return detail::Stop{};
        });
  }
  template <class Token>
  auto start_stream(detail::Link::Stream stream, const CallOptions& options, Token& token) {
    using Started = Result<Subscription>;
    return operate<Started>(
        token, [stream = std::move(stream), options](detail::Link& link,
                                                     const detail::Completion<Started>& done) {
          return link.start_stream(stream, options, done);
        });
  }
  template <class Options, class Token>
  auto begin_connect(const std::string& address, const TransportFactory& make,
                     const Options& options, Token& token) {
    return detail::initiate<Result<void>>(executor_, token,
                                          [weak = std::weak_ptr(links_), address, make,
                                           options](const detail::Completion<Result<void>>& done) {
                                            return connect(weak.lock(), address, make, options,
                                                           done);
                                          });
  }
  static detail::Stop connect(const std::shared_ptr<Links>& links, const std::string& address,
                              const TransportFactory& make, const ConnectOptions& options,
                              const detail::Completion<Result<void>>& done);
  static detail::Stop connect(const std::shared_ptr<Links>& links, const std::string& address,
                              const TransportFactory& make, const ReconnectOptions& options,
                              const detail::Completion<Result<void>>& done);
  Subscription subscribe(detail::MessageKey key, detail::Link::MessageHandler handler);
  /// Null before a connection.
  static std::shared_ptr<detail::Link> current(const Links& links);

  asio::any_io_executor executor_;
  std::shared_ptr<Links> links_;
};

}  // namespace sbgc
