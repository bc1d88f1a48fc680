#include "command/terminal_restorer.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#define NCURSES_NOMACROS
#include <curses.h>
#include <term.h>

namespace sbgc::tools {

namespace {

constexpr char released = 'r';

std::string collected;  // tputs() passes nothing to its function but the character

int collect(int character) {
  collected += static_cast<char>(character);
  return character;
}

/// Returns what leaves the full-screen view. It is written at once: the shell may print its prompt
/// at the same time, which must not divide an escape sequence.
std::string leaving_sequence() {
  collected.clear();
  for (const char* const name : {"sgr0", "rmkx", "cnorm", "rmcup"}) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): terminfo takes no const
    const char* const text = tigetstr(const_cast<char*>(name));
    // tigetstr() returns -1 for what is no text.
    const bool is_text = text != nullptr && reinterpret_cast<std::intptr_t>(text) != -1;
    if (is_text) tputs(text, 1, collect);
  }
  return collected;
}

[[noreturn]] void wait_and_restore(int input, const termios& before, const std::string& leaving) {
  // The signals of the terminal are for the command; the last one is sent while restoring it.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGTTOU}) {
    ::signal(signal, SIG_IGN);
  }
  char mark = 0;
  ssize_t size = 0;
  do {
    size = ::read(input, &mark, 1);
  } while (size == -1 && errno == EINTR);
  if (mark != released) {
    [[maybe_unused]] const auto written = ::write(STDOUT_FILENO, leaving.data(), leaving.size());
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
  }
  ::_exit(0);
}

}  // namespace

TerminalRestorer::TerminalRestorer(Screen screen) {
  termios before{};
  std::array<int, 2> ends{};
  int problem = 0;
  if (::tcgetattr(STDIN_FILENO, &before) != 0) return;
  if (setupterm(nullptr, STDOUT_FILENO, &problem) != OK) return;
  const std::string leaving = screen == Screen::full ? leaving_sequence() : "";
  del_curterm(cur_term);
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  const io::detail::Descriptor input(ends[0]);
  alive_ = io::detail::Descriptor(ends[1]);
  process_ = ::fork();
  if (process_ == 0) {
    alive_ = {};
    wait_and_restore(input.get(), before, leaving);
  }
}

TerminalRestorer::~TerminalRestorer() {
  if (!alive_) return;
  [[maybe_unused]] const auto size = ::write(alive_.get(), &released, sizeof released);
  if (process_ > 0) ::waitpid(process_, nullptr, 0);
}

}  // namespace sbgc::tools
