/// Restarts of the board, and the time after them.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// A restart loses what is not in the memory, and the board does not listen for a while.
class Restarts {
 public:
  enum class State : std::uint8_t { starting, running, in_bootloader };

  /// The board is switched on.
  Restarts(Device& device, Instant now);

  /// Schedules a restart, unless an earlier one is scheduled.
  void schedule(Instant at, bool to_bootloader);
  /// The board restarts by itself: it notifies all hosts and gives them time.
  void announce(Device& device, Instant now);
  /// Restarts now. `power_off`: also loses pending output and the registers of the devices on the
  /// bus.
  void restart_now(Device& device, Instant now, bool to_bootloader, bool power_off);

  State state() const { return state_; }
  bool is_listening() const { return state_ == State::running; }
  /// When the board last started.
  Instant started() const { return started_; }

  Instant next() const;
  void advance(Device& device, Instant now);

 private:
  struct Scheduled {
    Instant at{};
    bool to_bootloader{};
  };

  void begin_start(Device& device, Instant now);
  void begin_running(Device& device, Instant now);

  State state_ = State::starting;
  Instant changes_ = Instant::never;  ///< when the state changes
  Instant started_{};
  std::optional<Scheduled> scheduled_{};
};

}  // namespace sbgc::emulator
