/// The USB adapter behind a serial address, which may get another name when it is plugged in again.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <sbgc/client/result.hpp>
#include <sbgc/io/ports.hpp>

namespace sbgc::detail {

class Adapter {
 public:
  using ListPorts = std::function<io::PortList()>;

  /// `address` is an address of any kind; only a serial port can be an adapter.
  Adapter(std::string address, ListPorts list_ports);

  /// Notes the identity of the adapter, which is plugged in now.
  void remember();

  /// Returns the address at which the adapter is plugged in now, or that it is not. Without a known
  /// identity, this is the address it had before.
  ///
  /// Adapters are told apart by vendor, product and serial number. Several that look the same are
  /// an error, unless `is_board_known`: then the one with the name it had before is taken, because
  /// the board will tell.
  Result<std::string> find(bool is_board_known) const;

  /// Notes that the adapter is at this address now.
  void move_to(std::string address) { address_ = std::move(address); }

 private:
  std::string path() const;
  io::PortList list() const;

  std::string address_;
  ListPorts list_ports_;
  std::optional<io::UsbInfo> identity_;
};

}  // namespace sbgc::detail
