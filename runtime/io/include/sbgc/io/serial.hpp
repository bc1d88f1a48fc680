/// Serial ports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/line.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// Opens a serial port exclusively in raw mode, and discards bytes received before. Verifies the
/// settings by reading them back; the transport's line() changes them. If the device is unplugged,
/// operations fail with Errc::device_lost. Does not block.
OpenResult open_serial(const asio::any_io_executor& executor, const std::string& path,
                       const LineSettings& settings = default_line);

/// Continues on a serial port that is open: see adopt().
OpenResult adopt_serial(const asio::any_io_executor& executor, int descriptor);

/// The permissions of a device, for permission_error().
struct DeviceOwner {
  std::string group;            ///< the owning group, e.g. "dialout"
  bool group_may_open = false;  ///< the group may read and write
  bool is_member = false;       ///< the user is in the group, even if this login session is not
};

/// Returns the error for a device that the user may not open, including a remedy.
Error permission_error(const std::string& path, const DeviceOwner& owner);

}  // namespace sbgc::io
