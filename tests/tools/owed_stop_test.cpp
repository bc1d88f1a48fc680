#include "move/owed_stop.hpp"

#include <array>
#include <chrono>
#include <random>

#include <gtest/gtest.h>

#include <sbgc/messages/control.hpp>
#include <sbgc/meta/control.hpp>

#include "../client/virtual_client.hpp"

namespace sbgc::tools {
namespace {

using State = OwedStop::State;
using std::chrono::seconds;

constexpr OwedStop::Time start{};

Result<void> error(ErrorCode code) { return ClientError{code, "it failed"}; }

OwedStop motors_off() {
  const msg::MotorsOff request;
  return OwedStop(AnyMessage(*find_message(Meta<msg::MotorsOff>::info.name), &request), start);
}

TEST(OwedStop, StaysOwedOverSilenceAndLosses) {
  OwedStop stop;
  for (int second = 0; second < 3600; second += 3) {
    const auto began = start + seconds(second);
    const ErrorCode code = second % 2 == 0 ? ErrorCode::timeout : ErrorCode::link_lost;
    ASSERT_EQ(stop.take(error(code), began, began + seconds(3)), State::owed);
  }
  EXPECT_EQ(stop.take({}, start, start), State::done);
}

TEST(OwedStop, FailsIfTheBoardAnswersForLongAndTheCameraTurns) {
  OwedStop stop;
  EXPECT_EQ(stop.take(error(ErrorCode::board_error), start, start + seconds(1)), State::owed);
  EXPECT_EQ(stop.take(error(ErrorCode::timeout), start + seconds(1), start + seconds(2)),
            State::owed);
  EXPECT_EQ(stop.take(error(ErrorCode::board_error), start + seconds(2), start + seconds(3)),
            State::owed);
  EXPECT_EQ(stop.take(error(ErrorCode::interrupted), start + seconds(3), start + seconds(5)),
            State::failed);
}

TEST(OwedStop, FailsIfNoAttemptCanSucceed) {
  for (const ErrorCode code : {ErrorCode::unsupported, ErrorCode::invalid, ErrorCode::superseded}) {
    EXPECT_EQ(OwedStop().take(error(code), start, start), State::failed);
  }
}

TEST(OwedStop, MotorsAreTurnedOffForTenSeconds) {
  OwedStop stop = motors_off();
  static_cast<void>(stop.attempt(start + seconds(9)));
  EXPECT_TRUE(stop.turns_motors_off());
  static_cast<void>(stop.attempt(start + seconds(10)));
  EXPECT_FALSE(stop.turns_motors_off());
}

TEST(OwedStop, MotorsAreNotTurnedOffAfterARestart) {
  OwedStop stop = motors_off();
  EXPECT_EQ(stop.take(error(ErrorCode::board_reset), start, start), State::owed);
  EXPECT_FALSE(stop.turns_motors_off());
}

/// Carries nothing until a moment, and then loses a share of what is sent.
class UnreliableLine final : public test::VirtualLine {
 public:
  explicit UnreliableLine(unsigned seed) : random_(seed) {}

  void fail(Instant until, double loss) {
    silent_until_ = until;
    loss_ = loss;
  }
  void send(Way way, std::span<const std::uint8_t> bytes, Instant now) override {
    const bool is_lost = now < silent_until_ || std::bernoulli_distribution(loss_)(random_);
    if (!is_lost) VirtualLine::send(way, bytes, now);
  }

 private:
  std::mt19937 random_;
  Instant silent_until_{};
  double loss_ = 0;
};

class OwedStopProperty : public ::testing::TestWithParam<unsigned> {};

TEST_P(OwedStopProperty, IsDoneWhenTheCameraRestsHoweverTheLineIs) {
  std::mt19937 random(GetParam());
  const auto between = [&](int from, int to) {
    return std::uniform_int_distribution(from, to)(random);
  };
  UnreliableLine line(GetParam());
  emulator::EmulatorOptions options;
  options.board.firmware = msg::FirmwareVersion(
      static_cast<std::uint16_t>(std::array{2439, 2590, 2740}[GetParam() % 3]));
  options.board.gimbal.noise = 0;
  test::VirtualClient client(options, {}, &line);
  msg::Control turn;
  turn.control_mode.set_mode(msg::ControlModeKind::speed);
  turn.axes.yaw.speed = msg::ControlSpeed(static_cast<std::int16_t>(between(1, 300)));
  const bool turns = between(0, 4) != 0;
  if (turns) {
    const auto begin = [](msg::Control order) -> Task<Result<void>> {
      co_return co_await tasks::call(order);
    };
    ASSERT_TRUE(client.run(begin(turn)));
  }
  client.pass(sbgc::milliseconds(between(0, 1'000)));
  line.fail(client.now() + sbgc::milliseconds(between(0, 8'000)), between(0, 20) / 100.0);
  const auto now = [&] { return OwedStop::Time(std::chrono::microseconds(client.now().us)); };
  OwedStop stop;
  const bool was_lost = between(0, 1) == 0;
  if (was_lost) stop.line_lost();
  const auto commanded = client.gimbal().sample(client.now()).angles.yaw;
  State state = State::owed;
  Result<void> ended;
  for (const Instant end = client.now() + sbgc::seconds(120);
       state == State::owed && client.now() < end;) {
    const auto began = now();
    ended = client.run(stop.attempt(began));
    state = stop.take(ended, began, now());
    client.pass(sbgc::milliseconds(100));
  }
  EXPECT_EQ(state, State::done) << (ended ? "" : ended.error().message);
  const emulator::Sample end = client.gimbal().sample(client.now());
  EXPECT_EQ(end.target_speeds.yaw, 0);
  client.pass(sbgc::seconds(2));
  EXPECT_NEAR(client.gimbal().sample(client.now()).angles.yaw, end.angles.yaw, 0.5);
  if (!turns) EXPECT_NEAR(end.angles.yaw, commanded, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OwedStopProperty, ::testing::Range(0U, 150U));

}  // namespace
}  // namespace sbgc::tools
