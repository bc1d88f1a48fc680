/// What a handler of requests works with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// The frame to send instead of one that reports a change of the memory, after saving failed:
/// CMD_ERROR replaces a confirmation, other frames stay. Empty if this board and firmware have no
/// such error.
std::vector<std::uint8_t> refusal_instead(Availability versions,
                                          std::span<const std::uint8_t> frame);

/// One request while it is carried out. A handler is
///     Outcome handle(RequestContext& context, const M& request);
/// found by overload (handlers.hpp). It answers through the context and returns the outcome. A
/// message without a handler is answered as the model says (default_response.hpp).
class RequestContext {
 public:
  RequestContext(Device& of, std::size_t from, std::uint8_t id, Confirmed confirmed, Instant at)
      : device(of), port(from), command(id), now(at), confirmed_(confirmed) {}

  Device& device;
  const std::size_t port;
  const std::uint8_t command;  ///< id of the request
  const Instant now;

  /// Sends a response, if this board and firmware have it.
  template <Message M>
  Outcome answer(const M& message) {
    if (is_supported<M>(versions())) send(message);
    return Outcome::carried_out;
  }
  /// The same, even if this board does not have the message otherwise: old requests have the
  /// responses of newer ones (E020, E120).
  template <Message M>
  Outcome answer_anyway(const M& message) {
    send(message);
    return Outcome::carried_out;
  }
  /// Sends CMD_CONFIRM for the request, with these data. Assumption: not if the model calls it
  /// unlikely.
  Outcome confirm(std::span<const std::uint8_t> data = {});
  /// The same with the given fields.
  Outcome confirm(roles::Confirmation confirmation);
  /// Sends CMD_ERROR for the request.
  Outcome refuse(msg::BoardErrorCode reason, std::uint32_t detail = 0);
  /// Sends nothing, where the specification demands that.
  static Outcome ignore() { return Outcome::refused; }

  /// Sends a message whose type is not known at compile time.
  void answer_body(std::uint8_t id, std::span<const std::uint8_t> body);
  /// Versions of the board and its firmware.
  Availability versions() const;

 private:
  void send_frame(std::span<const std::uint8_t> frame);
  template <Message M>
  void send(const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    if (const WriteResult written = encode_frame(message, frame)) {
      send_frame(std::span(frame).first(written.size));
    }
  }

  bool confirms() const noexcept { return confirmed_ >= Confirmed::possible; }

  Confirmed confirmed_;
};

}  // namespace sbgc::emulator
