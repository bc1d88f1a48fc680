/// Checks the values of a message against the limits of their fields.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <sbgc/detail/named_values.hpp>
#include <sbgc/detail/walk_members.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/violation.hpp>

namespace sbgc::detail {

/// In place of a function that reports violations: only whether there are some is of interest.
struct NoReport {};

/// Without a report, everything is inlined into Meta<T>::visit(), where the facts of each field are
/// constants: what remains is a few comparisons of integers, without branches, which would
/// outnumber them. With one, the rules of a number are a function.
template <class Report>
class Check {
 public:
  static constexpr bool is_silent = std::is_same_v<Report, const NoReport>;
  static constexpr bool is_inlined = is_silent;
  using Place = std::conditional_t<is_silent, FieldPlace, PathPlace>;
  using Parent = typename Place::Parent;

  constexpr Check(const Availability& versions, Report& report) noexcept
      : versions_(versions), report_(report) {}

  constexpr bool passed() const noexcept { return failures_ == 0; }

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void members(const T& value, Parent parent) {
    MemberWalk<Check> walk{*this, parent};
    if constexpr (requires { Meta<T>::visit_used(value, walk); }) {
      Meta<T>::visit_used(value, walk);
    } else {
      Meta<T>::visit(value, walk);
    }
    if constexpr (requires { Meta<T>::rules(value, Order{*this, parent}); }) {
      Meta<T>::rules(value, Order{*this, parent});
    }
  }

