// The list of ports. Which there are depends on the machine; what holds of each does not.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include <sbgc/io/ports.hpp>

namespace sbgc::io {
namespace {

TEST(Ports, AreDevicesOfTheSystem) {
  const PortList list = list_ports();
  EXPECT_FALSE(list.error) << list.error.message;
  for (const PortInfo& port : list.ports) {
    EXPECT_TRUE(std::filesystem::is_character_file(port.name)) << port.name;
    EXPECT_TRUE(std::filesystem::exists("/sys/class/tty/" + port.name.substr(5))) << port.name;
  }
}

TEST(Ports, UsbSerialDevicesAreAmongThem) {
  // What the kernel has for USB adapters must be found, with its ids.
  const PortList list = list_ports();
  for (const auto& entry : std::filesystem::directory_iterator("/dev")) {
    const std::string name = entry.path();
    if (!name.starts_with("/dev/ttyUSB") && !name.starts_with("/dev/ttyACM")) continue;
    const auto found = std::ranges::find(list.ports, name, &PortInfo::name);
    ASSERT_NE(found, list.ports.end()) << name;
    EXPECT_TRUE(found->usb.has_value()) << name;
  }
}

}  // namespace
}  // namespace sbgc::io
