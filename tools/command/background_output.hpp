/// Output of commands that move a camera or serve hosts, which must not wait for a reader.
#pragma once

#include <chrono>
#include <memory>
#include <string>

namespace sbgc::tools {

/// Writes text to a file on a thread of its own. If the reader is slow or gone, a limited amount of
/// text waits; later text is dropped, and the number of its lines is written instead. Thread-safe.
class BackgroundOutput {
 public:
  /// Does not close the descriptor.
  explicit BackgroundOutput(int descriptor);
  BackgroundOutput(const BackgroundOutput&) = delete;
  BackgroundOutput& operator=(const BackgroundOutput&) = delete;
  /// Calls finish().
  ~BackgroundOutput();

  /// Never waits for the reader.
  void write(const std::string& text);
  /// Waits until everything is written.
  void wait();
  /// Waits for that until a time; returns false if it has not come.
  bool wait_until(std::chrono::steady_clock::time_point end);
  /// Waits for that as long as the reader reads. Returns false if something could not be written
  /// although the reader has not left.
  bool finish();
  /// True if a write has failed, as when the reader has left.
  bool is_closed() const;
  /// False if finish() has not waited for everything.
  bool is_complete() const;

 private:
  struct State;

  std::shared_ptr<State> state_;  // the thread may be blocked for longer than this object exists
};

BackgroundOutput& background_stdout();
BackgroundOutput& background_stderr();

/// Ends the standard output of a command that serves hosts. Throws CommandError if finish() fails.
void finish_stdout();

/// From now on, remarks go to background_stderr().
void remark_in_background();

}  // namespace sbgc::tools
