/// The frequencies of a vibration, told from their aliases.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "signal/vibration.hpp"

namespace sbgc::tools {

/// Assumption: the filter of a gyroscope stops what is faster, in hertz.
inline constexpr double fastest_vibration = 400;

/// Where a frequency appears in samples, `rate` of them per second.
double alias_of(double frequency, double rate);

/// A peak of a spectrum, and what it can be.
struct Frequency {
  Peak peak{};
  std::vector<double> others{};  ///< higher ones that look the same, ascending
  /// False if the peak itself is none of the candidates: it is an alias of one of the others.
  bool is_real = true;
};

/// What the peaks of one spectrum can be, up to fastest_vibration.
std::vector<Frequency> frequencies_of(const Vibration& vibration);

/// The same for a vibration that was sampled at two rates. A frequency that only one of them shows,
/// although both could, is none; so most aliases have one candidate.
std::vector<Frequency> frequencies_of(const Vibration& first, const Vibration& second);

/// The others, such as "150.0 or 400.0 Hz".
std::string others_text(const Frequency& frequency);

/// For example "37.0 Hz", "100.0 Hz (or an alias of 150.0 or 400.0 Hz)", or "213.0 Hz (an alias at
/// 37.0 Hz)".
std::string frequency_text(const Frequency& frequency);

}  // namespace sbgc::tools
