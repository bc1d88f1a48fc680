#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <sbgc/analysis/frequencies.hpp>
#include <sbgc/analysis/spectrum.hpp>
#include <sbgc/analysis/vibration.hpp>

namespace sbgc::analysis {

namespace {

/// The number of bins to each side over which the window spreads one frequency.
constexpr std::size_t spread = 2;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the offset, -0.5 to 0.5, of the top of a parabola through the logarithms of three
/// values, relative to the second one.
double top_of(double before, double at, double after) {
  const double a = std::log(before);
  const double b = std::log(at);
  const double c = std::log(after);
  const double curve = a - 2 * b + c;
  if (!std::isfinite(curve) || curve >= 0) return 0;
  return std::clamp((a - c) / (2 * curve), -0.5, 0.5);
}

}  // namespace

Vibration vibration_of(std::span<const double> samples, double rate) {
  // Three segments, so that noise averages out, and an even length.
  constexpr std::size_t longest = 1024;
  const std::size_t length = std::min(samples.size() / 2, longest) / 2 * 2;
  const PowerSpectrum spectrum = power_spectrum(samples, rate, length);
  if (spectrum.segments == 0) return {};
  const std::vector<double>& density = spectrum.density;
  const auto bin = [&](double frequency) {
    return static_cast<std::size_t>(std::max(0.0, frequency / spectrum.resolution));
  };
  // The first bin after 0 Hz also contains the residual slow motion of a segment.
  const std::size_t first = std::max<std::size_t>(bin(slowest_vibration) + 1, 2);
  const std::size_t last = std::min(bin(highest_share * rate), density.size() - 1);
  if (last < first + 2 * spread) return {};
  Vibration result{.rate = rate,
                   .resolution = spectrum.resolution,
                   .slowest = static_cast<double>(first) * spectrum.resolution,
                   .fastest = static_cast<double>(last) * spectrum.resolution};
  result.rms = std::sqrt(spectrum.power(first, last));
  const double median = median_of({density.begin() + static_cast<std::ptrdiff_t>(first),
                                   density.begin() + static_cast<std::ptrdiff_t>(last) + 1});
  for (std::size_t at = first; at <= last; ++at) {
    const std::size_t from = at - std::min(at, spread);
    const std::size_t to = std::min(at + spread, last);
    const auto begin = density.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = density.begin() + static_cast<std::ptrdiff_t>(to) + 1;
    const auto highest = std::max_element(begin, end);
    if (highest - density.begin() != static_cast<std::ptrdiff_t>(at) || density[at] <= 0) continue;
    const double noise = median * spectrum.resolution * static_cast<double>(to - from + 1);
    const double power = std::max(0.0, spectrum.power(from, to) - noise);
    const double shift = at < last ? top_of(density[at - 1], density[at], density[at + 1]) : 0;
    result.peaks.push_back({(static_cast<double>(at) + shift) * spectrum.resolution,
                            std::sqrt(2 * power), median > 0 ? density[at] / median : 1e9});
  }
  std::sort(result.peaks.begin(), result.peaks.end(),
            [](const Peak& one, const Peak& other) { return one.amplitude > other.amplitude; });
  return result;
}

namespace {

/// Returns the frequencies that appear at `seen` in samples at this rate, ascending.
std::vector<double> candidates_of(double seen, double rate) {
  std::vector<double> found{seen};
  for (double turn = rate; turn - seen <= fastest_vibration; turn += rate) {
    found.push_back(turn - seen);
    if (turn + seen <= fastest_vibration) found.push_back(turn + seen);
  }
  return found;
}

/// False if the vibration would show the frequency but does not.
bool permits(const Vibration& vibration, double frequency, const Peak& peak, double resolution) {
  const double seen = alias_of(frequency, vibration.rate);
  const double tolerance = (vibration.resolution + resolution) / 2;
  if (seen < vibration.slowest + tolerance || seen > vibration.fastest - tolerance) return true;
  // It is the same motion, but its strength may vary.
  constexpr double least_share = 0.5;
  return std::any_of(vibration.peaks.begin(), vibration.peaks.end(), [&](const Peak& other) {
    return std::abs(other.frequency - seen) <= tolerance &&
           other.amplitude >= least_share * peak.amplitude;
  });
}

std::vector<Frequency> explained(const Vibration& vibration,
                                 const std::function<bool(double, const Peak&)>& is_possible) {
  std::vector<Frequency> result;
  for (const Peak& peak : vibration.peaks) {
    Frequency found{peak, candidates_of(peak.frequency, vibration.rate), true};
    std::erase_if(found.others, [&](double one) { return !is_possible(one, peak); });
    if (found.others.empty()) continue;
    found.is_real = found.others.front() == peak.frequency;
    if (found.is_real) found.others.erase(found.others.begin());
    result.push_back(std::move(found));
  }
  return result;
}

}  // namespace

double alias_of(double frequency, double rate) {
  return std::abs(frequency - rate * std::round(frequency / rate));
}

std::vector<Frequency> frequencies_of(const Vibration& vibration) {
  return explained(vibration, [](double, const Peak&) { return true; });
}

std::vector<Frequency> frequencies_of(const Vibration& first, const Vibration& second) {
  if (!second.is_known()) return frequencies_of(first);
  return explained(first, [&](double frequency, const Peak& peak) {
    return permits(second, frequency, peak, first.resolution);
  });
}

}  // namespace sbgc::analysis
