// Tests of devices on the I2C bus of the board, and of the correction of gyroscopes.

#include "device/peripherals/i2c_bus.hpp"
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
  Host host({.gimbal = {.noise = 0}});
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

TEST(GyroCorrection, IsRemembered) {
  Host host;
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::frame};
  request.gyro_zero_corr = {msg::GyroOffset(100), msg::GyroOffset(0), msg::GyroOffset(-200)};
  EXPECT_TRUE(is_confirmed(host, request));
  const auto& kept = host.board.memory().imus;
  EXPECT_GT(kept[1].gyro_offset.x, 0);
  EXPECT_NEAR(kept[1].gyro_offset.z, -2 * kept[1].gyro_offset.x, 1e-9);
  EXPECT_EQ(kept[0].gyro_offset, emulator::Vector{});
}

}  // namespace
}  // namespace sbgc::test
