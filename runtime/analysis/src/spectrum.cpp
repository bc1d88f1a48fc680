#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include <kissfft/kissfft.hh>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/analysis/spectrum.hpp>

namespace sbgc::analysis {
namespace {

using Bins = std::vector<std::complex<double>>;

/// Transforms segments of one length.
class WindowedTransform {
 public:
  explicit WindowedTransform(std::size_t length)
      : window_(length), segment_(length), transform_(length / 2, false), bins_(length / 2 + 1) {
    // Periodic, because the segments overlap: the period is the length.
    for (std::size_t i = 0; i < length; ++i) {
      const double turn = static_cast<double>(i) / static_cast<double>(length);
      window_[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turn);
    }
  }

  [[nodiscard]] double window_power() const {
    return std::inner_product(window_.begin(), window_.end(), window_.begin(), 0.0);
  }

  const Bins& operator()(std::span<const double> samples) {
    const double mean =
        std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) segment_[i] = (samples[i] - mean) * window_[i];
    transform_.transform_real(segment_.data(), bins_.data());
    // KissFFT packs the real values of the first and the last bin into one number.
    bins_.back() = bins_.front().imag();
    bins_.front() = bins_.front().real();
    return bins_;
  }

 private:
  std::vector<double> window_;
  std::vector<double> segment_;
  kissfft<double> transform_;
  Bins bins_;
};

bool is_complete(std::span<const double> samples) {
  return std::all_of(samples.begin(), samples.end(), [](double x) { return std::isfinite(x); });
}

/// Returns the starts of the segments in a number of samples.
std::vector<std::size_t> segment_starts(std::size_t samples, std::size_t length) {
  std::vector<std::size_t> starts;
  if (length < 2 || length % 2 != 0) return starts;
  for (std::size_t start = 0; start + length <= samples; start += length / 2)
    starts.push_back(start);
  return starts;
}

/// Returns the factor from a sum over segments to the density of bin k: the bins between the first
/// and the last one also stand for the negative frequencies.
double bin_scale(std::size_t bin, std::size_t last, double scale) {
  return bin == 0 || bin == last ? scale : 2 * scale;
}

PowerSpectrum empty_spectrum(double rate, std::size_t length) {
  PowerSpectrum spectrum;
  spectrum.resolution = length == 0 ? 0 : rate / static_cast<double>(length);
  spectrum.density.assign(length / 2 + 1, 0.0);
  return spectrum;
}

void add_power(PowerSpectrum& spectrum, const Bins& bins) {
  ++spectrum.segments;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) spectrum.density[bin] += std::norm(bins[bin]);
}

void scale_power(PowerSpectrum& spectrum, double scale) {
  for (std::size_t bin = 0; bin < spectrum.density.size(); ++bin)
    spectrum.density[bin] *= bin_scale(bin, spectrum.density.size() - 1, scale);
}

}  // namespace

std::size_t segment_length(std::size_t samples, std::size_t longest) {
  return std::bit_floor(std::min(samples, longest));
}

double PowerSpectrum::power(std::size_t first_bin, std::size_t last_bin) const {
  double sum = 0;
  for (std::size_t bin = first_bin; bin <= last_bin && bin < density.size(); ++bin)
    sum += density[bin];
  return sum * resolution;
}

PowerSpectrum power_spectrum(std::span<const double> samples, double rate, std::size_t length) {
  PowerSpectrum spectrum = empty_spectrum(rate, length);
  const std::vector<std::size_t> starts = segment_starts(samples.size(), length);
  if (starts.empty()) return spectrum;
  WindowedTransform transform(length);
  for (const std::size_t start : starts) {
    const auto segment = samples.subspan(start, length);
    if (is_complete(segment)) add_power(spectrum, transform(segment));
  }
  if (spectrum.segments > 0) {
    scale_power(spectrum,
                1 / (rate * transform.window_power() * static_cast<double>(spectrum.segments)));
  }
  return spectrum;
}

