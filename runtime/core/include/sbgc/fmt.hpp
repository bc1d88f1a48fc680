/// A {fmt} formatter for every type that <sbgc/text.hpp> prints: fmt::print("{}\n", angles). Width,
/// fill and alignment work as for strings. Includes the tables of all messages; requires {fmt}.
#pragma once

#include <string>

#include <fmt/format.h>

#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

template <class T>
  requires sbgc::is_printable<T>
struct fmt::formatter<T> : fmt::formatter<fmt::string_view> {
  template <class Context>
  auto format(const T& value, Context& context) const {
    using sbgc::to_string;
    const std::string text = to_string(value);
    return fmt::formatter<fmt::string_view>::format(text, context);
  }
};
