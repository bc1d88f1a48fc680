// Tests of the motion of targets: modes, limits, arrival, RC signals, following.

#include "gimbal_rig.hpp"

namespace sbgc::emulator::test {
namespace {

struct Move {
  double speed, acceleration, distance;
};

class Limits : public testing::TestWithParam<Move> {};

TEST_P(Limits, AreKeptOnTheWayAndTheTargetIsReachedExactly) {
  const Move move = GetParam();
  Tuning tuning;
  tuning.axes.pitch.acceleration = move.acceleration;
  Gimbal gimbal = ready(quiet(), tuning);
  gimbal.command(pitch, {AxisMode::angle, move.speed, move.distance, 0}, ms(0));
  const double sign = move.distance < 0 ? -1 : 1;
  double before = 0;
  double fastest = 0;
  bool has_arrived = false;
  double way = 0;
  for (std::int64_t t = 1; t < 60000 && !has_arrived; ++t) {
    const Sample sample = gimbal.sample(ms(t));
    const double speed = sample.target_speeds.pitch * sign;
    ASSERT_LE(std::abs(speed - before), move.acceleration * 0.001 + 1e-9) << t;
    ASSERT_GE(speed, 0) << t;
    ASSERT_GE(sample.targets.pitch * sign, way - 1e-9) << t;
    fastest = std::max(fastest, speed);
    before = speed;
    way = sample.targets.pitch * sign;
    has_arrived = sample.targets.pitch == move.distance;
    ASSERT_LE(way, move.distance * sign + 1e-9) << t;
    ASSERT_TRUE(!has_arrived || speed == 0);
  }
  EXPECT_TRUE(has_arrived);
  EXPECT_LE(fastest, move.speed + 1e-9);
  const double possible = std::sqrt(move.acceleration * move.distance * sign);
  EXPECT_GT(fastest, 0.9 * std::min(move.speed, possible));
}

INSTANTIATE_TEST_SUITE_P(Moves, Limits,
                         testing::Values(Move{50, 100, 30}, Move{50, 500, -30}, Move{200, 20, 45},
                                         Move{3.7, 5, -0.4}, Move{10, 1000, 90}, Move{1, 7, 0.001},
                                         Move{1000, 13, 200}));

TEST(Motion, ATargetThatChangesIsFollowedWithinTheLimits) {
  Tuning tuning;
  tuning.axes.yaw.acceleration = 60;
  Gimbal gimbal = ready(quiet(), tuning);
  double before = 0;
  for (std::int64_t t = 0; t < 20000; t += 4) {
    if (t % 700 == 0) {
      const double angle = t % 1400 == 0 ? 40 : -25;
      gimbal.command(yaw, {AxisMode::angle, 80, angle, 0}, ms(t));
    }
    const Sample sample = gimbal.sample(ms(t));
    ASSERT_LE(std::abs(sample.target_speeds.yaw - before), 60 * 0.004 + 1e-9) << t;
    ASSERT_LE(std::abs(sample.target_speeds.yaw), 80) << t;
    before = sample.target_speeds.yaw;
  }
}

TEST(Motion, AngleMeansTheNearestModuloFourTurns) {
  Gimbal gimbal = ready();
  gimbal.place({0, 0, 700}, ms(0));
  gimbal.command(yaw, {AxisMode::angle, 200, -710, 0}, ms(0));  // = 730
  EXPECT_EQ(gimbal.sample(ms(3000)).targets.yaw, 730);
  gimbal.command(yaw, {AxisMode::angle, 400, 10, 0}, ms(3000));  // not the shorter way to 730 - 360
  EXPECT_EQ(gimbal.sample(ms(10000)).targets.yaw, 10);
}

TEST(Motion, SpeedAngleFollowsAnglesThatComeInSteps) {
  Gimbal gimbal = ready();
  double worst = 0;
  for (std::int64_t t = 0; t < 5000; t += 20) {
    const double angle = 0.02 * static_cast<double>(t);
    gimbal.command(pitch, {AxisMode::speed_angle, 20, angle, 0}, ms(t));
    if (t > 1000) worst = std::max(worst, std::abs(gimbal.sample(ms(t)).targets.pitch - angle));
  }
  EXPECT_LT(worst, 0.5);
  // Without further commands it holds the angle.
  const Sample sample = gimbal.sample(ms(20000));
  EXPECT_NEAR(sample.targets.pitch, 0.02 * 4980, 1e-9);
  EXPECT_EQ(sample.target_speeds.pitch, 0);
}

TEST(Motion, ARestartForgetsWholeTurnsOfTheJoints) {
  Gimbal gimbal = ready();
  gimbal.place({0, 0, 730}, ms(0));
  EXPECT_NEAR(gimbal.sample(ms(0)).joints.yaw, 730, 0.1);
  gimbal.restart(ms(100));
  EXPECT_NEAR(gimbal.sample(ms(100)).joints.yaw, 10, 0.1);
  EXPECT_NEAR(gimbal.sample(ms(100)).angles.yaw, 10, 0.1);
}

/// A tuning with limits of the yaw joint.
Tuning limited(double low, double high) {
  Tuning tuning;
  tuning.axes.yaw.joint_min = low;
  tuning.axes.yaw.joint_max = high;
  tuning.axes.yaw.acceleration = 100;
  return tuning;
}

TEST(JointLimits, HoldInAllModesAndTheTargetBrakesBefore) {
  for (const AxisCommand& command :
       {AxisCommand{AxisMode::angle, 40, 300}, AxisCommand{AxisMode::speed, 40},
        AxisCommand{AxisMode::speed_angle, 40, 300}, AxisCommand{AxisMode::signal, 0, 0, 1},
        AxisCommand{AxisMode::relative_angle, 40, 300}}) {
    for (const double sign : {1.0, -1.0}) {
      Gimbal gimbal = ready(quiet(), limited(-60, 60));
      gimbal.command(
          yaw, {command.mode, command.speed * sign, command.angle * sign, command.signal * sign},
          ms(0));
      double before = 0;
      double fastest = 0;
      for (std::int64_t t = 1; t < 5000; ++t) {
        const Sample sample = gimbal.sample(ms(t));
        const double speed = sample.target_speeds.yaw * sign;
        ASSERT_LE(std::abs(speed - before), 0.1 + 1e-9) << t;
        ASSERT_LE(sample.targets.yaw * sign, 60 + 1e-9) << t;
        fastest = std::max(fastest, speed);
        before = speed;
      }
      EXPECT_GT(fastest, 39);
      EXPECT_EQ(gimbal.sample(ms(5000)).targets.yaw, 60 * sign);
      EXPECT_EQ(gimbal.sample(ms(5000)).target_speeds.yaw, 0);
      // It leaves the limit immediately on command.
      gimbal.command(yaw, {AxisMode::speed, -40 * sign, 0, 0}, ms(5000));
      EXPECT_LT(gimbal.sample(ms(6000)).targets.yaw * sign, 32);
    }
  }
}

TEST(JointLimits, ThereAreNoneIfTheyAreEqualOrTheWrongWayRound) {
  for (const double limit : {0.0, 10.0}) {
    Gimbal gimbal = ready(quiet(), limited(limit, -limit));
    gimbal.command(yaw, {AxisMode::angle, 90, 120, 0}, ms(0));
    EXPECT_EQ(gimbal.sample(ms(5000)).targets.yaw, 120);
  }
}

/// A frame that turns about the vertical by 60 degrees, from 1 s to 3 s.
Gimbal::Options turning_frame() {
  Gimbal::Options options = quiet();
  options.frame.kind = Disturbance::Kind::recorded;
  options.frame.recording = {
      {ms(0), {}}, {ms(1000), {}}, {ms(3000), {0, 0, 60}}, {ms(60000), {0, 0, 60}}};
  return options;
}

TEST(JointLimits, AFrameThatTurnsTakesTheCameraWithIt) {
  Gimbal gimbal = ready(turning_frame(), limited(-20, 45));
  EXPECT_EQ(gimbal.sample(ms(1000)).targets.yaw, 0);
  for (std::int64_t t = 1000; t < 8000; t += 20) {
    // The target cannot accelerate as fast as the frame does.
    ASSERT_GT(gimbal.sample(ms(t)).joints.yaw, -20 - 10) << t;
  }
  EXPECT_NEAR(gimbal.sample(ms(8000)).joints.yaw, -20, 0.1);
  EXPECT_NEAR(gimbal.sample(ms(8000)).targets.yaw, 40, 0.1);
}

TEST(JointLimits, HoldAfterALongPauseToo) {
  Gimbal gimbal = ready(quiet(), limited(-20, 45));
  gimbal.command(yaw, {AxisMode::speed, 0.001, 0, 0}, ms(0));
  EXPECT_NEAR(gimbal.sample(ms(3'600'000)).targets.yaw, 3.6, 0.01);
  constexpr std::int64_t three_years = 100'000'000'000;
  EXPECT_EQ(gimbal.sample(ms(three_years)).targets.yaw, 45);
  EXPECT_EQ(gimbal.sample(ms(three_years)).target_speeds.yaw, 0);
}

TEST(Follow, TurnsWithTheFrameOutsideItsDeadband) {
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  tuning.axes.yaw.follow_speed = 15;
  tuning.axes.yaw.follow_deadband = 5;
  Gimbal gimbal = ready(turning_frame(), tuning);
  EXPECT_EQ(gimbal.sample(ms(1000)).targets.yaw, 0);
  for (std::int64_t t = 1000; t < 10000; t += 20) {
    ASSERT_LE(gimbal.sample(ms(t)).target_speeds.yaw, 15 + 1e-9);
  }
  const Sample sample = gimbal.sample(ms(15000));
  EXPECT_NEAR(sample.targets.yaw, 55, 0.1);
  EXPECT_EQ(sample.target_speeds.yaw, 0);
}

TEST(Follow, TheNeutralPositionCanBeBesideTheFrame) {
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  tuning.axes.yaw.follow_offset = 25;
  tuning.axes.yaw.start_angle = 5;
  Gimbal gimbal = ready(turning_frame(), tuning);
  EXPECT_NEAR(gimbal.sample(ms(15000)).joints.yaw, 30, 0.1) << "at the start";
  gimbal.set_remote(yaw, 0.0, ms(15000));
  EXPECT_NEAR(gimbal.sample(ms(25000)).joints.yaw, 25, 0.1);
  tuning.axes.yaw.follow_offset = -10;
  gimbal.tune(tuning, ms(25000));
  EXPECT_NEAR(gimbal.sample(ms(35000)).joints.yaw, -10, 0.1);
  tuning.axes.yaw.follows = false;
  gimbal.tune(tuning, ms(35000));
  EXPECT_NEAR(gimbal.sample(ms(45000)).targets.yaw, 0, 0.1) << "world angles have no follow offset";
}

TEST(Follow, AnglesOfTheWorldDoNot) {
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  Gimbal gimbal = ready(turning_frame(), tuning);
  gimbal.command(yaw, {AxisMode::angle, 0, 10, 0}, ms(500));
  EXPECT_EQ(gimbal.sample(ms(15000)).targets.yaw, 10);
  // Nor does it jump to the frame when control ends.
  gimbal.command(yaw, {}, ms(15000));
  EXPECT_EQ(gimbal.sample(ms(25000)).targets.yaw, 10);
}

TEST(Follow, AnAngleThatIsToldReplacesTheFrame) {
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  tuning.axes.yaw.follow_speed = 15;
  Gimbal gimbal = ready(turning_frame(), tuning);
  gimbal.set_followed(yaw, 0, ms(0));
  EXPECT_EQ(gimbal.sample(ms(5000)).targets.yaw, 0) << "the frame has turned";
  gimbal.set_followed(yaw, -20, ms(5000));
  EXPECT_NEAR(gimbal.sample(ms(6000)).target_speeds.yaw, -15, 0.1);
  EXPECT_NEAR(gimbal.sample(ms(9000)).targets.yaw, -20, 0.1);
  gimbal.set_followed(yaw, {}, ms(9000));
  EXPECT_NEAR(gimbal.sample(ms(15000)).targets.yaw, -20, 0.1) << "from there with the frame";
  gimbal.set_followed(yaw, 5, ms(15000));
  gimbal.restart(ms(16000));
  gimbal.set_motors(true, ms(16000));
  EXPECT_NEAR(gimbal.sample(ms(20000)).joints.yaw, 0, 0.1) << "it has forgotten that";
}

TEST(Follow, LimitsOfAccelerationHoldForBothWaysTogether) {
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  tuning.axes.yaw.acceleration = 80;
  Gimbal gimbal = ready(moving(Disturbance::Kind::vehicle, 3), tuning);
  double before = 0;
  for (std::int64_t t = 0; t < 30000; t += 4) {
    if (t % 3000 == 0) {
      gimbal.command(yaw, {AxisMode::speed, t % 6000 == 0 ? 40.0 : -40.0, 0, 0}, ms(t));
    }
    const double speed = gimbal.sample(ms(t)).target_speeds.yaw;
    ASSERT_LE(std::abs(speed - before), 80 * 0.004 + 1e-9) << t;
    before = speed;
  }
}

}  // namespace
}  // namespace sbgc::emulator::test
