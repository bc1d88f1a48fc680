/// The options, results and events of a session.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include <sbgc/frame.hpp>
#include <sbgc/line.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/status.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// Identifies a request of a session, from send() to its `completed` event. Never reused.
struct Handle {
  std::uint64_t number{};  ///< 0: no request; later requests have greater numbers

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  constexpr auto operator<=>(const Handle&) const = default;
  /// True if it names a request.
  constexpr explicit operator bool() const noexcept { return number != 0; }
};

/// The outcome of a request.
enum class Outcome : std::uint8_t {
  none,         ///< the event does not complete a request
  answered,     ///< the board answered; the event has the response, which may not decode
  confirmed,    ///< all confirmations arrived; the event has the last one
  sent,         ///< written; no response is required
  unconfirmed,  ///< written; the expected but optional confirmation did not arrive
  failed,       ///< a response or confirmation reports failure; see the event's frame
  board_error,  ///< the board reported an error instead; see the event's frame
  timeout,      ///< no response in time after all attempts, or the request's deadline passed
  reset,        ///< the board announced a restart first
  cancelled,    ///< by cancel()
  superseded,   ///< not written, because a later request of the same host stops all motion
  indistinct,   ///< not written: a data stream leaves no time to tell its answer from the samples
  link_lost,    ///< by abandon()
};

/// The kind of an event.
enum class EventKind : std::uint8_t {
  completed,     ///< a request has ended; once for every request that send() accepted
  confirmation,  ///< a confirmation; for a request with `handle`, the last one just before it
                 ///< completes
  series,        ///< a message that precedes the response to the request with `handle`; not if
                 ///< the session's capacity is one request
  board_error,   ///< an error that cannot be matched to a request
  stream,        ///< a sample of a data stream that this session has started
  unsolicited,   ///< any other message that no request waits for
  reset,         ///< the board is about to restart; the requests complete right after
};

/// Tells whether a message is a sample of a data stream that this session has started.
enum class Sample : std::uint8_t {
  none,      ///< no stream of this message, or of this size, is running
  yes,       ///< a sample, which may also answer a request
  no,        ///< a stream of this message is running, but this is only an answer
  doubtful,  ///< a sample, or a late answer
};

/// An event of a session. `frame` is a view, valid only during the call.
struct Event {
  EventKind kind{};
  Handle handle{};              ///< the request that it concerns, if any
  Outcome outcome{};            ///< of `completed`
  std::uint8_t command{};       ///< id of the request's command, or of the one that the board names
  std::uint8_t confirmation{};  ///< of `confirmation`: its number, from 1
  std::uint8_t confirmations{};  ///< of `confirmation`: the expected number of them
  bool is_late{};                ///< a late reply
  Sample sample{};  ///< if one sample completes several requests, it is `yes` only for the first
  Frame frame{};    ///< from the board; id 0 if there is none
};

/// The status of send().
enum class SendStatus : std::uint8_t {
  ok,
  queue_full,        ///< the session has no room for another request
  not_encodable,     ///< see the result's `encoding`
  over_budget,       ///< the data stream would use too much of the line's bandwidth
  too_many_streams,  ///< the board or the session has no room for another data stream
  timeout_too_long,  ///< more than longest_timeout
};

/// The longest timeout of a response.
inline constexpr Duration longest_timeout = seconds(3600);

/// The result of send(): a handle if the status is ok.
struct SendResult {
  Handle handle{};      ///< of the request, for cancel() and events
  SendStatus status{};  ///< why it was refused, or `ok`
  Status encoding{};    ///< the reason for not_encodable

  /// True if the request was accepted.
  constexpr explicit operator bool() const noexcept { return status == SendStatus::ok; }
};

/// Options of one request.
struct SendOptions {
  /// The host of the request, in a session that several hosts share: requests of one host keep
  /// their order. A host other than 0 distinguishes the responses to its own requests itself.
  std::uint16_t host = 0;
  /// Wait for an optional confirmation: complete with `confirmed` or `unconfirmed`, not `sent`.
  bool expect_confirmation = false;
  /// With expect_confirmation: resend it like a request whose confirmation is certain.
  bool repeat_unconfirmed = false;
  bool ignore_budget = false;  ///< start a data stream regardless of its bandwidth
  std::uint8_t attempts = 0;   ///< maximum transmissions if a retry is safe; 0: the session's
  /// The timeout of each transmission, at most longest_timeout; 0: that of the response policy.
  Duration timeout{};
  Instant deadline = Instant::never;  ///< completes with `timeout` at this time, sent or not
};

/// The pause after each command, so that the board's input buffer does not overflow.
struct PacingOptions {
  /// After a request and response of at most 48 bytes together.
  Duration shortest = milliseconds(shortest_pause_ms);
  Duration longest = milliseconds(longest_pause_ms);  ///< after the largest
  bool until_response = true;  ///< a response ends the pause: the board has read the command
};

/// Options of a session. The defaults suit a serial line of unknown speed. A duration of over an
/// hour may count as one hour.
struct SessionOptions {
  LineSettings line{};                ///< for transmission times; at 0 baud, these are 0
  PacingOptions pacing{};             ///< both 0: none
  std::uint8_t attempts = 3;          ///< maximum transmissions of a request whose retry is safe
  Duration late = milliseconds(500);  ///< how late a response may still arrive
  Duration duplicate_window{};        ///< how long a duplicate frame may arrive (UDP); 0: never
  Duration idle = milliseconds(100);  ///< silence that ends an incomplete frame
  std::uint8_t stream_percent = 80;   ///< the share of the line that data streams may use
};

/// Counters of a session since its construction.
struct SessionStatistics {
  ParserCounters parser{};      ///< frames and noise received
  Framing framing{};            ///< in use
  std::uint64_t sent_frames{};  ///< retries included
  std::uint64_t sent_bytes{};
  std::uint64_t retries{};       ///< transmissions of a request after the first
  std::uint64_t timeouts{};      ///< transmissions without a response
  std::uint64_t late_replies{};  ///< responses to requests that had ended
  std::uint64_t unsolicited{};   ///< messages that no request asked for
  std::uint64_t board_errors{};  ///< error messages of the board
  std::uint64_t resets{};        ///< restarts of the board
  std::uint64_t refused{};       ///< requests that send() did not accept
};

/// The bandwidth used by data streams, in bytes per second.
struct StreamUsage {
  std::uint32_t used{};   ///< by all streams
  std::uint32_t limit{};  ///< 0: unlimited
};

/// The result of poll(): write these bytes now, and call poll() again at `deadline` at the latest.
struct Output {
  std::span<const std::uint8_t> bytes{};  ///< a view, valid until the next poll()
  Instant deadline = Instant::never;      ///< when to call poll() again at the latest
};

}  // namespace sbgc
