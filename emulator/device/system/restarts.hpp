/// Restarts of the board and the phases after them.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Ports;
struct Device;

/// A restart loses everything outside the memory, and the board does not listen for a while.
class Restarts {
 public:
  enum class State : std::uint8_t { starting, running, in_bootloader };

  /// Powers the board on.
  Restarts(Device& device, Instant now);

  /// Schedules a restart, unless an earlier one is scheduled.
  void schedule(Instant at, bool to_bootloader);
  /// Schedules a restart on the board's own initiative, after notifying all hosts.
  void announce(Ports& ports, Instant now);
  /// Restarts now. `power_off` also loses pending output and the registers of bus devices.
  void restart_now(Device& device, Instant now, bool to_bootloader, bool power_off);

  State state() const { return state_; }
  bool is_listening() const { return state_ == State::running; }
  /// The time of the last start.
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
  Instant changes_ = Instant::never;  ///< time of the next state change
  Instant started_{};
  std::optional<Scheduled> scheduled_{};
};

}  // namespace sbgc::emulator
