/// A stable name for a pseudo-terminal.
#pragma once

#include <string>

namespace sbgc::serving {

/// A symbolic link to a pseudo-terminal, for as long as this exists. It never takes the place of
/// anything but a link that an emulator has left behind: one to a pseudo-terminal that is gone, or
/// that has become the one to link to.
class TerminalLink {
 public:
  /// Throws std::runtime_error if it can not be made, or if something else has the name.
  TerminalLink(std::string path, std::string terminal);
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;
  /// Removes it, if it still is what was made.
  ~TerminalLink();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string terminal_;
};

}  // namespace sbgc::serving
