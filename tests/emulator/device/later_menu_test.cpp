// Tests of the menu actions of later firmware.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using Menu = msg::MenuCommand;

void run_action(Host& host, Menu action, Duration time = seconds(8)) {
  EXPECT_EQ(confirmations<msg::ExecuteMenu>(host.ask(msg::ExecuteMenu{action}, time)), 1);
}

void aim(Host& host, double roll, double pitch, double yaw) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::angle);
  request.axes.roll.angle = msg::Angle14::from_degrees(roll).value_or({});
  request.axes.pitch.angle = msg::Angle14::from_degrees(pitch).value_or({});
  request.axes.yaw.angle = msg::Angle14::from_degrees(yaw).value_or({});
  host.ask(request, seconds(15));
}

Axes<double> targets(Host& host) { return host.board.gimbal().sample(host.now).targets; }
bool has_state(Host& host, msg::StateFlag flag) {
  return host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).system_state_flags.has(flag);
}

TEST(LaterMenu, LevelsOneAxis) {
  Host host(newest_board());
  aim(host, 10, -20, 0);
  run_action(host, Menu::level_roll);
  EXPECT_NEAR(targets(host).roll, 0, 0.1);
  EXPECT_NEAR(targets(host).pitch, -20, 0.1);
  run_action(host, Menu::level_pitch);
  EXPECT_NEAR(targets(host).pitch, 0, 0.1);
}

TEST(LaterMenu, TurnsAround) {
  Host host(newest_board());
  run_action(host, Menu::rotate_yaw_180, seconds(10));
  EXPECT_NEAR(std::abs(targets(host).yaw), 180, 0.5);
  run_action(host, Menu::switch_yaw_180_frame_rel, seconds(10));
  EXPECT_NEAR(std::remainder(targets(host).yaw, 360), 0, 1) << "forwards again";
  run_action(host, Menu::switch_pos_roll_90, seconds(10));
  EXPECT_NEAR(targets(host).roll, 90, 0.5);
}

TEST(LaterMenu, GoesHomeByTheShortestWay) {
  Host host(newest_board());
  aim(host, 0, 0, 350);
  run_action(host, Menu::home_position_shortest);
  EXPECT_NEAR(targets(host).yaw, 360, 0.5) << "10 degrees instead of 350";
  aim(host, 0, 0, 350);
  run_action(host, Menu::snap_to_fixed_position);
  EXPECT_NEAR(targets(host).yaw, 360, 0.5);
}

TEST(LaterMenu, SwitchesModes) {
  Host host(newest_board());
  const auto expect_switch = [&](Menu action, msg::StateFlag flag, bool is_on) {
    run_action(host, action, milliseconds(50));
    EXPECT_EQ(has_state(host, flag), is_on) << static_cast<int>(action);
  };
  expect_switch(Menu::servo_mode_on, msg::StateFlag::servo_mode_enabled, true);
  expect_switch(Menu::servo_mode_toggle, msg::StateFlag::servo_mode_enabled, false);
  expect_switch(Menu::shake_generator_on, msg::StateFlag::shake_gen_enabled, true);
  expect_switch(Menu::shake_generator_off, msg::StateFlag::shake_gen_enabled, false);
  expect_switch(Menu::forced_follow_toggle, msg::StateFlag::follow_mode_yaw, true);
  expect_switch(Menu::disable_follow_toggle, msg::StateFlag::follow_mode_yaw, false);
  expect_switch(Menu::retracted_position, msg::StateFlag::retracted_position, true);
  expect_switch(Menu::tripod_mode_on, msg::StateFlag::tripod_mode_enabled, true);
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_FALSE(has_state(host, msg::StateFlag::tripod_mode_enabled)) << "until the restart";
}

TEST(LaterMenu, ServoModeUsesTheAnglesOfTheMotors) {
  auto options = newest_board();
  const Axes<double> turned{0, 0, 40};
  options.gimbal.frame.recording = {{Instant{}, turned}, {Instant{} + seconds(1000), turned}};
  options.gimbal.frame.kind = emulator::Disturbance::Kind::recorded;
  Host host(options);
  run_action(host, Menu::servo_mode_on, milliseconds(50));
  aim(host, 0, 0, 10);
  EXPECT_NEAR(host.board.gimbal().sample(host.now).joints.yaw, 10, 1);
}

TEST(LaterMenu, MotorsStopSafely) {
  Host host(newest_board());
  run_action(host, Menu::motors_safe_toggle, seconds(1));
  EXPECT_FALSE(host.board.gimbal().motors_on());
  run_action(host, Menu::motors_safe_toggle, seconds(1));
  EXPECT_TRUE(host.board.gimbal().motors_on());
}

}  // namespace
}  // namespace sbgc::test
