/// Reads lines from a user or a file, and splits them into words.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// Reads lines of standard input. On a terminal it shows a prompt; if built with libedit, it
/// supports editing keys, completion with Tab, and a history stored in a file.
class LineEditor {
 public:
  /// Returns the possible replacements for the last word of a line.
  using Complete = std::function<std::vector<std::string>(std::string_view line)>;

  LineEditor(std::string prompt, Complete complete);
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;
  ~LineEditor();

  /// True for a user at a terminal.
  bool is_interactive() const { return is_interactive_; }

  /// Returns the next line without its end; nothing at the end of the input. Ctrl-C returns an
  /// empty line. Throws CommandError if the input is not text.
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
  std::size_t last_begin = 0;  ///< where the last word of the line begins
  bool is_complete = true;     ///< every quote is closed
};

/// Splits a line at spaces outside of quotes. A # at the beginning of a word begins a comment.
Words split_words(std::string_view line);

/// The same for an incomplete line: a space at its end begins another word.
Words split_typed(std::string_view line);

/// Returns the word quoted for a line: split_words() returns it unchanged.
std::string quoted_word(std::string_view word);

}  // namespace sbgc::tools
