/// Checks the values of a message against the limits of their fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <sbgc/detail/named_values.hpp>
#include <sbgc/detail/walk_members.hpp>
#include <sbgc/internal/compiler.hpp>

namespace sbgc::detail {

/// Detects only whether there are violations; violations.hpp reports them. Everything is inlined
/// into Meta<T>::visit(), where the facts of each field are constants: only a few integer
/// comparisons remain, without the branches that would outnumber them.
class Check {
 public:
  explicit constexpr Check(const Availability& versions) noexcept : versions_(versions) {}

  constexpr bool passed() const noexcept { return failures_ == 0; }

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void members(const T& value) {
    MemberWalk<Check> walk{*this};
    if constexpr (requires { Meta<T>::visit_used(value, walk); }) {
      Meta<T>::visit_used(value, walk);
    } else {
      Meta<T>::visit(value, walk);
    }
    if constexpr (requires { Meta<T>::rules(value, Order{*this}); }) {
      Meta<T>::rules(value, Order{*this});
    }
  }

  // The handlers of the walk.

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void scalar(const T& value, const FieldInfo& field) {
    limited(raw_of(value), field);
    if constexpr (has_named_values<T>) names(value);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void variable(T value, const VariableInfo& variable,
                                             const FieldInfo& field) {
    in_range(static_cast<double>(value), variable.range, field);
  }
  SBGC_ALWAYS_INLINE constexpr void counter(const Counter& counter, const FieldInfo& field) {
    limited(counter.count, field);
  }
  constexpr void number(const Number&, const FieldInfo&) {}
  template <class T>
  constexpr void text(const T&, const FieldInfo&) {}

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void bytes(const T& bytes, const FieldInfo& field) {
    if constexpr (is_bounded<T>) {
      counted(bytes.size(), field);
      aligned(bytes.size(), field);
    }
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void list(const T& list, const FieldInfo& field) {
    counted(list.size(), field);
    walk_list(list, field, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void array(const T& array, const FieldInfo& field) {
    walk_list(array, field, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void axes(const T& axes, const FieldInfo& field) {
    walk_axes(axes, field, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void optional(const T& optional, const FieldInfo& field) {
    if (!optional) return;
    // Its mere presence changes the body, whatever the value.
    exists(field.since, false);
    if (is_available(field.since, versions_)) walk(*optional, field, *this);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void group(const T& value, const FieldInfo&) {
    members(value);
  }

 private:
  /// Checks rules across fields.
  struct Order {
    Check& check;

    template <class T>
    SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo&, const T& low, const FieldInfo&,
                                                 const T& high, bool is_strict) {
      if constexpr (kind_of<T> == Kind::scalar) {
        const auto a = raw_of(low);
        const auto b = raw_of(high);
        check.require(is_strict ? a < b : a <= b);
      } else {
        for (std::size_t i = 0; i < low.size(); ++i) {
          (*this)(tail_field, low[i], tail_field, high[i], is_strict);
        }
      }
    }
  };

  SBGC_ALWAYS_INLINE constexpr void require(bool holds) noexcept {
    failures_ |= static_cast<unsigned>(!holds);
  }
  SBGC_ALWAYS_INLINE constexpr void exists(const Availability& since, bool is_absent) {
    require(is_absent || since.firmware <= versions_.firmware);
    require(is_absent || since.board <= versions_.board);
    require(is_absent || (since.features & versions_.features) == 0);
  }
  SBGC_ALWAYS_INLINE constexpr void counted(std::size_t size, const FieldInfo& field) {
    require(size >= field.min_count);
    require(field.max_count == 0 || size <= field.max_count);
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void aligned(Raw raw, const FieldInfo& field) {
    require(field.align == 1 || static_cast<std::uint64_t>(raw) % field.align == 0 ||
            is_special(raw, field));
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void in_range(Raw raw, const Range& range, const FieldInfo& field) {
    const bool is_low = is_below(raw, range);
    const bool is_high = is_above(raw, range);
    // A single condition, which compilers turn into one comparison.
    bool is_outside = is_low | is_high;
    if (!field.special.empty() && is_outside) is_outside = !is_special(raw, field);
    require(!is_outside);
  }
  template <class Raw>
  SBGC_ALWAYS_INLINE constexpr void limited(Raw raw, const FieldInfo& field) {
    exists(field.since, raw == 0);
    if constexpr (std::is_integral_v<Raw>) aligned(raw, field);
    const Range* range = field.range;
    if (!field.later.empty()) {
      const LaterMeaning* const later = meaning_in(field.later, versions_);
      if (later != nullptr && later->range != nullptr) range = later->range;
    }
    if (range != nullptr) in_range(raw, *range, field);
  }

  template <class Raw>
  SBGC_ALWAYS_INLINE static constexpr bool is_special(Raw raw, const FieldInfo& field) noexcept {
    bool result = false;
    for (const Special& special : field.special) {
      result |= static_cast<double>(raw) == static_cast<double>(special.value);
    }
    return result;
  }

  // Integers are compared with the smallest and the largest integer in the range. Written such that
  // NaN counts as below.
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
  /// Returns the largest integer that does not exceed `number`.
  SBGC_ALWAYS_INLINE static constexpr std::int64_t whole(double number) noexcept {
    const auto integer = static_cast<std::int64_t>(number);
    return static_cast<double>(integer) > number ? integer - 1 : integer;
  }

  /// Checks the named values that a later version introduced.
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void names(const T& value) {
    constexpr Availability needed = has_all_values_of<T>;
    if constexpr (needed.firmware != 0 || needed.board != 0 || needed.features != 0) {
      if (is_available(needed, versions_)) return;
      for_each_name(value,
                    [&](const ValueInfo& known, std::int64_t) { exists(known.since, false); });
    }
  }

  Availability versions_;
  unsigned failures_{};
};

}  // namespace sbgc::detail
