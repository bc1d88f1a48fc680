/// Ctrl-C and the other signals that ask a program to end.
#pragma once

namespace sbgc::tools {

/// While it exists, SIGINT, SIGTERM and SIGHUP no longer end the program; was_interrupted() tells.
/// The second signal ends it. One may exist inside another, on the same thread.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

/// While it exists inside an Interruption, the program has a use for a second signal, which only
/// Ctrl-C sends: others that follow the first signal are ignored. The third one ends the program.
class SecondSignal {
 public:
  SecondSignal() noexcept;
  SecondSignal(const SecondSignal&) = delete;
  SecondSignal& operator=(const SecondSignal&) = delete;
  ~SecondSignal();
};

/// True if Ctrl-C was the second signal, or one later, while a SecondSignal existed.
bool was_interrupted_twice() noexcept;

/// True if a signal asked the program to end while an Interruption existed.
bool was_interrupted() noexcept;
/// True if that signal is the one of Ctrl-C.
bool was_interrupted_by_key() noexcept;

/// A descriptor that becomes readable when a signal arrives, for poll(). Valid while an
/// Interruption exists.
int interruption_descriptor() noexcept;

}  // namespace sbgc::tools
