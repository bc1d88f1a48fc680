/// Restarts of the board, and the time after them.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Off and on again: what is not in the memory is lost, and hosts are not heard for a while.
class Restarts {
 public:
  enum class State : std::uint8_t { starting, running, in_bootloader };

  /// The board is switched on.
  Restarts(Device& device, Instant now);

  /// At that time. A restart that comes earlier anyway stays.
  void schedule(Instant at, bool to_bootloader);
  /// The board restarts by itself: it tells all hosts, and gives them time.
  void announce(Device& device, Instant now);
  /// At once. `power_off`: what waits to be sent is lost too, and what is in the devices on the
  /// bus.
  void restart_now(Device& device, Instant now, bool to_bootloader, bool power_off);

  State state() const { return state_; }
  bool is_listening() const { return state_ == State::running; }
  /// When the board has started last.
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
  Instant changes_ = Instant::never;  ///< when the state does
  Instant started_{};
  std::optional<Scheduled> scheduled_{};
};

}  // namespace sbgc::emulator
