// Tests of the effect of parameters on the mechanics.

#include "device/parameters/gimbal_tuning.hpp"

#include <gtest/gtest.h>

#include <sbgc/validate.hpp>

namespace sbgc::emulator {
namespace {

Tuning tuning(const Parameters& parameters, double battery_factor = 1) {
  return tuning_of(parameters, newest, true, battery_factor);
}

TEST(Tuning, TheGainFactorIsForAllGains) {
  Memory memory;
  Parameters parameters(memory);
  const AxisTuning before = tuning(parameters).axes.pitch;
  auto more = parameters.of<msg::ReadParamsExt2>();
  more.pid_gain.pitch = *msg::PidGain::from_value(2);
  ASSERT_TRUE(parameters.write(0, more));
  const AxisTuning after = tuning(parameters).axes.pitch;
  EXPECT_NEAR(after.p, 2 * before.p, 1e-9);
  EXPECT_NEAR(after.i, 2 * before.i, 1e-9);
  EXPECT_NEAR(after.d, 2 * before.d, 1e-9);
  EXPECT_EQ(after.power, before.power);
}

TEST(Tuning, TheOffsetOfTheFollowModeIsOfEachAxis) {
  Memory memory;
  Parameters parameters(memory);
  auto main = parameters.of<msg::ReadParams3>();
  main.follow_offset = {1, -20, 127};
  ASSERT_TRUE(parameters.write(0, main));
  EXPECT_EQ(tuning(parameters).axes.pitch.follow_offset, -20);
  EXPECT_EQ(tuning(parameters).axes.yaw.follow_offset, 127);
}

TEST(Tuning, TheMotorsStopAtWhatTheSensorShows) {
  Memory memory;
  Parameters parameters(memory);
  const double threshold = parameters.of<msg::ReadParams3>().bat_threshold_motors.volts();
  EXPECT_NEAR(tuning(parameters, 0.5).battery_stop, 2 * threshold, 1e-9);
  EXPECT_LT(tuning(parameters, 0).battery_stop, 0) << "the motors never stop without a sensor";
}

}  // namespace
}  // namespace sbgc::emulator
