// Tests of control commands and their effect on the axes.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "control_requests.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

using emulator::AxisMode;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

TEST(Control, OneModeForAllAxes) {
  Host host;
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.yaw.speed = msg::ControlSpeed(100);
  host.ask(request);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(host.board.gimbal().command(axis).mode, AxisMode::speed);
  }
}

TEST(Control, FineSpeedIsKnownToNewFirmwareOnly) {
  for (const int firmware : {2590, 2560}) {
    emulator::BoardOptions options;
    options.firmware = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware));
    Host host(options);
    auto request = one_axis(msg::ControlModeKind::speed, 1000, 0);
    request.control_mode.pitch.set_flags(msg::ControlFlag::high_res_speed);
    host.ask(request);
    const double speed = host.board.gimbal().command(1).speed;
    EXPECT_NEAR(speed, firmware == 2590 ? 1.0 : 1000 * 4000.0 / 32767, 1e-9);
  }
}

TEST(Control, AnUnknownModeIsRefusedAsAWhole) {
  Host host;
  host.ask(one_axis(msg::ControlModeKind::speed, 10, 0));
  msg::ControlExt request = one_axis(msg::ControlModeKind::angle, 10, 0);
  request.control_mode.yaw = msg::ControlMode(9);
  EXPECT_EQ(host.get<msg::ErrorExt>(request).cmd_id, msg::CommandToBoard::control);
  EXPECT_EQ(host.board.gimbal().command(1).mode, AxisMode::speed);
}

TEST(Control, TheCameraMoves) {
  Host host;
  auto request = one_axis(msg::ControlModeKind::angle, 0, 0);
  request.axes.pitch.angle = -30_deg;
  host.ask(request);
  host.listen(seconds(5));
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), -30, 0.5);
  EXPECT_EQ(angles.axes.pitch.rc_speed.raw(), 0);
}

/// Limits the joint of yaw to -30 to 60 degrees.
void limit_yaw(Host& host) {
  auto parameters = host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{});
  parameters.encoder_limit_min.yaw = msg::EncoderLimit(-10);
  parameters.encoder_limit_max.yaw = msg::EncoderLimit(20);
  host.ask(msg::WriteParamsExt{parameters});
}

/// Returns the final angle of the yaw joint after a command to turn the camera to `angle`.
double joint_after(Host& host, double angle) {
  msg::ControlExt request;
  request.control_mode.yaw.set_mode(msg::ControlModeKind::angle);
  request.axes.yaw.angle = *msg::Angle14::from_degrees(angle);
  host.ask(request, seconds(8));
  return host.get<msg::GetAnglesExt>(msg::GetAnglesExtRequest{})
      .axes.yaw.stator_rotor_angle.degrees();
}

TEST(Control, TheJointsTurnAsFarAsTheSettingsLetThem) {
  Host host;
  EXPECT_NEAR(joint_after(host, 150), 150, 0.5) << "factory parameters have no limits";
  limit_yaw(host);
  EXPECT_NEAR(joint_after(host, 150), 60, 0.5) << "it comes back";
  EXPECT_NEAR(joint_after(host, -150), -30, 0.5);
  EXPECT_NEAR(joint_after(host, 45), 45, 0.5);
}

TEST(Control, WithoutEncodersJointsHaveNoLimits) {
  emulator::BoardOptions options;
  options.features = msg::BoardFeature::three_axis;
  Host host(options);
  limit_yaw(host);
  EXPECT_NEAR(joint_after(host, 150), 150, 0.5);
}

TEST(Control, AnEmptyBatteryKeepsTheMotorsOff) {
  Host host;
  host.board.gimbal().set_battery(9, host.now);
  host.listen(seconds(1));
  host.ask(msg::MotorsOff{});
  const auto packets = host.ask(msg::MotorsOn{});
  ASSERT_THAT(packets, SizeIs(1));
  EXPECT_TRUE(is<msg::ErrorExt>(packets[0]));
}

TEST(Control, NoMotorIsFasterThanTheGyroscopeCanTell) {
  Host host;
  host.ask(one_axis(msg::ControlModeKind::speed, 32767, 0), seconds(8));
  const auto data = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(data.axes.pitch.rc_speed.degrees_per_second(), 2000, 0.1) << "and says so";
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

TEST(Control, AMotorThatIsNotConnectedHoldsNothing) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.output.pitch = msg::MotorOutput::disabled;
  host.ask(msg::WriteParams3{parameters});
  const auto power = host.board.gimbal().sample(host.now).power;
  EXPECT_EQ(power.pitch, 0);
  EXPECT_GT(power.roll, 0);
}

}  // namespace
}  // namespace sbgc::test
