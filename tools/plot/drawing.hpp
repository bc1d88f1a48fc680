/// Curves, as text and as SVG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "signal/chart.hpp"

namespace sbgc::tools {

/// One chart: values over a range of x.
struct Curve {
  std::string name{};
  std::string unit{};    ///< of the values
  std::string x_unit{};  ///< "s" or "Hz"
  double first_x{}, last_x{};
  std::vector<double> values{};  ///< at equal distances; NaN draws nothing
  std::string note{};            ///< shown beside the name
};

/// Draws the curves below each other, `height` lines each.
std::string draw_text(const std::vector<Curve>& curves, std::size_t width, std::size_t height,
                      ChartStyle style);

/// Returns a picture of the curves.
std::string draw_svg(const std::vector<Curve>& curves);

/// Returns at most `count` values that show the same curve: the lowest and the highest of each
/// part, in their order.
std::vector<double> thinned(const std::vector<double>& values, std::size_t count);

}  // namespace sbgc::tools
