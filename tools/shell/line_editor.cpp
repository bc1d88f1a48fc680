#include "shell/line_editor.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <histedit.h>

#include "command/command_error.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"

#ifdef SBGC_HAS_LIBEDIT
#endif
namespace sbgc::tools {

#ifdef SBGC_HAS_LIBEDIT

namespace {

/// Returns $XDG_STATE_HOME/sbgc/history, or ~/.local/state/sbgc/history; "" if there is no folder.
std::string history_file() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  std::filesystem::path folder = state == nullptr ? "" : state;
  if (folder.empty() && home != nullptr) folder = std::filesystem::path(home) / ".local/state";
  if (folder.empty()) return "";
  folder /= "sbgc";
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  return failed ? "" : (folder / "history").string();
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Returns the common prefix of all words.
std::string common_begin(const std::vector<std::string>& words) {
  std::string result = words.front();
  for (const std::string& word : words) {
    const auto end = std::ranges::mismatch(result, word).in1;
    result.erase(end, result.end());
  }
  return result;
}

/// Prints words in columns below the line.
void list_words(const std::vector<std::string>& words) {
  std::size_t widest = 0;
  for (const std::string& word : words) widest = std::max(widest, characters(word) + 2);
  const std::size_t in_row = std::max<std::size_t>(line_width() / widest, 1);
  fmt::print("\n");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool ends_row = (i + 1) % in_row == 0 || i + 1 == words.size();
    fmt::print("{:{}}{}", printable(words[i]), ends_row ? 0 : widest, ends_row ? "\n" : "");
  }
  std::fflush(stdout);
}

}  // namespace

/// Uses libedit, with one history.
class LineEditor::Editing {
 public:
  Editing(std::string prompt, Complete complete)
      : prompt_(std::move(prompt)),
        complete_(std::move(complete)),
        editor_(el_init("sbgc", stdin, stdout, stderr), el_end),
        history_(history_init(), history_end),
        file_(history_file()) {
    el_set(editor_.get(), EL_CLIENTDATA, this);
    el_set(editor_.get(), EL_PROMPT, &show_prompt);
    el_set(editor_.get(), EL_EDITOR, "emacs");
    el_set(editor_.get(), EL_SIGNAL, 1);
    el_set(editor_.get(), EL_HIST, history, history_.get());
    el_set(editor_.get(), EL_ADDFN, "sbgc-complete", "Complete a word", &press_tab);
    el_set(editor_.get(), EL_BIND, "^I", "sbgc-complete", nullptr);
    el_set(editor_.get(), EL_BIND, "^R", "em-inc-search-prev", nullptr);
    constexpr int most_lines = 1000;
    history(history_.get(), &event_, H_SETSIZE, most_lines);
    history(history_.get(), &event_, H_SETUNIQUE, 1);
    if (!file_.empty()) history(history_.get(), &event_, H_LOAD, file_.c_str());
  }

  std::optional<std::string> read() {
    int size = 0;
    const char* const typed = el_gets(editor_.get(), &size);
    if (typed == nullptr || size <= 0) {
      fmt::print("\n");
      std::fflush(stdout);
      if (size < 0) return "";  // Ctrl-C
      return std::nullopt;
    }
    std::string line(typed, static_cast<std::size_t>(size));
    while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
    return line;
  }

  void keep(const std::string& line) {
    if (line.find_first_not_of(" \t") == std::string::npos) return;
    history(history_.get(), &event_, H_ENTER, line.c_str());
    // At once, because a signal may end the program. libedit sets the mode to 0600.
    if (!file_.empty()) history(history_.get(), &event_, H_SAVE, file_.c_str());
  }

 private:
  static Editing& of(EditLine* editor) {
    void* self = nullptr;
    el_get(editor, EL_CLIENTDATA, &self);
    return *static_cast<Editing*>(self);
  }
  static char* show_prompt(EditLine* editor) { return of(editor).prompt_.data(); }
  static unsigned char press_tab(EditLine* editor, int) { return of(editor).complete(); }

  unsigned char complete() {
    const ::LineInfo* const info = el_line(editor_.get());
    const std::string_view line(info->buffer,
                                static_cast<std::size_t>(info->cursor - info->buffer));
    std::vector<std::string> words = complete_(line);
    if (words.empty()) return CC_ERROR;
    std::ranges::sort(words);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    const Words typed = split_typed(line);
    std::string inserted = common_begin(words);
    const bool is_longer = inserted.size() > typed.words.back().size();
    const bool is_only = words.size() == 1;
    const bool goes_on =
        inserted.ends_with('=') || inserted.ends_with('/') || inserted.ends_with(':');
    if (is_longer || is_only) {
      el_deletestr(editor_.get(), static_cast<int>(characters(line.substr(typed.last_begin))));
      inserted = quoted_word(inserted) + (is_only && !goes_on ? " " : "");
      el_insertstr(editor_.get(), inserted.c_str());
      return CC_REFRESH;
    }
    list_words(words);
    return CC_REDISPLAY;
  }

  std::string prompt_;
  Complete complete_;
  std::unique_ptr<EditLine, void (*)(EditLine*)> editor_;
  std::unique_ptr<::History, void (*)(::History*)> history_;
  std::string file_;
  HistEvent event_{};
};

#else

/// Without libedit, the terminal does the editing.
class LineEditor::Editing {
 public:
  Editing(std::string, const Complete&) {}
  static std::optional<std::string> read() { return std::nullopt; }
  static void keep(const std::string&) {}
};

#endif

LineEditor::LineEditor(std::string prompt, [[maybe_unused]] Complete complete)
    : is_interactive_(is_terminal(stdin)), prompt_(std::move(prompt)) {
#ifdef SBGC_HAS_LIBEDIT
  if (is_interactive_ && is_terminal(stdout) && !is_dumb_terminal()) {
    editing_ = std::make_unique<Editing>(prompt_, std::move(complete));
  }
#endif
}

LineEditor::~LineEditor() = default;

void LineEditor::keep(const std::string& line) {
  if (editing_) editing_->keep(line);
}

std::optional<std::string> LineEditor::read() {
  if (editing_) return editing_->read();
  if (is_interactive_) remark_as_is(prompt_);
  std::string line;
  if (!std::getline(std::cin, line)) {
    if (is_interactive_) remark_as_is("\n");
    return std::nullopt;
  }
  if (line.ends_with('\r')) line.pop_back();
  if (std::exchange(is_first_, false) && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  return line;
}

namespace {

/// True for characters that must be escaped or quoted.
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
  // If the word has ended, one more character adds another word.
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
