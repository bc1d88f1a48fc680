#include <cmath>

#include <sbgc/client/motion.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class MotionTest : public TaskTest {
 protected:
  Result<MoveProgress> move_to(const MoveTarget& target, const MoveOptions& options = {}) {
    return client().run(tasks::move_to(target, options), clock);
  }
  Result<void> stop() { return client().run(tasks::stop(), clock); }
  msg::Control last_control() {
    msg::Control last;
    for (const Packet& request : board.log()) {
      if (is<msg::Control>(request) && request.body.size() == msg::Control::max_size) {
        last = message<msg::Control>(request);
      }
    }
    return last;
  }
  void place(const Axes<double>& angles) {
    board.gimbal([&](emulator::Gimbal& gimbal, Instant now) { gimbal.place(angles, now); });
  }
  emulator::Sample sample() {
    return board.gimbal([](emulator::Gimbal& gimbal, Instant now) { return gimbal.sample(now); });
  }
  emulator::AxisMode mode(std::size_t axis) {
    return board.gimbal(
        [=](emulator::Gimbal& gimbal, Instant) { return gimbal.command(axis).mode; });
  }
  /// Turns the yaw axis at `speed`.
  void turn(msg::ControlSpeed speed) {
    msg::Control command;
    command.control_mode.set_mode(msg::ControlModeKind::speed);
    command.axes.yaw.speed = speed;
    board.write(command);
  }
};

TEST_F(MotionTest, MovesAllAxesAndWaitsForTheEnd) {
  connect();
  const Instant before = board.now();
  const auto moved =
      checked(move_to({.roll = 10_deg, .pitch = -30_deg, .yaw = 90_deg}, {.speed = 50_deg_per_s}));
  EXPECT_NEAR(moved->angles.pitch.degrees(), -30, 0.5);
  EXPECT_TRUE(moved->is_close);
  EXPECT_NEAR(sample().angles.yaw, 90, 0.6);
  // 90 degrees at 50 deg/s, followed by the settling time. The board's time advances even if this
  // machine stalls, so less time may pass here.
  EXPECT_GE((board.now() - before).us, 2'000'000);
  EXPECT_GE(moved->elapsed, Ms(300));
  EXPECT_LE(moved->elapsed, Ms(4000));
  EXPECT_GE(count<msg::GetAnglesRequest>(), 7U);
  EXPECT_EQ(count<msg::Control>(), 1U);
  const msg::Control sent = last_control();
  EXPECT_EQ(sent.control_mode.mode(), msg::ControlModeKind::angle);
  EXPECT_EQ(sent.axes.yaw.angle.raw(), 4096);
  EXPECT_EQ(sent.axes.yaw.speed.raw(), 410);  // 50 * 32767 / 4000
}

TEST_F(MotionTest, BeginsAMoveAndLeavesIt) {
  connect();
  board.on_lost([first = true](const Packet& request) mutable {
    return is<msg::Control>(request) && std::exchange(first, false);
  });
  const auto begun = checked(client().run(
      tasks::begin_move({.roll = 1_deg, .pitch = -20_deg, .yaw = 2_deg}, {.speed = 1_deg_per_s}),
      clock));
  // 18 s before the end, so that a machine that stalls makes no difference.
  EXPECT_GT(std::abs(begun->remaining.pitch), 2);
  EXPECT_EQ(count<msg::Control>(), 2U) << "the first one was lost";
  disconnect();
  board.skip(std::chrono::seconds(21));
  EXPECT_NEAR(sample().angles.pitch, -20, 0.6);
}

TEST_F(MotionTest, AMoveThatIsThereHasBegun) {
  const auto begun = checked(client().run(tasks::begin_move({.pitch = msg::Angle14(0)}), clock));
  EXPECT_TRUE(begun->is_close);
}

TEST_F(MotionTest, AMoveDoesNotBeginWithoutMotors) {
  client();
  board.write(msg::MotorsOff{});
  EXPECT_THAT(client().run(tasks::begin_move({.pitch = 20_deg}, {.timeout = Ms(500)}), clock),
              fails(ErrorCode::timeout, "are the motors on?"));
}

