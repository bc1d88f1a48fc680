/// A connection of a command that moves the camera, and the state of its motors.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <sbgc/client/client.hpp>
#include <sbgc/io/internal/descriptor.hpp>

#include "board/connection.hpp"
#include "command/interruption.hpp"
#include "move/guard.hpp"

namespace sbgc::tools {

/// A gimbal whose camera a command moves. After begins_to_move(), it has a guard, and signals do
/// not end the program; the motion must end when must_stop() returns true.
class MovingGimbal {
 public:
  /// Connects. Throws CommandError, also if the motors are off or no guard can hold the line.
  explicit MovingGimbal(const GimbalOptions& options);
  MovingGimbal(const MovingGimbal&) = delete;
  MovingGimbal& operator=(const MovingGimbal&) = delete;
  /// Leaves a camera that may still be turning to the guard.
  ~MovingGimbal();

  Client& client() noexcept { return *client_; }

  /// Starts the guard. Call this before the first command that moves the camera. If this process
  /// dies, the guard also writes the parameters `restored`. Throws CommandError.
  void begins_to_move(AfterStop after, const ParameterSet& restored = {});
  /// Reports that the camera has stopped.
  void has_stopped();
  /// Ends a failed motion: stops the camera, unless something else controls it, and ends the
  /// command with `problem`, or with the reason of must_stop().
  [[noreturn]] void give_up(const ClientError& problem);

  /// True if a signal requests the end of the command, or the guard has ended.
  bool must_stop() const;
  /// Waits until must_stop(), or for `time`, or until `descriptor` is readable. Returns true for
  /// the last reason.
  bool wait(std::chrono::milliseconds time, int descriptor = -1) const;

 private:
  enum class Motion : unsigned char { none, maybe, ended };

  std::optional<Interruption> interruption_{};
  std::optional<MustFinish> stop_{};
  std::optional<Guard> guard_{};
  io::detail::Descriptor line_{};  // a duplicate of the descriptor of the client, for the guard
  std::unique_ptr<Client> client_{};
  Motion motion_ = Motion::none;
};

/// Asks the board whether its motors are on.
Result<bool> are_motors_on(Client& client);

/// Ends the command unless the motors are on: without them, the board accepts every motion and the
/// camera does not turn. Throws CommandError.
void require_motors(Client& client);

/// Returns the names of the current errors of the board, such as "ERR_LOW_BAT1"; "" if there are
/// none or it does not report them.
std::string current_errors(Client& client);

}  // namespace sbgc::tools
