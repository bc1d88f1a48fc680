/// The untyped core of Client and AsyncClient.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <sbgc/client/message_key.hpp>
#include <sbgc/client/notice.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/message.hpp>

namespace sbgc {

struct BoardIdentity;

namespace detail {

/// A handle to the conversation with one board, which lasts until close(). Thread-safe.
///
/// Handlers run one at a time on the executor of the transport; handlers of calls may also run on
/// the thread that calls close(). Each call's handler is called exactly once.
class Conversation {
 public:
  using ReplyHandler = std::function<void(Result<Reply>)>;
  using MessageHandler = detail::MessageHandler;

  class State;

  Conversation() noexcept = default;
  explicit Conversation(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}

  /// Prepares the request for this board.
  template <Message M>
  Result<Request> prepare(const M& message, const CallOptions& options) const {
    static_assert(
        M::direction != Direction::from_board,
        "only the board sends this message: a call takes the request that it answers, such as "
        "GetAnglesRequest");
    return detail::prepare(message, versions(), options.validate);
  }

  Result<Request> prepare(const AnyMessage& message, const CallOptions& options) const {
    return detail::prepare(message, versions(), options.validate);
  }

  /// Returns the error if this board has no data stream of the message.
  std::optional<ClientError> stream_refusal(const MessageType& type) const {
    return detail::stream_refusal(type, versions());
  }

  /// Prepares a request that is sent unchanged.
  static Request prepare(RawRequest request);

  /// Starts a call, or fails with the error of `request`. The handler may run before start()
  /// returns.
  CallId start(Result<Request> request, const CallOptions& options, ReplyHandler handler) const;
  /// Ends a call with ErrorCode::cancelled, unless it has already ended.
  void cancel(CallId id) const;
  /// Makes a call and waits for its reply. Must not be called from a handler.
  Result<Reply> call(Result<Request> request, const CallOptions& options) const;

  Subscription subscribe(MessageKey key, MessageHandler handler) const;
  Subscription on_notice(std::function<void(const Notice&)> handler) const;
  Subscription on_frame(std::function<void(const BoardFrame&)> handler) const;

  /// Polling instead of a stream: the first request is repeated.
  struct Polling {
    std::chrono::microseconds interval{};
    std::string reason{};  ///< a clause
  };
  /// The requests that start and end a data stream.
  struct StreamRequests {
    Result<Request> start;
    Result<Request> end;
    std::optional<Polling> polling{};
  };
  using StreamHandler = std::function<void(Result<Subscription>)>;
  /// Registers a data stream and subscribes to its messages.
  CallId start_stream(StreamRequests requests, MessageKey key, MessageHandler handler,
                      const CallOptions& options, StreamHandler done) const;
  Result<Subscription> stream(StreamRequests requests, MessageKey key, MessageHandler handler,
                              const CallOptions& options) const;

  const BoardIdentity& identity() const noexcept;
  std::string description() const;
  ClientStatistics statistics() const;
  void close() const noexcept;

  explicit operator bool() const noexcept { return state_ != nullptr; }
  const std::shared_ptr<State>& state() const noexcept { return state_; }

 private:
  Availability versions() const noexcept;

  std::shared_ptr<State> state_;
};

}  // namespace detail
}  // namespace sbgc
