/// What happens on the line without having been asked for.
#pragma once

#include <cstdint>
#include <string>

namespace sbgc {

enum class NoticeKind : std::uint8_t {
  board_reset,  ///< the board has restarted: calls under way have failed, data streams have ended
  board_error,  ///< the board reports an error that belongs to no call; Notice::detail is its code
  link_lost,    ///< the line broke; every call fails from now on
};

struct Notice {
  NoticeKind kind{};
  std::string message{};  ///< for people: a sentence without a final stop
  int detail{};
  std::uint8_t command{};  ///< what a board_error is about; 0 if it does not say
};

}  // namespace sbgc
