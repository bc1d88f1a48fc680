/// A blocking client that connects again by itself when the line is lost.
///
///     auto client = sbgc::ReconnectingClient::connect("/dev/ttyUSB0");
///     if (!client) return fail(client.error().message);
///     auto stream = client->stream<sbgc::msg::RealtimeData4>(20ms, show);
///     auto changes = client->on_change([](const sbgc::LinkChange& change) { … });
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/client/reconnect_options.hpp>

namespace sbgc {

namespace detail {
class Reconnection;
struct ReconnectingMaker;
}  // namespace detail

/// A Client whose connection is restored after the line was lost, the board restarted, or a data
/// stream fell silent because the board lost its power.
///
/// - A USB adapter is found again under another name, by its vendor, product and serial number. One
///   without a serial number is taken only if exactly one such adapter is plugged in.
/// - The board must be the same: see ReconnectOptions::other_board.
/// - Subscriptions and data streams go on as soon as the connection is restored.
/// - A call during an outage fails with ErrorCode::not_connected, or waits: see
///   ReconnectOptions::calls. A call that the outage interrupts fails in any case, because the
///   board may have executed it.
///
/// Every function may be called from any thread, also concurrently. No function throws or waits
/// longer than its timeout. Handlers run one at a time, on threads of the client, and must not wait
/// for it: a call from a handler fails with ErrorCode::invalid.
class ReconnectingClient : public TaskCalls<ReconnectingClient> {
 public:
  /// Like Client::connect(): the first connection must succeed. See also reconnecting_over().
  static Result<ReconnectingClient> connect(const std::string& address,
                                            const ReconnectOptions& options = {});

  ReconnectingClient(ReconnectingClient&&) noexcept;
  ReconnectingClient& operator=(ReconnectingClient&&) noexcept;
  ReconnectingClient(const ReconnectingClient&) = delete;
  ReconnectingClient& operator=(const ReconnectingClient&) = delete;
  /// Closes the line and ends the search; see close().
  ~ReconnectingClient();

  /// Like Client::call().
  template <Callable M>
  CallResult<M> call(const M& request, const CallOptions& options = {}) {
    return detail::read_response<M>(transact(request, options));
  }
  /// Like Client::transact().
  template <Callable M>
  Result<Reply> transact(const M& request, const CallOptions& options = {}) {
    return use(options, [&](Client& client, const CallOptions& left) {
      return client.transact(request, left);
    });
  }
  /// Like Client::start_raw(); never waits for a connection.
  void start_raw(RawRequest request, const CallOptions& options,
                 std::function<void(const Result<Reply>&)> handler);

  /// Like Client::subscribe(), also during an outage.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return keep(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  /// Like Client::on_frame(), also during an outage.
  Subscription on_frame(std::function<void(const BoardFrame&)> handler);
  /// Like Client::on_notice(), also during an outage.
  Subscription on_notice(std::function<void(const Notice&)> handler);
  /// Calls `handler` with each change of the state of the connection.
  Subscription on_change(std::function<void(const LinkChange&)> handler);

  /// Like Client::stream(). A stream that the board refuses when it is started again is reported as
  /// a notice, NoticeKind::stream_ended, and tried again with the next connection.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::chrono::milliseconds interval,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    const auto request = detail::stream_request<Request>(interval);
    if (!request) return request.error();
    return stream<M, Request>(*request, std::move(handler), options);
  }
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::type_identity_t<Request> request,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    return keep_stream(
        [request, options](const detail::Conversation& conversation) {
          return detail::stream_requests<M>(conversation, request, options);
        },
        detail::key_of<M>, detail::typed_handler<M>(std::move(handler)),
        detail::stream_interval(request), options);
  }

  /// Like Client::stream_raw().
  template <class Request = roles::StreamRequest>
  Result<Subscription> stream_raw(const std::type_identity_t<Request>& request,
                                  std::function<void(const Frame&)> handler,
                                  const CallOptions& options = {}) {
    return keep_stream(
        [request, options](const detail::Conversation& conversation) {
          return detail::stream_requests(conversation, request, options);
        },
        detail::raw_key(request), detail::typed_handler<Frame>(std::move(handler)),
        detail::stream_interval(request), options);
  }

  /// Like Client::run(). A task ends with the connection on which it began.
  template <class R>
  R run(Task<R> task, Clock& clock = Clock::system()) {
    const Result<std::shared_ptr<Client>> client = current({});
    if (!client) return client.error();
    return (*client)->run(std::move(task), clock);
  }

  /// Asks the board for a sign of life, in the background. Without one, the connection counts as
  /// lost. For users of start_raw(), whose data streams the client does not know.
  void check();

  LinkState state() const;
  bool is_connected() const { return state() == LinkState::connected; }
  /// How many connections have been made; at least 1.
  std::uint64_t connections() const;
  /// The board of the current or the last connection.
  BoardIdentity identity() const;
  /// Describes the current or the last line.
  std::string description() const;
  /// Of the current or the last connection.
  ClientStatistics statistics() const;

  /// Ends every call with ErrorCode::cancelled, closes the line and stops searching. Later calls
  /// fail with ErrorCode::not_connected.
  void close() noexcept;

 private:
  friend struct detail::ReconnectingMaker;
  friend class SpeedControl;
  using MessageHandler = detail::Conversation::MessageHandler;
  /// Prepares the requests of a data stream for a new connection.
  using PrepareStream =
      std::function<detail::Conversation::StreamRequests(const detail::Conversation&)>;

  explicit ReconnectingClient(std::shared_ptr<detail::Reconnection> reconnection) noexcept;

  /// Returns the client of the current connection, without waiting.
  Result<std::shared_ptr<Client>> connected() const;
  /// The same, if need be after waiting.
  Result<std::shared_ptr<Client>> current(const CallOptions& options) const;
  /// Calls `call` with the connected client and the time that is left.
  Result<Reply> use(const CallOptions& options,
                    const std::function<Result<Reply>(Client&, const CallOptions&)>& call) const;
  Subscription keep(detail::MessageKey key, MessageHandler handler);
  Result<Subscription> keep_stream(PrepareStream prepare, detail::MessageKey key,
                                   MessageHandler handler, std::chrono::microseconds interval,
                                   const CallOptions& options);

  std::shared_ptr<detail::Reconnection> reconnection_;
};

}  // namespace sbgc
