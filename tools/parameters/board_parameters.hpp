/// The parameters on a board: the profile, reading them, and the outcome of writing them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/parameters.hpp>

namespace sbgc::tools {

/// The option --profile. Profiles are counted from 1 for users.
struct ProfileOption {
  std::optional<unsigned> number{};
};
void add_profile_option(CLI::App& command, ProfileOption& option);

/// A profile of a board.
struct ChosenProfile {
  std::uint8_t index{};  ///< from 0
  bool is_active{};

  /// For example "profile 2" or "profile 1, which is active".
  std::string text() const;
};

/// Returns the profile of the option, or the active one. Throws CommandError.
ChosenProfile choose_profile(Client& client, const ProfileOption& option);

/// Reads the parameters for which `wanted` holds; all if it is empty. Shows the progress. Throws
/// CommandError.
ParameterSet read_parameters(Client& client, std::function<bool(const ParametersId&)> wanted = {});

/// Returns the changes that the report lists, a line for each; "" if there are none.
std::string changes_text(const WriteReport& report);

/// The same for the differences of two sets of parameters.
std::string changes_text(const std::vector<ParametersChange>& changes);

/// Returns the number of values that the report lists for change.
std::size_t change_count(const WriteReport& report);

/// If writing failed, prints the present values of the board and ends the command. Without `hint`
/// the message is that of the library.
void check_outcome(const WriteReport& report, const std::string& hint = "");

}  // namespace sbgc::tools
