// Spectra, against signals whose spectra are known, and against the definition of the Fourier
// transform.
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/analysis/spectrum.hpp>

namespace sbgc::analysis {
namespace {

using std::numbers::pi;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> samples(count);
  for (double& sample : samples) sample = normal(random);
  return samples;
}

std::vector<double> sine(std::size_t count, double rate, double frequency, double amplitude) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = amplitude * std::sin(2 * pi * frequency * static_cast<double>(i) / rate);
  return samples;
}

/// The density of one segment, by definition.
std::vector<double> density_by_definition(const std::vector<double>& samples, double rate) {
  const auto n = static_cast<double>(samples.size());
  double mean = 0;
  for (const double sample : samples) mean += sample / n;
  std::vector<double> density;
  for (std::size_t k = 0; k <= samples.size() / 2; ++k) {
    std::complex<double> sum;
    double window_power = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double window = std::pow(std::sin(pi * static_cast<double>(i) / n), 2);
      window_power += window * window;
      const double angle = -2 * pi * static_cast<double>(k) * static_cast<double>(i) / n;
      sum += window * (samples[i] - mean) * std::polar(1.0, angle);
    }
    const double sides = k == 0 || k == samples.size() / 2 ? 1 : 2;
    density.push_back(sides * std::norm(sum) / (rate * window_power));
  }
  return density;
}

TEST(Spectrum, OneSegmentIsWhatTheDefinitionSays) {
  for (const std::size_t length : {2U, 4U, 6U, 64U, 90U}) {
    const std::vector<double> samples = noise(length, 1);
    const PowerSpectrum spectrum = power_spectrum(samples, 50, length);
    const std::vector<double> expected = density_by_definition(samples, 50);
    ASSERT_EQ(spectrum.segments, 1U);
    ASSERT_EQ(spectrum.density.size(), expected.size());
    for (std::size_t bin = 0; bin < expected.size(); ++bin)
      EXPECT_NEAR(spectrum.density[bin], expected[bin], 1e-12) << length << ' ' << bin;
    EXPECT_DOUBLE_EQ(spectrum.resolution, 50.0 / static_cast<double>(length));
  }
}

TEST(Spectrum, SegmentsOverlapByHalfAndAreAveraged) {
  const std::vector<double> samples = noise(16, 2);
  const PowerSpectrum spectrum = power_spectrum(samples, 1, 8);
  ASSERT_EQ(spectrum.segments, 3U);
  std::vector<double> expected(5);
  for (const std::ptrdiff_t start : {0, 4, 8}) {
    const std::vector<double> segment(samples.begin() + start, samples.begin() + start + 8);
    const std::vector<double> density = density_by_definition(segment, 1);
    for (std::size_t bin = 0; bin < 5; ++bin) expected[bin] += density[bin] / 3;
  }
  for (std::size_t bin = 0; bin < 5; ++bin)
    EXPECT_NEAR(spectrum.density[bin], expected[bin], 1e-12);
}

TEST(Spectrum, PowerOfASineIsHalfItsSquaredAmplitude) {
  const PowerSpectrum spectrum = power_spectrum(sine(8192, 1250, 100, 3), 1250, 1024);
  const auto peak = static_cast<std::size_t>(std::lround(100 / spectrum.resolution));
  EXPECT_NEAR(spectrum.power(peak - 3, peak + 3), 4.5, 0.01);
  EXPECT_LT(spectrum.power(0, peak - 20), 1e-3);
}

TEST(Spectrum, PowerOfNoiseIsItsVarianceAndItsMeanIsLeftOut) {
  std::vector<double> samples = noise(100'000, 3);
  for (double& sample : samples) sample += 1000;
  const PowerSpectrum spectrum = power_spectrum(samples, 10, 256);
  EXPECT_NEAR(spectrum.power(0, spectrum.density.size()), 1, 0.02);
}

TEST(Spectrum, ASegmentWithAMissingSampleIsLeftOut) {
  std::vector<double> samples = noise(64 * 5, 4);  // 9 segments of 64
  EXPECT_EQ(power_spectrum(samples, 1, 64).segments, 9U);
  samples[100] = missing;  // in the segments from 64 and from 96 (half a segment is 32)
  const PowerSpectrum spectrum = power_spectrum(samples, 1, 64);
  EXPECT_EQ(spectrum.segments, 7U);
  for (const double density : spectrum.density) EXPECT_TRUE(std::isfinite(density));
  // In a cross spectrum, a sample that is missing in either signal counts.
  const CrossSpectrum cross = cross_spectrum(noise(64 * 5, 5), samples, 1, 64);
  EXPECT_EQ(cross.input.segments, 7U);
  EXPECT_EQ(cross.output.segments, 7U);
}

TEST(Spectrum, WithoutACompleteSegmentThereIsNone) {
  EXPECT_EQ(power_spectrum(noise(63, 6), 1, 64).segments, 0U);
  EXPECT_EQ(power_spectrum(noise(64, 6), 1, 63).segments, 0U);  // an odd length
  EXPECT_EQ(power_spectrum(noise(64, 6), 1, 0).segments, 0U);
  EXPECT_EQ(power_spectrum(std::vector<double>(64, missing), 1, 64).segments, 0U);
  EXPECT_EQ(cross_spectrum(noise(64, 6), noise(63, 7), 1, 64).input.segments, 0U);
}

TEST(Spectrum, CrossSpectrumHasTheGainAndThePhaseOfADelay) {
  const std::vector<double> input = noise(50'000, 8);
  std::vector<double> output(input.size());
  for (std::size_t i = 2; i < input.size(); ++i) output[i] = 0.25 * input[i - 2];
  const CrossSpectrum spectrum = cross_spectrum(input, output, 1250, 1024);
  for (std::size_t bin = 4; bin < 500; bin += 31) {
    const std::complex<double> response = spectrum.cross[bin] / spectrum.input.density[bin];
    const double angle = -2 * pi * static_cast<double>(bin) * 2 / 1024;
    EXPECT_NEAR(std::abs(response - std::polar(0.25, angle)), 0, 0.005) << bin;
    EXPECT_NEAR(spectrum.output.density[bin] / spectrum.input.density[bin], 0.0625, 0.003);
  }
}

TEST(Spectrum, SegmentLengthIsAPowerOfTwo) {
  EXPECT_EQ(segment_length(5000), 1024U);
  EXPECT_EQ(segment_length(1023), 512U);
  EXPECT_EQ(segment_length(64), 64U);
  EXPECT_EQ(segment_length(100'000, 4096), 4096U);
  EXPECT_EQ(segment_length(0), 0U);
}

}  // namespace
}  // namespace sbgc::analysis
