// Execution of the commands of one gimbal, with an emulated gimbal in real time.

#include "gateway/gimbal_tasks.hpp"

#include <cmath>

#include <sbgc/literals.hpp>
#include <sbgc/meta/control.hpp>

#include "testing.hpp"

namespace sbgc::tools {
namespace {

using std::chrono::milliseconds;
using test::Collector;
using test::Packet;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::StartsWith;

/// A move of 40 seconds.
Order far_move() {
  MoveOrder order{.target = {.pitch = -80_deg}, .options = {.speed = 2_deg_per_s}};
  order.options.timeout = std::chrono::minutes(2);
  return {.what = order, .must_not_wait = true};
}

Order near_move(msg::Angle14 pitch = 3_deg) {
  const MoveOrder order{.target = {.pitch = pitch}, .options = {.speed = 30_deg_per_s}};
  return {.what = order, .must_not_wait = true};
}

/// A speed with a dead man's switch.
Order turning() {
  const SpeedOrder order{.speed = {.pitch = 20_deg_per_s}};
  return {.what = order, .must_not_wait = true};
}

template <class M>
Order calling(const M& request) {
  return {.what = CallOrder{AnyMessage(*find_message(Meta<M>::info.name), &request)}};
}

msg::Control turn() {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.pitch.speed = msg::ControlSpeed(-16);
  return request;
}

/// A speed without a dead man's switch.
Order turning_for(milliseconds time) {
  Order order = calling(turn());
  order.must_not_wait = true;
  order.goes_on = time;
  return order;
}

Order reading() { return calling(msg::GetAnglesRequest{}); }

Order motors_off() {
  Order order = calling(msg::MotorsOff{});
  order.is_urgent = true;
  return order;
}

class GimbalTasksTest : public ::testing::Test {
 public:
  GimbalTasksTest(const GimbalTasksTest&) = delete;
  GimbalTasksTest& operator=(const GimbalTasksTest&) = delete;

 protected:
  GimbalTasksTest() : gimbal(std::make_unique<Gimbal>(io, settings())) { begin({}); }
  ~GimbalTasksTest() override {
    if (!has_ended) shut_down();
    gimbal->close();
    io.finish();
    const std::weak_ptr<GimbalTasks> left = std::exchange(tasks, nullptr);
    gimbal.reset();
    EXPECT_TRUE(left.expired()) << "it holds itself";
  }

  /// Replaces the tasks of an earlier gateway.
  void begin(std::optional<std::int64_t> moved_by) {
    tasks = std::make_shared<GimbalTasks>(
        *gimbal,
        GimbalTasks::Hooks{[this] { return is_broker_there.load(); },
                           [this](const std::string& kind, const std::string& message) {
                             events.add(kind + ": " + message);
                           },
                           [this](std::int64_t command) { rests.add(command); }},
        moved_by);
  }
  void connect() {
    gimbal->on_status([tasks = tasks](const GimbalStatus& status) {
      tasks->link_changed(status.link == GimbalLink::online);
    });
    gimbal->on_status([this](const GimbalStatus& status) { links.add(status.link); });
    gimbal->start();
    ASSERT_TRUE(links.wait_until(
        [](const auto& all) { return std::ranges::count(all, GimbalLink::online) != 0; }));
  }
  /// Returns the number of the command.
  std::int64_t run(Order order, std::optional<milliseconds> until_deadline = {},
                   milliseconds waited = milliseconds(0), std::optional<std::uint64_t> stops = {}) {
    const std::int64_t command = ++commands;
    std::optional<GimbalTasks::Time> deadline;
    if (until_deadline) deadline = std::chrono::system_clock::now() + *until_deadline;
    tasks->run({.command = command,
                .order = std::move(order),
                .deadline = deadline,
                .arrived = GimbalTasks::Clock::now() - waited,
                .stops = stops.value_or(tasks->stops()),
                .done = [this, command](const TaskOutcome& outcome) {
                  ends.add({command, outcome.code.empty() ? outcome.status : outcome.code});
                }});
    return command;
  }
  /// Returns the result of a command.
  std::string end_of(std::int64_t command) {
    std::string found;
    EXPECT_TRUE(ends.wait_until([&](const auto& all) {
      const auto at = std::ranges::find(all, command, &End::first);
      if (at != all.end()) found = at->second;
      return at != all.end();
    }));
    return found;
  }
  std::string result(Order order) { return end_of(run(std::move(order))); }
  void start_turning() {
    EXPECT_EQ(result(turning_for(Order::forever)), "done");
    ASSERT_TRUE(eventually_turns());
  }
  /// Starts a long move, and two commands that wait for it.
  void run_three() {
    run(far_move());
    run(near_move());
    run(reading());
    ASSERT_TRUE(eventually_turns());
  }
  void shut_down() {
    std::promise<void> done;
    tasks->shut_down([&] { done.set_value(); });
    done.get_future().wait();
    has_ended = true;
  }
  /// Returns the speed that the board reports.
  double speed() {
    return board.gimbal([](emulator::Gimbal& one, Instant now) {
      return std::abs(one.sample(now).target_speeds.pitch);
    });
  }
  bool eventually_turns(bool turns = true) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while ((speed() != 0) != turns && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(milliseconds(10));
    }
    return (speed() != 0) == turns;
  }
  void be_silent() {
    board.on_lost([](const Packet&) { return true; });
  }
  bool has_event(const std::string& text) {
    return events.wait_until([&](const auto& all) {
      return std::ranges::any_of(
          all, [&](const std::string& one) { return one.find(text) != std::string::npos; });
    });
  }
  bool is_at_rest_after(std::int64_t command) {
    return rests.wait_until([&](const auto& all) { return !all.empty() && all.back() == command; });
  }

