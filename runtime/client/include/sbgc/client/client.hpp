/// Talking to a gimbal: the blocking client.
///
///     auto client = sbgc::Client::connect("/dev/ttyUSB0");
///     if (!client) return fail(client.error().message);
///     auto angles = client->get_angles();
///
/// Include the messages that are used, such as <sbgc/messages/realtime.hpp>.
///
/// Commands can move the camera: motors_on() lets it jump to its target angle, motors_off() lets it
/// drop to its heavy side. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/calls.hpp>
#include <sbgc/client/clock.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/client/task_calls.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

namespace detail {

struct ClientMaker;

/// Drives a task to its end in this thread.
void drive(const Conversation& conversation, TaskMachine& task, Clock& clock);

}  // namespace detail

/// A connected board. Every function may be called from any thread, also at the same time; nothing
/// throws, nothing waits longer than its timeout.
///
/// Besides call() there is a function with the name of each command, without its CMD_:
/// `client.read_params_3({.profile_id = profile})`; see <sbgc/client/calls.hpp>.
///
/// Handlers run on the client's own thread, one at a time, and must not wait for the client: a call
/// from there fails with ErrorCode::invalid.
class Client : public TaskCalls<Client> {
 public:
  /// Opens the address, finds the line's settings if it is a serial port without them, and reads
  /// what the board tells about itself. For addresses see <sbgc/io/open.hpp>: "/dev/ttyUSB0",
  /// "serial:/dev/ttyUSB0?baud=115200&parity=even", "tcp:host:port", "udp:host:port".
  static Result<Client> connect(const std::string& address, const ConnectOptions& options = {});

  Client(Client&&) noexcept = default;
  Client& operator=(Client&&) noexcept = default;
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  /// Closes the line; see close().
  ~Client() = default;

  /// Sends a request and waits for what the protocol says comes back: the message that answers it,
  /// its confirmations, or nothing.
  template <Message M>
  CallResult<M> call(const M& request, const CallOptions& options = {}) {
    return detail::read_answer<M>(transact(request, options));
  }

  /// As call(), but says how it ended and leaves the answer as it came.
  template <Message M>
  Result<Reply> transact(const M& request, const CallOptions& options = {}) {
    return conversation_.call(conversation_.prepare(request, options), options);
  }

  /// Calls `handler` with every M that the board sends, whether asked for or not.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return conversation_.subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }

  /// Calls `handler` with everything else that happens: resets, errors, the loss of the line.
  Subscription on_notice(std::function<void(const Notice&)> handler) {
    return conversation_.on_notice(std::move(handler));
  }

  /// Lets the board send M every `interval` as long as the subscription lives; 1 ms is as often as
  /// it can. ErrorCode::invalid if the interval is 0 or longer than a request can tell, about a
  /// minute; ErrorCode::overload if that is more than the line can carry.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::chrono::milliseconds interval,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    const auto request = detail::stream_request<Request>(interval);
    if (!request) return request.error();
    return stream<M, Request>(*request, std::move(handler), options);
  }

  /// The same for messages that the board must be told more about: `request` has the interval and
  /// whatever else the message needs, its command is filled in here.
  template <Message M, class Request = roles::StreamRequest>
  Result<Subscription> stream(std::type_identity_t<Request> request,
                              std::function<void(const M&)> handler,
                              const CallOptions& options = {}) {
    return conversation_.stream(
        detail::stream_requests<M>(conversation_, std::move(request), options), detail::key_of<M>,
        detail::typed_handler<M>(std::move(handler)), options);
  }

  /// Drives a task to its end. The clock is what the task waits on between its calls.
  template <class R>
  R run(Task<R> task, Clock& clock = Clock::system()) {
    detail::drive(conversation_, task.begin(conversation_.identity()), clock);
    return std::move(task).result();
  }

  /// What the board has told about itself.
  const BoardIdentity& identity() const noexcept { return conversation_.identity(); }
  /// What this client is connected to: "serial port /dev/ttyUSB0, 115200 8N1".
  std::string description() const { return conversation_.description(); }
  ClientStatistics statistics() const { return conversation_.statistics(); }

  /// Ends every call with ErrorCode::cancelled, and closes the line. Later calls fail with
  /// ErrorCode::not_connected.
  void close() noexcept { conversation_.close(); }

 private:
  friend struct detail::ClientMaker;

  Client(std::shared_ptr<const void> keeper, detail::Conversation conversation) noexcept
      : keeper_(std::move(keeper)), conversation_(std::move(conversation)) {}

  std::shared_ptr<const void> keeper_;  // of the thread that does the work; closes with the client
  detail::Conversation conversation_;
};

}  // namespace sbgc