  // The handlers of the walk.

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void scalar(const T& value, const Place& place) {
    if constexpr (is_silent) {
      limited(raw_of(value), place);
    } else {
      limited_apart(raw_of(value), place);
    }
    if constexpr (has_named_values<T>) names(value, place);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void variable(T value, const VariableInfo& variable,
                                             const Place& place) {
    if (variable.later.empty() || is_silent) {
      return in_range(static_cast<double>(value), variable.range, place, &variable.unit);
    }
    const UnitInfo unit = variable.unit_in(known_versions());
    in_range(static_cast<double>(value), variable.range, place, &unit);
  }
  SBGC_ALWAYS_INLINE constexpr void counter(const Counter& counter, const Place& place) {
    limited(counter.count, place);
  }
  constexpr void number(const Number&, const Place&) {}
  template <class T>
  constexpr void text(const T&, const Place&) {}

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void bytes(const T& bytes, const Place& place) {
    if constexpr (is_bounded<T>) {
      counted(bytes.size(), place);
      aligned(bytes.size(), place);
    }
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void list(const T& list, const Place& place) {
    counted(list.size(), place);
    walk_list(list, place, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void array(const T& array, const Place& place) {
    walk_list(array, place, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void axes(const T& axes, const Place& place) {
    if constexpr (is_silent) {
      walk_axes(axes, place, *this);
    } else {
      axes_apart(axes, place);
    }
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void optional(const T& optional, const Place& place) {
    if (!optional) return;
    // Its presence alone changes the body, whatever the value.
    exists(place.field.since, false, 0, place);
    if (is_available(place.field.since, versions_)) walk(*optional, place, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void group(const T& value, const Place& place) {
    members(value, place.parent());
  }

 private:
  /// What a violation is besides its place.
  struct Breach {
    double value{};
    double limit{};
    Rule rule{};
    const UnitInfo* unit{};  ///< if it is not that of the field
    const ValueInfo* named{};
    const FieldInfo* other{};
  };

  /// Checks rules across fields.
  struct Order {
    Check& check;
    Parent parent{};

    template <class T>
    SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo& field, const T& low,
                                                 const FieldInfo& other, const T& high,
                                                 bool is_strict) {
      compare(low, high, Place(field, parent), other, is_strict);
    }

    /// "" for an element of an array.
    template <class T>
    static constexpr const char* element_name(std::size_t i) noexcept {
      if constexpr (kind_of<T> == Kind::axes) {
        return Meta<T>::fields[i].name;
      } else {
        return "";
      }
    }

    template <class T>
    constexpr void compare(const T& low, const T& high, const Place& place, const FieldInfo& other,
                           bool is_strict) {
      if constexpr (kind_of<T> == Kind::scalar) {
        const auto a = raw_of(low);
        const auto b = raw_of(high);
        check.require(is_strict ? a < b : a <= b, place,
                      {.value = static_cast<double>(a),
                       .limit = static_cast<double>(b),
                       .rule = Rule::order,
                       .other = &other});
      } else {
        for (std::size_t i = 0; i < low.size(); ++i) {
          compare(low[i], high[i], Place(place, element_name<T>(i), i), other, is_strict);
        }
      }
    }
  };

  SBGC_ALWAYS_INLINE constexpr void require(bool holds, [[maybe_unused]] const Place& place,
                                            [[maybe_unused]] const Breach& breach) {
    if constexpr (is_silent) {
      failures_ |= static_cast<unsigned>(!holds);
    } else {
      if (!holds) fail(place, breach);
    }
  }
  SBGC_NOINLINE constexpr void fail(const Place& place, const Breach& breach) {
    failures_ = 1;
    const FieldInfo& field = place.field;
    const bool has_unit = field.alternative == nullptr && breach.rule != Rule::count;
    const LaterMeaning* const later = meaning_in(field.later, known_versions());
    const UnitInfo* const unit = !has_unit ? nullptr : later != nullptr ? later->unit : field.unit;
    report_(Violation{place.path, field, breach.value, breach.limit, breach.rule,
                      breach.unit != nullptr ? breach.unit : unit, breach.named, breach.other});
  }

  SBGC_ALWAYS_INLINE constexpr void exists(const Availability& since, bool is_absent, double value,
                                           const Place& place, const ValueInfo* named = nullptr) {
    require(is_absent || since.firmware <= versions_.firmware, place,
            {value, static_cast<double>(since.firmware), Rule::firmware, nullptr, named});
    require(is_absent || since.board <= versions_.board, place,
            {value, static_cast<double>(since.board), Rule::board, nullptr, named});
    require(is_absent || (since.features & versions_.features) == 0, place,
            {value, static_cast<double>(since.features), Rule::feature, nullptr, named});
  }
  SBGC_ALWAYS_INLINE constexpr void counted(std::size_t size, const Place& place) {
    const auto value = static_cast<double>(size);
    const std::uint16_t least = place.field.min_count;
    const std::uint16_t most = place.field.max_count;
    require(size >= least, place, {value, static_cast<double>(least), Rule::count});
    require(most == 0 || size <= most, place, {value, static_cast<double>(most), Rule::count});
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void aligned(Raw raw, const Place& place) {
    const std::uint16_t align = place.field.align;
    require(align == 1 || static_cast<std::uint64_t>(raw) % align == 0 || is_special(raw, place),
            place, {static_cast<double>(raw), static_cast<double>(align), Rule::alignment});
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void in_range(Raw raw, const Range& range, const Place& place,
                                             const UnitInfo* unit = nullptr) {
    const bool is_low = is_below(raw, range);
    const bool is_high = is_above(raw, range);
    // In one condition, which compilers make one comparison.
    bool is_outside = is_low | is_high;
    if (!place.field.special.empty() && is_outside) is_outside = !is_special(raw, place);
    const double limit = is_low ? range.lowest : range.highest;
    require(!is_outside, place,
            {static_cast<double>(raw), limit, is_low ? Rule::minimum : Rule::maximum, unit});
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void limited(Raw raw, const Place& place) {
    exists(place.field.since, raw == 0, static_cast<double>(raw), place);
    if constexpr (std::is_integral_v<Raw>) aligned(raw, place);
    const Range* range = place.field.range;
    if (!place.field.later.empty()) {
      const LaterMeaning* const later = meaning_in(place.field.later, versions_);
      if (later != nullptr && later->range != nullptr) range = later->range;
    }
    if (range != nullptr) in_range(raw, *range, place);
  }
  template <class Raw>
  SBGC_NOINLINE constexpr void limited_apart(Raw raw, const Place& place) {
    limited(raw, place);
  }

  template <class T>
  SBGC_NOINLINE constexpr void axes_apart(const T& axes, const Place& place) {
    walk_axes(axes, place, *this);
  }

  template <class Raw>
  static constexpr bool is_special(Raw raw, const Place& place) noexcept {
    bool result = false;
    for (const Special& special : place.field.special) {
      result |= static_cast<double>(raw) == static_cast<double>(special.value);
    }
    return result;
  }

  // Integers are compared with the smallest and the largest integer in the range. Written so that
  // NaN is below.
  template <class Raw>
  SBGC_ALWAYS_INLINE static constexpr bool is_below(Raw raw, const Range& range) noexcept {
    if constexpr (std::is_integral_v<Raw> && sizeof(Raw) <= 4) {
      constexpr std::int64_t least = std::numeric_limits<Raw>::min();
      const bool is_limited = range.lowest > static_cast<double>(least);
      return raw < (is_limited ? -whole(-range.lowest) : least);
    } else {
      return !(static_cast<double>(raw) >= range.lowest);
    }
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE static constexpr bool is_above(Raw raw, const Range& range) noexcept {
    if constexpr (std::is_integral_v<Raw> && sizeof(Raw) <= 4) {
      constexpr std::int64_t most = std::numeric_limits<Raw>::max();
      const bool is_limited = range.highest < static_cast<double>(most);
      return raw > (is_limited ? whole(range.highest) : most);
    } else {
      return static_cast<double>(raw) > range.highest;
    }
  }
  /// Returns the largest integer that is not above `number`.
  static constexpr std::int64_t whole(double number) noexcept {
    const auto integer = static_cast<std::int64_t>(number);
    return static_cast<double>(integer) > number ? integer - 1 : integer;
  }

  /// Checks the named values that a later version introduced.
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void names(const T& value, const Place& place) {
    constexpr Availability needed = has_all_values_of<T>;
    if constexpr (needed.firmware != 0 || needed.board != 0 || needed.features != 0) {
      if (is_available(needed, versions_)) return;
      for_each_name(value, [&](const ValueInfo& known, std::int64_t raw) {
        exists(known.since, false, static_cast<double>(raw), place, &known);
      });
    }
  }

  /// The versions of the board; none if it is any, whose values are in their usual units.
  constexpr Availability known_versions() const noexcept {
    return versions_.firmware == std::numeric_limits<std::uint16_t>::max() ? Availability{}
                                                                           : versions_;
  }

  Availability versions_;
  Report& report_;
  unsigned failures_{};
};

}  // namespace sbgc::detail
