#include "command/wording.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/characters.hpp>

namespace sbgc::tools {

std::string counted(std::uint64_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string clipped(std::string_view message) {
  constexpr std::size_t longest = 1000;
  const std::string result = detail::without_controls(message.substr(0, longest));
  return message.size() > longest ? result + "..." : result;
}

std::string abridged(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  constexpr std::string_view gap = "...";
  const std::size_t half = (longest - gap.size()) / 2;
  return fmt::format("{}{}{}", text.substr(0, half), gap, text.substr(text.size() - half));
}

std::string printable(std::string_view text) { return detail::without_controls(text, "\n"); }

std::string quoted_for_shell(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:-+,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + '\'';
}

std::string as_message(std::string sentence) {
  constexpr std::array beginnings{"The ", "There ", "A ", "An ", "It ", "This ", "No "};
  // The standard library for WebAssembly has no std::ranges::any_of().
  const bool is_sentence =
      std::any_of(beginnings.begin(), beginnings.end(),
                  [&](const char* words) { return sentence.starts_with(words); });
  if (is_sentence) sentence.front() = static_cast<char>(sentence.front() - 'A' + 'a');
  return sentence.ends_with("..") ? sentence : without_period(std::move(sentence));
}

}  // namespace sbgc::tools
