/// The vibration of a camera: its strength and its frequencies.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sbgc::tools {

/// The highest frequency that is looked at, as a share of the sample rate. At half of it, others
/// appear in its place.
inline constexpr double highest_share = 0.45;
/// Slower motion is no vibration, in hertz.
inline constexpr double slowest_vibration = 3;

/// A frequency at which the signal is stronger than at those around it.
struct Peak {
  double frequency{};  ///< hertz
  double amplitude{};  ///< in the unit of the signal
  double contrast{};   ///< its power density relative to the median of all frequencies
};

struct Vibration {
  double rms{};               ///< of all frequencies of a vibration, in the unit of the signal
  std::vector<Peak> peaks{};  ///< the strongest first
};

/// Returns the vibration in samples, `rate` of them per second: frequencies from slowest_vibration
/// to highest_share of the rate. There is none in too few samples.
Vibration vibration_of(std::span<const double> samples, double rate);

}  // namespace sbgc::tools
