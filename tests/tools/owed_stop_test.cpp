#include "motion/owed_stop.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include <sbgc/messages/control.hpp>
#include <sbgc/meta/control.hpp>

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

}  // namespace
}  // namespace sbgc::tools
