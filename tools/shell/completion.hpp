/// Candidates for completion at the cursor.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

struct Candidate {
  std::string word{};
  std::string description{};
};

/// Returns the candidates for the last of these words, which follow "sbgc". `files_directive` of
/// shell/scripts.hpp stands for files.
std::vector<Candidate> candidates_for(const CLI::App& app, const std::vector<std::string>& line);

/// Returns the subcommand that these words select, at the deepest level.
const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& line);

}  // namespace sbgc::tools
