/// The size of values on the wire.
#pragma once

#include <cstddef>

#include <sbgc/detail/kind.hpp>
#include <sbgc/type_list.hpp>

namespace sbgc {

/// The fixed-offset members of a generated struct or message: those whose wire offset is a
/// constant, in wire order. Generated types declare them as FixedMembers.
template <auto... member>
struct Members {};

namespace detail {

template <class T>
concept HasFixedMembers = requires {
  typename T::FixedMembers;
};

/// A generated struct or message with members whose wire offset varies.
/// varying_members(self, cursor) reads or writes them; a message may also need its Context.
template <class T>
concept HasVaryingMembers = requires {
  &T::template varying_members<T, int>;
};

/// A tagged union of `wire_size` bytes. The message that contains it determines its layout and
/// reads or writes it in tagged_unions(self, cursor).
template <class T>
concept TaggedUnion = requires {
  T::wire_size;
};

/// A struct whose size on the wire grew with some firmware; all elements of a list have one of its
/// `element_sizes`.
template <class T>
concept GrownElement = requires {
  T::element_sizes;
};

/// Returns true if elements of the struct have this size in some firmware.
template <GrownElement T>
constexpr bool is_element_size(std::size_t size) noexcept {
  // NOLINTNEXTLINE(readability-use-anyofallof): no <algorithm> here
  for (const std::size_t known : T::element_sizes) {
    if (known == size) return true;
  }
  return false;
}

template <class Struct, class T>
T type_of_member(T Struct::*);

template <auto... member>
consteval TypeList<decltype(type_of_member(member))...> types_of(Members<member...>) noexcept {
  return {};
}

/// The types of the fixed-offset members.
template <class T>
inline constexpr TypeList<> fixed_types{};
template <HasFixedMembers T>
inline constexpr auto fixed_types<T> = types_of(typename T::FixedMembers{});

template <class T>
consteval std::size_t size_of_value() noexcept;

}  // namespace detail

/// The size of a type on the wire; 0 if it varies.
template <class T>
inline constexpr std::size_t wire_size = detail::size_of_value<T>();

/// The unit of the counter of a list: bytes, or elements minus one.
enum class Counting : unsigned char { bytes, minus_1 };

namespace detail {

/// Returns the value of the counter of a list. The list must not be empty if it counts elements
/// minus one.
template <Counting counting, class List>
constexpr std::size_t counter_of(const List& list) noexcept {
  if constexpr (counting == Counting::bytes) {
    return list.size() * wire_size<typename List::value_type>;
  } else {
    return list.size() - (list.empty() ? 0 : 1);
  }
}

/// Returns the number of bits that are set. (std::popcount calls a library function on some cores.)
template <class Bits>
constexpr std::size_t count_bits(Bits bits) noexcept {
  std::size_t count = 0;
  for (; bits != 0; bits = static_cast<Bits>(bits & (bits - 1))) ++count;
  return count;
}

template <class... T>
consteval std::size_t size_of_all(TypeList<T...>) noexcept {
  return (std::size_t{0} + ... + wire_size<T>);
}

/// The total size of the fixed-offset members.
template <class T>
inline constexpr std::size_t fixed_size = size_of_all(fixed_types<T>);

template <class T>
consteval std::size_t size_of_value() noexcept {
  constexpr Kind kind = kind_of<T>;
  if constexpr (kind == Kind::scalar) {
    return is_integer24<T> ? 3 : sizeof(RawOf<T>);
  } else if constexpr (kind == Kind::axes || kind == Kind::array) {
    return sizeof(T) / sizeof(ElementOf<T>) * wire_size<ElementOf<T>>;
  } else if constexpr (kind == Kind::bytes || kind == Kind::text) {
    return is_bounded<T> ? 0 : sizeof(T);
  } else if constexpr (TaggedUnion<T>) {
    return T::wire_size;
  } else if constexpr (HasVaryingMembers<T>) {
    return 0;
  } else {
    return fixed_size<T>;
  }
}

}  // namespace detail
}  // namespace sbgc
