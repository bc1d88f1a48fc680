/// The implementation of Conversation: a dialogue over a channel, and its participants.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
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
#include <sbgc/detector.hpp>
#include <sbgc/io/internal/timer.hpp>
#include <sbgc/io/transport.hpp>

#include "calls/pending_calls.hpp"
#include "calls/stream_listeners.hpp"
#include "channel.hpp"
#include "conversation/dialogue.hpp"
#include "threads.hpp"

namespace sbgc::detail {

/// The error of a handler that waits for a call.
ClientError handler_waits_error();

/// Public functions may be called from any thread, unless documented otherwise. Dialogue, channel
/// and delivery require the strand. No lock is held while a handler runs.
class Conversation::State : public Channel::User,
                            public std::enable_shared_from_this<Conversation::State> {
 public:
  State(Strand strand, const ConnectOptions& options);

  /// Starts the conversation over a transport whose executor is the strand. Must be called once.
  void attach(std::unique_ptr<io::Transport> transport);

  /// Searches for the line settings at which a board responds, keeps them, and calls `done`.
  /// Requires attach() and a transport with a LineControl; must precede all calls. close() ends the
  /// search.
  void detect_line(std::function<void(bool is_found)> done);
  using Trials = std::array<Trial, Detector::lines>;
  /// The trials of the search so far.
  Trials trials() const;

  /// Sets the identity of the board; must precede the use of the conversation by others.
  void set_identity(const BoardIdentity& board) { board_ = board; }
  const BoardIdentity& identity() const noexcept { return board_; }

  /// Starts a call, of a task unless it is 0; returns when it ends at the latest.
  Instant start(CallId id, Result<Request> request, const CallOptions& options,
                ReplyHandler handler, TaskNumber task = 0);
  /// The pending calls, with the order of tasks; do not wait while you hold the lock.
  SharedCalls& calls() noexcept { return calls_; }
  /// Ends a call with this error, unless it has already ended.
  void end(CallId id, ClientError error);
  /// Ends the calls whose deadlines have passed. A thread that waits for a call does this itself:
  /// waiting for the strand would cost another scheduling delay, and a handler may block the
  /// strand.
  void end_overdue(Instant at);

  /// For subscriptions.
  Delivery& delivery() noexcept { return delivery_; }
  Instant start_stream(CallId id, StreamRequests requests, MessageKey key, MessageHandler handler,
                       const CallOptions& options, StreamHandler done);

  std::string description() const;
  /// True if the line may duplicate frames, because of its kind or the options.
  bool may_repeat() const noexcept { return may_repeat_; }
  ClientStatistics statistics() const;
  /// `loss` is why the line counts as lost; "" if its owner closes it.
  void close(std::string loss = "");
  /// Like close(), but also discards unsent data of the port, so that closing it does not wait.
  void abandon();

  const io::detail::ExecutorClock& clock() const noexcept { return clock_; }

  bool runs_in_this_thread() const { return channel_.runs_in_this_thread(); }
  /// The reason why the conversation ended; nothing while it is running.
  std::optional<ClientError> end_reason() const;

 private:
  class StreamHold;
  class PollHold;
  enum class Phase : std::uint8_t { open, lost, closed };

  /// Marks the strand as busy as long as it lives.
  class Busy;

  void complete(const CallPointer& call, Result<Reply> result);
  /// True if the strand has been busy for so long that a handler must be blocking it.
  bool is_stuck() const;
  void wake();
  void post(std::function<void()> function);
  void leave_stream(const StreamListeners::Key& key, StreamListeners::Listener listener);
  void change_stream(const StreamListeners::Key& key, Request request);
  void set_running(const StreamListeners::Key& key, std::uint32_t interval, bool may_change);
  Instant start_polling(CallId id, StreamRequests requests, MessageKey key, MessageHandler handler,
                        const CallOptions& options, StreamHandler done);
  bool is_open() const;

  // On the strand.
  void received(std::span<const std::uint8_t> bytes) override;
  void written() override;
  void woken() override { advance(); }
  void line_failed(const std::error_code& reason) override;
  void advance();
  void poll();
  void search();
  void end_search(bool is_found);
  /// Reports the end of the search, once. On any thread.
  void report_search(bool is_found);
  void begin_close();

  const ConnectOptions options_;
  const io::detail::ExecutorClock clock_;
  BoardIdentity board_;
  std::atomic<bool> may_repeat_ = false;
  SharedCalls calls_;
  Guarded<StreamListeners> streams_{make_mutex()};
  Guarded<Polls> polls_{make_mutex()};
  const std::vector<std::uint8_t> question_;  // of the detector
  Guarded<Detector> detector_;
  bool is_searching_ = false;  // only on the strand
  Delivery delivery_{make_mutex};
  Dialogue dialogue_;
  Channel channel_;

  mutable std::mutex mutex_;
  Phase phase_ = Phase::open;
  std::string description_;
  std::string loss_;  // why the line was lost
  std::function<void(bool)> on_search_end_;
  bool is_woken_ = false;
  bool is_abandoned_ = false;
  ClientStatistics statistics_;  // of the session and its streams

  std::atomic<std::int64_t> busy_since_us_{Instant::never.us};
};

}  // namespace sbgc::detail
