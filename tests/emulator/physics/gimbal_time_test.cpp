// Tests of time: the same seed and commands give the same samples, regardless of the sampling rate.

#include <bit>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

#include "gimbal_rig.hpp"
#include "physics/disturbance_motion.hpp"

namespace sbgc::emulator::test {
namespace {

/// All numbers of a sample, exactly.
using Numbers = std::array<double, sizeof(Sample) / sizeof(double)>;
static_assert(std::is_trivially_copyable_v<Sample>);

Numbers numbers_of(const Sample& sample) { return std::bit_cast<Numbers>(sample); }

bool is_finite(const Sample& sample) {
  return std::ranges::all_of(numbers_of(sample), [](double value) { return std::isfinite(value); });
}

Gimbal::Options lively(std::uint32_t seed = 7) {
  Gimbal::Options options;
  options.seed = seed;
  options.frame.kind = Disturbance::Kind::handheld;
  return options;
}

/// Runs two minutes with commands at odd times, sampled every `every` us; returns the samples of
/// whole minutes.
std::vector<Numbers> story(const Gimbal::Options& options, std::int64_t every) {
  Gimbal gimbal(options, Instant{-123});
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  std::vector<Numbers> seen;
  std::int64_t next_command = 0;
  int number = 0;
  for (std::int64_t t = 0; t <= 120'000'000; t += every) {
    while (next_command <= t && next_command < 120'000'000) {
      const Instant now{next_command};
      switch (number++) {
        case 0: gimbal.tune(tuning, now); break;
        case 1: gimbal.set_motors(true, now); break;
        case 2: gimbal.command(pitch, {AxisMode::angle, 20, -30, 0}, now); break;
        case 3: gimbal.command(yaw, {AxisMode::speed, 17, 0, 0}, now); break;
        case 4: gimbal.push(roll, 9, now); break;
        case 5: gimbal.set_remote(yaw, 0.3, now); break;
        case 6: gimbal.command(yaw, {}, now); break;
        case 7: gimbal.jam(pitch, true, now); break;
        case 8: gimbal.correct({{}, Vector{0.1, 1, 0}, false, true}, now); break;
        case 9: gimbal.correct_gyro(false, {0.01, 0, 0}, 0.02, now); break;
        default: break;
      }
      next_command += 7'654'321;
    }
    const Sample sample = gimbal.sample({t});
    if (t % 60'000'000 == 0) seen.push_back(numbers_of(sample));
  }
  return seen;
}

TEST(Time, LookingOftenChangesNothing) {
  const auto rarely = story(lively(), 60'000'000);
  EXPECT_EQ(rarely, story(lively(), 1000));
  EXPECT_EQ(rarely, story(lively(), 15'000));
}

TEST(Time, AllKindsOfFramesLookTheSameHoweverOftenTheyAreLookedAt) {
  for (const auto kind : {Disturbance::Kind::rest, Disturbance::Kind::drone,
                          Disturbance::Kind::vehicle, Disturbance::Kind::recorded}) {
    Gimbal::Options options = lively();
    options.frame.kind = kind;
    options.frame.recording = {
        {ms(0), {1, 2, 3}}, {ms(333), {4, -2, 170}}, {ms(900), {0, 0, -170}}};
    EXPECT_EQ(story(options, 60'000'000), story(options, 5000));
  }
}

TEST(Time, SameSeedSameSamplesOtherSeedOthers) {
  EXPECT_EQ(story(lively(), 60'000), story(lively(), 60'000));
  EXPECT_NE(story(lively(), 60'000), story(lively(8), 60'000));
}

TEST(Time, NoiseIsThatOfTheTimeNotOfTheCall) {
  Gimbal gimbal = ready(lively());
  const Sample first = gimbal.sample(ms(1001));
  EXPECT_EQ(gimbal.sample(ms(1001)).gyro, first.gyro);
  EXPECT_NE(gimbal.sample(ms(1002)).gyro, first.gyro);
}

TEST(Time, NothingJumpsFromStepToStep) {
  Gimbal gimbal = ready(moving(Disturbance::Kind::vehicle));
  gimbal.command(yaw, {AxisMode::angle, 30, 20, 0}, ms(0));
  Sample before = gimbal.sample({0});
  for (std::int64_t us = 100; us < 3'000'000; us += 100) {
    const Sample sample = gimbal.sample({us});
    ASSERT_NEAR(sample.angles.yaw, before.angles.yaw, 0.006) << us;
    ASSERT_NEAR(sample.targets.yaw, before.targets.yaw, 0.0031) << us;
    ASSERT_NEAR(sample.frame.yaw, before.frame.yaw, 0.004) << us;
    before = sample;
  }
}

/// Returns the yaw of a camera that is not sampled for `gap`, while its frame turns aside and back
/// at time `at`. If the turn is simulated, the camera lags by the dead band, 5 degrees.
double left_by_a_turn(std::int64_t at, std::int64_t gap) {
  Gimbal::Options options = quiet();
  options.frame.kind = Disturbance::Kind::recorded;
  options.frame.recording = {{ms(0), {}},
                             {ms(at), {}},
                             {ms(at + 1500), {0, 0, 60}},
                             {ms(at + 3000), {}},
                             {ms(100'000'000), {}}};
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  tuning.axes.yaw.follow_deadband = 5;
  return ready(options, tuning).sample(ms(gap)).targets.yaw;
}

TEST(Time, OfALongGapOnlyTheEndsAreSimulated) {
  constexpr std::int64_t minute = 60'000;
  constexpr std::int64_t hour = 60 * minute;
  EXPECT_NEAR(left_by_a_turn(20'000, minute), 5, 0.1) << "it is not long";
  for (const std::int64_t gap : {minute + 4, hour, 20 * hour}) {
    EXPECT_NEAR(left_by_a_turn(6000, gap), 5, 0.1) << gap;
    EXPECT_EQ(left_by_a_turn(11'000, gap), 0) << gap;
    EXPECT_EQ(left_by_a_turn(gap - 14'000, gap), 0) << gap;
    EXPECT_NEAR(left_by_a_turn(gap - 9000, gap), 5, 0.1) << gap;
  }
}

TEST(Time, YearsPassAtOnce) {
  for (const auto kind :
       {Disturbance::Kind::rest, Disturbance::Kind::handheld, Disturbance::Kind::recorded}) {
    Gimbal::Options options = lively();
    options.frame.kind = kind;
    options.frame.recording = {{ms(0), {}},
                               {ms(500), {0, 0, 100}},
                               {ms(1000), {0, 0, 200}},
                               {ms(1500), {0, 0, 300}},
                               {ms(2000), {0, 0, 360}}};
    Gimbal gimbal = ready(options);
    gimbal.command(pitch, {AxisMode::angle, 0, -30, 0}, ms(0));
    gimbal.command(yaw, {AxisMode::speed, 10, 0, 0}, ms(0));
    constexpr std::int64_t year = 365LL * 24 * 3600 * 1000;
    const Sample sample = gimbal.sample(ms(5 * year));
    EXPECT_TRUE(is_finite(sample));
    EXPECT_EQ(sample.targets.pitch, -30);
    EXPECT_NEAR(sample.angles.pitch, -30, 0.2);
    EXPECT_NEAR(sample.targets.yaw / (10.0 * 5 * year / 1000), 1, 1e-6);
    EXPECT_LT(sample.battery, 13);
    EXPECT_NEAR(sample.temperature, 36, 0.01);
    EXPECT_TRUE(is_finite(gimbal.sample(Instant::never)));
  }
  Gimbal early(lively(), Instant{std::numeric_limits<std::int64_t>::min()});
  EXPECT_TRUE(is_finite(early.sample(Instant::never)));
}

TEST(Time, ASlowMoveGoesOnDuringALongGap) {
  Gimbal gimbal = ready();
  gimbal.command(yaw, {AxisMode::angle, 0.001, 30, 0}, ms(0));
  EXPECT_NEAR(gimbal.sample(ms(4LL * 3600 * 1000)).targets.yaw, 14.4, 0.01);
  EXPECT_EQ(gimbal.sample(ms(9LL * 3600 * 1000)).targets.yaw, 30);
}

TEST(Time, WhoFollowsHasKeptUpAfterALongGap) {
  Gimbal::Options options = quiet();
  options.frame.kind = Disturbance::Kind::recorded;
  options.frame.recording = {
      {ms(0), {}}, {ms(20'000), {0, 0, 120}}, {ms(40'000), {0, 0, 240}}, {ms(60'000), {}}};
  Tuning tuning;
  tuning.axes.yaw.follows = true;
  const Sample sample = ready(options, tuning).sample(ms(3'600'000));
  EXPECT_NEAR(sample.frame.yaw, 60 * 360, 1);
  EXPECT_NEAR(sample.targets.yaw, sample.frame.yaw, 5);
}

TEST(Time, BeforeTheStartIsTheStart) {
  Gimbal gimbal(quiet(), ms(1000));
  EXPECT_EQ(numbers_of(gimbal.sample(ms(0))), numbers_of(gimbal.sample(ms(1000))));
}

TEST(AllNumbers, StayFiniteWhateverIsAskedFor) {
  const double huge = std::numeric_limits<double>::max();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  std::uint64_t n = 0;
  for (const double value : {huge, -huge, none, infinite, -infinite, 1e-308, -1e-320}) {
    Gimbal::Options options;
    options.noise = value;
    options.battery = value;
    options.capacity = value;
    options.ambient = value;
    options.imbalance = {value, value, value};
    options.frame = {Disturbance::Kind::drone, value, {}};
    Gimbal gimbal(options, ms(0));
    for (std::int64_t t = 0; t < 3000; t += 10, ++n) {
      Tuning tuning;
      AxisTuning& axis = tuning.axes[n % 3];
      double* const members[] = {&axis.p,
                                 &axis.i,
                                 &axis.d,
                                 &axis.power,
                                 &axis.speed,
                                 &axis.follow_speed,
                                 &axis.remote_min,
                                 &axis.remote_max,
                                 &axis.joint_min,
                                 &axis.joint_max,
                                 &axis.start_angle,
                                 &axis.acceleration,
                                 &axis.follow_deadband,
                                 &axis.remote_speed};
      *members[n % std::size(members)] = value;
      *members[n * 7 % std::size(members)] = value;
      axis.follows = n % 5 == 0;
      axis.remote_is_speed = n % 7 < 3;
      tuning.rotation_order = {static_cast<std::uint8_t>(n % 4), 1, 2};
      gimbal.tune(tuning, ms(t));
      gimbal.set_motors(n % 50 != 0, ms(t));
      const auto mode = static_cast<AxisMode>(n % 6);
      gimbal.command((n / 6) % 3, {mode, n % 2 == 0 ? value : 10, n % 4 < 2 ? value : 10, value},
                     ms(t));
      if (n % 3 == 0) gimbal.set_remote(n % 3, value, ms(t));
      if (n % 5 == 0) gimbal.set_followed(n % 3, value, ms(t));
      if (n % 40 == 0) gimbal.push(n % 3, value, ms(t));
      if (n % 90 == 0) gimbal.place({value, 0, value}, ms(t));
      if (n % 30 == 0) gimbal.correct_gyro(n % 2 == 0, {value, 0, value}, value, ms(t));
      gimbal.correct({Vector{value, 1, 0}, Vector{0, value, value}, n % 2 == 0, n % 3 == 0}, ms(t));
      ASSERT_TRUE(is_finite(gimbal.sample(ms(t)))) << value << ' ' << n;
      ASSERT_TRUE(is_finite(gimbal.sample(ms(t + 3)))) << value << ' ' << n;
    }
    gimbal.set_battery(value, ms(3000));
    ASSERT_TRUE(is_finite(gimbal.sample(ms(1LL << 44))));
  }
}

TEST(AllNumbers, AnyTuningHoldsStill) {
  for (const double p : {0.0, 0.1, 10.0, 255.0, 1500.0}) {
    for (const double i : {0.0, 0.1, 2.55, 15.0}) {
      for (const double d : {0.0, 1.0, 20.0, 255.0, 1500.0}) {
        for (const double power : {1.0, 100.0, 255.0}) {
          Tuning tuning;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            tuning.axes[axis].p = p;
            tuning.axes[axis].i = i;
            tuning.axes[axis].d = d;
            tuning.axes[axis].power = power;
          }
          Gimbal::Options options = quiet();
          options.imbalance = {};
          Gimbal gimbal = ready(options, tuning);
          gimbal.push(pitch, 1, ms(0));
          EXPECT_LT(worst_error(gimbal, 20'000, 21'000), 1.1)
              << p << ' ' << i << ' ' << d << ' ' << power;
        }
      }
    }
  }
}

TEST(Frame, SyntheticMotionIsSmoothAndItsSpeedIsItsDerivative) {
  for (const auto kind :
       {Disturbance::Kind::handheld, Disturbance::Kind::drone, Disturbance::Kind::vehicle}) {
    FrameMotion motion({kind, 1, {}}, 3);
    for (int step = 0; step < 3000; ++step) {
      const FrameMotion::State a = motion.ahead(3000);
      const FrameMotion::State b = motion.ahead(3990);
      motion.step();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(b.angles[axis] - a.angles[axis], 0.000495 * (a.speeds[axis] + b.speeds[axis]),
                    3e-5);
        ASSERT_NEAR(motion.now().angles[axis], b.angles[axis] + 1e-5 * b.speeds[axis], 1e-6);
        ASSERT_NEAR(motion.now().speeds[axis], b.speeds[axis], 0.1);
      }
    }
  }
}

TEST(Frame, JumpsAreWhereStepsWouldBe) {
  FrameMotion stepping({Disturbance::Kind::vehicle, 1, {}}, 3);
  for (int i = 0; i < 5000; ++i) stepping.step();
  FrameMotion jumping({Disturbance::Kind::vehicle, 1, {}}, 3);
  jumping.jump(5000);
  EXPECT_EQ(jumping.now().angles, stepping.now().angles);
}

TEST(Frame, StrengthIsAFactor) {
  FrameMotion one({Disturbance::Kind::drone, 1, {}}, 3);
  FrameMotion two({Disturbance::Kind::drone, 2, {}}, 3);
  EXPECT_DOUBLE_EQ(two.now().angles.roll, 2 * one.now().angles.roll);
}

TEST(Frame, RecordingsArePlayedAgainAndAgain) {
  const std::vector<FrameAngles> recording{
      {ms(0), {0, 1, 0}}, {ms(100), {10, 1, 0}}, {ms(300), {20, 1, 0}}, {ms(400), {-5, 1, 0}}};
  FrameMotion motion({Disturbance::Kind::recorded, 1, recording}, 1);
  const auto at = [&](std::int64_t t) {
    motion.jump(t / 4);
    return motion.now().angles;
  };
  EXPECT_NEAR(at(100).roll, 10, 1e-9);
  EXPECT_NEAR(at(300).roll, 20, 1e-9);
  EXPECT_NEAR(at(400).roll, -5, 1e-9);
  EXPECT_NEAR(at(1400).roll, 0, 1e-9);  // one second for the way back
  EXPECT_NEAR(at(1500).roll, 10, 1e-9);
  for (std::int64_t t = 0; t < 3000; t += 4) {
    ASSERT_LE(at(t).roll, 20 + 1e-9);
    ASSERT_GE(at(t).roll, -5 - 1e-9);
    ASSERT_NEAR(at(t).pitch, 1, 1e-12);
  }
}

TEST(Frame, RecordedTurnsAddUp) {
  // A full turn in four steps, across the wrap of the angles; it ends where it began.
  const std::vector<FrameAngles> recording{{ms(0), {}},
                                           {ms(1000), {0, 0, 90}},
                                           {ms(2000), {0, 0, 180}},
                                           {ms(3000), {0, 0, -90}},
                                           {ms(4000), {0, 0, 0}}};
  FrameMotion motion({Disturbance::Kind::recorded, 1, recording}, 1);
  motion.jump(10'250);  // 41 s
  EXPECT_NEAR(motion.now().angles.yaw, 3600 + 90, 1e-6);
}

TEST(Frame, BadRecordingsAreRest) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<FrameAngles>& recording : {std::vector<FrameAngles>{},
                                                    {{ms(0), {none, 0, 0}}},
                                                    {{ms(-5), {1, 0, 0}}},
                                                    {{Instant::never, {1, 0, 0}}}}) {
    FrameMotion motion({Disturbance::Kind::recorded, 1, recording}, 1);
    motion.step();
    EXPECT_EQ(motion.now().angles, (Axes<double>{}));
  }
  FrameMotion backwards({Disturbance::Kind::recorded, 1, {{ms(10), {1, 0, 0}}, {ms(5), {9, 0, 0}}}},
                        1);
  backwards.jump(77);
  EXPECT_EQ(backwards.now().angles.roll, 1);
}

}  // namespace
}  // namespace sbgc::emulator::test
