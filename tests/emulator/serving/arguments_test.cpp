// Tests of the arguments of `sbgc emulate`, of its faults, and of motion files.

#include "serving/arguments.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

#include <sbgc/text.hpp>

#include "host.hpp"
#include "serving/faults.hpp"
#include "serving/motion_file.hpp"

namespace sbgc::serving {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Arguments, Listen) {
  const hosts::ListenAddress port = parse_listen("5000");
  EXPECT_EQ(port.host, "127.0.0.1");
  EXPECT_EQ(port.port, 5000);
  EXPECT_EQ(parse_listen("0").port, 0);
  EXPECT_EQ(parse_listen("0.0.0.0:65535").host, "0.0.0.0");
  EXPECT_EQ(parse_listen("[::1]:1").host, "::1");
  for (const char* text : {"", "65536", "-1", "x", "::1:5", ":5", "[]:5", "a:", "1.5", " 5",
                           "gimbal.example:5", "[127.0.0.1.1]:5"}) {
    EXPECT_THROW(parse_listen(text), std::invalid_argument) << text;
  }
}

TEST(Arguments, Shares) {
  EXPECT_DOUBLE_EQ(parse_share("0.01"), 0.01);
  EXPECT_DOUBLE_EQ(parse_share("1%"), 0.01);
  EXPECT_DOUBLE_EQ(parse_share("1e-5"), 1e-5);
  EXPECT_DOUBLE_EQ(parse_share("100%"), 1);
  EXPECT_DOUBLE_EQ(parse_share("0"), 0);
  for (const char* text : {"", "1.01", "101%", "-0.1", "-0", "nan", "inf", "%", "1 %"}) {
    EXPECT_THROW(parse_share(text), std::invalid_argument) << text;
  }
}

TEST(Arguments, Delay) {
  EXPECT_EQ(parse_delay("0.1").delay, milliseconds(20));
  EXPECT_EQ(parse_delay("0.1:2.5").delay, microseconds(2500));
  EXPECT_DOUBLE_EQ(parse_delay("5%:1").share, 0.05);
  for (const char* text : {"", "0.1:", ":5", "2:5", "0.1:-5", "0.1:5:5"}) {
    EXPECT_THROW(parse_delay(text), std::invalid_argument) << text;
  }
}

TEST(Arguments, Times) {
  EXPECT_EQ(parse_seconds("0.0015"), microseconds(1500));
  EXPECT_EQ(parse_silence("1:0.5").from, seconds(1));
  EXPECT_EQ(parse_silence("1:0.5").length, milliseconds(500));
  for (const char* text : {"", "-1", "1e7", "nan", "1s"}) {
    EXPECT_THROW(parse_seconds(text), std::invalid_argument) << text;
    EXPECT_THROW(parse_silence(text), std::invalid_argument) << text;
  }
  EXPECT_EQ(parse_interval("0.001"), milliseconds(1));
  for (const char* text : {"", "-1", "0", "0.0009", "1e-7", "1e7", "nan"}) {
    EXPECT_THROW(parse_interval(text), std::invalid_argument) << text;
  }
  EXPECT_THROW(parse_silence("1"), std::invalid_argument);
  EXPECT_THROW(parse_silence("1:2:3"), std::invalid_argument);
}

TEST(Arguments, Versions) {
  EXPECT_EQ(problem_of(msg::FirmwareVersion(2745)), "") << "the newest emulated version";
  for (const int later : {2746, 2750, 3000, 9990}) {
    const msg::FirmwareVersion version(static_cast<std::uint16_t>(later));
    EXPECT_THAT(problem_of(version), StartsWith("firmware " + to_string(version) +
                                                " is not emulated, only up to 2.74.5:"));
  }
  EXPECT_EQ(parse_board("3.2"), msg::BoardVersion(32));
  for (const char* text : {"", "3", "3.", "3.10", "30.0", "3.0b1"}) {
    EXPECT_THROW(parse_board(text), std::invalid_argument) << text;
  }
}

TEST(Arguments, AFirmwareHasItsUsualBoard) {
  EXPECT_EQ(usual_board(msg::FirmwareVersion(2430)), msg::BoardVersion(30));
  EXPECT_EQ(usual_board(msg::FirmwareVersion(2686)), msg::BoardVersion(30));
  EXPECT_EQ(usual_board(msg::FirmwareVersion(2687)), msg::BoardVersion(36));
  EXPECT_EQ(usual_board(msg::FirmwareVersion(2740)), msg::BoardVersion(36));
}

std::vector<emulator::FrameAngles> motion(const std::string& text) {
  std::istringstream stream(text);
  return read_motion(stream, "m.csv");
}

TEST(Motion, Lines) {
  const auto angles = motion("time,roll,pitch,yaw\r\n# why\n\n5,1,2,3\n 5.02 , -1 , 2.5 ,1e1\r\n");
  ASSERT_EQ(angles.size(), 2U);
  EXPECT_EQ(angles[0].at, Instant{});
  EXPECT_EQ(angles[1].at, Instant{} + milliseconds(20));
  EXPECT_DOUBLE_EQ(angles[1].angles.roll, -1);
  EXPECT_DOUBLE_EQ(angles[1].angles.pitch, 2.5);
  EXPECT_DOUBLE_EQ(angles[1].angles.yaw, 10);
}

void expect_problem(const std::string& text, const std::string& place, const std::string& what) {
  try {
    motion(text);
    FAIL() << "taken: " << text;
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), StartsWith(place));
    EXPECT_THAT(error.what(), HasSubstr(what));
  }
}

TEST(Motion, ProblemsHaveALineNumber) {
  expect_problem("0,1,2,3\n1,2,3\n", "m.csv:2:", "four numbers");
  expect_problem("0,1,2,3\n1,2,3,4,5\n", "m.csv:2:", "four numbers");
  expect_problem("# a\n0,1,x,3\n", "m.csv:2:", "'x' is not a number");
  expect_problem("0,1,2,nan\n", "m.csv:1:", "'nan' is not a number");
  expect_problem("0,1,2,\n", "m.csv:1:", "'' is not a number");
  expect_problem("0,1,2,1e9\n", "m.csv:1:", "too large");
  expect_problem("0,1,2,3\n\n0,1,2,3\n", "m.csv:3:", "later");
  expect_problem("0,1,2,3\n", "m.csv:", "two lines");
  expect_problem("", "m.csv:", "two lines");
  expect_problem("time,roll,pitch,yaw\ntime,roll,pitch,yaw\n", "m.csv:2:", "'time'");
}

using testing::AllOf;

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
