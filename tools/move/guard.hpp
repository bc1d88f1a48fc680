/// A process that stops the gimbal if this one cannot, and the channel to it.
#pragma once

#include <sys/types.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/io/internal/descriptor.hpp>

namespace sbgc::tools {

/// The duties of the guard besides the stop.
enum class AfterStop : unsigned char {
  nothing,
  remove_timeout,  ///< so that RC does not take over: see set_control_timeout()
  end_tuning,      ///< before the stop, which a tuning board may ignore
  all,             ///< for a guard of several commands
};

/// Runs a guard: a process in its own session that also holds the line. If this process ends
/// without releasing it, for whatever reason, the guard stops the gimbal, and restores parameters
/// if it has any.
class Guard {
 public:
  /// Starts the guard. Throws CommandError.
  Guard();
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  /// Releases the guard, which ends, unless the stop was left to it.
  ~Guard();

  /// Passes the line to the guard; the caller keeps the descriptor. Throws CommandError.
  void take(int line, AfterStop after) const;
  /// Passes parameters that the guard restores after the stop. Throws CommandError.
  void restore(const ParameterSet& parameters) const;
  /// Lets the guard stop the camera. It continues after this process.
  void leave_it_to_guard();
  /// False once the guard has ended: then nothing stops the camera if this process dies.
  bool is_alive() const;
  /// Becomes readable when the guard ends, for poll().
  int descriptor() const noexcept { return channel_.get(); }

 private:
  io::detail::Descriptor channel_{};
  pid_t process_ = -1;
};

/// True if this process was started as a guard.
bool is_guard(int argc, char** argv);

/// The guard: waits for the end of the process that started it. Returns the exit status.
int run_guard();

/// The name of the guard process.
inline constexpr const char* guard_name = "sbgc-guard";

struct GuardedLine {
  int descriptor = -1;
  AfterStop after{};
  ParameterSet restored{};  ///< to restore on the board after the stop
};

/// Sends a line; the sender keeps its descriptor. Returns false on an error, which is in errno.
bool send_line(int channel, const GuardedLine& line);

/// Sends parameters to restore after the stop. Returns false on an error, which is in errno.
bool send_parameters(int channel, const Parameters& parameters);

/// Waits for lines and parameters until the other side has closed the channel or ended. Returns the
/// last line, with all parameters; the receiver owns its descriptor, which is -1 if none came.
GuardedLine receive_line(int channel);

}  // namespace sbgc::tools
