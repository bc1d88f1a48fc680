/// Unsolicited events on the line.
#pragma once

#include <cstdint>
#include <string>

namespace sbgc {

enum class NoticeKind : std::uint8_t {
  board_reset,   ///< the board restarted: pending calls have failed, data streams have ended
  board_error,   ///< the board reported an error outside any call; Notice::detail is its code
  link_lost,     ///< the line broke; all further calls fail
  stream_ended,  ///< only of ReconnectingClient: a data stream could not be started again
};

struct Notice {
  NoticeKind kind{};
  std::string message{};  ///< for people: a sentence without a final period
  int detail{};
  std::uint8_t command{};  ///< the command that a board_error concerns; 0 if unknown
};

}  // namespace sbgc
