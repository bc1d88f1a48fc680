#include "request.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <sbgc/availability.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>
#include <sbgc/visit.hpp>

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
std::vector<std::uint8_t> frame_of(const M& message) {
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = encode_frame(message, frame);
  const std::span<const std::uint8_t> used(frame.data(), written.size);
  return {used.begin(), used.end()};
}

}  // namespace

Result<Request> inspect(FrameBytes frame, const Availability& versions, bool validate) {
  if (frame.size() < frame_header_size + frame_trailer_size) {
    return ClientError{ErrorCode::invalid, "this is no frame of a request"};
  }
  const std::uint8_t id = Framing::id(frame.data());
  const auto body =
      frame.subspan(frame_header_size, frame.size() - frame_header_size - frame_trailer_size);
  Request request{id, {body.begin(), body.end()}, {}, nullptr};
  std::optional<ClientError> error;
  std::vector<std::uint8_t> later;
  const Status status = visit(id, body, Direction::to_board, [&]<class M>(const M& message) {
    if constexpr (requires { response_policy(message); }) {
      if constexpr (requires { later_form(message); }) {
        if (is_available(M::until, versions)) {
          later = frame_of(later_form(message));
          return;
        }
      }
      request.policy = response_policy(message);
      request.info = &Meta<M>::info;
      if (!is_supported<M>(versions)) {
        error = {ErrorCode::unsupported, lacking(Meta<M>::info, versions)};
      } else if (validate) {
        sbgc::validate(message, versions, [&](const Violation& violation) {
          if (error) return;
          error = {ErrorCode::invalid,
                   std::string(Meta<M>::info.command) + ": " + text_of(violation, versions)};
        });
      }
    }
  });
  // Firmware that no longer takes this form is sent the one that says the same.
  if (!later.empty()) return inspect(later, versions, validate);
  if (error) return *std::move(error);
  if (!status) {
    return ClientError{ErrorCode::invalid,
                       command_name(id, Direction::to_board) + ": " + to_string(status)};
  }
  return request;
}

void learn_from_request(const Request& request, Contexts& contexts) {
  std::ignore = visit(request.id, request.body, Direction::to_board,
                      [&](const auto& message) { contexts.learn(message); });
}

void learn_from_board(std::uint8_t id, std::span<const std::uint8_t> body, Contexts& contexts) {
  std::ignore = visit(
      id, body, Direction::from_board, [&](const auto& message) { contexts.learn(message); },
      contexts);
}

std::optional<MessageKey> key_of_received(std::uint8_t id, std::span<const std::uint8_t> body) {
  std::optional<MessageKey> key;
  select(Direction::from_board, id, body.size(), [&]<class M>(Type<M>) {
    key = MessageKey{id, M::form};
  });
  return key;
}

bool needs_context(std::uint8_t id, std::span<const std::uint8_t> body) {
  bool needs = false;
  select(Direction::from_board, id, body.size(), [&]<class M>(Type<M>) {
    needs = requires { typename M::Context; };
  });
  return needs;
}

std::vector<std::uint8_t> frame_that_ends_stream(const Request& request) {
  std::vector<std::uint8_t> frame;
  std::ignore =
      visit(request.id, request.body, Direction::to_board, [&]<class M>(const M& message) {
        if constexpr (std::is_same_v<M, roles::StreamRequest>) {
          M end = message;
          auto& interval = roles::stream_interval(end);
          interval = std::remove_reference_t<decltype(interval)>(roles::stream_end);
          frame = frame_of(end);
        }
      });
  return frame;
}

std::string command_name(std::uint8_t id, Direction direction) {
  const char* found = nullptr;
  AllMessages::for_each([&]<class M>(Type<M>) {
    const bool goes_there = M::direction == direction || M::direction == Direction::both;
    const bool has_id = static_cast<std::uint8_t>(M::command) == id;
    if (found == nullptr && goes_there && has_id) found = Meta<M>::info.command;
  });
  return found != nullptr ? found : "command " + std::to_string(id);
}

namespace {

/// Calls `use(name, number, names)` for each number of a message that is not the id of a command;
/// `names` are those of its values, or null.
template <class Use>
void for_each_number(std::uint8_t id, std::span<const std::uint8_t> body, const Use& use) {
  std::ignore = visit(id, body, Direction::from_board, [&]<class M>(const M& message) {
    const auto value = [&](const FieldInfo& field, const auto& member) {
      using Member = std::remove_cvref_t<decltype(member)>;
      if constexpr (std::is_same_v<Member, msg::CommandToBoard> ||
                    std::is_same_v<Member, msg::CommandFromBoard>) {
        // The caller knows which command it is about.
      } else if constexpr (std::is_enum_v<Member>) {
        use(field.name, static_cast<int>(member), &EnumMeta<Member>::info);
      } else if constexpr (std::is_integral_v<Member>) {
        use(field.name, static_cast<int>(member), nullptr);
      }
    };
    Meta<M>::visit(message, [&]<class T>(const FieldInfo& field, const T& member) {
      if constexpr (requires { member.has_value(); }) {
        if (member.has_value()) value(field, *member);
      } else {
        value(field, member);
      }
    });
  });
}

/// The value with that number, or null.
const ValueInfo* value_of(const EnumInfo& names, int number) {
  const ValueInfo* known = nullptr;
  for (const ValueInfo& value : names.values) {
    if (value.value == number) known = &value;
  }
  return known;
}

/// What an error of the board says was the reason; nothing in any other message.
std::optional<roles::ErrorReason> error_reason_in(std::uint8_t id,
                                                  std::span<const std::uint8_t> body) {
  const Frame frame{id, body};
  return roles::is_error(frame) ? std::optional(roles::error_reason(frame)) : std::nullopt;
}

}  // namespace

std::string describe(std::uint8_t id, std::span<const std::uint8_t> body) {
  if (const auto reason = error_reason_in(id, body)) {
    const int code = static_cast<int>(*reason);
    const ValueInfo* known = value_of(EnumMeta<roles::ErrorReason>::info, code);
    return known != nullptr ? known->name : "unknown code " + std::to_string(code);
  }
  std::string text;
  for_each_number(id, body, [&](const char* name, int number, const EnumInfo* names) {
    if (!text.empty()) text += ", ";
    text += name;
    text += ' ';
    const ValueInfo* known = names != nullptr ? value_of(*names, number) : nullptr;
    text += known != nullptr ? known->name + (" (" + std::to_string(number) + ")")
                             : std::to_string(number);
  });
  return text;
}

}  // namespace sbgc::detail
