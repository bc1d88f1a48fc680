#include "move/guard.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/messages/control.hpp>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

/// The setup of the guard process: its end of the channel is its standard input; it has no terminal
/// and no other files, and is in no process group that a signal for this one could reach.
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
  // process with threads can do almost nothing.
  const int error = ::posix_spawn(&process_, "/proc/self/exe", setup.files(), setup.attributes(),
                                  arguments.data(), environ);
  if (error != 0) fail_to_start(error);
}

Guard::~Guard() {
  if (!channel_) return;
  // It is no longer needed.
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

namespace {

/// One packet: a byte and a descriptor, or the text of parameters.
struct Packet {
  std::array<char, 1024> bytes{};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec data{bytes.data(), bytes.size()};
  msghdr header{};

  Packet() {
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  Packet(const Packet&) = delete;
  Packet& operator=(const Packet&) = delete;
  ~Packet() = default;
};

bool send_packet(int channel, const Packet& packet) {
  ssize_t size = 0;
  do {
    size = ::sendmsg(channel, &packet.header, MSG_NOSIGNAL);
  } while (size < 0 && errno == EINTR);
  return size == static_cast<ssize_t>(packet.data.iov_len);
}

/// The name of the message, a NUL, the copy, and the body.
std::string packed_text(const Parameters& parameters) {
  std::string text = parameters.id.message;
  text += '\0';
  text += static_cast<char>(parameters.id.copy);
  return text.append(parameters.body.begin(), parameters.body.end());
}

Parameters unpacked(std::string_view text) {
  Parameters parameters;
  const std::size_t end = text.find('\0');
  if (end == std::string_view::npos || end + 2 > text.size()) return parameters;
  parameters.id.message = text.substr(0, end);
  parameters.id.copy = static_cast<std::uint8_t>(text[end + 1]);
  const std::string_view body = text.substr(end + 2);
  parameters.body.assign(body.begin(), body.end());
  return parameters;
}

}  // namespace

bool send_line(int channel, const GuardedLine& line) {
  Packet packet;
  packet.bytes[0] = static_cast<char>(line.after);
  packet.data.iov_len = 1;
  cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(control), &line.descriptor, sizeof(int));
  return send_packet(channel, packet);
}

bool send_parameters(int channel, const Parameters& parameters) {
  const std::string text = packed_text(parameters);
  Packet packet;
  if (text.size() > packet.bytes.size()) {
    errno = EMSGSIZE;
    return false;
  }
  std::ranges::copy(text, packet.bytes.begin());
  packet.data.iov_len = text.size();
  packet.header.msg_control = nullptr;
  packet.header.msg_controllen = 0;
  return send_packet(channel, packet);
}

GuardedLine receive_line(int channel) {
  GuardedLine line;
  while (true) {
    Packet packet;
    const ssize_t size = ::recvmsg(channel, &packet.header, MSG_CMSG_CLOEXEC);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return line;  // the end, or no channel at all
    const cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
    if (control == nullptr) {
      const std::string_view text(packet.bytes.data(), static_cast<std::size_t>(size));
      // The sender is this program, so they can be decoded.
      static_cast<void>(line.restored.put(unpacked(text)));
      continue;
    }
    if (control->cmsg_type != SCM_RIGHTS) continue;
    if (line.descriptor >= 0) ::close(line.descriptor);
    std::memcpy(&line.descriptor, CMSG_DATA(control), sizeof(int));
    line.after = static_cast<AfterStop>(packet.bytes[0]);
  }
}

namespace {

using Clock = std::chrono::steady_clock;

/// The guard tries to stop the camera for this long. A line without traffic for as long is lost.
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
    // Before the timeout has expired, which is no longer than the rest of a stop.
    if (Result<void> removed = client->set_control_timeout({}); !removed) return removed;
  }
  return client->stop();
}

/// True if further attempts are pointless.
bool is_final(ErrorCode code) { return code == ErrorCode::link_lost || code == ErrorCode::io; }

}  // namespace

int run_guard() {
  ::prctl(PR_SET_NAME, guard_name);
  // It ends by itself, and must survive the signals that end the command.
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
