#include <vector>

#include <sbgc/client/motion.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

class MotionTest : public TaskTest {
 protected:
  MoveOptions options() { return {.clock = clock}; }
  Control last_control() const {
    Control last;
    for (const Packet& request : board.log) {
      if (is<Control>(request) && request.body.size() == Control::max_size) {
        last = message<Control>(request);
      }
    }
    return last;
  }
};

TEST_F(MotionTest, MovesAllAxesAndWaitsForTheEnd) {
  const auto moved = move_to(client(),
                             {.roll = Angle14::from_degrees(10.0),
                              .pitch = Angle14::from_degrees(-30.0),
                              .yaw = Angle14::from_degrees(90.0)},
                             ControlSpeed::from_degrees_per_second(50.0), options());
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(moved->angles.pitch.raw(), -1365);
  EXPECT_TRUE(moved->is_close);
  // 90 degrees are 4096 counts, 200 each look.
  EXPECT_GE(count<GetAnglesRequest>(), 21U);
  EXPECT_GE(moved->elapsed, milliseconds(20 * 50 + 300));
  const Control sent = last_control();
  EXPECT_EQ(sent.control_mode.mode(), ControlModeKind::angle);
  EXPECT_EQ(sent.axes.yaw.angle.raw(), 4096);
  EXPECT_EQ(sent.axes.yaw.speed.raw(), 410);  // 50 * 32767 / 4000
}

TEST_F(MotionTest, LeavesAxesAlone) {
  board.angles.yaw = board.targets.yaw = Angle14(777);
  ASSERT_TRUE(move_to(client(), {.pitch = Angle14::from_degrees(5.0)}, {}, options()));
  EXPECT_TRUE(board.controlled.pitch);
  EXPECT_FALSE(board.controlled.yaw);
  EXPECT_FALSE(board.controlled.roll);
  EXPECT_EQ(board.angles.yaw.raw(), 777);
}

TEST_F(MotionTest, OldFirmwareHoldsThemAtTheirTargets) {
  board.info.firmware_ver = FirmwareVersion(2430);
  board.angles.yaw = board.targets.yaw = Angle14(777);
  ASSERT_TRUE(move_to(client(), {.pitch = Angle14::from_degrees(5.0)}, {}, options()));
  EXPECT_EQ(last_control().axes.yaw.angle.raw(), 777);
  EXPECT_EQ(board.angles.yaw.raw(), 777);
}

TEST_F(MotionTest, ATargetBehindTheEndOfTheCountIsNear) {
  board.angles.yaw = board.targets.yaw = Angle14(32760);
  const auto moved =
      move_to(client(), {.yaw = Angle14(-32768)}, {}, {.tolerance = 0.5, .clock = clock});
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_LT(moved->elapsed, milliseconds(1000));
}

TEST_F(MotionTest, HasToStayThere) {
  std::vector<bool> close;
  MoveOptions settings = options();
  settings.progress = [&](const MoveProgress& seen) {
    close.push_back(seen.is_close);
    if (close.size() == 4) {  // a push
      with_board([](ModelBoard& model) { model.angles.pitch = Angle14(400); });
    }
    return true;
  };
  const auto moved = move_to(client(), {.pitch = Angle14(0)}, {}, settings);
  ASSERT_TRUE(moved);
  EXPECT_EQ(std::count(close.begin(), close.end(), false), 1);
  EXPECT_GE(close.size(), 4U + 1U + 6U);
}

TEST_F(MotionTest, ALostCommandIsSentAgain) {
  board.is_lost = [first = true](const Packet& request) mutable {
    return is<Control>(request) && std::exchange(first, false);
  };
  const auto moved = move_to(client(), {.pitch = Angle14::from_degrees(20.0)}, {}, options());
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(count<Control>(), 2U);
}

TEST_F(MotionTest, TellsHowFarItGot) {
  board.is_stuck = true;
  const auto moved = move_to(client(), {.pitch = Angle14::from_degrees(20.0)}, {}, options());
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().code, ErrorCode::timeout);
  EXPECT_THAT(moved.error().message,
              HasSubstr("pitch is at 0.00 deg, 20.00 deg from its target; it has been stopped"));
  EXPECT_EQ(last_control().control_mode.mode(), ControlModeKind::speed);
}

TEST_F(MotionTest, CanBeCancelled) {
  MoveOptions settings = options();
  settings.progress = [](const MoveProgress& seen) { return seen.remaining.pitch > 10; };
  const auto moved = move_to(client(), {.pitch = Angle14::from_degrees(20.0)}, {}, settings);
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().code, ErrorCode::cancelled);
  EXPECT_EQ(last_control().control_mode.mode(), ControlModeKind::speed);
}

TEST_F(MotionTest, ASilentBoardIsAnErrorAndIsToldToStop) {
  board.is_lost = [this](const Packet&) {
    if (board.count<GetAnglesRequest>() <= 5) return false;
    clock.advance(milliseconds(500));  // as long as the client waits for an answer
    return true;
  };
  MoveOptions settings = options();
  const auto moved = move_to(client(), {.pitch = Angle14::from_degrees(20.0)}, {}, settings);
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().code, ErrorCode::timeout);
  EXPECT_THAT(moved.error().message, HasSubstr("stopping it failed"));
}

TEST_F(MotionTest, SenselessMovesAreRefused) {
  EXPECT_EQ(move_to(client(), {}).error().code, ErrorCode::invalid);
  EXPECT_EQ(move_to(client(), {.yaw = Angle14(0)}, ControlSpeed(-1)).error().code,
            ErrorCode::invalid);
  EXPECT_FALSE(move_to(client(), {.yaw = Angle14(0)}, {}, {.tolerance = 0}));
  EXPECT_EQ(board.log.size(), 0U);
}

TEST_F(MotionTest, StopsAndLooksWhetherItHas) {
  board.speeds.yaw = ControlSpeed(500);
  board.is_lost = [first = true](const Packet& request) mutable {
    return is<Control>(request) && std::exchange(first, false);
  };
  ASSERT_TRUE(stop(client(), {.clock = clock}));
  EXPECT_EQ(count<Control>(), 2U);
  EXPECT_EQ(board.speeds.yaw.raw(), 0);
}

TEST_F(MotionTest, ACameraThatDoesNotStopIsAnError) {
  board.speeds.yaw = ControlSpeed(500);
  board.is_lost = [](const Packet& request) { return is<Control>(request); };
  const auto stopped = stop(client(), {.clock = clock});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::timeout);
  EXPECT_THAT(stopped.error().message, HasSubstr("yaw with 61.04 deg/s"));
}

TEST_F(MotionTest, Releases) {
  board.controlled = {true, true, true};
  ASSERT_TRUE(release(client()));
  ASSERT_TRUE(client().call(GetAnglesRequest{}));
  EXPECT_FALSE(board.controlled.yaw);
}

}  // namespace
}  // namespace sbgc::test
