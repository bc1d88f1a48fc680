/// Line charts over time or frequency, as SVG.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signal/chart.hpp"

namespace sbgc::tools {

struct LinePoint {
  double x{};
  double y{};  ///< NaN interrupts the line
};

/// Lines over a common range of x.
struct LinePlot {
  std::string title{};  ///< in up to two lines
  std::vector<std::vector<LinePoint>> lines{};
  std::string x_unit{};                ///< after the numbers below the plot
  bool has_log_x{};                    ///< x is above 0
  bool shows_angles{};                 ///< in degrees, with a grid of whole parts of a turn
  std::optional<ValueRange> values{};  ///< the range shown; otherwise that of its lines
  std::optional<double> mark{};        ///< a value with a dashed line
};

/// Draws the plots below each other. The names are those of the lines, which have the same color in
/// all plots; without names, there is no legend.
std::string svg_picture(const std::string& title, const std::vector<std::string>& names,
                        const std::vector<LinePlot>& plots);

}  // namespace sbgc::tools
