/// Checksums that combine the bytes by addition or exclusive or.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/internal/compiler.hpp>

namespace sbgc {

namespace detail {

constexpr std::uint8_t byte_sum_plain(const std::uint8_t* bytes, std::size_t size) noexcept {
  unsigned sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += bytes[i];
  return static_cast<std::uint8_t>(sum);
}

#if SBGC_HAS_SSE2

/// A table of masks: the 16 bytes at offset n keep the last n of 16 bytes.
inline constexpr std::uint8_t keep_last[32] = {
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};

/// Sums whole blocks of 16 bytes, and the last 16 bytes without those in a block. Precondition:
/// size >= 16.
inline std::uint8_t byte_sum_sse2(const std::uint8_t* bytes, std::size_t size) noexcept {
  const std::uint8_t* const end = bytes + size;
  const std::size_t rest = size % 16;
  Words2 sum = sum_halves(load16(end - 16) & load16(keep_last + rest));
  for (; bytes != end - rest; bytes += 16) sum += sum_halves(load16(bytes));
  return static_cast<std::uint8_t>(sum[0] + sum[1]);
}

#endif

}  // namespace detail

/// Returns the sum of `size` bytes modulo 256.
constexpr std::uint8_t byte_sum(const std::uint8_t* bytes, std::size_t size) noexcept {
#if SBGC_HAS_SSE2
  if (!detail::is_constant_evaluated() && size >= 16) return detail::byte_sum_sse2(bytes, size);
#endif
  return detail::byte_sum_plain(bytes, size);
}

namespace detail {

/// Accumulates a sum modulo 256 over several ranges. Inlined to keep it in registers.
class ByteSum {
 public:
  /// Adds `size` bytes. Fast only if the compiler knows `size`.
  SBGC_ALWAYS_INLINE void add(const std::uint8_t* bytes, std::size_t size) noexcept {
#if SBGC_HAS_SSE2
    if (size >= 16) {
      const std::size_t rest = size % 16;
      for (std::size_t at = 0; at != size - rest; at += 16) add16(load16(bytes + at));
      if (rest != 0) add16(load16(bytes + size - 16) & load16(keep_last + rest));
    } else if (size >= 8) {
      std::uint64_t halves[2];
      copy_memory(&halves[0], bytes, 8);
      copy_memory(&halves[1], bytes + size - 8, 8);
      halves[1] = size == 8 ? 0 : halves[1] >> (8 * (16 - size));
      Bytes16 all;
      copy_memory(&all, halves, sizeof all);
      add16(all);
    } else {
      add(byte_sum_plain(bytes, size));
    }
#else
    add(byte_sum(bytes, size));
#endif
  }

  /// Adds the sum of other bytes.
  void add(std::uint8_t sum) noexcept { sum_ += sum; }

  std::uint8_t value() const noexcept {
#if SBGC_HAS_SSE2
    return static_cast<std::uint8_t>(sum_ + static_cast<std::uint64_t>(halves_[0] + halves_[1]));
#else
    return static_cast<std::uint8_t>(sum_);
#endif
  }

 private:
  unsigned sum_{};
#if SBGC_HAS_SSE2
  SBGC_ALWAYS_INLINE void add16(Bytes16 bytes) noexcept { halves_ += sum_halves(bytes); }

  Words2 halves_{};
#endif
};

}  // namespace detail

/// Accumulates the sum of all bytes, modulo 256 or 65536, over several ranges.
template <class Integer>
class Sum {
 public:
  /// The type of the sum.
  using Word = Integer;

  /// Adds bytes.
  SBGC_ALWAYS_INLINE constexpr Sum& add(const std::uint8_t* bytes, std::size_t size) noexcept {
    if constexpr (sizeof(Word) == 1) {
      value_ = static_cast<Word>(value_ + byte_sum(bytes, size));
    } else {
      for (std::size_t i = 0; i < size; ++i) value_ = static_cast<Word>(value_ + bytes[i]);
    }
    return *this;
  }
  /// Returns the sum of all bytes so far.
  constexpr Word value() const noexcept { return value_; }

 private:
  Word value_{};
};

/// Accumulates the exclusive or of all bytes over several ranges.
class ExclusiveOr {
 public:
  /// The type of the sum.
  using Word = std::uint8_t;

  /// Adds bytes.
  SBGC_ALWAYS_INLINE constexpr ExclusiveOr& add(const std::uint8_t* bytes,
                                                std::size_t size) noexcept {
    for (std::size_t i = 0; i < size; ++i) value_ = static_cast<Word>(value_ ^ bytes[i]);
    return *this;
  }
  /// Returns the sum of all bytes so far.
  constexpr Word value() const noexcept { return value_; }

 private:
  Word value_{};
};

}  // namespace sbgc
