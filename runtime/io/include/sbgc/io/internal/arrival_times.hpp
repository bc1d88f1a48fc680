/// The arrival times of the bytes of a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include <sbgc/io/capture.hpp>

namespace sbgc::io::detail {

class ArrivalTimes {
 public:
  /// Records that the next bytes have arrived.
  void add(std::size_t size, CaptureTime time) {
    size_ += size;
    marks_.push_back({size_, time});
  }
  /// Returns the number of bytes that have arrived.
  std::uint64_t size() const noexcept { return size_; }

  /// Returns the arrival time of the last of the first `end` bytes. Precondition: it has arrived,
  /// and is not forgotten.
  CaptureTime of(std::uint64_t end) {
    while (marks_.front().end < end) marks_.pop_front();
    return marks_.front().time;
  }
  /// Forgets the first `end` bytes.
  void forget(std::uint64_t end) {
    while (!marks_.empty() && marks_.front().end <= end) marks_.pop_front();
  }

 private:
  /// The arrival time of the bytes up to `end`.
  struct Mark {
    std::uint64_t end;
    CaptureTime time;
  };

  std::uint64_t size_ = 0;
  std::deque<Mark> marks_{};
};

}  // namespace sbgc::io::detail
