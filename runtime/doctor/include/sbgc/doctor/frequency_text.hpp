/// Frequencies in words.
#pragma once

#include <string>

#include <sbgc/analysis/frequencies.hpp>

namespace sbgc::doctor {

/// The other frequencies, such as "150.0 or 400.0 Hz".
std::string others_text(const analysis::Frequency& frequency);

/// For example "37.0 Hz", "100.0 Hz (or an alias of 150.0 or 400.0 Hz)", or "213.0 Hz (an alias at
/// 37.0 Hz)".
std::string frequency_text(const analysis::Frequency& frequency);

}  // namespace sbgc::doctor
