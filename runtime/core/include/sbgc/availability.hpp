/// What a board supports.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <sbgc/message.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// Returns true if a board with these versions has a feature that exists since `since`.
constexpr bool is_available(const Availability& since, const Availability& versions) noexcept {
  return since.firmware <= versions.firmware && since.board <= versions.board;
}

/// Returns the newest framing that a board with these versions understands.
constexpr Framing newest_framing(const Availability& versions) noexcept {
  return [&versions]<std::size_t... i>(std::index_sequence<i...>) {
    Framing result = basic_framing;
    const auto consider = [&]<Framing framing>(std::integral_constant<Framing, framing>) {
      using Facts = FramingFacts<framing>;
      if (is_available({Facts::since_firmware, Facts::since_board}, versions)) result = framing;
    };
    (consider(std::integral_constant<Framing, framings[i]>{}), ...);
    return result;
  }
  (std::make_index_sequence<framings.size()>{});
}

/// Returns true if a board with these versions accepts the message: its firmware is not too old for
/// it, nor so new that another form has replaced it. That form is later_form(message).
template <Message M>
constexpr bool is_supported(const Availability& versions) noexcept {
  if constexpr (requires { M::until; }) {
    if (is_available(M::until, versions)) return false;
  }
  return is_available(M::since, versions);
}

/// As above, for the board that sent `info`:
///     if (is_supported<BeepSound>(board_info)) ...
template <Message M, class Info>
  requires requires(const Info& info) { versions_of(info); }
constexpr bool is_supported(const Info& info) noexcept {
  return is_supported<M>(versions_of(info));
}

}  // namespace sbgc
