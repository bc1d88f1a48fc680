/// Equidistant samples, some of which may be lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/types.hpp>

namespace sbgc::analysis {

/// The largest share of lost samples that is interpolated; more would distort a spectrum.
inline constexpr double most_lost = 0.01;

/// One value of each axis per sample.
class UniformSamples {
 public:
  /// `interval` is the time between two samples, in seconds.
  explicit UniformSamples(double interval) : interval_(interval) {}

  /// Adds the sample with this number, counted from any start. Numbers ascend; a sample with a
  /// number that is not higher than the last one is dropped.
  void add(std::int64_t number, const Axes<double>& values);
  /// Adds a sample of a clock that counts milliseconds and wraps at 16 bits. A sample may be off by
  /// less than half of the interval. After a gap, the clock must not have wrapped more than once.
  void add_at(std::uint16_t clock_ms, const Axes<double>& values);

  double rate() const { return 1 / interval_; }
  /// The number of samples that arrived.
  std::size_t size() const { return samples_.size(); }
  /// The share of samples that are missing between the first and the last.
  double lost_share() const;
  bool is_usable() const { return size() > 1 && lost_share() <= most_lost; }
  /// The values of an axis; missing ones are interpolated between their neighbors. Empty unless
  /// is_usable(): the missing samples may exceed the memory.
  std::vector<double> axis(std::size_t axis) const;

 private:
  struct Sample {
    std::int64_t number{};
    Axes<double> values{};
  };

  double interval_;
  std::vector<Sample> samples_{};
  std::uint64_t lost_ = 0;
  std::uint16_t clock_ms_ = 0;  ///< of the last sample
  double phase_ms_ = 0;         ///< of the samples relative to the first
  double since_ms_ = 0;         ///< of the last sample, since the first
};

}  // namespace sbgc::analysis
