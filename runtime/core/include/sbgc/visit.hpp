/// From a frame to a typed message.
#pragma once

#include <utility>

#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>

namespace sbgc {

/// Decodes a body and calls `visitor(message)` with the message it is.
///
/// `direction` says who sent it: some ids mean one thing in one direction and another in the
/// other. `contexts` is what earlier messages have told (see Contexts). The status is that of
/// decoding, or unknown_command or unknown_form; the visitor is called only when it is ok.
template <class Visitor>
constexpr Status visit(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                       Visitor&& visitor, const Contexts& contexts = {}) {
  Status status{};
  const Code code = select(direction, id, body.size(), [&]<class M>(Type<M>) {
    M message{};
    if constexpr (requires { contexts.of(message); }) {
      status = decode(body, message, contexts.of(message));
    } else {
      status = decode(body, message);
    }
    if (status) visitor(std::as_const(message));
  });
  return code == Code::ok ? status : Status{code};
}

/// As above, for a frame that the parser has found.
template <class Visitor>
constexpr Status visit(const Frame& frame, Direction direction, Visitor&& visitor,
                       const Contexts& contexts = {}) {
  return visit(frame.id, frame.body, direction, std::forward<Visitor>(visitor), contexts);
}

}  // namespace sbgc
