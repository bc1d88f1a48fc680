/// Keys of a terminal, as they are pressed.
#pragma once

#include <optional>

#include <termios.h>

namespace sbgc::tools {

enum class Key : unsigned char { up, down, left, right, character, end };

struct KeyPress {
  Key key{};
  char character{};  ///< for Key::character
};

/// The terminal on standard input, without echo, and without waiting for lines. Keys such as Ctrl-C
/// are characters. Restores the terminal at its end.
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
