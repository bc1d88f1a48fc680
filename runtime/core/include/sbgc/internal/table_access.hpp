/// Reads and writes the values of messages by means of their tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/number.hpp>

namespace sbgc::detail {

template <class T>
SBGC_ALWAYS_INLINE inline T load(const void* at) noexcept {
  T value;
  copy_memory(&value, at, sizeof value);
  return value;
}
template <class T>
SBGC_ALWAYS_INLINE inline void store(void* at, T value) noexcept {
  copy_memory(at, &value, sizeof value);
}

inline const void* moved(const void* at, std::size_t by) noexcept {
  return static_cast<const std::byte*>(at) + by;
}
inline void* moved(void* at, std::size_t by) noexcept { return static_cast<std::byte*>(at) + by; }

constexpr bool is_real(RawType type) noexcept { return type >= RawType::f32; }
constexpr bool is_signed(RawType type) noexcept {
  return (static_cast<unsigned>(type) & 1U) != 0 && !is_real(type);
}

/// True for a number without a special meaning.
constexpr bool is_plain_integer(const ValueType& type) noexcept {
  const ScalarInfo& info = type.meaning;
  return type.kind == Kind::scalar && !is_real(type.raw) && info.unit == nullptr &&
         info.names == nullptr && info.packed == nullptr;
}

/// Calls `use(T{})` with the type of a number in memory.
template <class Use>
SBGC_ALWAYS_INLINE inline decltype(auto) with_raw(RawType type, Use&& use) {
  switch (type) {
    case RawType::u8: return use(std::uint8_t{});
    case RawType::i8: return use(std::int8_t{});
    case RawType::u16: return use(std::uint16_t{});
    case RawType::i16: return use(std::int16_t{});
    case RawType::u24:
    case RawType::u32: return use(std::uint32_t{});
    case RawType::i24:
    case RawType::i32: return use(std::int32_t{});
    case RawType::u64: return use(std::uint64_t{});
    case RawType::i64: return use(std::int64_t{});
    case RawType::f32: return use(float{});
    case RawType::f64: break;
  }
  return use(double{});
}

/// Returns an integer; for an unsigned integer of 64 bits, its bits.
SBGC_ALWAYS_INLINE inline std::int64_t load_integer(RawType type, const void* at) noexcept {
  return with_raw(type, [at]<class T>(T) { return static_cast<std::int64_t>(load<T>(at)); });
}
inline double load_real(RawType type, const void* at) noexcept {
  return type == RawType::f32 ? static_cast<double>(load<float>(at)) : load<double>(at);
}
/// Stores an integer or a real number, which must fit.
template <class Value>
void store_number(RawType type, void* at, Value value) noexcept {
  with_raw(type, [&]<class T>(T) { store(at, static_cast<T>(value)); });
}

/// The range of the wire, for integers of at most 63 bits.
struct RawLimits {
  std::int64_t lowest;
  std::int64_t highest;
};
constexpr RawLimits limits_of(RawType type) noexcept {
  constexpr std::uint8_t bits[] = {8, 8, 16, 16, 24, 24, 32, 32, 64, 64};
  const unsigned used = bits[static_cast<unsigned>(type)] - (is_signed(type) ? 1U : 0U);
  const auto highest = static_cast<std::int64_t>(~std::uint64_t{0} >> (64 - used));
  return {is_signed(type) ? -highest - 1 : 0, highest};
}

/// Precondition: the type is an integer.
constexpr RawType raw_of_number(NumberType type) noexcept {
  switch (type) {
    case NumberType::i8: return RawType::i8;
    case NumberType::u16: return RawType::u16;
    case NumberType::i16: return RawType::i16;
    case NumberType::u32: return RawType::u32;
    case NumberType::i32: return RawType::i32;
    default: return RawType::u8;
  }
}

/// Returns true for an Optional that has a value, which is at the same place.
inline bool is_present(const ValueType& type, const void* at) noexcept {
  return load<std::uint8_t>(moved(at, type.begin)) != 0;
}
inline void set_present(const ValueType& type, void* at, bool is_present) noexcept {
  store(moved(at, type.begin), is_present);
}

/// Returns the number of bytes, characters or elements; the padding of a text does not count.
inline std::size_t size_at(const ValueType& type, const void* at) noexcept {
  if (type.is_bounded) return load<std::uint8_t>(at);
  std::size_t size = type.count;
  if (type.kind == Kind::text) {
    while (size > 0 && load<char>(moved(at, size - 1)) == '\0') --size;
  }
  return size;
}

/// Sets the size of bytes, a text or a list, and constructs new elements. Returns false and changes
/// nothing if the size exceeds the capacity, or differs from a fixed one.
inline bool resize(const ValueType& type, void* at, std::size_t size) noexcept {
  if (!type.is_bounded) return size == type.count;
  if (size > type.count) return false;
  if (type.construct != nullptr) {
    for (std::size_t i = size_at(type, at); i < size; ++i) {
      type.construct(moved(at, type.begin + i * type.element->memory));
    }
  }
  store(at, static_cast<std::uint8_t>(size));
  return true;
}

inline const void* element_at(const ValueType& type, const void* at, std::size_t index) noexcept {
  return moved(at, type.begin + index * type.element->memory);
}
inline void* element_at(const ValueType& type, void* at, std::size_t index) noexcept {
  return moved(at, type.begin + index * type.element->memory);
}

/// Returns the value of a counter, which is at its list.
inline std::size_t counted(const ValueType& type, const void* list) noexcept {
  const std::size_t size = size_at(*type.element, list) * type.counted_as;
  return size > type.uncounted ? size - type.uncounted : 0;
}

}  // namespace sbgc::detail