  using End = std::pair<std::int64_t, std::string>;

  test::EmulatedBoard board;
  Io io{2};
  std::unique_ptr<Gimbal> gimbal;
  std::shared_ptr<GimbalTasks> tasks{};
  std::atomic<bool> is_broker_there{true};
  Collector<std::string> events;
  Collector<std::int64_t> rests;
  Collector<GimbalLink> links;
  Collector<End> ends;
  bool has_ended = false;
  std::int64_t commands = 0;

 private:
  FleetGimbal settings() {
    FleetGimbal result;
    result.line.name = "front";
    result.line.port = board.serve_tcp();
    return result;
  }
};

class ConnectedTasks : public GimbalTasksTest {
 protected:
  void SetUp() override { connect(); }
};

TEST_F(ConnectedTasks, OneAfterTheOther) {
  run(near_move());
  run(reading());
  run(near_move(-3_deg));
  EXPECT_THAT(ends.wait_for(3), ElementsAre(End{1, "done"}, End{2, "done"}, End{3, "done"}));
  EXPECT_EQ(board.count<msg::Control>(), 2U);
  EXPECT_TRUE(is_at_rest_after(3));
}

TEST_F(ConnectedTasks, AStopGoesFirst) {
  run_three();
  const std::int64_t stop = run({.what = StopOrder()});
  EXPECT_EQ(end_of(stop), "done");
  EXPECT_EQ(speed(), 0);
  EXPECT_EQ(end_of(1), "cancelled");
  EXPECT_EQ(end_of(2), "superseded");
  EXPECT_EQ(end_of(3), "done") << "what moves nothing still waits";
  EXPECT_TRUE(is_at_rest_after(2));
}

TEST_F(ConnectedTasks, StopsThatComeTogetherAreOne) {
  EXPECT_EQ(result(turning_for(Order::forever)), "done");
  constexpr std::size_t count = 200;
  for (std::size_t i = 0; i < count; ++i) run({.what = StopOrder()});
  EXPECT_EQ(ends.wait_for(count + 1).back().second, "done");
  EXPECT_EQ(speed(), 0);
  EXPECT_LT(board.count<msg::Control>(), count);
}

TEST_F(ConnectedTasks, AMotionThatIsNotConfirmedDoesNotComeAfterAStop) {
  Collector<int> lost;
  board.on_lost([&](const Packet& request) {
    const bool is_turn = test::is<msg::Control>(request) &&
                         test::message<msg::Control>(request).axes.pitch.speed.raw() != 0;
    if (is_turn) lost.add(1);
    return is_turn;
  });
  run(turning_for(Order::forever));
  lost.wait_for(1);
  EXPECT_EQ(result({.what = StopOrder()}), "done");
  EXPECT_EQ(end_of(1), "cancelled");
  board.on_lost({});
  EXPECT_EQ(result(reading()), "done");
  EXPECT_EQ(speed(), 0);
}

TEST_F(ConnectedTasks, AMotionThatHasComeBeforeAStopIsSuperseded) {
  EXPECT_EQ(result({.what = StopOrder()}), "done");
  EXPECT_EQ(end_of(run(near_move(), {}, milliseconds(0), 0)), "superseded");
  EXPECT_TRUE(is_at_rest_after(2));
  EXPECT_EQ(end_of(run(reading(), {}, milliseconds(0), 0)), "done");
  EXPECT_EQ(result(near_move()), "done");
}

TEST_F(ConnectedTasks, MotorsAreTurnedOffBeforeWhatWaits) {
  run(far_move());
  run(near_move());
  ASSERT_TRUE(eventually_turns());
  EXPECT_EQ(result(motors_off()), "done");
  EXPECT_EQ(end_of(1), "cancelled");
  EXPECT_EQ(end_of(2), "superseded");
}

TEST_F(ConnectedTasks, TooManyThatWaitAreRefused) {
  run(far_move());
  ASSERT_TRUE(eventually_turns());
  for (int i = 0; i < 16; ++i) run(reading());
  EXPECT_EQ(result(reading()), "overload");
  EXPECT_EQ(result({.what = StopOrder()}), "done") << "it needs no room";
  EXPECT_EQ(end_of(17), "done");
}

TEST_F(GimbalTasksTest, NothingMovesWithoutTheBrokerOrTheGimbal) {
  EXPECT_EQ(result(near_move()), "not_connected");
  EXPECT_TRUE(is_at_rest_after(1));
  connect();
  is_broker_there = false;
  EXPECT_EQ(result(near_move()), "no_broker");
  EXPECT_EQ(result(reading()), "done");
  is_broker_there = true;
  EXPECT_EQ(board.count<msg::Control>(), 0U);
  EXPECT_EQ(result(near_move()), "done");
}

TEST_F(ConnectedTasks, ADeadlineThatPassesWhileItWaits) {
  run(far_move());
  ASSERT_TRUE(eventually_turns());
  const std::int64_t early = run(reading(), milliseconds(50));
  const std::int64_t late = run(reading(), std::chrono::minutes(1));
  std::this_thread::sleep_for(milliseconds(100));
  run({.what = StopOrder()});
  EXPECT_EQ(end_of(early), "expired");
  EXPECT_EQ(end_of(late), "done");
}

TEST_F(ConnectedTasks, ASpeedThatWaitedIsRefused) {
  EXPECT_EQ(end_of(run(turning(), {}, 2 * GimbalTasks::longest_silence)), "expired");
  EXPECT_EQ(end_of(run(turning())), "done");
}

TEST_F(ConnectedTasks, ASpeedEndsByItself) {
  const std::int64_t command = run(turning());
  EXPECT_EQ(end_of(command), "done");
  EXPECT_TRUE(eventually_turns());
  EXPECT_THAT(events.wait_for(1), ElementsAre(StartsWith("speed_ended: the camera was stopped")));
  EXPECT_TRUE(is_at_rest_after(command));
  EXPECT_TRUE(eventually_turns(false));
}

TEST_F(ConnectedTasks, TheEndOfASpeedDoesNotStopWhatComesAfterIt) {
  EXPECT_EQ(result(turning()), "done");
  EXPECT_EQ(result(turning_for(Order::forever)), "done");
  std::this_thread::sleep_for(2 * GimbalTasks::longest_silence);
  EXPECT_NE(speed(), 0);
}

TEST_F(ConnectedTasks, WhatGoesOnForAWhileIsThenAtRest) {
  const auto begun = GimbalTasks::Clock::now();
  const std::int64_t command = run(turning_for(milliseconds(500)));
  EXPECT_EQ(end_of(command), "done");
  EXPECT_TRUE(is_at_rest_after(command));
  EXPECT_GE(GimbalTasks::Clock::now() - begun, milliseconds(500));
}

TEST_F(ConnectedTasks, ABrokerThatIsGoneStopsTheCamera) {
  start_turning();
  EXPECT_THAT(rests.wait_for(0), ElementsAre());
  is_broker_there = false;
  EXPECT_THAT(events.wait_for(1),
              ElementsAre("stopped: the broker is gone; the camera has stopped"));
  EXPECT_EQ(speed(), 0);
  EXPECT_TRUE(is_at_rest_after(1));
}

TEST_F(ConnectedTasks, AStopIsOwedOverSilence) {
  start_turning();
  be_silent();
  EXPECT_THAT(result({.what = StopOrder()}), AnyOf("timeout", "not_connected", "link_lost"));
  EXPECT_TRUE(has_event("stopping: the stop is still owed: "));
  EXPECT_TRUE(gimbal->status().is_stopping);
  EXPECT_THAT(result(near_move()), AnyOf("stopping", "not_connected"));
  EXPECT_NE(speed(), 0);
  EXPECT_THAT(rests.wait_for(0), ElementsAre());
  board.on_lost({});
  EXPECT_TRUE(has_event("; the camera has stopped"));
  EXPECT_EQ(speed(), 0);
  EXPECT_TRUE(is_at_rest_after(3));
  EXPECT_FALSE(gimbal->status().is_stopping);
  EXPECT_EQ(result(near_move()), "done");
}

TEST_F(ConnectedTasks, MotorsOffAreOwedOverSilence) {
  be_silent();
  EXPECT_THAT(result(motors_off()), AnyOf("timeout", "not_connected", "link_lost"));
  EXPECT_TRUE(has_event("stopping: motors off is still owed: "));
  board.on_lost({});
  EXPECT_TRUE(has_event("stopped: motors off; "));
  EXPECT_EQ(result(reading()), "done");
}

TEST_F(ConnectedTasks, WhatSomethingElseTurnsIsNotOwedAStop) {
  start_turning();
  board.on_lost([](const Packet& request) { return test::is<msg::Control>(request); });
  // On a busy machine, an answer may be so late that the board counts as silent.
  std::string said = result({.what = StopOrder()});
  for (int i = 0; i < 4 && said == "timeout"; ++i) said = result({.what = StopOrder()});
  EXPECT_EQ(said, "interrupted");
  EXPECT_TRUE(is_at_rest_after(1));
  board.on_lost({});
  is_broker_there = false;
  std::this_thread::sleep_for(milliseconds(300));
  EXPECT_NE(speed(), 0);
}

TEST_F(ConnectedTasks, SilenceWhileTheCameraMovesIsALoss) {
  start_turning();
  be_silent();
  EXPECT_TRUE(has_event("silent: "));
  EXPECT_TRUE(links.wait_until(
      [](const auto& all) { return std::ranges::count(all, GimbalLink::offline) != 0; }));
  EXPECT_NE(speed(), 0);
  board.on_lost({});
  EXPECT_TRUE(has_event("stopped: the gimbal was silent while the camera could move; the camera"));
  EXPECT_EQ(speed(), 0);
}

TEST_F(ConnectedTasks, ALineThatIsLostInTheMiddle) {
  run_three();
  board.unplug();
  // The stop after the loss may precede the move's error.
  EXPECT_THAT(end_of(1), AnyOf("not_connected", "cancelled"));
  EXPECT_EQ(end_of(2), "link_lost");
  EXPECT_THAT(events.wait_for(1),
              ElementsAre("stopped: the line was lost while the camera could move; the camera has "
                          "stopped"));
  EXPECT_EQ(speed(), 0);
  EXPECT_TRUE(is_at_rest_after(2));
  EXPECT_EQ(result(near_move()), "done");
}

TEST_F(ConnectedTasks, ShuttingDownStopsTheCamera) {
  run(far_move());
  run(reading());
  ASSERT_TRUE(eventually_turns());
  shut_down();
  EXPECT_EQ(speed(), 0);
  EXPECT_EQ(end_of(1), "cancelled");
  EXPECT_EQ(end_of(2), "closing");
  EXPECT_EQ(result(reading()), "closing");
  EXPECT_EQ(result({.what = StopOrder()}), "closing");
  EXPECT_TRUE(is_at_rest_after(1));
}

TEST_F(ConnectedTasks, ShuttingDownLeavesACameraAloneThatNothingHasMoved) {
  EXPECT_EQ(result(reading()), "done");
  shut_down();
  EXPECT_EQ(board.count<msg::Control>(), 0U);
}

TEST_F(ConnectedTasks, ShuttingDownCancelsWhatRuns) {
  board.on_lost([](const Packet& request) { return test::is<msg::GetAnglesRequest>(request); });
  const std::int64_t command = run(reading());
  shut_down();
  EXPECT_EQ(end_of(command), "cancelled");
}

TEST_F(GimbalTasksTest, WhatAnEarlierGatewayHasMovedIsStopped) {
  begin(7);
  board.write(turn());
  EXPECT_THAT(rests.wait_for(0), ElementsAre());
  connect();
  EXPECT_THAT(events.wait_for(1),
              ElementsAre("stopped: the gateway ended while the camera could move; the camera has "
                          "stopped"));
  EXPECT_TRUE(is_at_rest_after(7));
  EXPECT_EQ(speed(), 0);
}

TEST_F(GimbalTasksTest, WhatStandsAfterTheStartGetsNothing) {
  begin(7);
  connect();
  EXPECT_TRUE(is_at_rest_after(7));
  EXPECT_EQ(board.count<msg::Control>(), 0U);
}

TEST_F(ConnectedTasks, ShuttingDownTriesUntilItIsGivenUp) {
  EXPECT_EQ(result(turning_for(Order::forever)), "done");
  be_silent();
  std::promise<void> done;
  tasks->shut_down([&] { done.set_value(); });
  EXPECT_TRUE(has_event("stopping: "));
  tasks->give_up();
  has_ended = true;
  EXPECT_THAT(rests.wait_for(0), ElementsAre());
}

TEST_F(ConnectedTasks, ParametersThatAreBeingWrittenEndWithTheExecutor) {
  board.on_lost([](const Packet&) { return true; });
  run({.what = SetOrder{values_of({{"pitch.p", "20"}}, false), {}}, .must_not_wait = true});
  shut_down();
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_THAT(ends.wait_for(0), ElementsAre()) << "they are not left half written";
  gimbal->close();
  io.finish();
  EXPECT_THAT(ends.wait_for(0), ElementsAre(End{1, "cancelled"}));
}

}  // namespace
}  // namespace sbgc::tools
