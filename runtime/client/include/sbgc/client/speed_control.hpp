/// Speed control of the camera with a dead man's switch. Read docs/2-safety.md first.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/motion_bound.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/types.hpp>
#include <sbgc/units.hpp>

namespace sbgc {

class AsyncClient;
class Client;

namespace detail {
class Connection;
}

/// Options of SpeedControl.
struct SpeedControlOptions {
  /// The camera is stopped after the owner has been silent for this long.
  std::chrono::milliseconds silence{500};
  /// The interval at which the speed is repeated, as a command may be lost. At least 20 ms, which
  /// the board requires.
  std::chrono::milliseconds repeat{100};
  /// The clock for `silence` and `repeat`. Must outlive the control.
  Clock& clock = Clock::system();
  /// The way in which the motion ends if this program dies.
  MotionBound bound = MotionBound::automatic;
  /// The time that the camera may turn without a command, except with MotionBound::none. Several
  /// times `repeat`, so that a lost command does not matter; at most a minute.
  std::chrono::milliseconds lookahead{500};
  /// Read the speeds before a speed is repeated, and fail with ErrorCode::interrupted if another
  /// program has stopped the camera, or with ErrorCode::timeout if it does not begin to turn. For
  /// speeds that seldom change; without it, another program's stop is undone within `repeat`.
  bool ends_when_stopped = false;
};

/// Holds a speed as long as its owner refreshes it. Without it, a board keeps turning if its host
/// dies or the line is lost.
///
/// If this program dies or the line is lost, nobody can stop the camera; then
/// SpeedControlOptions::bound limits the motion. `timeout` and `target` differ in their side
/// effects: the first changes the configuration of serial control, see set_control_timeout(); the
/// second reads the angles before each command, and its speed is a little less even.
///
///     SpeedControl control(client);
///     while (joystick.is_held()) {
///       if (auto set = control.set({.yaw = joystick.speed()}); !set) return fail(set.error());
///     }
///
/// The camera also stops if the owner is silent for too long, if sending fails, on stop() and on
/// destruction. A stop that the board does not execute is repeated until it does, the line is lost,
/// or this object is destroyed, which tries once more. Every function may be called from any thread
/// and returns at once: a separate thread does the sending. Its errors are returned by the next
/// call.
///
/// Over a client that reconnects, the loss of the line ends the motion, too: nothing turns again by
/// itself when the line is back. Then set() works again; until then it fails with
/// ErrorCode::not_connected.
///
/// Over an AsyncClient, its executor does the sending instead of a thread. Destruction
/// begins to stop the camera, and does not wait for it; if the client is destroyed before the stop
/// is sent, SpeedControlOptions::bound ends the motion. Do not call wait() on a thread that the
/// executor needs. SpeedControlOptions::clock has no effect.
class SpeedControl {
 public:
  /// See SpeedControlState.
  using State = SpeedControlState;

  /// `client` must outlive this object.
  explicit SpeedControl(Client& client, const SpeedControlOptions& options = {});
  explicit SpeedControl(AsyncClient& client, const SpeedControlOptions& options = {});
  SpeedControl(const SpeedControl&) = delete;
  SpeedControl& operator=(const SpeedControl&) = delete;
  SpeedControl(SpeedControl&&) = delete;
  SpeedControl& operator=(SpeedControl&&) = delete;
  /// Stops the camera if it turns, and waits until it has stopped.
  ~SpeedControl();

  /// Turns with these speeds from now on, also after silence. Axes with speed 0 hold still. If a
  /// later command of this client has stopped or moved the camera since the last call, fails once
  /// with ErrorCode::superseded and sends nothing. Errors, including those of sending since then:
  /// those of Client::call(), `invalid` also for impossible options; `interrupted` with
  /// SpeedControlOptions::ends_when_stopped.
  Result<void> set(const Axes<msg::ControlSpeed>& speed);
  /// Keeps the current speeds. Fails with ErrorCode::cancelled if there are none. Errors: those of
  /// set().
  Result<void> refresh();
  /// Stops the camera. Use wait() to wait until it has stopped. Errors: those of sending since the
  /// last call.
  Result<void> stop();
  /// Stops the camera for good, without waiting. `done` is called once, on a thread of the client,
  /// when the camera has stopped, or with the error that prevented it. Errors: those of stop().
  void close(std::function<void(const Result<void>&)> done);
  /// Waits until nothing remains to be sent immediately. Errors: those of set().
  Result<void> wait();
  /// True if wait() would return at once. After stop(), the camera has then stopped.
  [[nodiscard]] bool has_settled() const;

  /// Returns the current state.
  [[nodiscard]] State state() const;

 private:
  class End;
  class Worker;
  using ConnectionPointer = std::shared_ptr<detail::Connection>;

  /// The worker of the last connection for which set() was called; null before.
  std::shared_ptr<Worker> worker() const;
  /// Replaces the worker of a connection that was lost.
  Result<void> renew();

  const SpeedControlOptions options_;
  /// Return the current connection of the client, and make a worker for one.
  const std::function<Result<ConnectionPointer>()> connected_;
  const std::function<std::shared_ptr<Worker>(detail::Connection&)> make_worker_;
  std::mutex renewing_;
  mutable std::mutex mutex_;
  ConnectionPointer connection_;  // that of the worker
  std::shared_ptr<Worker> worker_;
  bool is_closed_ = false;
};

}  // namespace sbgc
