// Tests of calibrations: their progress, and what the memory keeps.

#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::Memory;

msg::CalibAccExt acc(msg::CalibAction action, msg::CalibImu imu = msg::CalibImu::main) {
  return {.imu_idx = imu, .action = action};
}
msg::CalibGyroExt gyro(msg::CalibAction action, msg::CalibImu imu = msg::CalibImu::main) {
  return {.imu_idx = imu, .action = action};
}

msg::CalibInfo info(Host& host, msg::SelectedImu imu = msg::SelectedImu::main) {
  return host.get<msg::CalibInfo>(msg::CalibInfoRequest{.imu_type = imu});
}

TEST(Calibrations, ProgressGoesFromNothingToAll) {
  Host host;
  EXPECT_EQ(info(host).progress, msg::Percent(0));
  host.ask(msg::CalibGyro{});
  int last = 0, steps = 0;
  for (int i = 0; i < 10; ++i) {
    const int now = info(host).progress.raw();
    EXPECT_GE(now, last);
    steps += now > last ? 1 : 0;
    last = now;
    host.listen(milliseconds(300));
  }
  EXPECT_GT(steps, 5);
  EXPECT_GT(last, 50);
  EXPECT_LT(last, 100);
  host.listen(seconds(2));
  EXPECT_EQ(info(host).progress, msg::Percent(100));
}

TEST(Calibrations, ResetForgetsThemAndRestarts) {
  Memory memory;
  memory.imus[0].acc_limits = 0x3F;
  memory.imus[1].acc_limits = 0x3F;
  Host host({}, memory);
  const Packets packets = host.ask(acc(msg::CalibAction::reset));
  EXPECT_EQ(confirmations<msg::CalibAcc>(packets), 1);
  host.listen(seconds(2));
  EXPECT_EQ(host.board.counters().restarts, 1U);
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimits{});
  EXPECT_EQ(info(host, msg::SelectedImu::frame).acc_limits_info, msg::CalibratedLimits(0x3F));
  EXPECT_TRUE(host.board.memory().imus[0].gyro_is_calibrated) << "that is another sensor";
}

TEST(Calibrations, SensorsKeepTheirOwn) {
  Memory memory;
  memory.sensors[0].acc_limits = 0x3F;
  memory.sensors[0].gyro_temperature_max = 50;
  Host host({}, memory);
  EXPECT_TRUE(is_confirmed(host, acc(msg::CalibAction::restore_factory)));
  EXPECT_EQ(confirmations<msg::CalibAcc>(host.listen(seconds(1))), 1);
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimits(0x3F));
  EXPECT_EQ(info(host).temp_calib_gyro_t_max_cels, msg::Temperature(0)) << "that is another sensor";

  host.ask(gyro(msg::CalibAction::temperature));
  host.listen(seconds(250));
  EXPECT_TRUE(is_confirmed(host, gyro(msg::CalibAction::store_in_sensor)));
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.listen(seconds(1))), 1);
  const Memory& after = host.board.memory();
  EXPECT_EQ(after.sensors[0].gyro_temperature_max, after.imus[0].gyro_temperature_max);
  EXPECT_TRUE(after.sensors[0].gyro_temperature_enabled);
}

TEST(Calibrations, ErasingTheEepromForgetsThem) {
  Memory memory;
  memory.battery_factor = 1.5;
  memory.imus[1].acc_limits = 0x3F;
  memory.sensors[1].acc_limits = 0x15;
  Host host({}, memory);
  EXPECT_TRUE(is_confirmed(host, msg::UseDefaults{.profile_id = msg::UseDefaults::erase_eeprom}));
  const Memory& after = host.board.memory();
  EXPECT_EQ(after.battery_factor, 1);
  EXPECT_EQ(info(host, msg::SelectedImu::frame).acc_limits_info, msg::CalibratedLimits{});
  EXPECT_EQ(after.sensors[1].acc_limits, 0x15) << "that is another EEPROM";
}

}  // namespace
}  // namespace sbgc::test
