/// CRC-32 as used by zip, PNG and Ethernet.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace sbgc::detail {

/// The coefficient of x^0 is the highest bit.
inline constexpr std::uint32_t crc32_polynomial = 0xEDB88320;

inline constexpr std::array<std::uint32_t, 256> crc32_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ crc32_polynomial * (value & 1);
    table[i] = value;
  }
  return table;
}();

constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t value = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) value = (value >> 8) ^ crc32_table[(value ^ byte) & 0xFF];
  return ~value;
}

}  // namespace sbgc::detail
