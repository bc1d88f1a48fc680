#include "monitor/pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sbgc/meta/realtime.hpp>

#include "frames/value_rows.hpp"
#include "monitor/chart.hpp"
#include "motion/axis_values.hpp"

namespace sbgc::tools {

namespace {

constexpr std::array<const char*, page_count> page_names{"Overview", "Charts", "Values", "Line"};
constexpr std::size_t first_row = 3;  // below the title and the names of the pages

ChartStyle style_of(const Screen& screen) {
  return screen.has_utf8() ? ChartStyle::braille : ChartStyle::ascii;
}

std::string number(double value, int decimals, const char* unit) {
  if (std::isnan(value)) return "-";
  return fmt::format("{:.{}f}{}{}", value, decimals, *unit == '\0' ? "" : " ", unit);
}

/// Returns the text, or its beginning if it is longer than `size`.
std::string cut(std::string_view text, std::size_t size) {
  if (text.size() <= size) return std::string(text);
  return std::string(text.substr(0, size - 3)) + "...";
}

std::string duration(std::chrono::seconds time) { return fmt::format("{:%H:%M:%S}", time); }

double relative(const View& view, double angle, std::size_t axis) {
  return view.zero ? angle - (*view.zero)[axis] : angle;
}

void draw_frame(Screen& screen, const View& view, const GimbalSnapshot& gimbal,
                const LineInfo& line) {
  screen.fill(0, Style::title);
  screen.put(0, 1, "sbgc monitor  board " + line.board, Style::title);
  std::string state = gimbal.is_connected ? "connected " + duration(line.open) : "NOT CONNECTED";
  if (view.is_paused) state = "PAUSED  " + state;
  const std::size_t width = screen.width();
  if (state.size() + 2 < width) {
    screen.put(0, width - state.size() - 2, ' ' + state + ' ', Style::title);
  }
  std::size_t column = 1;
  for (std::size_t i = 0; i < page_names.size(); ++i) {
    const bool is_chosen = static_cast<std::size_t>(view.page) == i;
    const std::string name = fmt::format(" {} {} ", i + 1, page_names[i]);
    screen.put(1, column, name, is_chosen ? Style::title : Style::dim);
    column += name.size() + 1;
  }
  screen.put(screen.height() - 1, 1,
             "1-4, Tab: page   p: pause   z: zero   arrows: scroll   q: quit", Style::dim);
}

/// Draws a row of the table of axes. Returns the column after it.
void draw_axis(Screen& screen, std::size_t row, std::size_t axis, const View& view,
               const GimbalSnapshot& gimbal) {
  const LiveValues& values = gimbal.values;
  const double angle = values.angle[axis];
  const double target = values.target[axis];
  screen.put(row, 2, axis_names[axis], Style::bold);
  screen.put(row, 9, fmt::format("{:>9.2f}", relative(view, angle, axis)), Style::accent);
  screen.put(row, 19, fmt::format("{:>9.2f}", relative(view, target, axis)));
  screen.put(row, 29, fmt::format("{:>9.2f}", angle - target));
  screen.put(row, 39, fmt::format("{:>9}", number(values.joint[axis], 2, "")));
  const double share = values.power[axis];
  const std::size_t bar = std::clamp<std::size_t>(screen.width() - 60, 8, 40);
  screen.put(row, 51, draw_bar(share, bar, style_of(screen)),
             share > 0.8 ? Style::bad : Style::good);
  screen.put(row, 51 + bar + 1, fmt::format("{:>3.0f} %", share * 100));
}

void draw_overview(Screen& screen, const View& view, const GimbalSnapshot& gimbal) {
  const LiveValues& values = gimbal.values;
  std::size_t row = first_row;
  screen.put(row++, 9, "    angle    target deviation     joint   motor power", Style::dim);
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    draw_axis(screen, row++, axis, view, gimbal);
  }
  screen.put(
      row++, 9,
      fmt::format("degrees{}; {}", view.zero ? ", relative to the zero" : "", directions_text()),
      Style::dim);
  screen.put(row, 2, "motors", Style::bold);
  screen.put(row, 12, values.motors_on ? "ON" : "off", values.motors_on ? Style::good : Style::dim);
  screen.put(row, 19, "battery", Style::bold);
  screen.put(row, 28, number(values.battery, 2, "V"));
  screen.put(row, 38, "current", Style::bold);
  screen.put(row, 47, number(values.current, 0, "mA"));
  screen.put(row, 58, "IMU", Style::bold);
  screen.put(row++, 63, number(values.temperature, 0, "degC"));
  screen.put(row, 2, "profile", Style::bold);
  screen.put(row, 12, std::to_string(values.profile));
  screen.put(row, 19, "cycle", Style::bold);
  screen.put(row, 28, number(values.cycle_us, 0, "us"));
  screen.put(row, 38, "I2C errors", Style::bold);
  screen.put(row, 50, std::to_string(values.i2c_errors));
  screen.put(row, 58, "serial errors", Style::bold);
  screen.put(row++, 73, std::to_string(values.serial_errors));
  screen.put(row, 2, "errors", Style::bold);
  if (values.errors.empty()) screen.put(row++, 12, "none", Style::good);
  for (const ValueInfo* const error : values.errors) {
    screen.put(row++, 12, fmt::format("{}: {}", error->name, error->summary), Style::bad);
  }
  if (!values.sub_error.empty()) {
    screen.put(row++, 12, "emergency stop: " + values.sub_error, Style::bad);
  }
  if (!values.task.empty()) screen.put(row++, 12, "running: " + values.task, Style::accent);
  ++row;
  // The rest: a small chart of each axis, side by side with its range.
  const std::size_t end = screen.height() - 1;
  const std::size_t space = end > row ? end - row : 0;
  const std::size_t height = space / axis_names.size();
  if (height == 0 || screen.width() < 40) return;
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    constexpr double least = 0.5;  // degrees
    const std::vector<double> angles = gimbal.angles[axis].values();
    const ValueRange range = range_of(angles, least);
    const auto lines = draw_chart(angles, range, screen.width() - 22, height, style_of(screen));
    screen.put(row, 2, axis_names[axis], Style::bold);
    screen.put(row, 8, fmt::format("{:>9.2f}", relative(view, range.high, axis)), Style::dim);
    if (height > 1) {
      screen.put(row + height - 1, 8, fmt::format("{:>9.2f}", relative(view, range.low, axis)),
                 Style::dim);
    }
    for (const std::string& chart_line : lines) screen.put(row++, 19, chart_line, Style::accent);
  }
}

