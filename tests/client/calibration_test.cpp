#include <vector>

#include <sbgc/client/calibration.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CalibrationTest : public TaskTest {
 protected:
  CalibrationOptions watched() {
    CalibrationOptions options;
    options.interval = milliseconds(1);
    options.progress = [this](const CalibrationProgress& seen) {
      EXPECT_TRUE(seen.has_started);
      if (seen.state) progress.push_back(seen.state->progress.raw());
      return goes_on;
    };
    return options;
  }

  std::vector<int> progress;
  bool goes_on = true;
};

TEST_F(CalibrationTest, EndsWithTheSecondConfirmationAndTellsItsProgress) {
  EXPECT_TRUE(calibrate(client(), Sensor::gyroscope, watched()));
  EXPECT_THAT(progress, ElementsAre(33, 66, 100));
  EXPECT_EQ(count<CalibGyro>(), 1U);
}

TEST_F(CalibrationTest, TheBoardIsToldWhichImuAndWhatToDo) {
  CalibrationOptions options = watched();
  options.imu = CalibImu::frame;
  options.action = CalibAction::temperature;
  EXPECT_TRUE(calibrate(client(), Sensor::accelerometer, options));
  const auto request = message<CalibAccExt>(board.log.front());
  EXPECT_EQ(request.imu_idx, CalibImu::frame);
  EXPECT_EQ(request.action, CalibAction::temperature);
  EXPECT_EQ(message<CalibInfoRequest>(board.log.back()).imu_type, SelectedImu::frame);
}

TEST_F(CalibrationTest, WithoutTheFirstConfirmationItHasNotBegun) {
  board.is_lost = [](const Packet& request) { return is<CalibGyro>(request); };
  const auto done = calibrate(client(), Sensor::gyroscope);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::timeout);
  EXPECT_THAT(done.error().message, HasSubstr("calibrating: "));
}

TEST_F(CalibrationTest, WithoutTheSecondConfirmationItsEndIsNotKnown) {
  CalibrationOptions options;
  options.timeout = milliseconds(50);
  const auto done = calibrate(client(), Sensor::gyroscope, options);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::timeout);
  EXPECT_THAT(done.error().message, HasSubstr("has begun, but its end is not known"));
}

TEST_F(CalibrationTest, WaitingCanBeCancelled) {
  goes_on = false;
  const auto done = calibrate(client(), Sensor::gyroscope, watched());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::cancelled);
}

TEST_F(CalibrationTest, ABoardThatRestartsMeanwhileIsAnError) {
  board.calibration_steps = 1000;
  board.after = [this, looks = 0](const Packet& request) mutable {
    if (is<CalibInfoRequest>(request) && ++looks == 3) send_reset();
  };
  const auto done = calibrate(client(), Sensor::gyroscope, watched());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::board_reset);
}

TEST_F(CalibrationTest, ALineThatBreaksMeanwhileIsAnError) {
  board.calibration_steps = 1000;
  board.after = [this](const Packet& request) {
    if (is<CalibInfoRequest>(request)) unplug();
  };
  const auto done = calibrate(client(), Sensor::gyroscope, watched());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::link_lost);
}

}  // namespace
}  // namespace sbgc::test
