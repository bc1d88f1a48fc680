// Tests of the list of ports. Its contents depend on the machine, its properties do not.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <sbgc/io/ports.hpp>

#include "port_order.hpp"

namespace sbgc::io {
namespace {

TEST(Ports, AreInTheOrderOfTheirNumbers) {
  const std::vector<std::string> ordered{"/dev/ttyACM0", "/dev/ttyS1",   "/dev/ttyS31",
                                         "/dev/ttyUSB",  "/dev/ttyUSB2", "/dev/ttyUSB10"};
  std::vector<std::string> names(ordered.rbegin(), ordered.rend());
  std::ranges::sort(names, detail::comes_before);
  EXPECT_EQ(names, ordered);
}

TEST(Ports, AreDevicesOfTheSystem) {
  const PortList list = list_ports();
  EXPECT_FALSE(list.error) << list.error.message;
  if (list.ports.empty()) GTEST_SKIP() << "there is none here";
  for (const PortInfo& port : list.ports) {
    EXPECT_TRUE(std::filesystem::is_character_file(port.name)) << port.name;
    EXPECT_TRUE(std::filesystem::exists("/sys/class/tty/" + port.name.substr(5))) << port.name;
  }
}

TEST(Ports, UsbSerialDevicesAreAmongThem) {
  // Every USB adapter known to the kernel must be listed with its ids.
  const PortList list = list_ports();
  bool is_any = false;
  for (const auto& entry : std::filesystem::directory_iterator("/dev")) {
    const std::string name = entry.path();
    if (!name.starts_with("/dev/ttyUSB") && !name.starts_with("/dev/ttyACM")) continue;
    is_any = true;
    const auto found = std::ranges::find(list.ports, name, &PortInfo::name);
    ASSERT_NE(found, list.ports.end()) << name;
    EXPECT_TRUE(found->usb.has_value()) << name;
  }
  if (!is_any) GTEST_SKIP() << "there is none here";
}

}  // namespace
}  // namespace sbgc::io
