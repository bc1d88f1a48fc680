#include "care/doctor/polling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sbgc::tools {

namespace {

double time_to_answer(const PollingParts& parts) {
  std::array<double, 20> times{};
  for (double& one : times) {
    const double start = parts.now();
    static_cast<void>(parts.ask());
    one = parts.now() - start;
  }
  std::ranges::sort(times);
  constexpr std::size_t late = 18;
  constexpr double shortest = 0.004;
  return std::max(shortest, std::ceil(1250 * times[late]) * 1e-3);
}

}  // namespace

UniformSamples poll_at(const PollingParts& parts, double interval, double time) {
  UniformSamples samples(interval);
  const double start = parts.now();
  std::int64_t number = 0;
  while (!parts.must_end() && parts.now() - start < time) {
    const Axes<double> values = parts.ask();
    const auto now = static_cast<std::int64_t>((parts.now() - start) / interval);
    samples.add(std::max(number, now), values);
    const double lost = samples.lost_share() * static_cast<double>(now + 1);
    if (lost > most_lost * time / interval) return samples;
    number = std::max(number, now) + 1;
    parts.wait_until(start + static_cast<double>(number) * interval);
  }
  return samples;
}

UniformSamples poll_often(const PollingParts& parts, double time) {
  constexpr double longest = 0.1;
  double interval = time_to_answer(parts);
  for (;; interval *= 2) {
    UniformSamples samples = poll_at(parts, interval, time);
    if (samples.is_usable() || interval >= longest || parts.must_end()) return samples;
  }
}

}  // namespace sbgc::tools
