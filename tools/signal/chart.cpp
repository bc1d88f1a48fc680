#include "signal/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sbgc::tools {

namespace {

/// A grid of dots. Each character holds `columns` by `rows` of them.
class Dots {
 public:
  Dots(std::size_t width, std::size_t height) : width_(width), cells_(width * height) {}

  void set(std::size_t cell_x, std::size_t cell_y, unsigned bits) {
    cells_[cell_y * width_ + cell_x] |= static_cast<std::uint8_t>(bits);
  }
  std::uint8_t at(std::size_t x, std::size_t y) const { return cells_[y * width_ + x]; }

 private:
  std::size_t width_;
  std::vector<std::uint8_t> cells_;
};

/// The eight dots of a Braille character, by column and row, as bits of its code point.
constexpr std::array<std::array<unsigned, 4>, 2> braille_bits{
    {{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}}};

void append_braille(std::string& line, std::uint8_t dots) {
  if (dots == 0) {
    line += ' ';
    return;
  }
  constexpr unsigned first = 0x2800;
  const unsigned code = first + dots;
  line += static_cast<char>(0xE0U | code >> 12U);
  line += static_cast<char>(0x80U | (code >> 6U & 0x3FU));
  line += static_cast<char>(0x80U | (code & 0x3FU));
}

/// Returns the row, from the top, at which a value is drawn.
std::size_t row_of(double value, ValueRange range, std::size_t rows) {
  const double part = (value - range.low) / (range.high - range.low);
  const double share = std::isfinite(part) ? part : 0.5;  // for an invalid range
  const double from_top = (1 - std::clamp(share, 0.0, 1.0)) * static_cast<double>(rows - 1);
  return static_cast<std::size_t>(std::lround(from_top));
}

}  // namespace

ValueRange range_of_values(std::span<const double> values, double least) {
  ValueRange range{std::nan(""), std::nan("")};
  for (const double value : values) {
    if (!is_drawable(value)) continue;
    range.low = std::fmin(range.low, value);
    range.high = std::fmax(range.high, value);
  }
  if (std::isnan(range.low)) return {0, least};
  const double missing = least - (range.high - range.low);
  if (missing > 0) range = {range.low - missing / 2, range.high + missing / 2};
  return range;
}

std::vector<std::string> draw_chart(std::span<const double> values, ValueRange range,
                                    std::size_t width, std::size_t height, ChartStyle style) {
  if (width == 0 || height == 0) return {};
  const bool is_braille = style == ChartStyle::braille;
  const std::size_t columns = is_braille ? 2 : 1;
  const std::size_t rows = is_braille ? 4 : 1;
  const std::size_t shown = std::min(values.size(), width * columns);
  const auto last = values.last(shown);
  Dots dots(width, height);
  std::size_t previous = 0;
  for (std::size_t i = 0; i < shown; ++i) {
    if (std::isnan(last[i])) continue;
    const std::size_t x = width * columns - shown + i;
    const std::size_t y = row_of(last[i], range, height * rows);
    // A line to the previous value, so that jumps remain visible.
    const bool has_previous = i != 0 && !std::isnan(last[i - 1]);
    const std::size_t from = has_previous && previous < y ? previous + 1 : y;
    const std::size_t to = has_previous && previous > y ? previous - 1 : y;
    for (std::size_t at = from; at <= to; ++at) {
      const unsigned bits = is_braille ? braille_bits[x % 2][at % 4] : 1U;
      dots.set(x / columns, at / rows, bits);
    }
    previous = y;
  }
  std::vector<std::string> lines(height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (is_braille) {
        append_braille(lines[y], dots.at(x, y));
      } else {
        lines[y] += dots.at(x, y) != 0 ? '*' : ' ';
      }
    }
  }
  return lines;
}

std::string draw_bar(double share, std::size_t width, ChartStyle style) {
  const double clamped = std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(std::lround(clamped * static_cast<double>(width)));
  const bool is_ascii = style == ChartStyle::ascii;
  std::string result;
  for (std::size_t i = 0; i < width; ++i) {
    if (i < filled) {
      result += is_ascii ? "#" : "█";
    } else {
      result += is_ascii ? "." : "░";
    }
  }
  return result;
}

}  // namespace sbgc::tools
