/// What a request does, in sentences.
#pragma once

#include <string>

#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// True if a request with these effects changes anything, except for a data stream.
bool needs_arming(const MessageInfo& info, Effects effects);

/// Returns sentences such as "The camera can move.".
std::string effect_text(Effects effects);

/// Returns words such as "reads" or "stores, moves".
std::string effect_words(Effects effects);

}  // namespace sbgc::tools
