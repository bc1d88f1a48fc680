#include "board/progress_bar.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

ProgressBar::ProgressBar(std::string unit)
    : is_on_(is_terminal(stderr) && !is_dumb_terminal()), unit_(std::move(unit)) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() const {
  if (is_on_) show_status("");
}

void ProgressBar::show(const Progress& progress) const {
  constexpr std::size_t width = 30;
  const std::size_t total = std::max<std::size_t>(progress.total, 1);
  const std::size_t filled = std::min(progress.done * width / total, width);
  std::string line = "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] ";
  if (unit_.empty()) {
    line += fmt::format("{}/{}  {}", progress.done, progress.total, progress.what);
  } else {
    line += fmt::format("{}/{} {}", progress.done, progress.total, unit_);
  }
  show(line);
}

void ProgressBar::show(std::string_view text) const {
  if (!is_on_) return;
  show_status(printable(text.substr(0, line_width(stderr) - 1)));
}

ProgressHandler ProgressBar::handler() const {
  return [this](const Progress& progress) {
    show(progress);
    return !was_interrupted();
  };
}

}  // namespace sbgc::tools
