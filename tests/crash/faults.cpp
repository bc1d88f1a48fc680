// A preloaded library that kills the program, or makes calls fail, at a chosen system call.
//
// SBGC_FAULT_AT is the prefix of the paths that count: a folder, or "socket:". SBGC_FAULT is one of
//   kill N         dies before the N-th call that changes such a file
//   tear N         dies in the middle of the N-th call: a write has written half of its bytes,
//                  other calls have ended
//   fail N NUMBER  the N-th and all later calls fail with this error number; before that, a write
//                  writes half of its bytes, as on a full disk
//   time US PAUSE  dies this long after the first call; each call takes PAUSE microseconds longer
//
// While the file that SBGC_FAULT_WHILE names exists, fsync() and fdatasync() do not return.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

enum class Mode { none, kill, tear, fail, time };

struct Plan {
  Mode mode = Mode::none;
  long at = 0;      ///< number of a call, or microseconds
  long number = 0;  ///< error number, or microseconds
  std::string_view place{};
};

Plan read_plan() {
  const char* const text = std::getenv("SBGC_FAULT");
  const char* const place = std::getenv("SBGC_FAULT_AT");
  Plan plan;
  char name[8]{};
  if (text == nullptr || place == nullptr ||
      std::sscanf(text, "%7s %ld %ld", name, &plan.at, &plan.number) < 2) {
    return plan;
  }
  plan.place = place;
  const std::string_view mode = name;
  plan.mode = mode == "kill"   ? Mode::kill
              : mode == "tear" ? Mode::tear
              : mode == "fail" ? Mode::fail
                               : Mode::time;
  return plan;
}

const Plan& plan() {
  static const Plan one = read_plan();
  return one;
}

[[noreturn]] void die() {
  ::kill(::getpid(), SIGKILL);
  while (true) ::pause();
}

/// Lets the kernel kill the program after a time, whatever it does then.
void die_after(long us) {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGKILL;
  timer_t timer{};
  itimerspec when{};
  when.it_value.tv_sec = us / 1'000'000;
  when.it_value.tv_nsec = us % 1'000'000 * 1000 + 1;
  if (::timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) std::abort();
  if (::timer_settime(timer, 0, &when, nullptr) != 0) std::abort();
}

bool counts(const char* path) {
  return plan().mode != Mode::none && std::string_view(path).starts_with(plan().place);
}

bool counts(int fd) {
  if (plan().mode == Mode::none) return false;
  const int before = errno;
  char place[64];
  char target[4096];
  std::snprintf(place, sizeof place, "/proc/self/fd/%d", fd);
  const ssize_t size = ::readlink(place, target, sizeof target - 1);
  errno = before;
  if (size < 0) return false;
  target[size] = '\0';
  return counts(target);
}

/// Counts the calls of all kinds.
long next_call() {
  static std::atomic<long> calls{0};
  return ++calls;
}

/// Runs one call that counts. `real(share)` makes it: the whole, or only half of a write. A call
/// that is no write returns 0 for half of it.
template <class Real>
long perform(Real real, bool can_fail = true) {
  const long call = next_call();
  const Plan& now = plan();
  if (now.mode == Mode::time) {
    if (call == 1) die_after(now.at);
    const long result = real(1);
    const int number = errno;
    ::usleep(static_cast<useconds_t>(now.number));
    errno = number;
    return result;
  }
  if (call < now.at || (now.mode == Mode::fail && !can_fail)) return real(1);
  if (now.mode == Mode::kill) die();
  if (now.mode == Mode::tear) {
    real(2);
    die();
  }
  if (call == now.at) {
    if (const long half = real(0); half > 0) return half;
  }
  errno = static_cast<int>(now.number);
  return -1;
}

/// Returns the size of a write: the whole (1), or a half (0 and 2).
std::size_t part(std::size_t size, int share) { return share == 1 ? size : size / 2; }

/// For calls other than writes: a failing one is not made.
template <class Real>
long perform_whole(Real real, bool can_fail = true) {
  return perform([&](int share) { return share == 0 ? 0L : static_cast<long>(real()); }, can_fail);
}

/// Simulates a disk that hangs, until the file is gone.
void hang() {
  const char* const file = std::getenv("SBGC_FAULT_WHILE");
  while (file != nullptr && ::access(file, F_OK) == 0) ::usleep(1000);
}

