#include "device/request_context.hpp"

#include <algorithm>
#include <array>

#include "device/features.hpp"

namespace sbgc::emulator {
namespace {

/// CMD_ERROR as sent by real boards: with the command that failed (E086).
msg::ErrorExt error_about(std::uint8_t command, msg::BoardErrorCode reason, std::uint32_t detail) {
  msg::ErrorExt error;
  error.cmd_id = static_cast<msg::CommandToBoard>(command);
  error.error_code = reason;
  for (std::size_t i = 0; i < error.error_data.size(); ++i) {
    error.error_data[i] = static_cast<std::uint8_t>(detail >> (8 * i));
  }
  return error;
}

}  // namespace

std::vector<std::uint8_t> refusal_instead(Availability versions,
                                          std::span<const std::uint8_t> frame) {
  const Frame held = frame_at(frame.data());
  if (!roles::is_confirmation(held)) return {frame.begin(), frame.end()};
  if (!is_supported<msg::ErrorExt>(versions)) return {};
  std::vector<std::uint8_t> result(max_frame_size);
  const std::uint8_t command = roles::confirmed_command(held);
  result.resize(encode_frame(held.framing,
                             error_about(command, msg::BoardErrorCode::operation_failed, 0), result)
                    .size);
  return result;
}

RequestContext::RequestContext(Ports& ports, const BoardOptions& options, std::size_t from,
                               std::uint8_t id, Confirmed confirmed, Instant at)
    : port(from),
      command(id),
      now(at),
      ports_(ports),
      versions_(versions_of(options)),
      confirmed_(confirmed) {}

bool RequestContext::is_usb() const { return ports_.is_usb(port); }

void RequestContext::answer_body(std::uint8_t id, std::span<const std::uint8_t> body) {
  std::array<std::uint8_t, max_frame_size> frame{};
  if (const WriteResult written = write_frame(id, body, frame)) {
    ports_.send_frame(port, std::span(frame).first(written.size));
  }
}

Reaction RequestContext::confirm(std::span<const std::uint8_t> data) {
  if (!confirms()) return Reaction::executed;
  std::array<std::uint8_t, max_body_size> body{command};
  std::size_t size = 1;
  for (const std::uint8_t byte : data.first(std::min(data.size(), body.size() - 1))) {
    body[size++] = byte;
  }
  answer_body(static_cast<std::uint8_t>(roles::Confirmation::command), std::span(body).first(size));
  return Reaction::executed;
}

Reaction RequestContext::confirm(roles::Confirmation confirmation) {
  if (!confirms()) return Reaction::executed;
  confirmation.cmd = static_cast<msg::CommandToBoard>(command);
  return answer(confirmation);
}

Reaction RequestContext::refuse(msg::BoardErrorCode reason, std::uint32_t detail) {
  static_cast<void>(answer(error_about(command, reason, detail)));
  return Reaction::refused;
}

}  // namespace sbgc::emulator
