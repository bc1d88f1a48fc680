/// The search for a board whose line was lost: the times of attempts, the present port of its USB
/// adapter, and the comparison of boards.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/reconnect_options.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/io/ports.hpp>

namespace sbgc::detail {

/// Compares serial numbers, or, if one board has none, the model and the firmware: with a serial
/// number, the firmware may have been updated.
inline bool is_same_board(const BoardIdentity& one, const BoardIdentity& other) {
  if (one.details && other.details) return one.serial_number() == other.serial_number();
  return one.details.has_value() == other.details.has_value() &&
         one.board_version() == other.board_version() &&
         one.firmware_version() == other.firmware_version();
}

/// Returns, e.g., "board 3.0 with firmware 2.59 and serial number 00112233445566778a".
inline std::string words_for(const BoardIdentity& board) {
  std::string text =
      "board " + board.board_version() + " with firmware " + board.firmware_version();
  const std::string number = board.serial_number();
  return number.empty() ? text : text + " and serial number " + number;
}

/// Determines when the next attempt is due, and compares the board that was found.
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

/// The USB adapter behind a serial address, which may get another name when it is re-plugged.
class Adapter {
 public:
  using ListPorts = std::function<io::PortList()>;

  /// `address` is an address of any kind; only a serial port can be an adapter.
  Adapter(std::string address, ListPorts list_ports);

  /// Records the identity of the adapter, which must be plugged in.
  void remember();

  /// Returns the present address of the adapter, or an error if it is not plugged in. Without a
  /// known identity, this is its previous address.
  ///
  /// Adapters are identified by vendor, product and serial number. Several identical ones are an
  /// error, unless `is_board_known`: then the one with the previous name is used, because the board
  /// can be verified.
  Result<std::string> find(bool is_board_known) const;

  /// Records the new address of the adapter.
  void move_to(std::string address) { address_ = std::move(address); }

 private:
  std::string path() const;
  io::PortList list() const;

  std::string address_;
  ListPorts list_ports_;
  std::optional<io::UsbInfo> identity_;
};

}  // namespace sbgc::detail
