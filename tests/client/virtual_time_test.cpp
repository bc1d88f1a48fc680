// Tests of tasks and of a client without threads, clocks and lines: in virtual time.

#include <sbgc/client/backup.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/motion.hpp>

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

/// A line on which bytes pass only at the settings of the board.
class Search : public ::testing::Test {
 protected:
  static constexpr LineSettings board_line{57600, Parity::even};

  /// Runs the client until `result`.
  Result<void> finish(const std::optional<Result<void>>& result) {
    while (!result) {
      if (const auto bytes = client.advance(now); !bytes.empty()) {
        if (line == board_line) board.from_host(port, bytes, now);
        client.written(now);
      }
      board.advance(now);
      if (const auto bytes = board.to_host(port); !bytes.empty()) {
        client.receive(bytes, now);
        board.take(port, bytes.size(), now);
      }
      now = later(earlier(client.deadline(), board.next()), now + microseconds(1));
    }
    return *result;
  }
  Result<void> search() {
    std::optional<Result<void>> result;
    client.detect_line(
        [&](const LineSettings& wanted) {
          line = wanted;
          return wanted.baud_rate != refused_rate;
        },
        [&](const Result<void>& found) { result = found; });
    return finish(result);
  }

  Instant now{};
  LineSettings line{};
  std::uint32_t refused_rate = 115200;
  emulator::Emulator board{{.board = {.firmware = msg::FirmwareVersion(2730)}}, {}, now};
  std::size_t port = board.connect(true, now).value();
  PassiveClient client{};
};

TEST_F(Search, FindsTheLineThenTheNewestFraming) {
  require(search());
  EXPECT_EQ(line, board_line);

  std::optional<Result<void>> connected;
  std::optional<Framing> last;
  const Subscription frames =
      client.on_frame([&](const BoardFrame& one) { last = one.frame.framing; });
  client.connect([&](const Result<void>& result) { connected = result; });
  ASSERT_TRUE(finish(connected));
  EXPECT_NE(newest_framing(client.identity().versions()), basic_framing);
  EXPECT_EQ(last, newest_framing(client.identity().versions()));
}

TEST_F(Search, FailsWhereNoSettingsServe) {
  refused_rate = board_line.baud_rate;
  EXPECT_THAT(search(), fails(ErrorCode::not_found));
}

}  // namespace
}  // namespace sbgc::test
