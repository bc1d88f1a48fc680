#include "command/interruption.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <deque>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

/// Without a MustFinish.
constexpr unsigned usual_bound = 8;
/// The time to report unfinished work, within the bound.
constexpr unsigned last_words = 5;
/// Signals that come sooner are one press of Ctrl-C, or have another sender.
constexpr std::int64_t least_between_keys = 500;

/// The work that must be finished.
struct Duty {
  unsigned bound{};  // seconds
  std::string undone{};
};

struct Replaced {
  int number{};
  struct sigaction before {};
};

// One for the process, as its signal handlers are.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<int> arrived = 0;  // the number of the first signal
std::atomic<bool> takes_cut = false;
std::atomic<bool> is_cut = false;
std::atomic<std::int64_t> last_key = 0;  // in ms; 0: none
std::atomic<const Duty*> duty = nullptr;
std::array<int, 2> channel{-1, -1};
int depth = 0;                   // of Interruptions that exist
std::vector<Replaced> replaced;  // by Interruption
std::vector<Replaced> replaced_by_duty;
std::vector<const Duty*> duties;  // the last is the present one
std::deque<Duty> all_duties;      // another thread may be in the handler, so that none ends
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

/// Sets the alarm that ends what must end now.
void set_alarm() {
  const Duty* const present = duty;
  const unsigned bound = present == nullptr ? usual_bound : present->bound;
  ::alarm(takes_cut && !is_cut ? bound - last_words : bound);
}

[[noreturn]] void end_now() {
  const Duty* const present = duty;
  pollfd standard_error{STDERR_FILENO, POLLOUT, 0};
  const bool has_room =
      ::poll(&standard_error, 1, 0) == 1 && (standard_error.revents & POLLOUT) != 0;
  if (present != nullptr && has_room) {
    [[maybe_unused]] const auto size =
        ::write(STDERR_FILENO, present->undone.data(), present->undone.size());
  }
  const int number = arrived;
  ::signal(number, SIG_DFL);
  sigset_t one{};
  sigemptyset(&one);
  sigaddset(&one, number);
  ::pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  ::raise(number);
  ::_exit(interrupted);
}

bool is_second_key(int number) {
  if (number != SIGINT) return false;
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = std::int64_t{time.tv_sec} * 1000 + time.tv_nsec / 1'000'000;
  const std::int64_t last = last_key;
  const bool is_second = last != 0 && now - last >= least_between_keys;
  if (last == 0 || is_second) last_key = now;
  return is_second;
}

extern "C" void take_signal(int number) {
  const int saved_errno = errno;
  const bool is_end = number == SIGALRM || is_second_key(number);
  if (is_end && (!takes_cut || is_cut)) end_now();
  int none = 0;
  const bool is_first = number != SIGALRM && arrived.compare_exchange_strong(none, number);
  if (is_end) {
    is_cut = true;
    ::alarm(last_words);
  } else if (is_first) {
    set_alarm();
  }
  const char mark = 0;
  [[maybe_unused]] const auto size = ::write(channel[1], &mark, 1);
  errno = saved_errno;
}

void replace(std::vector<Replaced>& list, int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  list.push_back({number, {}});
  ::sigaction(number, &action, &list.back().before);
}

/// After a signal, the program ends: its last steps are not ended by the next one either.
void restore(std::vector<Replaced>& list) {
  if (arrived != 0) return;
  for (const Replaced& one : list) ::sigaction(one.number, &one.before, nullptr);
  list.clear();
}

void change_duty() {
  duty = duties.empty() ? nullptr : duties.back();
  if (arrived != 0) set_alarm();
}

}  // namespace

Interruption::Interruption() {
  if (channel[0] == -1) {
    [[maybe_unused]] const int failed = ::pipe2(channel.data(), O_CLOEXEC | O_NONBLOCK);
  }
  if (depth++ != 0 || arrived != 0) return;
  for (const int number : asking_signals()) replace(replaced, number, take_signal);
  replace(replaced, SIGALRM, take_signal);
}

Interruption::~Interruption() {
  if (--depth == 0) restore(replaced);
}

MustFinish::MustFinish(std::chrono::seconds bound, std::string undone) {
  undone = fmt::format("\nsbgc: ended before it was done: {}\n", undone);
  duty_ = &all_duties.emplace_back(Duty{static_cast<unsigned>(bound.count()), std::move(undone)});
  if (duties.empty() && arrived == 0) {
    for (const int number : {SIGQUIT, SIGUSR1, SIGUSR2}) {
      replace(replaced_by_duty, number, take_signal);
    }
    // They come from a terminal, and from a pipe without a reader.
    for (const int number : {SIGTSTP, SIGTTIN, SIGTTOU, SIGPIPE}) {
      replace(replaced_by_duty, number, SIG_IGN);
    }
  }
  duties.push_back(&all_duties.back());
  change_duty();
}

MustFinish::~MustFinish() {
  std::erase(duties, duty_);
  change_duty();
  if (duties.empty()) restore(replaced_by_duty);
}

CutShort::CutShort() noexcept {
  takes_cut = true;
  if (arrived != 0) set_alarm();
}
CutShort::~CutShort() { takes_cut = false; }

bool was_cut_short() noexcept { return is_cut; }

bool was_interrupted() noexcept { return arrived != 0; }

bool was_interrupted_by_key() noexcept { return arrived == SIGINT; }

int interruption_descriptor() noexcept { return channel[0]; }

std::vector<int> asking_signals() {
  struct sigaction hangup {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler == SIG_IGN) return {SIGINT, SIGTERM};
  return {SIGINT, SIGTERM, SIGHUP};
}

}  // namespace sbgc::tools
