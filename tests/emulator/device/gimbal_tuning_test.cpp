// What the settings mean for the mechanics.

#include "device/parts/gimbal_tuning.hpp"

#include <gtest/gtest.h>

#include <sbgc/validate.hpp>

namespace sbgc::board {
namespace {

Tuning tuning(const Settings& settings, double battery_factor = 1) {
  return tuning_of(settings, newest, true, battery_factor);
}

TEST(Tuning, TheGainFactorIsForAllGains) {
  Memory memory;
  Settings settings(memory);
  const AxisTuning before = tuning(settings).axes.pitch;
  auto more = settings.of<msg::ReadParamsExt2>();
  more.pid_gain.pitch = msg::PidGain::from_value(2);
  ASSERT_TRUE(settings.write(0, more));
  const AxisTuning after = tuning(settings).axes.pitch;
  EXPECT_NEAR(after.p, 2 * before.p, 1e-9);
  EXPECT_NEAR(after.i, 2 * before.i, 1e-9);
  EXPECT_NEAR(after.d, 2 * before.d, 1e-9);
  EXPECT_EQ(after.power, before.power);
}

TEST(Tuning, TheOffsetOfTheFollowModeIsOfEachAxis) {
  Memory memory;
  Settings settings(memory);
  auto main = settings.of<msg::ReadParams3>();
  main.follow_offset = {1, -20, 127};
  ASSERT_TRUE(settings.write(0, main));
  EXPECT_EQ(tuning(settings).axes.pitch.follow_offset, -20);
  EXPECT_EQ(tuning(settings).axes.yaw.follow_offset, 127);
}

TEST(Tuning, OldFirmwareHasOneLimitForAllAxes) {
  Memory memory;
  Settings settings(memory);
  auto main = settings.of<msg::ReadParams3>();
  main.acc_limiter_all = msg::AngularAcceleration(10);
  ASSERT_TRUE(settings.write(0, main));
  auto more = settings.of<msg::ReadParamsExt2>();
  more.acc_limiter3.yaw = msg::AngularAcceleration(40);
  ASSERT_TRUE(settings.write(0, more));
  EXPECT_EQ(tuning(settings).axes.yaw.acceleration, 200);
  EXPECT_EQ(tuning(settings).axes.roll.acceleration, 0) << "no limit";
  const Availability old{2430, 30};
  EXPECT_EQ(tuning_of(settings, old, true, 1).axes.yaw.acceleration, 50);
}

TEST(Tuning, TheMotorsStopAtWhatTheSensorShows) {
  Memory memory;
  Settings settings(memory);
  const double threshold = settings.of<msg::ReadParams3>().bat_threshold_motors.volts();
  EXPECT_NEAR(tuning(settings, 0.5).battery_stop, 2 * threshold, 1e-9);
  EXPECT_LT(tuning(settings, 0).battery_stop, 0) << "without a sensor never";
}

}  // namespace
}  // namespace sbgc::board
