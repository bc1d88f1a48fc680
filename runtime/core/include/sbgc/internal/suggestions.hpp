/// Suggestions for mistyped words.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::detail {

/// The edit distance: letters to insert, remove, replace or swap with the next one.
inline std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, last[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last.back();
}

inline std::string_view without_dashes(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// Returns the words of `known` that are nearest to `word`, if any is near enough: it begins with
/// the word, or few letters differ. Ignores leading dashes.
inline std::vector<std::string> nearest(std::string_view word,
                                        const std::vector<std::string>& known) {
  word = without_dashes(word);
  constexpr std::size_t longest = 64;
  if (word.empty() || word.size() > longest) return {};
  // With more changed letters, it is another word.
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1);
  std::vector<std::string> result;
  for (const std::string& candidate : known) {
    const std::string_view other = without_dashes(candidate);
    const bool is_begin = word.size() > 1 && other.starts_with(word);
    std::size_t changes = distance(word, other);
    if (is_begin) changes = std::min<std::size_t>(changes, 1);
    if (changes > std::min(least, (other.size() + 1) / 3) || changes >= other.size()) continue;
    if (changes < least) result.clear();
    least = changes;
    result.push_back(candidate);
  }
  return result;
}

/// Joins words to "a", "a or b", "a, b or c", optionally quoted; `last` is the conjunction.
inline std::string alternatives(const std::vector<std::string>& words, bool quoted,
                                const char* last = "or") {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != 0) result += i + 1 == words.size() ? std::string(" ") + last + " " : ", ";
    result += quoted ? "'" + words[i] + "'" : words[i];
  }
  return result;
}

/// Returns "; did you mean 'a' or 'b'?". Without words, returns "; " and `otherwise`, or "" if that
/// is empty too.
inline std::string did_you_mean(const std::vector<std::string>& words,
                                const std::string& otherwise = "") {
  if (!words.empty()) return "; did you mean " + alternatives(words, true) + "?";
  return otherwise.empty() ? "" : "; " + otherwise;
}

}  // namespace sbgc::detail
