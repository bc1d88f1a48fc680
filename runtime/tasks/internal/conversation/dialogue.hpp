/// Requests and responses without I/O: runs the calls of a conversation over a session.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/session.hpp>

#include "delivery.hpp"
#include "shared_calls.hpp"

namespace sbgc::detail {

/// The owner feeds bytes and the time, and writes the output. Not thread-safe; only the pending
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
  /// Places of the session that reads and others with an effect can take; the rest is for stops.
  static constexpr std::size_t most_reads = 32;
  static constexpr std::size_t most_effects = capacity.requests - 4;

  void send_waiting();
  bool has_room(const Call& call) const noexcept;
  /// The call of the session's request; null if it is not of a call, or was forgotten.
  CallPointer call_of(Handle handle) const;
  void end_overdue(Instant now);
  void handle(const Event& event);
  /// Passes the frame of an event to those who want frames as they are.
  void show(const Event& event);
  void handle_completion(const Event& event);
  Result<Reply> result_of(const Call& call, const Event& event) const;
  /// The facts that decoding a response of a call needs; null if it needs none.
  std::shared_ptr<const Contexts> known_to(const Call& call, const Frame& frame) const;
  Reply reply_to(const Call& call, ReplyKind kind, const Frame& frame) const;
  ClientError refusal(const Call& call, const SendResult& refused) const;

  SharedCalls& calls_;
  Delivery& delivery_;
  BasicSession<capacity> session_;
  std::vector<CallPointer> in_session_;
  bool has_room_ = false;  // a request has left the session
};

}  // namespace sbgc::detail
