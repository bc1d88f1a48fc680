/// The blocking client: talks to a gimbal.
///
///     auto client = sbgc::Client::connect("/dev/ttyUSB0");
///     if (!client) return fail(client.error().message);
///     auto angles = client->get_angles();
///
/// or with automatic reconnection:
///
///     auto client = sbgc::Client::connect("/dev/ttyUSB0", sbgc::ReconnectOptions{});
///
/// Include the messages you use, such as <sbgc/messages/realtime.hpp>.
///
/// Commands can move the camera: after motors_on() it may jump to its target angle, after
/// motors_off() it may drop to its heavy side. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/calls.hpp>
#include <sbgc/client/clock.hpp>
#include <sbgc/client/link.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/reconnect_options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/stream_requests.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/client/task_calls.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// A board. Every function may be called from any thread, also concurrently. No function throws or
/// waits longer than its timeout: the thread that waits ends the wait itself, so it returns as soon
/// as the system lets it run again, also if the client's own thread gets no time. Only a move that
/// fails may take longer, to stop the camera; see MoveOptions::stop_on_failure.
///
/// Besides call(), each command has a function of its own, named without CMD_:
/// `client.read_params_3({.profile_id = profile})`; see <sbgc/client/calls.hpp>.
///
/// Handlers run one at a time, on threads of the client. They must not throw, which would end the
/// program, and must not wait for the client: a call from a handler fails with ErrorCode::invalid.
///
/// Connected with ReconnectOptions, the client restores its connection after the line was lost, the
/// board restarted, or a data stream fell silent because the board lost its power:
///
/// - A USB adapter is found again under another name, by its vendor, product and serial number. One
///   without a serial number is taken only if exactly one such adapter is plugged in.
/// - The board must be the same: see ReconnectOptions::other_board.
/// - Subscriptions and data streams go on as soon as the connection is restored.
/// - A call during an outage fails with ErrorCode::not_connected, or waits: see
///   ReconnectOptions::calls. A call or task that the outage interrupts fails in any case, because
///   the board may have executed it.
class Client : public TaskCalls<Client> {
 public:
  /// Opens the address, detects the settings of a serial port whose address does not give them, and
  /// reads the identity of the board. Addresses, see <sbgc/io/open.hpp>: "/dev/ttyUSB0",
  /// "serial:/dev/ttyUSB0?baud=115200&parity=even", "tcp:host:port", "udp:host:port".
  /// Errors: `invalid`, `not_found` for the port, the host or the board, `io`, `timeout`,
  /// `bad_file` for a capture, `link_lost`, and those of call() for the questions to the board.
  static Result<Client> connect(const std::string& address, const ConnectOptions& options = {});
  /// The same, but reconnects whenever the connection breaks. The first connection must succeed.
  /// The options have to be named: `{}` means ConnectOptions. Errors: those of connect().
  template <std::same_as<ReconnectOptions> Options>
  static Result<Client> connect(const std::string& address, const Options& options) {
    return keep_connected(address, options);
  }

  /// Over a link; see <sbgc/client/own_transport.hpp>.
  explicit Client(std::shared_ptr<detail::Link> link) noexcept : link_(std::move(link)) {}
  Client(Client&&) noexcept = default;
  Client& operator=(Client&&) noexcept = default;
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  /// Closes the line and ends the search for another one; see close().
  ~Client() = default;

  /// Sends a request and waits for the response that the protocol specifies: a message,
  /// confirmations or nothing. The result of an AnyMessage, see <sbgc/any.hpp>, is the response or
  /// confirmation, or nothing if the protocol has none.
  ///
  /// Errors: `unsupported` or `invalid` before anything is sent; `timeout`; `board_error`,
  /// `board_reset`, `link_lost`; `not_connected`, during an outage or after close(); `overload`;
  /// `cancelled`; `bad_response`; `unconfirmed` with CallOptions::expect_confirmation; `superseded`
  /// for a motion that a later one replaces in the queue.
  template <Callable M>
  CallResult<M> call(const M& request, const CallOptions& options = {}) {
    return detail::read_response<M>(transact(request, options));
  }

  /// Like call(), but also reports how the request ended, and does not decode the response,
  /// which may not be decodable. Errors: those of call() except `bad_response` and `unconfirmed`.
  template <Callable M>
  Result<Reply> transact(const M& request, const CallOptions& options = {}) {
    return link_->call(
        [&](const detail::Conversation& board) { return board.prepare(request, options); },
        options);
  }

  /// Calls `handler` with every M that the board sends, solicited or not.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return link_->subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  /// The same for a message whose type is known only at run time; see <sbgc/any.hpp>.
  Subscription subscribe(const MessageType& type, std::function<void(const AnyMessage&)> handler) {
    return link_->subscribe(detail::key_of_type(type),
                            detail::any_handler(type, std::move(handler)));
  }

