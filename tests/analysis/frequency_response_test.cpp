// Frequency responses of systems that are known.
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/analysis/frequency_response.hpp>

namespace sbgc::analysis {
namespace {

using std::numbers::pi;
constexpr double rate = 1250;

/// A system with two poles and a delay of `delay` samples.
struct System {
  double resonance = 50, damping = 0.2, gain = 2;
  std::size_t delay = 3;

  std::complex<double> pole() const {
    const double turn = 2 * pi * resonance / rate;
    return std::exp(turn * std::complex<double>(-damping, std::sqrt(1 - damping * damping)));
  }
  std::complex<double> response(double frequency) const {
    const std::complex<double> p = pole();
    const std::complex<double> z = std::polar(1.0, 2 * pi * frequency / rate);
    const std::complex<double> pole_pair = (1.0 - p / z) * (1.0 - std::conj(p) / z);
    return gain * std::norm(1.0 - p) / pole_pair * std::pow(z, -static_cast<double>(delay));
  }
  std::vector<double> operator()(const std::vector<double>& input) const {
    const std::complex<double> p = pole();
    std::vector<double> output(input.size());
    double last = 0, before = 0;
    for (std::size_t i = delay; i < input.size(); ++i) {
      const double next = 2 * p.real() * last - std::norm(p) * before +
                          gain * std::norm(1.0 - p) * input[i - delay];
      before = last;
      output[i] = last = next;
    }
    return output;
  }
};

std::vector<double> white_noise(std::size_t count, unsigned seed, double deviation = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, deviation);
  std::vector<double> samples(count);
  for (double& sample : samples) sample = normal(random);
  return samples;
}

double degrees_between(double a, double b) { return std::abs(std::remainder(a - b, 360)); }

TEST(FrequencyResponse, WithoutNoiseItIsThatOfTheSystem) {
  const System system;
  for (const std::size_t count : {5000U, 20'000U}) {  // 8 segments, 38 segments
    const std::vector<double> input = white_noise(count, 1);
    const FrequencyResponse found = frequency_response(input, system(input), rate, 6, 200);
    ASSERT_EQ(found.segments, (count - 1024) / 512 + 1);
    ASSERT_EQ(found.points.size(), 159U);  // 1250 / 1024 Hz apart
    std::size_t certain = 0;
    for (const ResponsePoint& point : found.points) {
      if (*point.coherence <= 0.99) continue;
      ++certain;
      const std::complex<double> truth = system.response(point.frequency);
      EXPECT_NEAR(point.gain, 20 * std::log10(std::abs(truth)), 0.5) << point.frequency;
      EXPECT_LT(degrees_between(point.phase, std::arg(truth) * 180 / pi), 3) << point.frequency;
    }
    EXPECT_GT(certain, 150U);
  }
}

TEST(FrequencyResponse, WithNoise95PercentAreWithinTwoDeviations) {
  const System system;
  for (const std::size_t count : {5000U, 20'000U}) {
    std::size_t within = 0, all = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const std::vector<double> input = white_noise(count, seed);
      std::vector<double> output = system(input);
      const std::vector<double> noise = white_noise(count, seed + 100, 0.7);
      for (std::size_t i = 0; i < count; ++i) output[i] += noise[i];
      for (const ResponsePoint& point : frequency_response(input, output, rate, 6, 200).points) {
        const std::complex<double> error = system.response(point.frequency) / point.response - 1.0;
        for (const double part : {error.real(), error.imag()}) {
          ++all;
          if (std::abs(part) <= 2 * *point.deviation) ++within;
        }
      }
    }
    const double share = static_cast<double>(within) / static_cast<double>(all);
    EXPECT_GE(share, 0.945) << count;
    EXPECT_LE(share, 0.975) << count << ": the deviation says more than it should";
  }
}

TEST(FrequencyResponse, ThePhaseOfADelayFallsWithoutJumps) {
  const System delay{.resonance = 10'000, .damping = 0.99, .gain = 1, .delay = 20};
  const std::vector<double> input = white_noise(20'000, 3);
  const FrequencyResponse found = frequency_response(input, delay(input), rate, 2, 400);
  EXPECT_NEAR(found.points.front().phase, -360 * found.points.front().frequency * 0.016, 2);
  EXPECT_NEAR(found.points.back().phase, -360 * found.points.back().frequency * 0.016, 15);
}

TEST(FrequencyResponse, AnInvertingSystemIsNotRelative) {
  const std::vector<double> input = white_noise(5000, 4);
  std::vector<double> output = input;
  for (double& sample : output) sample *= -10;
  const FrequencyResponse found = frequency_response(input, output, rate, 6, 200);
  for (const ResponsePoint& point : found.points) {
    EXPECT_NEAR(point.gain, 20, 1e-9);
    EXPECT_NEAR(std::abs(point.phase), 180, 1e-9);
    EXPECT_NEAR(*point.coherence, 1, 1e-12);
    EXPECT_LT(*point.deviation, 1e-6);
  }
}

TEST(FrequencyResponse, FewSegmentsHaveNoCoherence) {
  const std::vector<double> input = white_noise(5000, 5);
  const auto of = [&](std::size_t count) {
    return frequency_response(std::span(input).first(count), std::span(input).first(count), rate, 6,
                              200);
  };
  EXPECT_EQ(of(63).segments, 0U);
  EXPECT_EQ(of(64).segments, 1U);
  EXPECT_EQ(of(1024 + 2 * 512).segments, 3U);
  EXPECT_FALSE(of(1024 + 2 * 512).points.front().coherence);
  EXPECT_FALSE(of(1024 + 2 * 512).points.front().deviation);
  EXPECT_EQ(of(1024 + 3 * 512).segments, 4U);
  EXPECT_TRUE(of(1024 + 3 * 512).points.front().coherence);
}

TEST(FrequencyResponse, ALossDoesNotChangeTheRest) {
  const System system;
  const std::vector<double> input = white_noise(20'000, 6);
  std::vector<double> output = system(input);
  for (std::size_t i = 7000; i < 7020; ++i) output[i] = std::numeric_limits<double>::quiet_NaN();
  const FrequencyResponse found = frequency_response(input, output, rate, 6, 200);
  EXPECT_EQ(found.segments, 38U - 2);
  for (const ResponsePoint& point : found.points) {
    EXPECT_GT(*point.coherence, 0.98);
    const double error = std::abs(point.response / system.response(point.frequency) - 1.0);
    EXPECT_LT(error, 0.06) << point.frequency;
  }
}

TEST(FrequencyResponse, OutputWithoutInputHasNone) {
  const std::vector<double> silence(5000);
  const FrequencyResponse none = frequency_response(silence, white_noise(5000, 7), rate, 6, 200);
  EXPECT_EQ(none.segments, 8U);
  EXPECT_TRUE(none.points.empty());
  const FrequencyResponse dead = frequency_response(white_noise(5000, 7), silence, rate, 6, 200);
  EXPECT_EQ(dead.points.front().coherence, 0);
  EXPECT_EQ(dead.points.front().gain, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sbgc::analysis
