// Tests of the time that a motion to angles may take.

#include "motion/move_time.hpp"

#include <gtest/gtest.h>

namespace sbgc::tools {
namespace {

double seconds_for(const MoveTarget& target, const msg::GetAngles& state, msg::ControlSpeed speed) {
  return std::chrono::duration<double>(time_for_move(target, state, speed)).count();
}

TEST(MoveTime, TheFarthestAxisDecides) {
  constexpr msg::ControlSpeed speed(100);
  constexpr msg::ControlSpeed twice(200);
  constexpr msg::Angle14 quarter(4096);
  constexpr msg::Angle14 half(-8192);
  constexpr double rest = 10;
  const double turn = 1.5 * 360 / speed.degrees_per_second();
  constexpr double near = 0.002;
  msg::GetAngles state;
  EXPECT_NEAR(seconds_for({.pitch = quarter}, state, speed), rest + turn / 4, near);
  EXPECT_NEAR(seconds_for({.roll = quarter, .yaw = half}, state, speed), rest + turn / 2, near);
  EXPECT_NEAR(seconds_for({.roll = half, .yaw = quarter}, state, speed), rest + turn / 2, near);
  EXPECT_NEAR(seconds_for({.pitch = quarter}, state, twice), rest + turn / 8, near);

  state.axes.pitch.imu_angle = quarter;
  EXPECT_NEAR(seconds_for({.pitch = half}, state, speed), rest + turn * 3 / 4, near);
  EXPECT_NEAR(seconds_for({.pitch = quarter}, state, speed), rest, near);
  EXPECT_NEAR(seconds_for({.yaw = msg::Angle14(0)}, state, speed), rest, near)
      << "the pitch axis has no target";
}

}  // namespace
}  // namespace sbgc::tools
