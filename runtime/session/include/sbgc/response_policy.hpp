/// What comes back for a request. The facts are the specification's: <sbgc/responses/all.hpp>, or
/// the header of one family, has `response_policy(request)` for every message to the board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/frame.hpp>

namespace sbgc {

/// Bytes of a response that repeat a number of the request: the `size` lowest bytes of `value`,
/// little-endian, at `offset` of the body. Size 0 demands nothing.
struct CorrelationField {
  std::uint8_t offset{};
  std::uint8_t size{};
  std::uint32_t value{};

  bool operator==(const CorrelationField&) const = default;

  /// Whether the body has these bytes. A body that is too short to have them counts as well.
  constexpr bool holds(std::span<const std::uint8_t> body) const noexcept {
    if (body.size() < std::size_t{offset} + size) return true;
    for (std::size_t i = 0; i < size; ++i) {
      if (body[offset + i] != byte(i)) return false;
    }
    return true;
  }

  /// Whether no body can have both these bytes and the other's.
  constexpr bool excludes(const CorrelationField& other) const noexcept {
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = offset + i;
      const bool both = at >= other.offset && at < std::size_t{other.offset} + other.size;
      if (both && byte(i) != other.byte(at - other.offset)) return true;
    }
    return false;
  }

 private:
  constexpr std::uint8_t byte(std::size_t index) const noexcept {
    return static_cast<std::uint8_t>(value >> (8 * index));
  }
};

inline constexpr std::size_t max_correlation_fields = 2;
inline constexpr std::size_t max_response_forms = 2;

/// One message that answers a request.
struct ResponseForm {
  std::uint8_t id{};
  std::uint8_t min_size{};  ///< of the body
  std::uint8_t max_size{};  ///< of the body; max_body_size when later firmware may lengthen it
  std::uint8_t size{};      ///< of the body, as documented; the largest when it varies
  bool is_error{};          ///< says that the request has failed
  std::array<CorrelationField, max_correlation_fields> correlation{};

  bool operator==(const ResponseForm&) const = default;

  /// Whether this frame can be that response.
  constexpr bool fits(const Frame& frame) const noexcept {
    if (frame.id != id || frame.body.size() < min_size || frame.body.size() > max_size) {
      return false;
    }
    bool holds = true;
    for (const CorrelationField& field : correlation) holds = holds && field.holds(frame.body);
    return holds;
  }

  /// Whether some frame can be this response and the other.
  constexpr bool can_be(const ResponseForm& other) const noexcept {
    if (id != other.id || min_size > other.max_size || other.min_size > max_size) return false;
    for (const CorrelationField& one : correlation) {
      for (const CorrelationField& two : other.correlation) {
        if (one.excludes(two)) return false;
      }
    }
    return true;
  }
};

/// Whether the board confirms a request, from the least likely up. Only never and always are
/// certain.
enum class Confirmed : std::uint8_t { never, unlikely, possible, always };

/// The frames that may come back for a request: the messages that answer it, and confirmations.
struct Responses {
  std::uint8_t command{};  ///< id of the request
  Confirmed confirmed{};
  std::uint8_t form_count{};
  std::array<ResponseForm, max_response_forms> forms{};
  CorrelationField confirmation{};  ///< what the data of a confirmation repeat, if it has any

  bool operator==(const Responses&) const = default;

  /// The form of this frame if it can be a message that answers, else null.
  constexpr const ResponseForm* form_of(const Frame& frame) const noexcept {
    for (std::size_t i = 0; i < form_count; ++i) {
      if (forms[i].fits(frame)) return &forms[i];
    }
    return nullptr;
  }

  /// Whether anything may come back.
  constexpr bool are_possible() const noexcept {
    return form_count != 0 || confirmed != Confirmed::never;
  }

  /// Whether a confirmation that names `confirmed_command` can belong to the request.
  constexpr bool is_confirmed_by(std::uint8_t confirmed_command,
                                 const Frame& frame) const noexcept {
    return confirmed != Confirmed::never && confirmed_command == command &&
           confirmation.holds(frame.body);
  }

  /// Whether one frame could belong to this request and to the other. The data of a confirmation
  /// may be missing, so two confirmed requests of one command cannot be told apart.
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

/// Where the data of a confirmation have the result of the request, and its value after success.
struct ConfirmationResult {
  std::uint8_t offset{};
  std::uint8_t size{};  ///< 0: there is none
  std::uint32_t success{};

  /// Whether the confirmation reports a failure. One without data does not.
  constexpr bool is_failure(std::span<const std::uint8_t> body) const noexcept {
    if (size == 0 || body.size() < std::size_t{offset} + size) return false;
    return !CorrelationField{offset, size, success}.holds(body);
  }
};

inline constexpr std::size_t max_stream_config = 8;

/// The data stream that a request starts, changes or ends. Command and config identify it.
struct StreamChange {
  std::uint8_t command{};       ///< id of its messages; 0: the request is not about a stream
  std::uint8_t size{};          ///< of their bodies
  std::uint32_t interval_us{};  ///< 0 ends the stream
  std::array<std::uint8_t, max_stream_config> config{};
};

/// All that is known beforehand about how a request ends. Get it from response_policy().
struct ResponsePolicy {
  Responses responses{};
  std::uint8_t confirmations{};  ///< how many come when it is confirmed
  bool response_required{};      ///< a message answers, unless the request fails
  bool retry_is_safe{};          ///< sending it twice does no more than sending it once
  bool restarts_board{};         ///< the board restarts when it has carried it out
  /// For the message that answers, or the first confirmation. The specification names no times:
  /// this and finish_ms are assumptions.
  std::uint32_t timeout_ms{};
  std::uint32_t finish_ms{};  ///< for the last confirmation, from the request; 0: the same
  ConfirmationResult result{};
  StreamChange stream{};

  /// Whether something comes back unless it is lost or the request fails.
  constexpr bool is_certain() const noexcept {
    return response_required || responses.confirmed == Confirmed::always;
  }
};

}  // namespace sbgc
