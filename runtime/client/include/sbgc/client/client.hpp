/// The blocking client: talks to a gimbal.
///
///     auto client = sbgc::Client::connect("/dev/ttyUSB0");
///     if (!client) return fail(client.error().message);
///     auto angles = client->get_angles();
///
/// Include the messages you use, such as <sbgc/messages/realtime.hpp>.
///
/// Commands can move the camera: after motors_on() it may jump to its target angle, after
/// motors_off() it may drop to its heavy side. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/calls.hpp>
#include <sbgc/client/clock.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/stream_requests.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/client/task_calls.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

namespace detail {

struct ClientMaker;

/// Drives a task to completion on the calling thread.
void drive(const Conversation& conversation, TaskMachine& task, Clock& clock);

}  // namespace detail

/// A connected board. Every function may be called from any thread, also concurrently. No function
/// throws or waits longer than its timeout: the thread that waits ends the wait itself, so it
/// returns as soon as the system lets it run again, also if the client's own thread gets no time.
/// Only a move that fails may take longer, to stop the camera; see MoveOptions::stop_on_failure.
///
/// Besides call(), each command has a function of its own, named without CMD_:
/// `client.read_params_3({.profile_id = profile})`; see <sbgc/client/calls.hpp>.
///
/// Handlers run on the client's own thread, one at a time, and must not wait for the client: a call
/// from a handler fails with ErrorCode::invalid.
class Client : public TaskCalls<Client> {
 public:
  /// Opens the address, detects the settings of a serial port whose address does not give them, and
  /// reads the identity of the board. Addresses, see <sbgc/io/open.hpp>: "/dev/ttyUSB0",
  /// "serial:/dev/ttyUSB0?baud=115200&parity=even", "tcp:host:port", "udp:host:port".
  static Result<Client> connect(const std::string& address, const ConnectOptions& options = {});

  Client(Client&&) noexcept = default;
  Client& operator=(Client&&) noexcept = default;
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  /// Closes the line; see close().
  ~Client() = default;

  /// Sends a request and waits for the response that the protocol specifies: a message,
  /// confirmations or nothing. The result of an AnyMessage, see <sbgc/any.hpp>, is the response or
  /// confirmation, or nothing if the protocol has none.
  template <Callable M>
  CallResult<M> call(const M& request, const CallOptions& options = {}) {
    return detail::read_response<M>(transact(request, options));
  }

  /// Like call(), but also reports how the request ended, and does not decode the response,
  /// which may not be decodable.
  template <Callable M>
  Result<Reply> transact(const M& request, const CallOptions& options = {}) {
    return conversation_.call(conversation_.prepare(request, options), options);
  }

  /// Calls `handler` with every M that the board sends, solicited or not.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return conversation_.subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }

  /// Calls `handler` for all other events: resets, errors, the loss of the line.
  Subscription on_notice(std::function<void(const Notice&)> handler) {
    return conversation_.on_notice(std::move(handler));
  }

  /// Like transact(), for a request that is encoded already; see raw_request().
  Result<Reply> call_raw(RawRequest request, const CallOptions& options = {}) {
    return conversation_.call(conversation_.prepare(std::move(request)), options);
  }
  /// Sends a request that is encoded already, without waiting. `handler` is called exactly once: on
  /// the client's thread, or, if the request cannot be sent, at once.
  void start_raw(RawRequest request, const CallOptions& options,
                 std::function<void(const Result<Reply>&)> handler) {
    conversation_.start(conversation_.prepare(std::move(request)), options, std::move(handler));
  }

  /// Calls `handler` with every frame that the board sends, also with those of unknown messages.
  Subscription on_frame(std::function<void(const BoardFrame&)> handler) {
    return conversation_.on_frame(std::move(handler));
  }

  /// Makes the board send M every `interval` as long as the subscription lives. The shortest
  /// interval is 1 ms. Fails with ErrorCode::invalid if the interval is 0 or longer than a request
  /// can express (about a minute), and with ErrorCode::overload if the line cannot carry the data.
  /// Firmware without data streams is asked for M each time, if a request without content does it,
  /// at most as often as it answers; NoticeKind::polling reports that.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::chrono::milliseconds interval,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    const auto request = detail::stream_request<Request>(interval);
    if (!request) return request.error();
    return stream<M, Request>(*request, std::move(handler), options);
  }

  /// The same for messages that need more than an interval: `request` holds the interval and the
  /// configuration of the stream. This function sets its command.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::type_identity_t<Request> request,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    return conversation_.stream(
        detail::stream_requests<M>(conversation_, std::move(request), options), detail::key_of<M>,
        detail::typed_handler<M>(std::move(handler)), options);
  }

  /// Makes the board send a data stream of any message, also of one that is not known here:
  /// `request` has its id, the interval and the configuration. `handler` gets the bytes of each
  /// frame with this id, valid during the call.
  template <class Request = roles::StreamRequest>
  Result<Subscription> stream_raw(const std::type_identity_t<Request>& request,
                                  std::function<void(const Frame&)> handler,
                                  const CallOptions& options = {}) {
    return conversation_.stream(detail::stream_requests(conversation_, request, options),
                                detail::raw_key(request),
                                detail::typed_handler<Frame>(std::move(handler)), options);
  }

  /// Drives a task to completion. The task waits on `clock` between its calls.
  template <class R>
  R run(Task<R> task, Clock& clock = Clock::system()) {
    detail::drive(conversation_, task.begin(conversation_.identity()), clock);
    return std::move(task).result();
  }

  /// What the board reported about itself on connecting.
  const BoardIdentity& identity() const noexcept { return conversation_.identity(); }
  /// Describes the line, e.g. "serial port /dev/ttyUSB0, 115200 8N1".
  std::string description() const { return conversation_.description(); }
  ClientStatistics statistics() const { return conversation_.statistics(); }

  /// Ends every call with ErrorCode::cancelled and closes the line. Later calls fail with
  /// ErrorCode::not_connected.
  void close() noexcept { conversation_.close(); }

 private:
  friend struct detail::ClientMaker;

  Client(std::shared_ptr<const void> keeper, detail::Conversation conversation) noexcept
      : io_thread_(std::move(keeper)), conversation_(std::move(conversation)) {}

  std::shared_ptr<const void> io_thread_;  // keeps the I/O thread alive; closes with the client
  detail::Conversation conversation_;
};

}  // namespace sbgc
