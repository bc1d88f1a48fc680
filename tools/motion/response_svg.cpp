// The picture of frequency responses.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "motion/response_table.hpp"

namespace sbgc::tools {

namespace {

using analysis::ResponsePoint;

// Distinct also for the color-blind.
constexpr std::array response_colors{"#0072b2", "#d55e00", "#009e73",
                                     "#cc79a7", "#e69f00", "#56b4e9"};

constexpr double picture_width = 800;
constexpr double plot_left = 60;
constexpr double plot_right = picture_width - 20;
constexpr double plot_height = 200;
constexpr double plot_gap = 50;
constexpr double plot_top = 30;
constexpr double legend_line = 18;

struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Where a value is, from 0 to 1.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// One of the plots, below each other.
struct Plot {
  const char* title;
  std::function<std::optional<double>(const ResponsePoint&)> value;
  AxisRange range{};
  double step{};  ///< between two lines of the grid
  double top{};
};

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      default: result += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    }
  }
  return result;
}

/// A round distance of lines, at most six in the range: 1, 2 or 5 times a power of ten, or degrees.
double round_step(double size, bool is_angle) {
  constexpr double most_lines = 6;
  if (is_angle) {
    for (const double step : {5.0, 15.0, 45.0, 90.0, 180.0}) {
      if (size / step <= most_lines) return step;
    }
    return 360 * std::ceil(size / 360 / most_lines);
  }
  const double power = std::pow(10, std::floor(std::log10(size / most_lines)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (size / (factor * power) <= most_lines) return factor * power;
  }
  return 10 * power;
}

/// Extends a range to the lines of its grid.
void round_range(Plot& plot, bool is_angle) {
  if (!(plot.range.low <= plot.range.high)) plot.range = {0, 1};
  const double size = std::max(plot.range.high - plot.range.low, 1e-3);
  plot.step = round_step(size, is_angle);
  plot.range.low = std::floor(plot.range.low / plot.step) * plot.step;
  plot.range.high = std::ceil(plot.range.high / plot.step) * plot.step;
  if (plot.range.low == plot.range.high) plot.range.high += plot.step;
}

class Picture {
 public:
  explicit Picture(const std::vector<NamedResponse>& responses) : responses_(responses) {
    for (const NamedResponse& one : responses) {
      for (const ResponsePoint& point : one.response.points) frequencies_.include(point.frequency);
    }
    if (!(frequencies_.low < frequencies_.high)) {
      frequencies_ = {
          frequencies_.low > 0 && std::isfinite(frequencies_.low) ? frequencies_.low / 2 : 1,
          std::isfinite(frequencies_.high) ? frequencies_.high * 2 : 100};
    }
  }

  std::string draw() {
    double top = plot_top + legend_line * static_cast<double>(responses_.size());
    for (Plot& plot : plots_) {
      for (const NamedResponse& one : responses_) {
        for (const ResponsePoint& point : one.response.points) {
          if (const auto value = plot.value(point)) plot.range.include(*value);
        }
      }
      const bool is_coherence = &plot == &plots_.back();
      if (is_coherence) plot.range = {0, 1};
      round_range(plot, &plot == &plots_[1]);
      plot.top = top;
      top += plot_height + plot_gap;
    }
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n"
        "<title>Frequency response</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        picture_width, top);
    for (std::size_t i = 0; i < responses_.size(); ++i) add_legend(i);
    for (const Plot& plot : plots_) {
      add_grid(plot);
      for (std::size_t i = 0; i < responses_.size(); ++i) add_line(plot, i);
    }
    add("</svg>\n");
    return std::move(text_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  double x(double frequency) const {
    const AxisRange logs{std::log10(frequencies_.low), std::log10(frequencies_.high)};
    return plot_left + (plot_right - plot_left) * logs.share(std::log10(frequency));
  }
  static double y(const Plot& plot, double value) {
    return plot.top + plot_height * (1 - plot.range.share(value));
  }
  static const char* color(std::size_t response) {
    return response_colors[response % response_colors.size()];
  }

  void add_legend(std::size_t response) {
    const double middle = plot_top - 10 + legend_line * static_cast<double>(response);
    add("<path d=\"M{0:.0f} {1:.1f}h24\" stroke=\"{2}\" stroke-width=\"2\"/>"
        "<text x=\"{3:.0f}\" y=\"{4:.1f}\">{5}</text>\n",
        plot_left, middle - 4, color(response), plot_left + 32, middle,
        xml_text(responses_[response].name));
  }

  void add_grid(const Plot& plot) {
    add("<text x=\"{:.0f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n<g stroke=\"#ddd\">\n",
        plot_left, plot.top - 6, plot.title);
    std::string labels;
    const auto to = std::back_inserter(labels);
    const auto lines =
        static_cast<int>(std::lround((plot.range.high - plot.range.low) / plot.step));
    for (int i = 0; i <= lines; ++i) {
      const double value = plot.range.low + i * plot.step;
      const double at = y(plot, value);
      add("<path d=\"M{:.0f} {:.1f}H{:.0f}\"/>\n", plot_left, at, plot_right);
      fmt::format_to(to, "<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.4g}</text>\n",
                     plot_left - 6, at + 4, value + 0.0);
    }
    for (const double decade : {0.1, 1.0, 10.0, 100.0}) {
      for (int digit = 1; digit < 10; ++digit) {
        const double frequency = decade * digit;
        if (frequency < frequencies_.low || frequency > frequencies_.high) continue;
        const double at = x(frequency);
        add("<path d=\"M{:.1f} {:.1f}v{:.0f}\"/>\n", at, plot.top, plot_height);
        if (digit > 5) continue;
        fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:g}</text>\n",
                       at, plot.top + plot_height + 16, frequency);
      }
    }
    add("</g>\n<g>\n{}</g>\n", labels);
  }

  /// A line that is interrupted where there is no value.
  void add_line(const Plot& plot, std::size_t response) {
    std::string path;
    bool is_down = false;
    for (const ResponsePoint& point : responses_[response].response.points) {
      const auto value = plot.value(point);
      const bool is_value = value && std::isfinite(*value);
      if (is_value) {
        fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", is_down ? 'L' : 'M',
                       x(point.frequency), y(plot, *value));
      }
      is_down = is_value;
    }
    if (path.empty()) return;
    add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path,
        color(response));
  }

  const std::vector<NamedResponse>& responses_;
  AxisRange frequencies_{};
  std::array<Plot, 3> plots_{
      Plot{"Gain in dB", [](const ResponsePoint& point) { return std::optional(point.gain); }},
      Plot{"Phase in degrees",
           [](const ResponsePoint& point) { return std::optional(point.phase); }},
      Plot{"Coherence, over the frequency in Hz",
           [](const ResponsePoint& point) { return point.coherence; }}};
  std::string text_{};
};

}  // namespace

std::string response_svg(const std::vector<NamedResponse>& responses) {
  return Picture(responses).draw();
}

}  // namespace sbgc::tools
