/// The kinds of values that messages consist of. All code that treats kinds differently uses this
/// list; walk.hpp iterates over the values of a message.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sbgc/types.hpp>
#include <sbgc/wire.hpp>

namespace sbgc {

struct Counter;
struct Number;

/// A type that wraps one number of the wire: a quantity, flag set or packed value.
template <class T>
concept RawValue = requires(const T value) {
  typename T::raw_type;
  { value.raw() } -> std::same_as<typename T::raw_type>;
  T(value.raw());
};

namespace detail {

/// A value that is one number on the wire.
template <class T>
concept Scalar = wire::Number<T> || std::is_same_v<T, char> || std::is_enum_v<T> || RawValue<T>;

enum class Kind : std::uint8_t {
  scalar,    ///< a number, enum, quantity, flag set or packed value
  axes,      ///< Axes, Xyz: three elements with names
  array,     ///< std::array
  bytes,     ///< Bytes, BoundedBytes
  text,      ///< Text, BoundedText
  list,      ///< BoundedArray
  optional,  ///< Optional
  counter,   ///< the element count of a list, which no message stores
  number,    ///< a number whose type another message announces
  group,     ///< a generated struct, message or tagged union
};

template <class T>
inline constexpr Kind kind_of = Scalar<T> ? Kind::scalar : Kind::group;
template <class T>
inline constexpr Kind kind_of<Axes<T>> = Kind::axes;
template <class T>
inline constexpr Kind kind_of<Xyz<T>> = Kind::axes;
template <class T, std::size_t n>
inline constexpr Kind kind_of<std::array<T, n>> = Kind::array;
template <std::size_t n>
inline constexpr Kind kind_of<Bytes<n>> = Kind::bytes;
template <std::size_t n>
inline constexpr Kind kind_of<BoundedBytes<n>> = Kind::bytes;
template <std::size_t n>
inline constexpr Kind kind_of<Text<n>> = Kind::text;
template <std::size_t n>
inline constexpr Kind kind_of<BoundedText<n>> = Kind::text;
template <class T, std::size_t n>
inline constexpr Kind kind_of<BoundedArray<T, n>> = Kind::list;
template <class T>
inline constexpr Kind kind_of<Optional<T>> = Kind::optional;
template <>
inline constexpr Kind kind_of<Counter> = Kind::counter;
template <>
inline constexpr Kind kind_of<Number> = Kind::number;

/// True for the integers that are wider in memory than on the wire, and for quantities over them.
template <class T>
inline constexpr bool is_integer24 = false;
template <class Raw>
inline constexpr bool is_integer24<Integer24<Raw>> = true;
template <class T>
  requires requires { typename T::number_type; }
inline constexpr bool is_integer24<T> = is_integer24<typename T::number_type>;

/// True if the number of bytes or elements varies.
template <class T>
inline constexpr bool is_bounded = requires(T& value) {
  value.clear();
};

/// Returns the number that the wire carries.
template <Scalar T>
constexpr auto raw_of(T value) noexcept {
  if constexpr (RawValue<T>) {
    return value.raw();
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<std::underlying_type_t<T>>(value);
  } else if constexpr (std::is_same_v<T, char>) {
    return static_cast<std::uint8_t>(value);
  } else {
    return value;
  }
}
template <Scalar T>
using RawOf = decltype(raw_of(std::declval<T>()));

/// The type of the elements of axes or of an array.
template <class T>
using ElementOf = std::remove_cvref_t<decltype(std::declval<T&>()[0])>;

}  // namespace detail
}  // namespace sbgc
