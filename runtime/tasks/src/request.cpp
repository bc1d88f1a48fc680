#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "board_text.hpp"

namespace sbgc::detail {

namespace {

std::string has_firmware(const Availability& versions) {
  return ", the board has " + to_string(msg::FirmwareVersion(versions.firmware));
}

std::string is_board(const Availability& versions) {
  return ", this is board " + to_string(msg::BoardVersion(versions.board));
}

constexpr const char* lacks_it = ", which this board does not report";

std::string text_of(const Violation& violation, const Availability& versions) {
  std::string text = to_string(violation);
  if (violation.rule == Rule::firmware) text += has_firmware(versions);
  if (violation.rule == Rule::board) text += is_board(versions);
  if (violation.rule == Rule::feature) text += lacks_it;
  return text;
}

/// True if the board accepts another form of the command.
bool has_another_form(std::uint8_t id, const Availability& versions) {
  const auto types = message_types();
  return std::any_of(types.begin(), types.end(), [&](const MessageType* type) {
    return type->is_sent_to_board() && type->info->id == id &&
           objection_to(*type->info, versions).empty();
  });
}

std::string lacking(const MessageInfo& info, const Availability& versions) {
  const std::string objection = objection_to(info, versions);
  const bool is_request = info.direction != Direction::from_board;
  const bool has_other = is_request && has_another_form(info.id, versions);
  std::string text = std::string(info.command) + (has_other ? " in this form " : " ") + objection;
  const bool is_of_firmware = objection.starts_with("needs firmware");
  if (objection.starts_with("needs board")) return text + is_board(versions);
  return text + (is_of_firmware ? has_firmware(versions) : lacks_it);
}

std::optional<ClientError> refusal(const MessageInfo& info, const Availability& versions) {
  if (objection_to(info, versions).empty()) return std::nullopt;
  return ClientError{ErrorCode::unsupported, lacking(info, versions)};
}

std::optional<ClientError> refusal(const AnyMessage& message, const Availability& versions,
                                   bool validate) {
  const MessageInfo& info = *message.type().info;
  std::optional<ClientError> error = refusal(info, versions);
  if (error || !validate) return error;
  message.validate(versions, [&](const Violation& violation) {
    if (error) return;
    error = {ErrorCode::invalid, std::string(info.command) + ": " + text_of(violation, versions)};
  });
  return error;
}

/// Returns the form for firmware that no longer accepts this one, if there is one.
std::optional<AnyMessage> later_form_of(const AnyMessage& message, const Availability& versions) {
  std::optional<AnyMessage> later;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (requires(const M& request) { later_form(request); }) {
      const auto* const request = message.get_if<M>();
      if (request == nullptr || !is_available(M::until, versions)) return;
      const auto form = later_form(*request);
      later.emplace(message_type<std::remove_const_t<decltype(form)>>(), &form);
    }
  });
  return later;
}

/// True for a request that commands motion, and neither sets nor stores anything.
bool is_motion(const ResponsePolicy& policy, Effects effects) {
  const Effects motion = Effects(Effect::moves) | Effect::restarts;
  return policy.stops || (policy.moves && (effects.raw() & ~motion.raw()) == 0);
}

}  // namespace

ResponsePolicy policy_of(const AnyMessage& message) {
  ResponsePolicy policy;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (requires(const M& request) { response_policy(request); }) {
      if (const auto* const request = message.get_if<M>()) policy = response_policy(*request);
    }
  });
  return policy;
}

Result<Request> prepare(const AnyMessage& message, const Availability& versions, bool validate) {
  const MessageType& type = message.type();
  if (!type.is_sent_to_board()) {
    return ClientError{ErrorCode::invalid, "only the board sends this message"};
  }
  if (const auto later = later_form_of(message, versions)) {
    return prepare(*later, versions, validate);
  }
  if (auto error = refusal(message, versions, validate)) return *std::move(error);
  Request request{.id = type.info->id, .policy = policy_of(message), .command = type.info->command};
  request.is_motion = is_motion(request.policy, type.info->effects);
  request.body.resize(max_body_size);
  const WriteResult written = message.encode(request.body);
  if (!written) {
    Status status = written.status;
    if (status.code == Code::buffer_too_small) status.code = Code::too_long;
    return ClientError{ErrorCode::invalid, "the request cannot be encoded: " + to_string(status)};
  }
  request.body.resize(written.size);
  if (type.operations->teach != nullptr) {
    request.teach = [message](Contexts& contexts) { message.teach(contexts); };
  }
  return request;
}

Result<Request> prepare(const MessageType& type, const void* message, const Availability& versions,
                        bool validate) {
  return prepare(AnyMessage(type, message), versions, validate);
}

std::optional<ClientError> stream_refusal(const MessageType& type, const Availability& versions) {
  return refusal(*type.info, versions);
}

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

namespace sbgc {

namespace {

/// The timeout of a request that no message describes.
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
