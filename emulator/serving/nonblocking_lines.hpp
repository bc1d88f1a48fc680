/// Output lines for a reader that may be slow or gone.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sbgc::serving {

/// Writes lines to a file descriptor without blocking. Drops lines for which there is no room, and
/// reports their number once there is room again. Ignores errors.
class NonblockingLines {
 public:
  /// Does not close the descriptor.
  explicit NonblockingLines(int descriptor);
  NonblockingLines(const NonblockingLines&) = delete;
  NonblockingLines& operator=(const NonblockingLines&) = delete;
  /// Reports the number of dropped lines, if there is room.
  ~NonblockingLines();

  void write_line(const std::string& line);

 private:
  /// Completes a partially written line and reports dropped lines. Returns false if there is no
  /// room for all of that.
  bool catch_up();
  /// Returns true if at least part of the text was written; `rest_` is the remainder.
  bool write(std::string_view text);

  int descriptor_;
  int own_;           // the same file, opened nonblocking; -1 if that is impossible
  std::string rest_;  // of a line
  std::size_t left_out_ = 0;
};

}  // namespace sbgc::serving
