#include "move/raw_terminal.hpp"

#include <array>
#include <cerrno>
#include <string_view>

#include <poll.h>
#include <unistd.h>

namespace sbgc::tools {

namespace {

/// Returns true if a byte arrives within `milliseconds`.
bool has_input(int milliseconds) {
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  return ::poll(&waiting, 1, milliseconds) > 0;
}

/// Returns a byte, or nothing at the end of the input.
std::optional<char> read_byte() {
  char byte = 0;
  ssize_t size = 0;
  do {
    size = ::read(STDIN_FILENO, &byte, 1);
  } while (size < 0 && errno == EINTR);
  if (size != 1) return std::nullopt;
  return byte;
}

}  // namespace

RawTerminal::RawTerminal() {
  ::tcgetattr(STDIN_FILENO, &previous_);
  termios raw = previous_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

RawTerminal::~RawTerminal() {
  // TCSAFLUSH would wait until the terminal has shown all output.
  ::tcflush(STDIN_FILENO, TCIFLUSH);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &previous_);
}

std::optional<KeyPress> RawTerminal::next() {
  constexpr char escape = '\033';
  // The bytes of one key arrive together.
  constexpr int sequence_time = 20;
  if (!has_input(0)) return std::nullopt;
  const std::optional<char> first = read_byte();
  if (!first) return KeyPress{Key::end};
  if (*first != escape || !has_input(sequence_time)) return KeyPress{Key::character, *first};
  const std::optional<char> second = read_byte();
  if (!second) return KeyPress{Key::end};
  if ((*second != '[' && *second != 'O') || !has_input(sequence_time)) {
    return KeyPress{Key::character, *second};
  }
  const std::optional<char> third = read_byte();
  if (!third) return KeyPress{Key::end};
  constexpr std::string_view arrows = "ABCD";
  constexpr std::array keys{Key::up, Key::down, Key::right, Key::left};
  const std::size_t arrow = arrows.find(*third);
  if (arrow == std::string_view::npos) return KeyPress{Key::character};
  return KeyPress{keys[arrow]};
}

}  // namespace sbgc::tools
