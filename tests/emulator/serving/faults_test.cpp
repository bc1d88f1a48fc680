// Tests of the faults of `sbgc emulate --fault`.

#include "serving/faults.hpp"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host.hpp"

namespace sbgc::serving {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// The live data of a board with these faults, two seconds after its start.
msg::RealtimeData4 seen(const std::string& list) {
  emulator::BoardOptions options;
  if (!list.empty()) EXPECT_EQ(add_faults(list, options), "");
  test::Host host(options);
  host.listen(seconds(2));
  return host.get<msg::RealtimeData4>(msg::RealtimeData4Request{});
}

TEST(GimbalFaults, AHealthyBoardReportsNone) {
  const msg::RealtimeData4 data = seen("");
  EXPECT_EQ(data.system_error.raw(), 0);
  EXPECT_EQ(data.i2c_error_count, 0);
  EXPECT_EQ(data.cycle_time.raw(), 800);
}

TEST(GimbalFaults, ErrorsOfTheBoard) {
  EXPECT_EQ(seen("imu").system_error, msg::SystemErrors(msg::SystemError::no_sensor));
  EXPECT_EQ(seen("calib-acc,missed-steps").system_error,
            msg::SystemError::calib_acc | msg::SystemError::miss_steps);
  EXPECT_EQ(seen("emergency-stop").system_sub_error, msg::SystemSubError::i2c_errors);
}

TEST(GimbalFaults, Measurements) {
  EXPECT_EQ(seen("low-battery").system_error, msg::SystemErrors(msg::SystemError::low_bat1));
  EXPECT_NEAR(seen("low-battery=13.5V").bat_level.volts(), 13.45, 0.1);
  EXPECT_NEAR(seen("i2c-errors=100").i2c_error_count, 255, 10);
  EXPECT_NEAR(seen("line=100").serial_error_cnt, 255, 10);
  EXPECT_EQ(seen("slow-cycle=1500us").cycle_time.raw(), 1500);
  EXPECT_EQ(seen("overload=roll").motor_power.roll, 255);
  EXPECT_LT(seen("overload=roll").motor_power.pitch, 200);
  EXPECT_GT(std::abs(seen("imbalance=0.5:roll").balance_error.roll.percent()), 20);
  EXPECT_LT(std::abs(seen("imbalance=0.5:roll").balance_error.pitch.percent()), 5);
  EXPECT_GT(seen("drift").imu_g_err.degrees(), 2.5);
  EXPECT_LT(seen("").imu_g_err.degrees(), 0.5);
}

TEST(GimbalFaults, AResonanceTurnsTheCameraWhileTheMotorsAreOn) {
  emulator::BoardOptions options;
  options.gimbal.noise = 0;
  EXPECT_EQ(add_faults("resonance=5Hz:10:roll", options), "");
  test::Host host(options);
  host.listen(seconds(1));
  const auto rate = [&] { return host.board.gimbal().sample(host.now).gyro; };
  double largest = 0;
  for (int i = 0; i < 100; ++i) {  // two periods
    host.listen(milliseconds(4));
    largest = std::max(largest, std::abs(rate().y));
    EXPECT_NEAR(rate().x, 0, 0.2) << "another axis";
  }
  EXPECT_NEAR(largest, 10, 0.5);
  host.ask(msg::MotorsOff{});
  host.listen(seconds(1));
  EXPECT_NEAR(rate().y, 0, 0.1);
}

TEST(GimbalFaults, MistakesAreExplained) {
  emulator::BoardOptions board;
  const auto problem = [&](const std::string& list) { return add_faults(list, board); };
  EXPECT_THAT(problem("low-batery"), HasSubstr("did you mean 'low-battery'?"));
  EXPECT_THAT(problem(""), HasSubstr("there are low-battery"));
  EXPECT_THAT(problem("imu,"), HasSubstr("unknown fault ''"));
  EXPECT_EQ(problem("imu=1"), "the fault 'imu' has no value");
  for (const char* text : {"resonance", "resonance=37:1:roll:5"}) {
    EXPECT_EQ(problem(text), "the fault is resonance=FREQUENCY[:RATE[:AXIS]]") << text;
  }
  const std::map<std::string, std::vector<const char*>> ranges{
      {", FREQUENCY from 0.1 to 1000 Hz",
       {"resonance=", "resonance=Hz", "resonance=0", "resonance=nan", "resonance=37%"}},
      {", RATE from 0 to 1000", {"resonance=37:x", "i2c-errors=-5", "line=x"}},
      {", AXIS roll, pitch or yaw", {"resonance=37Hz:0.1:pan", "overload=3", "imbalance=30%:x"}},
      {", VOLTS from 0 to 100 V", {"low-battery=-1"}},
      {", US from 1 to 60000 us", {"slow-cycle=0", "slow-cycle=1e9"}},
      {", RATE from -100 to 100", {"drift=inf"}},
      {", SHARE from -1 to 1 (-100% to 100%)",
       {"imbalance=2", "imbalance=101%", "imbalance=-101%", "imbalance=%", "imbalance=nan%"}},
  };
  for (const auto& [range, texts] : ranges) {
    for (const char* text : texts) {
      EXPECT_THAT(problem(text), AllOf(StartsWith("the fault is "), HasSubstr(range))) << text;
    }
  }
}

TEST(GimbalFaults, AShareIsANumberOrPercent) {
  const auto imbalance = [](const char* text) {
    emulator::BoardOptions board;
    EXPECT_EQ(add_faults(text, board), "");
    return board.gimbal.imbalance;
  };
  EXPECT_DOUBLE_EQ(imbalance("imbalance=0.3")[1], 0.3);
  EXPECT_DOUBLE_EQ(imbalance("imbalance=-30%:roll")[0], -0.3);
  EXPECT_DOUBLE_EQ(imbalance("imbalance=100%:yaw")[2], 1);
}

}  // namespace
}  // namespace sbgc::serving
