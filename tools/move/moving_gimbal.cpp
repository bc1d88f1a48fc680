#include "move/moving_gimbal.hpp"

#include <array>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <sbgc/io/transport.hpp>

#include "move/motor_state.hpp"

namespace sbgc::tools {

MovingGimbal::MovingGimbal(const GimbalOptions& options) {
  const auto keep_line = [&](std::unique_ptr<io::Transport> transport) {
    line_ = io::detail::Descriptor(::fcntl(transport->native_handle(), F_DUPFD_CLOEXEC, 0));
    if (line_) return transport;
    throw CommandError("nothing can be moved over this line: no guard process can hold it (" +
                       transport->description() + ")");
  };
  client_ = std::make_unique<Client>(connect(options, keep_line));
  require_motors(*client_);
}

MovingGimbal::~MovingGimbal() {
  client_.reset();  // so that only the guard holds the line
  line_ = {};
  if (motion_ == Motion::maybe) guard_->leave_it_to_guard();
}

void MovingGimbal::begins_to_move(AfterStop after, const ParameterSet& restored) {
  interruption_.emplace();
  stop_.emplace(stop_bound, "the camera may still turn; a guard process stops it if it can");
  guard_.emplace();
  guard_->take(line_.get(), after);
  guard_->restore(restored);
  line_ = {};
  if (must_stop()) give_up({});
  motion_ = Motion::maybe;
}

void MovingGimbal::has_stopped() {
  motion_ = Motion::ended;
  stop_.reset();
}

void MovingGimbal::give_up(const ClientError& problem) {
  std::string end;
  if (is_in_other_hands(problem.code) && !must_stop()) {
    has_stopped();
    throw CommandError(problem.message);
  }
  if (motion_ == Motion::maybe) {
    const Result<void> stopped = client_->stop();
    if (stopped) has_stopped();
    if (!stopped) end = "; the camera may still turn: " + stopped.error().message;
  }
  if (motion_ == Motion::ended) end = "; the camera has stopped";
  if (was_interrupted()) throw CommandError("interrupted" + end, interrupted);
  if (guard_ && !guard_->is_alive()) {
    throw CommandError("the guard process, which stops the gimbal if this one dies, has ended" +
                       end);
  }
  throw CommandError(problem.message + end);
}

bool MovingGimbal::must_stop() const {
  return was_interrupted() || (guard_ && !guard_->is_alive());
}

bool MovingGimbal::wait(std::chrono::milliseconds time, int descriptor) const {
  std::array<pollfd, 3> waiting{{{interruption_descriptor(), POLLIN, 0},
                                 {guard_->descriptor(), POLLIN, 0},
                                 {descriptor, POLLIN, 0}}};
  ::poll(waiting.data(), waiting.size(), static_cast<int>(time.count()));
  return waiting[2].revents != 0;
}

}  // namespace sbgc::tools
