// Tests of I2C buses: which devices respond, and their registers.

#include "device/peripherals/i2c_bus.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;
using emulator::I2cBus;

msg::I2cDevice device(std::uint8_t address, msg::I2cPort port = msg::I2cPort::main) {
  msg::I2cDevice result;
  EXPECT_TRUE(result.set_address(address) && result.set_port(port));
  return result;
}

msg::I2cReadRegBufRequest reading(msg::I2cDevice from, std::uint8_t reg, std::uint8_t size) {
  return {.device_addr = from, .reg_addr = reg, .data_len = msg::SmallByteCount(size)};
}

std::vector<std::uint8_t> read(Host& host, msg::I2cDevice from, std::uint8_t reg,
                               std::uint8_t size) {
  const auto answer = host.get<msg::I2cReadRegBuf>(reading(from, reg, size));
  return {answer.data.begin(), answer.data.end()};
}

msg::I2cWriteRegBuf writing(msg::I2cDevice to, std::uint8_t reg,
                            std::initializer_list<std::uint8_t> data) {
  msg::I2cWriteRegBuf request{.device_addr = to, .reg_addr = reg};
  for (const std::uint8_t byte : data) request.data.push_back(byte);
  return request;
}

double word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] << 8 | bytes[at + 1]);
}

TEST(I2c, DevicesSayWhatTheyAre) {
  Host host;
  EXPECT_EQ(read(host, device(I2cBus::main_imu), 0x75, 1), std::vector<std::uint8_t>{0x68});
  EXPECT_EQ(read(host, device(I2cBus::frame_imu), 0x75, 1), std::vector<std::uint8_t>{0x68});
  EXPECT_EQ(read(host, device(I2cBus::magnetometer), 10, 3),
            (std::vector<std::uint8_t>{'H', '4', '3'}));
}

TEST(I2c, WhatIsNotThereDoesNotAnswer) {
  BoardOptions options;
  options.has_frame_imu = false;
  Host host(options);
  for (const msg::I2cDevice absent :
       {device(I2cBus::frame_imu), device(0x10), device(I2cBus::eeprom),
        device(I2cBus::main_imu, msg::I2cPort::second)}) {
    EXPECT_EQ(refusal(host, reading(absent, 0, 1)), msg::BoardErrorCode::operation_failed);
    EXPECT_EQ(refusal(host, writing(absent, 0, {1})), msg::BoardErrorCode::operation_failed);
  }
  EXPECT_EQ(refusal(host, reading(device(I2cBus::main_imu), 0, 0)),
            msg::BoardErrorCode::wrong_params);
}

TEST(I2c, AnImuMeasures) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  const auto level = read(host, device(I2cBus::main_imu), 0x3B, 14);
  EXPECT_NEAR(word(level, 4) / 2048, 1, 0.02);
  EXPECT_NEAR(word(level, 6) / 340 + 36.53, host.board.gimbal().sample(host.now).temperature, 1);
  host.board.gimbal().place({0, 90, 0}, host.now);
  EXPECT_NEAR(word(read(host, device(I2cBus::main_imu), 0x3B, 6), 4) / 2048, 0, 0.05);
}

TEST(I2c, RegistersKeepWhatIsWritten) {
  Host host;
  const msg::I2cDevice imu = device(I2cBus::main_imu);
  EXPECT_TRUE(is_confirmed(host, writing(imu, 0x19, {7, 3})));
  EXPECT_EQ(read(host, imu, 0x19, 2), (std::vector<std::uint8_t>{7, 3}));
  EXPECT_EQ(read(host, device(I2cBus::frame_imu), 0x19, 2), (std::vector<std::uint8_t>{0, 0}));
  EXPECT_TRUE(is_confirmed(host, writing(imu, 0x75, {0}))) << "it acknowledges";
  EXPECT_EQ(read(host, imu, 0x75, 1), std::vector<std::uint8_t>{0x68}) << "but keeps its name";
}

TEST(I2c, RegistersAreLostWithThePower) {
  Host host;
  const msg::I2cDevice imu = device(I2cBus::main_imu);
  host.ask(writing(imu, 0x19, {7}));
  host.ask(msg::ResetRequest{}, seconds(1));
  EXPECT_EQ(read(host, imu, 0x19, 1), std::vector<std::uint8_t>{7}) << "a reset leaves it on";
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(read(host, imu, 0x19, 1), std::vector<std::uint8_t>{0});
}

TEST(I2c, AddressesBeginAgain) {
  Host host;
  const auto all = read(host, device(I2cBus::magnetometer), 10, 255);
  ASSERT_EQ(all.size(), 255U);
  EXPECT_EQ(all[0], 'H');
  EXPECT_EQ(all[13], 'H');
}

TEST(I2c, TheEepromIsThatOfTheBoard) {
  Host host;
  const msg::I2cDevice chip = device(I2cBus::eeprom, msg::I2cPort::second);
  EXPECT_TRUE(is_confirmed(host, writing(chip, 0x7F, {1, 2, 3})));
  const auto page = host.get<msg::EepromRead>(
      msg::EepromReadRequest{.addr = 0x7F00, .size = *msg::ByteCount::from_bytes(64)});
  EXPECT_TRUE(std::equal(page.data.begin(), page.data.begin() + 3, std::begin({1, 2, 3})));
  EXPECT_EQ(read(host, chip, 0x7F, 3), (std::vector<std::uint8_t>{1, 2, 3}));
}

}  // namespace
}  // namespace sbgc::test
