/// Why something could not be done, for programs and for people.
#pragma once

#include <cstdint>
#include <string>

#include <sbgc/printable.hpp>

namespace sbgc {

/// Every way in which an operation of the client can fail.
enum class ErrorCode : std::uint8_t {
  timeout,        ///< no answer, or not in time
  unsupported,    ///< this board or its firmware does not have it
  board_error,    ///< the board has refused; ClientError::detail is its error code
  board_reset,    ///< the board has restarted meanwhile
  link_lost,      ///< the line broke meanwhile: unplugged, closed by the other side
  not_connected,  ///< there is no line any more: closed, or lost earlier
  invalid,        ///< a value, an option or an address is not allowed
  overload,       ///< too much at once: calls in the queue, data streams on a slow line
  cancelled,      ///< by the caller
  io,             ///< the system refused; ClientError::detail is its error number
  not_found,      ///< no board, no such port, file or name
  mismatch,       ///< what was read differs from what was written, or belongs to something else
  bad_answer,     ///< the board sent something that cannot be read
  bad_file,       ///< a file cannot be understood
  incompatible,   ///< made for another board model or firmware
};

/// The name of a code, e.g. "link_lost".
constexpr const char* name(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::timeout: return "timeout";
    case ErrorCode::unsupported: return "unsupported";
    case ErrorCode::board_error: return "board_error";
    case ErrorCode::board_reset: return "board_reset";
    case ErrorCode::link_lost: return "link_lost";
    case ErrorCode::not_connected: return "not_connected";
    case ErrorCode::invalid: return "invalid";
    case ErrorCode::overload: return "overload";
    case ErrorCode::cancelled: return "cancelled";
    case ErrorCode::io: return "io";
    case ErrorCode::not_found: return "not_found";
    case ErrorCode::mismatch: return "mismatch";
    case ErrorCode::bad_answer: return "bad_answer";
    case ErrorCode::bad_file: return "bad_file";
    case ErrorCode::incompatible: return "incompatible";
  }
  return "unknown_error";
}

/// What went wrong. (sbgc::Error is a message of the protocol.)
struct ClientError {
  ErrorCode code{};
  std::string message{};  ///< for people: a sentence without a final stop, maybe several lines
  int detail{};           ///< the number that belongs to some codes, else 0

  bool operator==(const ClientError&) const = default;
};

inline std::string to_string(ErrorCode code) { return name(code); }
/// The message.
inline std::string to_string(const ClientError& error) { return error.message; }

template <>
inline constexpr bool is_printable<ErrorCode> = true;
template <>
inline constexpr bool is_printable<ClientError> = true;

}  // namespace sbgc
