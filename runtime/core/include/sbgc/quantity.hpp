/// Physical quantities as strong types over the exact number on the wire.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <sbgc/detail/exponential.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/types.hpp>

namespace sbgc {
namespace detail {

template <class>
inline constexpr bool always_false = false;

/// The reason for a compile error; see the quantities.
// NOLINTNEXTLINE(readability-identifier-naming): a sentence
struct a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees {};

/// Called if a number that does not fit is used without a test: a compile error in a constant
/// expression, a trap at run time.
[[noreturn]] inline void the_number_does_not_fit_into_the_quantity() noexcept { trap(); }

}  // namespace detail

/// The conversion of a run-time number to a quantity, which it may not fit:
///     if (const auto angle = Angle14::from_degrees(x)) use(*angle);
template <class Q>
class [[nodiscard]] Conversion {
 public:
  constexpr Conversion() = default;
  /// A value that fits.
  constexpr explicit Conversion(Q value) noexcept : value_(value), fits_(true) {}

  /// Returns true if the number fits.
  constexpr explicit operator bool() const noexcept { return fits_; }
  /// Returns the nearest quantity. Traps if the number does not fit.
  constexpr Q operator*() const noexcept {
    if (!fits_) detail::the_number_does_not_fit_into_the_quantity();
    return value_;
  }
  /// Returns the value, or `other` if it does not fit.
  constexpr Q value_or(Q other) const noexcept { return fits_ ? value_ : other; }

  /// Never compiles; the error explains what to write instead.
  template <std::same_as<Q> To>
  constexpr operator To() const noexcept {  // NOLINT(google-explicit-constructor): see above
    static_assert(
        detail::always_false<To>,
        "a number known at run time may not fit: test it, as in 'if (const auto angle = "
        "Angle14::from_degrees(x))', then use *angle; write a constant as a literal, such "
        "as 45_deg");
    return value_;
  }

 private:
  Q value_{};
  bool fits_{};
};

namespace detail {

constexpr double ratio(std::int64_t numerator, std::int64_t denominator) noexcept {
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

template <class Self>
concept Exponential = requires {
  Self::growth;
};

/// The type of a wire number in a program.
template <class Number>
struct NumberInfo {
  using Raw = Number;
  static constexpr Raw lowest = std::numeric_limits<Raw>::lowest();
  static constexpr Raw highest = std::numeric_limits<Raw>::max();
};
template <class Integer>
struct NumberInfo<Integer24<Integer>> {
  using Raw = Integer;
  static constexpr Raw lowest = Integer24<Raw>::lowest;
  static constexpr Raw highest = Integer24<Raw>::highest;
};

/// Returns the integer nearest to a number, which must be in range.
template <class Integer>
constexpr Integer nearest_integer(double number) noexcept {
  // The remainder is exact; number + 0.5 would not be.
  const auto whole = static_cast<Integer>(number);
  const double rest = number - static_cast<double>(whole);
  if (rest >= 0.5) return static_cast<Integer>(whole + 1);
  return rest <= -0.5 ? static_cast<Integer>(whole - 1) : whole;
}

/// The base of all quantities: real value = raw * numerator / denominator + offset, in `Unit`. If
/// Self has a `growth`, growth^raw takes the place of raw. `Number` is the type on the wire.
template <class Self, class Number, class Unit, std::int64_t numerator, std::int64_t denominator,
          std::int64_t offset_numerator = 0, std::int64_t offset_denominator = 1>
class Quantity {
  using Raw = typename NumberInfo<Number>::Raw;
  static_assert(std::integral<Raw> || std::floating_point<Raw>);

 public:
  using number_type = Number;
  using raw_type = Raw;
  using unit_type = Unit;
  static constexpr const char* unit = Unit::text;

  constexpr Quantity() = default;
  /// Traps if the number does not fit on the wire, where it may have fewer bits than in memory.
  constexpr explicit Quantity(Raw raw) noexcept : number_(raw) {}
  /// Never compiles; the error explains what to write instead.
  template <std::floating_point Real>
    requires std::integral<Raw>
  constexpr explicit Quantity(Real) noexcept {
    static_assert(
        always_false<Real>,
        "this constructor takes the whole number of the wire: write a physical value as a "
        "literal, such as 45_deg, or with a function such as Angle14::from_degrees(x)");
  }
  /// Returns the number on the wire.
  constexpr Raw raw() const noexcept {
    if constexpr (std::same_as<Raw, Number>) {
      return number_;
    } else {
      return number_.raw();
    }
  }
  /// Returns the physical value in the quantity's unit.
  constexpr double real() const noexcept {
    const auto steps = [&] {
      if constexpr (Exponential<Self>) {
        return power(Self::growth, raw());
      } else {
        return static_cast<double>(raw());
      }
    }();
    return steps * static_cast<double>(numerator) / static_cast<double>(denominator) +
           ratio(offset_numerator, offset_denominator);
  }
  /// Returns the quantity nearest to a physical value.
  static constexpr Conversion<Self> from_real(double value) noexcept {
    double exact = (value - ratio(offset_numerator, offset_denominator)) *
                   static_cast<double>(denominator) / static_cast<double>(numerator);
    if constexpr (Exponential<Self>) {
      exact = static_cast<double>(nearest_exponent(Self::growth, exact));
    }
    constexpr auto lowest = static_cast<double>(NumberInfo<Number>::lowest);
    constexpr auto highest = static_cast<double>(NumberInfo<Number>::highest);
    // Written such that NaN also fails.
    if constexpr (std::floating_point<Raw>) {
      if (!(exact >= lowest && exact <= highest)) return {};
      return Conversion<Self>(Self(static_cast<Raw>(exact)));
    } else {
      // With 64 bits, `highest` is one too high, and `lowest - 0.5` equals `lowest`.
      if (!((exact >= lowest || exact > lowest - 0.5) && exact < highest + 0.5)) return {};
      using Wide = std::conditional_t<sizeof(Raw) == 8, Raw, std::int64_t>;
      return Conversion<Self>(Self(static_cast<Raw>(nearest_integer<Wide>(exact))));
    }
  }

  friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;

 private:
  Number number_{};
};

}  // namespace detail
}  // namespace sbgc
