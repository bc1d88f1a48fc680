/// The bounds of a motion whose owner is silent, and the states of a SpeedControl.
#pragma once

#include <cstdint>

namespace sbgc {

/// The way in which a motion ends if the line is lost and no command can reach the board.
enum class MotionBound : std::uint8_t {
  /// `timeout` with firmware that has it, otherwise `target`.
  automatic,
  /// The board ends serial control when it receives no command for a while: set_control_timeout().
  /// RC takes over; the camera stops unless RC turns it.
  timeout,
  /// Each command is an angle a short way ahead, where the camera stops by itself and holds.
  target,
  /// Nothing: the camera keeps turning.
  none,
};

/// The state of a SpeedControl.
enum class SpeedControlState : std::uint8_t {
  idle,      ///< it holds no speed, initially or after a stop
  turning,   ///< it holds a speed
  silenced,  ///< it stopped the camera because the owner was silent
  failed,    ///< sending failed; final
};

}  // namespace sbgc
