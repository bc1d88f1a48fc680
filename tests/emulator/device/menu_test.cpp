// Tests of every menu action.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/meta/enums.hpp>

#include "host.hpp"

namespace sbgc::test {
namespace {

using ::testing::SizeIs;

void execute(Host& host, msg::MenuCommand action, Duration wait = seconds(4)) {
  EXPECT_THAT(all<msg::Confirm>(host.ask(msg::ExecuteMenu{action}, wait)), SizeIs(1));
}

Axes<double> angles(Host& host) {
  const auto data = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
  return {data.angle.roll.degrees(), data.angle.pitch.degrees(), data.angle.yaw.degrees()};
}

void go_to(Host& host, const Axes<double>& wanted) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::angle);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    request.axes[axis].angle = msg::Angle14::from_degrees(wanted[axis]).value_or({});
  }
  host.ask(request, seconds(8));
}

TEST(Menu, HasAllActionsOfTheModelAndNoOther) {
  for (int action = 0; action < 256; ++action) {
    bool is_known = false;
    for (const ValueInfo& info : EnumMeta<msg::MenuCommand>::values)
      is_known |= info.value == action;
    Host host;
    const auto packets = host.ask(msg::ExecuteMenu{static_cast<msg::MenuCommand>(action)});
    EXPECT_EQ(all<msg::Confirm>(packets).size(), is_known ? 1U : 0U) << action;
    EXPECT_EQ(all<msg::ErrorExt>(packets).size(), is_known ? 0U : 1U) << action;
  }
}

TEST(Menu, Profiles) {
  Host host;
  std::uint8_t profile = 0;
  for (const auto action :
       {msg::MenuCommand::profile1, msg::MenuCommand::profile2, msg::MenuCommand::profile3,
        msg::MenuCommand::profile4, msg::MenuCommand::profile5}) {
    execute(host, action, milliseconds(10));
    EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_profile, profile++);
  }
}

TEST(Menu, Motors) {
  Host host;
  const auto is_on = [&] { return host.board.gimbal().motors_on(); };
  execute(host, msg::MenuCommand::motor_toggle);
  EXPECT_FALSE(is_on());
  execute(host, msg::MenuCommand::motor_on);
  EXPECT_TRUE(is_on());
  execute(host, msg::MenuCommand::motor_off);
  EXPECT_FALSE(is_on());
}

TEST(Menu, LookDownPointsTheCameraToTheGround) {
  Host host;
  execute(host, msg::MenuCommand::look_down, seconds(8));
  const auto attitude = host.get<msg::AhrsHelper>(msg::AhrsHelperRequest{});
  EXPECT_NEAR(static_cast<double>(attitude.z1_vector.y), -1, 0.02)
      << "y points forward: up is behind the camera";
}

TEST(Menu, Positions) {
  Host host;
  go_to(host, {10, -20, 30});
  execute(host, msg::MenuCommand::level_roll_pitch, seconds(8));
  EXPECT_NEAR(angles(host).roll, 0, 0.5);
  EXPECT_NEAR(angles(host).pitch, 0, 0.5);
  EXPECT_NEAR(angles(host).yaw, 30, 0.5);
  execute(host, msg::MenuCommand::center_yaw, seconds(8));
  EXPECT_NEAR(angles(host).yaw, 0, 0.5);
  go_to(host, {10, -20, 30});
  execute(host, msg::MenuCommand::home_position, seconds(8));
  EXPECT_NEAR(angles(host).pitch, 0, 0.5);
  EXPECT_NEAR(angles(host).yaw, 0, 0.5);
}

TEST(Menu, UntwistTurnsBackFullTurnsAndCenterDoesNot) {
  Host host;
  go_to(host, {0, 0, 400});
  host.listen(seconds(20));
  const auto joint = [&] {
    return host.get<msg::GetAnglesExt>(msg::GetAnglesExtRequest{})
        .axes.yaw.stator_rotor_angle.degrees();
  };
  EXPECT_NEAR(joint(), 400, 1);
  execute(host, msg::MenuCommand::center_yaw, seconds(20));
  EXPECT_NEAR(joint(), 360, 1);
  execute(host, msg::MenuCommand::untwist_cables, seconds(20));
  EXPECT_NEAR(joint(), 0, 1);
}

