// Tests of calibrations: confirmations, results and storage, and disturbances.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;
using emulator::Memory;
using ::testing::IsEmpty;

msg::CalibAccExt acc(msg::CalibAction action, msg::CalibImu imu = msg::CalibImu::main) {
  return {.imu_idx = imu, .action = action};
}
msg::CalibGyroExt gyro(msg::CalibAction action, msg::CalibImu imu = msg::CalibImu::main) {
  return {.imu_idx = imu, .action = action};
}

msg::CalibInfo info(Host& host, msg::SelectedImu imu = msg::SelectedImu::main) {
  return host.get<msg::CalibInfo>(msg::CalibInfoRequest{.imu_type = imu});
}

TEST(Calibrations, GyroscopeIsConfirmedOnReceptionAndAtTheEnd) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, msg::CalibGyro{}));
  EXPECT_THAT(host.listen(milliseconds(3800)), IsEmpty());
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.listen(milliseconds(400))), 1);
  EXPECT_THAT(host.listen(seconds(30)), IsEmpty());
}

TEST(Calibrations, AccelerometerLearnsTheDirectionThatPointsUp) {
  Host host;
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimits{});
  EXPECT_EQ(info(host).acc_cur_axis, 2);
  EXPECT_TRUE(is_confirmed(host, msg::CalibAcc{}));
  EXPECT_EQ(confirmations<msg::CalibAcc>(host.listen(milliseconds(3200))), 1);
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimit::plus_z);

  host.board.gimbal().place({90, 0, 0}, host.now);
  EXPECT_EQ(info(host).acc_cur_axis, 0);
  EXPECT_TRUE(is_confirmed(host, acc(msg::CalibAction::regular)));
  EXPECT_EQ(confirmations<msg::CalibAcc>(host.listen(milliseconds(3200))), 1);
  const auto limits = info(host).acc_limits_info;
  EXPECT_TRUE(limits == (msg::CalibratedLimit::plus_z | msg::CalibratedLimit::plus_x) ||
              limits == (msg::CalibratedLimit::plus_z | msg::CalibratedLimit::minus_x));
}

TEST(Calibrations, EachImuHasItsOwn) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, acc(msg::CalibAction::regular, msg::CalibImu::frame)));
  host.listen(seconds(4));
  EXPECT_EQ(info(host, msg::SelectedImu::frame).acc_limits_info, msg::CalibratedLimit::plus_z);
  EXPECT_EQ(info(host, msg::SelectedImu::main).acc_limits_info, msg::CalibratedLimits{});
}

TEST(Calibrations, TheActiveImuIsTheOneThatWasSelected) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, msg::SelectImu3{.imu_type = msg::SelectedImu::frame}));
  EXPECT_TRUE(is_confirmed(host, msg::CalibAcc{}));
  host.listen(seconds(4));
  EXPECT_EQ(info(host, msg::SelectedImu::frame).acc_limits_info, msg::CalibratedLimit::plus_z);
}

TEST(Calibrations, AWrongParameterIsMetWithSilence) {
  BoardOptions options;
  options.has_frame_imu = false;
  Host host(options);
  EXPECT_THAT(host.ask(acc(msg::CalibAction{0})), IsEmpty());
  EXPECT_THAT(host.ask(gyro(msg::CalibAction{8})), IsEmpty());
  EXPECT_THAT(host.ask(acc(msg::CalibAction::regular, msg::CalibImu{3})), IsEmpty());
  EXPECT_THAT(host.ask(gyro(msg::CalibAction::regular, msg::CalibImu::frame)), IsEmpty());
  EXPECT_THAT(host.listen(seconds(10)), IsEmpty());
}

