#include "move/response_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <sbgc/analysis/spectrum.hpp>

namespace sbgc::tools {

namespace {

struct FrequencyRange {
  double from = 0, to = 0;
};

FrequencyRange shown_range(const msg::BodeTestStartStopRequest& request) {
  constexpr double highest = 500;
  return {request.start_freq.hertz(), std::min(request.end_freq.hertz(), highest)};
}

}  // namespace

double resolution_of(const msg::BodeTestStartStopRequest& request) {
  return bode_sample_rate / static_cast<double>(analysis::segment_length(request.samples_num));
}

bool has_frequencies(const msg::BodeTestStartStopRequest& request) {
  const auto [from, to] = shown_range(request);
  const double resolution = resolution_of(request);
  return std::floor(to / resolution) * resolution >= std::max(from, resolution);
}

analysis::FrequencyResponse response_of(const BodeRecording& recording) {
  const auto [from, to] = shown_range(recording.request);
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
