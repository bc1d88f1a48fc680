// The behavior of a turning camera after the line is cut, in virtual time.

#include "tasks/bounded_turn.hpp"

#include <cmath>

#include <sbgc/client/motion.hpp>
#include <sbgc/client/speed_control.hpp>

#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

using detail::BoundedTurn;
using detail::ShortTargets;

// The rules

const ShortTargets::Angles somewhere{.roll = 1_deg, .pitch = -2_deg, .yaw = 30_deg};

TEST(ShortTargets, LeadAheadByTheLookahead) {
  ShortTargets targets(Ms(500));
  const auto next = targets.next({.pitch = -20_deg_per_s, .yaw = 10_deg_per_s}, somewhere);
  EXPECT_NEAR(next.angle.pitch.degrees(), -12, 0.05);
  EXPECT_NEAR(next.angle.yaw.degrees(), 35, 0.05);
  EXPECT_NEAR(next.speed.pitch.degrees_per_second(), 20, 0.1);
  EXPECT_NEAR(next.speed.yaw.degrees_per_second(), 10, 0.1);
}

TEST(ShortTargets, TheOtherAxesKeepTheirFirstAngle) {
  ShortTargets targets(Ms(500));
  const ShortTargets::Speed speed{.yaw = 10_deg_per_s};
  EXPECT_EQ(targets.next(speed, somewhere).angle.roll, somewhere.roll);
  const auto next = targets.next(speed, {.roll = 5_deg, .pitch = 5_deg, .yaw = 31_deg});
  EXPECT_EQ(next.angle.roll, somewhere.roll);
  EXPECT_EQ(next.angle.pitch, somewhere.pitch);
  EXPECT_EQ(next.speed.roll, msg::ControlSpeed(10_deg_per_s)) << "0 means another speed";
  // An axis that turned meanwhile stays where it is then.
  static_cast<void>(targets.next({.roll = 10_deg_per_s, .yaw = 10_deg_per_s}, somewhere));
  EXPECT_EQ(targets.next(speed, {.roll = 7_deg}).angle.roll, msg::Angle14(7_deg));
}

TEST(ShortTargets, TheSlowestSpeedTurnsAndTheLowestHasNoSign) {
  ShortTargets targets(Ms(1));
  const auto slow = targets.next({.yaw = msg::ControlSpeed(-1)}, somewhere);
  EXPECT_EQ(slow.angle.yaw.raw(), somewhere.yaw.raw() - 1);
  const auto fast = targets.next({.yaw = msg::ControlSpeed(-32768)}, somewhere);
  EXPECT_EQ(fast.speed.yaw.raw(), 32767);
}

TEST(ShortTargets, AnglesWrapAsOnTheBoard) {
  ShortTargets targets(Ms(1000));
  const auto next = targets.next({.yaw = 40_deg_per_s}, {.yaw = 700_deg});
  EXPECT_NEAR(next.angle.yaw.degrees(), 740 - 1440, 0.1);
}

// A cut line

struct CutLine {
  int firmware;
  MotionBound bound;
};

class BoundedTurnTest : public ::testing::Test {
 protected:
  /// Turns yaw at 20 deg/s for two seconds, then cuts the line for two seconds, during which the
  /// owner keeps refreshing.
  void turn_and_cut(const CutLine& on, Ms lookahead = Ms(500)) {
    client = std::make_unique<VirtualClient>(calm_board(on.firmware));
    const auto speed = client->held_speed();
    const Instant start = client->now();
    bool is_cut = false;
    static_cast<void>(client->run(
        detail::hold_speed(speed, BoundedTurn(on.bound, lookahead), false), [&](TaskMachine& task) {
          const Duration time = client->now() - start;
          if (time < seconds(4)) {
            static_cast<void>(speed->set({.yaw = 20_deg_per_s}, client->now()));
            task.wake();
          }
          if (time >= seconds(2) && !is_cut) {
            is_cut = true;
            speed_before = yaw_speed();
            angle_before = yaw();
            client->cut_the_line();
          }
          if (time >= seconds(4) && !is_over) {
            is_over = true;
            way = yaw() - angle_before;
            speed_after = yaw_speed();
            speed->close();
            task.wake();
          }
        }));
  }
  emulator::Sample sample() { return client->gimbal().sample(client->now()); }
  double yaw() { return sample().angles.yaw; }
  double yaw_speed() { return sample().speeds.yaw; }
  emulator::AxisMode mode() { return client->gimbal().command(2).mode; }

