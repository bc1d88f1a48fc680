/// Parts of the text of an argument.
#pragma once

#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace sbgc::serving {

/// Throws std::invalid_argument.
[[noreturn]] inline void refuse(const std::string& text, const char* wanted) {
  throw std::invalid_argument(fmt::format("'{}' is not {}", text, wanted));
}

/// Parses an unsigned number that fills the text and is at most `most`.
template <class Number>
bool read(std::string_view text, Number most, Number& number) {
  const char* const end = text.data() + text.size();
  if (text.empty() || text.front() == '-') return false;
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stopped == end && number <= most;  // false for NaN
}

/// The texts before and after the separator.
struct Halves {
  std::string_view first;
  std::string_view second;
};

inline Halves split(std::string_view text, char separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + 1)};
}

}  // namespace sbgc::serving
