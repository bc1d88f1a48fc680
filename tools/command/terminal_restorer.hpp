/// Gives a terminal back even if its program is killed.
#pragma once

#include <sys/types.h>

#include <sbgc/io/internal/descriptor.hpp>

namespace sbgc::tools {

/// While it exists, a second process waits for the end of this one, and if that comes first, sets
/// the terminal back to what it was. Must be created before any thread.
class TerminalRestorer {
 public:
  enum class Screen : unsigned char {
    normal,  ///< the program changes only the settings of the terminal
    full,    ///< it also uses the alternate screen
  };

  explicit TerminalRestorer(Screen screen);
  TerminalRestorer(const TerminalRestorer&) = delete;
  TerminalRestorer& operator=(const TerminalRestorer&) = delete;
  ~TerminalRestorer();

 private:
  pid_t process_ = -1;
  io::detail::Descriptor alive_{};  // closed by the end of this process
};

}  // namespace sbgc::tools
