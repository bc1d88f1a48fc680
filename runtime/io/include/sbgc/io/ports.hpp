/// The serial ports of this machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/io/error.hpp>

namespace sbgc::io {

/// What a USB device says about itself; texts are empty if it says nothing.
struct UsbInfo {
  std::uint16_t vendor_id{};
  std::uint16_t product_id{};
  std::string manufacturer;
  std::string product;
  std::string serial_number;
};

struct PortInfo {
  std::string name;            ///< what open_serial() takes: "/dev/ttyUSB0"
  std::string description;     ///< for people, may be empty
  std::optional<UsbInfo> usb;  ///< only of ports behind USB
};

struct PortList {
  std::vector<PortInfo> ports;  ///< sorted by name, numbers by value
  Error error;                  ///< if the system does not tell
};

PortList list_ports();

}  // namespace sbgc::io
