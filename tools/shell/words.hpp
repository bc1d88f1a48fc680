/// Lines of commands as words, as a POSIX shell reads them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

struct Words {
  std::vector<std::string> words{};
  std::size_t last_begin = 0;  ///< where the last word begins in the line
  bool is_complete = true;     ///< every quote has its end
};

/// Splits a line at spaces outside of quotes. After # at the begin of a word, there is a comment.
Words split_words(std::string_view line);

/// The same for a line that is being typed: a space at its end begins one more word.
Words split_typed(std::string_view line);

/// Returns the word as a line has it: split_words() returns it again.
std::string quoted_word(std::string_view word);

}  // namespace sbgc::tools
