/// Two transports that are connected to each other in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

struct MemoryOptions {
  /// Bytes each way that may be written but not read; a write completes when all its bytes are
  /// among them. At least 1.
  std::size_t capacity = 65536;
  /// The most bytes that one read delivers. At least 1.
  std::size_t max_read = std::numeric_limits<std::size_t>::max();
  /// Both ends have a LineControl. What is written while their settings differ arrives as the
  /// garbage that a UART would make of it.
  bool with_line = false;
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

/// What a UART with the settings `receiver` makes of bytes that another sends, back to back on an
/// idle line, with the settings `sender`. It drops bytes without a stop bit or with a wrong parity.
std::vector<std::uint8_t> received_as(std::span<const std::uint8_t> bytes,
                                      const LineSettings& sender, const LineSettings& receiver);

}  // namespace sbgc::io
