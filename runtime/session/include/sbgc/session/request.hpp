/// One request of a session, from send() to its end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/frame.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>
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

template <std::size_t body_capacity>
struct SessionRequest {
  RequestState state{};
  bool awaits_response{};   // false: completes when it is sent
  std::uint8_t attempts{};  // transmissions left
  std::uint8_t transmissions{};
  std::uint8_t confirmations{};
  std::uint8_t id{};
  std::uint8_t size{};  // of the body
  std::uint16_t host{};
  Ticks timeout{};
  Ticks finish{};          // timeout of the last confirmation
  Ticks attempt_left{};    // until the attempt times out
  Ticks late_left{};       // until even a late response cannot arrive any more
  Ticks duplicate_left{};  // until the last confirmation cannot arrive again
  Instant deadline{};
  Handle handle{};          // 0 if free
  ResponsePolicy policy{};  // its `stream` is a change that the session has recorded, or none
  std::array<std::uint8_t, body_capacity> body{};

  constexpr bool is_open() const noexcept { return state != RequestState::free; }

  /// Returns true if the request has been sent, so that a response can match it.
  constexpr bool is_in_flight() const noexcept { return state >= RequestState::in_flight; }

  /// Returns true if this request was accepted before the other. Numbers of open requests are
  /// close.
  constexpr bool is_older_than(Handle other) const noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(handle.number) -
                                     static_cast<std::uint32_t>(other.number)) < 0;
  }

  /// Returns true if this request is sent before the other, if both may be sent.
  constexpr bool precedes(const SessionRequest& other) const noexcept {
    if (policy.stops != other.policy.stops) return policy.stops;
    return is_older_than(other.handle);
  }

  /// Returns true if this request gets a response, or an error, that can belong to both: the board
  /// answers in order, but a long operation ends after the next one has begun or was refused.
  constexpr bool is_answered_before(const SessionRequest& other, bool is_error) const noexcept {
    if (confirmations != other.confirmations) return confirmations < other.confirmations;
    return is_older_than(other.handle) != (is_error && policy.is_answered_at_end());
  }

  /// Queues the request whose body and policy are in place. `most_attempts` applies unless the
  /// options override it.
  constexpr void open(Handle new_handle, std::uint8_t command, std::size_t body_size,
                      const SendOptions& options, Ticks response_timeout,
                      std::uint8_t most_attempts) noexcept {
    state = RequestState::queued;
    handle = new_handle;
    const bool is_certain = policy.is_certain();
    const bool may_be_confirmed = policy.responses.confirmed != Confirmed::never;
    awaits_response = is_certain || (options.expect_confirmation && may_be_confirmed);
    if (options.attempts != 0) most_attempts = options.attempts;
    // A merely possible confirmation may be missing, which is no reason to resend.
    const bool is_resent = is_certain || (awaits_response && options.repeat_unconfirmed);
    attempts = is_resent && policy.retry_is_safe && most_attempts != 0 ? most_attempts : 1;
    transmissions = confirmations = 0;
    id = command;
    host = options.host;
    size = static_cast<std::uint8_t>(body_size);
    timeout = response_timeout != 0 ? response_timeout : ticks_of_ms(policy.timeout_ms);
    finish = longer(ticks_of_ms(policy.finish_ms), timeout);
    attempt_left = never;
    late_left = duplicate_left = 0;
    deadline = options.deadline;
  }

  /// Lets time pass.
  constexpr void pass(Ticks elapsed) noexcept {
    detail::pass(attempt_left, elapsed);
    detail::pass(late_left, elapsed);
    detail::pass(duplicate_left, elapsed);
  }

  constexpr void close() noexcept {
    state = RequestState::free;
    handle = {};
  }
};

/// The last transmission of a session.
struct Transmission {
  Handle handle{};
  Ticks pause{};          // after the frame
  Ticks response_time{};  // of the response on the line
  Ticks finish{};
};

}  // namespace sbgc::detail
