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
/// The common prefix of all their names, including the last underscore.
std::string_view menu_prefix();
/// For example "profile1".
std::string short_name(const ValueInfo& action);
/// Replaces each '-' by '_'.
std::string without_dashes(std::string word);
/// Returns the action with this name, with or without the prefix; null if there is none.
const ValueInfo* menu_action(std::string_view word);

/// Performs an action, and requests a confirmation if the firmware supports it. Without one, a
/// change of the profile is verified by reading; all else fails with ErrorCode::unconfirmed.
Task<Result<void>> perform(msg::MenuCommand action, CallOptions options);

/// Returns the words of the command that corresponds to a menu action; empty if there is none.
std::vector<std::string> checked_command(msg::MenuCommand action);

}  // namespace sbgc::tools
