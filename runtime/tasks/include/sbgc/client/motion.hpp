/// Moving the camera to angles and stopping it. Read docs/2-safety.md first.
#pragma once

#include <chrono>
#include <functional>

#include <sbgc/client/task.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc {

/// The targets of a move: {.pitch = -30_deg} moves one axis and leaves the others alone.
using MoveTarget = Axes<Optional<msg::Angle14>>;

/// The progress of a move.
struct MoveProgress {
  Axes<msg::Angle14> angles{};          ///< measured
  Axes<double> remaining{};             ///< signed, in degrees; 0 for axes that do not move
  bool is_close{};                      ///< all axes are within the tolerance
  std::chrono::milliseconds elapsed{};  ///< since the start of the move
};

/// Options of move_to().
struct MoveOptions {
  /// The speed, without a sign; 0 selects the speed in the board's parameters.
  msg::ControlSpeed speed{};
  /// The timeout of the whole move. Stopping a camera that has not arrived by then takes longer.
  std::chrono::milliseconds timeout{30'000};
  /// The largest deviation from the target at which an axis counts as arrived, in degrees.
  double tolerance = 0.5;
  /// The time that all axes must stay within the tolerance; shorter than `timeout`.
  std::chrono::milliseconds settle{300};
  /// The interval for polling the angles.
  std::chrono::milliseconds interval{50};
  /// Stop the camera if it does not arrive: on a timeout, cancellation or error, but not if
  /// something else controls it. This takes up to StopOptions::timeout more.
  bool stop_on_failure = true;
  /// Called after each poll. Returning false cancels the move.
  std::function<bool(const MoveProgress&)> progress{};
};

/// Options of stop().
struct StopOptions {
  /// The timeout of the whole stop, including the rest.
  std::chrono::milliseconds timeout{3'000};
  /// The time for which the board must report speed 0.
  std::chrono::milliseconds rest{500};
  /// The interval for polling the speed, and for repeating the command while the camera turns.
  std::chrono::milliseconds interval{50};
  /// Send nothing to a camera that stands still: serial control would take it from RC.
  bool reads_first = false;
  /// Called after each poll that shows a still camera. Returning false ends the wait for its rest.
  std::function<bool()> goes_on{};
};

namespace tasks {

/// Moves the camera to `target`, in Euler coordinates, and waits until it arrives. Returns the last
/// state; the error says how far the move got. Axes without a target stay under, or return to, RC
/// control; firmware before 2.55b5 holds them at their current targets.
///
/// The command is repeated for at most 400 ms, and only while nothing shows that the board has
/// received it: no confirmation, no speed, the same target as before. Then:
/// - A camera that stands off the target for 500 ms, and whose board no longer has this target, has
/// been stopped or moved by something else: ErrorCode::interrupted.
/// - A stop, the end of serial control, a reset or another motion of this client, begun later, ends
///   the move: ErrorCode::superseded.
/// In both cases the move sends nothing more, not even a stop. If an obstacle keeps the camera off
/// the target, the move waits until the timeout.
///
/// Angles cover two full turns in each direction: 370 degrees is a different target from 10.
///
/// Errors: `timeout` if the camera has not arrived in time; `interrupted` and `superseded` as
/// above; `cancelled` by MoveOptions::progress; `invalid`; and those of Client::call().
Task<Result<MoveProgress>> move_to(MoveTarget target, MoveOptions options = {});

/// The same, but returns as soon as the camera turns to its target or is there. The timeout is for
/// this beginning; `progress` and `settle` have no effect. The camera stops at the target by
/// itself, also if the line is lost. Errors: those of move_to().
Task<Result<MoveProgress>> begin_move(MoveTarget target, MoveOptions options = {});

/// Stops all axes where they are, and succeeds when the board has reported speed 0 for each for
/// StopOptions::rest; until then, it stops turning axes again. A later motion of this client ends
/// it with ErrorCode::superseded. If the board has always answered and the camera still turns,
/// something else turns it: ErrorCode::interrupted. Serial control remains active, with speed 0;
/// see release(). Errors: those of Client::call(), `timeout` also if the board never answers.
Task<Result<void>> stop(StopOptions options = {});

/// Ends serial control and returns control to RC. Errors: those of Client::call().
Task<Result<void>> release();

/// Makes the board end serial control when it receives no control command for `timeout`, as
/// release() does: RC takes over, which is not a stop. 0 means never; at most 65535 ms. Applies to
/// all ports until the board restarts. The board does not report its timeout, so the previous one
/// cannot be restored. Fails with ErrorCode::unsupported before firmware 2.61.
///
/// The same command turns off the low-pass filters of commanded angles and speeds, which a program
/// may have turned on since the board started; the protocol can neither keep nor read them. All
/// other settings stay as they are. Errors: those of Client::call(); `invalid` for the timeout.
Task<Result<void>> set_control_timeout(std::chrono::milliseconds timeout);

}  // namespace tasks
}  // namespace sbgc
