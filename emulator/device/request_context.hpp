/// The interface between a request handler and the board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/time.hpp>

#include "device/features.hpp"
#include "device/ports.hpp"

namespace sbgc::emulator {

/// True if a message holds parameters of the board.
template <class M>
inline constexpr bool holds_parameters = requires {
  ParametersOf<sbgc::detail::CodedAs<M>>::copies;
};

/// Returns the frame that replaces one reporting a change of the memory if saving failed: CMD_ERROR
/// replaces a confirmation, other frames stay unchanged. Returns nothing if this board and firmware
/// do not support that error.
std::vector<std::uint8_t> refusal_instead(Availability versions,
                                          std::span<const std::uint8_t> frame);

/// One request during its execution. A handler is
///     Reaction handle(RequestContext& context, const M& request, Part& part, ...);
/// found by overload resolution (handlers.hpp), with the parts of the device that it uses. It
/// responds through the context and returns the reaction. Messages without a handler get the
/// response that the model defines (default_response.hpp).
class RequestContext {
 public:
  RequestContext(Ports& ports, const BoardOptions& options, std::size_t from, std::uint8_t id,
                 Confirmed confirmed, Instant at);

  const std::size_t port;
  const std::uint8_t command;  ///< the id of the request
  const Instant now;

  /// Sends a response if this board and firmware support it.
  template <Message M>
  Reaction answer(const M& message) {
    if (is_supported<M>(versions())) send(message);
    return Reaction::executed;
  }
  /// The same, even if this board does not support the message otherwise: an old request has the
  /// response of a newer one (E020).
  template <Message M>
  Reaction answer_anyway(const M& message) {
    send(message);
    return Reaction::executed;
  }
  /// Sends CMD_CONFIRM for the request with these data. Assumption: sends nothing if the model
  /// considers a confirmation unlikely.
  Reaction confirm(std::span<const std::uint8_t> data = {});
  /// The same with the given fields.
  Reaction confirm(roles::Confirmation confirmation);
  /// Sends CMD_ERROR for the request.
  Reaction refuse(msg::BoardErrorCode reason, std::uint32_t detail = 0);
  /// Sends nothing, as the specification requires.
  static Reaction ignore() { return Reaction::refused; }

  /// Sends a message whose type is not known at compile time.
  void answer_body(std::uint8_t id, std::span<const std::uint8_t> body);
  /// True if the request came over USB.
  bool is_usb() const;
  /// The versions of the board and its firmware.
  Availability versions() const { return versions_; }

 private:
  /// Removes fields that the firmware does not know, but parameters are sent as they are stored.
  template <Message M>
  void send(const M& message) {
    M known = message;
    if constexpr (!holds_parameters<M>) limit_to(versions(), known);
    ports_.send(port, known);
  }

  bool confirms() const noexcept { return confirmed_ >= Confirmed::possible; }

  Ports& ports_;
  Availability versions_;
  Confirmed confirmed_;
};

}  // namespace sbgc::emulator
