// Tests of CMD_CONTROL_CONFIG, of the later modes of CMD_CONTROL, and of CMD_CONTROL_EXT.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using ModeKind = msg::ControlModeKind;

msg::Control turn_yaw(double degrees_per_second) {
  msg::Control request;
  request.control_mode.set_mode(ModeKind::speed);
  request.axes.yaw.speed =
      msg::ControlSpeed::from_degrees_per_second(degrees_per_second).value_or({});
  return request;
}

double yaw_speed(Host& host) { return host.board.gimbal().sample(host.now).target_speeds.yaw; }
double yaw_target(Host& host) { return host.board.gimbal().sample(host.now).targets.yaw; }

TEST(ControlLink, EndsWithoutCommands) {
  Host host(newest_board());
  EXPECT_TRUE(is_confirmed(host, msg::ControlConfig{.timeout_ms = msg::Milliseconds(500)}));
  for (int i = 0; i < 5; ++i) {
    host.ask(turn_yaw(20), milliseconds(400));
    EXPECT_NEAR(yaw_speed(host), 20, 0.1);
  }
  host.listen(seconds(1));
  EXPECT_EQ(yaw_speed(host), 0) << "no command for 500 ms";
  EXPECT_TRUE(is_confirmed(host, msg::ControlConfig{}));
  host.ask(turn_yaw(20), seconds(3));
  EXPECT_NEAR(yaw_speed(host), 20, 0.1) << "there is no timeout";
}

TEST(ControlLink, ATimeoutAlsoEndsEarlierControl) {
  Host host(newest_board());
  host.ask(turn_yaw(20), milliseconds(400));
  EXPECT_TRUE(is_confirmed(host, msg::ControlConfig{.timeout_ms = msg::Milliseconds(500)}));
  host.listen(milliseconds(400));
  EXPECT_NEAR(yaw_speed(host), 20, 0.1);
  host.listen(milliseconds(600));
  EXPECT_EQ(yaw_speed(host), 0);
}

TEST(ControlLink, OnlyTheHighestPriorityCounts) {
  Host host(newest_board());
  const auto first = host.port;
  const auto second = host.board.open_port().value();
  EXPECT_TRUE(is_confirmed(host, msg::ControlConfig{.this_ch_priority = 5}));
  host.port = second;
  EXPECT_THAT(host.ask(turn_yaw(20)), IsEmpty()) << "ignored";
  EXPECT_EQ(yaw_speed(host), 0);
  host.port = first;
  EXPECT_TRUE(is_confirmed(host, turn_yaw(20)));
  // The second port is RC_SERIAL.
  EXPECT_TRUE(is_confirmed(host, msg::ControlConfig{.ch_priority = {0, 9, 0, 0}}));
  EXPECT_THAT(host.ask(turn_yaw(-20)), IsEmpty());
  host.board.close_port(second);
  EXPECT_TRUE(is_confirmed(host, turn_yaw(-20))) << "its host has left";
}

TEST(ControlLink, ConfirmationsCanBeOff) {
  Host host(newest_board());
  EXPECT_THAT(host.ask(msg::ControlConfig{.flags = msg::ControlConfigFlag::no_confirm}), IsEmpty());
  EXPECT_THAT(host.ask(turn_yaw(20)), IsEmpty());
  EXPECT_GT(yaw_speed(host), 0);
}

TEST(ControlLink, LimitsTheAcceleration) {
  const auto moved = [](std::uint16_t limit) {
    Host host(newest_board());
    msg::ControlConfig config;
    config.axes.yaw.acc_limit = msg::LongAngularAcceleration(limit);
    host.ask(config);
    host.ask(turn_yaw(60), seconds(1));
    return yaw_speed(host);
  };
  EXPECT_NEAR(moved(10), 10, 1);
  EXPECT_NEAR(moved(500), 60, 0.1);
}

