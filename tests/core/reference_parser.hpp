// The framing semantics implemented over a complete byte string, independently of the library.
//
// A frame is delivered at a position if a start byte is there, the id is not 0, the header checksum
// matches, the body and its checksum are complete, and the checksum matches. The search then
// continues after the frame; otherwise it continues at the next position. The start byte says
// which framing a candidate must follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sbgc::test {

using Bytes = std::vector<std::uint8_t>;

/// The framings that a parser accepts.
enum class Accepts { v1, v2, both };

struct ReferenceFrame {
  std::uint8_t id{};
  Bytes body;
  std::uint64_t offset{};
  bool is_v2 = false;

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

/// The checksum of v2, bit by bit: polynomial 0x8005, data least significant bit first.
inline unsigned reference_crc(const Bytes& bytes) {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes) {
    for (int bit = 0; bit < 8; ++bit) {
      const bool carry = ((byte >> bit & 1U) ^ crc >> 15) != 0;
      crc = (crc << 1 & 0xFFFFU) ^ (carry ? 0x8005U : 0);
    }
  }
  return crc;
}

inline ReferenceResult reference_parse(const Bytes& s, End end, std::uint64_t offset = 0,
                                       Accepts accepts = Accepts::v1) {
  ReferenceResult result;
  std::size_t i = 0;
  while (i < s.size()) {
    const bool is_v2 = s[i] == 0x24;
    const std::size_t trailer = is_v2 ? 2 : 1;
    if ((s[i] == 0x3E && accepts != Accepts::v2) || (is_v2 && accepts != Accepts::v1)) {
      const std::size_t left = s.size() - i;
      if (left >= 4 && (s[i + 1] == 0 || (s[i + 1] + s[i + 2]) % 256 != s[i + 3])) {
        ++result.header_errors;
      } else if (left < 4 || left < std::size_t{4} + s[i + 2] + trailer) {
        if (end == End::open) break;
        ++result.incomplete;
      } else {
        const std::size_t body_size = s[i + 2];
        Bytes body;
        Bytes covered{s[i + 1], s[i + 2], s[i + 3]};
        unsigned sum = 0;
        for (std::size_t k = 0; k < body_size; ++k) {
          body.push_back(s[i + 4 + k]);
          covered.push_back(s[i + 4 + k]);
          sum += s[i + 4 + k];
        }
        const std::size_t at = i + 4 + body_size;
        const bool is_right =
            is_v2 ? reference_crc(covered) == s[at] + 256U * s[at + 1] : sum % 256 == s[at];
        if (is_right) {
          result.frames.push_back({s[i + 1], body, offset + i, is_v2});
          i += 4 + body_size + trailer;
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
