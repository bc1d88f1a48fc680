// Stops against everything that moves: threads of one client, other programs, losses. In virtual
// time.

#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>

#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

/// A line that loses whole writes.
class LossyLine : public VirtualLine {
 public:
  LossyLine(std::uint32_t seed, double losses) : random_(seed), is_lost_(losses) {}

  /// Lets `pass(way, bytes)` decide first.
  std::function<bool(Way, std::span<const std::uint8_t>)> pass{};
  bool is_working = false;  // while the client connects, nothing is lost

  void send(Way way, std::span<const std::uint8_t> bytes, Instant now) override {
    if (is_working && (is_lost_(random_) || (pass && !pass(way, bytes)))) return;
    VirtualLine::send(way, bytes, now);
  }

 private:
  std::mt19937 random_;
  std::bernoulli_distribution is_lost_;
};

/// Programs at one board.
class Programs {
 public:
  explicit Programs(int firmware = 2745, double losses = 0, std::uint32_t seed = 1) {
    board = std::make_shared<VirtualBoard>(calm_board(firmware));
    for (std::uint32_t i = 0; i < 3; ++i) {
      lines.push_back(std::make_unique<LossyLine>(3 * seed + i, losses));
      clients.push_back(std::make_unique<VirtualClient>(board, lines.back().get()));
    }
    for (const auto& line : lines) line->is_working = true;
  }

  VirtualClient& operator[](std::size_t program) { return *clients[program]; }

  /// Lets all programs run until this time, or until the condition holds.
  void run(
      Instant until, const std::function<bool()>& is_over = [] { return false; }) {
    while (board->now < until && !is_over()) {
      Instant next = until;
      for (const auto& client : clients) next = earlier(next, client->proceed());
      if (at_each_step) at_each_step();
      if (next > board->now) board->now = later(board->now + microseconds(1), next);
    }
  }
  void run_for(Duration time) { run(board->now + time); }
  /// Starts a task; returns where its result will be.
  template <class R>
  std::shared_ptr<std::optional<R>> start(std::size_t program, Task<R> task) {
    const auto result = std::make_shared<std::optional<R>>();
    clients[program]->start(std::move(task), [result](R one) { *result = std::move(one); });
    return result;
  }
  /// Runs until the result is there.
  template <class R>
  R await(const std::shared_ptr<std::optional<R>>& result) {
    run(board->now + seconds(60), [&] { return result->has_value(); });
    return result->value();
  }

  emulator::Sample sample() { return clients[0]->gimbal().sample(board->now); }
  bool stands() {
    const Axes<double> speeds = sample().target_speeds;
    return speeds.roll == 0 && speeds.pitch == 0 && speeds.yaw == 0;
  }

  std::shared_ptr<VirtualBoard> board;
  std::vector<std::unique_ptr<LossyLine>> lines;
  std::vector<std::unique_ptr<VirtualClient>> clients;
  std::function<void()> at_each_step{};
};

/// The owner of a held speed: yaw at 20 deg/s.
class Owner {
 public:
  Owner(Programs& programs, std::size_t program, bool yields)
      : programs_(programs),
        speed_(programs[program].held_speed()),
        task_(programs[program].start(
            detail::hold_speed(speed_, detail::BoundedTurn(MotionBound::none, {}), yields),
            [](const Result<void>&) {})) {}

  Result<void> set() {
    task_.wake();
    return speed_->set({.yaw = 20_deg_per_s}, programs_.board->now);
  }
  Result<void> stop() {
    task_.wake();
    return speed_->stop();
  }
  /// Sets it every 20 ms until that fails.
  void set_again() {
    if (is_over_ || programs_.board->now < next_) return;
    next_ = programs_.board->now + sbgc::milliseconds(20);
    is_over_ = !set();
  }

 private:
  Programs& programs_;
  std::shared_ptr<detail::HeldSpeed> speed_;
  TaskMachine& task_;
  Instant next_{};
  bool is_over_ = false;
};

MoveOptions slowly(msg::ControlSpeed speed = 10_deg_per_s) { return {.speed = speed}; }

class StopTest : public ::testing::TestWithParam<int> {
 protected:
  Programs programs{GetParam()};
};

