#include "plot/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "signal/line_picture.hpp"

namespace sbgc::tools {

namespace {

/// The narrowest range of values that is drawn, so that a constant stays a line.
constexpr double least_range = 1e-9;

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::string title_of(const Curve& curve) {
  std::string title = curve.name;
  if (!curve.unit.empty()) title += " [" + curve.unit + "]";
  if (!curve.note.empty()) title += "  " + curve.note;
  return title;
}

}  // namespace

std::vector<double> thinned(const std::vector<double>& values, std::size_t count) {
  if (values.size() <= count) return values;
  const std::size_t parts = std::max<std::size_t>(count / 2, 1);
  std::vector<double> result;
  for (std::size_t i = 0; i < parts; ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * values.size() / parts);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>((i + 1) * values.size() / parts);
    auto lowest = end;
    auto highest = end;
    for (auto at = begin; at != end; ++at) {
      if (std::isnan(*at)) continue;
      if (lowest == end || *at < *lowest) lowest = at;
      if (highest == end || *at > *highest) highest = at;
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    result.push_back(lowest == end ? none : *std::min(lowest, highest));
    result.push_back(lowest == end ? none : *std::max(lowest, highest));
  }
  return result;
}

std::string draw_text(const std::vector<Curve>& curves, std::size_t width, std::size_t height,
                      ChartStyle style) {
  constexpr std::size_t label = 10;
  const std::size_t chart = width > label + 2 ? width - label - 1 : 1;
  const std::size_t dots = chart * (style == ChartStyle::braille ? 2 : 1);
  std::string text;
  for (const Curve& curve : curves) {
    if (!text.empty()) text += '\n';
    text += title_of(curve) + '\n';
    const ValueRange range = range_of_values(curve.values, least_range);
    std::vector<double> values = thinned(curve.values, dots);
    if (values.size() < dots && values.size() > 1) {
      // Stretched to the whole width.
      std::vector<double> wide(dots);
      for (std::size_t i = 0; i < dots; ++i) wide[i] = values[i * values.size() / dots];
      values = std::move(wide);
    }
    const auto lines = draw_chart(values, range, chart, height, style);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::string at_left;
      if (i == 0) at_left = short_number(range.high);
      if (i + 1 == lines.size()) at_left = short_number(range.low);
      text += fmt::format("{:>{}} {}\n", at_left, label, lines[i]);
    }
    const std::string first = short_number(curve.first_x) + " " + curve.x_unit;
    const std::string last = short_number(curve.last_x) + " " + curve.x_unit;
    const std::size_t space = chart > first.size() + last.size() ? chart - first.size() : 0;
    text += fmt::format("{:{}}{}{:>{}}\n", "", label + 1, first, last, space);
  }
  return text;
}

std::string draw_svg(const std::vector<Curve>& curves) {
  constexpr std::size_t most_points = 4000;
  std::vector<LinePlot> plots;
  for (const Curve& curve : curves) {
    LinePlot& plot = plots.emplace_back(LinePlot{.title = title_of(curve), .x_unit = curve.x_unit});
    auto& line = plot.lines.emplace_back();
    const std::vector<double> values = thinned(curve.values, most_points);
    const double steps = static_cast<double>(std::max<std::size_t>(values.size(), 2) - 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double share = static_cast<double>(i) / steps;
      line.push_back({curve.first_x + share * (curve.last_x - curve.first_x), values[i]});
    }
  }
  return svg_picture("Curves", {}, plots);
}

}  // namespace sbgc::tools
