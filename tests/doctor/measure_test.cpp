// Tests of measuring an emulated board in virtual time; of samples with equal distances, and of
// their vibration.

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/analysis/frequencies.hpp>
#include <sbgc/analysis/uniform_samples.hpp>
#include <sbgc/analysis/vibration.hpp>
#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/frequency_text.hpp>
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

namespace sbgc::analysis {
namespace {

using doctor::frequency_text;

Axes<double> value(double one) { return {one, 2 * one, 3 * one}; }

TEST(UniformSamples, FewLostOnesAreInterpolated) {
  UniformSamples samples(0.004);
  for (int i = 0; i < 400; ++i) {
    if (i != 7 && i != 8 && i != 100) samples.add(i + 5, value(i));
  }
  EXPECT_EQ(samples.size(), 397U);
  EXPECT_DOUBLE_EQ(samples.lost_share(), 3.0 / 400);
  ASSERT_TRUE(samples.is_usable());
  const std::vector<double> pitch = samples.axis(1);
  ASSERT_EQ(pitch.size(), 400U);
  for (std::size_t i = 0; i < pitch.size(); ++i) {
    EXPECT_NEAR(pitch[i], 2.0 * static_cast<double>(i), 1e-9);
  }
}

TEST(UniformSamples, ManyLostOnesAreRefused) {
  UniformSamples samples(0.004);
  for (int i = 0; i < 100; ++i) {
    if (i != 50) samples.add(i, value(i));
  }
  EXPECT_TRUE(samples.is_usable()) << "exactly 1 %";
  samples.add(101, value(0));
  EXPECT_FALSE(samples.is_usable());
}

TEST(UniformSamples, ASampleThatComesTwiceCountsOnce) {
  UniformSamples samples(0.01);
  samples.add(3, value(1));
  samples.add(3, value(9));
  samples.add(2, value(9));
  samples.add(4, value(2));
  EXPECT_EQ(samples.axis(0), (std::vector<double>{1, 2}));
}

TEST(UniformSamples, AClockThatWraps) {
  UniformSamples samples(0.004);
  std::uint32_t clock = 65000;
  for (int i = 0; i < 1000; ++i, clock += 4) {
    // Each sample is up to 1 ms from its time.
    const std::uint32_t jitter = static_cast<std::uint32_t>(i % 3) - 1;
    if (i != 200) samples.add_at(static_cast<std::uint16_t>(clock + jitter), value(i));
  }
  EXPECT_EQ(samples.size(), 999U);
  EXPECT_DOUBLE_EQ(samples.lost_share(), 0.001);
  EXPECT_NEAR(samples.axis(0)[200], 200, 1e-9);
}

TEST(UniformSamples, WhatIsMissingNeedsNoMemory) {
  UniformSamples samples(0.004);
  for (std::int64_t i = 0; i < 1000; ++i) samples.add(i << 50, value(1));
  EXPECT_EQ(samples.size(), 1000U);
  EXPECT_NEAR(samples.lost_share(), 1, 1e-12);
  EXPECT_THAT(samples.axis(0), testing::IsEmpty());
}

std::vector<double> sine(double frequency, double amplitude, double rate, std::size_t count) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    samples[i] =
        amplitude * std::sin(2 * std::numbers::pi * frequency * static_cast<double>(i) / rate) + 4;
  }
  return samples;
}

TEST(Vibration, FrequencyAndAmplitudeOfASine) {
  for (const double frequency : {1.9, 2.5, 5.0, 17.3, 37.0, 61.49, 99.9}) {
    const Vibration found = vibration_of(sine(frequency, 0.4, 250, 1250), 250);
    ASSERT_FALSE(found.peaks.empty()) << frequency;
    EXPECT_NEAR(found.peaks.front().frequency, frequency, 0.3);
    EXPECT_NEAR(found.peaks.front().amplitude, 0.4, 0.02) << frequency;
    EXPECT_NEAR(found.rms, 0.4 / std::sqrt(2), 0.01) << frequency << ": without the mean";
  }
}

