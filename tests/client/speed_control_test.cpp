#include <sbgc/client/speed_control.hpp>

#include "task_test.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc::test {
namespace {

using detail::DeadMansSwitch;
using Action = DeadMansSwitch::Action;
using State = SpeedControl::State;

// The rules

constexpr DeadMansSwitch::Speed slow{.yaw = msg::ControlSpeed(10)};
constexpr DeadMansSwitch::Speed fast{.yaw = msg::ControlSpeed(90)};

class DeadMansSwitchTest : public ::testing::Test {
 protected:
  Action at(int ms) { return hold.next(start + sbgc::milliseconds(ms)); }
  void set(const DeadMansSwitch::Speed& speed, int ms) {
    hold.set(speed, start + sbgc::milliseconds(ms));
  }

  Instant start{3'600'000'000};
  DeadMansSwitch hold{sbgc::milliseconds(500), sbgc::milliseconds(100)};
};

TEST_F(DeadMansSwitchTest, DoesNothingUnasked) {
  EXPECT_EQ(at(0), Action::none);
  EXPECT_EQ(at(100'000), Action::none);
  EXPECT_EQ(hold.state(), State::idle);
}

TEST_F(DeadMansSwitchTest, SendsAtOnceAndThenAgainAndAgain) {
  set(slow, 0);
  EXPECT_EQ(at(0), Action::send);
  EXPECT_EQ(at(0), Action::none);
  EXPECT_EQ(hold.deadline(start), start + sbgc::milliseconds(100));
  EXPECT_EQ(at(99), Action::none);
  EXPECT_EQ(at(100), Action::send);
  EXPECT_EQ(at(200), Action::send);
}

TEST_F(DeadMansSwitchTest, SendsAChangeAsSoonAsTheBoardTakesIt) {
  set(slow, 0);
  EXPECT_EQ(at(0), Action::send);
  set(fast, 5);
  EXPECT_EQ(at(5), Action::none);
  EXPECT_EQ(at(20), Action::send);
  EXPECT_EQ(hold.speed(), fast);
  set(fast, 30);
  EXPECT_EQ(at(60), Action::none);
  EXPECT_EQ(at(120), Action::send);
}

TEST_F(DeadMansSwitchTest, StopsWhenTheOwnerIsSilent) {
  set(slow, 0);
  for (int ms = 0; ms < 500; ms += 100) EXPECT_EQ(at(ms), Action::send);
  EXPECT_EQ(at(499), Action::none);
  EXPECT_EQ(at(500), Action::stop);
  EXPECT_EQ(at(500), Action::stop) << "until it is done";
  hold.stopped();
  EXPECT_EQ(at(500), Action::none);
  EXPECT_EQ(hold.state(), State::silenced);
}

TEST_F(DeadMansSwitchTest, GoesOnWhileItIsRefreshed) {
  set(slow, 0);
  for (int ms = 0; ms < 5000; ms += 100) {
    EXPECT_EQ(at(ms), Action::send);
    hold.refresh(start + sbgc::milliseconds(ms));
  }
}

TEST_F(DeadMansSwitchTest, TurnsAgainAfterASilence) {
  set(slow, 0);
  EXPECT_EQ(at(500), Action::stop);
  hold.stopped();
  set(slow, 600);
  EXPECT_EQ(at(600), Action::send);
  EXPECT_EQ(hold.state(), State::turning);
}

TEST_F(DeadMansSwitchTest, AFailureEndsWithAStopForEver) {
  set(slow, 0);
  EXPECT_EQ(at(0), Action::send);
  hold.fail();
  EXPECT_EQ(at(0), Action::stop);
  hold.stopped();
  set(fast, 10);
  EXPECT_EQ(at(1000), Action::none);
  EXPECT_EQ(hold.state(), State::failed);
}

TEST_F(DeadMansSwitchTest, AStopThatFailedIsRepeated) {
  set(slow, 0);
  EXPECT_EQ(at(500), Action::stop);
  hold.not_stopped(start + sbgc::milliseconds(500));
  EXPECT_EQ(hold.deadline(start + sbgc::milliseconds(500)), start + sbgc::milliseconds(600));
  EXPECT_EQ(at(599), Action::none);
  EXPECT_EQ(at(600), Action::stop);
  hold.not_stopped(start + sbgc::milliseconds(600));
  hold.stop();
  EXPECT_EQ(at(600), Action::stop) << "the owner does not wait";
  hold.stopped();
  EXPECT_EQ(at(10'000), Action::none);
}

TEST_F(DeadMansSwitchTest, WhatIsClosedNeverTurnsAgain) {
  detail::HeldSpeed speed(hold, {.begin = [] { return TaskNumber{1}; },
                                 .is_superseded = [](TaskNumber) { return false; }});
  ASSERT_TRUE(speed.set(slow, start));
  const auto send = speed.next(start);
  EXPECT_EQ(send.action, Action::send);
  speed.done(send, {}, start);
  speed.close();
  const auto stop = speed.next(start);
  EXPECT_EQ(stop.action, Action::stop);
  EXPECT_FALSE(speed.set(slow, start)) << "another thread goes on";
  speed.done(stop, {}, start);
  EXPECT_FALSE(speed.set(slow, start));
  EXPECT_TRUE(speed.next(start).is_last);
  EXPECT_TRUE(speed.stop());
}

TEST_F(DeadMansSwitchTest, StoppingWhatIsStillDoesNothing) {
  hold.stop();
  EXPECT_EQ(at(0), Action::none);
}

// The thread

class SpeedControlTest : public TaskTest {
 public:
  SpeedControlTest(const SpeedControlTest&) = delete;
  SpeedControlTest& operator=(const SpeedControlTest&) = delete;
  ~SpeedControlTest() override {
    board.after({});
    disconnect();
  }

 protected:
  SpeedControlTest() {
    board.after([this](const Packet& request) {
      if (!is<msg::Control>(request)) return;
      sent_.add(message<msg::Control>(request).axes.yaw.speed.raw());
    });
  }
  /// Without a bound, the commands are the speeds of the owner.
  SpeedControlOptions options() { return {Ms(500), Ms(100), clock, MotionBound::none}; }

  /// Begins to turn, and waits until the board has received it.
  void turn(SpeedControl& control) {
    ASSERT_TRUE(control.set({.yaw = msg::ControlSpeed(100)}));
    ASSERT_TRUE(control.wait());
    EXPECT_THAT(commands(1), ElementsAre(100));
  }
  /// Waits until `n` commands have arrived; returns the yaw speeds of all commands.
  std::vector<int> commands(std::size_t n) { return sent_.wait_for(n); }
  /// Removes repeated stop commands: stopping takes time, and the command is repeated until then.
  static std::vector<int> without_repeated_stops(std::vector<int> speeds) {
    while (speeds.size() > 1 && speeds.back() == 0 && speeds[speeds.size() - 2] == 0) {
      speeds.pop_back();
    }
    return speeds;
  }

 private:
  Collector<int> sent_;
};

TEST_F(SpeedControlTest, TurnsStopsWhenSilentAndTurnsAgain) {
  SpeedControl control(client(), options());
  turn(control);
  EXPECT_EQ(control.state(), State::turning);

  clock.advance(Ms(100));
  EXPECT_EQ(commands(2), std::vector<int>({100, 100}));
  clock.advance(Ms(399));
  ASSERT_TRUE(control.wait());
  EXPECT_EQ(control.state(), State::turning);
  clock.advance(Ms(1));
  ASSERT_TRUE(control.wait());
  EXPECT_EQ(control.state(), State::silenced);
  EXPECT_EQ(without_repeated_stops(commands(4)), std::vector<int>({100, 100, 100, 0}));
  EXPECT_EQ(control.refresh().error().code, ErrorCode::cancelled);

  ASSERT_TRUE(control.set({.yaw = msg::ControlSpeed(-50)}));
  clock.advance(Ms(20));  // the minimum interval of commands
  wait_until([&] { return commands(0).back() == -50; });
}

TEST_F(SpeedControlTest, RefusesImpossibleOptionsAtOnce) {
  const SpeedControlOptions wrong[] = {{.silence = Ms(-1)}, {.lookahead = Ms(60'001)}};
  for (const SpeedControlOptions& options : wrong) {
    EXPECT_THAT(SpeedControl(client(), options).set({}), fails(ErrorCode::invalid));
  }
}

TEST_F(SpeedControlTest, StopsWhenAsked) {
  SpeedControl control(client(), options());
  turn(control);
  EXPECT_TRUE(control.has_settled());
  EXPECT_EQ(commands(1), std::vector<int>({100}));
  board.on_lost([](const Packet& request) { return is<msg::Control>(request); });
  ASSERT_TRUE(control.stop());
  EXPECT_EQ(control.state(), State::idle);
  EXPECT_FALSE(control.has_settled()) << "the camera turns";
  board.on_lost({});
  clock.advance(Ms(100));
  ASSERT_TRUE(control.wait());
  EXPECT_TRUE(control.has_settled());
  EXPECT_THAT(without_repeated_stops(commands(2)), ElementsAre(100, 0));
}

TEST_F(SpeedControlTest, StopsWhenItIsDestroyed) {
  {
    SpeedControl control(client(), options());
    turn(control);
  }
  EXPECT_THAT(without_repeated_stops(commands(2)), ElementsAre(100, 0));
}

TEST_F(SpeedControlTest, ClosingItTellsWhenTheCameraHasStopped) {
  SpeedControl control(client(), options());
  turn(control);
  std::promise<Result<void>> stopped;
  control.close([&](const Result<void>& result) { stopped.set_value(result); });
  EXPECT_TRUE(stopped.get_future().get());
  EXPECT_THAT(without_repeated_stops(commands(2)), ElementsAre(100, 0));
  EXPECT_EQ(control.set({.yaw = msg::ControlSpeed(100)}).error().code, ErrorCode::cancelled);
  bool is_told = false;
  control.close([&](const Result<void>& result) { is_told = bool(result); });
  EXPECT_TRUE(is_told) << "at once";
}

TEST_F(SpeedControlTest, SendsNothingIfNothingTurned) {
  {
    SpeedControl control(client(), options());
    ASSERT_TRUE(control.wait());
  }
  ASSERT_TRUE(client().call(msg::GetAnglesRequest{}));
  EXPECT_TRUE(commands(0).empty());
}

TEST_F(SpeedControlTest, ByDefaultTheMotionIsBounded) {
  const auto modes_with = [&](msg::FirmwareVersion firmware) {
    become(firmware);
    SpeedControlOptions bounded = options();
    bounded.bound = SpeedControlOptions{}.bound;
    const std::size_t before = commands(0).size();
    SpeedControl control(client(), bounded);
    EXPECT_TRUE(control.set({.yaw = msg::ControlSpeed(100)}));
    EXPECT_TRUE(control.wait());
    commands(before + 1);
    std::vector<msg::ControlModeKind> modes;
    for (const Packet& one : board.log()) {
      if (is<msg::Control>(one)) modes.push_back(message<msg::Control>(one).control_mode.mode());
    }
    return modes;
  };
  using enum msg::ControlModeKind;
  EXPECT_EQ(modes_with(msg::FirmwareVersion(2590)), std::vector{angle});
  EXPECT_EQ(count<msg::ControlConfig>(), 0U);
  EXPECT_EQ(modes_with(msg::FirmwareVersion(2700)), std::vector{speed});
  EXPECT_EQ(count<msg::ControlConfig>(), 2U) << "set, and removed by the destructor";
}

TEST_F(SpeedControlTest, ALostLineIsAnErrorOfTheNextCall) {
  SpeedControl control(client(), options());
  turn(control);
  client().close();
  static_cast<void>(control.set({.yaw = msg::ControlSpeed(50)}));
  clock.advance(Ms(100));
  EXPECT_EQ(control.wait().error().code, ErrorCode::not_connected);
  EXPECT_EQ(control.set({.yaw = msg::ControlSpeed(50)}).error().code, ErrorCode::not_connected);
  EXPECT_EQ(control.state(), State::failed);
}

TEST_F(SpeedControlTest, ARefusalIsAnErrorOfTheNextCall) {
  SpeedControl control(client(), options());
  board.tamper([](Packets& answers) {
    for (Packet& one : answers) {
      if (!is<msg::Confirm>(one)) continue;
      msg::ErrorExt error{.cmd_id = msg::CommandToBoard::control,
                          .error_code = msg::BoardErrorCode::not_supported};
      one = packet(error);
    }
  });
  turn(control);
  ASSERT_TRUE(client().call(msg::GetAnglesRequest{}));  // all earlier frames are handled now
  clock.advance(Ms(100));
  EXPECT_EQ(control.wait().error().message, "CMD_CONTROL: the board refused: NOT_SUPPORTED");
  EXPECT_EQ(control.state(), State::failed);
}

TEST_F(SpeedControlTest, ARestartEndsTheMotion) {
  SpeedControl control(client(), options());
  turn(control);
  bool is_first = true;
  board.tamper([&](Packets& answers) {
    if (std::exchange(is_first, false)) answers.push_back(packet(msg::Reset{}));
  });
  static_cast<void>(client().call(msg::GetAnglesRequest{}));
  ASSERT_TRUE(client().call(msg::GetAnglesRequest{}));  // all earlier frames are handled now
  clock.advance(Ms(100));
  EXPECT_EQ(control.wait().error().code, ErrorCode::board_reset);
  EXPECT_EQ(control.state(), State::failed);
  EXPECT_THAT(without_repeated_stops(commands(2)), ElementsAre(100, 0));
}

TEST_F(SpeedControlTest, StopsAsSoonAsTheLineCarriesItAgain) {
  SpeedControl control(client(), options());
  turn(control);
  board.on_lost([](const Packet& request) { return is<msg::Control>(request); });
  clock.advance(Ms(500));  // no command from the owner
  EXPECT_EQ(control.wait().error().code, ErrorCode::timeout);
  board.on_lost({});
  clock.advance(Ms(100));
  EXPECT_THAT(without_repeated_stops(commands(2)), ElementsAre(100, 0));
  EXPECT_EQ(control.state(), State::failed);
}

TEST_F(SpeedControlTest, TakesSpeedsFromManyThreads) {
  SpeedControl control(client(), options());
  std::vector<std::thread> owners;
  owners.reserve(4);
  for (int i = 0; i < 4; ++i) {
    owners.emplace_back([&] {
      for (int n = 1; n < 100; ++n) {
        EXPECT_TRUE(control.set({.yaw = msg::ControlSpeed(static_cast<std::int16_t>(n))}));
        EXPECT_TRUE(control.refresh());
      }
    });
  }
  for (std::thread& owner : owners) owner.join();
  ASSERT_TRUE(control.stop());
  ASSERT_TRUE(control.wait());
  EXPECT_EQ(commands(1).back(), 0);
}

}  // namespace
}  // namespace sbgc::test
