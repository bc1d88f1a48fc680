/// A stable name for a pseudo-terminal.
#pragma once

#include <string>

namespace sbgc::hosts {

/// A symbolic link to a pseudo-terminal that exists as long as this object. Replaces only links
/// that an emulator left behind: those to a pseudo-terminal that is gone, or to this one.
class TerminalLink {
 public:
  /// Throws std::runtime_error if the link cannot be created or the name is in use.
  TerminalLink(std::string path, std::string terminal);
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;
  /// Removes the link unless it was replaced.
  ~TerminalLink();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string terminal_;
};

}  // namespace sbgc::hosts
