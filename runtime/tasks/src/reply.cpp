#include <algorithm>
#include <string>

#include <sbgc/any.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/dispatch.hpp>

#include "board_text.hpp"

namespace sbgc::detail {

Status decode_in_context(const Reply& reply, const MessageType& type, void* out) noexcept {
  const Contexts none;
  const AnyOperations& operations = *type.operations;
  return operations.decode(operations, reply.body, out, reply.contexts ? *reply.contexts : none);
}

Result<std::int64_t> stream_interval_count(std::chrono::milliseconds interval, std::int64_t most) {
  constexpr std::int64_t unit = roles::stream_interval_us;
  const std::int64_t longest = most * unit / 1000;
  const std::int64_t wanted = interval.count();
  const bool is_possible = wanted > 0 && wanted <= longest && wanted * 1000 % unit == 0 &&
                           wanted * 1000 / unit != roles::stream_end;
  if (is_possible) return wanted * 1000 / unit;
  return ClientError{ErrorCode::invalid,
                     "a stream interval of " + std::to_string(wanted) +
                         " ms is not possible: the range is " +
                         std::to_string(std::max<std::int64_t>(unit / 1000, 1)) + " to " +
                         std::to_string(longest) + " ms"};
}

ClientError decode_error(Status status, const Reply& reply) {
  const Contexts contexts = reply.contexts == nullptr ? Contexts{} : *reply.contexts;
  return {ErrorCode::bad_response,
          "the response " + undecodable(status, reply.id, reply.body, contexts)};
}

template <>
Result<std::optional<AnyMessage>> read_any(const Result<Reply>& reply) {
  if (!reply) return reply.error();
  const Contexts contexts = reply->contexts == nullptr ? Contexts{} : *reply->contexts;
  const MessageType* const type =
      find_message(Direction::from_board, reply->id, reply->body.size(), contexts);
  if (type == nullptr) return std::optional<AnyMessage>();
  AnyMessage message = type->make();
  const Status status = message.decode(reply->body, contexts);
  if (!status) return decode_error(status, *reply);
  return std::optional(std::move(message));
}

ClientError missing_response(const Reply& reply) {
  return {ErrorCode::bad_response, reply.kind == ReplyKind::confirmed
                                       ? "the board sent only a confirmation"
                                       : "the board sent no response"};
}

ClientError unconfirmed_error() {
  return {ErrorCode::unconfirmed, "sent; the board did not confirm it"};
}

}  // namespace sbgc::detail
