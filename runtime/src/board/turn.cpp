#include "turn.hpp"

#include <algorithm>

#include "machine.hpp"

namespace sbgc::board {

Availability Turn::versions() const { return machine.versions(); }

void Turn::send_frame(std::span<const std::uint8_t> frame) {
  machine.ports.send_frame(port, frame);
}

void Turn::answer_body(std::uint8_t id, std::span<const std::uint8_t> body) {
  std::array<std::uint8_t, max_frame_size> frame{};
  if (const WriteResult written = write_frame(id, body, frame)) {
    send_frame(std::span(frame).first(written.size));
  }
}

Outcome Turn::confirm(std::span<const std::uint8_t> data) {
  if (!confirms()) return Outcome::carried_out;
  std::array<std::uint8_t, max_body_size> body{command};
  std::size_t size = 1;
  for (const std::uint8_t byte : data.first(std::min(data.size(), body.size() - 1))) {
    body[size++] = byte;
  }
  answer_body(static_cast<std::uint8_t>(roles::Confirmation::command), std::span(body).first(size));
  return Outcome::carried_out;
}

Outcome Turn::confirm(roles::Confirmation confirmation) {
  if (!confirms()) return Outcome::carried_out;
  confirmation.cmd = static_cast<CommandId>(command);
  return answer(confirmation);
}

Outcome Turn::refuse(BoardErrorCode reason, std::uint32_t detail) {
  ErrorExt error;  // the form that real boards send: with the command that failed (E086)
  error.cmd_id = static_cast<CommandId>(command);
  error.error_code = reason;
  for (std::size_t i = 0; i < error.error_data.size(); ++i) {
    error.error_data[i] = static_cast<std::uint8_t>(detail >> (8 * i));
  }
  static_cast<void>(answer(error));
  return Outcome::refused;
}

}  // namespace sbgc::board
