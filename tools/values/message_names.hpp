/// Messages by name: ours, such as GetAnglesRequest, or that of the command in the specification,
/// such as CMD_GET_ANGLES.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "values/message_json.hpp"
#include "values/names.hpp"

namespace sbgc::tools {

/// True if the word names a command: in any case, with or without CMD_.
bool is_command_name(std::string_view word, std::string_view command);

/// Returns the id of a command that the word consists of: "67" or "0x43".
std::optional<std::uint8_t> parse_command_id(std::string_view word);

/// Returns the message with this name of ours, or the forms of this command that travel in
/// `direction`; none if there are none. The name of a command may be in lower case and without
/// CMD_, or be its number.
std::vector<const MessageType*> messages_named(std::string_view name, Direction direction);

/// Returns the first of the forms that has all these fields. Throws ValueError if none has.
const MessageType& form_with(const std::vector<const MessageType*>& forms,
                             const std::vector<std::string>& fields);

/// Returns "; did you mean …?", or "" if no name is near.
std::string similar_messages(std::string_view name);

}  // namespace sbgc::tools
