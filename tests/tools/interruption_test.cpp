// Tests of signals, each in a process of its own, and of calls that a signal may interrupt, which
// are repeated then. They are not repeated for another reason, even if errno tells of an earlier
// interruption: that would never end.

#include "command/interruption.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/system.hpp"
#include "move/guard.hpp"
#include "move/raw_terminal.hpp"

namespace sbgc::tools {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds as_a_person{600};
constexpr const char* left = "\nsbgc: ended before it was done: a thing is left\n";

/// The end of a process: its status, and its standard error.
struct End {
  int status{};  // of waitpid()
  std::string text{};

  bool is_by(int signal) const { return WIFSIGNALED(status) && WTERMSIG(status) == signal; }
  bool is_usual() const { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }
};

End end_of(const std::function<bool()>& work) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    ::_exit(work() ? 0 : 1);
  }
  ::close(ends[1]);
  End end;
  std::array<char, 1000> bytes{};
  while (const ssize_t size = ::read(ends[0], bytes.data(), bytes.size())) {
    if (size < 0) break;
    end.text.append(bytes.data(), static_cast<std::size_t>(size));
  }
  ::close(ends[0]);
  ::waitpid(process, &end.status, 0);
  return end;
}

void press_after(milliseconds time) {
  std::this_thread::sleep_for(time);
  ::raise(SIGINT);
}

TEST(Interruption, OnlyASecondPressOfCtrlCEndsIt) {
  const End end = end_of([] {
    const MustFinish something(stop_bound, "a thing is left");
    // These come from a terminal that closes, and from one press that arrives in two ways.
    for (const int one : {SIGHUP, SIGHUP, SIGINT, SIGINT, SIGTERM, SIGQUIT, SIGPIPE}) ::raise(one);
    return was_interrupted() && !was_interrupted_by_key();
  });
  EXPECT_TRUE(end.is_usual()) << end.status;
  EXPECT_EQ(end.text, "");
  const End pressed = end_of([] {
    const MustFinish something(stop_bound, "a thing is left");
    ::raise(SIGINT);
    ::raise(SIGTERM);
    press_after(as_a_person);
    return true;
  });
  EXPECT_TRUE(pressed.is_by(SIGINT)) << pressed.status;
  EXPECT_EQ(pressed.text, left);
}

TEST(Interruption, TheBoundEndsIt) {
  const End end = end_of([] {
    const MustFinish longer(write_bound, "another thing is left");
    const MustFinish something(std::chrono::seconds(1), "a thing is left");
    ::raise(SIGTERM);
    std::this_thread::sleep_for(std::chrono::seconds(30));
    return true;
  });
  EXPECT_TRUE(end.is_by(SIGTERM)) << end.status;
  EXPECT_EQ(end.text, left);
}

TEST(Interruption, WhatCanSayMoreIsCutShortFirst) {
  const End end = end_of([] {
    const MustFinish something(std::chrono::seconds(30), "a thing is left");
    const CutShort second;
    ::raise(SIGINT);
    const bool was_cut = was_cut_short();
    press_after(as_a_person);
    if (was_cut || !was_cut_short()) return false;
    press_after(as_a_person);
    return false;
  });
  EXPECT_TRUE(end.is_by(SIGINT)) << end.status;
  EXPECT_EQ(end.text, left);
  const End late = end_of([] {
    const MustFinish something(std::chrono::seconds(6), "a thing is left");
    const CutShort second;
    ::raise(SIGHUP);
    std::this_thread::sleep_for(milliseconds(1500));  // the last 5 s are for the last words
    return was_cut_short();
  });
  EXPECT_TRUE(late.is_usual()) << late.status;
}

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
