#include <optional>
#include <span>
#include <string>

#include <sbgc/availability.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/detail/compiler.hpp>
#include <sbgc/dispatch.hpp>
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

std::string text_of(const Violation& violation, const Availability& versions) {
  std::string text = to_string(violation);
  if (violation.rule == Rule::firmware) text += has_firmware(versions);
  if (violation.rule == Rule::board) text += is_board(versions);
  return text;
}

/// True if the board takes another form of the command.
bool has_another_form(std::uint8_t id, const Availability& versions) {
  bool is_known = false;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      const bool has_id = static_cast<std::uint8_t>(M::command) == id;
      is_known = is_known || (has_id && is_supported<M>(versions));
    }
  });
  return is_known;
}

std::string lacking(const MessageInfo& info, const Availability& versions) {
  std::string command = info.command;
  const bool is_request = info.direction != Direction::from_board;
  if (is_request && has_another_form(info.id, versions)) command += " in this form";
  if (info.until.firmware != 0 && info.until.firmware <= versions.firmware) {
    return command + " needs firmware before " +
           to_string(msg::FirmwareVersion(info.until.firmware)) + has_firmware(versions);
  }
  if (info.since.firmware > versions.firmware) {
    return command + " needs firmware " + to_string(msg::FirmwareVersion(info.since.firmware)) +
           has_firmware(versions);
  }
  return command + " needs board " + to_string(msg::BoardVersion(info.since.board)) +
         is_board(versions);
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
  static_cast<void>(request.body.resize(max_body_size));
  const WriteResult written = encode(message, {request.body.begin(), request.body.end()});
  if (!written) {
    Status status = written.status;
    if (status.code == Code::buffer_too_small) status.code = Code::too_long;
    return ClientError{ErrorCode::invalid, "the request cannot be encoded: " + to_string(status)};
  }
  static_cast<void>(request.body.resize(written.size));
  if constexpr (Contexts::learns_from<M>) {
    request.teach = [message](Contexts& contexts) { contexts.learn(message); };
  }
  return request;
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
