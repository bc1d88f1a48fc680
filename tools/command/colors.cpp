#include "command/colors.hpp"

#include <cstdlib>

#include "command/system.hpp"

namespace sbgc::tools {

bool is_dumb_terminal() {
  const char* const term = std::getenv("TERM");
  return term != nullptr && std::string_view(term) == "dumb";
}

Colors::Colors(std::FILE* file) {
  const char* const no_color = std::getenv("NO_COLOR");
  are_on_ = is_terminal(file) && (no_color == nullptr || *no_color == '\0') && !is_dumb_terminal();
}

std::string_view Colors::begin(Color color) const {
  if (!are_on_) return "";
  switch (color) {
    case Color::bold: return "\033[1m";
    case Color::dim: return "\033[2m";
    case Color::red: return "\033[31m";
    case Color::green: return "\033[32m";
    case Color::yellow: return "\033[33m";
    case Color::cyan: return "\033[36m";
  }
  return "";
}

std::string_view Colors::end() const { return are_on_ ? "\033[0m" : ""; }

std::string Colors::operator()(Color color, std::string_view text) const {
  return std::string(begin(color)).append(text).append(end());
}

}  // namespace sbgc::tools
