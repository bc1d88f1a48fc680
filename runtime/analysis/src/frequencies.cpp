#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <sbgc/analysis/frequencies.hpp>

namespace sbgc::analysis {

namespace {

/// The frequencies that appear at `seen` in samples at this rate, ascending.
std::vector<double> candidates_of(double seen, double rate) {
  std::vector<double> found{seen};
  for (double turn = rate; turn - seen <= fastest_vibration; turn += rate) {
    found.push_back(turn - seen);
    if (turn + seen <= fastest_vibration) found.push_back(turn + seen);
  }
  return found;
}

/// True unless the vibration would show the frequency and does not.
bool permits(const Vibration& vibration, double frequency, const Peak& peak, double resolution) {
  const double seen = alias_of(frequency, vibration.rate);
  const double tolerance = (vibration.resolution + resolution) / 2;
  if (seen < vibration.slowest + tolerance || seen > vibration.fastest - tolerance) return true;
  // The same motion, but its strength may vary.
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
