/// The offsets of members in memory and on the wire.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/type_list.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc::detail {

/// The offsets of one fixed-offset member.
struct MemberPlace {
  std::size_t wire{};    ///< its offset in the body
  std::size_t memory{};  ///< its offset in the struct
  /// The size of the block that begins with this member: a run of members laid out in memory as on
  /// the wire. 0 inside a block, and for a member whose bytes differ in memory.
  std::size_t block{};
  bool same{};  ///< true if its bytes are the same in memory and on the wire
};

/// The offsets of `n` members, and whether to copy them in blocks. Compilers seldom merge the
/// copies themselves.
template <std::size_t n>
struct Layout {
  std::array<MemberPlace, n> places{};
  bool in_blocks{};
  bool only_blocks{};                   ///< true if every member is in a block
  std::size_t block_count{};            ///< used elements of `blocks`
  std::array<std::size_t, n> blocks{};  ///< the index of the first member of each block
};

template <class M, class... T>
consteval auto layout_of(TypeList<T...>) noexcept {
  constexpr std::size_t count = sizeof...(T);
  constexpr std::array<std::size_t, count> sizes{sizeof(T)...};
  constexpr std::array<std::size_t, count> alignments{alignof(T)...};
  constexpr std::array<std::size_t, count> wire_sizes{wire_size<T>...};
  // Equal sizes imply equal bytes: no type has padding or a part that is larger than on the wire.
  constexpr std::array<bool, count> same{(sizeof(T) == wire_size<T> && !TaggedUnion<T>)...};
  Layout<count> layout;
  std::size_t memory = 0;
  std::size_t wire = 0;
  std::size_t others = 0;
  std::size_t numbers = 0;
  bool is_packed = false;
  MemberPlace* block = nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    if (alignments[i] > alignof(M)) is_packed = true;
    memory = (memory + alignments[i] - 1) / alignments[i] * alignments[i];
    MemberPlace& place = layout.places[i];
    place = {wire, memory, 0, same[i]};
    const bool goes_on = block != nullptr && memory - wire == block->memory - block->wire;
    if (!same[i]) {
      block = nullptr;
      ++others;
    } else if (!goes_on) {
      block = &place;
      layout.blocks[layout.block_count++] = i;
    }
    if (block != nullptr) block->block += sizes[i];
    numbers += sizes[i] / alignments[i];
    memory += sizes[i];
    wire += wire_sizes[i];
  }
  // For small code, a block replaces the numbers that it consists of.
  const std::size_t copies = prefers_small_code ? numbers : count;
  const bool is_worthwhile = copies > 2 && 2 * (layout.block_count + others) <= copies;
  layout.in_blocks = is_worthwhile && !is_packed && std::endian::native == std::endian::little;
  layout.only_blocks = layout.in_blocks && others == 0;
  return layout;
}

/// The layout of the fixed-offset members, which precede all others.
template <class M>
inline constexpr auto layout = layout_of<M>(fixed_types<M>);

}  // namespace sbgc::detail
