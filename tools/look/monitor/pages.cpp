#include "look/monitor/pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <sstream>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sbgc/meta/realtime.hpp>

#include "command/terminal_text.hpp"
#include "frames/value_rows.hpp"
#include "signal/chart.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

constexpr std::array<const char*, page_count> page_names{"Overview", "Charts", "Values", "Line"};

/// Returns the first row of a page: below the title, the names of the pages and, in a high
/// terminal, an empty row.
std::size_t first_row(const Screen& screen) { return screen.height() < 16 ? 2 : 3; }

/// Returns the row after the last one of a page: the row of the keys.
std::size_t end_row(const Screen& screen) { return screen.height() - 1; }

/// The visible part of a long page.
struct Window {
  std::size_t begin{};
  std::size_t end{};
  std::size_t all{};
};

/// Limits the scrolling to the existing lines.
Window window_of(View& view, std::size_t all, std::size_t space) {
  view.scroll = std::min(view.scroll, all > space ? all - space : 0);
  return {view.scroll, std::min(all, view.scroll + space), all};
}

/// Returns, for example, "1-20 of 60"; "" if everything is shown.
std::string place_text(const Window& window, bool has_utf8) {
  if (window.end - window.begin == window.all) return "";
  return fmt::format("{}{}{} of {}", window.begin + 1, has_utf8 ? "\u2013" : "-", window.end,
                     window.all);
}

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

void draw_title(Screen& screen, const View& view, const GimbalSnapshot& gimbal,
                const LineInfo& line) {
  const std::size_t width = screen.width();
  std::string marks = view.is_recording ? "REC  " : "";
  if (view.is_paused) marks += "PAUSED  ";
  std::string state =
      marks + (gimbal.is_connected ? "connected " + duration(line.open) : "NOT CONNECTED");
  std::string title = line.board;
  if (title.size() + state.size() + 4 > width && gimbal.is_connected) {
    state = marks + duration(line.open);
  }
  for (const char* const before : {"board ", "sbgc monitor  board "}) {
    const std::string longer = before + line.board;
    if (longer.size() + state.size() + 4 <= width) title = longer;
  }
  screen.fill(0, Style::title);
  screen.put(0, 1, title, Style::title);
  if (state.size() + 2 < width) {
    screen.put(0, width - state.size() - 2, ' ' + state + ' ', Style::title);
  }
}

void draw_page_names(Screen& screen, const View& view) {
  constexpr std::size_t wide = 48;  // with spaces around the names
  std::size_t column = 1;
  for (std::size_t i = 0; i < page_names.size(); ++i) {
    const bool is_chosen = static_cast<std::size_t>(view.page) == i && !view.shows_keys;
    const char* const format = screen.width() < wide ? "{} {}" : " {} {} ";
    const std::string name = fmt::format(fmt::runtime(format), i + 1, page_names[i]);
    screen.put(1, column, name, is_chosen ? Style::title : Style::dim);
    column += name.size() + 1;
  }
}

/// Draws the last row: a message, or as many keys as fit; and the position in a list.
void draw_last_row(Screen& screen, const View& view, const std::string& place, std::size_t size) {
  const std::size_t row = end_row(screen);
  screen.fill(row, Style::normal);
  if (size != 0) screen.put(row, screen.width() - size - 1, place, Style::bold);
  const std::size_t room = screen.width() - 2 - (size == 0 ? 0 : size + 2);
  if (!view.message.empty()) return screen.put(row, 1, cut(view.message, room), Style::accent);
  const std::string last = "?: keys   q: quit";
  std::string keys;
  for (const char* const one : {"1-4, Tab: page", "p: pause", "z: zero", "r: record", "m: mark"}) {
    const std::string longer = keys + one + "   ";
    if (longer.size() + last.size() > room) break;
    keys = longer;
  }
  screen.put(row, 1, keys + last, Style::dim);
}

/// A paragraph with a name.
struct NamedText {
  std::string name{};
  std::string text{};
};

