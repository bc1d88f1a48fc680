/// CRC-32 of any range of a sequence of bytes, in constant time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/internal/crc32.hpp>

namespace sbgc::io::detail {

/// Multiplies two polynomials modulo that of CRC-32. The coefficient of x^0 is the highest bit.
constexpr std::uint32_t multiply_crc32(std::uint32_t a, std::uint32_t b) noexcept {
  std::uint32_t product = 0;
  for (; a != 0; a <<= 1) {
    if ((a & 0x80000000) != 0) product ^= b;
    b = (b >> 1) ^ sbgc::detail::crc32_polynomial * (b & 1);
  }
  return product;
}

/// The powers of x by which zero bytes multiply a register: row k is for 0 to 255 times 256^k
/// bytes.
inline constexpr std::array<std::array<std::uint32_t, 256>, 3> zero_bytes_crc32 = [] {
  std::array<std::array<std::uint32_t, 256>, 3> rows{};
  std::uint32_t step = 0x00800000;  // x^8
  for (auto& row : rows) {
    row[0] = 0x80000000;
    for (std::size_t i = 1; i < row.size(); ++i) row[i] = multiply_crc32(row[i - 1], step);
    step = multiply_crc32(row.back(), step);
  }
  return rows;
}();

/// Computes the CRC of each range of the bytes that were appended and not dropped.
class RangeCrc32 {
 public:
  static constexpr std::size_t longest = (std::size_t{1} << 24) - 1;

  std::size_t size() const noexcept { return registers_.size() - 1; }

  void append(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      const std::uint32_t value = registers_.back();
      registers_.push_back((value >> 8) ^ sbgc::detail::crc32_table[(value ^ byte) & 0xFF]);
    }
  }

  /// Drops bytes from the beginning; all bytes if there are fewer.
  void drop(std::size_t count) {
    const std::size_t most = count < size() ? count : size();
    registers_.erase(registers_.begin(), registers_.begin() + static_cast<std::ptrdiff_t>(most));
  }

  /// Returns the CRC of `count` bytes, at most `longest`, starting at `begin`.
  std::uint32_t of(std::size_t begin, std::size_t count) const noexcept {
    // A register is linear in its initial value: zero bytes carry the difference to 0xFFFFFFFF.
    std::uint32_t difference = registers_[begin] ^ 0xFFFFFFFF;
    std::size_t digits = count;
    for (const auto& row : zero_bytes_crc32) {
      difference = multiply_crc32(row[digits & 0xFF], difference);
      digits >>= 8;
    }
    return ~(registers_[begin + count] ^ difference);
  }

 private:
  std::vector<std::uint32_t> registers_{0};  // after each number of bytes, from 0 on
};

}  // namespace sbgc::io::detail
