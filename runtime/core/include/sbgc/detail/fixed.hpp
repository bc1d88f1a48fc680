/// Reads and writes values of fixed size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sbgc/detail/compiler.hpp>
#include <sbgc/detail/layout.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

constexpr void copy(const std::uint8_t* from, std::uint8_t* to, std::size_t size) noexcept {
  if (detail::is_constant_evaluated()) {
    for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
  } else if (size != 0) {
    copy_memory(to, from, size);
  }
}

/// get() reads a value from the wire_size bytes at `from`; put() writes one to those at `to`.
/// Precondition: the buffer has that many bytes. A class, so that each overload sees all others.
struct Fixed {
  template <wire::Number T>
  static constexpr void get(const std::uint8_t* from, T& value) noexcept {
    value = wire::load<T>(from);
  }
  template <wire::Number T>
  static constexpr void put(std::uint8_t* to, T value) noexcept {
    wire::store(to, value);
  }

  static constexpr void get(const std::uint8_t* from, char& value) noexcept {
    value = static_cast<char>(*from);
  }
  static constexpr void put(std::uint8_t* to, char value) noexcept {
    *to = static_cast<std::uint8_t>(value);
  }

  template <class T>
    requires std::is_enum_v<T>
  static constexpr void get(const std::uint8_t* from, T& value) noexcept {
    value = static_cast<T>(wire::load<std::underlying_type_t<T>>(from));
  }
  template <class T>
    requires std::is_enum_v<T>
  static constexpr void put(std::uint8_t* to, T value) noexcept {
    wire::store(to, static_cast<std::underlying_type_t<T>>(value));
  }

  template <RawValue T>
  static constexpr void get(const std::uint8_t* from, T& value) noexcept {
    value = T(wire::load<typename T::raw_type>(from));
  }
  template <RawValue T>
  static constexpr void put(std::uint8_t* to, T value) noexcept {
    wire::store(to, value.raw());
  }

  template <class Raw>
  static constexpr void get(const std::uint8_t* from, Integer24<Raw>& value) noexcept {
    const std::uint32_t bits = wire::load<std::uint16_t>(from) | static_cast<std::uint32_t>(from[2])
                                                                     << 16;
    // Shifted to the top and back, which extends the sign.
    value = Integer24<Raw>(static_cast<Raw>(bits << 8) >> 8);
  }
  template <class Raw>
  static constexpr void put(std::uint8_t* to, Integer24<Raw> value) noexcept {
    const auto bits = static_cast<std::uint32_t>(value.raw());
    wire::store(to, static_cast<std::uint16_t>(bits));
    to[2] = static_cast<std::uint8_t>(bits >> 16);
  }

  template <class T>
  static constexpr void get(const std::uint8_t* from, Axes<T>& value) noexcept {
    get(from, value.roll);
    get(from + wire_size<T>, value.pitch);
    get(from + 2 * wire_size<T>, value.yaw);
  }
  template <class T>
  static constexpr void put(std::uint8_t* to, const Axes<T>& value) noexcept {
    put(to, value.roll);
    put(to + wire_size<T>, value.pitch);
    put(to + 2 * wire_size<T>, value.yaw);
  }

  template <class T>
  static constexpr void get(const std::uint8_t* from, Xyz<T>& value) noexcept {
    get(from, value.x);
    get(from + wire_size<T>, value.y);
    get(from + 2 * wire_size<T>, value.z);
  }
  template <class T>
  static constexpr void put(std::uint8_t* to, const Xyz<T>& value) noexcept {
    put(to, value.x);
    put(to + wire_size<T>, value.y);
    put(to + 2 * wire_size<T>, value.z);
  }

  template <class T, std::size_t n>
  static constexpr void get(const std::uint8_t* from, std::array<T, n>& value) noexcept {
    for (std::size_t i = 0; i < n; ++i) get(from + i * wire_size<T>, value[i]);
  }
  template <class T, std::size_t n>
  static constexpr void put(std::uint8_t* to, const std::array<T, n>& value) noexcept {
    for (std::size_t i = 0; i < n; ++i) put(to + i * wire_size<T>, value[i]);
  }

  template <std::size_t n>
  static constexpr void get(const std::uint8_t* from, Bytes<n>& value) noexcept {
    copy(from, value.data(), n);
  }
  template <std::size_t n>
  static constexpr void put(std::uint8_t* to, const Bytes<n>& value) noexcept {
    copy(value.data(), to, n);
  }

  template <std::size_t n>
  static constexpr void get(const std::uint8_t* from, Text<n>& value) noexcept {
    get(from, value.bytes);
  }
  template <std::size_t n>
  static constexpr void put(std::uint8_t* to, const Text<n>& value) noexcept {
    put(to, value.bytes);
  }

  // The fixed-offset members of a generated struct or message.

  template <HasFixedMembers T>
  static constexpr void get(const std::uint8_t* from, T& out) noexcept {
    get_members(from, out, typename T::FixedMembers{}, indices<T>);
  }
  template <HasFixedMembers T>
  static constexpr void put(std::uint8_t* to, const T& in) noexcept {
    put_members(to, in, typename T::FixedMembers{}, indices<T>);
  }

 private:
  template <class M>
  static constexpr std::make_index_sequence<layout<M>.places.size()> indices{};

  template <class M, auto... member, std::size_t... i>
  static constexpr void get_members(const std::uint8_t* SBGC_RESTRICT from, M& SBGC_RESTRICT out,
                                    Members<member...>, std::index_sequence<i...>) noexcept {
    (get_member<layout<M>.in_blocks, layout<M>.places[i]>(from, out, out.*member), ...);
  }
  template <class M, auto... member, std::size_t... i>
  static constexpr void put_members(std::uint8_t* SBGC_RESTRICT to, const M& SBGC_RESTRICT in,
                                    Members<member...>, std::index_sequence<i...>) noexcept {
    (put_member<layout<M>.in_blocks, layout<M>.places[i]>(to, in, in.*member), ...);
  }

  // If members are copied in blocks, the first member of each block copies the whole block.

  template <bool in_blocks, Place place, class M, class T>
  static constexpr void get_member(const std::uint8_t* from, M& out, T& member) noexcept {
    if (in_blocks && place.same && !detail::is_constant_evaluated()) {
      if constexpr (place.block != 0) {
        static_assert(std::is_standard_layout_v<M> && std::is_trivially_copyable_v<M>);
        auto* const bytes = reinterpret_cast<unsigned char*>(&out);
        copy_memory(bytes + place.memory, from + place.wire, place.block);
      }
    } else if constexpr (!TaggedUnion<T>) {
      get(from + place.wire, member);
    }
  }
  template <bool in_blocks, Place place, class M, class T>
  static constexpr void put_member(std::uint8_t* to, const M& in, const T& member) noexcept {
    if (in_blocks && place.same && !detail::is_constant_evaluated()) {
      if constexpr (place.block != 0) {
        static_assert(std::is_standard_layout_v<M> && std::is_trivially_copyable_v<M>);
        const auto* const bytes = reinterpret_cast<const unsigned char*>(&in);
        copy_memory(to + place.wire, bytes + place.memory, place.block);
      }
    } else if constexpr (!TaggedUnion<T>) {
      put(to + place.wire, member);
    }
  }
};

}  // namespace sbgc::detail
