// Tests of control with quaternions.

#include "device/control/quaternion_control.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using QuatFlag = msg::ControlQuatFlag;
using QuatMode = msg::ControlQuatMode;

constexpr double degrees_in_radian = 180 / 3.14159265358979323846;

/// A rotation about one axis: 1 X (pitch, up), 2 Y (roll), 3 Z (yaw, to the left).
std::array<float, 4> rotated_about(std::size_t axis, double degrees) {
  std::array<float, 4> out{};
  out[0] = static_cast<float>(std::cos(degrees / 2 / degrees_in_radian));
  out[axis] = static_cast<float>(std::sin(degrees / 2 / degrees_in_radian));
  return out;
}

msg::ControlQuatStatus quaternion_status(Host& host) {
  return host.get<msg::ControlQuatStatus>(
      msg::ControlQuatStatusRequest{msg::ControlQuatStatusFields(0x3FF)});
}

TEST(QuaternionControl, TurnsToAnAttitude) {
  Host host(newest_board());
  EXPECT_TRUE(is_confirmed(host, msg::ControlQuatAttitude{QuatMode::attitude, QuatFlag::confirm,
                                                          rotated_about(1, -20)}));
  host.listen(seconds(4));
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, 20, 0.01);
  const auto now = quaternion_status(host);
  EXPECT_EQ(now.mode, QuatMode::attitude);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto component = static_cast<double>(rotated_about(1, -20)[i]);
    EXPECT_NEAR(static_cast<double>((*now.target_attitude)[i]), component, 1e-4) << i;
    EXPECT_NEAR(static_cast<double>((*now.setpoint_attitude)[i]), component, 1e-4) << i;
    EXPECT_NEAR(static_cast<double>((*now.actual_attitude)[i]), component, 0.02) << i;
  }
}

TEST(QuaternionControl, TurnsAtASpeed) {
  Host host(newest_board());
  msg::ControlQuatSpeed request{QuatMode::speed, QuatFlag::confirm, {}};
  request.target_speed.z = msg::RadianRate(static_cast<float>(10 / degrees_in_radian));
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(2));
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.yaw, -20, 1);
  EXPECT_NEAR((*quaternion_status(host).target_speed).z.degrees_per_second(), 10, 0.1);
  EXPECT_NEAR((*quaternion_status(host).setpoint_speed).z.degrees_per_second(), 10, 0.1);
  // A limit applies from the next command on.
  msg::ControlQuatConfig config{.data_set = msg::ControlQuatConfigField::max_speed};
  config.max_speed = Xyz<msg::ControlSpeedLimit>{
      msg::ControlSpeedLimit(41), msg::ControlSpeedLimit(41), msg::ControlSpeedLimit(41)};
  EXPECT_TRUE(is_confirmed(host, config));
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(1));
  EXPECT_NEAR((*quaternion_status(host).setpoint_speed).z.degrees_per_second(), 5, 0.1);
  EXPECT_TRUE(is_confirmed(host, msg::ControlQuatDisabled{QuatMode::disabled, QuatFlag::confirm}));
  host.listen(seconds(1));
  EXPECT_NEAR((*quaternion_status(host).setpoint_speed).z.degrees_per_second(), 0, 0.1);
}

TEST(QuaternionControl, ATaskIsConfirmedAtItsEnd) {
  Host host(newest_board());
  const Packets start = host.ask(msg::ControlQuatAttitude{
      QuatMode::attitude, QuatFlag::confirm | QuatFlag::auto_task, rotated_about(1, -30)});
  EXPECT_EQ(confirmations<msg::ControlQuatAttitude>(start), 1);
  const Packets later = host.listen(seconds(5));
  ASSERT_THAT(all<msg::Confirm>(later), SizeIs(1));
  EXPECT_THAT(all<msg::Confirm>(later)[0].data, ::testing::ElementsAre(1)) << "complete";
  EXPECT_NEAR(host.board.gimbal().sample(host.now).angles.pitch, 30, 1.5);
}

TEST(QuaternionControl, ATaskThatCannotEndIsGivenUp) {
  Host host(newest_board());
  host.board.gimbal().jam(1, true, host.now);
  host.ask(
      msg::ControlQuatAttitude{QuatMode::attitude, QuatFlag::auto_task, rotated_about(1, -30)});
  EXPECT_THAT(host.listen(seconds(9)), IsEmpty());
  const Packets end = host.listen(seconds(2));
  EXPECT_THAT(all<msg::ErrorExt>(end), SizeIs(1));
  EXPECT_EQ(quaternion_status(host).mode, QuatMode::disabled);
}

TEST(QuaternionControl, APackedAttitudeIsTheSame) {
  // Independent of the packing code: 0.6 and 0.8 about two axes.
  const emulator::Quaternion q{0.8, 0, -0.6, 0};
  const msg::PackedQuaternion packed = emulator::packed(q);
  EXPECT_EQ(packed.largest(), msg::QuaternionComponent::w);
  EXPECT_FALSE(packed.largest_sign());
  EXPECT_NEAR(packed.b().value(), -0.6, 2e-6);
  const auto again = emulator::unpacked(packed);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(again[i], q[i], 4e-6) << i;

  Host host(newest_board());
  const msg::ControlQuatAttitudePacked request{
      QuatMode::attitude, QuatFlag::confirm | QuatFlag::attitude_packed,
      emulator::packed({std::cos(10 / degrees_in_radian), std::sin(10 / degrees_in_radian), 0, 0})};
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(4));
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, -20, 0.01);
}

TEST(QuaternionControl, RefusesWhatItCannotFollow) {
  Host host(newest_board());
  EXPECT_EQ(refusal(host, msg::ControlQuatAttitude{QuatMode::attitude, QuatFlag::confirm, {}}),
            msg::BoardErrorCode::wrong_params)
      << "no attitude";
  EXPECT_EQ(refusal(host, msg::ControlQuatSpeed{QuatMode::attitude, QuatFlag::confirm, {}}),
            msg::BoardErrorCode::wrong_params)
      << "the mode of another form";
  auto options = newest_board();
  options.features_ext2 = {};
  Host without(options);
  EXPECT_EQ(refusal(without, msg::ControlQuatStatusRequest{}), msg::BoardErrorCode::not_supported);
}

TEST(QuaternionControl, AnotherCommandEndsIt) {
  Host host(newest_board());
  msg::ControlQuatSpeed request{QuatMode::speed, QuatFlag::confirm, {}};
  request.target_speed.z = msg::RadianRate(1.0F);
  host.ask(request, seconds(1));
  host.ask(msg::Control{}, seconds(1));
  EXPECT_EQ(quaternion_status(host).mode, QuatMode::disabled);
  EXPECT_NEAR((*quaternion_status(host).setpoint_speed).z.degrees_per_second(), 0, 0.1);
}

}  // namespace
}  // namespace sbgc::test
