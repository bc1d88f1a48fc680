/// Suggestions for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sbgc::detail {

/// Returns the words of `known` that are nearest to `word`, if any is near: it begins with the
/// word, or few letters differ. Ignores leading dashes.
std::vector<std::string> nearest(std::string_view word, const std::vector<std::string>& known);

/// Joins words to "a", "a or b", "a, b or c", optionally quoted; `last` is the conjunction.
std::string alternatives(const std::vector<std::string>& words, bool quoted,
                         const char* last = "or");

/// Returns "; did you mean 'a' or 'b'?". Without words, returns "; " and `otherwise`, or "" if that
/// is empty too.
std::string did_you_mean(const std::vector<std::string>& words, const std::string& otherwise = "");

}  // namespace sbgc::detail
