#include "motion/response_table.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace sbgc::tools {

analysis::FrequencyResponse response_of(const BodeRecording& recording) {
  constexpr double highest = 500;
  const double from = recording.request.start_freq.hertz();
  const double to = std::min(recording.request.end_freq.hertz(), highest);
  return analysis::frequency_response(recording.input, recording.output, bode_sample_rate, from,
                                      to);
}

std::string response_table(const analysis::FrequencyResponse& response) {
  std::string text =
      fmt::format("{:>8} {:>9} {:>10} {:>10}\n", "Hz", "gain dB", "phase deg", "coherence");
  const auto to = std::back_inserter(text);
  for (const analysis::ResponsePoint& point : response.points) {
    const std::string coherence =
        point.coherence ? fmt::format("{:.3f}", *point.coherence) : std::string("-");
    fmt::format_to(to, "{:8.2f} {:9.2f} {:10.1f} {:>10}\n", point.frequency, point.gain,
                   point.phase, coherence);
  }
  return text;
}

}  // namespace sbgc::tools
