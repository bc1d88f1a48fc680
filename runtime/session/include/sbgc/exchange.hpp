/// What comes back for a request. The facts are the specification's: <sbgc/exchanges/all.hpp>, or
/// one family of it, has `exchange_of(request)` for every message to the board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/frame.hpp>

namespace sbgc {

/// Bytes of an answer that repeat a number of the request: at `offset` of the body stand the `size`
/// lowest bytes of `value`, little-endian. Size 0 demands nothing.
struct Echo {
  std::uint8_t offset{};
  std::uint8_t size{};
  std::uint32_t value{};

  bool operator==(const Echo&) const = default;

  /// Whether the body has these bytes. What a body is too short for counts as there.
  constexpr bool holds(std::span<const std::uint8_t> body) const noexcept {
    if (body.size() < std::size_t{offset} + size) return true;
    for (std::size_t i = 0; i < size; ++i) {
      if (body[offset + i] != byte(i)) return false;
    }
    return true;
  }

  /// Whether no body can have these bytes and the other's.
  constexpr bool excludes(const Echo& other) const noexcept {
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

inline constexpr std::size_t max_echoes = 2;
inline constexpr std::size_t max_answer_forms = 2;

/// One message that answers a request.
struct AnswerForm {
  std::uint8_t id{};
  std::uint8_t min_size{};  ///< of the body
  std::uint8_t max_size{};  ///< of the body; max_body_size when later firmware may lengthen it
  std::uint8_t size{};      ///< of the body, as documented; the largest when it varies
  bool is_error{};          ///< the answer of a request that failed
  std::array<Echo, max_echoes> echoes{};

  bool operator==(const AnswerForm&) const = default;

  /// Whether this frame can be that answer.
  constexpr bool fits(const Frame& frame) const noexcept {
    if (frame.id != id || frame.body.size() < min_size || frame.body.size() > max_size) {
      return false;
    }
    bool holds = true;
    for (const Echo& echo : echoes) holds = holds && echo.holds(frame.body);
    return holds;
  }

  /// Whether some frame can be this answer and the other.
  constexpr bool can_be(const AnswerForm& other) const noexcept {
    if (id != other.id || min_size > other.max_size || other.min_size > max_size) return false;
    for (const Echo& one : echoes) {
      for (const Echo& two : other.echoes) {
        if (one.excludes(two)) return false;
      }
    }
    return true;
  }
};

/// Whether the board confirms a request, from the least likely up. Nobody may rely on what is
/// between never and always.
enum class Confirmed : std::uint8_t { never, unlikely, possible, always };

/// The frames that may come back for a request.
struct Replies {
  std::uint8_t command{};  ///< id of the request
  Confirmed confirmed{};
  std::uint8_t answer_count{};
  std::array<AnswerForm, max_answer_forms> answers{};
  Echo confirmation{};  ///< what the data of a confirmation repeat, if it has any

  bool operator==(const Replies&) const = default;

  /// The answer that this frame can be, or null.
  constexpr const AnswerForm* answer(const Frame& frame) const noexcept {
    for (std::size_t i = 0; i < answer_count; ++i) {
      if (answers[i].fits(frame)) return &answers[i];
    }
    return nullptr;
  }

  /// Whether a confirmation that names `confirmed_command` can belong here.
  constexpr bool is_confirmed_by(std::uint8_t confirmed_command,
                                 const Frame& frame) const noexcept {
    return confirmed != Confirmed::never && confirmed_command == command &&
           confirmation.holds(frame.body);
  }

  /// Whether one frame could belong to this request and to the other. The data of a confirmation
  /// may be missing, so two confirmed requests of one command can not be told apart.
  constexpr bool can_be_confused_with(const Replies& other) const noexcept {
    if (command == other.command && confirmed != Confirmed::never &&
        other.confirmed != Confirmed::never) {
      return true;
    }
    for (std::size_t i = 0; i < answer_count; ++i) {
      for (std::size_t j = 0; j < other.answer_count; ++j) {
        if (answers[i].can_be(other.answers[j])) return true;
      }
    }
    return false;
  }
};

/// The result in the data of a confirmation: its place, and what stands there after success.
struct ConfirmationResult {
  std::uint8_t offset{};
  std::uint8_t size{};  ///< 0: there is none
  std::uint32_t success{};

  /// Whether the confirmation tells of a failure. One without data tells of none.
  constexpr bool is_failure(std::span<const std::uint8_t> body) const noexcept {
    if (size == 0 || body.size() < std::size_t{offset} + size) return false;
    return !Echo{offset, size, success}.holds(body);
  }
};

inline constexpr std::size_t max_stream_config = 8;

/// The data stream that a request starts, changes or ends. Command and config name it.
struct StreamChange {
  std::uint8_t command{};  ///< id of the messages it consists of; 0: the request is about no stream
  std::uint8_t size{};     ///< of their bodies
  std::uint32_t interval_us{};  ///< 0 ends the stream
  std::array<std::uint8_t, max_stream_config> config{};
};

/// All that is known beforehand about how a request ends. Get it from exchange_of().
struct Exchange {
  Replies replies{};
  std::uint8_t confirmations{};  ///< how many come when it is confirmed
  bool answer_required{};        ///< one of the answers comes, unless the request fails
  bool retry_is_safe{};          ///< sending it twice does no more than sending it once
  bool restarts_board{};         ///< the board restarts when it has carried it out
  /// For the answer or the first confirmation. The specification names no times: this and finish_ms
  /// are assumptions.
  std::uint32_t timeout_ms{};
  std::uint32_t finish_ms{};  ///< for the last confirmation, from the request; 0: the same
  ConfirmationResult result{};
  StreamChange stream{};
};

}  // namespace sbgc
