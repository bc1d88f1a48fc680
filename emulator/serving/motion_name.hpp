/// The names of synthetic motions of the frame.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include <sbgc/emulator/disturbance.hpp>

namespace sbgc::serving {

/// Returns the motion with this name, such as "handheld".
inline std::optional<emulator::Disturbance::Kind> motion_named(std::string_view name) {
  using Kind = emulator::Disturbance::Kind;
  static constexpr std::array<std::pair<std::string_view, Kind>, 4> kinds{
      {{"rest", Kind::rest},
       {"handheld", Kind::handheld},
       {"drone", Kind::drone},
       {"vehicle", Kind::vehicle}}};
  const auto* const found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.first == name; });
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace sbgc::serving