/// Moves pitch to the highest angle by a signal, then loses the signal.
void lose_signal(ModeKind mode, std::int16_t full, std::int16_t lost) {
  Host host(newest_board());
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_deadband = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) parameters.rc[axis].rc_mode = {};
  host.ask(msg::WriteParams3{parameters});
  msg::Control request;
  request.control_mode.set_mode(mode);
  request.axes.pitch.angle = msg::Angle14(full);
  host.ask(request, seconds(5));
  const double highest = host.board.gimbal().sample(host.now).targets.pitch;
  EXPECT_NEAR(highest, parameters.rc.pitch.rc_max_angle.degrees(), 0.5);
  request.axes.pitch.angle = msg::Angle14(lost);
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(3));
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, highest, 0.5) << "it holds";
}

TEST(Control, ASignalMayBeLost) {
  lose_signal(ModeKind::rc, 500, -10000);
  lose_signal(ModeKind::rc_high_res, 16384, -32768);
}

TEST(Control, AnIgnoredAxisKeepsItsState) {
  Host host(newest_board());
  host.ask(turn_yaw(20));
  msg::ControlExt request;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    request.control_mode[axis].set_mode(ModeKind::ignore);
  }
  request.control_mode.pitch.set_mode(ModeKind::angle);
  request.axes.pitch.angle = -10_deg;
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(3));
  EXPECT_NEAR(yaw_speed(host), 20, 0.1);
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, -10, 0.1);
}

TEST(Control, TheShortestWayIsLessThanHalfATurn) {
  Host host(newest_board());
  msg::Control request;
  request.control_mode.set_mode(ModeKind::angle);
  request.axes.yaw.angle = 170_deg;
  host.ask(request, seconds(15));
  ASSERT_NEAR(yaw_target(host), 170, 0.5);
  request.control_mode.set_mode(ModeKind::angle_shortest);
  request.axes.yaw.angle = -170_deg;
  host.ask(request, seconds(15));
  EXPECT_NEAR(yaw_target(host), 190, 0.5) << "20 degrees instead of 340";
}

TEST(Control, ATaskIsConfirmedWhenItArrives) {
  Host host(newest_board());
  msg::ControlExt request;
  request.control_mode.pitch.set_mode(ModeKind::angle);
  request.control_mode.pitch.set_flags(msg::ControlFlag::auto_task);
  request.axes.pitch.angle = -40_deg;
  EXPECT_TRUE(is_confirmed(host, request));
  const auto later = all<msg::Confirm>(host.listen(seconds(8)));
  ASSERT_THAT(later, SizeIs(1));
  EXPECT_EQ(later[0].cmd, msg::CommandToBoard::control);
  EXPECT_NEAR(host.board.gimbal().sample(host.now).angles.pitch, -40, 1.5);
}

TEST(ControlExt, HasDataForSomeAxesInTwoWidths) {
  Host host(newest_board());
  using Field = msg::ControlExtField;
  host.ask(turn_yaw(20));
  msg::ControlExtCommand request;
  request.data_set = Field::pitch_angle | Field::pitch_angle_32bit;
  request.data_set.set(Field::pitch_speed).set(Field::pitch_speed_32bit);
  request.axes.pitch.mode = msg::ControlMode(ModeKind::angle);
  request.axes.pitch.flags = msg::ControlExtFlags{};
  request.axes.pitch.speed_32 = msg::LongFineSpeed(20'000);  // 20 deg/s
  request.axes.pitch.angle_32 = msg::Angle20::from_degrees(-25.5).value_or({});
  host.ask(request, seconds(4));
  EXPECT_NEAR(host.board.gimbal().sample(host.now).targets.pitch, -25.5, 0.01);
  EXPECT_NEAR(yaw_speed(host), 20, 0.1) << "no data for this axis";
}

TEST(Motors, ASafeStopEndsTheMotionFirst) {
  Host host(newest_board());
  host.ask(turn_yaw(60), seconds(2));
  EXPECT_TRUE(is_confirmed(host, msg::MotorsOffExt{msg::MotorsOffMode::safe_stop}));
  EXPECT_TRUE(host.board.gimbal().motors_on()) << "it slows down";
  EXPECT_EQ(host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).calib_mode,
            msg::CalibMode::safe_stop);
  host.listen(seconds(3));
  EXPECT_FALSE(host.board.gimbal().motors_on());
}

}  // namespace
}  // namespace sbgc::test
