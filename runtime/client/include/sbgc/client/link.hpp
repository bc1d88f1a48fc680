/// The interface that carries out the operations of a client.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/clock.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/reconnect_options.hpp>
#include <sbgc/client/statistics.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::detail {

class Connection;

/// Takes the result of an operation, once, on any thread.
template <class R>
using Completion = std::function<void(R)>;
/// Cancels an operation; may be empty.
using Stop = std::function<void()>;

/// One connection to a board, or one after the other. The functions that return a Stop do not wait;
/// their completion may run before they return. Thread-safe.
class Link {
 public:
  using MessageHandler = Conversation::MessageHandler;
  /// Prepares a request for the board of a conversation.
  using Prepare = std::function<Result<Request>(const Conversation&)>;
  /// Starts a task for a board.
  using BeginTask = std::function<TaskMachine&(const BoardIdentity&)>;

  /// A data stream.
  struct Stream {
    std::function<Conversation::StreamRequests(const Conversation&)> prepare;
    MessageKey key;
    MessageHandler handler;
    std::chrono::microseconds interval;
  };

  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  virtual Result<Reply> call(const Prepare& prepare, const CallOptions& options) = 0;
  virtual Stop start(const Prepare& prepare, const CallOptions& options,
                     const Completion<Result<Reply>>& done) = 0;
  virtual Result<Subscription> stream(const Stream& stream, const CallOptions& options) = 0;
  virtual Stop start_stream(const Stream& stream, const CallOptions& options,
                            const Completion<Result<Subscription>>& done) = 0;
  /// Returns, or completes with, the error of a task that could not be started.
  virtual std::optional<ClientError> run(const BeginTask& begin, Clock& clock) = 0;
  virtual Stop start_task(const BeginTask& begin,
                          const Completion<std::optional<ClientError>>& done) = 0;

  virtual Subscription subscribe(MessageKey key, MessageHandler handler) = 0;
  virtual Subscription on_frame(std::function<void(const BoardFrame&)> handler) = 0;
  virtual Subscription on_notice(std::function<void(const Notice&)> handler) = 0;
  virtual Subscription on_change(std::function<void(const LinkChange&)> handler) = 0;

  /// Returns the current connection, without waiting.
  virtual Result<std::shared_ptr<Connection>> connected() = 0;
  virtual void check() = 0;
  virtual LinkState state() const = 0;
  virtual std::uint64_t connections() const = 0;
  virtual BoardIdentity identity() const = 0;
  virtual std::string description() const = 0;
  virtual ClientStatistics statistics() const = 0;
  virtual void close() noexcept = 0;
};

}  // namespace sbgc::detail
