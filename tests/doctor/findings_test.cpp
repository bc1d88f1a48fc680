// Tests of sbgc::doctor on emulated boards in virtual time: a healthy board has no finding, and
// each fault has one.

#include <functional>
#include <numbers>

#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/frequency_text.hpp>

#include "../emulator/device/host.hpp"
#include "polling.hpp"
#include "serving/faults.hpp"

namespace sbgc::doctor {
namespace {

using analysis::Frequency;
using analysis::UniformSamples;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Takes live data and samples of the gyroscope for some tenths of a second.
UniformSamples sampled(test::Host& host, std::uint16_t interval_ms, int tenths,
                       Measurements& result, const std::function<void(test::Host&)>& disturb) {
  UniformSamples samples(1e-3 * interval_ms);
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_custom;
  stream.interval_ms = decltype(stream.interval_ms)(interval_ms);
  stream.config.flags = msg::RealtimeDataCustomFlag::gyro_data;
  host.ask(stream);
  for (int i = 0; i < tenths; ++i) {
    if (disturb) disturb(host);
    host.send(msg::RealtimeData4Request{});
    for (const test::Packet& packet : host.listen(milliseconds(100))) {
      if (test::is<msg::RealtimeData4>(packet))
        result.add(test::message<msg::RealtimeData4>(packet));
      msg::RealtimeDataCustom data;
      if (packet.id != static_cast<std::uint8_t>(msg::RealtimeDataCustom::command)) continue;
      EXPECT_TRUE(decode(std::span(packet.body), data, {*stream.config.flags}));
      samples.add_at(data.timestamp_ms.raw(), {data.gyro_data->roll.degrees_per_second(),
                                               data.gyro_data->pitch.degrees_per_second(),
                                               data.gyro_data->yaw.degrees_per_second()});
    }
  }
  return samples;
}

/// Measures a board for some seconds, as measure() does with data streams.
Measurements measured(const emulator::BoardOptions& options, int tenths = 50,
                      const std::function<void(test::Host&)>& disturb = {}) {
  test::Host host(options);
  host.listen(milliseconds(100 * tenths));
  Measurements result;
  result.has_battery_meter = options.features.has(msg::BoardFeature::bat_monitoring);
  result.parameters = host.get<msg::ReadParams3>(
      msg::ReadParams3Request{.profile_id = msg::ReadParams3Request::active_profile});
  result.gyro = sampled(host, 4, tenths / 2, result, disturb);
  result.again = sampled(host, 5, tenths - tenths / 2, result, disturb);
  result.seconds = 0.1 * tenths;
  return result;
}

Measurements with_faults(const std::string& faults) {
  emulator::BoardOptions options;
  EXPECT_EQ(serving::add_faults(faults, options), "");
  return measured(options);
}

std::vector<std::string> ids_of(const std::vector<Finding>& findings) {
  std::vector<std::string> ids;
  for (const Finding& one : findings) {
    ids.push_back(one.id + (one.axis ? ":" + std::to_string(*one.axis) : ""));
  }
  return ids;
}

TEST(Doctor, AHealthyBoardHasNoFindingIn100Runs) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    emulator::BoardOptions options;
    options.gimbal.seed = seed;
    const Measurements healthy = measured(options);
    ASSERT_EQ(healthy.messages, 50U);
    ASSERT_GT(healthy.gyro->size(), 600U);
    ASSERT_GT(healthy.again->size(), 480U);
    ASSERT_EQ(healthy.gyro->lost_share(), 0);
    EXPECT_THAT(ids_of(findings_of(healthy)), IsEmpty()) << "seed " << seed;
  }
}

TEST(Doctor, EachFaultHasItsFindingAlone) {
  const std::vector<std::pair<std::string, std::string>> expected{
      {"low-battery", "battery"},
      {"low-bat2", "battery"},
      {"imu", "ERR_NO_SENSOR"},
      {"missed-steps", "ERR_MISS_STEPS"},
      {"calib-acc", "ERR_CALIB_ACC"},
      {"calib-poles", "ERR_CALIB_POLES"},
      {"set-power", "ERR_SET_POWER"},
      {"protection", "ERR_PROTECTION"},
      {"serial", "ERR_SERIAL"},
      {"gui-version", "ERR_GUI_VERSION"},
      {"system", "ERR_SYSTEM"},
      {"emergency-stop", "ERR_EMERGENCY_STOP"},
      {"imbalance=0.3:pitch", "balance:1"},
      {"imbalance=-0.3:roll", "balance:0"},
      {"overload=yaw", "motor-power:2"},
      {"resonance=37Hz:0.1:pitch", "vibration:1"},
      {"resonance=90Hz:2:roll", "vibration:0"},
      {"resonance=2Hz", "vibration:1"},
      {"i2c-errors", "i2c"},
      {"line", "line"},
      {"slow-cycle", "cycle-time"},
      {"drift", "attitude"},
  };
  for (const auto& [fault, id] : expected) {
    const std::vector<Finding> findings = findings_of(with_faults(fault));
    EXPECT_THAT(ids_of(findings), ElementsAre(id)) << fault;
    for (const Finding& one : findings) {
      EXPECT_FALSE(one.advice.empty()) << fault;
      EXPECT_TRUE(one.sentence.ends_with('.')) << one.sentence;
    }
  }
}

