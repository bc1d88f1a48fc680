/// Little-endian numbers in byte buffers, on any host and at compile time.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>

namespace sbgc::wire {

/// A number type on the wire.
template <class T>
concept Number = std::same_as<T, std::uint8_t> || std::same_as<T, std::int8_t> ||
    std::same_as<T, std::uint16_t> || std::same_as<T, std::int16_t> ||
    std::same_as<T, std::uint32_t> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint64_t> || std::same_as<T, std::int64_t> || std::same_as<T, float> ||
    std::same_as<T, double>;

static_assert(sizeof(float) == 4 && sizeof(double) == 8, "the wire carries IEEE 754 numbers");

namespace detail {

/// The unsigned integer with the size of T.
template <Number T>
using Bits = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// The unsigned integer for shifts of a T: at least 32 bits.
template <Number T>
using Shifted = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

/// True if numbers have the same bytes in memory and on the wire.
template <std::endian host>
inline constexpr bool same_order = host == std::endian::little;

}  // namespace detail

/// Reads a T from the sizeof(T) bytes at `bytes`, which may be unaligned.
/// `host` is a parameter so that tests can run the code for big-endian hosts on any machine.
template <Number T, std::endian host = std::endian::native>
constexpr T load(const std::uint8_t* bytes) noexcept {
  if (detail::same_order<host> && !sbgc::detail::is_constant_evaluated()) {
    T value;
    sbgc::detail::copy_memory(&value, bytes, sizeof value);
    return value;
  }
  detail::Shifted<T> bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits |= static_cast<detail::Shifted<T>>(bytes[i]) << (8 * i);
  }
  return std::bit_cast<T>(static_cast<detail::Bits<T>>(bits));
}

/// Writes `value` to the sizeof(T) bytes at `bytes`, which may be unaligned.
template <Number T, std::endian host = std::endian::native>
constexpr void store(std::uint8_t* bytes, T value) noexcept {
  if (detail::same_order<host> && !sbgc::detail::is_constant_evaluated()) {
    sbgc::detail::copy_memory(bytes, &value, sizeof value);
    return;
  }
  // NOLINTNEXTLINE(modernize-use-auto): widened, so that the shifts below are defined
  const detail::Shifted<T> bits = std::bit_cast<detail::Bits<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes[i] = static_cast<std::uint8_t>(bits >> (8 * i));
  }
}

}  // namespace sbgc::wire
