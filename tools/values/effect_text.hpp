/// The effects of a request, in sentences.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// Returns what the request can do. A form that only reads may share its fields with one that does
/// more, as CMD_AHRS_HELPER does: the board looks at their values, so these effects count, too,
/// unless they are 0.
Effects effects_of(const AnyMessage& message);

/// True if a request with these effects changes anything, except for a data stream.
bool needs_arming(const MessageInfo& info, Effects effects);

/// Returns sentences such as "The camera can move.".
std::string effect_text(Effects effects);

/// Returns words such as "reads" or "stores, moves".
std::string effect_words(Effects effects);

/// Returns the effect with this word; nothing if there is none.
std::optional<Effect> effect_of_word(std::string_view word);
std::vector<std::string> known_effect_words();

}  // namespace sbgc::tools
