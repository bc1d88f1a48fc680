/// The vibration of a camera: its strength and its frequencies.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sbgc::analysis {

/// The highest frequency that is analyzed, as a share of the sample rate. Near half the rate,
/// aliases appear.
inline constexpr double highest_share = 0.45;
/// Slower motion does not count as vibration, in hertz.
inline constexpr double slowest_vibration = 1;
/// A peak with less contrast counts as noise. Assumption.
inline constexpr double least_contrast = 10;

/// A frequency at which the signal is stronger than at those around it.
struct Peak {
  double frequency{};  ///< hertz
  double amplitude{};  ///< in the unit of the signal
  double contrast{};   ///< its power density relative to the median of all frequencies
};

struct Vibration {
  double rate{};              ///< of the samples, in hertz
  double resolution{};        ///< distance of two distinguishable frequencies, in hertz
  double slowest{};           ///< the lowest frequency of the spectrum that counts, in hertz
  double fastest{};           ///< the highest one; 0 if the samples were too few for any
  double rms{};               ///< over all of these, in the unit of the signal
  std::vector<Peak> peaks{};  ///< the strongest first

  bool is_known() const { return fastest > 0; }
};

/// Returns the vibration in samples taken `rate` times per second: frequencies from
/// slowest_vibration to highest_share of the rate. Too few samples do not determine it.
Vibration vibration_of(std::span<const double> samples, double rate);

}  // namespace sbgc::analysis
