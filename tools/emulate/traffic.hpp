/// Frames as lines for people.
#pragma once

#include <string>

#include <sbgc/board/board.hpp>

namespace sbgc::emulate {

/// "   1.234  host 0 > CMD_BOARD_INFO (86)  2 bytes  carried out", with `>` for frames to the board
/// and `<` for frames from it.
std::string to_text(const board::Board::Traffic& traffic);

}  // namespace sbgc::emulate
