/// Lines of output for a reader that may be slow or gone.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sbgc::serving {

/// Writes lines to a file descriptor and never blocks: a line for which there is no room is left
/// out, and once there is room again, a line says how many were. Errors are ignored.
class NonblockingLines {
 public:
  /// The descriptor stays open.
  explicit NonblockingLines(int descriptor);
  NonblockingLines(const NonblockingLines&) = delete;
  NonblockingLines& operator=(const NonblockingLines&) = delete;
  /// Writes how many lines were left out, if there is room.
  ~NonblockingLines();

  void write_line(const std::string& line);

 private:
  /// Finishes a line that was written in part and reports lines that were left out. False if there
  /// is no room for all of that.
  bool catch_up();
  /// True if at least a part of the text has been written; `rest_` is the remainder.
  bool write(std::string_view text);

  int descriptor_;
  int own_;           // the same file, opened non-blocking; -1 if that is not possible
  std::string rest_;  // of a line
  std::size_t left_out_ = 0;
};

}  // namespace sbgc::serving
