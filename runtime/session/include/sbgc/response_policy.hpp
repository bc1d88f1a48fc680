/// Response policies of requests. They are generated from the specification:
/// <sbgc/responses/all.hpp>, or the header of one family, defines `response_policy(request)` for
/// every message to the board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>

namespace sbgc {

/// Bytes of a response that repeat a number of the request: the `size` lowest bytes of `value`,
/// little-endian, at `offset` in the body. With size 0, every body matches.
struct CorrelationField {
  std::uint8_t offset{};   ///< in the body of the response
  std::uint8_t size{};     ///< in bytes
  std::uint16_t unused{};  ///< instead of padding, see Responses
  std::uint32_t value{};   ///< its lowest bytes must be there

  bool operator==(const CorrelationField&) const = default;

  /// Returns true if the body has these bytes, or is too short to contain them.
  constexpr bool holds(std::span<const std::uint8_t> body) const noexcept {
    if (body.size() < std::size_t{offset} + size) return true;
    for (std::size_t i = 0; i < size; ++i) {
      if (body[offset + i] != byte(i)) return false;
    }
    return true;
  }

  /// Returns true if no body can have both these bytes and those of `other`. Only compares fields
  /// at the same position.
  constexpr bool excludes(const CorrelationField& other) const noexcept {
    return size != 0 && offset == other.offset && size == other.size && value != other.value;
  }

 private:
  constexpr std::uint8_t byte(std::size_t index) const noexcept {
    return static_cast<std::uint8_t>(value >> (8 * index));
  }
};

/// The maximum number of fields that distinguish a response from those of other requests.
inline constexpr std::size_t max_correlation_fields = 2;
/// The maximum number of message types that may answer one request.
inline constexpr std::size_t max_response_forms = 2;

/// A message that answers a request.
struct ResponseForm {
  std::uint8_t id{};        ///< of the response
  std::uint8_t min_size{};  ///< of the body
  std::uint8_t max_size{};  ///< of the body; max_body_size if later firmware may extend it
  std::uint8_t size{};      ///< of the body, as documented; the largest if it varies
  bool is_error{};          ///< reports that the request has failed
  std::array<std::uint8_t, 3> unused{};  ///< instead of padding
  /// The values of the request that the response repeats.
  std::array<CorrelationField, max_correlation_fields> correlation{};

  bool operator==(const ResponseForm&) const = default;

  /// Returns true if the frame can be this response; with `any_size`, even if its body has a wrong
  /// size, so that it does not decode.
  constexpr bool fits(const Frame& frame, bool any_size) const noexcept {
    if (frame.id != id) return false;
    const std::size_t body = frame.body.size();
    if (!any_size && (body < min_size || body > max_size)) return false;
    bool holds = true;
    for (const CorrelationField& field : correlation) holds = holds && field.holds(frame.body);
    return holds;
  }

  /// Returns true if a frame can be both this response and `other`, unless fields in the same
  /// places differ.
  constexpr bool can_be(const ResponseForm& other) const noexcept {
    if (id != other.id || min_size > other.max_size || other.min_size > max_size) return false;
    for (std::size_t i = 0; i < correlation.size(); ++i) {
      if (correlation[i].excludes(other.correlation[i])) return false;
    }
    return true;
  }
};

/// The likelihood that the board confirms a request, in ascending order. Only `never` and `always`
/// are certain.
enum class Confirmed : std::uint8_t { never, unlikely, possible, always };

/// The possible responses to a request: messages and confirmations.
struct Responses {
  std::uint8_t command{};  ///< id of the request
  Confirmed confirmed{};   ///< whether the board confirms the request
  std::uint8_t form_count{};
  std::uint8_t unused{};                                 ///< instead of padding
  std::array<ResponseForm, max_response_forms> forms{};  ///< the messages that may answer
  CorrelationField confirmation{};  ///< the correlation field of a confirmation with data

  /// Compares the bytes, which takes little code. There is no padding among them.
  friend bool operator==(const Responses& a, const Responses& b) noexcept {
    static_assert(std::has_unique_object_representations_v<Responses>);
    return detail::is_same_memory(&a, &b, sizeof a);
  }

  /// Returns the form that the frame matches, or null. With `any_size`, a body of a wrong size
  /// matches the first form.
  constexpr const ResponseForm* form_of(const Frame& frame, bool any_size = false) const noexcept {
    for (std::size_t i = form_count; i-- > 0;) {
      if (forms[i].fits(frame, any_size && i == 0)) return &forms[i];
    }
    return nullptr;
  }

