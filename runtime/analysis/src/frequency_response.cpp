#include <algorithm>
#include <cmath>
#include <numbers>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/analysis/spectrum.hpp>

namespace sbgc::analysis {
namespace {

/// Segments that overlap by half share a part of their samples: so many of them, under a Hann
/// window, average as well as one of those that do not overlap.
constexpr double overlapping = 1 + 2.0 / 36;

/// The phase of a coherence below this is noise, which does not tell turns.
constexpr double least_coherence = 0.5;

/// Returns the deviation of a response, as a share of it.
double deviation_of(double coherence, std::size_t segments) {
  const double freedom = 2 * (static_cast<double>(segments) / overlapping - 1);
  const double variance = (1 - coherence) / (coherence * freedom);
  // The noise is estimated, too, so the error has Student's distribution: wider for few segments.
  return std::sqrt(variance) * (1 + 1.25 / freedom);
}

/// Returns the angle of a number in degrees, the one nearest to `last`.
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
  // The means of the segments are removed, and with them what is at 0 Hz.
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
