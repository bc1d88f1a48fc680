/// Lines for people who may not be reading.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sbgc::serving {

/// Writes lines to a file descriptor, and never waits: a line for which there is no room is left
/// out, and once there is room again, a line says how many were. What can not be written at all is
/// nobody's business either.
class NonblockingLines {
 public:
  /// Of the descriptor's file, which stays open.
  explicit NonblockingLines(int descriptor);
  NonblockingLines(const NonblockingLines&) = delete;
  NonblockingLines& operator=(const NonblockingLines&) = delete;
  /// Says how many were left out, if it can be said now.
  ~NonblockingLines();

  void write_line(const std::string& line);

 private:
  /// Whether nothing waits any more of a line that was written in part, and nothing that is left
  /// out has yet to be told of.
  bool catch_up();
  /// Whether all or a part of it has been written; `rest_` is what has not.
  bool write(std::string_view text);

  int descriptor_;
  int own_;           // the same file, opened so that writing never waits; -1 if that can not be
  std::string rest_;  // of a line
  std::size_t left_out_ = 0;
};

}  // namespace sbgc::serving