  std::unique_ptr<VirtualClient> client;
  double speed_before{};
  double angle_before{};
  double speed_after{};
  double way{};
  bool is_over = false;
};

TEST_F(BoundedTurnTest, WithoutABoundTheCameraKeepsTurning) {
  turn_and_cut({2590, MotionBound::none});
  EXPECT_NEAR(speed_before, 20, 1);
  EXPECT_NEAR(speed_after, 20, 1);
  EXPECT_NEAR(way, 40, 3);
}

TEST_F(BoundedTurnTest, OldFirmwareStopsAtTheLastTarget) {
  turn_and_cut({2590, MotionBound::automatic});
  EXPECT_NEAR(speed_before, 20, 1);
  EXPECT_NEAR(speed_after, 0, 0.5);
  EXPECT_GT(way, 3);
  EXPECT_LT(way, 20 * 0.5 + 1);
  EXPECT_EQ(mode(), emulator::AxisMode::angle) << "the motors hold the camera there";
}

TEST_F(BoundedTurnTest, LaterFirmwareEndsSerialControl) {
  turn_and_cut({2610, MotionBound::automatic});
  EXPECT_NEAR(speed_before, 20, 1);
  EXPECT_NEAR(speed_after, 0, 0.5);
  EXPECT_GT(way, 5);
  EXPECT_LT(way, 20 * 0.5 + 3);
  EXPECT_EQ(mode(), emulator::AxisMode::remote) << "RC takes over";
}

TEST_F(BoundedTurnTest, TargetsWorkWithLaterFirmwareToo) {
  turn_and_cut({2700, MotionBound::target}, Ms(1000));
  EXPECT_NEAR(speed_before, 20, 1);
  EXPECT_NEAR(speed_after, 0, 0.5);
  EXPECT_LT(way, 20 * 1.0 + 1);
  EXPECT_EQ(mode(), emulator::AxisMode::angle);
}

/// Keeps a yaw speed for six seconds; the board restarts after two. Returns the error.
ClientError turn_over_a_restart(VirtualClient& client) {
  const auto speed = client.held_speed();
  const Instant start = client.now();
  Result<void> last;
  BoundedTurn motion(MotionBound::automatic, Ms(500));
  static_cast<void>(
      client.run(detail::hold_speed(speed, std::move(motion), false), [&](TaskMachine& task) {
        if (client.now() - start < seconds(6)) {
          last = speed->set({.yaw = 20_deg_per_s}, client.now());
        } else {
          speed->close();
        }
        task.wake();
      }));
  return last ? ClientError{} : last.error();
}

TEST_F(BoundedTurnTest, ARestartEndsTheMotion) {
  emulator::EmulatorOptions options = calm_board(2730);
  options.board.start_time = sbgc::milliseconds(900);
  options.restart_at = seconds(2);
  client = std::make_unique<VirtualClient>(options);
  EXPECT_THAT(turn_over_a_restart(*client).message, HasSubstr("limiting the motion"));
  EXPECT_NEAR(yaw_speed(), 0, 0.5);
}

/// Turns for `time`, with a command every 100 ms.
Task<Result<void>> turn_for(Duration time) {
  BoundedTurn turn(MotionBound::timeout, Ms(500));
  TaskMachine& task = co_await tasks::this_task();
  const Instant end = task.now() + time;
  while (task.now() < end) {
    const Result<void> turned = co_await turn.turn({.yaw = 20_deg_per_s});
    if (!turned) co_return turned;
    static_cast<void>(co_await tasks::wait_until(task.now() + sbgc::milliseconds(100)));
  }
  // Its owner dies here.
  static_cast<void>(co_await tasks::wait_until(task.now() + seconds(3)));
  co_return Result<void>();
}

