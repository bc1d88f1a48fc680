/// Curves, as text and as SVG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "signal/chart.hpp"
#include "signal/line_picture.hpp"

namespace sbgc::tools {

/// One chart: values over a range of x.
struct Curve {
  std::string name{};
  std::string unit{};            ///< of the values
  std::string x_unit{};          ///< "s" or "Hz"
  std::vector<double> places{};  ///< x of the values, ascending
  std::vector<double> values{};  ///< NaN means missing
  std::string note{};            ///< shown beside the name
};

/// Draws the curves below each other, `height` lines each.
std::string draw_text(const std::vector<Curve>& curves, std::size_t width, std::size_t height,
                      ChartStyle style);

/// Returns an image of the curves.
std::string draw_svg(const std::vector<Curve>& curves);

/// Returns few points that show the same curve: the lowest and the highest one of each of the
/// `parts`, which are equally wide, in order. Missing numbers, and distances that are many times
/// the usual one, become gaps.
std::vector<LinePoint> thinned(const Curve& curve, std::size_t parts);

}  // namespace sbgc::tools