struct Chart {
  const char* name{};
  const char* unit{};
  const History* history{};
  double least{};  ///< the narrowest range, so that noise does not fill a chart
  double scale = 1;
  double shift = 0;
};

void draw_charts(Screen& screen, const View& view, const GimbalSnapshot& gimbal) {
  const auto shift = [&](std::size_t axis) { return relative(view, 0, axis); };
  const std::array charts{
      Chart{"roll", "deg", gimbal.angles.data(), 0.5, 1, shift(0)},
      Chart{"pitch", "deg", &gimbal.angles[1], 0.5, 1, shift(1)},
      Chart{"yaw", "deg", &gimbal.angles[2], 0.5, 1, shift(2)},
      Chart{"roll power", "%", gimbal.powers.data(), 10, 100},
      Chart{"pitch power", "%", &gimbal.powers[1], 10, 100},
      Chart{"yaw power", "%", &gimbal.powers[2], 10, 100},
      Chart{"battery", "V", &gimbal.battery, 0.5},
      Chart{"current", "mA", &gimbal.current, 100},
  };
  // As many columns as are wide enough to read.
  constexpr std::size_t narrowest = 36;
  const std::size_t columns = std::clamp<std::size_t>(screen.width() / narrowest, 1, 4);
  const std::size_t rows = (charts.size() + columns - 1) / columns;
  const std::size_t end = screen.height() - 1;
  const std::size_t height = end > first_row ? (end - first_row) / rows : 0;
  const std::size_t width = screen.width() / columns;
  if (height < 2) return;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const Chart& chart = charts[i];
    std::vector<double> values = chart.history->values();
    for (double& value : values) value = value * chart.scale + chart.shift;
    const ValueRange range = range_of(values, chart.least);
    const std::size_t top = first_row + i / columns * height;
    const std::size_t left = i % columns * width + 1;
    const double last = values.empty() ? std::nan("") : values.back();
    screen.put(top, left, chart.name, Style::bold);
    constexpr std::size_t behind_name = 12;
    const std::string now = number(last, 2, chart.unit);
    screen.put(top, left + behind_name, now, Style::accent);
    const int decimals = range.high - range.low < 10 ? 2 : 0;
    const std::string text =
        fmt::format("{:.{}f} to {:.{}f}", range.low, decimals, range.high, decimals);
    if (behind_name + now.size() + text.size() + 4 <= width) {
      screen.put(top, left + width - text.size() - 3, text, Style::dim);
    }
    const auto lines = draw_chart(values, range, width - 3, height - 1, style_of(screen));
    for (std::size_t y = 0; y < lines.size(); ++y) screen.put(top + 1 + y, left, lines[y]);
  }
}

/// Limits the scrolling to the lines there are. Returns the number of lines that fit.
std::size_t limit_scroll(const Screen& screen, View& view, std::size_t lines) {
  const std::size_t end = screen.height() - 1;
  const std::size_t space = end > first_row ? end - first_row : 0;
  view.scroll = std::min(view.scroll, lines > space ? lines - space : 0);
  return space;
}

