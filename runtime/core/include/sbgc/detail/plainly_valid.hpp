/// Decides quickly whether a message violates no rule. Validator reports the violations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <sbgc/detail/compiler.hpp>
#include <sbgc/detail/named_values.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc::detail {

/// Collects whether a value violates a rule. Everything is inlined into Meta<T>::visit(), where the
/// facts of each field are constants: what remains is a few comparisons of integers.
class PlainCheck {
 public:
  constexpr explicit PlainCheck(const Availability& versions) noexcept : versions_(versions) {}

  constexpr bool passed() const noexcept { return wrong_ == 0; }

  template <class T>
  constexpr void members(const T& value) {
    Meta<T>::visit(value, Members{*this});
    if constexpr (requires { Meta<T>::rules(value, Order{*this}); }) {
      Meta<T>::rules(value, Order{*this});
    }
  }

 private:
  struct Members {
    PlainCheck& check;
    const VariableInfo* variable = nullptr;  ///< the one that the last VariableId names, or null

    template <class Member>
    SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo& field, const Member& member) {
      if constexpr (std::is_same_v<Member, msg::VariableId>) variable = find_variable(member);
      if constexpr (std::is_integral_v<Member>) {
        if (field.is_variable_value && variable != nullptr) {
          return check.note(is_outside(static_cast<double>(member), variable->range));
        }
      }
      check.value(member, field);
    }
  };

  struct Order {
    PlainCheck& check;

    template <class T>
    SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo&, const T& low, const FieldInfo&,
                                                 const T& high, bool is_strict) {
      compare(low, high, is_strict);
    }

    template <class T>
    constexpr void compare(const T& low, const T& high, bool is_strict) {
      if constexpr (RawValue<T>) {
        compare(low.raw(), high.raw(), is_strict);
      } else if constexpr (std::is_arithmetic_v<T>) {
        check.note(!(is_strict ? low < high : low <= high));
      } else {
        for (std::size_t i = 0; i < low.size(); ++i) compare(low[i], high[i], is_strict);
      }
    }
  };

  // Without branches, which would outnumber the comparisons.
  SBGC_ALWAYS_INLINE constexpr void note(bool is_wrong) noexcept {
    wrong_ |= static_cast<unsigned>(is_wrong);
  }

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void value(const T& value, const FieldInfo& field) {
    if constexpr (std::is_enum_v<T>) {
      number(static_cast<std::underlying_type_t<T>>(value), field);
      names(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
      number(value, field);
    } else if constexpr (RawValue<T>) {
      number(value.raw(), field);
      constexpr bool is_flag_set = requires { typename T::flag_type; };
      if constexpr (is_flag_set || requires { PackedMeta<T>::info; }) names(value);
    } else if constexpr (requires { Meta<T>::fields; }) {
      members(value);
    }
  }
  SBGC_ALWAYS_INLINE constexpr void value(Counter counter, const FieldInfo& field) {
    number(counter.count, field);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void value(const Axes<T>& axes, const FieldInfo& field) {
    value(axes.roll, field);
    value(axes.pitch, field);
    value(axes.yaw, field);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void value(const Xyz<T>& xyz, const FieldInfo& field) {
    value(xyz.x, field);
    value(xyz.y, field);
    value(xyz.z, field);
  }
  template <class T, std::size_t n>
  SBGC_ALWAYS_INLINE constexpr void value(const std::array<T, n>& array, const FieldInfo& field) {
    for (const T& element : array) value(element, field);
  }
  template <std::size_t n>
  constexpr void value(const Bytes<n>&, const FieldInfo&) {}
  template <class T, std::size_t n>
  SBGC_ALWAYS_INLINE constexpr void value(const BoundedArray<T, n>& array, const FieldInfo& field) {
    count(array.size(), field);
    for (const T& element : array) value(element, field);
  }
  template <std::size_t n>
  SBGC_ALWAYS_INLINE constexpr void value(const BoundedBytes<n>& bytes, const FieldInfo& field) {
    count(bytes.size(), field);
    if (field.align != 1) note(bytes.size() % field.align != 0);
  }
  template <class T>
  SBGC_ALWAYS_INLINE constexpr void value(const Optional<T>& optional, const FieldInfo& field) {
    if (!optional) return;
    note(!is_available(field.since, versions_));
    value(*optional, field);
  }

  SBGC_ALWAYS_INLINE constexpr void count(std::size_t size, const FieldInfo& field) noexcept {
    note(size < field.min_count);
    if (field.max_count != 0) note(size > field.max_count);
  }

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void number(T raw, const FieldInfo& field) noexcept {
    if (field.since.firmware != 0 || field.since.board != 0) {
      note(raw != 0 && !is_available(field.since, versions_));
    }
    bool is_wrong = field.range != nullptr && is_outside(raw, *field.range);
    if constexpr (std::is_integral_v<T>) {
      if (field.align != 1) is_wrong |= static_cast<std::uint64_t>(raw) % field.align != 0;
    }
    if (!field.special.empty() && is_wrong) is_wrong = !is_special(raw, field);
    note(is_wrong);
  }

  template <class T>
  static constexpr bool is_special(T raw, const FieldInfo& field) noexcept {
    bool result = false;
    for (const Special& special : field.special) {
      result |= static_cast<double>(raw) == static_cast<double>(special.value);
    }
    return result;
  }

  template <class T>
  SBGC_ALWAYS_INLINE static constexpr bool is_outside(T raw, const Range& range) noexcept {
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 4) {
      constexpr std::int64_t least = std::numeric_limits<T>::min();
      constexpr std::int64_t most = std::numeric_limits<T>::max();
      // The smallest and the largest integer in the range.
      const bool has_lowest = range.lowest > static_cast<double>(least);
      const bool has_highest = range.highest < static_cast<double>(most);
      const std::int64_t lowest = has_lowest ? -whole(-range.lowest) : least;
      const std::int64_t highest = has_highest ? whole(range.highest) : most;
      return (raw < lowest) | (raw > highest);
    } else {
      const auto number = static_cast<double>(raw);
      return !(number >= range.lowest) | (number > range.highest);
    }
  }

  /// Returns the largest integer that is not above `number`.
  static constexpr std::int64_t whole(double number) noexcept {
    const auto integer = static_cast<std::int64_t>(number);
    return static_cast<double>(integer) > number ? integer - 1 : integer;
  }

  template <class T>
  SBGC_ALWAYS_INLINE constexpr void names(const T& value) {
    constexpr Availability needed = has_all_values_of<T>;
    if constexpr (needed.firmware != 0 || needed.board != 0) {
      if (is_available(needed, versions_)) return;
      for_each_name(value, [this](const ValueInfo& known, std::int64_t) {
        note(!is_available(known.since, versions_));
      });
    }
  }

  Availability versions_;
  unsigned wrong_{};
};

/// Returns true if validate() would report nothing.
template <class M>
constexpr bool is_plainly_valid(const M& message, const Availability& versions) {
  PlainCheck check(versions);
  check.members(message);
  return check.passed();
}

}  // namespace sbgc::detail
