/// Numbers from text.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <sbgc/internal/parse_real.hpp>

namespace sbgc::detail {

/// Returns the number that fills the text, if any. `format` is the base, or a std::chars_format.
template <class Number, class... Format>
std::optional<Number> parse_number(std::string_view text, Format... format) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = [&] {
    if constexpr (std::is_same_v<Number, double> && sizeof...(format) == 0) {
      return parse_real(text.data(), end, number);
    } else {
      return std::from_chars(text.data(), end, number, format...);
    }
  }();
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace sbgc::detail
