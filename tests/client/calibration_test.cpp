
#include <sbgc/client/calibration.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class CalibrationTest : public TaskTest {
 protected:
  CalibrationOptions watched() {
    CalibrationOptions options{.interval = Ms(1)};
    options.progress = [this](const CalibrationProgress& seen) {
      EXPECT_TRUE(seen.has_started);
      if (seen.state) progress.push_back(seen.state->progress.raw());
      return goes_on;
    };
    return options;
  }

  /// Advances the board's time by `time` with each progress request.
  void let_pass(Ms time) {
    board.after([this, time](const Packet& request) {
      if (is<msg::CalibInfoRequest>(request)) board.skip(time);
    });
  }

  std::vector<int> progress;
  bool goes_on = true;
};

TEST_F(CalibrationTest, EndsWithTheSecondConfirmationAndTellsItsProgress) {
  let_pass(Ms(700));
  EXPECT_TRUE(client().calibrate(Sensor::gyroscope, watched()));
  // The calibration takes 4 s. It may end after the last progress request, so one more is possible.
  ASSERT_GE(progress.size(), 3U);
  EXPECT_LT(progress[0], 75);
  EXPECT_GT(progress[1], progress[0]);
  EXPECT_GT(progress[2], progress[1]);
  EXPECT_EQ(count<msg::CalibGyro>(), 1U);
}

TEST_F(CalibrationTest, TheBoardIsToldWhichImuAndWhatToDo) {
  let_pass(std::chrono::minutes(1));
  CalibrationOptions options = watched();
  options.imu = msg::CalibImu::frame;
  options.action = msg::CalibAction::temperature;
  EXPECT_TRUE(client().calibrate(Sensor::accelerometer, options));
  const auto request = message<msg::CalibAccExt>(board.log().front());
  EXPECT_EQ(request.imu_idx, msg::CalibImu::frame);
  EXPECT_EQ(request.action, msg::CalibAction::temperature);
  EXPECT_EQ(message<msg::CalibInfoRequest>(board.log().back()).imu_type, msg::SelectedImu::frame);
  EXPECT_TRUE(board.memory().imus[1].acc_temperature_enabled);
  EXPECT_FALSE(board.memory().imus[0].acc_temperature_enabled);
}

TEST_F(CalibrationTest, WithoutTheFirstConfirmationItHasNotBegun) {
  board.on_lost([](const Packet& request) { return is<msg::CalibGyro>(request); });
  EXPECT_THAT(client().calibrate(Sensor::gyroscope), fails(ErrorCode::timeout, "calibrating: "));
}

TEST_F(CalibrationTest, WithoutTheSecondConfirmationItsEndIsNotKnown) {
  CalibrationOptions options;
  options.timeout = Ms(1500);  // the calibration takes 4 s
  EXPECT_THAT(client().calibrate(Sensor::gyroscope, options),
              fails(ErrorCode::timeout, "has started, but its result is unknown"));
}

TEST_F(CalibrationTest, WaitingCanBeCancelled) {
  goes_on = false;
  EXPECT_THAT(client().calibrate(Sensor::gyroscope, watched()), fails(ErrorCode::cancelled));
}

TEST_F(CalibrationTest, ABoardThatRestartsMeanwhileIsAnError) {
  board.tamper([looks = 0](Packets& answers) mutable {
    for (const Packet& one : answers) looks += is<msg::CalibInfo>(one) ? 1 : 0;
    if (looks == 3) answers.push_back(packet(msg::Reset{}));
  });
  EXPECT_THAT(client().calibrate(Sensor::gyroscope, watched()), fails(ErrorCode::board_reset));
}

TEST_F(CalibrationTest, ALineThatBreaksMeanwhileIsAnError) {
  board.after([this](const Packet& request) {
    if (is<msg::CalibInfoRequest>(request)) board.unplug();
  });
  EXPECT_THAT(client().calibrate(Sensor::gyroscope, watched()), fails(ErrorCode::link_lost));
}

TEST_F(CalibrationTest, AnyRequestCanCalibrate) {
  // Confirmed at the end only.
  board.after([this](const Packet& request) {
    if (is<msg::CalibPoles>(request)) board.skip(std::chrono::seconds(30));
  });
  const auto poles = checked(client().run_calibration(msg::CalibPoles{}));
  EXPECT_EQ(*poles, CalibrationEnd::finished);
  // Confirmed at the start only, if at all.
  const auto mag = checked(client().run_calibration(msg::CalibMag{}));
  EXPECT_EQ(*mag, CalibrationEnd::accepted);
  board.on_answer_lost([](const Packet&) { return true; });
  EXPECT_THAT(client().run_calibration(msg::CalibBat{}), fails(ErrorCode::unconfirmed));
}

TEST_F(CalibrationTest, OneAfterTheOther) {
  board.after([this](const Packet& request) {
    if (is<msg::CalibGyroExt>(request)) board.skip(std::chrono::seconds(30));
  });
  msg::CalibGyroExt request{.imu_idx = msg::CalibImu::main, .action = msg::CalibAction::regular};
  for (int i = 0; i < 2; ++i) {
    const auto ended = checked(client().run_calibration(request));
    EXPECT_EQ(*ended, CalibrationEnd::finished);
  }
}

}  // namespace
}  // namespace sbgc::test
