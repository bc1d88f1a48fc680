#include <algorithm>

#include <sbgc/any.hpp>
#include <sbgc/client/raw_request.hpp>

#include "policy_of.hpp"

namespace sbgc {

namespace {

/// For the response to a request that no message describes.
constexpr std::uint32_t unknown_timeout_ms = 1000;

ResponsePolicy cautious_policy(std::uint8_t id) {
  ResponsePolicy policy;
  policy.responses.command = id;
  policy.responses.confirmed = Confirmed::possible;
  policy.responses.form_count = 1;
  policy.responses.forms[0] = {.id = id,
                               .min_size = 0,
                               .max_size = static_cast<std::uint8_t>(max_body_size),
                               .size = static_cast<std::uint8_t>(max_body_size)};
  policy.confirmations = 1;
  policy.response_required = true;
  policy.has_effect = true;
  policy.timeout_ms = unknown_timeout_ms;
  return policy;
}

}  // namespace

Result<RawRequest> raw_request(std::uint8_t id, std::span<const std::uint8_t> body) {
  if (!check_frame(id, body.size(), max_frame_size) || body.size() > max_body_size) {
    return ClientError{ErrorCode::invalid, "not a request that a frame can carry"};
  }
  RawRequest request{id, {body.begin(), body.end()}, cautious_policy(id)};
  if (const MessageType* const type = find_message(Direction::to_board, id, body.size())) {
    AnyMessage message = type->make();
    if (message.decode(body)) request.policy = detail::policy_of(message);
  }
  return request;
}

}  // namespace sbgc
