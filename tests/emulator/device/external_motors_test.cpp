// Tests of external motors: modes, setpoints, limits, states and streams.

#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using MotorField = msg::ExtMotorsStateField;

constexpr msg::ExtMotorTargets second_confirmed(0x82);

void act_on_motor(Host& host, msg::ExtMotorActionKind action) {
  EXPECT_TRUE(is_confirmed(host, msg::ExtMotorsAction{second_confirmed, action, {}}));
}

void set_motor_mode(Host& host, msg::ExtMotorMode mode) {
  msg::ExtMotorsControlConfig config{.for_motors = second_confirmed};
  config.data_set = msg::ExtMotorsControlConfigField::mode;
  config.mode = mode;
  EXPECT_TRUE(is_confirmed(host, config));
}

void control_motor(Host& host, int setpoint) {
  msg::ExtMotorsControl request{.for_motors = msg::ExtMotor::motor2};
  request.setpoint16.emplace().push_back(static_cast<std::int16_t>(setpoint));
  EXPECT_THAT(host.ask(request), IsEmpty()) << "so many commands are not confirmed";
}

msg::ExtMotorsState motor_state(Host& host) {
  return host.get<msg::ExtMotorsState>(
      msg::ExtMotorsStateRequest{msg::ExtMotor::motor2, msg::ExtMotorsStateFields(0xFFFFF)});
}

TEST(ExternalMotors, MoveToAnAngleWithinTheirLimits) {
  Host host(newest_board());
  act_on_motor(host, msg::ExtMotorActionKind::on);
  set_motor_mode(host, msg::ExtMotorMode::position);
  msg::ExtMotorsControlConfig limits{.for_motors = second_confirmed};
  limits.data_set = msg::ExtMotorsControlConfigField::max_speed;
  limits.max_speed = msg::ExtMotorSpeedLimit(15);  // 30 deg/s
  EXPECT_TRUE(is_confirmed(host, limits));
  control_motor(host, 16384 / 4);
  host.listen(seconds(1));
  const auto moving = motor_state(host);
  EXPECT_NEAR((*moving.speed16).degrees_per_second(), 30, 0.5);
  EXPECT_NEAR((*moving.speed32).radians_per_second(), 30 * 3.14159265 / 180, 0.01);
  EXPECT_NEAR((*moving.angle16_setpoint).degrees(), 90, 0.1);
  EXPECT_EQ((*moving.max_speed).degrees_per_second(), 30);
  host.listen(seconds(4));
  const auto still = motor_state(host);
  EXPECT_NEAR((*still.angle16).degrees(), 90, 0.5);
  EXPECT_NEAR((*still.angle32).degrees(), 90, 0.5);
  EXPECT_NEAR((*still.speed16).degrees_per_second(), 0, 0.5);
  EXPECT_EQ((*still.state_flags).power(), msg::ExtMotorPower::on);
}

TEST(ExternalMotors, TurnAtASpeed) {
  Host host(newest_board());
  set_motor_mode(host, msg::ExtMotorMode::speed);
  act_on_motor(host, msg::ExtMotorActionKind::on);
  control_motor(host, 819);  // 100 deg/s
  host.listen(seconds(2));
  const auto turning = motor_state(host);
  EXPECT_NEAR((*turning.speed16).degrees_per_second(), 100, 1);
  EXPECT_GT((*turning.angle32).degrees(), 150);
  // A brake stops at once, a floating motor runs on for a while.
  act_on_motor(host, msg::ExtMotorActionKind::off_floating);
  host.listen(milliseconds(300));
  EXPECT_GT((*motor_state(host).speed16).degrees_per_second(), 50);
  act_on_motor(host, msg::ExtMotorActionKind::off_brake);
  host.listen(milliseconds(300));
  EXPECT_NEAR((*motor_state(host).speed16).degrees_per_second(), 0, 1);
  EXPECT_EQ((*motor_state(host).state_flags).power(), msg::ExtMotorPower::off_brake);
}

TEST(ExternalMotors, GoHome) {
  Host host(newest_board());
  set_motor_mode(host, msg::ExtMotorMode::speed);
  act_on_motor(host, msg::ExtMotorActionKind::on);
  control_motor(host, 819);
  host.listen(seconds(1));
  act_on_motor(host, msg::ExtMotorActionKind::home_position);
  host.listen(seconds(6));
  EXPECT_NEAR((*motor_state(host).angle32).degrees(), 0, 0.5);
}

TEST(ExternalMotors, TakeTargetsOfAllFormats) {
  Host host(newest_board());
  set_motor_mode(host, msg::ExtMotorMode::position);
  act_on_motor(host, msg::ExtMotorActionKind::on);
  msg::ExtMotorsControl request{.for_motors = msg::ExtMotor::motor2};
  using Format = msg::ExtMotorsControlField;
  request.data_set = Format::setpoint_32bit | Format::param1_16bit;
  // 3 turns at 100 deg/s.
  request.setpoint32_param16.emplace().push_back({3 * 16384, 819});
  host.ask(request, seconds(2));
  EXPECT_NEAR((*motor_state(host).speed16).degrees_per_second(), 100, 2);
  host.listen(seconds(12));
  EXPECT_NEAR((*motor_state(host).angle32).degrees(), 1080, 1);
}

TEST(ExternalMotors, AnswerOneByOneAndInStreams) {
  Host host(newest_board());
  const auto states = all<msg::ExtMotorsState>(
      host.ask(msg::ExtMotorsStateRequest{msg::ExtMotors(0x7F), MotorField::control_mode}));
  ASSERT_THAT(states, SizeIs(7));
  EXPECT_EQ(states[6].motor_id, 6);
  EXPECT_FALSE(states[6].angle16);
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::ext_motors_state;
  stream.interval_ms = msg::Milliseconds(100);
  stream.config.motor = std::uint8_t{4};
  stream.config.data_set = MotorField::angle16;
  EXPECT_TRUE(is_confirmed(host, stream));
  const auto samples = all<msg::ExtMotorsState>(host.listen(seconds(1)));
  ASSERT_THAT(samples, SizeIs(10));
  EXPECT_EQ(samples[0].motor_id, 4);
  EXPECT_TRUE(samples[0].angle16);
  stream.config.motor = std::uint8_t{7};
  EXPECT_EQ(refusal<msg::DataStreamInterval>(host.ask(stream, milliseconds(2))),
            msg::BoardErrorCode::wrong_params);
}

TEST(ExternalMotors, NeedTheFeature) {
  auto options = newest_board();
  options.features_ext2.set(msg::BoardFeaturesExt2Bit::ext_motors, false);
  Host host(options);
  const msg::ExtMotorsAction request{second_confirmed, msg::ExtMotorActionKind::on, {}};
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::not_supported);
  const auto info = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{});
  EXPECT_FALSE(info.board_features_ext2.has(msg::BoardFeaturesExt2Bit::ext_motors));
}

}  // namespace
}  // namespace sbgc::test
