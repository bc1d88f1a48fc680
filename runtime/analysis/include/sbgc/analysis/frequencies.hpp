/// The frequencies of a vibration, recovered from their aliases.
#pragma once

#include <cstddef>
#include <vector>

#include <sbgc/analysis/vibration.hpp>

namespace sbgc::analysis {

/// Assumption: the gyroscope's filter blocks higher frequencies, in hertz.
inline constexpr double fastest_vibration = 400;

/// Returns the frequency at which `frequency` appears when sampled `rate` times per second.
double alias_of(double frequency, double rate);

/// A peak of a spectrum, and the frequencies that may have caused it.
struct Frequency {
  Peak peak{};
  std::vector<double> others{};  ///< higher ones that look the same, ascending
  /// False if the peak is only an alias of one of the others.
  bool is_real = true;
};

/// The frequencies that the peaks of one spectrum can have, up to fastest_vibration.
std::vector<Frequency> frequencies_of(const Vibration& vibration);

/// The same for a vibration that was sampled at two rates. A frequency that only one of them shows,
/// although both could, is discarded; so most aliases have one candidate.
std::vector<Frequency> frequencies_of(const Vibration& first, const Vibration& second);

}  // namespace sbgc::analysis
