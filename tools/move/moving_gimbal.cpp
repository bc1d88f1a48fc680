#include "move/moving_gimbal.hpp"

#include <array>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <sbgc/io/transport.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"

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

Result<bool> are_motors_on(Client& client) {
  const Result<msg::RealtimeData3> state = client.call(msg::RealtimeData3Request{});
  if (!state) return state.error();
  return state->other_flags.has(msg::OtherFlag::motors_on);
}

void require_motors(Client& client) {
  if (value_of(are_motors_on(client))) return;
  throw CommandError("the motors are off; `sbgc motors on` turns them on");
}

std::string current_errors(Client& client) {
  const Result<msg::RealtimeData3> state = client.call(msg::RealtimeData3Request{});
  if (!state) return "";
  std::string names;
  for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
    if (!state->system_error.has(static_cast<msg::SystemError>(error.value))) continue;
    names += (names.empty() ? "" : ", ") + std::string(error.name);
  }
  return names;
}

}  // namespace sbgc::tools
