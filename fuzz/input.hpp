/// Shared by the fuzzers: require(), and the input as a script.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sbgc::fuzz {

/// Ends a fuzzer, which thereby reports its input, if an invariant does not hold.
inline void require(bool condition) {
  if (!condition) std::abort();
}

/// Bytes that are read one after the other; after the end, all are 0.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }
  std::size_t size() const { return bytes_.size(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t result = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return result;
  }

  /// Returns at most `most` bytes.
  std::span<const std::uint8_t> bytes(std::size_t most) {
    const auto result = bytes_.first(std::min(most, bytes_.size()));
    bytes_ = bytes_.subspan(result.size());
    return result;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace sbgc::fuzz
