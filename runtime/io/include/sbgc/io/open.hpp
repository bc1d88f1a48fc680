/// Addresses of gimbals as text.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/error.hpp>
#include <sbgc/io/line.hpp>
#include <sbgc/io/replay.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// The beginning of an address, and its full syntax. Also used by help and completion.
struct AddressKind {
  const char* name = "";        ///< "tcp"
  const char* syntax = "";      ///< "tcp:HOST:PORT"
  bool leads_to_gimbal = true;  ///< false if it waits for a host
};

/// "/dev/ttyUSB0", "serial:/dev/ttyUSB0?baud=57600&parity=even". A path without "serial:" has a
/// '/'.
struct SerialAddress {
  static constexpr AddressKind kind{"serial", "serial:PATH?baud=NUMBER&parity=none|even"};
  std::string path;
  LineSettings line = default_line;  ///< the default if the address gives no settings
  bool operator==(const SerialAddress&) const = default;
};

/// "tcp:gimbal.local:5000", "tcp:[fe80::1]:5000".
struct TcpAddress {
  static constexpr AddressKind kind{"tcp", "tcp:HOST:PORT"};
  std::string host;
  std::uint16_t port{};
  bool operator==(const TcpAddress&) const = default;
};

/// "udp:192.168.0.7:14550".
struct UdpAddress {
  static constexpr AddressKind kind{"udp", "udp:HOST:PORT"};
  std::string host;
  std::uint16_t port{};
  bool operator==(const UdpAddress&) const = default;
};

/// "pty:", a new pseudo-terminal that stays open; description() contains its path.
struct PtyAddress {
  static constexpr AddressKind kind{"pty", "pty:", false};
  bool operator==(const PtyAddress&) const = default;
};

/// "capture:flight.sbgc", "capture:flight.sbgc?timing=fast" (or timing=original).
struct CaptureAddress {
  static constexpr AddressKind kind{"capture", "capture:FILE"};
  std::string file;
  ReplayTiming timing = ReplayTiming::answers;
  bool operator==(const CaptureAddress&) const = default;
};

/// An address of any kind.
using Address = std::variant<SerialAddress, TcpAddress, UdpAddress, PtyAddress, CaptureAddress>;

/// All kinds of addresses.
inline constexpr auto address_kinds = []<class... Ts>(const std::variant<Ts...>*) {
  return std::array{Ts::kind...};
}(static_cast<const Address*>(nullptr));

/// An address, or the error in its text.
struct AddressResult {
  Address address{};  ///< the address, if there is no error
  Error error{};      ///< Errc::bad_address, with the correct syntax

  /// True if the text is an address.
  explicit operator bool() const noexcept { return !error; }
};

/// Parses an address. Returns Errc::bad_address if it is malformed; the message explains the error
/// and the correct syntax.
AddressResult parse_address(std::string_view text);

/// Options of open().
struct OpenOptions {
  /// The timeout for name lookups and connecting.
  std::chrono::milliseconds timeout = std::chrono::seconds(5);
};

/// Opens the transport at `address`. Blocks for at most options.timeout; never throws.
OpenResult open(const asio::any_io_executor& executor, std::string_view address,
                const OpenOptions& options = {});
OpenResult open(const asio::any_io_executor& executor, const Address& address,
                const OpenOptions& options = {});

/// Continues on an open line: the Transport::native_handle() of another transport, duplicated or
/// received from another process. Takes ownership of `descriptor`, also on failure. The line keeps
/// its settings, and a serial port stays locked as long as any descriptor of it is open. While two
/// transports share a line, only one of them may read.
OpenResult adopt(const asio::any_io_executor& executor, int descriptor);

}  // namespace sbgc::io
