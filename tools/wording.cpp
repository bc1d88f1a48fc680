#include "wording.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sbgc::tools {

std::string counted(std::uint64_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string clipped(std::string_view message) {
  constexpr std::size_t longest = 1000;
  std::string result(message.substr(0, longest));
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; };
  std::replace_if(result.begin(), result.end(), is_control, '?');
  return message.size() > longest ? result + "..." : result;
}

}  // namespace sbgc::tools
