#include "plot/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

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

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

// The layout of a picture, in pixels.
constexpr double picture_width = 900;
constexpr double chart_height = 160;
constexpr double chart_distance = 220;
constexpr double left = 80;
constexpr double right = 20;
constexpr double top = 30;

void append_chart(std::string& svg, const Curve& curve, double y) {
  const ValueRange range = range_of_values(curve.values, least_range);
  const double width = picture_width - left - right;
  const auto text = [&](double at_x, double at_y, const char* anchor, const std::string& words) {
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", at_x, at_y,
                       anchor, escaped(words));
  };
  text(left, y - 8, "start", title_of(curve));
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>\n", left,
      y, width, chart_height);
  text(left - 6, y + 10, "end", short_number(range.high));
  text(left - 6, y + chart_height, "end", short_number(range.low));
  text(left, y + chart_height + 16, "start", short_number(curve.first_x) + " " + curve.x_unit);
  text(left + width, y + chart_height + 16, "end", short_number(curve.last_x) + " " + curve.x_unit);
  constexpr std::size_t most_points = 4000;
  const std::vector<double> values = thinned(curve.values, most_points);
  const double steps = static_cast<double>(std::max<std::size_t>(values.size(), 2) - 1);
  std::string path;
  bool is_broken = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      is_broken = true;
      continue;
    }
    const double share = (values[i] - range.low) / (range.high - range.low);
    path +=
        fmt::format("{}{:.1f} {:.1f}", is_broken ? "M" : "L",
                    left + width * static_cast<double>(i) / steps, y + chart_height * (1 - share));
    is_broken = false;
  }
  svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#06c\"/>\n", path);
}

}  // namespace

std::vector<double> thinned(const std::vector<double>& values, std::size_t count) {
  if (values.size() <= count) return values;
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * values.size() / count;
    const std::size_t end = std::max(begin + 1, (i + 1) * values.size() / count);
    double chosen = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t at = begin; at < end; ++at) {
      chosen = i % 2 == 0 ? std::fmin(chosen, values[at]) : std::fmax(chosen, values[at]);
    }
    result[i] = chosen;
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
  const double height = chart_distance * static_cast<double>(curves.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      picture_width, height);
  double y = top;
  for (const Curve& curve : curves) {
    append_chart(svg, curve, y);
    y += chart_distance;
  }
  return svg + "</svg>\n";
}

}  // namespace sbgc::tools
