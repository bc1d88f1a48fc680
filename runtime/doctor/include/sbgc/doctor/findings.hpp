/// Findings from the measurements of a gimbal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/doctor/measurements.hpp>

namespace sbgc::doctor {

/// The limits beyond which a measurement is a finding.
enum class Limit : std::uint8_t {
  power,
  balance,
  vibration,
  resonance,
  contrast,
  cycle,
  i2c_errors,
  serial_errors,
  damaged,
  gravity_error,
};

/// All are assumptions: no document says what is normal.
struct Threshold {
  Limit limit{};
  const char* name{};
  double value{};
  const char* unit{};
  const char* meaning{};
};
std::span<const Threshold> thresholds();
double threshold(Limit limit);

/// Returns the frequencies to show.
inline std::span<const analysis::Frequency> strongest(const std::vector<analysis::Frequency>& all) {
  constexpr std::size_t most = 3;
  return std::span(all).first(std::min(all.size(), most));
}

/// A problem, and a remedy.
struct Finding {
  std::string id{};                   ///< a name, such as "vibration"
  std::optional<std::size_t> axis{};  ///< 0 roll, 1 pitch, 2 yaw
  std::string sentence{};
  std::string advice{};
  std::string command{};         ///< a remedy; may be ""
  std::optional<Limit> limit{};  ///< the exceeded limit
};

/// Judges the measurements. The findings are ordered by priority.
std::vector<Finding> findings_of(const Measurements& measured);

}  // namespace sbgc::doctor
