/// CRC-32 as used by zip, PNG and Ethernet.
#pragma once

#include <cstdint>
#include <span>

#include <sbgc/crc.hpp>

namespace sbgc::detail {

/// The coefficient of x^0 is the highest bit.
inline constexpr std::uint32_t crc32_polynomial = 0xEDB88320;

#if defined(SBGC_SMALL_CRC_TABLES)

constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
  constexpr const auto& of = crc_nibbles<crc32_polynomial>;
  std::uint32_t value = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    value ^= byte;
    value = value >> 4 ^ of[value & 15];
    value = value >> 4 ^ of[value & 15];
  }
  return ~value;
}

#else

inline constexpr auto& crc32_table = crc_table<crc32_polynomial, 8>[0];

constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
  constexpr const auto& of = crc_table<crc32_polynomial, 8>;
  std::uint32_t value = 0xFFFFFFFF;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    value ^= bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
             std::uint32_t{bytes[3]} << 24;
    value = of[7][value & 0xFF] ^ of[6][value >> 8 & 0xFF] ^ of[5][value >> 16 & 0xFF] ^
            of[4][value >> 24] ^ of[3][bytes[4]] ^ of[2][bytes[5]] ^ of[1][bytes[6]] ^
            of[0][bytes[7]];
  }
  for (const std::uint8_t byte : bytes) value = (value >> 8) ^ of[0][(value ^ byte) & 0xFF];
  return ~value;
}

#endif

}  // namespace sbgc::detail