TEST_F(MotionTest, LeavesAxesAlone) {
  place({.yaw = 17});
  ASSERT_TRUE(move_to({.pitch = 5_deg}));
  EXPECT_EQ(mode(0), emulator::AxisMode::remote);
  EXPECT_EQ(mode(1), emulator::AxisMode::angle);
  EXPECT_EQ(mode(2), emulator::AxisMode::remote);
  EXPECT_NEAR(sample().angles.pitch, 5, 0.6);
  EXPECT_NEAR(sample().angles.yaw, 17, 0.5);
}

TEST_F(MotionTest, OldFirmwareHoldsThemAtTheirTargets) {
  become(msg::FirmwareVersion(2430));
  place({.yaw = 17});
  ASSERT_TRUE(move_to({.pitch = 5_deg}));
  EXPECT_NEAR(last_control().axes.yaw.angle.degrees(), 17, 0.1);
  EXPECT_NEAR(sample().angles.yaw, 17, 0.5);
}

TEST_F(MotionTest, ATargetAfterTheEndOfTheCountIsNear) {
  place({.yaw = 719.8});
  const auto moved = checked(move_to({.yaw = msg::Angle14(-32768)}, {.tolerance = 0.5}));
  EXPECT_LT(moved->elapsed, Ms(1000));
}

TEST_F(MotionTest, HasToStayThere) {
  std::vector<bool> close;
  MoveOptions settings;
  settings.progress = [&](const MoveProgress& seen) {
    close.push_back(seen.is_close);
    if (close.size() == 4) {  // push the camera
      board.gimbal([](emulator::Gimbal& gimbal, Instant now) { gimbal.push(1, 45, now); });
    }
    return true;
  };
  const auto moved = move_to({.pitch = msg::Angle14(0)}, settings);
  ASSERT_TRUE(moved);
  const auto last_away = std::find(close.rbegin(), close.rend(), false);
  ASSERT_NE(last_away, close.rend()) << "the push was not seen";
  EXPECT_GE(last_away - close.rbegin(), 300 / 50);
}

TEST_F(MotionTest, ALostCommandIsSentAgain) {
  board.on_lost([first = true](const Packet& request) mutable {
    return is<msg::Control>(request) && std::exchange(first, false);
  });
  require(move_to({.pitch = 20_deg}));
  EXPECT_EQ(count<msg::Control>(), 2U);
}

TEST_F(MotionTest, TellsHowFarItGot) {
  board.gimbal([](emulator::Gimbal& gimbal, Instant now) { gimbal.jam(1, true, now); });
  EXPECT_THAT(
      move_to({.pitch = 20_deg}),
      fails(ErrorCode::timeout,
            ContainsRegex("pitch is at -?0.[0-9]+ deg, [12][0-9].[0-9]+ deg from its target; "
                          "it has been stopped")));
  EXPECT_EQ(last_control().control_mode.mode(), msg::ControlModeKind::speed);
}

TEST_F(MotionTest, CanBeCancelled) {
  MoveOptions settings;
  settings.progress = [](const MoveProgress& seen) { return seen.remaining.pitch > 10; };
  EXPECT_THAT(move_to({.pitch = 20_deg}, settings), fails(ErrorCode::cancelled));
  EXPECT_EQ(last_control().control_mode.mode(), msg::ControlModeKind::speed);
}

TEST_F(MotionTest, AnExceptionOfItsHandlerStopsTheCamera) {
  MoveOptions settings;
  settings.progress = [](const MoveProgress& seen) {
    if (seen.remaining.pitch <= 10) throw std::domain_error("of the handler");
    return true;
  };
  EXPECT_THROW(static_cast<void>(move_to({.pitch = 20_deg}, settings)), std::domain_error);
  EXPECT_EQ(last_control().control_mode.mode(), msg::ControlModeKind::speed);
}

TEST_F(MotionTest, DoesNotBeginIfItIsCancelledBefore) {
  MoveOptions settings;
  settings.progress = [](const MoveProgress&) { return false; };
  EXPECT_THAT(move_to({.pitch = 20_deg}, settings), fails(ErrorCode::cancelled));
  EXPECT_EQ(count<msg::Control>(), 0U);
}

