/// User scripts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <sbgc/enums.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/time.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

/// Runs one script at a time. The script language is not published. Assumptions: a script is a text
/// whose lines are commands that take time and do nothing else; the script of a slot is the file
/// with the slot's number.
class Scripts {
 public:
  /// Slots count from 0 (an assumption).
  static constexpr std::uint8_t slots =
      std::tuple_size_v<decltype(msg::BoardInfo3::script_slot_size)>;

  /// Whether this board runs scripts at all.
  static bool are_known(const Device& device);
  /// Starts a script and ends the one that runs. With a port, that gets CMD_SCRIPT_DEBUG with each
  /// command and once more at the end. Returns why it could not start.
  std::optional<msg::BoardErrorCode> start(Device& device, std::uint8_t slot,
                                           std::optional<std::size_t> port, Instant now);
  void stop() { run_.reset(); }
  /// Slot of the script that runs.
  std::optional<std::uint8_t> running() const;
  /// Number of its current command, from 1; 0 if no script runs.
  std::uint16_t command() const { return run_ ? run_->command : 0; }

  /// The port closes: send nothing more there.
  void forget_port(std::size_t port);

  Instant next() const;
  void advance(Device& device, Instant now);
  void restart(Device& device, Instant now);

 private:
  struct Run {
    std::uint8_t slot{};
    std::optional<std::size_t> port{};
    std::uint16_t commands{};  ///< in the script
    std::uint16_t command{};
    Instant due{};  ///< end of the command
  };

  void report(Device& device, msg::FileError error) const;

  std::optional<Run> run_{};
};

}  // namespace sbgc::emulator
