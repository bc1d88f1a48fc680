/// The meaning of a received frame for the requests of a session.
#pragma once

#include <cstdint>

#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc::detail {

/// The kind of a frame, and the command that it confirms or reports as failed (0 if unknown), or
/// its own id. With `any_size`, a body of a wrong size, which does not decode, is a response, too.
struct Meaning {
  const Frame& frame;
  EventKind kind;
  std::uint8_t command;
  bool any_size;

  /// Returns true for an error that does not name the failed request.
  bool is_anonymous() const noexcept { return kind == EventKind::board_error && command == 0; }

  /// Returns true if the frame can be one of these responses.
  SBGC_NOINLINE bool operator()(const Responses& responses) const noexcept {
    if (kind == EventKind::confirmation) return responses.is_confirmed_by(command, frame);
    if (kind == EventKind::board_error) return command == 0 || command == responses.command;
    return responses.form_of(frame, any_size) != nullptr;
  }
};

/// Returns the meaning of a frame. `is_of_stream` is true if its id is that of a running stream.
inline Meaning meaning_of(const Frame& frame, bool is_of_stream, bool any_size) noexcept {
  if (roles::is_reset(frame)) return {frame, EventKind::reset, frame.id, any_size};
  if (roles::is_confirmation(frame)) {
    return {frame, EventKind::confirmation, roles::confirmed_command(frame), any_size};
  }
  if (roles::is_error(frame)) {
    return {frame, EventKind::board_error, roles::failed_command(frame), any_size};
  }
  return {frame, is_of_stream ? EventKind::stream : EventKind::unsolicited, frame.id, any_size};
}

}  // namespace sbgc::detail
