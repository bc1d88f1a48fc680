// sbgc ports: lists the serial ports of this machine.

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <sbgc/io/ports.hpp>
#include <sbgc/text/values.hpp>

#include "board/listed_ports.hpp"
#include "command/option_values.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

struct PortsOptions {
  std::string format = "text";
};

void print_text(const io::PortInfo& port) {
  // Text from a device or a file may contain anything.
  fmt::print("{}", printable(port.name));
  if (!port.description.empty()) fmt::print("  {}", detail::quoted(port.description));
  fmt::print("\n");
  if (!port.usb) return;
  const io::UsbInfo& usb = *port.usb;
  fmt::print("    USB {:04x}:{:04x}", usb.vendor_id, usb.product_id);
  const auto add = [](const char* what, const std::string& text) {
    if (!text.empty()) fmt::print(", {} {}", what, detail::quoted(text));
  };
  add("manufacturer", usb.manufacturer);
  add("product", usb.product);
  add("serial number", usb.serial_number);
  fmt::print("\n");
}

int print_ports(const PortsOptions& options) {
  const io::PortList list = listed_ports();
  if (list.error) throw std::runtime_error(list.error.message);
  if (options.format == "json") {
    fmt::print("{}\n", detail::json_text(ports_json(list.ports), 2));
    return success;
  }
  for (const io::PortInfo& port : list.ports) print_text(port);
  if (list.ports.empty()) fmt::print("No serial ports found.\n");
  return success;
}

}  // namespace

void add_ports(CLI::App& app, CommandContext& context) {
  const Subcommand<PortsOptions> command(app, context, "ports",
                                         "List the serial ports of this machine");
  auto& options = command.options();
  add_format(*command, options.format);
  command.examples({"sbgc ports", "sbgc ports --format json"});
  command.runs(print_ports);
}

}  // namespace sbgc::tools
