/// The vibration of a camera: its strength and its frequencies.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sbgc::analysis {

/// The highest frequency that is looked at, as a share of the sample rate. At half of it, others
/// appear in its place.
inline constexpr double highest_share = 0.45;
/// Slower motion is no vibration, in hertz.
inline constexpr double slowest_vibration = 1;
/// A peak whose contrast is less is noise. Assumption.
inline constexpr double least_contrast = 10;

/// A frequency at which the signal is stronger than at those around it.
struct Peak {
  double frequency{};  ///< hertz
  double amplitude{};  ///< in the unit of the signal
  double contrast{};   ///< its power density relative to the median of all frequencies
};

struct Vibration {
  double rate{};              ///< of the samples, in hertz
  double resolution{};        ///< distance of two frequencies that can be told apart, in hertz
  double slowest{};           ///< the lowest frequency of the spectrum that counts, in hertz
  double fastest{};           ///< the highest one; 0 if the samples were too few for any
  double rms{};               ///< of all of these, in the unit of the signal
  std::vector<Peak> peaks{};  ///< the strongest first

  bool is_known() const { return fastest > 0; }
};

/// Returns the vibration in samples, `rate` of them per second: frequencies from slowest_vibration
/// to highest_share of the rate. It is not known from too few samples.
Vibration vibration_of(std::span<const double> samples, double rate);

}  // namespace sbgc::analysis
