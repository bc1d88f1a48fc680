#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "command/system.hpp"

namespace sbgc::tools {

/// Opens closed standard files, so that files opened later do not take their place. Reading the
/// input, or writing the others, still fails. A write beyond the limit of files fails, too, instead
/// of ending the program.
void prepare_standard_files() {
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(fd, F_GETFD) != -1;
    // The lowest free number is this one.
    if (!is_open && ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) return;
  }
}

std::ptrdiff_t read_available(std::FILE* file, std::span<std::uint8_t> into) {
  ssize_t size = 0;
  do {
    size = ::read(::fileno(file), into.data(), into.size());
  } while (size < 0 && errno == EINTR);
  return size;
}

const char* const end_of_input = "Ctrl+D";

bool is_terminal(std::FILE* file) { return ::isatty(::fileno(file)) == 1; }

std::size_t width_of_terminal(std::FILE* file) {
  winsize size{};
  return ::ioctl(::fileno(file), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace sbgc::tools
