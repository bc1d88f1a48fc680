/// The engine behind Conversation: one session on one transport.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/steady_timer.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/detector.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/io/transport.hpp>
#include <sbgc/session.hpp>

#include "handlers.hpp"
#include "request.hpp"

namespace sbgc::detail {

using Strand = asio::strand<asio::any_io_executor>;

/// Threads: what is public may be called from any thread, if nothing else is said. The session, the
/// transport and the timer belong to the strand; what they share with callers is under `mutex_`,
/// which is never held while a handler runs.
///
/// Asio's objects are given up on the strand when the conversation has been closed, because handles
/// and subscriptions may outlive the execution context.
class Conversation::State : public std::enable_shared_from_this<Conversation::State> {
 public:
  State(Strand strand, const ConnectOptions& options);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  /// Begins to talk over a transport whose executor is the strand. Called once.
  void attach(std::unique_ptr<io::Transport> transport);

  /// What a search for the line's settings has found.
  struct Detection {
    bool found = false;
    std::array<Trial, Detector::lines> trials{};
  };
  /// Searches for the settings of the line at which a board answers, and leaves the line there.
  /// Behind attach(), before any call; the transport has a line. close() ends the search.
  void detect(const std::function<void(Detection)>& done);
  /// Ends a search that is under way, unsuccessfully.
  void stop_detecting();

  /// Says with whom; before the conversation is handed out.
  void set_board(const BoardIdentity& board) { board_ = board; }
  const BoardIdentity& board() const noexcept { return board_; }

  struct Begun {
    Ticket ticket{};
    Instant deadline = Instant::never;  ///< the call ends by then
  };
  Begun start(FrameBytes frame, const CallOptions& options, ReplyHandler handler);
  /// Ends a call with this error, if it has not ended.
  void end(Ticket ticket, ClientError error);

  Subscription subscribe(MessageKey key, MessageHandler handler);
  Subscription on_notice(std::function<void(const Notice&)> handler);
  Begun start_stream(FrameBytes frame, MessageKey key, MessageHandler handler,
                     const CallOptions& options, StreamHandler done);

  std::string description() const;
  ClientStatistics statistics() const;
  void close();

  bool runs_in_this_thread() const;
  /// Why there is no conversation any more; nothing while it goes on.
  std::optional<ClientError> end_reason() const;

 private:
  class StreamHold;
  using StreamKey = std::pair<std::uint8_t, std::array<std::uint8_t, max_stream_config>>;

  static constexpr SessionCapacity capacity{.requests = 32, .late_replies = 64, .streams = 10};

  enum class Phase : std::uint8_t { open, lost, closed };

  struct Call {
    Ticket ticket{};
    Request request;
    SendOptions send{};
    Instant deadline = Instant::never;
    Duration allowed{};  // from start to deadline
    std::function<void(unsigned)> on_confirmation;
    ReplyHandler handler;
    Handle handle{};  // on the strand: of the session, once it has the request
  };
  using CallPointer = std::shared_ptr<Call>;

  /// A data stream that is subscribed to, or that is being ended.
  struct Stream {
    std::size_t subscriptions{};
    bool is_running{};              // the board may send it
    std::vector<std::uint8_t> end;  // the frame that ends it
  };

  // Any thread
  Begun begin(Request request, const CallOptions& options, ReplyHandler handler);
  void wake();
  void post(std::function<void()> function);
  CallPointer take(Ticket ticket);
  void complete(const Call& call, Result<Reply> result);
  void leave_stream(const StreamKey& key);
  ClientError no_line() const;

  // On the strand
  void advance();
  void hand_over();
  void advance_detection();
  void end_detection(bool found);
  void report(const Detection& detection);
  void forget(const Call& call);
  void end_overdue(Instant at);
  static ClientError overdue(const Call& call, bool was_sent);
  std::string refusal_text(const Request& request, const SendResult& refused) const;
  void arm(Instant at);
  void read();
  void take_bytes(std::span<const std::uint8_t> bytes);
  void write(std::span<const std::uint8_t> bytes);
  void handle_event(const Event& event);
  void handle_completion(const Event& event);
  Result<Reply> result_of(const Call& call, const Event& event) const;
  void deliver(const Frame& frame);
  void notify(const Notice& notice);
  void lose(const std::error_code& reason);
  void shut();
  void say_farewell();
  void hang_up();
  void release();

  const ConnectOptions options_;
  BoardIdentity board_;

  mutable std::mutex mutex_;
  std::optional<Strand> strand_;
  Phase phase_ = Phase::open;
  std::string description_;
  std::string loss_;  // why the line was lost
  Ticket last_ticket_{};
  bool is_woken_ = false;
  std::unordered_map<Ticket, CallPointer> calls_;  // all that have not ended
  std::deque<CallPointer> waiting_;                // those that the session has no room for
  std::set<std::pair<Instant, Ticket>> deadlines_;
  std::map<StreamKey, Stream> streams_;
  ClientStatistics statistics_;
  std::function<void(Detection)> detected_;  // while the line's settings are searched for

  // On the strand only
  BasicSession<capacity> session_;
  std::unordered_map<std::uint64_t, CallPointer> in_session_;  // by the number of their handle
  Contexts contexts_;
  std::unique_ptr<io::Transport> transport_;
  std::optional<asio::steady_timer> timer_;
  std::optional<Detector> detector_;
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_shut_ = false;                             // nothing more is asked of the board
  bool is_hung_up_ = false;                          // the transport is closed
  std::vector<std::vector<std::uint8_t>> farewell_;  // frames to be written before that
  bool has_room_ = false;                            // a request has left the session
  std::array<std::uint8_t, 4096> in_{};
  std::array<std::uint8_t, max_frame_size> out_{};

  std::shared_ptr<Handlers<MessageKey, bool(const Received&)>> messages_;
  std::shared_ptr<Handlers<int, void(const Notice&)>> notices_;
};

}  // namespace sbgc::detail
