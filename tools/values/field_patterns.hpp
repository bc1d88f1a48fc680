/// Patterns that select fields of a message by their paths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "values/message_json.hpp"

namespace sbgc::tools {

/// True if the text matches: * stands for any characters, ? for one.
bool matches_glob(std::string_view pattern, std::string_view text);

/// Returns true for those of `paths` that the patterns select, in their order. A pattern is
/// - a glob for the whole path: "axes.*.angle",
/// - a path, or the part of it before a dot or bracket: "angle" for "angle.roll",
/// - the end of a path after a dot, if it is unique: "cycle_time",
/// - the name in the specification: "ANGLE_ROLL".
/// `patterns` are separated by commas; without any, all are selected. Throws CommandError for a
/// pattern that selects nothing, with suggestions.
std::vector<bool> chosen_fields(std::string_view patterns, const MessageType& message,
                                const std::vector<std::string>& paths);

}  // namespace sbgc::tools
