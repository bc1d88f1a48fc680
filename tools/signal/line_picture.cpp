#include "signal/line_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

// Distinguishable for the color-blind, too.
constexpr std::array line_colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

// An image follows the colors of its surroundings. A point and its values are shown under the
// mouse.
constexpr const char* style =
    "<style>\n"
    ":root { color-scheme: light dark; --paper: #fff; --ink: #222; --grid: #ddd; --axis: #888 }\n"
    "@media (prefers-color-scheme: dark) {\n"
    "  :root { --paper: #16181d; --ink: #ddd; --grid: #363a42; --axis: #888 }\n"
    "}\n"
    ".paper { fill: var(--paper) } text { fill: var(--ink) }\n"
    ".grid { stroke: var(--grid) } .axis { stroke: var(--axis) }\n"
    ".mark { stroke: var(--axis); stroke-dasharray: 4 3 }\n"
    ".points circle { opacity: 0 } .points circle:hover { opacity: 1 }\n"
    "</style>\n";

// The layout of an image, in pixels.
constexpr double picture_width = 800;
constexpr double plot_left = 70;
constexpr double plot_right = picture_width - 30;
constexpr double plot_height = 200;
constexpr double plot_gap = 76;
constexpr double plot_top = 36;
constexpr double legend_line = 18;

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      default: result += c;
    }
  }
  return result;
}

