/// Choices of words on the command line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

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

}  // namespace sbgc::tools
