/// The serial ports of this machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/io/error.hpp>

namespace sbgc::io {

/// The description that a USB device reports; texts it does not report are empty.
struct UsbInfo {
  std::uint16_t vendor_id{};
  std::uint16_t product_id{};
  std::string manufacturer;
  std::string product;
  std::string serial_number;  ///< empty if it has none
};

/// A serial port of the machine.
struct PortInfo {
  std::string name;            ///< for open_serial(): "/dev/ttyUSB0"
  std::string description;     ///< for the user, may be empty
  std::optional<UsbInfo> usb;  ///< only of USB ports
};

/// The serial ports of the machine, or the error that prevented listing them.
struct PortList {
  std::vector<PortInfo> ports;  ///< sorted by name, numbers by value
  Error error;                  ///< if the system cannot list its ports
};

/// Lists the serial ports of the machine.
PortList list_ports();

}  // namespace sbgc::io
