/// The pages of the monitor.
#pragma once

#include <cstddef>
#include <string>

#include <sbgc/client/statistics.hpp>

#include "look/monitor/gimbal_state.hpp"
#include "look/monitor/screen.hpp"

namespace sbgc::tools {

enum class Page : unsigned char { overview, charts, values, line };
inline constexpr std::size_t page_count = 4;

/// The line to the gimbal.
struct LineInfo {
  std::string board{};  ///< "3.0, firmware 2.59"
  std::string description{};
  ClientStatistics statistics{};
  std::uint64_t connections{};
  std::chrono::seconds open{};  ///< since the connection was made or lost
};

/// The choices of the user.
struct View {
  Page page = Page::overview;
  bool is_paused = false;
  std::optional<PerAxis> zero{};  ///< angles are shown relative to these
  std::size_t scroll = 0;         ///< first line of a long page
  bool shows_keys = false;
  bool is_recording = false;
  std::string message{};  ///< in place of the keys in the last row
  std::chrono::steady_clock::time_point message_end{};
};

/// Draws the whole screen. Limits `view.scroll` to the existing lines.
void draw(Screen& screen, View& view, const GimbalSnapshot& gimbal, const LineInfo& line);

}  // namespace sbgc::tools
