/// The sum of the bytes of a value on the wire, computed from the value.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// Returns the sum of the lowest `size` bytes. Only the lowest byte of the result counts.
template <std::size_t size, wire::Number T>
SBGC_ALWAYS_INLINE constexpr unsigned sum_of_number(T number) noexcept {
  const auto bits = std::bit_cast<wire::detail::Bits<T>>(number);
  unsigned sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += static_cast<unsigned>(bits >> (8 * i));
  return sum;
}

template <class T>
constexpr unsigned sum_of_value(const T& value) noexcept;

template <class T, auto... member>
SBGC_ALWAYS_INLINE constexpr unsigned sum_of_members(const T& value, Members<member...>) noexcept {
  return (0U + ... + sum_of_value(value.*member));
}

/// The same for any value of fixed size.
template <class T>
SBGC_ALWAYS_INLINE constexpr unsigned sum_of_value(const T& value) noexcept {
  constexpr Kind kind = kind_of<T>;
  if constexpr (kind == Kind::scalar) {
    return sum_of_number<wire_size<T>>(raw_of(value));
  } else if constexpr (kind == Kind::axes) {
    return sum_of_value(value[0]) + sum_of_value(value[1]) + sum_of_value(value[2]);
  } else if constexpr (kind == Kind::array || kind == Kind::bytes) {
    unsigned sum = 0;
    for (const auto& element : value) sum += sum_of_value(element);
    return sum;
  } else if constexpr (kind == Kind::text) {
    return sum_of_value(value.bytes);
  } else if constexpr (HasFixedMembers<T>) {
    return sum_of_members(value, typename T::FixedMembers{});
  } else {
    return 0;  // a message without members
  }
}

}  // namespace sbgc::detail
