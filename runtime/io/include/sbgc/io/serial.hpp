/// Serial ports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/line.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// Opens a serial port for this program alone, transparent for bytes, and discards what has been
/// received before. Settings are verified by reading them back. The transport's line() changes
/// them; a device that goes away is Errc::device_lost. Does not block.
OpenResult open_serial(const asio::any_io_executor& executor, const std::string& path,
                       const LineSettings& settings = default_line);

/// Who may open a device, for permission_error().
struct DeviceOwner {
  std::string group;            ///< the owning group, e.g. "dialout"
  bool group_may_open = false;  ///< the group may read and write
  bool is_member = false;       ///< the user is in the group, although this program may not be yet
};

/// The error for a device that may not be opened, with what to do about it.
Error permission_error(const std::string& path, const DeviceOwner& owner);

}  // namespace sbgc::io
