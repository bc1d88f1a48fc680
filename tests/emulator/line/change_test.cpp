// Tests of Emulator::change(): motion of the frame and faults that begin and end while a board
// runs.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/codec.hpp>
#include <sbgc/messages/realtime.hpp>

#include "emulator_rig.hpp"

namespace sbgc::emulator::test {
namespace {

/// The live data that the board sends now.
msg::RealtimeData4 data_of(Bench& bench) {
  msg::RealtimeData4 data;
  bench.send(frame_of(msg::RealtimeData4Request{}));
  ParserOfAll parser;
  parser.feed(bench.listen(milliseconds(100)),
              [&](const Frame& frame) { EXPECT_TRUE(decode(frame.body, data)); });
  return data;
}

TEST(EmulatorChange, FaultsOfTheBoardBeginAndEnd) {
  Bench bench;
  EmulatorOptions options;
  options.board.faults.errors.set(msg::SystemError::no_sensor);
  options.board.faults.i2c_errors = 100;
  options.board.gimbal.battery = 13.8;
  bench.emulator.change(options, bench.now);
  bench.listen(seconds(2));
  const msg::RealtimeData4 faulty = data_of(bench);
  EXPECT_TRUE(faulty.system_error.has(msg::SystemError::no_sensor));
  EXPECT_NEAR(faulty.i2c_error_count, 200, 5) << "counted from the change on";
  EXPECT_LT(faulty.bat_level.volts(), 14);

  bench.emulator.change({}, bench.now);
  bench.listen(seconds(2));
  const msg::RealtimeData4 healthy = data_of(bench);
  EXPECT_EQ(healthy.system_error.raw(), 0);
  EXPECT_NEAR(healthy.i2c_error_count, 210, 15) << "a counter does not fall";
  EXPECT_GT(healthy.bat_level.volts(), 15);
}

TEST(EmulatorChange, TheFrameMovesAndTheCameraStays) {
  Bench bench;
  EmulatorOptions options;
  options.board.gimbal.frame = {.kind = Disturbance::Kind::vehicle, .strength = 3};
  bench.emulator.change(options, bench.now);
  const auto largest = [&](auto angle_of) {
    double result = 0;
    for (int i = 0; i < 20; ++i) {
      bench.listen(milliseconds(100));
      result = std::max(result, std::abs(angle_of(data_of(bench))));
    }
    return result;
  };
  const auto frame = [](const msg::RealtimeData4& data) {
    return data.frame_imu_angle.pitch.degrees();
  };
  const auto camera = [](const msg::RealtimeData4& data) { return data.angle.pitch.degrees(); };
  const double most = largest(frame);
  EXPECT_GT(most, 1);
  EXPECT_LT(largest(camera), most / 3);
  bench.emulator.change({}, bench.now);
  bench.listen(seconds(1));
  EXPECT_LT(largest(frame), 0.5);
}

TEST(EmulatorChange, TheLineLosesBytesFromThenOn) {
  Bench bench;
  const auto lost = [&] { return bench.emulator.counters(bench.port, Line::Way::to_host).lost; };
  bench.send(stream_of(20));
  bench.listen(seconds(1));
  EXPECT_EQ(lost(), 0U);
  EmulatorOptions options;
  options.line.faults.lost = 0.1;
  bench.emulator.change(options, bench.now);
  bench.listen(seconds(1));
  const std::uint64_t some = lost();
  EXPECT_GT(some, 100U);
  bench.emulator.change({}, bench.now);
  bench.listen(seconds(1));
  EXPECT_EQ(lost(), some);
}

}  // namespace
}  // namespace sbgc::emulator::test
