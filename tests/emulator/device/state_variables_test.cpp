// Tests of the statistics of the board's whole life.

#include "replies.hpp"

namespace sbgc::test {
namespace {

msg::ReadStateVars statistics(Host& host) {
  return host.get<msg::ReadStateVars>(msg::ReadStateVarsRequest{});
}

TEST(StateVariables, CountTimeAndEnergy) {
  Host host(newest_board());
  const auto before = statistics(host);
  const double volts = host.board.gimbal().sample(host.now).battery;
  const double amperes = host.board.gimbal().sample(host.now).current;
  host.listen(seconds(3600));
  const auto after = statistics(host);
  EXPECT_NEAR((after.work_time.milliseconds() - before.work_time.milliseconds()) / 1000, 3600, 2);
  EXPECT_NEAR(after.energy.watt_hours() - before.energy.watt_hours(), volts * amperes,
              0.3 * volts * amperes);
  EXPECT_NEAR(after.avg_current.milliamperes(), 1000 * amperes, 300 * amperes);
  EXPECT_GT(after.imu_temp_max.raw(), 0);
  EXPECT_LE(after.imu_temp_min.raw(), after.imu_temp_max.raw());
  EXPECT_GE(after.max_current.milliamperes(), after.avg_current.milliamperes());
}

TEST(StateVariables, SurviveARestartWithTheNumberOfStarts) {
  Host host(newest_board());
  host.listen(seconds(600));
  const auto before = statistics(host);
  EXPECT_EQ(before.startup_cnt, 1);
  host.board.restart(host.now);
  host.listen(seconds(2));
  const auto after = statistics(host);
  EXPECT_EQ(after.startup_cnt, 2);
  EXPECT_GE(after.work_time.milliseconds(), before.work_time.milliseconds() - 61'000);
  EXPECT_GT(after.work_time.milliseconds(), 500'000);
  // Another board with the same memory goes on.
  Host again(newest_board(), host.board.memory());
  EXPECT_EQ(statistics(again).startup_cnt, 3);
}

TEST(StateVariables, AreNotStoredIfTheParametersForbidIt) {
  Host host(newest_board());
  auto parameters = host.get<msg::ReadParamsExt2>(msg::ReadParamsExt2Request{});
  parameters.general_flags2.set(msg::GeneralFlags2Bit::save_system_stat, false);
  host.ask(msg::WriteParamsExt2{parameters});
  const auto revision = host.board.memory().revision;
  host.listen(seconds(600));
  EXPECT_EQ(host.board.memory().revision, revision);
}

}  // namespace
}  // namespace sbgc::test
