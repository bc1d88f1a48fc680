/// Colored text.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace sbgc::tools {

enum class Color : unsigned char { bold, dim, red, green, yellow, cyan };

/// True if TERM is "dumb": the terminal obeys no escape sequences.
bool is_dumb_terminal();

/// Colors text for one file, if it is a terminal and the environment variable NO_COLOR is unset or
/// empty.
class Colors {
 public:
  /// No colors.
  Colors() = default;
  explicit Colors(std::FILE* file);

  bool are_on() const noexcept { return are_on_; }
  std::string operator()(Color color, std::string_view text) const;
  /// The escape sequence that begins a color; "" without colors.
  std::string_view begin(Color color) const;
  std::string_view end() const;

 private:
  bool are_on_ = false;
};

}  // namespace sbgc::tools
