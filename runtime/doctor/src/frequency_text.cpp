#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <sbgc/doctor/frequency_text.hpp>

namespace sbgc::doctor {

std::string others_text(const analysis::Frequency& frequency) {
  constexpr std::size_t most = 4;
  const std::vector<double>& others = frequency.others;
  const std::size_t shown = std::min(others.size(), most);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == others.size();
    text += fmt::format("{}{:.1f}", i == 0 ? "" : is_last ? " or " : ", ", others[i]);
  }
  return text + (shown < others.size() ? " ... Hz" : " Hz");
}

std::string frequency_text(const analysis::Frequency& frequency) {
  std::string seen = fmt::format("{:.1f} Hz", frequency.peak.frequency);
  if (frequency.others.empty()) return seen;
  const std::string others = others_text(frequency);
  if (frequency.is_real) return fmt::format("{} (or an alias of {})", seen, others);
  return fmt::format("{} (an alias at {})", others, seen);
}

}  // namespace sbgc::doctor
