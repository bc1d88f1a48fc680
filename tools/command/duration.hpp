/// Durations on the command line: "500ms", "1.5s", "2m", "1h"; seconds without a unit.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

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

}  // namespace sbgc::tools
