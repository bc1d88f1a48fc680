#include "parameters/profile_choice.hpp"

#include <fmt/format.h>

#include <sbgc/client/profiles.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/interruption.hpp"

namespace sbgc::tools {

void add_profile_option(CLI::App& command, ProfileOption& option) {
  command
      .add_option("--profile", option.number,
                  "The profile, counted from 1; by default the active one")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, static_cast<int>(profile_count)).description(""));
}

std::string ChosenProfile::text() const {
  return fmt::format("profile {}{}", index + 1, is_active ? ", which is active" : "");
}

ChosenProfile choose_profile(Client& client, const ProfileOption& option) {
  const auto active = static_cast<std::uint8_t>(value_of(client.active_profile()));
  if (!option.number) return {active, true};
  const auto index = static_cast<std::uint8_t>(*option.number - 1);
  return {index, index == active};
}

ParameterSet read_parameters(Client& client, std::function<bool(const ParametersId&)> wanted) {
  const Interruption interruption;
  ProgressBar bar;
  ReadOptions options{.progress = bar.handler(), .wanted = std::move(wanted)};
  return value_of(client.read_parameters(options));
}

}  // namespace sbgc::tools
