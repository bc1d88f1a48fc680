// Tests of the stabilization of the camera: with faults, motors off, and low battery.

#include "gimbal_rig.hpp"

namespace sbgc::emulator::test {
namespace {

Tuning weak() {
  Tuning tuning;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    tuning.axes[axis].p = 1;
    tuning.axes[axis].d = 1;
    tuning.axes[axis].power = 20;
  }
  return tuning;
}

class Frames : public testing::TestWithParam<Disturbance::Kind> {};

TEST_P(Frames, AreKeptAwayFromTheCamera) {
  Gimbal gimbal = ready(moving(GetParam()));
  const double error = worst_error(gimbal, 5000, 60000);
  EXPECT_LT(error, 0.1);
  EXPECT_GT(error, 0.002) << "nothing is perfect";
}

TEST_P(Frames, MoveTheCameraWhenTuningIsWeak) {
  Gimbal gimbal = ready(moving(GetParam()), weak());
  EXPECT_GT(worst_error(gimbal, 5000, 60000), 0.3);
}

TEST_P(Frames, CarryTheCameraWhenMotorsAreOff) {
  Gimbal gimbal(moving(GetParam()), ms(0));
  const Sample first = gimbal.sample(ms(0));
  double widest = 0;
  for (std::int64_t t = 0; t < 60000; t += 7) {
    const Sample sample = gimbal.sample(ms(t));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(sample.joints[axis], first.joints[axis]);
      ASSERT_NEAR(sample.angles[axis], sample.frame[axis] + sample.joints[axis], 1e-9);
    }
    ASSERT_EQ(sample.targets.pitch, sample.angles.pitch);
    widest = std::max(widest, std::abs(sample.angles.pitch));
  }
  EXPECT_GT(widest, 1);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Frames,
                         testing::Values(Disturbance::Kind::handheld, Disturbance::Kind::drone,
                                         Disturbance::Kind::vehicle));

TEST(Hold, OneAxisWithoutPowerMovesWithTheFrame) {
  Tuning tuning;
  tuning.axes.roll.power = 0;
  Gimbal gimbal = ready(moving(Disturbance::Kind::handheld), tuning);
  const Sample sample = gimbal.sample(ms(9000));
  EXPECT_NEAR(sample.angles.roll, sample.frame.roll, 1e-9);
  EXPECT_EQ(sample.power.roll, 0);
  EXPECT_NEAR(sample.angles.pitch, sample.targets.pitch, 0.1);
}

TEST(Hold, HelpFromOutsideMakesItBetter) {
  Gimbal alone = ready(moving(Disturbance::Kind::handheld));
  Gimbal helped = ready(moving(Disturbance::Kind::handheld));
  double with = 0;
  double without = 0;
  for (std::int64_t t = 0; t < 30000; t += 5) {
    if (t % 100 == 0) helped.help(ms(t));
    if (t < 5000) continue;  // both have just started to hold
    with = std::max(with, worst_error(helped, t, t + 1));
    without = std::max(without, worst_error(alone, t, t + 1));
  }
  EXPECT_LT(with, 0.8 * without);
}

TEST(Hold, APushedCameraComesBack) {
  Gimbal gimbal = ready();
  gimbal.push(pitch, 20, ms(5000));
  EXPECT_NEAR(gimbal.sample(ms(5000)).angles.pitch, 20, 0.2);
  EXPECT_EQ(gimbal.sample(ms(5000)).targets.pitch, 0);
  EXPECT_NEAR(gimbal.sample(ms(7000)).angles.pitch, 0, 0.5);
  EXPECT_NEAR(gimbal.sample(ms(15000)).angles.pitch, 0, 0.01);
}

TEST(Hold, APushedCameraStaysWhenMotorsAreOff) {
  Gimbal gimbal = ready();
  gimbal.set_motors(false, ms(1000));
  gimbal.push(pitch, 20, ms(2000));
  EXPECT_NEAR(gimbal.sample(ms(9000)).angles.pitch, 20, 0.2);
  // This position is held when the motors turn on again.
  gimbal.set_motors(true, ms(9000));
  EXPECT_NEAR(gimbal.sample(ms(12000)).angles.pitch, 20, 0.2);
}

