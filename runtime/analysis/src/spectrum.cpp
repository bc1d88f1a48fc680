#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include <kissfft/kissfft.hh>

#include <sbgc/analysis/spectrum.hpp>

namespace sbgc::analysis {
namespace {

using Bins = std::vector<std::complex<double>>;

/// Transforms segments of one length.
class WindowedTransform {
 public:
  explicit WindowedTransform(std::size_t length)
      : window_(length), segment_(length), transform_(length / 2, false), bins_(length / 2 + 1) {
    // Periodic, as the segments overlap: its period is the length.
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
    // KissFFT has the real values of the first and the last bin in one number.
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

/// Starts of the segments in a number of samples.
std::vector<std::size_t> segment_starts(std::size_t samples, std::size_t length) {
  std::vector<std::size_t> starts;
  if (length < 2 || length % 2 != 0) return starts;
  for (std::size_t start = 0; start + length <= samples; start += length / 2)
    starts.push_back(start);
  return starts;
}

/// The factor from a sum over segments to the density of bin k: the bins between the first and the
/// last one stand for the negative frequencies, too.
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

}  // namespace sbgc::analysis
