#include "board_text.hpp"

#include <optional>
#include <tuple>
#include <type_traits>

#include <sbgc/dispatch.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/visit.hpp>

namespace sbgc::detail {

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

/// Calls `use(name, number, names)` for each number in a message except command ids; `names`
/// describes its values, or is null.
template <class Use>
void for_each_number(std::uint8_t id, std::span<const std::uint8_t> body, const Use& use) {
  std::ignore = visit(id, body, Direction::from_board, [&]<class M>(const M& message) {
    const auto value = [&](const FieldInfo& field, const auto& member) {
      using Member = std::remove_cvref_t<decltype(member)>;
      if constexpr (std::is_same_v<Member, msg::CommandToBoard> ||
                    std::is_same_v<Member, msg::CommandFromBoard>) {
        // Command ids: the caller already names the command.
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

/// Returns the value with this number, or null.
const ValueInfo* value_of(const EnumInfo& names, int number) {
  const ValueInfo* known = nullptr;
  for (const ValueInfo& value : names.values) {
    if (value.value == number) known = &value;
  }
  return known;
}

/// Returns the reason in an error message of the board; nothing for other messages.
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

std::string undecodable(const Status& status, std::uint8_t id, std::span<const std::uint8_t> body,
                        const Contexts& contexts) {
  return command_name(id, Direction::from_board) +
         " cannot be decoded: " + explain(status, Direction::from_board, id, body, contexts);
}

}  // namespace sbgc::detail
