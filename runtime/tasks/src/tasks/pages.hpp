/// Splitting a memory range into messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sbgc::detail {

/// Whole pages that fit into one message.
struct PageRun {
  std::uint64_t address{};  ///< a multiple of the page size
  std::size_t size{};       ///< a multiple of the page size

  bool operator==(const PageRun&) const = default;
};

/// Returns the runs of whole pages that cover `size` bytes from `address`, at most `most` bytes
/// each. Precondition: `page` is not 0, and `most` is at least one page.
inline std::vector<PageRun> page_runs(std::uint64_t address, std::size_t size, std::size_t page,
                                      std::size_t most) {
  std::vector<PageRun> runs;
  if (size == 0) return runs;
  const std::size_t step = most / page * page;
  const std::uint64_t end = (address + size + page - 1) / page * page;
  for (std::uint64_t at = address / page * page; at < end; at += step) {
    runs.push_back({at, static_cast<std::size_t>(std::min<std::uint64_t>(step, end - at))});
  }
  return runs;
}

}  // namespace sbgc::detail
