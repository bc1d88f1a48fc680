/// Two transports that are connected to each other in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// What a receiver gets of bytes that were sent back to back with other line settings than its own.
using LineMismatch = std::function<std::vector<std::uint8_t>(
    std::span<const std::uint8_t> bytes, const LineSettings& sender, const LineSettings& receiver)>;

struct MemoryOptions {
  /// Bytes each way that may be written but not read; a write completes when all its bytes are
  /// among them. At least 1.
  std::size_t capacity = 65536;
  /// The most bytes that one read delivers. At least 1.
  std::size_t max_read = std::numeric_limits<std::size_t>::max();
  /// Both ends have a LineControl.
  bool with_line = false;
  /// What arrives of bytes written while the settings of the two ends differ; without it, nothing
  /// does.
  LineMismatch mismatch{};
};

/// What one end writes, the other reads. When an end is closed, the other reads what was written
/// before, then Errc::end_of_stream; its writes end with Errc::end_of_stream at once.
struct MemoryPair {
  std::unique_ptr<Transport> first;
  std::unique_ptr<Transport> second;
};

/// Both ends on one executor: on a single thread everything happens in the same order each time.
MemoryPair make_memory_pair(const asio::any_io_executor& executor,
                            const MemoryOptions& options = {});
/// Each end on an executor of its own; they may run on different threads.
MemoryPair make_memory_pair(const asio::any_io_executor& first, const asio::any_io_executor& second,
                            const MemoryOptions& options = {});

}  // namespace sbgc::io
