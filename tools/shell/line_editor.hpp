/// Lines that a user types, or that a file has, and their words.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// Reads lines of standard input. On a terminal it shows a prompt; if it was built with libedit,
/// there are keys for editing, completion by Tab, and a history that a file keeps.
class LineEditor {
 public:
  /// Returns the words that can stand at the end of a line, in place of its last word.
  using Complete = std::function<std::vector<std::string>(std::string_view line)>;

  LineEditor(std::string prompt, Complete complete);
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;
  ~LineEditor();

  /// True if somebody types on a terminal.
  bool is_interactive() const { return is_interactive_; }

  /// Returns the next line without its end; nothing at the end of the input. Ctrl-C makes a line
  /// empty. Throws CommandError if the input is no text.
  std::optional<std::string> read();

  /// Adds a line to the history.
  void keep(const std::string& line);

 private:
  class Editing;

  bool is_interactive_;
  bool is_first_ = true;  // line
  std::string prompt_;
  std::unique_ptr<Editing> editing_;
};

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
