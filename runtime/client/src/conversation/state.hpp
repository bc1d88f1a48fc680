/// The engine behind Conversation: a dialogue on a channel, and who takes part in it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/io/transport.hpp>

#include "channel.hpp"
#include "delivery.hpp"
#include "dialogue.hpp"
#include "line_search.hpp"
#include "pending_calls.hpp"
#include "stream_listeners.hpp"

namespace sbgc::detail {

/// How long after its deadline a call is given up if the client's thread does not come round to
/// ending it, because a handler keeps it.
inline constexpr Duration grace = milliseconds(200);
/// Why such a call ended.
ClientError stuck_error();
/// Why a handler cannot wait for a call.
ClientError handler_waits_error();

/// What is public may be called from any thread, if nothing else is said. Dialogue, channel and
/// delivery belong to the strand. No lock is held while a handler runs.
class Conversation::State : public Channel::User,
                            public std::enable_shared_from_this<Conversation::State> {
 public:
  State(Strand strand, const ConnectOptions& options);

  /// Begins to talk over a transport whose executor is the strand. Called once.
  void attach(std::unique_ptr<io::Transport> transport);

  /// Searches for the settings of the line at which a board answers, and leaves the line there.
  /// After attach(), before any call; the transport has a line. close() ends the search.
  void find_line(LineSearch::Done done);
  /// Ends a search that is under way, unsuccessfully.
  void stop_finding_line();

  /// Says with whom; before the conversation is handed out.
  void set_identity(const BoardIdentity& board) { board_ = board; }
  const BoardIdentity& identity() const noexcept { return board_; }

  struct Begun {
    Ticket ticket{};
    Instant deadline = Instant::never;  ///< the call ends by then
  };
  Begun start(Result<Request> request, const CallOptions& options, ReplyHandler handler);
  /// Ends a call with this error, if it has not ended.
  void end(Ticket ticket, ClientError error);

  Subscription subscribe(MessageKey key, MessageHandler handler);
  Subscription on_notice(std::function<void(const Notice&)> handler);
  Begun start_stream(StreamRequests requests, MessageKey key, MessageHandler handler,
                     const CallOptions& options, StreamHandler done);

  std::string description() const;
  ClientStatistics statistics() const;
  void close();

  bool runs_in_this_thread() const { return channel_.runs_in_this_thread(); }
  /// Why there is no conversation any more; nothing while it goes on.
  std::optional<ClientError> end_reason() const;

 private:
  class StreamHold;
  enum class Phase : std::uint8_t { open, lost, closed };

  Begun begin(Request request, const CallOptions& options, ReplyHandler handler);
  void wake();
  void post(std::function<void()> function);
  void leave_stream(const StreamListeners::Key& key);
  bool is_open() const;

  // On the strand
  void received(std::span<const std::uint8_t> bytes) override;
  void written() override;
  void woken() override { advance(); }
  void line_failed(const std::error_code& reason) override;
  void advance();
  void end_search();
  void shut();

  const ConnectOptions options_;
  BoardIdentity board_;
  PendingCalls calls_;
  StreamListeners streams_;
  LineSearch search_;
  Delivery delivery_;
  Dialogue dialogue_;
  Channel channel_;

  mutable std::mutex mutex_;
  Phase phase_ = Phase::open;
  std::string description_;
  std::string loss_;  // why the line was lost
  bool is_woken_ = false;
  ClientStatistics statistics_;  // of the session and its streams
};

}  // namespace sbgc::detail
