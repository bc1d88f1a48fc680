// Tests of tasks in virtual time: without threads, clocks and lines.

#include <sbgc/client/backup.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/motion.hpp>

#include "tasks/hold_speed.hpp"
#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

template <class M>
Task<decltype(std::declval<detail::Calling<M>>().await_resume())> called(M request) {
  co_return co_await tasks::call(request);
}

class VirtualTime : public ::testing::Test {
 protected:
  double yaw_speed() { return client.gimbal().sample(client.now()).speeds.yaw; }

  VirtualClient client{calm_board()};
};

TEST_F(VirtualTime, ACancelledMoveStopsTheCamera) {
  const Instant end = client.now() + sbgc::milliseconds(700);
  EXPECT_THAT(client.run(tasks::move_to({.yaw = 120_deg}, {.speed = 20_deg_per_s}),
                         [&, is_cancelled = false](TaskMachine& task) mutable {
                           if (is_cancelled || client.now() < end) return;
                           is_cancelled = true;
                           task.cancel();
                         }),
              fails(ErrorCode::cancelled, "it has been stopped"));
  EXPECT_NEAR(yaw_speed(), 0, 1);
}

TEST_F(VirtualTime, ADeadLineEndsAStopInTime) {
  client.cut_the_line();
  const Instant start = client.now();
  EXPECT_THAT(client.run(tasks::stop()), fails(ErrorCode::timeout));
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
  msg::DataStreamInterval stream{.cmd_id = msg::RealtimeDataCustom::command};
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
    const auto acceleration = checked(ask(Flag::acc_data));
    EXPECT_NEAR(acceleration->acc_data->yaw.raw(), 512, 20);
    const std::size_t before = samples.size();
    require(ask(Flag::imu_angles));
    EXPECT_EQ(samples.size(), before + 1) << "the answer is the next sample";
  }
  for (const auto& sample : samples) EXPECT_NEAR(sample.imu_angles->yaw.degrees(), 0, 1);
  ASSERT_TRUE(start(10));
  EXPECT_THAT(ask(Flag::acc_data), fails(ErrorCode::overload));
}

TEST_F(VirtualTime, ACancelledCalibrationLeavesNoCallBehind) {
  CalibrationOptions options;
  options.progress = [](const CalibrationProgress&) { return false; };
  EXPECT_THAT(client.run(tasks::calibrate(Sensor::gyroscope, options)),
              fails(ErrorCode::cancelled));
  EXPECT_EQ(client.pending(), 0U);
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
