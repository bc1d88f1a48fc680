#include "command/interruption.hpp"

#include <array>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace sbgc::tools {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

// Of the process, as its signal handlers are.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t arrived = 0;  // the number of the signal
volatile std::sig_atomic_t has_second = 0;
volatile std::sig_atomic_t takes_second = 0;
std::array<int, 2> channel{-1, -1};
std::array<struct sigaction, signals.size()> previous{};
int depth = 0;  // of Interruptions that exist
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

extern "C" void take_signal(int number) {
  const int saved_errno = errno;
  const bool is_repeated = arrived != 0 && takes_second != 0 && has_second == 0;
  if (is_repeated && number != SIGINT) {
    errno = saved_errno;
    return;  // a terminal that closes, for one, sends the same signal twice
  }
  if (is_repeated) {
    has_second = 1;
  } else if (arrived != 0) {  // the user does not want to wait
    ::signal(number, SIG_DFL);
    ::raise(number);
  }
  arrived = number;
  const char mark = 0;
  [[maybe_unused]] const auto size = ::write(channel[1], &mark, 1);
  errno = saved_errno;
}

}  // namespace

Interruption::Interruption() {
  if (channel[0] == -1) {
    [[maybe_unused]] const int failed = ::pipe2(channel.data(), O_CLOEXEC | O_NONBLOCK);
  }
  if (depth++ != 0) return;
  struct sigaction action {};
  action.sa_handler = take_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &action, &previous[i]);
}

Interruption::~Interruption() {
  if (--depth != 0) return;
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &previous[i], nullptr);
}

SecondSignal::SecondSignal() noexcept { takes_second = 1; }
SecondSignal::~SecondSignal() { takes_second = 0; }

bool was_interrupted_twice() noexcept { return has_second != 0; }

bool was_interrupted() noexcept { return arrived != 0; }

bool was_interrupted_by_key() noexcept { return arrived == SIGINT; }

int interruption_descriptor() noexcept { return channel[0]; }

}  // namespace sbgc::tools
