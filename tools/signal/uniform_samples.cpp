#include "signal/uniform_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbgc::tools {

namespace {

/// A gap of so many samples is as useless as a longer one, and needs memory.
constexpr std::int64_t longest_gap = 100'000;

}  // namespace

void UniformSamples::add(std::int64_t number, const Axes<double>& values) {
  if (values_.empty()) next_ = number;
  if (number < next_) return;
  const std::int64_t gap = std::min(number - next_, longest_gap);
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  values_.insert(values_.end(), static_cast<std::size_t>(gap), {missing, missing, missing});
  lost_ += static_cast<std::size_t>(gap);
  values_.push_back(values);
  next_ = number + 1;
}

void UniformSamples::add_at(std::uint16_t clock_ms, const Axes<double>& values) {
  if (!values_.empty()) since_ms_ += static_cast<std::uint16_t>(clock_ms - clock_ms_);
  clock_ms_ = clock_ms;
  // The first sample may be off, too: the phase follows all of them.
  const double interval_ms = 1000 * interval_;
  const std::int64_t number = std::llround((since_ms_ - phase_ms_) / interval_ms);
  constexpr double share = 0.1;
  phase_ms_ += share * (since_ms_ - phase_ms_ - static_cast<double>(number) * interval_ms);
  add(number, values);
}

double UniformSamples::lost_share() const {
  if (values_.empty()) return 0;
  return static_cast<double>(lost_) / static_cast<double>(values_.size());
}

std::vector<double> UniformSamples::axis(std::size_t axis) const {
  std::vector<double> result(values_.size());
  std::size_t known = 0;  // the first and the last sample are never missing
  for (std::size_t i = 0; i < values_.size(); ++i) {
    result[i] = values_[i][axis];
    if (std::isnan(result[i])) continue;
    for (std::size_t at = known + 1; at < i; ++at) {
      const double share = static_cast<double>(at - known) / static_cast<double>(i - known);
      result[at] = result[known] + share * (result[i] - result[known]);
    }
    known = i;
  }
  return result;
}

}  // namespace sbgc::tools
