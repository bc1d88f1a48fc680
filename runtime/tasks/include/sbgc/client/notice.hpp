/// Unsolicited events on the line.
#pragma once

#include <cstdint>
#include <string>

namespace sbgc {

/// The kind of an event that happened outside of any call.
enum class NoticeKind : std::uint8_t {
  board_reset,   ///< the board restarted: pending calls have failed, data streams have ended
  board_error,   ///< the board reported an error outside any call; Notice::detail is its code
  link_lost,     ///< the line broke; all further calls fail
  unreadable,    ///< a message for a subscriber, such as a sample of a stream, does not decode;
                 ///< repeated only if the message changes
  polling,       ///< the firmware has no data streams: the client requests each message of one
  stream_ended,  ///< only from a client that reconnects: a stream could not be restarted
};

/// An event that happened outside of any call.
struct Notice {
  NoticeKind kind{};
  std::string message{};  ///< for people: a sentence without a final period
  int detail{};
  std::uint8_t command{};  ///< that of a board_error, 0 if unknown, or of an unreadable message
};

}  // namespace sbgc
