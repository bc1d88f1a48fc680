/// The effects of a request on a board.
#pragma once

#include <sbgc/any.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// Returns what the request can do. A form that only reads may share its fields with one that does
/// more, as CMD_AHRS_HELPER does: the board looks at their values, so these effects count, too,
/// unless they are 0.
Effects effects_of(const AnyMessage& message);

/// True if a request with these effects changes anything, except for a data stream.
bool needs_arming(const MessageInfo& info, Effects effects);

}  // namespace sbgc::tools
