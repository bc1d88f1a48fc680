/// Motions that end, and hosts that wait for their end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct MenuParts;

/// Confirms automatic tasks at their end, and turns the motors off after a safe stop or a
/// synchronous motion.
class Tasks {
 public:
  enum class Kind : std::uint8_t {
    motion,    ///< ends when all axes have arrived
    action,    ///< ends when the motion, calibration, tuning or script has ended
    attitude,  ///< ends when the attitude of CMD_CONTROL_QUAT is reached
  };

  /// Confirms `command` when the task ends. Replaces a task of the same command and port.
  void confirm_end(std::size_t port, std::uint8_t command, Kind kind, Instant now);
  /// Slows down and turns the motors off.
  void stop_safely(Gimbal& gimbal, Instant now);
  /// Drives one motor for this time, then turns the motors off.
  void synchronize(Gimbal& gimbal, std::size_t axis, double degrees, Duration time, Instant now);
  bool is_stopping() const { return stop_ != Instant::never; }
  /// Turns the motors on or off, and replaces a stop in progress.
  void set_motors(Gimbal& gimbal, bool on, Instant now);

  void drop_port(std::size_t port);

  Instant next() const { return next_; }
  void advance(Instant now, MenuParts& parts);

 private:
  struct Task {
    std::size_t port{};
    std::uint8_t command{};
    Kind kind{};
    Instant deadline{};
  };

  void plan(Instant now);

  std::vector<Task> tasks_{};
  Instant stop_ = Instant::never;  ///< the latest end of a safe stop
  Instant off_ = Instant::never;   ///< end of a synchronous motion
  Instant next_ = Instant::never;
};

}  // namespace sbgc::emulator
