/// Checks whether a board supports a message.
#pragma once

#include <sbgc/message.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// Returns true if a board with these versions has a feature that exists since `since`.
constexpr bool is_available(const Availability& since, const Availability& versions) noexcept {
  return since.firmware <= versions.firmware && since.board <= versions.board;
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
