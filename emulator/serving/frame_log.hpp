/// Frames as lines for people.
#pragma once

#include <string>
#include <vector>

#include <sbgc/emulator/board.hpp>

namespace sbgc::emulate {

/// "    1.2340  host 0 > CMD_BOARD_INFO (86), 0 bytes  carried out", with `>` for frames to the
/// board and `<` for frames from it.
std::string to_text(const board::Board::Traffic& traffic);

/// Puts lines into the order in which people expect them: the board tells what has come of a
/// request after it has answered.
class TrafficLines {
 public:
  void add(const board::Board::Traffic& traffic);
  /// Takes the lines since the last call. Not while a request is being dealt with.
  std::vector<std::string> take();

 private:
  std::vector<std::string> lines_{};
  std::size_t answers_ = 0;  // at the end of lines_, without the request that they may answer
  Instant at_{};
  std::size_t port_ = 0;
};

}  // namespace sbgc::emulate
