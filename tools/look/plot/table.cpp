#include "look/plot/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include <sbgc/analysis/uniform_samples.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "signal/chart.hpp"
#include "values/field_patterns.hpp"

namespace sbgc::tools {

namespace {

/// Splits a line at its commas; quoted cells may contain commas.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const bool is_doubled = is_quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (is_doubled) {
        cells.back() += line[++i];
      } else {
        is_quoted = !is_quoted;
      }
    } else if (line[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

/// Splits "angle.roll[deg]" into path and unit.
Series named(std::string cell) {
  const std::size_t bracket = cell.find('[');
  if (bracket == std::string::npos || cell.back() != ']') return {std::move(cell), "", {}};
  // An index such as rc[2] is not a unit.
  const std::string inside = cell.substr(bracket + 1, cell.size() - bracket - 2);
  if (sbgc::detail::parse_number<unsigned>(inside)) return {std::move(cell), "", {}};
  const std::size_t unit = cell.rfind('[');
  return {cell.substr(0, unit), cell.substr(unit + 1, cell.size() - unit - 2), {}};
}

bool chooses(std::string_view pattern, const std::string& path) {
  return matches_glob(pattern, path) || path.starts_with(std::string(pattern) + '.') ||
         path.ends_with('.' + std::string(pattern));
}

/// Unwraps a clock, in seconds.
std::vector<double> unwrapped(const std::vector<double>& clock_ms) {
  std::vector<double> seconds;
  double turns = 0;
  for (std::size_t i = 0; i < clock_ms.size(); ++i) {
    constexpr double turn = 65536;
    if (i != 0 && clock_ms[i] < clock_ms[i - 1]) turns += turn;
    seconds.push_back((clock_ms[i] + turns) * 1e-3);
  }
  return seconds;
}

/// Returns the distance of samples. If most have the usual one, the others are rounded to a
/// multiple of it; otherwise the times of arrival vary, and the mean distance is used.
double distance_of(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  const double mean = (times.back() - times.front()) / static_cast<double>(steps.size());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double usual = *middle;
  constexpr double near = 0.2;  // also for a clock that counts milliseconds
  const auto is_usual = [&](double step) { return std::abs(step - usual) <= near * usual; };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(steps, is_usual));
  if (!(usual > 0) || 4 * count < 3 * steps.size()) return mean;
  double total = 0;
  for (const double step : steps) total += std::max(1.0, std::round(step / usual));
  return (times.back() - times.front()) / total;
}

/// Returns which columns after the first the patterns select. Throws CommandError.
std::vector<bool> choice_of(const std::vector<Series>& columns, std::string_view patterns) {
  std::vector<bool> is_chosen(columns.size(), patterns.empty());
  is_chosen.front() = false;
  while (!patterns.empty()) {
    const std::size_t comma = std::min(patterns.find(','), patterns.size());
    const std::string_view pattern = patterns.substr(0, comma);
    bool is_found = false;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      if (!chooses(pattern, columns[i].path)) continue;
      is_found = true;
      is_chosen[i] = true;
    }
    if (!is_found) {
      std::string names;
      for (std::size_t i = 1; i < columns.size(); ++i) {
        names += (i == 1 ? "" : ", ") + columns[i].path;
      }
      throw CommandError(clipped(fmt::format("no column is '{}'; there are {}", pattern, names)),
                         wrong_usage);
    }
    patterns.remove_prefix(std::min(comma + 1, patterns.size()));
  }
  return is_chosen;
}

}  // namespace

void TableReader::choose_columns() {
  is_kept_ = choice_of(columns_, patterns_);
  constexpr std::ptrdiff_t most = 500;
  const std::ptrdiff_t count = std::ranges::count(is_kept_, true);
  if (count > most) {
    std::string some;
    for (std::size_t i = 0, named = 0; named < 3; ++i) {
      if (!is_kept_[i]) continue;
      some += columns_[i].path + ", ";
      ++named;
    }
    throw CommandError(clipped(fmt::format("the table has {} curves, more than {}; FIELDS chooses "
                                           "some of them: {}...",
                                           count, most, some)),
                       wrong_usage);
  }
  is_kept_.front() = true;
  for (std::size_t i = 1; i < columns_.size(); ++i) {
    if (columns_[i].path == clock_path) is_kept_[i] = true;
  }
}

void TableReader::add_line(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.find('\0') != std::string_view::npos) {
    throw CommandError(
        "this is no table in CSV; `sbgc decode --format csv CAPTURE` makes one of a capture");
  }
  ++lines_;
  std::vector<std::string> cells = cells_of(line);
  if (lines_ == 1) {
    for (std::string& cell : cells) columns_.push_back(named(std::move(cell)));
    return choose_columns();
  }
  if (cells.size() != columns_.size()) {
    throw CommandError(fmt::format("line {} of the table has {} instead of {}", lines_,
                                   counted(cells.size(), "column"), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_kept_[i]) continue;
    const auto number = sbgc::detail::parse_number<double>(cells[i]);
    const bool is_shown = number && is_drawable(*number);
    columns_[i].values.push_back(is_shown ? *number : std::numeric_limits<double>::quiet_NaN());
  }
}

std::vector<Series> TableReader::finish() {
  if (columns_.size() < 2 || columns_.front().values.size() < 2) {
    throw CommandError("the table has no two rows with a time and a value");
  }
  const std::vector<double>& times = columns_.front().values;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_after = i == 0 || times[i] >= times[i - 1];
    constexpr double most = 1e20;  // more than the nanoseconds since 1970; also not for NaN
    if (!(std::abs(times[i]) < most) || !is_after) {
      throw CommandError(fmt::format("line {}: the first column, '{}', is not a time that grows",
                                     i + 2, columns_.front().path));
    }
  }
  std::vector<Series> kept;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (is_kept_[i]) kept.push_back(std::move(columns_[i]));
  }
  return kept;
}

std::vector<Series> chosen_series(const std::vector<Series>& columns, std::string_view patterns) {
  const std::vector<bool> is_chosen = choice_of(columns, patterns);
  std::vector<Series> result;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const auto is_number = [](double value) { return !std::isnan(value); };
    if (is_chosen[i] && std::ranges::any_of(columns[i].values, is_number)) {
      result.push_back(columns[i]);
    }
  }
  return result;
}

UniformSeries uniform(const std::vector<double>& times, const std::vector<double>& clock_ms,
                      const std::vector<double>& values) {
  const bool has_clock =
      !clock_ms.empty() && std::ranges::none_of(clock_ms, [](double one) { return !(one >= 0); });
  const std::vector<double> at = has_clock ? unwrapped(clock_ms) : times;
  const double distance = at.size() < 2 ? 0 : distance_of(at);
  if (!(distance > 0) || !std::isfinite(distance)) return {};
  // A sample is never early: of several at the same time, the earlier ones are late.
  std::vector<std::int64_t> numbers(at.size());
  for (std::size_t i = at.size(); i-- > 0;) {
    constexpr double most = 1e15;  // an integer can hold it; more is a gap, anyway
    const double steps = std::min((at[i] - at.front()) / distance, most);
    const auto number = static_cast<std::int64_t>(std::llround(steps));
    numbers[i] = i + 1 < at.size() ? std::min(number, numbers[i + 1] - 1) : number;
  }
  analysis::UniformSamples samples(distance);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!std::isnan(values[i])) samples.add(numbers[i], {values[i], 0, 0});
  }
  UniformSeries result{1 / distance, samples.lost_share(), {}};
  if (samples.is_usable()) result.values = samples.axis(0);
  return result;
}

}  // namespace sbgc::tools
