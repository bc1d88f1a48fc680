/// Turning the camera with a speed, with a dead-man's switch. See docs/2-safety.md first.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc {

class Client;

/// How a speed is held.
struct SpeedControlOptions {
  /// So long the owner may be silent before the camera is stopped.
  std::chrono::milliseconds silence{500};
  /// How often the speed is sent again; a command may be lost. At least 20 ms, as the board asks.
  std::chrono::milliseconds repeat{100};
  Clock& clock = Clock::system();
};

/// Holds a speed as long as its owner refreshes it. A board by itself would go on turning when its
/// host has died, or the line is lost.
///
///     SpeedControl control(client);
///     while (joystick.is_held()) {
///       if (auto set = control.set({.yaw = joystick.speed()}); !set) return fail(set.error());
///     }
///
/// The camera is stopped when the owner is silent for too long, when sending fails, by stop() and
/// when this is destroyed. A stop that the board does not carry out is repeated until it does, the
/// line is gone, or this is destroyed, which tries once more. Every function may be called from any
/// thread, and returns at once: a thread of its own does the sending. What that runs into, the next
/// call returns.
class SpeedControl {
 public:
  enum class State : std::uint8_t {
    idle,      ///< it has no speed: not yet, or not any more
    turning,   ///< it holds a speed
    silenced,  ///< it has stopped the camera because the owner was silent
    failed,    ///< sending has failed; final
  };

  /// `client` must live longer.
  explicit SpeedControl(Client& client, const SpeedControlOptions& options = {});
  SpeedControl(const SpeedControl&) = delete;
  SpeedControl& operator=(const SpeedControl&) = delete;
  SpeedControl(SpeedControl&&) = delete;
  SpeedControl& operator=(SpeedControl&&) = delete;
  /// Stops the camera if it turns, and waits for that.
  ~SpeedControl();

  /// Turns with these speeds from now on; also after the owner was silent. Axes with speed 0 stand.
  Result<void> set(const Axes<msg::ControlSpeed>& speed);
  /// Goes on with the same speeds. ErrorCode::cancelled if there are none any more.
  Result<void> refresh();
  /// Stops the camera; wait() tells when that is done.
  Result<void> stop();
  /// Waits until nothing is left to be sent at once.
  Result<void> wait();

  [[nodiscard]] State state() const;

 private:
  class Keeper;

  std::unique_ptr<Keeper> keeper_;
};

}  // namespace sbgc
