// Tests of signals, each in a process of its own.

#include "command/interruption.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sbgc::tools {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds as_a_person{600};
constexpr const char* left = "\nsbgc: ended before it was done: a thing is left\n";

/// How a process ended, and what it wrote to standard error.
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

}  // namespace
}  // namespace sbgc::tools
