/// An action of the menu button, as a task.
#pragma once

#include <sbgc/client/options.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/enums.hpp>

namespace sbgc::tools {

/// Performs an action, and asks for the confirmation where the firmware knows how. Without one, a
/// change of the profile is read back; all else fails with ErrorCode::unconfirmed.
Task<Result<void>> perform(msg::MenuCommand action, CallOptions options);

}  // namespace sbgc::tools
