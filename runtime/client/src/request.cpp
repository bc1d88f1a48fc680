#include <array>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include <sbgc/availability.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/exchanges/all.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>

#include "text.hpp"

namespace sbgc::detail {

namespace {

std::string text_of(const Violation& violation, const Availability& versions) {
  std::array<char, 128> path{};
  violation.path.write(path.data(), path.size());
  const std::string what = std::string(path.data()) + " = " + number_text(violation.value);
  const std::string limit = number_text(violation.limit);
  switch (violation.rule) {
    case Rule::minimum: return what + " is too small, the smallest value is " + limit;
    case Rule::maximum: return what + " is too large, the largest value is " + limit;
    case Rule::alignment: return what + " is no multiple of " + limit;
    case Rule::count: {
      const bool is_short = violation.value < violation.limit;
      return std::string(path.data()) + " has " + number_text(violation.value) + " elements, at " +
             (is_short ? "least " + limit + " are needed" : "most " + limit + " are allowed");
    }
    case Rule::firmware:
      return what + " needs firmware " +
             firmware_text(static_cast<std::uint16_t>(violation.limit)) + ", the board has " +
             firmware_text(versions.firmware);
    case Rule::board:
      return what + " needs board " + board_text(static_cast<std::uint8_t>(violation.limit)) +
             ", this is board " + board_text(versions.board);
  }
  return what + " is not allowed";
}

/// Whether the board takes some other form of the command.
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
  if (has_another_form(info.id, versions)) command += " in this form";
  const std::string has = ", the board has " + firmware_text(versions.firmware);
  if (info.until.firmware != 0 && info.until.firmware <= versions.firmware) {
    return command + " needs firmware before " + firmware_text(info.until.firmware) + has;
  }
  if (info.since.firmware > versions.firmware) {
    return command + " needs firmware " + firmware_text(info.since.firmware) + has;
  }
  return command + " needs board " + board_text(info.since.board) + ", this is board " +
         board_text(versions.board);
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
    // Firmware that no longer takes this form is sent the one that says the same.
    if (is_available(M::until, versions)) {
      return prepare(later_form(message), versions, validate);
    }
  }
  if (auto error = refusal(message, versions, validate)) return *std::move(error);
  Request request{.id = static_cast<std::uint8_t>(M::command),
                  .exchange = exchange_of(message),
                  .command = Meta<M>::info.command};
  static_cast<void>(request.body.resize(max_body_size));
  const WriteResult written = encode(message, {request.body.begin(), request.body.end()});
  if (!written) {
    Status status = written.status;
    if (status.code == Code::buffer_too_small) status.code = Code::too_long;
    return ClientError{ErrorCode::invalid, "the request cannot be encoded: " + status_text(status)};
  }
  static_cast<void>(request.body.resize(written.size));
  if constexpr (Contexts::learns_from<M>) {
    request.teach = [message](Contexts& contexts) { contexts.learn(message); };
  }
  return request;
}

namespace {

template <class M>
constexpr auto preparer_of() noexcept {
  if constexpr (M::direction != Direction::from_board) {
    return std::tuple{&prepare<M>};
  } else {
    return std::tuple{};
  }
}

template <class... Ms>
constexpr auto preparers_of(TypeList<Ms...>) noexcept {
  return std::tuple_cat(preparer_of<Ms>()...);
}

/// Makes the compiler emit prepare() for every message to the board.
[[gnu::used]] const auto preparers = preparers_of(AllMessages{});

}  // namespace

}  // namespace sbgc::detail