Window draw_texts(Screen& screen, View& view, const std::vector<NamedText>& texts,
                  std::size_t column) {
  std::vector<NamedText> lines;
  for (const NamedText& one : texts) {
    std::istringstream wrapped_text(wrapped(one.text, screen.width() - column - 1));
    std::string name = one.name;
    std::string line;
    do {
      std::getline(wrapped_text, line);
      lines.push_back({std::exchange(name, ""), line});
    } while (wrapped_text.peek() != std::istringstream::traits_type::eof());
  }
  std::size_t row = first_row(screen);
  const Window window = window_of(view, lines.size(), end_row(screen) - row);
  for (std::size_t i = window.begin; i < window.end; ++i, ++row) {
    screen.put(row, 2, lines[i].name, Style::bold);
    screen.put(row, column, lines[i].text);
  }
  return window;
}

Window draw_keys(Screen& screen, View& view) {
  return draw_texts(screen, view,
                    {{"1 to 4", "choose the page"},
                     {"Tab, arrows", "next page, page before"},
                     {"up, down", "scroll, also page up, page down, Home"},
                     {"p, space", "pause the display"},
                     {"z", "show angles relative to the present ones, or not"},
                     {"r", "record to a file in this folder that is named by the time, or end it"},
                     {"m", "mark the moment in that file"},
                     {"?", "these keys"},
                     {"q", "quit"}},
                    15);
}

/// The columns of the overview for an axis, from the left; a narrow screen omits those of high
/// rank.
struct AxisColumn {
  const char* name{};
  unsigned rank{};
  std::string (*text)(const View& view, const LiveValues& values, std::size_t axis){};
};
constexpr std::array<AxisColumn, 7> axis_columns{{
    {"angle", 0,
     [](const View& view, const LiveValues& values, std::size_t axis) {
       return fmt::format("{:.2f}", relative(view, values.angle[axis], axis));
     }},
    {"target", 2,
     [](const View& view, const LiveValues& values, std::size_t axis) {
       return fmt::format("{:.2f}", relative(view, values.target[axis], axis));
     }},
    {"deviation", 3,
     [](const View&, const LiveValues& values, std::size_t axis) {
       return fmt::format("{:.2f}", values.angle[axis] - values.target[axis]);
     }},
    {"vibration", 4,
     [](const View&, const LiveValues& values, std::size_t axis) {
       return number(values.vibration[axis], 2, "");
     }},
    {"joint", 5,
     [](const View&, const LiveValues& values, std::size_t axis) {
       return number(values.joint[axis], 2, "");
     }},
    {"balance", 1,
     [](const View&, const LiveValues& values, std::size_t axis) {
       return number(values.balance[axis], 0, "%");
     }},
    {"power", 6,
     [](const View&, const LiveValues& values, std::size_t axis) {
       return fmt::format("{:.0f} %", values.power[axis] * 100);
     }},
}};

/// With at least this width, the overview has an additional column.
constexpr std::size_t wide_screen = 100;

/// Draws a row for each axis, and returns the row after them.
std::size_t draw_axes(Screen& screen, std::size_t row, const View& view, const LiveValues& values) {
  constexpr std::size_t begin = 8;
  constexpr std::size_t column_width = 10;
  constexpr std::size_t least_bar = 8;
  constexpr std::size_t behind_bar = 8;
  const std::size_t before_bar = screen.width() < wide_screen ? 5 : 6;
  const std::size_t bar_begin = begin + before_bar * column_width + 3;
  const bool has_bar = screen.width() >= bar_begin + least_bar + behind_bar;
  const std::size_t fitting = has_bar ? before_bar : (screen.width() - begin - 1) / column_width;
  std::size_t end = begin;
  for (const AxisColumn& column : axis_columns) {
    if (column.rank >= fitting) continue;
    end += column_width;
    const auto put = [&](std::size_t at, const std::string& text, Style style) {
      screen.put(row + at, end - text.size(), text, style);
    };
    put(0, column.name, Style::dim);
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      put(axis + 1, column.text(view, values, axis),
          column.rank == 0 ? Style::accent : Style::normal);
    }
  }
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    screen.put(row + axis + 1, 2, axis_names[axis], Style::bold);
  }
  if (has_bar) {
    screen.put(row, bar_begin, "motor power", Style::dim);
    const std::size_t size = std::min<std::size_t>(screen.width() - bar_begin - behind_bar, 40);
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      const double share = values.power[axis];
      screen.put(row + axis + 1, bar_begin, draw_bar(share, size, style_of(screen)),
                 share > 0.8 ? Style::bad : Style::good);
      screen.put(row + axis + 1, bar_begin + size + 1, fmt::format("{:>3.0f} %", share * 100));
    }
  }
  return row + 1 + axis_names.size();
}

