// Tests of calls that a signal may interrupt, which are repeated then. They are not repeated for
// another reason, even if errno tells of an earlier interruption: that would never end.

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "command/system.hpp"
#include "move/guard.hpp"
#include "move/raw_terminal.hpp"

namespace sbgc::tools {
namespace {

/// Replaces standard input by a file.
class Input {
 public:
  explicit Input(const char* file) : previous_(::dup(STDIN_FILENO)) {
    const int opened = ::open(file, O_RDONLY | O_CLOEXEC);
    EXPECT_GE(opened, 0);
    ::dup2(opened, STDIN_FILENO);
    ::close(opened);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() {
    ::dup2(previous_, STDIN_FILENO);
    ::close(previous_);
  }

 private:
  int previous_;
};

/// The two ends of a channel. Negative numbers are closed.
struct Channel {
  std::array<int, 2> ends{};

  Channel() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0); }
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel() {
    close(0);
    close(1);
  }
  void close(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
};

TEST(InterruptedCalls, TheEndOfAFileIsTheEnd) {
  std::FILE* const nothing = std::fopen("/dev/null", "rbe");
  ASSERT_NE(nothing, nullptr);
  std::array<std::uint8_t, 4> block{};
  errno = EINTR;
  EXPECT_EQ(read_available(nothing, block), 0);
  std::fclose(nothing);
}

TEST(InterruptedCalls, AFileThatCannotBeReadIsAnError) {
  std::FILE* const folder = std::fopen("/", "rbe");
  ASSERT_NE(folder, nullptr);
  std::array<std::uint8_t, 4> block{};
  EXPECT_EQ(read_available(folder, block), -1);
  EXPECT_EQ(errno, EISDIR);
  std::fclose(folder);
}

TEST(InterruptedCalls, ATerminalThatIsGoneHasNoKeys) {
  for (const char* const file : {"/dev/null", "/"}) {  // the end, and an error
    const Input input(file);
    RawTerminal terminal;
    errno = EINTR;
    const std::optional<KeyPress> press = terminal.next();
    ASSERT_TRUE(press) << file;
    EXPECT_EQ(press->key, Key::end) << file;
  }
}

TEST(InterruptedCalls, AGuardGetsTheLastLineOfAClosedChannel) {
  Channel channel;
  EXPECT_TRUE(send_line(channel.ends[0], {STDERR_FILENO, AfterStop::nothing, {}}));
  errno = EINTR;
  EXPECT_TRUE(send_line(channel.ends[0], {STDERR_FILENO, AfterStop::remove_timeout, {}}));
  channel.close(0);
  errno = EINTR;
  const GuardedLine line = receive_line(channel.ends[1]);
  EXPECT_GE(line.descriptor, 0);
  EXPECT_EQ(line.after, AfterStop::remove_timeout);
  ::close(line.descriptor);
}

TEST(InterruptedCalls, AGuardGetsParametersToRestore) {
  Channel channel;
  msg::ReadParams3 first;
  first.profile_id = 1;
  first.axes.pitch.p = 33;
  ParameterSet sent;
  ASSERT_TRUE(sent.set(first));
  first.profile_id = 4;
  ASSERT_TRUE(sent.set(first));
  for (const Parameters& one : sent.all()) EXPECT_TRUE(send_parameters(channel.ends[0], one));
  EXPECT_TRUE(send_line(channel.ends[0], {STDERR_FILENO, AfterStop::end_tuning, {}}));
  EXPECT_FALSE(send_parameters(channel.ends[0], {{std::string(2000, 'x'), 0}, {}}));
  channel.close(0);
  const GuardedLine line = receive_line(channel.ends[1]);
  EXPECT_EQ(line.restored, sent);
  EXPECT_EQ(line.after, AfterStop::end_tuning);
  ::close(line.descriptor);
}

TEST(InterruptedCalls, AGuardThatHasEndedGetsNoLine) {
  Channel channel;
  channel.close(1);
  EXPECT_FALSE(send_line(channel.ends[0], {STDERR_FILENO, {}, {}}));
  EXPECT_EQ(errno, EPIPE);
  EXPECT_EQ(receive_line(-1).descriptor, -1) << "there is no channel at all";
}

}  // namespace
}  // namespace sbgc::tools
