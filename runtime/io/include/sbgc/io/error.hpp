/// Errors of transports and captures.
#pragma once

#include <cstdint>
#include <string>
#include <system_error>
#include <type_traits>

#include <sbgc/printable.hpp>

namespace sbgc::io {

/// The failures that a caller may want to distinguish. Other errors of the operating system keep
/// their own code. An operation ended by close() has asio::error::operation_aborted.
enum class Errc : std::uint8_t {
  end_of_stream = 1,  ///< the other side has closed, or a replayed capture has ended
  device_lost,        ///< the device is gone, e.g. unplugged
  no_such_port,       ///< there is no device or file of this name
  not_a_port,         ///< it exists, but is not a serial port
  permission_denied,
  busy,            ///< another program uses the port
  line_refused,    ///< the port does not support these line settings
  bad_address,     ///< the address string is malformed
  host_not_found,  ///< the name does not resolve
  refused,         ///< the host answers, but nothing listens there
  unreachable,     ///< there is no route to the host
  timed_out,       ///< nothing answered within the deadline
  not_a_capture,   ///< the file exists, but is not a capture
};

/// The category of Errc; message() is a sentence for the user.
const std::error_category& error_category() noexcept;

/// Makes an std::error_code of an Errc.
inline std::error_code make_error_code(Errc code) noexcept {
  return {static_cast<int>(code), error_category()};
}

/// A failure, or no failure: a code for programs, a message for the user. True in a condition if it
/// is a failure.
struct Error {
  std::error_code code{};  ///< of Errc, or of the operating system
  std::string message{};   ///< ends with a period, names the port or host, may have several lines

  /// True if it is a failure.
  explicit operator bool() const noexcept { return static_cast<bool>(code); }
};

/// Returns the message.
inline std::string to_string(const Error& error) { return error.message; }

}  // namespace sbgc::io

template <>
inline constexpr bool sbgc::is_printable<sbgc::io::Error> = true;

template <>
struct std::is_error_code_enum<sbgc::io::Errc> : std::true_type {};
