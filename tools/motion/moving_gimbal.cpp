#include "motion/moving_gimbal.hpp"

#include <array>
#include <csignal>
#include <utility>

#include <poll.h>

#include <sbgc/io/transport.hpp>

namespace sbgc::tools {

namespace {

constexpr std::array ignored{SIGTSTP, SIGTTIN, SIGTTOU, SIGPIPE};

}  // namespace

StaysAwake::StaysAwake() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  for (std::size_t i = 0; i < ignored.size(); ++i) ::sigaction(ignored[i], &action, &previous_[i]);
}

StaysAwake::~StaysAwake() {
  for (std::size_t i = 0; i < ignored.size(); ++i) ::sigaction(ignored[i], &previous_[i], nullptr);
}

MovingGimbal::MovingGimbal(const GimbalOptions& options, AfterStop after)
    : guard_(std::make_unique<Guard>()) {
  const auto hand_over = [&](std::unique_ptr<io::Transport> transport) {
    guard_->take(*transport, after);
    return transport;
  };
  client_ = std::make_unique<Client>(connect(options, hand_over));
  if (must_stop()) give_up({});
}

MovingGimbal::~MovingGimbal() {
  client_.reset();  // so that only the guard holds the line
  if (motion_ == Motion::maybe) guard_->leave_it_to_guard();
}

void MovingGimbal::give_up(const ClientError& problem) {
  std::string end;
  if (motion_ == Motion::maybe) {
    const Result<void> stopped = client_->stop();
    if (stopped) has_stopped();
    if (!stopped) end = "; the camera may still turn: " + stopped.error().message;
  }
  if (motion_ == Motion::ended) end = "; the camera has stopped";
  if (was_interrupted()) throw CommandError("interrupted" + end, interrupted);
  if (!guard_->is_alive()) {
    throw CommandError("the guard process, which stops the gimbal if this one dies, has ended" +
                       end);
  }
  throw CommandError(problem.message + end);
}

bool MovingGimbal::must_stop() const { return was_interrupted() || !guard_->is_alive(); }

bool MovingGimbal::wait(std::chrono::milliseconds time, int descriptor) const {
  std::array<pollfd, 3> waiting{{{interruption_descriptor(), POLLIN, 0},
                                 {guard_->descriptor(), POLLIN, 0},
                                 {descriptor, POLLIN, 0}}};
  ::poll(waiting.data(), waiting.size(), static_cast<int>(time.count()));
  return waiting[2].revents != 0;
}

}  // namespace sbgc::tools
