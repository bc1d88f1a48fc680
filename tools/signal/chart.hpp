/// Charts of values over time, as lines of text.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sbgc::tools {

/// False for infinite values and for values so large that adding a few of them overflows.
inline bool is_drawable(double value) { return std::abs(value) <= 1e300; }

/// The characters of a chart: Braille dots need UTF-8.
enum class ChartStyle : unsigned char { braille, ascii };

/// The lowest and the highest value.
struct ValueRange {
  double low{};
  double high{};

  bool operator==(const ValueRange&) const = default;
};

/// Returns the range of the values, at least `least` wide, around their middle; [0, least] without
/// values.
ValueRange range_of_values(std::span<const double> values, double least);

/// Draws the last values, the newest at the right end, in `height` lines of `width` characters. A
/// Braille character shows two values. Values outside the range are drawn at its edge; NaN is
/// omitted.
std::vector<std::string> draw_chart(std::span<const double> values, ValueRange range,
                                    std::size_t width, std::size_t height, ChartStyle style);

/// Returns a bar of `width` characters, filled to `share` (0 to 1).
std::string draw_bar(double share, std::size_t width, ChartStyle style);

}  // namespace sbgc::tools