CrossSpectrum cross_spectrum(std::span<const double> input, std::span<const double> output,
                             double rate, std::size_t length) {
  CrossSpectrum spectrum{empty_spectrum(rate, length), empty_spectrum(rate, length), {}};
  spectrum.cross.assign(length / 2 + 1, 0.0);
  const std::vector<std::size_t> starts =
      segment_starts(std::min(input.size(), output.size()), length);
  if (starts.empty()) return spectrum;
  WindowedTransform of_input(length);
  WindowedTransform of_output(length);
  for (const std::size_t start : starts) {
    const auto in = input.subspan(start, length);
    const auto out = output.subspan(start, length);
    if (!is_complete(in) || !is_complete(out)) continue;
    const Bins& x = of_input(in);
    const Bins& y = of_output(out);
    add_power(spectrum.input, x);
    add_power(spectrum.output, y);
    for (std::size_t bin = 0; bin < x.size(); ++bin)
      spectrum.cross[bin] += std::conj(x[bin]) * y[bin];
  }
  if (spectrum.input.segments == 0) return spectrum;
  const double scale =
      1 / (rate * of_input.window_power() * static_cast<double>(spectrum.input.segments));
  scale_power(spectrum.input, scale);
  scale_power(spectrum.output, scale);
  for (std::size_t bin = 0; bin < spectrum.cross.size(); ++bin)
    spectrum.cross[bin] *= bin_scale(bin, spectrum.cross.size() - 1, scale);
  return spectrum;
}

namespace {

/// Segments that overlap by half share some of their samples: with a Hann window, this many of them
/// average as well as one that does not overlap.
constexpr double overlapping = 1 + 2.0 / 36;

/// With a coherence below this, the phase is noise and must not be unwrapped.
constexpr double least_coherence = 0.5;

/// Returns the deviation of a response, as a share of it.
double deviation_of(double coherence, std::size_t segments) {
  const double freedom = 2 * (static_cast<double>(segments) / overlapping - 1);
  const double variance = (1 - coherence) / (coherence * freedom);
  // The noise is estimated, too, so the error has Student's distribution: wider for few segments.
  return std::sqrt(variance) * (1 + 1.25 / freedom);
}

/// Returns the angle of a number in degrees, choosing the turn nearest to `last`.
double degrees_near(std::complex<double> number, double last) {
  const double angle = std::arg(number) * 180 / std::numbers::pi;
  return angle + 360 * std::round((last - angle) / 360);
}

}  // namespace

FrequencyResponse frequency_response(std::span<const double> input, std::span<const double> output,
                                     double rate, double from, double to) {
  FrequencyResponse result;
  const std::size_t length = segment_length(std::min(input.size(), output.size()));
  if (length < shortest_segment) return result;
  const CrossSpectrum spectrum = cross_spectrum(input, output, rate, length);
  result.resolution = spectrum.input.resolution;
  result.segments = spectrum.input.segments;
  if (result.segments == 0) return result;
  double last_phase = 0;
  // The means of the segments are removed, so there is no information at 0 Hz.
  for (std::size_t bin = 1; bin < spectrum.cross.size(); ++bin) {
    const double frequency = static_cast<double>(bin) * result.resolution;
    const double in = spectrum.input.density[bin];
    const double out = spectrum.output.density[bin];
    if (frequency < from || frequency > to || !(in > 0)) continue;
    ResponsePoint point;
    point.frequency = frequency;
    point.response = spectrum.cross[bin] / in;
    point.gain = 20 * std::log10(std::abs(point.response));
    point.phase = degrees_near(point.response, last_phase);
    if (result.segments >= least_segments) {
      const double shared = out > 0 ? std::norm(spectrum.cross[bin]) / (in * out) : 0;
      point.coherence = std::min(shared, 1.0);
      point.deviation = deviation_of(*point.coherence, result.segments);
    }
    if (point.coherence.value_or(1) >= least_coherence) last_phase = point.phase;
    result.points.push_back(point);
  }
  return result;
}

}  // namespace sbgc::analysis
