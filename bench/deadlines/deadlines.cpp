// How late the client returns after a deadline, from calls that a bad board does not let succeed:
//
//     deadlines [--repetitions N] [LOAD]...
//
// LOAD is the number of processes that use the processors meanwhile; by default, 0 and then 8. The
// control is a thread that sleeps until a time at the same moments: how late it wakes is the delay
// of the machine's scheduler, which no program can avoid.

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/messages.hpp>

#include "bad_board.hpp"

namespace {

using sbgc::bench::BadBoard;
using sbgc::bench::Manner;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr std::array manners{Manner::silent, Manner::partly, Manner::babbling};
constexpr std::array manner_names{"well", "silent", "partly", "babbling"};

/// Ends the program: nothing can be measured.
[[noreturn]] void fail(const std::string& reason) {
  std::fprintf(stderr, "deadlines: %s\n", reason.c_str());
  std::exit(1);
}

/// Processes that use the processors as long as the object lives.
class Load {
 public:
  explicit Load(unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      const pid_t child = fork();
      if (child < 0) fail("cannot start a process");
      if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile unsigned turns = 0;;) turns = turns + 1;
      }
      children_.push_back(child);
    }
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;
  ~Load() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }

 private:
  std::vector<pid_t> children_{};
};

/// Times after a deadline.
class Overshoots {
 public:
  void add(Clock::time_point deadline) { all_.emplace_back(Clock::now() - deadline); }
  void append(const Overshoots& more) {
    all_.insert(all_.end(), more.all_.begin(), more.all_.end());
  }
  void print(const std::string& name, milliseconds timeout) {
    std::ranges::sort(all_);
    std::printf("  %-18s %6lld ms %9.2f %9.2f %9.2f\n", name.c_str(),
                static_cast<long long>(timeout.count()), share(0.5), share(0.99),
                all_.back().count());
    std::fflush(stdout);
  }

 private:
  double share(double share) const {
    return all_[static_cast<std::size_t>(share * static_cast<double>(all_.size() - 1))].count();
  }

  std::vector<Milliseconds> all_{};
};

/// Sleeps until a time again and again, on a thread of its own.
class Control {
 public:
  explicit Control(milliseconds timeout) : thread_([this, timeout] { run(timeout); }) {}
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  ~Control() {
    if (thread_.joinable()) thread_.join();
  }

  Overshoots end() {
    is_ending_ = true;
    thread_.join();
    return overshoots_;
  }

 private:
  void run(milliseconds timeout) {
    while (!is_ending_) {
      const Clock::time_point deadline = Clock::now() + timeout;
      const auto since = deadline.time_since_epoch();
      const auto seconds = std::chrono::floor<std::chrono::seconds>(since);
      const timespec until{seconds.count(), std::chrono::nanoseconds(since - seconds).count()};
      while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
      }
      overshoots_.add(deadline);
    }
  }

  std::atomic<bool> is_ending_{};
  Overshoots overshoots_{};
  std::thread thread_;
};

/// What has a deadline.
struct Case {
  const char* name;
  milliseconds timeout;
  unsigned whole;  ///< answers that a board sends which answers partly
  std::function<bool(milliseconds timeout)> succeeds;
};

/// Measures one case with each kind of bad board, and the control meanwhile.
void measure(BadBoard& board, const Case& one, unsigned repetitions) {
  Overshoots control;
  for (const Manner manner : manners) {
    Overshoots client;
    Control sleeper(one.timeout);
    for (unsigned i = 0; i < repetitions; ++i) {
      board.behave(manner, one.whole);
      const Clock::time_point deadline = Clock::now() + one.timeout;
      if (one.succeeds(one.timeout)) fail(std::string(one.name) + " succeeded");
      client.add(deadline);
    }
    control.append(sleeper.end());
    client.print(one.name + std::string("/") + manner_names[static_cast<std::size_t>(manner)],
                 one.timeout);
  }
  control.print("control", one.timeout);
}

sbgc::Client connected(BadBoard& board) {
  board.behave(Manner::well);
  auto client = sbgc::Client::connect(board.address());
  if (!client) fail(client.error().message);
  return *std::move(client);
}

void measure_all(BadBoard& board, unsigned load, unsigned repetitions) {
  std::printf("\n%-21s %8s %9s %9s %9s\n", ("load " + std::to_string(load)).c_str(), "timeout",
              "median", "99 %", "max ms");
  measure(board,
          {"connect", milliseconds(300), 1,
           [&](milliseconds timeout) {
             return bool(sbgc::Client::connect(board.address(), {.timeout = timeout}));
           }},
          repetitions);
  sbgc::Client client = connected(board);
  auto backup = client.make_backup();
  if (!backup) fail(backup.error().message);
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    auto changed = *backup->parameters.get<sbgc::msg::ReadParams3>(profile);
    ++changed.gyro_trust;
    if (!backup->parameters.set(changed)) fail("cannot change the backup");
  }
  measure(board,
          {"call", milliseconds(50), 0,
           [&](milliseconds timeout) { return bool(client.get_angles({}, {.timeout = timeout})); }},
          repetitions);
  measure(
      board,
      {"task", milliseconds(100), 5,
       [&](milliseconds timeout) { return bool(client.read_parameters({.timeout = timeout})); }},
      repetitions);
  sbgc::RestoreOptions options;
  options.save_current = [](const sbgc::Backup&) { return sbgc::Result<void>(); };
  measure(board,
          {"restore", milliseconds(400), 22,  // the board falls silent while it is written
           [&](milliseconds timeout) {
             options.timeout = timeout;
             return bool(client.restore(*backup, options));
           }},
          repetitions);
}

unsigned number(const char* text) {
  char* end = nullptr;
  const unsigned long value = std::strtoul(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value > 10'000) fail(std::string("not a number: ") + text);
  return static_cast<unsigned>(value);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  unsigned repetitions = 100;
  std::vector<unsigned> loads;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--repetitions" && i + 1 < arguments.size()) {
      repetitions = std::max(1U, number(arguments[++i].c_str()));
    } else {
      loads.push_back(number(arguments[i].c_str()));
    }
  }
  if (loads.empty()) loads = {0, 8};
  for (const unsigned load : loads) {
    const Load processes(load);  // before there are threads
    BadBoard board;
    measure_all(board, load, repetitions);
  }
}
