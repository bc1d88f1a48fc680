#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/detail/compiler.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "entry_of_each.hpp"

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

/// True if the board takes another form of the command.
bool has_another_form(std::uint8_t id, const Availability& versions) {
  return std::ranges::any_of(message_types(), [&](const MessageType* type) {
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

template <Message M>
std::optional<ClientError> refusal(const M& message, const Availability& versions, bool validate) {
  if (!is_supported<M>(versions)) {
    return ClientError{ErrorCode::unsupported, lacking(Meta<M>::info, versions)};
  }
  std::optional<ClientError> error;
  if (!validate) return error;
  sbgc::validate(message, versions, [&](const Violation& violation) {
    if (error) return;
    error = {ErrorCode::invalid,
             std::string(Meta<M>::info.command) + ": " + text_of(violation, versions)};
  });
  return error;
}

}  // namespace

template <Message M>
Result<Request> prepare(const M& message, const Availability& versions, bool validate) {
  if constexpr (requires { later_form(message); }) {
    // Firmware that no longer takes this form receives the equivalent later form.
    if (is_available(M::until, versions)) {
      return prepare(later_form(message), versions, validate);
    }
  }
  if (auto error = refusal(message, versions, validate)) return *std::move(error);
  Request request{.id = static_cast<std::uint8_t>(M::command),
                  .policy = response_policy(message),
                  .command = Meta<M>::info.command};
  request.body.resize(max_body_size);
  const WriteResult written = encode(message, request.body);
  if (!written) {
    Status status = written.status;
    if (status.code == Code::buffer_too_small) status.code = Code::too_long;
    return ClientError{ErrorCode::invalid, "the request cannot be encoded: " + to_string(status)};
  }
  request.body.resize(written.size);
  if constexpr (Contexts::learns_from<M>) {
    request.teach = [message](Contexts& contexts) { contexts.learn(message); };
  }
  return request;
}

Result<Request> prepare(const AnyMessage& message, const Availability& versions, bool validate) {
  Result<Request> result = ClientError{ErrorCode::invalid, "only the board sends this message"};
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      const auto* const request = message.get_if<M>();
      if (request == nullptr) return;
      result = prepare(without_surplus(*request), versions, validate);
      if constexpr (takes_surplus<M>) {
        if (!result) return;
        std::vector<std::uint8_t>& body = result->body;
        body.insert(body.end(), request->tail.begin(), request->tail.end());
        if (body.size() > max_body_size) {
          result = ClientError{ErrorCode::invalid, "the tail is too long"};
        }
      }
    }
  });
  return result;
}

template <Message M>
std::optional<ClientError> stream_refusal(const Availability& versions) {
  if (is_supported<M>(versions)) return std::nullopt;
  return ClientError{ErrorCode::unsupported, lacking(Meta<M>::info, versions)};
}

namespace {

template <class M>
struct StreamRefusal {
  decltype(&stream_refusal<M>) function = &stream_refusal<M>;
};

/// Makes the compiler emit stream_refusal() for every message that boards stream.
SBGC_USED const auto stream_refusals = entries_for<StreamRefusal>(roles::StreamMessages{});

template <class M>
struct Preparer {};

template <class M>
  requires(M::direction != Direction::from_board)
struct Preparer<M> {
  decltype(&prepare<M>) function = &prepare<M>;
};

/// Makes the compiler emit prepare() for every message to the board.
SBGC_USED const auto preparers = entries_for<Preparer>(AllMessages{});

}  // namespace

}  // namespace sbgc::detail
