/// Remarks on standard error.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

/// Prints like fmt::print(stderr, ...), but ignores errors: a terminal that is gone must not keep a
/// command from stopping the camera.
template <class... Args>
void remark(fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(fmt::format(format, std::forward<Args>(args)...).c_str(), stderr);
}

}  // namespace sbgc::tools
