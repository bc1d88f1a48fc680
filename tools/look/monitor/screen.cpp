#include "look/monitor/screen.hpp"

#include <clocale>
#include <cstdlib>
#include <cstring>
#include <string>

#include <langinfo.h>
#include <poll.h>
#include <unistd.h>

// Without it, ncurses defines functions as macros.
#define NCURSES_NOMACROS  // NOLINT(readability-identifier-naming)
#include <curses.h>

#include "command/command_error.hpp"
#include "command/system.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

constexpr short title_pair = 1;
constexpr short good_pair = 2;
constexpr short bad_pair = 3;
constexpr short accent_pair = 4;

attr_t attributes(Style style) {
  const auto pair = [](short number) { return static_cast<attr_t>(COLOR_PAIR(number)); };
  switch (style) {
    case Style::normal: return A_NORMAL;
    case Style::bold: return A_BOLD;
    case Style::dim: return A_DIM;
    case Style::title: return has_colors() ? pair(title_pair) : A_REVERSE;
    case Style::good: return pair(good_pair);
    case Style::bad: return pair(bad_pair) | A_BOLD;
    case Style::accent: return pair(accent_pair);
  }
  return A_NORMAL;
}

void set_colors() {
  const char* const no_color = std::getenv("NO_COLOR");
  if (!has_colors() || (no_color != nullptr && *no_color != '\0')) return;
  start_color();
  use_default_colors();
  init_pair(title_pair, COLOR_BLACK, COLOR_CYAN);
  init_pair(good_pair, COLOR_GREEN, -1);
  init_pair(bad_pair, COLOR_RED, -1);
  init_pair(accent_pair, COLOR_CYAN, -1);
}

}  // namespace

Screen::Screen() {
  if (!is_terminal(stdin) || !is_terminal(stdout)) throw CommandError("this needs a terminal");
  std::setlocale(LC_CTYPE, "");
  has_utf8_ = std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
  if (newterm(nullptr, stdout, stdin) == nullptr) {
    const char* const type = std::getenv("TERM");
    throw CommandError(std::string("the type of the terminal is unknown: TERM is '") +
                       (type == nullptr ? "" : type) +
                       "'; `sbgc stream` prints live data anywhere");
  }
  cbreak();
  noecho();
  nonl();
  keypad(stdscr, true);
  nodelay(stdscr, true);
  set_escdelay(25);
  curs_set(0);
  set_colors();
}

Screen::~Screen() { endwin(); }

std::size_t Screen::width() const { return static_cast<std::size_t>(getmaxx(stdscr)); }
std::size_t Screen::height() const { return static_cast<std::size_t>(getmaxy(stdscr)); }

void Screen::clear() { werase(stdscr); }

// NOLINTNEXTLINE(readability-make-member-function-const): it changes the screen
void Screen::put(std::size_t row, std::size_t column, std::string_view any_text, Style style) {
  if (row >= height() || column >= width()) return;
  const std::string text = printable(any_text);
  const attr_t attribute = is_faint_ ? A_DIM : attributes(style);
  wattrset(stdscr, static_cast<int>(attribute));
  // A text beyond the right edge would continue in the next row. The number of bytes is an upper
  // bound of the number of characters, which ncurses counts.
  wmove(stdscr, static_cast<int>(row), static_cast<int>(column));
  std::size_t left = width() - column;
  std::size_t size = 0;
  while (size < text.size() && left > 0) {
    ++size;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) ++size;
    --left;
  }
  waddnstr(stdscr, text.data(), static_cast<int>(size));
  wattrset(stdscr, static_cast<int>(A_NORMAL));
}

void Screen::fill(std::size_t row, Style style) { put(row, 0, std::string(width(), ' '), style); }

void Screen::show() { wrefresh(stdscr); }

std::optional<int> Screen::wait_for_key(std::chrono::milliseconds time) {
  int code = wgetch(stdscr);
  if (code == ERR) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    ::poll(&input, 1, static_cast<int>(time.count()));
    code = wgetch(stdscr);
  }
  switch (code) {
    case ERR: return std::nullopt;
    case KEY_UP: return key::up;
    case KEY_DOWN: return key::down;
    case KEY_LEFT: return key::left;
    case KEY_RIGHT: return key::right;
    case KEY_PPAGE: return key::page_up;
    case KEY_NPAGE: return key::page_down;
    case KEY_HOME: return key::home;
    case KEY_END: return key::end;
    case KEY_RESIZE: return key::resized;
    default: return code;
  }
}

}  // namespace sbgc::tools
