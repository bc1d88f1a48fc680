// The picture of frequency responses.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "move/response_table.hpp"
#include "signal/line_picture.hpp"

namespace sbgc::tools {

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