TEST(Hold, MotorsOnGoOnWithTheCommand) {
  Gimbal gimbal = ready();
  gimbal.set_motors(false, ms(0));
  gimbal.command(yaw, {AxisMode::angle, 0, 15, 0}, ms(1000));
  EXPECT_EQ(gimbal.sample(ms(5000)).target_speeds.yaw, 0);
  EXPECT_EQ(gimbal.sample(ms(5000)).angles.yaw, 0);
  gimbal.set_motors(true, ms(5000));
  EXPECT_EQ(gimbal.sample(ms(8000)).targets.yaw, 15);
}

TEST(Hold, AJammedJointDoesNotTurn) {
  Gimbal gimbal = ready();
  const Sample before = gimbal.sample(ms(1000));
  gimbal.jam(pitch, true, ms(1000));
  gimbal.command(pitch, {AxisMode::angle, 0, -40, 0}, ms(1000));
  gimbal.push(pitch, 5, ms(2000));
  const Sample stuck = gimbal.sample(ms(4000));
  EXPECT_EQ(stuck.joints.pitch, before.joints.pitch);
  EXPECT_EQ(stuck.targets.pitch, -40);
  EXPECT_GT(stuck.power.pitch, 1.3 * before.power.pitch);
  EXPECT_GT(stuck.current, before.current + 0.1);
  gimbal.jam(pitch, false, ms(4000));
  EXPECT_NEAR(gimbal.sample(ms(9000)).angles.pitch, -40, 0.05);
}

TEST(Hold, ImbalanceCostsItsShareOfThePower) {
  Gimbal::Options options = quiet();
  options.imbalance = {0.1, -0.2, 0};
  Gimbal gimbal = ready(options);
  const Sample sample = gimbal.sample(ms(20000));
  EXPECT_NEAR(sample.imbalance.roll, 0.1, 0.005);
  EXPECT_NEAR(sample.imbalance.pitch, -0.2, 0.005);
  EXPECT_NEAR(sample.imbalance.yaw, 0, 0.005);
}

TEST(Hold, ItIsHeldAgainstImbalanceWithoutErrorByTheIntegralPart) {
  Tuning without;
  without.axes.pitch.i = 0;
  Gimbal gimbal = ready();
  Gimbal lazy = ready(quiet(), without);
  EXPECT_NEAR(gimbal.sample(ms(20000)).angles.pitch, 0, 0.005);
  EXPECT_GT(std::abs(lazy.sample(ms(20000)).angles.pitch), 0.05);
}

TEST(Battery, FallsWhileItIsUsed) {
  Gimbal gimbal = ready();
  const double full = gimbal.sample(ms(0)).battery;
  const double later = gimbal.sample(ms(3'600'000)).battery;
  const double much_later = gimbal.sample(ms(7'200'000)).battery;
  EXPECT_NEAR(full, 16.4, 0.1);
  EXPECT_LT(later, full - 0.1);
  EXPECT_LT(much_later, later - 0.1);
  EXPECT_GT(much_later, 10);
}

TEST(Battery, StopsTheMotorsWhenItIsLow) {
  Tuning tuning;
  tuning.battery_stop = 14;
  Gimbal gimbal = ready(quiet(), tuning);
  gimbal.command(yaw, {AxisMode::speed, 30, 0, 0}, ms(0));
  EXPECT_TRUE(gimbal.motors_on());
  gimbal.set_battery(13.9, ms(1000));
  EXPECT_FALSE(gimbal.motors_on());
  EXPECT_TRUE(gimbal.stopped_by_battery());
  EXPECT_EQ(gimbal.sample(ms(1000)).battery, 13.9);
  EXPECT_EQ(gimbal.sample(ms(3000)).speeds.yaw, 0);
  EXPECT_EQ(gimbal.sample(ms(3000)).power, (Axes<double>{}));
  // They do not turn on while it is low.
  gimbal.set_motors(true, ms(4000));
  EXPECT_FALSE(gimbal.motors_on());
  gimbal.set_battery(15, ms(5000));
  gimbal.set_motors(true, ms(5000));
  EXPECT_TRUE(gimbal.motors_on());
  EXPECT_FALSE(gimbal.stopped_by_battery());
}

TEST(Battery, StopsTheMotorsWhenItHasBeenUsedUp) {
  Gimbal::Options options = quiet();
  options.capacity = 0.2;
  Tuning tuning;
  tuning.battery_stop = 13;
  Gimbal gimbal = ready(options, tuning);
  EXPECT_FALSE((gimbal.sample(ms(60'000)), gimbal.stopped_by_battery()));
  EXPECT_TRUE((gimbal.sample(ms(7'200'000)), gimbal.stopped_by_battery()));
}

}  // namespace
}  // namespace sbgc::emulator::test