void draw_values(Screen& screen, View& view, const GimbalSnapshot& gimbal) {
  if (!gimbal.message) return;
  ValueRows values;
  std::visit([&](const auto& message) { values.assign(message, newest, newest); }, *gimbal.message);
  const Rows rows = values.rows();
  const auto count = static_cast<std::size_t>(rows.end() - rows.begin());
  const std::size_t columns = std::max<std::size_t>(screen.width() / 66, 1);
  const std::size_t lines = (count + columns - 1) / columns;
  const std::size_t space = limit_scroll(screen, view, lines);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t line = i % lines;
    if (line < view.scroll || line >= view.scroll + space) continue;
    const Row& row = rows.begin()[static_cast<std::ptrdiff_t>(i)];
    const std::size_t top = first_row + line - view.scroll;
    const std::size_t left = i / lines * 66 + 1;
    screen.put(top, left, row.path.text());
    screen.put(top, left + 26, fmt::format("{:>10}", rows.raw(row)), Style::dim);
    screen.put(top, left + 38, cut(rows.meaning(row), 27), Style::accent);
  }
}

void draw_line(Screen& screen, View& view, const GimbalSnapshot& gimbal, const LineInfo& line) {
  const SessionStatistics& session = line.statistics.session;
  const StreamUsage& streams = line.statistics.streams;
  std::size_t row = first_row;
  const auto put = [&](const char* name, const std::string& text) {
    screen.put(row, 2, name, Style::bold);
    screen.put(row++, 20, text);
  };
  put("line", line.description);
  put(gimbal.is_connected ? "connected" : "NOT CONNECTED",
      fmt::format("{}, connection {}", duration(line.open), line.connections));
  put("framing", to_string(session.framing));
  put("received",
      fmt::format("{} frames, {:.1f} per second of live data", session.parser.frames, gimbal.rate));
  put("noise",
      fmt::format("{} bytes skipped, {} bad headers, {} bad bodies", session.parser.skipped_bytes,
                  session.parser.header_errors, session.parser.body_errors));
  const LineQuality quality = line_quality(session);
  put("damaged", fmt::format("{:.2g} % of frames; about {:.2g} % are wrong without notice",
                             100 * quality.damaged, 100 * quality.undetected));
  put("sent", fmt::format("{} frames, {} bytes", session.sent_frames, session.sent_bytes));
  put("without response", fmt::format("{} attempts, {} repeated, {} late responses",
                                      session.timeouts, session.retries, session.late_replies));
  put("board", fmt::format("{} errors, {} restarts", session.board_errors, session.resets));
  put("streams", !gimbal.is_connected ? "-"
                 : streams.limit == 0
                     ? fmt::format("{} bytes per second", streams.used)
                     : fmt::format("{} of {} bytes per second", streams.used, streams.limit));
  ++row;
  screen.put(row++, 2, "events", Style::bold);
  const std::size_t end = screen.height() - 1;
  const std::size_t space = end > row ? end - row : 0;
  view.scroll = std::min(view.scroll, gimbal.log.size() > space ? gimbal.log.size() - space : 0);
  // The newest first.
  for (std::size_t i = view.scroll; i < gimbal.log.size() && row < end; ++i) {
    const LogEntry& entry = gimbal.log[gimbal.log.size() - 1 - i];
    const std::time_t time = std::chrono::system_clock::to_time_t(entry.time);
    screen.put(row, 2, fmt::format("{:%H:%M:%S}", fmt::localtime(time)), Style::dim);
    screen.put(row++, 12, cut(entry.text, screen.width() - 13));
  }
}

}  // namespace

void draw(Screen& screen, View& view, const GimbalSnapshot& gimbal, const LineInfo& line) {
  screen.clear();
  screen.set_faint(false);
  constexpr std::size_t least_height = 8;
  constexpr std::size_t least_width = 40;
  if (screen.height() < least_height || screen.width() < least_width) {
    screen.put(0, 0, "The terminal is");
    screen.put(1, 0, fmt::format("too small: {} x {}", least_width, least_height));
    screen.put(2, 0, "is the least.");
    return screen.show();
  }
  draw_frame(screen, view, gimbal, line);
  screen.set_faint(!gimbal.is_connected && view.page != Page::line);
  if (!gimbal.message) screen.put(first_row, 2, "waiting for live data", Style::dim);
  switch (view.page) {
    case Page::overview:
      if (gimbal.message) draw_overview(screen, view, gimbal);
      break;
    case Page::charts: draw_charts(screen, view, gimbal); break;
    case Page::values: draw_values(screen, view, gimbal); break;
    case Page::line: draw_line(screen, view, gimbal, line); break;
  }
  screen.show();
}

}  // namespace sbgc::tools
