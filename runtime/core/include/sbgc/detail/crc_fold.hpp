/// Cyclic redundancy checks by carry-less multiplication, which x86 processors have had as an
/// instruction since about 2010: blocks of 16 bytes are folded into one with the same remainder,
/// and Barrett reduction computes that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/checksum.hpp>
#include <sbgc/internal/compiler.hpp>

#if SBGC_HAS_CARRYLESS_MULTIPLICATION

namespace sbgc::detail {

/// Returns x^exponent modulo the polynomial. Here and below the coefficient of the highest power is
/// in the lowest bit, as in the register of a check whose bytes enter least significant bit first.
constexpr std::uint16_t power_of_x(unsigned exponent, std::uint16_t polynomial) noexcept {
  unsigned power = 0x8000;  // x^0
  for (; exponent != 0; --exponent) power = power >> 1 ^ ((power & 1) != 0 ? polynomial : 0U);
  return static_cast<std::uint16_t>(power);
}

/// Returns the quotient of x^80 by the polynomial, without its highest power x^64.
constexpr std::uint64_t quotient_of_x80(std::uint16_t polynomial) noexcept {
  std::uint64_t quotient = 0;
  unsigned rest = polynomial;
  for (unsigned bit = 0; bit < 64; ++bit) {
    const std::uint64_t digit = rest & 1;
    rest = rest >> 1 ^ (digit != 0 ? polynomial : 0U);
    quotient |= digit << bit;
  }
  return quotient;
}

/// The factor that moves 64 bits over `distance` bits. A product has 127 bits, the highest power in
/// bit 0, so that it is x times too large as a block.
template <std::uint16_t polynomial, unsigned distance>
inline constexpr auto factor_over =
    // NOLINTNEXTLINE(bugprone-misplaced-widening-cast): both types have 64 bits
    static_cast<long long>(std::uint64_t{power_of_x(distance - 1, polynomial)} << 48);

/// A table of shuffles: the 16 bytes at offset n move the first n bytes to the last n places; those
/// at offset 16 + n move the last 16 - n bytes to the first places. Other bytes become 0.
inline constexpr std::uint8_t shift_bytes[48] = {
    128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128,
    0,   1,   2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,
    128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128};

/// Returns a block with the same remainder as `block` moved up by `distance` bits.
template <std::uint16_t polynomial, unsigned distance>
SBGC_CARRYLESS_MULTIPLICATION SBGC_ALWAYS_INLINE inline Words2 folded(Words2 block) noexcept {
  constexpr Words2 by = {factor_over<polynomial, distance + 64>, factor_over<polynomial, distance>};
  return carryless_product<0, 0>(block, by) ^ carryless_product<1, 1>(block, by);
}

/// Returns the register that a block leaves if it enters a register of 0: the remainder of the
/// block times x^16.
template <std::uint16_t polynomial>
SBGC_CARRYLESS_MULTIPLICATION SBGC_ALWAYS_INLINE inline std::uint16_t remainder(
    Words2 block) noexcept {
  // The upper half over the lower one, then the 16 bits by which their sum is longer.
  constexpr Words2 over_half = {factor_over<polynomial, 64>, 0};
  const Words2 sum = carryless_product<0, 0>(block, over_half);
  const Words2 excess = carryless_product<0, 0>(sum, over_half);
  const Words2 value = {block[1] ^ sum[1] ^ excess[1], 0};
  // value * x^16 = quotient * polynomial + remainder.
  constexpr Words2 division = {static_cast<long long>(quotient_of_x80(polynomial)),
                               static_cast<long long>(std::uint64_t{polynomial} << 48)};
  const Words2 high = carryless_product<0, 0>(value, division);
  const Words2 quotient = {value[0] ^ high[0] << 1, 0};
  const Words2 low = carryless_product<0, 1>(quotient, division);
  return static_cast<std::uint16_t>(static_cast<std::uint64_t>(low[1]) >> 47);
}

/// Returns the register `start` after `size` bytes have entered it. Precondition: size >= 16.
template <std::uint16_t polynomial>
SBGC_CARRYLESS_MULTIPLICATION inline std::uint16_t crc_by_folding(std::uint16_t start,
                                                                  const std::uint8_t* bytes,
                                                                  std::size_t size) noexcept {
  const auto load = [](const std::uint8_t* from) { return reinterpret_cast<Words2>(load16(from)); };
  const auto first = reinterpret_cast<Bytes16>(Words2{start, 0});
  const std::size_t rest = size % 16;
  // Leading zeros do not change a register of 0: the first block is filled up with them. The
  // register enters together with the first two bytes, the second of which may be in the next
  // block.
  Words2 even = shuffled(load16(bytes) ^ first, load16(shift_bytes + rest));
  Words2 odd = shuffled(first, load16(shift_bytes + 16 + rest));
  odd ^= load(bytes + rest);
  const std::uint8_t* const end = bytes + size;
  bytes += rest + 16;
  // Two blocks at a time: the multiplications are independent.
  for (; end - bytes >= 32; bytes += 32) {
    even = folded<polynomial, 256>(even) ^ load(bytes);
    odd = folded<polynomial, 256>(odd) ^ load(bytes + 16);
  }
  Words2 block = folded<polynomial, 128>(even) ^ odd;
  if (bytes != end) block = folded<polynomial, 128>(block) ^ load(bytes);
  return remainder<polynomial>(block);
}

}  // namespace sbgc::detail

#endif