  /// Returns true if any response is possible.
  constexpr bool are_possible() const noexcept {
    return form_count != 0 || confirmed != Confirmed::never;
  }

  /// Returns true if a confirmation of `confirmed_command` can be for this request.
  constexpr bool is_confirmed_by(std::uint8_t confirmed_command,
                                 const Frame& frame) const noexcept {
    return confirmed != Confirmed::never && confirmed_command == command &&
           confirmation.holds(frame.body);
  }

  /// Returns true if a frame could be a response to both this request and the other. The data of a
  /// confirmation may be missing, so two confirmed requests of one command cannot be distinguished.
  constexpr bool can_be_confused_with(const Responses& other) const noexcept {
    if (command == other.command && confirmed != Confirmed::never &&
        other.confirmed != Confirmed::never) {
      return true;
    }
    for (std::size_t i = 0; i < form_count; ++i) {
      for (std::size_t j = 0; j < other.form_count; ++j) {
        if (forms[i].can_be(other.forms[j])) return true;
      }
    }
    return false;
  }
};

/// The position of the request's result in the data of a confirmation, and the value that means
/// success.
struct ConfirmationResult {
  std::uint8_t offset{};    ///< in the data of the confirmation
  std::uint8_t size{};      ///< 0: there is none
  std::uint32_t success{};  ///< the value that means success

  /// Returns true if the confirmation reports a failure. One without data does not.
  constexpr bool is_failure(std::span<const std::uint8_t> body) const noexcept {
    return !field().holds(body);
  }

  /// The bytes of a confirmation that reports success.
  constexpr CorrelationField field() const noexcept {
    return {.offset = offset, .size = size, .value = success};
  }
};

/// The maximum number of bytes in a request that distinguish a data stream from others.
inline constexpr std::size_t max_stream_config = 8;

/// The start, change or end of a data stream. `command` and `config` identify the stream; for a
/// request without an effect, the stream whose samples look like its answer.
struct StreamChange {
  std::uint8_t command{};       ///< id of its messages; 0: the request concerns no stream
  std::uint8_t size{};          ///< of their bodies
  std::uint32_t interval_us{};  ///< 0 ends the stream
  std::array<std::uint8_t, max_stream_config> config{};  ///< its bytes in the request
};

/// The response policy of a request. Get it from response_policy().
struct ResponsePolicy {
  Responses responses{};         ///< the possible responses
  std::uint8_t confirmations{};  ///< number of confirmations of a confirmed request
  bool response_required{};      ///< a message answers, unless the request fails
  bool retry_is_safe{};          ///< sending it twice has the same effect as sending it once
  bool restarts_board{};         ///< the board restarts after executing it
  bool has_effect{};             ///< it sets, stores, moves, restarts or erases something
  bool moves{};                  ///< the camera or the motors can move, now or after a restart
  bool stops{};                  ///< it stops all motion
  std::uint8_t series{};         ///< id of messages that precede the response; 0: none do
  /// The timeout of the response message or the first confirmation; with a series, the longest
  /// silence of the board until the response. The values of this and of finish_ms are assumptions;
  /// the specification states no times.
  std::uint32_t timeout_ms{};
  /// The timeout of the last confirmation, or of the response after a series; 0: the same.
  std::uint32_t finish_ms{};
  ConfirmationResult result{};  ///< a result that its confirmation holds
  StreamChange stream{};        ///< a data stream that it starts, changes or ends

  /// Returns true if this request must not follow a later one, of any host. A stop is never
  /// superseded: speed 0 is weaker than motors off.
  constexpr bool is_superseded_by(const ResponsePolicy& later) const noexcept {
    return moves && !stops && later.stops;
  }

  /// Returns true if it starts, changes or ends `stream`.
  constexpr bool changes_stream() const noexcept { return stream.command != 0 && has_effect; }

  /// Returns true if the response arrives only when a long operation is done. Meanwhile, the board
  /// answers other requests, and refuses another one of this kind at once.
  constexpr bool is_answered_at_end() const noexcept { return timeout_ms > 5000; }

  /// Returns true if a response arrives unless it is lost or the request fails.
  constexpr bool is_certain() const noexcept {
    return response_required || responses.confirmed == Confirmed::always;
  }
};

}  // namespace sbgc
