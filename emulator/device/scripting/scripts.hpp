/// User scripts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/time.hpp>

#include "device/storage/file_system.hpp"

namespace sbgc::emulator {

class Ports;

/// Runs one script at a time. The script language is undocumented. Assumptions: a script is text
/// whose lines are commands that only take time; the script of a slot is the file with the number
/// of the slot.
class Scripts {
 public:
  /// Slots count from 0. Assumption.
  static constexpr std::uint8_t slots =
      std::tuple_size_v<decltype(msg::BoardInfo3::script_slot_size)>;

  /// True if this board supports scripts.
  static bool are_supported(const BoardOptions& options);
  /// Starts a script and ends the running one. `port` receives CMD_SCRIPT_DEBUG for each command
  /// and at the end. Returns the reason if it cannot start.
  std::optional<msg::BoardErrorCode> start(const FileSystem& files, std::uint8_t slot,
                                           std::optional<std::size_t> port, Instant now);
  void stop() { run_.reset(); }
  /// The slot of the running script.
  std::optional<std::uint8_t> running() const;
  /// The number of its current command, from 1; 0 if no script is running.
  std::uint16_t command() const { return run_ ? run_->command : 0; }

  void drop_port(std::size_t port);

  Instant next() const;
  void advance(Instant now, const FileSystem& files, Ports& ports);

 private:
  struct Run {
    std::uint8_t slot{};
    std::optional<std::size_t> port{};
    std::uint16_t commands{};  ///< in the script
    std::uint16_t command{};
    Instant due{};  ///< end of the command
  };

  void report(Ports& ports, msg::FileError error) const;

  std::optional<Run> run_{};
};

}  // namespace sbgc::emulator
