/// A stable name for a pseudo-terminal.
#pragma once

#include <string>

namespace sbgc::serving {

/// A symbolic link to a pseudo-terminal, for as long as this object exists. It only replaces a link
/// that an emulator has left behind: one to a pseudo-terminal that is gone, or that is now the one
/// to link to.
class TerminalLink {
 public:
  /// Throws std::runtime_error if the link cannot be created or something else has the name.
  TerminalLink(std::string path, std::string terminal);
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;
  /// Removes the link, unless it has been replaced.
  ~TerminalLink();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string terminal_;
};

}  // namespace sbgc::serving
