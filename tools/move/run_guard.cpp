// The guard process.

#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/messages/control.hpp>

#include "command/command_error.hpp"
#include "move/guard_channel.hpp"

namespace sbgc::tools {

namespace {

using Clock = std::chrono::steady_clock;

/// How long the guard tries to stop the camera. A line that carries nothing for this long is lost.
constexpr std::chrono::seconds longest_question{60};

/// Makes one attempt. The descriptor stays open.
Result<void> stop_gimbal(const GuardedLine& line) {
  const auto adopt = [&](const asio::any_io_executor& executor) {
    return io::adopt(executor, fcntl(line.descriptor, F_DUPFD_CLOEXEC, 0)).transport;
  };
  ConnectOptions options;
  options.detect_line = false;  // the command had found it
  options.timeout = std::chrono::seconds(5);
  Result<Client> client = connect_over(adopt, options);
  if (!client) return client.error();
  const auto does = [&](AfterStop what) {
    return line.after == what || line.after == AfterStop::all;
  };
  Result<void> ended;
  if (does(AfterStop::end_tuning)) ended = client->run(tasks::end_tuning());
  StopOptions at_once;
  at_once.rest = {};
  Result<void> stopped = client->stop(at_once);
  if (!ended) return ended;
  if (!stopped) return stopped;
  if (!line.restored.all().empty()) {
    const WriteReport restored = client->write_parameters(line.restored);
    if (!restored) return restored.outcome;
  }
  const bool has_timeouts = is_supported<msg::ControlConfig>(client->identity().versions());
  if (does(AfterStop::remove_timeout) && has_timeouts) {
    // Before the timeout is over, which is no longer than the rest of a stop.
    if (Result<void> removed = client->set_control_timeout({}); !removed) return removed;
  }
  return client->stop();
}

/// True if no further attempt can succeed.
bool is_final(ErrorCode code) { return code == ErrorCode::link_lost || code == ErrorCode::io; }

}  // namespace

int run_guard() {
  ::prctl(PR_SET_NAME, guard_name);
  // It ends by itself, and must outlive what ends the command.
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGTSTP, SIGUSR1, SIGUSR2}) {
    ::signal(number, SIG_IGN);
  }
  const GuardedLine line = receive_line(STDIN_FILENO);
  if (line.descriptor < 0) return failure;
  const auto end = Clock::now() + longest_question;
  while (true) {
    const Result<void> stopped = stop_gimbal(line);
    if (stopped) return success;
    if (is_final(stopped.error().code) || Clock::now() >= end) return failure;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

}  // namespace sbgc::tools
