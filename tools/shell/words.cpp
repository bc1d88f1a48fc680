#include "shell/words.hpp"

namespace sbgc::tools {

namespace {

/// True for what stands for itself only after a backslash or in quotes.
bool is_special(char c) { return std::string_view(" \t'\"\\#").find(c) != std::string_view::npos; }

}  // namespace

Words split_words(std::string_view line) {
  Words result;
  char quote = '\0';
  bool is_in_word = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool is_space = c == ' ' || c == '\t';
    if (!is_in_word) {
      if (is_space) continue;
      if (c == '#') break;
      result.words.emplace_back();
      result.last_begin = i;
      is_in_word = true;
    }
    std::string& word = result.words.back();
    const bool is_escape = c == '\\' && quote != '\'' && i + 1 < line.size() &&
                           (quote == '\0' || line[i + 1] == '"' || line[i + 1] == '\\');
    if (is_escape) {
      word += line[++i];
    } else if (quote == '\0' && is_space) {
      is_in_word = false;
    } else if (quote == '\0' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = '\0';
    } else {
      word += c;
    }
  }
  result.is_complete = quote == '\0';
  return result;
}

Words split_typed(std::string_view line) {
  Words result = split_words(line);
  // With one more character, a word that has ended becomes two.
  const std::size_t words = split_words(std::string(line) + 'x').words.size();
  if (words > result.words.size()) {
    result.words.emplace_back();
    result.last_begin = line.size();
  }
  return result;
}

std::string quoted_word(std::string_view word) {
  std::string result;
  for (const char c : word) {
    if (is_special(c)) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace sbgc::tools
