// Tests of control with quaternions.

#include "device/control/quaternion_control.hpp"

#include <cmath>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using QuatFlag = msg::ControlQuatFlag;
using QuatMode = msg::ControlQuatMode;

constexpr double degrees_in_radian = 180 / 3.14159265358979323846;

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

}  // namespace
}  // namespace sbgc::test
