/// Values of options: durations such as "500ms", "1.5s", "2m", "1h" (seconds without a unit),
/// words, ranges of numbers, and rates.
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace sbgc::tools {

/// Parses a number and a unit: ms, s, m or h; without one, seconds. Returns nothing unless the
/// duration is a whole number of milliseconds from 1 ms to 1000 h.
std::optional<std::chrono::milliseconds> parse_duration(std::string_view text);

/// For example "500 ms", "1.5 s"; minutes and hours are shown in seconds.
std::string duration_text(std::chrono::milliseconds duration);

/// Adds an option that takes a duration.
CLI::Option* add_duration(CLI::App& command, const std::string& name,
                          std::optional<std::chrono::milliseconds>& into,
                          const std::string& description);

/// Accepts these words in any case, and makes the value the word as it is here; for transform().
inline CLI::Validator one_of(std::vector<std::string> words) {
  return CLI::IsMember(std::move(words), CLI::ignore_case);
}

/// Adds --format, whose default is the present value.
inline void add_format(CLI::App& command, std::string& format,
                       std::vector<std::string> words = {"text", "json"},
                       const std::string& help = "Output format") {
  command.add_option("--format", format, help)
      ->transform(one_of(std::move(words)))
      ->capture_default_str();
}

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

/// Adds --rate, in messages per second.
inline CLI::Option* add_rate(CLI::App& command, double& rate) {
  return command
      .add_option("--rate", rate,
                  "Messages per second; the board rounds the interval to milliseconds")
      ->type_name("HZ")
      ->check(number_range(0.02, 1000.0))
      ->capture_default_str();
}

inline std::chrono::milliseconds interval_of(double rate) {
  return std::chrono::milliseconds(std::lround(1000 / rate));
}

}  // namespace sbgc::tools
