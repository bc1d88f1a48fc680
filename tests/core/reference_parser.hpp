// The framing semantics implemented over a complete byte string, independently of the library.
//
// A frame is delivered at a position if the start byte is there, the id is not 0, the header
// checksum matches, the body and its checksum are complete, and the checksum matches. The search
// then continues after the frame; otherwise it continues at the next position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sbgc::test {

using Bytes = std::vector<std::uint8_t>;

struct ReferenceFrame {
  std::uint8_t id{};
  Bytes body;
  std::uint64_t offset{};

  bool operator==(const ReferenceFrame&) const = default;
};

struct ReferenceResult {
  std::vector<ReferenceFrame> frames;
  std::uint64_t skipped_bytes{};
  std::uint64_t header_errors{};
  std::uint64_t body_errors{};
  std::uint64_t incomplete{};
  std::size_t waiting_bytes{};
};

enum class End {
  final,  // the string is complete: an incomplete candidate is not a frame
  open,   // more may follow: the first incomplete candidate waits, with all bytes after it
};

inline ReferenceResult reference_parse(const Bytes& s, End end, std::uint64_t offset = 0) {
  ReferenceResult result;
  std::size_t i = 0;
  while (i < s.size()) {
    if (s[i] == 0x3E) {
      const std::size_t left = s.size() - i;
      if (left >= 4 && (s[i + 1] == 0 || (s[i + 1] + s[i + 2]) % 256 != s[i + 3])) {
        ++result.header_errors;
      } else if (left < 4 || left < std::size_t{4} + s[i + 2] + 1) {
        if (end == End::open) break;
        ++result.incomplete;
      } else {
        const std::size_t body_size = s[i + 2];
        Bytes body;
        unsigned sum = 0;
        for (std::size_t k = 0; k < body_size; ++k) {
          body.push_back(s[i + 4 + k]);
          sum += s[i + 4 + k];
        }
        if (sum % 256 == s[i + 4 + body_size]) {
          result.frames.push_back({s[i + 1], body, offset + i});
          i += 4 + body_size + 1;
          continue;
        }
        ++result.body_errors;
      }
    }
    ++result.skipped_bytes;
    ++i;
  }
  result.waiting_bytes = s.size() - i;
  return result;
}

}  // namespace sbgc::test
