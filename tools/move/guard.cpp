#include "move/guard.hpp"

#include <array>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/command_error.hpp"
#include "move/guard_channel.hpp"

namespace sbgc::tools {

namespace {

/// How the guard starts: its end of the channel is its standard input; it has no terminal, no other
/// file, and is in no group of processes that a signal for this one could reach.
class GuardSetup {
 public:
  explicit GuardSetup(int channel) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, channel, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawn_file_actions_addchdir_np(&files_, "/");
    posix_spawnattr_init(&attributes_);
    sigset_t none{};
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  }
  GuardSetup(const GuardSetup&) = delete;
  GuardSetup& operator=(const GuardSetup&) = delete;
  ~GuardSetup() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  const posix_spawn_file_actions_t* files() const noexcept { return &files_; }
  const posix_spawnattr_t* attributes() const noexcept { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

[[noreturn]] void fail_to_start(int reason) {
  throw CommandError(fmt::format("the guard process that stops the gimbal cannot be started: {}",
                                 std::strerror(reason)));
}

}  // namespace

Guard::Guard() {
  std::array<int, 2> ends{};
  const int failed = ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data());
  if (failed != 0) fail_to_start(errno);
  channel_ = io::detail::Descriptor(ends[0]);
  const io::detail::Descriptor end_of_guard(ends[1]);
  const GuardSetup setup(ends[1]);
  // `ps` shows this.
  std::string name(guard_name);
  std::string purpose = fmt::format("stops the gimbal if process {} dies", getpid());
  const std::array<char*, 3> arguments{name.data(), purpose.data(), nullptr};
  // This program, even if the file was replaced meanwhile. A new program, because a fork of a
  // process with threads can do next to nothing.
  const int error = ::posix_spawn(&process_, "/proc/self/exe", setup.files(), setup.attributes(),
                                  arguments.data(), environ);
  if (error != 0) fail_to_start(error);
}

Guard::~Guard() {
  if (!channel_) return;
  // It has nothing to do any more.
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Guard::take(int line, AfterStop after) const {
  if (!send_line(channel_.get(), {line, after, {}})) fail_to_start(errno);
}

void Guard::restore(const ParameterSet& parameters) const {
  for (const Parameters& one : parameters.all()) {
    if (!send_parameters(channel_.get(), one)) fail_to_start(errno);
  }
}

void Guard::leave_it_to_guard() { channel_ = {}; }

bool Guard::is_alive() const {
  pollfd waiting{channel_.get(), POLLIN, 0};  // it never writes
  return ::poll(&waiting, 1, 0) == 0;
}

bool is_guard(int argc, char** argv) { return argc > 0 && std::string_view(argv[0]) == guard_name; }

}  // namespace sbgc::tools
