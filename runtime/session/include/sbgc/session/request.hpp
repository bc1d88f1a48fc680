/// One request of a session, from send() to its end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/frame.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

///             send()          poll()               all responses received, or timed out
///     free ----------> queued ------> in_flight ------------------------------------> free
///                                      |     ^
///          the attempt has timed out   v     |   poll()
///                                      resend
///
/// Cancellation, a deadline, a reset of the board and the loss of the link free a request from any
/// state. Responses to a request that was already sent then become late replies.
enum class RequestState : std::uint8_t { free, queued, in_flight, resend };

struct SessionRequest {
  RequestState state{};
  Handle handle{};          // 0 if free
  ResponsePolicy policy{};  // its `stream` is a change that the session has noted, or none
  bool awaits_response{};   // false: completes when it is sent
  std::uint8_t attempts{};  // transmissions left
  std::uint8_t transmissions{};
  std::uint8_t confirmations{};
  std::uint8_t id{};
  std::uint8_t size{};  // of the body
  Duration timeout{};
  Duration finish{};       // timeout of the last confirmation
  Instant sent_at{};       // when the response could have arrived over the line
  Instant confirmed_at{};  // the last confirmation
  Instant attempt_end = Instant::never;
  Instant deadline = Instant::never;
  std::array<std::uint8_t, max_body_size> body{};

  constexpr bool is_open() const noexcept { return state != RequestState::free; }

  /// Returns true if the request has been sent, so that a response can match it.
  constexpr bool is_in_flight() const noexcept { return state >= RequestState::in_flight; }

  /// Queues the request whose body is in `body`. `most_attempts` applies unless the options
  /// override it.
  constexpr void open(Handle new_handle, std::uint8_t command, std::size_t body_size,
                      const ResponsePolicy& new_policy, const SendOptions& options,
                      std::uint8_t most_attempts) noexcept {
    state = RequestState::queued;
    handle = new_handle;
    policy = new_policy;
    const bool is_certain = policy.is_certain();
    const bool may_be_confirmed = policy.responses.confirmed != Confirmed::never;
    awaits_response = is_certain || (options.expect_confirmation && may_be_confirmed);
    if (options.attempts != 0) most_attempts = options.attempts;
    // A merely possible confirmation may be missing, which is no reason to resend.
    attempts = is_certain && policy.retry_is_safe && most_attempts != 0 ? most_attempts : 1;
    transmissions = confirmations = 0;
    id = command;
    size = static_cast<std::uint8_t>(body_size);
    timeout = options.timeout > Duration{} ? options.timeout : milliseconds(policy.timeout_ms);
    finish = milliseconds(policy.finish_ms);
    if (finish < timeout) finish = timeout;
    attempt_end = Instant::never;
    deadline = options.deadline;
  }

  constexpr void close() noexcept {
    state = RequestState::free;
    handle = {};
  }
};

/// The last transmission of a session.
struct Transmission {
  Handle handle{};
  Responses responses{};
  Duration pause{};          // after the frame
  Duration response_time{};  // of the response on the line
  Duration finish{};
};

}  // namespace sbgc::detail