/// Draws the values without an axis, in rows before `end`; returns the row after them.
std::size_t draw_facts(Screen& screen, std::size_t row, std::size_t end, const LiveValues& values) {
  struct Fact {
    const char* name{};
    std::string text{};
    Style style = Style::normal;
  };
  const std::array<Fact, 8> facts{{
      {"motors", values.motors_on ? "ON" : "off", values.motors_on ? Style::good : Style::dim},
      {"battery", number(values.battery, 2, "V")},
      {"current", number(values.current, 0, "mA")},
      {"IMU", number(values.temperature, 0, "degC")},
      {"profile", std::to_string(values.profile)},
      {"cycle", number(values.cycle_us, 0, "us")},
      {"I2C errors", std::to_string(values.i2c_errors)},
      {"serial errors", std::to_string(values.serial_errors)},
  }};
  constexpr std::size_t cell = 19;
  const std::size_t in_row = std::max<std::size_t>((screen.width() - 2) / cell, 1);
  for (std::size_t i = 0; i < facts.size() && row + i / in_row < end; ++i) {
    const Fact& fact = facts[i];
    const std::size_t column = 2 + i % in_row * cell;
    screen.put(row + i / in_row, column, fact.name, Style::bold);
    const std::size_t name_size = std::max<std::size_t>(std::string_view(fact.name).size() + 1, 10);
    screen.put(row + i / in_row, column + name_size, fact.text, fact.style);
  }
  return std::min(row + (facts.size() + in_row - 1) / in_row, end);
}

std::string vibration_unit(const LiveValues& values, bool is_wide) {
  if (!is_wide || !(values.fastest_vibration > 0)) return ", vibration in deg/s";
  return fmt::format(", vibration in deg/s from {:.0f} to {:.0f} Hz", values.slowest_vibration,
                     values.fastest_vibration);
}

/// Returns the time span that a chart of this width shows, such as "last 8 s".
std::string span_of(const GimbalSnapshot& gimbal, const Screen& screen, std::size_t width) {
  if (!(gimbal.rate > 0)) return "";
  const std::size_t dots = width * (style_of(screen) == ChartStyle::braille ? 2 : 1);
  return fmt::format("last {:.0f} s", static_cast<double>(dots) / gimbal.rate);
}

