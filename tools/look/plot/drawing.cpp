#include "look/plot/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "command/terminal_text.hpp"

namespace sbgc::tools {

namespace {

/// The narrowest range of values that is drawn, so that a constant remains a line.
constexpr double least_range = 1e-9;

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::string title_of(const Curve& curve) {
  std::string title = curve.name;
  if (!curve.unit.empty()) title += " [" + curve.unit + "]";
  if (!curve.note.empty()) title += "  " + curve.note;
  return title;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The points that have a number.
std::vector<LinePoint> points_of(const Curve& curve) {
  std::vector<LinePoint> points;
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    if (!std::isnan(curve.values[i])) points.push_back({curve.places[i], curve.values[i]});
  }
  return points;
}

/// Returns the longest distance of two points that does not count as a gap.
double longest_distance(const std::vector<LinePoint>& points) {
  constexpr double most = 10;  // multiple of the usual distance
  std::vector<double> distances;
  for (std::size_t i = 1; i < points.size(); ++i) {
    distances.push_back(points[i].x - points[i - 1].x);
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  // Points that come in bunches have no usual distance.
  return *middle > 0 ? most * *middle : std::numeric_limits<double>::infinity();
}

/// Divides the width of a curve into equal parts.
class WidthOfCurve {
 public:
  WidthOfCurve(const Curve& curve, std::size_t parts)
      : first_(curve.places.front()), last_(curve.places.back()), parts_(parts) {}

  /// Returns the part of a position; the last one if all positions are equal.
  std::size_t part_of(double place) const {
    const double share = last_ > first_ ? (place - first_) / (last_ - first_) : 1;
    const auto part = static_cast<std::size_t>(share * static_cast<double>(parts_));
    return std::min(part, parts_ - 1);
  }
  double middle_of(std::size_t part) const {
    const double share = (static_cast<double>(part) + 0.5) / static_cast<double>(parts_);
    return first_ + share * (last_ - first_);
  }

 private:
  double first_, last_;
  std::size_t parts_;
};

/// Returns the values to draw at `count` equal distances: of each pair, the lowest and the highest
/// one, and lines between distant points.
std::vector<double> at_equal_distances(const Curve& curve, std::size_t count) {
  const std::vector<LinePoint> points = thinned(curve, count / 2);
  const WidthOfCurve pairs(curve, count / 2);
  const WidthOfCurve dots(curve, count);
  std::vector<double> values(count, no_number);
  std::optional<std::size_t> drawn;  // the last dot of this line
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LinePoint& point = points[i];
    if (std::isnan(point.y)) {
      drawn.reset();
      continue;
    }
    const std::size_t pair = pairs.part_of(point.x);
    const auto shares_pair = [&](std::size_t other) {
      return other < points.size() && !std::isnan(points[other].y) &&
             pairs.part_of(points[other].x) == pair;
    };
    std::size_t dot = dots.part_of(point.x);
    if (shares_pair(i + 1)) dot = 2 * pair;
    if (drawn && shares_pair(i - 1)) dot = 2 * pair + 1;
    for (std::size_t at = drawn.value_or(dot) + 1; at < dot; ++at) {
      const LinePoint& from = points[i - 1];
      const double share = (dots.middle_of(at) - from.x) / (point.x - from.x);
      values[at] = from.y + std::clamp(share, 0.0, 1.0) * (point.y - from.y);
    }
    values[dot] = point.y;
    drawn = dot;
  }
  return values;
}

}  // namespace

std::vector<LinePoint> thinned(const Curve& curve, std::size_t parts) {
  const std::vector<LinePoint> points = points_of(curve);
  const double longest = longest_distance(points);
  const WidthOfCurve width(curve, parts);
  std::vector<LinePoint> result;
  for (std::size_t i = 0; i < points.size();) {
    const std::size_t part = width.part_of(points[i].x);
    if (i > 0 && points[i].x - points[i - 1].x > longest) {
      result.push_back({points[i].x, no_number});
    }
    std::size_t lowest = i;
    std::size_t highest = i;
    for (++i; i < points.size() && width.part_of(points[i].x) == part; ++i) {
      if (points[i].y < points[lowest].y) lowest = i;
      if (points[i].y >= points[highest].y) highest = i;  // a constant has its first and its last
    }
    result.push_back(points[std::min(lowest, highest)]);
    if (lowest != highest) result.push_back(points[std::max(lowest, highest)]);
  }
  return result;
}

namespace {

/// The characters of axes.
struct AxisSigns {
  const char* line;
  const char* tick;
  const char* corner;
  const char* along;
};

/// Returns the axis below a chart: its first, middle and last value, if there is room.
std::string axis_of_places(const Curve& curve, std::size_t width, const char* along) {
  const auto text_at = [&](double place) { return " " + short_number(place) + " " + curve.x_unit; };
  const double begin = curve.places.front();
  const double end = curve.places.back();
  const std::string first = text_at(begin) + " ";
  const std::string last = text_at(end);
  std::string middle = text_at(begin + (end - begin) / 2) + " ";
  if (width < first.size() + middle.size() + last.size() + 4) middle.clear();
  const std::size_t ends = first.size() + middle.size() + last.size();
  const std::size_t rest = width > ends ? width - ends : 0;
  const std::size_t left = middle.empty() ? rest : (width - middle.size()) / 2 - first.size();
  std::string text = first;
  for (std::size_t i = 0; i < rest; ++i) {
    if (i == left) text += middle;
    text += along;
  }
  return text + last;
}

}  // namespace

std::string draw_text(const std::vector<Curve>& curves, std::size_t width, std::size_t height,
                      ChartStyle style) {
  const AxisSigns signs =
      style == ChartStyle::braille ? AxisSigns{"│", "┤", "└", "─"} : AxisSigns{"|", "+", "+", "-"};
  constexpr std::size_t label = 10;
  // Even, because each pair of dots shows the lowest and the highest value.
  const std::size_t chart = width > label + 2 ? (width - label - 1) / 2 * 2 : 2;
  const std::size_t dots = chart * (style == ChartStyle::braille ? 2 : 1);
  std::string text;
  for (const Curve& curve : curves) {
    if (!text.empty()) text += '\n';
    text += wrapped(title_of(curve), width, 2, 2) + '\n';
    const ValueRange range = range_of_values(curve.values, least_range);
    const std::vector<double> values = at_equal_distances(curve, dots);
    const double middle = range.low + (range.high - range.low) / 2;
    const bool is_constant = !(range.high - range.low > 2 * least_range);
    const auto lines = draw_chart(values, range, chart, height, style);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::string at_left;
      if (is_constant) {
        if (i == lines.size() / 2) at_left = short_number(middle);
      } else if (i == 0) {
        at_left = short_number(range.high);
      } else if (i + 1 == lines.size()) {
        at_left = short_number(range.low);
      }
      const char* const axis = at_left.empty() ? signs.line : signs.tick;
      text += fmt::format("{:>{}}{}{}\n", at_left, label, axis, lines[i]);
    }
    text += fmt::format("{:{}}{}{}\n", "", label, signs.corner,
                        axis_of_places(curve, chart, signs.along));
  }
  return text;
}

std::string draw_svg(const std::vector<Curve>& curves) {
  constexpr std::size_t most_points = 4000;
  constexpr std::size_t line_of_title = 110;
  std::vector<LinePlot> plots;
  for (const Curve& curve : curves) {
    LinePlot& plot = plots.emplace_back(
        LinePlot{.title = wrapped(title_of(curve), line_of_title), .x_unit = curve.x_unit});
    plot.lines.push_back(thinned(curve, most_points / 2));
  }
  return svg_picture("Curves", {}, plots);
}

}  // namespace sbgc::tools
