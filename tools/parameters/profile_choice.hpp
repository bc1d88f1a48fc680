/// The profile that a command is about.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/parameters.hpp>

namespace sbgc::tools {

/// The option --profile. Profiles are counted from 1, as people do.
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

/// Reads the parameters for which `wanted` holds; all of them, if it is empty. Shows the progress.
/// Throws CommandError.
ParameterSet read_parameters(Client& client, std::function<bool(const ParametersId&)> wanted = {});

}  // namespace sbgc::tools
