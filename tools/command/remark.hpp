/// Remarks on standard error.
#pragma once

#include <atomic>
#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "command/wording.hpp"

namespace sbgc::tools {

/// Writes remarks. By default, it waits for the reader; remark_in_background() changes that.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): as standard error is
inline std::atomic<void (*)(const std::string& text)> remark_writer{
    [](const std::string& text) { std::fputs(text.c_str(), stderr); }};

/// The line below the remarks on a terminal; empty if there is none.
struct StatusLine {
  std::mutex mutex{};
  std::string text{};
};
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): as standard error is
inline StatusLine status_line;

/// Erases the line of the terminal that the cursor is in.
inline constexpr const char* erase_line = "\r\033[K";

/// Replaces the line below the remarks of a terminal; "" removes it.
inline void show_status(const std::string& text) {
  const std::lock_guard lock(status_line.mutex);
  if (text.empty() && status_line.text.empty()) return;
  status_line.text = text;
  remark_writer.load()(erase_line + text);
}

/// Prints text that may control the terminal. Ignores errors: a terminal that is gone must not keep
/// a command from stopping the camera.
inline void remark_as_is(const std::string& text) {
  const std::lock_guard lock(status_line.mutex);
  std::string& status = status_line.text;
  if (status.empty()) return remark_writer.load()(text);
  if (!text.ends_with('\n')) status.clear();  // it has no line of its own any more
  remark_writer.load()(erase_line + text + status);
}

/// Returns what a message of the command, "sbgc: ...", is on standard error: on a terminal, its
/// lines are wrapped between words.
std::string message_text(std::string text);

/// Prints like fmt::print(stderr, ...) what printable() makes of it; otherwise as remark_as_is().
template <class... Args>
void remark(fmt::format_string<Args...> format, Args&&... args) {
  remark_as_is(message_text(printable(fmt::format(format, std::forward<Args>(args)...))));
}

/// Prints "sbgc: " and a problem, then the advice as lines of their own. With colors, "sbgc:" is
/// bold and red; what the text proposes, and the commands in it, are green.
void remark_failure(const std::string& problem, const std::string& advice = "");
/// The same for something that does not end the command: "sbgc: warning: ", of which the first two
/// words are yellow.
void remark_warning(const std::string& problem);

}  // namespace sbgc::tools
