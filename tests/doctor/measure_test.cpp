// Tests of measuring an emulated board in virtual time.

#include <memory>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/measure.hpp>

#include "../client/virtual_client.hpp"
#include "serving/faults.hpp"

namespace sbgc::doctor {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

emulator::EmulatorOptions board_with(const std::string& faults) {
  emulator::EmulatorOptions options;
  EXPECT_EQ(serving::add_faults(faults, options.board), "");
  return options;
}

/// With an accelerometer that is calibrated in all positions.
emulator::Memory calibrated() {
  emulator::Memory memory;
  memory.imus[0].acc_limits = 0x3F;
  return memory;
}

TEST(Measure, FindsAFaultWithTwoDataStreams) {
  test::VirtualClient client(board_with("resonance=37Hz:0.5:pitch"), calibrated());
  client.pass(seconds(4));  // a camera that has just started shakes
  double last = 0;
  const auto measured = client.run(tasks::measure({.progress = [&](double seconds) {
    last = seconds;
    return true;
  }}));
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->sampling, Sampling::stream);
  EXPECT_DOUBLE_EQ(measured->gyro->rate(), 250);
  EXPECT_DOUBLE_EQ(measured->again->rate(), 200);
  EXPECT_GT(measured->gyro->size(), 600U);
  EXPECT_GT(measured->again->size(), 480U);
  EXPECT_NEAR(last, 5, 0.2);
  const auto findings = findings_of(*measured);
  ASSERT_THAT(findings, ElementsAre(Field(&Finding::id, "vibration")));
  EXPECT_THAT(findings[0].sentence, HasSubstr("The pitch axis shakes at 37.0 Hz"));
}

TEST(Measure, NoStreamGoesOnAfterIt) {
  test::VirtualClient client;
  int progress = 0;
  const auto measured =
      client.run(tasks::measure({.progress = [&](double) { return ++progress < 10; }}));
  ASSERT_FALSE(measured);
  EXPECT_EQ(measured.error().code, ErrorCode::cancelled);
  client.pass(milliseconds(100));
  std::size_t frames = 0;
  const auto heard = client.delivery().on_frame([&](const BoardFrame&) { ++frames; });
  client.pass(seconds(1));
  EXPECT_EQ(frames, 0U);
}

TEST(Measure, JudgesALineThatLosesManyAnswers) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    emulator::EmulatorOptions options;
    options.line.seed = seed;
    const auto board = std::make_shared<test::VirtualBoard>(options, calibrated());
    test::VirtualClient client(board);
    options.line.faults.bit_errors = 0.0005;  // damages a third of the answers
    board->emulator.change(options, board->now);
    auto measured = client.run(tasks::measure());
    ASSERT_TRUE(measured) << seed << ": " << measured.error().message;
    measured->damaged_share = 0.3;  // as the client counts
    EXPECT_THAT(findings_of(*measured), Contains(Field(&Finding::id, "line"))) << seed;
  }
}

TEST(Measure, AsksABoardWithoutStreams) {
  emulator::EmulatorOptions options = board_with("overload=yaw");
  options.board.firmware = msg::FirmwareVersion(2439);
  test::VirtualClient client(options, calibrated());
  const auto measured = client.run(tasks::measure());
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->sampling, Sampling::polls);
  EXPECT_DOUBLE_EQ(measured->again->rate(), measured->gyro->rate() / 1.25);
  EXPECT_THAT(findings_of(*measured), ElementsAre(Field(&Finding::id, "motor-power")));
}

}  // namespace
}  // namespace sbgc::doctor
