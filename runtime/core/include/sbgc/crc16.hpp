/// Cyclic redundancy checks of 16 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/detail/compiler.hpp>
#include <sbgc/detail/crc_fold.hpp>
#include <sbgc/protocol.hpp>

namespace sbgc {

/// The table with which a cyclic redundancy check is computed: more memory, fewer steps.
enum class CrcTable : std::uint8_t {
  nibbles,  ///< 32 bytes; two steps for each byte
  bytes,    ///< 512 bytes; a step for each byte
  slices,   ///< 4 KB; a step for each eight bytes, or by multiplication if the processor can
};

namespace detail {

/// Returns the bits in the opposite order: swaps bytes, nibbles, pairs and single bits.
constexpr std::uint16_t reversed(std::uint16_t value) noexcept {
  unsigned bits = value;
  bits = bits >> 8 | (bits & 0x00FF) << 8;
  bits = (bits >> 4 & 0x0F0F) | (bits & 0x0F0F) << 4;
  bits = (bits >> 2 & 0x3333) | (bits & 0x3333) << 2;
  bits = (bits >> 1 & 0x5555) | (bits & 0x5555) << 1;
  return static_cast<std::uint16_t>(bits);
}

/// Returns the register, least significant bit first, after `steps` zero bits.
constexpr std::uint16_t shifted(std::uint16_t value, int steps, std::uint16_t polynomial) noexcept {
  for (int step = 0; step < steps; ++step) {
    value = static_cast<std::uint16_t>(value >> 1 ^ ((value & 1) != 0 ? polynomial : 0));
  }
  return value;
}

/// table[n][b] is the register after the byte b and n zero bytes.
template <std::uint16_t polynomial, std::size_t slices>
inline constexpr auto crc_table = [] {
  std::array<std::array<std::uint16_t, 256>, slices> table{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    auto value = static_cast<std::uint16_t>(byte);
    for (std::size_t slice = 0; slice < slices; ++slice) {
      value = shifted(value, 8, polynomial);
      table[slice][byte] = value;
    }
  }
  return table;
}();

template <std::uint16_t polynomial>
inline constexpr auto crc_nibbles = [] {
  std::array<std::uint16_t, 16> table{};
  for (std::size_t nibble = 0; nibble < 16; ++nibble) {
    table[nibble] = shifted(static_cast<std::uint16_t>(nibble), 4, polynomial);
  }
  return table;
}();

}  // namespace detail

/// Accumulates a cyclic redundancy check over several ranges.
template <Crc16Parameters parameters, CrcTable table>
class Crc16 {
  static_assert(parameters.reflect_in, "only checks whose bytes enter least significant bit first");

 public:
  constexpr Crc16& add(const std::uint8_t* bytes, std::size_t size) noexcept {
#if SBGC_HAS_CARRYLESS_MULTIPLICATION
    if constexpr (table == CrcTable::slices) {
      constexpr std::size_t worthwhile = 32;
      if (!detail::is_constant_evaluated() && size >= worthwhile &&
          detail::has_carryless_multiplication()) {
        register_ = detail::crc_by_folding<polynomial>(register_, bytes, size);
        return *this;
      }
    }
#endif
    return add_by_table(bytes, size);
  }

  /// The same by table on any processor.
  constexpr Crc16& add_by_table(const std::uint8_t* bytes, std::size_t size) noexcept {
    const std::uint8_t* const end = bytes + size;
    unsigned value = register_;
    if constexpr (table == CrcTable::slices) {
      constexpr auto& of = detail::crc_table<polynomial, 8>;
      for (; end - bytes >= 8; bytes += 8) {
        value = of[7][(value ^ bytes[0]) & 0xFF] ^ of[6][value >> 8 ^ bytes[1]] ^ of[5][bytes[2]] ^
                of[4][bytes[3]] ^ of[3][bytes[4]] ^ of[2][bytes[5]] ^ of[1][bytes[6]] ^
                of[0][bytes[7]];
      }
    }
    for (; bytes != end; ++bytes) {
      if constexpr (table == CrcTable::nibbles) {
        constexpr auto& of = detail::crc_nibbles<polynomial>;
        value ^= *bytes;
        value = value >> 4 ^ of[value & 15];
        value = value >> 4 ^ of[value & 15];
      } else {
        constexpr auto &of = detail::crc_table < polynomial,
                       table == CrcTable::slices ? 8 : 1 > [0];
        value = value >> 8 ^ of[(value ^ *bytes) & 0xFF];
      }
    }
    register_ = static_cast<std::uint16_t>(value);
    return *this;
  }

  constexpr std::uint16_t value() const noexcept {
    const std::uint16_t value = parameters.reflect_out ? register_ : detail::reversed(register_);
    return static_cast<std::uint16_t>(value ^ parameters.final_xor);
  }

 private:
  static constexpr std::uint16_t polynomial = detail::reversed(parameters.polynomial);

  std::uint16_t register_ = detail::reversed(parameters.initial);
};

}  // namespace sbgc