TEST(Menu, TheStartAngleIsSavedOrNot) {
  for (const bool is_saved : {true, false}) {
    Host host;
    go_to(host, {0, -25, 0});
    execute(host, is_saved ? msg::MenuCommand::set_angle : msg::MenuCommand::set_angle_no_save);
    go_to(host, {0, 10, 0});
    execute(host, msg::MenuCommand::home_position, seconds(8));
    EXPECT_NEAR(angles(host).pitch, -25, 0.5);
    host.ask(msg::ResetRequest{}, seconds(8));
    EXPECT_NEAR(angles(host).pitch, is_saved ? -25 : 0, 0.5);
  }
}

TEST(Menu, AStartAngleThatIsNotSavedIsOfTheActiveProfileAlone) {
  Host host;
  const auto start_angle = [&](std::uint8_t profile) {
    const msg::ReadParams3Request request{.profile_id = profile};
    return host.get<msg::ReadParams3>(request).rc_memory.pitch.degrees();
  };
  go_to(host, {0, -25, 0});
  execute(host, msg::MenuCommand::set_angle_no_save);
  EXPECT_NEAR(start_angle(0), -25, 0.5);
  EXPECT_NEAR(start_angle(1), 0, 0.5);
  execute(host, msg::MenuCommand::profile2);
  execute(host, msg::MenuCommand::home_position, seconds(8));
  EXPECT_NEAR(angles(host).pitch, 0, 0.5);
  execute(host, msg::MenuCommand::profile1);
  EXPECT_NEAR(start_angle(0), 0, 0.5) << "it was not saved";
}

TEST(Menu, AStartAngleThatIsNotSavedCanBeSavedOrOverwritten) {
  Host host;
  go_to(host, {0, -25, 0});
  const auto stored = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  execute(host, msg::MenuCommand::set_angle_no_save);
  host.ask(msg::WriteParams3{stored});
  execute(host, msg::MenuCommand::home_position, seconds(8));
  EXPECT_NEAR(angles(host).pitch, 0, 0.5);
  go_to(host, {0, -25, 0});
  execute(host, msg::MenuCommand::set_angle_no_save);
  host.ask(msg::SaveParams3{});
  host.ask(msg::ResetRequest{}, seconds(8));
  EXPECT_NEAR(angles(host).pitch, -25, 0.5);
}

TEST(Menu, SignalsAreSwapped) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    parameters.rc_map[axis].set_source(msg::RcSource::api);
    parameters.rc_map[axis].set_channel(static_cast<std::uint8_t>(axis + 1));
  }
  parameters.rc_deadband = 0;
  parameters.rc_trim = {};
  parameters.rc_expo_rate = 0;
  host.ask(msg::WriteParams3{parameters});
  msg::ApiVirtChControl signals;
  for (std::size_t i = 0; i < 3; ++i) {
    signals.val_ch.push_back(msg::CentredRcSignal(static_cast<std::int16_t>(100 * (i + 1))));
  }
  host.ask(signals);
  const auto rc = [&] { return host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc; };
  EXPECT_EQ(rc(),
            (Axes<msg::RcSignal>{msg::RcSignal(1600), msg::RcSignal(1700), msg::RcSignal(1800)}));
  execute(host, msg::MenuCommand::swap_pitch_roll, milliseconds(10));
  EXPECT_EQ(rc(),
            (Axes<msg::RcSignal>{msg::RcSignal(1700), msg::RcSignal(1600), msg::RcSignal(1800)}));
  execute(host, msg::MenuCommand::swap_pitch_roll, milliseconds(10));
  execute(host, msg::MenuCommand::swap_yaw_roll, milliseconds(10));
  EXPECT_EQ(rc(),
            (Axes<msg::RcSignal>{msg::RcSignal(1800), msg::RcSignal(1700), msg::RcSignal(1600)}));
}

TEST(Menu, AButtonThatPressesItselfDoesNothing) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.menu_cmd[0] = msg::MenuCommand::button_press;
  host.ask(msg::WriteParams3{parameters});
  execute(host, msg::MenuCommand::button_press);
  parameters.menu_cmd[0] = msg::MenuCommand::motor_off;
  host.ask(msg::WriteParams3{parameters});
  execute(host, msg::MenuCommand::button_press);
  EXPECT_FALSE(host.board.gimbal().motors_on());
}

TEST(Menu, ACalibrationIsStarted) {
  Host host;
  execute(host, msg::MenuCommand::calib_gyro, milliseconds(500));
  const auto info =
      host.get<msg::CalibInfo>(msg::CalibInfoRequest{.imu_type = msg::SelectedImu::main});
  EXPECT_GT(info.progress.raw(), 0);
  EXPECT_LT(info.progress.raw(), 100);
}

}  // namespace
}  // namespace sbgc::test
