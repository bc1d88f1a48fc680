// Bombs and a limit of time, for the fuzzers of text.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>

namespace sbgc::fuzz {

constexpr std::size_t longest_text = std::size_t{1} << 16U;

/// Returns the text of an input, in which the byte 1 starts a bomb: the next byte is the exponent
/// of 2 of its count, the one after it the number of following bytes that are repeated. So a
/// mutation can make a deep or wide text.
inline std::string text_with_bombs(std::span<const std::uint8_t> input) {
  std::string text;
  while (!input.empty()) {
    if (input[0] != 1 || input.size() < 3) {
      text += static_cast<char>(input[0]);
      input = input.subspan(1);
      continue;
    }
    const std::size_t count = std::size_t{1} << (input[1] % 18U);
    const std::size_t size = std::min<std::size_t>(input[2], input.size() - 3);
    const std::string part(input.begin() + 3,
                           input.begin() + 3 + static_cast<std::ptrdiff_t>(size));
    for (std::size_t i = 0; i < count && text.size() + size <= longest_text; ++i) text += part;
    input = input.subspan(3 + size);
  }
  return text;
}

/// Calls `use`, and aborts if that takes more than `per_byte` for each of `size` bytes. Only the
/// time of this thread counts, and only if it is repeatedly too long: a busy machine is no finding.
template <class Use>
void require_linear_time(std::size_t size, std::chrono::nanoseconds per_byte, const Use& use) {
  using std::chrono::nanoseconds;
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
  };
  // Much for a short text: suggestions compare an unknown name with all others.
  constexpr nanoseconds constant = std::chrono::milliseconds(500);
  const nanoseconds limit = constant + per_byte * static_cast<std::int64_t>(size);
  for (int attempt = 0; attempt < 5; ++attempt) {
    const nanoseconds begin = now();
    use();
    if (now() - begin <= limit) return;
  }
  std::abort();
}

}  // namespace sbgc::fuzz
