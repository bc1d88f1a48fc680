#include "board/password.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/messages/system.hpp>

#include "command/background_output.hpp"
#include "command/command_error.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

using Password = decltype(msg::PassProtectWrite::new_password);

/// The size of a password with a line ending.
constexpr std::size_t longest_file = 34;
static_assert(longest_file == Password::capacity() + 2);

/// Removes the line ending; throws CommandError if the rest cannot be a password.
std::string checked(std::string text, const std::string& from) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  if (!text.empty() && text.back() == '\r') text.pop_back();
  if (text.size() > Password::capacity() || !detail::is_evident_text(text.data(), text.size())) {
    throw CommandError(
        fmt::format("{}: a password is one line of 1 to {} bytes", from, Password::capacity()));
  }
  return text;
}

std::string read_file(const std::string& name) {
  // Nonblocking, because opening a named pipe waits for a writer.
  const io::detail::Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat about {};
  if (!file || ::fstat(file.get(), &about) != 0) {
    throw CommandError(fmt::format("cannot read {}: {}", name, std::strerror(errno)));
  }
  if (!S_ISREG(about.st_mode)) throw CommandError(name + " is not a regular file");
  if ((about.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw CommandError(
        fmt::format("others can read or change the password in {}; run: chmod 600 {}", name,
                    quoted_for_shell(name)));
  }
  std::array<char, longest_file + 1> bytes{};
  std::size_t size = 0;
  for (ssize_t more = 1; more != 0 && size < bytes.size(); size += static_cast<std::size_t>(more)) {
    more = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (more < 0) throw CommandError(fmt::format("cannot read {}: {}", name, std::strerror(errno)));
  }
  return checked({bytes.data(), size}, name);
}

/// Turns off the echo of a terminal. Signals that would end the program are deferred until its
/// destructor, so that the echo is restored.
class WithoutEcho {
 public:
  WithoutEcho() {
    for (const int signal : waiting) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, &usual_signals_);
    ::tcgetattr(STDIN_FILENO, &usual_);
    termios silent = usual_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    silent.c_lflag |= ECHONL | ICANON | ISIG;
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  WithoutEcho(const WithoutEcho&) = delete;
  WithoutEcho& operator=(const WithoutEcho&) = delete;
  ~WithoutEcho() {
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &usual_);
    pthread_sigmask(SIG_SETMASK, &usual_signals_, nullptr);
  }

  /// True if a signal is pending.
  bool is_interrupted() const {
    sigset_t pending{};
    sigpending(&pending);
    return std::ranges::any_of(waiting, [&](int signal) {
      return sigismember(&pending, signal) == 1 && sigismember(&usual_signals_, signal) == 0;
    });
  }

 private:
  static constexpr std::array waiting{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};

  static sigset_t no_signals() {
    sigset_t none{};
    sigemptyset(&none);
    return none;
  }

  sigset_t signals_ = no_signals();
  sigset_t usual_signals_ = no_signals();
  termios usual_{};
};

std::string ask(const std::string& whose) {
  if (!is_terminal(stdin) || !is_terminal(stderr)) {
    throw CommandError("there is no terminal to ask for the password on; name a file of mode 0600");
  }
  std::array<char, _POSIX_MAX_CANON> line{};
  ssize_t size = -1;
  {
    const WithoutEcho silent;
    remark_as_is(fmt::format("Password of {}: ", whose));
    background_stderr().wait();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    constexpr int moment = 100;  // milliseconds
    while (!silent.is_interrupted() && size < 0) {
      if (::poll(&input, 1, moment) > 0) size = ::read(STDIN_FILENO, line.data(), line.size());
    }
  }
  if (size < 0) throw CommandError("no password was given", interrupted);
  return checked({line.data(), static_cast<std::size_t>(size)}, "what was typed");
}

}  // namespace

std::string read_password(const std::string& file, const std::string& whose) {
  return file == "-" ? ask(whose) : read_file(file);
}

}  // namespace sbgc::tools
