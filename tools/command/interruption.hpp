/// Ctrl-C and the other signals that ask a program to end.
#pragma once

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace sbgc::tools {

/// A stop takes no longer after a signal; then a guard has to do it.
inline constexpr std::chrono::seconds stop_bound{8};
/// Nor do writes to the board, with the way back of parameters.
inline constexpr std::chrono::seconds write_bound{60};

/// While it exists, SIGINT, SIGTERM and SIGHUP ask the program to end; was_interrupted() tells. A
/// program that has been asked may take 8 s, or as long as a MustFinish says. Further signals, such
/// as those of a terminal that closes, change nothing, but for a second Ctrl-C that a person can
/// have meant: SIGINT at least 500 ms after the first one ends the program at once. A SIGHUP that
/// was ignored at the start (nohup) stays so. One may exist inside another, on the same thread.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

/// An Interruption during what must be finished: it may take `bound` after a signal, and no signal
/// suspends or ends it. If it is cut short, "... `undone`" says what is left, such as "the camera
/// may still turn".
class MustFinish {
 public:
  MustFinish(std::chrono::seconds bound, std::string undone);
  MustFinish(const MustFinish&) = delete;
  MustFinish& operator=(const MustFinish&) = delete;
  ~MustFinish();

 private:
  Interruption interruption_{};
  const void* duty_;
};

/// While it exists inside an Interruption, a second Ctrl-C, or the bound, does not end the program:
/// was_cut_short() tells. The program has 5 s to say what it leaves undone; a third Ctrl-C ends it.
class CutShort {
 public:
  CutShort() noexcept;
  CutShort(const CutShort&) = delete;
  CutShort& operator=(const CutShort&) = delete;
  ~CutShort();
};

/// True if what must be finished has been cut short while a CutShort existed.
bool was_cut_short() noexcept;

/// True if a signal asked the program to end while an Interruption existed.
bool was_interrupted() noexcept;
/// True if that signal is the one of Ctrl-C.
bool was_interrupted_by_key() noexcept;

/// A descriptor that becomes readable when a signal arrives, for poll(). Valid while an
/// Interruption exists.
int interruption_descriptor() noexcept;

/// The signals of an Interruption, for programs with a loop of their own.
std::vector<int> asking_signals();

/// Blocks all signals for the threads that start meanwhile: the others handle them, and a write
/// without a reader is only an error.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all{};
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &previous_);
  }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;
  ~WithoutSignals() { ::pthread_sigmask(SIG_SETMASK, &previous_, nullptr); }

 private:
  sigset_t previous_{};
};

}  // namespace sbgc::tools
