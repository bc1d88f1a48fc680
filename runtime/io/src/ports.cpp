#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <tuple>

#include <libserialport.h>

#include <sbgc/io/ports.hpp>

namespace sbgc::io::detail {
namespace {

/// Orders ttyUSB2 before ttyUSB10: of two numbers, the shorter one is smaller.
bool comes_before(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    return std::tuple(name.substr(0, digits), name.size(), name);
  };
  return key(a) < key(b);
}

}  // namespace
}  // namespace sbgc::io::detail

namespace sbgc::io {

namespace {

std::string text(const char* value) { return value == nullptr ? "" : value; }

PortInfo describe(const sp_port* port) {
  PortInfo result{text(sp_get_port_name(port)), text(sp_get_port_description(port)), std::nullopt};
  if (sp_get_port_transport(port) != SP_TRANSPORT_USB) return result;
  UsbInfo& usb = result.usb.emplace();
  int vendor = 0;
  int product = 0;
  if (sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK) {
    usb.vendor_id = static_cast<std::uint16_t>(vendor);
    usb.product_id = static_cast<std::uint16_t>(product);
  }
  usb.manufacturer = text(sp_get_port_usb_manufacturer(port));
  usb.product = text(sp_get_port_usb_product(port));
  usb.serial_number = text(sp_get_port_usb_serial(port));
  return result;
}

}  // namespace

PortList list_ports() {
  sp_port** list = nullptr;
  if (sp_list_ports(&list) != SP_OK) {
    // Without /sys, as in some containers and chroots, there are no serial ports.
    if (sp_last_error_code() == ENOENT) return {};
    return {{}, {std::make_error_code(std::errc::io_error), "The system cannot list its ports."}};
  }
  const std::unique_ptr<sp_port*, void (*)(sp_port**)> owner(list, sp_free_port_list);
  PortList result;
  for (sp_port** port = list; *port != nullptr; ++port) result.ports.push_back(describe(*port));
  std::ranges::sort(result.ports, detail::comes_before, &PortInfo::name);
  return result;
}

}  // namespace sbgc::io
