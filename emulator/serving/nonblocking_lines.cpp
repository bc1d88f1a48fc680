#include "serving/nonblocking_lines.hpp"

#include <algorithm>
#include <climits>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sbgc::serving {

namespace {

/// Opens the file again, because O_NONBLOCK would affect every process that shares the descriptor.
/// Regular files would get a separate offset, and never block anyway.
int open_again(int descriptor) {
  struct stat about {};
  if (::fstat(descriptor, &about) != 0 || S_ISREG(about.st_mode)) return -1;
  const std::string name = fmt::format("/proc/self/fd/{}", descriptor);
  return ::open(name.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

}  // namespace

NonblockingLines::NonblockingLines(int descriptor)
    : descriptor_(descriptor), own_(open_again(descriptor)) {}

NonblockingLines::~NonblockingLines() {
  catch_up();
  if (own_ >= 0) ::close(own_);
}

void NonblockingLines::write_line(const std::string& line) {
  if (!catch_up()) {
    ++left_out_;
    return;
  }
  // A pipe accepts this many bytes atomically.
  std::string text = line.substr(0, PIPE_BUF - 1);
  text += '\n';
  if (!write(text)) ++left_out_;
}

bool NonblockingLines::catch_up() {
  if (!rest_.empty() && (!write(std::string(rest_)) || !rest_.empty())) return false;
  if (left_out_ == 0) return true;
  if (!write(fmt::format("... {} lines dropped: no reader\n", left_out_))) return false;
  left_out_ = 0;
  return rest_.empty();
}

bool NonblockingLines::write(std::string_view text) {
  const int to = own_ >= 0 ? own_ : descriptor_;
  pollfd room{to, POLLOUT, 0};
  if (::poll(&room, 1, 0) <= 0 || (room.revents & POLLOUT) == 0) return false;
  const ssize_t written = ::write(to, text.data(), text.size());
  if (written < 0) return false;
  rest_ = text.substr(static_cast<std::size_t>(written));
  return true;
}

}  // namespace sbgc::serving
