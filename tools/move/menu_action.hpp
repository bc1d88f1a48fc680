/// The actions of the menu button, by name and as tasks.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/options.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// All actions of the protocol.
std::span<const ValueInfo> menu_actions();
/// The words that all their names begin with, including the last underscore.
std::string_view menu_prefix();
/// For example "profile1".
std::string short_name(const ValueInfo& action);
/// Returns '_' for each '-'.
std::string without_dashes(std::string word);
/// Returns the action with this name, with or without the prefix; null if there is none.
const ValueInfo* menu_action(std::string_view word);

/// Performs an action, and asks for the confirmation where the firmware knows how. Without one, a
/// change of the profile is read back; all else fails with ErrorCode::unconfirmed.
Task<Result<void>> perform(msg::MenuCommand action, CallOptions options);

/// Returns the words of the command that does the same as a menu action; none if there is none.
std::vector<std::string> checked_command(msg::MenuCommand action);

}  // namespace sbgc::tools