TEST(Calibrations, InformationNeedsAnImuThatIsThere) {
  BoardOptions options;
  options.has_frame_imu = false;
  Host host(options);
  EXPECT_EQ(refusal(host, msg::CalibInfoRequest{.imu_type = msg::SelectedImu::frame}),
            msg::BoardErrorCode::not_supported);
  EXPECT_EQ(refusal(host, msg::CalibInfoRequest{.imu_type = msg::SelectedImu{3}}),
            msg::BoardErrorCode::wrong_params);
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

TEST(Calibrations, LiveDataAreThoseOfTheImu) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  const msg::CalibInfo still = info(host);
  EXPECT_NEAR(still.acc_data.z.g(), 1, 0.02);
  EXPECT_NEAR(still.imu_temp_cels.degrees_celsius(),
              host.board.gimbal().sample(host.now).temperature, 1);
  host.board.gimbal().command(2, {.mode = emulator::AxisMode::speed, .speed = 40}, host.now);
  host.listen(seconds(2));
  EXPECT_NEAR(info(host).gyro_abs_val * msg::GyroRate(1).degrees_per_second(), 40, 4);
  EXPECT_GT(info(host).gyro_abs_val, still.gyro_abs_val);
}

TEST(Calibrations, OneAtATime) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, msg::CalibGyro{}));
  EXPECT_EQ(refusal(host, msg::CalibAcc{}), msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(refusal(host, acc(msg::CalibAction::reset)), msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(refusal(host, msg::CalibPoles{}), msg::BoardErrorCode::wrong_state);
  const Packets packets = host.listen(seconds(5));
  EXPECT_EQ(packets.size(), 1U);
  EXPECT_EQ(confirmations<msg::CalibGyro>(packets), 1);
  EXPECT_TRUE(is_confirmed(host, msg::CalibAcc{}));
}

TEST(Calibrations, WhoHasAskedIsToldOfTheEnd) {
  Host host;
  const auto first = host.port;
  const auto other = host.board.open_port().value();
  EXPECT_TRUE(is_confirmed(host, msg::CalibGyro{}));
  host.port = other;
  EXPECT_EQ(refusal(host, msg::CalibGyro{}), msg::BoardErrorCode::wrong_state);
  EXPECT_THAT(host.listen(seconds(5)), IsEmpty());
  host.port = first;
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.listen({})), 1);
}

TEST(Calibrations, AGimbalThatMovesIsWaitedFor) {
  Host host;
  host.board.gimbal().command(2, {.mode = emulator::AxisMode::speed, .speed = 30}, host.now);
  host.listen(seconds(1));
  EXPECT_TRUE(is_confirmed(host, msg::CalibGyro{}));
  EXPECT_THAT(host.listen(seconds(5)), IsEmpty());
  EXPECT_EQ(info(host).progress, msg::Percent(0));
  host.board.gimbal().command(2, {.mode = emulator::AxisMode::speed, .speed = 0}, host.now);
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.listen(seconds(6))), 1);
}

TEST(Calibrations, AGimbalThatKeepsMovingCannotBeCalibrated) {
  Host host;
  host.board.gimbal().command(2, {.mode = emulator::AxisMode::speed, .speed = 30}, host.now);
  host.listen(seconds(1));
  EXPECT_TRUE(is_confirmed(host, msg::CalibAcc{}));
  EXPECT_EQ(refusal<msg::CalibAcc>(host.listen(seconds(25))),
            msg::BoardErrorCode::operation_failed);
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimits{});
  const auto errors = host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).system_error;
  EXPECT_TRUE(errors.has(msg::SystemError::calib_acc));
}

TEST(Calibrations, OverTemperatureTakesMinutes) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, gyro(msg::CalibAction::temperature)));
  EXPECT_THAT(host.listen(seconds(200)), IsEmpty());
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.listen(seconds(100))), 1);
  const msg::CalibInfo one = info(host);
  EXPECT_EQ(one.temp_calib_gyro_enabled, 1);
  // The board warms up continuously.
  EXPECT_LT(one.temp_calib_gyro_t_min_cels, one.temp_calib_gyro_t_max_cels);
  EXPECT_NEAR(one.temp_calib_gyro_t_max_cels.raw(), one.imu_temp_cels.raw(), 3);
  EXPECT_EQ(one.temp_calib_acc_enabled, 0);
}

