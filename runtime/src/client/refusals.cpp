#include "refusals.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>

#include <sbgc/frame.hpp>
#include <sbgc/messages/system.hpp>

#include "request.hpp"

namespace sbgc::detail {

Refusals::Refusals(Client& client, const MessageInfo& request)
    : subscription_(client.subscribe<ErrorExt>([this, &request](const ErrorExt& error) {
        if (static_cast<std::uint8_t>(error.cmd_id) != request.id) return;
        std::array<std::uint8_t, max_body_size> buffer{};
        const auto body = std::span(buffer).first(encode(error, buffer).size);
        const auto id = static_cast<std::uint8_t>(ErrorExt::command);
        const std::scoped_lock lock(mutex_);
        last_ = {ErrorCode::board_error,
                 std::string(request.command) + ": the board refused: " + describe(id, body),
                 error_code_in(id, body)};
      })) {}

std::optional<ClientError> Refusals::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(last_, std::nullopt);
}

}  // namespace sbgc::detail
