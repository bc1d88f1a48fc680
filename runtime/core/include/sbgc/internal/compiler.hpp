/// Everything specific to compilers and processors; the other headers are standard C++20. The
/// supported compilers are g++ and clang++, on any processor and system; MSVC is not.
#pragma once

#if __cplusplus < 202002L
#error "sbgc needs C++20: compile with -std=c++20, in CMake with CMAKE_CXX_STANDARD 20"
// The missing file ends the compilation: further errors would only confuse.
#include <the_compiler_stops_here>
#endif

#include <cstddef>
#include <cstdint>
#include <type_traits>

#if !defined(__GNUC__)
#error "sbgc needs g++ 11, clang++ 14 or a later version of them"
#endif

/// For functions that are slow or large if the compiler decides about inlining.
#define SBGC_ALWAYS_INLINE [[gnu::always_inline]]
#define SBGC_NOINLINE [[gnu::noinline]]
/// For objects that only their constructors use.
#define SBGC_USED [[gnu::used]]
/// For pointers and references to memory that nothing else changes.
#define SBGC_RESTRICT __restrict

namespace sbgc::detail {

// The C library does the same, but freestanding compilers have no <cstring>.

SBGC_ALWAYS_INLINE inline void copy_memory(void* to, const void* from, std::size_t size) noexcept {
  __builtin_memcpy(to, from, size);
}

/// The two may overlap.
SBGC_ALWAYS_INLINE inline void move_memory(void* to, const void* from, std::size_t size) noexcept {
  __builtin_memmove(to, from, size);
}

SBGC_ALWAYS_INLINE inline bool is_same_memory(const void* a, const void* b,
                                              std::size_t size) noexcept {
  return __builtin_memcmp(a, b, size) == 0;
}

/// True in a constant expression, which must not copy memory or use vectors. SBGC_AS_CONSTANT makes
/// a program run the code of constant expressions, so that a fuzzer can test it.
SBGC_ALWAYS_INLINE constexpr bool is_constant_evaluated() noexcept {
#if defined(SBGC_AS_CONSTANT)
  return true;
#else
  return std::is_constant_evaluated();
#endif
}

/// Ends the program. A constant expression that reaches it does not compile.
[[noreturn]] SBGC_ALWAYS_INLINE inline void trap() noexcept { __builtin_trap(); }

// Each stores the result, and returns true if it does not fit.

template <class T>
SBGC_ALWAYS_INLINE constexpr bool add_overflows(T a, T b, T& sum) noexcept {
  return __builtin_add_overflow(a, b, &sum);
}

template <class T>
SBGC_ALWAYS_INLINE constexpr bool subtract_overflows(T a, T b, T& difference) noexcept {
  return __builtin_sub_overflow(a, b, &difference);
}

template <class T>
SBGC_ALWAYS_INLINE constexpr bool multiply_overflows(T a, T b, T& product) noexcept {
  return __builtin_mul_overflow(a, b, &product);
}

}  // namespace sbgc::detail

namespace sbgc::detail {

/// True on 32-bit processors, most of which are microcontrollers: there, small code matters more
/// than the stalls of a large processor that reads bytes just written.
inline constexpr bool prefers_small_code = sizeof(void*) < 8;

}  // namespace sbgc::detail

/// 1 if the compiler may use the vectors of x86 processors.
#if defined(__SSE2__)
#define SBGC_HAS_SSE2 1
#else
#define SBGC_HAS_SSE2 0
#endif

/// 1 if the compiler supports the carry-less multiplication of x86 processors;
/// has_carryless_multiplication() tells whether the processor does. Freestanding programs have no
/// library to detect it; they use it if the compiler may.
#if SBGC_HAS_SSE2 && defined(__x86_64__) && \
    ((defined(__PCLMUL__) && defined(__SSSE3__)) || __STDC_HOSTED__)
#define SBGC_HAS_CARRYLESS_MULTIPLICATION 1
#else
#define SBGC_HAS_CARRYLESS_MULTIPLICATION 0
#endif

#if SBGC_HAS_SSE2

namespace sbgc::detail {

// Not those of <emmintrin.h>, which includes hosted headers.
using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
using Words2 = long long __attribute__((vector_size(16)));
using Chars16 = char __attribute__((vector_size(16)));

/// Returns the sums of the lower and the upper eight bytes.
inline Words2 sum_halves(Bytes16 bytes) noexcept {
  return reinterpret_cast<Words2>(
      __builtin_ia32_psadbw128(reinterpret_cast<Chars16>(bytes), Chars16{}));
}

/// Returns the highest bit of each byte.
inline unsigned sign_bits(Bytes16 bytes) noexcept {
  return static_cast<unsigned>(__builtin_ia32_pmovmskb128(reinterpret_cast<Chars16>(bytes)));
}

inline Bytes16 load16(const std::uint8_t* bytes) noexcept {
  Bytes16 value;
  copy_memory(&value, bytes, sizeof value);
  return value;
}

}  // namespace sbgc::detail

#endif

#if SBGC_HAS_CARRYLESS_MULTIPLICATION

/// For functions that use it.
#define SBGC_CARRYLESS_MULTIPLICATION [[gnu::target("pclmul,ssse3")]]

namespace sbgc::detail {

inline bool has_carryless_multiplication() noexcept {
#if defined(__PCLMUL__) && defined(__SSSE3__)
  return true;
#else
  return static_cast<bool>(__builtin_cpu_supports("pclmul")) &&
         static_cast<bool>(__builtin_cpu_supports("ssse3"));
#endif
}

/// Returns the product of one half of each: a[half_of_a] * b[half_of_b].
template <int half_of_a, int half_of_b>
SBGC_CARRYLESS_MULTIPLICATION SBGC_ALWAYS_INLINE inline Words2 carryless_product(
    Words2 a, Words2 b) noexcept {
  return __builtin_ia32_pclmulqdq128(a, b, half_of_a + 16 * half_of_b);
}

/// Returns the bytes at the given places, and 0 for places over 127.
SBGC_CARRYLESS_MULTIPLICATION SBGC_ALWAYS_INLINE inline Words2 shuffled(Bytes16 bytes,
                                                                        Bytes16 places) noexcept {
  return reinterpret_cast<Words2>(__builtin_ia32_pshufb128(reinterpret_cast<Chars16>(bytes),
                                                           reinterpret_cast<Chars16>(places)));
}

}  // namespace sbgc::detail

#endif