TEST_F(MotionTest, ASilentBoardIsAnErrorAndIsToldToStop) {
  connect(few_retries);
  board.on_lost([this](const Packet&) {
    if (board.count<msg::GetAnglesRequest>() <= 5) return false;
    clock.advance(Ms(500));  // as long as the client waits for a response
    return true;
  });
  MoveOptions settings;
  EXPECT_THAT(move_to({.pitch = 20_deg}, settings),
              fails(ErrorCode::timeout, "stopping it failed"));
}

TEST_F(MotionTest, SenselessMovesAreRefused) {
  EXPECT_EQ(move_to({}).error().code, ErrorCode::invalid);
  EXPECT_EQ(move_to({.yaw = msg::Angle14(0)}, {.speed = msg::ControlSpeed(-1)}).error().code,
            ErrorCode::invalid);
  EXPECT_FALSE(move_to({.yaw = msg::Angle14(0)}, {.tolerance = 0}));
  EXPECT_THAT(move_to({.yaw = msg::Angle14(0)}, {.timeout = Ms(300)}),
              fails(ErrorCode::invalid, "within 300 ms"));
  EXPECT_EQ(board.log().size(), 0U);
}

TEST_F(MotionTest, StopsAndLooksWhetherItHas) {
  turn(msg::ControlSpeed(500));
  board.on_lost([first = true](const Packet& request) mutable {
    return is<msg::Control>(request) && std::exchange(first, false);
  });
  ASSERT_TRUE(stop());
  EXPECT_GE(count<msg::Control>(), 2U);  // the first one is lost, and stopping takes time
  EXPECT_NEAR(sample().speeds.yaw, 0, 5);
}

TEST_F(MotionTest, ACameraThatDoesNotStopIsAnError) {
  turn(msg::ControlSpeed(500));
  board.on_lost([](const Packet& request) { return is<msg::Control>(request); });
  const auto stopped = stop();
  ASSERT_FALSE(stopped);
  // stop_test.cpp asserts the code, in virtual time: a machine that stalls seems a silent board.
  EXPECT_THAT(stopped.error().message, HasSubstr("yaw at 61.04 deg/s"));
}

TEST_F(MotionTest, Releases) {
  turn(msg::ControlSpeed(500));
  ASSERT_EQ(mode(2), emulator::AxisMode::speed);
  ASSERT_TRUE(client().release());
  ASSERT_TRUE(client().call(msg::GetAnglesRequest{}));
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(mode(axis), emulator::AxisMode::remote);
}

/// Makes the board reject CMD_CONTROL: the error precedes the next CMD_GET_ANGLES.
void refuse_control(Packets& answers) {
  const auto is_angles = [](const Packet& one) { return is<msg::GetAngles>(one); };
  if (!std::ranges::any_of(answers, is_angles)) return;
  msg::ErrorExt error{.cmd_id = msg::CommandToBoard::control,
                      .error_code = msg::BoardErrorCode::wrong_state};
  answers.insert(answers.begin(), packet(error));
}

TEST_F(MotionTest, ARefusedTargetIsAnErrorAtOnce) {
  connect();
  board.on_lost([](const Packet& request) { return is<msg::Control>(request); });
  board.tamper(refuse_control);
  EXPECT_THAT(move_to({.roll = msg::Angle14(0), .pitch = -30_deg}, {.speed = 10_deg_per_s}),
              fails(ErrorCode::board_error,
                    Eq("CMD_CONTROL: the board refused: WRONG_STATE; the camera is not turning")));
}

TEST_F(MotionTest, ARefusedStopIsAnErrorWhileTheCameraTurns) {
  connect();
  turn(5_deg_per_s);
  board.on_lost([](const Packet& request) { return is<msg::Control>(request); });
  board.tamper(refuse_control);
  EXPECT_THAT(stop(),
              fails(ErrorCode::board_error,
                    "CMD_CONTROL: the board refused: WRONG_STATE; the camera still turns: yaw"));
}

}  // namespace
}  // namespace sbgc::test
