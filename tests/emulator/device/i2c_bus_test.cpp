// Tests of I2C buses: measurements in the registers of devices.

#include "device/peripherals/i2c_bus.hpp"

#include <cstdint>
#include <vector>

#include "host.hpp"

namespace sbgc::test {
namespace {

using emulator::I2cBus;

std::vector<std::uint8_t> read(Host& host, std::uint8_t address, std::uint8_t reg,
                               std::uint8_t size) {
  msg::I2cReadRegBufRequest request{.reg_addr = reg, .data_len = msg::SmallByteCount(size)};
  EXPECT_TRUE(request.device_addr.set_address(address));
  EXPECT_TRUE(request.device_addr.set_port(msg::I2cPort::main));
  const auto answer = host.get<msg::I2cReadRegBuf>(request);
  return {answer.data.begin(), answer.data.end()};
}

double word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] << 8 | bytes[at + 1]);
}

TEST(I2c, AnImuMeasures) {
  emulator::BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  const auto level = read(host, I2cBus::main_imu, 0x3B, 14);
  EXPECT_NEAR(word(level, 4) / 2048, 1, 0.02);
  EXPECT_NEAR(word(level, 6) / 340 + 36.53, host.board.gimbal().sample(host.now).temperature, 1);
  host.board.gimbal().place({0, 90, 0}, host.now);
  EXPECT_NEAR(word(read(host, I2cBus::main_imu, 0x3B, 6), 4) / 2048, 0, 0.05);
}

TEST(I2c, AddressesBeginAgain) {
  Host host;
  const auto all = read(host, I2cBus::magnetometer, 10, 255);
  ASSERT_EQ(all.size(), 255U);
  EXPECT_EQ(all[0], 'H');
  EXPECT_EQ(all[13], 'H');
}

}  // namespace
}  // namespace sbgc::test
