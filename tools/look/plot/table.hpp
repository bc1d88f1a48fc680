/// Columns of numbers over time, from CSV as written by `sbgc stream` and `sbgc decode`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sbgc::tools {

/// A column. Cells without a number are NaN.
struct Series {
  std::string path{};  ///< such as "angle.roll"
  std::string unit{};  ///< "" if it has none
  std::vector<double> values{};
};

/// The name of the column with the clock of the samples.
inline constexpr const char* clock_path = "timestamp_ms";

/// Reads a table line by line, and keeps the time, the clock and the selected columns.
class TableReader {
 public:
  explicit TableReader(std::string patterns = "") : patterns_(std::move(patterns)) {}

  /// Adds a line without its end; the first line has the names. Throws CommandError.
  void add_line(std::string_view line);
  /// Returns the columns; the first one is the time. Throws CommandError if there are no rows.
  std::vector<Series> finish();

 private:
  void choose_columns();

  std::string patterns_;
  std::vector<Series> columns_{};
  std::vector<bool> is_kept_{};
  std::size_t lines_ = 0;
};

/// Returns the columns after the first that the patterns select: globs of whole paths, their
/// beginnings before a dot, or their ends after one, separated by commas; all without patterns.
/// Throws CommandError for a pattern that selects nothing.
std::vector<Series> chosen_series(const std::vector<Series>& columns, std::string_view patterns);

/// Equidistant values.
struct UniformSeries {
  double rate{};
  double lost_share{};
  std::vector<double> values{};  ///< empty if too many are lost
};
/// Determines the sample interval, in seconds, from the times of arrival, which may be late;
/// `clock_ms` is a clock of the samples themselves that wraps at 16 bits, or empty.
UniformSeries uniform(const std::vector<double>& times, const std::vector<double>& clock_ms,
                      const std::vector<double>& values);

}  // namespace sbgc::tools
