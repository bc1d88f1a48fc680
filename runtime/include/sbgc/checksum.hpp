/// The checksum of the protocol: the sum of all bytes modulo 256.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace sbgc {

namespace detail {

constexpr std::uint8_t byte_sum_plain(const std::uint8_t* bytes, std::size_t size) noexcept {
  unsigned sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += bytes[i];
  return static_cast<std::uint8_t>(sum);
}

#if defined(__SSE2__)

// The vector types and built-ins of GCC and Clang, because <emmintrin.h> includes hosted headers.
using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
using Words2 = long long __attribute__((vector_size(16)));
using Chars16 = char __attribute__((vector_size(16)));

/// Sums of the lower and the upper eight of 16 bytes.
inline Words2 sum_halves(Bytes16 bytes) noexcept {
  return reinterpret_cast<Words2>(
      __builtin_ia32_psadbw128(reinterpret_cast<Chars16>(bytes), Chars16{}));
}

/// The uppermost bit of each of 16 bytes.
inline unsigned sign_bits(Bytes16 bytes) noexcept {
  return static_cast<unsigned>(__builtin_ia32_pmovmskb128(reinterpret_cast<Chars16>(bytes)));
}

inline Bytes16 load16(const std::uint8_t* bytes) noexcept {
  Bytes16 value;
  __builtin_memcpy(&value, bytes, sizeof value);
  return value;
}

/// 16 zeros and 16 ones: read from offset n, it keeps the last n of 16 bytes.
inline constexpr std::uint8_t keep_last[32] = {
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};

/// For at least 16 bytes: whole blocks, then the last 16 bytes without those already summed.
inline std::uint8_t byte_sum_sse2(const std::uint8_t* bytes, std::size_t size) noexcept {
  const std::uint8_t* const end = bytes + size;
  const std::size_t rest = size % 16;
  Words2 sum = sum_halves(load16(end - 16) & load16(keep_last + rest));
  for (; bytes != end - rest; bytes += 16) sum += sum_halves(load16(bytes));
  return static_cast<std::uint8_t>(sum[0] + sum[1]);
}

#endif

}  // namespace detail

/// The sum modulo 256 of `size` bytes.
constexpr std::uint8_t byte_sum(const std::uint8_t* bytes, std::size_t size) noexcept {
#if defined(__SSE2__)
  if (!std::is_constant_evaluated() && size >= 16) return detail::byte_sum_sse2(bytes, size);
#endif
  return detail::byte_sum_plain(bytes, size);
}

}  // namespace sbgc