TEST(Doctor, ANoisyLine) {
  const auto damage = [](test::Host& host) {
    // A request whose body checksum is wrong.
    host.send_bytes(std::array<std::uint8_t, 6>{0x3E, 21, 1, 22, 255, 0});
  };
  EXPECT_THAT(ids_of(findings_of(measured({}, 20, damage))), ElementsAre("line"));
  Measurements healthy = measured({}, 5);
  healthy.damaged_share = 0.005;
  EXPECT_THAT(ids_of(findings_of(healthy)), ElementsAre("line"));
}

TEST(Doctor, SeveralFaultsHaveSeveralFindings) {
  EXPECT_THAT(ids_of(findings_of(with_faults("low-battery,imu,overload=roll"))),
              ElementsAre("ERR_NO_SENSOR", "battery", "motor-power:0"));
}

TEST(Doctor, NamesAResonanceWithin1Hz) {
  for (const double hertz : {2.0, 3.0, 5.0, 12.5, 37.0, 50.0, 70.0, 85.0}) {
    SCOPED_TRACE(hertz);
    const std::string fault = "resonance=" + std::to_string(hertz) + ":0.1:yaw";
    const Measurements shaking = with_faults(fault);
    const auto vibration = shaking.vibration();
    ASSERT_TRUE(vibration && !vibration->yaw.frequencies.empty());
    const Frequency& found = vibration->yaw.frequencies.front();
    EXPECT_TRUE(found.is_real);
    EXPECT_NEAR(found.peak.frequency, hertz, 1);
    EXPECT_NEAR(found.peak.amplitude, 0.1, 0.03);
    const std::vector<Finding> findings = findings_of(shaking);
    ASSERT_THAT(ids_of(findings), ElementsAre("vibration:2"));
    EXPECT_THAT(findings[0].sentence, HasSubstr(frequency_text(found)));
    EXPECT_LE(rms_of(found.peak), 1.01 * vibration->yaw.rms) << "both are in that sentence";
  }
}

TEST(Doctor, NoAliasIsNamedAsAFrequency) {
  // At 250 per second, they appear at 37 Hz, 30 Hz and 7 Hz.
  for (const double hertz : {213.0, 280.0, 243.0}) {
    SCOPED_TRACE(hertz);
    const std::string fault = "resonance=" + std::to_string(hertz) + ":1:pitch";
    const std::vector<Finding> findings = findings_of(with_faults(fault));
    ASSERT_THAT(ids_of(findings), ElementsAre("vibration:1"));
    EXPECT_THAT(findings[0].sentence, HasSubstr(" (an alias at "));
    EXPECT_THAT(findings[0].sentence,
                testing::ContainsRegex(std::to_string(static_cast<int>(hertz)) + "\\.[0-9]|" +
                                       std::to_string(static_cast<int>(hertz) - 1) + "\\.[5-9]"));
  }
}

TEST(Doctor, WithoutASecondRateEachFrequencyMayBeAnAlias) {
  Measurements shaking = with_faults("resonance=37Hz:1:pitch");
  shaking.again.reset();
  const std::vector<Finding> findings = findings_of(shaking);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].sentence, testing::ContainsRegex("37\\.. Hz \\(or an alias of 21[23]"));
}

TEST(Doctor, EachThresholdOfTheBattery) {
  Measurements board = measured({}, 2);
  const auto hundredths = [](double volts) {
    return msg::VoltageThreshold(static_cast<std::int16_t>(100 * volts));
  };
  const auto judge = [&](double volts, double alarm, double motors) {
    board.lowest_battery = volts;
    board.parameters->bat_threshold_alarm = hundredths(alarm);
    board.parameters->bat_threshold_motors = hundredths(motors);
    std::string text;
    for (const Finding& one : findings_of(board)) text += one.sentence;
    return text;
  };
  EXPECT_EQ(judge(13, 12, 11), "");
  EXPECT_THAT(judge(11.5, 12, 11), HasSubstr("below the alarm threshold of 12.00 V"));
  EXPECT_THAT(judge(10.5, 12, 11),
              HasSubstr("below the threshold of 11.00 V at which the motors stop"));
  EXPECT_THAT(judge(10.5, -12, 11), HasSubstr("11.00 V at which the motors stop"));
  EXPECT_EQ(judge(10.5, -12, -11), "") << "a negative one is none";
  EXPECT_THAT(judge(0, -12, -11), HasSubstr("measures no battery voltage"));
  board.has_battery_meter = false;
  EXPECT_EQ(judge(0, 12, 11), "");
}

