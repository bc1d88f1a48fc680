/// Physical quantities as strong types over the exact number on the wire.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

#include <sbgc/detail/compiler.hpp>
#include <sbgc/detail/exponential.hpp>

namespace sbgc {
namespace detail {

template <class>
inline constexpr bool always_false = false;

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
  constexpr explicit Conversion(Q value) noexcept : value_(value), fits_(true) {}

  /// Returns true if the number fits.
  constexpr explicit operator bool() const noexcept { return fits_; }
  /// Returns the nearest quantity. Traps if the number does not fit.
  constexpr Q operator*() const noexcept {
    if (!fits_) detail::the_number_does_not_fit_into_the_quantity();
    return value_;
  }
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

/// The base of all quantities: real value = raw * numerator / denominator + offset, in `Unit`. If
/// Self has a `growth`, growth^raw takes the place of raw.
template <class Self, class Raw, class Unit, std::int64_t numerator, std::int64_t denominator,
          std::int64_t offset_numerator = 0, std::int64_t offset_denominator = 1>
  requires std::integral<Raw> || std::floating_point<Raw>
class Quantity {
 public:
  using raw_type = Raw;
  using unit_type = Unit;
  static constexpr const char* unit = Unit::text;

  constexpr Quantity() = default;
  constexpr explicit Quantity(Raw raw) noexcept : raw_(raw) {}
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
  constexpr Raw raw() const noexcept { return raw_; }
  /// Returns the physical value in the quantity's unit.
  constexpr double real() const noexcept {
    const auto steps = [&] {
      if constexpr (Exponential<Self>) {
        return power(Self::growth, raw_);
      } else {
        return static_cast<double>(raw_);
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
    constexpr auto lowest = static_cast<double>(std::numeric_limits<Raw>::lowest());
    constexpr auto highest = static_cast<double>(std::numeric_limits<Raw>::max());
    // Written so that NaN also fails.
    if constexpr (std::floating_point<Raw>) {
      if (!(exact >= lowest && exact <= highest)) return {};
      return Conversion<Self>(Self(static_cast<Raw>(exact)));
    } else {
      if (!(exact > lowest - 0.5 && exact < highest + 0.5)) return {};
      // The remainder is exact; exact + 0.5 would not be.
      const auto whole = static_cast<std::int64_t>(exact);
      const double rest = exact - static_cast<double>(whole);
      const std::int64_t step = rest >= 0.5 ? 1 : rest <= -0.5 ? -1 : 0;
      return Conversion<Self>(Self(static_cast<Raw>(whole + step)));
    }
  }

  friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;

 private:
  Raw raw_{};
};

}  // namespace detail
}  // namespace sbgc
