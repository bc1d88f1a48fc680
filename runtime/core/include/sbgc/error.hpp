/// Errors of the client, with a code for programs and a message for people.
#pragma once

#include <cstdint>
#include <string>

#include <sbgc/printable.hpp>

namespace sbgc {

/// The reasons why an operation of the client can fail.
enum class ErrorCode : std::uint8_t {
  timeout,        ///< no response, or not in time
  unsupported,    ///< not supported by this board or its firmware
  board_error,    ///< the board refused; ClientError::detail is its error code
  board_reset,    ///< the board restarted during the operation
  link_lost,      ///< the line broke during the operation: unplugged, or closed by the peer
  not_connected,  ///< the line is closed, or was lost earlier
  invalid,        ///< a value, an option or an address is not allowed
  overload,       ///< too many calls in the queue, or too many data streams for the line
  cancelled,      ///< cancelled by the caller
  io,             ///< the operating system refused; ClientError::detail is its error number
  not_found,      ///< no such board, port, file or name; for a port, ClientError::detail is ENOENT
  mismatch,       ///< the data read differ from the data written, or have another origin
  bad_response,   ///< the response of the board is unexpected or cannot be decoded
  bad_file,       ///< the content of a file is invalid
  incompatible,   ///< made for another board model or firmware
  superseded,     ///< replaced by a later motion or stop of the same client
  interrupted,    ///< another program, RC or a limit ended the motion
  unconfirmed,    ///< it was sent, but not confirmed: the board may or may not have executed it
};

/// The name of a code, such as "link_lost".
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
    case ErrorCode::bad_response: return "bad_response";
    case ErrorCode::bad_file: return "bad_file";
    case ErrorCode::incompatible: return "incompatible";
    case ErrorCode::superseded: return "superseded";
    case ErrorCode::interrupted: return "interrupted";
    case ErrorCode::unconfirmed: return "unconfirmed";
  }
  return "unknown_error";
}

/// True if a motion has ended because something else controls the camera now. Its owner must send
/// nothing more: neither a stop nor a way back.
constexpr bool is_in_other_hands(ErrorCode code) noexcept {
  return code == ErrorCode::superseded || code == ErrorCode::interrupted;
}

/// An error of the client. (sbgc::Error is a message of the protocol.)
struct ClientError {
  ErrorCode code{};       ///< for programs
  std::string message{};  ///< for people: a sentence without a final period, possibly several lines
  int detail{};           ///< the number that some codes carry, otherwise 0

  bool operator==(const ClientError&) const = default;
};

/// Returns the name of the code.
inline std::string to_string(ErrorCode code) { return name(code); }
/// Returns the message.
inline std::string to_string(const ClientError& error) { return error.message; }

template <>
inline constexpr bool is_printable<ErrorCode> = true;
template <>
inline constexpr bool is_printable<ClientError> = true;

}  // namespace sbgc
