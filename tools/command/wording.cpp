#include "command/wording.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include <sbgc/detail/is_control.hpp>
#include <sbgc/json/values.hpp>

namespace sbgc::tools {

std::string counted(std::uint64_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string clipped(std::string_view message) {
  constexpr std::size_t longest = 1000;
  std::string result = printable(std::string(message.substr(0, longest)));
  std::ranges::replace(result, '\n', '?');
  return message.size() > longest ? result + "..." : result;
}

std::string printable(const std::string& text) {
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = detail::utf8_length(rest);
    const bool is_c1 =
        length == 2 && rest[0] == '\xC2' && static_cast<std::uint8_t>(rest[1]) < 0xA0;
    const bool is_line_break = rest[0] == '\n';
    if (length == 0 || is_c1 || (detail::is_control(rest[0]) && !is_line_break)) {
      result += '?';
    } else {
      result += rest.substr(0, length);
    }
    rest.remove_prefix(std::max(length, std::size_t{1}));
  }
  return result;
}

std::string as_message(std::string sentence) {
  constexpr std::array beginnings{"The ", "There ", "A ", "An ", "It ", "This ", "No "};
  const bool is_sentence = std::ranges::any_of(
      beginnings, [&](const char* words) { return sentence.starts_with(words); });
  if (is_sentence) sentence.front() = static_cast<char>(sentence.front() - 'A' + 'a');
  return sentence.ends_with("..") ? sentence : without_period(std::move(sentence));
}

std::string without_period(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

}  // namespace sbgc::tools
