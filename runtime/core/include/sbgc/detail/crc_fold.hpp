/// Cyclic redundancy checks by multiplication without carry, which x86 processors have had as an
/// instruction since about 2010: blocks of 16 bytes are folded into one with the same remainder.
#pragma once

#if defined(__x86_64__) && defined(__SSE2__) && \
    ((defined(__PCLMUL__) && defined(__SSSE3__)) || (defined(__GNUC__) && __STDC_HOSTED__))

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/checksum.hpp>

/// Defined if fold_blocks() can be compiled; has_carryless_multiplication() says if it can run.
#define SBGC_HAS_CRC_FOLD 1

namespace sbgc::detail {

/// Returns true if the processor has the instructions of fold_blocks(). Freestanding programs have
/// no library that knows; they use them if the compiler may.
inline bool has_carryless_multiplication() noexcept {
#if defined(__PCLMUL__) && defined(__SSSE3__)
  return true;
#else
  return static_cast<bool>(__builtin_cpu_supports("pclmul")) &&
         static_cast<bool>(__builtin_cpu_supports("ssse3"));
#endif
}

/// Returns x^exponent modulo the polynomial. Here and below the coefficient of the highest power is
/// in the lowest bit, as in the register of a check whose bytes enter least significant bit first.
constexpr std::uint16_t power_of_x(unsigned exponent, std::uint16_t polynomial) noexcept {
  unsigned power = 0x8000;  // x^0
  for (; exponent != 0; --exponent) power = power >> 1 ^ ((power & 1) != 0 ? polynomial : 0U);
  return static_cast<std::uint16_t>(power);
}

/// The factors that move the lower and the upper half of a block over the 16 bytes after it. A
/// product has 127 bits, the highest power in bit 0, so that it is x times too large as a block.
template <std::uint16_t polynomial>
inline constexpr std::array<std::uint64_t, 2> fold_factors = {
    std::uint64_t{power_of_x(128 + 64 - 1, polynomial)} << 48,
    std::uint64_t{power_of_x(128 - 1, polynomial)} << 48};

/// A table of shuffles: the 16 bytes at offset n move the last n bytes of the result to the first n
/// places of the source, and at offset 16 + n the other way; other bytes become 0.
inline constexpr std::uint8_t shift_bytes[48] = {
    128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128,
    0,   1,   2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,
    128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128};

/// Returns 16 bytes that, entering a register of 0, leave it as `size` bytes leave the register
/// `start`. Precondition: size >= 16.
template <std::uint16_t polynomial>
[[gnu::target("pclmul,ssse3")]] inline std::array<std::uint8_t, 16> fold_blocks(
    std::uint16_t start, const std::uint8_t* bytes, std::size_t size) noexcept {
  constexpr auto& factors = fold_factors<polynomial>;
  const auto by = Words2{static_cast<long long>(factors[0]), static_cast<long long>(factors[1])};
  const auto first = reinterpret_cast<Bytes16>(Words2{start, 0});
  const std::size_t rest = size % 16;
  // Leading zeros do not change a register of 0: the first block is filled up with them. The
  // register enters together with the first two bytes, the second of which may be in the next
  // block.
  const auto to_end = reinterpret_cast<Chars16>(load16(shift_bytes + rest));
  const auto to_begin = reinterpret_cast<Chars16>(load16(shift_bytes + 16 + rest));
  auto folded = reinterpret_cast<Words2>(
      __builtin_ia32_pshufb128(reinterpret_cast<Chars16>(load16(bytes) ^ first), to_end));
  auto next = reinterpret_cast<Words2>(
      __builtin_ia32_pshufb128(reinterpret_cast<Chars16>(first), to_begin));
  const std::uint8_t* const end = bytes + size;
  for (bytes += rest; bytes != end; bytes += 16) {
    folded = __builtin_ia32_pclmulqdq128(folded, by, 0x00) ^
             __builtin_ia32_pclmulqdq128(folded, by, 0x11) ^ next ^
             reinterpret_cast<Words2>(load16(bytes));
    next = Words2{};
  }
  std::array<std::uint8_t, 16> result{};
  __builtin_memcpy(result.data(), &folded, sizeof folded);
  return result;
}

}  // namespace sbgc::detail

#endif
