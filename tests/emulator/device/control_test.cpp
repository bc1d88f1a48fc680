// Tests of helper data for the control of axes, and of packed quaternions.

#include <optional>

#include "device/control/quaternion_control.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

/// Returns the state of a handheld gimbal after 5 s in which a host sends `data` 50 times per
/// second.
template <class Data>
emulator::Sample helped(const std::optional<Data>& data) {
  emulator::BoardOptions options;
  options.gimbal.frame.kind = emulator::Disturbance::Kind::handheld;
  options.gimbal.noise = 0;
  Host host(options);
  for (int i = 0; i < 250; ++i) {
    if (data) {
      host.send(*data);
    }
    EXPECT_THAT(host.listen(milliseconds(20)), IsEmpty())
        << "it is sent often, so it is not confirmed";
  }
  return host.board.gimbal().sample(host.now);
}

TEST(Control, HelpIsWhatTellsSomething) {
  const auto alone = helped<msg::HelperData>({}).angles;
  EXPECT_EQ(helped(std::optional(msg::HelperData{})).angles, alone) << "zeros are not used";
  EXPECT_EQ(helped(std::optional(msg::HelperDataExt{})).angles, alone);
  msg::HelperData tilt;
  tilt.frame_angle_pitch = msg::Angle14(100);
  EXPECT_NE(helped(std::optional(tilt)).angles, alone);
  msg::HelperDataExt speed{.coord_sys = msg::CoordinateSystem::ground_yaw_rotated};
  speed.frame_speed.z = msg::GyroRate(100);
  const auto with_speed = helped(std::optional(speed)).angles;
  EXPECT_NE(with_speed, alone);
  speed.coord_sys = msg::CoordinateSystem{7};
  EXPECT_EQ(helped(std::optional(speed)).angles, with_speed) << "as the usual coordinates";
}

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
