// Tests of devices at the board: on I2C buses and on the CAN bus; of the correction of gyroscopes;
// of copies for debugging.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

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

using emulator::BoardOptions;

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

TEST(GyroCorrection, IsInForceWhenTheBoardIsSwitchedOn) {
  BoardOptions options;
  options.gimbal.noise = 0;
  emulator::Memory memory;
  memory.imus[0].gyro_offset = {0, 0, 0.5};
  Host plain(options), corrected(options, memory);
  for (Host* host : {&plain, &corrected}) host->listen(seconds(60));
  EXPECT_GT(std::abs(plain.board.gimbal().sample(plain.now).joints.yaw -
                     corrected.board.gimbal().sample(corrected.now).joints.yaw),
            1);
}

/// Returns the gyroscope's reading for a camera at rest: with motors on, it would turn so that this
/// is 0.
double still(Host& host) {
  host.ask(msg::MotorsOff{}, seconds(2));
  return host.board.gimbal().sample(host.now).gyro.z;
}

TEST(GyroCorrection, IsForgottenWithTheCalibrations) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::main};
  request.gyro_zero_corr.z = msg::GyroOffset(4000);
  host.ask(request);
  EXPECT_LT(still(host), -0.1);
  host.ask(msg::CalibGyroExt{.imu_idx = msg::CalibImu::main, .action = msg::CalibAction::reset});
  host.listen(seconds(3));
  EXPECT_EQ(host.board.memory().imus[0].gyro_offset, emulator::Vector{});
  EXPECT_NEAR(still(host), 0, 0.1);
}

TEST(GyroCorrection, OfTheSensorIsInForceWhenItIsCopied) {
  BoardOptions options;
  options.gimbal.noise = 0;
  emulator::Memory memory;
  memory.sensors[0].gyro_offset = {0, 0, 0.5};
  Host host(options, memory);
  host.ask(msg::CalibGyroExt{.imu_idx = msg::CalibImu::main,
                             .action = msg::CalibAction::restore_factory});
  host.listen(seconds(1));
  EXPECT_LT(still(host), -0.3);
}

TEST(GyroCorrection, ACalibrationAtTheStartReplacesIt) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::main};
  request.gyro_zero_corr.z = msg::GyroOffset(4000);
  host.ask(request);
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.skip_gyro_calib = msg::SkipGyroCalibration::do_not_skip;
  host.ask(msg::WriteParams3{parameters});
  host.ask(msg::ResetRequest{}, seconds(1));
  EXPECT_EQ(host.board.memory().imus[0].gyro_offset, emulator::Vector{});
  host.ask(msg::WriteParams3{parameters});
  EXPECT_NEAR(still(host), 0, 0.1);
}

TEST(Modules, IntroduceThemselvesThroughTheBoard) {
  Host host(newest_board());
  std::array<std::uint8_t, max_frame_size> frame{};
  const auto size = encode_frame(msg::BoardInfoRequest{}, frame).size;
  msg::TransparentSapiRequest request;
  static_cast<void>(request.target.set_device(msg::TransparentDevice::can_imu_main));
  for (std::size_t i = 0; i < size; ++i) request.payload.push_back(frame[i]);
  const auto answer = host.get<msg::TransparentSapi>(request);
  EXPECT_EQ(answer.target, request.target);
  Parser parser;
  unsigned introductions = 0;
  parser.feed(std::span(answer.payload.data(), answer.payload.size()), [&](const Frame& inner) {
    msg::BoardInfo info;
    if (inner.id == 86 && decode(inner.body, info)) ++introductions;
  });
  EXPECT_EQ(introductions, 1U);
  static_cast<void>(request.target.set_device(msg::TransparentDevice::can_serial_hub2));
  EXPECT_THAT(host.ask(request), IsEmpty()) << "there is no such device";
}

TEST(DebugCopies, OfEachOtherDoNotRunAway) {
  Host host(newest_board());
  const msg::SetDebugPortRequest start{.action = msg::DebugPortAction::start};
  host.ask(start);
  const auto first = host.port;
  host.port = host.board.open_port().value();
  host.ask(start);
  host.ask(msg::MotorsOn{});
  const auto sent = host.board.counters().sent;
  host.listen(seconds(1));
  EXPECT_EQ(host.board.counters().sent, sent);
  host.port = first;
  EXPECT_FALSE(all<msg::SetDebugPort>(host.listen(milliseconds(10))).empty());
}

}  // namespace
}  // namespace sbgc::test
