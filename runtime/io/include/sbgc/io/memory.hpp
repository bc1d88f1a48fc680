/// Two transports connected in memory.
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

/// Returns the bytes that a receiver gets if they were sent back to back with different line
/// settings.
using LineMismatch = std::function<std::vector<std::uint8_t>(
    std::span<const std::uint8_t> bytes, const LineSettings& sender, const LineSettings& receiver)>;

/// Options of a pair of transports in memory.
struct MemoryOptions {
  /// The number of bytes that may be buffered in each direction; a write completes when all its
  /// bytes are buffered. At least 1.
  std::size_t capacity = 65536;
  /// The maximum number of bytes that one read delivers. At least 1.
  std::size_t max_read = std::numeric_limits<std::size_t>::max();
  /// Both ends have a LineControl.
  bool with_line = false;
  /// Maps bytes written while the line settings of the two ends differ; if empty, none arrive.
  LineMismatch mismatch{};
};

/// Each end reads what the other writes. When an end is closed, the other reads the bytes written
/// before, then Errc::end_of_stream; its writes fail with Errc::end_of_stream immediately.
struct MemoryPair {
  std::unique_ptr<Transport> first;
  std::unique_ptr<Transport> second;
};

/// Both ends on one executor: on a single thread, the order of events is deterministic.
MemoryPair make_memory_pair(const asio::any_io_executor& executor,
                            const MemoryOptions& options = {});
/// Each end on its own executor; they may run on different threads.
MemoryPair make_memory_pair(const asio::any_io_executor& first, const asio::any_io_executor& second,
                            const MemoryOptions& options = {});

}  // namespace sbgc::io
