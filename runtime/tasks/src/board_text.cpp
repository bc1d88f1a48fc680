#include "board_text.hpp"

#include <optional>

#include <sbgc/any.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::detail {

std::string command_name(std::uint8_t id, Direction direction) {
  for (const MessageType* const type : message_types()) {
    const MessageInfo& info = *type->info;
    if (info.travels(direction) && info.id == id) return info.command;
  }
  return "command " + std::to_string(id);
}

namespace {

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
  const MessageType* const type = find_message(Direction::from_board, id, body.size());
  if (type == nullptr) return {};
  AnyMessage message = type->make();
  if (!message.decode(body)) return {};
  std::string text;
  message.for_each_leaf([&](const Leaf& leaf) {
    const EnumInfo* const names = leaf.names;
    // The caller already names the command.
    const bool is_command = names == &EnumMeta<msg::CommandToBoard>::info ||
                            names == &EnumMeta<msg::CommandFromBoard>::info;
    const bool is_flags = names != nullptr && names->is_flags;
    const bool is_other = is_command || is_flags || leaf.unit != nullptr || leaf.packed != nullptr;
    if (leaf.kind != LeafKind::integer || is_other || leaf.path.parent != nullptr) return;
    if (!text.empty()) text += ", ";
    text += leaf.field.name;
    text += ' ';
    const int number = static_cast<int>(leaf.integer);
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