int open_file(const char* path, int flags, mode_t mode) {
  const auto real = [&] { return ::syscall(SYS_openat, AT_FDCWD, path, flags, mode); };
  const bool changes = (flags & O_ACCMODE) != O_RDONLY;
  if (!changes || !counts(path)) return static_cast<int>(real());
  return static_cast<int>(perform_whole(real));
}

}  // namespace

// Replacements of functions of the C library, whose headers name the parameters differently.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name,readability-identifier-naming,bugprone-reserved-identifier)
extern "C" {

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  return open_file(path, flags, mode);
}

int __open_2(const char* path, int flags) { return open_file(path, flags, 0); }

ssize_t write(int fd, const void* bytes, std::size_t size) {
  const auto real = [&](int share) { return ::syscall(SYS_write, fd, bytes, part(size, share)); };
  return counts(fd) ? perform(real) : real(1);
}

ssize_t send(int fd, const void* bytes, std::size_t size, int flags) {
  const auto real = [&](int share) {
    return ::syscall(SYS_sendto, fd, bytes, part(size, share), flags, nullptr, 0);
  };
  return counts(fd) ? perform(real) : real(1);
}

ssize_t sendmsg(int fd, const msghdr* message, int flags) {
  const auto real = [&](int share) {
    if (share == 1 || message->msg_iovlen == 0) return ::syscall(SYS_sendmsg, fd, message, flags);
    iovec first = message->msg_iov[0];
    first.iov_len = part(first.iov_len, share);
    msghdr half = *message;
    half.msg_iov = &first;
    half.msg_iovlen = 1;
    return ::syscall(SYS_sendmsg, fd, &half, flags);
  };
  return counts(fd) ? perform(real) : real(1);
}

int fdatasync(int fd) {
  hang();
  return static_cast<int>(::syscall(SYS_fdatasync, fd));
}

int fsync(int fd) {
  hang();
  const auto real = [&] { return ::syscall(SYS_fsync, fd); };
  return static_cast<int>(counts(fd) ? perform_whole(real) : real());
}

int ftruncate(int fd, off_t size) noexcept {
  const auto real = [&] { return ::syscall(SYS_ftruncate, fd, size); };
  return static_cast<int>(counts(fd) ? perform_whole(real) : real());
}

int fchmod(int fd, mode_t mode) noexcept {
  const auto real = [&] { return ::syscall(SYS_fchmod, fd, mode); };
  return static_cast<int>(counts(fd) ? perform_whole(real, false) : real());
}

int close(int fd) {
  const auto real = [&] { return ::syscall(SYS_close, fd); };
  const bool changes = (::fcntl(fd, F_GETFL) & O_ACCMODE) != O_RDONLY;
  if (!changes || !counts(fd)) return static_cast<int>(real());
  // The descriptor is gone even if closing fails.
  const long result = perform_whole(real);
  if (result != 0) {
    const int number = errno;
    real();
    errno = number;
  }
  return static_cast<int>(result);
}

int rename(const char* from, const char* to) noexcept {
  const auto real = [&] { return ::syscall(SYS_rename, from, to); };
  return static_cast<int>(counts(to) ? perform_whole(real) : real());
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  const auto real = [&] {
    return ::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags);
  };
  return static_cast<int>(counts(to) ? perform_whole(real) : real());
}

int symlink(const char* target, const char* path) noexcept {
  const auto real = [&] { return ::syscall(SYS_symlinkat, target, AT_FDCWD, path); };
  return static_cast<int>(counts(path) ? perform_whole(real) : real());
}

int unlink(const char* path) noexcept {
  const auto real = [&] { return ::syscall(SYS_unlinkat, AT_FDCWD, path, 0); };
  return static_cast<int>(counts(path) ? perform_whole(real, false) : real());
}

int mkdir(const char* path, mode_t mode) noexcept {
  const auto real = [&] { return ::syscall(SYS_mkdirat, AT_FDCWD, path, mode); };
  return static_cast<int>(counts(path) ? perform_whole(real) : real());
}

}  // extern "C"
// NOLINTEND(readability-inconsistent-declaration-parameter-name,readability-identifier-naming,bugprone-reserved-identifier)
