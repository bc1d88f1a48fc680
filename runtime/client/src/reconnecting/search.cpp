#include "reconnecting/search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <sbgc/io/internal/real_path.hpp>
#include <sbgc/io/open.hpp>

namespace sbgc::detail {

namespace {

bool is_same(const io::UsbInfo& one, const io::UsbInfo& other) {
  return one.vendor_id == other.vendor_id && one.product_id == other.product_id &&
         one.serial_number == other.serial_number;
}

}  // namespace

Adapter::Adapter(std::string address, ListPorts list_ports)
    : address_(std::move(address)), list_ports_(std::move(list_ports)) {}

/// Returns the path of the serial port; "" if the address is not one.
std::string Adapter::path() const {
  const io::AddressResult parsed = io::parse_address(address_);
  const auto* const serial = std::get_if<io::SerialAddress>(&parsed.address);
  return parsed && serial != nullptr ? serial->path : std::string();
}

io::PortList Adapter::list() const { return list_ports_ ? list_ports_() : io::PortList{}; }

void Adapter::remember() {
  const std::string path = this->path();
  if (path.empty()) return;
  const std::string real = io::detail::real_path(path);
  for (const io::PortInfo& port : list().ports) {
    if (port.name == path || port.name == real) identity_ = port.usb;
  }
}

Result<std::string> Adapter::find(bool is_board_known) const {
  if (!identity_) return address_;
  const std::string path = this->path();
  const io::PortList list = this->list();
  if (list.error) return address_;
  std::vector<std::string> matches;
  for (const io::PortInfo& port : list.ports) {
    if (port.usb && is_same(*port.usb, *identity_)) matches.push_back(port.name);
  }
  if (matches.empty()) {
    return ClientError{ErrorCode::not_found, "the adapter of " + path + " is not plugged in"};
  }
  const auto before = std::ranges::find(matches, io::detail::real_path(path));
  const bool is_certain = matches.size() == 1;
  if (!is_certain && (!is_board_known || before == matches.end())) {
    return ClientError{ErrorCode::not_found,
                       std::to_string(matches.size()) + " adapters look like that of " + path};
  }
  std::string address = address_;
  const std::string& name = is_certain ? matches.front() : *before;
  // The parsed path is a part of the address.
  return address.replace(address.find(path), path.size(), name);
}

}  // namespace sbgc::detail