TEST(Doctor, WhatTheBoardSaysOfItselfIsJudged) {
  Measurements board = measured({}, 2);
  board.firmware = "0.00";
  board.firmware_problem = "unknown; the sensors are often unplugged";
  board.calibration = msg::CalibInfo{};
  const std::vector<Finding> findings = findings_of(board);
  ASSERT_THAT(ids_of(findings), ElementsAre("firmware", "calibration"));
  EXPECT_THAT(findings[0].sentence, HasSubstr("firmware 0.00: unknown; the sensors are often"));
  EXPECT_THAT(findings[1].sentence, HasSubstr("in 0 of 6 positions"));
}

/// A board in virtual time, that answers within some time.
struct SlowBoard {
  Instant now{};
  double frequency = 0;
  std::function<double(int)> answer_time{};  ///< of the request with this number
  int requests = 0;

  Task<Result<Axes<double>>> answer() {
    const double time = answer_time(requests++);
    const Instant at = now + microseconds(std::llround(1e6 * time));
    if (const auto waited = co_await tasks::wait_until(at); !waited) co_return waited.error();
    const double value =
        std::sin(2 * std::numbers::pi * frequency * 1e-6 * static_cast<double>(now.us));
    co_return Axes<double>{value, 0, 0};
  }
  Ask ask() {
    return [this] { return answer(); };
  }
  UniformSamples run(Task<Result<UniformSamples>> task) {
    TaskMachine& machine = task.begin({});
    for (TaskStep step = machine.step(now); step.kind != TaskStep::Kind::done;
         step = machine.step(now)) {
      now = later(now, step.until);
    }
    return *std::move(task).result();
  }
};

TEST(Polling, TakesTheRateThatTheBoardKeepsUpWith) {
  SlowBoard board{.answer_time = [](int) { return 0.0155; }};
  const UniformSamples samples = board.run(poll_often(board.ask(), seconds(2)));
  EXPECT_DOUBLE_EQ(samples.rate(), 50) << "a quarter more than an answer takes";
  EXPECT_EQ(samples.lost_share(), 0);
  EXPECT_EQ(samples.size(), 100U);
}

TEST(Polling, BeginsAgainAtHalfOfTheRate) {
  // Later, each tenth answer takes longer than the interval.
  SlowBoard board{
      .answer_time = [](int number) { return number > 40 && number % 10 == 0 ? 0.030 : 0.0075; }};
  const UniformSamples samples = board.run(poll_often(board.ask(), seconds(2)));
  EXPECT_DOUBLE_EQ(samples.rate(), 25) << "after 100 and 50";
  EXPECT_TRUE(samples.is_usable());
  EXPECT_LT(board.now, Instant{} + seconds(3)) << "it did not wait for the end of what failed";
}

TEST(Polling, GivesUpOnABoardThatNeverKeepsUp) {
  SlowBoard board{
      .answer_time = [](int number) { return number > 20 && number % 3 == 0 ? 0.4 : 0.001; }};
  EXPECT_FALSE(board.run(poll_often(board.ask(), seconds(2))).is_usable());
}

TEST(Polling, AnAliasOfSlowPollsIsKnownAsOne) {
  const auto seen = [](double frequency) {
    SlowBoard board{.frequency = frequency, .answer_time = [](int) { return 0.001; }};
    Measurements measured;
    measured.gyro = board.run(poll_at(board.ask(), microseconds(22'222), milliseconds(2500)));
    measured.again = board.run(poll_at(board.ask(), microseconds(27'778), milliseconds(2500)));
    return measured.vibration()->roll.frequencies.front();
  };
  const Frequency fast = seen(37);  // which appears at 8 Hz
  EXPECT_NEAR(fast.peak.frequency, 8, 0.5);
  EXPECT_FALSE(fast.is_real);
  EXPECT_THAT(fast.others, testing::Contains(testing::DoubleNear(37, 0.5)));
  const Frequency slow = seen(8);
  EXPECT_TRUE(slow.is_real);
  EXPECT_NEAR(slow.peak.frequency, 8, 0.5);
}

TEST(Doctor, LostSamplesAreRefusedAbove1Percent) {
  Measurements shaking = with_faults("resonance=37Hz:1:pitch");
  const UniformSamples all = *shaking.gyro;
  const auto without = [&](std::size_t each) {
    UniformSamples some(1 / all.rate());
    const std::array values{all.axis(0), all.axis(1), all.axis(2)};
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      if (i % each != each - 1) {
        some.add(static_cast<std::int64_t>(i), {values[0][i], values[1][i], values[2][i]});
      }
    }
    return some;
  };
  shaking.again.reset();
  shaking.gyro = without(120);
  EXPECT_THAT(ids_of(findings_of(shaking)), ElementsAre("vibration:1"));
  shaking.gyro = without(80);
  EXPECT_THAT(findings_of(shaking), IsEmpty());
  EXPECT_FALSE(shaking.vibration());
}

TEST(Doctor, ThresholdsHaveNamesAndMeanings) {
  std::set<std::string> names;
  for (const Threshold& one : thresholds()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_STRNE(one.meaning, "");
    EXPECT_EQ(threshold(one.limit), one.value);
  }
}

}  // namespace
}  // namespace sbgc::doctor
