/// Moving the camera to angles, and stopping it. See docs/2-safety.md first.
#pragma once

#include <chrono>
#include <functional>

#include <sbgc/client/tasks.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc {

/// {.pitch = -30_deg} moves one axis; axes without an angle are left alone.
using MoveTarget = Axes<Optional<msg::Angle14>>;

/// What is seen while the camera moves.
struct MoveProgress {
  Axes<msg::Angle14> angles{};  ///< measured
  Axes<double> remaining{};     ///< degrees to the target, with a sign; 0 for axes left alone
  bool is_close{};              ///< all within the tolerance
  std::chrono::milliseconds elapsed{};
};

/// How a move is made.
struct MoveOptions {
  /// Without a direction; 0 is the speed from the board's parameters.
  msg::ControlSpeed speed{};
  /// For all of it.
  std::chrono::milliseconds timeout{30'000};
  /// How far from its target an axis may end, in degrees.
  double tolerance = 0.5;
  /// How long all axes have to stay within the tolerance.
  std::chrono::milliseconds settle{300};
  /// How often the angles are asked for.
  std::chrono::milliseconds interval{50};
  /// Stop the camera if it does not arrive: out of time, cancelled, or after an error.
  bool stop_on_failure = true;
  /// Called with all that is seen. False cancels the move.
  std::function<bool(const MoveProgress&)> progress{};
};

/// How the camera is stopped.
struct StopOptions {
  std::chrono::milliseconds timeout{3'000};
  /// How often it is looked at and the command sent again.
  std::chrono::milliseconds interval{50};
};

namespace tasks {

/// Moves the camera to `target`, in Euler coordinates, and waits until it is there. Returns what
/// was seen last; an error says how far it got. Axes left alone stay with, or go back to, RC
/// control; firmware before 2.55b5 holds them at their present targets. When the measured angle
/// stays elsewhere the command is sent again.
///
/// Angles cover two full turns in each direction, so 370 degrees is another target than 10.
Task<Result<MoveProgress>> move_to(MoveTarget target, MoveOptions options = {});

/// Stops all axes where they are and waits until the board says that none has a speed any more.
/// Serial control goes on, with speed 0; see release().
Task<Result<void>> stop(StopOptions options = {});

/// Ends serial control; RC has control again.
Task<Result<void>> release();

}  // namespace tasks
}  // namespace sbgc