TEST_P(StopTest, OfAnotherProgramEndsAMove) {
  const auto move = programs.start(0, tasks::move_to({.pitch = 80_deg}, slowly()));
  programs.run_for(sbgc::milliseconds(1000));
  ASSERT_TRUE(programs.await(programs.start(1, tasks::stop())));
  const double stopped_at = programs.sample().angles.pitch;
  EXPECT_THAT(programs.await(move),
              fails(ErrorCode::interrupted, "its target is no longer 80.00: another program"));
  programs.run_for(seconds(3));
  EXPECT_NEAR(programs.sample().angles.pitch, stopped_at, 0.3);
}

TEST_P(StopTest, OfTheSameClientSupersedesItsMoves) {
  const auto move = programs.start(0, tasks::move_to({.pitch = 80_deg}, slowly()));
  programs.run_for(sbgc::milliseconds(1000));
  const auto stopped = programs.start(0, tasks::stop());
  EXPECT_EQ(programs.await(move).error().code, ErrorCode::superseded);
  EXPECT_TRUE(programs.await(stopped));
  programs.run_for(seconds(3));
  EXPECT_TRUE(programs.stands());
}

TEST_P(StopTest, RightAfterTheStartOfAMove) {
  for (int after = 0; after < 50'000; after += 3'000) {
    const auto move = programs.start(0, tasks::move_to({.pitch = 80_deg}, slowly()));
    programs.run_for(microseconds(after));
    ASSERT_TRUE(programs.await(programs.start(1, tasks::stop()))) << after;
    programs.run_for(sbgc::milliseconds(1000));
    EXPECT_TRUE(programs.stands()) << after;
    EXPECT_FALSE(programs.await(move)) << after;
  }
}

TEST_P(StopTest, WithoutRestItFailsAndSaysSo) {
  EXPECT_THAT(programs.await(programs.start(0, tasks::stop({.timeout = Ms(300), .rest = Ms(500)}))),
              fails(ErrorCode::interrupted, Eq("the camera has not come to rest")));
}

TEST_P(StopTest, ALaterMotionOfTheSameClientEndsItsWatch) {
  const auto stopped = programs.start(0, tasks::stop());
  programs.run_for(sbgc::milliseconds(100));
  const auto move = programs.start(0, tasks::move_to({.pitch = 5_deg}));
  EXPECT_EQ(programs.await(stopped).error().code, ErrorCode::superseded);
  EXPECT_TRUE(programs.await(move));
}

TEST_P(StopTest, ALaterCommandEndsTheStopOfACancelledMove) {
  std::optional<Result<MoveProgress>> ended;
  TaskMachine& move =
      programs[0].start(tasks::move_to({.pitch = 80_deg}, slowly()),
                        [&](Result<MoveProgress> result) { ended = std::move(result); });
  programs.run_for(sbgc::milliseconds(1000));
  move.cancel();
  programs.run_for(sbgc::milliseconds(50));
  EXPECT_TRUE(programs.await(programs.start(0, tasks::stop())));
  ASSERT_TRUE(ended.has_value());
  EXPECT_THAT(*ended,
              fails(ErrorCode::cancelled,
                    ::testing::EndsWith("); a later command stops the camera or moves it")));
}

TEST_P(StopTest, AStalledAxisHasItsTargetSentOnce) {
  int targets = 0;
  programs.lines[0]->pass = [&](VirtualLine::Way way, std::span<const std::uint8_t> bytes) {
    if (way == VirtualLine::Way::to_board && bytes[1] == 67) ++targets;
    return true;
  };
  programs[0].gimbal().jam(1, true, programs.board->now);
  MoveOptions options = slowly(40_deg_per_s);
  options.timeout = Ms(5000);
  options.stop_on_failure = false;
  EXPECT_THAT(programs.await(programs.start(0, tasks::move_to({.pitch = 20_deg}, options))),
              fails(ErrorCode::timeout));
  EXPECT_EQ(targets, 1);
}

TEST_P(StopTest, TheSlowestMoveArrives) {
  MoveOptions options = slowly(msg::ControlSpeed(1));  // 0.12 deg/s
  options.tolerance = 0.1;
  const auto moved = programs.await(programs.start(0, tasks::move_to({.pitch = 1_deg}, options)));
  EXPECT_TRUE(moved) << moved.error().message;
}

