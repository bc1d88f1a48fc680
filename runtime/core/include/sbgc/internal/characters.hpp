/// UTF-8 characters, and detection of those that are unsafe on a terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sbgc::detail {

/// Returns the length of the well-formed UTF-8 sequence at the start of `text`; 0 if there is none.
constexpr std::size_t utf8_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
  };
  const auto follows = [&](std::size_t i, std::uint8_t low = 0x80, std::uint8_t high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const std::uint8_t first = byte(0);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const std::uint8_t low = first == 0xE0 ? 0xA0 : 0x80;
    const std::uint8_t high = first == 0xED ? 0x9F : 0xBF;
    return follows(1, low, high) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const std::uint8_t low = first == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t high = first == 0xF4 ? 0x8F : 0xBF;
    return follows(1, low, high) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

/// Returns the code point of a well-formed UTF-8 sequence.
constexpr char32_t code_point(std::string_view sequence) noexcept {
  const std::size_t size = sequence.size();
  char32_t code = static_cast<std::uint8_t>(sequence[0]) & (0xFFU >> (size == 1 ? 1 : size + 1));
  for (const char c : sequence.substr(1))
    code = code << 6U | (static_cast<std::uint8_t>(c) & 0x3FU);
  return code;
}

/// True for a character that a terminal interprets instead of showing it: ASCII and C1 controls,
/// characters that change the direction of text, and line and paragraph separators; and for U+FFFE
/// and U+FFFF, which are noncharacters and not allowed in XML.
constexpr bool is_control(char32_t c) noexcept {
  const auto is_in = [&](char32_t first, char32_t last) { return c >= first && c <= last; };
  return c < 0x20 || is_in(0x7F, 0x9F) || c == 0x061C || is_in(0x200E, 0x200F) ||
         is_in(0x2028, 0x202E) || is_in(0x2066, 0x2069) || is_in(0xFFFE, 0xFFFF);
}

/// Writes such a character as "\u009b". All of them have at most four digits.
inline std::string escaped(char32_t c) {
  std::string result = "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) result += "0123456789abcdef"[c >> shift & 15U];
  return result;
}

/// Calls `use(sequence, is_utf8)` for each character, and for each byte of invalid UTF-8.
template <class Use>
constexpr void for_each_sequence(std::string_view text, Use&& use) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view sequence = text.substr(0, length == 0 ? 1 : length);
    use(sequence, length != 0);
    text.remove_prefix(sequence.size());
  }
}

/// Returns the text with '?' for each character that is unsafe on a terminal, except those in
/// `kept`, and for each byte that is not UTF-8.
inline std::string without_controls(std::string_view text, std::string_view kept = {}) {
  std::string result;
  for_each_sequence(text, [&](std::string_view sequence, bool is_utf8) {
    const bool is_shown = is_utf8 && (!is_control(code_point(sequence)) ||
                                      kept.find(sequence) != std::string_view::npos);
    result += is_shown ? sequence : std::string_view("?");
  });
  return result;
}

}  // namespace sbgc::detail
