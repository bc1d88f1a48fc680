/// Shared code of the readers of lines of text.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sbgc::tools {

inline constexpr std::string_view blanks = " \t\r";
inline constexpr std::string_view decimal_digits = "0123456789";
inline constexpr std::string_view hex_digits = "0123456789abcdefABCDEF";
inline constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";

inline bool is_one_of(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

/// Returns the number of characters of `text` from `at` on that are in `set`.
inline std::size_t run(std::string_view text, std::size_t at, std::string_view set) {
  const std::size_t end = std::min(text.find_first_not_of(set, at), text.size());
  return end - std::min(at, end);
}

inline bool has(std::string_view text, std::size_t at, std::string_view set) {
  return at < text.size() && is_one_of(text[at], set);
}

inline std::uint64_t number_of(std::string_view digits, int base) {
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  return value;
}

inline std::uint8_t byte_of(std::string_view digits, int base = 16) {
  return static_cast<std::uint8_t>(number_of(digits, base));
}

/// Reads one character or escape inside quotes. Returns false for an unknown escape.
bool read_escape(std::string_view line, std::size_t& at, std::vector<std::uint8_t>& out);

}  // namespace sbgc::tools
