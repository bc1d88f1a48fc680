/// Physical quantities as strong types over the exact integer of the wire.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

namespace sbgc {

/// A real number turned into a quantity, unless it does not fit.
///
/// A constant converts by itself, and one that does not fit does not compile:
///     Angle14 a = Angle14::from_degrees(-30.0);
/// A value that is known only at run time has to be asked first:
///     if (auto a = Angle14::from_degrees(x)) use(*a);
template <class Q>
class Conversion {
 public:
  constexpr Conversion() = default;
  constexpr explicit Conversion(Q value) noexcept : value_(value), fits_(true) {}

  /// Whether the number fits.
  constexpr explicit operator bool() const noexcept { return fits_; }
  /// The nearest quantity. Precondition: the number fits.
  constexpr Q operator*() const noexcept { return value_; }
  constexpr Q value_or(Q other) const noexcept { return fits_ ? value_ : other; }

  consteval operator Q() const noexcept {  // NOLINT(google-explicit-constructor): see above
    if (!fits_) number_does_not_fit_into_the_quantity();
    return value_;
  }

 private:
  // Not constexpr: reaching it at compile time is the error message.
  static void number_does_not_fit_into_the_quantity() noexcept {}

  Q value_{};
  bool fits_{};
};

namespace detail {

/// What all quantities share: real value = raw * numerator / denominator + offset.
template <class Self, class Raw, std::int64_t numerator, std::int64_t denominator,
          std::int64_t offset_numerator = 0, std::int64_t offset_denominator = 1>
  requires std::integral<Raw> || std::floating_point<Raw>
class Quantity {
 public:
  using raw_type = Raw;

  constexpr Quantity() = default;
  constexpr explicit Quantity(Raw raw) noexcept : raw_(raw) {}

  /// The number as it stands on the wire.
  constexpr Raw raw() const noexcept { return raw_; }
  /// The physical value in the quantity's unit.
  constexpr double real() const noexcept {
    return static_cast<double>(raw_) * static_cast<double>(numerator) /
               static_cast<double>(denominator) +
           offset;
  }
  /// The nearest quantity to a physical value.
  static constexpr Conversion<Self> from_real(double value) noexcept {
    const double exact =
        (value - offset) * static_cast<double>(denominator) / static_cast<double>(numerator);
    constexpr auto lowest = static_cast<double>(std::numeric_limits<Raw>::lowest());
    constexpr auto highest = static_cast<double>(std::numeric_limits<Raw>::max());
    // Written so that NaN fails, too.
    if constexpr (std::floating_point<Raw>) {
      if (!(exact >= lowest && exact <= highest)) return {};
      return Conversion<Self>(Self(static_cast<Raw>(exact)));
    } else {
      if (!(exact > lowest - 0.5 && exact < highest + 0.5)) return {};
      // The remainder is exact, which exact + 0.5 would not be.
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
  static constexpr double offset =
      static_cast<double>(offset_numerator) / static_cast<double>(offset_denominator);

  Raw raw_{};
};

}  // namespace detail
}  // namespace sbgc
