/// The effects of a request, in sentences.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/meta.hpp>

namespace sbgc::tools {

/// Returns sentences such as "The camera can move.".
std::string effect_text(Effects effects);

/// Returns words such as "reads" or "stores, moves".
std::string effect_words(Effects effects);

/// Returns the effect named by this word; nothing if there is none.
std::optional<Effect> effect_of_word(std::string_view word);
std::vector<std::string> known_effect_words();

}  // namespace sbgc::tools