void draw_overview(Screen& screen, const View& view, const GimbalSnapshot& gimbal) {
  const LiveValues& values = gimbal.values;
  const std::size_t end = end_row(screen);
  const bool is_high = first_row(screen) == 3;
  std::size_t row = draw_axes(screen, first_row(screen), view, values);
  if (is_high) {
    std::string units = fmt::format("degrees{}{}", view.zero ? ", relative to the zero" : "",
                                    vibration_unit(values, screen.width() >= wide_screen));
    const std::string directions = "; " + directions_text();
    if (2 + units.size() + directions.size() <= screen.width()) units += directions;
    screen.put(row++, 9 + units.size() <= screen.width() ? 9 : 2, units, Style::dim);
  }
  row = draw_facts(screen, row, end - 1, values);
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
  // The rest: a small chart of each axis, next to its range.
  const std::size_t space = end > row ? end - row : 0;
  const std::size_t height = space / axis_names.size();
  if (height == 0) return;
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    constexpr double least = 0.5;  // degrees
    const std::vector<double> angles = gimbal.angles[axis].values();
    const ValueRange range = range_of_values(angles, least);
    const auto lines = draw_chart(angles, range, screen.width() - 22, height, style_of(screen));
    screen.put(row, 2, axis_names[axis], Style::bold);
    screen.put(row, 8, fmt::format("{:>9.2f}", relative(view, range.high, axis)), Style::dim);
    if (height > 1) {
      screen.put(row + height - 1, 8, fmt::format("{:>9.2f}", relative(view, range.low, axis)),
                 Style::dim);
    }
    if (height > 2)
      screen.put(row + 1, 2, span_of(gimbal, screen, screen.width() - 22), Style::dim);
    const bool is_ascii = style_of(screen) == ChartStyle::ascii;
    for (const std::string& chart_line : lines) {
      screen.put(row, 18, is_ascii ? "|" : "│", Style::dim);
      screen.put(row++, 19, chart_line, Style::accent);
    }
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

Window draw_charts(Screen& screen, View& view, const GimbalSnapshot& gimbal) {
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
  // Only as many columns as are wide enough to read.
  constexpr std::size_t narrowest = 36;
  const std::size_t columns = std::clamp<std::size_t>(screen.width() / narrowest, 1, 4);
  const std::size_t rows = (charts.size() + columns - 1) / columns;
  constexpr std::size_t least_height = 2;
  const std::size_t space = end_row(screen) - first_row(screen);
  const Window window = window_of(view, rows, std::min(space / least_height, rows));
  const std::size_t height = space / (window.end - window.begin);
  const std::size_t width = screen.width() / columns;
  const std::size_t end = std::min(window.end * columns, charts.size());
  for (std::size_t i = window.begin * columns; i < end; ++i) {
    const Chart& chart = charts[i];
    std::vector<double> values = chart.history->values();
    for (double& value : values) value = value * chart.scale + chart.shift;
    const ValueRange range = range_of_values(values, chart.least);
    const std::size_t top = first_row(screen) + (i / columns - window.begin) * height;
    const std::size_t left = i % columns * width + 1;
    const double last = values.empty() ? std::nan("") : values.back();
    screen.put(top, left, chart.name, Style::bold);
    constexpr std::size_t behind_name = 12;
    const std::string now = number(last, 2, chart.unit);
    screen.put(top, left + behind_name, now, Style::accent);
    const int decimals = range.high - range.low < 10 ? 2 : 0;
    std::string text = fmt::format("{:.{}f} to {:.{}f}", range.low, decimals, range.high, decimals);
    const std::string span = ", " + span_of(gimbal, screen, width - 3);
    if (behind_name + now.size() + text.size() + span.size() + 4 <= width) text += span;
    if (behind_name + now.size() + text.size() + 4 <= width) {
      screen.put(top, left + width - text.size() - 3, text, Style::dim);
    }
    const auto lines = draw_chart(values, range, width - 3, height - 1, style_of(screen));
    for (std::size_t y = 0; y < lines.size(); ++y) screen.put(top + 1 + y, left, lines[y]);
  }
  return {window.begin * columns, end, charts.size()};
}

Window draw_values(Screen& screen, View& view, const GimbalSnapshot& gimbal) {
  if (!gimbal.message) return {};
  ValueRows values;
  std::visit(
      [&]<class M>(const M& message) {
        values.assign(AnyMessage(*find_message(Meta<M>::info.name), &message), newest, newest);
      },
      *gimbal.message);
  const Rows rows = values.rows();
  constexpr std::size_t column_width = 66;
  const auto count = static_cast<std::size_t>(rows.end() - rows.begin());
  const std::size_t columns = std::max<std::size_t>(screen.width() / column_width, 1);
  const std::size_t lines = (count + columns - 1) / columns;
  const Window window = window_of(view, lines, end_row(screen) - first_row(screen));
  std::size_t path_width = 0;
  for (const Row& row : rows) path_width = std::max(path_width, row.path.text().size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t line = i % lines;
    if (line < window.begin || line >= window.end) continue;
    const Row& row = rows.begin()[static_cast<std::ptrdiff_t>(i)];
    const std::size_t top = first_row(screen) + line - window.begin;
    const std::size_t left = i / lines * column_width + 1;
    const auto raw = fmt::format("{}", rows.raw(row));
    const auto meaning = fmt::format("{}", rows.meaning(row));
    screen.put(top, left, row.path.text());
    if (screen.width() < column_width) {  // there is only room for one of them
      const std::size_t column = left + path_width + 2;
      const std::size_t room = screen.width() - std::min(column, screen.width());
      screen.put(top, column, cut(meaning.empty() ? raw : meaning, room), Style::accent);
      continue;
    }
    screen.put(top, left + 26, fmt::format("{:>10}", raw), Style::dim);
    screen.put(top, left + 38, cut(meaning, 27), Style::accent);
  }
  return window;
}

Window draw_line(Screen& screen, View& view, const GimbalSnapshot& gimbal, const LineInfo& line) {
  const SessionStatistics& session = line.statistics.session;
  const StreamUsage& streams = line.statistics.streams;
  const LineQuality quality = line_quality(session);
  std::vector<NamedText> texts{
      {"line", line.description},
      {gimbal.is_connected ? "connected" : "NOT CONNECTED",
       fmt::format("{}, connection {}", duration(line.open), line.connections)},
      {"framing", to_string(session.framing)},
      {"received", fmt::format("{} frames, {:.1f} per second of live data", session.parser.frames,
                               gimbal.rate)},
      {"noise",
       fmt::format("{} bytes skipped, {} bad headers, {} bad bodies", session.parser.skipped_bytes,
                   session.parser.header_errors, session.parser.body_errors)},
      {"damaged", fmt::format("{:.2g} % of frames; about {:.2g} % are wrong without notice",
                              100 * quality.damaged, 100 * quality.undetected)},
      {"sent", fmt::format("{} frames, {} bytes", session.sent_frames, session.sent_bytes)},
      {"without response", fmt::format("{} attempts, {} repeated, {} late responses",
                                       session.timeouts, session.retries, session.late_replies)},
      {"board", fmt::format("{} errors, {} restarts", session.board_errors, session.resets)},
      {"streams", !gimbal.is_connected ? "-"
                  : streams.limit == 0
                      ? fmt::format("{} bytes per second", streams.used)
                      : fmt::format("{} of {} bytes per second", streams.used, streams.limit)},
      {},
      {"events", gimbal.log.empty() ? "none" : ""}};
  // The newest first.
  // NOLINTNEXTLINE(modernize-loop-convert): clang 14 cannot compile std::views::reverse
  for (auto entry = gimbal.log.rbegin(); entry != gimbal.log.rend(); ++entry) {
    const std::time_t time = std::chrono::system_clock::to_time_t(entry->time);
    texts.push_back({fmt::format("{:%H:%M:%S}", fmt::localtime(time)), entry->text});
  }
  return draw_texts(screen, view, texts, 20);
}

/// Draws the page, and returns the visible part of a longer one.
Window draw_page(Screen& screen, View& view, const GimbalSnapshot& gimbal, const LineInfo& line) {
  if (view.shows_keys) return draw_keys(screen, view);
  if (view.page == Page::line) return draw_line(screen, view, gimbal, line);
  if (!gimbal.message) screen.put(first_row(screen), 2, "waiting for live data", Style::dim);
  if (view.page == Page::charts) return draw_charts(screen, view, gimbal);
  if (view.page == Page::values) return draw_values(screen, view, gimbal);
  if (gimbal.message) draw_overview(screen, view, gimbal);
  return {};
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
  draw_title(screen, view, gimbal, line);
  draw_page_names(screen, view);
  screen.set_faint(!gimbal.is_connected && view.page != Page::line && !view.shows_keys);
  const Window window = draw_page(screen, view, gimbal, line);
  screen.set_faint(false);
  const std::string place = place_text(window, screen.has_utf8());
  const std::size_t bytes_of_dash = screen.has_utf8() ? 3 : 1;
  draw_last_row(screen, view, place, place.empty() ? 0 : place.size() - bytes_of_dash + 1);
  screen.show();
}

}  // namespace sbgc::tools
