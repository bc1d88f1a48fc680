/// Whether two connections lead to the same board.
#pragma once

#include <string>

#include <sbgc/client/board_identity.hpp>

namespace sbgc::detail {

/// Compares serial numbers, or, if one board has none, the model and the firmware: with a serial
/// number, the firmware may have been updated.
inline bool is_same_board(const BoardIdentity& one, const BoardIdentity& other) {
  if (one.details && other.details) return one.serial_number() == other.serial_number();
  return one.details.has_value() == other.details.has_value() &&
         one.board_version() == other.board_version() &&
         one.firmware_version() == other.firmware_version();
}

/// For example "board 3.0 with firmware 2.59 and serial number 00112233445566778a".
inline std::string words_for(const BoardIdentity& board) {
  std::string text =
      "board " + board.board_version() + " with firmware " + board.firmware_version();
  const std::string number = board.serial_number();
  return number.empty() ? text : text + " and serial number " + number;
}

}  // namespace sbgc::detail