TEST(Calibrations, AccelerometerHasThreeTemperaturesForEachDirection) {
  Host host;
  for (int i = 1; i <= 4; ++i) {
    host.ask(acc(msg::CalibAction::temperature));
    host.listen(seconds(250));
    const msg::CalibInfo one = info(host);
    EXPECT_EQ(one.temp_calib_acc_slot_num[2], std::min(i, 3));
    EXPECT_EQ(one.temp_calib_acc_enabled, 1);
    EXPECT_TRUE(one.acc_limits_info.has(msg::CalibratedLimit::plus_z));
  }
}

TEST(Calibrations, TemperatureCanBeSwitchedOffAndOnAgain) {
  Host host;
  host.ask(acc(msg::CalibAction::temperature));
  host.listen(seconds(250));
  const msg::CalibInfo before = info(host);

  const Packets packets = host.ask(acc(msg::CalibAction::disable_temperature));
  EXPECT_EQ(confirmations<msg::CalibAcc>(packets), 1);
  host.listen(seconds(2));
  EXPECT_EQ(host.board.counters().restarts, 1U);
  EXPECT_EQ(info(host).temp_calib_acc_enabled, 0);
  EXPECT_EQ(info(host).temp_calib_acc_slot_num, before.temp_calib_acc_slot_num);

  host.ask(acc(msg::CalibAction::enable_temperature));
  host.listen(seconds(2));
  EXPECT_EQ(host.board.counters().restarts, 2U);
  EXPECT_EQ(info(host).temp_calib_acc_enabled, 1);
}

TEST(Calibrations, WhatIsNotThereIsNotSwitchedOn) {
  Host host;
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.ask(gyro(msg::CalibAction::enable_temperature))), 1);
  host.listen(seconds(2));
  EXPECT_EQ(info(host).temp_calib_gyro_enabled, 0);
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

TEST(Calibrations, PolesAreConfirmedAtTheEndOnly) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.axes.pitch.poles = 99;
  msg::WriteParams3 write;
  static_cast<msg::ReadParams3&>(write) = parameters;
  EXPECT_TRUE(is_confirmed(host, write));
  EXPECT_THAT(host.ask(msg::CalibPoles{}), IsEmpty());
  EXPECT_THAT(host.listen(seconds(9)), IsEmpty());
  EXPECT_EQ(confirmations<msg::CalibPoles>(host.listen(seconds(2))), 1);
  EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.pitch.poles, 14);
}

TEST(Calibrations, GainsOfAFlightController) {
  Host host;
  EXPECT_THAT(host.ask(msg::CalibExtGain{}), IsEmpty());
  EXPECT_EQ(confirmations<msg::CalibExtGain>(host.listen(seconds(6))), 1);
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  EXPECT_NE(parameters.ext_fc_gain_roll, 0);
  EXPECT_NE(parameters.ext_fc_gain_pitch, 0);
}

TEST(Calibrations, ChangeTheProfileThatWasActiveWhenTheyBegan) {
  Host host;
  EXPECT_THAT(host.ask(msg::CalibExtGain{}), IsEmpty());
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile2});
  EXPECT_EQ(confirmations<msg::CalibExtGain>(host.listen(seconds(6))), 1);
  const auto gain = [&](std::uint8_t profile) {
    const msg::ReadParams3Request request{.profile_id = profile};
    return host.get<msg::ReadParams3>(request).ext_fc_gain_roll;
  };
  EXPECT_NE(gain(0), 0);
  EXPECT_EQ(gain(1), 0);
}

TEST(Calibrations, OffsetsOfTheFollowMode) {
  Host host;
  host.board.gimbal().place({0, -20, 35}, host.now);
  EXPECT_TRUE(is_confirmed(host, msg::CalibOffset{}));
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  EXPECT_NEAR(parameters.follow_offset.pitch, -20, 1);
  EXPECT_NEAR(parameters.follow_offset.yaw, 35, 1);

  host.board.gimbal().place({0, 0, 170}, host.now);
  EXPECT_EQ(refusal(host, msg::CalibOffset{}), msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).follow_offset.yaw,
            parameters.follow_offset.yaw);
}

