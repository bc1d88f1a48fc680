/// Numbers whose type is known only at run time, because another message announces it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <sbgc/types.hpp>

namespace sbgc {

/// The number types of the wire.
enum class NumberType : std::uint8_t { none, u8, i8, u16, i16, u32, i32, f32 };

/// Returns the size of a number of this type in bytes; 0 for none.
constexpr std::size_t size_of(NumberType type) noexcept {
  switch (type) {
    case NumberType::none: return 0;
    case NumberType::u8:
    case NumberType::i8: return 1;
    case NumberType::u16:
    case NumberType::i16: return 2;
    case NumberType::u32:
    case NumberType::i32:
    case NumberType::f32: return 4;
  }
  return 0;
}

/// Returns the name of a type, e.g. "i16".
constexpr const char* name(NumberType type) noexcept {
  switch (type) {
    case NumberType::none: return "none";
    case NumberType::u8: return "u8";
    case NumberType::i8: return "i8";
    case NumberType::u16: return "u16";
    case NumberType::i16: return "i16";
    case NumberType::u32: return "u32";
    case NumberType::i32: return "i32";
    case NumberType::f32: return "f32";
  }
  return "none";
}

/// A number with its type; `bits` is its wire representation, not sign-extended.
struct Number {
  NumberType type{};
  std::uint32_t bits{};  ///< the number as on the wire; floats as their bits

  /// Precondition: the type is not f32.
  constexpr std::int64_t integer() const noexcept {
    switch (type) {
      case NumberType::i8: return static_cast<std::int8_t>(bits);
      case NumberType::i16: return static_cast<std::int16_t>(bits);
      case NumberType::i32: return static_cast<std::int32_t>(bits);
      default: return bits;
    }
  }
  /// Precondition: the type is f32.
  constexpr float real() const noexcept { return std::bit_cast<float>(bits); }
  /// Returns the value of a number of any type.
  constexpr double value() const noexcept {
    return type == NumberType::f32 ? static_cast<double>(real()) : static_cast<double>(integer());
  }

  friend constexpr bool operator==(const Number&, const Number&) = default;
};

/// The types that a message announces for the numbers of later ones.
using NumberTypes = BoundedArray<NumberType, 255>;

namespace detail {

/// Adds `count` numbers of a type, at least one, up to the capacity. Returns false if the type is
/// unknown, because the numbers after it cannot be located then.
constexpr bool announce(NumberTypes& types, NumberType type, std::size_t count) noexcept {
  if (type == NumberType::none) return false;
  do {
    if (!types.push_back(type)) return true;
  } while (count-- > 1);
  return true;
}

}  // namespace detail
}  // namespace sbgc
