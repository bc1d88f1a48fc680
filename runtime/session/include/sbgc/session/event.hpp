/// What a session is told and what it reports.
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

/// Stands for one request of a session, from send() to its `completed` event. Never used again.
struct Handle {
  std::uint64_t number{};  ///< 0: no request; later ones have greater numbers

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  constexpr auto operator<=>(const Handle&) const = default;
  constexpr explicit operator bool() const noexcept { return number != 0; }
};

/// How a request ended.
enum class Outcome : std::uint8_t {
  none,         ///< not yet: the event completes nothing
  answered,     ///< the answer is in the event
  confirmed,    ///< every confirmation has come; the last one is in the event
  sent,         ///< written; the board need not say anything
  unconfirmed,  ///< written; the confirmation that was hoped for has not come
  failed,       ///< the board answered or confirmed that it failed; see the event's frame
  board_error,  ///< the board reported an error instead; see the event's frame
  timeout,      ///< nothing came in time, after all attempts; or the request's own deadline passed
  reset,        ///< the board announced a restart first
  cancelled,    ///< by cancel()
  link_lost,    ///< by abandon()
};

/// What happened.
enum class EventKind : std::uint8_t {
  completed,     ///< a request is over: once for every request that send() took
  confirmation,  ///< a confirmation; for a request with `handle`, the last one just before it
                 ///< completes
  board_error,   ///< an error that cannot be assigned to a request
  stream,        ///< a sample of a data stream that this session has started
  unsolicited,   ///< any other message that no request waits for
  reset,         ///< the board is about to restart; the requests complete right after
};

/// One thing that happened. `frame` is a view, valid during the call.
struct Event {
  EventKind kind{};
  Handle handle{};              ///< the request it is about, if any
  Outcome outcome{};            ///< of `completed`
  std::uint8_t command{};       ///< id of the request's command, or of the one that the board names
  std::uint8_t confirmation{};  ///< of `confirmation`: which one it is, from 1
  std::uint8_t confirmations{};  ///< of `confirmation`: how many there will be
  bool is_late{};                ///< it belongs to a request that is over
  bool may_be_sample{};          ///< of `completed`: a stream of the same message is running, too
  Frame frame{};                 ///< what the board said; id 0 if nothing
};

/// Whether send() took a request.
enum class SendStatus : std::uint8_t {
  ok,
  queue_full,        ///< there are as many requests as the session can hold
  not_encodable,     ///< see the result's `encoding`
  over_budget,       ///< the data stream would take too much of the line
  too_many_streams,  ///< the board, or the session, has no room for another data stream
};

/// What send() reports: a handle if the status is ok.
struct SendResult {
  Handle handle{};
  SendStatus status{};
  Status encoding{};  ///< why it was not_encodable

  constexpr explicit operator bool() const noexcept { return status == SendStatus::ok; }
};

/// How one request is to be treated.
struct SendOptions {
  /// Wait for a confirmation that need not come: `confirmed` or `unconfirmed` instead of `sent`.
  bool expect_confirmation = false;
  bool ignore_budget = false;         ///< start a data stream whatever it takes of the line
  std::uint8_t attempts = 0;          ///< most transmissions, if a retry is safe; 0: as the session
  Duration timeout{};                 ///< of each transmission; 0: as the specification says
  Instant deadline = Instant::never;  ///< completes with `timeout` at this moment, sent or not
};

/// The pause after each command, so that the board's input buffer does not overflow.
struct PacingOptions {
  Duration shortest = milliseconds(shortest_pause_ms);  ///< after a small request and response
  Duration longest = milliseconds(longest_pause_ms);    ///< after the largest
};

/// How a session works. The defaults are right for a serial line whose speed is not known.
struct SessionOptions {
  LineSettings line{};                ///< what sending and receiving take; 0 baud: no time
  PacingOptions pacing{};             ///< both 0: none
  std::uint8_t attempts = 3;          ///< most transmissions of a request whose retry is safe
  Duration late = milliseconds(500);  ///< how late a response may still come
  Duration duplicates{};              ///< how long a frame may come again (UDP); 0: never
  Duration idle = milliseconds(100);  ///< silence that ends an incomplete frame
  std::uint8_t stream_percent = 80;   ///< of the line, that data streams may take
};

/// Counts since the construction of a session.
struct SessionStatistics {
  ParserCounters parser{};      ///< frames and noise received
  std::uint64_t sent_frames{};  ///< retries included
  std::uint64_t sent_bytes{};
  std::uint64_t retries{};
  std::uint64_t timeouts{};      ///< transmissions without a response
  std::uint64_t late_replies{};  ///< responses to requests that were over
  std::uint64_t unsolicited{};
  std::uint64_t board_errors{};
  std::uint64_t resets{};
  std::uint64_t refused{};  ///< requests that send() did not take
};

/// How much of the line the data streams take, in bytes a second.
struct StreamUsage {
  std::uint32_t used{};
  std::uint32_t limit{};  ///< 0: not limited
};

/// What poll() wants: these bytes written now, and the next call at `deadline` at the latest.
struct Output {
  std::span<const std::uint8_t> bytes{};  ///< a view, valid until the next poll()
  Instant deadline = Instant::never;
};

}  // namespace sbgc
