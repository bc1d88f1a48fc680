/// Messages by name: the own name, such as GetAnglesRequest, or that of the command in the
/// specification, such as CMD_GET_ANGLES; and their effects.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/meta.hpp>

#include "values/message_json.hpp"

namespace sbgc::tools {

// Words that a user can type, for shell completion. Each is defined where the names are known.

/// Returns the names of all messages to the board and of their commands, sorted.
std::vector<std::string> message_names();

/// Returns the paths of the fields of a message to the board; none if there is no such message.
std::vector<std::string> field_names(std::string_view message);

/// Returns the paths of all parameters.
std::vector<std::string> parameter_names();

/// Returns the names of all adjustable variables.
std::vector<std::string> variable_names();

/// Returns the words that `sbgc describe` explains.
std::vector<std::string> described_words();

/// True if the word names a command: in any case, with or without CMD_.
bool is_command_name(std::string_view word, std::string_view command);

/// Parses a word that is a command id: "67" or "0x43".
std::optional<std::uint8_t> parse_command_id(std::string_view word);

/// Returns the message with this name, or the forms of this command that travel in `direction`;
/// empty if there are none. The name of a command may be in lower case and without CMD_, or its
/// number.
std::vector<const MessageType*> messages_named(std::string_view name, Direction direction);

/// Returns the first form that has all these fields. Throws ValueError if there is none.
const MessageType& form_with(const std::vector<const MessageType*>& forms,
                             const std::vector<std::string>& fields);

/// Returns "; did you mean …?", or "" if no name is near.
std::string similar_messages(std::string_view name);

/// Returns the possible effects of the request. A form that only reads may share its fields with
/// one that does more, as CMD_AHRS_HELPER does: the board looks at their values, so these effects
/// count, too, unless the values are 0.
Effects effects_of(const AnyMessage& message);

/// True if a request with these effects changes anything, except for a data stream.
bool needs_arming(const MessageInfo& info, Effects effects);

}  // namespace sbgc::tools
