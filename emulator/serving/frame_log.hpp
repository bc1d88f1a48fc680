/// Frames between hosts and a board, as log lines.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/emulator/board.hpp>

namespace sbgc::serving {

/// Describes a frame in one line. The user of this library provides it, because command names are
/// not available here.
using DescribeFrame = std::function<std::string(const emulator::Board::Traffic&)>;

/// Collects one line per frame, a request before its responses. The board reports the verdict of a
/// request only after it has sent the responses.
class FrameLog {
 public:
  explicit FrameLog(DescribeFrame describe) : describe_(std::move(describe)) {}

  void add(const emulator::Board::Traffic& traffic);
  /// Takes the lines since the last call. Must not be called while the board executes a request.
  std::vector<std::string> take();

 private:
  DescribeFrame describe_;
  std::vector<std::string> lines_{};
  std::size_t responses_ =
      0;  // responses at the end of lines_ whose request has not been reported yet
  Instant at_{};
  std::size_t port_ = 0;
};

}  // namespace sbgc::serving