TEST_P(StopTest, ATargetThatIsLostIsRepeatedForAtMost400Milliseconds) {
  const Instant start = programs.board->now;
  Instant last{};
  programs.lines[0]->pass = [&](VirtualLine::Way way, std::span<const std::uint8_t> bytes) {
    const bool is_control = way == VirtualLine::Way::to_board && bytes[1] == 67;
    if (is_control) last = programs.board->now;
    return !is_control;
  };
  MoveOptions options = slowly();
  options.stop_on_failure = false;
  EXPECT_THAT(programs.await(programs.start(0, tasks::move_to({.pitch = 20_deg}, options))),
              fails(ErrorCode::timeout, "did not begin"));
  EXPECT_LE((last - start).us, 420'000);
  EXPECT_GE((last - start).us, 200'000);
}

TEST_P(StopTest, AHeldSpeedOfTheSameClientFailsOnceAndThenTurnsAgain) {
  Owner owner(programs, 0, false);
  ASSERT_TRUE(owner.set());
  programs.run_for(sbgc::milliseconds(300));
  EXPECT_FALSE(programs.stands());
  const auto stopped = programs.start(0, tasks::stop());
  programs.run_for(sbgc::milliseconds(1));
  EXPECT_EQ(owner.set().error().code, ErrorCode::superseded);
  EXPECT_TRUE(programs.await(stopped));
  EXPECT_TRUE(programs.stands());
  ASSERT_TRUE(owner.set());
  programs.run_for(sbgc::milliseconds(300));
  EXPECT_FALSE(programs.stands());
}

// For example, keys that are held, released and held again, or a machine that stalls.
TEST_P(StopTest, AHeldSpeedMayBeginAgainAfterItsOwnStop) {
  Owner owner(programs, 0, true);
  for (int i = 0; i < 6; ++i) {
    ASSERT_TRUE(owner.set());
    programs.run_for(sbgc::milliseconds(300));
    EXPECT_FALSE(programs.stands());
    if (i % 2 == 0) {
      ASSERT_TRUE(owner.stop());
    }
    programs.run_for(sbgc::seconds(2));
    EXPECT_TRUE(programs.stands());
  }
}

INSTANTIATE_TEST_SUITE_P(Firmware, StopTest, ::testing::Values(2430, 2590, 2745));

/// Random tasks in three programs, then a stop: when it succeeds, nothing that began before moves
/// the camera.
class StopProperty : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(StopProperty, NothingMovesAfterAStopThatHasSucceeded) {
  std::mt19937 random(GetParam());
  const auto upto = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  const auto any_program = [&] { return static_cast<std::size_t>(upto(2)); };
  const std::vector<int> versions{2430, 2590, 2745};
  const double losses = upto(2) * 0.03;
  Programs programs(versions[any_program()], losses, GetParam());
  std::vector<Owner> owners;
  programs.at_each_step = [&] {
    for (Owner& owner : owners) owner.set_again();
  };
  const std::size_t stopper = any_program();
  bool is_fought = false;  // a held speed of another program is repeated by its owner
  for (int i = 0, count = 1 + upto(4); i < count; ++i) {
    const std::size_t program = any_program();
    const msg::Angle14 angle(static_cast<std::int16_t>(upto(3000)));
    const int kind = upto(4);
    switch (kind) {
      case 0: programs.start(program, tasks::move_to({.pitch = angle}, slowly())); break;
      case 1: programs.start(program, tasks::move_to({.yaw = angle}, slowly(40_deg_per_s))); break;
      case 2: programs.start(program, tasks::begin_move({.yaw = angle}, slowly())); break;
      case 3: programs.start(program, tasks::stop()); break;
      default: {
        const bool yields = upto(1) != 0;
        owners.emplace_back(programs, program, yields);
        owners.back().set_again();
        is_fought = is_fought || (program != stopper && !yields);
      }
    }
    programs.run_for(sbgc::milliseconds(upto(700)));
  }
  const auto stopped = programs.await(programs.start(stopper, tasks::stop()));
  if (!stopped) {
    EXPECT_TRUE(is_fought || losses > 0) << stopped.error().message;
    return;
  }
  EXPECT_TRUE(programs.stands());
  bool has_moved = false;
  programs.run(programs.board->now + seconds(4), [&] { return has_moved = !programs.stands(); });
  EXPECT_FALSE(has_moved);
}

INSTANTIATE_TEST_SUITE_P(Seeds, StopProperty, ::testing::Range(0U, 300U));

}  // namespace
}  // namespace sbgc::test
