/// Reading key presses from a terminal.
#pragma once

#include <optional>

#include <termios.h>

namespace sbgc::tools {

enum class Key : unsigned char { up, down, left, right, character, end };

struct KeyPress {
  Key key{};
  char character{};  ///< for Key::character
};

/// The terminal on standard input, without echo and line buffering. Keys such as Ctrl-C are
/// characters. Restores the terminal on destruction.
class RawTerminal {
 public:
  RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  ~RawTerminal();

  /// Returns the next key without waiting; nothing if none was pressed. Key::end means that the
  /// terminal is gone.
  std::optional<KeyPress> next();

 private:
  termios previous_{};
};

}  // namespace sbgc::tools
