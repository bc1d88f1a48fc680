/// A table-driven codec for messages whose bodies all have the same members.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/any.hpp>

namespace sbgc::detail {

/// True for messages that consist of fixed members, and perhaps a tail.
template <class M>
inline constexpr bool has_only_fixed =
    !HasVaryingMembers<CodedAs<M>> && !HasTaggedUnions<CodedAs<M>>;

constexpr bool is_integer24_raw(RawType raw) noexcept {
  return raw == RawType::u24 || raw == RawType::i24;
}
constexpr std::size_t size_on_wire(RawType raw) noexcept {
  constexpr std::uint8_t sizes[] = {1, 1, 2, 2, 3, 3, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(raw)];
}
constexpr std::size_t size_in_memory(RawType raw) noexcept {
  return is_integer24_raw(raw) ? 4 : size_on_wire(raw);
}

/// Collects the runs of a message. Without a destination, only counts them.
struct RunFinder {
  Run* runs{};
  std::size_t count{};
  Run last{};

  constexpr void add(const ValueType& type, std::size_t wire, std::size_t memory) noexcept {
    if (type.kind == Kind::scalar) {
      add(type.raw, 1, wire, memory);
    } else if (type.group != nullptr) {
      members(*type.group, wire, memory);
    } else if (type.kind == Kind::array) {
      for (std::size_t i = 0; i < type.count; ++i) {
        add(*type.element, wire + i * type.element->wire, memory + i * type.element->memory);
      }
    } else {
      add(RawType::u8, type.wire, wire, memory);  // bytes or a text
    }
  }
  constexpr void members(const StructTable& group, std::size_t wire, std::size_t memory) noexcept {
    for (const Slot& slot : group.slots) {
      add(*slot.type, wire, memory + slot.offset);
      wire += slot.type->wire;
    }
  }
  constexpr void add(RawType raw, std::size_t size, std::size_t wire, std::size_t memory) noexcept {
    if (std::endian::native == std::endian::little && !is_integer24_raw(raw)) {
      size *= size_on_wire(raw);
      raw = RawType::u8;  // the bytes are the same
    }
    const bool goes_on = count != 0 && raw == last.raw &&
                         wire == last.wire + last.count * size_on_wire(raw) &&
                         memory == last.memory + last.count * size_in_memory(raw);
    if (goes_on) {
      last.count = static_cast<std::uint16_t>(last.count + size);
    } else {
      last = {static_cast<std::uint16_t>(wire), static_cast<std::uint16_t>(memory),
              static_cast<std::uint16_t>(size), raw};
      ++count;
    }
    if (runs != nullptr) runs[count - 1] = last;
  }
};

template <class M>
inline constexpr std::size_t run_count = [] {
  RunFinder counter;
  counter.members(table_of<M>(), 0, 0);
  return counter.count;
}();
template <class M>
inline constexpr auto runs_of = [] {
  std::array<Run, run_count<M>> runs{};
  RunFinder finder{.runs = runs.data()};
  finder.members(table_of<M>(), 0, 0);
  return runs;
}();

Status decode_fixed(const AnyOperations& of, std::span<const std::uint8_t> body, void* message,
                    const Contexts& contexts);
WriteResult encode_fixed(const AnyOperations& of, const void* message, std::span<std::uint8_t> out);

}  // namespace sbgc::detail
