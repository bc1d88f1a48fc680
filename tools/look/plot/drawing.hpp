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
  std::vector<double> places{};  ///< where the values are, ascending
  std::vector<double> values{};  ///< NaN is none
  std::string note{};            ///< shown beside the name
};

/// Draws the curves below each other, `height` lines each.
std::string draw_text(const std::vector<Curve>& curves, std::size_t width, std::size_t height,
                      ChartStyle style);

/// Returns a picture of the curves.
std::string draw_svg(const std::vector<Curve>& curves);

/// Returns few points that show the same curve: the lowest and the highest one of each of the
/// `parts`, which are equally wide, in their order. A point without a number is a gap: nothing is
/// drawn over a distance of many usual ones.
std::vector<LinePoint> thinned(const Curve& curve, std::size_t parts);

}  // namespace sbgc::tools