TEST_F(BoundedTurnTest, ARestartThatNobodyNoticesIsCovered) {
  emulator::EmulatorOptions options = calm_board(2730);
  options.restart_at = seconds(1);
  client = std::make_unique<VirtualClient>(options);
  static_cast<void>(client->run(turn_for(seconds(8))));  // ignores the notice
  EXPECT_EQ(mode(), emulator::AxisMode::remote) << "the timeout is there again";
  EXPECT_NEAR(yaw_speed(), 0, 0.5);
}

/// Loses an answer with angles every two seconds.
class ForgetfulLine : public VirtualLine {
 public:
  void send(Way way, std::span<const std::uint8_t> bytes, Instant now) override {
    constexpr auto angles = static_cast<std::uint8_t>(msg::GetAngles::command);
    const bool has_angles = way == Way::to_host && bytes.size() > 1 && bytes[1] == angles;
    if (has_angles && now >= next_) {
      next_ = now + seconds(2);
      ++lost;
      return;
    }
    VirtualLine::send(way, bytes, now);
  }

  int lost = 0;

 private:
  Instant next_{seconds(2).us};
};

TEST_F(BoundedTurnTest, ALostAnswerDoesNotEndTheMotion) {
  for (const int firmware : {2590, 2700}) {
    for (const bool yields : {false, true}) {
      ForgetfulLine line;
      client = std::make_unique<VirtualClient>(calm_board(firmware), emulator::Memory(), &line);
      const auto speed = client->held_speed();
      const Instant end = client->now() + seconds(10);
      const double before = yaw();
      double slowest = 20;
      BoundedTurn motion(MotionBound::automatic, Ms(500));
      static_cast<void>(
          client->run(detail::hold_speed(speed, std::move(motion), yields), [&](TaskMachine& task) {
            if (client->now() >= end) return speed->close(), task.wake();
            EXPECT_TRUE(speed->set({.yaw = 20_deg_per_s}, client->now()));
            if (client->now() >= end - seconds(9)) slowest = std::min(slowest, yaw_speed());
            task.wake();
          }));
      EXPECT_NEAR(yaw() - before, 200, 4) << firmware << yields;
      EXPECT_GT(slowest, 15) << firmware << yields;
      if (yields || firmware == 2590) EXPECT_GE(line.lost, 4);
    }
  }
}

/// Turns for half a second and stops.
Task<Result<void>> turn_and_stop(MotionBound bound) {
  BoundedTurn turn(bound, Ms(500));
  TaskMachine& task = co_await tasks::this_task();
  const Result<void> turned = co_await turn.turn({.yaw = 20_deg_per_s});
  if (!turned) co_return turned;
  static_cast<void>(co_await tasks::wait_until(task.now() + sbgc::milliseconds(500)));
  const Result<void> stopped = co_await turn.stop([] { return false; });
  if (!stopped) co_return stopped;
  static_cast<void>(co_await tasks::wait_until(task.now() + seconds(3)));
  co_return Result<void>();
}

TEST_F(BoundedTurnTest, AfterAStopRcDoesNotTakeOver) {
  client = std::make_unique<VirtualClient>(calm_board(2700));
  require(client->run(turn_and_stop(MotionBound::automatic)));
  EXPECT_EQ(mode(), emulator::AxisMode::speed);
  EXPECT_NEAR(yaw_speed(), 0, 0.5);
}

TEST_F(BoundedTurnTest, OldFirmwareHasNoTimeout) {
  client = std::make_unique<VirtualClient>();  // 2.59
  EXPECT_THAT(client->run(turn_and_stop(MotionBound::timeout)),
              fails(ErrorCode::unsupported, "limiting the motion"));
}

TEST_F(BoundedTurnTest, OptionsAreChecked) {
  client = std::make_unique<VirtualClient>();
  const auto turn = [](Ms lookahead) -> Task<Result<void>> {
    BoundedTurn motion(MotionBound::target, lookahead);
    co_return co_await motion.turn({.yaw = 20_deg_per_s});
  };
  EXPECT_EQ(client->run(turn(Ms(0))).error().code, ErrorCode::invalid);
  EXPECT_EQ(client->run(turn(Ms(60'001))).error().code, ErrorCode::invalid);
  EXPECT_EQ(client->run(tasks::set_control_timeout(Ms(65'536))).error().code, ErrorCode::invalid);
}

}  // namespace
}  // namespace sbgc::test
