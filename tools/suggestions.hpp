/// What somebody may have meant who has mistyped a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// Those of `known` that are nearest to `word`, if any is near: it begins with the word, or few
/// letters have to be changed. Dashes in front do not count.
std::vector<std::string> nearest(std::string_view word, const std::vector<std::string>& known);

/// "a", "a or b", "a, b or c", in quotes if wanted.
std::string alternatives(const std::vector<std::string>& words, bool quoted);

}  // namespace sbgc::tools
