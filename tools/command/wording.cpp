#include "command/wording.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <sbgc/detail/is_control.hpp>

namespace sbgc::tools {

std::string counted(std::uint64_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string clipped(std::string_view message) {
  constexpr std::size_t longest = 1000;
  std::string result(message.substr(0, longest));
  std::replace_if(result.begin(), result.end(), detail::is_control, '?');
  return message.size() > longest ? result + "..." : result;
}

std::string printable(std::string text) {
  constexpr char c1_lead = '\xC2';  // in UTF-8, before 80 to 9F
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_c1 = i > 0 && text[i - 1] == c1_lead && static_cast<std::uint8_t>(text[i]) < 0xA0;
    if (is_c1) text[i - 1] = '?';
    if (is_c1 || (detail::is_control(text[i]) && text[i] != '\n')) text[i] = '?';
  }
  return text;
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