/// The range of the drawable numbers that were included, starting at `low`.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!is_drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Returns the relative position of a value, from 0 to 1.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// Returns a round distance of grid lines, at most `most` in the range: 1, 2 or 5 times a power of
/// ten, or degrees.
double round_step(double size, bool is_angle, double most) {
  if (is_angle) {
    for (const double step : {5.0, 15.0, 45.0, 90.0, 180.0}) {
      if (size / step <= most) return step;
    }
    return 360 * std::ceil(size / 360 / most);
  }
  const double power = std::pow(10, std::floor(std::log10(size / most)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (size / (factor * power) <= most) return factor * power;
  }
  return 10 * power;
}

class Picture {
 public:
  Picture(const std::vector<std::string>& names, const std::vector<LinePlot>& plots)
      : names_(names), plots_(plots) {}

  std::string draw(const std::string& title) {
    double top = plot_top + legend_line * static_cast<double>(names_.size());
    const double height = top + (plot_height + plot_gap) * static_cast<double>(plots_.size());
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"12\" role=\"img\">\n"
        "<title>{2}</title>\n<desc>{3}</desc>\n{4}<rect width=\"100%\" height=\"100%\" "
        "class=\"paper\"/>\n",
        picture_width, height, xml_text(title), xml_text(description()), style);
    for (std::size_t i = 0; i < names_.size(); ++i) add_legend(i);
    for (const LinePlot& plot : plots_) {
      add_plot(plot, top);
      top += plot_height + plot_gap;
    }
    add("</svg>\n");
    return std::move(text_);
  }

 private:
  /// Describes the image in words: what each line shows, with its range.
  std::string description() const {
    std::string words;
    for (const LinePlot& plot : plots_) {
      for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        AxisRange values;
        for (const LinePoint& point : plot.lines[i]) values.include(point.y);
        if (values.low > values.high) continue;
        words += fmt::format("{}{}{}: {:.4g} to {:.4g}. ", i < names_.size() ? names_[i] : "",
                             i < names_.size() ? ", " : "", plot.title, values.low, values.high);
      }
    }
    return words;
  }

  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }
  void add_text(double x, double y, const char* anchor, std::string_view words) {
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
        xml_text(words));
  }
  /// Adds the title, with its last line at `y`.
  void add_title(std::string_view title, double y) {
    constexpr double line = 14;
    y -= line * static_cast<double>(std::ranges::count(title, '\n'));
    for (;; y += line) {
      const std::size_t end = title.find('\n');
      add_text(plot_left, y, "start", title.substr(0, end));
      if (end == std::string_view::npos) return;
      title.remove_prefix(end + 1);
    }
  }
  static const char* color(std::size_t line) { return line_colors[line % line_colors.size()]; }

  void add_legend(std::size_t line) {
    const double middle = plot_top - 10 + legend_line * static_cast<double>(line);
    add("<line x1=\"{0:.0f}\" y1=\"{1:.1f}\" x2=\"{2:.0f}\" y2=\"{1:.1f}\" stroke=\"{3}\" "
        "stroke-width=\"2\"/>\n",
        plot_left, middle - 4, plot_left + 24, color(line));
    add_text(plot_left + 32, middle, "start", names_[line]);
  }

  void add_plot(const LinePlot& plot, double top) {
    measure(plot, top);
    add_title(plot.title, top - 6);
    const double lines = std::round((values_.high - values_.low) / step_);
    for (int i = 0; i <= lines; ++i) {
      const double value = values_.low + i * step_;
      add_line_of("grid", plot_left, y(value), plot_right, y(value));
      const double shown = std::abs(value) < step_ / 2 ? 0 : value;
      add_text(plot_left - 6, y(value) + 4, "end", fmt::format("{:.4g}", shown));
    }
    add_places(plot);
    add_line_of("axis", plot_left, top, plot_left, top + plot_height);
    add_line_of("axis", plot_left, top + plot_height, plot_right, top + plot_height);
    if (values_.low < 0 && values_.high > 0) add_line_of("axis", plot_left, y(0), plot_right, y(0));
    if (plot.mark) add_line_of("mark", plot_left, y(*plot.mark), plot_right, y(*plot.mark));
    for (std::size_t i = 0; i < plot.lines.size(); ++i) add_line(plot, i);
  }

  /// Prepares x() and y(). The range of values extends to its grid lines.
  void measure(const LinePlot& plot, double top) {
    top_ = top;
    has_log_x_ = plot.has_log_x;
    places_ = values_ = {};
    for (const auto& line : plot.lines) {
      for (const LinePoint& point : line) {
        places_.include(point.x);
        values_.include(point.y);
      }
    }
    if (plot.values) values_ = {plot.values->low, plot.values->high};
    if (values_.low > values_.high) values_ = {0, 1};
    if (places_.low > places_.high) places_ = {1, 100};
    if (values_.low == values_.high) values_ = {values_.low - 0.5, values_.high + 0.5};
    constexpr double most_lines = 6;
    const double least = std::max(1e-9, 1e-3 * std::abs(values_.high));
    step_ = round_step(std::max(values_.high - values_.low, least), plot.shows_angles, most_lines);
    values_.low = std::floor(values_.low / step_) * step_;
    values_.high = std::ceil(values_.high / step_) * step_;
    if (values_.low == values_.high) values_.high += step_;
  }
  double x(double place) const {
    const double width = plot_right - plot_left;
    if (!has_log_x_) return plot_left + width * places_.share(place);
    const AxisRange logs{std::log10(places_.low), std::log10(places_.high)};
    return plot_left + width * logs.share(std::log10(place));
  }
  double y(double value) const { return top_ + plot_height * (1 - values_.share(value)); }

  void add_line_of(const char* kind, double x1, double y1, double x2, double y2) {
    add("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x1, y1,
        x2, y2, kind);
  }
  void add_place(double place, bool is_labeled) {
    if (place < places_.low || place > places_.high) return;
    add_line_of("grid", x(place), top_, x(place), top_ + plot_height);
    if (is_labeled)
      add_text(x(place), top_ + plot_height + 16, "middle", fmt::format("{:.4g}", place));
  }

  /// Adds grid lines at round values: for a logarithmic scale, at the digits of each power of ten.
  void add_places(const LinePlot& plot) {
    const std::string_view quantity = plot.x_unit == "Hz"  ? "frequency in "
                                      : plot.x_unit == "s" ? "time in "
                                                           : "";
    add_text((plot_left + plot_right) / 2, top_ + plot_height + 34, "middle",
             fmt::format("{}{}", quantity, plot.x_unit));
    if (has_log_x_) {
      constexpr int last_labeled = 5;
      for (double power = std::pow(10, std::floor(std::log10(places_.low))); power <= places_.high;
           power *= 10) {
        for (int digit = 1; digit < 10; ++digit) {
          add_place(power * digit, digit <= last_labeled);
        }
      }
      return;
    }
    constexpr double most_lines = 10;
    const double least = std::max(1e-9, 1e-9 * std::abs(places_.high));
    const double step = round_step(std::max(places_.high - places_.low, least), false, most_lines);
    const double first = std::ceil(places_.low / step);
    for (int i = 0; i <= most_lines; ++i) add_place((first + i) * step, true);
  }

  void add_line(const LinePlot& plot, std::size_t line) {
    const std::vector<LinePoint>& points = plot.lines[line];
    std::string path;
    bool is_down = false;
    for (const LinePoint& point : points) {
      const bool is_number = is_drawable(point.x) && is_drawable(point.y);
      if (is_number) {
        fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", is_down ? 'L' : 'M', x(point.x),
                       y(point.y));
      }
      is_down = is_number;
    }
    if (path.empty()) return;
    add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, color(line));
    // Enough points to read values under the mouse.
    constexpr std::size_t most_points = 200;
    const std::size_t step = points.size() / most_points + 1;
    add("<g class=\"points\" fill=\"{}\">\n", color(line));
    for (std::size_t i = 0; i < points.size(); i += step) {
      const LinePoint& point = points[i];
      if (!is_drawable(point.x) || !is_drawable(point.y)) continue;
      add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{:.4g} {}: {:.4g}</title></circle>\n",
          x(point.x), y(point.y), point.x, xml_text(plot.x_unit), point.y);
    }
    add("</g>\n");
  }

  const std::vector<std::string>& names_;
  const std::vector<LinePlot>& plots_;
  std::string text_{};

  // The plot that is being drawn
  AxisRange places_{}, values_{};
  double step_{};  ///< between two grid lines of the values
  double top_{};
  bool has_log_x_{};
};

}  // namespace

std::string svg_picture(const std::string& title, const std::vector<std::string>& names,
                        const std::vector<LinePlot>& plots) {
  return Picture(names, plots).draw(title);
}

}  // namespace sbgc::tools
