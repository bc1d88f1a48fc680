/// Ranges of numbers on the command line.
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace sbgc::tools {

/// Accepts finite numbers from `least` to `most`. CLI::Range accepts "nan".
inline CLI::Validator number_range(double least, double most) {
  const auto check = [least, most](const std::string& text) {
    double number = 0;
    const bool is_number = CLI::detail::lexical_cast(text, number);
    const bool is_inside = is_number && number >= least && number <= most;
    return is_inside ? std::string()
                     : fmt::format("'{}' is not a number from {} to {}", text, least, most);
  };
  return {check, ""};
}

}  // namespace sbgc::tools
