// Tests of the correction of gyroscopes.

#include <cmath>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;

TEST(GyroCorrection, IsRemembered) {
  Host host;
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::frame};
  request.gyro_zero_corr = {msg::GyroOffset(100), msg::GyroOffset(0), msg::GyroOffset(-200)};
  EXPECT_TRUE(is_confirmed(host, request));
  const auto& kept = host.board.memory().imus;
  EXPECT_GT(kept[1].gyro_offset.x, 0);
  EXPECT_NEAR(kept[1].gyro_offset.z, -2 * kept[1].gyro_offset.x, 1e-9);
  EXPECT_EQ(kept[0].gyro_offset, emulator::Vector{});
}

TEST(GyroCorrection, IsInForceWhenTheBoardIsSwitchedOn) {
  BoardOptions options;
  options.gimbal.noise = 0;
  emulator::Memory memory;
  memory.imus[0].gyro_offset = {0, 0, 0.5};
  Host plain(options), corrected(options, memory);
  for (Host* host : {&plain, &corrected}) host->listen(seconds(60));
  EXPECT_GT(std::abs(plain.board.gimbal().sample(plain.now).joints.yaw -
                     corrected.board.gimbal().sample(corrected.now).joints.yaw),
            1);
}

/// Returns the gyroscope's reading for a camera at rest: with motors on, it would turn so that this
/// is 0.
double still(Host& host) {
  host.ask(msg::MotorsOff{}, seconds(2));
  return host.board.gimbal().sample(host.now).gyro.z;
}

TEST(GyroCorrection, IsForgottenWithTheCalibrations) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::main};
  request.gyro_zero_corr.z = msg::GyroOffset(4000);
  host.ask(request);
  EXPECT_LT(still(host), -0.1);
  host.ask(msg::CalibGyroExt{.imu_idx = msg::CalibImu::main, .action = msg::CalibAction::reset});
  host.listen(seconds(3));
  EXPECT_EQ(host.board.memory().imus[0].gyro_offset, emulator::Vector{});
  EXPECT_NEAR(still(host), 0, 0.1);
}

TEST(GyroCorrection, OfTheSensorIsInForceWhenItIsCopied) {
  BoardOptions options;
  options.gimbal.noise = 0;
  emulator::Memory memory;
  memory.sensors[0].gyro_offset = {0, 0, 0.5};
  Host host(options, memory);
  host.ask(msg::CalibGyroExt{.imu_idx = msg::CalibImu::main,
                             .action = msg::CalibAction::restore_factory});
  host.listen(seconds(1));
  EXPECT_LT(still(host), -0.3);
}

TEST(GyroCorrection, ACalibrationAtTheStartReplacesIt) {
  BoardOptions options;
  options.gimbal.noise = 0;
  Host host(options);
  msg::GyroCorrection request{.imu_type = msg::ImuIndex::main};
  request.gyro_zero_corr.z = msg::GyroOffset(4000);
  host.ask(request);
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.skip_gyro_calib = msg::SkipGyroCalibration::do_not_skip;
  host.ask(msg::WriteParams3{parameters});
  host.ask(msg::ResetRequest{}, seconds(1));
  EXPECT_EQ(host.board.memory().imus[0].gyro_offset, emulator::Vector{});
  host.ask(msg::WriteParams3{parameters});
  EXPECT_NEAR(still(host), 0, 0.1);
}

}  // namespace
}  // namespace sbgc::test
