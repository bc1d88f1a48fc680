/// The search for a board whose line was lost, without I/O and threads.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/reconnect_options.hpp>

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

/// Says when the next attempt is due, and what to think of the board that was found.
class Search {
 public:
  explicit Search(const ReconnectOptions& options)
      : pause_(options.first_pause),
        longest_pause_(options.longest_pause),
        most_attempts_(options.attempts) {}

  /// Records a failed attempt. Returns the pause before the next one; nothing after the last.
  std::optional<std::chrono::milliseconds> failed() {
    if (++attempts_ == most_attempts_) return std::nullopt;
    return std::exchange(pause_, std::min(pause_ * 2, longest_pause_));
  }

  /// True if this is another board than that of the last attempt.
  bool is_news(const BoardIdentity& other) {
    if (other_ && is_same_board(other, *other_)) return false;
    other_ = other;
    return true;
  }

 private:
  std::chrono::milliseconds pause_;
  std::chrono::milliseconds longest_pause_;
  unsigned most_attempts_;  // 0: any number
  unsigned attempts_ = 0;
  std::optional<BoardIdentity> other_{};
};

}  // namespace sbgc::detail
