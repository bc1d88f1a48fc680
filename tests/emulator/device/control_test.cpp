// Tests of control commands, also with quaternions, and of their effect on the axes.

#include <cmath>
#include <optional>

#include "device/control/quaternion_control.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

using emulator::AxisMode;

/// Returns a request that moves only pitch.
msg::ControlExt one_axis(msg::ControlModeKind mode, std::int16_t speed, std::int16_t angle) {
  msg::ControlExt request;
  request.control_mode.pitch.set_mode(mode);
  request.axes.pitch = {msg::ControlSpeed(speed), msg::Angle14(angle)};
  return request;
}

TEST(Control, ModesAndUnits) {
  Host host;
  const auto command = [&] { return host.board.gimbal().command(1); };
  EXPECT_THAT(host.ask(one_axis(msg::ControlModeKind::speed, 1000, 0)), SizeIs(1));
  EXPECT_EQ(command().mode, AxisMode::speed);
  EXPECT_NEAR(command().speed, 1000 * 4000.0 / 32767, 1e-9);
  host.ask(one_axis(msg::ControlModeKind::angle, -1000, 8192));
  EXPECT_EQ(command().mode, AxisMode::angle);
  EXPECT_NEAR(command().speed, 1000 * 4000.0 / 32767, 1e-9) << "the angle determines the direction";
  EXPECT_EQ(command().angle, 180);
  host.ask(one_axis(msg::ControlModeKind::speed_angle, -1000, 100));
  EXPECT_EQ(command().mode, AxisMode::speed_angle);
  EXPECT_LT(command().speed, 0);
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_deadband = 0;
  host.ask(msg::WriteParams3{parameters});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, -250));
  EXPECT_EQ(command().mode, AxisMode::signal);
  EXPECT_EQ(command().signal, -0.5);
  parameters.rc.pitch.rc_mode.set_inverted(true);
  parameters.rc_trim.pitch = 50;
  host.ask(msg::WriteParams3{parameters});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, -250));
  EXPECT_NEAR(command().signal, 0.6, 1e-9) << "it replaces the RC signal, including its parameters";
  parameters.rc.pitch.rc_mode.set_inverted(false);
  host.ask(msg::WriteParams3{parameters});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, 9999));
  EXPECT_EQ(command().signal, 1);
  host.ask(one_axis(msg::ControlModeKind::angle_rel_frame, 0, -16384));
  EXPECT_EQ(command().mode, AxisMode::relative_angle);
  EXPECT_EQ(command().angle, -360);
  EXPECT_EQ(host.board.gimbal().command(0).mode, AxisMode::remote) << "other axes have their own";
  host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
  EXPECT_EQ(command().mode, AxisMode::remote);
}

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
