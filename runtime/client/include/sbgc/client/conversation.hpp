/// The untyped core of Client and AsyncClient.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <sbgc/client/notice.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/message.hpp>

namespace sbgc {

struct BoardIdentity;

namespace detail {

/// A request in its frame. Everything else about it the library finds out from the bytes.
using FrameBytes = std::span<const std::uint8_t>;

/// One message as a subscriber names it.
struct MessageKey {
  std::uint8_t id{};
  Form form{};

  bool operator==(const MessageKey&) const = default;
};

template <Message M>
inline constexpr MessageKey key_of{static_cast<std::uint8_t>(M::command), M::form};

/// A handle of the conversation with one board, which goes on until close(). Thread-safe.
///
/// Handlers run one at a time on the executor of the transport, those of calls also on the thread
/// that calls close(). Each is called exactly once.
class Conversation {
 public:
  using ReplyHandler = std::function<void(Result<Reply>)>;
  /// False: the message cannot be decoded.
  using MessageHandler = std::function<bool(const Received&)>;
  using Ticket = std::uint64_t;

  class State;

  Conversation() noexcept = default;
  explicit Conversation(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}

  /// Begins a call. The handler may run before start() returns.
  Ticket start(FrameBytes frame, const CallOptions& options, ReplyHandler handler) const;
  /// Ends a call with ErrorCode::cancelled, if it has not ended yet.
  void cancel(Ticket ticket) const;
  /// A call that is waited for. Not from a handler.
  Result<Reply> call(FrameBytes frame, const CallOptions& options) const;

  Subscription subscribe(MessageKey key, MessageHandler handler) const;
  Subscription on_notice(std::function<void(const Notice&)> handler) const;

  using StreamHandler = std::function<void(Result<Subscription>)>;
  /// Registers a data stream with the request in `frame` and subscribes to its messages.
  Ticket start_stream(FrameBytes frame, MessageKey key, MessageHandler handler,
                      const CallOptions& options, StreamHandler done) const;
  Result<Subscription> stream(FrameBytes frame, MessageKey key, MessageHandler handler,
                              const CallOptions& options) const;

  const BoardIdentity& board() const noexcept;
  std::string description() const;
  ClientStatistics statistics() const;
  void close() const noexcept;

  const std::shared_ptr<State>& state() const noexcept { return state_; }

 private:
  std::shared_ptr<State> state_;
};

}  // namespace detail
}  // namespace sbgc
