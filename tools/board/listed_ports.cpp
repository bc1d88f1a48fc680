#include "board/listed_ports.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/own_json.hpp>
#include <sbgc/io/internal/own_file.hpp>

namespace sbgc::tools {

namespace {

constexpr std::size_t largest_list = 1 << 20;
/// More than any machine has; all are opened at the same time.
constexpr std::size_t most_ports = 128;
constexpr const char* format_name = "sbgc-ports";
constexpr int format_version = 1;

io::PortList failed(const std::string& reason) {
  return {{}, {std::make_error_code(std::errc::invalid_argument), reason + "."}};
}

/// Throws Json::exception, or std::out_of_range for a number that is not a USB id.
std::uint16_t usb_id(const Json& json) {
  const auto& number = json.get_ref<const Json::number_unsigned_t&>();
  if (number > 0xFFFF) throw std::out_of_range("not a USB id");
  return static_cast<std::uint16_t>(number);
}

io::PortInfo from_json(const Json& port) {
  io::PortInfo result{port.at("name"), port.value("description", ""), std::nullopt};
  if (!port.contains("usb") || port["usb"].is_null()) return result;
  const Json& usb = port["usb"];
  result.usb = io::UsbInfo{usb_id(usb.at("vendor_id")), usb_id(usb.at("product_id")),
                           usb.value("manufacturer", ""), usb.value("product", ""),
                           usb.value("serial_number", "")};
  return result;
}

Json json_of(const io::PortInfo& port) {
  Json result{{"name", port.name}, {"description", port.description}, {"usb", nullptr}};
  if (port.usb) {
    result["usb"] = {{"vendor_id", port.usb->vendor_id},
                     {"product_id", port.usb->product_id},
                     {"manufacturer", port.usb->manufacturer},
                     {"product", port.usb->product},
                     {"serial_number", port.usb->serial_number}};
  }
  return result;
}

io::PortList read_ports(const std::string& name) {
  const Result<std::string> text = detail::read_text_file(name, largest_list);
  if (!text) return failed(text.error().message);
  const Result<Json> parsed =
      detail::parse_own_json(*text, format_name, "a list of ports of `sbgc ports --format json`");
  if (!parsed) return failed(name + ": " + parsed.error().message);
  const std::string unfit = name + ": not a list of ports as `sbgc ports --format json` prints it";
  if (parsed->value("version", Json()) != format_version) return failed(unfit);
  const Json ports = parsed->value("ports", Json());
  if (!ports.is_array()) return failed(unfit);
  if (ports.size() > most_ports) {
    return failed(fmt::format("{}: more than {} ports", name, most_ports));
  }
  io::PortList result;
  try {
    for (const Json& port : ports) result.ports.push_back(from_json(port));
  } catch (const std::exception&) {
    return failed(unfit + fmt::format("; port {} has unexpected values", result.ports.size() + 1));
  }
  return result;
}

}  // namespace

io::PortList listed_ports() {
  const char* const file = std::getenv("SBGC_PORTS");
  return file == nullptr || *file == '\0' ? io::list_ports() : read_ports(file);
}

Json ports_json(const std::vector<io::PortInfo>& ports) {
  Json list = Json::array();
  for (const io::PortInfo& port : ports) list.push_back(json_of(port));
  return {{"format", format_name}, {"version", format_version}, {"ports", std::move(list)}};
}

}  // namespace sbgc::tools
