/// Values that a page passes: settings, NAME=VALUE, and times, which are microseconds as numbers of
/// JavaScript.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include <sbgc/time.hpp>

#include "modules/exchange.hpp"

namespace sbgc::web {

inline std::string_view input_text() {
  const auto& input = tools::exchange().input;
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// Takes what precedes the separator from a text, with the separator.
inline std::string_view take_until(char separator, std::string_view& text) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

/// Calls `use(name, value)` for each part that is not empty.
template <class Use>
void for_each_setting(std::string_view text, Use&& use, char separator = '\n') {
  while (!text.empty()) {
    std::string_view value = take_until(separator, text);
    if (value.empty()) continue;
    const std::string_view name = take_until('=', value);
    use(name, value);
  }
}

inline Instant at(double us) { return {static_cast<std::int64_t>(us)}; }

/// Infinity for Instant::never.
inline double in_us(Instant time) {
  if (time == Instant::never) return std::numeric_limits<double>::infinity();
  return static_cast<double>(time.us);
}

}  // namespace sbgc::web
