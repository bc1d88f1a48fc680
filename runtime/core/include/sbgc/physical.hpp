/// Literals of physical values, such as 45_deg, whose type holds the number and the unit.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <sbgc/internal/compiler.hpp>

namespace sbgc {

template <class Q>
class Conversion;  // see quantity.hpp

/// The value `numerator / denominator` in `Unit`. Converts to every quantity in that unit; a value
/// that does not fit is a compile error.
template <class Unit, std::int64_t numerator, std::int64_t denominator = 1>
struct Physical {
  /// Returns the number in the unit.
  static constexpr double real() noexcept {
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }
  template <class Quantity>
    requires std::same_as<typename Quantity::unit_type, Unit>
  constexpr operator Quantity() const noexcept {  // NOLINT(google-explicit-constructor): see above
    constexpr auto quantity = Quantity::from_real(real());
    static_assert(static_cast<bool>(quantity),
                  "this physical value does not fit into the number of the quantity on the wire");
    return Quantity((*quantity).raw());
  }
  /// The value itself.
  constexpr Physical operator+() const noexcept { return {}; }
  /// The value with the other sign.
  constexpr Physical<Unit, -numerator, denominator> operator-() const noexcept { return {}; }
};

namespace detail {

/// A number as written in source code. Numerator and denominator are exact as doubles, so their
/// quotient is correctly rounded.
struct Decimal {
  std::int64_t numerator{};
  std::int64_t denominator = 1;
  bool is_decimal = true;
  bool is_short = true;

  consteval void times_ten(std::int64_t& number) noexcept {
    constexpr std::int64_t exact = 1'000'000'000'000'000;  // below 2^53
    if (number < exact / 10) {
      number *= 10;
    } else {
      is_short = false;
    }
  }
};

/// Parses "45", "12.6", "1'000" and "2.5e-3".
template <std::size_t n>
consteval Decimal read_decimal(const char (&text)[n]) noexcept {
  Decimal result{};
  std::size_t at = 0;
  bool is_fraction = false;
  for (; at < n && text[at] != 'e' && text[at] != 'E'; ++at) {
    const char c = text[at];
    if (c == '\'') continue;
    if (c == '.') {
      is_fraction = true;
    } else if (c >= '0' && c <= '9') {
      result.times_ten(result.numerator);
      result.numerator += c - '0';
      if (is_fraction) result.times_ten(result.denominator);
    } else {
      result.is_decimal = false;
    }
  }
  // In C++, an integer that begins with 0 is octal.
  if (n > 1 && text[0] == '0' && at == n && !is_fraction) result.is_decimal = false;
  if (at == n) return result;
  const bool is_negative = text[++at] == '-';
  if (text[at] == '-' || text[at] == '+') ++at;
  int exponent = 0;
  for (; at < n && exponent < 100; ++at) {
    if (text[at] != '\'') exponent = 10 * exponent + (text[at] - '0');
  }
  for (; exponent > 0 && result.is_short; --exponent) {
    result.times_ten(is_negative ? result.denominator : result.numerator);
  }
  return result;
}

/// Returns the value of a literal of the unit.
template <class Unit, char... text>
constexpr auto physical() noexcept {
  constexpr char characters[] = {text...};
  constexpr Decimal number = read_decimal(characters);
  static_assert(number.is_decimal, "write the number of a physical value in decimal");
  static_assert(number.is_short, "the number of this physical value has too many digits");
  return Physical<Unit, number.numerator, number.denominator>{};
}

}  // namespace detail
}  // namespace sbgc
