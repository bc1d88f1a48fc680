// Tests of tasks in virtual time: without threads, clocks and lines.

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/variables.hpp>

#include "tasks/hold_speed.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

emulator::EmulatorOptions calm_board() {
  emulator::EmulatorOptions options;
  options.board.gimbal.noise = 0;
  return options;
}

template <class M>
Task<decltype(std::declval<detail::Calling<M>>().await_resume())> called(M request) {
  co_return co_await tasks::call(request);
}

class VirtualTime : public ::testing::Test {
 protected:
  double pitch() { return client.gimbal().sample(client.now()).angles.pitch; }
  double yaw_speed() { return client.gimbal().sample(client.now()).speeds.yaw; }

  VirtualClient client{calm_board()};
};

TEST_F(VirtualTime, AMoveTakesAsLongAsTheCameraNeeds) {
  const auto moved = client.run(tasks::move_to({.pitch = -30_deg}, {.speed = 20_deg_per_s}));
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_NEAR(pitch(), -30, 0.6);
  EXPECT_GE(moved->elapsed, std::chrono::milliseconds(1500));
  EXPECT_LE(moved->elapsed, std::chrono::milliseconds(2500));
}

TEST_F(VirtualTime, TheSameMoveTwiceTakesTheSameTime) {
  const auto time = [] {
    VirtualClient other(calm_board());
    const Instant start = other.now();
    EXPECT_TRUE(other.run(tasks::move_to({.yaw = 40_deg})));
    return other.now() - start;
  };
  EXPECT_EQ(time(), time());
}

TEST_F(VirtualTime, ACancelledMoveStopsTheCamera) {
  const Instant end = client.now() + sbgc::milliseconds(700);
  const auto moved = client.run(tasks::move_to({.yaw = 120_deg}, {.speed = 20_deg_per_s}),
                                [&, is_cancelled = false](TaskMachine& task) mutable {
                                  if (is_cancelled || client.now() < end) return;
                                  is_cancelled = true;
                                  task.cancel();
                                });
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().code, ErrorCode::cancelled);
  EXPECT_THAT(moved.error().message, HasSubstr("it has been stopped"));
  EXPECT_NEAR(yaw_speed(), 0, 1);
}

TEST_F(VirtualTime, ADeadLineEndsAStopInTime) {
  client.cut_the_line();
  const Instant start = client.now();
  const auto stopped = client.run(tasks::stop());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::timeout);
  EXPECT_LE(client.now() - start, seconds(10));
  EXPECT_EQ(client.pending(), 0U);
}

TEST_F(VirtualTime, AnAnswerOfOtherContentIsNoSampleOfTheStream) {
  using Flag = msg::RealtimeDataCustomFlag;
  std::vector<msg::RealtimeDataCustom> samples;
  const auto subscription =
      client.delivery().subscribe(detail::key_of<msg::RealtimeDataCustom>, [&](const void* sample) {
        samples.push_back(*static_cast<const msg::RealtimeDataCustom*>(sample));
      });
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::RealtimeDataCustom::command;
  const auto ask = [&](Flag what) {
    return client.run(called(msg::RealtimeDataCustomRequest{.flags = what}));
  };
  const auto start = [&](std::uint16_t interval) {
    stream.interval_ms = msg::Milliseconds(interval);
    stream.config.flags = msg::RealtimeDataCustomFlags(Flag::imu_angles);
    return client.run(called(stream));
  };
  ASSERT_TRUE(start(20));
  for (int i = 0; i < 20; ++i) {
    const auto acceleration = ask(Flag::acc_data);
    ASSERT_TRUE(acceleration) << acceleration.error().message;
    EXPECT_NEAR(acceleration->acc_data->yaw.raw(), 512, 20);
    const std::size_t before = samples.size();
    const auto angles = ask(Flag::imu_angles);
    ASSERT_TRUE(angles) << angles.error().message;
    EXPECT_EQ(samples.size(), before + 1) << "the answer is the next sample";
  }
  for (const auto& sample : samples) EXPECT_NEAR(sample.imu_angles->yaw.degrees(), 0, 1);
  ASSERT_TRUE(start(10));
  const auto refused = ask(Flag::acc_data);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::overload);
}

