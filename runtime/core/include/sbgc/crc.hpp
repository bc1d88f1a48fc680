/// Cyclic redundancy checks of 8, 16 and 32 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/detail/crc_fold.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/protocol.hpp>

namespace sbgc {

/// The table for computing a cyclic redundancy check: more memory, fewer steps. A program that is
/// entirely compiled with SBGC_SMALL_CRC_TABLES has only `nibbles`.
enum class CrcTable : std::uint8_t {
  nibbles,  ///< 32 bytes; two steps for each byte
  bytes,    ///< 512 bytes; a step for each byte
  slices,   ///< 4 KB; a step for each eight bytes, or by multiplication if the processor can;
            ///< the same as `bytes` for checks other than those of 16 bits with reflected input
};

namespace detail {

/// Returns the bits in the opposite order: swaps halves, bytes, nibbles, pairs and single bits.
template <class Word>
constexpr Word reversed(Word value) noexcept {
  std::uint32_t bits = value;
  if constexpr (sizeof(Word) == 4) bits = bits >> 16 | bits << 16;
  if constexpr (sizeof(Word) >= 2) bits = (bits >> 8 & 0x00FF00FF) | (bits & 0x00FF00FF) << 8;
  bits = (bits >> 4 & 0x0F0F0F0F) | (bits & 0x0F0F0F0F) << 4;
  bits = (bits >> 2 & 0x33333333) | (bits & 0x33333333) << 2;
  bits = (bits >> 1 & 0x55555555) | (bits & 0x55555555) << 1;
  return static_cast<Word>(bits);
}

/// Returns the register, least significant bit first, after `steps` zero bits.
template <class Word>
constexpr Word shifted(Word value, int steps, Word polynomial) noexcept {
  for (int step = 0; step < steps; ++step) {
    value = static_cast<Word>(value >> 1 ^ ((value & 1) != 0 ? polynomial : Word{}));
  }
  return value;
}

/// table[n][b] is the register after the byte b and n zero bytes.
template <auto polynomial, std::size_t slices>
inline constexpr auto crc_table = [] {
  using Word = decltype(polynomial);
  std::array<std::array<Word, 256>, slices> table{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    auto value = static_cast<Word>(byte);
    for (std::size_t slice = 0; slice < slices; ++slice) {
      value = shifted(value, 8, polynomial);
      table[slice][byte] = value;
    }
  }
  return table;
}();

template <auto polynomial>
inline constexpr auto crc_nibbles = [] {
  using Word = decltype(polynomial);
  std::array<Word, 16> table{};
  for (std::size_t nibble = 0; nibble < 16; ++nibble) {
    table[nibble] = shifted(static_cast<Word>(nibble), 4, polynomial);
  }
  return table;
}();

}  // namespace detail

/// Accumulates a cyclic redundancy check over several ranges. Its register has the least
/// significant bit first, so that reflected bytes enter unchanged.
template <auto parameters, CrcTable table>
class Crc {
 public:
  /// The type of the sum.
  using Word = decltype(parameters.polynomial);

  /// Adds bytes.
  constexpr Crc& add(const std::uint8_t* bytes, std::size_t size) noexcept {
#if SBGC_HAS_CARRYLESS_MULTIPLICATION
    if constexpr (uses_slices) {
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
  constexpr Crc& add_by_table(const std::uint8_t* bytes, std::size_t size) noexcept {
    const std::uint8_t* const end = bytes + size;
    std::uint32_t value = register_;
    if constexpr (uses_slices) {
      constexpr auto& of = detail::crc_table<polynomial, 8>;
      for (; end - bytes >= 8; bytes += 8) {
        value = of[7][(value ^ bytes[0]) & 0xFF] ^ of[6][value >> 8 ^ bytes[1]] ^ of[5][bytes[2]] ^
                of[4][bytes[3]] ^ of[3][bytes[4]] ^ of[2][bytes[5]] ^ of[1][bytes[6]] ^
                of[0][bytes[7]];
      }
    }
    for (; bytes != end; ++bytes) {
      const std::uint8_t byte = parameters.reflect_in ? *bytes : detail::reversed(*bytes);
      if constexpr (uses_nibbles) {
        constexpr auto& of = detail::crc_nibbles<polynomial>;
        value ^= byte;
        value = value >> 4 ^ of[value & 15];
        value = value >> 4 ^ of[value & 15];
      } else {
        constexpr auto &of = detail::crc_table < polynomial, uses_slices ? 8 : 1 > [0];
        value = value >> 8 ^ of[(value ^ byte) & 0xFF];
      }
    }
    register_ = static_cast<Word>(value);
    return *this;
  }

  /// Returns the sum of all bytes so far.
  constexpr Word value() const noexcept {
    const Word value = parameters.reflect_out ? register_ : detail::reversed(register_);
    return static_cast<Word>(value ^ parameters.final_xor);
  }

 private:
  static constexpr Word polynomial = detail::reversed(parameters.polynomial);
#if defined(SBGC_SMALL_CRC_TABLES)
  static constexpr bool uses_nibbles = true;
#else
  static constexpr bool uses_nibbles = table == CrcTable::nibbles;
#endif
  static constexpr bool uses_slices =
      !uses_nibbles && table == CrcTable::slices && sizeof(Word) == 2 && parameters.reflect_in;

  Word register_ = detail::reversed(parameters.initial);
};

}  // namespace sbgc
