/// Functions that check what a board supports.
#pragma once

#include <sbgc/message.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

/// Returns the newest framing that a board with these versions understands.
constexpr Framing newest_framing(const Availability& versions) noexcept {
  Framing result = basic_framing;
  for (const Framing framing : framings) {
    const Availability since = with_framing(framing, [](auto f) {
      return Availability{FramingFacts<f()>::since_firmware, FramingFacts<f()>::since_board};
    });
    if (is_available(since, versions)) result = framing;
  }
  return result;
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

/// The same for the board that sent `info`:
///     if (is_supported<msg::BeepSound>(board_info)) ...
template <Message M, class Info>
  requires requires(const Info& info) { versions_of(info); }
constexpr bool is_supported(const Info& info) noexcept {
  return is_supported<M>(versions_of(info));
}

}  // namespace sbgc