TEST_F(VirtualTime, ABackupComesBack) {
  const auto before = client.run(tasks::make_backup("2024-05-01T12:00:00Z"));
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_EQ(before->created, "2024-05-01T12:00:00Z");
  auto changed = *before;
  auto params = changed.parameters.get<msg::ReadParams3>(2);
  ASSERT_TRUE(params);
  params->gyro_trust = static_cast<std::uint8_t>(params->gyro_trust + 1);
  ASSERT_TRUE(changed.parameters.set(*params));
  std::vector<Backup> saved;
  RestoreOptions options;
  options.save_current = [&](const Backup& present) {
    saved.push_back(present);
    return Result<void>();
  };
  const WriteReport report = client.run(tasks::restore(changed, options));
  EXPECT_TRUE(report) << to_text(report);
  ASSERT_THAT(saved, SizeIs(1));
  EXPECT_EQ(saved[0].parameters, before->parameters);
  const auto after = client.run(tasks::read_parameters());
  ASSERT_TRUE(after);
  EXPECT_THAT(diff(before->parameters, *after), SizeIs(1));
  EXPECT_THAT(diff(changed.parameters, *after), SizeIs(0));
}

TEST_F(VirtualTime, NothingIsWrittenIfThePresentStateCannotBeSaved) {
  const auto before = client.run(tasks::make_backup(""));
  ASSERT_TRUE(before);
  RestoreOptions options;
  options.save_current = [](const Backup&) -> Result<void> {
    return ClientError{ErrorCode::io, "the disk is full"};
  };
  const WriteReport report = client.run(tasks::restore(*before, options));
  ASSERT_FALSE(report);
  EXPECT_EQ(report.outcome.error().code, ErrorCode::io);
  EXPECT_THAT(report.parameters, SizeIs(0));
}

TEST_F(VirtualTime, ACalibrationEndsWithItsSecondConfirmation) {
  std::vector<CalibrationProgress> seen;
  CalibrationOptions options;
  options.progress = [&](const CalibrationProgress& one) {
    seen.push_back(one);
    return true;
  };
  const Instant start = client.now();
  const auto done = client.run(tasks::calibrate(Sensor::gyroscope, options));
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_GE(client.now() - start, seconds(4));
  EXPECT_LE(client.now() - start, seconds(6));
  EXPECT_GE(seen.size(), 6U);
  for (const CalibrationProgress& one : seen) EXPECT_TRUE(one.has_started);
}

TEST_F(VirtualTime, ACancelledCalibrationLeavesNoCallBehind) {
  CalibrationOptions options;
  options.progress = [](const CalibrationProgress&) { return false; };
  const auto done = client.run(tasks::calibrate(Sensor::gyroscope, options));
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::cancelled);
  EXPECT_EQ(client.pending(), 0U);
}

TEST_F(VirtualTime, FilesAndVariables) {
  std::vector<std::uint8_t> data(1000);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint8_t>(i * 7);
  ASSERT_TRUE(client.run(tasks::upload_file(3, data)));
  const auto read = client.run(tasks::download_file(3));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, data);
  ASSERT_TRUE(client.run(tasks::set_variable("P_ROLL", 33)));
  const auto value = client.run(tasks::get_variable("P_ROLL"));
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 33);
}

TEST_F(VirtualTime, ASilentOwnerStopsTheCamera) {
  const auto speed = client.held_speed();
  const Instant start = client.now();
  ASSERT_TRUE(speed->set({.yaw = 20_deg_per_s}, start));
  double fastest = 0;
  const detail::BoundedTurn unbounded(MotionBound::none, {});
  const auto done = client.run(detail::hold_speed(speed, unbounded, false), [&](TaskMachine& task) {
    fastest = std::max(fastest, yaw_speed());
    if (client.now() - start < seconds(3)) return;
    speed->close();
    task.wake();
  });
  EXPECT_TRUE(done);
  EXPECT_NEAR(fastest, 20, 5);
  EXPECT_NEAR(yaw_speed(), 0, 1);
  EXPECT_EQ(speed->state(), SpeedControlState::silenced);
}

}  // namespace
}  // namespace sbgc::test
