/// Exchanges texts and bytes between a page and the module: the page calls input() for a buffer,
/// fills it, calls a function, and reads output(). Many texts consist of NAME=VALUE settings.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#if defined(__wasm__)
#define SBGC_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else  // for tools that only parse a file
#define SBGC_EXPORT(name) extern "C"
#endif

namespace sbgc::tools {

/// The buffers of the functions that a page calls, one at a time.
struct Exchange {
  std::vector<std::uint8_t> input;
  std::string output;
};

Exchange& exchange();

}  // namespace sbgc::tools

namespace sbgc::web {

inline std::string_view input_text() {
  const auto& input = tools::exchange().input;
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// Returns the text before the separator, and removes both from `text`.
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

}  // namespace sbgc::web
