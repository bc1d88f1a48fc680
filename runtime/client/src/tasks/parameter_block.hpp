/// Reading and writing the settings of one message.
#pragma once

#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>

#include "settings_kind.hpp"
#include "tasks/tools.hpp"

namespace sbgc::detail {

CallOptions settings_options(const Deadline& deadline);

/// `deadline` is that of the task that this belongs to.
Task<Result<Block>> read_block(const SettingsKind& kind, std::uint8_t copy,
                               const Deadline& deadline);

}  // namespace sbgc::detail
