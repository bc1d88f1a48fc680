// Tests of the blocks of CMD_REALTIME_DATA_CUSTOM in later firmware.

#include <cmath>
#include <cstdint>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using Block = msg::RealtimeDataCustomFlag;

msg::RealtimeDataCustom blocks_of(Host& host, msg::RealtimeDataCustomFlags flags) {
  const Packets packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags});
  msg::RealtimeDataCustom data;
  EXPECT_EQ(packets.size(), 1U);
  if (packets.size() == 1) {
    EXPECT_TRUE(decode(std::span(packets[0].body), data, {flags}));
  }
  EXPECT_TRUE(data.tail.empty());
  return data;
}

void look_at(Host& host, double pitch, double yaw) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::angle);
  request.axes.pitch.angle = msg::Angle14::from_degrees(pitch).value_or({});
  request.axes.yaw.angle = msg::Angle14::from_degrees(yaw).value_or({});
  host.ask(request, seconds(8));
}

TEST(CustomData, HasTheSizeOfEachBlock) {
  // Sizes by bit, from 9 on.
  const int sizes[]{8, 26, 9, 12, 40, 20, 46, 6, 12, 12, 7, 13, 8, 8, 8, 8, 12, 6, 24, 12, 11};
  Host host(newest_board());
  for (unsigned bit = 9; bit < 30; ++bit) {
    const msg::RealtimeDataCustomFlags flags(1U << bit);
    const Packets packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags});
    ASSERT_EQ(packets.size(), 1U) << bit;
    EXPECT_EQ(packets[0].body.size(), 2U + static_cast<unsigned>(sizes[bit - 9])) << bit;
  }
}

TEST(CustomData, AnglesAreTheSameInAllUnits) {
  Host host(newest_board());
  look_at(host, -20, 30);
  auto flags = Block::imu_angles_20 | Block::target_angles_20;
  flags.set(Block::imu_angles_rad).set(Block::encoder_raw24).set(Block::imu_quat);
  flags.set(Block::target_quat);
  const auto data = blocks_of(host, flags);
  EXPECT_NEAR((*data.target_angles_20).pitch.degrees(), -20, 0.01);
  EXPECT_NEAR((*data.imu_angles_20).pitch.degrees(), -20, 1);
  EXPECT_NEAR((*data.imu_angles_rad).pitch.radians(), -20 * 3.14159265 / 180, 0.02);
  EXPECT_NEAR((*data.encoder_raw24).yaw.raw() * 360.0 / 0x1000000, 30, 1);
  // The half angle of the whole rotation: first pitch, then yaw.
  const double w = std::cos(10 * 3.14159265 / 180) * std::cos(15 * 3.14159265 / 180);
  const auto target = *data.target_quat;
  const double rest = 1 - std::pow(target.a().value(), 2) - std::pow(target.b().value(), 2) -
                      std::pow(target.c().value(), 2);
  EXPECT_EQ(target.largest(), msg::QuaternionComponent::w);
  EXPECT_NEAR(std::sqrt(rest), w, 1e-3);
}

TEST(CustomData, TellsWhatTheBoardDoes) {
  Host host(newest_board());
  const auto flags = Block::system_state | Block::system_power_state;
  EXPECT_EQ(blocks_of(host, flags).system_state->calib_mode, msg::CalibMode::none);
  EXPECT_EQ(blocks_of(host, flags).system_power_state->state, msg::PowerState::on);
  host.ask(msg::CalibGyro{});
  EXPECT_EQ(blocks_of(host, flags).system_state->calib_mode, msg::CalibMode::gyro);
  host.ask(msg::ExecuteMenu{msg::MenuCommand::tripod_mode_on});
  host.ask(msg::MotorsOffExt{});
  const auto data = blocks_of(host, flags);
  EXPECT_TRUE(data.system_state->flags.has(msg::StateFlag::tripod_mode_enabled));
  EXPECT_EQ(data.system_power_state->state, msg::PowerState::off);
  EXPECT_NEAR(data.system_power_state->battery_voltage.volts(),
              host.board.gimbal().sample(host.now).battery, 0.02);
}

TEST(CustomData, DistancesToLimitsThatThereAre) {
  Host host(newest_board());
  EXPECT_EQ((*blocks_of(host, Block::sw_limits_dist).sw_limits_dist).yaw.dist[0].raw(),
            msg::SoftLimitDistances::unknown_distance);
  auto parameters = host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{});
  parameters.encoder_limit_min.yaw = msg::EncoderLimit(-30);  // 90 degrees
  parameters.encoder_limit_max.yaw = msg::EncoderLimit(30);
  host.ask(msg::WriteParamsExt{parameters});
  look_at(host, 0, 30);
  const auto yaw = (*blocks_of(host, Block::sw_limits_dist).sw_limits_dist).yaw;
  EXPECT_NEAR(yaw.dist[0].degrees(), 120, 1);
  EXPECT_NEAR(yaw.dist[1].degrees(), 60, 1);
}

TEST(CustomData, RepeatsTheFlagsOnRequest) {
  Host host(newest_board());
  const auto flags = Block::imu_angles | Block::main_imu_state | Block::include_flags;
  const Packets packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags});
  ASSERT_EQ(packets.size(), 1U);
  // Decoding needs no request, nor is it misled by another one.
  for (const msg::RealtimeDataCustomFlags known : {{}, flags, Block::imu_angles | Block::rc_data}) {
    msg::RealtimeDataCustom data;
    ASSERT_TRUE(decode(std::span(packets[0].body), data, {known}));
    EXPECT_EQ(data.flags, flags);
    EXPECT_TRUE(data.main_imu_state);
    EXPECT_TRUE(data.tail.empty());
  }
}

TEST(CustomData, OfTheFrame) {
  Host host(newest_board());
  const msg::RealtimeDataCustom2Flags flags(0x8000007F);
  const Packets packets = host.ask(msg::RealtimeDataCustom2Request{.flags = flags});
  ASSERT_EQ(packets.size(), 1U);
  msg::RealtimeDataCustom2 data;
  ASSERT_TRUE(decode(std::span(packets[0].body), data));
  EXPECT_EQ(data.flags, flags);
  EXPECT_TRUE(data.frame_imu_angles);
  EXPECT_EQ(data.pin_state->pin_state.input_8(), msg::InputState::unavailable);
  EXPECT_TRUE(data.stab_err_ampl);
  EXPECT_TRUE(data.tail.empty());
}

TEST(CustomData, WhatDoesNotFitIsRefused) {
  Host host(newest_board());
  const msg::RealtimeDataCustomRequest everything{.flags =
                                                      msg::RealtimeDataCustomFlags(0x0FFFFFFF)};
  EXPECT_EQ(refusal(host, everything), msg::BoardErrorCode::wrong_params);
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_custom;
  stream.interval_ms = msg::Milliseconds(10);
  stream.config.flags = everything.flags;
  EXPECT_EQ(refusal(host, stream), msg::BoardErrorCode::wrong_params);
}

TEST(CustomData, StreamsCountAttitudes) {
  Host host(newest_board());
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_custom;
  stream.interval_ms = msg::Milliseconds(5);
  stream.config.flags = msg::RealtimeDataCustomFlags{};
  stream.sync_to_data = msg::StreamSync::imu_attitude;
  host.ask(stream, microseconds(800));
  // An attitude in each cycle of 0.8 ms, a sample for each fifth one.
  EXPECT_EQ(host.listen(seconds(2)).size(), 500U);
}

}  // namespace
}  // namespace sbgc::test
