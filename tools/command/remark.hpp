/// Remarks on standard error.
#pragma once

#include <atomic>
#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "command/wording.hpp"

namespace sbgc::tools {

/// Writes remarks. By default, it waits for the reader; remark_in_background() changes that.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): as standard error is
inline std::atomic<void (*)(const std::string& text)> remark_writer{
    [](const std::string& text) { std::fputs(text.c_str(), stderr); }};

/// Prints text that may control the terminal. Ignores errors: a terminal that is gone must not keep
/// a command from stopping the camera.
inline void remark_as_is(const std::string& text) { remark_writer.load()(text); }

/// Prints like fmt::print(stderr, ...) what printable() makes of it; otherwise as remark_as_is().
template <class... Args>
void remark(fmt::format_string<Args...> format, Args&&... args) {
  remark_as_is(printable(fmt::format(format, std::forward<Args>(args)...)));
}

}  // namespace sbgc::tools
