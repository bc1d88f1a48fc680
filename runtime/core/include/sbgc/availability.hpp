/// What a board of some version understands.
#pragma once

#include <sbgc/message.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// Whether something that exists since `since` is there on a board with these versions.
constexpr bool is_available(const Availability& since, const Availability& versions) noexcept {
  return since.firmware <= versions.firmware && since.board <= versions.board;
}

/// Whether a board with these versions takes the message: not if its firmware is too old for it,
/// nor if it is so new that another form has taken its place, which is later_form(message) then.
template <Message M>
constexpr bool is_supported(const Availability& versions) noexcept {
  if constexpr (requires { M::until; }) {
    if (is_available(M::until, versions)) return false;
  }
  return is_available(M::since, versions);
}

/// Whether the board that has introduced itself so knows the message:
///     if (is_supported<BeepSound>(board_info)) ...
template <Message M, class Info>
  requires requires(const Info& info) { versions_of(info); }
constexpr bool is_supported(const Info& info) noexcept {
  return is_supported<M>(versions_of(info));
}

}  // namespace sbgc
