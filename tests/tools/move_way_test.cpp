// Tests of the way of a motion to angles.

#include "move/move_way.hpp"

#include <string>

#include <gtest/gtest.h>

namespace sbgc::tools {
namespace {

using Angles = Axes<msg::Angle14>;

msg::Angle14 deg(double degrees) { return *msg::Angle14::from_degrees(degrees); }

double seconds_for(const MoveTarget& target, const Angles& angles, msg::ControlSpeed speed) {
  return std::chrono::duration<double>(time_for_move(target, angles, speed)).count();
}

TEST(MoveWay, TheFarthestAxisDecidesTheTime) {
  constexpr msg::ControlSpeed speed(100);
  constexpr msg::ControlSpeed twice(200);
  constexpr msg::Angle14 quarter(4096);
  constexpr msg::Angle14 half(-8192);
  constexpr double rest = 10;
  const double turn = 1.5 * 360 / speed.degrees_per_second();
  constexpr double near = 0.002;
  Angles angles;
  EXPECT_NEAR(seconds_for({.pitch = quarter}, angles, speed), rest + turn / 4, near);
  EXPECT_NEAR(seconds_for({.roll = quarter, .yaw = half}, angles, speed), rest + turn / 2, near);
  EXPECT_NEAR(seconds_for({.roll = half, .yaw = quarter}, angles, speed), rest + turn / 2, near);
  EXPECT_NEAR(seconds_for({.pitch = quarter}, angles, twice), rest + turn / 8, near);

  angles.pitch = quarter;
  EXPECT_NEAR(seconds_for({.pitch = half}, angles, speed), rest + turn * 3 / 4, near);
  EXPECT_NEAR(seconds_for({.pitch = quarter}, angles, speed), rest, near);
  EXPECT_NEAR(seconds_for({.yaw = msg::Angle14(0)}, angles, speed), rest, near)
      << "the pitch axis has no target";
  angles.yaw = deg(719);
  EXPECT_NEAR(seconds_for({.yaw = deg(-719)}, angles, speed), rest + turn / 180, near) << "2 deg";
}

TEST(MoveWay, TheSentenceSaysWhereItEndsAndWhichWay) {
  const Angles angles{.roll = deg(2), .pitch = deg(40), .yaw = deg(30)};
  const auto text = [&](const MoveTarget& target) { return target_text(target, angles); };
  EXPECT_EQ(text({.pitch = deg(10)}), "10 deg down (now 40 down: up by 30)");
  EXPECT_EQ(text({.pitch = deg(-7.5)}), "7.5 deg up (now 40 down: up by 47.5)");
  EXPECT_EQ(text({.pitch = deg(0)}), "pitch 0 deg (now 40 down: up by 40)");
  EXPECT_EQ(text({.pitch = deg(40)}), "40 deg down (it is there)");
  EXPECT_EQ(text({.roll = deg(-5), .yaw = deg(20)}),
            "roll -5 deg (now 2: by -7), 20 deg right (now 30 right: left by 10)");
  EXPECT_EQ(target_text({.yaw = deg(-20)}, {}, "from"), "20 deg left (from 0: left by 20)");
}

TEST(MoveWay, AnglesWrapAsThoseOfBoards) {
  const Angles angles{.yaw = deg(719)};
  const MoveTarget target{.yaw = angle_after(angles.yaw, deg(2))};
  EXPECT_NEAR((*target.yaw).degrees(), -719, 0.03);
  EXPECT_EQ(target_text(target, angles), "719 deg left (now 719 right: right by 2)");
  EXPECT_EQ(angle_after(deg(10), deg(-30)),
            msg::Angle14(static_cast<std::int16_t>(deg(10).raw() + deg(-30).raw())));
}

TEST(MoveWay, MoreThanHalfATurnWarnsOfCables) {
  const auto warning = [](double from, double to) {
    return cable_warning({.yaw = deg(to)}, {.yaw = deg(from)});
  };
  EXPECT_EQ(warning(0, 180), "");
  EXPECT_EQ(warning(-90, 90), "");
  EXPECT_EQ(warning(170, -170), " Watch the cables: yaw turns by 340 deg.");
  EXPECT_EQ(warning(170, 190), " Watch the cables: yaw ends 190 deg from its zero.");
  EXPECT_EQ(warning(719, -719), " Watch the cables: yaw ends 719 deg from its zero.");
}

}  // namespace
}  // namespace sbgc::tools
