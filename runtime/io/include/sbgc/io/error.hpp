/// What can go wrong between this program and a gimbal's bytes.
#pragma once

#include <cstdint>
#include <string>
#include <system_error>
#include <type_traits>

#include <sbgc/printable.hpp>

namespace sbgc::io {

/// The failures a caller may want to tell apart. Whatever else the operating system reports keeps
/// its own code. An operation that is ended by close() has asio::error::operation_aborted.
enum class Errc : std::uint8_t {
  end_of_stream = 1,  ///< the other side has closed, or a replayed capture is over
  device_lost,        ///< the device is gone, e.g. unplugged
  no_such_port,       ///< there is no device or file of this name
  not_a_port,         ///< it exists, but is no serial port
  permission_denied,
  busy,            ///< another program has the port
  line_refused,    ///< the port does not take these line settings
  bad_address,     ///< the address string is malformed
  host_not_found,  ///< the name does not resolve
  refused,         ///< the host answers, but nothing listens there
  unreachable,     ///< there is no way to the host
  timed_out,       ///< nothing answered within the deadline
  not_a_capture,   ///< the file is there, but no capture
};

/// The category of Errc; message() is a sentence for people.
const std::error_category& error_category() noexcept;

inline std::error_code make_error_code(Errc code) noexcept {
  return {static_cast<int>(code), error_category()};
}

/// A failure: a code for programs, a sentence or more for people. True in a condition if it is one.
struct Error {
  std::error_code code{};
  std::string message{};  ///< ends with a full stop, names the port or host, may have several lines

  explicit operator bool() const noexcept { return static_cast<bool>(code); }
};

/// The message.
inline std::string to_string(const Error& error) { return error.message; }

}  // namespace sbgc::io

template <>
inline constexpr bool sbgc::is_printable<sbgc::io::Error> = true;

template <>
struct std::is_error_code_enum<sbgc::io::Errc> : std::true_type {};