TEST(Vibration, NothingAbove45PercentOfTheRateOrBelow1Hz) {
  for (const double frequency : {0.3, 0.5, 118.0, 124.0}) {
    const Vibration found = vibration_of(sine(frequency, 1, 250, 2500), 250);
    EXPECT_LT(found.rms, 0.05) << frequency;
    for (const Peak& peak : found.peaks) {
      EXPECT_LE(peak.frequency, 112.5 + 0.5);
      EXPECT_LT(peak.amplitude, 0.05) << frequency;
    }
  }
}

TEST(Vibration, TheStrongestFirst) {
  std::vector<double> samples = sine(20, 0.1, 250, 1250);
  const std::vector<double> other = sine(60, 0.3, 250, 1250);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += other[i];
  const Vibration found = vibration_of(samples, 250);
  ASSERT_GE(found.peaks.size(), 2U);
  EXPECT_NEAR(found.peaks[0].frequency, 60, 0.3);
  EXPECT_NEAR(found.peaks[1].frequency, 20, 0.3);
}

TEST(Vibration, TooFewSamplesHaveNone) {
  for (const std::size_t count : {0U, 1U, 2U, 13U}) {
    EXPECT_FALSE(vibration_of(sine(5, 1, 250, count), 250).is_known()) << count;
  }
  EXPECT_EQ(vibration_of(std::vector<double>(1000, 7.0), 250).rms, 0) << "at rest";
}

TEST(Frequencies, WhereAliasesAppear) {
  EXPECT_DOUBLE_EQ(alias_of(37, 250), 37);
  EXPECT_DOUBLE_EQ(alias_of(213, 250), 37);
  EXPECT_DOUBLE_EQ(alias_of(287, 250), 37);
  EXPECT_DOUBLE_EQ(alias_of(213, 200), 13);
  EXPECT_DOUBLE_EQ(alias_of(250, 250), 0);
}

/// Samples at 250 and at 200 per second.
std::vector<Frequency> seen_twice(double frequency, double amplitude_later = 1) {
  return frequencies_of(vibration_of(sine(frequency, 1, 250, 625), 250),
                        vibration_of(sine(frequency, amplitude_later, 200, 500), 200));
}

TEST(Frequencies, TwoRatesTellAliases) {
  for (const double frequency : {2.5, 10.0, 37.0, 60.0, 88.0}) {
    const Frequency found = seen_twice(frequency).front();
    EXPECT_TRUE(found.is_real) << frequency;
    EXPECT_NEAR(found.peak.frequency, frequency, 0.5);
  }
  EXPECT_EQ(frequency_text(seen_twice(37).front()), "37.0 Hz");
  for (const double frequency : {163.0, 213.0, 287.0, 333.0}) {
    const Frequency found = seen_twice(frequency).front();
    EXPECT_FALSE(found.is_real) << frequency;
    ASSERT_FALSE(found.others.empty());
    EXPECT_NEAR(found.others.front(), frequency, 0.5) << frequency_text(found);
  }
  EXPECT_EQ(frequency_text(seen_twice(213).front()), "213.0 Hz (an alias at 37.0 Hz)");
  const Frequency both = seen_twice(50).front();
  EXPECT_EQ(frequency_text(both), "50.0 Hz (or an alias of 200.0 or 300.0 Hz)")
      << "which the second rate does not show";
  EXPECT_TRUE(seen_twice(100).front().is_real) << "nor this";
}

TEST(Frequencies, WhatOnlyOneRateShowsIsNone) {
  for (const Frequency& found : seen_twice(37, 0.01)) EXPECT_LT(found.peak.amplitude, 0.1);
}

TEST(Frequencies, OneRateLeavesAllOpen) {
  const Frequency found = frequencies_of(vibration_of(sine(37, 1, 250, 1250), 250)).front();
  EXPECT_TRUE(found.is_real);
  EXPECT_EQ(frequency_text(found), "37.0 Hz (or an alias of 213.0 or 287.0 Hz)");
}

}  // namespace
}  // namespace sbgc::analysis