TEST(Calibrations, BatteryShowsTheVoltageThatWasGiven) {
  Host host;
  const double shown = host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).bat_level.volts();
  EXPECT_TRUE(is_confirmed(host, msg::CalibBat{*msg::Voltage::from_volts(shown * 1.1)}));
  EXPECT_NEAR(host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).bat_level.volts(),
              shown * 1.1, 0.1);
  const double factor = host.board.memory().battery_factor;
  EXPECT_EQ(refusal(host, msg::CalibBat{msg::Voltage(1)}), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(host.board.memory().battery_factor, factor);
}

TEST(Calibrations, TheMotorsObeyTheBatteryAsItShowsAtOnce) {
  Host host;
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const double stop = parameters.bat_threshold_motors.volts();
  host.ask(msg::CalibBat{*msg::Voltage::from_volts(stop - 0.5)});
  EXPECT_TRUE(host.board.gimbal().stopped_by_battery());
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

TEST(Calibrations, Magnetometer) {
  Host host;
  EXPECT_TRUE(is_confirmed(host, msg::CalibMag{}));
  EXPECT_LT(info(host).progress.raw(), 100);
  EXPECT_THAT(host.listen(seconds(25)), IsEmpty());
  EXPECT_EQ(info(host).progress, msg::Percent(100));
}

TEST(Calibrations, EncodersCountFromThePresentPosition) {
  Host host;
  host.board.gimbal().place({0, -30, 0}, host.now);
  EXPECT_TRUE(is_confirmed(host, msg::EncodersCalibOffset4{}));
  host.listen(seconds(2));
  const auto parameters = host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{});
  EXPECT_NEAR(parameters.encoder_offset.pitch.degrees(), -30, 1);
  EXPECT_TRUE(is_confirmed(host, msg::EncodersCalibFldOffset4{}));
  host.listen(seconds(12));
  EXPECT_NE(host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{}).encoder_fld_offset,
            parameters.encoder_fld_offset);
}

TEST(Calibrations, NothingIsDoneToEncodersThatAreNotThere) {
  BoardOptions options;
  options.features = msg::BoardFeature::three_axis;
  Host host(options);
  EXPECT_EQ(refusal(host, msg::EncodersCalibOffset4{}), msg::BoardErrorCode::not_supported);
  EXPECT_EQ(refusal(host, msg::EncodersCalibFldOffset4{}), msg::BoardErrorCode::not_supported);
}

TEST(Calibrations, AHostThatHasLeftGetsNothing) {
  Host host;
  host.ask(msg::CalibGyro{});
  host.board.close_port(host.port);
  ASSERT_EQ(host.board.open_port(), host.port) << "the next host has the same port";
  EXPECT_THAT(host.listen(seconds(10)), IsEmpty());
  EXPECT_EQ(info(host).progress, msg::Percent(100)) << "it continued nevertheless";
}

TEST(Calibrations, ARestartEndsThem) {
  Host host;
  host.ask(msg::CalibGyro{});
  host.board.restart(host.now);
  EXPECT_THAT(host.listen(seconds(10)), IsEmpty());
  EXPECT_EQ(info(host).progress, msg::Percent(0));
  EXPECT_TRUE(is_confirmed(host, msg::CalibGyro{}));
}

TEST(Calibrations, TheMenuStartsThem) {
  Host host;
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::calib_acc});
  EXPECT_EQ(refusal(host, msg::CalibGyro{}), msg::BoardErrorCode::wrong_state);
  EXPECT_THAT(host.listen(seconds(5)), IsEmpty()) << "no request is awaiting a confirmation";
  EXPECT_EQ(info(host).acc_limits_info, msg::CalibratedLimit::plus_z);
}

TEST(Calibrations, TestsNeedNotWait) {
  BoardOptions options;
  options.calibration_time = 0;
  Host host(options);
  EXPECT_EQ(confirmations<msg::CalibGyro>(host.ask(msg::CalibGyro{})), 2);
  EXPECT_EQ(confirmations<msg::CalibAcc>(host.ask(acc(msg::CalibAction::temperature))), 2);
  EXPECT_EQ(confirmations<msg::CalibPoles>(host.ask(msg::CalibPoles{})), 1);
}

}  // namespace
}  // namespace sbgc::test
