/// Requests and responses without I/O: runs the calls of a conversation over a session, and
/// delivers the messages of the board to subscribers.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/client/message_key.hpp>
#include <sbgc/client/notice.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/result.hpp>
#include <sbgc/session.hpp>

#include "calls/pending_calls.hpp"
#include "handlers.hpp"

namespace sbgc::detail {

/// With locks, subscribing is thread-safe. Everything else belongs to the owner's thread or strand.
class Delivery {
 public:
  explicit Delivery(MakeLock make_lock = no_lock)
      : messages_(std::make_shared<MessageHandlers>(make_lock)),
        frames_(std::make_shared<FrameHandlers>(make_lock)),
        notices_(std::make_shared<NoticeHandlers>(make_lock)) {}

  using Registration = std::unique_ptr<Subscription::Registration>;
  Registration subscribe(MessageKey key, MessageHandler handler) {
    return messages_->add(key, std::move(handler));
  }
  Registration on_notice(std::function<void(const Notice&)> handler) {
    return notices_->add({}, std::move(handler));
  }
  Registration on_frame(std::function<void(const BoardFrame&)> handler) {
    return frames_->add({}, std::move(handler));
  }

  /// Decodes a message once, if a subscriber or a context needs it; `known` are the facts for an
  /// answer, if they differ from those of the conversation.
  void deliver(const Frame& frame, const Contexts* known = nullptr);
  void notify(const Notice& notice);
  /// Passes on a raw frame.
  void show(const BoardFrame& frame);

  /// Facts from earlier messages that decoding later ones needs.
  Contexts& contexts() noexcept { return contexts_; }
  /// The number of messages for a subscriber that could not be decoded.
  std::uint64_t unreadable() const noexcept { return unreadable_; }

 private:
  /// Notifies the user of an undecodable message, unless the last one looked the same: a stream of
  /// them causes one notice.
  void report_unreadable(const Frame& frame, const Status& status, std::size_t subscribers);

  using MessageHandlers = Handlers<MessageKey, void(const void*)>;
  using FrameHandlers = Handlers<int, void(const BoardFrame&)>;
  using NoticeHandlers = Handlers<int, void(const Notice&)>;

  std::shared_ptr<MessageHandlers> messages_;
  std::shared_ptr<FrameHandlers> frames_;
  std::shared_ptr<NoticeHandlers> notices_;
  Contexts contexts_;
  std::atomic<std::uint64_t> unreadable_{};
  std::string last_unreadable_;  // its notice
};

/// The owner passes in bytes and the time, and writes the output. Not thread-safe; only the pending
/// calls are shared with other threads.
class Dialogue {
 public:
  Dialogue(const ConnectOptions& options, SharedCalls& calls, Delivery& delivery);

  /// Sets the settings of the line that carries the bytes.
  void set_line(const LineSettings& line) { session_.set_line(line); }

  /// Passes waiting calls to the session and ends overdue ones. Returns the bytes to write and the
  /// time of the next call. While a write is pending, `can_write` is false and there is nothing to
  /// write.
  Output advance(Instant now, bool can_write);
  void feed(std::span<const std::uint8_t> bytes, Instant now);
  /// Reports that the bytes of the last advance() have been written.
  void written(Instant now) { session_.written(now); }
  /// Drops a call that is no longer pending.
  void forget(const Call& call);
  /// Drops all calls.
  void forget_all() { in_session_.clear(); }

  Framing framing() const noexcept { return session_.framing(); }
  SessionStatistics statistics() const noexcept { return session_.statistics(); }
  StreamUsage stream_usage() const noexcept { return session_.stream_usage(); }

 private:
  static constexpr SessionCapacity capacity{.requests = 64, .late_replies = 64, .streams = 10};
  /// The places of the session for reads and for requests with an effect; the rest is for stops.
  static constexpr std::size_t most_reads = 32;
  static constexpr std::size_t most_effects = capacity.requests - 4;

  void send_waiting();
  bool has_room(const Call& call) const noexcept;
  /// Returns the call of the session's request; null if it belongs to no call, or was dropped.
  CallPointer call_of(Handle handle) const;
  void end_overdue(Instant now);
  void handle(const Event& event);
  /// Passes the frame of an event to subscribers of raw frames.
  void show(const Event& event);
  void handle_completion(const Event& event);
  Result<Reply> result_of(const Call& call, const Event& event) const;
  /// Returns the facts for decoding a response of a call; null if it needs none.
  std::shared_ptr<const Contexts> known_to(const Call& call, const Frame& frame) const;
  Reply reply_to(const Call& call, ReplyKind kind, const Frame& frame) const;
  ClientError refusal(const Call& call, const SendResult& refused) const;

  SharedCalls& calls_;
  Delivery& delivery_;
  BasicSession<capacity> session_;
  std::vector<CallPointer> in_session_;
  bool has_room_ = false;  // a request has left the session
};

/// Returns the request for the introduction of a board whose port requires this password. Fails if
/// the password is invalid. The error does not reveal it.
Result<msg::BoardInfoRequestExt> opening_request(const std::string& password);
/// Returns the frame of the first request, which a search for the line sends; empty for the usual
/// one.
std::vector<std::uint8_t> opening_frame(const std::optional<std::string>& password);

}  // namespace sbgc::detail
