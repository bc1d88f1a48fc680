#include "move/response_output.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/analysis/spectrum.hpp>

#include "signal/line_picture.hpp"

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

namespace {

using analysis::ResponsePoint;

LinePlot plot_of(const std::vector<NamedResponse>& responses, const char* title,
                 const std::function<double(const ResponsePoint&)>& value) {
  LinePlot plot{.title = title, .x_unit = "Hz", .has_log_x = true};
  for (const NamedResponse& one : responses) {
    auto& line = plot.lines.emplace_back();
    for (const ResponsePoint& point : one.response.points) {
      line.push_back({point.frequency, value(point)});
    }
  }
  return plot;
}

}  // namespace

std::string response_svg(const std::vector<NamedResponse>& responses) {
  std::vector<std::string> names;
  names.reserve(responses.size());
  for (const NamedResponse& one : responses) names.push_back(one.name);
  LinePlot gain = plot_of(responses, "Gain in dB", &ResponsePoint::gain);
  LinePlot phase = plot_of(responses, "Phase in degrees", &ResponsePoint::phase);
  phase.shows_angles = true;
  LinePlot coherence = plot_of(responses, "Coherence", [](const ResponsePoint& point) {
    return point.coherence.value_or(std::numeric_limits<double>::quiet_NaN());
  });
  coherence.values = {0, 1};
  coherence.mark = 0.9;  // below, noise and friction dominate
  return svg_picture("Frequency response", names, {gain, phase, coherence});
}

}  // namespace sbgc::tools