  /// Calls `handler` for all other events: resets, errors, the loss of the line.
  Subscription on_notice(std::function<void(const Notice&)> handler) {
    return link_->on_notice(std::move(handler));
  }
  /// Calls `handler` with each change of the state of the connection; without reconnection, with
  /// its loss.
  Subscription on_change(std::function<void(const LinkChange&)> handler) {
    return link_->on_change(std::move(handler));
  }

  /// Like transact(), for a request that is encoded already; see raw_request(). Errors: those of
  /// transact().
  Result<Reply> call_raw(RawRequest request, const CallOptions& options = {}) {
    return link_->call(
        [&](const detail::Conversation&) { return detail::Conversation::prepare(request); },
        options);
  }
  /// Sends an encoded request without waiting, not even for a connection. `handler` is called
  /// exactly once: on the client's thread, or at once if the request cannot be sent. Errors, of the
  /// handler: those of transact().
  void start_raw(RawRequest request, const CallOptions& options,
                 std::function<void(const Result<Reply>&)> handler);

  /// Calls `handler` with every frame that the board sends, including unknown messages.
  Subscription on_frame(std::function<void(const BoardFrame&)> handler) {
    return link_->on_frame(std::move(handler));
  }

  /// Makes the board send M every `interval` as long as the subscription lives. The shortest
  /// interval is 1 ms. Fails with ErrorCode::invalid if the interval is 0 or longer than a request
  /// can express (about a minute), and with ErrorCode::overload if the line cannot carry the data.
  /// Firmware without data streams is polled for M instead, if a request without content does it,
  /// at most as often as it answers; NoticeKind::polling reports that. A stream that the board
  /// refuses to restart is reported as a notice, NoticeKind::stream_ended, and tried again with the
  /// next connection. Errors: those of call().
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::chrono::milliseconds interval,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    const auto request = detail::stream_request<Request>(interval);
    if (!request) return request.error();
    return stream<M, Request>(*request, std::move(handler), options);
  }

  /// The same for messages that need more than an interval: `request` holds the interval and the
  /// configuration of the stream. This function sets its command. Errors: the same.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::type_identity_t<Request> request,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    return link_->stream(
        detail::stream_of<M>(Result<Request>(std::move(request)), std::move(handler), options),
        options);
  }

  /// The same for a message whose type is known only at run time, one of stream_types(). Errors:
  /// the same, `invalid` also for another type.
  Result<Subscription> stream(const MessageType& type, const roles::StreamRequest& request,
                              std::function<void(const AnyMessage&)> handler,
                              const CallOptions& options = {}) {
    return link_->stream(
        detail::stream_of(type, request, detail::any_handler(type, std::move(handler)), options),
        options);
  }

  /// Makes the board send a data stream of any message, including unknown ones: `request` has its
  /// id, the interval and the configuration. `handler` gets the bytes of each frame with this id,
  /// valid during the call. Errors: those of stream().
  Result<Subscription> stream_raw(const roles::StreamRequest& request,
                                  std::function<void(const Frame&)> handler,
                                  const CallOptions& options = {}) {
    return link_->stream(detail::raw_stream_of(request, std::move(handler), options), options);
  }

  /// Drives a task to completion. The task waits on `clock` between its calls, and ends with the
  /// connection on which it began. Errors: those of the task; `not_connected` if it cannot begin,
  /// and `invalid` from a handler of this client.
  template <class R>
  R run(Task<R> task, Clock& clock = Clock::system()) {
    const auto refusal = link_->run(
        [&](const BoardIdentity& board) -> TaskMachine& { return task.begin(board); }, clock);
    if (refusal) return *refusal;
    return std::move(task).result();
  }

  /// Asks the board for a sign of life, in the background. Without one, the connection counts as
  /// lost. For users of start_raw(), whose data streams the client does not know. Does nothing
  /// without reconnection.
  void check() { link_->check(); }

  /// Returns the state of the connection: `connected` or, without reconnection, `lost` or `closed`.
  LinkState state() const { return link_->state(); }
  /// True if state() is LinkState::connected.
  bool is_connected() const { return state() == LinkState::connected; }
  /// Returns the number of connections that have been made; at least 1.
  std::uint64_t connections() const { return link_->connections(); }
  /// Returns the identity of the board of the current or the last connection.
  BoardIdentity identity() const { return link_->identity(); }
  /// Describes the current or the last line, e.g. "serial port /dev/ttyUSB0, 115200 8N1".
  std::string description() const { return link_->description(); }
  /// Returns the counters of the current or the last connection.
  ClientStatistics statistics() const { return link_->statistics(); }

  /// Ends every call with ErrorCode::cancelled, closes the line and stops searching. Later calls
  /// fail with ErrorCode::not_connected.
  void close() noexcept { link_->close(); }

 private:
  friend class SpeedControl;

  static Result<Client> keep_connected(const std::string& address, const ReconnectOptions& options);

  std::shared_ptr<detail::Link> link_;
};

}  // namespace sbgc
