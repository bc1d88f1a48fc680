#include <cmath>

#include <sbgc/analysis/uniform_samples.hpp>

namespace sbgc::analysis {

void UniformSamples::add(std::int64_t number, const Axes<double>& values) {
  if (!samples_.empty()) {
    const std::int64_t last = samples_.back().number;
    if (number <= last) return;
    lost_ += static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(last) - 1;
  }
  samples_.push_back({number, values});
}

void UniformSamples::add_at(std::uint16_t clock_ms, const Axes<double>& values) {
  if (!samples_.empty()) since_ms_ += static_cast<std::uint16_t>(clock_ms - clock_ms_);
  clock_ms_ = clock_ms;
  // The first sample may be late or early, too: the phase follows all of them.
  const double interval_ms = 1000 * interval_;
  const std::int64_t number = std::llround((since_ms_ - phase_ms_) / interval_ms);
  constexpr double share = 0.1;
  phase_ms_ += share * (since_ms_ - phase_ms_ - static_cast<double>(number) * interval_ms);
  add(number, values);
}

double UniformSamples::lost_share() const {
  if (lost_ == 0) return 0;
  const auto lost = static_cast<double>(lost_);
  return lost / (lost + static_cast<double>(samples_.size()));
}

std::vector<double> UniformSamples::axis(std::size_t axis) const {
  std::vector<double> result;
  if (!is_usable()) return result;
  for (const Sample& sample : samples_) {
    const auto at = static_cast<std::size_t>(sample.number - samples_.front().number);
    const double value = sample.values[axis];
    const double last = result.empty() ? value : result.back();
    const std::size_t known = result.size();
    for (std::size_t i = known; i <= at; ++i) {
      const double share = static_cast<double>(i + 1 - known) / static_cast<double>(at + 1 - known);
      result.push_back(last + share * (value - last));
    }
  }
  return result;
}

}  // namespace sbgc::analysis
