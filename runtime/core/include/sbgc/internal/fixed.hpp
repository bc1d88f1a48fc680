/// Reads and writes values of fixed size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sbgc/detail/layout.hpp>
#include <sbgc/internal/compiler.hpp>
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

/// Reads the number of a scalar.
template <Scalar T>
constexpr RawOf<T> load_raw(const std::uint8_t* from) noexcept {
  using Raw = RawOf<T>;
  if constexpr (is_integer24<T>) {
    const std::uint32_t bits = wire::load<std::uint16_t>(from) | static_cast<std::uint32_t>(from[2])
                                                                     << 16;
    // Shifted to the top and back, which extends the sign.
    return static_cast<Raw>(bits << 8) >> 8;
  } else {
    return wire::load<Raw>(from);
  }
}

template <Scalar T>
constexpr void store_raw(std::uint8_t* to, RawOf<T> raw) noexcept {
  if constexpr (is_integer24<T>) {
    const auto bits = static_cast<std::uint32_t>(raw);
    wire::store(to, static_cast<std::uint16_t>(bits));
    to[2] = static_cast<std::uint8_t>(bits >> 16);
  } else {
    wire::store(to, raw);
  }
}

/// get() reads a value from the wire_size bytes at `from`; put() writes one to those at `to`.
/// Precondition: the buffer has that many bytes.
struct Fixed {
  template <class T>
  static constexpr void get(const std::uint8_t* from, T& value) noexcept {
    constexpr Kind kind = kind_of<T>;
    if constexpr (kind == Kind::scalar) {
      value = static_cast<T>(load_raw<T>(from));
    } else if constexpr (kind == Kind::axes) {
      constexpr std::size_t step = wire_size<ElementOf<T>>;
      get(from, value[0]);
      get(from + step, value[1]);
      get(from + 2 * step, value[2]);
    } else if constexpr (kind == Kind::array) {
      constexpr std::size_t step = wire_size<ElementOf<T>>;
      for (std::size_t i = 0; i < value.size(); ++i) get(from + i * step, value[i]);
    } else if constexpr (kind == Kind::bytes) {
      copy(from, value.data(), value.size());
    } else if constexpr (kind == Kind::text) {
      get(from, value.bytes);
    } else if constexpr (HasFixedMembers<T>) {
      get_members(from, value, typename T::FixedMembers{}, indices<T>);
    }
  }

  template <class T>
  static constexpr void put(std::uint8_t* to, const T& value) noexcept {
    constexpr Kind kind = kind_of<T>;
    if constexpr (kind == Kind::scalar) {
      store_raw<T>(to, raw_of(value));
    } else if constexpr (kind == Kind::axes) {
      constexpr std::size_t step = wire_size<ElementOf<T>>;
      put(to, value[0]);
      put(to + step, value[1]);
      put(to + 2 * step, value[2]);
    } else if constexpr (kind == Kind::array) {
      constexpr std::size_t step = wire_size<ElementOf<T>>;
      for (std::size_t i = 0; i < value.size(); ++i) put(to + i * step, value[i]);
    } else if constexpr (kind == Kind::bytes) {
      copy(value.data(), to, value.size());
    } else if constexpr (kind == Kind::text) {
      put(to, value.bytes);
    } else if constexpr (HasFixedMembers<T>) {
      put_members(to, value, typename T::FixedMembers{}, indices<T>);
    }
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

  template <bool in_blocks, MemberPlace place, class M, class T>
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
  template <bool in_blocks, MemberPlace place, class M, class T>
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
