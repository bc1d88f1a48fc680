/// Remarks on standard error.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "command/wording.hpp"

namespace sbgc::tools {

/// Prints text that may control the terminal. Ignores errors: a terminal that is gone must not keep
/// a command from stopping the camera.
inline void remark_as_is(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// Prints like fmt::print(stderr, ...) what printable() makes of it; otherwise as remark_as_is().
template <class... Args>
void remark(fmt::format_string<Args...> format, Args&&... args) {
  remark_as_is(printable(fmt::format(format, std::forward<Args>(args)...)));
}

}  // namespace sbgc::tools
